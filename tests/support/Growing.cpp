// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/Growing.h"

#include <cmath>

namespace espalier::test {

namespace {

int whole(Random& random, int from, int to)
{
    return from + static_cast<int>(random.bits() % static_cast<std::uint64_t>(to - from + 1));
}

} // namespace

TreeParameters randomParameters(Random& random)
{
    TreeParameters parameters;
    GrowthParameters& p = parameters.growth;
    p.internodeLength = random.uniform(0.05, 0.2);
    p.phyllotaxis = random.uniform(0.0, 2.0 * std::numbers::pi);
    p.lateralsPerNode = whole(random, 1, 4);
    p.branchingAngle = radians(random.uniform(20, 90));
    p.deflectionAngle = radians(random.uniform(0, 20));
    p.irregularity = whole(random, 0, 3) == 0 ? 0.0 : random.uniform();
    p.maxShootLength = whole(random, 1, 8);
    p.occupancyRadius = random.uniform(0.8, 3.0);
    p.perceptionDepth = random.uniform(1.0, 5.0);
    p.perceptionAngle = whole(random, 0, 3) == 0 ? radians(360) : radians(random.uniform(60, 170));
    p.apicalDominance = random.uniform(0.3, 0.7);
    p.lightSensitivity = random.uniform(0.3, 3.0);
    p.shedding = whole(random, 0, 2) == 0 ? 0.0 : random.uniform(0.0, 0.4);
    p.shadowIntensity = random.uniform(0.005, 0.1);
    p.shadowFalloff = random.uniform(1.2, 3.0);
    p.shadowDepth = whole(random, 0, 8);
    const double axis = random.uniform();
    const double tropism = random.uniform();
    const double space = random.uniform();
    const double sum = axis + tropism + space;
    p.axisWeight = axis / sum;
    p.tropismWeight = tropism / sum;
    p.spaceWeight = space / sum;
    p.setPointAngle = radians(random.uniform(0, 180));
    p.tropismFromStroke = whole(random, 0, 1) == 1;
    p.uprightTrunk = whole(random, 0, 1) == 1;
    if (whole(random, 0, 1) == 1) {
        p.ellipseVertical = random.uniform(0.3, 1.5);
        p.ellipseParallel = random.uniform(0.3, 1.5);
        p.ellipseOffset = p.ellipseVertical * random.uniform(-0.95, 0.95);
    }
    p.markerDensity = random.uniform(0.05, 0.3);
    p.markerAge = whole(random, 2, 12);
    p.markersPerBud = whole(random, 1, 6);
    p.straightening = whole(random, 0, 2) == 0 ? 0.0 : random.uniform();
    return parameters;
}

std::vector<BrushSample> strokeAlong(std::span<const Vec3> points, float radius, double seconds)
{
    const int count = std::max(1, static_cast<int>(std::ceil(seconds * 60.0)));
    std::vector<BrushSample> samples;
    for (int i = 0; i <= count; ++i) {
        const double t = static_cast<double>(i) / count * static_cast<double>(points.size() - 1);
        const auto from = std::min(static_cast<std::size_t>(t), points.size() - 1);
        const std::size_t to = std::min(from + 1, points.size() - 1);
        const auto part = static_cast<float>(t - static_cast<double>(from));
        samples.push_back({seconds * i / count, points[from] + part * (points[to] - points[from]), radius});
    }
    return samples;
}

std::vector<BrushSample> randomStroke(Random& random, const GrowthParameters& growth, double seconds)
{
    const auto l = static_cast<float>(growth.internodeLength);
    std::vector<Vec3> points;
    // One after another: the order in which arguments are evaluated is the compiler's choice.
    const auto z = static_cast<float>(random.uniform(-5, 5));
    const auto y = static_cast<float>(random.uniform(2, 12));
    const auto x = static_cast<float>(random.uniform(-5, 5));
    Vec3 point = l * Vec3(x, y, z);
    for (int i = 0; i < 4; ++i) {
        points.push_back(point);
        point += 4.0F * l * random.direction();
        point.y() = std::abs(point.y());
    }
    // Some strokes draw a single axis, some are thin, most are wide.
    const int kind = whole(random, 0, 5);
    const double inInternodes = kind == 0   ? 0.0
                                : kind == 1 ? random.uniform(0.5, 2.0)
                                            : random.uniform(2.0, 6.0);
    return strokeAlong(points, l * static_cast<float>(inInternodes), random.uniform(0.3, seconds));
}

void brush(TreeDocument& document, std::span<const BrushSample> samples, Competitors competitors)
{
    BrushGesture gesture(document, samples.front(), competitors);
    for (const BrushSample& sample : samples.subspan(1))
        gesture.add(sample);
    gesture.finish();
}

int grow(TreeDocument& document, int steps, Competitors competitors)
{
    GrowGesture gesture(document, competitors);
    int grown = 0;
    while (grown < steps && gesture.step())
        ++grown;
    gesture.finish();
    return grown;
}

void growAtRandom(TreeDocument& document, std::uint64_t seed, std::uint32_t least, std::uint32_t most)
{
    Random random(seed, 0, 0, Purpose::ShootLength);
    document.reset(seed, randomParameters(random));
    for (int attempt = 0; attempt < 30 && document.tree().size() < least; ++attempt) {
        const std::vector<BrushSample> samples = randomStroke(random, document.parameters().growth, 1.5);
        BrushGesture gesture(document, samples.front());
        for (const BrushSample& sample : samples) {
            if (document.tree().size() < most)
                gesture.add(sample);
        }
        gesture.finish();
        for (int i = 0; i < 3 && document.tree().size() < most; ++i)
            grow(document, 1);
    }
}

double diameterOf(const Widths& widths, const TreeIndex& index, InternodeId id)
{
    return 2.0 * static_cast<double>(widths.radius(index, id));
}

} // namespace espalier::test
