// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/ParameterScale.h"

#include <QSlider>

namespace espalier {

/// A slider that stands for a parameter's value, which assistive tools read and set in the parameter's own
/// unit. It takes the wheel only while it has the focus: a panel is scrolled past it.
class ParameterSlider : public QSlider {
    Q_OBJECT

public:
    explicit ParameterSlider(const ParameterScale& scale, QWidget* parent = nullptr);

    const ParameterScale& scale() const { return m_scale; }
    /// In the surface unit.
    double parameter() const;
    /// Shows @p value; no signal.
    void show(double value);

Q_SIGNALS:
    /// By a person's hand.
    void edited(double value);

protected:
    void wheelEvent(QWheelEvent* event) override;

private:
    ParameterScale m_scale;
    double m_shown = 0.0; ///< Finer than the slider's positions
};

} // namespace espalier
