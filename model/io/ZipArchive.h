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

/// Reads the entries of a ZIP archive without trusting it: nothing is unpacked before the size that the
/// archive declares has been compared with what is wanted and with what its packed bytes can hold at all.
class ZipReader {
public:
    /// @p content must stay as it is while the reader lives.
    static Result<ZipReader> open(const QByteArray& content);
    /// Reads no more of the file than is asked for.
    static Result<ZipReader> openFile(const QString& fileName);

    bool contains(const char* name) const;
    /// An entry of at most @p maximumBytes.
    Result<QByteArray> read(const char* name, std::uint64_t maximumBytes) const;
    /// An entry that is to fill @p target exactly.
    Result<void> readExactly(const char* name, std::span<std::byte> target) const;
    /// Whether an entry is there and has @p bytes: ask before allocating them.
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
