// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/TimeGesture.h"
#include "commands/recipe/RecipeText.h"
#include "commands/recipe/TravelOperation.h"

#include <algorithm>

namespace espalier {

QString TravelOperation::perform(TreeDocument& document) const
{
    TimeGesture gesture(document);
    const auto here = static_cast<std::int64_t>(document.journal().size());
    const auto end = static_cast<std::int64_t>(gesture.historyLength());
    const std::int64_t there = std::clamp(here + by, std::int64_t{0}, end);
    gesture.moveTo(static_cast<std::size_t>(there));
    gesture.finish();
    if (there == here + by)
        return {};
    return by < 0 ? RecipeText::tr("the history goes back only by %1, not by %2").arg(here).arg(-by)
                  : RecipeText::tr("the history goes on only by %1, not by %2").arg(end - here).arg(by);
}

} // namespace espalier
