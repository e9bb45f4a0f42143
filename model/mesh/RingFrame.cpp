// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/RingFrame.h"

#include <cmath>
#include <cstddef>
#include <cstring>
#include <memory>
#include <numbers>

namespace espalier {

namespace {

constexpr int kMostSides = kSideCounts.back();

/// Cosine and sine around a ring of m sides, and the share of the full turn; entry m repeats entry 0 exactly,
/// so that the seam has no gap.
struct RingTable {
    std::array<float, kMostSides + 1> cosine{};
    std::array<float, kMostSides + 1> sine{};
    std::array<float, kMostSides + 1> share{};
};

using RingTables = std::array<RingTable, kMostSides + 1>;

const RingTable& ringTable(int sides)
{
    static const auto tables = [] {
        auto made = std::make_unique<RingTables>();
        for (const int count : kSideCounts) {
            RingTable& table = (*made)[static_cast<std::size_t>(count)];
            for (int i = 0; i <= count; ++i) {
                const double angle = 2.0 * std::numbers::pi * (i % count) / count;
                const auto entry = static_cast<std::size_t>(i);
                table.cosine[entry] = static_cast<float>(std::cos(angle));
                table.sine[entry] = static_cast<float>(std::sin(angle));
                table.share[entry] = static_cast<float>(i) / static_cast<float>(count);
            }
        }
        return made;
    }();
    return (*tables)[static_cast<std::size_t>(sides)];
}

} // namespace

Vec3 transported(const Vec3& normal, const Vec3& from, const Vec3& fromTangent, const Vec3& to,
                 const Vec3& toTangent)
{
    const Vec3 chord = to - from;
    const float chordSquared = chord.squaredNorm();
    Vec3 carried = normal;
    Vec3 tangent = fromTangent;
    if (chordSquared > 0.0F) {
        const float scale = 2.0F / chordSquared;
        carried -= scale * chord.dot(normal) * chord;
        tangent -= scale * chord.dot(fromTangent) * chord;
    }
    const Vec3 bisector = toTangent - tangent;
    const float bisectorSquared = bisector.squaredNorm();
    // After a reversal no frame is the nearest; any frame is right.
    if (bisectorSquared > 1e-12F)
        carried -= 2.0F / bisectorSquared * bisector.dot(carried) * bisector;
    // Otherwise rounding would accumulate along an axis of thousands of rings.
    carried -= carried.dot(toTangent) * toTangent;
    const float squared = carried.squaredNorm();
    return squared > 1e-8F ? Vec3(carried / std::sqrt(squared)) : anyPerpendicular(toTangent);
}

RingFrame::RingFrame(const Vec3& centre, const Vec3& tangent, const Vec3& normal, float radius, float slant,
                     float v)
{
    const Vec3 binormal = tangent.cross(normal);
    const float outward = 1.0F / std::sqrt(1.0F + slant * slant);
    const Vec3 n = outward * normal;
    const Vec3 b = outward * binormal;
    const Vec3 rise = outward * slant * tangent;
    const Vec3 rn = radius * normal;
    const Vec3 rb = radius * binormal;
    m_base[0] = {centre.x(), centre.y(), centre.z(), rise.x()};
    m_base[1] = {rise.y(), rise.z(), 0.0F, 0.0F};
    m_base[2] = {0.0F, 1.0F, 0.0F, v};
    m_cosine[0] = {rn.x(), rn.y(), rn.z(), n.x()};
    m_cosine[1] = {n.y(), n.z(), binormal.x(), binormal.y()};
    m_cosine[2] = {binormal.z(), 0.0F, 0.0F, 0.0F};
    m_sine[0] = {rb.x(), rb.y(), rb.z(), b.x()};
    m_sine[1] = {b.y(), b.z(), -normal.x(), -normal.y()};
    m_sine[2] = {-normal.z(), 0.0F, 0.0F, 0.0F};
}

void RingFrame::write(MeshVertex* vertex, int sides, float repeats) const
{
    static_assert(offsetof(MeshVertex, normal) == 12 && offsetof(MeshVertex, tangent) == 24 &&
                  offsetof(MeshVertex, uv) == 40);
    const RingTable& table = ringTable(sides);
    for (std::size_t i = 0; i <= static_cast<std::size_t>(sides); ++i) {
        const float c = table.cosine[i];
        const float s = table.sine[i];
        std::array<Eigen::Array4f, 3> values;
        for (std::size_t part = 0; part < 3; ++part)
            values[part] = m_base[part] + c * m_cosine[part] + s * m_sine[part];
        std::memcpy(static_cast<void*>(vertex + i), values.data(), sizeof(MeshVertex));
        vertex[i].uv[0] = repeats * table.share[i];
    }
}

} // namespace espalier
