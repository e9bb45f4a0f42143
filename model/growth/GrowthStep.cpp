// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/growth/GrowthStep.h"

#include "model/base/Parallel.h"
#include "model/base/Random.h"
#include "model/growth/BorchertHonda.h"
#include "model/growth/Buds.h"
#include "model/growth/Shedding.h"
#include "model/growth/Straightening.h"

#include <cmath>

namespace espalier {

namespace {

/// Spread at full irregularity. Of roll (rad) and length (relative): the standard deviation. Of direction:
/// the length of a random vector that is added, over α.
constexpr double kRollSpread = radians(30);
constexpr double kLengthSpread = 0.5;
constexpr double kDirectionSpread = 0.12;

/// A bud that grows into a shoot.
struct Shoot {
    BudRef bud;    ///< The bud that grows next: moves up with the shoot's tip
    Vec3 space;    ///< E
    float vigour;  ///< relative to the step's greatest, 0...1
    int remaining; ///< internodes
    int grown = 0;
};

/// Computes the directions of new internodes.
class Orientation {
public:
    Orientation(const GrowingTree& tree, const GrowthStepOptions& options)
        : m_tree(tree), m_options(options), m_parameters(tree.tree().parameters().growth)
    {
    }

    Vec3 of(const Shoot& shoot) const
    {
        const auto [node, slot] = shoot.bud;
        Vec3 heading = m_tree.budDirection(node, slot);
        if (slot == kTerminalSlot && shoot.grown == 0)
            heading = deflected(node, heading);

        const bool isTrunk = slot == kTerminalSlot && m_tree.parent(m_tree.axis(node)) == kNoInternode;
        const double theta = isTrunk && m_parameters.uprightTrunk ? 0.0 : m_options.setPointAngle;
        Random random(m_tree.key(node), static_cast<std::uint32_t>(slot), Purpose::TropismPlane);
        const double azimuth = m_options.isPlanar ? 0.0 : random.uniform(0.0, 2.0 * std::numbers::pi);
        const Vec3 level(static_cast<float>(std::cos(azimuth)), 0.0F, static_cast<float>(std::sin(azimuth)));

        const Vec3 direction =
            growthDirection(m_options.weights, heading, tropismVector(heading, theta, level), shoot.space);
        const auto spread =
            static_cast<float>(m_parameters.irregularity * kDirectionSpread * m_options.weights.axis);
        Random wander(m_tree.key(node), static_cast<std::uint32_t>(slot), Purpose::Direction);
        const Vec3 wandering = direction + spread * wander.direction();
        // Removes what rounding has added outside the plane.
        return (m_options.isPlanar ? Vec3(direction.x(), direction.y(), 0.0F) : wandering).normalized();
    }

private:
    /// The main axis turns by δ away from each lateral that has started at its node, in the plane of the two
    /// (TreeSketch §3.2).
    Vec3 deflected(InternodeId node, const Vec3& heading) const
    {
        Vec3 result = heading;
        if (m_tree.parent(node) == kNoInternode)
            return result; // a root internode has no laterals
        // A bud that sleeps or has died has not started.
        const BudStates states = m_tree.budStates(node);
        const auto started = static_cast<unsigned>(newBuds(m_tree.grownWith(node)) &
                                                   ~(states.living | states.other) & ~kTerminalBud);
        for (unsigned rest = started; rest != 0; rest &= rest - 1) {
            const Vec3 lateral = m_tree.budDirection(node, std::countr_zero(rest));
            const Vec3 axis = heading.cross(lateral);
            if (axis.norm() > 1e-4F)
                result =
                    Eigen::AngleAxisf(-static_cast<float>(m_parameters.deflectionAngle), axis.normalized()) *
                    result;
        }
        return result;
    }

