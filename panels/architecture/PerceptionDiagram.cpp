// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/architecture/PerceptionDiagram.h"

#include "panels/architecture/DiagramStyle.h"

#include <algorithm>
#include <numbers>

namespace espalier {

namespace {

enum PerceptionHandle { Radius, Depth, Angle };

constexpr double kPerceptionMargin = 13.0; ///< px

/// How far the drawing reaches to each side of the bud, in internodes.
struct PerceptionExtent {
    double above;
    double below;
    double side;
};

PerceptionExtent perceptionExtentOf(const GrowthParameters& growth)
{
    const double reach = growth.occupancyRadius + growth.perceptionDepth;
    const double half = growth.perceptionAngle / 2.0;
    return {reach, std::max(growth.occupancyRadius, -reach * std::cos(half)),
            std::max(growth.occupancyRadius, reach * std::sin(std::min(half, std::numbers::pi / 2.0)))};
}

} // namespace

PerceptionDiagram::PerceptionDiagram(ParameterEditor& editor, QWidget* parent) : Diagram(editor, parent)
{
    addHandle({"growth.occupancyRadius"});
    addHandle({"growth.perceptionDepth"});
    addHandle({"growth.perceptionAngle"});
}

QString PerceptionDiagram::caption() const
{
    const double r = shown().occupancyRadius;
    if (r < 1.4)
        return tr("dense");
    return r <= 2.8 ? tr("ordinary") : tr("airy");
}

double PerceptionDiagram::unitFor(const GrowthParameters& growth) const
{
    const PerceptionExtent extent = perceptionExtentOf(growth);
    return std::min((height() - 2.0 * kPerceptionMargin) / (extent.above + extent.below),
                    (width() / 2.0 - kPerceptionMargin) / extent.side);
}

double PerceptionDiagram::unit() const
{
    return unitFor(fitted());
}

QPointF PerceptionDiagram::bud() const
{
    const PerceptionExtent extent = perceptionExtentOf(fitted());
    const double unused = height() - 2.0 * kPerceptionMargin - unit() * (extent.above + extent.below);
    return {width() / 2.0, height() - kPerceptionMargin - unused / 2.0 - unit() * extent.below};
}

QPointF PerceptionDiagram::place(int number, const GrowthParameters& growth) const
{
    const double r = unit() * growth.occupancyRadius;
    const double reach = unit() * (growth.occupancyRadius + growth.perceptionDepth);
    switch (number) {
    case Radius: // on the left, where the other two handles never are
        return bud() - QPointF(r, 0.0);
    case Depth:
        return bud() - QPointF(0.0, reach);
    default:
        return diagram::polar(bud(), reach, growth.perceptionAngle / 2.0);
    }
}

void PerceptionDiagram::pull(int number, const QPointF& to, TreeParameters& parameters) const
{
    const auto set = [&](const char* key, double value) {
        setParameter(parameters, key, ParameterScale::of(key).rounded(value));
    };
    switch (number) {
    case Radius:
        set("growth.occupancyRadius", diagram::stretched(bud().x() - to.x(), bud().x()) / unit());
        break;
    case Depth:
        set("growth.perceptionDepth",
            diagram::stretched(bud().y() - to.y(), bud().y()) / unit() - parameters.growth.occupancyRadius);
        break;
    default: {
        const double half = diagram::angleOf(bud(), to);
        // To the left of straight up the cone is closed, to the left of straight down it is open all around.
        const double angle = half >= 0.0 ? half : (half > -std::numbers::pi / 2.0 ? 0.0 : std::numbers::pi);
        set("growth.perceptionAngle", degrees(2.0 * angle));
    }
    }
}

void PerceptionDiagram::draw(QPainter& painter, const GrowthParameters& growth)
{
    const QPointF centre = bud();
    const double r = unit() * growth.occupancyRadius;
    const double reach = unit() * (growth.occupancyRadius + growth.perceptionDepth);
    const double zeta = growth.perceptionAngle;
    painter.setClipRect(rect());

    const auto square = [&](double radius) {
        return QRectF(centre.x() - radius, centre.y() - radius, 2.0 * radius, 2.0 * radius);
    };
    // A truncated cone with spherical caps.
    QPainterPath cone;
    const double from = 90.0 - degrees(zeta) / 2.0;
    if (zeta < radians(359.5)) {
        cone.arcMoveTo(square(reach), from);
        cone.arcTo(square(reach), from, degrees(zeta));
        cone.arcTo(square(r), from + degrees(zeta), -degrees(zeta));
        cone.closeSubpath();
    } else {
        cone.addEllipse(square(reach));
        cone.addEllipse(square(r));
    }
    painter.setPen(QPen(theme::kAccent, 2.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(diagram::kFill);
    painter.drawPath(cone);

    QColor taken = diagram::kRed;
    taken.setAlpha(45);
    painter.setPen(QPen(diagram::kRed, 1.2, Qt::DashLine));
    painter.setBrush(taken);
    painter.drawEllipse(square(r));

    painter.setPen(diagram::guidePen());
    painter.drawLine(centre, place(Depth, growth));
    painter.drawLine(centre, place(Radius, growth));

    // The bud.
    QPainterPath leaf;
    leaf.moveTo(centre + QPointF(0.0, 9.0));
    leaf.quadTo(centre + QPointF(-9.0, 0.0), centre - QPointF(0.0, 11.0));
    leaf.quadTo(centre + QPointF(9.0, 0.0), centre + QPointF(0.0, 9.0));
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme::kAccent);
    painter.drawPath(leaf);

    diagram::drawLabel(painter, place(Radius, growth) + QPointF(0.0, 19.0), QStringLiteral("r"));
    diagram::drawLabel(painter, place(Depth, growth) + QPointF(18.0, 6.0), QStringLiteral("d"));
    diagram::drawLabel(painter, place(Angle, growth) + QPointF(2.0, 19.0), QStringLiteral("ζ"));
}

} // namespace espalier
