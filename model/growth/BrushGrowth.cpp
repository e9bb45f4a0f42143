// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/growth/BrushGrowth.h"

#include "model/base/Random.h"

#include <cmath>

namespace espalier {

namespace {

/// More markers per step only cost time.
constexpr double kMostNewMarkers = 4000;
/// Below this radius, in occupancy radii, growth begins to turn into drawing.
constexpr double kThinBrush = 1.0;
/// The direction of a stroke is averaged over about this length, m.
constexpr float kDirectionWindow = 0.25F;
/// The greatest number of internodes that one step draws; the rest of a longer path follows in later steps.
constexpr int kMostDrawn = 10'000;

Vec3 aboveGround(const Vec3& point)
{
    return {point.x(), std::max(0.0F, point.y()), point.z()};
}

/// The degree to which a brush of this radius (m) draws instead of growing, 0...1.
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
    // Otherwise the zone that the leading shoot occupies would cover all of a thin brush.
    options.perception.occupancy *= static_cast<float>(1.0 - 0.75 * drawn);
    return options;
}

/// The first point along @p path whose distance from @p centre is @p distance; removes the path up to there.
/// Empty if no point of the path is that far away.
std::optional<Vec3> advanceAlong(std::vector<Vec3>& path, const Vec3& centre, float distance)
{
    for (std::size_t i = 0; i < path.size(); ++i) {
        if ((path[i] - centre).norm() < distance)
            continue;
        const Vec3 from = i == 0 ? centre : path[i - 1];
        const Vec3 along = path[i] - from;
        // |from + s along − centre| = distance, the greater root: from lies within the distance.
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

/// Removes the part of @p path before the point that is nearest to @p centre.
void beginAtNearest(std::vector<Vec3>& path, const Vec3& centre)
{
    Vec3 nearest = path.front();
    std::size_t next = 1;
    for (std::size_t i = 1; i < path.size(); ++i) {
        const Vec3 along = path[i] - path[i - 1];
        const float squared = along.squaredNorm();
        const float s = squared > 0.0F ? (centre - path[i - 1]).dot(along) / squared : 0.0F;
        const Vec3 point = path[i - 1] + std::clamp(s, 0.0F, 1.0F) * along;
        if ((point - centre).squaredNorm() <= (nearest - centre).squaredNorm()) {
            nearest = point;
            next = i;
        }
    }
    path.erase(path.begin(), path.begin() + static_cast<std::ptrdiff_t>(next));
    path.insert(path.begin(), nearest);
}

/// @p direction, or, if it leads back along @p heading, the nearest one that does not. All are unit vectors.
Vec3 withoutFold(const Vec3& direction, const Vec3& heading)
{
    const float along = direction.dot(heading);
    if (along >= 0.0F)
        return direction;
    const Vec3 side = direction - along * heading;
    return side.norm() > 1e-3F ? Vec3(side.normalized()) : anyPerpendicular(heading);
}

/// The living bud nearest to @p point; at one node, the terminal bud before laterals; at equal distance, the
/// smallest id.
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

TreeDelta BrushGrowth::step(const Tree& tree, const TreeIndex& index, const GrowthModel& model,
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
    const float sight = brush.radius + 0.5F * options.perception.reach;
    if (const std::optional<InternodeId> seedling = seedlingFor(tree, index, brush.position, sight)) {
        return growLeader(tree, index, {trunkTip(index, *seedling), kTerminalSlot}, brush.position, sight,
                          p.maxShootLength, m_workspace);
    }
    return model.growToward(tree, index, m_markers, options, m_workspace);
}

/// A seedling grows a bare trunk toward a brush that is too far away to be perceived. Returns the root of
/// that seedling; nothing if the bud nearest to the brush is in sight, or belongs to a tree that has
/// branches.
std::optional<InternodeId> BrushGrowth::seedlingFor(const Tree& tree, const TreeIndex& index,
                                                    const Vec3& brush, float sight) const
{
    const auto isSeedling = [&index](InternodeId root) { return index.tipCount(root) == 1; };
    // To find the nearest bud is a pass over the tree.
    if (m_competitors.node != kNoInternode || std::ranges::none_of(index.roots(), isSeedling))
        return {};
    const BudRef nearest = nearestBud(tree, index, brush);
    const InternodeId root = index.rootOf(tree, nearest.node);
    if (!isSeedling(root) || (brush - index.nodePosition(nearest.node)).norm() <= sight)
        return {};
    return root;
}

void BrushGrowth::layMarkers(const Tree& tree, const BrushSample& previous, const BrushSample& brush)
{
    const GrowthParameters& p = tree.parameters().growth;
    const double reach = std::max<double>(brush.radius, p.internodeLength);
    const double volume = 4.0 / 3.0 * std::numbers::pi * std::pow(reach / p.internodeLength, 3);
    // At least three; otherwise it would depend on chance whether a thin brush grows anything.
    const double wanted = std::clamp(p.markerDensity * volume / p.markerAge, 3.0, kMostNewMarkers);
    Random random(tree.seed(), tree.step(), m_time, Purpose::BrushMarker);
    for (int i = 0; i < static_cast<int>(wanted); ++i) {
        // Spread over the path since the last sample, so that a fast stroke leaves no gaps.
        const auto t = static_cast<float>(random.uniform());
        const Vec3 centre = previous.position + t * (brush.position - previous.position);
        const float radius = previous.radius + t * (brush.radius - previous.radius);
        const Vec3 marker = centre + radius * random.inBall();
        if (marker.y() < 0.0F) // there is no free space below the ground
            continue;
        m_markers.positions.push_back(marker);
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
        m_path.push_back(aboveGround(previous.position));
        m_hasDrawn = false;
    }
    m_path.push_back(aboveGround(brush.position));
    // The competitors' node may have been shed, or may never have existed.
    if (m_drawnBud->node >= tree.size() || !tree.isAlive(m_drawnBud->node))
        return deltaStartingAt(tree);

    const auto length = static_cast<float>(p.internodeLength);
    if (!m_hasDrawn && !beginPath(growing, length))
        return deltaStartingAt(tree);
    for (int i = 0; i < kMostDrawn; ++i) {
        const auto [node, slot] = *m_drawnBud;
        if ((growing.buds(node) & budBit(slot)) == 0)
            break;
        const Vec3 base = growing.nodePosition(node);
        const std::optional<Vec3> next = advanceAlong(m_path, base, length);
        if (!next)
            break;
        Vec3 direction = (*next - base).normalized();
        if (slot == kTerminalSlot)
            direction = withoutFold(direction, growing.heading(node));
        m_drawnBud = BudRef{growing.grow(node, slot, direction, p.phyllotaxis, length, 1.0), kTerminalSlot};
        m_hasDrawn = true;
    }
    return growing.takeDelta();
}

/// Prepares the path so that the drawn axis begins at its bud, wherever the stroke was pressed: removes the
/// part of the stroke before its nearest point to the bud. If that point is behind the bud (a press at the
/// foot of a seedling), drawing waits until the stroke is an internode past it. Returns whether the axis may
/// grow.
bool BrushGrowth::beginPath(const GrowingTree& growing, float length)
{
    const auto [node, slot] = *m_drawnBud;
    const Vec3 base = growing.nodePosition(node);
    beginAtNearest(m_path, base);
    const Vec3 nearest = m_path.front();
    if (slot != kTerminalSlot || (nearest - base).dot(growing.heading(node)) >= 0.0F)
        return true;
    const std::optional<Vec3> past = advanceAlong(m_path, nearest, length);
    if (past)
        m_path.insert(m_path.begin(), *past);
    return past.has_value();
}

} // namespace espalier
