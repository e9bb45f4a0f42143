// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Error.h"
#include "model/base/Random.h"
#include "model/envelope/EnvelopeField.h"
#include "model/envelope/LassoLoop.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace espalier {

struct EnvelopeOptions {
    /// Nodes along the longer side, 32...1024. At 256 the silhouette is kept to a fifth of a percent of the
    /// size, far below the spacing of markers; 512 takes four times as long.
    int resolution = 256;

    bool operator==(const EnvelopeOptions&) const = default;
};

/// The volume that lasso strokes in one plane stand for (TreeSketch §3.2): their silhouette, inflated to both
/// sides of the plane. Immutable; copies share their content.
class Envelope {
public:
    /// The ends of each stroke are joined; a stroke within another is a hole, others are united (see
    /// coverage()). All strokes are taken in the plane of the first. Fails if the first stroke has no plane
    /// or if nothing is enclosed.
    static Result<Envelope> fromStrokes(std::span<const LassoStroke> strokes,
                                        const EnvelopeOptions& options = {});

    bool contains(const Vec3& point) const;
    /// Whether the point lies at least @p margin (m, ≥ 0) within the silhouette and the surface. Where the
    /// envelope is thinner than that, its inner part counts as inside.
    bool containsWithin(const Vec3& point, double margin) const;
    /// How far the surface rises above the plane at the point's place in it, m; 0 beside the silhouette.
    double riseAt(const Vec3& point) const;
    /// m³
    double volume() const;
    /// A box that contains the envelope and exceeds it by less than a node's spacing.
    Box3 bounds() const;
    /// Closed lines in the plane (the last point is joined to the first), m: regions counter-clockwise seen
    /// from the front, holes clockwise.
    std::vector<std::vector<Vec3>> outline() const;
    /// Positions of markers of free space, m: uniform in the volume. The same seed and step give the same
    /// positions, on any number of threads.
    std::vector<Vec3> sampleUniform(std::size_t count, std::uint64_t seed, std::uint32_t step = 0) const;

    const EnvelopeField& field() const;
    double spacing() const; ///< Between nodes of the field, m
    /// Where a place in the field's grid lies, @p z spacings in front of the plane.
    Vec3 toWorld(double x, double y, double z) const;
    /// Turns a direction from the field's axes to the world's; z is the front, right × up.
    Vec3 directionToWorld(const Vec3& inField) const;

private:
    friend class EnvelopeSet;
    struct Content;

    explicit Envelope(std::shared_ptr<const Content> content) : m_content(std::move(content)) {}

    /// One attempt at a random point. A point that is returned is uniform in the volume; an attempt succeeds
    /// with the probability volume() / proposalVolume().
    std::optional<Vec3> propose(Random& random) const;
    double proposalVolume() const; ///< m³
    Vec3 deepest() const;          ///< A point that is contained for certain

    std::shared_ptr<const Content> m_content;
};

} // namespace espalier
