// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/shape/WidthRegions.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace espalier {

namespace {

constexpr double kSmallestRegionExponent = 0.5;
constexpr double kLargestRegionExponent = 10.0;
constexpr int kMostIterations = 60;
constexpr double kSmallestTip = 1e-9; ///< m
constexpr double kLargestDiameter = 1e6;
/// A seedling for a thick tree is at most as thick as this share of its length.
constexpr double kThickestStem = 1.0 / 3.0;
constexpr std::uint32_t kRegionTableSize = 1024;

/// ln Σ c_i d_i^n, and its derivative by n.
struct LogSum {
    double value = 0.0;
    double slope = 0.0;
};

LogSum logSum(double exponent, std::span<const WidthExtremities> extremities)
{
    double largest = -std::numeric_limits<double>::infinity();
    for (const WidthExtremities& e : extremities)
        largest = std::max(largest, exponent * e.logDiameter);
    double sum = 0.0;
    double weighted = 0.0;
    for (const WidthExtremities& e : extremities) {
        const double term = e.count * std::exp(exponent * e.logDiameter - largest);
        sum += term;
        weighted += term * e.logDiameter;
    }
    return {largest + std::log(sum), weighted / sum};
}

/// The exponent for a base that is thicker than each of several extremities.
double solveExponent(double logBase, std::span<const WidthExtremities> extremities)
{
    double count = 0.0;
    double thinnest = logBase;
    double thickest = -std::numeric_limits<double>::infinity();
    for (const WidthExtremities& e : extremities) {
        count += e.count;
        thinnest = std::min(thinnest, e.logDiameter);
        thickest = std::max(thickest, e.logDiameter);
    }
    double low = std::log(count) / (logBase - thinnest);
    double high = std::log(count) / (logBase - thickest);
    double exponent = low;
    for (int i = 0; i < kMostIterations; ++i) {
        const LogSum sum = logSum(exponent, extremities);
        const double excess = sum.value - exponent * logBase;
        (excess > 0.0 ? low : high) = exponent;
        double next = exponent - excess / (sum.slope - logBase);
        if (!(next >= low && next <= high))
            next = 0.5 * (low + high);
        if (std::abs(next - exponent) <= 1e-15 * exponent)
            return next;
        exponent = next;
    }
    return exponent;
}

/// Computes the radii; one object for each call of constrainedRadii.
class Regions {
public:
    Regions(const Tree& tree, const TreeIndex& index, std::span<const WidthConstraint> constraints,
            double power)
        : m_tree(tree),
          m_index(index),
          m_parameters(tree.parameters().widths),
          m_constraints(constraints),
          m_power(power),
          m_logTip(std::log(std::max(m_parameters.tipDiameter, kSmallestTip)))
    {
    }

    std::vector<float> radii()
    {
        findRegions();
        for (Region& region : m_regions)
            solve(region);
        fill();
        std::ranges::sort(m_crossings, {}, &Crossing::id);
        for (auto first = m_crossings.begin(); first != m_crossings.end();) {
            const auto last = std::find_if(
                first, m_crossings.end(), [&](const Crossing& crossing) { return crossing.id != first->id; });
            m_radii[first->id] = radiusOf(std::span(first, last));
            first = last;
        }
        for (const WidthConstraint& constraint : m_constraints)
            m_radii[constraint.id] = static_cast<float>(std::exp(logOf(constraint)) / 2.0);
        return std::move(m_radii);
    }

private:
    /// The part of the tree between a base and the extremities above it.
    struct Region {
        InternodeId base = 0;
        std::optional<double> logBase;
        std::vector<std::uint32_t> ends; ///< Constraints that are extremities
        WidthLaw law{1.0, 0.0};
        /// For internodes that carry twigs only: ln d = ln d_e + power · ln tips
        double power = 1.0;
        std::vector<float> table; ///< Radii of small tip counts
    };
    /// An internode below one of its region's ends.
    struct Crossing {
        InternodeId id;
        std::uint32_t region;
        std::uint32_t tips; ///< Number of tips that the end carries
        double logDiameter; ///< Of the end's diameter
        double share;       ///< 1 at the base, 0 at the end, by the length between
    };

    double logOf(const WidthConstraint& constraint) const
    {
        const auto diameter = static_cast<double>(constraint.value);
        return diameter > 0.0 ? std::log(std::clamp(diameter, kSmallestTip, kLargestDiameter)) : m_logTip;
    }

