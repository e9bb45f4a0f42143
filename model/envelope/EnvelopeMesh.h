// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/envelope/Envelope.h"

namespace espalier {

/// The surface of an envelope, for showing: triangles counter-clockwise seen from outside.
struct EnvelopeMesh {
    std::vector<Vec3> positions; ///< m
    std::vector<Vec3> normals;   ///< Unit, out of the surface
    std::vector<std::uint32_t> triangles;
};

/// Makes a closed surface: a front and a back over every @p stride-th node of the envelope's field (1...8),
/// joined on the outline. Parts thinner than the stride are missing, unless nothing else would be left.
EnvelopeMesh envelopeMesh(const Envelope& envelope, int stride = 2);

} // namespace espalier
