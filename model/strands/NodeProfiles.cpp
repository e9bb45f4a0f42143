// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/strands/NodeProfiles.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace espalier {

namespace {

/// A profile fades over this many radii of the wood.
constexpr float kFadeRadii = 2.0F;
constexpr int kCirclePoints = 64;

/// A circle of the profile's area around the node.
StrandProfile roundLike(const StrandProfile& profile)
{
    const float radius = std::sqrt(areaOf(profile) / std::numbers::pi_v<float>);
    StrandProfile::Loop circle;
    for (int i = 0; i < kCirclePoints; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / kCirclePoints;
        circle.push_back(radius *
                         Vec2(static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle))));
    }
    return {{std::move(circle)}, {}};
}

/// From 0 to 1 without a kink at either end.
float eased(float share)
{
    return share * share * (3.0F - 2.0F * share);
}

void addProfile(ContentHash& hash, const StrandProfile& profile)
{
    for (const StrandProfile::Loop& loop : profile.boundaries)
        hash.addAll(std::span(reinterpret_cast<const float*>(loop.data()), 2 * loop.size()));
    for (const auto& [from, to] : profile.attractors) {
        for (const float number : {from.x(), from.y(), to.x(), to.y()})
            hash.add(number);
    }
}

} // namespace

/// Finds the nodes at which profiles fade.
class NodeProfiles::Fader {
public:
    Fader(const StrandSkeleton& skeleton, std::vector<Share>& shares) : m_skeleton(skeleton), m_shares(shares)
    {
    }

    void fade()
    {
        std::vector<std::uint32_t> ends;
        for (std::uint32_t i = 0; i < m_shares.size(); ++i) {
            if (m_shares[i].from != nullptr)
                ends.push_back(i);
        }
        for (const bool isUpward : {true, false}) {
            for (const std::uint32_t end : ends)
                fadeFrom(end, isUpward);
        }
    }

private:
    struct Step {
        std::uint32_t node;
        float path; ///< m from the profile's last node
    };

    /// The next node along the branch, or kNoNode.
    std::uint32_t next(std::uint32_t node, bool isUpward) const
    {
        const StrandNode& n = m_skeleton.nodes[node];
        std::uint32_t other = n.parent;
        if (isUpward) {
            if (n.childCount == 0)
                return kNoNode;
            other = *std::ranges::max_element(m_skeleton.childrenOf(node), {}, [&](std::uint32_t child) {
                return m_skeleton.nodes[child].strands;
            });
        } else if (m_skeleton.isBase(node)) {
            return kNoNode;
        }
        return other;
    }

    void fadeFrom(std::uint32_t end, bool isUpward)
    {
        const StrandProfile* const profile = m_shares[end].from;
        const StrandNode& first = m_skeleton.nodes[end];
        const float reach = kFadeRadii * first.radius;
        m_steps.clear();
        float path = 0.0F;
        std::uint32_t below = end;
        for (std::uint32_t node = next(end, isUpward);; node = next(node, isUpward)) {
            if (node == kNoNode)
                break;
            const StrandNode& n = m_skeleton.nodes[node];
            // Another branch is not shaped by this one.
            if (2 * n.strands < first.strands || n.strands > 2 * first.strands)
                break;
            path += (n.position - m_skeleton.nodes[below].position).norm();
            below = node;
            if (path >= 2.0F * reach)
                break;
            if (const Share& there = m_shares[node]; there.from != nullptr) {
                const bool isOwn = there.share == 0.0F && there.to == nullptr;
                if (isOwn && isUpward)
                    blendSteps(profile, there.from, path);
                else
                    fadeSteps(profile, std::min(reach, path / 2.0F));
                return;
            }
            m_steps.push_back({node, path});
        }
        fadeSteps(profile, reach);
    }

    void blendSteps(const StrandProfile* from, const StrandProfile* to, float length)
    {
        for (const Step& step : m_steps)
            m_shares[step.node] = {from, to, eased(step.path / length)};
    }

    void fadeSteps(const StrandProfile* from, float reach)
    {
        for (const Step& step : m_steps) {
            if (step.path < reach)
                m_shares[step.node] = {from, nullptr, eased(step.path / reach)};
        }
    }

    const StrandSkeleton& m_skeleton;
    std::vector<Share>& m_shares;
    std::vector<Step> m_steps;
};

NodeProfiles::NodeProfiles(const Tree& tree, const StrandSkeleton& skeleton, bool areFaded)
    : m_shares(skeleton.nodes.size())
{
    if (tree.content().sparse.profile.cells().empty())
        return;
    for (std::uint32_t i = 0; i < m_shares.size(); ++i) {
        const StrandNode& n = skeleton.nodes[i];
        if (n.along == 1.0F || skeleton.isBase(i))
            m_shares[i].from = tree.profileOf(n.internode);
    }
    if (!areFaded)
        return;
    Fader(skeleton, m_shares).fade();
    for (const Share& share : m_shares) {
        if (share.share > 0.0F)
            m_blends[{share.from, share.to}];
    }
}

void NodeProfiles::addTo(ContentHash& hash, std::uint32_t node) const
{
    const Share& share = m_shares[node];
    hash.add(share.from != nullptr);
    if (share.from == nullptr)
        return;
    hash.add(share.share);
    addProfile(hash, *share.from);
    if (share.to != nullptr)
        addProfile(hash, *share.to);
}

StrandProfile NodeProfiles::at(std::uint32_t node) const
{
    const Share& share = m_shares[node];
    if (share.share == 0.0F)
        return *share.from;
    LazyBlend& lazy = m_blends.find({share.from, share.to})->second;
    std::call_once(lazy.isMade, [&] {
        if (share.to != nullptr)
            lazy.blend.emplace(*share.from, *share.to);
        else
            lazy.blend.emplace(*share.from, roundLike(*share.from), ProfileBlend::By::Distances);
    });
    return lazy.blend->at(share.share);
}

} // namespace espalier
