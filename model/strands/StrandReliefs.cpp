// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/strands/StrandReliefs.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <utility>

namespace espalier {

namespace {

// All heights are shares of the radius of the wood, at full strength.

/// A ridge below a limb: its height for a limb of all strands, the distance over which it fades by 1/e, in
/// radii of the wood, and the least share of the strands that a limb has.
constexpr float kRidge = 0.95F;
constexpr float kRidgeFade = 14.0F;
constexpr float kLeastLimb = 0.02F;
constexpr float kLeastHeight = 0.004F;
/// Two stems of a fork both count as limbs if the thicker one has less than this share of the strands.
constexpr float kEvenFork = 0.7F;
/// The farthest that a bundle's middle must lie from that of the wood for its ridge to be whole, in radii.
constexpr float kClearSide = 0.45F;
/// Buttresses: their height for the usual flare, up to where they rise, in radii, and how many there are.
constexpr float kButtress = 1.1F;
constexpr float kButtressRadii = 4.5F;
constexpr float kUsualFlare = 0.5F;
constexpr std::size_t kMostButtresses = 7;
/// Bundles at the ground are divided until they have at most this share of the strands.
constexpr float kLargestRoot = 0.22F;
constexpr float kSmallestRoot = 0.015F;
/// Half the width of a buttress, and the least angle between two, rad.
constexpr float kButtressWidth = 0.3F;
constexpr float kButtressGap = 0.65F;
/// Hollows of limbs: the smallest that leaves one and the largest that counts, in radii of the wood; their
/// depth and their height along the wood in radii of the limb; the height of the rim in depths, where it is
/// and how wide, in widths of the hollow; and how far all that reaches.
constexpr float kSmallestHollow = 0.12F;
constexpr float kLargestHollow = 0.7F;
constexpr float kHollow = 2.2F;
constexpr float kHollowHeight = 1.3F;
constexpr float kHollowRim = 0.35F;
constexpr float kHollowRimAt = 1.25F;
constexpr float kHollowRimWidth = 0.35F;
constexpr float kHollowReach = 2.5F;
/// A hollow goes on into branches with at least one of so many strands of the wood below.
constexpr std::uint32_t kStemShare = 4;

/// Bulges are not seen beyond so many of their half widths.
constexpr float kGaussReach = 3.5F;

constexpr float kLowest = -0.45F;
constexpr float kHighest = 0.8F;
/// Strands that are looked at to find the middle of a bundle.
constexpr std::uint32_t kSideSamples = 32;

float gauss(float distance, float width)
{
    const float q = distance / width;
    return std::exp(-0.5F * q * q);
}

/// The difference of two angles, −π...π.
float angleBetween(float a, float b)
{
    return std::remainder(a - b, 2.0F * std::numbers::pi_v<float>);
}

/// Where a bundle lies in a section.
struct BundleSide {
    float angle = 0.0F;
    float clearness = 0.0F; ///< 0 for a bundle in the middle, which has no side, to 1
};

} // namespace

/// Sums up the reliefs of all nodes.
class StrandReliefs::Builder {
public:
    Builder(const ReliefSources& sources, StrandReliefs& reliefs)
        : m_sources(sources),
          m_tree(sources.tree),
          m_index(sources.index),
          m_skeleton(sources.skeleton),
          m_reliefs(reliefs),
          m_strength(static_cast<float>(m_tree.parameters().wood.flutes)),
          m_flare(static_cast<float>(m_tree.parameters().widths.flare))
    {
    }

    void build()
    {
        m_reliefs.m_strength = m_strength;
        for (std::uint32_t node = 0; node < m_skeleton.nodes.size(); ++node)
            addLimbs(node);
        for (const std::uint32_t base : m_skeleton.bases)
            addButtresses(base);
        level();
        addHollows();
        listHollows();
        for (Table& table : m_reliefs.m_ridges.tables) {
            for (float& value : table)
                value = std::clamp(m_strength * value, kLowest, kHighest);
        }
    }

private:
    const StrandNode& at(std::uint32_t node) const { return m_skeleton.nodes[node]; }
    bool isThick(std::uint32_t node) const { return at(node).strands >= kFewestStrands; }

    std::uint32_t thickestOf(std::uint32_t node) const
    {
        return *std::ranges::max_element(m_skeleton.childrenOf(node), {},
                                         [this](std::uint32_t child) { return at(child).strands; });
    }

    /// Distance of a node from the one below it, m.
    float lengthTo(std::uint32_t node) const
    {
        return (at(node).position - at(at(node).parent).position).norm();
    }

