// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Error.h"
#include "model/tree/StrandProfile.h"

#include <QJsonObject>

namespace espalier {

/// A profile as JSON: {"boundaries": [[[x, y], …], …], "attractors": [[[x, y], [x, y]], …]}; attractors are
/// left out if there are none.
QJsonObject profileToJson(const StrandProfile& profile);
/// Reads what profileToJson() has written. The error names the place, below @p place, and says what is wrong:
/// also what profileFault() finds.
Result<StrandProfile> readProfile(const QJsonValue& json, const QString& place);

} // namespace espalier
