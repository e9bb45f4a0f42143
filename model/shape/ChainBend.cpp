// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/shape/ChainBend.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace espalier {

namespace {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

/// Half-width of the joints' faces, in lengths of the movable part: the smaller it is, the less a chain is
/// pulled apart before it bends.
constexpr double kFaceShare = 0.05;
/// No internode counts as shorter than this, in mean internode lengths.
constexpr double kLeastLength = 1e-3;
/// A chain with a gap above this, in mean internode lengths, is taut.
constexpr double kTautGap = 0.05;
/// rad, the most that a prism turns in a step.
constexpr double kMostTurn = 0.5;
constexpr int kMostHalvings = 12;
/// A step is accepted if it brings this share of the descent that the slope promises.
constexpr double kLeastDescent = 1e-4;
/// Steps below this (rad, or lengths of the movable part) end a call.
constexpr double kSmallestStep = 1e-7;
/// Limit of a call's cost, in steps times internodes, and the least number of steps.
constexpr std::size_t kWork = 8'000;
constexpr std::size_t kLeastSteps = 10;
constexpr std::size_t kMostSteps = 60;
/// A handle whose target moves further at once, in lengths of the movable part, moves there in stages.
constexpr double kStage = 0.2;
constexpr double kMostStages = 4.0;
constexpr std::size_t kStepsPerStage = 4;
/// rad, far too small to be seen.
constexpr double kNudge = 1e-6;
/// Weight of keeping nodes in place against holding the handles exactly, when gaps are closed.
constexpr double kClosingRidge = 1e-2;

/// Sets components to zero that are less than rounding beside @p scale: they would become denormal numbers,
/// which are slow.
template <class Values>
Values withoutTraces(const Values& values, double scale)
{
    return ((values.array() + scale) - scale).matrix();
}

Matrix3d turnedBy(const Vector3d& rotationVector, const Matrix3d& rotation)
{
    const double angle = rotationVector.norm();
    if (angle == 0.0)
        return rotation;
    Quaterniond turned = Eigen::AngleAxisd(angle, rotationVector / angle) * Quaterniond(rotation);
    return withoutTraces<Matrix3d>(turned.normalized().toRotationMatrix(), 1.0);
}

} // namespace

ChainBend::ChainBend(ChainPose rest, std::span<const ChainHandle> handles, const BendOptions& options)
    : m_rest(std::move(rest)), m_mostStretch(std::max(1.0, options.mostStretch))
{
    const std::size_t count = m_rest.rotations.size();
    assert(m_rest.nodes.size() == count + 1);
    std::vector<ChainPrism> prisms;
    for (std::size_t i = 0; i < count; ++i) {
        const Vector3d segment = m_rest.nodes[i + 1] - m_rest.nodes[i];
        const double length = segment.norm();
        m_directions.push_back(length > 0.0 ? Vector3d(segment / length)
                                            : m_rest.rotations[i] * Vector3d::UnitY());
        m_length += i > 0 ? length : 0.0;
        prisms.push_back({.centre = 0.5 * (m_rest.nodes[i] + m_rest.nodes[i + 1])});
    }
    placeGrips(handles, prisms);
    for (std::size_t i = 0; i < count; ++i) {
        prisms[i].lower = m_rest.nodes[i] - prisms[i].centre;
        prisms[i].upper = m_rest.nodes[i + 1] - prisms[i].centre;
    }
    m_energy = ChainEnergy(std::move(prisms), makeJoints(options));
    reset();
}

void ChainBend::placeGrips(std::span<const ChainHandle> handles, std::span<ChainPrism> prisms)
{
    const auto isUsed = [&](const ChainHandle& handle) {
        return handle.internode > 0 && handle.internode < prisms.size() && m_length > 0.0;
    };
    for (const ChainHandle& handle : handles) {
        if (!isUsed(handle))
            continue;
        const double along = std::isfinite(handle.along) ? std::clamp(handle.along, 0.0, 1.0) : 1.0;
        const auto known = std::ranges::find(m_grips, handle.internode, &Grip::internode);
        if (known != m_grips.end()) {
            known->along += along;
            known->count += 1.0;
        } else {
            m_grips.push_back({handle.internode, along, 0.0, 1.0, Vector3d::Zero()});
        }
    }
    std::ranges::sort(m_grips, {}, &Grip::internode);
    for (const ChainHandle& handle : handles) {
        const auto grip = std::ranges::find(m_grips, handle.internode, &Grip::internode);
        m_gripOf.push_back(isUsed(handle) ? static_cast<std::size_t>(grip - m_grips.begin())
                                          : m_grips.size());
    }

    double arc = 0.0;
    double arcBelow = 0.0;
    std::size_t internode = 1;
    for (Grip& grip : m_grips) {
        grip.along /= grip.count;
        const auto lengthOf = [&](std::size_t i) { return (m_rest.nodes[i + 1] - m_rest.nodes[i]).norm(); };
        for (; internode < grip.internode; ++internode)
            arc += lengthOf(internode);
        const double arcHere = arc + grip.along * lengthOf(grip.internode);
        grip.reach = m_mostStretch * (arcHere - arcBelow);
        arcBelow = arcHere;
        ChainPrism& prism = prisms[grip.internode];
        prism.centre =
            (1.0 - grip.along) * m_rest.nodes[grip.internode] + grip.along * m_rest.nodes[grip.internode + 1];
        grip.target = prism.centre;
        m_held.push_back(grip.internode);
    }
}

