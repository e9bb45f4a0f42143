// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

namespace espalier {

/// Shows where the user can rotate the tree with one hand while the other hand brushes (TreeSketch §3.1): a
/// scale along the bottom edge that turns with the view. The viewport below it handles the fingers.
class RotationStrip : public QWidget {
    Q_OBJECT

public:
    explicit RotationStrip(QWidget* parent = nullptr);

    /// Sets the azimuth of the view, rad.
    void setAzimuth(double azimuth);
    /// Sets whether the picture below the strip is light.
    void setOverLight(bool light);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    double m_azimuth = 0.0;
    bool m_isOverLight = false;
};

} // namespace espalier
