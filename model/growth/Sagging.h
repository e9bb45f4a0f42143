// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/growth/VigourFlux.h"

namespace espalier {

/// The weight on an internode: of itself and all that it carries.
struct BranchLoad {
    double mass = 0.0; ///< Of internodes as thick as a tip and as long as the parameters say
    Eigen::Vector3d moment = Eigen::Vector3d::Zero(); ///< Mass times position, m
    double tips = 0.0;                                ///< Twig tips that it carries
    float lowest = 0.0F;                              ///< Height of the lowest node above it, m
    double reach = 0.0;                               ///< Length of the longest way through it to a tip, m
    BranchLoad& operator+=(const BranchLoad& other)
    {
        mass += other.mass;
        moment += other.moment;
        tips += other.tips;
        lowest = std::min(lowest, other.lowest);
        reach = std::max(reach, other.reach);
        return *this;
    }
};

/// How far an internode under @p load sags, as a share of its angle to straight down: b_max (1 − exp(−k M /
/// (t/t_e)^p)), M being the moment of the load about the lower end @p base, m, and t/t_e the thickness
/// relative to a tip's (EvoEngine 2024). 0...bendingMaximum.
double sagging(const VigourParameters& parameters, const BranchLoad& load, const Vec3& base);

/// Turns the internodes that take part down, by what their sagging with the additions of this step exceeds
/// that without them. So the sum over all steps is the greatest sagging so far, and a lighter branch does not
/// rise again. Trunks stay upright, and so do internodes whose branch would reach into the ground.
void sagBranches(GrowingTree& growing, const VigourFlux& flux, const VigourParameters& parameters);

} // namespace espalier
