// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/tree/TreeIndex.h"

#include <vector>

namespace espalier {

/// The exponent n of d^n = Σ d_i^n that leads from @p tips equal extremities of diameter @p tipDiameter to a
/// base of diameter
/// @p baseDiameter: n = ln M / (ln d_b − ln d_e) (TreeSketch §3.3, eq. 3), clamped to 0.5...10; where no
/// exponent exists (a single tip, or a base no thicker than a tip), @p fallback.
double widthExponent(std::uint32_t tips, double tipDiameter, double baseDiameter, double fallback);

/// Branch radii by da Vinci's rule. With equal extremities an internode's radius depends on how many tips it
/// carries alone, so it follows every edit through TreeIndex::tipCount at no cost of its own. A snapshot of
/// the parameters: make a new one after they, or (with a base diameter) the number of tips, have changed.
class Widths {
public:
    Widths(const WidthParameters& parameters, std::uint32_t treeTips);
    Widths(const Tree& tree, const TreeIndex& index) : Widths(tree.parameters().widths, index.tipCount(0)) {}

    double exponent() const { return m_exponent; }
    /// m; 0 for an internode that carries nothing (a dead one).
    float radiusOfTips(std::uint32_t tips) const;
    float radius(const TreeIndex& index, InternodeId id) const { return radiusOfTips(index.tipCount(id)); }

private:
    double m_exponent;
    double m_tipRadius;
    std::vector<float> m_table; ///< Radii of small tip counts
};

} // namespace espalier
