// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/StrandTubes.h"

#include "model/base/Parallel.h"
#include "model/mesh/LoopThinning.h"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>

namespace espalier {

namespace {

/// Bundles of fewer strands get a ring.
constexpr std::uint32_t kFewStrands = 7;
constexpr int kFewestRingSides = 5;
constexpr int kMostRingSides = 32;
constexpr int kMostSteps = 5;
/// Forks of fewer strands get fewer cross-sections.
constexpr std::uint32_t kManyStrands = 50;
/// Strands that stray from one part to another are no tube if they are fewer than this share of either part.
constexpr float kLeastShare = 0.08F;
/// The curve may be missed by this many tolerances.
constexpr float kCurveSlack = 5.0F;
constexpr std::size_t kPlansPerTask = 64;

int sidesOf(float radius, double tolerance)
{
    const double cosine = 1.0 - tolerance / std::max(double{radius}, tolerance);
    return std::clamp(static_cast<int>(std::ceil(std::numbers::pi / std::acos(cosine))), kFewestRingSides,
                      kMostRingSides);
}

class TubeFinder {
public:
    TubeFinder(const StrandLayouts& layouts, const WoodParameters& wood, const WoodMeshOptions& options,
               const StrandReuse& reuse, const StrandTubes* last, WorkProgress& progress, StrandTubes& result)
        : m_layouts(layouts),
          m_skeleton(layouts.skeleton()),
          m_alpha(static_cast<float>(wood.alpha)),
          m_tolerance(std::max(options.tolerance, WoodMeshOptions::kFinest)),
          m_reuse(reuse),
          m_progress(progress),
          m_last(last),
          m_thinning(static_cast<float>(options.tolerance - WoodMeshOptions{}.tolerance)),
          m_result(result),
          m_divides(layouts.skeleton().nodes.size(), 0),
          m_sections(layouts.skeleton().nodes.size())
    {
    }

    void find()
    {
        m_result.nodes.resize(m_skeleton.nodes.size());
        forEachNode([this](std::uint32_t node) { m_divides[node] = isDividedAnew(node) ? 1 : 0; });
        forEachNode([this](std::uint32_t node) { begin(node); });
        const auto forEachDivided = [this](auto&& work) {
            forEachNode([&](std::uint32_t node) {
                if (m_divides[node] != 0)
                    work(node);
            });
        };
        WorkCount divided(m_progress, static_cast<std::size_t>(std::ranges::count(m_divides, 1)));
        forEachDivided([&](std::uint32_t node) {
            divide(node);
            divided.add(1);
        });
        forEachDivided([this](std::uint32_t node) { chooseSteps(node); });
        if (m_thinning > 0.0F)
            forEachNode([this](std::uint32_t node) { thin(node); });
    }

private:
    struct Scratch {
        NodeSection section;
        std::uint32_t sectionNode = NodeSection::kNoPart; ///< Whose section that is
        std::vector<std::uint32_t> labels;
        std::vector<float> gaps;
    };

    template <class Work>
    void forEachNode(Work&& work)
    {
        parallelFor(m_skeleton.nodes.size(), kPlansPerTask, [&](std::size_t begin, std::size_t end) {
            if (m_progress.isCancelled())
                return;
            for (std::size_t i = begin; i < end; ++i)
                work(static_cast<std::uint32_t>(i));
        });
    }

    bool isTaken(std::uint32_t node) const { return m_reuse.has(node, StrandReach::Positions); }
    /// Whether the tubes above a node are found: those of all its children, since they are found together.
    bool isDividedAnew(std::uint32_t node) const
    {
        return !isTaken(node) || !std::ranges::all_of(m_skeleton.childrenOf(node),
                                                      [&](std::uint32_t child) { return isTaken(child); });
    }
    bool isBelowDividedAnew(std::uint32_t node) const
    {
        return !m_skeleton.isBase(node) && m_divides[m_skeleton.nodes[node].parent] != 0;
    }

    /// Takes a node over from the last mesh, or finds its outline.
    void begin(std::uint32_t node)
    {
        StrandTubes::Node& n = m_result.nodes[node];
        const bool hasTubes = isBelowDividedAnew(node);
        if ((m_divides[node] != 0 || hasTubes) && m_layouts.strandCount(node) >= kFewStrands &&
            !m_layouts.isDisc(node)) {
            m_sections[node] = std::make_unique<NodeSection>();
            m_sections[node]->set(m_layouts, node, m_alpha);
        }
        if (!isTaken(node)) {
            outline(node);
            return;
        }
        n = m_last->nodes[m_reuse.before(node)];
        if (hasTubes) {
            n.tubes.clear();
            n.continuesBelow = true;
        }
        if (m_divides[node] != 0) {
            n.continuesAbove = true;
            n.joined = 0;
        }
    }

