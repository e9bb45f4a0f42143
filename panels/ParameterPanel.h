// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/Bar.h"
#include "panels/LookChoice.h"
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

Q_SIGNALS:
    /// The user wants to choose an image, or has dropped one on the sheet.
    void imageAsked(espalier::LookKind kind);
    void imageDropped(espalier::LookKind kind, const QString& fileName);

protected:
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    QWidget* makeSection(const ParameterSection& section, QWidget* parent);

    ParameterEditor m_editor;
    std::optional<LookKind> m_look; ///< The kind of an image that is dropped on this sheet
    std::vector<ParameterRow*> m_rows;
};

} // namespace espalier
