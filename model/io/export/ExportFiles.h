// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/io/FileWriter.h"

#include <QByteArray>
#include <QDir>
#include <QFileInfo>
#include <QStringList>

#include <concepts>
#include <memory>
#include <utility>
#include <vector>

namespace espalier {

/// The files of one export: the main file, which the user named, and companions beside it (textures,
/// materials), whose names are chosen here. All appear together on commit(); without it nothing on the disk
/// changes.
///
/// The main file is replaced. A companion replaces a file only if that file is exactly what an earlier export
/// to the same main file wrote (see FileMark.h). Where another file has the name, all companions get another
/// stem: oak_bark.png, oak_2_bark.png, oak_3_bark.png.
class ExportFiles {
public:
    /// @p others: files that are going to be written, too; their names are not free.
    explicit ExportFiles(const QString& mainFile, const QStringList& others = {});
    ExportFiles(ExportFiles&&) = default;

    /// Chooses the stem of the companions so that none of the names stem + ending belongs to another file;
    /// to be called once, with all endings ("_bark.png", ".mtl"), before name(). Names that differ only in
    /// the case of letters count as equal, since they are on some disks.
    Result<void> chooseNames(const QStringList& endings);
    /// File name of a companion. It has no spaces, since some readers of OBJ files do not accept them.
    QString name(const QString& ending) const { return m_stem + ending; }

    /// Adds a companion with the mark of the main file: PNG, or a text whose comments begin with #.
    Result<void> addCompanion(const QString& ending, const QByteArray& content);
    /// Adds the main file. @p write gets a QIODevice& and returns whether the file is whole: false if the
    /// device did not take everything, or if the format cannot hold so much.
    template <std::invocable<QIODevice&> Write>
    Result<void> addMain(Write&& write)
    {
        return add(m_main.fileName(), std::forward<Write>(write));
    }
    Result<void> addMain(const QByteArray& content);

    /// Name of the main file, without its folder.
    QString mainName() const { return m_main.fileName(); }

    /// That the format cannot hold so much.
    Error tooLarge() const;

    /// Fails if another program has taken one of the names since they were chosen.
    Result<void> checkNames() const;
    /// The files for FileWriter::commitAll(), the companions before the main file, which refers to them.
    std::vector<FileWriter*> writers() const;
    /// Checks the names and puts all files in their places.
    Result<void> commit();

private:
    struct Entry {
        std::unique_ptr<FileWriter> file;
        bool isCompanion = false;
    };

    template <class Write>
    Result<void> add(const QString& name, Write&& write)
    {
        auto file = std::make_unique<FileWriter>(m_main.dir().filePath(name));
        const bool isWhole = write(static_cast<QIODevice&>(*file));
        if (Result<void> written = file->finish(); !written)
            return written;
        if (!isWhole)
            return tooLarge();
        m_entries.push_back({std::move(file), name != m_main.fileName()});
        return {};
    }
    /// Whether a companion of this name replaces no file of the user. @p existing are the names in the
    /// folder.
    bool isFree(const QString& name, const QStringList& existing) const;
    QStringList namesInFolder() const;

    QFileInfo m_main;
    QString m_stem;
    QStringList m_others; ///< Absolute paths
    std::vector<Entry> m_entries;
};

} // namespace espalier