    /// The section of a node: kept if it is triangulated, else made anew.
    const NodeSection& section(std::uint32_t node)
    {
        if (m_sections[node])
            return *m_sections[node];
        Scratch& scratch = m_scratch.local();
        if (scratch.sectionNode != node) {
            scratch.section.set(m_layouts, node, m_alpha);
            scratch.sectionNode = node;
        }
        return scratch.section;
    }

    void outline(std::uint32_t node)
    {
        StrandTubes::Node& n = m_result.nodes[node];
        n.ringSides = sidesOf(m_skeleton.nodes[node].radius, m_tolerance);
        if (m_layouts.strandCount(node) < kFewStrands)
            return;
        n.whole.loops = section(node).outline();
        // Cavities end at the ground.
        if (m_skeleton.isBase(node))
            std::erase_if(n.whole.loops, &SectionLoop::isCavity);
    }

    std::uint32_t partOf(std::uint32_t node, std::uint32_t strand) const
    {
        if (!m_sections[node] || m_sections[node]->parts().empty())
            return 0;
        return m_sections[node]->parts()[strand];
    }
    std::uint32_t partCount(std::uint32_t node) const
    {
        return m_sections[node] ? std::max(1U, m_sections[node]->partCount()) : 1;
    }

    /// Finds the tubes from a node to its children.
    void divide(std::uint32_t node)
    {
        const auto children = m_skeleton.childrenOf(node);
        if (children.empty())
            return;
        Scratch& scratch = m_scratch.local();
        std::vector<std::uint32_t>& labels = scratch.labels;
        labels.assign(m_layouts.strandCount(node), NodeSection::kNoPart);
        struct Piece {
            std::uint32_t child;
            std::uint32_t lowerPart;
            std::uint32_t upperPart;
            std::uint32_t count = 0;
        };
        std::vector<Piece> pieces;
        for (const std::uint32_t child : children) {
            const StrandNode& c = m_skeleton.nodes[child];
            if (partCount(node) == 1 && partCount(child) == 1) {
                std::fill_n(labels.begin() + c.offset, c.strands, static_cast<std::uint32_t>(pieces.size()));
                pieces.push_back({child, 0, 0, c.strands});
                continue;
            }
            std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> numbers;
            const auto first = static_cast<std::uint32_t>(pieces.size());
            for (std::uint32_t strand = 0; strand < c.strands; ++strand) {
                const std::uint32_t lower = partOf(node, c.offset + strand);
                const std::uint32_t upper = partOf(child, strand);
                if (lower == NodeSection::kNoPart || upper == NodeSection::kNoPart)
                    continue;
                const auto [found, isNew] =
                    numbers.try_emplace({lower, upper}, static_cast<std::uint32_t>(pieces.size()));
                if (isNew)
                    pieces.push_back({child, lower, upper, 0});
                labels[c.offset + strand] = found->second;
                ++pieces[found->second].count;
            }
            if (pieces.size() == first) {
                std::fill_n(labels.begin() + c.offset, c.strands, first);
                pieces.push_back({child, 0, 0, c.strands});
            }
        }
        // A stray piece is no tube; but each upper part needs the largest of its pieces.
        std::vector<bool> isKept(pieces.size(), true);
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            std::uint32_t lower = 0;
            std::uint32_t upper = 0;
            bool isLargest = true;
            for (std::size_t j = 0; j < pieces.size(); ++j) {
                if (pieces[j].child != pieces[i].child)
                    continue;
                if (pieces[j].lowerPart == pieces[i].lowerPart)
                    lower += pieces[j].count;
                if (pieces[j].upperPart != pieces[i].upperPart)
                    continue;
                upper += pieces[j].count;
                isLargest = isLargest && (pieces[j].count < pieces[i].count ||
                                          (pieces[j].count == pieces[i].count && j >= i));
            }
            isKept[i] = isLargest || (pieces[i].count >= kFewStrands &&
                                      static_cast<float>(pieces[i].count) >=
                                          kLeastShare * static_cast<float>(std::min(lower, upper)));
        }
        std::size_t kept = 0;
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            if (!isKept[i])
                continue;
            ++kept;
            const Piece& piece = pieces[i];
            addTube(node, piece.child, static_cast<std::uint32_t>(i), piece.count, pieces.size() == 1);
        }
        m_result.nodes[node].continuesAbove = kept == 1 && outerLoops(m_result.nodes[node].whole) == 1;
        for (const std::uint32_t child : children)
            completeAbove(child, labels);
        if (m_result.nodes[node].continuesAbove) {
            for (const std::uint32_t child : children) {
                for (StrandTube& tube : m_result.nodes[child].tubes)
                    tube.below = m_result.nodes[node].whole;
            }
        }
        for (const std::uint32_t child : children)
            dropEndingCavities(child);
    }

