// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/architecture/BranchingDiagram.h"

#include "panels/architecture/DiagramStyle.h"

#include <algorithm>

namespace espalier {

namespace {

enum BranchingHandle { Lateral, Axis };

/// A twig with a leaf at its end.
void drawTwig(QPainter& painter, const QPointF& from, const QPointF& to, double width)
{
    painter.setPen(QPen(diagram::kWood, width, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(from, to);
}

} // namespace

BranchingDiagram::BranchingDiagram(ParameterEditor& editor, QWidget* parent) : Diagram(editor, parent)
{
    addHandle({"growth.branchingAngle"});
    addHandle({"growth.deflectionAngle"});
}

QString BranchingDiagram::caption() const
{
    if (shown().deflectionAngle >= radians(25))
        return tr("zigzag");
    const double psi = degrees(shown().branchingAngle);
    if (psi < 40.0)
        return tr("acute");
    return psi <= 95.0 ? tr("spreading") : tr("reflexed");
}

QPointF BranchingDiagram::node() const
{
    return {width() / 2.0 - 8.0, 0.58 * height()};
}

double BranchingDiagram::lateralLength() const
{
    return std::min(0.46 * height(), 0.5 * width() - 10.0);
}

double BranchingDiagram::axisLength() const
{
    return 0.58 * height() - 16.0;
}

QPointF BranchingDiagram::place(int number, const GrowthParameters& growth) const
{
    return number == Lateral ? diagram::polar(node(), lateralLength(), growth.branchingAngle)
                             : diagram::polar(node(), axisLength(), -growth.deflectionAngle);
}

void BranchingDiagram::pull(int number, const QPointF& to, TreeParameters& parameters) const
{
    const char* key = number == Lateral ? "growth.branchingAngle" : "growth.deflectionAngle";
    const ParameterScale scale = ParameterScale::of(key);
    double angle = degrees(diagram::angleOf(node(), to)) * (number == Lateral ? 1.0 : -1.0);
    // Beyond straight down the angle continues on the other side.
    if (angle < -90.0)
        angle += 360.0;
    setParameter(parameters, key, scale.rounded(angle));
}

void BranchingDiagram::draw(QPainter& painter, const GrowthParameters& growth)
{
    const double psi = growth.branchingAngle;
    const double delta = growth.deflectionAngle;
    painter.setPen(diagram::guidePen());
    painter.drawLine(node(), diagram::polar(node(), axisLength() + 8.0, 0.0));

    drawTwig(painter, place(Lateral, growth), node(), 6.0);
    drawTwig(painter, place(Axis, growth), node(), 7.0);
    drawTwig(painter, node(), {node().x(), height() - 5.0}, 9.0);

    const double reach = 0.52 * lateralLength();
    painter.setPen(QPen(theme::kHandle, 1.5));
    diagram::drawArc(painter, node(), reach, 0.0, psi);
    if (delta > 0.0)
        diagram::drawArc(painter, node(), 0.62 * axisLength(), -delta, 0.0);
    if (psi > radians(14))
        diagram::drawLabel(painter, diagram::polar(node(), reach + 11.0, psi / 2.0), QStringLiteral("ψ"));
    diagram::drawLabel(painter, place(Axis, growth) - QPointF(20.0, 0.0), QStringLiteral("δ"));
}

} // namespace espalier
