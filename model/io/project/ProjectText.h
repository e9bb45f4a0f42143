// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>

namespace espalier {

/// Translates the messages of the readers and writers of project files.
struct ProjectText {
    Q_DECLARE_TR_FUNCTIONS(ProjectFile)
};

} // namespace espalier
