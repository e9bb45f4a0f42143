// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/MoveBranch.h"

#include "commands/RecordedEdit.h"
#include "commands/recipe/RecipeJson.h"

#include <QCoreApplication>

namespace espalier {

MoveGesture::MoveGesture(TreeDocument& document) : m_edit(document, [this] { finish(); }) {}

Result<void> MoveGesture::set(const BranchMove& wanted)
{
    if (!m_edit.isActive())
        return {};
    // A recipe does not keep the sign of zeros, so the tree must not depend on it.
    BranchMove move = wanted;
    move.rotation.coeffs() = withoutNegativeZeros<4>(move.rotation.coeffs());
    move.place.along = move.place.along == 0.0F ? 0.0F : move.place.along;
    const TreeDocument& document = m_edit.document();
    m_edit.takeBack();
    m_branch.reset();
    Result<TreeDelta> delta = moved(document.tree(), document.index(), move);
    if (!delta)
        return delta.error();
    if (delta->isEmpty())
        return {};
    m_operation = MoveBranchOperation::of(document, move);
    m_branch = movedBranch(*delta);
    m_edit.apply(std::move(*delta));
    return {};
}

void MoveGesture::finish()
{
    commitRecorded(m_edit, QCoreApplication::translate("Commands", "Move Branch"),
                   [this] { return m_operation; });
}

Result<void> moveBranch(TreeDocument& document, const BranchMove& move)
{
    MoveGesture gesture(document);
    const Result<void> done = gesture.set(move);
    gesture.finish();
    return done;
}

} // namespace espalier
