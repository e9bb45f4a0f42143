// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/ParameterGesture.h"

#include "commands/DeltaCommand.h"

namespace espalier {

/// Lets its gesture know when the undo stack drops it, and can leave the stack on being undone.
class ParameterGesture::TrialCommand : public DeltaCommand {
public:
    using DeltaCommand::DeltaCommand;

    void undo() override
    {
        DeltaCommand::undo();
        setObsolete(m_isTakenBack);
    }

    /// It stays itself, so that the next trial can replace it.
    int id() const override { return -1; }
    std::weak_ptr<TrialCommand*> handle() const { return m_self; }
    void takeBack() { m_isTakenBack = true; }

private:
    std::shared_ptr<TrialCommand*> m_self = std::make_shared<TrialCommand*>(this);
    bool m_isTakenBack = false;
};

void ParameterGesture::tryOut(const TreeParameters& parameters, const QString& text)
{
    if (parameters == m_document.parameters())
        return;
    takeBack();
    if (parameters == m_document.parameters())
        return;

    const auto known = m_document.tree().parameterSets().size();
    auto delta = std::make_shared<TreeDelta>(TreeDelta::startingAt(m_document.tree()));
    delta->parametersAfter = m_document.rememberParameters(parameters);
    m_remembered = m_document.tree().parameterSets().size() > known;
    m_document.apply(delta);
    auto* command = new TrialCommand(m_document, text, {std::move(delta)});
    m_command = command->handle();
    m_document.undoStack().push(command);
}

void ParameterGesture::takeBack()
{
    const auto command = m_command.lock();
    m_command.reset();
    QUndoStack& stack = m_document.undoStack();
    if (!command || stack.index() == 0 || stack.command(stack.index() - 1) != *command)
        return;
    (*command)->takeBack();
    stack.undo();
    if (m_remembered)
        m_document.forgetLastParameters();
}

} // namespace espalier
