// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/texture/OwnTextures.h"

#include "model/texture/LeafCut.h"
#include "tests/support/OwnImages.h"
#include "tests/support/TestClasses.h"

#include <QTest>

#include <cmath>

namespace espalier::test {

class OwnTexturesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void leaf_withAlphaIsCutToWhatIsCovered();
    void leaf_onPlainPaperIsCutOut();
    void leaf_onAnythingElseIsNoLeaf();
    void leaf_keepsItsPetioleInTheMiddle();
    void leaf_colourGoesOnBeyondItsEdge();
    void bark_isSquareAndRepeatsAnImageThatIsNot();
    void bark_thatDoesNotRepeatLosesItsSeam();
    void bark_thatRepeatsStaysAsItIs();
    void bark_takesItsOwnNormalsAndRoughness();
    void brokenImage_showsTheDrawnLook();
    void hue_turnsAsInTheViewport();
};

namespace {

double coverage(const QImage& image)
{
    int covered = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x)
            covered += qAlpha(image.pixel(x, y)) > 127;
    }
    return covered / double(image.width() * image.height());
}

/// Mean difference of neighbours within an image, and of its first and last row.
std::pair<double, double> rowDifferences(const QImage& image)
{
    const auto between = [&](int a, int b) {
        double sum = 0.0;
        for (int x = 0; x < image.width(); ++x)
            sum += std::abs(qGray(image.pixel(x, a)) - qGray(image.pixel(x, b)));
        return sum / image.width();
    };
    double inside = 0.0;
    for (int y = 0; y + 1 < image.height(); ++y)
        inside += between(y, y + 1) / (image.height() - 1);
    return {inside, between(image.height() - 1, 0)};
}

} // namespace

void OwnTexturesTest::leaf_withAlphaIsCutToWhatIsCovered()
{
    const ImageAsset asset(pngOf(drawnLeaf(Qt::transparent)), QStringLiteral("leaf.png"));
    const std::optional<QImage> leaf = cutLeaf(asset, 1024);
    QVERIFY(leaf);
    // An ellipse of 80 × 160 pixels.
    QVERIFY2(std::abs(leaf->width() - 80) <= 3 && std::abs(leaf->height() - 160) <= 3,
             qPrintable(QStringLiteral("%1 × %2").arg(leaf->width()).arg(leaf->height())));
    QVERIFY(std::abs(coverage(*leaf) - std::numbers::pi / 4) < 0.02);
    QVERIFY(std::abs(*ownLeafAspect(asset) - 0.5) < 0.03);
    QVERIFY(cutLeaf(asset, 64)->height() <= 64);
    QCOMPARE(leaf->format(), QImage::Format_RGBA8888);
}

void OwnTexturesTest::leaf_onPlainPaperIsCutOut()
{
    for (const QColor paper : {QColor(Qt::white), QColor(Qt::black), QColor(40, 60, 160)}) {
        for (const char* format : {"png", "jpg"}) {
            QByteArray file;
            QBuffer buffer(&file);
            drawnLeaf(paper).convertToFormat(QImage::Format_RGB888).save(&buffer, format, 85);
            const std::optional<QImage> leaf = cutLeaf(ImageAsset(file, QStringLiteral("leaf")), 1024);
            QVERIFY(leaf);
            QVERIFY(std::abs(leaf->width() - 80) <= 4 && std::abs(leaf->height() - 160) <= 4);
            QVERIFY2(std::abs(coverage(*leaf) - std::numbers::pi / 4) < 0.04,
                     qPrintable(QString::number(coverage(*leaf))));
            // Nothing of the paper is left, not even at the edge.
            for (int y = 0; y < leaf->height(); ++y) {
                for (int x = 0; x < leaf->width(); ++x) {
                    const QColor colour = leaf->pixelColor(x, y);
                    QVERIFY2(colour.green() > colour.red() + 20 && colour.green() > colour.blue() + 20,
                             qPrintable(QStringLiteral("%1 on %2 at %3, %4, %5")
                                            .arg(colour.name(), paper.name())
                                            .arg(x)
                                            .arg(y)
                                            .arg(QLatin1String(format))));
                }
            }
        }
    }
}

void OwnTexturesTest::leaf_onAnythingElseIsNoLeaf()
{
    QImage patterned = drawnLeaf(Qt::white);
    for (int y = 0; y < patterned.height(); ++y) {
        for (int x = 0; x < patterned.width(); ++x) {
            if ((x / 8 + y / 8) % 2 == 0)
                patterned.setPixelColor(x, y, QColor(90, 60, 30));
        }
    }
    QImage empty(64, 64, QImage::Format_RGB32);
    empty.fill(Qt::white);
    QImage nothing(64, 64, QImage::Format_ARGB32);
    nothing.fill(Qt::transparent);
    for (const QImage& image : {patterned, empty, nothing}) {
        const ImageAsset asset(pngOf(image), QStringLiteral("photo.png"));
        QVERIFY(!cutLeaf(asset, 256));
        QVERIFY(!ownLeafAspect(asset));
        QVERIFY(noLeafIn(asset).startsWith(QStringLiteral("photo.png: ")));
    }
}

void OwnTexturesTest::leaf_keepsItsPetioleInTheMiddle()
{
    QImage image = drawnLeaf(Qt::transparent);
    QPainter painter(&image);
    painter.fillRect(QRect(70, 170, 6, 25), QColor(80, 60, 20)); // ten pixels right of the ellipse's middle
    painter.end();
    const std::optional<QImage> leaf = cutLeaf(ImageAsset(pngOf(image), QStringLiteral("leaf.png")), 1024);
    QVERIFY(leaf);
    const int bottom = leaf->height() - 2;
    int first = leaf->width();
    int last = 0;
    for (int x = 0; x < leaf->width(); ++x) {
        if (qAlpha(leaf->pixel(x, bottom)) > 127) {
            first = std::min(first, x);
            last = x;
        }
    }
    QVERIFY(std::abs((first + last) / 2 - leaf->width() / 2) <= 1);
}

