// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/tools/PruneTool.h"

#include "views/tools/ClearTool.h"
#include "views/tools/CutTool.h"
#include "views/tools/EraserTool.h"

namespace espalier {

PruneTool::PruneTool(ToolContext& context)
    : Tool(context),
      m_cut(std::make_unique<CutTool>(context)),
      m_clear(std::make_unique<ClearTool>(context)),
      m_eraser(std::make_unique<EraserTool>(context))
{
}

Tool& PruneTool::ofMode() const
{
    switch (context().viewSettings().values().pruneMode) {
    case PruneMode::KeepClear:
        return *m_clear;
    case PruneMode::Erase:
    case PruneMode::Thin:
        return *m_eraser;
    case PruneMode::Cut:
        break;
    }
    return *m_cut;
}

void PruneTool::begin(const PointerSample& sample)
{
    m_held = &hand();
    m_held->begin(sample);
}

void PruneTool::end(const PointerSample& sample)
{
    hand().end(sample);
    m_held = nullptr;
}

void PruneTool::finish()
{
    hand().finish();
    m_held = nullptr;
}

void PruneTool::cancel()
{
    hand().cancel();
    m_held = nullptr;
}

void PruneTool::leave()
{
    for (Tool* tool : {m_cut.get(), m_clear.get(), m_eraser.get()})
        tool->leave();
}

} // namespace espalier
