// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Parallel.h"

#include <QImage>

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
    float height = 0.0F; ///< 0...1 of the texture's relief
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

/// Rows that one task paints.
inline constexpr std::size_t kRowsPerTask = 32;

/// An image whose pixels @p paint(u, v, out) writes, each by advancing out by its bytes; u and v are those of
/// its middle, v rises from the bottom row.
template <class Paint>
QImage paintPixels(int size, QImage::Format format, const Paint& paint)
{
    QImage image(size, size, format);
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

/// The normal map of the heights of @p texture: a height of 1 stands @p relief of the image's edge above 0.
/// @p repeats: the image continues at its opposite edge, else the edge's own height goes on.
template <class Texture>
QImage paintNormals(int size, const Texture& texture, float relief, bool repeats)
{
    const auto count = static_cast<std::size_t>(size);
    const float pixel = 1.0F / static_cast<float>(size);
    std::vector<float> heights(count * count);
    parallelFor(count, kRowsPerTask, [&](std::size_t begin, std::size_t end) {
        for (std::size_t row = begin; row < end; ++row) {
            const float v = 1.0F - (static_cast<float>(row) + 0.5F) * pixel;
            for (std::size_t column = 0; column < count; ++column)
                heights[row * count + column] =
                    texture((static_cast<float>(column) + 0.5F) * pixel, v).height;
        }
    });

    QImage image(size, size, QImage::Format_RGB888);
    uchar* bytes = image.bits();
    const auto stride = static_cast<std::size_t>(image.bytesPerLine());
    const auto before = [&](std::size_t i) { return i > 0 ? i - 1 : (repeats ? count - 1 : 0); };
    const auto after = [&](std::size_t i) { return i + 1 < count ? i + 1 : (repeats ? 0 : count - 1); };
    const float steepness = relief / (2.0F * pixel);
    parallelFor(count, kRowsPerTask, [&](std::size_t begin, std::size_t end) {
        for (std::size_t row = begin; row < end; ++row) {
            uchar* out = bytes + row * stride;
            const float* line = heights.data() + row * count;
            const float* above = heights.data() + before(row) * count;
            const float* below = heights.data() + after(row) * count;
            for (std::size_t column = 0; column < count; ++column) {
                const float x = -steepness * (line[after(column)] - line[before(column)]);
                const float y = -steepness * (above[column] - below[column]);
                const float scale = 0.5F / std::sqrt(x * x + y * y + 1.0F);
                *out++ = toByte(0.5F + scale * x);
                *out++ = toByte(0.5F + scale * y);
                *out++ = toByte(0.5F + scale);
            }
        }
    });
    return image;
}

} // namespace espalier
