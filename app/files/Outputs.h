// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Error.h"
#include "model/io/export/Exporter.h"
#include "model/io/project/ProjectFile.h"

#include <QImage>
#include <QStringList>

#include <memory>
#include <utility>
#include <vector>

namespace espalier {

/// Writes a project in the format that the file's suffix names: .espalier, or one of exportSuffixes(). Can be
/// called on any thread. The tree at the moment shown is exported.
Result<void> writeOutput(const Project& project, const QString& fileName, const Progress& progress = {});

/// Writes what was done to a project's tree as a recipe: see recipeOf() and saveRecipe(). May run on any
/// thread.
Result<void> writeRecipeOf(const Project& project, const QString& fileName);

/// Replaces the file whole or leaves it as it was.
Result<void> writePicture(const QImage& picture, const QString& fileName);

/// The files that one command writes: all of them take their places in commit(), or none does. A device or a
/// pipe gets its bytes at once.
class Outputs {
public:
    /// @p names: of all files that will be added; textures of exports get other names.
    explicit Outputs(QStringList names) : m_names(std::move(names)) {}

    /// See writeOutput(). A file that has been added is left out.
    Result<void> add(const Project& project, const QString& fileName);
    Result<void> add(const QByteArray& bytes, const QString& fileName);
    Result<void> add(const QImage& picture, const QString& fileName);
    Result<void> commit();

private:
    QStringList m_names;
    QStringList m_projects; ///< Absolute names of the files that were added with a project
    std::vector<ExportFiles> m_exports;
    std::vector<std::unique_ptr<FileWriter>> m_files; ///< All others
    std::vector<FileWriter*> m_order;
};

} // namespace espalier
