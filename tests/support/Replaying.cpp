// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/Replaying.h"

#include "commands/DocumentProject.h"
#include "commands/recipe/JournalRecipe.h"
#include "commands/recipe/RecipePlayer.h"
#include "tests/support/Documents.h"

namespace espalier::test {

QString replayFault(const TreeDocument& document)
{
    const Project project = projectOf(document, QStringLiteral("Tree"));
    const Result<Recipe> recipe = recipeOf(project);
    if (!recipe)
        return recipe.error().message;
    const Result<Recipe> read = parseRecipe(writeRecipe(*recipe));
    if (!read)
        return QStringLiteral("the recipe cannot be read: ") + read.error().message;
    if (!(*read == *recipe))
        return QStringLiteral("the recipe is another one when it has been written and read");

    TreeDocument again;
    RecipePlayer player(again, *read);
    player.playAll();
    if (!player.warnings().isEmpty())
        return player.warnings().join(QLatin1Char('\n'));
    DocumentState wanted(document);
    wanted.undoIndex = again.undoStack().index();
    if (const QString difference = differenceFrom(wanted, again); !difference.isEmpty())
        return difference;
    const Result<QByteArray> file = packProject(project);
    const Result<QByteArray> fileAgain = packProject(projectOf(again, QStringLiteral("Tree")));
    if (!file || !fileAgain)
        return QStringLiteral("a project cannot be packed");
    return *file == *fileAgain ? QString() : QStringLiteral("the project file");
}

} // namespace espalier::test
