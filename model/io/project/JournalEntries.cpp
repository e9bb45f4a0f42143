// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/project/JournalEntries.h"

#include "model/io/JsonReader.h"
#include "model/io/project/ColumnEntries.h"
#include "model/io/project/JournalCheck.h"
#include "model/io/project/ProjectLimits.h"
#include "model/io/project/ProjectText.h"
#include "model/io/project/RecordEntries.h"

namespace espalier {

namespace {

Error doesNotAddUp()
{
    return inputError(ProjectText::tr("the history"), ProjectText::tr("its parts do not add up"));
}

/// The changes of one kind in all deltas: how many changes each delta makes, and how many have been read.
struct Counts {
    QList<std::uint32_t> count;
    std::uint32_t sum = 0;
    qsizetype next = 0;

    void append(std::size_t changes)
    {
        count.append(static_cast<std::uint32_t>(changes));
        sum += count.back();
    }
    /// Reads the counts of @p deltas deltas, which change each of @p rows rows at most once. Returns whether
    /// the journal has changes of this kind.
    Result<bool> read(const ZipReader& archive, const QByteArray& name, std::uint32_t deltas,
                      std::uint32_t rows)
    {
        const QByteArray entry = name + ".count";
        if (!archive.contains(entry.constData()))
            return false;
        if (const Result<void> read = readEntry(archive, entry, deltas, count); !read)
            return read.error();
        std::uint64_t all = 0;
        for (const std::uint32_t changes : count) {
            all += changes;
            if (changes > rows || all > projectLimits::kChanges)
                return doesNotAddUp();
        }
        sum = static_cast<std::uint32_t>(all);
        return sum > 0;
    }
    /// Number of changes of delta @p i.
    std::uint32_t at(std::size_t i) const { return sum == 0 ? 0 : count[static_cast<qsizetype>(i)]; }
};

/// A number of each delta. The column is empty if all are zero.
using Numbers = QList<std::uint32_t>;

std::uint32_t numberAt(const Numbers& column, std::size_t i)
{
    return column.isEmpty() ? 0 : column[static_cast<qsizetype>(i)];
}

/// The changes of one column.
template <class T>
struct ChangeColumns {
    Counts counts;
    QList<std::uint32_t> row;
    QList<T> before;
    QList<T> after;

    void append(const CellChanges<T>& changes)
    {
        counts.append(changes.size());
        for (const CellChange<T>& change : changes) {
            row.append(change.row);
            before.append(change.before);
            after.append(change.after);
        }
    }
    void add(ZipWriter& archive, const QByteArray& name) const
    {
        if (counts.sum == 0)
            return;
        addEntry(archive, name + ".count", counts.count);
        addEntry(archive, name + ".row", row);
        addEntry(archive, name + ".before", before);
        addEntry(archive, name + ".after", after);
    }
    Result<void> read(const ZipReader& archive, const QByteArray& name, std::uint32_t deltas,
                      std::uint32_t rows)
    {
        const Result<bool> any = counts.read(archive, name, deltas, rows);
        if (!any)
            return any.error();
        Result<void> read;
        if (*any)
            read = readEntry(archive, name + ".row", counts.sum, row);
        if (*any && read)
            read = readEntry(archive, name + ".before", counts.sum, before);
        if (*any && read)
            read = readEntry(archive, name + ".after", counts.sum, after);
        return read;
    }
    /// Moves the changes of delta @p i into @p changes; call it for each delta in turn.
    void take(std::size_t i, CellChanges<T>& changes)
    {
        const std::uint32_t count = counts.at(i);
        if (count > 0)
            changes.reserve(count);
        for (const qsizetype end = counts.next + count; counts.next < end; ++counts.next)
            changes.push_back({row[counts.next], before[counts.next], after[counts.next]});
    }
};

#define ESPALIER_CHANGE_COLUMNS(Type, name, fallback, fault, edits) ChangeColumns<Type> name;
#define ESPALIER_SPARSE_CHANGE_COLUMNS(Type, name, fallback, fault, edits)                                   \
    ChangeColumns<std::optional<Type>> name;
#define ESPALIER_KEPT_COUNT_COLUMN(Type, name, fallback, fault, edits) Numbers name;

/// A journal as columns.
struct JournalColumns {
    struct Internodes {
        ESPALIER_INTERNODE_COLUMNS(ESPALIER_CHANGE_COLUMNS)
    };
    struct Leaves {
        ESPALIER_LEAF_COLUMNS(ESPALIER_CHANGE_COLUMNS)
    };
    struct Sparse {
        ESPALIER_SPARSE_COLUMNS(ESPALIER_SPARSE_CHANGE_COLUMNS)
    };
    struct Kept {
        ESPALIER_KEPT_VALUES(ESPALIER_KEPT_COUNT_COLUMN)
    };

