// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/LassoGesture.h"

#include "commands/SetParameters.h"
#include "commands/recipe/RecipePlayer.h"
#include "model/io/project/ProjectFile.h"
#include "tests/model/envelope/Silhouettes.h"
#include "tests/support/AllOperations.h"
#include "tests/support/CrownSilhouette.h"
#include "tests/support/Documents.h"
#include "tests/support/Growing.h"
#include "tests/support/TestClasses.h"

#include <QTest>

namespace espalier::test {

class LassoGestureTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void lasso_isOneUndoStep_undoneAndRedoneToTheBit();
    void cancelledLasso_leavesNoTrace();
    void fullDocument_refusesMore();
    void finishedEarly_keepsWhatGrew();
    void seedlingBelow_reachesTheEnvelope();
    void shapes_areFilledAndKept_data();
    void shapes_areFilledAndKept();
    void rounded_fromTheSide();
    void secondLasso_joinsTheFirst();
    void regrow_usesTheNewParameters_asOneUndoStep();
    void cancelledRegrow_leavesNoTrace();
    void regrowAfterLoading_works();
    void removed_theTreeStays();
    void onlyTheChosenBud_grows();
    void badStrokes_areRefusedAndChangeNothing_data();
    void badStrokes_areRefusedAndChangeNothing();
    void enormousStrokes_endAndAreUndone_data();
    void enormousStrokes_endAndAreUndone();
    void recipe_givesTheSameTree();
};

namespace {

/// Points of a silhouette, scaled to @p size m and put @p up m above the ground.
LassoStroke strokeOf(const Points& points, float size, float up = 0.6F)
{
    Eigen::AlignedBox2f box;
    for (const Vec2& point : points)
        box.extend(point);
    LassoStroke stroke;
    for (const Vec2& point : points) {
        const Vec2 offset = size / box.sizes().maxCoeff() * (point - box.min());
        stroke.points.emplace_back(offset.x() - 0.5F * size / box.sizes().maxCoeff() * box.sizes().x(),
                                   offset.y() + up);
    }
    return stroke;
}

TreeParameters coarse()
{
    TreeParameters parameters;
    parameters.growth.internodeLength = 0.2;
    parameters.leaves.length = 0.18;
    return parameters;
}

int run(LassoGesture& gesture)
{
    int steps = 0;
    while (gesture.step())
        ++steps;
    gesture.finish();
    return steps;
}

int fill(TreeDocument& document, const LassoStroke& stroke)
{
    const LassoGesture::Begun begun = LassoGesture::fill(document, stroke);
    return begun ? run(**begun) : -1;
}

} // namespace

void LassoGestureTest::lasso_isOneUndoStep_undoneAndRedoneToTheBit()
{
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        TreeDocument document;
        growAtRandom(document, seed, 20, 100);
        const DocumentState before(document);
        QVERIFY(fill(document, strokeOf(circle(1.0), 2.0F)) >= 0);
        QCOMPARE(document.undoStack().count(), before.undoIndex + 1);
        QCOMPARE(document.tree().lassoIndicesInForce().size(), 1U);
        const DocumentState done(document);
        QCOMPARE(indexFault(document), QString());
        document.undoStack().undo();
        QCOMPARE(differenceFrom(before, document), QString());
        QVERIFY(document.tree().lassoIndicesInForce().empty());
        const DocumentState undone(document);
        document.undoStack().redo();
        QVERIFY(DocumentState(document) == done);
        document.undoStack().undo();
        QVERIFY(DocumentState(document) == undone);
    }
}

void LassoGestureTest::fullDocument_refusesMore()
{
    TreeContent content = Tree().content();
    content.kept.lassos.resize(kMostLassos, strokeOf(heart(), 3.0F));
    TreeDocument document;
    document.reset(*Tree::fromContent(content), Journal());
    const LassoGesture::Begun begun = LassoGesture::fill(document, strokeOf(heart(), 3.0F));
    QVERIFY(!begun);
    QVERIFY2(begun.error().message.contains(QStringLiteral("more lassos")),
             qPrintable(begun.error().message));
    QVERIFY(!LassoGesture::fillAll(document, {strokeOf(heart(), 3.0F)}, document.parameters()));
    QVERIFY(document.edit() == nullptr);
}

