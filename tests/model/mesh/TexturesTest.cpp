// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/texture/Textures.h"

#include "model/mesh/LeafCard.h"
#include "model/texture/TextureShading.h"
#include "model/texture/TileNoise.h"
#include "tests/support/TestClasses.h"

#include <QColor>
#include <QTest>

#include <tbb/global_control.h>

#include <cmath>
#include <functional>

namespace espalier::test {

class TexturesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void noise_repeatsAndIsBalanced();
    void cells_repeatAndHaveBorders();
    void normals_ofAKnownSlope_areKnown();
    void images_haveTheirFormats();
    void bark_repeatsWithoutASeam();
    void bark_kindsDiffer();
    void normalMaps_areUnitAndLookOut();
    void leaf_liesWithinItsCard();
    void leaf_hasTheHueAskedFor();
    void leaf_isPalerWithLessSaturation();
    void leaf_colourGoesOnBeyondItsEdge();
    void roughness_differsWithinAndBetweenBarks();
    void roughness_ofLeavesIsThatOfTheirWax();
    void images_areTheSameOnOneThreadAndMany();
};

namespace {

constexpr std::array kBarks{BarkKind::Furrowed, BarkKind::Smooth,  BarkKind::Plated,  BarkKind::Birch,
                            BarkKind::Cherry,   BarkKind::Mottled, BarkKind::Fibrous, BarkKind::Ringed};
constexpr std::array kLeaves{
    LeafShape::Ovate,   LeafShape::Lanceolate, LeafShape::Lobed,  LeafShape::Needles,  LeafShape::Cordate,
    LeafShape::Palmate, LeafShape::Pinnate,    LeafShape::Willow, LeafShape::Fascicle, LeafShape::Frond};

double difference(QRgb a, QRgb b)
{
    return std::abs(qRed(a) - qRed(b)) + std::abs(qGreen(a) - qGreen(b)) + std::abs(qBlue(a) - qBlue(b));
}

/// Mean difference between columns (or rows) a and b.
double between(const QImage& image, int a, int b, bool rows)
{
    double sum = 0.0;
    for (int i = 0; i < image.width(); ++i)
        sum += rows ? difference(image.pixel(i, a), image.pixel(i, b))
                    : difference(image.pixel(a, i), image.pixel(b, i));
    return sum / image.width();
}

void forEachTexel(const QImage& image, const std::function<void(int, int, QRgb)>& visit)
{
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x)
            visit(x, y, image.pixel(x, y));
    }
}

bool isCovered(const LeafCard& card, float u, float v)
{
    const auto side = [](const std::array<float, 2>& a, const std::array<float, 2>& b, float x, float y) {
        return (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
    };
    for (std::size_t i = 0; i < card.indices.size(); i += 3) {
        const auto& a = card.vertices[card.indices[i]].uv;
        const auto& b = card.vertices[card.indices[i + 1]].uv;
        const auto& c = card.vertices[card.indices[i + 2]].uv;
        if (side(a, b, u, v) >= -1e-6F && side(b, c, u, v) >= -1e-6F && side(c, a, u, v) >= -1e-6F)
            return true;
    }
    return false;
}

} // namespace

void TexturesTest::noise_repeatsAndIsBalanced()
{
    const TileNoise& noise = TileNoise::shared();
    double sum = 0.0;
    double squares = 0.0;
    for (int i = 0; i < 100; ++i) {
        for (int j = 0; j < 100; ++j) {
            const float u = static_cast<float>(i) / 128.0F;
            const float v = static_cast<float>(j) / 128.0F;
            const float value = noise(u, v);
            QVERIFY(std::abs(value) < 1.5F);
            QVERIFY(std::abs(noise(u + 1.0F, v - 2.0F) - value) < 1e-5F);
            QVERIFY(std::abs(noise(u + 1.0F / 512.0F, v) - value) < 0.2F);
            sum += value;
            squares += value * value;
        }
    }
    QVERIFY(std::abs(sum / 1e4) < 0.08);
    QVERIFY(squares / 1e4 > 0.04);
}

