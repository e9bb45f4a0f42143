// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/shape/ChainBend.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace espalier {

namespace {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

/// Half-width of the joints' faces, in lengths of what can move: the smaller, the less a chain is pulled
/// apart before it bends.
constexpr double kFaceShare = 0.05;
/// No internode counts as shorter than this, in mean internode lengths.
constexpr double kLeastLength = 1e-3;
/// A chain with a gap above this, in mean internode lengths, is taut.
constexpr double kTautGap = 0.05;
/// rad, the most that a prism turns in a step.
constexpr double kMostTurn = 0.5;
constexpr int kMostHalvings = 12;
/// A step must bring this share of the descent that the slope promises.
constexpr double kLeastDescent = 1e-4;
/// Steps below this (rad, or lengths of what can move) end a call.
constexpr double kSmallestStep = 1e-7;
/// What a call may cost, in steps times internodes, and the least steps that it makes.
constexpr std::size_t kWork = 8'000;
constexpr std::size_t kLeastSteps = 10;
constexpr std::size_t kMostSteps = 60;
/// A handle that moves further at once, in lengths of what can move, goes there in stages.
constexpr double kStage = 0.2;
constexpr double kMostStages = 4.0;
constexpr std::size_t kStepsPerStage = 4;
/// rad, far below what can be seen.
constexpr double kNudge = 1e-6;
/// How much a handle may be off, once gaps are closed, rather than that a node goes far astray.
constexpr double kClosingRidge = 1e-2;

Matrix3d cross(const Vector3d& v)
{
    Matrix3d m;
    m << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
    return m;
}

/// Without what is less than rounding beside @p scale: components that fade away would end as denormal
/// numbers, which are slow.
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

/// (aᵀb)I − baᵀ = [a]×ᵀ[b]×
Matrix3d inertia(const Vector3d& a, const Vector3d& b)
{
    return a.dot(b) * Matrix3d::Identity() - b * a.transpose();
}

/// The positive part of what the curvature of the rotation of @p lever adds to the second derivative of
/// |e|²/2, where the end of the lever appears in @p e.
Matrix3d curvature(const Vector3d& e, const Vector3d& lever)
{
    const Matrix3d product = e * lever.transpose();
    Eigen::SelfAdjointEigenSolver<Matrix3d> solver;
    solver.computeDirect(0.5 * (product + product.transpose()) - e.dot(lever) * Matrix3d::Identity());
    return solver.eigenvectors() * solver.eigenvalues().cwiseMax(0.0).asDiagonal() *
           solver.eigenvectors().transpose();
}

/// Of a positive definite matrix, by its 3 × 3 blocks.
template <class Matrix6>
Matrix6 inverseOf(const Matrix6& matrix)
{
    const Matrix3d turns = matrix.template topLeftCorner<3, 3>().inverse();
    const Matrix3d coupling = matrix.template topRightCorner<3, 3>();
    const Matrix3d carried = turns * coupling;
    const Matrix3d rest = matrix.template bottomRightCorner<3, 3>() - coupling.transpose() * carried;
    const Matrix3d shifts = rest.inverse();
    const Matrix3d mixed = -carried * shifts;
    Matrix6 inverse;
    inverse.template topLeftCorner<3, 3>() = turns - mixed * carried.transpose();
    inverse.template topRightCorner<3, 3>() = mixed;
    inverse.template bottomLeftCorner<3, 3>() = mixed.transpose();
    inverse.template bottomRightCorner<3, 3>() = shifts;
    return inverse;
}

} // namespace

double faceEnergy(const Matrix3d& lower, const Matrix3d& upper, const Vector3d& a, const Vector3d& b)
{
    const Matrix3d difference = lower - upper;
    return ((difference * a).squaredNorm() + (difference * b).squaredNorm()) / 3.0;
}

