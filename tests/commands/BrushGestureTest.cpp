// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/BrushGesture.h"

#include "commands/SetParameters.h"
#include "tests/support/Documents.h"
#include "tests/support/Growing.h"
#include "tests/support/TestClasses.h"

#include <QTest>

#include <cmath>
#include <set>

namespace espalier::test {

class BrushGestureTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void stroke_isOneUndoStep_undoneAndRedoneToTheBit();
    void cancelledStroke_leavesNoTrace();
    void strokeDroppedUnfinished_isCancelled();
    void strokeThatGrowsNothing_isNoCommand();
    void afterItsEnd_theGestureDoesNothing();
    void samplesThatGoBackInTime_areIgnored();
    void restingBrush_goesOnGrowing();
    void growth_followsTheBrush();
    void brush_onADrawnStem_growsWhereTheBrushIs();
    void seedling_reachesForADistantBrush();
    void slowStroke_growsDenserThanAFastOne();
    void drawnStroke_isOneAxisOnTheLine();
    void drawnStroke_startsFromTheBudNearest();
    void drawnStroke_fromASelectedBud_startsThere();
    void drawnStroke_fromABudThatIsNotThere_growsNothing();
    void drawnStroke_turningBackOnItself_turnsInAsTightABowAsItCan();
    void drawnStroke_fromTheFootOfASeedling_neverFolds_data();
    void drawnStroke_fromTheFootOfASeedling_neverFolds();
    void drawnStroke_neverTurnsByMoreThanARightAngle();
    void drawnStroke_staysAboveTheGround();
    void thinnerBrush_growsFewerShoots();
    void strokeThatThinsOut_endsInOneAxis();
    void tropismFromStroke_bendsGrowthAlongTheStroke();
    void uprightTrunk_staysUpWhateverTheBranchesDo();
    void selectedBranch_growsAlone();
    void parametersChangedBetweenStrokes_leaveWhatStood();
    void liveMarkers_areShownWhileBrushing();
};

namespace {

TreeParameters parameters(double irregularity = 0.4)
{
    TreeParameters result;
    result.growth.irregularity = irregularity;
    return result;
}

/// A young crown, two metres high.
void growCrown(TreeDocument& document, std::uint64_t seed = 1, const TreeParameters& with = parameters())
{
    document.reset(seed, with);
    brush(document, strokeAlong(std::vector{Vec3(0.0F, 0.6F, 0.0F), Vec3(0.0F, 1.8F, 0.0F)}, 0.5F, 1.5));
    document.undoStack().clear();
    QVERIFY(document.index().livingCount() > 100);
}

const std::vector<BrushSample> kCrownStroke =
    strokeAlong(std::vector{Vec3(-0.6F, 1.6F, 0.0F), Vec3(0.6F, 2.0F, 0.2F)}, 0.4F, 0.8);

/// Internodes that came with the last change of the journal's length.
std::vector<InternodeId> bornSince(const TreeDocument& document, std::uint32_t size)
{
    std::vector<InternodeId> born;
    for (InternodeId id = size; id < document.tree().size(); ++id) {
        if (document.tree().isAlive(id))
            born.push_back(id);
    }
    return born;
}

double distanceToPolyline(const Vec3& point, std::span<const Vec3> line)
{
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const Eigen::Vector3d a = line[i].cast<double>();
        const Eigen::Vector3d along = line[i + 1].cast<double>() - a;
        const Eigen::Vector3d p = point.cast<double>();
        const double t = std::clamp((p - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
        nearest = std::min(nearest, (a + t * along - p).norm());
    }
    return nearest;
}

bool descendsFrom(const Tree& tree, InternodeId id, InternodeId node, int slot)
{
    while (id != kNoInternode) {
        if (tree.parent(id) == node && tree.columns().slot[id] == slot)
            return true;
        id = tree.parent(id);
    }
    return false;
}

/// Of the internodes from @p first on that continue their parent's axis, the greatest angle between one and
/// its parent, rad.
double sharpestTurn(const TreeDocument& document, InternodeId first)
{
    double sharpest = 0.0;
    for (InternodeId id = first; id < document.tree().size(); ++id) {
        if (!document.tree().continuesAxis(id))
            continue;
        const Vec3 before = document.index().heading(document.tree().parent(id));
        const double cosine = before.dot(document.index().heading(id));
        sharpest = std::max(sharpest, std::acos(std::clamp(cosine, -1.0, 1.0)));
    }
    return sharpest;
}

} // namespace

void BrushGestureTest::stroke_isOneUndoStep_undoneAndRedoneToTheBit()
{
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        TreeDocument document;
        growAtRandom(document, seed, 40, 200);
        Random random(seed, 9, 0, Purpose::ShootLength);
        const DocumentState before(document);
        brush(document, randomStroke(random, document.parameters().growth, 1.0));
        if (document.journal().size() == before.journal.size())
            continue;
        QCOMPARE(document.undoStack().count(), before.undoIndex + 1);
        const DocumentState done(document);
        QCOMPARE(indexFault(document), QString());
        document.undoStack().undo();
        QCOMPARE(differenceFrom(before, document), QString());
        const DocumentState undone(document);
        document.undoStack().redo();
        QVERIFY(DocumentState(document) == done);
        QCOMPARE(indexFault(document), QString());
        document.undoStack().undo();
        QVERIFY(DocumentState(document) == undone);
        QCOMPARE(indexFault(document), QString());
    }
}