void OwnTexturesTest::leaf_colourGoesOnBeyondItsEdge()
{
    const std::optional<QImage> leaf =
        cutLeaf(ImageAsset(pngOf(drawnLeaf(Qt::transparent)), QStringLiteral("leaf.png")), 1024);
    QVERIFY(leaf);
    QCOMPARE(qAlpha(leaf->pixel(0, 0)), 0);
    for (const QPoint corner : {QPoint(0, 0), QPoint(leaf->width() - 1, leaf->height() - 1)})
        QVERIFY(qGreen(leaf->pixel(corner)) > 100);
}

void OwnTexturesTest::bark_isSquareAndRepeatsAnImageThatIsNot()
{
    BarkParameters bark;
    bark.image = ImageAsset(pngOf(repeatingBark(64, 192)), QStringLiteral("bark.png"));
    const SurfaceTextures textures = barkTextures(bark, 1024);
    QCOMPARE(textures.colour.width(), textures.colour.height());
    QCOMPARE(textures.normal.size(), textures.colour.size());
    QCOMPARE(textures.roughness.size(), textures.colour.size());
    // Three times side by side.
    const int third = textures.colour.width() / 3;
    for (int x = 0; x < third; ++x)
        QCOMPARE(textures.colour.pixel(x, 11), textures.colour.pixel(x + third, 11));
    QVERIFY(!textures.colour.hasAlphaChannel());
    QCOMPARE(textures.normal.format(), QImage::Format_RGB888);
    QCOMPARE(textures.roughness.format(), QImage::Format_Grayscale8);
    QCOMPARE(barkTextures(bark, 64).colour.width(), 64 / 3 * 3);
}

void OwnTexturesTest::bark_thatDoesNotRepeatLosesItsSeam()
{
    QImage image = repeatingBark(128, 128);
    // Light above, dark below.
    for (int y = 0; y < 128; ++y) {
        for (int x = 0; x < 128; ++x)
            image.setPixelColor(x, y, image.pixelColor(x, y).darker(100 + y));
    }
    const auto [insideBefore, seamBefore] = rowDifferences(image);
    QVERIFY(seamBefore > 3.0 * insideBefore);
    BarkParameters bark;
    bark.image = ImageAsset(pngOf(image), QStringLiteral("bark.png"));
    const auto [inside, seam] = rowDifferences(barkTextures(bark, 128).colour);
    QVERIFY2(seam < 2.0 * inside, qPrintable(QStringLiteral("%1 %2").arg(seam).arg(inside)));
}

void OwnTexturesTest::bark_thatRepeatsStaysAsItIs()
{
    const QImage image = repeatingBark(128, 128).convertToFormat(QImage::Format_RGB888);
    BarkParameters bark;
    bark.image = ImageAsset(pngOf(image), QStringLiteral("bark.png"));
    QCOMPARE(barkTextures(bark, 512).colour, image);
}

void OwnTexturesTest::bark_takesItsOwnNormalsAndRoughness()
{
    BarkParameters bark;
    bark.image = ImageAsset(pngOf(repeatingBark(128, 128)), QStringLiteral("bark.png"));
    const SurfaceTextures derived = barkTextures(bark, 128);
    // Normals and roughness derived from brightness are neither flat nor uniform.
    QVERIFY(derived.normal.pixel(3, 3) != derived.normal.pixel(20, 70));
    QVERIFY(derived.roughness.pixel(3, 3) != derived.roughness.pixel(20, 70));
    QImage normal(64, 64, QImage::Format_RGB888);
    normal.fill(QColor(100, 150, 240));
    QImage roughness(32, 32, QImage::Format_RGB888);
    roughness.fill(QColor(77, 77, 77));
    bark.normalImage = ImageAsset(pngOf(normal), QStringLiteral("normal.png"));
    bark.roughnessImage = ImageAsset(pngOf(roughness), QStringLiteral("roughness.png"));
    const SurfaceTextures textures = barkTextures(bark, 128);
    QCOMPARE(textures.colour, derived.colour);
    QCOMPARE(textures.normal.pixelColor(50, 90), QColor(100, 150, 240));
    QCOMPARE(qRed(textures.roughness.pixel(50, 90)), 77);
    QCOMPARE(textures.normal.size(), textures.colour.size());
    QCOMPARE(textures.roughness.size(), textures.colour.size());
}

void OwnTexturesTest::brokenImage_showsTheDrawnLook()
{
    TreeParameters parameters;
    parameters.leaves.image = parameters.bark.image = ImageAsset("no image", QStringLiteral("broken.png"));
    QCOMPARE(barkTextures(parameters.bark, 64).colour, barkAlbedo(BarkKind::Furrowed, 64));
    QCOMPARE(leafTextures(parameters.leaves, 64).colour, leafAlbedo(LeafShape::Ovate, 64));
}

void OwnTexturesTest::hue_turnsAsInTheViewport()
{
    for (const double factor : hueFactors(0.0))
        QVERIFY(std::abs(factor - 1.0) < 0.03);
    const std::array<double, 3> red = hueFactors(radians(-60.0));
    QVERIFY(red[0] > 2.0 && red[1] < 0.8);
    const std::array<double, 3> blue = hueFactors(radians(60.0));
    QVERIFY(blue[2] > 1.5 && blue[0] < 0.6);
}

const TestClass<OwnTexturesTest> ownTexturesTest;

} // namespace espalier::test

#include "OwnTexturesTest.moc"
