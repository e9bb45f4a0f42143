// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/tools/GrowTool.h"

namespace espalier {

void GrowTool::begin(const PointerSample&)
{
    if (m_growth.isRunning())
        return;
    m_holds = true;
    m_growth.begin();
}

void GrowTool::end(const PointerSample&)
{
    if (std::exchange(m_holds, false))
        m_growth.release();
}

void GrowTool::finish()
{
    if (std::exchange(m_holds, false))
        m_growth.end();
}

void GrowTool::cancel()
{
    if (std::exchange(m_holds, false))
        m_growth.cancel();
}

} // namespace espalier
