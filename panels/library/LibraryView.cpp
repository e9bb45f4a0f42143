// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/library/LibraryView.h"

#include "panels/Theme.h"
#include "panels/library/LibraryCards.h"

#include <QContextMenuEvent>
#include <QGuiApplication>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QScrollBar>
#include <QScroller>
#include <QStyleHints>
#include <QTextLayout>

#include <algorithm>

namespace espalier {

namespace {

constexpr int kLeastColumn = 212; ///< px
constexpr int kCardMargin = 7;    ///< px around a card
constexpr int kInset = 9;         ///< px between a card's edge and what is on it
constexpr int kLines = 2;
constexpr int kOverlap = 6;     ///< px by which the lines overlap the touch area of the name
constexpr int kLongPress = 550; ///< ms
/// Height of a picture by its width, as in the recipes' pictures.
constexpr double kPictureAspect = 0.875;

QFont nameFont(QFont font)
{
    font.setWeight(QFont::DemiBold);
    return font;
}

QFont lineFont(QFont font)
{
    font.setPointSizeF(font.pointSizeF() * 0.88);
    return font;
}

QRect picturePlace(const QRect& card)
{
    const int width = card.width() - 2 * kCardMargin;
    return {card.left() + kCardMargin, card.top() + kCardMargin, width, qRound(width * kPictureAspect)};
}

QRect namePlace(const QRect& card)
{
    const QRect picture = picturePlace(card);
    return {picture.left() + kInset, picture.bottom() + 1, picture.width() - kInset - theme::kTarget,
            theme::kTarget};
}

/// At most kLines lines, the last of them elided.
void drawLines(QPainter& painter, const QRect& place, const QString& text)
{
    QTextLayout layout(text, painter.font());
    const QFontMetrics metrics(painter.font());
    layout.beginLayout();
    int y = place.top();
    for (int line = 0; line < kLines; ++line) {
        QTextLine row = layout.createLine();
        if (!row.isValid())
            break;
        row.setLineWidth(place.width());
        const bool isLast = line == kLines - 1;
        const QString words =
            isLast ? metrics.elidedText(text.mid(row.textStart()), Qt::ElideRight, place.width())
                   : text.mid(row.textStart(), row.textLength()).trimmed();
        painter.drawText(place.left(), y + metrics.ascent(), words);
        y += metrics.lineSpacing();
    }
    layout.endLayout();
}

/// Draws a seedling in place of a picture.
void drawNoPicture(QPainter& painter, const QRectF& place)
{
    painter.fillRect(place, theme::kSunken);
    const double unit = place.height() / 10.0;
    const QPointF base(place.center().x(), place.center().y() + 2.2 * unit);
    QPainterPath seedling(base);
    seedling.lineTo(base - QPointF(0.0, 2.6 * unit));
    for (const double side : {-1.0, 1.0}) {
        const QPointF fork = base - QPointF(0.0, (side < 0.0 ? 1.7 : 2.6) * unit);
        const QPointF tip = fork + QPointF(side * 1.9 * unit, -1.5 * unit);
        seedling.moveTo(fork);
        seedling.quadTo(fork + QPointF(side * 0.2 * unit, -1.5 * unit), tip);
        seedling.quadTo(fork + QPointF(side * 1.8 * unit, 0.1 * unit), fork);
    }
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(theme::kFaintText, 1.8, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPath(seedling);
}

} // namespace

int CardPainter::heightFor(int width, const QFont& font)
{
    const QRect card(0, 0, width, 0);
    return namePlace(card).bottom() + 1 - kOverlap + kLines * QFontMetrics(lineFont(font)).lineSpacing() +
           kInset + kCardMargin;
}

QRect CardPainter::menuPlace(const QRect& card)
{
    const QRect name = namePlace(card);
    return {name.right() + 1, name.top(), theme::kTarget, theme::kTarget};
}

QSize CardPainter::sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const
{
    const auto* view = qobject_cast<const QListView*>(option.widget);
    return view ? view->gridSize() : QSize();
}

void CardPainter::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const
{
    const bool isChosen = option.state & QStyle::State_Selected;
    const bool isUnderPointer = option.state & QStyle::State_MouseOver;
    const bool hasFocus = isChosen && option.state & QStyle::State_HasFocus;
    painter->save();
    painter->setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
    const QRectF body = QRectF(option.rect).adjusted(kCardMargin, kCardMargin, -kCardMargin, -kCardMargin);
    QPainterPath outline;
    outline.addRoundedRect(body, theme::kRadius, theme::kRadius);
    painter->fillPath(outline, isChosen ? theme::kAccentFill : theme::kRaised);

    painter->save();
    painter->setClipPath(outline);
    const QRectF place = picturePlace(option.rect);
    const auto picture = index.data(Qt::DecorationRole).value<QImage>();
    if (picture.isNull()) {
        drawNoPicture(*painter, place);
    } else {
        const QSizeF shown = place.size().scaled(picture.size(), Qt::KeepAspectRatio);
        const QRectF part(
            QPointF((picture.width() - shown.width()) / 2.0, (picture.height() - shown.height()) / 2.0),
            shown);
        painter->drawImage(place, picture, part);
    }
    painter->restore();
    if (isChosen || isUnderPointer) {
        painter->setPen(
            QPen(hasFocus || isChosen ? theme::kAccent : theme::kFaintText, hasFocus ? 2.0 : 1.0));
        painter->setBrush(Qt::NoBrush);
        painter->drawPath(outline);
    }

    painter->setFont(nameFont(option.font));
    painter->setPen(theme::kText);
    const QRect name = namePlace(option.rect);
    painter->drawText(
        name, Qt::AlignVCenter | Qt::AlignLeft,
        painter->fontMetrics().elidedText(index.data().toString(), Qt::ElideRight, name.width()));
    painter->setFont(lineFont(option.font));
    painter->setPen(theme::kDimText);
    const QRect lines(name.left(), name.bottom() + 1 - kOverlap,
                      option.rect.width() - 2 * (kCardMargin + kInset), 0);
    drawLines(*painter, lines, index.data(LibraryCards::LineRole).toString());

    painter->setPen(Qt::NoPen);
    painter->setBrush(isChosen || isUnderPointer ? theme::kText : theme::kDimText);
    const QPointF dots = QRectF(menuPlace(option.rect)).center();
    for (const double x : {-6.0, 0.0, 6.0})
        painter->drawEllipse(dots + QPointF(x, 0.0), 1.7, 1.7);
    painter->restore();
}

QWidget* CardPainter::createEditor(QWidget* parent, const QStyleOptionViewItem&, const QModelIndex&) const
{
    auto* editor = new QLineEdit(parent);
    editor->setObjectName(QStringLiteral("cardName"));
    editor->setAccessibleName(LibraryCards::tr("Name"));
    return editor;
}

void CardPainter::setEditorData(QWidget* editor, const QModelIndex& index) const
{
    // A picture that arrives during editing must not reset the typed text.
    auto* line = qobject_cast<QLineEdit*>(editor);
    if (line && line->text().isEmpty() && !line->isModified())
        line->setText(index.data(Qt::EditRole).toString());
}

void CardPainter::updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                                       const QModelIndex&) const
{
    editor->setGeometry(namePlace(option.rect).adjusted(-6, 4, theme::kTarget - 3, -4));
}

CardView::CardView(QWidget* parent) : QListView(parent)
{
    setItemDelegate(new CardPainter(this));
    setViewMode(QListView::IconMode);
    setMovement(QListView::Static);
    setResizeMode(QListView::Adjust);
    setUniformItemSizes(true);
    setSelectionMode(QAbstractItemView::SingleSelection);
    setSelectionRectVisible(false);
    setEditTriggers(QAbstractItemView::EditKeyPressed);
    setFrameShape(QFrame::NoFrame);
    setMouseTracking(true);
    setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    viewport()->setAutoFillBackground(false);
    QScroller::grabGesture(viewport(), QScroller::TouchGesture);
    m_longPress.setSingleShot(true);
    m_longPress.setInterval(kLongPress);
    connect(&m_longPress, &QTimer::timeout, this, [this] {
        const QModelIndex index = indexAt(m_pressedAt);
        if (index.isValid())
            Q_EMIT menuAsked(index, viewport()->mapToGlobal(m_pressedAt));
    });
}

bool CardView::isOnDots(const QPoint& place) const
{
    const QModelIndex index = indexAt(place);
    return index.isValid() && CardPainter::menuPlace(visualRect(index)).contains(place);
}

void CardView::resizeEvent(QResizeEvent* event)
{
    const int columns = std::max(1, viewport()->width() / kLeastColumn);
    // One pixel is left over, because otherwise the view does not place the last column.
    const int width = (viewport()->width() - 1) / columns;
    const int height = CardPainter::heightFor(width, font());
    setGridSize({width, height});
    verticalScrollBar()->setSingleStep(height / 3);
    QListView::resizeEvent(event);
}

void CardView::mousePressEvent(QMouseEvent* event)
{
    QListView::mousePressEvent(event);
    m_pressedAt = event->position().toPoint();
    if (event->button() == Qt::LeftButton && indexAt(m_pressedAt).isValid())
        m_longPress.start();
}

void CardView::mouseMoveEvent(QMouseEvent* event)
{
    const QPoint way = event->position().toPoint() - m_pressedAt;
    if (way.manhattanLength() > QGuiApplication::styleHints()->startDragDistance())
        m_longPress.stop();
    // A drag over the cards must not select cards.
    if (event->buttons() == Qt::NoButton)
        QListView::mouseMoveEvent(event);
}

void CardView::mouseReleaseEvent(QMouseEvent* event)
{
    const bool wasShort = m_longPress.isActive();
    m_longPress.stop();
    QListView::mouseReleaseEvent(event);
    const QPoint place = event->position().toPoint();
    if (wasShort && isOnDots(m_pressedAt) && isOnDots(place))
        Q_EMIT menuAsked(indexAt(place), viewport()->mapToGlobal(place));
}

void CardView::mouseDoubleClickEvent(QMouseEvent* event)
{
    m_longPress.stop();
    // Two fast taps on the dots are two clicks, not a double click.
    if (isOnDots(event->position().toPoint()))
        mousePressEvent(event);
    else
        QListView::mouseDoubleClickEvent(event);
}

void CardView::contextMenuEvent(QContextMenuEvent* event)
{
    const bool byKey = event->reason() == QContextMenuEvent::Keyboard;
    const QModelIndex index = byKey ? currentIndex() : indexAt(event->pos());
    if (index.isValid())
        Q_EMIT menuAsked(index,
                         byKey ? viewport()->mapToGlobal(visualRect(index).center()) : event->globalPos());
}

void CardView::keyPressEvent(QKeyEvent* event)
{
    const bool isPlain = !(event->modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier));
    if (event->key() == Qt::Key_Delete && currentIndex().isValid()) {
        Q_EMIT deleteAsked(currentIndex());
    } else if (isPlain && !event->text().isEmpty() && event->text().front().isPrint()) {
        Q_EMIT typed(event->text());
    } else {
        QListView::keyPressEvent(event);
    }
}

} // namespace espalier
