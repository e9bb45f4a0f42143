// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/Bars.h"

#include "panels/Icon.h"
#include "panels/Theme.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QVBoxLayout>

namespace espalier {

namespace {

constexpr int kLeastTitle = 4; ///< Letters; fewer say nothing

} // namespace

SideBar::SideBar(const Actions& actions, QWidget* parent) : Bar(parent)
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(6, 6, 6, 6);
    column->setSpacing(4);
    for (const ActionId id : Actions::tools())
        column->addWidget(new BarButton(BarButton::Look::IconAboveText, actions[id], this));
    column->addSpacing(3);
    column->addWidget(barSeparator(Qt::Horizontal, this));
    column->addSpacing(3);
    for (const ActionId id : {ActionId::Undo, ActionId::Redo})
        column->addWidget(new BarButton(BarButton::Look::IconAboveText, actions[id], this));
}

TopBar::TopBar(const Actions& actions, std::function<void(QMenu&)> fillRecentFiles, QWidget* parent)
    : Bar(parent), m_title(new QLabel(this))
{
    setFlat(true);
    auto* menuButton = new BarButton(BarButton::Look::Icon, this);
    menuButton->setIcon(icon(QStringLiteral("menu")));
    menuButton->setToolTip(tr("Menu"));
    menuButton->setAccessibleName(tr("Menu"));
    menuButton->setPopupMode(QToolButton::InstantPopup);
    menuButton->setMenu(makeMenu(actions, std::move(fillRecentFiles)));

    m_title->setTextFormat(Qt::PlainText);
    // Where there is little room, buttons have it before the title.
    m_title->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    m_title->setMinimumWidth(1);
    theme::setTone(*m_title, theme::Tone::Dim);

    // Files and view have equal shares of the rest, so that the sheets stand in the middle.
    auto* line = new QHBoxLayout(this);
    line->setContentsMargins(8, 3, 8, 3);
    line->setSpacing(2);
    auto* files = new QHBoxLayout;
    files->setSpacing(2);
    files->addWidget(menuButton);
    for (const ActionId id :
         {ActionId::New, ActionId::Open, ActionId::Library, ActionId::Save, ActionId::Export})
        files->addWidget(new BarButton(BarButton::Look::Icon, actions[id], this));
    files->addSpacing(14);
    files->addWidget(m_title, 1);
    line->addLayout(files, 1);
    for (const ActionId id :
         {ActionId::Architecture, ActionId::LeafSheet, ActionId::BranchSheet, ActionId::Background})
        line->addWidget(new BarButton(BarButton::Look::Tab, actions[id], this));
    auto* view = new QHBoxLayout;
    view->setSpacing(2);
    view->addStretch(1);
    for (const ActionId id : {ActionId::Markers, ActionId::Leaves, ActionId::History, ActionId::FrameAll,
                              ActionId::HideInterface, ActionId::Help})
        view->addWidget(new BarButton(BarButton::Look::Icon, actions[id], this));
    line->addLayout(view, 1);
}

QMenu* TopBar::makeMenu(const Actions& actions, std::function<void(QMenu&)> fillRecentFiles)
{
    auto* menu = new QMenu(this);
    ActionGroup group = ActionGroup::File;
    for (const ActionEntry& entry : Actions::table()) {
        if (entry.id == ActionId::Quit || entry.id == ActionId::Cancel)
            continue;
        if (std::exchange(group, entry.group) != entry.group)
            menu->addSeparator();
        menu->addAction(actions[entry.id]);
        if (entry.id == ActionId::Open) {
            QMenu* recent = menu->addMenu(tr("Open Recent"));
            connect(recent, &QMenu::aboutToShow, this, [recent, fill = std::move(fillRecentFiles)] {
                recent->clear();
                fill(*recent);
            });
        }
    }
    menu->addSeparator();
    menu->addAction(actions[ActionId::Quit]);
    return menu;
}

void TopBar::setTitle(const QString& name, bool modified)
{
    m_name = name;
    m_modified = modified;
    showTitle();
}

void TopBar::showTitle()
{
    const QString mark = m_modified ? QStringLiteral(" •") : QString();
    const int room = m_title->width() - m_title->fontMetrics().horizontalAdvance(mark);
    const bool fits = room >= m_title->fontMetrics().averageCharWidth() * kLeastTitle;
    m_title->setText(fits ? m_title->fontMetrics().elidedText(m_name, Qt::ElideMiddle, room) + mark
                          : QString());
    m_title->setToolTip(m_modified ? tr("%1 has changes that are not saved.").arg(m_name) : m_name);
}

void TopBar::resizeEvent(QResizeEvent* event)
{
    Bar::resizeEvent(event);
    layout()->activate();
    showTitle();
}

} // namespace espalier
