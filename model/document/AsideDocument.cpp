// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/document/AsideDocument.h"

namespace espalier {

std::vector<AsideDocument::Step> AsideDocument::stepsOf(const TreeDocument& document)
{
    const QUndoStack& stack = document.undoStack();
    std::vector<Step> steps;
    for (int i = 0; i < stack.count(); ++i) {
        const EditCommand& command = EditCommand::at(stack, i);
        steps.push_back({command.text(), command.content()});
    }
    return steps;
}

AsideDocument AsideDocument::takenFrom(TreeDocument& document)
{
    document.interruptEdit();
    QUndoStack& stack = document.m_undoStack;
    AsideDocument aside;
    aside.steps = stepsOf(document);
    aside.index = stack.index();
    aside.cleanIndex = stack.cleanIndex();
    aside.undoLimit = stack.undoLimit();
    // Its listeners look at the document, so it is cleared while the document is whole.
    stack.clear();
    PreparedTree& tree = aside.tree;
    tree.tree = std::move(document.m_tree);
    tree.journal = std::move(document.m_journal);
    tree.future = std::move(document.m_future);
    tree.index = std::move(document.m_index);
    tree.growthModel = std::move(document.m_growthModel);
    tree.pickIndex = std::move(document.m_pickIndex);
    tree.look = document.m_look;
    document.reset(1);
    return aside;
}

void AsideDocument::bringBackTo(TreeDocument& document)
{
    const SceneLook look = tree.look.value_or(SceneLook());
    document.replaceBy(std::move(tree));
    document.setLook(look);
    fillStack(document);
}

void AsideDocument::fillStack(TreeDocument& document)
{
    QUndoStack& stack = document.m_undoStack;
    stack.setUndoLimit(undoLimit);
    std::vector<EditCommand*> commands;
    for (Step& step : steps) {
        const auto state =
            static_cast<int>(commands.size()) < index ? EditCommand::State::Done : EditCommand::State::Undone;
        commands.push_back(new EditCommand(document, step.text, std::move(step.content), state));
        commands.back()->setAsleep(true);
        stack.push(commands.back());
    }
    if (cleanIndex >= 0) {
        stack.setIndex(cleanIndex);
        stack.setClean();
    } else {
        stack.resetClean();
    }
    stack.setIndex(index);
    for (EditCommand* command : commands)
        command->setAsleep(false);
}

} // namespace espalier
