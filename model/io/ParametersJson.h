// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Error.h"
#include "model/tree/Parameters.h"

#include <QJsonObject>

namespace espalier {

/// Parameters as JSON: {"growth": {"apicalDominance": 0.5, …}, "widths": …, "leaves": …, "bark": …}, in
/// surface units: degrees for angles, the name for a choice, true or false for a switch. Every number has as
/// few digits as lead back to the same value.
QJsonObject toJson(const TreeParameters& parameters);
/// Only what differs from @p base.
QJsonObject toJson(const TreeParameters& parameters, const TreeParameters& base);

/// @p base with what @p json says. Unknown names, wrong types and values outside the limits of
/// visitParameters give an error that names the place ("parameters.growth.shedding: …"), and so do parameters
/// that contradict each other: direction weights that are all 0, or an ellipse whose offset reaches its edge.
Result<TreeParameters> fromJson(const QJsonObject& json, const TreeParameters& base, const QString& place);

/// Scales the direction weights α, β, γ so that their sum is 1, unless it is already (then not a bit
/// changes). Precondition: one of them is above 0.
void normaliseDirectionWeights(GrowthParameters& growth);

} // namespace espalier
