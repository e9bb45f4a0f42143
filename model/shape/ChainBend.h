// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/shape/ChainEnergy.h"

#include <Eigen/Geometry>

#include <cstdint>
#include <span>
#include <vector>

namespace espalier {

/// How a branch yields when it is bent. Only the ratio of the two weights affects its form.
struct BendOptions {
    double stretching = 1.0; ///< σ, 0.01...100, resistance of joints against being pulled apart
    double bending = 1.0;    ///< β, 0.01...100, resistance of joints against bending and twisting
    /// 1...10, how far away a target can be, in lengths of the path that leads to the handle.
    double mostStretch = 1.5;

    bool operator==(const BendOptions&) const = default;
};

/// A path of internodes in the world: node i and i + 1 are the ends of internode i.
struct ChainPose {
    std::vector<Eigen::Vector3d> nodes; ///< m; one more than there are internodes
    std::vector<Eigen::Quaterniond> rotations;
};

/// A place at which a path is held.
struct ChainHandle {
    std::uint32_t internode = 0; ///< Index in the path
    double along = 1.0;          ///< 0...1 from its lower to its upper node
};

/// Bends a path of internodes as a chain of rigid prisms with elastic joints (PriMo: Botsch et al. 2006;
/// TreeSketch §3.3). The first internode stays where it is, handles pull points of others to their targets,
/// and the rest settles where the energy of the joints
///
///     E = Σ w (σ |gap|² + β ∫ |distance of the two prisms' copies of the face|²)
///
/// is least; w is 1 over the length that a joint stands for, so that shorter internodes give the same form.
/// Energy is measured from the rest pose: handles at their rest points give that pose again.
///
/// Minimised by Gauss-Newton steps of all prisms at once, each turned about its own centre or about the point
/// that is held. Steps are halved until the energy falls; where the chain is taut, the part of the second
/// derivative that keeps it taut is added. A call makes a bounded number of steps and the next call continues
/// from there, so that a path of 200 internodes can be dragged at 60 frames a second.
class ChainBend {
public:
    /// @p rest has one node more than rotations. Several handles of one internode act as one in their middle;
    /// handles on the first internode, or beyond the last, have no effect.
    ChainBend(ChainPose rest, std::span<const ChainHandle> handles, const BendOptions& options = {});

    /// Pulls the handles (in the order given) to @p targets, m; a handle whose target is out of reach is
    /// pulled in the target's direction. A target that is not a number leaves its handle where it was.
    /// Returns whether the form has settled; if not, more calls bring it nearer.
    bool solve(std::span<const Eigen::Vector3d> targets);
    /// Returns to the rest pose.
    void reset();

    const ChainPose& rest() const { return m_rest; }
    /// The pose that the last call has led to: gaps are closed, and each rotation has +Y along its internode
    /// and is turned about it with its prism.
    const ChainPose& pose() const { return m_pose; }

    /// The elastic energy of the prisms with the gaps between them; 0 at rest.
    double energy() const;
    /// Energies before and after each step of the last call. Handles move in several stages, and each stage
    /// begins with a new energy.
    struct Descent {
        double before;
        double after;
    };
    std::span<const Descent> descents() const { return m_descents; }
    /// Rotation of prism @p internode away from rest, a rotation matrix.
    const Eigen::Matrix3d& prismRotation(std::size_t internode) const
    {
        return m_motions[internode].rotation;
    }

private:
    struct Grip {
        std::size_t internode;
        double along;
        double reach; ///< m, from the grip below it or from the first prism
        double count; ///< Number of handles that this grip replaces
        Eigen::Vector3d target;
    };
    /// Sets the centres of the prisms that handles hold to the held points.
    void placeGrips(std::span<const ChainHandle> handles, std::span<ChainPrism> prisms);
    std::vector<ChainJoint> makeJoints(const BendOptions& options) const;
    std::vector<Eigen::Vector3d> reachable(std::span<const Eigen::Vector3d> targets) const;
    void unsettle();
    bool isTaut() const;
    bool makeStep(double& energyNow);
    void closeGaps();

    ChainPose m_rest;
    std::vector<Eigen::Vector3d> m_directions; ///< Of internodes at rest, unit
    double m_length = 0.0;                     ///< Length of all that can move, m
    double m_mostStretch = 1.0;
    ChainEnergy m_energy;
    std::vector<Grip> m_grips; ///< From the base up
    /// Index of the grip of each handle; past the end if the handle has no effect.
    std::vector<std::size_t> m_gripOf;
    std::vector<std::size_t> m_held; ///< Internodes of the grips
    ChainEnergy::Motions m_motions;
    ChainEnergy::Motions m_trial;
    ChainEnergy::Step m_step;
    std::vector<Descent> m_descents;
    ChainPose m_pose;
};

} // namespace espalier
