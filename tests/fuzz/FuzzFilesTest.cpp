// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/JournalRecipe.h"
#include "model/base/Memory.h"
#include "model/document/Edit.h"
#include "model/document/TreeDocument.h"
#include "model/io/ImageFile.h"
#include "model/io/project/ProjectFile.h"
#include "model/texture/OwnTextures.h"
#include "tests/fuzz/Mutator.h"
#include "tests/support/AllOperations.h"
#include "tests/support/OwnImages.h"
#include "tests/support/SampleProject.h"
#include "tests/support/ZipEntries.h"

#include <QTest>

using namespace espalier;
using namespace espalier::test;

/// With the address sanitizer, an allocation of more than this ends the test.
extern "C" const char* __asan_default_options();
extern "C" const char* __asan_default_options()
{
    return "max_allocation_size_mb=1024:allocator_may_return_null=0";
}

/// Damaged files: each must give an error or a valid document, never a crash, a hang or unlimited memory.
class FuzzFilesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void damagedArchives();
    void damagedEntries();
    void damagedRecipes();
    void damagedImages();

private:
    /// Opens the bytes as a project and uses it. Returns whether they could be opened.
    bool tryProject(const QByteArray& content);

    std::vector<QByteArray> m_projects;
    std::vector<QByteArray> m_recipes;
};

void FuzzFilesTest::initTestCase()
{
    keepFreedMemory();
    Project withPicture = sampleProject(60);
    withPicture.thumbnail = QImage(8, 8, QImage::Format_RGB32);
    withPicture.thumbnail.fill(Qt::darkGreen);
    Project illustrated = sampleProject(12, 3);
    TreeParameters look = illustrated.tree.parameters();
    look.leaves.image = ImageAsset(pngOf(drawnLeaf(Qt::transparent)), QStringLiteral("leaf.png"));
    look.bark.image = look.bark.normalImage =
        ImageAsset(pngOf(repeatingBark(16, 16)), QStringLiteral("bark.png"));
    illustrated.journal.push_back(std::make_shared<TreeDelta>(parameterChange(illustrated.tree, look)));
    illustrated.tree.apply(*illustrated.journal.back());
    illustrated.journal.back()->record = std::make_shared<const EditRecord>(
        EditRecord{R"({"op":"brushStroke","samples":[[0,0,0,0,1],[1,0,2,0,1]]})", 1});
    illustrated.journal.front()->record =
        std::make_shared<const EditRecord>(EditRecord{R"({"op":"grow","steps":3})", 2});
    withPicture.look = SceneLook();
    withPicture.look->tracing.image = look.leaves.image;
    m_projects = {*packProject(withPicture), *packProject(sampleProject(25, 2)), *packProject({}),
                  *packProject(illustrated)};

    Recipe recipe;
    recipe.name = QStringLiteral("Fuzz");
    SetParametersOperation change;
    change.parameters.growth.apicalDominance = 0.45;
    change.parameters.leaves.shape = LeafShape::Lobed;
    recipe.operations = {
        BrushStrokeOperation{
            {{0.0, Vec3(0, 0, 0), 0.5F}, {0.5, Vec3(0.1F, 1, 0), 0.4F}, {1.0, Vec3(0, 2, 0.3F), 0.0F}}},
        change,
        GrowOperation{5},
        UndoOperation{2},
        RedoOperation{1},
        LassoOperation{{Vec3(0, 1, 0), Vec3::UnitX(), Vec3::UnitY(), {{-1, 0}, {1, 0.5F}, {0, 2}}}},
        RegrowOperation{},
        RemoveLassoOperation{},
        SetParametersOperation{}};
    m_recipes = {writeRecipe(recipe), R"({"espalier-recipe":1,"operations":[{"op":"grow","steps":3}]})"};
}

bool FuzzFilesTest::tryProject(const QByteArray& content)
{
    const Result<Project> project = unpackProject(content);
    if (!project) {
        if (project.error().message.isEmpty())
            qFatal("an error without a word");
        return false;
    }
    // Reading the parameter sets loads their images.
    for (const TreeParameters& set : project->tree.parameterSets())
        (void)leafTextures(set.leaves, 16);
    // All that a user can do with the history, through the document and all its indices.
    TreeDocument document;
    document.reset(project->tree, project->journal);
    Edit edit(document);
    edit.travelTo(0);
    edit.travelTo(project->journal.size());
    edit.cancel();
    if (!(document.tree() == project->tree))
        qFatal("the history does not lead back");
    // A recipe is made of it, or a sentence.
    if (const Result<Recipe> recipe = recipeOf(*project); !recipe && recipe.error().message.isEmpty())
        qFatal("an error without a word");
    // And what it is saved as can be opened again.
    const Result<QByteArray> packed = packProject(*project);
    const Result<Project> again = packed ? unpackProject(*packed) : packed.error();
    if (!again || !(again->tree == project->tree) || !sameJournal(again->journal, project->journal))
        qFatal("what was opened cannot be saved: %s",
               again ? "it differs" : qPrintable(again.error().message));
    return true;
}

