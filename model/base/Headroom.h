// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace espalier {

/// The capacity that a column of @p size elements gets when it has to grow: an eighth more, and at least
/// @p least elements more. The policy of the containers themselves is up to twice the size, which leaves up
/// to half of the memory of a large tree unused. While a column grows to n elements, at most 9 n elements are
/// copied in all, so the cost of growth stays proportional to the size.
constexpr std::size_t withHeadroom(std::size_t size, std::size_t least = 64)
{
    return size + std::max(size / 8, least);
}

/// Makes room in @p column (a QList or a std::vector) for @p size elements in all, with headroom. Does
/// nothing if it has room for them. Call it before elements are appended to a column that has one for each
/// row of a tree.
template <class Column>
void makeRoom(Column& column, std::size_t size, std::size_t leastHeadroom = 64)
{
    using Size = decltype(column.capacity());
    if (column.capacity() < static_cast<Size>(size))
        column.reserve(static_cast<Size>(withHeadroom(size, leastHeadroom)));
}

/// Cuts @p list to @p size elements, of which it is the only owner then; throws std::bad_alloc if there is no
/// memory for a copy. To be called before a list is written that snapshots may share: the copy that a QList
/// makes by itself is written to address 0 if there is no memory (Qt 6.4).
template <class T>
void ownFirst(QList<T>& list, qsizetype size)
{
    if (list.isDetached()) {
        list.resize(size);
        return;
    }
    QList<T> copy;
    copy.resize(size); // throws
    std::copy_n(list.cbegin(), size, copy.begin());
    list = std::move(copy);
}

/// Sets the number of elements of @p column; new ones are copies of @p value, if one is given.
template <class Column, class... Value>
void resizeColumn(Column& column, std::size_t size, const Value&... value)
{
    makeRoom(column, size);
    column.resize(size, value...);
}

/// Removes the elements of @p list and frees its memory. ("list = {}" and clear() keep the memory.)
template <class T>
void freeList(std::vector<T>& list)
{
    list = std::vector<T>();
}

/// Removes the elements of a list that is filled again and again with few elements or with many. A large list
/// also gives its memory back.
template <class T>
void clearScratch(std::vector<T>& list)
{
    constexpr std::size_t kMostBytesKept = std::size_t{64} << 10;
    if (list.capacity() * sizeof(T) > kMostBytesKept)
        freeList(list);
    else
        list.clear();
}

} // namespace espalier
