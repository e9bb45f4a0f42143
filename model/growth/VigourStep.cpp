// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/growth/VigourStep.h"

#include "model/base/Random.h"
#include "model/growth/BudBreak.h"
#include "model/growth/LightPruning.h"
#include "model/growth/Sagging.h"
#include "model/growth/ShootDirection.h"

#include <algorithm>
#include <cmath>

namespace espalier {

namespace {

constexpr double kYearsOfStep = 30.0 / 365.0;
constexpr double kYearsUnderBrush = 0.5;
/// The greatest part of added vigour that a step uses, relative to the step's own length.
constexpr double kMostAddedUse = 2.0;
/// At a share of 1, added vigour makes internodes longer by this part.
constexpr double kAddedLength = 0.6;
/// Spread of the lengths of internodes, relative.
constexpr double kLengthSpread = 0.12;
/// Less growth than this is none, in internodes.
constexpr double kLeastGrowth = 0.01;
/// A remainder that is shorter than this lengthens the internode before, in internodes.
constexpr double kShortest = 0.08;
/// The first internode of a lateral is at least as long, in internodes.
constexpr double kFirstOfLateral = 0.35;
/// How much of the shade a bud with markers does not feel.
constexpr double kBrushLight = 0.5;

/// A bud that grows in this step.
struct VigorousShoot {
    BudRef bud;    ///< Moves up with the tip
    Vec3 space;    ///< E, or zero
    double length; ///< That is left to grow, m
    double full;   ///< Length of its internodes, m
    double vigour; ///< Relative to the step's greatest, 0...1
    int order;     ///< Of its axis
};

/// Grows the shoots of one step of the vigour model.
class ShootGrowth {
public:
    ShootGrowth(GrowingTree& growing, const VoxelSpace& space, const VigourParameters& parameters,
                const GrowthStepOptions& options)
        : m_growing(growing), m_space(space), m_parameters(parameters), m_options(options)
    {
    }

    /// Grows at most one internode, or what its tip's internode lacks to its full length. Sets shoot.length
    /// to 0 when the shoot ends. Returns false if the way was refused.
    bool grow(VigorousShoot& shoot)
    {
        const auto [node, slot] = shoot.bud;
        // A new internode has the length that it gets in this step, and one with branches is mature.
        if (slot == kTerminalSlot && !m_growing.isNew(node) &&
            m_growing.index().firstChild(node) == kNoInternode &&
            m_growing.length(node) < fullLength(shoot, m_growing.key(node))) {
            if (!lengthen(shoot))
                return false;
            if (shoot.length <= 0.0)
                return true;
        }
        return begin(shoot);
    }

private:
    /// The length to which the shoot's internode with the key @p key grows, m.
    static double fullLength(const VigorousShoot& shoot, InternodeKey key)
    {
        Random random(key, 0, Purpose::InternodeLength);
        return shoot.full * std::clamp(1.0 + kLengthSpread * random.normal(), 0.6, 1.4);
    }

    bool isAdmitted(const Vec3& from, const Vec3& to) const
    {
        return (to.y() >= 0.0F || to.y() >= from.y()) && (!m_options.admits || m_options.admits(from, to));
    }

    bool lengthen(VigorousShoot& shoot)
    {
        const InternodeId id = shoot.bud.node;
        const double missing = fullLength(shoot, m_growing.key(id)) - m_growing.length(id);
        // The length that would not make an internode of its own is added here.
        const double by = shoot.length - missing < kShortest * shoot.full ? shoot.length : missing;
        const Vec3 from = m_growing.stretchedPosition(id);
        if (!isAdmitted(from, from + static_cast<float>(by) * m_growing.heading(id)))
            return refuse(shoot);
        m_growing.stretch(id, m_growing.length(id) + static_cast<float>(by));
        shoot.length -= by;
        return true;
    }

    bool begin(VigorousShoot& shoot)
    {
        const Vec3 from = m_growing.stretchedPosition(shoot.bud.node);
        Vec3 direction = shootDirection(m_growing, m_space, m_parameters, shoot.bud, shoot.order);
        if (!shoot.space.isZero()) {
            // γ of the brush: 0.3 turns by half of the angle, 1 by all of it.
            const double gamma = std::clamp(m_options.weights.space, 0.0, 1.0);
            direction = turnedToward(direction, shoot.space, 1.0 - (1.0 - gamma) * (1.0 - gamma));
        }
        const auto [node, slot] = shoot.bud;
        const InternodeKey key = childKey(m_growing.key(node), slot, m_growing.tree().step() + 1);
        double length = std::min(shoot.length, fullLength(shoot, key));
        if (shoot.length - length < kShortest * shoot.full)
            length = shoot.length;
        const auto end = [&] { return Vec3(from + static_cast<float>(length) * direction); };
        if (!isAdmitted(from, end())) {
            length *= 0.5;
            if (!isAdmitted(from, end()))
                return refuse(shoot);
        }
        const double roll = shootRoll(m_growing, m_parameters, shoot.bud);
        const InternodeId id = m_growing.grow(node, slot, direction, roll, length, shoot.vigour);
        shoot.bud = {id, kTerminalSlot};
        shoot.length -= length;
        if (shoot.length < kLeastGrowth * shoot.full)
            shoot.length = 0.0;
        return true;
    }