void BrushGestureTest::cancelledStroke_leavesNoTrace()
{
    TreeDocument document;
    growCrown(document);
    const DocumentState before(document);
    BrushGesture gesture(document, kCrownStroke.front());
    for (const BrushSample& sample : kCrownStroke)
        gesture.add(sample);
    QVERIFY(document.journal().size() > before.journal.size());
    gesture.cancel();
    QCOMPARE(differenceFrom(before, document), QString());
    QCOMPARE(document.undoStack().count(), 0);
    gesture.finish(); // it has no effect any more
    QCOMPARE(document.undoStack().count(), 0);
}

void BrushGestureTest::strokeDroppedUnfinished_isCancelled()
{
    TreeDocument document;
    growCrown(document);
    const DocumentState before(document);
    {
        BrushGesture gesture(document, kCrownStroke.front());
        for (const BrushSample& sample : kCrownStroke)
            gesture.add(sample);
        QVERIFY(document.journal().size() > before.journal.size());
    }
    QCOMPARE(differenceFrom(before, document), QString());
    QCOMPARE(document.undoStack().count(), 0);
}

void BrushGestureTest::strokeThatGrowsNothing_isNoCommand()
{
    TreeDocument document;
    growCrown(document);
    const DocumentState before(document);
    // A tap, and a stroke far away from all buds.
    brush(document, std::vector{kCrownStroke.front()});
    brush(document, strokeAlong(std::vector{Vec3(50.0F, 5.0F, 0.0F), Vec3(55.0F, 5.0F, 0.0F)}, 0.3F, 0.5));
    QVERIFY(DocumentState(document) == before);
    QCOMPARE(document.undoStack().count(), 0);
}

void BrushGestureTest::afterItsEnd_theGestureDoesNothing()
{
    TreeDocument document;
    growCrown(document);
    BrushGesture gesture(document, kCrownStroke.front());
    for (const BrushSample& sample : kCrownStroke)
        gesture.add(sample);
    gesture.finish();
    const DocumentState done(document);
    QCOMPARE(document.undoStack().count(), 1);
    gesture.add({5.0, Vec3(0.0F, 2.0F, 0.0F), 0.5F});
    gesture.finish();
    gesture.cancel();
    QVERIFY(DocumentState(document) == done);
    QCOMPARE(document.undoStack().count(), 1);
}

void BrushGestureTest::samplesThatGoBackInTime_areIgnored()
{
    TreeDocument straight;
    growCrown(straight);
    brush(straight, kCrownStroke);
    TreeDocument jumbled;
    growCrown(jumbled);
    BrushGesture gesture(jumbled, kCrownStroke.front());
    for (const BrushSample& sample : kCrownStroke) {
        gesture.add(sample);
        gesture.add({sample.time - 0.01, Vec3(9.0F, 9.0F, 9.0F), 1.0F});
        gesture.add({sample.time, Vec3(9.0F, 9.0F, 9.0F), 1.0F});
    }
    gesture.finish();
    QVERIFY(jumbled.tree() == straight.tree());
}