ChainBend::ChainBend(ChainPose rest, std::span<const ChainHandle> handles, const BendOptions& options)
    : m_rest(std::move(rest)), m_mostStretch(std::max(1.0, options.mostStretch))
{
    const std::size_t count = m_rest.rotations.size();
    assert(m_rest.nodes.size() == count + 1);
    for (std::size_t i = 0; i < count; ++i) {
        const Vector3d segment = m_rest.nodes[i + 1] - m_rest.nodes[i];
        const double length = segment.norm();
        m_directions.push_back(length > 0.0 ? Vector3d(segment / length)
                                            : m_rest.rotations[i] * Vector3d::UnitY());
        m_length += i > 0 ? length : 0.0;
        m_prisms.push_back({.centre = 0.5 * (m_rest.nodes[i] + m_rest.nodes[i + 1])});
    }
    placeGrips(handles);
    for (std::size_t i = 0; i < count; ++i) {
        m_prisms[i].lower = m_rest.nodes[i] - m_prisms[i].centre;
        m_prisms[i].upper = m_rest.nodes[i + 1] - m_prisms[i].centre;
    }
    placeJoints(options);
    m_blocks.resize(count);
    reset();
}

void ChainBend::placeGrips(std::span<const ChainHandle> handles)
{
    const auto isUsed = [&](const ChainHandle& handle) {
        return handle.internode > 0 && handle.internode < m_prisms.size() && m_length > 0.0;
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
        Prism& prism = m_prisms[grip.internode];
        prism.centre =
            (1.0 - grip.along) * m_rest.nodes[grip.internode] + grip.along * m_rest.nodes[grip.internode + 1];
        grip.target = prism.centre;
    }
}

void ChainBend::placeJoints(const BendOptions& options)
{
    if (m_prisms.size() < 2)
        return;
    const double mean = m_length / static_cast<double>(m_prisms.size() - 1);
    const auto lengthOf = [&](std::size_t i) {
        return std::max((m_rest.nodes[i + 1] - m_rest.nodes[i]).norm(), std::max(kLeastLength * mean, 1e-12));
    };
    const double halfWidth = kFaceShare * m_length;
    for (std::size_t i = 0; i + 1 < m_prisms.size(); ++i) {
        // Half of each prism gives way at its joint; of the first, which stays, nothing.
        const double length = 0.5 * ((i > 0 ? lengthOf(i) : 0.0) + lengthOf(i + 1));
        const Vector3d sum = m_directions[i] + m_directions[i + 1];
        const Vector3d normal = sum.norm() > 1e-6 ? Vector3d(sum.normalized()) : m_directions[i];
        const Vector3d a = halfWidth * normal.unitOrthogonal();
        m_joints.push_back({std::clamp(options.stretching, 0.01, 100.0) / length,
                            std::clamp(options.bending, 0.01, 100.0) / length, a, normal.cross(a)});
    }
}

void ChainBend::reset()
{
    m_motions.clear();
    for (const Prism& prism : m_prisms)
        m_motions.push_back({Matrix3d::Identity(), prism.centre});
    for (Grip& grip : m_grips)
        grip.target = m_prisms[grip.internode].centre;
    m_descents.clear();
    m_pose = m_rest;
}

double ChainBend::energy() const
{
    return energy(m_motions);
}

Vector3d ChainBend::gap(const Motions& motions, std::size_t joint) const
{
    const Motion& lower = motions[joint];
    const Motion& upper = motions[joint + 1];
    return lower.centre + lower.rotation * m_prisms[joint].upper - upper.centre -
           upper.rotation * m_prisms[joint + 1].lower;
}

