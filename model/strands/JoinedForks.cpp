// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/strands/JoinedForks.h"

#include "model/strands/HexLattice.h"

#include <algorithm>

namespace espalier {

namespace {

/// A branch parts at once if its fork has more than so many times its strands.
constexpr std::uint32_t kMostTimesItsStrands = 8;
/// Of the way along each branch, this share leads along the wood below; a branch that turns aside parts.
constexpr float kLeastAscent = 0.5F;
/// Wood of fewer strands separates as if it had so many.
constexpr std::uint32_t kManyStrands = 80;
/// Nodes of a joined bundle are at least this share of its radius apart.
constexpr float kLeastGap = 0.02F;

/// A branch from its fork along its thickest children.
struct BranchLine {
    std::vector<std::uint32_t> nodes;
    std::vector<float> paths;    ///< m, from the fork; of the fork itself first, so one more than nodes
    std::vector<Vec3> positions; ///< Likewise
    std::size_t joined = 0;      ///< So many of its nodes belong to the bundle

    Vec3 at(float path) const
    {
        std::size_t i = 1;
        while (i + 1 < paths.size() && paths[i] < path)
            ++i;
        const float length = paths[i] - paths[i - 1];
        const float t = length > 0.0F ? std::clamp((path - paths[i - 1]) / length, 0.0F, 1.0F) : 0.0F;
        return positions[i - 1] + t * (positions[i] - positions[i - 1]);
    }
    float length() const { return paths.back(); }
    std::size_t indexAt(float path) const
    {
        std::size_t i = 0;
        while (i + 1 < nodes.size() && paths[i + 1] < path)
            ++i;
        return i;
    }
};

class ForkJoiner {
public:
    ForkJoiner(StrandSkeleton& skeleton, const WoodParameters& wood)
        : m_skeleton(skeleton),
          m_nodes(skeleton.nodes),
          m_wood(wood),
          m_children(skeleton.nodes.size()),
          m_isParting(skeleton.nodes.size(), false)
    {
        m_strands.assign(m_nodes.size(), 0);
        for (auto i = static_cast<std::uint32_t>(m_nodes.size()); i-- > 0;) {
            if (m_strands[i] == 0)
                m_strands[i] = static_cast<std::uint32_t>(wood.strandsPerTip);
            if (m_nodes[i].parent != i)
                m_strands[m_nodes[i].parent] += m_strands[i];
        }
        for (std::uint32_t i = 0; i < m_nodes.size(); ++i) {
            if (m_nodes[i].parent != i)
                m_children[m_nodes[i].parent].push_back(i);
        }
    }

    void join()
    {
        std::vector<std::uint32_t> order;
        order.reserve(m_nodes.size());
        std::vector<std::uint32_t> open(m_skeleton.bases.rbegin(), m_skeleton.bases.rend());
        bool isChanged = false;
        while (!open.empty()) {
            const std::uint32_t node = open.back();
            open.pop_back();
            order.push_back(node);
            isChanged = joinAt(node) || isChanged;
            open.insert(open.end(), m_children[node].rbegin(), m_children[node].rend());
        }
        if (isChanged)
            renumber(order);
    }

private:
    std::uint32_t thickestChild(std::uint32_t node) const
    {
        return *std::ranges::max_element(m_children[node], {},
                                         [&](std::uint32_t child) { return m_strands[child]; });
    }

    /// Length of a strand radius at a node, m: of one of many. In radii of few thick strands, α would join
    /// the twigs of a seedling as by webs.
    float scaleAt(std::uint32_t node) const
    {
        if (m_wood.strandRadius > 0.0)
            return static_cast<float>(m_wood.strandRadius);
        return m_nodes[node].radius / bundleRadius(std::max(m_strands[node], kManyStrands));
    }

    bool joinAt(std::uint32_t node)
    {
        bool isChanged = false;
        if (m_isParting[node])
            return false;
        // The thickest branch with the next one, what they join with the third, and so on.
        std::vector<std::uint32_t> branches = m_children[node];
        std::ranges::stable_sort(branches, std::greater(),
                                 [&](std::uint32_t child) { return m_strands[child]; });
        for (std::size_t i = 1; i < branches.size(); ++i) {
            if (kMostTimesItsStrands * m_strands[branches[i]] < m_strands[node])
                break;
            if (joinTwo(node, branches.front(), branches[i])) {
                branches.front() = m_children[node].front();
                isChanged = true;
            }
        }
        return isChanged;
    }

    BranchLine lineFrom(std::uint32_t fork, std::uint32_t branch, float reach) const
    {
        BranchLine line;
        line.paths.push_back(0.0F);
        line.positions.push_back(m_nodes[fork].position);
        for (std::uint32_t node = branch;; node = thickestChild(node)) {
            line.nodes.push_back(node);
            line.paths.push_back(line.paths.back() + (m_nodes[node].position - line.positions.back()).norm());
            line.positions.push_back(m_nodes[node].position);
            if (line.paths.back() > reach || m_children[node].empty())
                return line;
        }
    }

