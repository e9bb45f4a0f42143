// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/ContentHash.h"
#include "model/strands/ProfileMorph.h"
#include "model/strands/StrandNode.h"
#include "model/tree/Tree.h"

#include <map>
#include <mutex>
#include <vector>

namespace espalier {

/// The profiles of a skeleton's nodes. A node has the profile of its internode. A trunk's foot has the one of
/// its first node, so that a hollow reaches the ground. Where profiles end, the wood returns to its round
/// section over twice its radius along the branch, so that there is no ledge; where the next profile is
/// nearer than two such lengths, one becomes the other. Fades follow branches, not the limbs that leave them.
class NodeProfiles {
public:
    /// Without fades, nodes between two internodes' ends have no profile. Refers to @p tree.
    NodeProfiles(const Tree& tree, const StrandSkeleton& skeleton, bool areFaded);

    bool has(std::uint32_t node) const { return m_shares[node].from != nullptr; }
    /// How far the section is on the way from a drawn profile (0) to one without (1).
    float roundness(std::uint32_t node) const
    {
        const Share& share = m_shares[node];
        return share.from == nullptr ? 1.0F : share.to == nullptr ? share.share : 0.0F;
    }
    /// Adds all that the profile of a node is made from.
    void addTo(ContentHash& hash, std::uint32_t node) const;
    /// Can be called by many threads. Precondition: has(node).
    StrandProfile at(std::uint32_t node) const;

private:
    /// A profile between two; without a second one, the way to a round section.
    struct Share {
        const StrandProfile* from = nullptr;
        const StrandProfile* to = nullptr;
        float share = 0.0F; ///< 0 for a profile of the node's own
    };
    struct LazyBlend {
        std::once_flag isMade;
        std::optional<ProfileBlend> blend;
    };
    using Blends = std::map<std::pair<const StrandProfile*, const StrandProfile*>, LazyBlend>;
    class Fader;

    std::vector<Share> m_shares; ///< By node
    mutable Blends m_blends;     ///< One for each pair in m_shares
};

} // namespace espalier
