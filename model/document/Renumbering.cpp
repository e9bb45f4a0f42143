// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/document/Renumbering.h"

#include "model/base/Headroom.h"

#include <utility>

namespace espalier {

namespace {

/// Calls @p numbers.internode(number), .leaf(), .parameters(), .lasso() or .profile() for each number of a
/// row or a value in @p delta, apart from the ranges of those that it brings.
template <class Numbers>
void forEachNumber(TreeDelta& delta, const Numbers& numbers)
{
    numbers.parameters(delta.parametersBefore);
    numbers.parameters(delta.parametersAfter);
    for (InternodeId& id : delta.died)
        numbers.internode(id);
    const auto internodeRows = [&](const auto&, auto& changes) {
        for (auto& change : changes)
            numbers.internode(change.row);
    };
    InternodeTable::visit(internodeRows, delta.internodes);
    SparseTable::visit(internodeRows, delta.sparse);
    LeafTable::visit(
        [&](const auto&, auto& changes) {
            for (auto& change : changes)
                numbers.leaf(change.row);
        },
        delta.leaves);
    for (auto& change : delta.leaves.internode) {
        numbers.internode(change.before);
        numbers.internode(change.after);
    }
    for (auto& change : delta.sparse.profile) {
        for (std::optional<std::uint32_t>* value : {&change.before, &change.after}) {
            if (*value)
                numbers.profile(**value);
        }
    }
    for (TreeDelta::LassoChange& change : delta.lassos)
        numbers.lasso(change.index);
}

/// A visitor of forEachNumber() that calls @p Call(numbers of the kind, number).
template <auto Call>
struct Visitor {
    NewNumbers& internodes;
    NewNumbers& leaves;
    NewNumbers& parameterSets;
    NewNumbers& lassos;
    NewNumbers& profiles;

