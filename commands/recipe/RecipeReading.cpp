// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/RecipeReading.h"

#include "commands/recipe/RecipeLimits.h"
#include "commands/recipe/RecipeText.h"
#include "model/io/ImageFile.h"
#include "model/io/ParametersJson.h"
#include "model/texture/OwnTextures.h"

#include <QDir>

namespace espalier {

Result<ImageAsset> RecipeReading::readImage(const QString& name) const
{
    if (m_images.size() >= recipeLimits::kImages)
        return inputError(name,
                          RecipeText::tr("a recipe can have at most %1 images").arg(recipeLimits::kImages));
    const Result<QString> path = pathOf(name);
    return path ? readImageFile(*path, name) : path.error();
}

Result<Skeleton> RecipeReading::readSkeleton(const QString& name) const
{
    const Result<QString> path = pathOf(name);
    return path ? readSkeletonFile(*path) : path.error();
}

Result<QString> RecipeReading::pathOf(const QString& name) const
{
    if (m_folder.isEmpty())
        return inputError(name, RecipeText::tr("a recipe that was not read from a file cannot name files"));
    if (QDir::isAbsolutePath(name))
        return inputError(name, RecipeText::tr("a path relative to the recipe is expected"));
    return QDir(m_folder).filePath(name);
}

const RecipeReading::Image& RecipeReading::image(const QString& name)
{
    const auto known = m_images.find(name);
    if (known != m_images.end())
        return *known;
    Image image{readImage(name)};
    if (image.asset)
        image.aspect = ownLeafAspect(*image.asset).value_or(0.0);
    return *m_images.insert(name, image);
}

Result<void> RecipeReading::readParameters(const QJsonObject& json, const QString& place)
{
    if (json.isEmpty())
        return {};
    TreeParameters base = m_parameters;
    const ImageOfName imageOfName = [this](const QString& name) { return image(name).asset; };
    const QString leaf =
        json.value(QLatin1String("leaves")).toObject().value(QLatin1String("image")).toString();
    if (!leaf.isEmpty()) {
        const Image& found = image(leaf);
        if (found.asset && found.aspect == 0.0)
            return inputError(place + QLatin1String(".leaves.image"), noLeafIn(*found.asset));
        if (found.asset && !(base.leaves.image == *found.asset))
            adoptImage(base.leaves, *found.asset, found.aspect);
    }
    Result<TreeParameters> parameters = fromJson(json, base, place, imageOfName);
    if (!parameters)
        return parameters.error();
    m_parameters = std::move(*parameters);
    normaliseDirectionWeights(m_parameters.growth);
    return {};
}

bool RecipeReading::admitSamples(JsonReader& reader, QLatin1StringView key, qsizetype samples)
{
    m_samples += samples;
    if (m_samples > recipeLimits::kSamples)
        reader.fail(key, RecipeText::tr("a recipe can have at most %1 samples").arg(recipeLimits::kSamples));
    return m_samples <= recipeLimits::kSamples;
}

} // namespace espalier
