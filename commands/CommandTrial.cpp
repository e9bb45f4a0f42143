// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/CommandTrial.h"

#include "model/document/Edit.h"

#include <memory>

namespace espalier {

Result<void> CommandTrial::tryWith(const std::function<Result<void>(Edit&)>& perform)
{
    const std::unique_ptr<Edit> edit =
        isLast() ? Edit::resumed(m_document) : std::make_unique<Edit>(m_document);
    m_revision.reset();
    edit->takeBack();
    Result<void> performed = perform(*edit);
    if (performed)
        m_revision = m_document.revision();
    return performed;
}

} // namespace espalier
