// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/export/FileMark.h"

#include <QCryptographicHash>
#include <QtEndian>

#include <zlib.h>

namespace espalier {

namespace {

constexpr char kPngSignature[] = "\x89PNG\r\n\x1a\n";
/// Start of a PNG: the signature, and the header's chunk with its length, type and checksum.
constexpr qsizetype kPngHeader = 8 + 12 + 13;

QByteArray bigEndian(std::uint32_t number)
{
    QByteArray bytes(4, '\0');
    qToBigEndian(number, bytes.data());
    return bytes;
}

bool isPng(const QByteArray& content)
{
    return content.size() >= kPngHeader && content.startsWith(kPngSignature);
}

qsizetype placeOfMark(const QByteArray& content)
{
    return isPng(content) ? kPngHeader : 0;
}

/// The mark's size depends only on whether the content is a PNG.
QByteArray markOf(const QByteArray& content, const QString& owner)
{
    QCryptographicHash hash(QCryptographicHash::Sha256);
    hash.addData(owner.toUtf8());
    hash.addData(QByteArray(1, '\0'));
    hash.addData(content);
    const QByteArray digest = hash.result().toHex();
    if (!isPng(content))
        return "# Espalier " + digest + '\n';
    const QByteArray chunk = "tEXtEspalier" + QByteArray(1, '\0') + digest;
    const auto checksum =
        crc32(0, reinterpret_cast<const Bytef*>(chunk.constData()), static_cast<uInt>(chunk.size()));
    return bigEndian(static_cast<std::uint32_t>(chunk.size() - 4)) + chunk +
           bigEndian(static_cast<std::uint32_t>(checksum));
}

} // namespace

QByteArray marked(const QByteArray& content, const QString& owner)
{
    QByteArray result = content;
    return result.insert(placeOfMark(content), markOf(content, owner));
}

bool isMarked(const QByteArray& content, const QString& owner)
{
    const qsizetype place = placeOfMark(content);
    const qsizetype size = markOf(content, owner).size();
    if (content.size() < place + size)
        return false;
    QByteArray original = content;
    original.remove(place, size);
    return isPng(original) == isPng(content) &&
           QByteArrayView(content).sliced(place, size) == markOf(original, owner);
}

} // namespace espalier
