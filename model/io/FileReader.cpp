// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/FileReader.h"

#include "model/io/JsonReader.h"

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>

#include <algorithm>

namespace espalier {

namespace {

struct ReaderText {
    Q_DECLARE_TR_FUNCTIONS(FileReader)
};

bool isPipedIn(const QString& fileName)
{
    return fileName == QLatin1String("/dev/stdin") || fileName.startsWith(QLatin1String("/dev/fd/")) ||
           fileName.startsWith(QLatin1String("/proc/self/fd/"));
}

QString largerThan(qint64 bytes)
{
    constexpr qint64 kMegabyte = 1 << 20;
    return bytes < kMegabyte ? ReaderText::tr("it is larger than %1 bytes").arg(bytes)
                             : ReaderText::tr("it is larger than %1 MB").arg(bytes / kMegabyte);
}

} // namespace

Result<QByteArray> readFile(const QString& fileName, qint64 most, FileKind kind)
{
    const QFileInfo info(fileName);
    const QString name = info.fileName();
    if (!info.exists() && !info.isSymLink())
        return inputError(name, ReaderText::tr("there is no such file"));
    if (info.isDir())
        return inputError(name, ReaderText::tr("it is a folder"));
    if (info.exists() && !info.isFile() && (kind == FileKind::Regular || !isPipedIn(fileName)))
        return inputError(name, ReaderText::tr("it is a device or a pipe, not a file"));
    QFile file(fileName);
    if (!file.open(QIODevice::ReadOnly))
        return inputError(name, file.errorString());
    if (file.size() > most)
        return inputError(name, largerThan(most));
    // A file can grow while it is read, and a pipe has no size. A read of more than there is would allocate
    // it.
    constexpr qint64 kBlock = 1 << 20;
    QByteArray bytes = file.read(file.size() + 1);
    while (bytes.size() <= most && file.error() == QFileDevice::NoError) {
        const QByteArray more = file.read(std::min(kBlock, most + 1 - bytes.size()));
        if (more.isEmpty())
            break;
        bytes += more;
    }
    if (file.error() != QFileDevice::NoError)
        return inputError(name, ReaderText::tr("it cannot be read: %1").arg(file.errorString()));
    if (bytes.size() > most)
        return inputError(name, largerThan(most));
    return bytes;
}

} // namespace espalier
