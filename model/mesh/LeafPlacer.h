// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/LeafInstance.h"
#include "model/mesh/Mesh.h"
#include "model/mesh/WoodLines.h"
#include "model/tree/PlacedLeafIndex.h"

#include <memory>
#include <span>
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

/// Which internodes have leaves, by the LeafParameters in force: those that carry few tips, lie near the end
/// of their branch, and have not been made thick by the user, in proportion to a leaf.
class LeafRule {
public:
    LeafRule(const Tree& tree, const TreeIndex& index);

    /// Whether a living internode has leaves.
    bool bears(InternodeId id) const
    {
        const std::uint32_t tips = m_index.tipCount(id);
        return m_perNode > 0 && tips > 0 && tips <= m_maxTips && m_index.subtreeSize(id) <= m_reach &&
               m_tree.widthConstraint(id) <= m_thickest;
    }
    /// Number of leaves on each internode that bears leaves, 0...kMost.
    std::uint32_t leavesPerInternode() const { return m_perNode; }
    /// Counts the leaves of living internodes, such as those of a piece of wood.
    std::uint32_t count(std::span<const InternodeId> internodes) const;

    static constexpr std::uint32_t kMost = 8;

private:
    const Tree& m_tree;
    const TreeIndex& m_index;
    std::uint32_t m_perNode;
    std::uint32_t m_maxTips;
    std::uint32_t m_reach;
    float m_thickest; ///< Of the diameters that the user has set, m
};

/// Places leaves at the nodes of young shoots (LeafRule), on the bark of the wood that is shown, and shows
/// there the leaves that the user has placed (Tree::placedLeaves()).
///
/// Frames are transported in parallel along each axis from its first internode (Strands 2024 §6), so leaves
/// turn from node to node by their arrangement alone. LeafArrangement::Shoot uses the frames that the shoots
/// grew with, which turn by the phyllotaxis of the buds as well: the leaves stand evenly around, the first
/// above the first lateral bud. The other arrangements count along the axis from its first internode, in the
/// plane of the twig: for a leaning axis the plane that is level across it, for an upright one a plane that
/// the axis determines. LeafArrangement::Flat turns back toward the level plane, a little at each node.
/// Random spread is a function of the tree's seed and the internode alone; its amount is
/// GrowthParameters::irregularity: at 0 the arrangement is exact.
///
/// No leaf by rule reaches below the ground, y = 0: it turns upward as far as necessary. A leaf that stands
/// below the ground is hidden.
///
/// A leaf that the user has placed has the frame and the length of its row, and looks like the leaves by
/// rule: their shape, image and colours, which vary by the same amounts, as a function of the internode and
/// of the leaf's number there. Flowers and fruit look like leaves. Its base is on the bark, on the side that
/// the midrib points to; a leaf along the wood begins in the middle of the wood.
class LeafPlacer {
public:
    /// @p tree, @p index and @p widths must outlive this, and so must @p strands: the wood if it is shown as
    /// strands. @p placed: the placed leaves of the tree if the caller knows them already.
    LeafPlacer(const Tree& tree, const TreeIndex& index, const Widths& widths,
               std::span<const WoodLine> strands = {}, const PlacedLeafIndex* placed = nullptr);

    const LeafRule& rule() const { return m_rule; }

    /// Counts the leaves of living internodes: those by rule and those that the user has placed.
    std::uint32_t count(std::span<const InternodeId> internodes) const;
    /// Writes the leaves by rule of one internode that bears into a span of LeafRule::leavesPerInternode().
    void place(InternodeId id, std::span<LeafInstance> leaves) const;
    /// Writes the leaves of living internodes into a span of count(): for each, the leaves by rule and then
    /// those that the user has placed. Fastest if each internode follows its parent.
    void place(std::span<const InternodeId> internodes, std::span<LeafInstance> leaves) const;

private:
    /// What is carried along an axis from node to node.
    struct Carried {
        std::uint32_t below = 0;   ///< Nodes of the axis below
        Vec3 axis = Vec3::UnitY(); ///< Unit vector along the wood
        Vec3 own = Vec3::UnitX();  ///< Across it: what the axis determines, transported
        Vec3 side = Vec3::UnitX(); ///< Unit vector across it, in the plane of the twig
    };
    /// Where a leaf stands on its internode.
    struct Stand {
        Vec3 outward; ///< Unit vector across the shoot
        Vec3 face;    ///< Direction of the blade's upper face before it is turned
        float along;  ///< From the internode's node (0) down to the one below (1)
    };

    /// The colours of an internode's leaves before they vary.
    struct Look {
        double hueShift; ///< rad
        float value;
    };

    void place(InternodeId id, const Carried& carried, std::span<LeafInstance> leaves) const;
    std::uint32_t placedCount(InternodeId id) const;
    std::uint32_t showPlaced(InternodeId id, std::span<LeafInstance> leaves) const;
    Look lookOf(InternodeId id) const;
    std::int32_t shape() const;
    void keepAboveGround(LeafInstance& leaf, const Eigen::Matrix3f& frame) const;
    Carried firstOf(InternodeId first) const;
    void carryTo(InternodeId next, Carried& carried) const;
    Carried carriedTo(InternodeId id) const;
    Stand stand(std::uint32_t i, const Carried& carried, const Eigen::Matrix3f& frame) const;

    const Tree& m_tree;
    const TreeIndex& m_index;
    WoodLines m_wood;
    LeafRule m_rule;
    std::unique_ptr<const PlacedLeafIndex> m_ownPlaced; ///< Where the caller does not know them
    const PlacedLeafIndex* m_placed;
    LeafParameters m_parameters;
    std::uint32_t m_perNode;
    float m_jitter;
    float m_cosine; ///< Cosine of the angle between shoot and petiole
    float m_sine;
    bool m_alongInternode;
    std::array<Vec2, LeafRule::kMost> m_azimuths;
};

/// All leaves of a tree, tube by tube (see Tubes.h); in parallel, with the same result on one thread
/// or many. @p strands: the wood if it is shown as strands.
MeshBuffer<LeafInstance> placeLeaves(const Tree& tree, const TreeIndex& index, const Widths& widths,
                                     std::span<const WoodLine> strands = {});

} // namespace espalier
