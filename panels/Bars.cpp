// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/Bars.h"

#include "panels/Icon.h"
#include "panels/Theme.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <utility>

namespace espalier {

namespace {

constexpr int kSideMargin = 6;  ///< px
constexpr int kSideSpacing = 4; ///< px

constexpr int kLeastTitle = 4; ///< Letters; a shorter title is useless
/// px that a title can get by hiding buttons whose actions are available elsewhere.
constexpr int kTitleRoom = 130;

/// In the order in which they are hidden; the menu has all of them.
constexpr std::array kYielding{ActionId::Markers, ActionId::Another, ActionId::Export, ActionId::Open,
                               ActionId::FrameAll};

} // namespace

SideBar::SideBar(const Actions& actions, QWidget* parent) : Bar(parent)
{
    m_grid = new QGridLayout(this);
    m_grid->setContentsMargins(kSideMargin, kSideMargin, kSideMargin, kSideMargin);
    m_grid->setSpacing(kSideSpacing);
    for (const ActionId id : Actions::tools())
        m_tools.push_back(new BarButton(BarButton::Look::IconAboveText, actions[id], this));
    m_line = barSeparator(Qt::Horizontal, this);
    for (const ActionId id : {ActionId::Undo, ActionId::Redo})
        m_steps.push_back(new BarButton(BarButton::Look::IconAboveText, actions[id], this));
    arrange(1);
}

void SideBar::fit(int height)
{
    const int row = m_tools.front()->sizeHint().height() + kSideSpacing;
    const int room = height - 2 * kSideMargin - kSideSpacing - m_line->height();
    const auto rows = [](std::size_t count, int columns) {
        return (static_cast<int>(count) + columns - 1) / columns;
    };
    int columns = 1;
    while (columns < 4 && (rows(m_tools.size(), columns) + rows(m_steps.size(), columns)) * row > room)
        ++columns;
    arrange(columns);
}

void SideBar::arrange(int columns)
{
    if (std::exchange(m_columns, columns) == columns)
        return;
    while (QLayoutItem* item = m_grid->takeAt(0))
        delete item;
    int row = 0;
    const auto add = [&](const std::vector<BarButton*>& buttons) {
        for (std::size_t i = 0; i < buttons.size(); ++i)
            m_grid->addWidget(buttons[i], row + static_cast<int>(i) / columns, static_cast<int>(i) % columns);
        row += (static_cast<int>(buttons.size()) + columns - 1) / columns;
    };
    add(m_tools);
    m_grid->addWidget(m_line, row++, 0, 1, columns);
    add(m_steps);
    m_grid->invalidate();
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
    // In a narrow bar some buttons are hidden to make room for the title; the other ones come before it.
    m_title->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    m_title->setMinimumWidth(1);
    theme::setTone(*m_title, theme::Tone::Dim);

    // Files and view have equal shares of the rest, so that the sheets are in the middle.
    auto* line = new QHBoxLayout(this);
    line->setContentsMargins(8, 3, 8, 3);
    line->setSpacing(2);
    auto* files = new QHBoxLayout;
    files->setSpacing(2);
    files->addWidget(menuButton);
    const auto addButton = [&](ActionId id, QHBoxLayout& group) {
        auto* button = new BarButton(BarButton::Look::Icon, actions[id], this);
        group.addWidget(button);
        if (const auto place = std::ranges::find(kYielding, id); place != kYielding.end())
            m_yielding[static_cast<std::size_t>(place - kYielding.begin())] = button;
    };
    for (const ActionId id :
         {ActionId::New, ActionId::Open, ActionId::Library, ActionId::Save, ActionId::Export})
        addButton(id, *files);
    files->addSpacing(14);
    files->addWidget(m_title, 1);
    files->addSpacing(10);
    line->addLayout(files, 1);
    for (const ActionId id : Actions::sheets())
        line->addWidget(new BarButton(BarButton::Look::Tab, actions[id], this));
    auto* view = new QHBoxLayout;
    view->setSpacing(2);
    view->addStretch(1);
    for (const ActionId id : {ActionId::Markers, ActionId::Leaves, ActionId::Another, ActionId::History,
                              ActionId::FrameAll, ActionId::HideInterface, ActionId::Help})
        addButton(id, *view);
    line->addLayout(view, 1);
}

QMenu* TopBar::makeMenu(const Actions& actions, std::function<void(QMenu&)> fillRecentFiles)
{
    auto* menu = new QMenu(this);
    // The actions for files are in the menu itself; the others, which have buttons and keys, are in a
    // submenu.
    QMenu* group = menu;
    ActionGroup kind = ActionGroup::File;
    for (const ActionEntry& entry : Actions::table()) {
        if (entry.id == ActionId::Quit || entry.id == ActionId::Cancel)
            continue;
        if (std::exchange(kind, entry.group) != entry.group) {
            if (group == menu)
                menu->addSeparator();
            group = menu->addMenu(Actions::groupTitle(kind));
        }
        group->addAction(actions[entry.id]);
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
    arrange();
}

void TopBar::arrange()
{
    const int wanted = std::min(titleWidth(), kTitleRoom);
    m_title->setMinimumWidth(1);
    for (QWidget* button : m_yielding)
        button->show();
    const auto leastWidth = [this] {
        // Layouts inside are computed again too.
        layout()->invalidate();
        layout()->activate();
        return layout()->minimumSize().width() - m_title->minimumWidth() + 1;
    };
    for (QWidget* button : m_yielding) {
        if (leastWidth() + wanted <= width())
            break;
        button->hide();
    }
    m_title->setMinimumWidth(std::clamp(width() - leastWidth(), 1, wanted));
    layout()->activate();
    showTitle();
}

QString TopBar::mark() const
{
    return m_modified ? QStringLiteral(" •") : QString();
}

int TopBar::titleWidth() const
{
    return m_title->fontMetrics().horizontalAdvance(m_name + mark()) + 2;
}

void TopBar::showTitle()
{
    const int room = m_title->width() - m_title->fontMetrics().horizontalAdvance(mark());
    const bool fits = room >= m_title->fontMetrics().averageCharWidth() * kLeastTitle;
    m_title->setText(fits ? m_title->fontMetrics().elidedText(m_name, Qt::ElideMiddle, room) + mark()
                          : QString());
    m_title->setToolTip(m_modified ? tr("%1 has unsaved changes.").arg(m_name) : m_name);
}

void TopBar::showEvent(QShowEvent* event)
{
    // The buttons have their fonts only now.
    Bar::showEvent(event);
    arrange();
}

void TopBar::resizeEvent(QResizeEvent* event)
{
    Bar::resizeEvent(event);
    arrange();
}

} // namespace espalier
