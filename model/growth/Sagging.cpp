// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/growth/Sagging.h"

#include <cmath>

namespace espalier {

namespace {

/// Thickness grows with this power of the number of tips.
constexpr double kThicknessExponent = 0.45;
constexpr double kUnitOfBending = 0.004; // so that k has the range of EvoEngine
/// Sagging is counted in these steps: most internodes do not turn in most growth steps.
constexpr double kSteps = 128.0;

double thicknessOf(double tips)
{
    return std::pow(std::max(tips, 1.0), kThicknessExponent);
}

/// The loads of all internodes that take part, by id; with the additions of the step or without them.
std::vector<BranchLoad> loadsOf(const GrowingTree& growing, const VigourFlux& flux, double internodeLength,
                                bool isAfter)
{
    const Tree& tree = growing.tree();
    const std::uint32_t size = isAfter ? growing.size() : tree.size();
    std::vector<BranchLoad> loads(size);
    for (InternodeId id = size; id-- > 0;) {
        const bool isNew = growing.isNew(id);
        if (!isNew && !flux.takesPart(id))
            continue;
        BranchLoad& load = loads[id];
        if (load.tips == 0.0)
            load.tips = 1.0;
        const double thickness = thicknessOf(load.tips);
        const float length = isAfter ? growing.length(id) : tree.length(id);
        const Vec3 node = isAfter ? growing.stretchedPosition(id) : growing.nodePosition(id);
        const double mass = thickness * thickness * length / internodeLength;
        const Vec3 middle = node - 0.5F * length * growing.heading(id);
        load.reach += length;
        load.mass += mass;
        load.moment += mass * middle.cast<double>();
        load.lowest = std::min(load.lowest == 0.0F ? node.y() : load.lowest, node.y());
        const InternodeId parent = growing.parent(id);
        if (parent == kNoInternode)
            continue;
        BranchLoad& carrier = loads[parent];
        if (carrier.tips == 0.0)
            carrier = load;
        else
            carrier += load;
    }
    return loads;
}

} // namespace

double sagging(const VigourParameters& p, const BranchLoad& load, const Vec3& base)
{
    const Eigen::Vector3d about = load.moment - load.mass * base.cast<double>();
    const double moment = std::hypot(about.x(), about.z());
    const double stiffness = std::pow(thicknessOf(load.tips), p.bendingExponent);
    return p.bendingMaximum * (1.0 - std::exp(-kUnitOfBending * p.bending * moment / stiffness));
}

void sagBranches(GrowingTree& growing, const VigourFlux& flux, const VigourParameters& p)
{
    if (p.bending <= 0.0 || p.bendingMaximum <= 0.0)
        return;
    const Tree& tree = growing.tree();
    const std::vector<BranchLoad> before = loadsOf(growing, flux, p.internodeLength, false);
    const std::vector<BranchLoad> after = loadsOf(growing, flux, p.internodeLength, true);
    const auto counted = [&](const BranchLoad& load, const Vec3& base) {
        return std::floor(kSteps * sagging(p, load, base)) / kSteps;
    };
    std::vector<double> drops(tree.size(), 0.0); // how far nodes may move by what turns so far, m
    for (InternodeId id = 0; id < tree.size(); ++id) {
        if (!flux.takesPart(id) || flux.order(id) == 0)
            continue;
        drops[id] = drops[tree.parent(id)];
        const Vec3 base = growing.index().basePosition(tree, id);
        const double old = counted(before[id], base);
        const double sag = counted(after[id], base);
        if (sag <= old)
            continue;
        const Vec3 heading = growing.heading(id);
        const Vec3 axis = heading.cross(Vec3(0.0F, -1.0F, 0.0F));
        const float sine = axis.norm();
        if (sine < 1e-3F)
            continue;
        const double angle = std::atan2(sine, -heading.y()) * (sag - old) / (1.0 - old);
        // No node of the branch moves further than the angle times its distance.
        const double moved = drops[id] + angle * after[id].reach;
        if (after[id].lowest < moved)
            continue;
        drops[id] = moved;
        const Rotation turn(Eigen::AngleAxisf(static_cast<float>(angle), axis / sine));
        const Rotation carrier = growing.rotation(tree.parent(id));
        growing.turn(id, (carrier.conjugate() * turn * carrier * tree.columns().rotation[id]).normalized());
    }
}

} // namespace espalier