    void internode(std::uint32_t& number) const { Call(internodes, number); }
    void leaf(std::uint32_t& number) const { Call(leaves, number); }
    void parameters(std::uint32_t& number) const { Call(parameterSets, number); }
    void lasso(std::uint32_t& number) const { Call(lassos, number); }
    void profile(std::uint32_t& number) const { Call(profiles, number); }
};

using Keep = Visitor<[](NewNumbers& numbers, std::uint32_t& number) { numbers.keep(number); }>;
using Renumber = Visitor<[](NewNumbers& numbers, std::uint32_t& number) { number = numbers[number]; }>;

/// Sets each element of @p column to its new number.
template <class T>
void renumberColumn(QList<T>& column, const NewNumbers& numbers)
{
    ownFirst(column, column.size());
    for (T& number : column)
        number = static_cast<T>(numbers[number]);
}

template <class T>
QList<T> keptOf(const QList<T>& column, const NewNumbers& numbers)
{
    QList<T> kept;
    makeRoom(kept, static_cast<std::size_t>(column.size()));
    for (qsizetype i = 0; i < column.size(); ++i) {
        if (numbers.isKept(static_cast<std::uint32_t>(i)))
            kept.append(column[i]);
    }
    kept.squeeze();
    return kept;
}

template <class T>
std::size_t sizeOf(const QList<T>& list)
{
    return static_cast<std::size_t>(list.size());
}

} // namespace

Renumbering::Renumbering(Tree tree, const Journal& journal, std::size_t first, const RowsOfDeltas& rows)
    : m_tree(std::move(tree)), m_rows(rows)
{
    Tree base = m_tree;
    for (std::size_t i = journal.size(); i-- > first;)
        base.revertDropping(*journal[i]);
    const KeptValues& kept = base.content().kept;
    m_internodes = NewNumbers(base.size());
    m_leaves = NewNumbers(base.placedLeaves().size());
    m_parameters = NewNumbers(sizeOf(kept.parameters));
    m_lassos = NewNumbers(sizeOf(kept.lassos));
    m_profiles = NewNumbers(sizeOf(kept.profiles));
    keepWhatLives(base);
}

void Renumbering::keepWhatLives(const Tree& base)
{
    for (InternodeId id = 0; id < base.size(); ++id) {
        if (base.isAlive(id))
            m_internodes.keep(id);
    }
    const LeafColumns& leaves = base.placedLeaves();
    for (LeafId leaf = 0; leaf < leaves.size(); ++leaf) {
        if (leaves.death[leaf] == kNever && base.isAlive(leaves.internode[leaf]))
            m_leaves.keep(leaf);
    }
    m_parameters.keep(base.currentParameterSet());
    for (const std::uint32_t index : base.lassoIndicesInForce())
        m_lassos.keep(index);
}

std::shared_ptr<TreeDelta> Renumbering::copyOf(const std::shared_ptr<TreeDelta>& delta)
{
    std::shared_ptr<TreeDelta>& copy = m_copies[delta.get()];
    if (copy)
        return copy;
    // All but the rows, which belong to the document's thread.
    copy = std::make_shared<TreeDelta>(TreeDelta{.stepBefore = delta->stepBefore,
                                                 .stepAfter = delta->stepAfter,
                                                 .parametersBefore = delta->parametersBefore,
                                                 .parametersAfter = delta->parametersAfter,
                                                 .born = delta->born,
                                                 .bornLeaves = delta->bornLeaves,
                                                 .kept = delta->kept,
                                                 .died = delta->died,
                                                 .internodes = delta->internodes,
                                                 .leaves = delta->leaves,
                                                 .sparse = delta->sparse,
                                                 .lassos = delta->lassos,
                                                 .rows = nullptr,
                                                 .record = delta->record});
    if (const auto rows = m_rows.find(delta.get()); rows != m_rows.end())
        copy->rows = std::make_shared<TreeRows>(*rows->second);
    return copy;
}

Result<void> Renumbering::finish()
{
    keepWhatCopiesName();
    keepWhatRowsName();
    giveNumbers();

    const Renumber renumber{m_internodes, m_leaves, m_parameters, m_lassos, m_profiles};
    for (const auto& [delta, copy] : m_copies) {
        forEachNumber(*copy, renumber);
        copy->born.first = m_internodes[copy->born.first];
        copy->bornLeaves.first = m_leaves[copy->bornLeaves.first];
        if (copy->rows) {
            renumberColumn(copy->rows->internodes.parent, m_internodes);
            renumberColumn(copy->rows->internodes.parameterSet, m_parameters);
            renumberColumn(copy->rows->leaves.internode, m_internodes);
        }
    }
    return renumberTree();
}

void Renumbering::keepWhatCopiesName()
{
    const Keep keep{m_internodes, m_leaves, m_parameters, m_lassos, m_profiles};
    for (const auto& [delta, copy] : m_copies) {
        forEachNumber(*copy, keep);
        if (!copy->rows)
            continue;
        for (const InternodeId parent : std::as_const(copy->rows->internodes.parent))
            m_internodes.keep(parent);
        for (const std::uint16_t set : std::as_const(copy->rows->internodes.parameterSet))
            m_parameters.keep(set);
        for (const InternodeId id : std::as_const(copy->rows->leaves.internode))
            m_internodes.keep(id);
    }
}

void Renumbering::keepWhatRowsName()
{
    const TreeContent& content = m_tree.content();
    const LeafColumns& leaves = content.leaves;
    for (LeafId leaf = 0; leaf < leaves.size(); ++leaf) {
        if (m_leaves.isKept(leaf))
            m_internodes.keep(leaves.internode[leaf]);
    }
    // A parent comes before its children.
    const InternodeColumns& internodes = content.internodes;
    for (InternodeId id = m_tree.size(); id-- > 0;) {
        if (!m_internodes.isKept(id))
            continue;
        m_internodes.keep(internodes.parent[id]);
        m_parameters.keep(internodes.parameterSet[id]);
    }
    for (const auto& cell : content.sparse.profile.cells()) {
        if (m_internodes.isKept(cell.id))
            m_profiles.keep(cell.value);
    }
}

void Renumbering::giveNumbers()
{
    for (NewNumbers* numbers : {&m_internodes, &m_leaves, &m_parameters, &m_lassos, &m_profiles})
        numbers->number();
}

Result<void> Renumbering::renumberTree()
{
    TreeContent content = m_tree.content();
    InternodeTable::visit([this](const auto&, auto& column) { column = keptOf(column, m_internodes); },
                          content.internodes);
    LeafTable::visit([this](const auto&, auto& column) { column = keptOf(column, m_leaves); },
                     content.leaves);
    renumberColumn(content.internodes.parent, m_internodes);
    renumberColumn(content.internodes.parameterSet, m_parameters);
    renumberColumn(content.leaves.internode, m_internodes);
    SparseTable::visit(
        [this]<class T>(const auto&, SparseColumn<T>& column) {
            std::vector<SparseCell<T>> cells;
            for (const SparseCell<T>& cell : column.cells()) {
                if (m_internodes.isKept(cell.id))
                    cells.push_back({m_internodes[cell.id], cell.value});
            }
            column = SparseColumn<T>::fromCells(std::move(cells));
        },
        content.sparse);
    SparseColumn<std::uint32_t> profiles;
    for (const auto& cell : content.sparse.profile.cells())
        profiles.set(cell.id, m_profiles[cell.value]);
    content.sparse.profile = std::move(profiles);
    content.kept.parameters = keptOf(content.kept.parameters, m_parameters);
    content.kept.lassos = keptOf(content.kept.lassos, m_lassos);
    content.kept.profiles = keptOf(content.kept.profiles, m_profiles);
    content.currentParameters = m_parameters[content.currentParameters];
    for (std::uint32_t& index : content.lassosInForce)
        index = m_lassos[index];
    Result<Tree> tree = Tree::fromContent(std::move(content));
    if (!tree)
        return tree.error();
    m_tree = std::move(*tree);
    return {};
}

} // namespace espalier
