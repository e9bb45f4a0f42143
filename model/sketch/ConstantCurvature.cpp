// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/sketch/ConstantCurvature.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace espalier {

namespace {

/// |k| at each point of a line, 1/m: the turn divided by half the length of the two segments. Ends have their
/// neighbour's.
std::vector<double> strokeCurvatures(const SketchLine& line)
{
    std::vector<double> curvatures(line.size(), 0.0);
    for (std::size_t i = 1; i + 1 < line.size(); ++i) {
        const Eigen::Vector2d from = line[i] - line[i - 1];
        const Eigen::Vector2d to = line[i + 1] - line[i];
        const double length = 0.5 * (from.norm() + to.norm());
        if (from.norm() > 0.0 && to.norm() > 0.0) {
            const double turn = std::atan2(from.x() * to.y() - from.y() * to.x(), from.dot(to));
            curvatures[i] = std::abs(turn) / length;
        }
    }
    if (line.size() > 2) {
        curvatures.front() = curvatures[1];
        curvatures.back() = curvatures[line.size() - 2];
    }
    return curvatures;
}

double quantileOf(std::vector<double> values, double quantile)
{
    const auto place =
        static_cast<std::ptrdiff_t>(std::round(quantile * static_cast<double>(values.size() - 1)));
    std::ranges::nth_element(values, values.begin() + place);
    return values[static_cast<std::size_t>(place)];
}

/// Integrates φ and z along the stroke.
class ElevatedCurve {
public:
    ElevatedCurve(double curvature, double limit, double side)
        : m_curvature(curvature), m_limit(limit), m_side(side)
    {
    }

    double depth() const { return m_depth; }

    /// Goes on by @p length, along which the stroke's curvature changes linearly.
    void advance(double length, double fromCurvature, double toCurvature)
    {
        constexpr double kStep = 0.02; // rad
        const int steps = std::clamp(static_cast<int>(std::ceil(m_curvature * length / kStep)), 4, 64);
        const double step = length / steps;
        for (int i = 0; i < steps; ++i) {
            const double stroke = std::lerp(fromCurvature, toCurvature, (i + 0.5) / steps);
            const double middle =
                std::clamp(m_elevation + 0.5 * step * m_side * slope(m_elevation, stroke), -m_limit, m_limit);
            m_depth += step * std::tan(middle);
            m_elevation += step * m_side * slope(middle, stroke);
            if (std::abs(m_elevation) >= m_limit) {
                m_elevation = std::copysign(m_limit, m_elevation);
                m_side = -std::copysign(1.0, m_elevation);
            }
        }
    }

private:
    /// |φ'|
    double slope(double elevation, double strokeCurvature) const
    {
        const double cosine = std::cos(elevation);
        const double whole = m_curvature / cosine;
        const double planar = strokeCurvature * cosine;
        const double square = whole * whole - planar * planar;
        // Below this the stroke itself has the whole curvature but for rounding, which would grow otherwise.
        return square > 1e-5 * m_curvature * m_curvature ? std::sqrt(square) : 0.0;
    }

    double m_curvature; ///< K, 1/m
    double m_limit;
    double m_side;
    double m_elevation = 0.0; ///< φ
    double m_depth = 0.0;
};

} // namespace

std::vector<double> constantCurvatureDepths(const SketchLine& line, const ConstantCurvatureOptions& options)
{
    std::vector<double> depths(line.size(), 0.0);
    if (line.size() < 2)
        return depths;
    if (line.size() > 2) {
        const std::vector<double> curvatures = strokeCurvatures(line);
        const double greatest = quantileOf(curvatures, options.quantile);
        // A turn of a thousandth of a radian in all is a straight line.
        if (greatest * lengthOf(line) > 1e-3) {
            ElevatedCurve curve(greatest, options.elevationLimit, options.side);
            for (std::size_t i = 1; i < line.size(); ++i) {
                curve.advance((line[i] - line[i - 1]).norm(), std::min(curvatures[i - 1], greatest),
                              std::min(curvatures[i], greatest));
                depths[i] = curve.depth();
            }
        }
    }
    if (options.endDepth) {
        const std::vector<double> shares = arcShares(line);
        const double missing = *options.endDepth - depths.back();
        for (std::size_t i = 0; i < line.size(); ++i)
            depths[i] += shares[i] * missing;
        depths.back() = *options.endDepth;
    }
    return depths;
}

} // namespace espalier
