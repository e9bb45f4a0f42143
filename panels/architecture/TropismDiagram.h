// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/growth/Schematic.h"
#include "panels/architecture/Diagram.h"

namespace espalier {

/// The schematic tree that shows the effect of all parameters of growth, and over it the arrow of tropism:
/// the set-point angle θ from straight up (TreeSketch §3.4, figure 16).
class TropismDiagram : public Diagram {
    Q_OBJECT

public:
    explicit TropismDiagram(ParameterEditor& editor, QWidget* parent = nullptr);

    QString caption() const override;
    /// The schematic tree for the shown parameters; it is grown when it is asked for.
    const Schematic& schematic() const;

protected:
    QPointF place(int number, const GrowthParameters& growth) const override;
    void pull(int number, const QPointF& to, TreeParameters& parameters) const override;
    void draw(QPainter& painter, const GrowthParameters& growth) override;

private:
    QPointF pivot() const;
    double arrowLength() const;

    mutable GrowthParameters m_grownWith;
    mutable Schematic m_schematic;
};

/// Draws a schematic tree into @p box, as large as possible, its base in the middle of the lower edge.
void drawSchematic(QPainter& painter, const Schematic& schematic, const QRectF& box);

} // namespace espalier
