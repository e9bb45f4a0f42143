// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/InvigorateGesture.h"

#include "commands/recipe/InvigorateOperation.h"
#include "model/growth/VigourStep.h"

#include <QCoreApplication>

#include <algorithm>

namespace espalier {

namespace {

constexpr double kVigourStepsPerSecond = 15.0;
/// Years of vigour: what a step adds, and what the subtree uses of it.
constexpr double kAddedInStep = 0.15;
constexpr double kUsedInStep = 0.1;

} // namespace

InvigorateGesture::InvigorateGesture(TreeDocument& document, InternodeId branch)
    : HoldGesture(document, branch, kVigourStepsPerSecond,
                  QCoreApplication::translate("Commands", "Invigorate"))
{
}

TreeDelta InvigorateGesture::step(const TreeDocument& document)
{
    const Tree& tree = document.tree();
    const double has = tree.content().sparse.addedVigour.at(branch()).value_or(0.0F);
    const double added = std::min(kAddedInStep, kMostAddedVigour - has);
    return invigorate(tree, document.index(), document.growthModel().space(), branch(), added, kUsedInStep,
                      m_workspace);
}

RecipeOperation InvigorateGesture::operation() const
{
    return InvigorateOperation{reference(), seconds()};
}

} // namespace espalier
