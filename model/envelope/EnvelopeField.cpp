// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/envelope/EnvelopeField.h"

#include "model/envelope/Contours.h"
#include "model/envelope/DistanceTransform.h"
#include "model/envelope/Thinning.h"

#include <cmath>

namespace espalier {

namespace {

/// Width of the bell with which the balls' creases are rounded, nodes.
constexpr double kSmoothing = 2.0;

/// The distance rises by 1 a node but at its ridges: there by the sine of half the angle of the corner that
/// they lead to, here 137 degrees.
constexpr double kRidgeSlope = 0.93;

double square(double value)
{
    return value * value;
}

/// Along rows and columns with a symmetric kernel (its centre first); the values at the edge go on beyond it.
Grid<float> convolved(const Grid<float>& values, const std::vector<double>& kernel)
{
    const int width = values.width();
    const int height = values.height();
    const int reach = static_cast<int>(kernel.size()) - 1;
    Grid<float> across(width, height);
    std::vector<double> padded(static_cast<std::size_t>(width + 2 * reach));
    for (int y = 0; y < height; ++y) {
        for (int x = -reach; x < width + reach; ++x)
            padded[static_cast<std::size_t>(x + reach)] = double{values(std::clamp(x, 0, width - 1), y)};
        for (int x = 0; x < width; ++x) {
            const auto centre = static_cast<std::size_t>(x + reach);
            double sum = kernel[0] * padded[centre];
            for (std::size_t k = 1; k < kernel.size(); ++k)
                sum += kernel[k] * (padded[centre - k] + padded[centre + k]);
            across(x, y) = static_cast<float>(sum);
        }
    }
    Grid<float> result(width, height);
    std::vector<double> sums(static_cast<std::size_t>(width));
    for (int y = 0; y < height; ++y) {
        std::ranges::fill(sums, 0.0);
        for (int k = -reach; k <= reach; ++k) {
            const double weight = kernel[static_cast<std::size_t>(std::abs(k))];
            const std::size_t row = across.index(0, std::clamp(y + k, 0, height - 1));
            for (std::size_t x = 0; x < sums.size(); ++x)
                sums[x] += weight * double{across[row + x]};
        }
        for (std::size_t x = 0; x < sums.size(); ++x)
            result[result.index(0, y) + x] = static_cast<float>(sums[x]);
    }
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

/// Smoothed such that quadratic functions stay what they are: around one axis the balls' squared height is
/// one, and a plain bell would lower thin bars to nothing.
Grid<float> smoothed(const Grid<float>& values)
{
    const std::vector<double> kernel = bell(kSmoothing);
    Grid<float> once = convolved(values, kernel);
    const Grid<float> twice = convolved(once, kernel);
    for (std::size_t i = 0; i < once.size(); ++i)
        once[i] = 2.0F * once[i] - twice[i];
    return once;
}

/// Distances to the contours' line, positive where the values are above the level.
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
    for (int y = 0; y < height; ++y) {
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
    return result;
}

/// What balls that touch the outline rise to, squared; negative beyond them.
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
/// they are a few nodes wide, which a second erosion mends.
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

} // namespace

EnvelopeField inflate(std::span<const Loop> loops, int width, int height)
{
    // Half a node's blur takes the steps out of the outline.
    const Grid<float> filled = convolved(coverage(loops, width, height), {0.5, 0.25});
    constexpr float kHalf = 0.5F;
    const Contours contours(filled, kHalf);
    EnvelopeField field;
    if (contours.isEmpty())
        return field;
    field.outlines = contours.loops();
    field.distance = signedDistance(filled, kHalf, contours);
    field.axes = chordalAxes(field.distance);

    const Grid<float> aroundAxes = balls(field.distance, field.axes);
    Mask centres = field.axes;
    for (std::size_t i = 0; i < centres.size(); ++i) {
        const float inside = field.distance[i];
        if (inside > 0.0F && aroundAxes[i] < inside * inside)
            centres[i] = 1;
    }
    field.squaredHeight = smoothed(balls(field.distance, centres));
    for (std::size_t i = 0; i < field.squaredHeight.size(); ++i) {
        // Smoothing lifts the surface off its outline in notches; within one node it is brought back.
        const float inside = field.distance[i];
        float& height2 = field.squaredHeight[i];
        height2 = inside > 0.0F ? std::max(height2 * std::min(inside, 1.0F), inside * inside)
                                : -std::abs(height2) * std::min(-inside, 1.0F);
    }
    return field;
}

} // namespace espalier
