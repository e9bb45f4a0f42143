// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include <optional>

namespace espalier {

/// The curve from a pen's pressure to the pressure that the brush uses: p to the power of an exponent. A drag
/// moves the curve to the pointer; arrow keys, Home and End move it too. A pen that presses here shows as a
/// dot on the curve, and leaves a trail as wide as the resulting pressure.
class PressureCurve : public QWidget {
    Q_OBJECT

public:
    /// @p softest and @p firmest limit the exponent.
    PressureCurve(double softest, double firmest, QWidget* parent = nullptr);

    double exponent() const { return m_exponent; }
    void setExponent(double exponent);
    /// Pressure of the pen that presses on the widget now, 0...1 as the tablet reports it; 0 for none.
    double rawPressure() const { return m_raw; }

    QSize sizeHint() const override { return {260, 230}; }

Q_SIGNALS:
    /// The user has changed the exponent by a drag or a key.
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
    /// The exponent after a key press, or nothing if the key has no meaning here.
    std::optional<double> keyed(int key) const;

    double m_softest;
    double m_firmest;
    double m_exponent = 1.0;
    double m_raw = 0.0;
    QList<Dab> m_trail;
};

} // namespace espalier
