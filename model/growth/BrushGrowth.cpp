// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/growth/BrushGrowth.h"

#include "model/base/Random.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

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
/// Markers for each internode's length of a thin line.
constexpr double kMarkersAlong = 3.0;
/// A line's point is reached by a node that is nearer than this, in internodes, or within the brush there.
constexpr float kReached = 1.5F;
/// A line that comes near itself is not reached farther ahead than this, in internodes of its length.
constexpr float kReachedAhead = 8.0F;
/// Growth has come to its end after so many steps without any.
constexpr int kMostIdle = 3;
constexpr int kMostSettlingSteps = 400;

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

/// Notes that the axis of @p tip is drawn up to there.
void noteDrawn(GrowingTree& growing, InternodeId tip)
{
    const InternodeId axis = growing.axis(tip);
    float length = growing.length(axis);
    for (InternodeId id = tip; id != axis; id = growing.parent(id))
        length += growing.length(id);
    growing.setDrawnLength(axis, length);
}

/// The living bud nearest to @p point, of the first @p count internodes; at one node, the terminal bud before
/// laterals; at equal distance, the smallest id.
BudRef nearestBud(const Tree& tree, const TreeIndex& index, const Vec3& point,
                  std::uint32_t count = kNoInternode)
{
    BudRef best{0, kTerminalSlot};
    float nearest = std::numeric_limits<float>::infinity();
    for (InternodeId id = 0; id < std::min(count, tree.size()); ++id) {
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
                            std::span<const BrushSample> way)
{
    const GrowthParameters& p = tree.parameters().growth;
    const BrushSample& brush = way.back();
    ++m_time;
    const Vec3 moved = brush.position - way.front().position;
    const float fresh = std::min(1.0F, moved.norm() / kDirectionWindow);
    if (fresh > 0.0F)
        m_strokeDirection = (1.0F - fresh) * m_strokeDirection + fresh * moved.normalized();

    if (m_end == StrokeEnd::Arrives) {
        passNewNodes(tree, index);
        m_line.insert(m_line.end(), m_line.empty() ? way.begin() : way.begin() + 1, way.end());
        m_lineSizes.resize(m_time, m_line.size());
    }
    if (draws(p, brush.radius)) {
        m_markers.clear();
        return draw(tree, index, way);
    }
    m_drawnBud.reset();
    m_path.clear();
    dropOldMarkers(tree);
    layMarkers(tree, way);
    return growTowardMarkers(tree, index, model, brush);
}

std::optional<TreeDelta> BrushGrowth::settle(const Tree& tree, const TreeIndex& index,
                                             const GrowthModel& model, const BrushSample& brush)
{
    const GrowthParameters& p = tree.parameters().growth;
    if (m_end != StrokeEnd::Arrives || m_hasSettled || draws(p, brush.radius))
        return std::nullopt;
    passNewNodes(tree, index);
    if (!m_isReachingOut)
        ++m_time;
    dropOldMarkers(tree);
    const bool isThin = drawnness(p, brush.radius) > 0.0;
    const bool hasArrived = isThin && m_passed == m_line.size();
    if (!hasArrived && !m_markers.positions.empty() && m_idle < kMostIdle &&
        ++m_settlingSteps < kMostSettlingSteps)
        return growTowardMarkers(tree, index, model, brush);
    m_hasSettled = true;
    m_markers.clear();
    return isThin && !hasArrived ? drawRest(tree, index) : std::nullopt;
}

/// Markers live for a number of steps; where a thin line arrives, until the tree has passed them, too.
void BrushGrowth::dropOldMarkers(const Tree& tree)
{
    const GrowthParameters& p = tree.parameters().growth;
    const Step age = static_cast<Step>(p.markerAge);
    m_markers.filter([&](std::size_t i) {
        const Step born = m_markers.born[i]; // The first is 1
        if (m_time - born < age)
            return true;
        return born <= m_lineSizes.size() && m_lineSizes[born - 1] > m_passed &&
               drawnness(p, m_line[m_lineSizes[born - 1] - 1].radius) > 0.0;
    });
}

TreeDelta BrushGrowth::growTowardMarkers(const Tree& tree, const TreeIndex& index, const GrowthModel& model,
                                         const BrushSample& brush)
{
    const GrowthParameters& p = tree.parameters().growth;
    GrowthStepOptions options = optionsFor(p, brush.radius);
    options.competitors = m_competitors;
    if (p.tropismFromStroke && m_strokeDirection.norm() > 0.1F) {
        const double cosine = std::clamp(m_strokeDirection.normalized().y(), -1.0F, 1.0F);
        options.setPointAngle = std::acos(cosine);
    }
    const float sight = brush.radius + 0.5F * options.perception.reach;
    const Vec3& target = m_end == StrokeEnd::Arrives ? m_line.front().position : brush.position;
    const std::optional<BudRef> leader = m_end == StrokeEnd::Arrives
                                             ? budToReachOut(tree, index, sight)
                                             : seedlingFor(tree, index, target, sight);
    m_isReachingOut = leader.has_value();
    if (leader)
        return growLeader(tree, index, *leader, target, sight, p.maxShootLength, m_workspace);
    return model.growToward(tree, index, m_markers, options, m_workspace);
}

/// Notes how far along the line the nodes are that have grown since the last call, and whether there are any.
void BrushGrowth::passNewNodes(const Tree& tree, const TreeIndex& index)
{
    const std::uint32_t met = m_metNodes.value_or(tree.size());
    m_metNodes = tree.size();
    if (m_line.empty())
        return;
    m_idle = tree.size() > met ? 0 : m_idle + 1;
    const auto internode = static_cast<float>(tree.parameters().growth.internodeLength);
    for (InternodeId id = met; id < tree.size(); ++id) {
        const Vec3& node = index.nodePosition(id);
        float ahead = 0.0F;
        for (std::size_t i = m_passed; i < m_line.size() && ahead <= kReachedAhead * internode; ++i) {
            if ((node - m_line[i].position).norm() <= std::max(kReached * internode, m_line[i].radius))
                m_passed = i + 1;
            if (i + 1 < m_line.size())
                ahead += (m_line[i + 1].position - m_line[i].position).norm();
        }
    }
}

/// The bud that grows toward a line of which nothing is reached or perceived yet: that of a seedling's tip,
/// or the nearest one.
std::optional<BudRef> BrushGrowth::budToReachOut(const Tree& tree, const TreeIndex& index, float sight) const
{
    if (m_passed > 0 || m_competitors.node != kNoInternode)
        return {};
    const Vec3& target = m_line.front().position;
    const BudRef nearest = nearestBud(tree, index, target);
    if (tree.buds(nearest.node) == 0 || (target - index.nodePosition(nearest.node)).norm() <= sight)
        return {};
    const InternodeId root = index.rootOf(tree, nearest.node);
    if (index.tipCount(root) == 1)
        return BudRef{trunkTip(index, root), kTerminalSlot};
    const double moved = double{(m_line.back().position - target).norm()};
    return moved > tree.parameters().growth.internodeLength ? std::optional(nearest) : std::nullopt;
}

/// A seedling grows a bare trunk toward a brush that is too far away to be perceived. Returns the bud at its
/// tip; nothing if the bud nearest to the brush is in sight, or belongs to a tree that has
/// branches.
std::optional<BudRef> BrushGrowth::seedlingFor(const Tree& tree, const TreeIndex& index, const Vec3& brush,
                                               float sight) const
{
    const auto isSeedling = [&index](InternodeId root) { return index.tipCount(root) == 1; };
    // To find the nearest bud is a pass over the tree.
    if (m_competitors.node != kNoInternode || std::ranges::none_of(index.roots(), isSeedling))
        return {};
    const BudRef nearest = nearestBud(tree, index, brush);
    const InternodeId root = index.rootOf(tree, nearest.node);
    if (!isSeedling(root) || (brush - index.nodePosition(nearest.node)).norm() <= sight)
        return {};
    return BudRef{trunkTip(index, root), kTerminalSlot};
}

/// How many markers a step lays: so many that as many are alive around a resting brush as the parameters say;
/// where the stroke arrives, around a quick one as well.
double BrushGrowth::newMarkerCount(const GrowthParameters& p, std::span<const BrushSample> way) const
{
    const float radius = way.back().radius;
    const double reach = std::max<double>(radius, p.internodeLength) / p.internodeLength;
    const double volume = 4.0 / 3.0 * std::numbers::pi * std::pow(reach, 3);
    // At least three; otherwise it would depend on chance whether a thin brush grows anything.
    double wanted = std::clamp(p.markerDensity * volume / p.markerAge, 3.0, kMostNewMarkers);
    if (m_end == StrokeEnd::Arrives) {
        double moved = 0.0; // In internodes
        for (std::size_t i = 1; i < way.size(); ++i)
            moved += double{(way[i].position - way[i - 1].position).norm()} / p.internodeLength;
        if (drawnness(p, radius) > 0.0) {
            wanted = std::max(wanted, kMarkersAlong * moved);
        } else if (moved > 0.0) {
            // The share of the steps that a place misses because the brush passes it in fewer.
            const double missed = std::max(0.0, 1.0 - 2.0 * reach / (moved * p.markerAge));
            wanted += missed * p.markerDensity * std::numbers::pi * reach * reach * moved;
        }
        wanted = std::min(wanted, kMostNewMarkers);
    }
    return wanted;
}

void BrushGrowth::layMarkers(const Tree& tree, std::span<const BrushSample> way)
{
    std::vector<float> lengths{0.0F};
    for (std::size_t i = 1; i < way.size(); ++i)
        lengths.push_back(lengths.back() + (way[i].position - way[i - 1].position).norm());
    const auto on = [&](float share) {
        if (way.size() == 2)
            return std::pair(std::size_t{1}, share);
        const float at = share * lengths.back();
        const auto next = std::upper_bound(lengths.begin() + 1, lengths.end() - 1, at);
        const auto i = static_cast<std::size_t>(next - lengths.begin());
        const float length = lengths[i] - lengths[i - 1];
        return std::pair(i, length > 0.0F ? (at - lengths[i - 1]) / length : 1.0F);
    };
    const auto count = static_cast<int>(newMarkerCount(tree.parameters().growth, way));
    Random random(tree.seed(), tree.step(), m_time, Purpose::BrushMarker);
    for (int i = 0; i < count; ++i) {
        // Spread over the path since the last sample, so that a fast stroke leaves no gaps.
        const auto [next, t] = on(static_cast<float>(random.uniform()));
        const BrushSample& from = way[next - 1];
        const BrushSample& to = way[next];
        const Vec3 centre = from.position + t * (to.position - from.position);
        const float radius = from.radius + t * (to.radius - from.radius);
        const Vec3 marker = centre + radius * random.inBall();
        if (marker.y() < 0.0F) // there is no free space below the ground
            continue;
        m_markers.positions.push_back(marker);
        m_markers.born.push_back(m_time);
    }
}

TreeDelta BrushGrowth::draw(const Tree& tree, const TreeIndex& index, std::span<const BrushSample> way)
{
    if (!m_drawnBud) {
        m_drawnBud = m_competitors.node != kNoInternode
                         ? BudRef{m_competitors.node, m_competitors.slot}
                         : nearestBud(tree, index, way.front().position, m_mostBegun);
        m_path.push_back(aboveGround(way.front().position));
        m_hasDrawn = false;
    }
    // Another copy of the stroke may have taken the bud meanwhile.
    const bool isTaken = !m_hasDrawn && tree.isAlive(m_drawnBud->node) &&
                         (tree.buds(m_drawnBud->node) & budBit(m_drawnBud->slot)) == 0;
    if (isTaken && m_mostBegun != kNoInternode)
        m_drawnBud = nearestBud(tree, index, m_path.front(), m_mostBegun);
    for (const BrushSample& sample : way.subspan(1))
        m_path.push_back(aboveGround(sample.position));
    return drawPath(tree, index);
}

/// What a thin brush has not reached, as an axis from the nearest bud.
std::optional<TreeDelta> BrushGrowth::drawRest(const Tree& tree, const TreeIndex& index)
{
    const std::size_t first = m_passed > 0 ? m_passed - 1 : 0;
    m_drawnBud =
        m_competitors.node != kNoInternode && m_passed == 0
            ? BudRef{m_competitors.node, m_competitors.slot}
            : nearestBud(tree, index, m_line[first].position, m_passed == 0 ? m_mostBegun : kNoInternode);
    m_hasDrawn = false;
    m_path.clear();
    for (const BrushSample& sample : std::span(m_line).subspan(first))
        m_path.push_back(aboveGround(sample.position));
    return drawPath(tree, index);
}

TreeDelta BrushGrowth::drawPath(const Tree& tree, const TreeIndex& index)
{
    const GrowthParameters& p = tree.parameters().growth;
    GrowingTree growing(tree, index, m_workspace);
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
    if (growing.isNew(m_drawnBud->node))
        noteDrawn(growing, m_drawnBud->node);
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
