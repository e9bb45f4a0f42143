// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/sketch/StrokeFit.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace espalier {

namespace {

bool isSample(const Eigen::Vector2d& point)
{
    return point.allFinite() && point.cwiseAbs().maxCoeff() <= kFarthestSketchPoint;
}

/// The samples without those that lie within @p least of the last one kept; the last sample stays.
SketchLine withoutRepeats(const SketchLine& samples, double least)
{
    SketchLine kept;
    for (const Eigen::Vector2d& sample : samples) {
        if (kept.empty() || (sample - kept.back()).norm() > least)
            kept.push_back(sample);
    }
    const Eigen::Vector2d& end = samples.back();
    if (kept.size() > 1 && kept.back() != end)
        kept.back() = end;
    return kept;
}

bool isLoop(const SketchLine& line, double length, const StrokeFitOptions& options)
{
    if (line.size() < 3)
        return false;
    const double gap = (line.back() - line.front()).norm();
    return gap < options.closingShare * length || (gap < options.closingGap && gap < length / 3.0);
}

/// Bell-shaped means of points at even distances @p step, each at most @p farthest from its point. The ends
/// of an open line stay, and near them the mean reaches only as far as to the end, on both sides.
SketchLine withoutShake(const SketchLine& line, bool closed, double step, double deviation, double farthest)
{
    const auto count = static_cast<std::ptrdiff_t>(line.size());
    const auto reach = std::min(static_cast<std::ptrdiff_t>(3.0 * deviation / step), (count - 1) / 2);
    if (reach < 1)
        return line;
    std::vector<double> weight;
    for (std::ptrdiff_t i = 0; i <= reach; ++i)
        weight.push_back(std::exp(-0.5 * std::pow(static_cast<double>(i) * step / deviation, 2)));
    const auto at = [&](std::ptrdiff_t i) -> Eigen::Vector2d {
        return line[static_cast<std::size_t>((i + count) % count)];
    };
    SketchLine smooth;
    smooth.reserve(line.size());
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        const std::ptrdiff_t here = closed ? reach : std::min({reach, i, count - 1 - i});
        Eigen::Vector2d sum = at(i);
        double total = 1.0;
        for (std::ptrdiff_t j = 1; j <= here; ++j) {
            const double share = weight[static_cast<std::size_t>(j)];
            sum += share * (at(i - j) + at(i + j));
            total += 2.0 * share;
        }
        Eigen::Vector2d shift = sum / total - at(i);
        if (const double norm = shift.norm(); norm > farthest)
            shift *= farthest / norm;
        smooth.push_back(at(i) + shift);
    }
    return smooth;
}

/// The farthest that a sample is from a line. Samples and line run side by side, so each sample is compared
/// with the line near its own share of the length only.
double fartherSample(const SketchLine& samples, const SketchLine& line)
{
    constexpr std::ptrdiff_t kWindow = 6;
    const std::vector<double> shares = arcShares(samples);
    const auto segments = static_cast<std::ptrdiff_t>(line.size()) - 1;
    double worst = 0.0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const auto middle = static_cast<std::ptrdiff_t>(shares[i] * static_cast<double>(segments));
        const std::ptrdiff_t from = std::max<std::ptrdiff_t>(middle - kWindow, 0);
        const std::ptrdiff_t to = std::min(middle + kWindow, segments);
        const SketchLine part(line.begin() + from, line.begin() + to + 1);
        worst = std::max(worst, nearestPlace(part, samples[i]).distance);
    }
    return worst;
}

} // namespace

StrokeFitOptions StrokeFitOptions::forPixels(double pixel)
{
    const StrokeFitOptions pixels;
    return {.tolerance = pixels.tolerance * pixel,
            .spacing = pixels.spacing * pixel,
            .shake = pixels.shake * pixel,
            .closingGap = pixels.closingGap * pixel,
            .closingShare = pixels.closingShare};
}

std::optional<SketchStroke> fitStroke(const SketchLine& samples, const StrokeFitOptions& options)
{
    if (samples.empty() || !std::ranges::all_of(samples, isSample))
        return std::nullopt;
    SketchLine kept = withoutRepeats(samples, 0.05 * options.tolerance);
    const double length = lengthOf(kept);
    if (kept.size() < 2 || length == 0.0)
        return SketchStroke{.kind = SketchStroke::Kind::Dot, .line = {samples.front()}};

    const bool closed = isLoop(kept, length, options);
    if (closed && kept.front() != kept.back())
        kept.push_back(kept.front());
    const double whole = lengthOf(kept);
    // Fine points first, so that smoothing does not depend on the rate of the device.
    const double pieces = std::ceil(whole / std::min(0.25 * options.tolerance, options.spacing));
    const auto fine = static_cast<std::size_t>(std::clamp(pieces, 2.0, 8.0 * kMostSketchPoints));
    SketchLine smooth = evenLine(kept, fine + 1);
    if (closed)
        smooth.pop_back();
    smooth = withoutShake(smooth, closed, whole / static_cast<double>(fine), options.shake,
                          0.5 * options.tolerance);
    if (closed)
        smooth.push_back(smooth.front());

    SketchStroke stroke{.kind = closed ? SketchStroke::Kind::Closed : SketchStroke::Kind::Open, .line = {}};
    const double least = closed ? 3.0 : 1.0;
    for (double spacing = options.spacing;; spacing *= 0.5) {
        const double steps = std::ceil(lengthOf(smooth) / spacing - 1e-9);
        stroke.line =
            evenLine(smooth, static_cast<std::size_t>(std::clamp(steps, least, kMostSketchPoints - 1.0)) + 1);
        // With points as near as that, no sample can be farther away than the tolerance.
        if (spacing <= 0.75 * options.tolerance || fartherSample(kept, stroke.line) <= options.tolerance)
            break;
    }
    if (closed)
        stroke.line.pop_back();
    return stroke;
}

} // namespace espalier
