// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/envelope/EnvelopeSet.h"

#include "model/base/Parallel.h"

#include <algorithm>

namespace espalier {

namespace {

constexpr int kMarkerAttempts = 10000;
constexpr std::size_t kVolumePoints = 20000;

} // namespace

Result<EnvelopeSet> EnvelopeSet::fromStrokes(std::span<const LassoStroke> strokes,
                                             const EnvelopeOptions& options)
{
    std::vector<std::vector<LassoStroke>> planes;
    for (const LassoStroke& stroke : strokes) {
        const auto same = std::ranges::find_if(
            planes, [&](const std::vector<LassoStroke>& plane) { return coplanar(plane.front(), stroke); });
        (same != planes.end() ? *same : planes.emplace_back()).push_back(stroke);
    }
    std::vector<Envelope> envelopes;
    std::optional<Error> error;
    for (const std::vector<LassoStroke>& plane : planes) {
        Result<Envelope> envelope = Envelope::fromStrokes(plane, options);
        if (envelope)
            envelopes.push_back(*envelope);
        else
            error = envelope.error();
    }
    if (envelopes.empty() && error)
        return *error;
    return EnvelopeSet(std::move(envelopes));
}

std::size_t EnvelopeSet::envelopesAt(const Vec3& point) const
{
    return static_cast<std::size_t>(
        std::ranges::count_if(m_envelopes, [&](const Envelope& one) { return one.contains(point); }));
}

bool EnvelopeSet::contains(const Vec3& point) const
{
    return std::ranges::any_of(m_envelopes, [&](const Envelope& one) { return one.contains(point); });
}

bool EnvelopeSet::containsWithin(const Vec3& point, double margin) const
{
    return std::ranges::any_of(m_envelopes,
                               [&](const Envelope& one) { return one.containsWithin(point, margin); });
}

double EnvelopeSet::riseAt(const Vec3& point) const
{
    double greatest = 0.0;
    for (const Envelope& envelope : m_envelopes) {
        if (envelope.contains(point))
            greatest = std::max(greatest, envelope.riseAt(point));
    }
    return greatest;
}

double EnvelopeSet::volume() const
{
    if (m_envelopes.size() == 1)
        return m_envelopes.front().volume();
    double sum = 0.0;
    for (const Envelope& envelope : m_envelopes) {
        // A point in several envelopes is counted once for each of them, so it counts for a share in each.
        double shares = 0.0;
        for (const Vec3& point : envelope.sampleUniform(kVolumePoints, 0))
            shares += 1.0 / static_cast<double>(std::max<std::size_t>(1, envelopesAt(point)));
        sum += envelope.volume() * shares / static_cast<double>(kVolumePoints);
    }
    return sum;
}

Box3 EnvelopeSet::bounds() const
{
    Box3 box;
    for (const Envelope& envelope : m_envelopes)
        box.extend(envelope.bounds());
    return box;
}

std::vector<Vec3> EnvelopeSet::sampleUniform(std::size_t count, std::uint64_t seed, std::uint32_t step) const
{
    if (m_envelopes.empty())
        return {};
    std::vector<double> upTo;
    double total = 0.0;
    for (const Envelope& envelope : m_envelopes)
        upTo.push_back(total += envelope.proposalVolume());

    std::vector<Vec3> markers(count);
    parallelFor(count, 1024, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            Random random(seed, step, static_cast<std::uint32_t>(i), Purpose::LassoMarker);
            markers[i] = m_envelopes.front().deepest();
            for (int attempt = 0; attempt < kMarkerAttempts; ++attempt) {
                const auto chosen = std::ranges::upper_bound(upTo, random.uniform() * total) - upTo.begin();
                const std::size_t one = std::min(static_cast<std::size_t>(chosen), upTo.size() - 1);
                const std::optional<Vec3> point = m_envelopes[one].propose(random);
                // Where n envelopes propose points, one in n is taken.
                if (point && random.uniform() * static_cast<double>(envelopesAt(*point)) < 1.0) {
                    markers[i] = *point;
                    break;
                }
            }
        }
    });
    return markers;
}

} // namespace espalier