    static std::size_t outerLoops(const BundleOutline& outline)
    {
        if (outline.isRing())
            return 1;
        return static_cast<std::size_t>(
            std::ranges::count_if(outline.loops, [](const SectionLoop& loop) { return !loop.isCavity(); }));
    }

    /// Keeps the largest loop around wood, with the cavities if @p cavities.
    static void keepLargest(std::vector<SectionLoop>& loops, bool cavities)
    {
        const auto largest = std::ranges::max_element(loops, {}, &SectionLoop::area);
        if (largest == loops.end() || largest->isCavity()) {
            loops.clear();
            return;
        }
        std::rotate(loops.begin(), largest, largest + 1);
        const auto rest = std::remove_if(loops.begin() + 1, loops.end(), [&](const SectionLoop& loop) {
            return !cavities || !loop.isCavity();
        });
        loops.erase(rest, loops.end());
    }

    void addTube(std::uint32_t node, std::uint32_t child, std::uint32_t label, std::uint32_t count,
                 bool isAll)
    {
        const StrandNode& c = m_skeleton.nodes[child];
        StrandTube& tube = m_result.nodes[child].tubes.emplace_back();
        const std::vector<std::uint32_t>& labels = m_scratch.local().labels;
        if (count < c.strands) {
            for (std::uint32_t strand = 0; strand < c.strands; ++strand) {
                if (labels[c.offset + strand] == label)
                    tube.strands.push_back(strand);
            }
        }
        const float radius = count == c.strands ? c.radius : m_layouts.scale(child) * bundleRadius(count);
        tube.sides = sidesOf(radius, m_tolerance);
        if (count < kFewStrands)
            return;
        if (isAll && m_result.nodes[node].whole.loops.size() == 1) {
            tube.below = m_result.nodes[node].whole;
            return;
        }
        tube.below.loops = section(node).boundary(labels, label);
        keepLargest(tube.below.loops, !m_layouts.isDisc(node));
        for (SectionLoop& loop : tube.below.loops) {
            for (std::uint32_t& strand : loop.strands)
                strand -= c.offset;
        }
    }

    /// Finds the outlines of the tubes to @p child in its own section.
    void completeAbove(std::uint32_t child, std::span<const std::uint32_t> labels)
    {
        StrandTubes::Node& n = m_result.nodes[child];
        const StrandNode& c = m_skeleton.nodes[child];
        const bool isWhole = n.tubes.size() == 1 && outerLoops(n.whole) == 1;
        n.continuesBelow = isWhole;
        for (StrandTube& tube : n.tubes) {
            if (isWhole) {
                tube.above = n.whole;
            } else {
                const std::uint32_t some = tube.strands.empty() ? 0 : tube.strands.front();
                tube.above.loops =
                    section(child).boundary(labels.subspan(c.offset, c.strands), labels[c.offset + some]);
                keepLargest(tube.above.loops, true);
            }
            if (tube.below.isRing())
                tube.below = tube.above;
            else if (tube.above.isRing() && !isWhole)
                tube.above = tube.below;
        }
    }

    static bool endsCavity(const StrandTube& tube)
    {
        if (tube.below.loops.size() < 2 && tube.above.loops.size() < 2)
            return false; // Only their outer loops
        const auto goOn = cavitiesThatGoOn(tube);
        return std::ranges::any_of(
            goOn, [](const std::vector<bool>& end) { return std::ranges::find(end, false) != end.end(); });
    }

    /// Takes the cavities out of the patches at the ends of the tubes to @p child that end right there: the
    /// triangles which would close them could have an edge in common with those of the patch.
    void dropEndingCavities(std::uint32_t child)
    {
        StrandTubes::Node& n = m_result.nodes[child];
        const bool isPatchedBelow = !m_result.nodes[m_skeleton.nodes[child].parent].continuesAbove;
        for (StrandTube& tube : n.tubes) {
            if (!endsCavity(tube))
                continue;
            const auto [below, above] = cavitiesThatGoOn(tube);
            if (isPatchedBelow)
                keepLoops(tube.below.loops, below);
            if (!n.continuesBelow)
                keepLoops(tube.above.loops, above);
        }
    }

