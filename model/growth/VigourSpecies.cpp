// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/growth/VigourSpecies.h"

#include <QCoreApplication>

#include <array>

namespace espalier {

std::span<const VigourSpecies> vigourSpecies()
{
    static const std::array<VigourSpecies, 1> kSpecies{{{QT_TRANSLATE_NOOP("Parameters", "Hazel"), {}}}};
    return kSpecies;
}

} // namespace espalier