    /// The base diameter of the trunk of a living root, m, where @p mostTips is the greatest number of tips
    /// of a trunk: the parameter for a trunk of so many tips, less for the others. If all trunks are still
    /// single axes, limited by the trunk's length.
    double baseDiameter(InternodeId root, std::uint32_t mostTips) const
    {
        if (mostTips > 1) {
            const std::uint32_t tips = m_index.tipCount(root);
            return tips == mostTips ? m_parameters.baseDiameter
                                    : std::exp(m_logTip + m_power * std::log(static_cast<double>(tips)));
        }
        double length = 0.0;
        for (InternodeId id = root; id != kNoInternode; id = m_index.firstChild(id))
            length += static_cast<double>(m_tree.length(id));
        return std::min(m_parameters.baseDiameter,
                        std::max(m_parameters.tipDiameter, kThickestStem * length));
    }

    /// The first regions are those at the bases of the roots, in their order; the others are those above the
    /// constraints, in their order.
    void findRegions()
    {
        const std::span<const InternodeId> roots = m_index.roots();
        const std::uint32_t mostTips = m_index.greatestTipCount();
        m_regions.resize(roots.size() + m_constraints.size());
        for (std::size_t i = 0; i < roots.size(); ++i) {
            m_regions[i].base = roots[i];
            if (m_parameters.baseDiameter > 0.0 && m_index.tipCount(roots[i]) > 0)
                m_regions[i].logBase = std::log(std::max(baseDiameter(roots[i], mostTips), kSmallestTip));
        }
        m_regionOf.assign(m_tree.size(), 0);
        const InternodeId* parents = m_tree.columns().parent.constData();
        std::uint32_t nextRoot = 1;
        std::size_t next = 0;
        // All internodes before these belong to the region of the first root.
        const InternodeId secondRoot = roots.size() > 1 ? roots[1] : m_tree.size();
        const InternodeId first =
            m_constraints.empty() ? secondRoot : std::min(secondRoot, m_constraints.front().id);
        for (InternodeId id = first; id < m_tree.size(); ++id) {
            const bool isRoot = parents[id] == kNoInternode;
            std::uint32_t below = 0;
            if (!isRoot)
                below = m_regionOf[parents[id]];
            else if (id != roots.front())
                below = nextRoot++;
            m_regionOf[id] = below;
            if (next == m_constraints.size() || m_constraints[next].id != id)
                continue;
            if (!isRoot)
                m_regions[below].ends.push_back(static_cast<std::uint32_t>(next));
            const std::size_t above = roots.size() + next;
            m_regionOf[id] = static_cast<std::uint32_t>(above);
            m_regions[above].base = id;
            m_regions[above].logBase = logOf(m_constraints[next]);
            ++next;
        }
    }

    void solve(Region& region)
    {
        const auto self = static_cast<std::uint32_t>(&region - m_regions.data());
        std::uint32_t twigs = m_index.tipCount(region.base);
        std::vector<WidthExtremities> extremities;
        for (const std::uint32_t end : region.ends) {
            twigs -= m_index.tipCount(m_constraints[end].id);
            extremities.push_back({1.0, logOf(m_constraints[end])});
        }
        if (twigs > 0)
            extremities.push_back({static_cast<double>(twigs), m_logTip});
        region.law = solveWidths(region.logBase, extremities, m_parameters.exponent);
        region.power = 1.0 / region.law.exponent;
        // The factor's share in an internode that carries twigs is its distance from a twig to the base, by
        // the logarithm of the diameter: so the diameters follow a power law.
        const double rise = logDiameter(region.law.exponent, extremities) - m_logTip;
        if (rise > 1e-9)
            region.power *= 1.0 + region.law.logFactor / rise;
        for (std::uint32_t tips = 0; tips <= std::min(twigs, kRegionTableSize - 1); ++tips)
            region.table.push_back(radiusOfTwigs(region, tips));

        for (const std::uint32_t end : region.ends) {
            const InternodeId id = m_constraints[end].id;
            cross(self, id, m_index.tipCount(id), logOf(m_constraints[end]));
        }
        if (region.ends.empty() && twigs == 1 && region.logBase) {
            // With a single twig there is no exponent, and the width changes along its length.
            InternodeId tip = region.base;
            while (m_index.firstChild(tip) != kNoInternode)
                tip = m_index.firstChild(tip);
            cross(self, tip, 1, m_logTip);
        }
    }

