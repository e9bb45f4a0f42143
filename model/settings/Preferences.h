// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/settings/Lengths.h"
#include "model/settings/MouseScheme.h"

#include <QString>
#include <QStringList>

namespace espalier {

/// Colours of the window: dark, light, or as the system has them.
enum class Look : int { Dark, Light, System };

/// How strokes are calmed; see StrokeStabiliser.
struct Stabilising {
    static constexpr double kGreatestDistance = 60.0;
    static constexpr double kLongestDelay = 0.5;

    double distance = 0.0; ///< Of the stroke from the pointer, px, 0...kGreatestDistance
    double delay = 0.0;    ///< s, 0...kLongestDelay

    bool operator==(const Stabilising&) const = default;
};

/// The user's choices in the sheet of settings.
struct Preferences {
    static constexpr double kSoftest = 0.25;
    static constexpr double kFirmest = 4.0;
    static constexpr int kMostUndoSteps = 10'000;
    static constexpr int kLeastUndoMemory = 50;
    static constexpr int kMostUndoMemory = 64'000;

    Look look = Look::Dark;
    bool areToolsRight = false; ///< The bar of tools is on the right, for people who draw with the left hand
    double pressureExponent = 1.0; ///< kSoftest...kFirmest; see PointerReader::setPressureExponent
    MouseScheme mouse = MouseScheme::Espalier;
    int undoSteps = 0;       ///< Number of undo steps that are kept, 0...kMostUndoSteps; 0 for all
    int undoMemory = 2'000;  ///< MB that the history may take, kLeastUndoMemory...kMostUndoMemory
    QString libraryFolder{}; ///< Folder of the library's trees; empty for a folder among the program's data
    Units units = Units::Metric;
    QString language{}; ///< One of Preferences::languages(); empty for the system's language
    Stabilising stabilising{};

    std::size_t undoBytes() const { return std::size_t{1'000'000} * static_cast<std::size_t>(undoMemory); }

    /// Codes of the languages that the program has texts in, such as "de"; English first.
    static QStringList languages();

    bool operator==(const Preferences&) const = default;
};

} // namespace espalier