/// Number of mutations to try: @p usual, or an eighth with the sanitizers, which make each many times as
/// slow.
static int mutations(int usual)
{
#ifdef __SANITIZE_ADDRESS__
    return usual / 8;
#else
    return usual;
#endif
}

void FuzzFilesTest::damagedImages()
{
    QByteArray photo;
    QBuffer buffer(&photo);
    repeatingBark(40, 60).save(&buffer, "jpg");
    const std::vector<QByteArray> images{pngOf(drawnLeaf(Qt::transparent)), pngOf(drawnLeaf(Qt::white)),
                                         photo};
    Mutator mutator(5);
    int good = 0;
    for (int i = 0; i < mutations(1200); ++i) {
        const QByteArray& original = images[mutator.below(images.size())];
        const QByteArray& donor = images[mutator.below(images.size())];
        const Result<ImageAsset> image = readImage(mutator.mutated(original, donor), QStringLiteral("image"));
        if (!image) {
            if (image.error().message.isEmpty())
                qFatal("an error without a word");
            continue;
        }
        ++good;
        TreeParameters look;
        look.leaves.image = look.bark.image = *image;
        const SurfaceTextures leaf = leafTextures(look.leaves, 64);
        const SurfaceTextures bark = barkTextures(look.bark, 64);
        if (leaf.normal.size() != leaf.colour.size() || bark.normal.size() != bark.colour.size())
            qFatal("images of one material differ in size");
    }
    qInfo("%d of %d could be read", good, mutations(1200));
    QVERIFY(good > mutations(20));
    QVERIFY(good < mutations(1190));
}

void FuzzFilesTest::damagedArchives()
{
    Mutator mutator(1);
    int good = 0;
    for (int i = 0; i < mutations(3000); ++i) {
        const QByteArray& original = m_projects[mutator.below(m_projects.size())];
        const QByteArray& donor = m_projects[mutator.below(m_projects.size())];
        good += tryProject(mutator.mutated(original, donor)) ? 1 : 0;
    }
    // Because of checksums, hardly anything but names, padding and the thumbnail can change.
    qInfo("%d of %d could be opened", good, mutations(3000));
    QVERIFY(good < mutations(1500));
}

void FuzzFilesTest::damagedEntries()
{
    Mutator mutator(2);
    int good = 0;
    for (int i = 0; i < mutations(4000); ++i) {
        ZipEntries entries = unpackEntries(m_projects[mutator.below(m_projects.size())]);
        ZipEntries others = unpackEntries(m_projects[mutator.below(m_projects.size())]);
        QByteArray& description = entry(entries, "project.json");
        for (std::uint64_t changes = mutator.below(2) + 1; changes-- > 0;) {
            const std::size_t at = mutator.below(entries.size());
            auto& [name, content] = entries[at];
            const QByteArray& donor = others[mutator.below(others.size())].second;
            if (mutator.chance(20)) {
                description = mutator.mutatedJson(description);
            } else if (mutator.chance(70) && name != "project.json") {
                static const std::vector<qsizetype> kSizes{1, 2, 4, 16};
                mutator.mutateColumn(content, kSizes[mutator.below(kSizes.size())]);
            } else if (mutator.chance(90)) {
                content = mutator.mutated(content, donor);
            } else {
                content = donor;
            }
        }
        good += tryProject(packEntries(entries)) ? 1 : 0;
    }
    qInfo("%d of %d could be opened", good, mutations(4000));
    // Both results were frequent.
    QVERIFY(good > mutations(200));
    QVERIFY(good < mutations(3000));
}

void FuzzFilesTest::damagedRecipes()
{
    Mutator mutator(3);
    int good = 0;
    for (int i = 0; i < mutations(3000); ++i) {
        QByteArray json = m_recipes[mutator.below(m_recipes.size())];
        const QByteArray& donor = m_recipes[mutator.below(m_recipes.size())];
        json = mutator.chance(70) ? mutator.mutatedJson(json) : mutator.mutated(json, donor);
        const Result<Recipe> recipe = parseRecipe(json);
        if (!recipe) {
            QVERIFY(!recipe.error().message.isEmpty());
            continue;
        }
        ++good;
        const Result<Recipe> again = parseRecipe(writeRecipe(*recipe));
        QVERIFY2(again, again ? "" : qPrintable(again.error().message));
        QVERIFY(*again == *recipe);
    }
    qInfo("%d of %d could be read", good, mutations(3000));
    QVERIFY(good > mutations(300));
    QVERIFY(good < mutations(2700));
}

QTEST_GUILESS_MAIN(FuzzFilesTest)

#include "FuzzFilesTest.moc"
