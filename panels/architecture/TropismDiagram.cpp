// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/architecture/TropismDiagram.h"

#include "model/shape/Widths.h"
#include "panels/architecture/DiagramStyle.h"

#include <algorithm>
#include <cmath>

namespace espalier {

namespace {

constexpr double kTropismMargin = 8.0; ///< px

// Shares of the drawing's height: twigs stay visible, trunks slim.
constexpr double kTwig = 0.0065;
constexpr double kTrunk = 0.05;
constexpr double kLeafRadius = 0.0138;

/// The mean angle from straight up of the last internodes of all branches, rad.
double meanTipAngle(const Schematic& schematic)
{
    const auto& [tree, index] = schematic;
    double sum = 0.0;
    int count = 0;
    for (InternodeId id = 0; id < tree.size(); ++id) {
        if (!tree.isAlive(id) || index.firstChild(id) != kNoInternode)
            continue;
        const Vec3 way = index.nodePosition(id) - index.basePosition(tree, id);
        sum += std::atan2(std::hypot(way.x(), way.z()), way.y());
        ++count;
    }
    return count > 0 ? sum / count : 0.0;
}

} // namespace

TropismDiagram::TropismDiagram(ParameterEditor& editor, QWidget* parent)
    : Diagram(editor, parent), m_grownWith(editor.shown().growth), m_schematic(growSchematic(m_grownWith))
{
    addHandle({"growth.setPointAngle"});
}

QString TropismDiagram::caption() const
{
    if (shown().tropismFromStroke)
        return tr("as the stroke");
    // What the tree does, not what the arrow alone would make of it: other weights may be stronger.
    const double angle = degrees(meanTipAngle(schematic()));
    if (angle < 30.0)
        return tr("upright");
    if (angle < 70.0)
        return tr("slanting");
    return angle <= 100.0 ? tr("level") : tr("weeping");
}

const Schematic& TropismDiagram::schematic() const
{
    if (m_grownWith != shown()) {
        m_grownWith = shown();
        m_schematic = growSchematic(m_grownWith);
    }
    return m_schematic;
}

QPointF TropismDiagram::pivot() const
{
    return {width() / 2.0, height() / 2.0};
}

double TropismDiagram::arrowLength() const
{
    return 0.5 * std::min(width(), height()) - 14.0;
}

QPointF TropismDiagram::place(int, const GrowthParameters& growth) const
{
    return diagram::polar(pivot(), arrowLength(), growth.setPointAngle);
}

void TropismDiagram::pull(int, const QPointF& to, TreeParameters& parameters) const
{
    const ParameterScale scale = ParameterScale::of("growth.setPointAngle");
    // The angle has no side: a drag to the left of the tree means the same as one to the right.
    const double theta = std::abs(diagram::angleOf(pivot(), to));
    setParameter(parameters, "growth.setPointAngle", scale.rounded(degrees(theta)));
}

void TropismDiagram::draw(QPainter& painter, const GrowthParameters& growth)
{
    drawSchematic(painter, schematic(),
                  QRectF(rect()).adjusted(kTropismMargin, kTropismMargin, -kTropismMargin, -2.0));

    const bool isInferred = growth.tropismFromStroke;
    const QColor colour = isInferred ? theme::kFaintText : theme::kHandle;
    painter.setPen(diagram::guidePen());
    painter.drawLine(pivot(), diagram::polar(pivot(), arrowLength(), 0.0));
    painter.setPen(QPen(colour, 1.5, Qt::DotLine));
    diagram::drawArc(painter, pivot(), 0.62 * arrowLength(), 0.0, growth.setPointAngle);
    painter.setPen(QPen(colour, 3.0, isInferred ? Qt::DashLine : Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawLine(pivot(), place(0, growth));
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    painter.drawEllipse(pivot(), 3.0, 3.0);
}

void drawSchematic(QPainter& painter, const Schematic& schematic, const QRectF& box)
{
    const Tree& tree = schematic.tree;
    const TreeIndex& index = schematic.index;
    Box3 bounds(Vec3::Zero());
    for (InternodeId id = 0; id < tree.size(); ++id) {
        if (tree.isAlive(id))
            bounds.extend(index.nodePosition(id));
    }
    // The base stays in the middle, so that it does not wander while a handle moves.
    const double halfWidth = std::max({1.0, -1.0 * bounds.min().x(), 1.0 * bounds.max().x()});
    const double tall = std::max(1.0, static_cast<double>(bounds.sizes().y()));
    const double scale = std::min(box.width() / 2.0 / halfWidth, box.height() / tall);
    const QPointF base(box.center().x(), box.bottom() + scale * static_cast<double>(bounds.min().y()));
    const auto seen = [&](const Vec3& position) {
        return base +
               QPointF(scale * static_cast<double>(position.x()), -scale * static_cast<double>(position.y()));
    };

    const Widths widths(WidthParameters{.exponent = 2.2, .tipDiameter = 1.0}, index.tipCount(0));
    const double thickness =
        box.height() * std::min(kTwig, kTrunk / (2.0 * static_cast<double>(widths.radius(index, 0))));
    const double leaf = box.height() * kLeafRadius;
    for (InternodeId id = 0; id < tree.size(); ++id) {
        if (!tree.isAlive(id))
            continue;
        const double width = 2.0 * static_cast<double>(widths.radius(index, id)) * thickness;
        painter.setPen(QPen(diagram::kWood, std::max(0.6, width), Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(seen(index.basePosition(tree, id)), seen(index.nodePosition(id)));
    }
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme::kAccent);
    for (InternodeId id = 0; id < tree.size(); ++id) {
        if (tree.isAlive(id) && index.tipCount(id) == 1 && index.firstChild(id) == kNoInternode)
            painter.drawEllipse(seen(index.nodePosition(id)), leaf, leaf);
    }
}

} // namespace espalier
