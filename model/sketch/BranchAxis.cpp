// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/sketch/BranchAxis.h"

#include <algorithm>
#include <cmath>

namespace espalier {

namespace {

/// Sine of the angle between a branch and its parent below which the parent's direction gives no side.
constexpr double kLeastSideways = 0.02;
/// A place that is nearer to a node than this share of the axis's length is the node.
constexpr double kNodeShare = 1e-6;

Eigen::Vector3d headingOf(const TreeIndex& index, InternodeId id)
{
    return index.heading(id).cast<double>().normalized();
}

Eigen::Quaterniond baseFrame(const Tree& tree, const TreeIndex& index, InternodeId first)
{
    const Eigen::Vector3d y = headingOf(index, first);
    const InternodeId parent = tree.parent(first);
    Eigen::Vector3d side = Eigen::Vector3d::Zero();
    if (parent != kNoInternode) {
        const Eigen::Vector3d forward = headingOf(index, parent);
        side = forward - forward.dot(y) * y;
    }
    if (side.norm() < kLeastSideways) {
        const Eigen::Vector3d own = (index.rotation(first) * Vec3(Vec3::UnitX())).cast<double>();
        side = own - own.dot(y) * y;
    }
    Eigen::Matrix3d axes;
    axes.col(0) = side.normalized();
    axes.col(1) = y;
    axes.col(2) = axes.col(0).cross(y);
    return Eigen::Quaterniond(axes).normalized();
}

} // namespace

BranchAxis::BranchAxis(const Tree& tree, const TreeIndex& index, InternodeId id)
{
    const InternodeId first = index.axis(id);
    double end = 0.0;
    for (InternodeId on = first; on != kNoInternode; on = index.mainChild(on)) {
        end += double{tree.length(on)};
        if (m_internodes.empty()) {
            m_frames.push_back(baseFrame(tree, index, on));
        } else {
            const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(
                headingOf(index, m_internodes.back()), headingOf(index, on));
            m_frames.push_back((turn * m_frames.back()).normalized());
        }
        m_internodes.push_back(on);
        m_ends.push_back(end);
    }
}

double BranchAxis::distanceOf(const Place& place) const
{
    const double begin = place.number == 0 ? 0.0 : m_ends[place.number - 1];
    return begin + double{place.along} * (m_ends[place.number] - begin);
}

BranchAxis::Place BranchAxis::at(double distance) const
{
    const double slack = kNodeShare * length();
    const auto found = std::ranges::lower_bound(m_ends, distance - slack);
    const auto number = std::min(static_cast<std::size_t>(found - m_ends.begin()), m_ends.size() - 1);
    if (m_ends[number] - distance <= slack)
        return {number, 1.0F};
    const double begin = number == 0 ? 0.0 : m_ends[number - 1];
    const double share = (distance - begin) / (m_ends[number] - begin);
    return {number, static_cast<float>(std::clamp(share, 0.0, 1.0))};
}

double ChildBranch::downAngle() const
{
    return std::atan2(std::hypot(heading.x(), heading.z()), heading.y());
}

double ChildBranch::rotationAngle() const
{
    return std::atan2(heading.z(), heading.x());
}

std::vector<ChildBranch> childBranches(const Tree& tree, const TreeIndex& index, const BranchAxis& axis)
{
    std::vector<ChildBranch> children;
    for (std::size_t i = 0; i < axis.internodes().size(); ++i) {
        for (InternodeId id = index.firstChild(axis.internodes()[i]); id != kNoInternode;
             id = index.nextSibling(id)) {
            if (tree.continuesAxis(id))
                continue;
            const BranchAxis::Place place{i, tree.columns().along[id]};
            children.push_back({.id = id,
                                .place = place,
                                .distance = axis.distanceOf(place),
                                .heading = axis.frame(i).conjugate() * headingOf(index, id)});
        }
    }
    std::ranges::sort(children, [&](const ChildBranch& a, const ChildBranch& b) {
        return a.distance != b.distance ? a.distance < b.distance : tree.key(a.id) < tree.key(b.id);
    });
    return children;
}

} // namespace espalier
