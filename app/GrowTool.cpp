// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/GrowTool.h"

namespace espalier {

void GrowTool::begin(const PointerSample&)
{
    if (m_runner.isRunning())
        return;
    m_holds = true;
    m_runner.begin();
}

void GrowTool::end(const PointerSample&)
{
    if (std::exchange(m_holds, false))
        m_runner.release();
}

void GrowTool::cancel()
{
    if (std::exchange(m_holds, false))
        m_runner.cancel();
}

} // namespace espalier
