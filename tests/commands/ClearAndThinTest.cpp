// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/EraseTwigs.h"
#include "commands/KeepClear.h"
#include "model/io/project/ProjectFile.h"
#include "tests/support/Documents.h"
#include "tests/support/Growing.h"
#include "tests/support/Replaying.h"
#include "tests/support/TestClasses.h"
#include "tests/support/TreeBuilder.h"

#include <QTest>

namespace espalier::test {

/// Trunks that are kept clear while the tree grows, the eraser and thinning.
class ClearAndThinTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void clear_isOneUndoStep();
    void trunk_staysClearWhileItGrows_data();
    void trunk_staysClearWhileItGrows();
    void seedling_growsATrunkThatIsClear();
    void budsThatMayShootAgain_do();
    void drawnLine_doesNotBeginAtClearWood();
    void file_keepsWhatIsClear();
    void erase_isOneUndoStep();
    void thin_takesTheSameShareAgain();
    void recipe_givesTheSameDocument();
};

namespace {

/// A small tree with a trunk of about 1.6 m and branches from the foot on.
void plantBushyTree(TreeDocument& document, GrowthModelKind model = GrowthModelKind::TreeSketch)
{
    TreeParameters parameters;
    parameters.growth.internodeLength = 0.1;
    parameters.growth.model = model;
    document.reset(11, parameters);
    const std::vector<Vec3> way{Vec3::Zero(), Vec3(0.0F, 1.6F, 0.0F)};
    brush(document, strokeAlong(way, 0.5F, 2.0));
    if (model == GrowthModelKind::Vigour)
        grow(document, 25);
    document.undoStack().clear();
}

/// The number of living branches on the trunk below @p height along it, m.
std::size_t shootsOnTrunk(const TreeDocument& document, float height)
{
    return shootsBelow(document.tree(), document.index(), 0, height).size();
}

SweptTwigs wholeTree(double thickest)
{
    return {.sweeps = {{Vec3(0.0F, 1.0F, 10.0F),
                        {{Vec3(0.0F, 0.0F, 0.0F), 2.0F}, {Vec3(0.0F, 3.0F, 0.0F), 2.0F}}}},
            .thickest = thickest};
}

} // namespace

void ClearAndThinTest::clear_isOneUndoStep()
{
    TreeDocument document;
    plantBushyTree(document);
    QVERIFY(shootsOnTrunk(document, 0.8F) > 1);
    const DocumentState before(document);
    QVERIFY(keepClear(document, 0, 0.8F));
    QCOMPARE(document.undoStack().count(), 1);
    QCOMPARE(shootsOnTrunk(document, 0.8F), std::size_t{0});
    QCOMPARE(indexFault(document), QString());
    const DocumentState after(document);
    document.undoStack().undo();
    QCOMPARE(differenceFrom(before, document), QString());
    document.undoStack().redo();
    QCOMPARE(differenceFrom(after, document), QString());
    QVERIFY(!keepClear(document, 0, 0.8F));
    QCOMPARE(document.undoStack().count(), 1);
}

void ClearAndThinTest::trunk_staysClearWhileItGrows_data()
{
    QTest::addColumn<int>("model");
    QTest::newRow("TreeSketch") << static_cast<int>(GrowthModelKind::TreeSketch);
    QTest::newRow("vigour") << static_cast<int>(GrowthModelKind::Vigour);
}

void ClearAndThinTest::trunk_staysClearWhileItGrows()
{
    QFETCH(int, model);
    TreeDocument document;
    plantBushyTree(document, static_cast<GrowthModelKind>(model));
    QVERIFY(keepClear(document, 0, 0.8F));
    const std::uint32_t before = document.index().livingCount();
    grow(document, 8);
    QVERIFY(document.index().livingCount() > before);
    QCOMPARE(shootsOnTrunk(document, 0.8F), std::size_t{0});
    // A brush over the clear part brings nothing there, either.
    brush(document, strokeAlong(std::vector<Vec3>{Vec3::Zero(), Vec3(0.0F, 0.6F, 0.0F)}, 0.4F, 1.0));
    QCOMPARE(shootsOnTrunk(document, 0.8F), std::size_t{0});
}

