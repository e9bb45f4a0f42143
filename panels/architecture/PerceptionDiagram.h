// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/architecture/Diagram.h"

namespace espalier {

/// A bud, the space that it occupies, and the cone in which it sees room to grow: r, d and ζ (TreeSketch
/// figure 8B).
class PerceptionDiagram : public Diagram {
    Q_OBJECT

public:
    explicit PerceptionDiagram(ParameterEditor& editor, QWidget* parent = nullptr);

    QString caption() const override;
    /// Place of the bud, px; and the length of one internode, px.
    QPointF bud() const;
    double unit() const;

protected:
    QPointF place(int number, const GrowthParameters& growth) const override;
    void pull(int number, const QPointF& to, TreeParameters& parameters) const override;
    void draw(QPainter& painter, const GrowthParameters& growth) override;

private:
    double unitFor(const GrowthParameters& growth) const;
};

} // namespace espalier