void BrushGestureTest::restingBrush_goesOnGrowing()
{
    TreeDocument document;
    growCrown(document);
    BrushGesture gesture(document, {0.0, Vec3(0.0F, 1.8F, 0.0F), 0.5F});
    std::vector<std::uint32_t> sizes;
    for (int i = 1; i <= 4; ++i) {
        gesture.add({0.25 * i, Vec3(0.0F, 1.8F, 0.0F), 0.5F});
        sizes.push_back(document.tree().size());
    }
    QVERIFY(std::ranges::is_sorted(sizes));
    QVERIFY(sizes[1] > sizes[0]);
}

void BrushGestureTest::growth_followsTheBrush()
{
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        TreeDocument document;
        growCrown(document, seed);
        const std::uint32_t size = document.tree().size();
        const std::vector<Vec3> path{Vec3(0.0F, 1.8F, 0.0F), Vec3(1.6F, 2.0F, 0.0F)};
        brush(document, strokeAlong(path, 0.35F, 2.0));
        const auto born = bornSince(document, size);
        QVERIFY(born.size() > 40);
        const auto reach = static_cast<double>(Perception::of(document.parameters().growth).reach);
        double farthest = 0.0;
        for (const InternodeId id : born) {
            QVERIFY(distanceToPolyline(document.index().nodePosition(id), path) < 0.35 + reach);
            farthest = std::max(farthest, static_cast<double>(document.index().nodePosition(id).x()));
        }
        QVERIFY(farthest > 1.2);
    }
}

void BrushGestureTest::brush_onADrawnStem_growsWhereTheBrushIs()
{
    TreeDocument document;
    document.reset(1, parameters());
    brush(document, strokeAlong(std::vector{Vec3(0.0F, 0.0F, 0.0F), Vec3(0.0F, 3.0F, 0.0F)}, 0.0F, 1.0));
    QCOMPARE(document.index().tipCount(0), 1U);
    const std::uint32_t size = document.tree().size();
    const Vec3 place(0.2F, 1.0F, 0.0F);
    brush(document, strokeAlong(std::vector{place, Vec3(0.4F, 1.1F, 0.0F)}, 0.3F, 0.8));
    const auto born = bornSince(document, size);
    QVERIFY(!born.empty());
    for (const InternodeId id : born)
        QVERIFY((document.index().nodePosition(id) - place).norm() < 1.2F);
}

void BrushGestureTest::seedling_reachesForADistantBrush()
{
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        TreeDocument document;
        document.reset(seed, parameters());
        const Vec3 place(0.5F, 3.0F, 0.0F);
        brush(document, strokeAlong(std::vector{place, place}, 0.6F, 3.0));
        // A trunk that is bare below, and a crown where the brush is.
        int branchesBelow = 0;
        int inCrown = 0;
        for (InternodeId id = 1; id < document.tree().size(); ++id) {
            const Vec3& position = document.index().nodePosition(id);
            branchesBelow += position.y() < 1.5F && document.index().axis(id) != 0 ? 1 : 0;
            inCrown += (position - place).norm() < 1.0F ? 1 : 0;
        }
        QCOMPARE(branchesBelow, 0);
        QVERIFY(inCrown > 50);
    }
}

void BrushGestureTest::slowStroke_growsDenserThanAFastOne()
{
    const std::vector<Vec3> path{Vec3(-0.2F, 1.6F, 0.0F), Vec3(1.2F, 1.9F, 0.0F)};
    std::size_t slow = 0;
    std::size_t fast = 0;
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        for (const bool isSlow : {true, false}) {
            TreeDocument document;
            growCrown(document, seed);
            const std::uint32_t size = document.tree().size();
            brush(document, strokeAlong(path, 0.4F, isSlow ? 3.0 : 0.5));
            (isSlow ? slow : fast) += bornSince(document, size).size();
        }
    }
    QVERIFY(fast > 0);
    QVERIFY2(2 * slow > 3 * fast, qPrintable(QStringLiteral("slow %1, fast %2").arg(slow).arg(fast)));
}

