// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/ParameterGesture.h"
#include "panels/Bar.h"
#include "panels/ParameterTexts.h"

#include <vector>

namespace espalier {

class ParameterRow;

/// One sheet of a document's parameters, in sections side by side. A gesture on a row becomes one undo step.
/// What shows at once (leaves, widths, bark) is tried out while a slider moves; what steers growth is put in
/// force when the gesture ends.
class ParameterPanel : public Bar {
    Q_OBJECT

public:
    ParameterPanel(TreeDocument& document, ParameterSheet sheet, QWidget* parent = nullptr);

    /// The row of a parameter, or null if this sheet has none.
    ParameterRow* row(const char* key) const;

private:
    void build(ParameterSheet sheet);
    QWidget* makeSection(const ParameterSection& section, QWidget* parent);
    void addRow(const ParameterText& text, QWidget* parent);
    void showValues();
    void edit(const ParameterRow& row, double value);
    void finish(const ParameterRow& row);
    void putInForce(const ParameterRow& row);

    TreeDocument& m_document;
    ParameterGesture m_gesture;
    TreeParameters m_shown; ///< What the rows say
    bool m_isOwnChange = false;
    std::vector<ParameterRow*> m_rows;
};

} // namespace espalier
