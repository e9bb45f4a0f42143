// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/export/SceneTextures.h"

namespace espalier {

namespace {

std::vector<const ExportTexture*> texturesOf(const ExportScene& scene)
{
    std::vector<const ExportTexture*> textures;
    for (const ExportMaterial& material : scene.materials) {
        for (const ExportTexture* texture :
             {&material.colour, &material.normal, &material.roughness, &material.mask}) {
            if (!texture->png.isEmpty())
                textures.push_back(texture);
        }
    }
    return textures;
}

} // namespace

QString textureEnding(const ExportTexture& texture)
{
    return QLatin1Char('_') + texture.name + QLatin1String(".png");
}

QStringList textureEndings(const ExportScene& scene)
{
    QStringList endings;
    for (const ExportTexture* texture : texturesOf(scene))
        endings.append(textureEnding(*texture));
    return endings;
}

Result<void> addTextures(const ExportScene& scene, ExportFiles& files)
{
    for (const ExportTexture* texture : texturesOf(scene)) {
        if (Result<void> added = files.addCompanion(textureEnding(*texture), texture->png); !added)
            return added;
    }
    return {};
}

} // namespace espalier
