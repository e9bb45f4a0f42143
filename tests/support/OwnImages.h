// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QBuffer>
#include <QByteArray>
#include <QImage>
#include <QPainter>

#include <cmath>

namespace espalier::test {

inline QByteArray pngOf(const QImage& image)
{
    QByteArray file;
    QBuffer buffer(&file);
    image.save(&buffer, "png");
    return file;
}

/// A leaf of 80 × 160 pixels, an ellipse, with a wide margin.
inline QImage drawnLeaf(const QColor& background)
{
    QImage image(120, 200, QImage::Format_ARGB32);
    image.fill(background);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(70, 150, 40));
    painter.drawEllipse(QRectF(20, 20, 80, 160));
    return image;
}

/// Brown waves that repeat.
inline QImage repeatingBark(int width, int height)
{
    QImage image(width, height, QImage::Format_RGB32);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const double wave = std::sin(6.2831853 * (3.0 * x / width + std::sin(6.2831853 * y / height)));
            const int light = static_cast<int>(100 + 50 * wave);
            image.setPixelColor(x, y, QColor(light, light * 3 / 4, light / 2));
        }
    }
    return image;
}

} // namespace espalier::test
