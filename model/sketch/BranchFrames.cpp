// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/sketch/BranchFrames.h"

#include <algorithm>

namespace espalier {

BranchFrames::BranchFrames(const Tree& tree, const TreeIndex& index, InternodeId id)
{
    double length = 0.0;
    Eigen::Quaterniond carried = Eigen::Quaterniond::Identity();
    for (InternodeId place = index.axis(id); place != kNoInternode; place = index.mainChild(place)) {
        const Eigen::Quaterniond own = index.rotation(place).cast<double>().normalized();
        const Eigen::Vector3d heading = own * Eigen::Vector3d::UnitY();
        if (m_internodes.empty())
            carried = own;
        else
            carried =
                Eigen::Quaterniond::FromTwoVectors(carried * Eigen::Vector3d::UnitY(), heading) * carried;
        carried.normalize();
        length += static_cast<double>(tree.length(place));
        m_internodes.push_back(place);
        m_ends.push_back(length);
        m_turns.emplace_back((own.conjugate() * carried).normalized());
    }
}

std::size_t BranchFrames::rowOf(InternodeId id) const
{
    // Parents come before their children, so the ids ascend.
    const auto found = std::ranges::lower_bound(m_internodes, id);
    return found != m_internodes.end() && *found == id
               ? static_cast<std::size_t>(found - m_internodes.begin())
               : m_internodes.size();
}

std::optional<double> BranchFrames::distanceOf(const BranchPlace& place) const
{
    const std::size_t row = rowOf(place.internode);
    if (row == m_internodes.size())
        return std::nullopt;
    const double below = row == 0 ? 0.0 : m_ends[row - 1];
    return below + static_cast<double>(place.along) * (m_ends[row] - below);
}

BranchPlace BranchFrames::placeAt(double distance) const
{
    // A node that rounding puts on the internode above it stays the end of the one below.
    const double slack = 1e-6 * length();
    const auto found = std::ranges::lower_bound(m_ends, distance - slack);
    const auto row = std::min(static_cast<std::size_t>(found - m_ends.begin()), m_ends.size() - 1);
    const double below = row == 0 ? 0.0 : m_ends[row - 1];
    const double along = (distance - below) / (m_ends[row] - below);
    return {.internode = m_internodes[row], .along = static_cast<float>(std::clamp(along, 0.0, 1.0))};
}

Eigen::Quaterniond BranchFrames::carriedFrom(InternodeId id, const Rotation& rotation) const
{
    return (m_turns[rowOf(id)].conjugate() * rotation.cast<double>().normalized()).normalized();
}

Rotation BranchFrames::localFrom(InternodeId id, const Eigen::Quaterniond& carried) const
{
    const Eigen::Quaterniond local = (m_turns[rowOf(id)] * carried).normalized();
    return Rotation(local.cast<float>());
}

} // namespace espalier
