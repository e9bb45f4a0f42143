// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/architecture/DirectionDiagram.h"

#include "panels/architecture/DiagramStyle.h"

#include <QLocale>

#include <algorithm>

namespace espalier {

namespace {

constexpr double kLabelHeight = 18.0; ///< px
constexpr double kGrain = 100.0;      ///< Weights are hundredths

using Weights = std::array<double, 3>;

Weights weightsOf(const GrowthParameters& growth)
{
    return {growth.axisWeight, growth.tropismWeight, growth.spaceWeight};
}

void setWeights(GrowthParameters& growth, Weights weights)
{
    // Hundredths whose sum is still 1.
    const double axis = std::round(weights[0] * kGrain) / kGrain;
    const double tropism = std::min(std::round(weights[1] * kGrain) / kGrain, 1.0 - axis);
    growth.axisWeight = axis;
    growth.tropismWeight = tropism;
    growth.spaceWeight = std::max(0.0, 1.0 - axis - tropism);
}

double dot(const QPointF& a, const QPointF& b)
{
    return QPointF::dotProduct(a, b);
}

double cross(const QPointF& a, const QPointF& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

} // namespace

Weights barycentricWeights(const std::array<QPointF, 3>& corners, const QPointF& point)
{
    const double area = cross(corners[1] - corners[0], corners[2] - corners[0]);
    Weights weights{};
    for (std::size_t i = 0; i < 3; ++i) {
        const QPointF& from = corners[(i + 1) % 3];
        weights[i] = cross(corners[(i + 2) % 3] - from, point - from) / area;
    }
    if (std::ranges::min(weights) >= 0.0)
        return weights;
    // Outside: the nearest point of the nearest side.
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t next = (i + 1) % 3;
        const QPointF side = corners[next] - corners[i];
        const double along = std::clamp(dot(point - corners[i], side) / dot(side, side), 0.0, 1.0);
        const double away = diagram::distance(point, corners[i] + along * side);
        if (away < least) {
            least = away;
            weights = {};
            weights[i] = 1.0 - along;
            weights[next] = along;
        }
    }
    return weights;
}

DirectionDiagram::DirectionDiagram(ParameterEditor& editor, QWidget* parent) : Diagram(editor, parent)
{
    addHandle({"growth.axisWeight", "growth.tropismWeight", "growth.spaceWeight"},
              tr("Weights of direction"));
}

QString DirectionDiagram::caption() const
{
    const Weights weights = weightsOf(shown());
    const auto greatest = std::ranges::max_element(weights) - weights.begin();
    if (weights[static_cast<std::size_t>(greatest)] < 0.45)
        return tr("balanced");
    const QString words[] = {tr("straight"), tr("tropism"), tr("free space")};
    return words[greatest];
}

std::array<QPointF, 3> DirectionDiagram::corners() const
{
    const double side = std::min(width() - 28.0, (height() - 2.0 * kLabelHeight - 4.0) * 1.1547);
    const double middle = width() / 2.0;
    const double top = (height() - side / 1.1547) / 2.0;
    const double bottom = top + side / 1.1547;
    return {QPointF(middle, top), QPointF(middle - side / 2.0, bottom), QPointF(middle + side / 2.0, bottom)};
}

QPointF DirectionDiagram::place(int, const GrowthParameters& growth) const
{
    const auto at = corners();
    const Weights weights = weightsOf(growth);
    return weights[0] * at[0] + weights[1] * at[1] + weights[2] * at[2];
}

void DirectionDiagram::pull(int, const QPointF& to, TreeParameters& parameters) const
{
    setWeights(parameters.growth, barycentricWeights(corners(), to));
}

void DirectionDiagram::stride(int, const QPointF& direction, ParameterScale::Stride stride,
                              TreeParameters& parameters) const
{
    Weights weights = weightsOf(parameters.growth);
    const double step = (stride == ParameterScale::Stride::Fine ? 1.0 : 4.0) / kGrain;
    if (direction.y() != 0.0) {
        // Moves toward H or away from it; the other weights keep their ratio.
        const double axis = std::clamp(weights[0] - step * direction.y(), 0.0, 1.0);
        const double rest = weights[1] + weights[2];
        const double share = rest > 0.0 ? weights[1] / rest : 0.5;
        weights = {axis, (1.0 - axis) * share, 0.0};
    } else {
        const double rest = weights[1] + weights[2];
        weights[1] = std::clamp(weights[1] - step * direction.x(), 0.0, rest);
    }
    setWeights(parameters.growth, weights);
}

QString DirectionDiagram::bubbleText(int) const
{
    const Weights weights = weightsOf(shown());
    const auto percent = [](double weight) { return QLocale().toString(weight, 'f', 2); };
    return QStringLiteral("H %1 · T %2 · E %3")
        .arg(percent(weights[0]), percent(weights[1]), percent(weights[2]));
}

void DirectionDiagram::draw(QPainter& painter, const GrowthParameters& growth)
{
    const auto at = corners();
    painter.setPen(QPen(theme::kEdge, 1.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(theme::kSunken);
    painter.drawPolygon(at.data(), 3);

    const QPointF point = place(0, growth);
    const Weights weights = weightsOf(growth);
    const QColor colours[] = {diagram::kWood, diagram::kRed, theme::kAccent};
    for (std::size_t i = 0; i < 3; ++i) {
        // The line's width shows the weight; a weight of 0 has no line.
        if (weights[i] <= 0.0)
            continue;
        painter.setPen(QPen(colours[i], 1.2 + 5.0 * weights[i], Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(point, at[i]);
    }
    diagram::drawLabel(painter, at[0] - QPointF(0.0, 11.0), tr("H straight on"));
    // Labels that would reach beyond a side are moved inward, in any language.
    const auto half = [&](const QString& text) {
        return 0.5 * painter.fontMetrics().horizontalAdvance(text) + 2.0;
    };
    const QString tropism = tr("T tropism");
    const QString space = tr("E space");
    diagram::drawLabel(painter, {std::max(half(tropism), at[1].x()), at[1].y() + 11.0}, tropism);
    diagram::drawLabel(painter, {std::min(width() - half(space), at[2].x()), at[2].y() + 11.0}, space);
}

} // namespace espalier