    BundleSide sideOf(std::uint32_t node, std::uint32_t first, std::uint32_t count) const
    {
        const std::uint32_t stride = std::max(1U, count / kSideSamples);
        Vec2 sum = Vec2::Zero();
        std::uint32_t taken = 0;
        for (std::uint32_t i = 0; i < count; i += stride, ++taken)
            sum += m_sources.place(node, first + i);
        const Vec2 middle = sum / static_cast<float>(taken);
        const float radius = at(node).radius / m_sources.scales[node];
        return {std::atan2(middle.y(), middle.x()), std::min(1.0F, middle.norm() / (kClearSide * radius))};
    }

    /// Adds a bulge to the section of a node that may have reliefs; @p halfWidth rad.
    void add(std::uint32_t node, float angle, float height, float halfWidth)
    {
        height *= m_sources.roundness(node);
        if (!isThick(node) || height == 0.0F)
            return;
        Table& table = m_reliefs.m_ridges.of(node, m_skeleton.nodes.size());
        constexpr float kStep = 2.0F * std::numbers::pi_v<float> / static_cast<float>(kAngles);
        const int middle = static_cast<int>(std::lround(angle / kStep));
        const int reach =
            std::min(static_cast<int>(kGaussReach * halfWidth / kStep), static_cast<int>(kAngles) / 2 - 1);
        for (int i = middle - reach; i <= middle + reach; ++i) {
            const auto entry = static_cast<std::size_t>(i + 2 * static_cast<int>(kAngles)) % kAngles;
            table[entry] += height * gauss(static_cast<float>(i) * kStep - angle, halfWidth);
        }
    }

    /// Ridges below the limbs that part at a node.
    void addLimbs(std::uint32_t node)
    {
        if (at(node).childCount < 2 || !isThick(node))
            return;
        const auto strands = static_cast<float>(at(node).strands);
        const std::uint32_t thickest = thickestOf(node);
        for (const std::uint32_t child : m_skeleton.childrenOf(node)) {
            const float share = static_cast<float>(at(child).strands) / strands;
            if (share >= kLeastLimb && (child != thickest || share < kEvenFork))
                addRidge(node, at(child).offset, at(child).strands);
        }
    }

    /// The ridge of a bundle, from @p node downward; @p first: its first strand there.
    void addRidge(std::uint32_t node, std::uint32_t first, std::uint32_t count)
    {
        float path = 0.0F;
        while (true) {
            const StrandNode& n = at(node);
            const float width = std::sqrt(static_cast<float>(count) / static_cast<float>(n.strands));
            const float fade = std::exp(-path / (kRidgeFade * std::max(n.radius, 1e-6F)));
            const float most = kRidge * width * fade;
            if (most < kLeastHeight)
                return;
            const BundleSide side = sideOf(node, first, count);
            const float height = most * side.clearness;
            const float half = std::max(0.5F * std::asin(std::min(width, 1.0F)), 0.1F);
            add(node, side.angle, height, half);
            if (m_skeleton.isBase(node))
                return;
            first += n.offset;
            path += lengthTo(node);
            node = n.parent;
        }
    }

    struct Root {
        std::uint32_t first; ///< Of its strands at the base
        std::uint32_t count;
        float weight;
        float angle;
    };

    /// The bundles whose strands come down to a base, the weightiest first, no two at one side.
    std::vector<Root> rootsOf(std::uint32_t base) const
    {
        const auto strands = static_cast<float>(at(base).strands);
        std::vector<Root> bundles;
        struct Open {
            std::uint32_t node;
            std::uint32_t first;
        };
        std::vector<Open> open{{base, 0}};
        while (!open.empty()) {
            const auto [node, first] = open.back();
            open.pop_back();
            const float share = static_cast<float>(at(node).strands) / strands;
            if (share < kSmallestRoot)
                continue;
            if (share > kLargestRoot && at(node).childCount > 0) {
                for (const std::uint32_t child : m_skeleton.childrenOf(node))
                    open.push_back({child, first + at(child).offset});
                continue;
            }
            const BundleSide side = sideOf(base, first, at(node).strands);
            bundles.push_back({first, at(node).strands, std::sqrt(share) * side.clearness, side.angle});
        }
        std::ranges::stable_sort(bundles, std::greater(), &Root::weight);
        std::vector<Root> roots;
        for (const Root& bundle : bundles) {
            const bool isApart = std::ranges::none_of(roots, [&](const Root& root) {
                return std::abs(angleBetween(root.angle, bundle.angle)) < kButtressGap;
            });
            if (isApart && roots.size() < kMostButtresses)
                roots.push_back(bundle);
        }
        return roots;
    }

