// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/project/JournalCheck.h"

#include "commands/DocumentProject.h"
#include "model/document/Edit.h"
#include "tests/support/Documents.h"
#include "tests/support/SampleProject.h"
#include "tests/support/TestClasses.h"
#include "tests/support/ZipEntries.h"

#include <QElapsedTimer>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include <array>
#include <atomic>
#include <cstring>
#include <functional>
#include <thread>

namespace espalier::test {

/// The check of histories, which the reader and the writer of project files share.
class JournalCheckTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void placedLeaves_areRemovedUndoneTravelledAndSaved();
    void wrongHistories_areRefused_data();
    void wrongHistories_areRefused();
    void emptyDeltas_areRefusedBeforeTheyAreMade();
    void moreChangesThanRows_areRefused();
    void farNodes_areRefusedAtEachMoment_data();
    void farNodes_areRefusedAtEachMoment();
    void longFoldedTree_isSavedAndOpened();
    void shownTree_canBeMadeWhileTheDocumentTravels();
};

namespace {

Project projectOf(TreeBuilder builder)
{
    Project project;
    project.tree = builder.tree;
    for (TreeDelta& delta : builder.journal) {
        project.journal.push_back(std::make_shared<TreeDelta>(std::move(delta)));
        project.journal.back()->rows.reset();
    }
    return project;
}

QString packingFault(const Project& project)
{
    const Result<QByteArray> packed = packProject(project);
    return packed ? QString() : packed.error().message;
}

/// Compares a document with what its file holds. Returns what differs, or an empty text.
QString fileFault(const TreeDocument& document)
{
    const Project project = espalier::projectOf(document, QStringLiteral("ash"));
    const Result<QByteArray> packed = packProject(project);
    if (!packed)
        return packed.error().message;
    const Result<Project> back = unpackProject(*packed);
    if (!back)
        return back.error().message;
    if (!(back->tree == project.tree) || !sameJournal(back->journal, project.journal))
        return QStringLiteral("another tree or history");
    if (!(shownTree(*back) == document.tree()))
        return QStringLiteral("another moment is shown");
    if (*packProject(*back) != *packed)
        return QStringLiteral("other bytes");
    return survivesItsHistory(*back) ? QString() : QStringLiteral("the history does not lead back");
}

} // namespace

void JournalCheckTest::placedLeaves_areRemovedUndoneTravelledAndSaved()
{
    TreeDocument document;
    const Project grown = projectOf(randomTree(30, 3));
    document.reset(grown.tree, grown.journal);
    std::vector<DocumentState> states{DocumentState(document)};
    const auto edit = [&](TreeDelta delta) {
        apply(document, std::move(delta));
        states.emplace_back(document);
    };
    edit(leafPlacement(document.tree(), std::array<InternodeId, 3>{4, 7, 9}));
    edit(leafRemoval(document.tree(), 1));
    edit(leafChange(document.tree(), 2, 5, LeafKind::Fruit));
    edit(randomGrowth(document.tree(), 10));
    edit(leafRemoval(document.tree(), 0));
    QCOMPARE(document.tree().placedLeaves().death,
             (QList<Step>{document.tree().step(), document.tree().step() - 1, kNever}));
    QCOMPARE(fileFault(document), QString());

    for (std::size_t i = states.size() - 1; i-- > 0;) {
        document.undo();
        QCOMPARE(differenceFrom(states[i], document), QString());
        QCOMPARE(fileFault(document), QString());
    }
    for (std::size_t i = 1; i < states.size(); ++i) {
        document.redo();
        QCOMPARE(differenceFrom(states[i], document), QString());
        QCOMPARE(fileFault(document), QString());
    }
    const std::size_t end = document.journal().size();
    for (std::size_t i = 0; i < states.size(); ++i) {
        travel(document, end - i);
        QVERIFY(document.tree() == states[states.size() - 1 - i].tree);
        QCOMPARE(fileFault(document), QString());
    }
}

