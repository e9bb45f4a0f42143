// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>

namespace espalier {

/// What speaks against reading a PNG or JPEG file, from a walk over its parts and without unpacking any: it
/// ends too early, a part claims to be longer than the file, or it is made so that unpacking would take very
/// long. A reason without a full stop; empty if there is none. To be asked first: the libraries that unpack
/// images allocate what a part claims.
QString imageStructureFault(const QByteArray& file);

} // namespace espalier
