// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/SafetyCopy.h"

#include "model/io/FileWriter.h"
#include "model/io/JsonReader.h"
#include "model/io/project/HistoryChange.h"
#include "model/io/project/ProjectFile.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QtEndian>

#include <zlib.h>

#include <array>
#include <cstring>
#include <limits>
#include <span>

namespace espalier {

namespace {

struct CopyText {
    Q_DECLARE_TR_FUNCTIONS(SafetyCopy)
};

constexpr std::array<char, 4> kPieceMark{'E', 'S', 'C', '1'};
constexpr qsizetype kHeader = 12; // bytes: mark, length, checksum

std::uint32_t checksum(const QByteArray& bytes)
{
    return static_cast<std::uint32_t>(
        ::crc32_z(0, reinterpret_cast<const Bytef*>(bytes.constData()), static_cast<z_size_t>(bytes.size())));
}

QByteArray framed(const QByteArray& piece)
{
    QByteArray bytes(kHeader, Qt::Uninitialized);
    std::memcpy(bytes.data(), kPieceMark.data(), kPieceMark.size());
    qToLittleEndian(static_cast<quint32>(piece.size()), bytes.data() + 4);
    qToLittleEndian(static_cast<quint32>(checksum(piece)), bytes.data() + 8);
    return bytes + piece;
}

struct Pieces {
    std::vector<QByteArray> whole{}; ///< Up to the first that is not
    bool isTorn = false;             ///< More bytes follow
};

Pieces piecesOf(const QByteArray& bytes)
{
    std::vector<QByteArray> pieces;
    qsizetype at = 0;
    while (bytes.size() - at >= kHeader &&
           std::memcmp(bytes.constData() + at, kPieceMark.data(), kPieceMark.size()) == 0) {
        const auto size = static_cast<qsizetype>(qFromLittleEndian<quint32>(bytes.constData() + at + 4));
        if (size > bytes.size() - at - kHeader)
            break;
        QByteArray piece = bytes.sliced(at + kHeader, size);
        if (checksum(piece) != qFromLittleEndian<quint32>(bytes.constData() + at + 8))
            break;
        pieces.push_back(std::move(piece));
        at += kHeader + size;
    }
    return {std::move(pieces), at < bytes.size()};
}

QByteArray hashOf(const QByteArray& bytes)
{
    return QCryptographicHash::hash(bytes, QCryptographicHash::Sha256);
}

Result<Project> replayed(const QByteArray& projectBytes, std::span<const QByteArray> changes)
{
    Result<Project> project = unpackProject(projectBytes);
    if (!project)
        return project;
    HistoryReplay replay(std::move(*project));
    for (const QByteArray& change : changes) {
        if (const Result<void> done = replay.add(change); !done)
            return done.error();
    }
    return replay.finish();
}

QByteArray bytesOf(const QString& fileName)
{
    QFile file(fileName);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace

SafetyCopy SafetyCopy::ofProject(const QString& fileName)
{
    return SafetyCopy(fileName.chopped(static_cast<qsizetype>(std::strlen(kSuffix))));
}

Result<void> SafetyCopy::writeOrigin(const Origin& origin) const
{
    QString text = origin.fileName;
    if (origin.content.exists())
        text += QLatin1Char('\n') + origin.content.toLine();
    return writeFile(originFile(), text.toUtf8());
}

SafetyCopy::Origin SafetyCopy::readOrigin() const
{
    constexpr qint64 kMost = 8192; // bytes
    QFile file(originFile());
    if (!file.open(QIODevice::ReadOnly))
        return {};
    const QString text = QString::fromUtf8(file.read(kMost));
    const qsizetype end = text.lastIndexOf(QLatin1Char('\n'));
    const FileContent content = FileContent::fromLine(text.mid(end + 1));
    const Origin origin = content.exists() && end >= 0 ? Origin{text.left(end), content} : Origin{text, {}};
    const bool isName = QDir::isAbsolutePath(origin.fileName) &&
                        !origin.fileName.contains(QChar::ReplacementCharacter) &&
                        !origin.fileName.contains(QChar::Null);
    return isName ? origin : Origin{};
}

Result<SafetyCopy::Written> SafetyCopy::writeBytes(const QByteArray& bytes, QSet<QString> images) const
{
    // Changes of the project before have its hash, so they count for nothing from now on.
    if (const Result<void> done = writeFile(projectFile(), bytes); !done)
        return done.error();
    QFile::remove(changesFile());
    return Written{hashOf(bytes), std::move(images), bytes.size(), 0};
}

Result<SafetyCopy::Written> SafetyCopy::writeProject(const Project& project) const
{
    const Result<QByteArray> bytes = packProject(project);
    if (!bytes)
        return bytes.error();
    return writeBytes(*bytes, imageHashes(project));
}

Result<SafetyCopy::Written> SafetyCopy::copyProject(const QString& fileName, const FileContent& content) const
{
    const QByteArray bytes = QFileInfo(fileName).isFile() ? bytesOf(fileName) : QByteArray();
    if (FileContent::of(bytes) != content)
        return inputError(QFileInfo(fileName).fileName(), CopyText::tr("another program has changed it"));
    return writeBytes(bytes, {});
}

Result<SafetyCopy::Written> SafetyCopy::takeOver(const SafetyCopy& other, std::size_t deltas) const
{
    const Result<Project> project = other.read();
    if (!project)
        return project.error();
    if (project->journal.size() != deltas)
        return inputError(QFileInfo(other.projectFile()).fileName(), CopyText::tr("it is not up to date"));
    return writeProject(*project);
}

Result<void> SafetyCopy::addChange(const QByteArray& packed, Written& written) const
{
    if (packed.size() > std::numeric_limits<qint32>::max())
        return Error{Error::Kind::Output, CopyText::tr("a change of the tree is too large")};
    QByteArray bytes;
    if (written.changeBytes == 0)
        bytes = framed(written.projectHash);
    bytes += framed(packed);
    if (written.changeBytes == 0)
        QFile::remove(changesFile());
    const Result<void> done = appendToFile(changesFile(), bytes, written.changeBytes);
    if (done)
        written.changeBytes += bytes.size();
    return done;
}

std::vector<QByteArray> SafetyCopy::readChanges(const QByteArray& projectHash) const
{
    std::vector<QByteArray> pieces = piecesOf(bytesOf(changesFile())).whole;
    if (pieces.empty() || pieces.front() != projectHash)
        return {};
    pieces.erase(pieces.begin());
    return pieces;
}

Result<Project> SafetyCopy::read() const
{
    const QString name = QFileInfo(projectFile()).fileName();
    QFile file(projectFile());
    if (!file.open(QIODevice::ReadOnly))
        return inputError(name, file.errorString());
    const QByteArray bytes = file.readAll();
    Result<Project> project = unpackProject(bytes);
    if (!project)
        return inputError(name, project.error().message);
    const std::vector<QByteArray> changes = readChanges(hashOf(bytes));
    const auto warn = [&name](Project& incomplete) {
        incomplete.warning =
            inputError(name, CopyText::tr("what was done last cannot be brought back")).message;
    };
    if (isTorn())
        warn(*project);
    if (changes.empty())
        return project;
    // If what comes last cannot be used, what is before it can, probably.
    Result<Project> whole = Error{Error::Kind::Input, QString()};
    for (std::size_t count = changes.size(); count > 0; count /= 2) {
        whole = replayed(bytes, std::span(changes).first(count));
        if (whole && (count < changes.size() || isTorn()))
            warn(*whole);
        if (whole)
            return whole;
    }
    warn(*project);
    return project;
}

bool SafetyCopy::hasChanges() const
{
    const QByteArray bytes = bytesOf(projectFile());
    return !readChanges(hashOf(bytes)).empty() || FileContent::of(bytes) != readOrigin().content;
}

bool SafetyCopy::isTorn() const
{
    return piecesOf(bytesOf(changesFile())).isTorn;
}

void SafetyCopy::remove() const
{
    for (const QString& file : {projectFile(), changesFile(), originFile()})
        QFile::remove(file);
}

} // namespace espalier
