// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/shape/SeenWood.h"

#include <algorithm>
#include <iterator>

namespace espalier {

namespace {

/// What is nearer to the eye than this is not seen, m.
constexpr float kNearestSeen = 1e-3F;

float crossOf(const Vec2& a, const Vec2& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

/// Squared distance of @p point from the segment @p a to @p b.
float squaredGap(const Vec2& point, const Vec2& a, const Vec2& b)
{
    const Vec2 way = b - a;
    const float squared = way.squaredNorm();
    const float along = squared > 0.0F ? std::clamp((point - a).dot(way) / squared, 0.0F, 1.0F) : 0.0F;
    return (point - a - along * way).squaredNorm();
}

bool segmentsCross(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d)
{
    const float ca = crossOf(d - c, a - c);
    const float cb = crossOf(d - c, b - c);
    const float ac = crossOf(b - a, c - a);
    const float ad = crossOf(b - a, d - a);
    return ((ca > 0.0F) != (cb > 0.0F)) && ((ac > 0.0F) != (ad > 0.0F));
}

template <class Id>
void addSorted(std::vector<Id>& to, const std::vector<Id>& from)
{
    std::vector<Id> all;
    std::ranges::set_union(to, from, std::back_inserter(all));
    to = std::move(all);
}

} // namespace

void Swept::add(const Swept& other)
{
    addSorted(internodes, other.internodes);
    addSorted(leaves, other.leaves);
}

NearSide::NearSide(const Tree& tree, const TreeIndex& index, const Vec3& eye)
    : m_roots(tree.size()), m_feet(tree.size(), Vec3(Vec3::Zero())), m_away(tree.size(), Vec3(Vec3::Zero()))
{
    for (InternodeId id = 0; id < tree.size(); ++id) {
        m_roots[id] = tree.isRoot(id) ? id : m_roots[tree.parent(id)];
        if (!tree.isRoot(id))
            continue;
        m_feet[id] = index.basePosition(tree, id);
        Vec3 away = m_feet[id] - eye;
        away.y() = 0.0F;
        if (away.norm() > kNearestSeen)
            m_away[id] = away.normalized();
    }
}

bool NearSide::has(InternodeId id, const Vec3& point) const
{
    const InternodeId root = m_roots[id];
    return (point - m_feet[root]).dot(m_away[root]) <= 0.0F;
}

SeenWood::SeenWood(const Tree& tree, const TreeIndex& index, const Vec3& eye, const Vec3& toward,
                   SweepDepth depth)
    : m_eye(eye)
{
    const Vec3 way = toward - eye;
    m_forward = way.norm() > kNearestSeen ? Vec3(way.normalized()) : Vec3(-Vec3::UnitZ());
    m_right = anyPerpendicular(m_forward);
    m_up = m_right.cross(m_forward);
    std::optional<NearSide> near;
    if (depth == SweepDepth::NearSide)
        near.emplace(tree, index, eye);
    m_wood.reserve(index.livingCount());
    for (InternodeId id = 0; id < tree.size(); ++id) {
        if (!tree.isAlive(id) || tree.isRoot(id))
            continue;
        const Vec3 base = index.basePosition(tree, id);
        const Vec3& node = index.nodePosition(id);
        Segment segment{{}, {}, id};
        if ((!near || near->has(id, 0.5F * (base + node))) && see(base, segment.from) &&
            see(node, segment.to))
            m_wood.push_back(segment);
    }
    const LeafColumns& leaves = tree.placedLeaves();
    for (LeafId leaf = 0; leaf < leaves.size(); ++leaf) {
        const InternodeId on = leaves.internode[leaf];
        if (leaves.death[leaf] != kNever || !tree.isAlive(on))
            continue;
        const Vec3 place =
            index.nodePosition(on) - (1.0F - leaves.along[leaf]) * tree.length(on) * index.heading(on);
        Segment segment{{}, {}, leaf};
        if ((!near || near->has(on, place)) && see(place, segment.from)) {
            segment.to = segment.from;
            m_leaves.push_back(segment);
        }
    }
}

/// Whether @p point is before the eye; if so, sets its @p place.
bool SeenWood::see(const Vec3& point, Vec2& place) const
{
    const Vec3 offset = point - m_eye;
    const float depth = offset.dot(m_forward);
    if (depth < kNearestSeen)
        return false;
    place = Vec2(offset.dot(m_right), offset.dot(m_up)) / depth;
    return true;
}

Swept SeenWood::under(const SweepPoint& from, const SweepPoint& to) const
{
    Swept swept;
    Vec2 a;
    Vec2 b;
    if (!see(from.position, a) || !see(to.position, b))
        return swept;
    const auto seenRadius = [&](const SweepPoint& point) {
        return point.radius / (point.position - m_eye).dot(m_forward);
    };
    const float radius = std::max(seenRadius(from), seenRadius(to));
    swept.internodes = touched(m_wood, a, b, radius);
    swept.leaves = touched(m_leaves, a, b, radius);
    return swept;
}

std::vector<std::uint32_t> SeenWood::touched(const std::vector<Segment>& segments, const Vec2& from,
                                             const Vec2& to, float radius)
{
    std::vector<std::uint32_t> rows;
    const float squared = radius * radius;
    const Vec2 lower = from.cwiseMin(to) - Vec2::Constant(radius);
    const Vec2 upper = from.cwiseMax(to) + Vec2::Constant(radius);
    for (const Segment& segment : segments) {
        if ((segment.from.cwiseMax(segment.to).array() < lower.array()).any() ||
            (segment.from.cwiseMin(segment.to).array() > upper.array()).any())
            continue;
        if (squaredGap(segment.from, from, to) <= squared || squaredGap(segment.to, from, to) <= squared ||
            squaredGap(from, segment.from, segment.to) <= squared ||
            squaredGap(to, segment.from, segment.to) <= squared ||
            segmentsCross(segment.from, segment.to, from, to))
            rows.push_back(segment.row);
    }
    return rows;
}

Swept sweptBy(const Tree& tree, const TreeIndex& index, std::span<const Sweep> sweeps, SweepDepth depth)
{
    Swept swept;
    for (const Sweep& sweep : sweeps) {
        const SeenWood seen(tree, index, sweep.eye, sweep.path.front().position, depth);
        swept.add(seen.under(sweep.path.front(), sweep.path.front()));
        for (std::size_t i = 1; i < sweep.path.size(); ++i)
            swept.add(seen.under(sweep.path[i - 1], sweep.path[i]));
    }
    return swept;
}

} // namespace espalier