void BrushGestureTest::drawnStroke_isOneAxisOnTheLine()
{
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        TreeDocument document;
        growAtRandom(document, seed, 30, 100);
        TreeParameters with = document.parameters();
        with.growth.internodeLength = 0.06;
        setParameters(document, with);
        Random random(seed, 4, 0, Purpose::Direction);
        // A bend of short pieces that begins at a living bud.
        InternodeId start = document.tree().size() - 1;
        while (!document.tree().isAlive(start) || document.tree().buds(start) == 0 ||
               document.index().heading(start).y() < 0.3F)
            --start;
        std::vector<Vec3> line{document.index().nodePosition(start)};
        // Not back along the shoot that it starts from, and not into the ground.
        Vec3 heading = random.direction();
        heading.y() = std::abs(heading.y());
        heading = (heading + document.index().heading(start)).normalized();
        for (int i = 0; i < 40; ++i) {
            if (i > 0)
                heading = (heading + 0.4F * random.direction()).normalized();
            heading.y() = std::abs(heading.y());
            line.push_back(line.back() + 0.05F * heading);
        }
        const std::uint32_t size = document.tree().size();
        // The same polyline at another pace of samples: one sample a corner.
        std::vector<BrushSample> samples;
        for (std::size_t i = 0; i < line.size(); ++i)
            samples.push_back({static_cast<double>(i) / kBrushStepsPerSecond, line[i], 0.0F});
        brush(document, samples);
        const auto born = bornSince(document, size);
        QVERIFY2(born.size() >= 15, qPrintable(QStringLiteral("seed %1: %2").arg(seed).arg(born.size())));
        for (std::size_t i = 0; i < born.size(); ++i) {
            const InternodeId id = born[i];
            const double off = distanceToPolyline(document.index().nodePosition(id), line);
            QVERIFY2(off < 1e-4, qPrintable(QStringLiteral("seed %1, internode %2 of %3: %4")
                                                .arg(seed)
                                                .arg(i)
                                                .arg(born.size())
                                                .arg(off)));
            QVERIFY(std::abs(document.tree().length(id) - 0.06F) < 1e-6F);
            if (i > 0) {
                QCOMPARE(document.tree().parent(id), born[i - 1]);
                QVERIFY(document.tree().continuesAxis(id));
            }
        }
        QCOMPARE(document.index().tipCount(born.front()), 1U);
    }
}

void BrushGestureTest::drawnStroke_startsFromTheBudNearest()
{
    TreeDocument document;
    growCrown(document);
    const std::uint32_t size = document.tree().size();
    const Vec3 place(0.5F, 1.5F, 0.2F);
    double nearest = std::numeric_limits<double>::infinity();
    for (InternodeId id = 0; id < size; ++id) {
        if (document.tree().isAlive(id) && document.tree().buds(id) != 0)
            nearest =
                std::min(nearest, static_cast<double>((document.index().nodePosition(id) - place).norm()));
    }
    brush(document, strokeAlong(std::vector{place, Vec3(1.5F, 1.8F, 0.2F)}, 0.0F, 0.5));
    const auto born = bornSince(document, size);
    QVERIFY(born.size() > 5);
    QVERIFY(std::abs((document.index().basePosition(document.tree(), born.front()) - place).norm() -
                     nearest) < 1e-5);
}

void BrushGestureTest::drawnStroke_fromASelectedBud_startsThere()
{
    TreeDocument document;
    growCrown(document);
    const std::uint32_t size = document.tree().size();
    // A lateral bud low in the crown.
    InternodeId node = 1;
    while (!document.tree().isAlive(node) || (document.tree().buds(node) & budBit(0)) == 0)
        ++node;
    const Vec3 from = document.index().nodePosition(node);
    brush(document, strokeAlong(std::vector{from, Vec3(from + Vec3(1.0F, 0.5F, 0.0F))}, 0.0F, 0.5),
          {node, 0});
    const auto born = bornSince(document, size);
    QVERIFY(born.size() > 5);
    QCOMPARE(document.tree().parent(born.front()), node);
    QCOMPARE(document.tree().columns().slot[born.front()], std::uint8_t{0});
    for (const InternodeId id : born)
        QVERIFY(descendsFrom(document.tree(), id, node, 0));
}

