// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Error.h"
#include "model/tree/TreeDelta.h"
#include "model/tree/TreeTables.h"

#include <span>

namespace espalier {

/// All data of a tree.
struct TreeContent {
    std::uint64_t seed = 1;
    Step step = 0;
    InternodeColumns internodes;
    LeafColumns leaves;
    SparseColumns sparse;
    KeptValues kept;
    std::uint32_t currentParameters = 0;      ///< Index of the parameter set in force
    std::vector<std::uint32_t> lassosInForce; ///< Indices of strokes, ascending

    bool operator==(const TreeContent& other) const;
};

/// The plant graph. An internode is a row of the columns; its upper end is a node, which has buds. An axis is
/// a chain of internodes of which each continues the one before (slot kTerminalSlot). Internodes that are
/// shed or pruned get a death step; only undo removes rows. Internode 0 is the seedling: it is a root, stands
/// upright and never dies; other roots may stand beside it. Each root begins a trunk.
///
/// A Tree is a value: copies share their columns until one of them changes.
class Tree {
public:
    /// A seedling at the world's origin.
    explicit Tree(std::uint64_t seed = 1, const TreeParameters& parameters = {});

    /// A tree with data from a file. Fails with the text of treeFault() if that finds a fault (Kind::Input).
    static Result<Tree> fromContent(TreeContent content);

    const TreeContent& content() const { return m_content; }
    std::uint64_t seed() const { return m_content.seed; }
    Step step() const { return m_content.step; }
    /// Internodes, the dead included.
    std::uint32_t size() const { return m_content.internodes.size(); }
    const InternodeColumns& columns() const { return m_content.internodes; }
    const LeafColumns& placedLeaves() const { return m_content.leaves; }

    // Values of columns; see TreeTables.h for their units and ranges.
    InternodeId parent(InternodeId id) const { return columns().parent[id]; }
    bool isRoot(InternodeId id) const { return parent(id) == kNoInternode; }
    float length(InternodeId id) const { return columns().length[id]; }
    float vigour(InternodeId id) const { return columns().vigour[id]; }
    /// The active buds at its node.
    BudMask buds(InternodeId id) const { return columns().buds[id].active(); }
    BudStates budStates(InternodeId id) const { return columns().buds[id]; }
    Step birth(InternodeId id) const { return columns().birth[id]; }
    InternodeKey key(InternodeId id) const { return columns().key[id]; }
    /// Also false for ids beyond the last row.
    bool isAlive(InternodeId id) const { return id < size() && columns().death[id] == kNever; }
    bool continuesAxis(InternodeId id) const { return columns().slot[id] == kTerminalSlot; }
    /// World position of a root's lower end, m.
    Vec3 rootPosition(InternodeId id) const
    {
        const Vec3* const position = m_content.sparse.rootPosition.find(id);
        return position ? *position : Vec3(Vec3::Zero());
    }

    /// The diameters that the user has set, by ascending id; those of dead internodes have no effect.
    std::span<const WidthConstraint> widthConstraints() const { return m_content.sparse.width.cells(); }
    /// The diameter that the user has set at @p id, m; 0 if there is none.
    float widthConstraint(InternodeId id) const { return m_content.sparse.width.at(id).value_or(0.0F); }

    /// How far from its base on the axis that begins with @p axis bears no shoots, m; 0 if it may anywhere.
    float clearLength(InternodeId axis) const { return m_content.sparse.clearLength.at(axis).value_or(0.0F); }

    /// How far from its base on the axis that begins with @p axis was drawn, m; 0 if it grew.
    float drawnLength(InternodeId axis) const { return m_content.sparse.drawnLength.at(axis).value_or(0.0F); }