    /// The loops at the two ends of a tube that do not end between them.
    static std::array<std::vector<bool>, 2> cavitiesThatGoOn(const StrandTube& tube)
    {
        std::array<std::vector<bool>, 2> goOn{std::vector<bool>(tube.below.loops.size()),
                                              std::vector<bool>(tube.above.loops.size())};
        std::array<std::vector<std::span<const std::uint32_t>>, 2> ends;
        std::array<std::vector<std::size_t>, 2> numbers; // Of those loops
        const auto collect = [&](std::size_t end, const BundleOutline& outline) {
            for (std::size_t i = 0; i < outline.loops.size(); ++i) {
                goOn[end][i] = !outline.loops[i].isCavity();
                if (!goOn[end][i]) {
                    ends[end].emplace_back(outline.loops[i].strands);
                    numbers[end].push_back(i);
                }
            }
        };
        collect(0, tube.below);
        collect(1, tube.above);
        const std::vector<std::size_t> matches = matchCavities(ends[0], ends[1]);
        for (std::size_t i = 0; i < matches.size(); ++i) {
            if (matches[i] == kNoCavity)
                continue;
            goOn[0][numbers[0][i]] = true;
            goOn[1][numbers[1][matches[i]]] = true;
        }
        return goOn;
    }

    static void keepLoops(std::vector<SectionLoop>& loops, const std::vector<bool>& isKept)
    {
        std::size_t kept = 0;
        for (std::size_t i = 0; i < loops.size(); ++i) {
            if (isKept[i])
                std::swap(loops[kept++], loops[i]);
        }
        loops.resize(kept);
    }

    void chooseSteps(std::uint32_t node)
    {
        const auto children = m_skeleton.childrenOf(node);
        int steps = 1;
        for (const std::uint32_t child : children)
            steps = std::max(steps, stepsTo(child));
        // Two patches on one outline, or a patch and the end of a cavity, could share an edge across it: then
        // it has two sections.
        StrandTubes::Node& n = m_result.nodes[node];
        const bool isPatchedBelow = !n.continuesBelow || m_skeleton.isBase(node);
        const bool isDoubled = !children.empty() && !n.continuesAbove &&
                               (isPatchedBelow || std::ranges::any_of(n.tubes, [](const StrandTube& t) {
                                    return endsCavity(t);
                                }));
        const bool endsCavityAbove =
            n.continuesAbove && isPatchedBelow && std::ranges::any_of(children, [&](std::uint32_t child) {
                return std::ranges::any_of(m_result.nodes[child].tubes,
                                           [](const StrandTube& tube) { return endsCavity(tube); });
            });
        if (isDoubled || endsCavityAbove)
            steps = std::max(steps, 3);
        // So has a tube between two patches.
        const bool isBetween = !n.continuesAbove && std::ranges::any_of(children, [&](std::uint32_t child) {
            return !m_result.nodes[child].continuesBelow;
        });
        if (isBetween)
            steps = std::max(steps, kMostSteps);
        for (const std::uint32_t child : children)
            m_result.nodes[child].steps = steps;
        n.joined = std::max(joinedSteps(node, steps), isDoubled ? 1 : 0);
        if (isBetween)
            n.joined = std::min(n.joined, kMostSteps - 3);
    }

    int stepsTo(std::uint32_t child) const
    {
        if (m_layouts.reliefs().hasHollow(child))
            return kMostSteps;
        const StrandNode& upper = m_skeleton.nodes[child];
        const StrandNode& lower = m_skeleton.nodes[upper.parent];
        const StrandTubes::Node& n = m_result.nodes[child];
        const float length = (m_layouts.centre(child) - m_layouts.centre(upper.parent)).norm();
        const float bend = ((upper.frame * up()) - (lower.frame * up())).norm();
        const float rings = std::sqrt(length * bend / (8.0F * kCurveSlack * static_cast<float>(m_tolerance)));
        int least = 1;
        const bool isFork = !m_result.nodes[upper.parent].continuesAbove;
        if (isFork)
            least = lower.strands >= kManyStrands ? kMostSteps : lower.strands >= kFewStrands ? 3 : 2;
        if (!n.continuesBelow)
            least = std::max(least, 3);
        for (const StrandTube& tube : n.tubes) {
            if (!tube.below.isRing() && !tube.above.isRing() && !haveEqualLoops(tube))
                least = std::max(least, 2);
        }
        return std::max(least, static_cast<int>(std::ceil(std::clamp(rings, 1.0F, float{kMostSteps}))));
    }