    const GrowingTree& m_tree;
    const GrowthStepOptions& m_options;
    const GrowthParameters& m_parameters;
};

/// The roll of the internode that grows from a bud of a planar tree, 0 or π: the sum of φ along the axis
/// decides on which side of the plane the next lateral is.
double planarRoll(const GrowingTree& tree, const BudRef& bud)
{
    if (bud.slot != kTerminalSlot)
        return 0.0;
    int place = 0; // along the axis
    for (InternodeId id = bud.node; tree.parent(id) != kNoInternode && tree.slot(id) == kTerminalSlot;
         id = tree.parent(id))
        ++place;
    const auto isTurned = [&](int at) {
        return std::cos(at * tree.tree().parameters().growth.phyllotaxis) < -1e-9;
    };
    return isTurned(place) == isTurned(place + 1) ? 0.0 : std::numbers::pi;
}

/// Grows one internode; if it is not admitted or would end below the ground, one of half the length. Returns
/// its id, or kNoInternode if neither is possible.
InternodeId growOne(GrowingTree& tree, const Shoot& shoot, const Vec3& direction,
                    const GrowthStepOptions& options = {})
{
    const GrowthParameters& p = tree.tree().parameters().growth;
    const auto [node, slot] = shoot.bud;
    Random random(tree.key(node), static_cast<std::uint32_t>(slot), Purpose::Phyllotaxis);
    // A branch starts with a random roll; along an axis, the phyllotactic angle is added.
    double roll = slot == kTerminalSlot ? p.phyllotaxis + p.irregularity * kRollSpread * random.normal()
                                        : random.uniform(0.0, 2.0 * std::numbers::pi);
    if (options.isPlanar)
        roll = planarRoll(tree, shoot.bud);
    const double stretch = std::clamp(1.0 + p.irregularity * kLengthSpread * random.normal(), 0.35, 1.9);
    double length = p.internodeLength * stretch;
    const Vec3& from = tree.nodePosition(node);
    const auto isAdmitted = [&] {
        const Vec3 to = from + static_cast<float>(length) * direction;
        // A shoot that grows downward ends at the ground.
        return (to.y() >= 0.0F || to.y() >= from.y()) && (!options.admits || options.admits(from, to));
    };
    if (!isAdmitted()) {
        length *= 0.5;
        if (!isAdmitted())
            return kNoInternode;
    }
    return tree.grow(node, slot, direction, roll, length, shoot.vigour);
}

std::vector<Shoot> startShoots(const std::vector<EnabledBud>& enabled, VigourFlow& flow,
                               const GrowthStepOptions& options, int longest)
{
    std::vector<double> vigours;
    vigours.reserve(enabled.size());
    double greatest = 0.0;
    for (const EnabledBud& bud : enabled) {
        vigours.push_back(flow.ofBud(bud.bud.node, bud.bud.slot));
        greatest = std::max(greatest, vigours.back());
    }
    std::vector<Shoot> shoots;
    for (std::size_t i = 0; i < enabled.size(); ++i) {
        const int length = shootLength(vigours[i], greatest, longest);
        if (length > 0 && vigours[i] >= options.leastVigour * greatest)
            shoots.push_back(
                {enabled[i].bud, enabled[i].space, static_cast<float>(vigours[i] / greatest), length});
    }
    return shoots;
}

/// Grows the enabled buds into shoots, in lockstep, and sheds the branches that they shade too much.
void growShoots(GrowingTree& growing, const GrowthIndex& growth, VigourFlow& flow, Competition& competition,
                const GrowthStepOptions& options, GrowthWorkspace& workspace)
{
    const Orientation orientation(growing, options);
    std::vector<Shoot> shoots =
        startShoots(competition.enabled(), flow, options, growing.tree().parameters().growth.maxShootLength);
    std::vector<InternodeId> growingAt;
    for (const Shoot& shoot : shoots)
        growingAt.push_back(shoot.bud.node);

    std::vector<BudRef> refused;
    while (!shoots.empty()) {
        // By ascending node and slot: laterals that start at a node must have deflected its axis before that
        // grows.
        for (Shoot& shoot : shoots) {
            const InternodeId id = growOne(growing, shoot, orientation.of(shoot), options);
            if (id == kNoInternode) {
                refused.push_back(shoot.bud);
                shoot.remaining = 0;
                continue;
            }
            shoot.bud = {id, kTerminalSlot};
            ++shoot.grown;
            --shoot.remaining;
        }
        std::erase_if(shoots, [](const Shoot& shoot) { return shoot.remaining == 0; });
        if (shoots.empty())
            break;
        competition.repeat();
        const auto stillFree = competition.enabled(growing.tree().size()); // the shoots' tips are new nodes
        std::erase_if(shoots, [&](Shoot& shoot) {
            const auto found = std::ranges::lower_bound(stillFree, shoot.bud, {}, &EnabledBud::bud);
            if (found == stillFree.end() || found->bud != shoot.bud)
                return true;
            shoot.space = found->space;
            return false;
        });
    }
    if (!refused.empty()) {
        std::ranges::sort(refused);
        competition.dropOwned(refused);
    }
    if (options.straightens)
        straightenWood(growing, growingAt, workspace);
    if (options.sheds)
        shedBranches(growing, growth, flow, growingAt, workspace);
}

struct VigorousBud {
    BudRef bud;
    double vigour;
};

/// All competing buds with a vigour above 0.
std::vector<VigorousBud> competingBuds(const GrowingTree& growing, VigourFlow& flow,
                                       const Competitors& competitors)
{
    std::vector<VigorousBud> buds;
    const Tree& tree = growing.tree();
    for (InternodeId id = 0; id < tree.size(); ++id) {
        if (!tree.isAlive(id))
            continue;
        for (unsigned rest = tree.buds(id); rest != 0; rest &= rest - 1) {
            const BudRef bud{id, std::countr_zero(rest)};
            const double vigour = competes(growing, competitors, bud) ? flow.ofBud(id, bud.slot) : 0.0;
            if (vigour > 0.0)
                buds.push_back({bud, vigour});
        }
    }
    return buds;
}

/// Places markers above the ground, uniformly in the bud's volume of perception: the cone of angle ζ between
/// the radii r and r + d, or, for a planar tree, its section with the plane. Writes at most markersPerBud to
/// @p markers, and returns how many.
std::size_t placeBudMarkers(const GrowingTree& growing, const BudRef& bud, const GrowthStepOptions& options,
                            Vec3* markers)
{
    const Perception& perception = options.perception;
    const Tree& tree = growing.tree();
    std::size_t count = 0;
    const Vec3 heading = growing.budDirection(bud.node, bud.slot);
    const Vec3 side = options.isPlanar ? Vec3(heading.y(), -heading.x(), 0.0F) : anyPerpendicular(heading);
    const Vec3 other = heading.cross(side);
    const double dimensions = options.isPlanar ? 2.0 : 3.0;
    const double inner = std::pow(perception.occupancy, dimensions);
    const double outer = std::pow(perception.reach, dimensions);
    const double halfAngle = options.isPlanar ? std::acos(static_cast<double>(perception.cosHalfAngle)) : 0.0;
    Random random(childKey(growing.key(bud.node), bud.slot, tree.step()), 0, Purpose::BudMarker);
    for (int i = 0; i < tree.parameters().growth.markersPerBud; ++i) {
        const double within = random.uniform(inner, outer);
        const double radius = options.isPlanar ? std::sqrt(within) : std::cbrt(within);
        double cosine = random.uniform(static_cast<double>(perception.cosHalfAngle), 1.0);
        double azimuth = random.uniform(0.0, 2.0 * std::numbers::pi);
        if (options.isPlanar) {
            cosine = std::cos(halfAngle * random.uniform());
            azimuth = azimuth < std::numbers::pi ? 0.0 : std::numbers::pi;
        }
        const double sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
        const Vec3 direction = static_cast<float>(cosine) * heading +
                               static_cast<float>(sine * std::cos(azimuth)) * side +
                               static_cast<float>(sine * std::sin(azimuth)) * other;
        const Vec3 marker = growing.nodePosition(bud.node) + static_cast<float>(radius) * direction;
        if (marker.y() >= 0.0F)
            markers[count++] = marker;
    }
    return count;
}

/// Adds the markers of @p buds. Returns the bud of each new marker.
std::vector<BudRef> layMarkers(const GrowingTree& growing, std::span<const VigorousBud> buds,
                               const GrowthStepOptions& options, MarkerSet& markers)
{
    constexpr std::size_t kBudsPerTask = 64;
    const auto perBud = static_cast<std::size_t>(growing.tree().parameters().growth.markersPerBud);
    std::vector<Vec3> places(perBud * buds.size());
    std::vector<std::size_t> counts(buds.size());
    parallelFor(buds.size(), kBudsPerTask, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            counts[i] = placeBudMarkers(growing, buds[i].bud, options, places.data() + perBud * i);
    });

