// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/GrowthGesture.h"

#include "commands/RecordedEdit.h"

namespace espalier {

GrowthGesture::GrowthGesture(TreeDocument& document, QString text, const std::function<void(Edit&)>& prepare)
    : m_text(std::move(text)),
      m_interrupted([this] { finish(); }),
      m_edit(std::make_unique<Edit>(document, [this] {
          const auto interrupted = m_interrupted; // a copy: the call may destroy the gesture
          interrupted();
      }))
{
    if (prepare)
        prepare(*m_edit);
}

void GrowthGesture::setProcess(std::unique_ptr<GrowthProcess> process)
{
    m_process = std::move(process);
    m_markers.assign(m_process->markers().begin(), m_process->markers().end());
}

bool GrowthGesture::step()
{
    if (!m_edit->isActive() || !m_process)
        return false;
    const TreeDocument& document = m_edit->document();
    TreeDelta delta = m_process->step(document.tree(), document.index(), document.growthModel());
    return add({std::move(delta), {m_process->markers().begin(), m_process->markers().end()}});
}

bool GrowthGesture::add(GrownStep grown)
{
    if (!m_edit->isActive())
        return false;
    m_markers = std::move(grown.markers);
    if (grown.delta.isEmpty()) {
        m_isExhausted = true;
        return false;
    }
    ++m_stepCount;
    m_edit->apply(std::move(grown.delta));
    return true;
}

void GrowthGesture::finish()
{
    commitRecorded(*m_edit, title(), [this] { return operation(); });
}

} // namespace espalier
