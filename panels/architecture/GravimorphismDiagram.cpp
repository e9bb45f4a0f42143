// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/architecture/GravimorphismDiagram.h"

#include "model/growth/Gravimorphism.h"
#include "panels/architecture/DiagramStyle.h"

#include <QLocale>

#include <algorithm>
#include <numbers>

namespace espalier {

namespace {

enum EllipseHandle { Vertical, Parallel, Offset };

constexpr double kEllipseMargin = 14.0; ///< px
/// To each side of the branch the drawing has room for so much; for larger ellipses it shrinks.
constexpr double kRoom = 1.25;

GravimorphismEllipse ellipseOf(const GrowthParameters& growth)
{
    return {growth.ellipseVertical, growth.ellipseParallel, growth.ellipseOffset};
}

/// How far the drawing reaches from the branch.
struct EllipseExtent {
    double above;
    double below;
    double side;
};

EllipseExtent ellipseExtentOf(const GrowthParameters& growth)
{
    return {std::max(kRoom, growth.ellipseVertical + growth.ellipseOffset),
            std::max(kRoom, growth.ellipseVertical - growth.ellipseOffset),
            std::max(kRoom, growth.ellipseParallel)};
}

} // namespace

GravimorphismDiagram::GravimorphismDiagram(ParameterEditor& editor, QWidget* parent) : Diagram(editor, parent)
{
    addHandle({"growth.ellipseVertical"});
    addHandle({"growth.ellipseParallel"});
    addHandle({"growth.ellipseOffset"});
}

QString GravimorphismDiagram::caption() const
{
    const GravimorphismEllipse ellipse = ellipseOf(shown());
    const double above = ellipseDistance(ellipse, 0.0);
    const double side = ellipseDistance(ellipse, std::numbers::pi / 2.0);
    const double below = ellipseDistance(ellipse, std::numbers::pi);
    const double most = std::max({above, side, below});
    if (most - std::min({above, side, below}) < 0.1 * most)
        return tr("all alike");
    if (side > std::max(above, below))
        return tr("amphitony");
    if (std::abs(above - below) < 0.1 * most)
        return tr("vertical");
    return above > below ? tr("epitony") : tr("hypotony");
}

QPointF GravimorphismDiagram::axis() const
{
    const EllipseExtent extent = ellipseExtentOf(fitted());
    const double unused = height() - 2.0 * kEllipseMargin - unit() * (extent.above + extent.below);
    return {width() / 2.0, kEllipseMargin + unused / 2.0 + unit() * extent.above};
}

double GravimorphismDiagram::unit() const
{
    const EllipseExtent extent = ellipseExtentOf(fitted());
    return std::min((height() - 2.0 * kEllipseMargin) / (extent.above + extent.below),
                    (width() / 2.0 - kEllipseMargin) / extent.side);
}

QPointF GravimorphismDiagram::rayEnd(double chi) const
{
    return diagram::polar(axis(), unit() * ellipseDistance(ellipseOf(shown()), chi), chi);
}

QPointF GravimorphismDiagram::place(int number, const GrowthParameters& growth) const
{
    const QPointF centre = axis() - QPointF(0.0, unit() * growth.ellipseOffset);
    switch (number) {
    case Vertical:
        return centre - QPointF(0.0, unit() * growth.ellipseVertical);
    case Parallel:
        return centre + QPointF(unit() * growth.ellipseParallel, 0.0);
    default:
        return centre;
    }
}

void GravimorphismDiagram::pull(int number, const QPointF& to, TreeParameters& parameters) const
{
    const double rise = axis().y() - to.y();
    const double up = diagram::stretched(rise, rise > 0.0 ? axis().y() : height() - axis().y()) / unit();
    const double right = diagram::stretched(to.x() - axis().x(), width() / 2.0) / unit();
    const auto set = [&](const char* key, double value) {
        setParameter(parameters, key, ParameterScale::of(key).rounded(value));
    };
    switch (number) {
    case Vertical: {
        // The handle at the top stands for s_v + e_v; e_v stays unless the ellipse becomes too flat for it.
        const double offset = parameters.growth.ellipseOffset;
        const double vertical = up - offset;
        const bool isFlat = std::abs(offset) > kMostEllipseOffset * vertical;
        set("growth.ellipseVertical",
            isFlat ? up / (1.0 + std::copysign(kMostEllipseOffset, offset)) : vertical);
        break;
    }
    case Parallel:
        set("growth.ellipseParallel", right);
        break;
    default:
        set("growth.ellipseOffset", up);
    }
}

bool GravimorphismDiagram::isRing(int number) const
{
    return number == Offset; // this handle lies on the branch, unless one side is favoured
}

QString GravimorphismDiagram::bubbleText(int number) const
{
    const GravimorphismEllipse ellipse = ellipseOf(shown());
    const auto number2 = [](double value) { return QLocale().toString(value, 'f', 2); };
    const QString above = number2(ellipseDistance(ellipse, 0.0));
    const QString below = number2(ellipseDistance(ellipse, std::numbers::pi));
    if (number == Parallel)
        return tr("side %1").arg(number2(ellipseDistance(ellipse, std::numbers::pi / 2.0)));
    return tr("above %1 · below %2").arg(above, below);
}

void GravimorphismDiagram::draw(QPainter& painter, const GrowthParameters& growth)
{
    const QPointF origin = axis();
    painter.setPen(QPen(diagram::kGuide, 1.0));
    painter.drawLine(QPointF(10.0, origin.y()), QPointF(width() - 10.0, origin.y()));
    painter.drawLine(QPointF(origin.x(), 4.0), QPointF(origin.x(), height() - 4.0));
    painter.setBrush(Qt::NoBrush);
    painter.setPen(diagram::guidePen());
    painter.drawEllipse(origin, unit(), unit());

    QPainterPath outline;
    constexpr int kRays = 96;
    for (int i = 0; i < kRays; ++i) {
        const QPointF end = rayEnd(2.0 * std::numbers::pi * i / kRays);
        i == 0 ? outline.moveTo(end) : outline.lineTo(end);
    }
    outline.closeSubpath();
    painter.setPen(QPen(theme::kAccent, 2.0));
    painter.setBrush(diagram::kFill);
    painter.drawPath(outline);

    // Buds around the branch, their size shows their readiness to grow.
    const GravimorphismEllipse ellipse = ellipseOf(growth);
    for (int i = 0; i < 8; ++i) {
        const double chi = std::numbers::pi / 4.0 * i;
        const double size = 0.9 + 2.0 * std::min(1.6, ellipseDistance(ellipse, chi));
        painter.setPen(QPen(QColor(0x7f, 0xb0, 0x69, 0x70), 1.0));
        painter.drawLine(diagram::polar(origin, 14.0, chi), rayEnd(chi));
        painter.setPen(Qt::NoPen);
        painter.setBrush(theme::kAccent);
        painter.drawEllipse(diagram::polar(origin, 15.0, chi), size, size);
    }
    painter.setBrush(diagram::kWood);
    painter.drawEllipse(origin, 12.0, 12.0);
    diagram::drawLabel(painter, {origin.x() + 10.0, height() - 9.0}, QStringLiteral("V"));
    diagram::drawLabel(painter, {width() - 8.0, origin.y() + 11.0}, QStringLiteral("P"));
}

} // namespace espalier
