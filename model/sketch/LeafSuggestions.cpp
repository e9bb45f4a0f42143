// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/sketch/LeafSuggestions.h"

#include "model/sketch/LeafPlacement.h"
#include "model/tree/PlacedLeafIndex.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace espalier {

namespace {

constexpr double kFullTurn = 2.0 * std::numbers::pi;
/// The sine of the angle between branch and midrib below which the upper side gives a leaf's azimuth.
constexpr double kUprightLeaf = 1e-3;
/// A leaf whose angle is off by less, rad, stays.
constexpr double kSameAngle = 1e-6;

/// @p angle, rad, as -period/2...period/2.
double wrapped(double angle, double period)
{
    return std::remainder(angle, period);
}

/// The turn around +Y that takes +X to the azimuth, from +X toward +Z.
Eigen::Quaterniond turnTo(double azimuth)
{
    return Eigen::Quaterniond(Eigen::AngleAxisd(-azimuth, Eigen::Vector3d::UnitY()));
}

/// A placed leaf on a branch.
struct LeafSample {
    LeafId id = kNoLeaf;
    double distance = 0.0; ///< m, from the branch's base
    double azimuth = 0.0;  ///< rad, in the carried frame
    /// The carried frame of the leaf, turned back to the azimuth 0.
    Eigen::Quaterniond frame = Eigen::Quaterniond::Identity();
    double length = 0.0; ///< m
};

/// The azimuth of a leaf's frame against the carried frame, rad.
double frameAzimuth(const Eigen::Quaterniond& frame)
{
    Eigen::Vector3d pointer = frame * Eigen::Vector3d::UnitY();
    if (std::hypot(pointer.x(), pointer.z()) < kUprightLeaf)
        pointer = frame * Eigen::Vector3d::UnitZ();
    return std::atan2(pointer.z(), pointer.x());
}

LeafSample sampleOf(const Tree& tree, const BranchFrames& branch, LeafId id, double distance)
{
    const LeafRow row = leafRow(tree, id);
    const Eigen::Quaterniond carried = branch.carriedFrom(row.internode, row.rotation);
    const double azimuth = frameAzimuth(carried);
    return {.id = id,
            .distance = distance,
            .azimuth = azimuth,
            .frame = (turnTo(azimuth).conjugate() * carried).normalized(),
            .length = static_cast<double>(row.length)};
}

/// The leaves at one place of a branch, the oldest first.
using Whorl = std::vector<LeafSample>;

/// The whorls of the leaves of a kind on a branch, from the base to the tip.
std::vector<Whorl> whorlsOf(const Tree& tree, const BranchFrames& branch, LeafKind kind)
{
    const LeafColumns& rows = tree.placedLeaves();
    Whorl all;
    for (LeafId id = 0; id < rows.size(); ++id) {
        if (rows.death[id] != kNever || rows.kind[id] != kind)
            continue;
        if (const auto distance = branch.distanceOf({rows.internode[id], rows.along[id]}))
            all.push_back(sampleOf(tree, branch, id, *distance));
    }
    std::ranges::stable_sort(all, {}, &LeafSample::distance);
    std::vector<Whorl> whorls;
    const double tolerance = kWhorlTolerance * branch.length();
    double begin = 0.0;
    for (const LeafSample& leaf : all) {
        if (whorls.empty() || leaf.distance - begin > tolerance) {
            whorls.emplace_back();
            begin = leaf.distance;
        }
        whorls.back().push_back(leaf);
    }
    for (Whorl& whorl : whorls)
        std::ranges::sort(whorl, {}, &LeafSample::id);
    return whorls;
}

/// The form that new leaves get from samples.
struct LeafForm {
    Eigen::Quaterniond frame = Eigen::Quaterniond::Identity(); ///< At the azimuth 0
    double length = 0.0;                                       ///< m
};

/// @p frame, or its other side up, whichever is nearer to @p sample: the upper sides of leaves that are drawn
/// all look at the viewer, whichever side of the branch they are on.
Eigen::Quaterniond faceUpLike(const Eigen::Quaterniond& sample, const Eigen::Quaterniond& frame)
{
    const Eigen::Quaterniond over =
        frame * Eigen::Quaterniond(Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitY()));
    return std::abs(over.dot(sample)) > std::abs(frame.dot(sample)) + kSameAngle ? over : frame;
}

