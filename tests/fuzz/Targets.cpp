// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/Targets.h"

#include "commands/DocumentProject.h"
#include "commands/DrawSketch.h"
#include "commands/recipe/JournalRecipe.h"
#include "commands/recipe/Recipe.h"
#include "model/document/Edit.h"
#include "model/document/TreeDocument.h"
#include "model/io/ImageFile.h"
#include "model/io/import/DrawingFile.h"
#include "model/io/import/Skeleton.h"
#include "model/io/project/HistoryChange.h"
#include "model/io/project/ProjectFile.h"
#include "model/texture/OwnTextures.h"
#include "tests/soak/Hand.h"
#include "tests/support/SampleProject.h"

#include <array>
#include <cstring>

namespace espalier::test {

namespace {

void expectSentence(const Error& error)
{
    if (error.message.isEmpty())
        qFatal("an error without a word");
}

/// All that a user can do with the history, through the document and all its indices; then it is saved and
/// read again.
void useProject(const Project& project)
{
    TreeDocument document;
    document.reset(project.tree, project.journal);
    Edit edit(document);
    edit.travelTo(0);
    edit.travelTo(project.journal.size());
    edit.cancel();
    if (!(document.tree() == project.tree))
        qFatal("the history does not lead back");
    if (const Result<Recipe> recipe = recipeOf(project); !recipe)
        expectSentence(recipe.error());
    const Result<QByteArray> packed = packProject(project);
    const Result<Project> again = packed ? unpackProject(*packed) : packed.error();
    if (!again || !(again->tree == project.tree) || !sameJournal(again->journal, project.journal))
        qFatal("what was opened cannot be saved: %s",
               again ? "it differs" : qPrintable(again.error().message));
}

void readProjectInput(const QByteArray& input)
{
    const Result<Project> project = unpackProject(input);
    if (project)
        useProject(*project);
    else
        expectSentence(project.error());
}

void readRecipeInput(const QByteArray& input)
{
    const Result<Recipe> recipe = parseRecipe(input);
    if (!recipe) {
        expectSentence(recipe.error());
        return;
    }
    const Result<Recipe> again = parseRecipe(writeRecipe(*recipe));
    if (!again || !(*again == *recipe))
        qFatal("a recipe is not what was written of it: %s",
               again ? "it differs" : qPrintable(again.error().message));
}

void readDrawingInput(const QByteArray& input)
{
    for (const bool isSvg : {true, false}) {
        if (const Result<DrawingStrokes> strokes = parseDrawing(input, isSvg, 0); !strokes)
            expectSentence(strokes.error());
    }
}

void readSkeletonInput(const QByteArray& input)
{
    if (const Result<Skeleton> skeleton = readSkeleton(input); !skeleton)
        expectSentence(skeleton.error());
}

void readImageInput(const QByteArray& input)
{
    const Result<ImageAsset> image = readImage(input, QStringLiteral("image"));
    if (!image) {
        expectSentence(image.error());
        return;
    }
    TreeParameters look;
    look.leaves.image = look.bark.image = *image;
    const SurfaceTextures leaf = leafTextures(look.leaves, 64);
    const SurfaceTextures bark = barkTextures(look.bark, 64);
    if (leaf.normal.size() != leaf.colour.size() || bark.normal.size() != bark.colour.size())
        qFatal("images of one material differ in size");
}

void readChangesInput(const QByteArray& input)
{
    static const Project base = sampleProject(25);
    Project copy = base;
    // The replay writes rows into the deltas.
    for (auto& delta : copy.journal)
        delta = std::make_shared<TreeDelta>(*delta);
    HistoryReplay replay(std::move(copy));
    if (const Result<void> added = replay.add(input); !added) {
        expectSentence(added.error());
        return;
    }
    const Result<Project> project = replay.finish();
    if (project)
        useProject(*project);
    else
        expectSentence(project.error());
}

void doOperations(const QByteArray& input)
{
    std::uint64_t seed = 0;
    std::memcpy(&seed, input.constData(),
                std::min<std::size_t>(sizeof seed, static_cast<std::size_t>(input.size())));
    const qsizetype operations = std::min<qsizetype>(input.size(), 24);
    RandomOperations random(seed, 120);
    TreeDocument document;
    document.reset(seed, random.parameters());
    for (qsizetype i = 0; i < operations; ++i)
        doByHand(document, random.next(document, document.undoStack().index()), random);
    useProject(projectOf(document, QStringLiteral("fuzz")));
}

constexpr std::array kTargets{
    FuzzTarget{"project", readProjectInput}, FuzzTarget{"recipe", readRecipeInput},
    FuzzTarget{"drawing", readDrawingInput}, FuzzTarget{"skeleton", readSkeletonInput},
    FuzzTarget{"image", readImageInput},     FuzzTarget{"changes", readChangesInput},
    FuzzTarget{"operations", doOperations},
};

} // namespace

std::span<const FuzzTarget> fuzzTargets()
{
    return kTargets;
}

const FuzzTarget* fuzzTarget(const QByteArray& name)
{
    const auto* target =
        std::ranges::find_if(kTargets, [&](const FuzzTarget& one) { return name == one.name; });
    return target == kTargets.end() ? nullptr : target;
}

} // namespace espalier::test
