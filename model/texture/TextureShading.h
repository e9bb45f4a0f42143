// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Parallel.h"
#include "model/texture/AllocatedImage.h"
#include "model/texture/Textures.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace espalier {

/// sRGB, 0...1.
struct Colour {
    float red = 0.0F;
    float green = 0.0F;
    float blue = 0.0F;

    Colour operator*(float factor) const { return {red * factor, green * factor, blue * factor}; }
};

/// One place of a procedural texture.
struct TexturePoint {
    Colour colour;
    float height = 0.0F;    ///< 0...1 of the texture's relief
    float roughness = 0.8F; ///< 0 a mirror, 1 chalk
};

inline float clamped(float value)
{
    return std::clamp(value, 0.0F, 1.0F);
}

inline float smoothStep(float from, float to, float value)
{
    const float t = clamped((value - from) / (to - from));
    return t * t * (3.0F - 2.0F * t);
}

inline Colour mix(const Colour& a, const Colour& b, float share)
{
    return {a.red + share * (b.red - a.red), a.green + share * (b.green - a.green),
            a.blue + share * (b.blue - a.blue)};
}

inline uchar toByte(float value)
{
    return static_cast<uchar>(255.0F * clamped(value) + 0.5F);
}

/// Heights, from the upper row down.
struct HeightMap {
    std::vector<float> values;
    int width = 0;
    int height = 0;
};

/// The normal map of a relief in which a height of 1 stands @p relief pixels above 0 (Format_RGB888). @p
/// repeats: the image continues at its opposite edge, otherwise the edge's own height continues.
QImage normalMap(const HeightMap& heights, float relief, bool repeats);

/// Rows that one task paints.
inline constexpr std::size_t kRowsPerTask = 32;

/// An image whose pixels @p paint(u, v, out) writes, each by advancing out by its bytes; u and v are the
/// coordinates of the pixel's middle, v rises from the bottom row.
template <class Paint>
QImage paintPixels(int size, QImage::Format format, const Paint& paint)
{
    QImage image = allocated(QImage(size, size, format));
    uchar* bytes = image.bits();
    const auto stride = static_cast<std::size_t>(image.bytesPerLine());
    const float pixel = 1.0F / static_cast<float>(size);
    parallelFor(static_cast<std::size_t>(size), kRowsPerTask, [&](std::size_t begin, std::size_t end) {
        for (std::size_t row = begin; row < end; ++row) {
            uchar* out = bytes + row * stride;
            const float v = 1.0F - (static_cast<float>(row) + 0.5F) * pixel;
            for (int column = 0; column < size; ++column)
                paint((static_cast<float>(column) + 0.5F) * pixel, v, out);
        }
    });
    return image;
}

inline void writeColour(const Colour& colour, uchar*& out)
{
    *out++ = toByte(colour.red);
    *out++ = toByte(colour.green);
    *out++ = toByte(colour.blue);
}

/// The colours of @p texture(u, v) at the middle of each pixel; v rises from the bottom row.
template <class Texture>
QImage paintAlbedo(int size, const Texture& texture)
{
    return paintPixels(size, QImage::Format_RGB888,
                       [&](float u, float v, uchar*& out) { writeColour(texture(u, v).colour, out); });
}

/// All textures of @p texture(u, v), which is called once for each pixel: colours, with alpha if its points
/// have one, normals where a height of 1 stands @p relief of the image's edge above 0, and roughness. @p
/// repeats: the image continues at its opposite edge, otherwise the edge's own height continues.
template <class Texture>
SurfaceTextures paintSurface(int size, const Texture& texture, float relief, bool repeats)
{
    constexpr bool hasAlpha = requires(const Texture& t)
    {
        t(0.0F, 0.0F).alpha;
    };
    const QImage::Format format = hasAlpha ? QImage::Format_RGBA8888 : QImage::Format_RGB888;
    SurfaceTextures images{
        allocated(QImage(size, size, format)), {}, allocated(QImage(size, size, QImage::Format_Grayscale8))};
    const auto count = static_cast<std::size_t>(size);
    HeightMap heights{std::vector<float>(count * count), size, size};
    const float pixel = 1.0F / static_cast<float>(size);
    uchar* const colours = images.colour.bits();
    uchar* const roughness = images.roughness.bits();
    const auto colourStride = static_cast<std::size_t>(images.colour.bytesPerLine());
    const auto roughnessStride = static_cast<std::size_t>(images.roughness.bytesPerLine());
    parallelFor(count, kRowsPerTask, [&](std::size_t begin, std::size_t end) {
        for (std::size_t row = begin; row < end; ++row) {
            const float v = 1.0F - (static_cast<float>(row) + 0.5F) * pixel;
            uchar* out = colours + row * colourStride;
            for (std::size_t column = 0; column < count; ++column) {
                const auto point = texture((static_cast<float>(column) + 0.5F) * pixel, v);
                writeColour(point.colour, out);
                if constexpr (hasAlpha)
                    *out++ = toByte(point.alpha);
                heights.values[row * count + column] = point.height;
                roughness[row * roughnessStride + column] = toByte(point.roughness);
            }
        }
    });
    images.normal = normalMap(heights, relief * static_cast<float>(size), repeats);
    return images;
}

} // namespace espalier
