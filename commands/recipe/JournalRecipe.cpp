// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/JournalRecipe.h"

#include "commands/recipe/RecipeText.h"
#include "commands/recipe/TravelOperation.h"
#include "model/tree/JournalEdit.h"

#include <QJsonDocument>

#include <algorithm>

namespace espalier {

namespace {

/// The number of runs of unknown steps that an error names.
constexpr std::size_t kRunsNamed = 3;

/// Whether the operation of the edit that begins with @p delta is known.
bool isKnown(const TreeDelta& delta)
{
    return delta.record && !delta.record->operation.isEmpty();
}

/// The steps without a known operation; consecutive ones are joined.
std::vector<JournalEdit> unknownSteps(const Journal& journal)
{
    std::vector<JournalEdit> unknown;
    for (std::size_t i = 0; i < journal.size();) {
        const JournalEdit edit = JournalEdit::at(journal, i);
        i = edit.end;
        if (isKnown(*journal[edit.first]))
            continue;
        if (!unknown.empty() && unknown.back().end == edit.first)
            unknown.back().end = edit.end;
        else
            unknown.push_back(edit);
    }
    return unknown;
}

Error notKnown(const std::vector<JournalEdit>& unknown, std::size_t steps)
{
    std::size_t count = 0;
    QStringList runs;
    for (const JournalEdit& run : unknown) {
        count += run.end - run.first;
        if (runs.size() < static_cast<qsizetype>(kRunsNamed)) {
            runs.append(run.end == run.first + 1 ? QString::number(run.end)
                                                 : QStringLiteral("%1–%2").arg(run.first + 1).arg(run.end));
        }
    }
    if (unknown.size() > kRunsNamed)
        runs.append(QStringLiteral("…"));
    return inputError(
        {},
        RecipeText::tr("the tree's history cannot become a recipe: of its %1 steps, %2 (%3) were made by a "
                       "version of Espalier that did not record how")
            .arg(steps)
            .arg(count)
            .arg(runs.join(QLatin1String(", "))));
}

/// Adds travels by @p deltas in total; one travel has a limit.
void addTravel(Recipe& recipe, std::int64_t deltas)
{
    while (deltas != 0) {
        const auto by =
            std::clamp<std::int64_t>(deltas, -TravelOperation::kFarthest, TravelOperation::kFarthest);
        recipe.operations.emplace_back(TravelOperation{static_cast<int>(by)});
        deltas -= by;
    }
}

/// A recipe begins with a seedling as it is sown. A tree that was imported does not, nor does one whose
/// oldest steps were dropped.
bool beginsWithASeedling(const Project& project)
{
    Tree first = project.tree;
    for (auto i = project.journal.rbegin(); i != project.journal.rend(); ++i)
        first.revertDropping(**i);
    return first == Tree(first.seed(), first.parameters());
}

} // namespace

Result<Recipe> recipeOf(const Project& project)
{
    const Journal& journal = project.journal;
    const QList<TreeParameters>& sets = project.tree.parameterSets();
    if (const std::vector<JournalEdit> unknown = unknownSteps(journal); !unknown.empty())
        return notKnown(unknown, journal.size());
    if (!beginsWithASeedling(project))
        return inputError(
            {}, RecipeText::tr(
                    "the tree's history cannot become a recipe: it does not begin with a seedling, because "
                    "the tree was imported or its oldest steps were dropped"));

    Recipe recipe;
    recipe.name = project.name;
    recipe.seed = project.tree.seed();
    recipe.parameters = journal.empty() ? project.tree.parameters() : sets[journal.front()->parametersBefore];
    RecipeReading reading({});
    for (std::size_t i = 0; i < journal.size();) {
        const JournalEdit edit = JournalEdit::at(journal, i);
        const TreeDelta& first = *journal[edit.first];
        // If an edit changes parameters, its first delta does.
        reading.setParameters(sets[first.parametersAfter]);
        Result<RecipeOperation> operation =
            readOperation(QJsonDocument::fromJson(first.record->operation).object(),
                          RecipeText::tr("step %1 of the history").arg(i + 1), reading);
        if (!operation)
            return operation.error();
        recipe.operations.push_back(std::move(*operation));
        const std::size_t stands = edit.end - edit.first;
        if (stands < first.record->deltas)
            addTravel(recipe, -static_cast<std::int64_t>(first.record->deltas - stands));
        i = edit.end;
    }
    addTravel(recipe, -std::int64_t{project.ahead});
    return recipe;
}

} // namespace espalier