    bool joinTwo(std::uint32_t fork, std::uint32_t first, std::uint32_t second)
    {
        const float gap = (static_cast<float>(m_wood.alpha) - 2.0F) * scaleAt(fork);
        // Branches that diverge by less over a longer way run beside each other.
        const float reach = 4.0F * (gap + m_nodes[fork].radius);
        BranchLine a = lineFrom(fork, first, reach);
        BranchLine b = lineFrom(fork, second, reach);
        const Vec3 forward =
            a.at(m_nodes[fork].radius) + b.at(m_nodes[fork].radius) - 2.0F * m_nodes[fork].position;
        if (forward.squaredNorm() <= 0.0F)
            return false;
        const auto staysAt = [&](float path) {
            const Vec3 pa = a.at(path) - m_nodes[fork].position;
            const Vec3 pb = b.at(path) - m_nodes[fork].position;
            const float least = kLeastAscent * path * forward.norm();
            return (pa - pb).norm() <= gap && pa.dot(forward) >= least && pb.dot(forward) >= least;
        };
        struct Step {
            std::uint32_t node;
            float path;
        };
        std::vector<Step> steps;
        const float end = std::min({a.length(), b.length(), reach});
        while (a.joined < a.nodes.size() && b.joined < b.nodes.size()) {
            const float pathA = a.paths[a.joined + 1];
            const float pathB = b.paths[b.joined + 1];
            const bool takesA = pathA <= pathB;
            const float path = takesA ? pathA : pathB;
            // Both go on above.
            if (path >= end || !staysAt(path))
                break;
            BranchLine& line = takesA ? a : b;
            steps.push_back({line.nodes[line.joined++], path});
        }
        if (steps.empty())
            return false;
        placeSteps(fork, a, b, steps);
        relink(fork, a, b, steps);
        return true;
    }

    template <class Steps>
    void placeSteps(std::uint32_t fork, const BranchLine& a, const BranchLine& b, const Steps& steps)
    {
        struct Place {
            Vec3 position;
            float radius;
            std::uint32_t strands;
        };
        std::vector<Place> places;
        float path = 0.0F;
        for (const auto& step : steps) {
            path = std::max(step.path, path + kLeastGap * m_nodes[fork].radius);
            const std::uint32_t na = a.nodes[a.indexAt(step.path)];
            const std::uint32_t nb = b.nodes[b.indexAt(step.path)];
            // By the thickness and not by the strands, so that a twig that is pruned further up moves
            // nothing.
            const float wa = m_nodes[na].radius * m_nodes[na].radius;
            const float wb = m_nodes[nb].radius * m_nodes[nb].radius;
            const float share = wa + wb > 0.0F ? wa / (wa + wb) : 0.5F;
            places.push_back({Vec3(share * a.at(path) + (1.0F - share) * b.at(path)),
                              std::hypot(m_nodes[na].radius, m_nodes[nb].radius),
                              m_strands[na] + m_strands[nb]});
        }
        for (std::size_t i = 0; i < steps.size(); ++i) {
            StrandNode& node = m_nodes[steps[i].node];
            node.position = places[i].position;
            node.radius = std::max(node.radius, std::min(places[i].radius, m_nodes[fork].radius));
            m_strands[steps[i].node] = places[i].strands;
        }
    }

    template <class Steps>
    void relink(std::uint32_t fork, const BranchLine& a, const BranchLine& b, const Steps& steps)
    {
        for (const BranchLine* line : {&a, &b}) {
            std::uint32_t below = fork;
            for (std::size_t i = 0; i <= line->joined && i < line->nodes.size(); ++i) {
                std::erase(m_children[below], line->nodes[i]);
                below = line->nodes[i];
            }
        }
        std::uint32_t below = fork;
        for (const auto& step : steps) {
            m_nodes[step.node].parent = below;
            m_children[below].insert(m_children[below].begin(), step.node);
            below = step.node;
        }
        m_isParting[below] = true;
        for (const BranchLine* line : {&b, &a}) {
            const std::uint32_t next = line->nodes[line->joined];
            m_nodes[next].parent = below;
            m_children[below].insert(m_children[below].begin(), next);
        }
    }

    /// Makes @p order the order of the nodes.
    void renumber(const std::vector<std::uint32_t>& order)
    {
        std::vector<std::uint32_t> numbers(m_nodes.size());
        for (std::uint32_t i = 0; i < order.size(); ++i)
            numbers[order[i]] = i;
        std::vector<StrandNode> nodes;
        nodes.reserve(order.size());
        for (const std::uint32_t node : order) {
            nodes.push_back(m_nodes[node]);
            nodes.back().parent = numbers[nodes.back().parent];
        }
        m_nodes = std::move(nodes);
        for (std::uint32_t& base : m_skeleton.bases)
            base = numbers[base];
    }

    StrandSkeleton& m_skeleton;
    std::vector<StrandNode>& m_nodes;
    const WoodParameters& m_wood;
    std::vector<std::vector<std::uint32_t>> m_children;
    std::vector<std::uint32_t> m_strands;
    std::vector<bool> m_isParting; ///< Whether two branches part at a node that were joined below it
};

} // namespace

void joinForks(StrandSkeleton& skeleton, const WoodParameters& wood)
{
    ForkJoiner(skeleton, wood).join();
}

} // namespace espalier
