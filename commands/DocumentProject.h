// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/PreparedTree.h"
#include "model/document/TreeDocument.h"
#include "model/io/project/ProjectFile.h"

namespace espalier {

/// What of a document goes into a file: all of its history, also what lies ahead of the moment shown.
Project projectOf(const TreeDocument& document, const QString& name);
/// What a document derives from a project that was read; may run on any thread.
PreparedTree prepared(Project project);
/// Shows a project that was read, at the moment that was shown when it was written.
void showProject(TreeDocument& document, Project project);

} // namespace espalier
