// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/sketch/BranchFrames.h"

#include <array>
#include <cstdint>
#include <vector>

namespace espalier {

/// A way to go on with leaves that the user has placed as samples (Okabe 2005, 3.5, figures 7 to 10). A whorl
/// consists of the leaves that stand at the same place of a branch.
enum class LeafEngine : std::uint8_t {
    AddToWhorl,   ///< One more leaf in the whorl (or beside a single leaf); all stand evenly around
    ExtendWhorls, ///< From a whorl and leaves at another place: whorls at that spacing along the branch
    Alternate,    ///< From single leaves at two places: one leaf each time, turned by the same angle
    Opposite,     ///< From one or two leaves at two places: pairs at that spacing, all in one plane
    Decussate,    ///< The same, each pair across the one below it
};
inline constexpr std::array kLeafEngines{LeafEngine::AddToWhorl, LeafEngine::ExtendWhorls,
                                         LeafEngine::Alternate, LeafEngine::Opposite, LeafEngine::Decussate};

/// Leaves that stand nearer to each other than this share of the branch's length are a whorl.
inline constexpr double kWhorlTolerance = 0.02;
/// The most leaves of a whorl.
inline constexpr std::size_t kMostOfWhorl = 64;

struct LeafSuggestion {
    LeafEngine engine = LeafEngine::AddToWhorl;
    TreeDelta delta; ///< Starts at the tree; adds leaves, and moves those that are redistributed
};

/// What the engines suggest after the user has edited the leaf nearest to @p place, in the order of
/// kLeafEngines; engines that do not apply there, or would change nothing, are left out. The samples are that
/// leaf's whorl and the whorl nearest to it on the same branch, among living leaves of its kind.
///
/// New leaves have the mean length of the samples, and their mean frame apart from the angle around the
/// branch and from which of its two sides is up; angles are taken in frames that are carried along the branch
/// (BranchFrames). Arrangements go on from the samples toward the tip and toward the base, up to the ends of
/// the branch; a place that has leaves already is left as it is. Only these leaves of the samples move:
/// AddToWhorl gives the leaves of its whorl the place of the oldest one, even angles and the mean frame;
/// Opposite and Decussate turn a leaf of a sample into its pair.
///
/// Angles between the leaves of a new whorl are even to 1e-6 rad. Nothing for a dead internode, or for a
/// branch without leaves. The result is a function of the tree and the place.
std::vector<LeafSuggestion> suggestLeaves(const Tree& tree, const TreeIndex& index, const BranchPlace& place);

} // namespace espalier
