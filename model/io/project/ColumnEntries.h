// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Error.h"
#include "model/base/Vector.h"
#include "model/io/ZipArchive.h"

#include <QList>

#include <bit>
#include <optional>
#include <span>

namespace espalier {

// Columns of numbers as entries of an archive, little-endian, a rotation as four floats x, y, z, w.
static_assert(std::endian::native == std::endian::little);
static_assert(sizeof(Rotation) == 4 * sizeof(float));
static_assert(sizeof(Vec3) == 3 * sizeof(float) && sizeof(Vec2) == 2 * sizeof(float));

template <class T>
void addEntry(ZipWriter& archive, const QByteArray& name, const QList<T>& column)
{
    archive.add(name, QByteArray(reinterpret_cast<const char*>(column.constData()),
                                 column.size() * static_cast<qsizetype>(sizeof(T))));
}

/// Values that can be missing: their flags are in a separate entry.
template <class T>
void addEntry(ZipWriter& archive, const QByteArray& name, const QList<std::optional<T>>& column)
{
    QList<std::uint8_t> flags;
    QList<T> values;
    for (const std::optional<T>& value : column) {
        flags.append(value ? 1 : 0);
        if (value)
            values.append(*value);
    }
    addEntry(archive, name + ".set", flags);
    addEntry(archive, name, values);
}

/// Reads an entry that must have exactly @p rows rows.
template <class T>
Result<void> readEntry(const ZipReader& archive, const QByteArray& name, std::uint32_t rows, QList<T>& column)
{
    if (const Result<void> size = archive.expectSize(name.constData(), std::uint64_t{rows} * sizeof(T));
        !size)
        return size;
    column.resize(rows);
    return archive.readExactly(name.constData(), std::as_writable_bytes(std::span(column.data(), rows)));
}

template <class T>
Result<void> readEntry(const ZipReader& archive, const QByteArray& name, std::uint32_t rows,
                       QList<std::optional<T>>& column)
{
    QList<std::uint8_t> flags;
    if (const Result<void> read = readEntry(archive, name + ".set", rows, flags); !read)
        return read;
    QList<T> values;
    const auto set = static_cast<std::uint32_t>(flags.size() - flags.count(0));
    if (const Result<void> read = readEntry(archive, name, set, values); !read)
        return read;
    column.reserve(rows);
    auto next = values.cbegin();
    for (const std::uint8_t flag : flags)
        column.append(flag != 0 ? std::optional<T>(*next++) : std::nullopt);
    return {};
}

} // namespace espalier