std::vector<ChainJoint> ChainBend::makeJoints(const BendOptions& options) const
{
    std::vector<ChainJoint> joints;
    const std::size_t count = m_rest.rotations.size();
    if (count < 2)
        return joints;
    const double mean = m_length / static_cast<double>(count - 1);
    const auto lengthOf = [&](std::size_t i) {
        return std::max((m_rest.nodes[i + 1] - m_rest.nodes[i]).norm(), std::max(kLeastLength * mean, 1e-12));
    };
    const double halfWidth = kFaceShare * m_length;
    for (std::size_t i = 0; i + 1 < count; ++i) {
        // Half of each prism is elastic at its joint; of the first prism, which stays, nothing.
        const double length = 0.5 * ((i > 0 ? lengthOf(i) : 0.0) + lengthOf(i + 1));
        const Vector3d sum = m_directions[i] + m_directions[i + 1];
        const Vector3d normal = sum.norm() > 1e-6 ? Vector3d(sum.normalized()) : m_directions[i];
        const Vector3d a = halfWidth * normal.unitOrthogonal();
        joints.push_back({std::clamp(options.stretching, 0.01, 100.0) / length,
                          std::clamp(options.bending, 0.01, 100.0) / length, a, normal.cross(a)});
    }
    return joints;
}

void ChainBend::reset()
{
    m_motions.clear();
    for (const ChainPrism& prism : m_energy.prisms())
        m_motions.push_back({Matrix3d::Identity(), prism.centre});
    for (Grip& grip : m_grips)
        grip.target = m_energy.prisms()[grip.internode].centre;
    m_descents.clear();
    m_pose = m_rest;
}

double ChainBend::energy() const
{
    return m_energy.of(m_motions);
}

std::vector<Vector3d> ChainBend::reachable(std::span<const Vector3d> targets) const
{
    std::vector<Vector3d> sums(m_grips.size(), Vector3d::Zero());
    for (std::size_t i = 0; i < m_gripOf.size(); ++i) {
        if (const std::size_t grip = m_gripOf[i]; grip < m_grips.size()) {
            const bool isGiven = i < targets.size() && targets[i].allFinite();
            sums[grip] += isGiven ? targets[i] : m_grips[grip].target;
        }
    }
    Vector3d below = m_rest.nodes[1];
    for (std::size_t i = 0; i < m_grips.size(); ++i) {
        const Vector3d way = sums[i] / m_grips[i].count - below;
        const double distance = way.stableNorm();
        below += distance > m_grips[i].reach ? Vector3d(m_grips[i].reach * way.stableNormalized()) : way;
        sums[i] = below;
    }
    return sums;
}

bool ChainBend::solve(std::span<const Vector3d> targets)
{
    m_descents.clear();
    if (m_grips.empty())
        return true;
    const std::vector<Vector3d> goals = reachable(targets);
    double furthest = 0.0;
    for (std::size_t i = 0; i < goals.size(); ++i)
        furthest = std::max(furthest, (goals[i] - m_grips[i].target).norm());
    const double stages = std::clamp(std::ceil(furthest / (kStage * m_length)), 1.0, kMostStages);
    std::size_t stepsLeft = std::clamp(kWork / m_motions.size(), kLeastSteps, kMostSteps);
    if (furthest > 0.0 && energy() == 0.0)
        unsettle();
    bool settled = false;
    for (double stage = 1.0; stage <= stages; stage += 1.0) {
        const bool isLast = stage == stages;
        for (std::size_t i = 0; i < goals.size(); ++i) {
            Grip& grip = m_grips[i];
            ChainMotion& motion = m_motions[grip.internode];
            motion.centre += (goals[i] - motion.centre) / (stages - stage + 1.0);
            if (isLast)
                motion.centre = grip.target = goals[i];
        }
        double energyNow = energy();
        settled = false;
        std::size_t steps = isLast ? stepsLeft : std::min(stepsLeft, kStepsPerStage);
        for (; steps > 0 && !settled; --steps, --stepsLeft)
            settled = !makeStep(energyNow);
    }
    closeGaps();
    return settled;
}