void LassoGestureTest::cancelledLasso_leavesNoTrace()
{
    TreeDocument document;
    document.reset(3, coarse());
    const DocumentState before(document);
    {
        const LassoGesture::Begun begun = LassoGesture::fill(document, strokeOf(heart(), 3.0F));
        QVERIFY(begun);
        QVERIFY((*begun)->step());
        QVERIFY((*begun)->step());
        QVERIFY(!(*begun)->markers().empty());
    }
    QCOMPARE(differenceFrom(before, document), QString());
    QVERIFY(document.tree().lassos() == before.tree.lassos());
    QCOMPARE(document.undoStack().count(), 0);
}

void LassoGestureTest::finishedEarly_keepsWhatGrew()
{
    TreeDocument document;
    document.reset(3, coarse());
    const LassoGesture::Begun begun = LassoGesture::fill(document, strokeOf(heart(), 3.0F));
    QVERIFY(begun);
    QVERIFY((*begun)->step());
    const Tree grown = document.tree();
    (*begun)->finish();
    QVERIFY(!(*begun)->step());
    (*begun)->cancel();
    QVERIFY(document.tree() == grown);
    QCOMPARE(document.undoStack().count(), 1);
}

void LassoGestureTest::seedlingBelow_reachesTheEnvelope()
{
    TreeDocument document;
    document.reset(1, coarse());
    QVERIFY(fill(document, strokeOf(circle(1.0), 2.0F, 6.0F)) > 0);
    QVERIFY(document.index().tipCount(0) > 20);
    for (InternodeId id = 1; id < document.tree().size(); ++id) {
        // There are no branches on the way to the envelope.
        if (document.index().nodePosition(id).y() < 5.0F)
            QVERIFY(document.tree().continuesAxis(id));
    }
}

void LassoGestureTest::shapes_areFilledAndKept_data()
{
    QTest::addColumn<Points>("points");
    QTest::newRow("circle") << circle(1.0);
    QTest::newRow("heart") << heart();
    QTest::newRow("arch") << arch();
    QTest::newRow("swan") << swan();
}

void LassoGestureTest::shapes_areFilledAndKept()
{
    QFETCH(const Points, points);
    TreeDocument document;
    const LassoGesture::Begun begun = LassoGesture::fill(document, strokeOf(points, 5.0F));
    QVERIFY(begun);
    const Envelope envelope = EnvelopeSet::fromStrokes(document.tree().lassosInForce())->envelopes().front();
    QVERIFY(run(**begun) > 0);
    const auto [covered, outside] = crownSilhouette(document, envelope);
    qInfo("%.1f %% covered, %.1f %% outside", 100.0 * covered, 100.0 * outside);
    QVERIFY(covered >= 0.8);
    QVERIFY(outside <= 0.03);
}

void LassoGestureTest::rounded_fromTheSide()
{
    TreeDocument document;
    document.reset(1, coarse());
    QVERIFY(fill(document, strokeOf(circle(1.0), 4.0F, 1.0F)) > 0);
    Box3 crown;
    for (InternodeId id = 1; id < document.tree().size(); ++id) {
        if (document.tree().isAlive(id))
            crown.extend(document.index().nodePosition(id));
    }
    QVERIFY(crown.sizes().z() > 0.8F * crown.sizes().x());
}

void LassoGestureTest::secondLasso_joinsTheFirst()
{
    TreeDocument document;
    document.reset(1, coarse());
    QVERIFY(fill(document, strokeOf(circle(1.0), 2.0F, 1.0F)) > 0);
    const std::uint32_t first = document.index().livingCount();
    // A separate ball on top, with half a metre of air between.
    QVERIFY(fill(document, strokeOf(circle(1.0), 1.5F, 3.5F)) > 0);
    QCOMPARE(document.tree().lassoIndicesInForce().size(), 2U);
    QVERIFY(document.index().livingCount() > first + 20);
    int above = 0;
    for (InternodeId id = 0; id < document.tree().size(); ++id)
        above += document.tree().isAlive(id) && document.index().nodePosition(id).y() > 4.0F ? 1 : 0;
    QVERIFY(above > 20);
}

