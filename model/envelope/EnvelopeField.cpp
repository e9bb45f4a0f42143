// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/envelope/EnvelopeField.h"

#include "model/envelope/Contours.h"
#include "model/envelope/DistanceTransform.h"
#include "model/envelope/GridLines.h"
#include "model/envelope/Thinning.h"

#include <cmath>

namespace espalier {

namespace {

/// Width of the bell with which the balls' creases are rounded, nodes.
constexpr double kSmoothing = 4.0;

/// The distance rises by 1 a node, except at its ridges: there by the sine of half the angle of the corner to
/// which the ridge leads, here 137 degrees.
constexpr double kRidgeSlope = 0.93;

double square(double value)
{
    return value * value;
}

/// Extrapolates values with a constant second derivative, @p steps beyond the edge.
double beyond(double edge, double inner, double curvature, int steps)
{
    const double slope = inner - edge - 0.5 * curvature;
    return edge - slope * steps + 0.5 * curvature * steps * steps;
}

/// Convolves along rows and columns with a symmetric kernel (its centre first). Beyond the edge, the values
/// continue with the given second derivative along rows and along columns.
Grid<float> convolved(const Grid<float>& values, const std::vector<double>& kernel, double curvature)
{
    const int width = values.width();
    const int height = values.height();
    const int reach = static_cast<int>(kernel.size()) - 1;
    const auto row = [&](int y) {
        return static_cast<std::size_t>(y + reach) * static_cast<std::size_t>(width);
    };
    std::vector<double> across(static_cast<std::size_t>(height + 2 * reach) *
                               static_cast<std::size_t>(width));
    forLines(height, [&](int begin, int end) {
        std::vector<double> padded(static_cast<std::size_t>(width + 2 * reach));
        for (int y = begin; y < end; ++y) {
            double* const line = padded.data() + reach;
            for (int x = 0; x < width; ++x)
                line[x] = double{values(x, y)};
            for (int k = 1; k <= reach; ++k) {
                line[-k] = beyond(line[0], line[1], curvature, k);
                line[width - 1 + k] = beyond(line[width - 1], line[width - 2], curvature, k);
            }
            double* const sums = across.data() + row(y);
            for (int x = 0; x < width; ++x) {
                double sum = kernel[0] * line[x];
                for (int k = 1; k <= reach; ++k)
                    sum += kernel[static_cast<std::size_t>(k)] * (line[x - k] + line[x + k]);
                sums[x] = sum;
            }
        }
    });
    for (int k = 1; k <= reach; ++k) {
        for (std::size_t x = 0; x < static_cast<std::size_t>(width); ++x) {
            across[row(-k) + x] = beyond(across[row(0) + x], across[row(1) + x], curvature, k);
            across[row(height - 1 + k) + x] =
                beyond(across[row(height - 1) + x], across[row(height - 2) + x], curvature, k);
        }
    }
    Grid<float> result(width, height);
    forLines(height, [&](int begin, int end) {
        std::vector<double> sums(static_cast<std::size_t>(width));
        for (int y = begin; y < end; ++y) {
            std::ranges::fill(sums, 0.0);
            for (int k = -reach; k <= reach; ++k) {
                const double weight = kernel[static_cast<std::size_t>(std::abs(k))];
                for (std::size_t x = 0; x < sums.size(); ++x)
                    sums[x] += weight * across[row(y + k) + x];
            }
            for (std::size_t x = 0; x < sums.size(); ++x)
                result[result.index(0, y) + x] = static_cast<float>(sums[x]);
        }
    });
    return result;
}

std::vector<double> bell(double deviation)
{
    std::vector<double> kernel;
    double sum = 0.0;
    for (int k = 0; k <= std::ceil(3.0 * deviation); ++k) {
        kernel.push_back(std::exp(-0.5 * square(k / deviation)));
        sum += (k == 0 ? 1.0 : 2.0) * kernel.back();
    }
    for (double& weight : kernel)
        weight /= sum;
    return kernel;
}

/// Smooths such that quadratic functions do not change: around one axis the squared height of the balls is
/// quadratic, and a plain bell would lower thin bars to nothing.
Grid<float> smoothed(const Grid<float>& values)
{
    constexpr double kCurvature = -2.0; // of R² - |p - s|²
    const std::vector<double> kernel = bell(kSmoothing);
    Grid<float> once = convolved(values, kernel, kCurvature);
    const Grid<float> twice = convolved(once, kernel, kCurvature);
    for (std::size_t i = 0; i < once.size(); ++i)
        once[i] = 2.0F * once[i] - twice[i];
    return once;
}

/// Distances to the contours, positive where the values are above the level.
Grid<float> signedDistance(const Grid<float>& values, float level, const Contours& contours)
{
    const int width = values.width();
    const int height = values.height();
    Grid<double> nearLine(width, height, kNoSite);
    for (int y = 0; y + 1 < height; ++y)
        for (int x = 0; x + 1 < width; ++x)
            if (contours.isCrossed(x, y))
                nearLine(x, y) = nearLine(x + 1, y) = nearLine(x, y + 1) = nearLine(x + 1, y + 1) = 0.0;
    const DistanceTransform nearest = distanceTransform(nearLine);

    Grid<float> result(width, height);
    forLines(height, [&](int begin, int end) {
        for (int y = begin; y < end; ++y) {
            for (int x = 0; x < width; ++x) {
                const bool inside = values(x, y) > level;
                double squared = nearest.value(x, y);
                if (inside || squared <= square(kFieldMargin)) {
                    // The nearest part of the line lies beside the nearest node that has the line beside it.
                    const int site = nearest.site(x, y);
                    squared = contours.squaredDistance({x, y}, site % width, site / width, 2);
                }
                result(x, y) = static_cast<float>(inside ? std::sqrt(squared) : -std::sqrt(squared));
            }
        }
    });
    return result;
}

/// Squared height of balls that touch the outline; negative beyond them.
Grid<float> balls(const Grid<float>& distance, const Mask& centres)
{
    Grid<double> cost(distance.width(), distance.height(), kNoSite);
    for (std::size_t i = 0; i < cost.size(); ++i)
        if (centres[i] != 0)
            cost[i] = -square(double{distance[i]});
    const DistanceTransform power = distanceTransform(cost);
    Grid<float> result(distance.width(), distance.height());
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] = static_cast<float>(-power.value[i]);
    return result;
}

Mask insideOf(const Grid<float>& distance)
{
    Mask mask(distance.width(), distance.height());
    for (std::size_t i = 0; i < mask.size(); ++i)
        mask[i] = distance[i] > 0.0F;
    return mask;
}

/// Erosion alone would round off corners. So the ridges that corners raise in the distance are kept at first;
/// they are a few nodes wide, and a second erosion thins them.
Mask chordalAxes(const Grid<float>& distance)
{
    const Mask inside = insideOf(distance);
    Mask ridges(distance.width(), distance.height());
    for (int y = 1; y + 1 < distance.height(); ++y) {
        for (int x = 1; x + 1 < distance.width(); ++x) {
            const double across = 0.5 * double{distance(x + 1, y) - distance(x - 1, y)};
            const double up = 0.5 * double{distance(x, y + 1) - distance(x, y - 1)};
            ridges(x, y) = inside(x, y) != 0 && square(across) + square(up) < square(kRidgeSlope);
        }
    }
    return thinned(thinned(inside, ridges));
}

/// The axes run between nodes, so the inner nodes beside an axis get balls too.
Mask withNeighbours(const Mask& axes, const Grid<float>& distance)
{
    Mask result(axes.width(), axes.height());
    for (int y = 1; y + 1 < axes.height(); ++y)
        for (int x = 1; x + 1 < axes.width(); ++x)
            for (int k = 0; axes(x, y) != 0 && k < 9; ++k)
                if (distance(x + k % 3 - 1, y + k / 3 - 1) > 0.0F)
                    result(x + k % 3 - 1, y + k / 3 - 1) = 1;
    return result;
}

/// Smoothing lifts the surface off the outline in notches and lowers it below the outline in corners. This
/// corrects the surface within a few nodes of the outline, by the error at the nearest point of the outline.
Grid<float> sewnToOutline(const Grid<float>& squaredHeight, const Grid<float>& distance)
{
    const int width = distance.width();
    const int height = distance.height();
    Grid<float> result(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const auto inside = double{distance(x, y)};
            auto sewn = double{squaredHeight(x, y)};
            const double share = 1.0 - std::abs(inside) / kFieldMargin;
            if (share > 0.0) {
                const Eigen::Vector2d rise(double{distance(std::min(x + 1, width - 1), y)} -
                                               double{distance(std::max(x - 1, 0), y)},
                                           double{distance(x, std::min(y + 1, height - 1))} -
                                               double{distance(x, std::max(y - 1, 0))});
                const Eigen::Vector2d foot = Eigen::Vector2d(x, y) - inside * rise.stableNormalized();
                const int left = std::clamp(static_cast<int>(foot.x()), 0, width - 2);
                const int below = std::clamp(static_cast<int>(foot.y()), 0, height - 2);
                sewn -= share * interpolate(squaredHeight, {left, below, foot.x() - left, foot.y() - below});
            }
            result(x, y) =
                static_cast<float>(inside > 0.0 ? std::max(sewn, inside * inside) : std::min(sewn, 0.0));
        }
    }
    return result;
}

} // namespace

EnvelopeField inflate(std::span<const Loop> loops, int width, int height)
{
    // A blur of half a node removes the steps from the outline.
    const Grid<float> filled = convolved(coverage(loops, width, height), {0.5, 0.25}, 0.0);
    constexpr float kHalf = 0.5F;
    const Contours contours(filled, kHalf);
    EnvelopeField field;
    if (contours.isEmpty())
        return field;
    field.outlines = contours.loops();
    field.distance = signedDistance(filled, kHalf, contours);
    field.axes = chordalAxes(field.distance);

    Mask centres = withNeighbours(field.axes, field.distance);
    const Grid<float> aroundAxes = balls(field.distance, centres);
    for (std::size_t i = 0; i < centres.size(); ++i) {
        const float inside = field.distance[i];
        if (inside > 0.0F && aroundAxes[i] < inside * inside)
            centres[i] = 1;
    }
    field.squaredHeight = sewnToOutline(smoothed(balls(field.distance, centres)), field.distance);
    return field;
}

} // namespace espalier