void BrushGestureTest::drawnStroke_fromABudThatIsNotThere_growsNothing()
{
    TreeDocument document;
    growCrown(document);
    const std::uint32_t size = document.tree().size();
    brush(document, kCrownStroke);
    document.undoStack().undo();
    const DocumentState before(document);
    QCOMPARE(document.tree().size(), size);
    for (const InternodeId node : {size, size + 100, InternodeId{0xffff'fffe}}) {
        brush(document, strokeAlong(std::vector{Vec3(0.0F, 1.8F, 0.0F), Vec3(1.0F, 2.0F, 0.0F)}, 0.0F, 0.5),
              {node, kTerminalSlot});
        QVERIFY(DocumentState(document) == before);
    }
}

void BrushGestureTest::drawnStroke_turningBackOnItself_turnsInAsTightABowAsItCan()
{
    TreeDocument document;
    document.reset(1, parameters());
    const auto l = static_cast<float>(document.parameters().growth.internodeLength);
    const std::vector<Vec3> line{Vec3(0.0F, l, 0.0F), Vec3(0.0F, 1.0F, 0.0F), Vec3(0.0F, 0.4F, 0.0F),
                                 Vec3(0.0F, 1.5F, 0.0F)};
    brush(document, strokeAlong(line, 0.0F, 1.5));
    QVERIFY(document.tree().size() > 10);
    for (InternodeId id = 0; id < document.tree().size(); ++id) {
        QVERIFY(document.index().nodePosition(id).allFinite());
        QVERIFY(distanceToPolyline(document.index().nodePosition(id), line) < 1.5 * l);
    }
    QVERIFY(sharpestTurn(document, 1) <= radians(90) + 1e-3);
}

void BrushGestureTest::drawnStroke_fromTheFootOfASeedling_neverFolds_data()
{
    QTest::addColumn<double>("x0");
    QTest::addColumn<double>("y0");
    QTest::addColumn<double>("x1");
    QTest::addColumn<double>("y1");
    QTest::addColumn<double>("sharpest");
    QTest::newRow("straight up") << 0.0 << 0.0 << 0.0 << 1.0 << 5.0;
    QTest::newRow("from below the ground") << 0.0 << -0.2 << 0.0 << 1.0 << 5.0;
    QTest::newRow("from beside the foot") << 0.03 << 0.01 << 0.03 << 1.0 << 30.0;
    QTest::newRow("leaning") << 0.0 << 0.0 << 0.5 << 1.0 << 60.0;
    QTest::newRow("along the ground") << 0.0 << 0.0 << 1.0 << 0.0 << 90.0;
}

void BrushGestureTest::drawnStroke_fromTheFootOfASeedling_neverFolds()
{
    QFETCH(const double, x0);
    QFETCH(const double, y0);
    QFETCH(const double, x1);
    QFETCH(const double, y1);
    QFETCH(const double, sharpest);
    const Vec3 from = Eigen::Vector3d(x0, y0, 0.0).cast<float>();
    const Vec3 to = Eigen::Vector3d(x1, y1, 0.0).cast<float>();
    TreeDocument document;
    document.reset(1, parameters());
    brush(document, strokeAlong(std::vector{from, to}, 0.0F, 1.0));
    QVERIFY(document.tree().size() > 6);
    QVERIFY(sharpestTurn(document, 1) <= radians(sharpest) + 1e-3);
    // As long as the stroke: nothing is drawn twice.
    const auto l = static_cast<float>(document.parameters().growth.internodeLength);
    QVERIFY(static_cast<float>(document.tree().size()) * l < (to - from).norm() + 2.5F * l);
}

void BrushGestureTest::drawnStroke_neverTurnsByMoreThanARightAngle()
{
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
        TreeDocument document;
        document.reset(seed, parameters());
        Random random(seed, 5, 0, Purpose::Direction);
        std::vector<Vec3> line{Vec3::Zero()};
        for (int i = 0; i < 12; ++i)
            line.push_back(Vec3(0.0F, 1.0F, 0.0F) + random.inBall());
        brush(document, strokeAlong(line, 0.0F, 3.0));
        QVERIFY(document.tree().size() > 30);
        QVERIFY2(sharpestTurn(document, 1) <= radians(90) + 1e-3,
                 qPrintable(QStringLiteral("seed %1").arg(seed)));
    }
}

void BrushGestureTest::drawnStroke_staysAboveTheGround()
{
    TreeDocument document;
    document.reset(1, parameters());
    brush(document,
          strokeAlong(std::vector{Vec3(0, 0, 0), Vec3(0.5F, 1, 0), Vec3(1, -0.5F, 0), Vec3(2, -0.5F, 0)},
                      0.0F, 2.0));
    QVERIFY(document.tree().size() > 15);
    for (InternodeId id = 0; id < document.tree().size(); ++id)
        QVERIFY(document.index().nodePosition(id).y() >= -1e-6F);
}

void BrushGestureTest::thinnerBrush_growsFewerShoots()
{
    // Tips that the same stroke adds, on average over some trees, as the brush goes from the occupancy radius
    // to nothing.
    std::vector<double> tips;
    for (const double share : {1.0, 0.75, 0.5, 0.25, 0.0}) {
        double sum = 0.0;
        for (std::uint64_t seed = 1; seed <= 12; ++seed) {
            TreeDocument document;
            growCrown(document, seed);
            const GrowthParameters& p = document.parameters().growth;
            const auto radius = static_cast<float>(share * p.occupancyRadius * p.internodeLength);
            const std::uint32_t size = document.tree().size();
            brush(document,
                  strokeAlong(std::vector{Vec3(0.2F, 1.8F, 0.0F), Vec3(1.8F, 2.2F, 0.0F)}, radius, 2.0));
            int count = 0;
            for (const InternodeId id : bornSince(document, size))
                count += document.index().firstChild(id) == kNoInternode ? 1 : 0;
            sum += count;
            if (share == 0.0)
                QCOMPARE(count, 1);
        }
        tips.push_back(sum / 12.0);
    }
    const QString found =
        QStringLiteral("%1 %2 %3 %4 %5").arg(tips[0]).arg(tips[1]).arg(tips[2]).arg(tips[3]).arg(tips[4]);
    QVERIFY2(tips.front() > 3.0, qPrintable(found));
    for (std::size_t i = 1; i < tips.size(); ++i)
        QVERIFY2(tips[i] < 1.1 * tips[i - 1], qPrintable(found));
}

void BrushGestureTest::strokeThatThinsOut_endsInOneAxis()
{
    TreeDocument document;
    growCrown(document);
    BrushGesture gesture(document, {0.0, Vec3(0.0F, 1.8F, 0.0F), 0.4F});
    gesture.add({1.0, Vec3(0.8F, 2.0F, 0.0F), 0.4F});
    gesture.add({1.2, Vec3(1.0F, 2.0F, 0.0F), 0.0F});
    const std::uint32_t size = document.tree().size();
    gesture.add({2.0, Vec3(2.5F, 2.0F, 0.0F), 0.0F});
    gesture.finish();
    const auto born = bornSince(document, size);
    QVERIFY(born.size() > 5);
    for (std::size_t i = 1; i < born.size(); ++i)
        QCOMPARE(document.tree().parent(born[i]), born[i - 1]);
}

void BrushGestureTest::tropismFromStroke_bendsGrowthAlongTheStroke()
{
    double withStroke = 0.0;
    double without = 0.0;
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        for (const bool fromStroke : {true, false}) {
            TreeParameters with = parameters(0.2);
            with.growth.axisWeight = 0.3;
            with.growth.tropismWeight = 0.6;
            with.growth.spaceWeight = 0.1;
            with.growth.setPointAngle = 0.0;
            TreeDocument document;
            growCrown(document, seed, with);
            with.growth.tropismFromStroke = fromStroke;
            setParameters(document, with);
            const std::uint32_t size = document.tree().size();
            brush(document,
                  strokeAlong(std::vector{Vec3(0.0F, 1.6F, 0.0F), Vec3(1.5F, 1.6F, 0.0F)}, 0.4F, 2.0));
            const auto born = bornSince(document, size);
            double sum = 0.0;
            for (const InternodeId id : born)
                sum += static_cast<double>(document.index().heading(id).y());
            (fromStroke ? withStroke : without) += sum / static_cast<double>(born.size()) / 6.0;
        }
    }
    QVERIFY2(withStroke + 0.2 < without, qPrintable(QStringLiteral("%1, %2").arg(withStroke).arg(without)));
}

