// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>

namespace espalier::test {

/// A recipe with these members.
inline QByteArray recipeOf(const QByteArray& members)
{
    return R"({"espalier-recipe": 1, )" + members + '}';
}

/// A recipe with these operations.
inline QByteArray operationsOf(const QByteArray& list)
{
    return recipeOf("\"operations\": [" + list + ']');
}

} // namespace espalier::test