LeafForm meanForm(std::initializer_list<const Whorl*> samples)
{
    const Eigen::Quaterniond first = (*samples.begin())->front().frame;
    Eigen::Vector4d sum = Eigen::Vector4d::Zero();
    double length = 0.0;
    std::size_t count = 0;
    for (const Whorl* const whorl : samples) {
        for (const LeafSample& leaf : *whorl) {
            const Eigen::Quaterniond frame = faceUpLike(first, leaf.frame);
            const double sign = frame.dot(first) < 0.0 ? -1.0 : 1.0;
            sum += sign * frame.coeffs();
            length += leaf.length;
            ++count;
        }
    }
    Eigen::Quaterniond frame = first;
    if (sum.norm() > 1e-6)
        frame.coeffs() = sum.normalized();
    // Where samples are rolled, their mean need not point where they do.
    frame = (turnTo(frameAzimuth(frame)).conjugate() * frame).normalized();
    return {.frame = frame, .length = length / static_cast<double>(count)};
}

/// Arranges leaves along one branch.
class Arranging {
public:
    Arranging(const Tree& tree, const BranchFrames& branch, const std::vector<Whorl>& whorls,
              std::size_t chosen)
        : m_tree(tree), m_branch(branch), m_whorls(whorls), m_chosen(whorls[chosen])
    {
        double nearest = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < whorls.size(); ++i) {
            const double distance = std::abs(placeOf(whorls[i]) - placeOf(m_chosen));
            if (distance > kWhorlTolerance * branch.length() && distance < nearest) {
                nearest = distance;
                m_other = &whorls[i];
            }
        }
    }

    /// Whether the engine applies; if it does, delta() has what it suggests.
    bool arrange(LeafEngine engine)
    {
        m_delta = deltaStartingAt(m_tree);
        if (engine == LeafEngine::AddToWhorl)
            return addToWhorl();
        if (m_other == nullptr)
            return false;
        switch (engine) {
        case LeafEngine::ExtendWhorls:
            return extendWhorls();
        case LeafEngine::Alternate:
            return alternate();
        case LeafEngine::Opposite:
            return inPairs(0.0);
        default:
            return inPairs(0.25 * kFullTurn);
        }
    }
    TreeDelta takeDelta() { return std::move(m_delta); }

