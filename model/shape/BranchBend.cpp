// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/shape/BranchBend.h"

#include <algorithm>

namespace espalier {

namespace {

constexpr double kLeastShare = 0.01; ///< Of its length that is left of an internode
/// m; whoever bends the same branch for ever does not make it vanish or fill the world.
constexpr double kLeastBranchLength = 1e-5;

ChainPose poseOf(const Tree& tree, const TreeIndex& index, std::span<const InternodeId> path)
{
    ChainPose pose;
    if (path.empty()) {
        pose.nodes.push_back(Eigen::Vector3d::Zero());
        return pose;
    }
    pose.nodes.push_back(index.basePosition(tree, path.front()).cast<double>());
    for (const InternodeId id : path) {
        pose.nodes.push_back(index.nodePosition(id).cast<double>());
        pose.rotations.push_back(index.rotation(id).cast<double>().normalized());
    }
    return pose;
}

std::vector<ChainHandle> handlesOn(std::span<const InternodeId> path,
                                   std::span<const BranchBend::Handle> handles)
{
    std::vector<ChainHandle> found;
    for (const BranchBend::Handle& handle : handles) {
        const auto place = std::ranges::lower_bound(path, handle.id);
        const bool isOnPath = place != path.end() && *place == handle.id;
        // Handles that have no effect get the base's index.
        const auto internode = static_cast<std::uint32_t>(isOnPath ? place - path.begin() : 0);
        found.push_back({internode, handle.along});
    }
    return found;
}

} // namespace

std::vector<InternodeId> pathBetween(const Tree& tree, InternodeId base, InternodeId end)
{
    std::vector<InternodeId> path;
    for (InternodeId id = end; id != kNoInternode && id >= base; id = tree.parent(id))
        path.push_back(id);
    if (path.empty() || path.back() != base)
        return {};
    std::ranges::reverse(path);
    return path;
}

BranchBend::BranchBend(const Tree& tree, const TreeIndex& index, InternodeId base, InternodeId end,
                       std::span<const Handle> handles, const BendOptions& options)
    : m_path(pathBetween(tree, base, end)),
      m_chain(poseOf(tree, index, m_path), handlesOn(m_path, handles), options)
{
    for (const InternodeId id : m_path) {
        m_rotations.push_back(tree.columns().rotation[id]);
        m_lengths.push_back(tree.length(id));
    }
}

Vec3 BranchBend::restPoint(const Handle& handle) const
{
    const auto place = std::ranges::lower_bound(m_path, handle.id);
    if (place == m_path.end() || *place != handle.id)
        return Vec3::Zero();
    const auto lower = static_cast<std::size_t>(place - m_path.begin());
    const auto& nodes = m_chain.rest().nodes;
    return ((1.0 - handle.along) * nodes[lower] + handle.along * nodes[lower + 1]).cast<float>();
}

bool BranchBend::solve(std::span<const Vec3> targets)
{
    std::vector<Eigen::Vector3d> wanted;
    for (const Vec3& target : targets)
        wanted.emplace_back(target.cast<double>());
    return m_chain.solve(wanted);
}

std::vector<FrameChange> BranchBend::changes() const
{
    std::vector<FrameChange> changes;
    const ChainPose& rest = m_chain.rest();
    const ChainPose& bent = m_chain.pose();
    Eigen::Quaterniond turnBelow = Eigen::Quaterniond::Identity();
    for (std::size_t i = 1; i < m_path.size(); ++i) {
        // Turns the stored row, so that a frame that has not moved keeps every bit.
        const Eigen::Quaterniond turn = bent.rotations[i] * rest.rotations[i].conjugate();
        const Eigen::Quaterniond& below = rest.rotations[i - 1];
        const Eigen::Quaterniond local =
            below.conjugate() * turnBelow.conjugate() * turn * below * m_rotations[i].cast<double>();
        turnBelow = turn;
        Rotation after = local.cast<float>();
        if (after.dot(m_rotations[i]) < 0.0F)
            after.coeffs() = -after.coeffs();

        const double lengthAtRest = (rest.nodes[i + 1] - rest.nodes[i]).norm();
        const double length = (bent.nodes[i + 1] - bent.nodes[i]).norm();
        const double before = static_cast<double>(m_lengths[i]);
        const double wanted = lengthAtRest > 0.0 ? before * (length / lengthAtRest) : length;
        const double least = std::max(kLeastShare * before, std::min(kLeastBranchLength, before));
        const auto lengthAfter =
            static_cast<float>(std::clamp(wanted, least, static_cast<double>(kGreatestLength)));
        // Otherwise rounding would accumulate over many bends.
        if (after != m_rotations[i])
            after.normalize();
        if (after != m_rotations[i] || lengthAfter != m_lengths[i])
            changes.push_back({m_path[i], m_rotations[i], after, m_lengths[i], lengthAfter});
    }
    return changes;
}

} // namespace espalier