    std::vector<BudRef> perceivers;
    for (std::size_t i = 0; i < buds.size(); ++i) {
        const Vec3* const first = places.data() + perBud * i;
        markers.positions.insert(markers.positions.end(), first, first + counts[i]);
        perceivers.insert(perceivers.end(), counts[i], buds[i].bud);
    }
    markers.born.resize(markers.size(), growing.tree().step());
    return perceivers;
}

} // namespace

GrowthStepOptions GrowthStepOptions::of(const GrowthParameters& p)
{
    GrowthStepOptions options;
    options.weights = {p.axisWeight, p.tropismWeight, p.spaceWeight};
    options.perception = Perception::of(p);
    options.setPointAngle = p.setPointAngle;
    return options;
}

int shootLength(double vigour, double greatestVigour, int longest)
{
    return greatestVigour > 0.0 ? static_cast<int>(std::floor(vigour / greatestVigour * longest)) : 0;
}

TreeDelta growthStep(const Tree& tree, const TreeIndex& index, const GrowthIndex& growth, MarkerSet& markers,
                     const GrowthStepOptions& options, GrowthWorkspace& workspace)
{
    GrowingTree growing(tree, index, workspace);
    VigourFlow flow(tree, index, growth, workspace.vigour);
    Competition competition(growing, growth.space(), options.perception, options.competitors, markers);
    competition.admit();
    growShoots(growing, growth, flow, competition, options, workspace);
    return growing.takeDelta();
}