double ChainBend::energy(const Motions& motions) const
{
    double sum = 0.0;
    for (std::size_t i = 0; i < m_joints.size(); ++i) {
        const Joint& joint = m_joints[i];
        sum += joint.stretching * gap(motions, i).squaredNorm() +
               joint.bending * faceEnergy(motions[i].rotation, motions[i + 1].rotation, joint.a, joint.b);
    }
    return sum;
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
    std::size_t stepsLeft = std::clamp(kWork / m_prisms.size(), kLeastSteps, kMostSteps);
    if (furthest > 0.0 && energy() == 0.0)
        unsettle();
    bool settled = false;
    for (double stage = 1.0; stage <= stages; stage += 1.0) {
        const bool isLast = stage == stages;
        for (std::size_t i = 0; i < goals.size(); ++i) {
            Grip& grip = m_grips[i];
            Motion& motion = m_motions[grip.internode];
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

/// Turns each prism a little, so that a straight chain which is pushed gives way to a side.
void ChainBend::unsettle()
{
    for (std::size_t i = 1; i < m_prisms.size(); ++i)
        m_motions[i].rotation = turnedBy(kNudge * m_joints[i - 1].a.normalized(), Matrix3d::Identity());
}

bool ChainBend::isTaut() const
{
    const double tautGap = kTautGap * m_length / static_cast<double>(m_joints.size());
    for (std::size_t i = 0; i < m_joints.size(); ++i) {
        if (gap(m_motions, i).norm() > tautGap)
            return true;
    }
    return false;
}

/// The energy's gradient and second derivative by the prisms' rotation vectors and shifts (both halved).
void ChainBend::buildModel(bool taut)
{
    for (Block& block : m_blocks) {
        block.own.setZero();
        block.above.setZero();
        block.gradient.setZero();
    }
    for (std::size_t i = 0; i < m_joints.size(); ++i) {
        const Joint& joint = m_joints[i];
        const Motion& lower = m_motions[i];
        const Motion& upper = m_motions[i + 1];
        Block& one = m_blocks[i];
        Block& other = m_blocks[i + 1];

        const Vector3d p = lower.rotation * m_prisms[i].upper;
        const Vector3d q = upper.rotation * m_prisms[i + 1].lower;
        const Vector3d gap = lower.centre + p - upper.centre - q;
        const double s = joint.stretching;
        const Matrix3d pCross = s * cross(p);
        const Matrix3d qCross = s * cross(q);
        one.own.topLeftCorner<3, 3>() += s * inertia(p, p);
        one.own.topRightCorner<3, 3>() += pCross;
        one.own.bottomLeftCorner<3, 3>() -= pCross;
        one.own.bottomRightCorner<3, 3>().diagonal().array() += s;
        other.own.topLeftCorner<3, 3>() += s * inertia(q, q);
        other.own.topRightCorner<3, 3>() += qCross;
        other.own.bottomLeftCorner<3, 3>() -= qCross;
        other.own.bottomRightCorner<3, 3>().diagonal().array() += s;
        one.above.topLeftCorner<3, 3>() -= s * inertia(p, q);
        one.above.topRightCorner<3, 3>() -= pCross;
        one.above.bottomLeftCorner<3, 3>() += qCross;
        one.above.bottomRightCorner<3, 3>().diagonal().array() -= s;
        one.gradient.head<3>() += s * p.cross(gap);
        one.gradient.tail<3>() += s * gap;
        other.gradient.head<3>() -= s * q.cross(gap);
        other.gradient.tail<3>() -= s * gap;
        if (taut) {
            one.own.topLeftCorner<3, 3>() += s * curvature(gap, p);
            other.own.topLeftCorner<3, 3>() += s * curvature(-gap, q);
        }

        const double bend = joint.bending / 3.0;
        for (const Vector3d* extent : {&joint.a, &joint.b}) {
            const Vector3d u = lower.rotation * *extent;
            const Vector3d v = upper.rotation * *extent;
            one.own.topLeftCorner<3, 3>() += bend * inertia(u, u);
            other.own.topLeftCorner<3, 3>() += bend * inertia(v, v);
            one.above.topLeftCorner<3, 3>() -= bend * inertia(u, v);
            const Vector3d torque = bend * v.cross(u);
            one.gradient.head<3>() += torque;
            other.gradient.head<3>() -= torque;
        }
    }
    // What is held turns about the point that it is held at, and shifts no more.
    for (const Grip& grip : m_grips) {
        Block& block = m_blocks[grip.internode];
        block.own.bottomRows<3>().setZero();
        block.own.rightCols<3>().setZero();
        block.own.bottomRightCorner<3, 3>().setIdentity();
        block.gradient.tail<3>().setZero();
        block.above.bottomRows<3>().setZero();
        m_blocks[grip.internode - 1].above.rightCols<3>().setZero();
    }
}

/// Block elimination from the second prism up (the first stays), and back.
void ChainBend::solveModel()
{
    m_blocks.front().step.setZero();
    const std::size_t count = m_blocks.size();
    for (std::size_t i = 1; i < count; ++i) {
        Block& block = m_blocks[i];
        block.step = -block.gradient;
        if (i > 1) {
            const Block& below = m_blocks[i - 1];
            block.own.noalias() -= below.above.transpose().lazyProduct(below.own);
            block.step.noalias() -= below.above.transpose() * below.step;
            // Rounding makes it less symmetric, and each elimination that more so by a factor.
            block.own.triangularView<Eigen::StrictlyUpper>() = block.own.transpose();
        }
        const Matrix6 inverse = inverseOf(block.own);
        block.step = inverse.lazyProduct(block.step).eval();
        // What the way back needs, in the place of what it does not.
        block.own.noalias() = inverse.lazyProduct(block.above);
    }
    for (std::size_t i = count - 1; i-- > 1;)
        m_blocks[i].step.noalias() -= m_blocks[i].own * m_blocks[i + 1].step;
}

/// Returns whether there is more to do.
bool ChainBend::makeStep(double& energyNow)
{
    buildModel(isTaut());
    solveModel();
    double slope = 0.0;
    double turn = 0.0;
    double shift = 0.0;
    for (const Block& block : m_blocks) {
        slope += 2.0 * block.gradient.dot(block.step);
        turn = std::max(turn, block.step.head<3>().norm());
        shift = std::max(shift, block.step.tail<3>().norm());
    }
    if (!std::isfinite(slope) || !(slope < 0.0) || (turn < kSmallestStep && shift < kSmallestStep * m_length))
        return false;

    double share = std::min(1.0, kMostTurn / std::max(turn, kMostTurn));
    m_trial = m_motions;
    for (int halvings = 0; halvings <= kMostHalvings; ++halvings, share *= 0.5) {
        for (std::size_t i = 1; i < m_blocks.size(); ++i) {
            m_trial[i].rotation = turnedBy(share * m_blocks[i].step.head<3>(), m_motions[i].rotation);
            m_trial[i].centre =
                withoutTraces<Vector3d>(m_motions[i].centre + share * m_blocks[i].step.tail<3>(), m_length);
        }
        const double energyThen = energy(m_trial);
        if (energyThen <= energyNow + kLeastDescent * share * slope) {
            m_descents.push_back({energyNow, energyThen});
            energyNow = energyThen;
            m_motions.swap(m_trial);
            return true;
        }
    }
    return false;
}

/// A node is in the middle of the gap at its joint; then as little as can be is moved to bring the held
/// points to their targets again.
void ChainBend::closeGaps()
{
    const std::size_t count = m_prisms.size();
    for (std::size_t i = 1; i < count; ++i) {
        const Motion& motion = m_motions[i];
        Vector3d node = motion.centre + motion.rotation * m_prisms[i].upper;
        if (i + 1 < count) {
            const Motion& above = m_motions[i + 1];
            node = 0.5 * (node + above.centre + above.rotation * m_prisms[i + 1].lower);
        }
        m_pose.nodes[i + 1] = node;
    }

    const auto grips = static_cast<Eigen::Index>(m_grips.size());
    const auto weight = [&](const Grip& grip, std::size_t node) {
        if (node < 2)
            return 0.0; // of the first internode
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
