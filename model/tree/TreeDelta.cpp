// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/tree/TreeDelta.h"

namespace espalier {

const std::shared_ptr<const EditRecord>& EditRecord::unknown()
{
    static const auto record = std::make_shared<const EditRecord>();
    return record;
}

void TreeDelta::addFrame(InternodeId id, const Rotation& before, const Rotation& after, float lengthBefore,
                         float lengthAfter)
{
    if (before != after)
        internodes.rotation.push_back({id, before, after});
    if (lengthBefore != lengthAfter)
        internodes.length.push_back({id, lengthBefore, lengthAfter});
}

void TreeDelta::squeeze()
{
    died.shrink_to_fit();
    lassos.shrink_to_fit();
    const auto squeeze = [](const auto&, auto& changes) { changes.squeeze(); };
    InternodeTable::visit(squeeze, internodes);
    LeafTable::visit(squeeze, leaves);
    SparseTable::visit(squeeze, sparse);
}

bool TreeDelta::isEmpty() const
{
    bool isEmpty = stepBefore == stepAfter && parametersBefore == parametersAfter && !bringsRows() &&
                   died.empty() && lassos.empty();
    const auto look = [&isEmpty](const auto&, const auto& changes) { isEmpty = isEmpty && changes.empty(); };
    InternodeTable::visit(look, internodes);
    LeafTable::visit(look, leaves);
    SparseTable::visit(look, sparse);
    return isEmpty;
}

std::size_t TreeDelta::bytes() const
{
    std::size_t sum =
        sizeof(*this) + died.capacity() * sizeof(InternodeId) + lassos.capacity() * sizeof(LassoChange);
    const auto add = [&sum](const auto&, const auto& changes) { sum += changes.bytes(); };
    InternodeTable::visit(add, internodes);
    LeafTable::visit(add, leaves);
    SparseTable::visit(add, sparse);
    if (record)
        sum += sizeof(*record) + static_cast<std::size_t>(record->operation.capacity());
    return sum;
}

bool TreeDelta::operator==(const TreeDelta& other) const
{
    bool isEqual = stepBefore == other.stepBefore && stepAfter == other.stepAfter &&
                   parametersBefore == other.parametersBefore && parametersAfter == other.parametersAfter &&
                   born == other.born && bornLeaves == other.bornLeaves && kept == other.kept &&
                   died == other.died && lassos == other.lassos &&
                   (record == other.record || (record && other.record && *record == *other.record));
    const auto compare = [&isEqual](const auto&, const auto& a, const auto& b) {
        isEqual = isEqual && a == b;
    };
    InternodeTable::visit(compare, internodes, other.internodes);
    LeafTable::visit(compare, leaves, other.leaves);
    SparseTable::visit(compare, sparse, other.sparse);
    return isEqual;
}

} // namespace espalier
