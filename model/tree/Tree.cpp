// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/tree/Tree.h"

#include "model/base/Headroom.h"
#include "model/base/Random.h"

#include <QSet>

#include <algorithm>
#include <utility>

namespace espalier {

namespace {

template <class T>
bool isSameColumn(const QList<T>& a, const QList<T>& b)
{
    return a.isSharedWith(b) || a == b;
}

/// Calls @p write(cell, change) for each change of the columns in @p changes.
template <class Table, class Columns, class Changes, class Write>
void writeCells(Columns& columns, const Changes& changes, Write&& write)
{
    Table::visit(
        [&](const auto&, auto& column, const auto& columnChanges) {
            if (columnChanges.empty())
                return;
            ownFirst(column, column.size());
            auto* const cells = column.data();
            for (const auto& change : columnChanges)
                write(cells[change.row], change);
        },
        columns, changes);
}

/// Kept values that are compared with a new one: a value from before them is kept once more, so that an edit
/// costs the same however many values there are.
constexpr qsizetype kCompared = 256;

/// The place of @p value among the last @p most of @p values; −1 if it is not there.
template <class T>
qsizetype lastPlace(const QList<T>& values, const T& value, qsizetype most)
{
    const auto end = values.crbegin() + std::min(most, values.size());
    const auto last = std::find(values.crbegin(), end, value);
    return last == end ? -1 : values.crend() - last - 1;
}

TreeRows& rowsOf(TreeDelta& delta)
{
    if (!delta.rows)
        delta.rows = std::make_shared<TreeRows>();
    return *delta.rows;
}

constexpr auto kWriteAfter = [](auto& cell, const auto& change) { cell = change.after; };
constexpr auto kWriteBefore = [](auto& cell, const auto& change) { cell = change.before; };

} // namespace

void InternodeColumns::append(const InternodeRow& row)
{
    InternodeTable::visit([](const auto&, auto& column, const auto& value) { column.append(value); }, *this,
                          row);
}

void LeafColumns::append(const LeafRow& row)
{
    LeafTable::visit([](const auto&, auto& column, const auto& value) { column.append(value); }, *this, row);
}

bool TreeContent::operator==(const TreeContent& other) const
{
    bool isEqual = seed == other.seed && step == other.step && currentParameters == other.currentParameters &&
                   lassosInForce == other.lassosInForce;
    const auto compare = [&isEqual](const auto&, const auto& a, const auto& b) {
        isEqual = isEqual && isSameColumn(a, b);
    };
    InternodeTable::visit(compare, internodes, other.internodes);
    LeafTable::visit(compare, leaves, other.leaves);
    KeptTable::visit(compare, kept, other.kept);
    SparseTable::visit([&isEqual](const auto&, const auto& a, const auto& b) { isEqual = isEqual && a == b; },
                       sparse, other.sparse);
    return isEqual;
}

Tree::Tree(std::uint64_t seed, const TreeParameters& parameters)
{
    m_content.seed = seed;
    m_content.kept.parameters.append(parameters);
    InternodeColumns& c = m_content.internodes;
    c.append({.parent = kNoInternode,
              .length = static_cast<float>(parameters.growth.internodeLength),
              .vigour = 1.0F,
              .slot = kTerminalSlot,
              .buds = BudStates::active(kTerminalBud),
              .key = rootKey(seed)});
}

Result<Tree> Tree::fromContent(TreeContent content)
{
    if (QString fault = treeFault(content); !fault.isEmpty())
        return Error{Error::Kind::Input, std::move(fault)};
    Tree tree;
    tree.m_content = std::move(content);
    return tree;
}

bool Tree::hasRoomFor(const TreeParameters& parameters, qsizetype mostImageBytes) const
{
    if (parameterSets().size() >= kMostParameterSets && !parameterSets().contains(parameters))
        return false;
    // Seldom do parameters bring another image.
    QSet<QString> known;
    const auto bytesOfNew = [&known](const TreeParameters& set) {
        qsizetype bytes = 0;
        visitImages(set, [&](const char*, const ImageAsset& image) {
            if (!image.isNull() && !known.contains(image.hash())) {
                known.insert(image.hash());
                bytes += image.file().size();
            }
        });
        return bytes;
    };
    bytesOfNew(this->parameters());
    if (bytesOfNew(parameters) == 0)
        return true;
    known.clear();
    qsizetype bytes = bytesOfNew(parameters);
    for (const TreeParameters& set : parameterSets())
        bytes += bytesOfNew(set);
    return bytes <= mostImageBytes;
}

bool Tree::hasRoomForLassos(std::size_t count) const
{
    return static_cast<qsizetype>(count) <= kMostLassos - lassos().size();
}

bool Tree::hasRoomForProfiles(const TreeDelta& delta) const
{
    if (delta.kept.profiles == 0)
        return true;
    std::size_t bytes = 0;
    for (const QList<StrandProfile>* list : {&profiles(), &std::as_const(delta.rows->kept.profiles)}) {
        for (const StrandProfile& profile : *list)
            bytes += profile.bytes();
    }
    return static_cast<qsizetype>(delta.kept.profiles) <= kMostProfiles - profiles().size() &&
           bytes <= kMostProfilePointsInAll * sizeof(Vec2);
}

std::vector<LassoStroke> Tree::lassosInForce() const
{
    std::vector<LassoStroke> strokes;
    for (const std::uint32_t index : m_content.lassosInForce)
        strokes.push_back(lassos()[index]);
    return strokes;
}

void Tree::apply(const TreeDelta& delta)
{
    TreeContent& c = m_content;
    Q_ASSERT(c.step == delta.stepBefore && delta.born.first == size());
    Q_ASSERT(delta.bringsRows() == (delta.rows != nullptr));
    if (delta.rows) {
        const auto append = [](const auto&, auto& column, const auto& rows) {
            makeRoom(column, static_cast<std::size_t>(column.size() + rows.size()));
            column.append(rows);
        };
        InternodeTable::visit(append, c.internodes, delta.rows->internodes);
        LeafTable::visit(append, c.leaves, delta.rows->leaves);
        KeptTable::visit([](const auto&, auto& column, const auto& values) { column.append(values); }, c.kept,
                         delta.rows->kept);
    }
    setDeaths(delta, delta.stepAfter);
    writeCells<InternodeTable>(c.internodes, delta.internodes, kWriteAfter);
    writeCells<LeafTable>(c.leaves, delta.leaves, kWriteAfter);
    SparseTable::visit(
        [](const auto&, auto& column, const auto& changes) {
            for (const auto& change : changes)
                column.set(change.row, change.after);
        },
        c.sparse, delta.sparse);
    for (const TreeDelta::LassoChange& change : delta.lassos)
        setLasso(change.index, change.isInForce);
    c.currentParameters = delta.parametersAfter;
    c.step = delta.stepAfter;
}

void Tree::revert(TreeDelta& delta)
{
    if (delta.bringsRows() && !delta.rows) {
        const TreeContent& c = m_content;
        delta.rows = std::make_shared<TreeRows>();
        // Later deltas have been reverted, so its rows are the last ones and have only its own changes.
        revertChanges(delta);
        const auto takeFrom = [](std::uint32_t first) {
            return [first](const auto&, const auto& column, auto& rows) { rows = column.mid(first); };
        };
        InternodeTable::visit(takeFrom(delta.born.first), c.internodes, delta.rows->internodes);
        LeafTable::visit(takeFrom(delta.bornLeaves.first), c.leaves, delta.rows->leaves);
        KeptTable::visit([](const auto&, const auto& column, auto& rows,
                            std::uint32_t count) { rows = column.mid(column.size() - count); },
                         c.kept, delta.rows->kept, delta.kept);
    } else {
        revertChanges(delta);
    }
    truncate(delta);
}

void Tree::revertDropping(const TreeDelta& delta)
{
    revertChanges(delta);
    truncate(delta);
}

void Tree::revertChanges(const TreeDelta& delta)
{
    TreeContent& c = m_content;
    Q_ASSERT(c.step == delta.stepAfter && delta.born.end() == size());
    for (const TreeDelta::LassoChange& change : delta.lassos)
        setLasso(change.index, !change.isInForce);
    SparseTable::visit(
        [](const auto&, auto& column, const auto& changes) {
            for (const auto& change : changes)
                column.set(change.row, change.before);
        },
        c.sparse, delta.sparse);
    writeCells<LeafTable>(c.leaves, delta.leaves, kWriteBefore);
    writeCells<InternodeTable>(c.internodes, delta.internodes, kWriteBefore);
    setDeaths(delta, kNever);
    c.currentParameters = delta.parametersBefore;
    c.step = delta.stepBefore;
}

void Tree::setDeaths(const TreeDelta& delta, Step death)
{
    QList<Step>& column = m_content.internodes.death;
    if (delta.died.empty())
        return;
    ownFirst(column, column.size());
    for (const InternodeId id : delta.died)
        column[id] = death;
}

/// Removes the rows and values that @p delta added.
void Tree::truncate(const TreeDelta& delta)
{
    if (!delta.bringsRows())
        return;
    const auto cut = [](std::uint32_t size) {
        return [size](const auto&, auto& column) { ownFirst(column, size); };
    };
    if (delta.born.count > 0)
        InternodeTable::visit(cut(delta.born.first), m_content.internodes);
    if (delta.bornLeaves.count > 0)
        LeafTable::visit(cut(delta.bornLeaves.first), m_content.leaves);
    KeptTable::visit(
        [](const auto&, auto& column, std::uint32_t count) {
            if (count > 0)
                column.resize(column.size() - count);
        },
        m_content.kept, delta.kept);
}

void Tree::setLasso(std::uint32_t index, bool inForce)
{
    std::vector<std::uint32_t>& indices = m_content.lassosInForce;
    const auto place = std::ranges::lower_bound(indices, index);
    const bool isIn = place != indices.end() && *place == index;
    if (inForce && !isIn)
        indices.insert(place, index);
    else if (!inForce && isIn)
        indices.erase(place);
}

std::size_t Tree::bytes() const
{
    std::size_t sum = 0;
    const auto add = [&sum](const auto&, const auto& column) {
        sum += static_cast<std::size_t>(column.capacity()) * sizeof(*column.constData());
    };
    InternodeTable::visit(add, m_content.internodes);
    LeafTable::visit(add, m_content.leaves);
    KeptTable::visit(add, m_content.kept);
    SparseTable::visit(
        [&sum](const auto&, const auto& column) {
            sum += column.cells().capacity() * sizeof(column.cells().front());
        },
        m_content.sparse);
    for (const LassoStroke& stroke : lassos())
        sum += stroke.points.capacity() * sizeof(Vec2);
    for (const StrandProfile& profile : profiles())
        sum += profile.bytes();
    return sum;
}

TreeDelta deltaStartingAt(const Tree& tree)
{
    TreeDelta delta;
    delta.stepBefore = delta.stepAfter = tree.step();
    delta.parametersBefore = delta.parametersAfter = tree.currentParameterSet();
    delta.born = {tree.size(), 0};
    delta.bornLeaves = {tree.placedLeaves().size(), 0};
    return delta;
}

std::uint32_t keepParameters(TreeDelta& delta, const Tree& tree, const TreeParameters& parameters)
{
    const QList<TreeParameters>& sets = tree.parameterSets();
    const bool hasRoom = sets.size() < kMostParameterSets;
    if (const auto known = lastPlace(sets, parameters, hasRoom ? kCompared : sets.size()); known >= 0)
        return static_cast<std::uint32_t>(known);
    Q_ASSERT(hasRoom);
    rowsOf(delta).kept.parameters.append(parameters);
    return static_cast<std::uint32_t>(sets.size()) + delta.kept.parameters++;
}

std::uint32_t keepLasso(TreeDelta& delta, const Tree& tree, const LassoStroke& stroke)
{
    Q_ASSERT(isLasso(stroke));
    rowsOf(delta).kept.lassos.append(stroke);
    return static_cast<std::uint32_t>(tree.lassos().size()) + delta.kept.lassos++;
}

std::uint32_t keepProfile(TreeDelta& delta, const Tree& tree, const StrandProfile& profile)
{
    Q_ASSERT(profileFault(profile).isEmpty());
    if (const auto known = lastPlace(tree.profiles(), profile, kCompared); known >= 0)
        return static_cast<std::uint32_t>(known);
    const auto first = static_cast<std::uint32_t>(tree.profiles().size());
    if (delta.rows) {
        if (const auto known = lastPlace(delta.rows->kept.profiles, profile, kCompared); known >= 0)
            return first + static_cast<std::uint32_t>(known);
    }
    rowsOf(delta).kept.profiles.append(profile);
    return first + delta.kept.profiles++;
}

} // namespace espalier