    Numbers stepBefore;
    Numbers stepAfter;
    Numbers parametersBefore;
    Numbers parametersAfter;
    Numbers born;
    Numbers bornLeaves;
    Kept kept;
    Internodes internodes;
    Leaves leaves;
    Sparse sparse;
    Counts diedCounts;
    QList<InternodeId> died;
    Counts lassoCounts;
    QList<std::uint32_t> lassoIndex;
    QList<std::uint8_t> lassoInForce;

    /// Calls @p visit(name, column) for each column of numbers that every delta has; a column of zeros may be
    /// missing in the file.
    template <class Self, class Visit>
    static void visitNumbers(Self& self, const Visit& visit)
    {
        visit("stepBefore", self.stepBefore);
        visit("stepAfter", self.stepAfter);
        visit("parametersBefore", self.parametersBefore);
        visit("parametersAfter", self.parametersAfter);
        visit("born", self.born);
        visit("bornLeaves", self.bornLeaves);
        KeptTable::visit(
            [&](const auto& info, auto& column) { visit(QByteArray("kept.") + info.name, column); },
            self.kept);
    }
    /// Calls @p visit(table)(info, columns) for the changes of each column of each table.
    template <class Self, class Visit>
    static void visitChanges(Self& self, const Visit& visit)
    {
        InternodeTable::visit(visit("internodes"), self.internodes);
        LeafTable::visit(visit("leaves"), self.leaves);
        SparseTable::visit(visit("sparse"), self.sparse);
    }
    static QByteArray entryOf(QByteArrayView table, const char* column)
    {
        return "journal/" + table.toByteArray() + '.' + column;
    }

    /// Whether delta @p i changes nothing.
    bool isEmpty(std::size_t i) const
    {
        bool isEmpty = numberAt(stepBefore, i) == numberAt(stepAfter, i) &&
                       numberAt(parametersBefore, i) == numberAt(parametersAfter, i) &&
                       numberAt(born, i) == 0 && numberAt(bornLeaves, i) == 0 && diedCounts.at(i) == 0 &&
                       lassoCounts.at(i) == 0;
        KeptTable::visit(
            [&](const auto&, const Numbers& column) { isEmpty = isEmpty && numberAt(column, i) == 0; }, kept);
        visitChanges(*this, [&](QByteArrayView) {
            return [&](const auto&, const auto& columns) { isEmpty = isEmpty && columns.counts.at(i) == 0; };
        });
        return isEmpty;
    }

    void append(const TreeDelta& delta)
    {
        stepBefore.append(delta.stepBefore);
        stepAfter.append(delta.stepAfter);
        parametersBefore.append(delta.parametersBefore);
        parametersAfter.append(delta.parametersAfter);
        born.append(delta.born.count);
        bornLeaves.append(delta.bornLeaves.count);
        const auto append = [](const auto&, auto& columns, const auto& values) { columns.append(values); };
        KeptTable::visit(append, kept, delta.kept);
        InternodeTable::visit(append, internodes, delta.internodes);
        LeafTable::visit(append, leaves, delta.leaves);
        SparseTable::visit(append, sparse, delta.sparse);
        diedCounts.append(delta.died.size());
        for (const InternodeId id : delta.died)
            died.append(id);
        lassoCounts.append(delta.lassos.size());
        for (const auto [index, isInForce] : delta.lassos) {
            lassoIndex.append(index);
            lassoInForce.append(isInForce ? 1 : 0);
        }
    }

