// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/architecture/Diagram.h"

namespace espalier {

/// An axis with a lateral: the branching angle ψ between the two, and the deflection δ of the axis away from
/// the lateral (TreeSketch figure 8A).
class BranchingDiagram : public Diagram {
    Q_OBJECT

public:
    explicit BranchingDiagram(ParameterEditor& editor, QWidget* parent = nullptr);

    QString caption() const override;

protected:
    QPointF place(int number, const GrowthParameters& growth) const override;
    void pull(int number, const QPointF& to, TreeParameters& parameters) const override;
    void draw(QPainter& painter, const GrowthParameters& growth) override;

private:
    QPointF node() const;
    double lateralLength() const;
    double axisLength() const;
};

} // namespace espalier
