// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Vector.h"

#include <array>
#include <cstdint>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace espalier {

/// A vertex in the form that the graphics card gets: 48 bytes without padding. It has no initial values, so
/// that large buffers are not written twice.
struct MeshVertex {
    std::array<float, 3> position; ///< m
    std::array<float, 3> normal;   ///< Unit, out of the surface
    /// Unit, toward rising u; the fourth number is the handedness: toward rising v lies w (normal × tangent).
    std::array<float, 4> tangent;
    /// v = 0 is the bottom row of an image, v = 1 its top row (as in Blender and OBJ, opposite to glTF).
    std::array<float, 2> uv;

    bool operator==(const MeshVertex&) const = default;
};
static_assert(sizeof(MeshVertex) == 48 && std::is_trivial_v<MeshVertex>);

/// Allocates without zeroing: large buffers are written once, by the threads that fill them.
template <class T>
struct UninitialisedAllocator : std::allocator<T> {
    template <class U>
    struct rebind {
        using other = UninitialisedAllocator<U>;
    };
    template <class U>
    void construct(U* place) noexcept
    {
        ::new (static_cast<void*>(place)) U;
    }
    template <class U, class... Arguments>
    void construct(U* place, Arguments&&... arguments)
    {
        ::new (static_cast<void*>(place)) U(std::forward<Arguments>(arguments)...);
    }
};

template <class T>
using MeshBuffer = std::vector<T, UninitialisedAllocator<T>>;

using VertexIndex = std::uint32_t;

/// Triangles, counter-clockwise seen from outside.
struct TriangleMesh {
    MeshBuffer<MeshVertex> vertices;
    MeshBuffer<VertexIndex> indices;
};

/// The numbers of elements of a mesh or of a part of one.
struct MeshSize {
    std::uint32_t vertices = 0;
    std::uint32_t indices = 0;
    bool operator==(const MeshSize&) const = default;
};

inline Vec3 toVec3(const std::array<float, 3>& values)
{
    return {values[0], values[1], values[2]};
}

inline std::array<float, 3> toArray(const Vec3& vector)
{
    return {vector.x(), vector.y(), vector.z()};
}

} // namespace espalier
