// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/Replaying.h"

#include "commands/DocumentProject.h"
#include "commands/recipe/JournalRecipe.h"
#include "commands/recipe/RecipePlayer.h"
#include "tests/support/Documents.h"

#include <algorithm>

namespace espalier::test {

namespace {

/// Gives @p delta the step's name of @p other, if both begin an edit: a recipe does not have the names, and
/// an operation's may be another than the gesture's.
void takeStepName(TreeDelta& delta, const TreeDelta& other)
{
    if (!delta.record || !other.record)
        return;
    EditRecord record = *delta.record;
    record.step = other.record->step;
    delta.record = std::make_shared<const EditRecord>(std::move(record));
}

} // namespace

QString replayFault(const TreeDocument& document)
{
    Project project = projectOf(document, QStringLiteral("Tree"));
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
    const Project projectAgain = projectOf(again, QStringLiteral("Tree"));
    for (std::size_t i = 0; i < std::min(project.journal.size(), projectAgain.journal.size()); ++i) {
        auto named = std::make_shared<TreeDelta>(*project.journal[i]);
        takeStepName(*named, *projectAgain.journal[i]);
        if (i < wanted.journal.size())
            wanted.journal[i].record = named->record;
        else
            wanted.future[project.journal.size() - 1 - i].record = named->record;
        project.journal[i] = std::move(named);
    }
    if (const QString difference = differenceFrom(wanted, again); !difference.isEmpty())
        return difference;
    const Result<QByteArray> file = packProject(project);
    const Result<QByteArray> fileAgain = packProject(projectAgain);
    if (!file || !fileAgain)
        return QStringLiteral("a project cannot be packed");
    return *file == *fileAgain ? QString() : QStringLiteral("the project file");
}

} // namespace espalier::test
