// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/project/TreeEntries.h"

#include "model/base/Random.h"
#include "model/io/project/ColumnEntries.h"

namespace espalier {

namespace {

template <class Table, class Columns>
void addTable(ZipWriter& archive, const char* folder, const Columns& columns)
{
    Table::visit(
        [&]<class T>(const ColumnInfo<T>& info, const QList<T>& column) {
            const bool isPlain = info.fallback && std::ranges::all_of(column, [&](const T& value) {
                                     return value == *info.fallback;
                                 });
            if (!isPlain)
                addEntry(archive, QByteArray(folder) + '/' + info.name, column);
        },
        columns);
}

template <class Table, class Columns>
Result<void> readTable(const ZipReader& archive, const char* folder, std::uint32_t rows, Columns& columns)
{
    Result<void> read;
    Table::visit(
        [&]<class T>(const ColumnInfo<T>& info, QList<T>& column) {
            const QByteArray name = QByteArray(folder) + '/' + info.name;
            if (!read || rows == 0)
                return;
            if (info.fallback && !archive.contains(name.constData()))
                column.fill(*info.fallback, rows);
            else
                read = readEntry(archive, name, rows, column);
        },
        columns);
    return read;
}

/// Keys in the form that files have: the difference from the key that follows from the parent's key, the slot
/// and the step of birth. Nearly all differences are zero, so the packed column is small. @p known returns
/// the key of a row before @p id.
template <class KnownKey>
InternodeKey expectedKey(const TreeContent& content, InternodeId id, const KnownKey& known)
{
    const InternodeColumns& c = content.internodes;
    const InternodeId parent = c.parent[id];
    if (parent == kNoInternode || parent >= id)
        return rootKey(content.seed);
    return childKey(known(parent), c.slot[id], c.birth[id]);
}

QList<InternodeKey> keyDifferences(const TreeContent& content)
{
    const QList<InternodeKey>& keys = content.internodes.key;
    QList<InternodeKey> differences;
    differences.resize(keys.size()); // unlike the constructor, throws if there is no memory
    for (InternodeId id = 0; id < content.internodes.size(); ++id)
        differences[id] = keys[id] ^ expectedKey(content, id, [&](InternodeId row) { return keys[row]; });
    return differences;
}

void restoreKeys(TreeContent& content)
{
    QList<InternodeKey>& keys = content.internodes.key;
    for (InternodeId id = 0; id < content.internodes.size(); ++id)
        keys[id] ^= expectedKey(content, id, [&](InternodeId row) { return keys[row]; });
}

template <class T>
Result<void> readSparse(const ZipReader& archive, const QByteArray& name, std::uint32_t internodes,
                        SparseColumn<T>& column)
{
    const QByteArray idName = name + ".id";
    if (!archive.contains(idName.constData()))
        return {};
    const Result<QByteArray> bytes =
        archive.read(idName.constData(), std::uint64_t{internodes} * sizeof(InternodeId));
    if (!bytes)
        return bytes.error();
    const auto rows = static_cast<std::uint32_t>(bytes->size() / static_cast<qsizetype>(sizeof(InternodeId)));
    QList<InternodeId> ids;
    QList<T> values;
    Result<void> read = readEntry(archive, idName, rows, ids);
    if (read)
        read = readEntry(archive, name + ".value", rows, values);
    if (!read)
        return read;
    std::vector<SparseCell<T>> cells;
    cells.reserve(rows);
    for (qsizetype i = 0; i < ids.size(); ++i)
        cells.push_back({ids[i], values[i]});
    column = SparseColumn<T>::fromCells(std::move(cells));
    return {};
}

} // namespace

void addRows(ZipWriter& archive, const InternodeColumns& internodes, const LeafColumns& leaves)
{
    if (internodes.size() > 0)
        addTable<InternodeTable>(archive, "internodes", internodes);
    if (leaves.size() > 0)
        addTable<LeafTable>(archive, "leaves", leaves);
}

Result<void> readRows(const ZipReader& archive, std::uint32_t internodes, std::uint32_t leaves,
                      TreeRows& rows)
{
    Result<void> read = readTable<InternodeTable>(archive, "internodes", internodes, rows.internodes);
    if (read)
        read = readTable<LeafTable>(archive, "leaves", leaves, rows.leaves);
    return read;
}

void addTree(ZipWriter& archive, const TreeContent& content)
{
    InternodeColumns internodes = content.internodes;
    internodes.key = keyDifferences(content);
    addTable<InternodeTable>(archive, "internodes", internodes);
    if (content.leaves.size() > 0)
        addTable<LeafTable>(archive, "leaves", content.leaves);
    SparseTable::visit(
        [&]<class T>(const ColumnInfo<T>& info, const SparseColumn<T>& column) {
            if (column.cells().empty())
                return;
            QList<InternodeId> ids;
            QList<T> values;
            for (const auto& [id, value] : column.cells()) {
                ids.append(id);
                values.append(value);
            }
            const QByteArray name = QByteArray("sparse/") + info.name;
            addEntry(archive, name + ".id", ids);
            addEntry(archive, name + ".value", values);
        },
        content.sparse);
}

Result<void> readTree(const ZipReader& archive, std::uint32_t internodes, std::uint32_t leaves,
                      TreeContent& content)
{
    Result<void> read = readTable<InternodeTable>(archive, "internodes", internodes, content.internodes);
    if (read)
        restoreKeys(content);
    if (read)
        read = readTable<LeafTable>(archive, "leaves", leaves, content.leaves);
    SparseTable::visit(
        [&]<class T>(const ColumnInfo<T>& info, SparseColumn<T>& column) {
            if (read)
                read = readSparse(archive, QByteArray("sparse/") + info.name, internodes, column);
        },
        content.sparse);
    return read;
}

} // namespace espalier
