// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/Bar.h"
#include "panels/ParameterEditor.h"
#include "panels/ParameterTexts.h"

#include <vector>

namespace espalier {

class ParameterRow;

/// One sheet of a document's parameters, as rows in sections side by side.
class ParameterPanel : public Bar {
    Q_OBJECT

public:
    ParameterPanel(TreeDocument& document, ParameterSheet sheet, QWidget* parent = nullptr);

    /// The row of a parameter, or null if this sheet has none.
    ParameterRow* row(std::string_view key) const;

private:
    QWidget* makeSection(const ParameterSection& section, QWidget* parent);

    ParameterEditor m_editor;
    std::vector<ParameterRow*> m_rows;
};

} // namespace espalier
