// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/document/NewNumbers.h"

namespace espalier {

void NewNumbers::number()
{
    std::uint32_t next = 0;
    for (std::uint32_t& number : m_numbers) {
        if (number != kGone)
            number = next++;
    }
    m_gone = count() - next;
}

} // namespace espalier