/// Turns each prism a little, so that a straight chain that is pushed can yield sideways.
void ChainBend::unsettle()
{
    for (std::size_t i = 1; i < m_motions.size(); ++i) {
        const Vector3d axis = m_energy.joints()[i - 1].a.normalized();
        m_motions[i].rotation = turnedBy(kNudge * axis, Matrix3d::Identity());
    }
}

bool ChainBend::isTaut() const
{
    const std::size_t joints = m_energy.joints().size();
    const double tautGap = kTautGap * m_length / static_cast<double>(joints);
    for (std::size_t i = 0; i < joints; ++i) {
        if (m_energy.gap(m_motions, i).norm() > tautGap)
            return true;
    }
    return false;
}

/// Makes one step. Returns whether more steps are needed.
bool ChainBend::makeStep(double& energyNow)
{
    m_energy.findStep(m_motions, m_held, isTaut(), m_step);
    const double slope = m_step.slope;
    double turn = 0.0;
    double shift = 0.0;
    for (std::size_t i = 1; i < m_motions.size(); ++i) {
        turn = std::max(turn, m_step.turns[i].norm());
        shift = std::max(shift, m_step.shifts[i].norm());
    }
    if (!std::isfinite(slope) || !(slope < 0.0) || (turn < kSmallestStep && shift < kSmallestStep * m_length))
        return false;

    double share = std::min(1.0, kMostTurn / std::max(turn, kMostTurn));
    m_trial = m_motions;
    for (int halvings = 0; halvings <= kMostHalvings; ++halvings, share *= 0.5) {
        for (std::size_t i = 1; i < m_motions.size(); ++i) {
            m_trial[i].rotation = turnedBy(share * m_step.turns[i], m_motions[i].rotation);
            m_trial[i].centre =
                withoutTraces<Vector3d>(m_motions[i].centre + share * m_step.shifts[i], m_length);
        }
        const double energyThen = m_energy.of(m_trial);
        if (energyThen <= energyNow + kLeastDescent * share * slope) {
            m_descents.push_back({energyNow, energyThen});
            energyNow = energyThen;
            m_motions.swap(m_trial);
            return true;
        }
    }
    return false;
}

/// Moves each node to the middle of the gap at its joint; then moves nodes as little as possible to bring the
/// held points to their targets again.
void ChainBend::closeGaps()
{
    const std::vector<ChainPrism>& prisms = m_energy.prisms();
    const std::size_t count = prisms.size();
    for (std::size_t i = 1; i < count; ++i) {
        const ChainMotion& motion = m_motions[i];
        Vector3d node = motion.centre + motion.rotation * prisms[i].upper;
        if (i + 1 < count) {
            const ChainMotion& above = m_motions[i + 1];
            node = 0.5 * (node + above.centre + above.rotation * prisms[i + 1].lower);
        }
        m_pose.nodes[i + 1] = node;
    }

    const auto grips = static_cast<Eigen::Index>(m_grips.size());
    const auto weight = [&](const Grip& grip, std::size_t node) {
        if (node < 2)
            return 0.0; // the first internode
        return node == grip.internode ? 1.0 - grip.along : node == grip.internode + 1 ? grip.along : 0.0;
    };
    Eigen::MatrixXd system(grips, grips);
    Eigen::MatrixX3d off(grips, 3);
    for (Eigen::Index i = 0; i < grips; ++i) {
        const Grip& grip = m_grips[static_cast<std::size_t>(i)];
        const std::size_t lower = grip.internode;
        for (Eigen::Index j = 0; j < grips; ++j) {
            const Grip& other = m_grips[static_cast<std::size_t>(j)];
            system(i, j) = weight(grip, lower) * weight(other, lower) +
                           weight(grip, lower + 1) * weight(other, lower + 1) +
                           (i == j ? kClosingRidge : 0.0);
        }
        off.row(i) =
            grip.target - (1.0 - grip.along) * m_pose.nodes[lower] - grip.along * m_pose.nodes[lower + 1];
    }
    const Eigen::MatrixX3d shifts = system.llt().solve(off);
    for (Eigen::Index i = 0; i < grips; ++i) {
        const Grip& grip = m_grips[static_cast<std::size_t>(i)];
        for (const std::size_t node : {grip.internode, grip.internode + 1})
            m_pose.nodes[node] += weight(grip, node) * shifts.row(i).transpose();
    }

    for (std::size_t i = 1; i < count; ++i) {
        const Vector3d segment = m_pose.nodes[i + 1] - m_pose.nodes[i];
        const Matrix3d& rotation = m_motions[i].rotation;
        Quaterniond turn(rotation);
        if (const double length = segment.norm(); length > 1e-9 * m_length)
            turn = Quaterniond::FromTwoVectors(rotation * m_directions[i], segment / length) * turn;
        m_pose.rotations[i] = (turn * m_rest.rotations[i]).normalized();
    }
}

} // namespace espalier
