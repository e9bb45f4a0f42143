// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Vector.h"

#include <QList>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace espalier {

/// Checks a value. Returns what is wrong, as a text to be translated in the context "Tree" ("its length is
/// out of range"), or null.
template <class T>
using FaultOf = const char* (*)(const T& value);

/// Whether a delta may change the cells of a column in rows that exist.
enum class Edits { Never, Allowed };

/// One column of a table, as applying, comparing, saving, reading and migrating see it.
template <class T>
struct ColumnInfo {
    const char* name;          ///< The name in files; never changes
    std::optional<T> fallback; ///< The value for files that lack the column; empty if every file must have it
    FaultOf<T> faultOf;        ///< The check for values from files
    Edits edits;               ///< Histories in files are held to it
};

template <class T>
constexpr const char* noFault(const T& /*value*/)
{
    return nullptr;
}

/// The value of a cell in a new row that is not given explicitly: the column's fallback, or the type's zero.
template <class T>
T initialValue(const std::optional<T>& fallback)
{
    if constexpr (std::is_same_v<T, Rotation>)
        return fallback.value_or(Rotation::Identity());
    else
        return fallback.value_or(T{});
}

/// The change of one cell.
template <class T>
struct CellChange {
    std::uint32_t row;
    T before;
    T after;

    bool operator==(const CellChange&) const = default;
};

/// The changed cells of one column, each row at most once. As long as it is empty it takes the memory of a
/// pointer: a delta has one for every column, and most of them are empty.
template <class T>
class CellChanges {
public:
    using Value = T;

    CellChanges() = default;
    CellChanges(const CellChanges& other)
        : m_changes(other.empty() ? nullptr : std::make_unique<List>(*other.m_changes))
    {
    }
    CellChanges(CellChanges&&) noexcept = default;
    CellChanges& operator=(CellChanges other) noexcept
    {
        m_changes = std::move(other.m_changes);
        return *this;
    }
    ~CellChanges() = default;

    bool empty() const { return !m_changes || m_changes->empty(); }
    std::size_t size() const { return m_changes ? m_changes->size() : 0; }
    const CellChange<T>* begin() const { return m_changes ? m_changes->data() : nullptr; }
    const CellChange<T>* end() const { return begin() + size(); }
    CellChange<T>* begin() { return m_changes ? m_changes->data() : nullptr; }
    CellChange<T>* end() { return begin() + size(); }
    const CellChange<T>& front() const { return m_changes->front(); }
    void reserve(std::size_t count) { list().reserve(count); }
    void push_back(CellChange<T> change) { list().push_back(std::move(change)); }
    /// Frees the memory beyond its size.
    void squeeze()
    {
        if (empty())
            m_changes.reset();
        else
            m_changes->shrink_to_fit();
    }

    std::size_t bytes() const
    {
        return m_changes ? sizeof(List) + m_changes->capacity() * sizeof(CellChange<T>) : 0;
    }
    bool operator==(const CellChanges& other) const
    {
        return std::equal(begin(), end(), other.begin(), other.end());
    }

private:
    using List = std::vector<CellChange<T>>;

    List& list()
    {
        if (!m_changes)
            m_changes = std::make_unique<List>();
        return *m_changes;
    }

    std::unique_ptr<List> m_changes;
};

/// A value of a sparse column.
template <class T>
struct SparseCell {
    std::uint32_t id;
    T value;
    bool operator==(const SparseCell&) const = default;
};

/// A property that few internodes have: (id, value) by ascending id.
template <class T>
class SparseColumn {
public:
    using Cell = SparseCell<T>;

    const std::vector<Cell>& cells() const { return m_cells; }
    /// Null if the internode has none.
    const T* find(std::uint32_t id) const
    {
        const auto place = std::ranges::lower_bound(m_cells, id, {}, &Cell::id);
        return place != m_cells.end() && place->id == id ? &place->value : nullptr;
    }
    std::optional<T> at(std::uint32_t id) const
    {
        const T* const value = find(id);
        return value ? std::optional<T>(*value) : std::nullopt;
    }
    /// Sets the value of @p id, or removes it if @p value is empty.
    void set(std::uint32_t id, const std::optional<T>& value)
    {
        const auto place = std::ranges::lower_bound(m_cells, id, {}, &Cell::id);
        const bool isThere = place != m_cells.end() && place->id == id;
        if (value && isThere)
            place->value = *value;
        else if (value)
            m_cells.insert(place, {id, *value});
        else if (isThere)
            m_cells.erase(place);
    }
    /// A column with cells from a file; the caller checks that their ids ascend.
    static SparseColumn fromCells(std::vector<Cell> cells)
    {
        SparseColumn column;
        column.m_cells = std::move(cells);
        return column;
    }

    bool operator==(const SparseColumn&) const = default;

private:
    std::vector<Cell> m_cells;
};

} // namespace espalier

// A table is described by one list of columns, LIST(COLUMN), of lines COLUMN(type, name, fallback, fault,
// edits).
// The macros make from it the members of the struct <Table>Columns (a QList a column), <Table>Row (a value a
// column) and <Table>Changes (a CellChanges a column), and <Table>Table::visit(visitor, parts…), which calls
// visitor(ColumnInfo, part.name…) for each column in the list's order. So a new column needs one line in the
// list, and the code that uses it.
#define ESPALIER_COLUMN_MEMBER(Type, name, fallback, fault, edits) QList<Type> name;
#define ESPALIER_ROW_MEMBER(Type, name, fallback, fault, edits) Type name = initialValue<Type>(fallback);
#define ESPALIER_CHANGES_MEMBER(Type, name, fallback, fault, edits) CellChanges<Type> name;
#define ESPALIER_SPARSE_MEMBER(Type, name, fallback, fault, edits) SparseColumn<Type> name;
#define ESPALIER_SPARSE_CHANGES_MEMBER(Type, name, fallback, fault, edits)                                   \
    CellChanges<std::optional<Type>> name;
#define ESPALIER_COUNT_MEMBER(Type, name, fallback, fault, edits) std::uint32_t name = 0;
#define ESPALIER_VISIT_COLUMN(Type, name, fallback, fault, edits)                                            \
    visitor(ColumnInfo<Type>{#name, fallback, fault, edits}, parts.name...);
#define ESPALIER_VISITOR(Name, LIST)                                                                         \
    struct Name {                                                                                            \
        template <class Visitor, class... Parts>                                                             \
        static void visit(Visitor&& visitor, Parts&&... parts)                                               \
        {                                                                                                    \
            LIST(ESPALIER_VISIT_COLUMN)                                                                      \
        }                                                                                                    \
    };
