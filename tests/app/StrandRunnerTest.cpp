// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/runners/StrandRunner.h"

#include "commands/ProfileEdits.h"
#include "commands/Prune.h"
#include "model/strands/ProfileShapes.h"
#include "tests/support/Strands.h"
#include "tests/support/TestClasses.h"

#include <QSignalSpy>
#include <QTest>

#include <array>

using namespace espalier;

namespace {

constexpr int kRunnerPatience = 60'000; ///< ms

/// A document of a tree with so many tips, whose wood is strands.
void fill(TreeDocument& document, std::uint32_t tips)
{
    TreeParameters parameters;
    parameters.wood.mesher = WoodMesherKind::Strands;
    document.reset(test::forkedTree(tips, parameters).tree, {});
}

void drawProfile(TreeDocument& document, InternodeId id)
{
    setProfile(document, std::array{id}, profileOf(ProfileShape::CShape));
}

} // namespace

/// The mesh of strands that another thread makes.
class StrandRunnerTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void mesh_isThatOfThePresentTree();
    void edit_takesOverWhatItLeaves();
    void editMeanwhile_stopsTheWork();
    void cancel_stopsTheWorkUntilTheTreeChanges();
    void longWork_tellsItsProgress();
    void tubes_areNotItsWork();
};

void StrandRunnerTest::mesh_isThatOfThePresentTree()
{
    TreeDocument document;
    StrandRunner runner(document);
    QSignalSpy meshed(&runner, &StrandRunner::meshed);
    fill(document, 300);
    QTRY_COMPARE_WITH_TIMEOUT(meshed.count(), 1, kRunnerPatience);
    QCOMPARE(meshed.front()[1].toULongLong(), document.revision());
    const BranchMesh fresh =
        meshStrands(test::layoutsOf(document.tree(), document.index()), document.parameters());
    QVERIFY(std::ranges::equal(runner.last()->mesh->vertices, fresh.vertices));
    QVERIFY(std::ranges::equal(runner.last()->mesh->indices, fresh.indices));
}

void StrandRunnerTest::edit_takesOverWhatItLeaves()
{
    TreeDocument document;
    StrandRunner runner(document);
    QSignalSpy meshed(&runner, &StrandRunner::meshed);
    fill(document, 1500);
    QTRY_COMPARE_WITH_TIMEOUT(meshed.count(), 1, kRunnerPatience);
    QCOMPARE(runner.last()->taken, 0U);
    drawProfile(document, 2);
    QTRY_COMPARE_WITH_TIMEOUT(meshed.count(), 2, kRunnerPatience);
    QVERIFY(runner.last()->taken > 9 * runner.last()->layouts->skeleton().nodes.size() / 10);
    const BranchMesh fresh =
        meshStrands(test::layoutsOf(document.tree(), document.index()), document.parameters());
    QVERIFY(std::ranges::equal(runner.last()->mesh->vertices, fresh.vertices));
}

void StrandRunnerTest::editMeanwhile_stopsTheWork()
{
    TreeDocument document;
    StrandRunner runner(document);
    QSignalSpy meshed(&runner, &StrandRunner::meshed);
    QSignalSpy ended(&runner, &StrandRunner::ended);
    fill(document, 14'600);
    QTRY_VERIFY_WITH_TIMEOUT(runner.isRunning(), kRunnerPatience);
    QElapsedTimer timer;
    timer.start();
    drawProfile(document, 2);
    QTRY_COMPARE_WITH_TIMEOUT(ended.count(), 1, kRunnerPatience);
    const qint64 stopped = timer.elapsed();
    QCOMPARE(meshed.count(), 0);
    QTRY_COMPARE_WITH_TIMEOUT(meshed.count(), 1, kRunnerPatience);
    QCOMPARE(meshed.front()[1].toULongLong(), document.revision());
    // The second one was made whole; the first one had only begun.
    QVERIFY2(stopped < timer.elapsed() / 2, qPrintable(QString::number(stopped)));
}

void StrandRunnerTest::cancel_stopsTheWorkUntilTheTreeChanges()
{
    TreeDocument document;
    StrandRunner runner(document);
    QSignalSpy meshed(&runner, &StrandRunner::meshed);
    QSignalSpy cancelled(&runner, &StrandRunner::cancelled);
    runner.cancel();
    QCOMPARE(cancelled.count(), 0);
    fill(document, 5000);
    QTRY_VERIFY_WITH_TIMEOUT(runner.isRunning(), kRunnerPatience);
    runner.cancel();
    QCOMPARE(cancelled.count(), 1);
    QTRY_VERIFY_WITH_TIMEOUT(!runner.isRunning(), kRunnerPatience);
    QTest::qWait(200);
    QVERIFY(!runner.isRunning());
    QCOMPARE(meshed.count(), 0);
    drawProfile(document, 2);
    QTRY_COMPARE_WITH_TIMEOUT(meshed.count(), 1, kRunnerPatience);
}

void StrandRunnerTest::longWork_tellsItsProgress()
{
    TreeDocument document;
    StrandRunner runner(document);
    QSignalSpy meshed(&runner, &StrandRunner::meshed);
    QSignalSpy progressed(&runner, &StrandRunner::progressed);
    QSignalSpy ended(&runner, &StrandRunner::ended);
    fill(document, 50); // Work that does not take long
    QTRY_COMPARE_WITH_TIMEOUT(meshed.count(), 1, kRunnerPatience);
    QCOMPARE(progressed.count(), 0);
    runner.setPatience(0);
    fill(document, 14'600);
    QTRY_COMPARE_WITH_TIMEOUT(meshed.count(), 2, kRunnerPatience);
    QCOMPARE(ended.count(), 2);
    QVERIFY(progressed.count() > 2);
    double last = 0.0;
    for (const QList<QVariant>& arguments : progressed) {
        QVERIFY(arguments[0].toDouble() >= last && arguments[0].toDouble() <= 1.0);
        last = arguments[0].toDouble();
    }
    QVERIFY(last > 0.1);
}

void StrandRunnerTest::tubes_areNotItsWork()
{
    TreeDocument document;
    StrandRunner runner(document);
    runner.ask();
    QTest::qWait(100);
    QVERIFY(!runner.isRunning());
    QVERIFY(!runner.last());
}

static const test::TestClass<StrandRunnerTest> strandRunnerTest;

#include "StrandRunnerTest.moc"
