// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/TreeDocument.h"

#include <span>
#include <vector>

namespace espalier {

/// The internodes from @p first to @p last, both included, if one of them is on the way from the other to the
/// root; else none.
std::vector<InternodeId> branchBetween(const Tree& tree, InternodeId first, InternodeId last);

// Each of these is one undo step, or none if nothing changes. Dead and unknown internodes are left out.

/// Gives the nodes of @p internodes a profile (Strands 2024 §5.3). Returns false, and does nothing, if the
/// document has no room for another profile. Precondition: profileFault(profile) is empty.
bool setProfile(TreeDocument& document, std::span<const InternodeId> internodes,
                const StrandProfile& profile);
/// Gives the nodes from @p first to @p last profiles between @p profile and @p lastProfile, by the length of
/// the branch between them; the two ends get these profiles themselves. Does nothing if there is no way
/// between them (see branchBetween()). Returns false, and does nothing, if the document has no room for these
/// profiles. Precondition: the profiles have no faults.
bool blendProfiles(TreeDocument& document, InternodeId first, InternodeId last, const StrandProfile& profile,
                   const StrandProfile& lastProfile);
/// Takes the profiles of these nodes away.
void clearProfiles(TreeDocument& document, std::span<const InternodeId> internodes);

} // namespace espalier