void TexturesTest::cells_repeatAndHaveBorders()
{
    const TileCells cells(5, 3, 0.9F, 1);
    for (int i = 0; i < 64; ++i) {
        for (int j = 0; j < 64; ++j) {
            const float u = static_cast<float>(i) / 64.0F;
            const float v = static_cast<float>(j) / 64.0F;
            const TileCells::Nearest nearest = cells.nearest(u, v);
            QVERIFY(nearest.edge >= 0.0F && nearest.edge < 1.5F);
            QVERIFY(nearest.levelness >= 0.0F && nearest.levelness <= 1.0F);
            QVERIFY(nearest.x * nearest.x + nearest.y * nearest.y < 2.0F);
            const TileCells::Nearest again = cells.nearest(u + 1.0F, v - 1.0F);
            QVERIFY(std::abs(again.edge - nearest.edge) < 1e-4F);
            QVERIFY(again.value == nearest.value || nearest.edge < 1e-4F);
            // The nearest point is at most as far away as the point of the own cell.
            const TileCells::Sample own = cells.own(u, v);
            QVERIFY(nearest.x * nearest.x + nearest.y * nearest.y <= own.x * own.x + own.y * own.y + 1e-6F);
        }
    }
}

void TexturesTest::normals_ofAKnownSlope_areKnown()
{
    // Rising upward in the image at 45°: the normal leans down, so green is below the middle. 127.5 (1 − √½)
    // = 37.3.
    const auto rising = [](float, float v) { return TexturePoint{{}, v}; };
    const QImage upward = paintSurface(64, rising, 1.0F, false).normal;
    QCOMPARE(qRed(upward.pixel(20, 20)), 128);
    QCOMPARE(qGreen(upward.pixel(20, 20)), 37);
    QCOMPARE(qBlue(upward.pixel(20, 20)), 218);
    // Falling to the right: it leans right, red.
    const auto falling = [](float u, float) { return TexturePoint{{}, 1.0F - u}; };
    const QImage rightward = paintSurface(64, falling, 1.0F, false).normal;
    QCOMPARE(qRed(rightward.pixel(20, 20)), 218);
    QCOMPARE(qGreen(rightward.pixel(20, 20)), 128);
    const auto flat = [](float, float) { return TexturePoint{{}, 0.7F}; };
    QCOMPARE(paintSurface(16, flat, 1.0F, true).normal.pixel(3, 3), qRgb(128, 128, 255));
}

void TexturesTest::images_haveTheirFormats()
{
    for (const int size : {16, 128}) {
        const auto check = [size](const SurfaceTextures& images, QImage::Format colours) {
            for (const auto& [image, format] : {std::pair(images.colour, colours),
                                                {images.normal, QImage::Format_RGB888},
                                                {images.roughness, QImage::Format_Grayscale8}}) {
                QCOMPARE(image.size(), QSize(size, size));
                QCOMPARE(image.format(), format);
            }
        };
        for (const BarkKind kind : kBarks) {
            check(barkTextures(kind, size), QImage::Format_RGB888);
            QCOMPARE(barkAlbedo(kind, size), barkTextures(kind, size).colour);
        }
        for (const LeafShape shape : kLeaves) {
            check(leafTextures(shape, size), QImage::Format_RGBA8888);
            QCOMPARE(leafAlbedo(shape, size), leafTextures(shape, size).colour);
        }
    }
}

void TexturesTest::bark_repeatsWithoutASeam()
{
    constexpr int size = 256;
    for (const BarkKind kind : kBarks) {
        const SurfaceTextures textures = barkTextures(kind, size);
        for (const QImage& image : {textures.colour, textures.normal, textures.roughness}) {
            for (const bool rows : {false, true}) {
                double inside = 0.0;
                double greatest = 0.0;
                for (int i = 0; i + 1 < size; ++i) {
                    inside += between(image, i, i + 1, rows) / (size - 1);
                    greatest = std::max(greatest, between(image, i, i + 1, rows));
                }
                const double seam = between(image, size - 1, 0, rows);
                QVERIFY2(seam <= greatest && seam < 2.0 * inside, qPrintable(QString::number(seam / inside)));
                QVERIFY(inside > 0.5);
            }
        }
    }
}

