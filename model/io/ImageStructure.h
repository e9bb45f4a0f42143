// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QSize>
#include <QString>

namespace espalier {

/// What speaks against unpacking a PNG or JPEG file with pixels of that size, from a walk over its parts and
/// without unpacking any: it ends too early, or it is made so that unpacking would take very long. A reason
/// without a full stop; empty if there is none.
QString imageStructureFault(const QByteArray& file, const QSize& size);

} // namespace espalier
