// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Ids.h"
#include "model/tree/BudStates.h"
#include "model/tree/Columns.h"
#include "model/tree/LassoStroke.h"
#include "model/tree/Parameters.h"
#include "model/tree/StrandProfile.h"

namespace espalier {

/// Limits of values in a tree, m.
inline constexpr float kGreatestLength = 1000.0F;  ///< Of an internode
inline constexpr float kGreatestDiameter = 100.0F; ///< Of a width constraint
inline constexpr float kFarthestRoot = 1'000.0F;   ///< Of a root from the world's origin, along an axis
inline constexpr float kFarthestNode = 10'000.0F;  ///< Of any node, along an axis; bends stop there
inline constexpr float kGreatestLeaf = 100.0F;     ///< Of a placed leaf
/// The greatest twist of the strands at a node, rad.
inline constexpr float kGreatestTwist = 1000.0F;
/// The greatest vigour that is added at a node, years of growth.
inline constexpr float kMostAddedVigour = 10'000.0F;
/// The greatest length over which an axis is kept clear, m.
inline constexpr float kGreatestClearLength = 1'000.0F;
/// The greatest number of different parameter sets of one tree; columns refer to them with 16 bits.
inline constexpr qsizetype kMostParameterSets = 65'535;
// What a tree keeps for undo counts, too.
inline constexpr qsizetype kMostLassos = 100'000;
inline constexpr qsizetype kMostProfiles = 100'000;
inline constexpr std::size_t kMostProfilePointsInAll = 400'000;
/// Of the files of all different images in parameter sets, bytes; beside them, a scene has one picture.
inline constexpr qsizetype kMostImageBytes = qsizetype{448} << 20;

/// The kind of a placed leaf.
enum class LeafKind : std::uint8_t { Leaf, Flower, Fruit };

/// Checks of single values from files; see FaultOf.
namespace faults {
const char* ofShare(const float& value);
const char* ofRotation(const Rotation& value);
const char* ofLength(const float& value);
const char* ofVigour(const float& value);
const char* ofSlot(const std::uint8_t& value);
const char* ofBuds(const BudStates& value);
const char* ofLeafLength(const float& value);
const char* ofLeafKind(const LeafKind& value);
const char* ofDiameter(const float& value);
const char* ofRootPosition(const Vec3& value);
const char* ofTwist(const float& value);
const char* ofAddedVigour(const float& value);
const char* ofClearLength(const float& value);
const char* ofDrawnLength(const float& value);
} // namespace faults

// The columns of internodes:
//   parent        kNoInternode for a root
//   along         where on the parent it is attached: 0 at its lower end, 1 at its node
//   rotation      local frame against the parent's; +Y along the internode, +X to its first lateral bud
//   length        m
//   vigour        of the bud that it grew from, relative to the strongest bud of that step, 0...1
//   slot          bud of the parent's node that it grew from; kTerminalSlot continues the axis
//   buds          at its node, the upper end
//   birth, death  steps; kNever while it lives; only TreeDelta::died sets the death
//   parameterSet  index of the parameter set that it grew with
//   key           seed of its random numbers, and its name in recipes
#define ESPALIER_INTERNODE_COLUMNS(COLUMN)                                                                   \
    COLUMN(InternodeId, parent, std::nullopt, noFault, Edits::Never)                                         \
    COLUMN(float, along, 1.0F, faults::ofShare, Edits::Allowed)                                              \
    COLUMN(Rotation, rotation, std::nullopt, faults::ofRotation, Edits::Allowed)                             \
    COLUMN(float, length, std::nullopt, faults::ofLength, Edits::Allowed)                                    \
    COLUMN(float, vigour, 0.0F, faults::ofVigour, Edits::Allowed)                                            \
    COLUMN(std::uint8_t, slot, std::nullopt, faults::ofSlot, Edits::Never)                                   \
    COLUMN(BudStates, buds, BudStates(), faults::ofBuds, Edits::Allowed)                                     \
    COLUMN(Step, birth, std::nullopt, noFault, Edits::Never)                                                 \
    COLUMN(Step, death, kNever, noFault, Edits::Never)                                                       \
    COLUMN(std::uint16_t, parameterSet, std::uint16_t{0}, noFault, Edits::Never)                             \
    COLUMN(InternodeKey, key, std::nullopt, noFault, Edits::Never)

// The columns of leaves (flowers, fruit) that the user has placed; leaves by rule are a function of the
// parameters:
//   internode     the one that bears it
//   along         place on that internode, 0...1
//   rotation      frame against the internode's; +Y along the midrib, +Z the upper side
//   length        m, from base to tip
//   kind
//   birth, death  steps; kNever while it exists; a delta that removes the leaf sets the death to stepAfter
#define ESPALIER_LEAF_COLUMNS(COLUMN)                                                                        \
    COLUMN(InternodeId, internode, std::nullopt, noFault, Edits::Allowed)                                    \
    COLUMN(float, along, 1.0F, faults::ofShare, Edits::Allowed)                                              \
    COLUMN(Rotation, rotation, std::nullopt, faults::ofRotation, Edits::Allowed)                             \
    COLUMN(float, length, std::nullopt, faults::ofLeafLength, Edits::Allowed)                                \
    COLUMN(LeafKind, kind, LeafKind::Leaf, faults::ofLeafKind, Edits::Allowed)                               \
    COLUMN(Step, birth, std::nullopt, noFault, Edits::Never)                                                 \
    COLUMN(Step, death, kNever, noFault, Edits::Allowed)

// Properties that few internodes have:
//   width         diameter that the user has set, m (TreeSketch §3.3); no effect while the internode is dead
//   rootPosition  world position of a root, m; roots without one stand at the origin
//   profile       index of the profile that the strands at the node are packed into (Strands 2024 §5.3)
//   twist         rad, by which the section of strands at the node is turned against the one below it (§5.4)
//   addedVigour   years of growth that the subtree has been given and not used yet (§4, invigoration)
//   clearLength   m along the axis that begins with the internode, from its base on: there, buds rest; no
//                 effect on an internode that begins no axis
//   drawnLength   m along that axis, in the same way: there, it was drawn and growth does not straighten it
#define ESPALIER_SPARSE_COLUMNS(COLUMN)                                                                      \
    COLUMN(float, width, std::nullopt, faults::ofDiameter, Edits::Allowed)                                   \
    COLUMN(Vec3, rootPosition, std::nullopt, faults::ofRootPosition, Edits::Allowed)                         \
    COLUMN(std::uint32_t, profile, std::nullopt, noFault, Edits::Allowed)                                    \
    COLUMN(float, twist, std::nullopt, faults::ofTwist, Edits::Allowed)                                      \
    COLUMN(float, addedVigour, std::nullopt, faults::ofAddedVigour, Edits::Allowed)                          \
    COLUMN(float, clearLength, std::nullopt, faults::ofClearLength, Edits::Allowed)                          \
    COLUMN(float, drawnLength, std::nullopt, faults::ofDrawnLength, Edits::Allowed)

// Values that are stored once and referred to by index; see KeptEntries (model/io/project) for how files hold
// them:
//   parameters    every set that was ever in force
//   lassos        every stroke that was ever in force
//   profiles      every profile that a node ever had
#define ESPALIER_KEPT_VALUES(COLUMN)                                                                         \
    COLUMN(TreeParameters, parameters, std::nullopt, noFault, Edits::Never)                                  \
    COLUMN(LassoStroke, lassos, std::nullopt, noFault, Edits::Never)                                         \
    COLUMN(StrandProfile, profiles, std::nullopt, noFault, Edits::Never)

ESPALIER_VISITOR(InternodeTable, ESPALIER_INTERNODE_COLUMNS)
ESPALIER_VISITOR(LeafTable, ESPALIER_LEAF_COLUMNS)
ESPALIER_VISITOR(SparseTable, ESPALIER_SPARSE_COLUMNS)
ESPALIER_VISITOR(KeptTable, ESPALIER_KEPT_VALUES)

/// The values of a new row: an internode, or a placed leaf.
struct InternodeRow {
    ESPALIER_INTERNODE_COLUMNS(ESPALIER_ROW_MEMBER)
};
struct LeafRow {
    ESPALIER_LEAF_COLUMNS(ESPALIER_ROW_MEMBER)
};

/// Internodes as columns: row i of each belongs to internode i (or, in a delta, to the i-th one that it
/// adds). QList shares its data implicitly: a copy is a snapshot and costs nothing until one side changes.
struct InternodeColumns {
    ESPALIER_INTERNODE_COLUMNS(ESPALIER_COLUMN_MEMBER)
    std::uint32_t size() const { return static_cast<std::uint32_t>(parent.size()); }
    void append(const InternodeRow& row);
};

/// Placed leaves as columns, in the same way.
struct LeafColumns {
    ESPALIER_LEAF_COLUMNS(ESPALIER_COLUMN_MEMBER)
    std::uint32_t size() const { return static_cast<std::uint32_t>(internode.size()); }
    void append(const LeafRow& row);
};

/// The sparse columns of a tree.
struct SparseColumns {
    ESPALIER_SPARSE_COLUMNS(ESPALIER_SPARSE_MEMBER)
};

/// The kept values of a tree, or those that a delta adds. A value that is stored does not change.
struct KeptValues {
    ESPALIER_KEPT_VALUES(ESPALIER_COLUMN_MEMBER)
};

/// The changed cells of each column.
struct InternodeChanges {
    ESPALIER_INTERNODE_COLUMNS(ESPALIER_CHANGES_MEMBER)
};
struct LeafChanges {
    ESPALIER_LEAF_COLUMNS(ESPALIER_CHANGES_MEMBER)
};
/// A cell without a value means that the internode has none.
struct SparseChanges {
    ESPALIER_SPARSE_COLUMNS(ESPALIER_SPARSE_CHANGES_MEMBER)
};
/// The number of values of each kind.
struct KeptCounts {
    ESPALIER_KEPT_VALUES(ESPALIER_COUNT_MEMBER)
    bool operator==(const KeptCounts&) const = default;
};

/// A diameter that the user has set for an internode, m.
using WidthConstraint = SparseCell<float>;

} // namespace espalier
