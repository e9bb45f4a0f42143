// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include <optional>

namespace espalier {

/// The curve from a pen's pressure to what the brush makes of it: p to the power of an exponent. A drag draws
/// the curve to the pointer, and so do arrow keys, Home and End; a pen that presses here is shown as a dot on
/// it, and leaves a trail as wide as it says.
class PressureCurve : public QWidget {
    Q_OBJECT

public:
    /// The exponent stays within these.
    PressureCurve(double softest, double firmest, QWidget* parent = nullptr);

    double exponent() const { return m_exponent; }
    void setExponent(double exponent);
    /// Pressure of the pen that presses here now, 0...1 as the tablet tells it; 0 for none.
    double rawPressure() const { return m_raw; }

    QSize sizeHint() const override { return {260, 230}; }

Q_SIGNALS:
    /// By a drag or a key.
    void exponentEdited(double exponent);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void tabletEvent(QTabletEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool event(QEvent* event) override;

private:
    struct Dab {
        QPointF place;
        double width;
    };

    QRectF field() const;
    void dragTo(const QPointF& place);
    /// What a key makes of the exponent, or nothing if it means nothing.
    std::optional<double> keyed(int key) const;

    double m_softest;
    double m_firmest;
    double m_exponent = 1.0;
    double m_raw = 0.0;
    QList<Dab> m_trail;
};

} // namespace espalier