    void addButtresses(std::uint32_t base)
    {
        // A bundle that is the whole wood has no side.
        const std::vector<Root> roots = rootsOf(base);
        if (roots.size() < 2)
            return;
        const float radius = at(base).radius / (1.0F + m_flare);
        const float end = kButtressRadii * radius;
        float path = 0.0F;
        std::uint32_t passed = 0; // First strand of the node among those of the base
        for (std::uint32_t node = base; path < end;) {
            const float rest = 1.0F - path / end;
            const float full = kButtress * std::min(1.5F, m_flare / kUsualFlare) * rest * rest;
            for (const Root& root : roots) {
                if (root.first < passed || root.first + root.count > passed + at(node).strands)
                    continue; // It has left the trunk further down.
                const float height = full * root.weight / roots.front().weight;
                const float angle = sideOf(node, root.first - passed, root.count).angle;
                add(node, angle, height, kButtressWidth);
            }
            if (at(node).childCount == 0)
                return;
            node = thickestOf(node);
            passed += at(node).offset;
            path += lengthTo(node);
        }
    }

    /// Lowers the valleys by as much as the ridges rise, so that the wood stays as thick in the mean.
    void level()
    {
        for (Table& table : m_reliefs.m_ridges.tables) {
            float mean = 0.0F;
            for (const float value : table)
                mean += value / static_cast<float>(kAngles);
            for (float& value : table)
                value -= mean;
        }
    }

    /// The tips that each dead internode carried when it died; 0 for one that died later than the one below.
    std::vector<std::uint32_t> lostTips() const
    {
        std::vector<std::uint32_t> tips(m_tree.size(), 0);
        const auto& death = m_tree.columns().death;
        for (InternodeId id = m_tree.size(); id-- > 0;) {
            if (m_tree.isAlive(id))
                continue;
            tips[id] = std::max(tips[id], 1U);
            const InternodeId parent = m_tree.parent(id);
            if (parent != kNoInternode && death[parent] == death[id])
                tips[parent] += tips[id];
        }
        return tips;
    }

    void addHollows()
    {
        const std::vector<std::uint32_t> tips = lostTips();
        const auto perTip = static_cast<std::uint32_t>(m_tree.parameters().wood.strandsPerTip);
        std::vector<std::uint32_t> nodeOf; // By internode: its own node
        for (InternodeId id = 0; id < m_tree.size(); ++id) {
            const InternodeId parent = m_tree.parent(id);
            if (tips[id] == 0 || parent == kNoInternode || !m_tree.isAlive(parent))
                continue;
            if (nodeOf.empty()) {
                nodeOf.resize(m_tree.size(), kNone);
                for (std::uint32_t node = 0; node < m_skeleton.nodes.size(); ++node) {
                    if (at(node).along == 1.0F)
                        nodeOf[at(node).internode] = node;
                }
            }
            std::uint32_t node = nodeOf[parent];
            const float along = m_tree.columns().along[id];
            while (at(node).along > along && at(at(node).parent).internode == parent &&
                   !m_skeleton.isBase(node))
                node = at(node).parent;
            if (isThick(node))
                addHollow(node, id, static_cast<float>(tips[id] * perTip));
        }
    }

    void addHollow(std::uint32_t node, InternodeId limb, float strands)
    {
        const float share = std::sqrt(strands / static_cast<float>(at(node).strands));
        if (share < kSmallestHollow)
            return;
        // The index need not know the frames of the dead.
        const Rotation grown = m_index.rotation(m_tree.parent(limb)) * m_tree.columns().rotation[limb];
        const Vec3 heading = at(node).frame.conjugate() * (grown * up());
        if (Vec2(heading.x(), heading.z()).norm() < 0.15F)
            return; // It went on in the direction of the wood, which has closed over it.
        if (m_sources.roundness(node) == 0.0F)
            return;
        const float radius = std::min(share, kLargestHollow) * at(node).radius;
        const Vec3 outward = grown * up();
        cut(node, outward, 0.0F, radius);
        const float reach = kHollowReach * kHollowHeight * radius;
        float path = 0.0F;
        for (std::uint32_t place = node; !m_skeleton.isBase(place);) {
            path += lengthTo(place);
            place = at(place).parent;
            if (path > reach)
                break;
            cut(place, outward, path, radius);
        }
        cutAbove(node, outward, 0.0F, radius);
    }

