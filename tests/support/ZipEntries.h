// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/io/ZipArchive.h"

#include <QByteArray>

#include <zip.h>

#include <utility>
#include <vector>

namespace espalier::test {

/// The entries of a ZIP archive, unpacked, in their order. What cannot be unpacked is empty.
using ZipEntries = std::vector<std::pair<QByteArray, QByteArray>>;

inline ZipEntries unpackEntries(const QByteArray& archive)
{
    zip_source_t* const source =
        zip_source_buffer_create(archive.constData(), static_cast<zip_uint64_t>(archive.size()), 0, nullptr);
    zip_t* const zip = zip_open_from_source(source, ZIP_RDONLY, nullptr);
    Q_ASSERT(zip != nullptr);
    ZipEntries entries;
    for (zip_int64_t i = 0; i < zip_get_num_entries(zip, 0); ++i) {
        zip_stat_t stat;
        zip_stat_index(zip, static_cast<zip_uint64_t>(i), 0, &stat);
        QByteArray content(static_cast<qsizetype>(stat.size), '\0');
        if (zip_file_t* const file = zip_fopen_index(zip, static_cast<zip_uint64_t>(i), 0)) {
            zip_fread(file, content.data(), stat.size);
            zip_fclose(file);
        } else {
            content.clear();
        }
        entries.emplace_back(stat.name, content);
    }
    zip_discard(zip);
    return entries;
}

inline QByteArray packEntries(const ZipEntries& entries)
{
    ZipWriter writer;
    for (const auto& [name, content] : entries)
        writer.add(name, content);
    return *writer.finish();
}

/// The content of one entry, to read or to change.
inline QByteArray& entry(ZipEntries& entries, const QByteArray& name)
{
    for (auto& [entryName, content] : entries) {
        if (entryName == name)
            return content;
    }
    qFatal("there is no entry %s", name.constData());
}

} // namespace espalier::test
