// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/architecture/Diagram.h"

#include <array>

namespace espalier {

/// The weights of growth's direction as a point in a triangle: α toward H, the current direction of the axis,
/// β toward T, tropism, γ toward E, free space (TreeSketch figure 11B).
class DirectionDiagram : public Diagram {
    Q_OBJECT

public:
    explicit DirectionDiagram(ParameterEditor& editor, QWidget* parent = nullptr);

    QString caption() const override;
    /// The corners H, T and E, px.
    std::array<QPointF, 3> corners() const;

protected:
    QPointF place(int number, const GrowthParameters& growth) const override;
    void pull(int number, const QPointF& to, TreeParameters& parameters) const override;
    void stride(int number, const QPointF& direction, ParameterScale::Stride stride,
                TreeParameters& parameters) const override;
    void draw(QPainter& painter, const GrowthParameters& growth) override;
    QString bubbleText(int number) const override;
};

/// The weights, each at least 0 and with the sum 1, of the point of the triangle that is nearest to @p point.
std::array<double, 3> barycentricWeights(const std::array<QPointF, 3>& corners, const QPointF& point);

} // namespace espalier
