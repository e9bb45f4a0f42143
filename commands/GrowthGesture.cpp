// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/GrowthGesture.h"

#include "commands/DeltaCommand.h"

namespace espalier {

GrowthGesture::GrowthGesture(TreeDocument& document, QString text, std::unique_ptr<GrowthProcess> process,
                             Journal replaced, Journal first, std::uint32_t lassosBefore)
    : m_document(document),
      m_text(std::move(text)),
      m_process(std::move(process)),
      m_markers(m_process->markers().begin(), m_process->markers().end()),
      m_replaced(std::move(replaced)),
      m_deltas(std::move(first)),
      m_lassosBefore(lassosBefore)
{
}

GrowthGesture::~GrowthGesture()
{
    cancel();
}

bool GrowthGesture::step()
{
    if (m_ended || !m_process)
        return false;
    TreeDelta delta = m_process->step(m_document.tree(), m_document.index(), m_document.growthIndex());
    return add({std::move(delta), {m_process->markers().begin(), m_process->markers().end()}});
}

bool GrowthGesture::add(GrownStep grown)
{
    if (m_ended)
        return false;
    m_markers = std::move(grown.markers);
    if (grown.delta.isEmpty())
        return false;
    m_deltas.push_back(std::make_shared<TreeDelta>(std::move(grown.delta)));
    ++m_stepCount;
    m_document.apply(m_deltas.back());
    return true;
}

void GrowthGesture::finish()
{
    if (std::exchange(m_ended, true) || m_deltas.empty())
        return;
    m_document.undoStack().push(
        new DeltaCommand(m_document, m_text, std::move(m_deltas), std::move(m_replaced)));
}

void GrowthGesture::cancel()
{
    if (std::exchange(m_ended, true))
        return;
    revertAll(m_document, m_deltas);
    applyAll(m_document, m_replaced);
    m_deltas.clear();
    m_replaced.clear();
    m_document.forgetLassosFrom(m_lassosBefore);
}

} // namespace espalier
