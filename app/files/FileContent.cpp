// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/FileContent.h"

#include <QCryptographicHash>
#include <QFile>
#include <QFileInfo>
#include <QStringList>

namespace espalier {

namespace {

constexpr auto kAlgorithm = QCryptographicHash::Sha256;
const QString kMark = QStringLiteral("sha256");

} // namespace

FileStamp FileStamp::of(const QString& fileName)
{
    const QFileInfo file(fileName);
    return file.isFile() ? FileStamp{file.size(), file.lastModified()} : FileStamp();
}

FileContent FileContent::of(const QString& fileName)
{
    QFile file(fileName);
    QCryptographicHash hash(kAlgorithm);
    if (!QFileInfo(fileName).isFile() || !file.open(QIODevice::ReadOnly) || !hash.addData(&file))
        return {};
    return {file.pos(), hash.result()};
}

FileContent FileContent::of(const QByteArray& bytes)
{
    return {bytes.size(), QCryptographicHash::hash(bytes, kAlgorithm)};
}

QString FileContent::toLine() const
{
    return QStringLiteral("%1 %2 %3").arg(kMark).arg(size).arg(QString::fromLatin1(hash.toHex()));
}

FileContent FileContent::fromLine(const QString& line)
{
    const QStringList parts = line.split(QLatin1Char(' '));
    if (parts.size() != 3 || parts[0] != kMark)
        return {};
    bool isNumber = false;
    const qint64 size = parts[1].toLongLong(&isNumber);
    const QByteArray hash = QByteArray::fromHex(parts[2].toLatin1());
    if (!isNumber || size < 0 || hash.size() != QCryptographicHash::hashLength(kAlgorithm))
        return {};
    return {size, hash};
}

} // namespace espalier
