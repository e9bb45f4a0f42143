// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/UndoOperation.h"

#include "commands/recipe/RecipeText.h"

namespace espalier {

namespace {

constexpr QLatin1StringView kCountKey("count");

} // namespace

UndoOperation UndoOperation::read(JsonReader& reader, RecipeReading&)
{
    return {static_cast<int>(reader.integer(kCountKey, 1, kMostCount, 1))};
}

QJsonObject UndoOperation::write(RecipeWriting&) const
{
    return {{kCountKey, count}};
}

QString UndoOperation::perform(TreeDocument& document) const
{
    for (int done = 0; done < count; ++done) {
        if (!document.undoStack().canUndo())
            return RecipeText::tr("there are only %1 commands to undo, not %2").arg(done).arg(count);
        document.undo();
    }
    return {};
}

} // namespace espalier