void TexturesTest::bark_kindsDiffer()
{
    std::array<double, kBarks.size()> light{};
    std::array<double, kBarks.size()> warmth{};
    for (std::size_t i = 0; i < kBarks.size(); ++i) {
        forEachTexel(barkAlbedo(kBarks[i], 128), [&](int, int, QRgb texel) {
            light[i] += qGray(texel) / 16384.0;
            warmth[i] += (qRed(texel) - qBlue(texel)) / 16384.0;
        });
    }
    QVERIFY(light[3] > light[1] + 40.0);   // birch is white,
    QVERIFY(light[1] > light[0] + 30.0);   // beech grey, oak dark,
    QVERIFY(warmth[2] > warmth[0] + 10.0); // pine rusty
    QVERIFY(warmth[2] > warmth[1] + 10.0);
}

void TexturesTest::normalMaps_areUnitAndLookOut()
{
    std::vector<QImage> maps;
    for (const BarkKind kind : kBarks)
        maps.push_back(barkTextures(kind, 128).normal);
    for (const LeafShape shape : kLeaves)
        maps.push_back(leafTextures(shape, 128).normal);
    for (const QImage& map : maps) {
        double red = 0.0;
        double green = 0.0;
        double spread = 0.0;
        int wrong = 0;
        forEachTexel(map, [&](int, int, QRgb texel) {
            const auto signedOf = [](int channel) { return static_cast<float>(channel) / 127.5F - 1.0F; };
            const Vec3 normal(signedOf(qRed(texel)), signedOf(qGreen(texel)), signedOf(qBlue(texel)));
            wrong += std::abs(normal.norm() - 1.0F) < 0.02F && normal.z() > 0.0F ? 0 : 1;
            red += normal.x() / 16384.0;
            green += normal.y() / 16384.0;
            spread += (1.0F - normal.z()) / 16384.0;
        });
        QCOMPARE(wrong, 0);
        QVERIFY(std::abs(red) < 0.05 && std::abs(green) < 0.05);
        QVERIFY(spread > 0.002);
    }
}

void TexturesTest::leaf_liesWithinItsCard()
{
    constexpr int size = 256;
    for (const LeafShape shape : kLeaves) {
        const LeafCard& card = leafCard(shape);
        const QImage image = leafAlbedo(shape, size);
        int opaque = 0;
        int cutOff = 0;
        int top = size;
        forEachTexel(image, [&](int x, int y, QRgb texel) {
            const float u = (static_cast<float>(x) + 0.5F) / size;
            const float v = 1.0F - (static_cast<float>(y) + 0.5F) / size;
            if (qAlpha(texel) < 128)
                return;
            ++opaque;
            top = std::min(top, y);
            cutOff += isCovered(card, u, v) ? 0 : 1;
        });
        const double share = opaque / double{size * size};
        QVERIFY2(share > 0.2 && share < 0.8, qPrintable(QString::number(share)));
        // Except the foot of the petiole, inside the shoot.
        QVERIFY2(cutOff < 0.002 * opaque,
                 qPrintable(QStringLiteral("shape %1: %2").arg(static_cast<int>(shape)).arg(cutOff)));
        QVERIFY(qAlpha(image.pixel(size / 2, size - 1)) > 200);
        QVERIFY(top < size / 16);
    }
}

void TexturesTest::leaf_hasTheHueAskedFor()
{
    for (const LeafShape shape : kLeaves) {
        for (const double hue : {20.0, 60.0, 98.0, 140.0, 300.0}) {
            double sine = 0.0;
            double cosine = 0.0;
            forEachTexel(leafAlbedo(shape, 128, radians(hue)), [&](int, int, QRgb texel) {
                if (qAlpha(texel) < 128)
                    return;
                const double own = radians(QColor(texel).hsvHueF() * 360.0);
                sine += std::sin(own);
                cosine += std::cos(own);
            });
            const double mean = degrees(std::atan2(sine, cosine));
            QVERIFY2(std::abs(std::remainder(mean - hue, 360.0)) < 8.0, qPrintable(QString::number(mean)));
        }
    }
}

