// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/shape/ChainEnergy.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <cassert>

namespace espalier {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Matrix3d crossMatrix(const Vector3d& v)
{
    Matrix3d m;
    m << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
    return m;
}

/// (aᵀb)I − baᵀ = [a]×ᵀ[b]×
Matrix3d inertia(const Vector3d& a, const Vector3d& b)
{
    return a.dot(b) * Matrix3d::Identity() - b * a.transpose();
}

/// The positive part of the contribution of the curvature of the rotation of @p lever to the second
/// derivative of |e|²/2, where the end of the lever appears in @p e.
Matrix3d curvature(const Vector3d& e, const Vector3d& lever)
{
    const Matrix3d product = e * lever.transpose();
    Eigen::SelfAdjointEigenSolver<Matrix3d> solver;
    solver.computeDirect(0.5 * (product + product.transpose()) - e.dot(lever) * Matrix3d::Identity());
    return solver.eigenvectors() * solver.eigenvalues().cwiseMax(0.0).asDiagonal() *
           solver.eigenvectors().transpose();
}

} // namespace

double faceEnergy(const Matrix3d& lower, const Matrix3d& upper, const Vector3d& a, const Vector3d& b)
{
    const Matrix3d difference = lower - upper;
    return ((difference * a).squaredNorm() + (difference * b).squaredNorm()) / 3.0;
}

ChainEnergy::ChainEnergy(std::vector<ChainPrism> prisms, std::vector<ChainJoint> joints)
    : m_prisms(std::move(prisms)), m_joints(std::move(joints)), m_system(m_prisms.size())
{
    assert(m_joints.size() + 1 == m_prisms.size() || m_prisms.empty());
}

Vector3d ChainEnergy::gap(const Motions& motions, std::size_t joint) const
{
    const ChainMotion& lower = motions[joint];
    const ChainMotion& upper = motions[joint + 1];
    return lower.centre + lower.rotation * m_prisms[joint].upper - upper.centre -
           upper.rotation * m_prisms[joint + 1].lower;
}

double ChainEnergy::of(const Motions& motions) const
{
    double sum = 0.0;
    for (std::size_t i = 0; i < m_joints.size(); ++i) {
        const ChainJoint& joint = m_joints[i];
        sum += joint.stretching * gap(motions, i).squaredNorm() +
               joint.bending * faceEnergy(motions[i].rotation, motions[i + 1].rotation, joint.a, joint.b);
    }
    return sum;
}

void ChainEnergy::addJoint(const Motions& motions, std::size_t index, bool withCurvature)
{
    const ChainJoint& joint = m_joints[index];
    const ChainMotion& lower = motions[index];
    const ChainMotion& upper = motions[index + 1];
    BlockTridiagonal::Row& one = m_system.rows()[index];
    BlockTridiagonal::Row& other = m_system.rows()[index + 1];

    const Vector3d p = lower.rotation * m_prisms[index].upper;
    const Vector3d q = upper.rotation * m_prisms[index + 1].lower;
    const Vector3d gap = lower.centre + p - upper.centre - q;
    const double s = joint.stretching;
    const Matrix3d pCross = s * crossMatrix(p);
    const Matrix3d qCross = s * crossMatrix(q);
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
    one.right.head<3>() -= s * p.cross(gap);
    one.right.tail<3>() -= s * gap;
    other.right.head<3>() += s * q.cross(gap);
    other.right.tail<3>() += s * gap;
    if (withCurvature) {
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
        one.right.head<3>() -= torque;
        other.right.head<3>() += torque;
    }
}

void ChainEnergy::findStep(const Motions& motions, std::span<const std::size_t> held, bool withCurvature,
                           Step& step)
{
    m_system.setZero();
    for (std::size_t i = 0; i < m_joints.size(); ++i)
        addJoint(motions, i, withCurvature);
    std::vector<BlockTridiagonal::Row>& rows = m_system.rows();
    for (const std::size_t prism : held) {
        BlockTridiagonal::Row& row = rows[prism];
        row.own.bottomRows<3>().setZero();
        row.own.rightCols<3>().setZero();
        row.own.bottomRightCorner<3, 3>().setIdentity();
        row.right.tail<3>().setZero();
        row.above.bottomRows<3>().setZero();
        rows[prism - 1].above.rightCols<3>().setZero();
    }
    rows.front().own.setIdentity();
    rows.front().above.setZero();
    rows.front().right.setZero();
    m_system.solve();

    step.turns.resize(rows.size());
    step.shifts.resize(rows.size());
    step.slope = 0.0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        step.turns[i] = rows[i].solution.head<3>();
        step.shifts[i] = rows[i].solution.tail<3>();
        step.slope -= 2.0 * rows[i].right.dot(rows[i].solution);
    }
}

} // namespace espalier
