// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/texture/TextureShading.h"

#include "model/texture/AllocatedImage.h"

namespace espalier {

QImage normalMap(const HeightMap& heights, float relief, bool repeats)
{
    const auto columns = static_cast<std::size_t>(heights.width);
    const auto rows = static_cast<std::size_t>(heights.height);
    QImage image = allocated(QImage(heights.width, heights.height, QImage::Format_RGB888));
    uchar* const bytes = image.bits();
    const auto stride = static_cast<std::size_t>(image.bytesPerLine());
    const auto before = [repeats](std::size_t i, std::size_t count) {
        return i > 0 ? i - 1 : (repeats ? count - 1 : 0);
    };
    const auto after = [repeats](std::size_t i, std::size_t count) {
        return i + 1 < count ? i + 1 : (repeats ? 0 : count - 1);
    };
    const float steepness = 0.5F * relief;
    parallelFor(rows, kRowsPerTask, [&](std::size_t begin, std::size_t end) {
        for (std::size_t row = begin; row < end; ++row) {
            uchar* out = bytes + row * stride;
            const float* const line = heights.values.data() + row * columns;
            const float* const above = heights.values.data() + before(row, rows) * columns;
            const float* const below = heights.values.data() + after(row, rows) * columns;
            for (std::size_t column = 0; column < columns; ++column) {
                const float x = -steepness * (line[after(column, columns)] - line[before(column, columns)]);
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
