// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Parallel.h"

namespace espalier {

/// Calls @p body(begin, end) on ranges of @p count rows or columns, on all threads; see parallelFor().
template <class Body>
void forLines(int count, Body&& body)
{
    parallelFor(static_cast<std::size_t>(count), 32, [&](std::size_t begin, std::size_t end) {
        body(static_cast<int>(begin), static_cast<int>(end));
    });
}

} // namespace espalier