private:
    static double placeOf(const Whorl& whorl) { return whorl.front().distance; }

    LeafRow rowAt(const BranchPlace& place, double azimuth, const LeafForm& form) const
    {
        LeafRow row;
        row.internode = place.internode;
        row.along = place.along;
        row.rotation = m_branch.localFrom(place.internode, (turnTo(azimuth) * form.frame).normalized());
        row.length = static_cast<float>(form.length);
        row.kind = m_tree.placedLeaves().kind[m_chosen.front().id];
        return row;
    }
    BranchPlace placeOfRow(LeafId id) const
    {
        return {m_tree.placedLeaves().internode[id], m_tree.placedLeaves().along[id]};
    }

    /// Adds the leaves of a new whorl of @p count leaves at a distance from the base.
    void addWhorl(double distance, double azimuth, std::size_t count, const LeafForm& form)
    {
        const BranchPlace place = m_branch.placeAt(distance);
        for (std::size_t i = 0; i < count; ++i)
            addLeaf(m_delta, rowAt(place, azimuth + share(i, count), form));
    }
    static double share(std::size_t i, std::size_t count)
    {
        return kFullTurn * static_cast<double>(i) / static_cast<double>(count);
    }

    /// Calls @p add(distance, k) for the places at k times the spacing from the first sample, within the
    /// branch's ends, that have no leaves; k is neither 0 nor 1, which are the samples.
    template <class Add>
    void forEachFreePlace(double first, double spacing, Add&& add) const
    {
        const double length = m_branch.length();
        const double slack = 1e-6 * length;
        const double tolerance = kWhorlTolerance * length;
        // From the base to the tip.
        const auto most = static_cast<int>(length / std::abs(spacing)) + 1;
        for (int step = -most; step <= most; ++step) {
            const int k = spacing > 0.0 ? step : -step;
            const double distance = first + k * spacing;
            if (k == 0 || k == 1 || distance < -slack || distance > length + slack)
                continue;
            const bool isFree = std::ranges::none_of(m_whorls, [&](const Whorl& whorl) {
                return std::ranges::any_of(whorl, [&](const LeafSample& leaf) {
                    return std::abs(leaf.distance - distance) <= tolerance;
                });
            });
            if (isFree)
                add(std::clamp(distance, 0.0, length), k);
        }
    }

    bool addToWhorl()
    {
        const std::size_t count = m_chosen.size() + 1;
        if (count > kMostOfWhorl)
            return false;
        const LeafForm form = meanForm({&m_chosen});
        const LeafSample& oldest = m_chosen.front();
        const BranchPlace place = placeOfRow(oldest.id);
        // In their order around the branch, so that each leaf moves as little as possible.
        Whorl around = m_chosen;
        std::ranges::stable_sort(around, {}, [&](const LeafSample& leaf) {
            const double angle = wrapped(leaf.azimuth - oldest.azimuth, kFullTurn);
            return angle < 0.0 ? angle + kFullTurn : angle;
        });
        for (std::size_t i = 0; i < around.size() && around.size() > 1; ++i) {
            LeafRow row = rowAt(place, oldest.azimuth + share(i, count), form);
            row.length = m_tree.placedLeaves().length[around[i].id];
            moveLeaf(m_delta, m_tree, around[i].id, row);
        }
        addLeaf(m_delta, rowAt(place, oldest.azimuth + share(count - 1, count), form));
        return true;
    }

    bool extendWhorls()
    {
        const bool isChosenLarger = m_chosen.size() > m_other->size();
        const Whorl& whorl = isChosenLarger ? m_chosen : *m_other;
        const Whorl& sample = isChosenLarger ? *m_other : m_chosen;
        const std::size_t count = whorl.size();
        if (count < 2 || count > kMostOfWhorl)
            return false;
        const LeafForm form = meanForm({&whorl});
        const double azimuth = whorl.front().azimuth;
        const double turn = wrapped(sample.front().azimuth - azimuth, kFullTurn / static_cast<double>(count));
        const double spacing = placeOf(sample) - placeOf(whorl);
        // The leaves of the second sample keep their places in its whorl.
        std::vector<bool> isTaken(count, false);
        for (const LeafSample& leaf : sample) {
            const double place = wrapped(leaf.azimuth - azimuth - turn, kFullTurn) / share(1, count);
            const auto slot = static_cast<std::int64_t>(std::llround(place));
            const auto size = static_cast<std::int64_t>(count);
            isTaken[static_cast<std::size_t>((slot % size + size) % size)] = true;
        }
        const BranchPlace samplePlace = placeOfRow(sample.front().id);
        for (std::size_t i = 0; i < count && sample.size() < count; ++i) {
            if (!isTaken[i])
                addLeaf(m_delta, rowAt(samplePlace, azimuth + turn + share(i, count), form));
        }
        forEachFreePlace(placeOf(whorl), spacing, [&](double distance, int k) {
            addWhorl(distance, azimuth + k * turn, count, form);
        });
        return true;
    }

    bool alternate()
    {
        if (m_chosen.size() != 1 || m_other->size() != 1)
            return false;
        const LeafForm form = meanForm({m_other, &m_chosen});
        const double azimuth = m_other->front().azimuth;
        const double turn = wrapped(m_chosen.front().azimuth - azimuth, kFullTurn);
        forEachFreePlace(placeOf(*m_other), placeOf(m_chosen) - placeOf(*m_other),
                         [&](double distance, int k) { addWhorl(distance, azimuth + k * turn, 1, form); });
        return true;
    }

    /// Turns the leaves of a sample into a pair at @p azimuth and opposite to it.
    void completePair(const Whorl& sample, double azimuth, const LeafForm& form)
    {
        const BranchPlace place = placeOfRow(sample.front().id);
        const double side = std::cos(sample.front().azimuth - azimuth) >= 0.0 ? 0.0 : 0.5 * kFullTurn;
        for (std::size_t i = 0; i < 2; ++i) {
            const double wanted = azimuth + side + share(i, 2);
            if (i >= sample.size()) {
                addLeaf(m_delta, rowAt(place, wanted, form));
                continue;
            }
            const LeafSample& leaf = sample[i];
            if (std::abs(wrapped(leaf.azimuth - wanted, kFullTurn)) <= kSameAngle)
                continue;
            moveLeaf(m_delta, m_tree, leaf.id,
                     rowAt(placeOfRow(leaf.id), wanted, {.frame = leaf.frame, .length = leaf.length}));
        }
    }

    bool inPairs(double turn)
    {
        if (m_chosen.size() > 2 || m_other->size() > 2)
            return false;
        const bool isChosenFirst = m_chosen.size() > m_other->size();
        const Whorl& first = isChosenFirst ? m_chosen : *m_other;
        const Whorl& second = isChosenFirst ? *m_other : m_chosen;
        const LeafForm form = meanForm({&first, &second});
        const double azimuth = first.front().azimuth;
        completePair(first, azimuth, form);
        completePair(second, azimuth + turn, form);
        forEachFreePlace(placeOf(first), placeOf(second) - placeOf(first),
                         [&](double distance, int k) { addWhorl(distance, azimuth + k * turn, 2, form); });
        return true;
    }

    const Tree& m_tree;
    const BranchFrames& m_branch;
    const std::vector<Whorl>& m_whorls;
    const Whorl& m_chosen;
    const Whorl* m_other = nullptr;
    TreeDelta m_delta;
};

