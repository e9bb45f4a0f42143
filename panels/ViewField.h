// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/settings/ViewSettings.h"
#include "panels/ParameterScale.h"

class QWidget;

namespace espalier {

class ViewRow;

/// A value of the view for a ViewRow, in surface units. Texts are untranslated; their context is
/// "Parameters".
struct ViewField {
    ParameterInfo info;
    ParameterText text;
    double (*get)(const ViewValues&);
    void (*set)(ViewValues&, double);
};

template <auto Member>
constexpr ViewField viewSwitch(const char* key, const char* label, const char* tip)
{
    return {{key, Quantity::Switch, 0, 1},
            {key, label, "", tip},
            [](const ViewValues& values) { return values.*Member ? 1.0 : 0.0; },
            [](ViewValues& values, double value) { values.*Member = value != 0.0; }};
}

/// Makes a row that sets the value in @p settings, which must outlive it, and follows their changes.
ViewRow* makeViewRow(const ViewField& field, ViewSettings& settings, QWidget* parent);

} // namespace espalier