    static bool refuse(VigorousShoot& shoot)
    {
        shoot.length = 0.0;
        return false;
    }

    GrowingTree& m_growing;
    const VoxelSpace& m_space;
    const VigourParameters& m_parameters;
    const GrowthStepOptions& m_options;
};

/// The shoot that grows from @p bud at the growth rate @p rate; its length is 0 if that is too little.
VigorousShoot shootOf(const VigourFlux& flux, const VigourParameters& p, const BudRef& bud, double rate)
{
    VigorousShoot shoot{bud, Vec3::Zero(), 0.0, 0.0, rate, 0};
    shoot.full = p.internodeLength * (1.0 + kAddedLength * flux.addedShare(bud.node));
    // Added vigour goes into longer internodes, not only into more of them.
    shoot.length = rate * flux.years(bud.node) * p.growthRate * shoot.full / p.internodeLength;
    shoot.order = flux.order(bud.node) + (bud.slot == kTerminalSlot ? 0 : 1);
    if (shoot.length < kLeastGrowth * shoot.full)
        shoot.length = 0.0;
    else if (bud.slot != kTerminalSlot)
        shoot.length = std::max(shoot.length, kFirstOfLateral * shoot.full);
    return shoot;
}

/// The shoots of a step without markers; @p isShed as pruneShaded() returns it.
std::vector<VigorousShoot> freeShoots(const GrowingTree& growing, const VigourFlux& flux,
                                      const VigourParameters& p, const std::vector<std::uint8_t>& isShed)
{
    std::vector<VigorousShoot> shoots;
    const auto add = [&](const BudRef& bud) {
        if (!isShed.empty() && isShed[bud.node] != 0)
            return;
        if (const VigorousShoot shoot = shootOf(flux, p, bud, flux.rate(bud.node)); shoot.length > 0.0)
            shoots.push_back(shoot);
    };
    for (const InternodeId id : flux.nodes()) {
        if ((growing.buds(id) & kTerminalBud) != 0 && flux.mayGrow(id, kTerminalSlot))
            add({id, kTerminalSlot});
    }
    for (const BudRef& bud : breakingBuds(growing, flux, p))
        add(bud);
    double greatest = 0.0;
    for (const VigorousShoot& shoot : shoots)
        greatest = std::max(greatest, shoot.vigour);
    for (VigorousShoot& shoot : shoots)
        shoot.vigour /= greatest;
    return shoots;
}

/// Makes a step without markers of what takes part.
TreeDelta growFree(GrowingTree& growing, const VigourFlux& flux, const VoxelSpace& space,
                   const VigourParameters& p, const GrowthStepOptions& options)
{
    ShootGrowth growth(growing, space, p, options);
    std::vector<std::uint8_t> isShed;
    if (options.sheds)
        isShed = pruneShaded(growing, flux, space, p, bareHeight(flux, p));
    std::vector<VigorousShoot> shoots = freeShoots(growing, flux, p, isShed);
    for (VigorousShoot& shoot : shoots) {
        while (shoot.length > 0.0 && growth.grow(shoot)) {
        }
    }
    sagBranches(growing, flux, p);
    return growing.takeDelta();
}

/// The years of added vigour that each internode's subtree uses in a step, by id; empty if none does. Notes
/// the use in the step.
std::vector<float> useAddedVigour(GrowingTree& growing)
{
    const Tree& tree = growing.tree();
    std::vector<float> years;
    for (const auto& [id, value] : tree.content().sparse.addedVigour.cells()) {
        if (!tree.isAlive(id))
            continue;
        years.resize(tree.size(), 0.0F);
        years[id] = std::min(value, static_cast<float>(kMostAddedUse * kYearsOfStep));
        growing.setAddedVigour(id, value - years[id]);
    }
    if (!years.empty()) {
        for (InternodeId id = 0; id < tree.size(); ++id) {
            if (!tree.isRoot(id))
                years[id] = std::max(years[id], years[tree.parent(id)]);
        }
    }
    return years;
}

/// Grows the shoots in lockstep, with a new competition for the markers after each internode.
void growInLockstep(std::vector<VigorousShoot>& shoots, ShootGrowth& growth, Competition& competition)
{
    std::vector<BudRef> refused;
    while (!shoots.empty()) {
        for (VigorousShoot& shoot : shoots) {
            if (!growth.grow(shoot))
                refused.push_back(shoot.bud);
        }
        std::erase_if(shoots, [](const VigorousShoot& shoot) { return shoot.length <= 0.0; });
        if (shoots.empty())
            break;
        competition.repeat();
        const auto stillFree = competition.enabled();
        std::erase_if(shoots, [&](VigorousShoot& shoot) {
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
}

} // namespace

TreeDelta vigourStep(const Tree& tree, const TreeIndex& index, const VoxelSpace& space,
                     const GrowthStepOptions& options, GrowthWorkspace& workspace)
{
    const VigourParameters p = vigourParametersOf(tree.parameters());
    GrowingTree growing(tree, index, workspace);
    // Selective growth leaves the vigour of the other branches to them.
    std::vector<float> added;
    if (options.competitors.areAll())
        added = useAddedVigour(growing);
    const VigourFlux flux(growing, space, p, {.competitors = options.competitors, .years = kYearsOfStep},
                          std::move(added));
    return growFree(growing, flux, space, p, options);
}

TreeDelta vigourStepToward(const Tree& tree, const TreeIndex& index, const VoxelSpace& space,
                           MarkerSet& markers, const GrowthStepOptions& options, GrowthWorkspace& workspace)
{
    const VigourParameters p = vigourParametersOf(tree.parameters());
    GrowingTree growing(tree, index, workspace);
    Competition competition(growing, space, options.perception, options.competitors, markers);
    competition.admit();
    std::vector<EnabledBud> enabled = competition.enabled();
    if (enabled.empty())
        return growing.takeDelta();
    const VigourFlux flux(growing, space, p, {.competitors = options.competitors, .years = kYearsUnderBrush});

    // Tips that have markers have room. Low branches may be what the user draws, so trunks do not become
    // bare.
    if (options.sheds) {
        std::vector<InternodeId> spared;
        for (const EnabledBud& bud : enabled)
            spared.push_back(bud.bud.node);
        std::ranges::sort(spared);
        const std::vector<std::uint8_t> isShed = pruneShaded(growing, flux, space, p, 0.0, spared);
        // A branch below the ground is shed with all that it carries.
        std::erase_if(enabled, [&](const EnabledBud& bud) {
            return bud.bud.node < isShed.size() && isShed[bud.bud.node] != 0;
        });
    }

    std::vector<VigorousShoot> shoots;
    double greatest = 0.0;
    std::size_t likeliest = enabled.size(); // of the buds that do not break
    double mostLikely = 0.0;
    const auto shootAt = [&](const EnabledBud& bud) {
        const double lit = kBrushLight + (1.0 - kBrushLight) * flux.light(bud.bud.node);
        VigorousShoot shoot = shootOf(flux, p, bud.bud, lit * flux.potential(bud.bud.node));
        shoot.space = bud.space;
        return shoot;
    };
    for (std::size_t i = 0; i < enabled.size(); ++i) {
        const auto [node, slot] = enabled[i].bud;
        const VigorousShoot shoot = shootAt(enabled[i]);
        if (slot != kTerminalSlot) {
            const double chance = flux.order(node) < p.maximumOrder
                                      ? p.flushingRate * std::exp(-flux.inhibitor(node)) * shoot.vigour
                                      : 0.0;
            if (chance > mostLikely) {
                mostLikely = chance;
                likeliest = i;
            }
            if (!breaks(growing, enabled[i].bud, chance))
                continue;
        }
        if (shoot.length > 0.0)
            shoots.push_back(shoot);
    }
    // Growth does not stop before markers that only inhibited buds perceive.
    if (shoots.empty() && likeliest < enabled.size())
        shoots.push_back(shootAt(enabled[likeliest]));
    for (const VigorousShoot& shoot : shoots)
        greatest = std::max(greatest, shoot.vigour);
    std::erase_if(shoots, [&](const VigorousShoot& shoot) {
        return shoot.length <= 0.0 || shoot.vigour < options.leastVigour * greatest;
    });
    for (VigorousShoot& shoot : shoots)
        shoot.vigour /= greatest;

    ShootGrowth growth(growing, space, p, options);
    growInLockstep(shoots, growth, competition);
    return growing.takeDelta();
}

TreeDelta invigorate(const Tree& tree, const TreeIndex& index, const VoxelSpace& space, InternodeId subtree,
                     double added, double used, GrowthWorkspace& workspace)
{
    const VigourParameters p = vigourParametersOf(tree.parameters());
    GrowingTree growing(tree, index, workspace);
    const double whole = tree.content().sparse.addedVigour.at(subtree).value_or(0.0F) + added;
    const double spent = std::min(whole, used);
    growing.setAddedVigour(subtree, static_cast<float>(whole - spent));
    const VigourFlux flux(growing, space, p, {.subtree = subtree},
                          std::vector<float>(tree.size(), static_cast<float>(spent)));
    GrowthStepOptions options;
    options.sheds = false;
    return growFree(growing, flux, space, p, options);
}

} // namespace espalier
