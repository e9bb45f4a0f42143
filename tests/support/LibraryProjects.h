// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/files/Library.h"
#include "commands/GrowGesture.h"

namespace espalier::test {

/// The names that the user sees.
inline QStringList namesOf(const std::vector<LibraryEntry>& entries)
{
    QStringList names;
    for (const LibraryEntry& entry : entries)
        names.append(entry.name);
    return names;
}

/// A project whose tree differs from those with another angle.
inline Project project(double branchingAngle)
{
    TreeParameters parameters;
    parameters.growth.branchingAngle = branchingAngle;
    TreeDocument document;
    document.reset(3, parameters);
    GrowGesture growth(document);
    for (int i = 0; i < 3; ++i)
        growth.step();
    growth.finish();
    Project project{document.tree(), document.journal(), QStringLiteral("any"), {}, 0};
    project.thumbnail = QImage(64, 64, QImage::Format_RGB32);
    project.thumbnail.fill(Qt::red);
    return project;
}

} // namespace espalier::test
