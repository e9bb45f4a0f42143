// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/architecture/Diagram.h"

namespace espalier {

/// The ellipse of gravimorphism around a level branch, seen along it: a bud's readiness to grow is the length
/// of the ray toward it (TreeSketch figure 10B; s_v, s_p, e_v). The dotted circle is 1: no effect.
class GravimorphismDiagram : public Diagram {
    Q_OBJECT

public:
    explicit GravimorphismDiagram(ParameterEditor& editor, QWidget* parent = nullptr);

    QString caption() const override;
    /// The point of the drawing where the ray toward the bud at χ (rad, 0 = top) ends, px.
    QPointF rayEnd(double chi) const;
    /// Place of the branch, px; and the length that stands for 1, px.
    QPointF axis() const;
    double unit() const;

protected:
    QPointF place(int number, const GrowthParameters& growth) const override;
    void pull(int number, const QPointF& to, TreeParameters& parameters) const override;
    void draw(QPainter& painter, const GrowthParameters& growth) override;
    bool isRing(int number) const override;
    QString bubbleText(int number) const override;
};

} // namespace espalier
