// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/RedoOperation.h"

#include <QCoreApplication>

namespace espalier {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Recipe)
};

constexpr QLatin1StringView kCountKey("count");

} // namespace

RedoOperation RedoOperation::read(JsonReader& reader, RecipeReading&)
{
    return {static_cast<int>(reader.integer(kCountKey, 1, kMostCount, 1))};
}

QJsonObject RedoOperation::write(RecipeWriting&) const
{
    return {{kCountKey, count}};
}

QString RedoOperation::perform(TreeDocument& document) const
{
    QUndoStack& stack = document.undoStack();
    for (int done = 0; done < count; ++done) {
        if (!stack.canRedo())
            return Text::tr("there are %1 commands to redo only, not %2").arg(done).arg(count);
        stack.redo();
    }
    return {};
}

} // namespace espalier
