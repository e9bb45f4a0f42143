// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/PreparedTree.h"
#include "model/document/TreeDocument.h"
#include "model/io/project/ProjectFile.h"

namespace espalier {

/// The content of a project file: the document's whole history, with the future.
Project projectOf(const TreeDocument& document, const QString& name);
/// Makes all that a document derives from a project that was read, with the undo steps that its history tells
/// of. Can be called on any thread.
PreparedTree prepared(Project project);
/// Shows a project that was read, at the moment that was shown when it was written.
void showProject(TreeDocument& document, Project project);

} // namespace espalier
