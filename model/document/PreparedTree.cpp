// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/document/PreparedTree.h"

#include "model/growth/NamedModel.h"

namespace espalier {

PreparedTree::PreparedTree(Tree whole, Journal history, std::size_t ahead)
    : tree(std::move(whole)), journal(std::move(history)), growthModel(std::make_unique<NamedModel>())
{
    for (; ahead > 0; --ahead) {
        tree.revert(*journal.back());
        future.push_back(std::move(journal.back()));
        journal.pop_back();
    }
    index.rebuild(tree);
    growthModel->rebuild(tree, index);
}

} // namespace espalier
