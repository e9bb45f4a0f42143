// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/ImageFile.h"

#include "tests/support/OwnImages.h"
#include "tests/support/TestClasses.h"

#include <QTemporaryDir>
#include <QTest>

namespace espalier::test {

class ImageFileTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void image_isWhatItsBytesSay();
    void sameBytes_areTheSameImage();
    void refused_data();
    void refused();
    void jpeg_isWholeAtAnyPlaceButTheEnd();
    void imagesMadeToTakeLong_areRefused();
    void largestImage_isRead();
    void largeImage_isMadeSmallerForUse();
    void file_thatIsNone_isAnError();
};

namespace {

QByteArray jpegOf(const QImage& image)
{
    QByteArray file;
    QBuffer buffer(&file);
    image.save(&buffer, "jpg");
    return file;
}

QImage plain(int width, int height)
{
    QImage image(width, height, QImage::Format_RGB32);
    image.fill(QColor(90, 60, 30));
    return image;
}

/// A PNG whose header has another size.
QByteArray withSize(QByteArray png, quint32 width, quint32 height)
{
    for (int i = 0; i < 4; ++i) {
        png[16 + i] = static_cast<char>(width >> (24 - 8 * i));
        png[20 + i] = static_cast<char>(height >> (24 - 8 * i));
    }
    // The header's checksum, by its definition.
    quint32 crc = 0xffffffffU;
    for (int i = 12; i < 29; ++i) {
        crc ^= static_cast<uchar>(png[i]);
        for (int bit = 0; bit < 8; ++bit)
            crc = (crc & 1U) != 0 ? (crc >> 1U) ^ 0xedb88320U : crc >> 1U;
    }
    crc = ~crc;
    for (int i = 0; i < 4; ++i)
        png[29 + i] = static_cast<char>(crc >> (24 - 8 * i));
    return png;
}

} // namespace

void ImageFileTest::image_isWhatItsBytesSay()
{
    const QByteArray png = pngOf(drawnLeaf(Qt::transparent));
    const Result<ImageAsset> image = readImage(png, QStringLiteral("leaf.jpeg"));
    QVERIFY(image);
    QCOMPARE(image->suffix(), QStringLiteral("png"));
    QCOMPARE(image->name(), QStringLiteral("leaf.jpeg"));
    QCOMPARE(image->file(), png);
    QCOMPARE(image->pixels().size(), QSize(120, 200));
    QCOMPARE(image->pixels().format(), QImage::Format_RGBA8888);
    const Result<ImageAsset> photo = readImage(jpegOf(plain(20, 10)), QStringLiteral("bark"));
    QVERIFY(photo);
    QCOMPARE(photo->suffix(), QStringLiteral("jpg"));
    QCOMPARE(photo->pixels().format(), QImage::Format_RGB888);
    QCOMPARE(photo->hash().size(), 64);
}

void ImageFileTest::sameBytes_areTheSameImage()
{
    const QByteArray png = pngOf(plain(8, 8));
    const ImageAsset a(png, QStringLiteral("a.png"));
    QVERIFY(a == ImageAsset(png, QStringLiteral("b.png")));
    QVERIFY(!(a == ImageAsset(pngOf(plain(8, 9)), QStringLiteral("a.png"))));
    QVERIFY(!(a == ImageAsset()));
    QVERIFY(ImageAsset() == ImageAsset());
    // FIPS 180-2, the hash of "abc".
    QCOMPARE(ImageAsset("abc", {}).hash(),
             QStringLiteral("ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"));
}

void ImageFileTest::refused_data()
{
    QTest::addColumn<QByteArray>("file");
    QTest::addColumn<QString>("sentence");
    const QByteArray png = pngOf(plain(300, 300));
    QTest::newRow("empty") << QByteArray() << QStringLiteral("it is neither a PNG nor a JPEG image");
    QTest::newRow("text") << QByteArray("{}") << QStringLiteral("it is neither a PNG nor a JPEG image");
    QTest::newRow("bitmap") << QByteArray("BM6\0\0\0")
                            << QStringLiteral("it is neither a PNG nor a JPEG image");
    QTest::newRow("cut off") << png.first(png.size() / 2) << QStringLiteral("the file is not whole");
    QTest::newRow("only a head") << png.first(8) << QStringLiteral("the file is not whole");
    QTest::newRow("damaged") << (png.first(60) + QByteArray(40, 'x') + png.sliced(100))
                             << QStringLiteral("the image is broken");
    QTest::newRow("too wide") << withSize(png, 8193, 4)
                              << QStringLiteral("it has 8193 × 4 pixels; 8192 along an edge is the most");
    QTest::newRow("absurd") << withSize(png, 2'000'000'000, 2'000'000'000)
                            << QStringLiteral("the image is broken");
    QTest::newRow("too small") << pngOf(plain(3, 50))
                               << QStringLiteral("it is too small: only 3 × 50 pixels");
    QTest::newRow("too many bytes") << (png + QByteArray(64 << 20, '\0'))
                                    << QStringLiteral("it is larger than 64 MB");
}

