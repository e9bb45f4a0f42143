// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

#include <span>
#include <string_view>

namespace espalier {

/// The sheets that parameters are shown on.
enum class ParameterSheet { Architecture, Brush, Leaves, Branches };

/// How a parameter presents itself to a person.
struct ParameterText {
    /// How a slider's way is shared among the values.
    enum class Scale {
        Linear,
        Logarithmic, ///< Equal ways are equal ratios; the minimum is above 0
        Cubic,       ///< Finer toward 0
    };

    const char* key;    ///< As in ParameterInfo
    const char* label;  ///< Untranslated; the context is "Parameters"
    const char* symbol; ///< The papers' sign for it, or ""
    const char* tip;    ///< Untranslated
    Scale scale = Scale::Linear;
    int decimals = 2;
    const char* unit = "";  ///< As it is shown
    double factor = 1.0;    ///< From the parameter's surface unit to the one that is shown
    const char* least = ""; ///< What its smallest value is called instead of the number; untranslated
    /// What a botanist would say of it; untranslated, or "".
    const char* botany = "";
};

/// Parameters that belong together, under a heading.
struct ParameterSection {
    ParameterSheet sheet;
    const char* title; ///< Untranslated
    std::span<const ParameterText> parameters;
    /// How it presents itself on the sheet of architecture.
    enum class Look {
        Rows,
        Diagram, ///< Drawn, with handles
        More,    ///< Rows for those who ask for more
    };
    Look look = Look::Rows;
};

/// All of them, in the order in which they are shown; each parameter once.
std::span<const ParameterSection> parameterSections();
/// The one of that key, or null.
const ParameterText* parameterText(std::string_view key);

/// What a control tells of its parameter, for a tool tip and for help: its name and sign, plain words, and a
/// botanist's. Rich text.
QString explanation(const ParameterText& text);
/// Its name and sign; rich text.
QString richLabel(const ParameterText& text);

/// Translates a text of the tables, or the name of a choice.
QString parameterTr(const char* text);
/// The names that a person reads for the choices of a ParameterInfo; a name of two words has "_" between
/// them.
QStringList choiceNames(const char* choices);

} // namespace espalier
