// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/Recipe.h"

#include <QJsonObject>

namespace espalier {

/// Values of parameters that the command line gives (--set), which hold in place of those of recipes and
/// projects.
class ParameterOverrides {
public:
    /// Reads "group.name=value": a parameter of visitParameters() and its value in surface units (degrees,
    /// the name of a choice, true or false). The last value of a parameter counts. The error is one sentence;
    /// it also says if the values contradict each other.
    Result<void> add(const QString& text);
    bool isEmpty() const { return m_values.isEmpty(); }

    /// @p parameters with the values. What contradicts them yields: direction weights that are not given
    /// share what the given ones leave of 1, and a half-axis or offset of the gravimorphic ellipse moves as
    /// far as it must.
    TreeParameters appliedTo(const TreeParameters& parameters) const;
    /// Makes the values hold from the recipe's beginning to its end, whatever its operations set.
    void applyTo(Recipe& recipe) const;

private:
    bool has(const char* key) const;

    QJsonObject m_values; ///< As fromJson() reads it
};

} // namespace espalier
