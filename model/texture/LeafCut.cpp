// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/texture/LeafCut.h"

#include "model/texture/AllocatedImage.h"
#include "model/texture/TextureShading.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <deque>
#include <vector>

namespace espalier {

namespace {

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

QImage noLargerThan(const QImage& image, int edge)
{
    if (std::max(image.width(), image.height()) <= edge)
        return image;
    return allocated(image.scaled(edge, edge, Qt::KeepAspectRatio, Qt::SmoothTransformation));
}

int distance(const uchar* a, const std::array<int, 3>& b)
{
    return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
}

/// The common colour of all four corners, if they have one.
std::optional<std::array<int, 3>> backgroundOf(const QImage& image)
{
    const int shorter = std::min(image.width(), image.height());
    const int patch = std::clamp(shorter / 50, std::min(2, shorter), shorter);
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

} // namespace

std::optional<QImage> cutLeaf(const ImageAsset& asset, int size)
{
    const QImage pixels = asset.colours();
    if (pixels.isNull())
        return {};
    QImage image = allocated(noLargerThan(pixels, size).convertToFormat(QImage::Format_RGBA8888));
    const bool hasAlpha = pixels.hasAlphaChannel() && isTransparentAnywhere(image);
    if (!hasAlpha && !takeBackgroundOut(image))
        return {};
    const QRect leaf = leafIn(image);
    if (leaf.isNull() || (!hasAlpha && !isTransparentAnywhere(image)))
        return {};
    // In a photograph an edge is blurred over a few pixels.
    const int margin = hasAlpha ? 0 : 2;
    image = allocated(image.copy(leaf.adjusted(-margin, -margin, margin, margin)));
    spreadColours(image, margin);
    return allocated(image.copy(QRect(QPoint(margin, margin), leaf.size())));
}

} // namespace espalier
