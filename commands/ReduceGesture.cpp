// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/ReduceGesture.h"

#include "commands/recipe/ReduceOperation.h"
#include "model/shape/Reduction.h"

#include <QCoreApplication>

namespace espalier {

namespace {

constexpr double kReductionsPerSecond = 10.0;

} // namespace

ReduceGesture::ReduceGesture(TreeDocument& document, InternodeId branch)
    : HoldGesture(document, branch, kReductionsPerSecond, QCoreApplication::translate("Commands", "Reduce"))
{
}

TreeDelta ReduceGesture::step(const TreeDocument& document)
{
    return reduceBranch(document.tree(), document.index(), branch());
}

RecipeOperation ReduceGesture::operation() const
{
    return ReduceOperation{reference(), seconds()};
}

} // namespace espalier