/// The kind of the leaf of a branch that is nearest to a distance from its base, the youngest of equals.
std::optional<LeafKind> nearestKind(const Tree& tree, const BranchFrames& branch, double distance)
{
    const LeafColumns& rows = tree.placedLeaves();
    std::optional<LeafKind> kind;
    double nearest = std::numeric_limits<double>::infinity();
    for (LeafId id = 0; id < rows.size(); ++id) {
        if (rows.death[id] != kNever)
            continue;
        const auto here = branch.distanceOf({rows.internode[id], rows.along[id]});
        if (here && std::abs(*here - distance) <= nearest) {
            nearest = std::abs(*here - distance);
            kind = rows.kind[id];
        }
    }
    return kind;
}

} // namespace

std::vector<LeafSuggestion> suggestLeaves(const Tree& tree, const TreeIndex& index, const BranchPlace& place)
{
    std::vector<LeafSuggestion> suggestions;
    if (!tree.isAlive(place.internode))
        return suggestions;
    const BranchFrames branch(tree, index, place.internode);
    const double distance = branch.distanceOf(place).value_or(0.0);
    const std::optional<LeafKind> kind = nearestKind(tree, branch, distance);
    if (!kind)
        return suggestions;
    const std::vector<Whorl> whorls = whorlsOf(tree, branch, *kind);
    const auto away = [&](const Whorl& whorl) {
        return std::abs(
            std::ranges::min(whorl, {},
                             [&](const LeafSample& leaf) { return std::abs(leaf.distance - distance); })
                .distance -
            distance);
    };
    const auto chosen = std::ranges::min_element(whorls, {}, away);
    Arranging arranging(tree, branch, whorls, static_cast<std::size_t>(chosen - whorls.begin()));
    for (const LeafEngine engine : kLeafEngines) {
        if (!arranging.arrange(engine))
            continue;
        TreeDelta delta = arranging.takeDelta();
        if (!delta.isEmpty())
            suggestions.push_back({.engine = engine, .delta = std::move(delta)});
    }
    return suggestions;
}

} // namespace espalier
