// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/Mesh.h"

#include <array>

namespace espalier {

/// The numbers of sides that a tube's rings can have.
inline constexpr std::array<int, 9> kSideCounts{4, 6, 8, 12, 16, 24, 32, 48, 64};

/// Carries @p normal from one point of a curve to the next with as little twist as can be (double reflection,
/// Wang et al. 2008); all directions are unit vectors.
Vec3 transported(const Vec3& normal, const Vec3& from, const Vec3& fromTangent, const Vec3& to,
                 const Vec3& toTangent);

/// The numbers that all vertices of a ring share. A vertex is base + cosine · C + sine · S in the twelve
/// numbers of MeshVertex, except u.
class RingFrame {
public:
    /// A ring of @p radius (m) around @p centre, across @p tangent, beginning at @p normal. @p slant: how
    /// much its normals rise along the tangent per unit outward.
    RingFrame(const Vec3& centre, const Vec3& tangent, const Vec3& normal, float radius, float slant,
              float v);

    /// Writes sides + 1 vertices, the last at the place of the first; u goes from 0 to @p repeats.
    /// Precondition: @p sides is one of kSideCounts.
    void write(MeshVertex* vertex, int sides, float repeats) const;

private:
    std::array<Eigen::Array4f, 3> m_base;
    std::array<Eigen::Array4f, 3> m_cosine;
    std::array<Eigen::Array4f, 3> m_sine;
};

} // namespace espalier
