// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/texture/RepeatingTile.h"

#include "model/texture/AllocatedImage.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>

namespace espalier {

namespace {

/// How often an image must be repeated across and along to become about square.
QSize repeatsOf(const QSize& size)
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
    QImage result =
        allocated(rows ? image.copy(0, 0, image.width(), kept) : image.copy(0, 0, kept, image.height()));
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

} // namespace

RepeatingTile::RepeatingTile(const QImage& image, int size)
    : m_fadesRows(hasSeam(image, true)),
      m_fadesColumns(hasSeam(image, false)),
      m_repeats(repeatsOf(image.size())),
      m_edge(std::min(size, std::max(m_repeats.width() * image.width(), m_repeats.height() * image.height())))
{
}

QImage RepeatingTile::of(QImage image) const
{
    image = allocated(image.convertToFormat(QImage::Format_RGB888));
    if (m_fadesRows)
        image = withoutSeam(image, true);
    if (m_fadesColumns)
        image = withoutSeam(image, false);
    const int across = m_repeats.width();
    const int along = m_repeats.height();
    image = allocated(image.scaled(std::max(1, m_edge / across), std::max(1, m_edge / along),
                                   Qt::IgnoreAspectRatio, Qt::SmoothTransformation));
    image = allocated(image.convertToFormat(QImage::Format_RGB888));
    if (m_repeats == QSize(1, 1))
        return image;
    QImage tiled = allocated(QImage(across * image.width(), along * image.height(), QImage::Format_RGB888));
    const auto bytes = static_cast<std::size_t>(3 * image.width());
    for (int y = 0; y < tiled.height(); ++y) {
        for (int i = 0; i < across; ++i)
            std::memcpy(tiled.scanLine(y) + static_cast<std::size_t>(i) * bytes,
                        image.constScanLine(y % image.height()), bytes);
    }
    return tiled;
}

} // namespace espalier
