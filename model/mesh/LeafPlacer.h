// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/LeafInstance.h"
#include "model/mesh/Mesh.h"
#include "model/tree/TreeIndex.h"

#include <span>
#include <type_traits>
#include <vector>

namespace espalier {

/// The hue that leaves of weak shoots shift toward.
inline constexpr double kLeafWeakHue = radians(10);
/// A shoot of at least this vigour has leaves of full colour. Vigour is relative to the strongest bud of its
/// step.
inline constexpr double kFullVigour = 0.5;

/// How weak a shoot is: u = clamp(1 − v / v_ref, 0, 1). A @p reference of 0 counts every shoot as strong.
double shootWeakness(double vigour, double reference = kFullVigour);

/// A hue shifted by the share @p amount (0...1) of the way toward red: through green and yellow, or from
/// purple through magenta, never through blue. All in rad; the result may be above 2π.
double shiftedLeafHue(double hue, double amount);

/// Leaves on young shoots, by the LeafParameters in force: at each node of an internode that carries few
/// tips. LeafArrangement::Shoot uses the frames that the shoots grew with: the leaves stand evenly around,
/// the first above the first lateral bud. The other arrangements count along the axis from its first
/// internode. They start from the plane of the twig: for a leaning axis the plane that is level across it,
/// for an upright one a plane that the axis determines. Random spread is a function of the tree's seed and
/// the internode alone; its amount is GrowthParameters::irregularity: at 0 the arrangement is exact.
///
/// No leaf reaches below the ground, y = 0: it turns upward as far as necessary. A leaf that stands below the
/// ground is hidden.
class LeafPlacer {
public:
    explicit LeafPlacer(const Tree& tree, const TreeIndex& index);

    /// Whether a living internode has leaves.
    bool bears(InternodeId id) const
    {
        const std::uint32_t tips = m_index.tipCount(id);
        return m_perNode > 0 && tips > 0 && tips <= m_maxTips && m_index.subtreeSize(id) <= m_reach;
    }
    /// Number of leaves on each internode that bears leaves.
    std::uint32_t leavesPerInternode() const { return m_perNode; }

    /// Writes the leaves of one internode that bears into a span of leavesPerInternode().
    void place(InternodeId id, std::span<LeafInstance> leaves) const { place(id, nodesBelow(id), leaves); }

    /// Counts the leaves of living internodes, such as those of a piece of wood, and writes them into a span
    /// of that size. Fastest if each internode follows its parent.
    std::uint32_t count(std::span<const InternodeId> internodes) const;
    void place(std::span<const InternodeId> internodes, std::span<LeafInstance> leaves) const;

private:
    /// Where a leaf stands on its internode.
    struct Stand {
        Vec3 outward; ///< Unit vector across the shoot
        Vec3 face;    ///< Direction of the blade's upper face before it is turned
        float along;  ///< From the internode's node (0) down to the one below (1)
    };

    void place(InternodeId id, std::uint32_t below, std::span<LeafInstance> leaves) const;
    void keepAboveGround(LeafInstance& leaf, const Eigen::Matrix3f& frame) const;
    std::uint32_t nodesBelow(InternodeId id) const;
    Vec3 side(InternodeId id, const Vec3& axis) const;
    Stand stand(std::uint32_t i, std::uint32_t below, const Eigen::Matrix3f& frame, const Vec3& side) const;

    const Tree& m_tree;
    const TreeIndex& m_index;
    LeafParameters m_parameters;
    std::uint32_t m_perNode;
    std::uint32_t m_maxTips;
    std::uint32_t m_reach;
    float m_jitter;
    float m_cosine; ///< Cosine of the angle between shoot and petiole
    float m_sine;
    bool m_alongInternode;
    std::array<Vec2, 8> m_azimuths;
};

/// All leaves of a tree, tube by tube (see Tubes.h); in parallel, with the same result on one thread
/// or many.
MeshBuffer<LeafInstance> placeLeaves(const Tree& tree, const TreeIndex& index);

} // namespace espalier