void ClearAndThinTest::seedling_growsATrunkThatIsClear()
{
    TreeParameters parameters;
    parameters.growth.internodeLength = 0.1;
    TreeDocument document;
    document.reset(5, parameters);
    QVERIFY(keepClear(document, 0, 1.0F));
    brush(document, strokeAlong(std::vector<Vec3>{Vec3::Zero(), Vec3(0.0F, 2.0F, 0.0F)}, 0.4F, 3.0));
    QVERIFY(document.index().livingCount() > 40);
    QCOMPARE(shootsOnTrunk(document, 1.0F), std::size_t{0});
    QVERIFY(shootsOnTrunk(document, 3.0F) > 0);
}

void ClearAndThinTest::budsThatMayShootAgain_do()
{
    TreeDocument document;
    plantBushyTree(document);
    QVERIFY(keepClear(document, 0, 0.8F));
    QVERIFY(keepClear(document, 0, 0.0F));
    brush(document,
          strokeAlong(std::vector<Vec3>{Vec3(0.2F, 0.2F, 0.0F), Vec3(0.2F, 0.7F, 0.0F)}, 0.4F, 1.5));
    QVERIFY(shootsOnTrunk(document, 0.8F) > 0);
}

void ClearAndThinTest::drawnLine_doesNotBeginAtClearWood()
{
    TreeDocument document;
    plantBushyTree(document);
    QVERIFY(keepClear(document, 0, 0.8F));
    brush(document,
          strokeAlong(std::vector<Vec3>{Vec3(0.0F, 0.4F, 0.0F), Vec3(1.0F, 0.6F, 0.0F)}, 0.0F, 1.5));
    QCOMPARE(shootsOnTrunk(document, 0.8F), std::size_t{0});
}

void ClearAndThinTest::file_keepsWhatIsClear()
{
    TreeDocument document;
    plantBushyTree(document);
    QVERIFY(keepClear(document, 0, 0.8F));
    Project project;
    project.tree = document.tree();
    const Result<QByteArray> packed = packProject(project);
    QVERIFY(packed);
    const Result<Project> read = unpackProject(*packed);
    QVERIFY(read);
    QCOMPARE(read->tree.clearLength(0), 0.8F);
    QVERIFY(read->tree == document.tree());
}

void ClearAndThinTest::erase_isOneUndoStep()
{
    TreeDocument document;
    plantBushyTree(document);
    const DocumentState before(document);
    QVERIFY(eraseTwigs(document, {wholeTree(0.5)}));
    QCOMPARE(document.undoStack().count(), 1);
    QVERIFY(document.index().livingCount() < before.tree.size() / 2);
    QCOMPARE(indexFault(document), QString());
    document.undoStack().undo();
    QCOMPARE(differenceFrom(before, document), QString());
    QVERIFY(!eraseTwigs(document, {SweptTwigs{.sweeps = {{Vec3(0, 1, 10), {{Vec3(9, 1, 0), 0.1F}}}}}}));
    QCOMPARE(document.undoStack().count(), 1);
}

void ClearAndThinTest::thin_takesTheSameShareAgain()
{
    TreeDocument document;
    std::vector<NewInternode> internodes;
    for (InternodeId i = 0; i < 20; ++i)
        internodes.push_back({.parent = i});
    for (InternodeId i = 1; i <= 20; ++i)
        internodes.push_back({.parent = i, .slot = 0, .rotation = branching(1.0)});
    apply(document, births(document.tree(), internodes));
    const std::size_t all = shootsOnTrunk(document, 9.0F);
    QCOMPARE(all, std::size_t{20});
    QVERIFY(thinTwigs(document, {wholeTree(1.0), 0.4}));
    const std::size_t once = shootsOnTrunk(document, 9.0F);
    QVERIFY(std::abs(static_cast<double>(once) - 0.6 * static_cast<double>(all)) <= 1.5);
    QVERIFY(thinTwigs(document, {wholeTree(1.0), 0.4}));
    const std::size_t twice = shootsOnTrunk(document, 9.0F);
    QVERIFY(std::abs(static_cast<double>(twice) - 0.6 * static_cast<double>(once)) <= 1.5);
}

void ClearAndThinTest::recipe_givesTheSameDocument()
{
    TreeDocument document;
    document.reset(11, TreeParameters());
    grow(document, 12);
    QVERIFY(keepClear(document, 3, 0.123F));
    grow(document, 2);
    QVERIFY(thinTwigs(document, {wholeTree(1.0), 0.333}));
    grow(document, 2);
    QVERIFY(eraseTwigs(document, {wholeTree(0.3)}));
    grow(document, 1);
    QCOMPARE(replayFault(document), QString());
}

static const TestClass<ClearAndThinTest> clearAndThinTest;

} // namespace espalier::test

#include "ClearAndThinTest.moc"
