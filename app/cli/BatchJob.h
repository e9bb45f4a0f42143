// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/CommandLine.h"
#include "views/camera/Camera.h"

namespace espalier {

/// Performs a command that needs no window (replay, export, render, info), prints one line for each thing
/// that goes wrong, and returns the exit code. A picture needs a QGuiApplication.
ExitCode runBatchJob(const CommandLine& line);

/// The view of that name in recipes and command lines; the front for an empty one.
NamedView namedView(const QString& name);

/// Prints "espalier: sentence" as one line on the standard error.
void complain(const QString& sentence);

} // namespace espalier
