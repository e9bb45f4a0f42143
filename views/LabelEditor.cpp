// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/LabelEditor.h"

#include <QKeyEvent>

#include <algorithm>
#include <utility>

namespace espalier {

namespace {

// px
constexpr int kLeastEditorWidth = 84;
constexpr int kEditorHeight = 32;

bool isEnter(int key)
{
    return key == Qt::Key_Return || key == Qt::Key_Enter;
}

} // namespace

LabelEditor::LabelEditor(const QRectF& box, const QString& text, std::function<bool(const QString&)> take,
                         QWidget* parent)
    : QLineEdit(text, parent), m_take(std::move(take))
{
    const int width = std::max(kLeastEditorWidth, static_cast<int>(box.width()) + 24);
    const QPoint middle = box.center().toPoint();
    setGeometry(std::clamp(static_cast<int>(box.left()), 0, std::max(0, parent->width() - width)),
                std::clamp(middle.y() - kEditorHeight / 2, 0, std::max(0, parent->height() - kEditorHeight)),
                width, kEditorHeight);
    setAccessibleName(text);
    selectAll();
    show();
    setFocus(Qt::OtherFocusReason);
}

bool LabelEditor::event(QEvent* event)
{
    // The window has shortcuts for these keys.
    if (event->type() == QEvent::ShortcutOverride) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Escape || isEnter(key)) {
            event->accept();
            return true;
        }
    }
    return QLineEdit::event(event);
}

void LabelEditor::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Escape) {
        shut();
    } else if (isEnter(event->key())) {
        if (m_take(text()))
            shut();
        else
            selectAll();
    } else {
        QLineEdit::keyPressEvent(event);
    }
}

void LabelEditor::focusOutEvent(QFocusEvent* event)
{
    QLineEdit::focusOutEvent(event);
    if (event->reason() != Qt::PopupFocusReason && event->reason() != Qt::ActiveWindowFocusReason)
        shut();
}

void LabelEditor::shut()
{
    if (isHidden())
        return;
    const bool hadFocus = hasFocus();
    hide();
    if (hadFocus)
        parentWidget()->setFocus(Qt::OtherFocusReason);
    deleteLater();
}

} // namespace espalier
