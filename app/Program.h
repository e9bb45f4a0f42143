// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace espalier {

/// The whole program; returns its exit code (see ExitCode).
int runProgram(int argc, char** argv);

} // namespace espalier
