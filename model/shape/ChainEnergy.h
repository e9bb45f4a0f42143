// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/shape/BlockTridiagonal.h"

#include <Eigen/Core>

#include <span>
#include <vector>

namespace espalier {

/// A rigid prism of a chain at rest; an internode of the path that ChainBend bends.
struct ChainPrism {
    Eigen::Vector3d centre;                          ///< m, the point about which the prism turns
    Eigen::Vector3d lower = Eigen::Vector3d::Zero(); ///< m, from the centre to the lower node
    Eigen::Vector3d upper = Eigen::Vector3d::Zero(); ///< m, from the centre to the upper node
};

/// The elastic joint of prisms i and i + 1, at their common node.
struct ChainJoint {
    double stretching; ///< σ w, see ChainBend
    double bending;    ///< β w
    Eigen::Vector3d a; ///< m, half-extents of the square face that both prisms carry at rest
    Eigen::Vector3d b;
};

/// Current place of a prism.
struct ChainMotion {
    Eigen::Matrix3d rotation; ///< From rest
    Eigen::Vector3d centre;   ///< m
};

/// The energy, per unit of weight, of the square faces that two prisms carry at their joint, if the prisms
/// are turned against each other by @p lower and @p upper and share the centre of the face: the integral of
/// the squared distance of corresponding points over the area of the face, with half-extents @p a and @p b.
double faceEnergy(const Eigen::Matrix3d& lower, const Eigen::Matrix3d& upper, const Eigen::Vector3d& a,
                  const Eigen::Vector3d& b);

/// The elastic energy of a chain of prisms, and its quadratic model for Newton steps.
class ChainEnergy {
public:
    using Motions = std::vector<ChainMotion>;

    ChainEnergy() = default;
    /// @p joints has one element less than @p prisms (none if there is no prism).
    ChainEnergy(std::vector<ChainPrism> prisms, std::vector<ChainJoint> joints);

    const std::vector<ChainPrism>& prisms() const { return m_prisms; }
    const std::vector<ChainJoint>& joints() const { return m_joints; }

    /// The energy of the chain when its prisms are at @p motions; 0 at rest.
    double of(const Motions& motions) const;
    /// The gap from prism @p joint + 1 to the prism below it, m.
    Eigen::Vector3d gap(const Motions& motions, std::size_t joint) const;

    /// A step of all prisms.
    struct Step {
        std::vector<Eigen::Vector3d> turns;  ///< rad, rotation vector of each prism about its centre
        std::vector<Eigen::Vector3d> shifts; ///< m, of each centre
        double slope = 0.0; ///< Derivative of the energy along the step, negative for a descent
    };
    /// Sets @p step to the Gauss-Newton step from @p motions to the minimum of the quadratic model of the
    /// energy. The first prism stays; the prisms with the indices @p held (from 1 on) turn and do not shift.
    /// @p withCurvature adds the positive part of what the gaps of a taut chain contribute to the second
    /// derivative.
    void findStep(const Motions& motions, std::span<const std::size_t> held, bool withCurvature, Step& step);

private:
    void addJoint(const Motions& motions, std::size_t index, bool withCurvature);

    std::vector<ChainPrism> m_prisms;
    std::vector<ChainJoint> m_joints;
    BlockTridiagonal m_system; ///< Halves of the second and first derivatives; one row for each prism
};

} // namespace espalier
