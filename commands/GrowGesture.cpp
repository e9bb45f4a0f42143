// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/GrowGesture.h"

#include "commands/DeltaCommand.h"

#include <QCoreApplication>

namespace espalier {

GrowGesture::GrowGesture(TreeDocument& document, Competitors competitors)
    : m_document(document), m_competitors(competitors)
{
}

GrowGesture::~GrowGesture()
{
    cancel();
}

bool GrowGesture::step()
{
    if (m_ended)
        return false;
    GrowthStepOptions options = GrowthStepOptions::of(m_document.parameters().growth);
    options.competitors = m_competitors;
    TreeDelta delta =
        autonomousStep(m_document.tree(), m_document.index(), m_document.growthIndex(), options, m_workspace);
    if (delta.isEmpty())
        return false;
    m_deltas.push_back(std::make_shared<TreeDelta>(std::move(delta)));
    m_document.apply(m_deltas.back());
    return true;
}

void GrowGesture::finish()
{
    if (std::exchange(m_ended, true) || m_deltas.empty())
        return;
    m_document.undoStack().push(
        new DeltaCommand(m_document, QCoreApplication::translate("Commands", "Grow"), std::move(m_deltas)));
}

void GrowGesture::cancel()
{
    if (std::exchange(m_ended, true))
        return;
    for (std::size_t i = 0; i < m_deltas.size(); ++i)
        m_document.revertLast();
    m_deltas.clear();
}

} // namespace espalier
