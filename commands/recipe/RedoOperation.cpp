// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/RedoOperation.h"

#include "commands/recipe/RecipeText.h"

namespace espalier {

namespace {

constexpr QLatin1StringView kRedoCountKey("count");

} // namespace

RedoOperation RedoOperation::read(JsonReader& reader, RecipeReading&)
{
    return {static_cast<int>(reader.integer(kRedoCountKey, 1, kMostCount, 1))};
}

QJsonObject RedoOperation::write(RecipeWriting&) const
{
    return {{kRedoCountKey, count}};
}

QString RedoOperation::perform(TreeDocument& document) const
{
    for (int done = 0; done < count; ++done) {
        if (!document.undoStack().canRedo())
            return RecipeText::tr("there are only %1 commands to redo, not %2").arg(done).arg(count);
        document.redo();
    }
    return {};
}

} // namespace espalier