void LassoGestureTest::regrow_usesTheNewParameters_asOneUndoStep()
{
    TreeDocument document;
    document.reset(2, coarse());
    grow(document, 2);
    QVERIFY(fill(document, strokeOf(heart(), 4.0F)) > 0);
    TreeParameters finer = document.parameters();
    finer.growth.internodeLength = 0.15;
    setParameters(document, finer);
    const DocumentState before(document);
    const LassoGesture::Begun begun = LassoGesture::regrow(document);
    QVERIFY(begun);
    // As it was before the lasso.
    QVERIFY(document.index().livingCount() < 60);
    QVERIFY(run(**begun) > 0);
    QVERIFY(document.parameters() == finer);
    QCOMPARE(document.tree().lassoIndicesInForce(), std::vector<std::uint32_t>{0});
    QCOMPARE(document.undoStack().count(), before.undoIndex + 1);
    QCOMPARE(indexFault(document), QString());
    const InternodeId last = document.tree().size() - 1;
    QCOMPARE(document.tree().parametersOf(last).growth.internodeLength, 0.15);
    const DocumentState done(document);
    const Result<Project> saved =
        unpackProject(*packProject({document.tree(), document.journal(), QStringLiteral("a"), {}}));
    QVERIFY2(saved, saved ? "" : qPrintable(saved.error().message));
    QVERIFY(saved->tree == document.tree());
    document.undoStack().undo();
    QCOMPARE(differenceFrom(before, document), QString());
    const DocumentState undone(document);
    document.undoStack().redo();
    QVERIFY(DocumentState(document) == done);
    while (document.undoStack().canUndo())
        document.undoStack().undo();
    QVERIFY(document.journal().empty());
    QCOMPARE(document.index().livingCount(), 1U);
    while (document.undoStack().canRedo())
        document.undoStack().redo();
    QVERIFY(DocumentState(document) == done);
}

void LassoGestureTest::cancelledRegrow_leavesNoTrace()
{
    TreeDocument document;
    document.reset(2, coarse());
    QVERIFY(fill(document, strokeOf(heart(), 3.0F)) > 0);
    const DocumentState before(document);
    {
        const LassoGesture::Begun begun = LassoGesture::regrow(document);
        QVERIFY(begun);
        QVERIFY((*begun)->step());
    }
    QCOMPARE(differenceFrom(before, document), QString());
    QVERIFY(document.tree().lassos() == before.tree.lassos());
}

void LassoGestureTest::regrowAfterLoading_works()
{
    TreeDocument document;
    document.reset(2, coarse());
    QVERIFY(fill(document, strokeOf(heart(), 3.0F)) > 0);
    Result<Project> project =
        unpackProject(*packProject({document.tree(), document.journal(), QStringLiteral("a"), {}}));
    QVERIFY(project);
    TreeDocument other;
    other.reset(project->tree, project->journal);
    const DocumentState before(other);
    const LassoGesture::Begun begun = LassoGesture::regrow(other);
    QVERIFY(begun);
    QCOMPARE(other.index().livingCount(), 1U);
    QVERIFY(run(**begun) > 0);
    other.undoStack().undo();
    QCOMPARE(differenceFrom(before, other), QString());
}

void LassoGestureTest::removed_theTreeStays()
{
    TreeDocument document;
    document.reset(2, coarse());
    QVERIFY(!removeEnvelopes(document));
    QVERIFY(!LassoGesture::regrow(document));
    QVERIFY(fill(document, strokeOf(heart(), 3.0F)) > 0);
    const std::uint32_t living = document.index().livingCount();
    QVERIFY(removeEnvelopes(document));
    QVERIFY(document.tree().lassosInForce().empty());
    QCOMPARE(document.index().livingCount(), living);
    document.undoStack().undo();
    QCOMPARE(document.tree().lassosInForce().size(), 1U);
    document.undoStack().undo();
    QVERIFY(document.tree().lassosInForce().empty());
}

void LassoGestureTest::onlyTheChosenBud_grows()
{
    TreeDocument document;
    document.reset(2, coarse());
    grow(document, 6);
    const std::uint32_t size = document.tree().size();
    InternodeId tip = 0;
    for (InternodeId id = 1; id < size; ++id) {
        if (document.tree().isAlive(id) && (document.tree().buds(id) & kTerminalBud) != 0)
            tip = id;
    }
    const Vec3 place = document.index().nodePosition(tip);
    LassoStroke stroke = strokeOf(circle(1.0), 3.0F, -1.5F);
    stroke.origin = place;
    const LassoGesture::Begun begun = LassoGesture::fill(document, stroke, {tip, kTerminalSlot});
    QVERIFY(begun);
    QVERIFY(run(**begun) > 0);
    for (InternodeId id = size; id < document.tree().size(); ++id) {
        InternodeId ancestor = id;
        while (ancestor > tip)
            ancestor = document.tree().parent(ancestor);
        QCOMPARE(ancestor, tip);
    }
}

