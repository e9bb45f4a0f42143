// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Error.h"
#include "model/tree/Parameters.h"

#include <QJsonObject>

#include <functional>

namespace espalier {

/// Returns the name of an image in a file; and the image of that name.
using ImageName = std::function<QString(const ImageAsset&)>;
using ImageOfName = std::function<Result<ImageAsset>(const QString&)>;

/// Parameters as JSON: {"growth": {"apicalDominance": 0.5, …}, "widths": …, "leaves": …, "bark": …}, in
/// surface units: degrees for angles, the name for a choice, true or false for a switch. Every number has as
/// few digits as lead back to the same value. An image is written as @p imageName of it, or as its hash if no
/// function is given; a parameter without an image is left out.
QJsonObject toJson(const TreeParameters& parameters, const ImageName& imageName = {});
/// Only what differs from @p base; "" takes an image away.
QJsonObject toJson(const TreeParameters& parameters, const TreeParameters& base,
                   const ImageName& imageName = {});

/// @p base with what @p json says. Unknown names, wrong types and values outside the limits of
/// visitParameters give an error that names the place ("parameters.growth.shedding: …"), and so do parameters
/// that contradict each other: direction weights that are all 0, or an ellipse whose offset reaches its edge;
/// and images that @p imageOfName does not know, or any if it is not given.
Result<TreeParameters> fromJson(const QJsonObject& json, const TreeParameters& base, const QString& place,
                                const ImageOfName& imageOfName = {});

/// Scales the direction weights α, β, γ so that their sum is 1, unless it is already (then not a bit
/// changes). Precondition: one of them is above 0.
void normaliseDirectionWeights(GrowthParameters& growth);

} // namespace espalier