void ImageFileTest::refused()
{
    QFETCH(const QByteArray, file);
    QFETCH(const QString, sentence);
    const Result<ImageAsset> image = readImage(file, QStringLiteral("leaf.png"));
    QVERIFY(!image);
    QCOMPARE(image.error().message, QStringLiteral("leaf.png: ") + sentence);
}

void ImageFileTest::jpeg_isWholeAtAnyPlaceButTheEnd()
{
    QByteArray photo;
    QBuffer buffer(&photo);
    repeatingBark(120, 90).save(&buffer, "jpg");
    QVERIFY(readImage(photo, QStringLiteral("bark.jpg")));
    for (qsizetype size = 3; size < photo.size(); size += 7) {
        const Result<ImageAsset> image = readImage(photo.first(size), QStringLiteral("bark.jpg"));
        QVERIFY2(!image, qPrintable(QString::number(size)));
    }
    // Cameras add something after the end.
    QVERIFY(readImage(photo + QByteArray(500, 'x'), QStringLiteral("bark.jpg")));
}

void ImageFileTest::imagesMadeToTakeLong_areRefused()
{
    QByteArray photo;
    QBuffer buffer(&photo);
    repeatingBark(120, 90).save(&buffer, "jpg");
    // The pass again and again.
    const qsizetype pass = photo.indexOf("\xff\xda");
    const qsizetype end = photo.lastIndexOf("\xff\xd9");
    QByteArray many = photo.first(end);
    for (int i = 0; i < 300; ++i)
        many += photo.sliced(pass, end - pass);
    many += photo.sliced(end);
    QElapsedTimer timer;
    timer.start();
    Result<ImageAsset> image = readImage(many, QStringLiteral("bark.jpg"));
    QVERIFY(!image);
    QVERIFY(image.error().message.contains(QStringLiteral("very long")));

    QImage picture = plain(40, 40);
    for (int i = 0; i < 100; ++i)
        picture.setText(QStringLiteral("note %1").arg(i), QString(100'000, QLatin1Char('a')));
    image = readImage(pngOf(picture), QStringLiteral("bark.png"));
    QVERIFY(!image);
    QVERIFY(image.error().message.contains(QStringLiteral("very long")));
    QVERIFY(timer.elapsed() < 1000);
}

void ImageFileTest::largestImage_isRead()
{
    // 256 MB of pixels.
    const QByteArray file =
        pngOf(QImage(plain(4, 4)).scaled(8192, 8192).convertToFormat(QImage::Format_RGBA8888));
    QVERIFY(readImage(file, QStringLiteral("bark.png")));
}

void ImageFileTest::largeImage_isMadeSmallerForUse()
{
    const QByteArray png = pngOf(plain(4000, 1000));
    const Result<ImageAsset> image = readImage(png, QStringLiteral("bark.png"));
    QVERIFY(image);
    QCOMPARE(image->pixels().size(), QSize(2048, 512));
    QCOMPARE(image->file(), png);
}

void ImageFileTest::file_thatIsNone_isAnError()
{
    const QTemporaryDir folder;
    QVERIFY(readImageFile(folder.filePath(QStringLiteral("leaf.png")))
                .error()
                .message.startsWith(QStringLiteral("leaf.png: ")));
    QVERIFY(!readImageFile(folder.path()));
    QVERIFY(!readImageFile(QStringLiteral("/dev/zero")));
    QFile file(folder.filePath(QStringLiteral("leaf.png")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(pngOf(plain(16, 16)));
    file.close();
    QCOMPARE(readImageFile(file.fileName())->name(), QStringLiteral("leaf.png"));
    QCOMPARE(readImageFile(file.fileName(), QStringLiteral("../leaf.png"))->name(),
             QStringLiteral("../leaf.png"));
}

const TestClass<ImageFileTest> imageFileTest;

} // namespace espalier::test

#include "ImageFileTest.moc"
