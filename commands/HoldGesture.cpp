// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/HoldGesture.h"

#include "commands/RecordedEdit.h"
#include "commands/recipe/HeldTime.h"

#include <algorithm>
#include <cmath>

namespace espalier {

HoldGesture::HoldGesture(TreeDocument& document, InternodeId branch, double stepsPerSecond, QString text)
    : m_edit(document, [this] { finish(); }),
      m_branch(branch),
      m_reference(InternodeReference::to(document, branch)),
      m_stepsPerSecond(stepsPerSecond),
      m_text(std::move(text))
{
}

void HoldGesture::holdTo(double seconds)
{
    // A recipe's time is written as a decimal number.
    const double steps = std::floor(std::min(seconds, kMostHeldSeconds) * m_stepsPerSecond + 1e-6);
    while (m_edit.isActive() && m_steps < steps)
        makeStep();
}

void HoldGesture::makeStep()
{
    ++m_steps;
    TreeDelta delta = step(m_edit.document());
    m_changes += delta.isEmpty() ? 0 : 1;
    m_edit.apply(std::move(delta));
}

void HoldGesture::finish()
{
    if (m_edit.isActive() && m_steps == 0)
        makeStep();
    commitRecorded(m_edit, m_text, [this] { return operation(); });
}

} // namespace espalier