void LassoGestureTest::badStrokes_areRefusedAndChangeNothing_data()
{
    QTest::addColumn<LassoStroke>("stroke");
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const auto row = [](const char* name, const Points& points) -> LassoStroke& {
        static LassoStroke stroke;
        stroke = {};
        stroke.points = points;
        QTest::newRow(name) << stroke;
        return stroke;
    };
    row("none", {});
    row("one point", {{1, 1}});
    row("two points", {{0, 1}, {1, 2}});
    row("there and back", {{0, 1}, {1, 2}, {0, 1}});
    row("no number", {{nan, nan}, {nan, 0}, {0, nan}});
    row("all beyond reason", {{1e9F, 0}, {-1e9F, 1e9F}, {0, 3e8F}});
    row("a point many times", Points(1000, Vec2(1, 1)));
    LassoStroke plane;
    plane.points = circle(1.0);
    plane.up = plane.right;
    QTest::newRow("no plane") << plane;
    plane.up = Vec3(nan, nan, nan);
    QTest::newRow("a plane of no numbers") << plane;
    plane.up = Vec3::UnitY();
    plane.origin = Vec3(0, 1e30F, 0);
    QTest::newRow("a plane far away") << plane;
}

void LassoGestureTest::badStrokes_areRefusedAndChangeNothing()
{
    QFETCH(const LassoStroke, stroke);
    TreeDocument document;
    const DocumentState before(document);
    const LassoGesture::Begun begun = LassoGesture::fill(document, stroke);
    QVERIFY(!begun);
    QVERIFY(!begun.error().message.isEmpty());
    QVERIFY(DocumentState(document) == before);
}

void LassoGestureTest::enormousStrokes_endAndAreUndone_data()
{
    QTest::addColumn<LassoStroke>("stroke");
    LassoStroke stroke;
    Random random(5, 0, 0, Purpose::Direction);
    for (int i = 0; i < 100'000; ++i)
        stroke.points.emplace_back((Vec3(0, 3, 0) + 2.0F * random.inBall()).head<2>());
    QTest::newRow("a scribble of 100,000 points") << stroke;
    QTest::newRow("larger than the world") << strokeOf(circle(1.0, 0, 0, 100'000), 1e6F, -1e5F);
    QTest::newRow("out of the window") << strokeOf(circle(1.0), 500.0F, -400.0F);
    QTest::newRow("tiny") << strokeOf(circle(1.0), 0.01F, 0.0F);
    QTest::newRow("below the ground") << strokeOf(circle(1.0), 3.0F, -10.0F);
}

void LassoGestureTest::enormousStrokes_endAndAreUndone()
{
    QFETCH(const LassoStroke, stroke);
    TreeDocument document;
    document.reset(1, coarse());
    const DocumentState before(document);
    const LassoGesture::Begun begun = LassoGesture::fill(document, stroke);
    QVERIFY(begun);
    QElapsedTimer clock;
    clock.start();
    qint64 longest = 0;
    for (int i = 0; i < 40; ++i) {
        const qint64 start = clock.elapsed();
        if (!(*begun)->step())
            break;
        longest = std::max(longest, clock.elapsed() - start);
    }
    qInfo("longest step %lld ms", longest);
    QVERIFY(longest < 2000);
    (*begun)->finish();
    QVERIFY(document.tree().lassos().constLast().points.size() <= kMostLassoPoints);
    for (InternodeId id = 0; id < document.tree().size(); ++id)
        QVERIFY(document.index().nodePosition(id).allFinite());
    document.undoStack().undo();
    QCOMPARE(differenceFrom(before, document), QString());
}

void LassoGestureTest::recipe_givesTheSameTree()
{
    Recipe recipe;
    recipe.parameters = coarse();
    recipe.operations.emplace_back(LassoOperation{strokeOf(heart(), 3.0F)});
    recipe.operations.emplace_back(LassoOperation{}); // encloses nothing
    recipe.operations.emplace_back(RegrowOperation{});
    recipe.operations.emplace_back(RemoveLassoOperation{});
    TreeDocument whole;
    RecipePlayer(whole, recipe).playAll();
    QCOMPARE(whole.undoStack().count(), 3);
    QVERIFY(whole.index().livingCount() > 100);
    TreeDocument sliced;
    RecipePlayer player(sliced, recipe);
    bool wasShown = false;
    while (!player.isDone()) {
        player.advance(0.05);
        wasShown = wasShown || player.lasso() != nullptr;
    }
    QVERIFY(wasShown);
    QVERIFY(sliced.tree() == whole.tree());
}

const TestClass<LassoGestureTest> lassoGestureTest;

} // namespace espalier::test

#include "LassoGestureTest.moc"
