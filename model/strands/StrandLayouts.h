// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/WorkProgress.h"
#include "model/strands/BundlePlaces.h"
#include "model/strands/HexLattice.h"
#include "model/strands/StrandReliefs.h"
#include "model/strands/StrandSkeleton.h"
#include "model/tree/Tree.h"

#include <memory>
#include <span>
#include <vector>

namespace espalier {

/// The arrangement of the strands in the cross-section of each node of a tree (Strands 2024 §5.2).
/// Coordinates are in strand radii, along X and Z of the node's frame, with the node's place at the origin.
///
/// By StrandPacking::Rest each strand has a slot of a lattice, so no two overlap. A fork hands down the slots
/// of its thickest child. The strands of the others take the slots nearest to the side that they come from
/// (equations 1 and 2 give that side), and push the strands there away, each by a slot, toward the free slots
/// at the rim. So neighbours stay neighbours, and strands at the rim stay there. WoodParameters::steps says
/// how far a node comes toward that arrangement from the one above it. Profiles draw the strands of their
/// nodes, and fade along the branch (NodeProfiles).
///
/// A node with one child and no profile has the layout of the child, once packing is at rest.
/// Twists turn the frames of the nodes, not what lies in them.
class StrandLayouts {
public:
    /// Arrangements that have not changed since @p last, of this tree or another one, are taken from there.
    /// The result is the same with and without it. If @p progress is cancelled meanwhile, it is of no use.
    /// @p progress gets the share of the strands that have their places.
    StrandLayouts(const Tree& tree, const TreeIndex& index, const Widths& widths,
                  const StrandLayouts* last = nullptr, WorkProgress* progress = nullptr);

    const StrandSkeleton& skeleton() const { return m_skeleton; }
    std::uint32_t strandCount(std::uint32_t node) const { return m_skeleton.nodes[node].strands; }

    /// Place of one of the strands at a node.
    Vec2 place(std::uint32_t node, std::uint32_t strand) const
    {
        return m_places[m_sections[node].first + strand];
    }
    /// Places of all its strands, in strand radii.
    std::span<const Vec2> places(std::uint32_t node) const
    {
        return std::span(m_places).subspan(m_sections[node].first, strandCount(node));
    }
    /// The node whose layout this one shares; itself if it has its own.
    std::uint32_t owner(std::uint32_t node) const { return m_sections[node].owner; }
    /// Whether the strands are the first slots of a lattice around the origin, without a profile.
    bool isDisc(std::uint32_t node) const { return m_sections[m_sections[node].owner].isDisc; }
    /// Slots of the lattice, by strand. Precondition: isDisc(node).
    std::span<const std::uint32_t> slots(std::uint32_t node) const
    {
        return std::span(m_slots).subspan(m_sections[node].firstSlot, strandCount(node));
    }
    const HexLattice& lattice() const { return *m_lattice; }

    /// Length of a strand radius at a node, m.
    float scale(std::uint32_t node) const { return m_bundles.scales[node]; }
    /// World position of the middle of the section, m. Where a branch leaves a thick one, it lies on that
    /// one's surface, and approaches the branch's own line further up.
    const Vec3& centre(std::uint32_t node) const { return m_bundles.centres[node]; }
    /// How far the wood's line is rounded to either side of a node, m: about as far as the wood is thick, and
    /// near a fork as far as that is. 0 where the next nodes are farther.
    float reach(std::uint32_t node) const { return m_bundles.reaches[node]; }
    /// World position of a point of the section, moved as the ridges of the wood say.
    Vec3 world(std::uint32_t node, const Vec2& place) const
    {
        const StrandNode& n = m_skeleton.nodes[node];
        const float scale = m_bundles.scales[node];
        const Vec2 moved = m_reliefs.moved(node, place, n.radius / scale);
        return m_bundles.centres[node] + n.frame * (scale * Vec3(moved.x(), 0.0F, moved.y()));
    }
    const StrandReliefs& reliefs() const { return m_reliefs; }
    /// Coordinates of the node's profile times this are coordinates of its layout; 0 without a profile.
    float profileScale(std::uint32_t node) const { return m_sections[node].profileScale; }

    struct Counts {
        std::uint64_t strands = 0;
        std::uint64_t particles = 0; ///< Strands times the nodes that they pass, bases excluded
        std::uint64_t contacts = 0;  ///< Pairs of strands that overlap, of each layout
        double deepest = 0.0;        ///< Overlap of the deepest contact, as a share of a diameter
    };
    /// Also looks for contacts, which takes time.
    Counts count() const;
    std::size_t bytes() const;

private:
    struct Section {
        std::size_t first = 0;     ///< Into m_places
        std::size_t firstSlot = 0; ///< Into m_slots
        std::uint32_t owner = 0;
        bool isDisc = true;
        bool ownsSlots = false;
        float profileScale = 0.0F;
        float roundness = 1.0F; ///< NodeProfiles::roundness()
    };
    class Builder;

    StrandSkeleton m_skeleton;
    std::shared_ptr<const HexLattice> m_lattice;
    std::vector<Section> m_sections;
    std::vector<Vec2> m_places;
    std::vector<std::uint32_t> m_slots;
    /// Hashes of all that a node's slots are made from, and its places; 0 for nodes that share a layout.
    struct Keys {
        std::uint64_t slots = 0;
        std::uint64_t places = 0;
    };
    std::vector<Keys> m_keys;
    BundlePlaces m_bundles;
    StrandReliefs m_reliefs;
};

} // namespace espalier
