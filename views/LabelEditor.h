// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLineEdit>

#include <functional>

namespace espalier {

/// A field in place of a label over the tree, to type what the label says. Enter hands the text over and
/// closes the field, unless the text is refused; Escape, and a click elsewhere, close it. Then its parent has
/// the focus again.
class LabelEditor : public QLineEdit {
    Q_OBJECT

public:
    /// @p take: returns whether it has taken the text.
    LabelEditor(const QRectF& box, const QString& text, std::function<bool(const QString&)> take,
                QWidget* parent);

protected:
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    void shut();

    std::function<bool(const QString&)> m_take;
};

} // namespace espalier
