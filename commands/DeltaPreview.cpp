// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/DeltaPreview.h"

#include "commands/DeltaCommand.h"

namespace espalier {

void DeltaPreview::show(TreeDelta delta)
{
    if (m_ended)
        return;
    takeBack();
    if (delta.isEmpty())
        return;
    m_delta = std::make_shared<TreeDelta>(std::move(delta));
    m_document.apply(m_delta);
}

void DeltaPreview::finish(const QString& text)
{
    if (std::exchange(m_ended, true) || !m_delta)
        return;
    m_document.undoStack().push(new DeltaCommand(m_document, text, {std::move(m_delta)}));
}

void DeltaPreview::cancel()
{
    if (!std::exchange(m_ended, true))
        takeBack();
}

void DeltaPreview::takeBack()
{
    if (std::exchange(m_delta, nullptr))
        m_document.revertLast();
}

} // namespace espalier
