// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QListView>
#include <QStyledItemDelegate>
#include <QTimer>

namespace espalier {

/// Paints a card: a picture, a name, one or two lines of text, and three dots that open its menu.
class CardPainter : public QStyledItemDelegate {
    Q_OBJECT

public:
    using QStyledItemDelegate::QStyledItemDelegate;

    /// Height of a card, px, in a column of that width.
    static int heightFor(int width, const QFont& font);
    /// Where the dots are in a card, px.
    static QRect menuPlace(const QRect& card);

    /// Size of a whole cell of the view's grid.
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                          const QModelIndex& index) const override;
    void setEditorData(QWidget* editor, const QModelIndex& index) const override;
    void updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                              const QModelIndex& index) const override;
};

/// Cards in as many columns as there is room for. Enter or a double click activates a card; the dots, a long
/// press, the right button and the menu key open its menu.
class CardView : public QListView {
    Q_OBJECT

public:
    explicit CardView(QWidget* parent = nullptr);

Q_SIGNALS:
    /// @p place: position on the screen, px.
    void menuAsked(const QModelIndex& index, const QPoint& place);
    void deleteAsked(const QModelIndex& index);
    /// The user has typed letters that the cards do not use.
    void typed(const QString& text);

protected:
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    bool isOnDots(const QPoint& place) const;

    QTimer m_longPress;
    QPoint m_pressedAt;
};

} // namespace espalier
