// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/Outputs.h"

#include "commands/recipe/JournalRecipe.h"
#include "commands/recipe/RecipeFile.h"
#include "model/io/FileWriter.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QFileInfo>

namespace espalier {

Result<void> writeOutput(const Project& project, const QString& fileName, const Progress& progress)
{
    if (QFileInfo(fileName).suffix().toLower() == QStringLiteral("espalier"))
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
    QByteArray bytes;
    QBuffer buffer(&bytes);
    if (!buffer.open(QIODevice::WriteOnly) || !picture.save(&buffer, "PNG")) {
        return Error{
            Error::Kind::Output,
            QCoreApplication::translate("Outputs", "%1: the picture could not be compressed").arg(fileName)};
    }
    return writeFile(fileName, bytes);
}

} // namespace espalier