    TreeDelta take(std::size_t i)
    {
        TreeDelta delta;
        delta.stepBefore = numberAt(stepBefore, i);
        delta.stepAfter = numberAt(stepAfter, i);
        delta.parametersBefore = numberAt(parametersBefore, i);
        delta.parametersAfter = numberAt(parametersAfter, i);
        delta.born.count = numberAt(born, i);
        delta.bornLeaves.count = numberAt(bornLeaves, i);
        KeptTable::visit(
            [i](const auto&, const Numbers& column, std::uint32_t& count) { count = numberAt(column, i); },
            kept, delta.kept);
        const auto take = [i](const auto&, auto& columns, auto& changes) { columns.take(i, changes); };
        InternodeTable::visit(take, internodes, delta.internodes);
        LeafTable::visit(take, leaves, delta.leaves);
        SparseTable::visit(take, sparse, delta.sparse);
        const auto firstDied = died.cbegin() + diedCounts.next;
        delta.died.assign(firstDied, firstDied + diedCounts.at(i));
        diedCounts.next += diedCounts.at(i);
        for (const qsizetype end = lassoCounts.next + lassoCounts.at(i); lassoCounts.next < end;
             ++lassoCounts.next)
            delta.lassos.push_back({lassoIndex[lassoCounts.next], lassoInForce[lassoCounts.next] != 0});
        return delta;
    }
};

/// The first of @p rows rows that the deltas bring, which are the last rows of their table. Empty if there
/// are fewer rows.
std::optional<std::uint32_t> firstBirth(const Numbers& born, std::uint32_t rows)
{
    std::uint64_t sum = 0;
    for (const std::uint32_t count : born)
        sum += count;
    return sum <= rows ? std::optional(static_cast<std::uint32_t>(rows - sum)) : std::nullopt;
}

/// Reads all columns of @p deltas deltas, whose last one leads to a tree of those sizes.
Result<void> read(const ZipReader& archive, std::uint32_t deltas, const JournalBounds& bounds,
                  JournalColumns& columns)
{
    const std::uint32_t internodes = bounds.internodes;
    Result<void> read;
    JournalColumns::visitNumbers(columns, [&](const QByteArray& name, auto& column) {
        const QByteArray entry = "journal/" + name;
        if (read && archive.contains(entry.constData()))
            read = readEntry(archive, entry, deltas, column);
    });
    JournalColumns::visitChanges(columns, [&](QByteArrayView table) {
        const std::uint32_t rows = table == "leaves" ? bounds.leaves : internodes;
        return [&, table, rows](const auto& info, auto& changes) {
            if (read)
                read = changes.read(archive, JournalColumns::entryOf(table, info.name), deltas, rows);
        };
    });
    if (!read)
        return read;
    const Result<bool> anyDied = columns.diedCounts.read(archive, "journal/died", deltas, internodes);
    if (!anyDied)
        return anyDied.error();
    if (columns.diedCounts.sum > internodes)
        return doesNotAddUp();
    if (*anyDied)
        read = readEntry(archive, "journal/died", columns.diedCounts.sum, columns.died);
    if (!read)
        return read;
    const Result<bool> anyLassos = columns.lassoCounts.read(archive, "journal/lassos", deltas, bounds.lassos);
    if (!anyLassos)
        return anyLassos.error();
    if (*anyLassos)
        read = readEntry(archive, "journal/lassos.index", columns.lassoCounts.sum, columns.lassoIndex);
    if (*anyLassos && read)
        read = readEntry(archive, "journal/lassos.inForce", columns.lassoCounts.sum, columns.lassoInForce);
    if (std::ranges::any_of(columns.lassoInForce, [](std::uint8_t flag) { return flag > 1; }))
        return doesNotAddUp();
    return read;
}

} // namespace

JournalBounds JournalBounds::of(const TreeContent& content)
{
    return {content.internodes.size(), content.leaves.size(),
            static_cast<std::uint32_t>(content.kept.lassos.size())};
}

void addJournal(ZipWriter& archive, const Journal& journal)
{
    JournalColumns columns;
    for (const auto& delta : journal)
        columns.append(*delta);
    JournalColumns::visitNumbers(columns, [&](const QByteArray& name, const QList<std::uint32_t>& column) {
        if (column.count(0) < column.size())
            addEntry(archive, "journal/" + name, column);
    });
    JournalColumns::visitChanges(columns, [&](QByteArrayView table) {
        return [&archive, table](const auto& info, const auto& changes) {
            changes.add(archive, JournalColumns::entryOf(table, info.name));
        };
    });
    if (!columns.died.isEmpty()) {
        addEntry(archive, "journal/died.count", columns.diedCounts.count);
        addEntry(archive, "journal/died", columns.died);
    }
    if (!columns.lassoIndex.isEmpty()) {
        addEntry(archive, "journal/lassos.count", columns.lassoCounts.count);
        addEntry(archive, "journal/lassos.index", columns.lassoIndex);
        addEntry(archive, "journal/lassos.inForce", columns.lassoInForce);
    }
    addRecords(archive, journal);
}

Result<Journal> readJournal(const ZipReader& archive, std::uint32_t deltas, const JournalBounds& bounds)
{
    JournalColumns columns;
    if (const Result<void> result = read(archive, deltas, bounds, columns); !result)
        return result.error();
    for (std::uint32_t i = 0; i < deltas; ++i) {
        if (columns.isEmpty(i))
            return emptyDelta(i);
    }
    std::optional<std::uint32_t> nextInternode = firstBirth(columns.born, bounds.internodes);
    std::optional<std::uint32_t> nextLeaf = firstBirth(columns.bornLeaves, bounds.leaves);
    if (!nextInternode || !nextLeaf)
        return doesNotAddUp();
    Journal journal;
    journal.reserve(deltas);
    for (std::uint32_t i = 0; i < deltas; ++i) {
        auto delta = std::make_shared<TreeDelta>(columns.take(i));
        delta->born.first = std::exchange(*nextInternode, *nextInternode + delta->born.count);
        delta->bornLeaves.first = std::exchange(*nextLeaf, *nextLeaf + delta->bornLeaves.count);
        journal.push_back(std::move(delta));
    }
    if (const Result<void> records = readRecords(archive, journal); !records)
        return records.error();
    return journal;
}

} // namespace espalier