    const QList<TreeParameters>& parameterSets() const { return m_content.kept.parameters; }
    std::uint32_t currentParameterSet() const { return m_content.currentParameters; }
    /// The parameters in force.
    const TreeParameters& parameters() const { return parameterSets()[m_content.currentParameters]; }
    /// The parameters that the internode grew with.
    const TreeParameters& parametersOf(InternodeId id) const
    {
        return parameterSets()[columns().parameterSet[id]];
    }
    /// Whether a delta may put @p parameters in force: the tree has this set already, or has fewer than
    /// kMostParameterSets, and all images together stay within @p mostImageBytes. Otherwise no file could
    /// hold the tree.
    bool hasRoomFor(const TreeParameters& parameters, qsizetype mostImageBytes = kMostImageBytes) const;
    /// Whether a delta may bring so many more lassos.
    bool hasRoomForLassos(std::size_t count) const;
    /// Whether @p delta may bring the profiles that it has.
    bool hasRoomForProfiles(const TreeDelta& delta) const;

    /// All lasso strokes that were ever in force.
    const QList<LassoStroke>& lassos() const { return m_content.kept.lassos; }
    /// Indices of the strokes in force, ascending: the tree's envelopes.
    const std::vector<std::uint32_t>& lassoIndicesInForce() const { return m_content.lassosInForce; }
    /// Copies of the strokes in force.
    std::vector<LassoStroke> lassosInForce() const;

    /// All profiles that a node ever had.
    const QList<StrandProfile>& profiles() const { return m_content.kept.profiles; }
    /// The profile that the user has given the node of @p id, or null.
    const StrandProfile* profileOf(InternodeId id) const
    {
        const std::uint32_t* const profile = m_content.sparse.profile.find(id);
        return profile ? &profiles()[*profile] : nullptr;
    }

    /// Appends the delta's rows and makes its changes. Precondition: the delta starts at the state of this
    /// tree and has its rows.
    void apply(const TreeDelta& delta);
    /// Undoes apply(); moves the removed rows into the delta if it has none. Precondition: @p delta is the
    /// last one that was applied.
    void revert(TreeDelta& delta);
    /// The same, but drops the removed rows. It neither reads nor writes the delta's rows, so the delta may
    /// belong to a document of another thread.
    void revertDropping(const TreeDelta& delta);

    bool operator==(const Tree&) const = default;

    /// Memory of the columns, the sparse columns and the kept values, in bytes.
    std::size_t bytes() const;

private:
    void revertChanges(const TreeDelta& delta);
    void setDeaths(const TreeDelta& delta, Step death);
    void truncate(const TreeDelta& delta);
    void setLasso(std::uint32_t index, bool inForce);

    TreeContent m_content;
};

/// An empty delta that starts at the present state of @p tree; the caller adds changes.
TreeDelta deltaStartingAt(const Tree& tree);
/// The index of a parameter set in @p tree, where @p delta starts. If the tree does not have the set, or has
/// not had it among the last ones, the set is added to the delta. Precondition: the tree has room for it
/// (Tree::hasRoomFor).
std::uint32_t keepParameters(TreeDelta& delta, const Tree& tree, const TreeParameters& parameters);
/// Adds @p stroke to @p delta and returns the index that it will have. Precondition: isLasso(stroke).
std::uint32_t keepLasso(TreeDelta& delta, const Tree& tree, const LassoStroke& stroke);
/// The index of a profile in @p tree, where @p delta starts; adds the profile to the delta if it is not among
/// the last ones. Precondition: profileFault(profile) is empty.
std::uint32_t keepProfile(TreeDelta& delta, const Tree& tree, const StrandProfile& profile);

/// Describes the first fault of @p content in a sentence without a full stop; empty if there is none. Checks
/// that columns have equal sizes, parents come before children, a node has at most one living continuation,
/// living internodes have living parents, values are within their limits, parameter sets exist, and keys
/// differ. Both the reader and the writer of files use it.
QString treeFault(const TreeContent& content);

/// Whether an internode may have this local frame (a unit quaternion) and length (0 < length <=
/// kGreatestLength, m).
bool isFrame(const Rotation& rotation, float length);

} // namespace espalier
