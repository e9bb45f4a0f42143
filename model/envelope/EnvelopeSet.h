// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/envelope/Envelope.h"

namespace espalier {

/// The union of envelopes that were drawn from several sides, each in its own plane.
class EnvelopeSet {
public:
    EnvelopeSet() = default;
    explicit EnvelopeSet(std::vector<Envelope> envelopes) : m_envelopes(std::move(envelopes)) {}

    /// Strokes in the same plane make one envelope, in which they can be one another's holes. Those that
    /// enclose nothing are left out; an Error if there are no others.
    static Result<EnvelopeSet> fromStrokes(std::span<const LassoStroke> strokes,
                                           const EnvelopeOptions& options = {});

    const std::vector<Envelope>& envelopes() const { return m_envelopes; }
    bool isEmpty() const { return m_envelopes.empty(); }

    bool contains(const Vec3& point) const;
    /// Whether it lies so in one of the envelopes; see there.
    bool containsWithin(const Vec3& point, double margin) const;
    /// The greatest of the envelopes that contain the point; see there.
    double riseAt(const Vec3& point) const;
    /// m³; what envelopes have in common counts once. Of several envelopes it is estimated at 20,000 points,
    /// to about one percent.
    double volume() const;
    Box3 bounds() const; ///< Empty if the set is
    /// As Envelope::sampleUniform; where envelopes overlap it is no denser. None if the set is empty.
    std::vector<Vec3> sampleUniform(std::size_t count, std::uint64_t seed, std::uint32_t step = 0) const;

private:
    std::size_t envelopesAt(const Vec3& point) const;

    std::vector<Envelope> m_envelopes;
};

} // namespace espalier
