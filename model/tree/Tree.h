// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Error.h"
#include "model/tree/TreeDelta.h"
#include "model/tree/TreeTables.h"

#include <span>

namespace espalier {

/// All that a tree is made of.
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

/// The plant graph. An internode is a row of the columns; its upper end is a node, which carries buds; an
/// axis is a chain of internodes that each continue the one before (slot kTerminalSlot). What is shed or
/// pruned gets a death step; only undo takes rows out. Internode 0 is the seedling: it is a root, stands
/// upright and never dies; other roots may stand beside it.
///
/// A Tree is a value: copies share their columns until one of them changes.
class Tree {
public:
    /// A seedling at the world's origin.
    explicit Tree(std::uint64_t seed = 1, const TreeParameters& parameters = {});

    /// A tree read from elsewhere. Fails, naming the row, unless treeFault() finds nothing.
    static Result<Tree> fromContent(TreeContent content);

    const TreeContent& content() const { return m_content; }
    std::uint64_t seed() const { return m_content.seed; }
    Step step() const { return m_content.step; }
    /// Internodes, the dead included.
    std::uint32_t size() const { return m_content.internodes.size(); }
    const InternodeColumns& columns() const { return m_content.internodes; }
    const LeafColumns& placedLeaves() const { return m_content.leaves; }

    InternodeId parent(InternodeId id) const { return columns().parent[id]; }
    float length(InternodeId id) const { return columns().length[id]; }
    float vigour(InternodeId id) const { return columns().vigour[id]; }
    /// Its active buds.
    BudMask buds(InternodeId id) const { return columns().buds[id].active(); }
    BudStates budStates(InternodeId id) const { return columns().buds[id]; }
    Step birth(InternodeId id) const { return columns().birth[id]; }
    InternodeKey key(InternodeId id) const { return columns().key[id]; }
    /// False, too, for ids beyond the rows.
    bool isAlive(InternodeId id) const { return id < size() && columns().death[id] == kNever; }
    bool continuesAxis(InternodeId id) const { return columns().slot[id] == kTerminalSlot; }
    /// Where a root stands, m.
    Vec3 rootPosition(InternodeId id) const
    {
        const Vec3* const position = m_content.sparse.rootPosition.find(id);
        return position ? *position : Vec3(Vec3::Zero());
    }

    /// The widths that a person has set, by ascending id; those of dead internodes count for nothing.
    std::span<const WidthConstraint> widthConstraints() const { return m_content.sparse.width.cells(); }
    /// m; 0 if none is set there.
    float widthConstraint(InternodeId id) const { return m_content.sparse.width.at(id).value_or(0.0F); }

    const QList<TreeParameters>& parameterSets() const { return m_content.kept.parameters; }
    std::uint32_t currentParameterSet() const { return m_content.currentParameters; }
    /// The parameters in force now.
    const TreeParameters& parameters() const { return parameterSets()[m_content.currentParameters]; }
    /// The parameters that an internode was grown with.
    const TreeParameters& parametersOf(InternodeId id) const
    {
        return parameterSets()[columns().parameterSet[id]];
    }
    /// Whether a delta may put @p parameters in force: they are known, or there are few enough different
    /// sets.
    bool hasRoomFor(const TreeParameters& parameters) const;

    /// The lasso strokes that were ever in force.
    const QList<LassoStroke>& lassos() const { return m_content.kept.lassos; }
    /// Indices of those in force now, ascending: the tree's envelopes.
    const std::vector<std::uint32_t>& lassoIndicesInForce() const { return m_content.lassosInForce; }
    /// Copies of the strokes in force.
    std::vector<LassoStroke> lassosInForce() const;

    /// Appends the delta's rows and makes its changes. Precondition: the delta starts at this tree and has
    /// its rows.
    void apply(const TreeDelta& delta);
    /// The inverse; moves the rows that go into the delta, if it has none.
    void revert(TreeDelta& delta);
    /// Likewise, and drops the rows that go.
    void revertDropping(const TreeDelta& delta);

    bool operator==(const Tree&) const = default;

    /// Memory of the columns, in bytes.
    std::size_t bytes() const;

private:
    void revertChanges(const TreeDelta& delta);
    void truncate(const TreeDelta& delta);
    void setLasso(std::uint32_t index, bool inForce);

    TreeContent m_content;
};

/// A delta that changes nothing, to be filled in, at the moment that @p tree is in.
TreeDelta deltaStartingAt(const Tree& tree);
/// The index of a parameter set in @p tree, where @p delta starts; the delta brings the set along if the tree
/// does not know it. Precondition: the tree has room for it (Tree::hasRoomFor).
std::uint32_t keepParameters(TreeDelta& delta, const Tree& tree, const TreeParameters& parameters);
/// The index that a stroke will have; @p delta brings it along. Precondition: isLasso(stroke).
std::uint32_t keepLasso(TreeDelta& delta, const Tree& tree, const LassoStroke& stroke);

/// What is wrong with @p content, in a sentence without a full stop; empty if it may be a tree: equal sizes,
/// parents before children, at most one living continuation a node, living parents of living internodes,
/// values within their limits, known parameter sets, different keys. Serves the reader and the writer of
/// files.
QString treeFault(const TreeContent& content);

/// Whether an internode may have such a local frame and length.
bool isFrame(const Rotation& rotation, float length);

} // namespace espalier