    void thin(std::uint32_t node)
    {
        StrandTubes::Node& n = m_result.nodes[node];
        const StrandNode& upper = m_skeleton.nodes[node];
        thin(n.whole, node, 0);
        for (StrandTube& tube : n.tubes) {
            thin(tube.below, upper.parent, upper.offset);
            thin(tube.above, node, 0);
        }
    }
    /// @p offset: of the outline's strands among those of @p node.
    void thin(BundleOutline& outline, std::uint32_t node, std::uint32_t offset) const
    {
        const std::span<const Vec2> places = m_layouts.places(node).subspan(offset);
        std::vector<Vec2> points;
        for (SectionLoop& loop : outline.loops) {
            // The ends of cavities are triangles across them, which need room beside those of a fork.
            if (loop.isCavity())
                continue;
            points.clear();
            for (const std::uint32_t strand : loop.strands)
                points.push_back(places[strand]);
            std::size_t count = 0;
            for (const std::uint32_t kept : thinLoop(points, m_thinning / m_layouts.scale(node)))
                loop.strands[count++] = loop.strands[kept];
            loop.strands.resize(count);
        }
    }

    static bool haveEqualLoops(const StrandTube& tube)
    {
        return std::ranges::equal(tube.below.loops, tube.above.loops, {}, &SectionLoop::strands,
                                  &SectionLoop::strands);
    }

    /// The number of cross-sections above a fork in which the gap between its branches is below α.
    int joinedSteps(std::uint32_t node, int steps)
    {
        const auto children = m_skeleton.childrenOf(node);
        const StrandTubes::Node& n = m_result.nodes[node];
        if (children.size() < 2 || steps < 3 || n.whole.isRing() || n.continuesAbove)
            return 0;
        Scratch& scratch = m_scratch.local();
        scratch.labels.assign(m_layouts.strandCount(node), 0);
        for (std::uint32_t i = 0; i < children.size(); ++i) {
            const StrandNode& c = m_skeleton.nodes[children[i]];
            std::fill_n(scratch.labels.begin() + c.offset, c.strands, i);
        }
        const std::vector<std::uint32_t>& labels = scratch.labels;
        const NodeSection& seams = section(node);
        for (int step = 1; step <= steps - 2; ++step) {
            const float t = static_cast<float>(step) / static_cast<float>(steps);
            scratch.gaps.clear();
            seams.forEachSeam(labels, [&](std::uint32_t a, std::uint32_t b) {
                const auto place = [&](std::uint32_t strand) {
                    const std::uint32_t child = children[labels[strand]];
                    const Vec3 low = m_layouts.world(node, m_layouts.place(node, strand));
                    const Vec3 high = m_layouts.world(
                        child, m_layouts.place(child, strand - m_skeleton.nodes[child].offset));
                    return Vec3(low + t * (high - low));
                };
                scratch.gaps.push_back((place(a) - place(b)).norm() / m_layouts.scale(node));
            });
            if (scratch.gaps.empty())
                return 0;
            const auto quarter = scratch.gaps.begin() + static_cast<std::ptrdiff_t>(scratch.gaps.size() / 4);
            std::ranges::nth_element(scratch.gaps, quarter);
            if (*quarter > m_alpha)
                return step - 1;
        }
        return steps - 2;
    }

    const StrandLayouts& m_layouts;
    const StrandSkeleton& m_skeleton;
    float m_alpha;
    double m_tolerance;
    const StrandReuse& m_reuse;
    WorkProgress& m_progress;
    const StrandTubes* m_last;
    float m_thinning; ///< Tolerance of the outlines, m: where it is above 0, some strands are left out
    StrandTubes& m_result;
    std::vector<std::uint8_t> m_divides;                  ///< By node: whether the tubes above it are found
    std::vector<std::unique_ptr<NodeSection>> m_sections; ///< Those that are triangulated
    tbb::enumerable_thread_specific<Scratch> m_scratch;
};

} // namespace

StrandTubes strandTubes(const StrandLayouts& layouts, const WoodParameters& wood,
                        const WoodMeshOptions& options, const StrandReuse& reuse, const StrandTubes* last,
                        WorkProgress& progress)
{
    StrandTubes tubes;
    TubeFinder(layouts, wood, options, reuse, last, progress, tubes).find();
    return tubes;
}

} // namespace espalier
