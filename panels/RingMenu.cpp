// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/RingMenu.h"

#include "panels/Theme.h"

#include <QGuiApplication>
#include <QIcon>
#include <QKeyEvent>
#include <QKeySequence>
#include <QPainter>
#include <QPainterPath>
#include <QScreen>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace espalier {

namespace {

/// In each ring clockwise, the first at the top.
constexpr std::array kInnerRing{ActionId::LargerBrush, ActionId::Redo, ActionId::SmallerBrush,
                                ActionId::Undo};
constexpr std::array kOuterRing{ActionId::Brush, ActionId::Lasso, ActionId::Grow, ActionId::Bend,
                                ActionId::Prune, ActionId::Width, ActionId::Move, ActionId::Sketch};
constexpr double kRingReach = RingMenu::kOuter + 2.0; ///< From the middle to an edge of the widget, px
/// A key that was held this long, ms, chooses by its release, even if nothing is below the pointer.
constexpr qint64 kRingHeld = 300;
constexpr int kRingIcon = 24;  ///< px
constexpr int kName = 8;       ///< Half the height of a tool's name, px
constexpr int kNameWidth = 66; ///< px

double sectorOf(int ring)
{
    return 360.0 / static_cast<double>(ring == 0 ? kInnerRing.size() : kOuterRing.size());
}

} // namespace

RingMenu::RingMenu(const Actions& actions, QWidget* parent)
    : QWidget(parent, Qt::Popup | Qt::FramelessWindowHint | Qt::NoDropShadowWindowHint), m_actions(actions)
{
    setObjectName(QStringLiteral("ringMenu"));
    const int size = static_cast<int>(2.0 * kRingReach);
    setFixedSize(size, size);
    // Without a compositor a window cannot be transparent, so its corners are cut off.
    setMask(QRegion(rect(), QRegion::Ellipse));
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("Tools around the pointer"));
}

void RingMenu::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange)
        setAccessibleName(tr("Tools around the pointer"));
    QWidget::changeEvent(event);
}

void RingMenu::openAt(const QPoint& place, int key)
{
    QPoint corner = place - rect().center();
    if (const QScreen* screen = QGuiApplication::screenAt(place)) {
        const QRect room = screen->availableGeometry();
        corner.setX(std::clamp(corner.x(), room.left(), std::max(room.left(), room.right() + 1 - width())));
        corner.setY(std::clamp(corner.y(), room.top(), std::max(room.top(), room.bottom() + 1 - height())));
    }
    m_key = key;
    m_openedAt = m_pointer = QPointF(place - corner);
    m_wasPressed = false;
    m_sinceOpened.start();
    move(corner);
    show();
    setFocus(Qt::PopupFocusReason);
}

std::optional<RingMenu::Field> RingMenu::fieldAt(const QPointF& place) const
{
    const QPointF from = place - QRectF(rect()).center();
    const double distance = std::hypot(from.x(), from.y());
    if (distance < kMiddle || distance > kRingReach)
        return std::nullopt;
    const int ring = distance < kInner ? 0 : 1;
    // Clockwise from the top.
    const double angle = std::atan2(from.x(), -from.y()) * 180.0 / std::numbers::pi;
    const int count = static_cast<int>(ring == 0 ? kInnerRing.size() : kOuterRing.size());
    const int index = (static_cast<int>(std::lround(angle / sectorOf(ring))) + count) % count;
    const auto at = static_cast<std::size_t>(index);
    return Field{ring == 0 ? kInnerRing[at] : kOuterRing[at], ring, index};
}

QAction* RingMenu::actionAt(const QPointF& place) const
{
    const std::optional<Field> field = fieldAt(place);
    return field ? m_actions[field->id] : nullptr;
}

QPointF RingMenu::middleOf(const Field& field) const
{
    const double angle = field.place * sectorOf(field.ring) * std::numbers::pi / 180.0;
    const double radius = field.ring == 0 ? (kMiddle + kInner) / 2.0 : (kInner + kOuter) / 2.0;
    return QRectF(rect()).center() + radius * QPointF(std::sin(angle), -std::cos(angle));
}

QPointF RingMenu::placeOf(ActionId id) const
{
    const auto indexIn = [id](const auto& ring) {
        return static_cast<int>(std::ranges::find(ring, id) - ring.begin());
    };
    const int inner = indexIn(kInnerRing);
    return inner < static_cast<int>(kInnerRing.size()) ? middleOf({id, 0, inner})
                                                       : middleOf({id, 1, indexIn(kOuterRing)});
}

/// Does what is at @p place. The brush can be made larger or smaller again, so the ring stays for that.
void RingMenu::choose(const QPointF& place)
{
    const std::optional<Field> field = fieldAt(place);
    if (field && !m_actions[field->id]->isEnabled())
        return;
    const bool repeats = field && (field->id == ActionId::SmallerBrush || field->id == ActionId::LargerBrush);
    if (!repeats)
        close();
    if (field)
        m_actions[field->id]->trigger();
}

