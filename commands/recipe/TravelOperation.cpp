// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/TravelOperation.h"

#include "commands/TimeGesture.h"
#include "commands/recipe/RecipeText.h"

namespace espalier {

namespace {

constexpr QLatin1StringView kByKey("by");

} // namespace

TravelOperation TravelOperation::read(JsonReader& reader, RecipeReading&)
{
    const auto by = reader.integer(kByKey, -kFarthest, kFarthest);
    if (by == 0)
        reader.fail(kByKey, RecipeText::tr("a number other than 0 is expected"));
    return {static_cast<int>(by)};
}

QJsonObject TravelOperation::write(RecipeWriting&) const
{
    return {{kByKey, by}};
}

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
    return by < 0 ? RecipeText::tr("the history goes back by %1 only, not by %2").arg(here).arg(-by)
                  : RecipeText::tr("the history goes on by %1 only, not by %2").arg(end - here).arg(by);
}

} // namespace espalier