    /// Notes the path from the region's base to @p end.
    void cross(std::uint32_t region, InternodeId end, std::uint32_t tips, double logDiameter)
    {
        const std::size_t first = m_crossings.size();
        double length = 0.0;
        for (InternodeId id = end;; id = m_tree.parent(id)) {
            m_crossings.push_back({id, region, tips, logDiameter, length});
            if (id == m_regions[region].base)
                break;
            length += static_cast<double>(m_tree.length(id));
        }
        for (std::size_t i = first; i < m_crossings.size(); ++i)
            m_crossings[i].share = length > 0.0 ? m_crossings[i].share / length : 0.0;
        m_crossings.back().share = 1.0;
    }

    float radiusOfTwigs(const Region& region, std::uint32_t tips) const
    {
        if (tips == 0)
            return 0.0F;
        return static_cast<float>(std::exp(m_logTip + region.power * std::log(static_cast<double>(tips))) /
                                  2.0);
    }

    void fill()
    {
        m_radii.resize(m_tree.size());
        for (InternodeId id = 0; id < m_tree.size(); ++id) {
            const Region& region = m_regions[m_regionOf[id]];
            const std::uint32_t tips = m_index.tipCount(id);
            m_radii[id] = tips < region.table.size() ? region.table[tips] : radiusOfTwigs(region, tips);
        }
    }

    /// Radius of an internode; @p ends are the extremities above it.
    float radiusOf(std::span<const Crossing> ends)
    {
        const Region& region = m_regions[ends.front().region];
        std::uint32_t twigs = m_index.tipCount(ends.front().id);
        double share = 0.0;
        m_extremities.clear();
        for (const Crossing& end : ends) {
            // If ends belong to two regions, the regions meet here: the internode has a constraint.
            if (end.region != ends.front().region)
                return 0.0F;
            twigs -= end.tips;
            share = std::max(share, end.share);
            m_extremities.push_back({1.0, end.logDiameter});
        }
        if (twigs > 0)
            m_extremities.push_back({static_cast<double>(twigs), m_logTip});
        const double log = logDiameter(region.law.exponent, m_extremities) + share * region.law.logFactor;
        return static_cast<float>(std::exp(log) / 2.0);
    }

    const Tree& m_tree;
    const TreeIndex& m_index;
    const WidthParameters& m_parameters;
    std::span<const WidthConstraint> m_constraints;
    double m_power;
    double m_logTip;
    std::vector<Region> m_regions;
    /// By internode; an internode with a constraint belongs to the region above it.
    std::vector<std::uint32_t> m_regionOf;
    std::vector<Crossing> m_crossings;
    std::vector<float> m_radii;
    std::vector<WidthExtremities> m_extremities;
};

} // namespace

double logDiameter(double exponent, std::span<const WidthExtremities> extremities)
{
    return logSum(exponent, extremities).value / exponent;
}

WidthLaw solveWidths(std::optional<double> logBase, std::span<const WidthExtremities> extremities,
                     double fallback)
{
    double count = 0.0;
    double thickest = -std::numeric_limits<double>::infinity();
    for (const WidthExtremities& e : extremities) {
        count += e.count;
        thickest = std::max(thickest, e.logDiameter);
    }
    double exponent = std::clamp(fallback, kSmallestRegionExponent, kLargestRegionExponent);
    if (!logBase || count <= 0.0)
        return {exponent, 0.0};
    if (count >= 2.0) {
        const bool hasRoot = *logBase > thickest;
        exponent = hasRoot ? solveExponent(*logBase, extremities) : kLargestRegionExponent;
        if (hasRoot && exponent >= kSmallestRegionExponent && exponent <= kLargestRegionExponent)
            return {exponent, 0.0};
        exponent = std::clamp(exponent, kSmallestRegionExponent, kLargestRegionExponent);
    }
    return {exponent, *logBase - logDiameter(exponent, extremities)};
}

std::vector<float> constrainedRadii(const Tree& tree, const TreeIndex& index,
                                    std::span<const WidthConstraint> constraints, double power)
{
    return Regions(tree, index, constraints, power).radii();
}

} // namespace espalier
