// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Error.h"
#include "model/tree/InternodeColumns.h"
#include "model/tree/LassoStroke.h"
#include "model/tree/Parameters.h"
#include "model/tree/TreeDelta.h"
#include "model/tree/WidthConstraint.h"

#include <span>

namespace espalier {

/// Limits of what a tree may hold, m.
inline constexpr float kGreatestLength = 1000.0F;  ///< Of an internode
inline constexpr float kGreatestDiameter = 100.0F; ///< Of a width constraint

/// Whether an internode may have such a local frame and length.
bool isFrame(const Rotation& rotation, float length);

/// The lasso strokes of a tree: its envelopes.
struct Lassos {
    QList<LassoStroke> strokes;         ///< That were ever in force
    std::vector<std::uint32_t> inForce; ///< Their indices, ascending

    bool operator==(const Lassos&) const = default;
};

/// The plant graph. An internode is a row of the columns; its upper end is a node, which carries buds; an
/// axis is a chain of internodes that each continue the one before (slot kTerminalSlot). Nothing is erased:
/// what is shed or pruned gets a death step, and what is undone is marked absent. Internode 0 is the
/// seedling: it stands at the origin, upright, and never dies.
///
/// A Tree is a value: copies share their columns until one of them changes.
class Tree {
public:
    /// A seedling.
    explicit Tree(std::uint64_t seed = 1, const TreeParameters& parameters = {});

    /// A tree read from elsewhere. Fails unless the columns agree with each other: equal sizes, parents
    /// before children, at most one living continuation a node, living parents of living internodes, finite
    /// numbers, known parameter sets, positive widths by ascending id, lassos that are some.
    static Result<Tree> fromColumns(std::uint64_t seed, Step step, InternodeColumns columns,
                                    QList<TreeParameters> parameterSets, std::uint32_t currentParameters,
                                    std::vector<WidthConstraint> widths = {}, Lassos lassos = {});

    std::uint64_t seed() const { return m_seed; }
    Step step() const { return m_step; }
    /// Rows, the dead and the undone included.
    std::uint32_t size() const { return m_columns.size(); }
    const InternodeColumns& columns() const { return m_columns; }

    InternodeId parent(InternodeId id) const { return m_columns.parent[id]; }
    float length(InternodeId id) const { return m_columns.length[id]; }
    float vigour(InternodeId id) const { return m_columns.vigour[id]; }
    BudMask buds(InternodeId id) const { return m_columns.buds[id]; }
    Step birth(InternodeId id) const { return m_columns.birth[id]; }
    bool isAlive(InternodeId id) const { return m_columns.present[id] != 0 && m_columns.death[id] == kNever; }
    bool continuesAxis(InternodeId id) const { return m_columns.slot[id] == kTerminalSlot; }

    /// The widths that a person has set, by ascending id; those of dead internodes count for nothing.
    std::span<const WidthConstraint> widthConstraints() const { return m_widths; }
    /// m; 0 if none is set there.
    float widthConstraint(InternodeId id) const;

    const QList<TreeParameters>& parameterSets() const { return m_parameterSets; }
    std::uint32_t currentParameterSet() const { return m_currentParameters; }
    /// The parameters in force now.
    const TreeParameters& parameters() const { return m_parameterSets[m_currentParameters]; }
    /// The parameters that an internode was grown with.
    const TreeParameters& parametersOf(InternodeId id) const
    {
        return m_parameterSets[m_columns.parameterSet[id]];
    }

    /// Keeps @p parameters, unless they are known already, and returns their index. Changes nothing else: a
    /// delta puts them in force. Precondition: less than 65,536 different sets.
    std::uint32_t rememberParameters(const TreeParameters& parameters);
    /// Drops the set that was remembered last. Precondition: neither an internode nor a delta refers to it,
    /// and it is not in force.
    void forgetLastParameters();

    const Lassos& lassos() const { return m_lassos; }
    /// Copies of the strokes in force.
    std::vector<LassoStroke> lassosInForce() const;
    /// Keeps @p stroke and returns its index. A delta puts it in force. Precondition: isLasso(stroke).
    std::uint32_t rememberLasso(const LassoStroke& stroke);
    /// Drops the strokes from @p count on. Precondition: none of them is in force, nor does a delta refer to
    /// one.
    void forgetLassosFrom(std::uint32_t count);

    void apply(TreeDelta& delta);
    void revert(const TreeDelta& delta);

    bool operator==(const Tree& other) const;

    /// Memory of the columns, in bytes.
    std::size_t bytes() const;

private:
    void setWidth(InternodeId id, float diameter);
    void setLasso(std::uint32_t index, bool inForce);

    InternodeColumns m_columns;
    std::vector<WidthConstraint> m_widths;
    Lassos m_lassos;
    QList<TreeParameters> m_parameterSets;
    std::uint32_t m_currentParameters = 0;
    std::uint64_t m_seed = 1;
    Step m_step = 0;
};

} // namespace espalier