void RingMenu::keyPressEvent(QKeyEvent* event)
{
    static constexpr std::array kModifiers{Qt::Key_Shift, Qt::Key_Control, Qt::Key_Alt, Qt::Key_AltGr,
                                           Qt::Key_Meta};
    if (event->isAutoRepeat() || event->key() == m_key || std::ranges::count(kModifiers, event->key()) > 0)
        return;
    close();
    if (event->key() == Qt::Key_Escape)
        return;
    // A shortcut is not lost.
    const QKeySequence keys(event->keyCombination());
    for (QAction* action : parentWidget()->actions()) {
        if (action->shortcuts().contains(keys)) {
            action->trigger();
            return;
        }
    }
}

void RingMenu::keyReleaseEvent(QKeyEvent* event)
{
    if (event->isAutoRepeat() || event->key() != m_key)
        return;
    m_key = 0;
    const QPointF moved = m_pointer - m_openedAt;
    if (std::hypot(moved.x(), moved.y()) > kMiddle) {
        choose(m_pointer);
        close();
    } else if (m_sinceOpened.elapsed() >= kRingHeld) {
        close();
    }
}

void RingMenu::mouseMoveEvent(QMouseEvent* event)
{
    m_pointer = event->position();
    update();
}

void RingMenu::mousePressEvent(QMouseEvent* event)
{
    m_pointer = event->position();
    // The second click of a double click with the right button belongs to the one that opened the ring.
    m_wasPressed = event->button() == Qt::LeftButton;
    if (!rect().contains(event->position().toPoint()))
        close();
    update();
}

void RingMenu::mouseReleaseEvent(QMouseEvent* event)
{
    m_pointer = event->position();
    if (std::exchange(m_wasPressed, false))
        choose(m_pointer);
}

void RingMenu::leaveEvent(QEvent* event)
{
    m_pointer = QRectF(rect()).center();
    update();
    QWidget::leaveEvent(event);
}

void RingMenu::paintField(QPainter& painter, const Field& field) const
{
    const QAction* action = m_actions[field.id];
    const std::optional<Field> under = fieldAt(m_pointer);
    const bool isUnder = under && under->id == field.id && action->isEnabled();
    const auto disc = [this](double radius) {
        const QPointF centre = QRectF(rect()).center();
        return QRectF(centre - QPointF(radius, radius), centre + QPointF(radius, radius));
    };
    const double sector = sectorOf(field.ring);
    if (isUnder || (action->isCheckable() && action->isChecked())) {
        const double outer = field.ring == 0 ? kInner : kOuter;
        const double inner = field.ring == 0 ? kMiddle : kInner;
        // Qt counts counterclockwise from the right.
        const double begin = 90.0 - (field.place + 0.5) * sector;
        QPainterPath path;
        path.arcMoveTo(disc(outer), begin);
        path.arcTo(disc(outer), begin, sector);
        path.arcTo(disc(inner), begin + sector, -sector);
        path.closeSubpath();
        painter.fillPath(path, isUnder ? theme::kEdge : theme::kAccentFill);
    }
    const QPointF middle = middleOf(field);
    if (!action->icon().isNull()) {
        const int up = field.ring == 0 ? 0 : kName;
        const QRect place(middle.toPoint() - QPoint(kRingIcon / 2, kRingIcon / 2 + up),
                          QSize(kRingIcon, kRingIcon));
        action->icon().paint(&painter, place, Qt::AlignCenter,
                             !action->isEnabled() ? QIcon::Disabled
                             : isUnder            ? QIcon::Active
                                                  : QIcon::Normal,
                             action->isChecked() ? QIcon::On : QIcon::Off);
    }
    if (field.ring == 1) {
        const QRectF room(middle + QPointF(-kNameWidth / 2.0, kRingIcon / 2.0 - kName + 1.0),
                          QSizeF(kNameWidth, 2.0 * kName));
        painter.setPen(!action->isEnabled() ? theme::kFaintText
                       : isUnder            ? theme::kBrightText
                                            : theme::kText);
        painter.drawText(room, Qt::AlignCenter,
                         painter.fontMetrics().elidedText(action->iconText(), Qt::ElideRight, kNameWidth));
    }
    if (!action->icon().isNull())
        return;
    // The sizes of the brush.
    painter.setPen(QPen(action->isEnabled() ? theme::kText : theme::kFaintText, 1.6));
    painter.setBrush(Qt::NoBrush);
    const double radius = field.id == ActionId::LargerBrush ? 9.0 : 4.0;
    painter.drawEllipse(middle, radius, radius);
}

void RingMenu::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), theme::kRaised);
    QFont small = font();
    small.setPixelSize(10);
    painter.setFont(small);
    for (int i = 0; const ActionId id : kOuterRing)
        paintField(painter, {id, 1, i++});
    for (int i = 0; const ActionId id : kInnerRing)
        paintField(painter, {id, 0, i++});
    const QPointF centre = QRectF(rect()).center();
    painter.setPen(QPen(theme::kEdge, 1.0));
    painter.setBrush(Qt::NoBrush);
    for (const double radius : {kMiddle, kInner, kOuter})
        painter.drawEllipse(centre, radius, radius);
}

} // namespace espalier
