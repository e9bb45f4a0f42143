// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

#include <span>
#include <string_view>

namespace espalier {

/// The sheets that parameters are shown on.
enum class ParameterSheet { Architecture, Brush, Leaves, Branches };

/// The texts of a parameter in the user interface.
struct ParameterText {
    /// How values are distributed along a slider.
    enum class Scale {
        Linear,
        Logarithmic, ///< Equal distances are equal ratios; the minimum is above 0
        Cubic,       ///< Finer toward 0
    };

    const char* key;    ///< As in ParameterInfo
    const char* label;  ///< Untranslated; the context is "Parameters"
    const char* symbol; ///< The papers' sign for it, or ""
    const char* tip;    ///< Untranslated
    Scale scale = Scale::Linear;
    int decimals = 2;
    const char* unit = "";  ///< As it is shown
    double factor = 1.0;    ///< From the parameter's surface unit to the shown unit
    const char* least = ""; ///< Name that shows instead of the number for the smallest value; untranslated
    /// The botanical term for it; untranslated, or "".
    const char* botany = "";
};

/// Parameters that belong together, under a heading.
struct ParameterSection {
    ParameterSheet sheet;
    const char* title; ///< Untranslated
    std::span<const ParameterText> parameters;
    /// How a section shows on the sheet of architecture.
    enum class Look {
        Rows,
        Diagram, ///< As a diagram with handles
        More,    ///< As rows that show on demand
        Model,   ///< As rows that always show; the others show if the model that they belong to is in force
        Vigour,  ///< As rows of the vigour model
    };
    Look look = Look::Rows;
};

/// All sections, in the order in which they are shown; each parameter is in one of them.
std::span<const ParameterSection> parameterSections();
/// The texts of that parameter, or null.
const ParameterText* parameterText(std::string_view key);

/// Explains a parameter in a tool tip and in the help: its name and symbol, plain words, and the botanical
/// term. Rich text.
QString explanation(const ParameterText& text);
/// Name and symbol of a parameter; rich text.
QString richLabel(const ParameterText& text);

/// Translates a text of the tables, or the name of a choice.
QString parameterTr(const char* text);
/// The translated names of the choices of a ParameterInfo; a name of two words has "_" between them.
QStringList choiceNames(const char* choices);

} // namespace espalier