void BrushGestureTest::uprightTrunk_staysUpWhateverTheBranchesDo()
{
    double upright = 0.0;
    double leaning = 0.0;
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        for (const bool isUpright : {true, false}) {
            TreeParameters with = parameters(0.2);
            with.growth.setPointAngle = radians(120);
            with.growth.axisWeight = 0.4;
            with.growth.tropismWeight = 0.5;
            with.growth.spaceWeight = 0.1;
            with.growth.uprightTrunk = isUpright;
            TreeDocument document;
            document.reset(seed, with);
            grow(document, 15);
            double sum = 0.0;
            int count = 0;
            for (InternodeId id = 1; id < document.tree().size(); ++id) {
                if (document.index().axis(id) != 0)
                    continue;
                sum += static_cast<double>(document.index().heading(id).y());
                ++count;
            }
            QVERIFY(count > 3);
            (isUpright ? upright : leaning) += sum / count / 6.0;
        }
    }
    QVERIFY2(upright > 0.95, qPrintable(QString::number(upright)));
    QVERIFY2(leaning < 0.7, qPrintable(QString::number(leaning)));
}

void BrushGestureTest::selectedBranch_growsAlone()
{
    int strokes = 0;
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        TreeDocument document;
        growCrown(document, seed);
        const Tree& tree = document.tree();
        const TreeIndex& index = document.index();
        // A lateral bud near the crown's edge.
        InternodeId node = 0;
        for (InternodeId id = 1; id < tree.size(); ++id) {
            if (tree.isAlive(id) && (tree.buds(id) & budBit(0)) != 0 &&
                index.nodePosition(id).x() > index.nodePosition(node).x())
                node = id;
        }
        const std::uint32_t size = tree.size();
        const Vec3 from = index.nodePosition(node);
        brush(document, strokeAlong(std::vector{from, Vec3(from + Vec3(1.2F, 0.2F, 0.0F))}, 0.4F, 2.0),
              {node, 0});
        const auto born = bornSince(document, size);
        strokes += born.empty() ? 0 : 1;
        for (const InternodeId id : born)
            QVERIFY(descendsFrom(tree, id, node, 0));
    }
    QVERIFY(strokes >= 4);
}

