// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Error.h"

#include <QByteArray>
#include <QString>

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

struct zip;
struct zip_source;

namespace espalier {

/// Makes a ZIP archive in memory. The same entries give the same bytes: no time, owner or machine is written.
class ZipWriter {
public:
    enum class Packing { Fast, Store };

    void add(QByteArray name, QByteArray content, Packing packing = Packing::Fast);
    Result<QByteArray> finish();

private:
    struct Entry {
        QByteArray name;
        QByteArray content;
        Packing packing;
    };
    std::vector<Entry> m_entries;
};

/// Reads the entries of a ZIP archive without trusting it: an archive whose entries together claim to be many
/// times as large as the archive is refused, and before an entry is unpacked, its declared size is compared
/// with the expected size and with what its packed bytes can hold at most.
class ZipReader {
public:
    /// @p content must stay as it is while the reader lives.
    static Result<ZipReader> open(const QByteArray& content);
    /// Reads only the requested entries of the file.
    static Result<ZipReader> openFile(const QString& fileName);

    bool contains(const char* name) const;
    /// Of all entries, in the order of the archive; a damaged archive can have the same one twice.
    std::vector<QByteArray> names() const;
    /// Unpacks an entry of at most @p maximumBytes.
    Result<QByteArray> read(const char* name, std::uint64_t maximumBytes) const;
    /// Unpacks an entry into @p target, which it must fill exactly.
    Result<void> readExactly(const char* name, std::span<std::byte> target) const;
    /// Fails unless the entry exists and has @p bytes: call it before allocating them.
    Result<void> expectSize(const char* name, std::uint64_t bytes) const;

private:
    struct Close {
        void operator()(zip* archive) const;
    };

    explicit ZipReader(zip* archive) : m_archive(archive) {}
    static Result<ZipReader> openSource(zip_source* source);
    Result<std::uint64_t> sizeOf(const char* name) const;

    std::unique_ptr<zip, Close> m_archive;
};

} // namespace espalier
