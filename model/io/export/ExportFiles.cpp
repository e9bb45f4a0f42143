// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/export/ExportFiles.h"

#include "model/io/JsonReader.h"
#include "model/io/export/ExportScene.h"
#include "model/io/export/ExportText.h"
#include "model/io/export/FileMark.h"

#include <algorithm>

namespace espalier {

namespace {

/// Stems that are tried before an export gives up.
constexpr int kMostStems = 10'000;
/// Bytes in UTF-8 of a stem, so that the name with its number and ending stays within a file system's 255.
constexpr qsizetype kStemBytes = 200;

QString shortened(QString stem)
{
    while (stem.toUtf8().size() > kStemBytes)
        stem.chop(stem.back().isLowSurrogate() ? 2 : 1);
    return stem;
}

} // namespace

ExportFiles::ExportFiles(const QString& mainFile, const QStringList& others)
    : m_main(mainFile), m_stem(shortened(safeExportName(m_main.completeBaseName())))
{
    for (const QString& other : others)
        m_others.append(QFileInfo(other).absoluteFilePath());
}

Result<void> ExportFiles::chooseNames(const QStringList& endings)
{
    const QStringList existing = namesInFolder();
    const QString first = m_stem;
    for (int number = 2; number <= kMostStems; ++number) {
        if (std::ranges::all_of(endings, [&](const QString& e) { return isFree(name(e), existing); }))
            return {};
        m_stem = QStringLiteral("%1_%2").arg(first).arg(number);
    }
    return Error{Error::Kind::Output,
                 inputError(mainName(), ExportText::tr("there are too many files with similar names in this "
                                                       "folder; choose another name or another folder"))
                     .message};
}

bool ExportFiles::isFree(const QString& name, const QStringList& existing) const
{
    const auto isSame = [&](const QString& other) { return other.compare(name, Qt::CaseInsensitive) == 0; };
    if (name.compare(mainName(), Qt::CaseInsensitive) == 0 ||
        m_others.contains(QFileInfo(m_main.dir().filePath(name)).absoluteFilePath(), Qt::CaseInsensitive))
        return false;
    for (const QString& other : existing) {
        if (!isSame(other))
            continue;
        // Folders, devices and unreadable files cannot be files of an earlier export.
        const QFileInfo info(m_main.dir().filePath(other));
        QFile file(info.filePath());
        if (other != name || !info.isFile() || !file.open(QIODevice::ReadOnly) ||
            !isMarked(file.readAll(), mainName()))
            return false;
    }
    return true;
}

QStringList ExportFiles::namesInFolder() const
{
    return m_main.dir().entryList(QDir::AllEntries | QDir::Hidden | QDir::System | QDir::NoDotAndDotDot,
                                  QDir::Unsorted);
}

Result<void> ExportFiles::addCompanion(const QString& ending, const QByteArray& content)
{
    const QByteArray bytes = marked(content, mainName());
    return add(name(ending), [&](QIODevice& file) { return file.write(bytes) == bytes.size(); });
}

Result<void> ExportFiles::addMain(const QByteArray& content)
{
    return addMain([&](QIODevice& file) { return file.write(content) == content.size(); });
}

Error ExportFiles::tooLarge() const
{
    const QString what = QCoreApplication::translate(
        "Exporter", "the tree takes more than such a file can hold; export less detail");
    return {Error::Kind::Output, inputError(mainName(), what).message};
}

Result<void> ExportFiles::checkNames() const
{
    const QStringList existing = namesInFolder();
    for (const Entry& entry : m_entries) {
        const QString name = QFileInfo(entry.file->fileName()).fileName();
        if (entry.isCompanion && !isFree(name, existing)) {
            return Error{
                Error::Kind::Output,
                inputError(name, ExportText::tr("another program made this file during the export; export "
                                                "again, and another name will be chosen"))
                    .message};
        }
    }
    return {};
}

std::vector<FileWriter*> ExportFiles::writers() const
{
    std::vector<FileWriter*> files;
    for (const bool isCompanion : {true, false}) {
        for (const Entry& entry : m_entries) {
            if (entry.isCompanion == isCompanion)
                files.push_back(entry.file.get());
        }
    }
    return files;
}

Result<void> ExportFiles::commit()
{
    const Result<void> checked = checkNames();
    return checked ? FileWriter::commitAll(writers()) : checked;
}

} // namespace espalier
