// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/WoodMesher.h"
#include "model/strands/StrandLayouts.h"

#include <array>
#include <cstdint>
#include <vector>

namespace espalier {

/// What a mesh of strands has at a node is a function of the nodes around it. The distance up to which they
/// matter, in steps from a node to its parent or to a child:
enum class StrandReach {
    /// 3: tubes, sections and the positions of their vertices. Counted from places that are rounded already
    /// (StrandCurves::place).
    Positions,
    Triangles, ///< 4: triangles, which also read positions at the node below
    Normals,   ///< 5: normals, which also read triangles at the nodes below and above
};
inline constexpr std::size_t kStrandReachCount = 3;

/// For each node hashes of all that the mesh there is made from.
struct StrandKeys {
    std::array<std::vector<std::uint64_t>, kStrandReachCount> ofNodes;
};

StrandKeys strandKeys(const StrandLayouts& layouts, const WoodParameters& wood,
                      const WoodMeshOptions& options);

/// Compares the nodes of a tree with those of its last mesh: what has the same key can be taken over. So
/// nothing has to know what an edit changes, and a mesh with taken parts is the same, byte for byte, as one
/// without.
class StrandReuse {
public:
    /// @p last: the keys of the last mesh, which was made with options that are not coarser than the default,
    /// or null, and @p lastSkeleton: its skeleton, which must outlive
    /// this object.
    StrandReuse(const StrandLayouts& layouts, const WoodParameters& wood, const WoodMeshOptions& options,
                const StrandKeys* last, const StrandSkeleton* lastSkeleton);

    /// Whether a part of the mesh at @p node can be taken over.
    bool has(std::uint32_t node, StrandReach reach) const
    {
        return m_before[node] != kNoNode && m_reach[node] > static_cast<std::uint8_t>(reach);
    }
    /// The number of @p node in the last mesh. Precondition: has(node, ...).
    std::uint32_t before(std::uint32_t node) const { return m_before[node]; }
    /// Precondition: has() of any node.
    const StrandSkeleton& lastSkeleton() const { return *m_lastSkeleton; }
    StrandKeys takeKeys() { return std::move(m_keys); }

private:
    const StrandSkeleton* m_lastSkeleton;
    StrandKeys m_keys;
    std::vector<std::uint32_t> m_before;
    std::vector<std::uint8_t> m_reach; ///< How many of the reaches have the same key
};

} // namespace espalier
