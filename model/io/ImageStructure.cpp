// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/ImageStructure.h"

#include "model/tree/ImageAsset.h"

#include <QCoreApplication>
#include <QtEndian>

#include <algorithm>
#include <cstdint>

namespace espalier {

namespace {

struct StructureText {
    Q_DECLARE_TR_FUNCTIONS(ImageStructure)
};

/// Packed texts and colour profiles of a PNG file; each may unpack to megabytes.
constexpr int kMostPackedTexts = 16;
/// Pixels that the passes of a JPEG file go over, in all: twenty passes over 8192 × 8192.
constexpr qint64 kMostPassPixels = qint64{20} * 8192 * 8192;
constexpr int kMostPasses = 200;

QString notWhole()
{
    return StructureText::tr("the file is not whole");
}

QString tooLong()
{
    return StructureText::tr("it is made so that unpacking it would take very long");
}

QString pngFault(const QByteArray& file)
{
    constexpr qsizetype kSignature = 8;
    constexpr qsizetype kAround = 12; // length, type and checksum of a chunk
    int packedTexts = 0;
    qsizetype at = kSignature;
    while (file.size() - at >= kAround) {
        const auto length = static_cast<qsizetype>(qFromBigEndian<quint32>(file.constData() + at));
        const QByteArrayView type = QByteArrayView(file).sliced(at + 4, 4);
        if (length > file.size() - at - kAround)
            return notWhole();
        if (type == "IEND")
            return {};
        // An iTXt chunk says after its keyword whether it is packed.
        const QByteArrayView content = QByteArrayView(file).sliced(at + 8, length);
        const qsizetype keyword = content.indexOf('\0');
        const bool isPackedText =
            type == "iTXt" && keyword >= 0 && keyword + 1 < length && content[keyword + 1] != 0;
        if (type == "zTXt" || type == "iCCP" || isPackedText)
            ++packedTexts;
        if (packedTexts > kMostPackedTexts)
            return tooLong();
        at += kAround + length;
    }
    return notWhole();
}

QString jpegFault(const QByteArray& file)
{
    const auto byte = [&file](qsizetype at) { return static_cast<std::uint8_t>(file[at]); };
    const auto isRestart = [](std::uint8_t marker) { return marker >= 0xd0 && marker <= 0xd7; };
    // Markers of a frame, which has the size, are 0xc0...0xcf but for three.
    const auto isFrame = [](std::uint8_t marker) {
        return marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
    };
    qint64 pixels = 0;
    int passes = 0;
    qsizetype at = 2;
    while (file.size() - at >= 2) {
        if (byte(at) != 0xff) { // pixels of a pass
            const qsizetype next = file.indexOf('\xff', at);
            if (next < 0)
                return notWhole();
            at = next;
            continue;
        }
        const std::uint8_t marker = byte(at + 1);
        if (marker == 0xd9) // the end
            return {};
        if (marker == 0xff) { // filling
            ++at;
            continue;
        }
        at += 2;
        if (marker == 0x00 || marker == 0x01 || isRestart(marker))
            continue;
        if (file.size() - at < 2)
            return notWhole();
        const auto length = static_cast<qsizetype>(qFromBigEndian<quint16>(file.constData() + at));
        if (length < 2 || length > file.size() - at)
            return notWhole();
        if (isFrame(marker) && length >= 8) {
            const auto height = qFromBigEndian<quint16>(file.constData() + at + 3);
            const auto width = qFromBigEndian<quint16>(file.constData() + at + 5);
            pixels = std::max(pixels, qint64{width} * height);
        }
        at += length;
        if (marker == 0xda && (++passes > kMostPasses || passes * pixels > kMostPassPixels))
            return tooLong();
    }
    return notWhole();
}

} // namespace

QString imageStructureFault(const QByteArray& file)
{
    return imageFormat(file) == "png" ? pngFault(file) : jpegFault(file);
}

} // namespace espalier
