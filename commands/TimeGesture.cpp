// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/TimeGesture.h"

#include "commands/EditTitle.h"
#include "commands/RecordedEdit.h"
#include "commands/recipe/GrowOperation.h"

#include <QCoreApplication>

#include <algorithm>

namespace espalier {

TimeGesture::TimeGesture(TreeDocument& document, Edit::Interrupted interrupted)
    : m_edit(document, interrupted ? std::move(interrupted) : Edit::Interrupted([this] { finish(); })),
      m_historyLength(document.journal().size() + document.future().size())
{
}

void TimeGesture::moveTo(std::size_t position)
{
    if (!m_edit.isActive())
        return;
    const TreeDocument& document = m_edit.document();
    while (m_edit.deltaCount() > 0 && document.journal().size() > position)
        m_edit.takeBackLast();
    if (m_edit.deltaCount() == 0)
        m_edit.travelTo(std::min(position, m_historyLength));
    while (document.journal().size() < position && grow()) {
    }
}

bool TimeGesture::grow()
{
    const TreeDocument& document = m_edit.document();
    // The document's competitors at the first step apply to all steps, as in a GrowGesture.
    if (m_edit.deltaCount() == 0) {
        m_competitors = document.competitors();
        m_only = BudReference::to(document, m_competitors);
    }
    GrowthStepOptions options = GrowthStepOptions::of(document.parameters().growth);
    options.competitors = m_competitors;
    TreeDelta delta =
        document.growthModel().growFreely(document.tree(), document.index(), options, m_workspace);
    if (delta.isEmpty())
        return false;
    m_edit.apply(std::move(delta));
    return true;
}

void TimeGesture::finish()
{
    const auto steps = static_cast<int>(m_edit.deltaCount());
    commitRecorded(m_edit, titleOfGrowth(steps), [&] { return GrowOperation{steps, m_only}; });
}

} // namespace espalier
