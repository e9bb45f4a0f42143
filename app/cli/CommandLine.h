// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/ParameterOverrides.h"
#include "commands/recipe/VaryOperation.h"
#include "model/base/Error.h"

#include <QSize>
#include <QString>
#include <QStringList>

#include <cstdint>
#include <optional>

namespace espalier {

/// Exit codes of the program.
enum ExitCode : int {
    kDone = 0,
    kUsage = 2,           ///< The command line is not valid
    kInputUnreadable = 3, ///< A file could not be read, or its content is wrong
    kOutputNotWritten = 4,
};

/// The content of a command line.
struct CommandLine {
    enum class Verb { Window, Demo, Replay, Import, Sketch, Export, Render, Info, Help, Version };

    Verb verb = Verb::Window;
    QStringList inputs;       ///< Recipes, a project, a skeleton, or drawings
    QStringList outputs;      ///< Their suffixes say the formats
    QString picture;          ///< PNG; empty for none
    QSize size{1600, 1200};   ///< Of the picture, px
    QString camera;           ///< front, side, top, three-quarter; empty for what the recipe says
    bool transparent = false; ///< The picture shows the tree alone, on nothing
    bool fibres = false;      ///< The picture shows the strands in place of the bark
    /// The transparent picture has the tree's shadow too, as black of some opacity.
    bool groundShadow = false;
    QString stats;                          ///< JSON; empty for none
    QString profiles;                       ///< JSON of the strands in each cross-section; empty for none
    bool strict = false;                    ///< An operation that finds nothing to do is an error
    int drawing = 0;                        ///< Of a file with many drawings, from 0
    bool frontOnly = false;                 ///< A drawing is placed once, not a second time turned by 90°
    int threads = 0;                        ///< 0 for as many as the machine has
    std::optional<std::uint64_t> seed;      ///< In place of the recipe's
    std::optional<VaryOperation> variation; ///< Of the tree at last
    ParameterOverrides overrides{};         ///< In place of the recipe's or project's

    /// Whether a window or a picture will be drawn, which needs a display.
    bool needsDisplay() const;
};

/// Reads the arguments without the program's name. The error's message says in one sentence what is wrong.
Result<CommandLine> parseCommandLine(const QStringList& arguments);

/// What --help prints.
QString commandLineHelp();

} // namespace espalier
