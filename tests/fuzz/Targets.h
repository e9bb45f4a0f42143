// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>

#include <span>

namespace espalier::test {

/// Something that reads what may come from anywhere.
struct FuzzTarget {
    const char* name;
    /// Reads @p input and uses what it gave. Ends the program if it finds a fault.
    void (*read)(const QByteArray& input);
};

/// "project", "recipe", "drawing", "skeleton", "image", "changes" and "operations"; the inputs of the last
/// one are seeds of random operations.
std::span<const FuzzTarget> fuzzTargets();
/// Null if there is none of that name.
const FuzzTarget* fuzzTarget(const QByteArray& name);

} // namespace espalier::test