void JournalCheckTest::wrongHistories_areRefused_data()
{
    QTest::addColumn<Tree>("tree");
    QTest::addColumn<Journal>("journal");
    QTest::addColumn<QString>("message");
    // Step 1 grows, step 2 places two leaves, step 3 removes the first, step 4 grows.
    const auto row = [](const char* title, const char* message,
                        const std::function<void(TreeBuilder&)>& addSteps) {
        TreeBuilder builder;
        builder.growAxis(0, kTerminalSlot, continuing(), 10);
        builder.apply(leafPlacement(builder.tree, std::array<InternodeId, 2>{4, 7}));
        builder.apply(leafRemoval(builder.tree, 0));
        builder.apply(randomGrowth(builder.tree, 10));
        addSteps(builder);
        const Project project = projectOf(std::move(builder));
        QTest::newRow(title) << project.tree << project.journal << QString::fromUtf8(message);
    };
    const auto edit = [](TreeBuilder& b, const std::function<void(TreeDelta&)>& change) {
        TreeDelta delta = deltaStartingAt(b.tree);
        change(delta);
        b.apply(std::move(delta));
    };
    row("nothing is wrong", "", [](TreeBuilder&) {});
    row("a dead leaf revives", "step 5 of the history: it changes “death” in a way that is not possible",
        [&](TreeBuilder& b) {
            edit(b, [](TreeDelta& delta) { delta.leaves.death.push_back({0, 1, kNever}); });
        });
    row("a dead leaf dies", "step 5 of the history: it changes “death” in a way that is not possible",
        [](TreeBuilder& b) { b.apply(leafRemoval(b.tree, 0)); });
    row("a leaf dies at another time",
        "step 5 of the history: it changes “death” in a way that is not possible", [&](TreeBuilder& b) {
            edit(b, [](TreeDelta& delta) { delta.leaves.death.push_back({1, kNever, 1}); });
        });
    row("a leaf dies in the step that places it", "step 5 of the history: it places a leaf that is not there",
        [](TreeBuilder& b) {
            TreeDelta delta = leafPlacement(b.tree, std::array<InternodeId, 1>{4});
            delta.leaves.death.push_back({2, kNever, b.tree.step()});
            b.apply(std::move(delta));
        });
    row("a leaf is placed dead", "step 5 of the history: it places a leaf that is not there",
        [](TreeBuilder& b) {
            TreeDelta delta = leafPlacement(b.tree, std::array<InternodeId, 1>{4});
            delta.rows->leaves.death[0] = b.tree.step();
            b.apply(std::move(delta));
        });
    row("a leaf is placed at another time", "step 5 of the history: it places a leaf at another time",
        [](TreeBuilder& b) {
            TreeDelta delta = leafPlacement(b.tree, std::array<InternodeId, 1>{4});
            delta.rows->leaves.birth[0] = 1;
            b.apply(std::move(delta));
        });
    row("a leaf's birth changes", "step 5 of the history: it changes “birth”, which never changes",
        [&](TreeBuilder& b) { edit(b, [](TreeDelta& delta) {
                                  delta.leaves.birth.push_back({1, 1, 2});
                              }); });
    row("a leaf comes from an internode that is not there",
        "step 5 of the history: it changes “internode” in a way that is not possible", [&](TreeBuilder& b) {
            edit(b, [](TreeDelta& delta) { delta.leaves.internode.push_back({1, 700, 7}); });
        });
    row("a leaf comes from an internode that is born later",
        "step 6 of the history: it changes “internode” in a way that is not possible", [&](TreeBuilder& b) {
            edit(b, [&](TreeDelta& delta) { delta.leaves.internode.push_back({1, 7, b.tree.size()}); });
            TreeDelta growth = randomGrowth(b.tree, 3);
            growth.leaves.internode.push_back({1, b.tree.size(), 7});
            b.apply(std::move(growth));
        });
    row("a leaf waits for its internode",
        "step 5 of the history: it changes “internode” in a way that is not possible", [&](TreeBuilder& b) {
            edit(b, [&](TreeDelta& delta) { delta.leaves.internode.push_back({1, 7, b.tree.size()}); });
            b.apply(randomGrowth(b.tree, 3));
        });
    row("an internode dies twice", "step 5 of the history: it changes “death”, which never changes",
        [&](TreeBuilder& b) {
            edit(b, [](TreeDelta& delta) { delta.internodes.death.push_back({3, kNever, 2}); });
        });
    row("an internode grew with parameters that are not there",
        "step 5 of the history: it changes “parameterSet”, which never changes", [&](TreeBuilder& b) {
            edit(b, [](TreeDelta& delta) { delta.internodes.parameterSet.push_back({3, 60'000, 0}); });
        });
    row("an internode grows with later parameters",
        "step 5 of the history: it creates an internode whose parameters are not there", [](TreeBuilder& b) {
            TreeDelta delta = randomGrowth(b.tree, 1);
            delta.rows->internodes.parameterSet[0] = 1;
            b.apply(std::move(delta));
            TreeParameters parameters;
            parameters.growth.shedding = 0.3;
            b.apply(parameterChange(b.tree, parameters));
        });
    row("nothing", "step 5 of the history: it changes nothing",
        [](TreeBuilder& b) { b.apply(deltaStartingAt(b.tree)); });
}

void JournalCheckTest::wrongHistories_areRefused()
{
    QFETCH(const Tree, tree);
    QFETCH(const Journal, journal);
    QFETCH(const QString, message);
    const Result<void> sound = checkJournal(tree, journal);
    const QString fault = sound ? QString() : sound.error().message;
    QVERIFY2(message.isEmpty() ? fault.isEmpty() : fault.startsWith(message), qPrintable(fault));
}

void JournalCheckTest::emptyDeltas_areRefusedBeforeTheyAreMade()
{
    // The description of a seedling's file claims the greatest number of deltas, of which the file has
    // nothing.
    for (const int ahead : {0, 4'000'000}) {
        ZipEntries entries = unpackEntries(*packProject({}));
        QJsonObject json = QJsonDocument::fromJson(entry(entries, "project.json")).object();
        json[QStringLiteral("deltas")] = 4'000'000;
        json[QStringLiteral("ahead")] = ahead;
        entry(entries, "project.json") = QJsonDocument(json).toJson();
        const QByteArray file = packEntries(entries);
        QVERIFY(file.size() < 4'000);
        QElapsedTimer timer;
        timer.start();
        const Result<Project> project = unpackProject(file);
        const qint64 time = timer.elapsed();
        QVERIFY(!project);
        QCOMPARE(project.error().message, QStringLiteral("step 1 of the history: it changes nothing"));
        QVERIFY2(time < 100, qPrintable(QString::number(time)));
    }
}

void JournalCheckTest::moreChangesThanRows_areRefused()
{
    // One delta claims a million changes in a tree of 50 internodes.
    const QByteArray good = *packProject(sampleProject(50));
    for (const char* column : {"internodes.rotation", "leaves.internode", "sparse.width", "lassos", "died"}) {
        ZipEntries entries = unpackEntries(good);
        const QByteArray name = QByteArray("journal/") + column;
        QByteArray& count = entry(entries, name + ".count");
        const std::uint32_t million = 1'000'000;
        std::memcpy(count.data(), &million, sizeof(million));
        const Result<Project> project = unpackProject(packEntries(entries));
        QVERIFY(!project);
        QVERIFY2(project.error().message.startsWith(QStringLiteral("the history: its parts do not add up")),
                 qPrintable(project.error().message));
    }
}

namespace {

constexpr std::uint32_t kLongAxis = 20;

/// An axis of 20 internodes of 1 km each, folded: each lies against the one before. It reaches 1 km far.
TreeBuilder foldedAxis()
{
    TreeBuilder builder;
    const Rotation back(Eigen::AngleAxisf(std::numbers::pi_v<float>, Vec3::UnitZ()));
    builder.growAxis(0, kTerminalSlot, Rotation::Identity(), kLongAxis, back, 1000.0F);
    return builder;
}

/// An edit that turns all internodes of the axis but the first two.
TreeDelta turnAll(const Tree& tree, const Rotation& after)
{
    TreeDelta delta = deltaStartingAt(tree);
    for (InternodeId id = 2; id <= kLongAxis; ++id)
        delta.addFrame(id, tree.columns().rotation[id], after, tree.length(id), tree.length(id));
    return delta;
}

const Rotation kBack(0.0F, 0.0F, 0.0F, 1.0F);

} // namespace

void JournalCheckTest::farNodes_areRefusedAtEachMoment_data()
{
    QTest::addColumn<Tree>("tree");
    QTest::addColumn<Journal>("journal");
    QTest::addColumn<QString>("message");
    const auto row = [](const char* title, TreeBuilder builder, const char* message) {
        const Project project = projectOf(std::move(builder));
        QTest::newRow(title) << project.tree << project.journal << QString::fromUtf8(message);
    };
    const auto straighten = [](TreeBuilder& b) { b.apply(turnAll(b.tree, Rotation::Identity())); };

    TreeBuilder builder = foldedAxis();
    straighten(builder);
    row("at the end", builder, "internode 10: it lies more than 10000 m away");
    builder.apply(turnAll(builder.tree, kBack));
    row("before the last step", builder,
        "step 3 of the history: before it, internode 10 lies more than 10000 m away");
    builder.apply(randomGrowth(builder.tree, 3));
    builder.apply(bend(builder.tree, 1, Rotation(Eigen::AngleAxisf(0.5F, Vec3::UnitX())), 1.0F));
    row("before some steps", builder,
        "step 3 of the history: before it, internode 10 lies more than 10000 m away");

    TreeBuilder lengths = foldedAxis();
    TreeDelta shrink = turnAll(lengths.tree, Rotation::Identity());
    for (InternodeId id = 1; id <= kLongAxis; ++id)
        shrink.internodes.length.push_back({id, 1000.0F, 1.0F});
    lengths.apply(std::move(shrink));
    TreeDelta grow = deltaStartingAt(lengths.tree);
    for (InternodeId id = 1; id <= kLongAxis; ++id)
        grow.internodes.length.push_back({id, 1.0F, 900.0F});
    lengths.apply(std::move(grow));
    TreeDelta again = deltaStartingAt(lengths.tree);
    for (InternodeId id = 1; id <= kLongAxis; ++id)
        again.internodes.length.push_back({id, 900.0F, 1.0F});
    lengths.apply(std::move(again));
    row("by lengths", lengths, "step 4 of the history: before it, internode 12 lies more than 10000 m away");

    TreeBuilder root;
    root.growAxis(0, kTerminalSlot, Rotation::Identity(), 10, Rotation::Identity(), 950.0F);
    TreeDelta away = deltaStartingAt(root.tree);
    away.sparse.rootPosition.push_back({0, std::nullopt, Vec3(0.0F, 1000.0F, 0.0F)});
    root.apply(std::move(away));
    TreeDelta home = deltaStartingAt(root.tree);
    home.sparse.rootPosition.push_back({0, Vec3(0.0F, 1000.0F, 0.0F), std::nullopt});
    root.apply(std::move(home));
    row("by the root", root, "step 3 of the history: before it, internode 10 lies more than 10000 m away");
}

void JournalCheckTest::farNodes_areRefusedAtEachMoment()
{
    QFETCH(const Tree, tree);
    QFETCH(const Journal, journal);
    QFETCH(const QString, message);
    for (const std::uint32_t ahead : {0U, 1U})
        QCOMPARE(packingFault({tree, journal, {}, {}, ahead}), message);
}

void JournalCheckTest::longFoldedTree_isSavedAndOpened()
{
    TreeBuilder builder = foldedAxis();
    builder.apply(bend(builder.tree, 5, Rotation(Eigen::AngleAxisf(0.5F, Vec3::UnitX())), 0.5F));
    builder.apply(bend(builder.tree, 5, Rotation(Eigen::AngleAxisf(-0.5F, Vec3::UnitX())), 2.0F));
    const Project project = projectOf(std::move(builder));
    const Result<QByteArray> packed = packProject(project);
    QVERIFY2(packed, packed ? "" : qPrintable(packed.error().message));
    QVERIFY(unpackProject(*packed)->tree == project.tree);
}

void JournalCheckTest::shownTree_canBeMadeWhileTheDocumentTravels()
{
    // A history so short that the worker and the document meet at the same delta all the time.
    TreeDocument document;
    for (std::uint64_t i = 0; i < 2; ++i)
        apply(document, randomGrowth(document.tree(), 1, i));
    const std::size_t end = document.journal().size();
    travel(document, 0);
    const Tree shown = document.tree();
    const Project project = espalier::projectOf(document, QStringLiteral("ash"));
    const QByteArray packed = *packProject(project);

    std::atomic<bool> hasEnded = false;
    std::atomic<int> wrong = 0;
    std::thread worker([&] {
        for (int i = 0; i < 1'000'000; ++i)
            wrong += shownTree(project) == shown ? 0 : 1;
        for (int i = 0; i < 20; ++i)
            wrong += *packProject(project) == packed ? 0 : 1;
        hasEnded = true;
    });
    Edit edit(document);
    while (!hasEnded) {
        edit.travelTo(end);
        edit.travelTo(0);
    }
    worker.join();
    edit.cancel();
    QCOMPARE(wrong.load(), 0);
    QVERIFY(document.tree() == shown);
}

static const TestClass<JournalCheckTest> journalCheckTest;

} // namespace espalier::test

#include "JournalCheckTest.moc"