void BrushGestureTest::parametersChangedBetweenStrokes_leaveWhatStood()
{
    TreeDocument document;
    growCrown(document);
    const InternodeColumns before = document.tree().columns();
    const TreeIndex indexBefore = document.index();
    const std::uint32_t size = document.tree().size();
    TreeParameters with = document.parameters();
    with.growth.internodeLength = 0.17;
    with.growth.irregularity = 0.0;
    with.growth.straightening = 0.0; // It turns what stands already
    with.growth.branchingAngle = radians(80);
    with.growth.lateralsPerNode = 3;
    setParameters(document, with);
    brush(document, strokeAlong(std::vector{Vec3(-0.8F, 1.6F, 0.0F), Vec3(1.2F, 2.6F, 0.2F)}, 0.8F, 2.0));
    QVERIFY(bornSince(document, size).size() > 10);

    const InternodeColumns& after = document.tree().columns();
    for (InternodeId id = 0; id < size; ++id) {
        QCOMPARE(after.parameterSet[id], before.parameterSet[id]);
        QCOMPARE(after.length[id], before.length[id]);
        QVERIFY(after.rotation[id].coeffs() == before.rotation[id].coeffs());
        QCOMPARE(document.index().nodePosition(id), indexBefore.nodePosition(id));
        // Buds can only have been used up.
        QCOMPARE(after.buds[id].active() & ~before.buds[id].active(), 0);
    }
    for (const InternodeId id : bornSince(document, size)) {
        QVERIFY(document.tree().parametersOf(id) == with);
        QVERIFY(std::abs(document.tree().length(id) - 0.17F) < 1e-6F);
    }
}

void BrushGestureTest::liveMarkers_areShownWhileBrushing()
{
    TreeDocument document;
    growCrown(document);
    BrushGesture gesture(document, {0.0, Vec3(1.2F, 2.6F, 0.0F), 0.5F});
    QVERIFY(gesture.markers().empty());
    gesture.add({0.2, Vec3(1.3F, 2.6F, 0.0F), 0.5F});
    QVERIFY(!gesture.markers().empty());
    for (const Vec3& marker : gesture.markers())
        QVERIFY((marker - Vec3(1.25F, 2.6F, 0.0F)).norm() < 0.56F);
    gesture.add({0.4, Vec3(1.3F, 2.6F, 0.0F), 0.0F}); // drawing needs none
    QVERIFY(gesture.markers().empty());
}

const TestClass<BrushGestureTest> brushGestureTest;

} // namespace espalier::test

#include "BrushGestureTest.moc"
