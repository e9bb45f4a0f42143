// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/growth/BrushGrowth.h"

#include "model/base/Random.h"

#include <cmath>

namespace espalier {

namespace {

/// More markers a step than this bring nothing but waiting.
constexpr double kMostNewMarkers = 4000;
/// A brush thinner than this many occupancy radii begins to draw.
constexpr double kThinBrush = 1.0;
/// m; a stroke's direction is an average over about this length.
constexpr float kDirectionWindow = 0.25F;

/// How far a brush of this radius is on the way from growing (0) to drawing (1).
double drawnness(const GrowthParameters& p, float radius)
{
    return std::clamp(1.0 - radius / (kThinBrush * p.occupancyRadius * p.internodeLength), 0.0, 1.0);
}

bool draws(const GrowthParameters& p, float radius)
{
    return radius < 0.5 * p.internodeLength;
}

GrowthStepOptions optionsFor(const GrowthParameters& p, float radius)
{
    GrowthStepOptions options = GrowthStepOptions::of(p);
    const double drawn = drawnness(p, radius);
    options.weights = {p.axisWeight * (1.0 - drawn), p.tropismWeight * (1.0 - drawn),
                       p.spaceWeight * (1.0 - drawn) + drawn};
    options.leastVigour = drawn;
    // A thin brush must not be swallowed by the zone that the shoot it leads occupies.
    options.perception.occupancy *= static_cast<float>(1.0 - 0.75 * drawn);
    return options;
}

/// Where @p path first is @p distance away from @p centre, going along it; the path up to there is taken out.
/// Nothing if it stays nearer.
std::optional<Vec3> advanceAlong(std::vector<Vec3>& path, const Vec3& centre, float distance)
{
    for (std::size_t i = 0; i < path.size(); ++i) {
        if ((path[i] - centre).norm() < distance)
            continue;
        const Vec3 from = i == 0 ? centre : path[i - 1];
        const Vec3 along = path[i] - from;
        // |from + s along − centre| = distance, the greater root: from lies within.
        const Vec3 offset = from - centre;
        const double a = along.squaredNorm();
        const double b = offset.dot(along);
        const double c = offset.squaredNorm() - distance * distance;
        const double s = std::clamp((-b + std::sqrt(std::max(0.0, b * b - a * c))) / a, 0.0, 1.0);
        path.erase(path.begin(), path.begin() + static_cast<std::ptrdiff_t>(i));
        return from + static_cast<float>(s) * along;
    }
    return std::nullopt;
}

/// The living bud nearest to @p point: terminal before lateral, then by id.
BudRef nearestBud(const Tree& tree, const TreeIndex& index, const Vec3& point)
{
    BudRef best{0, kTerminalSlot};
    float nearest = std::numeric_limits<float>::infinity();
    for (InternodeId id = 0; id < tree.size(); ++id) {
        if (!tree.isAlive(id) || tree.buds(id) == 0)
            continue;
        const float squared = (index.nodePosition(id) - point).squaredNorm();
        if (squared < nearest) {
            nearest = squared;
            best = {id, (tree.buds(id) & kTerminalBud) != 0 ? kTerminalSlot
                                                            : std::countr_zero(unsigned{tree.buds(id)})};
        }
    }
    return best;
}

} // namespace

TreeDelta BrushGrowth::step(const Tree& tree, const TreeIndex& index, const GrowthIndex& growth,
                            const BrushSample& previous, const BrushSample& brush)
{
    const GrowthParameters& p = tree.parameters().growth;
    ++m_time;
    const Vec3 moved = brush.position - previous.position;
    const float fresh = std::min(1.0F, moved.norm() / kDirectionWindow);
    if (fresh > 0.0F)
        m_strokeDirection = (1.0F - fresh) * m_strokeDirection + fresh * moved.normalized();

    if (draws(p, brush.radius)) {
        m_markers.clear();
        return draw(tree, index, previous, brush);
    }
    m_drawnBud.reset();
    m_path.clear();

    const Step age = static_cast<Step>(p.markerAge);
    m_markers.filter([&](std::size_t i) { return m_time - m_markers.born[i] < age; });
    layMarkers(tree, previous, brush);

    GrowthStepOptions options = optionsFor(p, brush.radius);
    options.competitors = m_competitors;
    if (p.tropismFromStroke && m_strokeDirection.norm() > 0.1F) {
        const double cosine = std::clamp(m_strokeDirection.normalized().y(), -1.0F, 1.0F);
        options.setPointAngle = std::acos(cosine);
    }
    // A seedling follows a brush that is out of its sight, with a trunk that stays bare until it gets there.
    const float sight = brush.radius + 0.5F * options.perception.reach;
    const bool isSeedling = index.tipCount(0) == 1 && m_competitors.node == kNoInternode;
    const auto isOutOfSight = [&] {
        const BudRef nearest = nearestBud(tree, index, brush.position);
        return (brush.position - index.nodePosition(nearest.node)).norm() > sight;
    };
    if (isSeedling && isOutOfSight())
        return growLeader(tree, index, brush.position, sight, p.maxShootLength, m_workspace);
    return growthStep(tree, index, growth, m_markers, options, m_workspace);
}

void BrushGrowth::layMarkers(const Tree& tree, const BrushSample& previous, const BrushSample& brush)
{
    const GrowthParameters& p = tree.parameters().growth;
    const double reach = std::max<double>(brush.radius, p.internodeLength);
    const double volume = 4.0 / 3.0 * std::numbers::pi * std::pow(reach / p.internodeLength, 3);
    // At least a few, or a thin brush would be a matter of luck.
    const double wanted = std::clamp(p.markerDensity * volume / p.markerAge, 3.0, kMostNewMarkers);
    Random random(tree.seed(), tree.step(), m_time, Purpose::BrushMarker);
    for (int i = 0; i < static_cast<int>(wanted); ++i) {
        // Spread over the way that the brush came, so that a fast stroke leaves no gaps.
        const auto t = static_cast<float>(random.uniform());
        const Vec3 centre = previous.position + t * (brush.position - previous.position);
        const float radius = previous.radius + t * (brush.radius - previous.radius);
        m_markers.positions.push_back(centre + radius * random.inBall());
        m_markers.born.push_back(m_time);
    }
}

TreeDelta BrushGrowth::draw(const Tree& tree, const TreeIndex& index, const BrushSample& previous,
                            const BrushSample& brush)
{
    const GrowthParameters& p = tree.parameters().growth;
    GrowingTree growing(tree, index, m_workspace);
    if (!m_drawnBud) {
        m_drawnBud = m_competitors.node != kNoInternode ? BudRef{m_competitors.node, m_competitors.slot}
                                                        : nearestBud(tree, index, previous.position);
        m_path.push_back(previous.position);
    }
    m_path.push_back(brush.position);
    // The competitors' node may have been shed on the way, or never have been.
    if (m_drawnBud->node >= tree.size() || !tree.isAlive(m_drawnBud->node))
        return TreeDelta::startingAt(tree);

    const auto length = static_cast<float>(p.internodeLength);
    while ((growing.buds(m_drawnBud->node) & budBit(m_drawnBud->slot)) != 0) {
        const Vec3 base = growing.nodePosition(m_drawnBud->node);
        const std::optional<Vec3> next = advanceAlong(m_path, base, length);
        if (!next)
            break;
        const Vec3 direction = (*next - base).normalized();
        const InternodeId grown =
            growing.grow(m_drawnBud->node, m_drawnBud->slot, direction, p.phyllotaxis, length, 1.0);
        m_drawnBud = BudRef{grown, kTerminalSlot};
    }
    return growing.takeDelta();
}

} // namespace espalier
