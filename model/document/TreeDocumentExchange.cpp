// SPDX-License-Identifier: GPL-3.0-or-later
// The part of TreeDocument that makes an undo step of another tree.
#include "model/document/EditCommand.h"
#include "model/document/PreparedTree.h"
#include "model/document/TreeDocument.h"

namespace espalier {

void TreeDocument::exchange(PreparedTree prepared, const QString& text)
{
    interruptEdit();
    EditCommand::Content content;
    content.other = std::make_shared<PreparedTree>(std::move(prepared));
    swapWith(*content.other);
    m_undoStack.push(new EditCommand(*this, text, std::move(content)));
}

} // namespace espalier
