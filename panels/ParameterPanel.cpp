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
} // namespace

ParameterPanel::ParameterPanel(TreeDocument& document, ParameterSheet sheet, QWidget* parent)
    : Bar(parent), m_editor(document)
{
    auto* content = new QWidget;
    auto* columns = new QHBoxLayout(content);
    columns->setContentsMargins(20, 14, 20, 12);
    columns->setSpacing(18);
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
    auto* box = new QWidget(parent);
    box->setFixedWidth(kColumnWidth);
    auto* lines = new QVBoxLayout(box);
    lines->setContentsMargins(0, 0, 0, 0);
    lines->setSpacing(2);
    lines->addWidget(barHeading(parameterTr(section.title), box));
    for (const ParameterText& text : section.parameters) {
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
