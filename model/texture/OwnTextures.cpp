// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/texture/OwnTextures.h"

#include "model/texture/AllocatedImage.h"
#include "model/texture/LeafCut.h"
#include "model/texture/RepeatingTile.h"
#include "model/texture/TextureShading.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace espalier {

namespace {

constexpr int kAspectEdge = 512; ///< px, at which a leaf's aspect is measured
constexpr double kLeastAspect = 0.02;
constexpr double kGreatestAspect = 3.0;

/// Relief from an image's brightness, as a share of its edge.
constexpr float kBarkRelief = 0.014F;
constexpr float kLeafRelief = 0.008F;

/// Perceived brightness, 0...1.
HeightMap lightness(const QImage& image)
{
    const QImage grey = allocated(image.convertToFormat(QImage::Format_Grayscale8));
    HeightMap map{{}, grey.width(), grey.height()};
    map.values.reserve(static_cast<std::size_t>(grey.width()) * static_cast<std::size_t>(grey.height()));
    for (int y = 0; y < grey.height(); ++y) {
        const uchar* const line = grey.constScanLine(y);
        for (int x = 0; x < grey.width(); ++x)
            map.values.push_back(static_cast<float>(line[x]) / 255.0F);
    }
    return map;
}

/// A photograph's noise makes no relief.
HeightMap smoothedMap(const HeightMap& map, bool repeats)
{
    HeightMap result = map;
    const auto at = [&](int x, int y) {
        if (repeats) {
            x = (x + map.width) % map.width;
            y = (y + map.height) % map.height;
        } else {
            x = std::clamp(x, 0, map.width - 1);
            y = std::clamp(y, 0, map.height - 1);
        }
        return map.values[static_cast<std::size_t>(y * map.width + x)];
    };
    parallelFor(static_cast<std::size_t>(map.height), kRowsPerTask, [&](std::size_t begin, std::size_t end) {
        for (int y = static_cast<int>(begin); y < static_cast<int>(end); ++y) {
            for (int x = 0; x < map.width; ++x) {
                float sum = 0.0F;
                for (int dy = -1; dy <= 1; ++dy)
                    sum += at(x - 1, y + dy) + 2.0F * at(x, y + dy) + at(x + 1, y + dy);
                result.values[static_cast<std::size_t>(y * map.width + x)] = sum / 12.0F;
            }
        }
    });
    return result;
}

/// Roughness around @p middle: what is darker than the mean is duller.
QImage roughnessMap(const HeightMap& lightness, float middle)
{
    double sum = 0.0;
    for (const float value : lightness.values)
        sum += static_cast<double>(value);
    const auto mean = static_cast<float>(sum / static_cast<double>(lightness.values.size()));
    QImage image = allocated(QImage(lightness.width, lightness.height, QImage::Format_Grayscale8));
    for (int y = 0; y < image.height(); ++y) {
        uchar* const line = image.scanLine(y);
        for (int x = 0; x < image.width(); ++x) {
            const float value = lightness.values[static_cast<std::size_t>(y * image.width() + x)];
            line[x] = toByte(std::clamp(middle - 0.5F * (value - mean), 0.2F, 1.0F));
        }
    }
    return image;
}

/// Several repeats of a tile can be a pixel or two short; this scales all images of one material to one size.
QImage sized(const QImage& image, const QSize& size)
{
    return image.size() == size
               ? image
               : allocated(image.scaled(size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation));
}

} // namespace

std::optional<double> ownLeafAspect(const ImageAsset& image)
{
    const std::optional<QImage> leaf = cutLeaf(image, kAspectEdge);
    if (!leaf)
        return {};
    return std::clamp(static_cast<double>(leaf->width()) / leaf->height(), kLeastAspect, kGreatestAspect);
}

QString noLeafIn(const ImageAsset& image)
{
    return QCoreApplication::translate("OwnTextures",
                                       "%1: the leaf cannot be told apart from its background; the image "
                                       "needs a transparent or a plain background")
        .arg(image.name());
}

void adoptImage(LeafParameters& leaves, const ImageAsset& image, double aspect)
{
    leaves.image = image;
    leaves.aspect = aspect;
    leaves.hue = kLeafTextureHue;
    leaves.saturation = 1.0;
    leaves.brightness = 1.0;
}

SurfaceTextures barkTextures(const BarkParameters& bark, int size)
{
    const QImage pixels = bark.image.colours();
    if (pixels.isNull())
        return barkTextures(bark.kind, size);
    const QImage image = allocated(pixels.convertToFormat(QImage::Format_RGB888));
    const RepeatingTile tile(image, size);
    SurfaceTextures textures;
    textures.colour = tile.of(image);
    const HeightMap light = lightness(textures.colour);
    if (const QImage normal = bark.normalImage.pixels(); !normal.isNull()) {
        textures.normal = sized(tile.of(normal), textures.colour.size());
    } else {
        textures.normal = normalMap(smoothedMap(light, true),
                                    kBarkRelief * static_cast<float>(textures.colour.width()), true);
    }
    if (const QImage roughness = bark.roughnessImage.pixels(); !roughness.isNull()) {
        textures.roughness = allocated(
            sized(tile.of(roughness), textures.colour.size()).convertToFormat(QImage::Format_Grayscale8));
    } else {
        textures.roughness = roughnessMap(light, 0.82F);
    }
    return textures;
}

SurfaceTextures leafTextures(const LeafParameters& leaves, int size)
{
    std::optional<QImage> leaf;
    if (!leaves.image.isNull())
        leaf = cutLeaf(leaves.image, size);
    if (!leaf)
        return leafTextures(leaves.shape, size);
    const HeightMap light = lightness(allocated(leaf->convertToFormat(QImage::Format_RGB888)));
    const float edge = static_cast<float>(std::max(leaf->width(), leaf->height()));
    return {*leaf, normalMap(smoothedMap(light, false), kLeafRelief * edge, false),
            roughnessMap(light, 0.55F)};
}

std::array<double, 3> hueFactors(double angle)
{
    // A green of value 0.5 and saturation 0.62, and the green that it becomes; see leaf.vert.
    constexpr std::array kShown{0.305, 0.5, 0.19};
    constexpr std::array kOffsets{5.0, 3.0, 1.0};
    std::array<double, 3> factors;
    for (std::size_t i = 0; i < 3; ++i) {
        const double k =
            std::fmod(kOffsets[i] + (kLeafTextureHue + angle) * 3.0 / std::numbers::pi + 12.0, 6.0);
        const double turned = 0.5 - 0.31 * std::clamp(std::min(k, 4.0 - k), 0.0, 1.0);
        factors[i] = turned / kShown[i] * (turned / kShown[i]);
    }
    return factors;
}

} // namespace espalier