    /// Notes a hollow whose middle is @p path above @p place, m.
    void cut(std::uint32_t place, const Vec3& outward, float path, float radius)
    {
        const auto shareAt = [&](std::uint32_t n) { return isThick(n) ? m_sources.roundness(n) : 0.0F; };
        const float atNode = shareAt(place);
        const float atBelow = shareAt(at(place).parent);
        if (atNode == 0.0F && atBelow == 0.0F)
            return;
        const Vec3 local = at(place).frame.conjugate() * outward;
        m_found.emplace_back(place, Hollow{.angle = std::atan2(local.z(), local.x()),
                                           .path = path,
                                           .radius = radius,
                                           .atBelow = atBelow,
                                           .atNode = atNode});
    }

    /// The same in the stems above @p node; cross-sections belong to the node above them.
    void cutAbove(std::uint32_t node, const Vec3& outward, float path, float radius)
    {
        if (path > kHollowReach * kHollowHeight * radius)
            return;
        for (const std::uint32_t child : m_skeleton.childrenOf(node)) {
            if (kStemShare * at(child).strands < at(node).strands)
                continue;
            const float above = path + lengthTo(child);
            cut(child, outward, -above, radius);
            cutAbove(child, outward, above, radius);
        }
    }

    /// Sorts the hollows by node.
    void listHollows()
    {
        if (m_found.empty())
            return;
        std::ranges::stable_sort(m_found, {}, &std::pair<std::uint32_t, Hollow>::first);
        m_reliefs.m_firstHollows.assign(m_skeleton.nodes.size() + 1, 0);
        for (const auto& [node, hollow] : m_found) {
            m_reliefs.m_hollows.push_back(hollow);
            ++m_reliefs.m_firstHollows[node + 1];
        }
        std::partial_sum(m_reliefs.m_firstHollows.begin(), m_reliefs.m_firstHollows.end(),
                         m_reliefs.m_firstHollows.begin());
    }

    const ReliefSources& m_sources;
    const Tree& m_tree;
    const TreeIndex& m_index;
    const StrandSkeleton& m_skeleton;
    StrandReliefs& m_reliefs;
    std::vector<std::pair<std::uint32_t, Hollow>> m_found; ///< With the nodes that they are near to
    float m_strength;
    float m_flare;
};

StrandReliefs::StrandReliefs(const ReliefSources& sources)
{
    if (sources.tree.parameters().wood.flutes > 0.0)
        Builder(sources, *this).build();
}

StrandReliefs::Table& StrandReliefs::Layer::of(std::uint32_t node, std::size_t nodes)
{
    if (tableOf.empty())
        tableOf.resize(nodes, kNone);
    if (tableOf[node] == kNone) {
        tableOf[node] = static_cast<std::uint32_t>(tables.size());
        tables.emplace_back().fill(0.0F);
    }
    return tables[tableOf[node]];
}

float StrandReliefs::depth(std::uint32_t node, const Between& between, float angle) const
{
    const float path = (between.t - 1.0F) * between.length;
    float sum = 0.0F;
    for (std::uint32_t i = m_firstHollows[node]; i < m_firstHollows[node + 1]; ++i) {
        const Hollow& hollow = m_hollows[i];
        const float width = hollow.radius / std::max(between.radius, 1e-6F); // rad
        const float aside = angleBetween(angle, hollow.angle) / width;
        const float along = (path - hollow.path) / (kHollowHeight * hollow.radius);
        const float q2 = aside * aside + along * along;
        if (q2 > kHollowReach * kHollowReach)
            continue;
        const float share = hollow.atBelow + between.t * (hollow.atNode - hollow.atBelow);
        sum += share * std::min(m_strength * kHollow * width, -kLowest) *
               (kHollowRim * gauss(std::sqrt(q2) - kHollowRimAt, kHollowRimWidth) - std::exp(-q2 * q2));
    }
    return std::max(sum, kLowest);
}

void StrandReliefs::addTo(ContentHash& hash, std::uint32_t node) const
{
    hash.addAll(m_ridges.around(node));
    if (!hasHollow(node))
        return;
    hash.add(m_strength);
    for (std::uint32_t i = m_firstHollows[node]; i < m_firstHollows[node + 1]; ++i) {
        const auto& [angle, path, radius, atBelow, atNode] = m_hollows[i];
        for (const float number : {angle, path, radius, atBelow, atNode})
            hash.add(number);
    }
}

} // namespace espalier
