// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/tree/TreeIndex.h"
#include "model/tree/TreeTables.h"

#include <span>
#include <vector>

namespace espalier {

/// The exponent n of d^n = Σ d_i^n that leads from @p tips equal extremities of diameter @p tipDiameter to a
/// base of diameter @p baseDiameter: n = ln M / (ln d_b − ln d_e) (TreeSketch §3.3, eq. 3), clamped to
/// 0.5...10. Where no exponent exists (a single tip, or a base no thicker than a tip), @p fallback.
double widthExponent(std::uint32_t tips, double tipDiameter, double baseDiameter, double fallback);

/// Branch radii by da Vinci's rule. With equal extremities an internode's radius depends only on the number
/// of tips that it carries, so it follows every edit through TreeIndex::tipCount without further cost.
///
/// Constraints divide a tree into regions: each is an extremity for the region below it and the base of the
/// one above, and each region has its own exponent (see WidthRegions). Then all radii are computed at once;
/// so are those of a single axis with a base diameter, which tapers by its length.
///
/// Where several roots stand side by side, the base diameter is that of the trunk with the most tips. The
/// same power leads to the diameters of the other trunks. If all trunks are single axes, each tapers by its
/// own length.
///
/// A snapshot: make a new one when the parameters, or (with a base diameter) the number of tips, or (with
/// constraints) anything else of the tree has changed.
class Widths {
public:
    /// @p trunkTips: the number of tips that the trunk with the most of them carries.
    Widths(const WidthParameters& parameters, std::uint32_t trunkTips);
    /// Uses the tree's constraints.
    Widths(const Tree& tree, const TreeIndex& index) : Widths(tree, index, tree.widthConstraints()) {}
    /// @p constraints: ascending, at most one for each internode.
    Widths(const Tree& tree, const TreeIndex& index, std::span<const WidthConstraint> constraints);

    /// Exponent of the region at the base of the trunk with the most tips; if a constraint is there, the
    /// exponent without constraints.
    double exponent() const { return m_exponent; }
    /// p of d = d_e · tips^p, where radii depend on the number of tips alone: 1 / exponent() within its
    /// limits, and beyond them the power that leads to the base diameter.
    double power() const { return m_power; }
    /// Whether an internode's radius is a function of how many tips it carries.
    bool dependOnTipsAlone() const { return m_radii.empty(); }
    /// Radius for a number of tips, m, where radii depend on tips alone; 0 for no tips (a dead internode).
    float radiusOfTips(std::uint32_t tips) const;
    /// Radius of an internode, m.
    float radius(const TreeIndex& index, InternodeId id) const
    {
        return id < m_radii.size() ? m_radii[id] : radiusOfTips(index.tipCount(id));
    }

private:
    double m_exponent;
    double m_power;
    double m_tipRadius;
    std::vector<float> m_table; ///< Radii of small tip counts
    std::vector<float> m_radii; ///< By internode; empty where tips alone decide
};

} // namespace espalier
