// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/project/RecordEntries.h"

#include "model/io/JsonReader.h"
#include "model/io/project/ColumnEntries.h"
#include "model/io/project/ProjectLimits.h"
#include "model/io/project/ProjectText.h"

#include <QJsonDocument>

namespace espalier {

namespace {

constexpr char kDeltas[] = "journal/records.deltas";
constexpr char kSizes[] = "journal/records.size";
constexpr char kOperations[] = "journal/records.json";

Error doNotAddUp()
{
    return inputError(ProjectText::tr("the record of what was done"),
                      ProjectText::tr("its parts do not add up"));
}

} // namespace

void addRecords(ZipWriter& archive, const Journal& journal)
{
    QList<std::uint32_t> deltas;
    QList<std::uint32_t> sizes;
    QByteArray operations;
    for (const auto& delta : journal) {
        const EditRecord* record = delta->record.get();
        deltas.append(record ? record->deltas : 0);
        if (!record)
            continue;
        const bool hasRoom = record->operation.size() <= projectLimits::kRecordBytes - operations.size();
        const QByteArray operation = hasRoom ? record->operation : QByteArray();
        sizes.append(static_cast<std::uint32_t>(operation.size()));
        operations.append(operation);
    }
    if (sizes.isEmpty())
        return;
    addEntry(archive, kDeltas, deltas);
    addEntry(archive, kSizes, sizes);
    archive.add(kOperations, operations);
}

Result<void> readRecords(const ZipReader& archive, Journal& journal)
{
    if (!archive.contains(kDeltas))
        return {};
    QList<std::uint32_t> deltas;
    Result<void> read = readEntry(archive, kDeltas, static_cast<std::uint32_t>(journal.size()), deltas);
    if (!read)
        return read;
    if (std::ranges::any_of(deltas, [](std::uint32_t count) { return count > projectLimits::kDeltas; }))
        return doNotAddUp();
    QList<std::uint32_t> sizes;
    read = readEntry(archive, kSizes, static_cast<std::uint32_t>(deltas.size() - deltas.count(0)), sizes);
    if (!read)
        return read;
    const Result<QByteArray> operations = archive.read(kOperations, projectLimits::kRecordBytes);
    if (!operations)
        return operations.error();

    qsizetype edit = 0;
    qsizetype first = 0;
    for (qsizetype i = 0; i < deltas.size(); ++i) {
        if (deltas[i] == 0)
            continue;
        const qsizetype bytes = sizes[edit++];
        if (bytes > EditRecord::kMostBytes || bytes > operations->size() - first)
            return doNotAddUp();
        const QByteArray operation = operations->sliced(first, bytes);
        first += bytes;
        if (bytes > 0 && !QJsonDocument::fromJson(operation).isObject()) {
            return inputError(ProjectText::tr("step %1 of the history").arg(i + 1),
                              ProjectText::tr("the record of what was done is not a JSON object"));
        }
        journal[static_cast<std::size_t>(i)]->record =
            std::make_shared<const EditRecord>(EditRecord{operation, deltas[i]});
    }
    return first == operations->size() ? Result<void>() : doNotAddUp();
}

} // namespace espalier
