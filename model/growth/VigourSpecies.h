// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/tree/Parameters.h"

#include <span>

namespace espalier {

/// Parameters of the vigour model by which a tree grows like a species.
struct VigourSpecies {
    const char* name; ///< Untranslated; the context is "Parameters"
    VigourParameters parameters;
};

/// The species that the program knows.
std::span<const VigourSpecies> vigourSpecies();

} // namespace espalier
