// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/tree/TreeIndex.h"

#include <span>
#include <vector>

namespace espalier {

/// A round brush that is held before the tree, facing the eye.
struct SweepPoint {
    Vec3 position = Vec3::Zero(); ///< m
    float radius = 0.1F;          ///< m
    bool operator==(const SweepPoint&) const = default;
};

/// The way of such a brush, seen from one place.
struct Sweep {
    Vec3 eye = Vec3::UnitZ();     ///< m
    std::vector<SweepPoint> path; ///< One or more
    bool operator==(const Sweep&) const = default;
};

/// How far behind a brush its reach goes.
enum class SweepDepth {
    All,      ///< Through the whole tree
    NearSide, ///< Up to the upright plane through the foot of the trunk, across the line of sight
};

/// What a brush has swept.
struct Swept {
    std::vector<InternodeId> internodes; ///< Living ones, without roots; ascending
    std::vector<LeafId> leaves;          ///< Placed leaves that exist; ascending

    void add(const Swept& other);
};

/// Which side of a trunk is the one toward the eye.
class NearSide {
public:
    /// Everything is near if the eye looks straight down.
    NearSide(const Tree& tree, const TreeIndex& index, const Vec3& eye);

    /// Whether @p point, m, which belongs to the living internode @p id, is on the near side of its trunk.
    bool has(InternodeId id, const Vec3& point) const;

private:
    std::vector<InternodeId> m_roots; ///< By internode
    std::vector<Vec3> m_feet;         ///< By root's place in m_trunks
    std::vector<Vec3> m_away;         ///< Level direction from the eye, or zero
};

/// The wood of a tree as it appears from one place, to find what a brush sweeps. The cost of a search is a
/// pass over the tree. The result depends on the tree, the eye and the brush alone, so a search of a path's
/// parts gives the same as a replay of the whole path.
class SeenWood {
public:
    /// @p toward: a point that the eye looks at, m; usually the beginning of the path.
    SeenWood(const Tree& tree, const TreeIndex& index, const Vec3& eye, const Vec3& toward, SweepDepth depth);

    /// What a brush sweeps on its straight way from @p from to @p to: all internodes, and the bases of placed
    /// leaves, that appear under it.
    Swept under(const SweepPoint& from, const SweepPoint& to) const;

private:
    struct Segment {
        Vec2 from; ///< m at a distance of 1 m from the eye
        Vec2 to;
        std::uint32_t row;
    };

    bool see(const Vec3& point, Vec2& place) const;
    static std::vector<std::uint32_t> touched(const std::vector<Segment>& segments, const Vec2& from,
                                              const Vec2& to, float radius);

    Vec3 m_eye;
    Vec3 m_forward;
    Vec3 m_right;
    Vec3 m_up;
    std::vector<Segment> m_wood;
    std::vector<Segment> m_leaves;
};

/// What all of @p sweeps have swept together.
Swept sweptBy(const Tree& tree, const TreeIndex& index, std::span<const Sweep> sweeps, SweepDepth depth);

} // namespace espalier
