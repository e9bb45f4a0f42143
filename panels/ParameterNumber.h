// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/ParameterScale.h"

#include <QDoubleSpinBox>

namespace espalier {

/// A parameter's number with its unit, which the user can tap and edit; a length can be typed in any unit. It
/// has no buttons, and uses the wheel only while it has the focus, so that the wheel scrolls the panel.
class ParameterNumber : public QDoubleSpinBox {
    Q_OBJECT

public:
    explicit ParameterNumber(const ParameterScale& scale, QWidget* parent = nullptr);

    /// Shows a value in the surface unit.
    void show(double value);

    QString textFromValue(double value) const override;
    double valueFromText(const QString& text) const override;
    QValidator::State validate(QString& text, int& cursor) const override;
    void stepBy(int steps) override;

Q_SIGNALS:
    /// The user has typed or stepped to another value (surface unit).
    void edited(double value);

protected:
    void focusInEvent(QFocusEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    bool event(QEvent* event) override;

private:
    ParameterScale m_scale;
    double m_factor;
};

} // namespace espalier
