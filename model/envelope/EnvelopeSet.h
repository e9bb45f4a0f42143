// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/envelope/Envelope.h"

namespace espalier {

/// The union of envelopes that were drawn from several sides, each in its own plane.
class EnvelopeSet {
public:
    EnvelopeSet() = default;
    explicit EnvelopeSet(std::vector<Envelope> envelopes) : m_envelopes(std::move(envelopes)) {}

    /// Strokes in the same plane make one envelope, in which one stroke can be a hole of another. Strokes
    /// that enclose nothing are left out; fails if all strokes enclose nothing.
    static Result<EnvelopeSet> fromStrokes(std::span<const LassoStroke> strokes,
                                           const EnvelopeOptions& options = {});

    const std::vector<Envelope>& envelopes() const { return m_envelopes; }
    bool isEmpty() const { return m_envelopes.empty(); }

    bool contains(const Vec3& point) const;
    /// Whether one of the envelopes contains the point; see Envelope::containsWithin().
    bool containsWithin(const Vec3& point, double margin) const;
    /// The greatest Envelope::riseAt() of the envelopes that contain the point.
    double riseAt(const Vec3& point) const;
    /// m³; overlaps of envelopes count once. The volume of several envelopes is estimated at 20,000 points,
    /// to about one percent.
    double volume() const;
    Box3 bounds() const; ///< Empty if the set is empty
    /// Like Envelope::sampleUniform(); where envelopes overlap the density is the same. None if the set is
    /// empty.
    std::vector<Vec3> sampleUniform(std::size_t count, std::uint64_t seed, std::uint32_t step = 0) const;

private:
    std::size_t envelopesAt(const Vec3& point) const;

    std::vector<Envelope> m_envelopes;
};

} // namespace espalier
