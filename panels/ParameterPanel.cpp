// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/ParameterPanel.h"

#include "panels/ParameterRow.h"
#include "panels/Sideways.h"

#include <QDragEnterEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>

namespace espalier {

namespace {
constexpr int kColumnWidth = 196;
constexpr int kColumnSpacing = 18;
/// A section of more rows than this has two columns, so that the sheet leaves room for the tree below it.
constexpr std::size_t kMostRows = 5;
} // namespace

ParameterPanel::ParameterPanel(TreeDocument& document, ParameterSheet sheet, QWidget* parent)
    : Bar(parent), m_editor(document)
{
    auto* content = new QWidget;
    auto* columns = new QHBoxLayout(content);
    columns->setContentsMargins(20, 14, 20, 12);
    columns->setSpacing(kColumnSpacing);
    for (const ParameterSection& section : parameterSections()) {
        if (section.sheet != sheet)
            continue;
        if (columns->count() > 0)
            columns->addWidget(barSeparator(Qt::Vertical, content));
        columns->addWidget(makeSection(section, content));
    }
    auto* whole = new QVBoxLayout(this);
    whole->setContentsMargins(1, 1, 1, 1);
    whole->addWidget(new Sideways(content, this));
}

QWidget* ParameterPanel::makeSection(const ParameterSection& section, QWidget* parent)
{
    const std::size_t rows = section.parameters.size();
    const std::size_t columnCount = rows > kMostRows ? 2 : 1;
    const std::size_t rowsOfColumn = (rows + columnCount - 1) / columnCount;
    auto* box = new QWidget(parent);
    box->setFixedWidth(static_cast<int>(columnCount) * (kColumnWidth + kColumnSpacing) - kColumnSpacing);
    auto* whole = new QVBoxLayout(box);
    whole->setContentsMargins(0, 0, 0, 0);
    whole->setSpacing(2);
    whole->addWidget(barHeading(parameterTr(section.title), box));
    auto* columns = new QHBoxLayout;
    columns->setSpacing(kColumnSpacing);
    whole->addLayout(columns);
    whole->addStretch();
    QVBoxLayout* lines = nullptr;
    for (std::size_t i = 0; i < rows; ++i) {
        if (i % rowsOfColumn == 0) {
            if (lines != nullptr)
                lines->addStretch();
            lines = new QVBoxLayout;
            lines->setSpacing(2);
            columns->addLayout(lines, 1);
        }
        const ParameterText& text = section.parameters[i];
        m_rows.push_back(new ParameterRow(m_editor, text, box));
        lines->addWidget(m_rows.back());
        if (LookChoice* look = m_rows.back()->look()) {
            m_look = LookChoice::kindOf(text.key);
            setAcceptDrops(true);
            connect(look, &LookChoice::imageAsked, this, &ParameterPanel::imageAsked);
            connect(look, &LookChoice::imageDropped, this, &ParameterPanel::imageDropped);
        }
    }
    lines->addStretch();
    return box;
}

void ParameterPanel::dragEnterEvent(QDragEnterEvent* event)
{
    if (m_look && !droppedImage(*event->mimeData()).isEmpty())
        event->acceptProposedAction();
}

void ParameterPanel::dropEvent(QDropEvent* event)
{
    const QString file = droppedImage(*event->mimeData());
    if (!m_look || file.isEmpty())
        return;
    event->acceptProposedAction();
    Q_EMIT imageDropped(*m_look, file);
}

ParameterRow* ParameterPanel::row(std::string_view key) const
{
    const auto found =
        std::ranges::find_if(m_rows, [&](const ParameterRow* row) { return key == row->key(); });
    return found == m_rows.end() ? nullptr : *found;
}

} // namespace espalier
