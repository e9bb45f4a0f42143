// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/FineSlider.h"
#include "panels/ParameterScale.h"

namespace espalier {

/// A slider for a parameter's value, which assistive tools read and set in the parameter's own unit. It uses
/// the wheel only while it has the focus, so that the wheel scrolls the panel.
class ParameterSlider : public FineSlider {
    Q_OBJECT

public:
    explicit ParameterSlider(const ParameterScale& scale, QWidget* parent = nullptr);

    const ParameterScale& scale() const { return m_scale; }
    /// The value in the surface unit.
    double parameter() const;
    /// Shows @p value; emits no signal.
    void show(double value);

Q_SIGNALS:
    /// The user has moved the slider.
    void edited(double value);

protected:
    void wheelEvent(QWheelEvent* event) override;

private:
    ParameterScale m_scale;
    double m_shown = 0.0; ///< The value, finer than the slider's positions
};

} // namespace espalier
