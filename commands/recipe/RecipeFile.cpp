// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/RecipeFile.h"

#include "commands/recipe/FillEnvelopesOperation.h"
#include "commands/recipe/RecipeLimits.h"
#include "commands/recipe/RecipeText.h"
#include "commands/recipe/SetParametersOperation.h"
#include "model/io/FileWriter.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QHash>
#include <QRegularExpression>

namespace espalier {

namespace {

constexpr qsizetype kHashDigits = 8; ///< Of an image's hash, in the name of its file

Error notWritten(const QString& fileName, const QString& reason)
{
    return {Error::Kind::Output, inputError(QFileInfo(fileName).fileName(), reason).message};
}

/// The same image under the name of its file beside the recipe.
ImageAsset renamed(const ImageAsset& image)
{
    static const QRegularExpression unusual(QStringLiteral("[^\\w.-]+"),
                                            QRegularExpression::UseUnicodePropertiesOption);
    const QString base = QFileInfo(image.name()).completeBaseName().replace(unusual, QStringLiteral("_"));
    return {image.file(),
            QStringLiteral("%1-%2.%3").arg(image.hash().left(kHashDigits), base, image.suffix())};
}

using Images = QHash<QString, ImageAsset>; ///< Renamed images by hash

void rename(TreeParameters& parameters, Images& images)
{
    visitImages(parameters, [&](const char*, ImageAsset& image) {
        if (image.isNull())
            return;
        ImageAsset& known = images[image.hash()];
        if (known.isNull())
            known = renamed(image);
        image = known;
    });
}

Images renameImages(Recipe& recipe)
{
    Images images;
    rename(recipe.parameters, images);
    for (RecipeOperation& operation : recipe.operations) {
        if (const auto* set = operation.as<SetParametersOperation>()) {
            SetParametersOperation changed = *set;
            rename(changed.parameters, images);
            operation = changed;
        } else if (const auto* fill = operation.as<FillEnvelopesOperation>()) {
            FillEnvelopesOperation changed = *fill;
            rename(changed.parameters, images);
            operation = changed;
        }
    }
    return images;
}

Result<void> writeImage(const ImageAsset& image, const QString& fileName)
{
    QFile there(fileName);
    if (!there.exists())
        return writeFile(fileName, image.file());
    if (there.open(QIODevice::ReadOnly) && there.readAll() == image.file())
        return {};
    return notWritten(fileName,
                      RecipeText::tr("another file with this name is where the recipe's image should go"));
}

} // namespace

Result<void> saveRecipe(Recipe recipe, const QString& fileName)
{
    const Images images = renameImages(recipe);
    if (images.size() > recipeLimits::kImages)
        return notWritten(fileName,
                          RecipeText::tr("a recipe can have at most %1 images").arg(recipeLimits::kImages));
    const QByteArray text = writeRecipe(recipe);
    const QDir folder(QFileInfo(fileName).path());
    for (const ImageAsset& image : images) {
        if (Result<void> written = writeImage(image, folder.filePath(image.name())); !written)
            return written;
    }
    const Result<Recipe> read = parseRecipe(text, folder.path());
    if (!read)
        return notWritten(fileName, read.error().message);
    if (!(*read == recipe))
        return notWritten(fileName, RecipeText::tr("the recipe's numbers cannot be written exactly"));
    return writeFile(fileName, text);
}

} // namespace espalier
