// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/TourCard.h"

#include "panels/Theme.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>

#include <algorithm>
#include <cmath>
#include <vector>

namespace espalier {

namespace {

constexpr int kTextWidth = 300; ///< px
constexpr int kCardGap = 34;    ///< Between the card and what it points at, px
constexpr int kCardEdge = 12;   ///< Between the card and the window's edge, px
constexpr int kTop = 62;        ///< Below the bar at the top, px
constexpr int kBottom = 48;     ///< Above the strip at the bottom, px
constexpr int kGrid = 12;       ///< Between the places that are tried, px
/// A card stays where it is unless another place is better by more than this, px.
constexpr double kInertia = 40.0;
constexpr int kRingReach = 5; ///< Distance of the ring from its target, px

/// The point of @p rect that is nearest to @p point.
QPoint nearestOn(const QRect& rect, const QPoint& point)
{
    return {std::clamp(point.x(), rect.left(), rect.right()),
            std::clamp(point.y(), rect.top(), rect.bottom())};
}

double area(const QRect& rect)
{
    return rect.isEmpty() ? 0.0 : static_cast<double>(rect.width()) * rect.height();
}

/// Length of the gap between two rectangles, px; 0 if they touch.
double gapBetween(const QRect& a, const QRect& b)
{
    const int across = std::max({a.left() - b.right(), b.left() - a.right(), 0});
    const int along = std::max({a.top() - b.bottom(), b.top() - a.bottom(), 0});
    return std::hypot(across, along);
}

} // namespace

/// The ring and the line; they ignore the pointer.
class TourCard::Ring : public QWidget {
public:
    explicit Ring(QWidget* parent) : QWidget(parent) { setAttribute(Qt::WA_TransparentForMouseEvents); }

    void span(const QRect& target, const QRect& card)
    {
        const QRect ring = target.adjusted(-kRingReach, -kRingReach, kRingReach, kRingReach);
        if (ring == m_ring && card == m_card && isVisible())
            return;
        m_ring = ring;
        m_card = card;
        setGeometry(ring.united(card).adjusted(-2, -2, 2, 2));
        show();
        update();
    }

protected:
    void paintEvent(QPaintEvent*) override
    {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.translate(-geometry().topLeft());
        painter.setPen(QPen(theme::kHandle, 2.0, Qt::SolidLine, Qt::RoundCap));
        const QPoint middle = nearestOn(m_ring, m_card.center());
        painter.drawLine(nearestOn(m_card, middle), middle);
        painter.drawRoundedRect(QRectF(m_ring), theme::kRadius, theme::kRadius);
    }

private:
    QRect m_ring;
    QRect m_card;
};

TourCard::TourCard(QWidget* parent)
    : Bar(parent),
      m_ring(new Ring(parent)),
      m_title(new QLabel(this)),
      m_text(new QLabel(this)),
      m_number(new QLabel(this)),
      m_watch(new QPushButton(tr("Watch"), this)),
      m_skip(new QPushButton(tr("Skip"), this)),
      m_next(new QPushButton(this))
{
    setAccessibleName(tr("Tour"));
    setOpaque(true);
    QFont large = m_title->font();
    large.setPointSizeF(large.pointSizeF() * 1.35);
    m_title->setFont(large);
    m_text->setTextFormat(Qt::RichText);
    m_text->setWordWrap(true);
    m_text->setFixedWidth(kTextWidth);
    theme::setTone(*m_number, theme::Tone::Dim);
    m_watch->setObjectName(QStringLiteral("tourWatch"));
    m_skip->setObjectName(QStringLiteral("tourSkip"));
    m_next->setObjectName(QStringLiteral("tourNext"));
    m_next->setDefault(true);
    for (QPushButton* button : {m_watch, m_skip, m_next}) {
        button->setMinimumHeight(theme::kTarget);
        button->setFocusPolicy(Qt::TabFocus);
    }
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(20, 16, 20, 16);
    column->setSpacing(8);
    column->addWidget(m_title);
    column->addWidget(m_text);
    column->addSpacing(8);
    auto* line = new QHBoxLayout;
    line->addWidget(m_number, 1);
    line->addWidget(m_watch);
    line->addWidget(m_skip);
    line->addWidget(m_next);
    column->addLayout(line);
    connect(m_watch, &QPushButton::clicked, this, &TourCard::watchAsked);
    connect(m_skip, &QPushButton::clicked, this, &TourCard::skipAsked);
    connect(m_next, &QPushButton::clicked, this, &TourCard::nextAsked);
    m_ring->hide();
    hide();
}

void TourCard::setWords(const QString& title, const QString& text, int number, int count, bool canBeWatched)
{
    m_title->setText(title);
    m_text->setText(text);
    m_number->setText(tr("%1 of %2").arg(number).arg(count));
    m_watch->setVisible(canBeWatched);
    m_skip->setVisible(number < count);
    m_next->setText(number < count ? tr("Next") : tr("Done"));
    m_text->setFixedHeight(m_text->heightForWidth(kTextWidth));
    adjustSize();
}

QPoint TourCard::placeBeside(const QRect& target, const QRect& canvas) const
{
    const QRect whole = parentWidget()->rect();
    const QRect room = whole.adjusted(kCardEdge, kTop, -kCardEdge, -kBottom);
    std::vector<QRect> covered;
    for (const QObject* child : parentWidget()->children()) {
        const auto* bar = qobject_cast<const Bar*>(child);
        if (bar && bar != this && bar->isVisible())
            covered.push_back(bar->geometry().adjusted(-kCardEdge, -kCardEdge, kCardEdge, kCardEdge));
    }
    if (!target.isEmpty())
        covered.push_back(target.adjusted(-kCardEdge, -kCardEdge, kCardEdge, kCardEdge));
    // Without a target, the place is at the bottom: the tree stands in the middle.
    const QPoint wanted =
        target.isEmpty() ? QPoint(room.center().x(), room.bottom() - height() / 2) : target.center();
    const auto badness = [&](const QPoint& place) {
        const QRect card(place, size());
        double bad = area(card.intersected(canvas));
        for (const QRect& rect : covered)
            bad += 100.0 * area(card.intersected(rect));
        if (!target.isEmpty())
            bad += 2.0 * std::abs(gapBetween(card, target) - kCardGap);
        const QPoint off = card.center() - wanted;
        return bad + 0.5 * std::hypot(off.x(), off.y());
    };
    // On the right of the target, if nothing is in the way.
    QPoint best(target.right() + kCardGap, wanted.y() - height() / 2);
    best.setX(std::clamp(best.x(), room.left(), std::max(room.left(), room.right() - width())));
    best.setY(std::clamp(best.y(), room.top(), std::max(room.top(), room.bottom() - height())));
    double least = badness(best) - kInertia;
    for (int y = room.top(); y + height() <= room.bottom(); y += kGrid) {
        for (int x = room.left(); x + width() <= room.right(); x += kGrid) {
            if (const double bad = badness({x, y}); bad < least) {
                least = bad;
                best = {x, y};
            }
        }
    }
    return isVisible() && room.contains(geometry()) && badness(pos()) < least + kInertia ? pos() : best;
}

void TourCard::pointAt(const QRect& target, const QRect& canvas)
{
    move(placeBeside(target, canvas));
    if (target.isEmpty()) {
        m_ring->hide();
    } else {
        m_ring->span(target, geometry());
        m_ring->raise();
    }
    show();
    raise();
}

void TourCard::hideRing()
{
    m_ring->hide();
}

void TourCard::hideEvent(QHideEvent* event)
{
    m_ring->hide();
    Bar::hideEvent(event);
}

} // namespace espalier