TreeDelta autonomousStep(const Tree& tree, const TreeIndex& index, const GrowthIndex& growth,
                         const GrowthStepOptions& options, GrowthWorkspace& workspace)
{
    GrowingTree growing(tree, index, workspace);
    VigourFlow flow(tree, index, growth, workspace.vigour);
    std::vector<VigorousBud> buds = competingBuds(growing, flow, options.competitors);

    // A bud grows if v >= v_max / n_max, where v_max is the vigour of the strongest enabled bud. That is
    // known only after enough of the strong buds have competed. So markers are placed for weaker and weaker
    // buds, until the remaining ones could not grow.
    const int longest = tree.parameters().growth.maxShootLength;
    MarkerSet markers;
    Competition competition(growing, growth.space(), options.perception, options.competitors, markers);
    double greatest = 0.0; // of the enabled buds
    double least = std::numeric_limits<double>::infinity();
    for (auto rest = buds.begin(); rest != buds.end();) {
        // If none of the stronger buds found free space, weaker ones compete.
        if (greatest == 0.0)
            least = std::min(least / 2.0,
                             std::ranges::max_element(rest, buds.end(), {}, &VigorousBud::vigour)->vigour /
                                 longest);
        const auto strong = rest;
        rest = std::partition(rest, buds.end(), [&](const VigorousBud& bud) { return bud.vigour >= least; });
        if (rest == strong)
            break;
        std::sort(strong, rest, [](const VigorousBud& a, const VigorousBud& b) {
            return a.vigour != b.vigour ? a.vigour > b.vigour : a.bud < b.bud;
        });
        competition.admit(layMarkers(growing, std::span(strong, rest), options, markers));
        competition.forEachOwner(
            [&](const BudRef& owner) { greatest = std::max(greatest, flow.ofBud(owner.node, owner.slot)); });
        if (greatest > 0.0)
            least = greatest / longest;
    }
    growShoots(growing, growth, flow, competition, options, workspace);
    return growing.takeDelta();
}

InternodeId trunkTip(const TreeIndex& index, InternodeId root)
{
    InternodeId tip = root;
    while (index.mainChild(tip) != kNoInternode)
        tip = index.mainChild(tip);
    return tip;
}

TreeDelta growLeader(const Tree& tree, const TreeIndex& index, const BudRef& bud, const Vec3& target,
                     float distance, int count, GrowthWorkspace& workspace)
{
    GrowingTree growing(tree, index, workspace);
    BudRef tip = bud;
    for (int i = 0; i < count && (growing.buds(tip.node) & budBit(tip.slot)) != 0; ++i) {
        const Vec3 toTarget = target - growing.nodePosition(tip.node);
        if (toTarget.norm() <= distance)
            break;
        const Vec3 heading = growing.budDirection(tip.node, tip.slot);
        const Vec3 direction = growthDirection({0.6, 0.0, 0.4}, heading, heading, toTarget.normalized());
        const InternodeId grown = growOne(growing, {tip, toTarget, 1.0F, 1}, direction);
        if (grown == kNoInternode)
            break;
        tip = {grown, kTerminalSlot};
    }
    return growing.takeDelta();
}

} // namespace espalier
