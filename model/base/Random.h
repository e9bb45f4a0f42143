// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Ids.h"
#include "model/base/Vector.h"

#include <cmath>
#include <cstdint>

namespace espalier {

/// What a random number is used for. It is part of the number's key, so that two uses never share a value.
/// Append only: the values of the enumerators are part of "same recipe, same tree".
enum class Purpose : std::uint32_t {
    BrushMarker,
    BudMarker,
    TropismPlane,
    BranchingAngle,
    Phyllotaxis,
    DeflectionAngle,
    ShootLength,
    BudDormancy,
    Leaf,
    Direction,
    InternodeLength,
    Texture,
    LassoMarker,
    LeafPlane,
    Thinning,
};

/// SplitMix64's finaliser: each bit of the value changes about half of the result's.
constexpr std::uint64_t mixedBits(std::uint64_t value)
{
    value += 0x9e3779b97f4a7c15U;
    value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9U;
    value = (value ^ (value >> 27)) * 0x94d049bb133111ebU;
    return value ^ (value >> 31);
}

/// The key of a root of a tree that is grown from @p seed. @p number: 0 for the seedling, and for another
/// root the number of roots, the dead included, that the tree had before it.
constexpr InternodeKey rootKey(std::uint64_t seed, std::uint32_t number = 0)
{
    const InternodeKey key = mixedBits(seed);
    return number == 0 ? key : mixedBits(mixedBits(key ^ 0x2545f4914f6cdd1dU) ^ number);
}

/// The key of an internode that grows from the bud @p slot of the internode with the key @p parent and is
/// born in @p step. It does not depend on rows, so edits that were undone do not change what grows next.
constexpr InternodeKey childKey(InternodeKey parent, int slot, Step step)
{
    return mixedBits(mixedBits(parent ^ 0x5851f42d4c957f2dU) ^
                     ((std::uint64_t{step} << 8U) | static_cast<std::uint64_t>(slot)));
}

/// Counter-based random numbers: a pure function of (seed, step, id, purpose, counter) or of (an internode's
/// key, number, purpose, counter), never of the order of calls, so that one thread or many give the same
/// tree. The mixing is applied to each part of the key in turn.
class Random {
public:
    /// Random numbers of an internode. @p number distinguishes its buds or its steps.
    Random(InternodeKey key, std::uint32_t number, Purpose purpose)
        : m_key(mixedBits(mixedBits(key ^ (std::uint64_t{number} << 32U)) ^
                          static_cast<std::uint64_t>(purpose)))
    {
    }
    /// Numbers that belong to no internode.
    Random(std::uint64_t seed, std::uint32_t step, std::uint32_t id, Purpose purpose)
        : Random(mixedBits(seed) ^ id, step, purpose)
    {
    }

    std::uint64_t bits() { return mixedBits(m_key + kGamma * ++m_counter); }

    /// Uniform in [0, 1), 53 bits.
    double uniform() { return static_cast<double>(bits() >> 11) * 0x1.0p-53; }
    /// Uniform in [from, to).
    double uniform(double from, double to) { return from + (to - from) * uniform(); }
    /// Bell-shaped: mean 0, standard deviation 1, within ±3.5 (the sum of four uniforms: Box-Muller costs ten
    /// times as much).
    double normal()
    {
        const double sum = uniform() + uniform() + uniform() + uniform();
        return std::numbers::sqrt3 * (sum - 2.0);
    }
    /// Uniform on the unit sphere.
    Vec3 direction()
    {
        const double z = uniform(-1.0, 1.0);
        const double azimuth = uniform(0.0, 2.0 * std::numbers::pi);
        const double ring = std::sqrt(1.0 - z * z);
        return {static_cast<float>(ring * std::cos(azimuth)), static_cast<float>(z),
                static_cast<float>(ring * std::sin(azimuth))};
    }
    /// Uniform in the unit ball.
    Vec3 inBall()
    {
        const auto radius = static_cast<float>(std::cbrt(uniform()));
        return radius * direction();
    }

private:
    static constexpr std::uint64_t kGamma = 0x9e3779b97f4a7c15U;

    std::uint64_t m_key;
    std::uint64_t m_counter = 0;
};

} // namespace espalier