void TexturesTest::leaf_isPalerWithLessSaturation()
{
    const QImage full = leafAlbedo(LeafShape::Ovate, 64);
    for (const double factor : {0.0, 0.4, 1.0}) {
        QImage paler = full;
        saturateLeaf(paler, factor);
        forEachTexel(full, [&](int x, int y, QRgb before) {
            const QColor from(before);
            const QColor to(paler.pixel(x, y));
            QVERIFY(std::abs(to.valueF() - from.valueF()) < 0.01F);
            QVERIFY(std::abs(to.hsvSaturationF() - static_cast<float>(factor) * from.hsvSaturationF()) <
                    0.02F);
            QCOMPARE(qAlpha(paler.pixel(x, y)), qAlpha(before));
        });
    }
}

void TexturesTest::leaf_colourGoesOnBeyondItsEdge()
{
    for (const LeafShape shape : kLeaves) {
        double inside = 0.0;
        int insideCount = 0;
        double outside = 0.0;
        int outsideCount = 0;
        int darkest = 255;
        forEachTexel(leafAlbedo(shape, 128), [&](int, int, QRgb texel) {
            const double green = qGreen(texel);
            if (qAlpha(texel) > 127) {
                inside += green;
                ++insideCount;
            } else {
                darkest = std::min(darkest, qGreen(texel));
                outside += green;
                ++outsideCount;
            }
        });
        QVERIFY(darkest > 40);
        QVERIFY(outside / outsideCount > 0.75 * inside / insideCount);
    }
}

namespace {

/// Mean and greatest difference between the roughness of a texture's parts, 0...1.
std::pair<double, double> roughnessOf(const QImage& roughness)
{
    double sum = 0.0;
    int least = 255;
    int greatest = 0;
    forEachTexel(roughness, [&](int, int, QRgb texel) {
        sum += qRed(texel) / 255.0;
        least = std::min(least, qRed(texel));
        greatest = std::max(greatest, qRed(texel));
    });
    return {sum / (roughness.width() * roughness.height()), (greatest - least) / 255.0};
}

} // namespace

void TexturesTest::roughness_differsWithinAndBetweenBarks()
{
    std::array<double, kBarks.size()> mean{};
    for (std::size_t i = 0; i < kBarks.size(); ++i) {
        const auto [middle, spread] = roughnessOf(barkTextures(kBarks[i], 128).roughness);
        mean[i] = middle;
        QVERIFY2(middle > 0.4 && middle < 0.97, qPrintable(QString::number(middle)));
        QVERIFY2(spread > 0.12, qPrintable(QString::number(spread)));
    }
    for (const std::size_t corky : {0U, 2U, 6U}) {
        QVERIFY(mean[corky] > mean[3] + 0.15); // oak, pine and redwood are rougher than birch,
        QVERIFY(mean[corky] > mean[4] + 0.15); // and cherry is the smoothest
    }
}

void TexturesTest::roughness_ofLeavesIsThatOfTheirWax()
{
    const auto mean = [](LeafShape shape) { return roughnessOf(leafTextures(shape, 128).roughness).first; };
    for (const LeafShape shape : kLeaves)
        QVERIFY(mean(shape) > 0.35 && mean(shape) < 0.8);
    QVERIFY(mean(LeafShape::Needles) < mean(LeafShape::Ovate));
    QVERIFY(mean(LeafShape::Willow) < mean(LeafShape::Cordate));
}

void TexturesTest::images_areTheSameOnOneThreadAndMany()
{
    const auto all = [](std::size_t threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        std::vector<QImage> images;
        for (const BarkKind kind : kBarks) {
            const SurfaceTextures textures = barkTextures(kind, 128);
            images.insert(images.end(), {textures.colour, textures.normal, textures.roughness});
        }
        for (const LeafShape shape : kLeaves) {
            const SurfaceTextures textures = leafTextures(shape, 128);
            images.insert(images.end(), {textures.colour, textures.normal, textures.roughness});
        }
        return images;
    };
    QVERIFY(all(1) == all(4));
}

const TestClass<TexturesTest> texturesTest;

} // namespace espalier::test

#include "TexturesTest.moc"
