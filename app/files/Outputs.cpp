// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/Outputs.h"

#include "commands/recipe/JournalRecipe.h"
#include "commands/recipe/RecipeFile.h"
#include "model/io/FileWriter.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QFileInfo>

#include <algorithm>
#include <iterator>

namespace espalier {

namespace {

bool isProjectName(const QString& fileName)
{
    return QFileInfo(fileName).suffix().toLower() == QStringLiteral("espalier");
}

} // namespace

Result<void> writeOutput(const Project& project, const QString& fileName, const Progress& progress)
{
    if (isProjectName(fileName))
        return saveProject(project, fileName);
    const Tree tree = shownTree(project);
    return exportTree(tree, TreeIndex(tree), project.name, fileName, {}, progress);
}

Result<void> writeRecipeOf(const Project& project, const QString& fileName)
{
    Result<Recipe> recipe = recipeOf(project);
    if (!recipe)
        return Error{Error::Kind::Output,
                     inputError(QFileInfo(fileName).fileName(), recipe.error().message).message};
    if (recipe->name.isEmpty())
        recipe->name = QFileInfo(fileName).completeBaseName();
    return saveRecipe(std::move(*recipe), fileName);
}

Result<void> writePicture(const QImage& picture, const QString& fileName)
{
    Outputs outputs({fileName});
    const Result<void> added = outputs.add(picture, fileName);
    return added ? outputs.commit() : added;
}

Result<void> Outputs::add(const Project& project, const QString& fileName)
{
    const QString path = QFileInfo(fileName).absoluteFilePath();
    if (m_projects.contains(path))
        return {};
    m_projects.append(path);
    if (isProjectName(fileName)) {
        const Result<QByteArray> bytes = packProject(project);
        if (!bytes)
            return Error{Error::Kind::Output,
                         inputError(QFileInfo(fileName).fileName(), bytes.error().message).message};
        return add(*bytes, fileName);
    }
    const Tree tree = shownTree(project);
    QStringList others = m_names;
    for (const FileWriter* file : m_order)
        others.append(file->fileName());
    Result<ExportFiles> files = prepareExport(tree, TreeIndex(tree), project.name, fileName, {}, {}, others);
    if (!files)
        return files.error();
    m_exports.push_back(std::move(*files));
    std::ranges::copy(m_exports.back().writers(), std::back_inserter(m_order));
    return {};
}

Result<void> Outputs::add(const QByteArray& bytes, const QString& fileName)
{
    auto file = std::make_unique<FileWriter>(fileName);
    file->write(bytes);
    if (Result<void> finished = file->finish(); !finished)
        return finished;
    m_order.push_back(file.get());
    m_files.push_back(std::move(file));
    return {};
}

Result<void> Outputs::add(const QImage& picture, const QString& fileName)
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    if (!buffer.open(QIODevice::WriteOnly) || !picture.save(&buffer, "PNG")) {
        return Error{
            Error::Kind::Output,
            QCoreApplication::translate("Outputs", "%1: the picture could not be compressed").arg(fileName)};
    }
    return add(bytes, fileName);
}

Result<void> Outputs::commit()
{
    for (const ExportFiles& files : m_exports) {
        if (Result<void> checked = files.checkNames(); !checked)
            return checked;
    }
    return FileWriter::commitAll(m_order);
}

} // namespace espalier
