// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/strands/StrandFibres.h"

#include "model/base/Parallel.h"
#include "model/strands/StrandCurves.h"

#include <algorithm>
#include <cmath>

namespace espalier {

namespace {

constexpr std::size_t kFibresPerTask = 64;
/// Pieces between two nodes, if there is room for them.
constexpr std::size_t kPiecesPerSegment = 3;
/// The branches of a limb differ from it by at most half of this, in turns of the circle of hues.
constexpr float kHueSpread = 0.3F;
/// Brightness of fibres in the middle of the wood, relative to those at its surface.
constexpr float kInnermost = 0.35F;
/// Twigs of few strands have no inside; wood of so many has.
constexpr float kThickStrands = 20.0F;

/// A saturated colour of a hue in turns, and a brightness of 0...1.
std::array<std::uint8_t, 4> colourOf(float hue, float brightness)
{
    std::array<std::uint8_t, 4> colour{0, 0, 0, 255};
    for (std::size_t channel = 0; channel < 3; ++channel) {
        const float turn = hue + static_cast<float>(channel) / 3.0F;
        const float wave = 0.5F + 0.5F * std::cos(2.0F * std::numbers::pi_v<float> * turn);
        colour[channel] = static_cast<std::uint8_t>(255.0F * brightness * (0.25F + 0.75F * wave));
    }
    return colour;
}

/// A hue that belongs to the axis for ever, 0...1 turns.
float hueOf(InternodeKey axis)
{
    constexpr int kBits = 24;
    return static_cast<float>(axis >> (64 - kBits)) / static_cast<float>(1U << kBits);
}

/// The hue of the strands that end at the tip @p id, in turns: of the limb, which is the axis that leaves the
/// trunk, and a little of the branch that leaves the limb. It depends only on where these begin, so nothing
/// that grows or is cut elsewhere changes it.
float hueOf(const Tree& tree, const TreeIndex& index, InternodeId id)
{
    InternodeId trunk = index.axis(id);
    InternodeId limb = trunk;
    InternodeId branch = trunk;
    while (tree.parent(trunk) != kNoInternode) {
        branch = limb;
        limb = trunk;
        trunk = index.axis(tree.parent(trunk));
    }
    const float hue = hueOf(tree.key(limb));
    return branch == limb ? hue : hue + kHueSpread * (hueOf(tree.key(branch)) - 0.5F);
}

/// A strand by its tip.
struct Fibre {
    std::uint32_t tip;    ///< Node
    std::uint32_t strand; ///< Its number there
    std::size_t segments; ///< From the base to the tip
    std::size_t first;    ///< Vertex
};

} // namespace

std::vector<FibreVertex> strandFibres(const StrandLayouts& layouts, const Tree& tree, const TreeIndex& index,
                                      std::size_t most)
{
    const StrandSkeleton& skeleton = layouts.skeleton();
    std::vector<std::size_t> depths(skeleton.nodes.size(), 0);
    std::vector<Fibre> fibres;
    std::size_t segments = 0;
    for (std::uint32_t node = 0; node < skeleton.nodes.size(); ++node) {
        const StrandNode& n = skeleton.nodes[node];
        if (!skeleton.isBase(node))
            depths[node] = depths[n.parent] + 1;
        if (n.childCount > 0 || depths[node] == 0)
            continue;
        for (std::uint32_t strand = 0; strand < n.strands; ++strand)
            fibres.push_back({node, strand, depths[node], 0});
        segments += n.strands * depths[node];
    }
    std::size_t pieces = kPiecesPerSegment;
    while (pieces > 1 && pieces * segments > most)
        --pieces;
    // Every so many-th strand alone, as few as necessary are left out.
    if (pieces * segments > most && most > 0) {
        const std::size_t stride = (pieces * segments + most - 1) / most;
        std::size_t kept = 0;
        for (std::size_t i = stride / 2; i < fibres.size(); i += stride)
            fibres[kept++] = fibres[i];
        fibres.resize(kept);
    }
    // The strands that are left may be longer than the mean.
    std::size_t vertices = 0;
    std::size_t kept = 0;
    for (Fibre& fibre : fibres) {
        if (vertices + 2 * pieces * fibre.segments > 2 * most)
            break;
        fibre.first = vertices;
        vertices += 2 * pieces * fibre.segments;
        ++kept;
    }
    fibres.resize(kept);

    std::vector<FibreVertex> result(vertices);
    const StrandCurves curves(layouts);
    parallelFor(fibres.size(), kFibresPerTask, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Fibre& fibre = fibres[i];
            const float hue = hueOf(tree, index, skeleton.nodes[fibre.tip].internode);
            const auto colourAt = [&](std::uint32_t at, std::uint32_t number) {
                const std::uint32_t count = skeleton.nodes[at].strands;
                const float out = std::min(layouts.place(at, number).norm() / bundleRadius(count), 1.0F);
                const float thick = std::min(static_cast<float>(count - 1) / kThickStrands, 1.0F);
                return colourOf(hue, 1.0F - (1.0F - kInnermost) * thick * (1.0F - out * out));
            };
            FibreVertex* place = result.data() + fibre.first;
            std::uint32_t node = fibre.tip;
            std::uint32_t strand = fibre.strand;
            while (!skeleton.isBase(node)) {
                const StrandCurves::Controls controls = curves.controls(node, strand);
                const std::array<std::uint8_t, 4> colour = colourAt(node, strand);
                for (std::size_t piece = 0; piece < pieces; ++piece) {
                    const auto count = static_cast<float>(pieces);
                    for (const std::size_t stop : {piece, piece + 1}) {
                        const Vec3 point = StrandCurves::point(controls, static_cast<float>(stop) / count);
                        *place++ = {{point.x(), std::max(point.y(), 0.0F), point.z()}, colour};
                    }
                }
                strand += skeleton.nodes[node].offset;
                node = skeleton.nodes[node].parent;
            }
        }
    });
    return result;
}

} // namespace espalier
