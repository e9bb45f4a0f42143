// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/texture/OwnTextures.h"

#include "model/texture/TextureShading.h"

#include <QColorSpace>
#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <deque>
#include <numbers>
#include <vector>

namespace espalier {

namespace {

constexpr int kAspectEdge = 512; ///< px, at which a leaf's aspect is measured
constexpr double kLeastAspect = 0.02;
constexpr double kGreatestAspect = 3.0;
// The largest difference of a background's colours, and the difference from which on a colour is wholly leaf;
// of 255.
constexpr int kPlainSpread = 24;
constexpr float kBackgroundEnd = 14.0F;
constexpr float kLeafBegin = 44.0F;
/// A pixel with less alpha is not leaf.
constexpr int kCovered = 128;
/// The colour of a pixel with more alpha contains nothing of the background.
constexpr int kSolid = 240;
constexpr double kLeastLeaf = 0.002; ///< Share of the image
constexpr double kLeastRim = 0.6;    ///< Share of its rim that is background

/// Relief from an image's brightness, as a share of its edge.
constexpr float kBarkRelief = 0.014F;
constexpr float kLeafRelief = 0.008F;

QImage inSrgb(QImage image)
{
    const QColorSpace space = image.colorSpace();
    if (space.isValid() && space != QColorSpace(QColorSpace::SRgb))
        image.convertToColorSpace(QColorSpace(QColorSpace::SRgb));
    return image;
}

QImage noLargerThan(const QImage& image, int edge)
{
    if (std::max(image.width(), image.height()) <= edge)
        return image;
    return image.scaled(edge, edge, Qt::KeepAspectRatio, Qt::SmoothTransformation);
}

int distance(const uchar* a, const std::array<int, 3>& b)
{
    return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
}

/// The common colour of all four corners, if they have one.
std::optional<std::array<int, 3>> backgroundOf(const QImage& image)
{
    const int patch = std::max(2, std::min(image.width(), image.height()) / 50);
    std::array<int, 3> sum{};
    std::vector<const uchar*> pixels;
    for (const int left : {0, image.width() - patch}) {
        for (const int top : {0, image.height() - patch}) {
            for (int y = top; y < top + patch; ++y) {
                for (int x = left; x < left + patch; ++x) {
                    pixels.push_back(image.constScanLine(y) + 4 * x);
                    for (std::size_t i = 0; i < 3; ++i)
                        sum[i] += pixels.back()[i];
                }
            }
        }
    }
    const int count = static_cast<int>(pixels.size());
    for (int& channel : sum)
        channel /= count;
    const auto off = std::ranges::count_if(
        pixels, [&](const uchar* pixel) { return distance(pixel, sum) > kPlainSpread; });
    // Dust and noise are tolerated.
    return off > count / 50 ? std::nullopt : std::optional(sum);
}

/// Removes the pixels that are like the background and connected with the image's edge; false if there is no
/// such background all around.
bool takeBackgroundOut(QImage& image)
{
    const auto background = backgroundOf(image);
    if (!background)
        return false;
    const int width = image.width();
    const int height = image.height();
    std::vector<bool> seen(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    std::vector<QPoint> open;
    const auto visit = [&](int x, int y) {
        if (x < 0 || y < 0 || x >= width || y >= height)
            return;
        const auto index =
            static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
        if (seen[index])
            return;
        seen[index] = true;
        uchar* const pixel = image.scanLine(y) + 4 * x;
        const auto off = static_cast<float>(distance(pixel, *background));
        pixel[3] = toByte(smoothStep(kBackgroundEnd, kLeafBegin, off));
        if (off < kLeafBegin)
            open.push_back({x, y});
    };
    for (int x = 0; x < width; ++x) {
        visit(x, 0);
        visit(x, height - 1);
    }
    for (int y = 0; y < height; ++y) {
        visit(0, y);
        visit(width - 1, y);
    }
    while (!open.empty()) {
        const QPoint place = open.back();
        open.pop_back();
        visit(place.x() - 1, place.y());
        visit(place.x() + 1, place.y());
        visit(place.x(), place.y() - 1);
        visit(place.x(), place.y() + 1);
    }
    const auto isOut = [&](int x, int y) { return image.constScanLine(y)[4 * x + 3] < kCovered ? 1 : 0; };
    int out = 0;
    for (int x = 0; x < width; ++x)
        out += isOut(x, 0) + isOut(x, height - 1);
    for (int y = 0; y < height; ++y)
        out += isOut(0, y) + isOut(width - 1, y);
    return out > kLeastRim * 2 * (width + height);
}

bool isTransparentAnywhere(const QImage& image)
{
    for (int y = 0; y < image.height(); ++y) {
        const uchar* pixel = image.constScanLine(y);
        for (int x = 0; x < image.width(); ++x, pixel += 4) {
            if (pixel[3] < kCovered)
                return true;
        }
    }
    return false;
}

/// The rectangle of the leaf, with its petiole in the middle if that needs little more room; null if there is
/// no leaf.
QRect leafIn(const QImage& image)
{
    int left = image.width();
    int right = -1;
    int top = image.height();
    int bottom = -1;
    std::int64_t covered = 0;
    for (int y = 0; y < image.height(); ++y) {
        const uchar* const line = image.constScanLine(y);
        for (int x = 0; x < image.width(); ++x) {
            if (line[4 * x + 3] < kCovered)
                continue;
            ++covered;
            left = std::min(left, x);
            right = std::max(right, x);
            top = std::min(top, y);
            bottom = y;
        }
    }
    if (static_cast<double>(covered) < kLeastLeaf * image.width() * image.height())
        return {};
    std::int64_t sum = 0;
    std::int64_t count = 0;
    for (int y = std::max(top, bottom - (bottom - top) / 40); y <= bottom; ++y) {
        for (int x = left; x <= right; ++x) {
            if (image.constScanLine(y)[4 * x + 3] >= kCovered) {
                sum += x;
                ++count;
            }
        }
    }
    const int petiole = static_cast<int>(sum / std::max<std::int64_t>(1, count));
    const int half = std::max(petiole - left, right - petiole);
    // A leaf that lies aslant, or has lobes beside its petiole, would leave half of the image empty.
    const bool isNearMiddle = 2 * half < (right - left) * 3 / 2;
    if (isNearMiddle) {
        left = petiole - half;
        right = petiole + half;
    }
    return {left, top, right - left + 1, bottom - top + 1};
}

/// Whether a place and all places within @p margin pixels of it are covered.
bool isSolid(const QImage& image, int x, int y, int margin)
{
    for (int row = std::max(0, y - margin); row <= std::min(image.height() - 1, y + margin); ++row) {
        const uchar* const line = image.constScanLine(row);
        for (int column = std::max(0, x - margin); column <= std::min(image.width() - 1, x + margin);
             ++column) {
            if (line[4 * column + 3] <= kSolid)
                return false;
        }
    }
    return true;
}

/// Extends the leaf's colours beyond its edge and over @p margin pixels within it, whose colours contain the
/// background's: each place gets the mean colour of the smallest neighbourhood that has colours.
void spreadColours(QImage& image, int margin)
{
    struct Level {
        int width;
        int height;
        std::vector<std::array<float, 4>> pixels; ///< Colours times their weight, and the weight
    };
    std::deque<Level> levels;
    Level& first = levels.emplace_back(Level{image.width(), image.height(), {}});
    first.pixels.reserve(static_cast<std::size_t>(image.width()) * static_cast<std::size_t>(image.height()));
    for (int y = 0; y < image.height(); ++y) {
        const uchar* pixel = image.constScanLine(y);
        for (int x = 0; x < image.width(); ++x, pixel += 4) {
            const float weight = isSolid(image, x, y, margin) ? 1.0F : 0.0F;
            first.pixels.push_back({weight * static_cast<float>(pixel[0]),
                                    weight * static_cast<float>(pixel[1]),
                                    weight * static_cast<float>(pixel[2]), weight});
        }
    }
    while (levels.back().width > 1 || levels.back().height > 1) {
        const Level& fine = levels.back();
        Level coarse{(fine.width + 1) / 2, (fine.height + 1) / 2, {}};
        coarse.pixels.resize(static_cast<std::size_t>(coarse.width) *
                             static_cast<std::size_t>(coarse.height));
        for (int y = 0; y < fine.height; ++y) {
            for (int x = 0; x < fine.width; ++x) {
                const auto& from = fine.pixels[static_cast<std::size_t>(y * fine.width + x)];
                auto& to = coarse.pixels[static_cast<std::size_t>(y / 2 * coarse.width + x / 2)];
                for (std::size_t i = 0; i < 4; ++i)
                    to[i] += from[i];
            }
        }
        levels.push_back(std::move(coarse));
    }
    for (int y = 0; y < image.height(); ++y) {
        uchar* pixel = image.scanLine(y);
        for (int x = 0; x < image.width(); ++x, pixel += 4) {
            if (first.pixels[static_cast<std::size_t>(y * image.width() + x)][3] > 0.0F)
                continue;
            for (std::size_t level = 1; level < levels.size(); ++level) {
                const auto& mean =
                    levels[level]
                        .pixels[static_cast<std::size_t>((y >> level) * levels[level].width + (x >> level))];
                if (mean[3] < 1.0F)
                    continue;
                for (std::size_t i = 0; i < 3; ++i)
                    pixel[i] = static_cast<uchar>(mean[i] / mean[3] + 0.5F);
                break;
            }
        }
    }
}

/// Perceived brightness, 0...1.
HeightMap lightness(const QImage& image)
{
    const QImage grey = image.convertToFormat(QImage::Format_Grayscale8);
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
    QImage image(lightness.width, lightness.height, QImage::Format_Grayscale8);
    for (int y = 0; y < image.height(); ++y) {
        uchar* const line = image.scanLine(y);
        for (int x = 0; x < image.width(); ++x) {
            const float value = lightness.values[static_cast<std::size_t>(y * image.width() + x)];
            line[x] = toByte(std::clamp(middle - 0.5F * (value - mean), 0.2F, 1.0F));
        }
    }
    return image;
}

/// How often an image must be repeated across and along to become about square.
QSize repeats(const QSize& size)
{
    QSize best(1, 1);
    double least = 10.0;
    for (int across = 1; across <= 4; ++across) {
        for (int along = 1; along <= 4; ++along) {
            const double off =
                std::abs(std::log(static_cast<double>(across * size.width()) / (along * size.height())));
            // Of two equally good numbers, the smaller one.
            if (off + 0.05 * (across * along) < least) {
                least = off + 0.05 * (across * along);
                best = {across, along};
            }
        }
    }
    return best;
}

/// Mean difference of an image's columns (or rows) a and b.
double difference(const QImage& image, int a, int b, bool rows)
{
    std::int64_t sum = 0;
    const int length = rows ? image.width() : image.height();
    for (int i = 0; i < length; ++i) {
        const uchar* const first = rows ? image.constScanLine(a) + 3 * i : image.constScanLine(i) + 3 * a;
        const uchar* const second = rows ? image.constScanLine(b) + 3 * i : image.constScanLine(i) + 3 * b;
        for (int channel = 0; channel < 3; ++channel)
            sum += std::abs(first[channel] - second[channel]);
    }
    return static_cast<double>(sum) / length;
}

/// Whether an image (Format_RGB888) shows a seam when it is repeated.
bool hasSeam(const QImage& image, bool rows)
{
    const int count = rows ? image.height() : image.width();
    double inside = 0.0;
    for (int i = 0; i + 1 < count; ++i)
        inside += difference(image, i, i + 1, rows) / (count - 1);
    return difference(image, count - 1, 0, rows) > 2.0 * inside + 3.0;
}

/// Fades the last eighth of an image (Format_RGB888) into the pixels before its first row or column, so that
/// it repeats; the original content of that eighth is lost.
QImage withoutSeam(const QImage& image, bool rows)
{
    const int whole = rows ? image.height() : image.width();
    const int band = whole / 8;
    const int kept = whole - band;
    QImage result = rows ? image.copy(0, 0, image.width(), kept) : image.copy(0, 0, kept, image.height());
    for (int i = 0; i < band; ++i) {
        // The pixels before the first row are those that follow the last kept one.
        const int share = 255 * (2 * i + 1) / (2 * band);
        const int length = rows ? image.width() : image.height();
        for (int j = 0; j < length; ++j) {
            uchar* const to = rows ? result.scanLine(i) + 3 * j : result.scanLine(j) + 3 * i;
            const uchar* const beyond =
                rows ? image.constScanLine(kept + i) + 3 * j : image.constScanLine(j) + 3 * (kept + i);
            for (int channel = 0; channel < 3; ++channel)
                to[channel] =
                    static_cast<uchar>((share * to[channel] + (255 - share) * beyond[channel] + 127) / 255);
        }
    }
    return result;
}

/// How an image becomes a repeating tile; the same for all images of a bark.
struct Tiling {
    bool fadesRows = false;
    bool fadesColumns = false;
    QSize repeats{1, 1};
    int edge = 0; ///< px, of the result

    static Tiling of(const QImage& image, int size)
    {
        Tiling tiling;
        tiling.fadesRows = hasSeam(image, true);
        tiling.fadesColumns = hasSeam(image, false);
        tiling.repeats = espalier::repeats(image.size());
        tiling.edge = std::min(
            size, std::max(tiling.repeats.width() * image.width(), tiling.repeats.height() * image.height()));
        return tiling;
    }

    QImage operator()(QImage image) const
    {
        image = image.convertToFormat(QImage::Format_RGB888);
        if (fadesRows)
            image = withoutSeam(image, true);
        if (fadesColumns)
            image = withoutSeam(image, false);
        const int across = repeats.width();
        const int along = repeats.height();
        image = image
                    .scaled(std::max(1, edge / across), std::max(1, edge / along), Qt::IgnoreAspectRatio,
                            Qt::SmoothTransformation)
                    .convertToFormat(QImage::Format_RGB888);
        if (repeats == QSize(1, 1))
            return image;
        QImage tiled(across * image.width(), along * image.height(), QImage::Format_RGB888);
        const auto bytes = static_cast<std::size_t>(3 * image.width());
        for (int y = 0; y < tiled.height(); ++y) {
            for (int i = 0; i < across; ++i)
                std::memcpy(tiled.scanLine(y) + static_cast<std::size_t>(i) * bytes,
                            image.constScanLine(y % image.height()), bytes);
        }
        return tiled;
    }
};

/// Several repeats of a tile can be a pixel or two short; this scales all images of one material to one size.
QImage sized(const QImage& image, const QSize& size)
{
    return image.size() == size ? image : image.scaled(size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
}

} // namespace

std::optional<QImage> cutLeaf(const ImageAsset& asset, int size)
{
    const QImage pixels = asset.pixels();
    if (pixels.isNull())
        return {};
    QImage image = noLargerThan(inSrgb(pixels), size).convertToFormat(QImage::Format_RGBA8888);
    const bool hasAlpha = pixels.hasAlphaChannel() && isTransparentAnywhere(image);
    if (!hasAlpha && !takeBackgroundOut(image))
        return {};
    const QRect leaf = leafIn(image);
    if (leaf.isNull() || (!hasAlpha && !isTransparentAnywhere(image)))
        return {};
    // In a photograph an edge is blurred over a few pixels.
    const int margin = hasAlpha ? 0 : 2;
    image = image.copy(leaf.adjusted(-margin, -margin, margin, margin));
    spreadColours(image, margin);
    return image.copy(QRect(QPoint(margin, margin), leaf.size()));
}

std::optional<double> ownLeafAspect(const ImageAsset& image)
{
    const std::optional<QImage> leaf = cutLeaf(image, kAspectEdge);
    if (!leaf)
        return {};
    return std::clamp(static_cast<double>(leaf->width()) / leaf->height(), kLeastAspect, kGreatestAspect);
}

QString noLeafIn(const ImageAsset& image)
{
    return QCoreApplication::translate(
               "OwnTextures", "%1: there is no telling the leaf from what is behind it; the image needs a "
                              "transparent or a plain background")
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
    const QImage pixels = inSrgb(bark.image.pixels());
    if (pixels.isNull())
        return barkTextures(bark.kind, size);
    const QImage image = pixels.convertToFormat(QImage::Format_RGB888);
    const Tiling tile = Tiling::of(image, size);
    SurfaceTextures textures;
    textures.colour = tile(image);
    const HeightMap light = lightness(textures.colour);
    if (const QImage normal = bark.normalImage.pixels(); !normal.isNull()) {
        textures.normal = sized(tile(normal), textures.colour.size());
    } else {
        textures.normal = normalMap(smoothedMap(light, true),
                                    kBarkRelief * static_cast<float>(textures.colour.width()), true);
    }
    if (const QImage roughness = bark.roughnessImage.pixels(); !roughness.isNull()) {
        textures.roughness =
            sized(tile(roughness), textures.colour.size()).convertToFormat(QImage::Format_Grayscale8);
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
    const HeightMap light = lightness(leaf->convertToFormat(QImage::Format_RGB888));
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
