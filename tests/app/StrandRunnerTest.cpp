// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/runners/StrandRunner.h"

#include "app/runners/Background.h"
#include "commands/ProfileEdits.h"
#include "commands/Prune.h"
#include "model/strands/ProfileShapes.h"
#include "tests/support/Strands.h"
#include "tests/support/TestClasses.h"

#include <QSignalSpy>
#include <QTest>

#include <algorithm>
#include <array>
#include <memory>
#include <set>
#include <vector>

using namespace espalier;

namespace {

constexpr int kRunnerPatience = 60'000; ///< ms

/// A document of a tree with so many tips, whose wood is strands.
void fill(TreeDocument& document, std::uint32_t tips, StrandPacking packing = StrandPacking::Rest)
{
    TreeParameters parameters;
    parameters.wood.packing = packing;
    parameters.wood.mesher = WoodMesherKind::Strands;
    document.reset(test::forkedTree(tips, parameters).tree, {});
}

void drawProfile(TreeDocument& document, InternodeId id)
{
    setProfile(document, std::array{id}, profileOf(ProfileShape::CShape));
}

/// What progressed() has told.
std::vector<double> sharesOf(const QSignalSpy& progressed)
{
    std::vector<double> shares;
    for (const QList<QVariant>& arguments : progressed)
        shares.push_back(arguments[0].toDouble());
    return shares;
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
    void packing_tellsItsProgress();
    void editWhileProgressIsTold_goesOnTelling();
    void tubes_areNotItsWork();
    void destroyedAtWork_stopsTheWork();
    void fibresAskedForMeanwhile_comeWithTheMesh();
    void fibresNotWantedAnyMore_stopTheWork();
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
    fill(document, 14'600);
    QTRY_VERIFY_WITH_TIMEOUT(runner.isRunning(), kRunnerPatience);
    drawProfile(document, 2);
    QCOMPARE(meshed.count(), 0);
    QTRY_COMPARE_WITH_TIMEOUT(meshed.count(), 1, kRunnerPatience);
    QCOMPARE(meshed.front()[1].toULongLong(), document.revision());
    QVERIFY(!runner.isRunning());
}

void StrandRunnerTest::cancel_stopsTheWorkUntilTheTreeChanges()
{
    TreeDocument document;
    StrandRunner runner(document);
    QSignalSpy meshed(&runner, &StrandRunner::meshed);
    QSignalSpy cancelled(&runner, &StrandRunner::cancelled);
    runner.cancel();
    QCOMPARE(cancelled.count(), 0);
    fill(document, 14'600);
    QTRY_VERIFY_WITH_TIMEOUT(runner.isRunning(), kRunnerPatience);
    QElapsedTimer timer;
    timer.start();
    runner.cancel();
    QCOMPARE(cancelled.count(), 1);
    QTRY_VERIFY_WITH_TIMEOUT(!runner.isRunning(), kRunnerPatience);
    const qint64 stopped = timer.elapsed();
    QTest::qWait(200);
    QVERIFY(!runner.isRunning());
    QCOMPARE(meshed.count(), 0);
    timer.start();
    drawProfile(document, 2);
    QTRY_COMPARE_WITH_TIMEOUT(meshed.count(), 1, kRunnerPatience);
    // This work was done whole; the other one had only begun.
    QVERIFY2(stopped < timer.elapsed() / 2, qPrintable(QString::number(stopped)));
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
    QCOMPARE(ended.count(), 0);
    runner.setPatience(0);
    fill(document, 14'600);
    QTRY_COMPARE_WITH_TIMEOUT(meshed.count(), 2, kRunnerPatience);
    QCOMPARE(ended.count(), 1);
    const std::vector<double> shares = sharesOf(progressed);
    QVERIFY(shares.size() > 10);
    QVERIFY(std::ranges::is_sorted(shares));
    QVERIFY2(shares.front() < 0.2 && shares.back() > 0.8 && shares.back() <= 1.0,
             qPrintable(QStringLiteral("%1 to %2").arg(shares.front()).arg(shares.back())));
    // It neither stands still for long nor jumps.
    for (std::size_t i = 1; i < shares.size(); ++i)
        QVERIFY2(shares[i] - shares[i - 1] < 0.3, qPrintable(QString::number(shares[i])));
}

void StrandRunnerTest::packing_tellsItsProgress()
{
    TreeDocument document;
    StrandRunner runner(document);
    runner.setPatience(0);
    QSignalSpy meshed(&runner, &StrandRunner::meshed);
    QSignalSpy progressed(&runner, &StrandRunner::progressed);
    fill(document, 1500, StrandPacking::Pbd);
    QTRY_COMPARE_WITH_TIMEOUT(meshed.count(), 1, kRunnerPatience);
    const std::vector<double> shares = sharesOf(progressed);
    QVERIFY(std::ranges::is_sorted(shares));
    const std::set<double> early(shares.begin(), std::ranges::lower_bound(shares, 0.3));
    QVERIFY2(early.size() > 5, qPrintable(QString::number(early.size())));
}

void StrandRunnerTest::editWhileProgressIsTold_goesOnTelling()
{
    TreeDocument document;
    StrandRunner runner(document);
    runner.setPatience(0);
    QSignalSpy meshed(&runner, &StrandRunner::meshed);
    QSignalSpy progressed(&runner, &StrandRunner::progressed);
    QSignalSpy ended(&runner, &StrandRunner::ended);
    fill(document, 5000);
    QTRY_VERIFY_WITH_TIMEOUT(progressed.count() > 2, kRunnerPatience);
    drawProfile(document, 2);
    QTRY_COMPARE_WITH_TIMEOUT(meshed.count(), 1, kRunnerPatience);
    QCOMPARE(ended.count(), 1);
    const std::vector<double> shares = sharesOf(progressed);
    QVERIFY(shares.back() > 0.5);
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

void StrandRunnerTest::destroyedAtWork_stopsTheWork()
{
    TreeDocument document;
    auto runner = std::make_unique<StrandRunner>(document);
    QSignalSpy meshed(runner.get(), &StrandRunner::meshed);
    fill(document, 14'600);
    QTRY_VERIFY_WITH_TIMEOUT(runner->isRunning(), kRunnerPatience);
    QElapsedTimer timer;
    timer.start();
    runner.reset();
    QVERIFY(timer.elapsed() < 500); // The window does not wait for the work
    QVERIFY(backgroundThreads().waitForDone(kRunnerPatience));
    // The work that was under way ends after the runner; its result has no receiver any more.
    QCoreApplication::processEvents();
    QCOMPARE(meshed.count(), 0);
    drawProfile(document, 2);
    QTest::qWait(100);
    QCOMPARE(backgroundThreads().activeThreadCount(), 0);
}

void StrandRunnerTest::fibresAskedForMeanwhile_comeWithTheMesh()
{
    TreeDocument document;
    StrandRunner runner(document);
    std::shared_ptr<const ShownStrands> shown;
    int count = 0;
    connect(&runner, &StrandRunner::meshed, this, [&](const std::shared_ptr<const ShownStrands>& strands) {
        shown = strands;
        ++count;
    });
    fill(document, 5000);
    QTRY_VERIFY_WITH_TIMEOUT(runner.isRunning(), kRunnerPatience);
    runner.setFibresShown(true);
    QTRY_VERIFY_WITH_TIMEOUT(count > 0, kRunnerPatience);
    QCOMPARE(count, 1); // The work without fibres was stopped
    QVERIFY(shown->hasFibres && !shown->fibres.empty() && shown->hasMesh());
    QTRY_VERIFY_WITH_TIMEOUT(!runner.isRunning(), kRunnerPatience);
}

void StrandRunnerTest::fibresNotWantedAnyMore_stopTheWork()
{
    TreeDocument document;
    StrandRunner runner(document);
    QSignalSpy meshed(&runner, &StrandRunner::meshed);
    document.reset(test::forkedTree(14'600).tree, {}); // Tubes
    runner.setFibresShown(true);
    QTRY_VERIFY_WITH_TIMEOUT(runner.isRunning(), kRunnerPatience);
    runner.setFibresShown(false);
    QTRY_VERIFY_WITH_TIMEOUT(!runner.isRunning(), kRunnerPatience);
    QTest::qWait(100);
    QVERIFY(!runner.isRunning());
    QCOMPARE(meshed.count(), 0);
}

static const test::TestClass<StrandRunnerTest> strandRunnerTest;

#include "StrandRunnerTest.moc"
