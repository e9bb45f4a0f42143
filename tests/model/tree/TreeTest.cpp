// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/tree/Tree.h"

#include "tests/support/TestClasses.h"
#include "tests/support/TreeBuilder.h"

#include <QTest>

#include <cmath>
#include <unordered_set>

namespace espalier::test {

class TreeTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void newTree_isAnUprightSeedling();
    void revert_restoresWhatApplyChanged();
    void applyAgain_bringsBackTheSameTree();
    void copies_doNotShareWhatChanges();
    void death_leavesRowsAndRevertRevives();
    void undoneRows_leaveNoTrace();
    void keptParameters_areKnownOnce_andGoWhenTheirDeltaIsReverted();
    void manyParameterSets_areRefusedBeforeTheirNumberOverflows();
    void imagesOfAllTime_haveALimit();
    void placedLeaves_comeAndGoWithTheirDelta();
    void attachmentAlong_placesTheBaseOnTheParent();
    void severalRoots_standWhereTheyAre();
    void parameterChange_leavesWhatHasGrown();
    void fromContent_acceptsWhatATreeHolds();
    void fromContent_refusesFaults_data();
    void fromContent_refusesFaults();
    void keysOfOneBucket_areCheckedQuickly();
    void emptyDelta_isEmpty();
};

namespace {

Result<Tree> reread(const Tree& tree, InternodeColumns columns)
{
    TreeContent content = tree.content();
    content.internodes = std::move(columns);
    return Tree::fromContent(std::move(content));
}

} // namespace

void TreeTest::newTree_isAnUprightSeedling()
{
    const Tree tree(7);
    QCOMPARE(tree.size(), 1U);
    QVERIFY(tree.isAlive(0));
    QCOMPARE(tree.parent(0), kNoInternode);
    QCOMPARE(tree.buds(0), kTerminalBud);
    QCOMPARE(tree.seed(), std::uint64_t{7});
    QCOMPARE(tree.step(), 0U);
    const TreeIndex index(tree);
    QVERIFY((index.heading(0) - up()).norm() < 1e-6F);
    QVERIFY(
        (index.nodePosition(0) - static_cast<float>(tree.parameters().growth.internodeLength) * up()).norm() <
        1e-6F);
}

void TreeTest::revert_restoresWhatApplyChanged()
{
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        TreeBuilder builder = randomTree(200, seed);
        std::vector<Tree> before;
        for (int i = 0; i < 5; ++i) {
            before.push_back(builder.tree);
            InternodeId victim = 50;
            while (!builder.tree.isAlive(victim))
                ++victim;
            builder.apply(i % 2 == 0 ? randomGrowth(builder.tree, 30, seed)
                                     : death(builder.tree, builder.index, victim));
        }
        while (!before.empty()) {
            builder.revert();
            QVERIFY(builder.tree == before.back());
            before.pop_back();
        }
    }
}

void TreeTest::applyAgain_bringsBackTheSameTree()
{
    TreeBuilder builder = randomTree(300, 3);
    const Tree done = builder.tree;
    std::vector<TreeDelta> taken;
    while (!builder.journal.empty())
        taken.push_back(builder.revert());
    QVERIFY(!(builder.tree == done));
    QCOMPARE(TreeIndex(builder.tree).livingCount(), 1U);
    const Tree undone = builder.tree;
    for (int round = 0; round < 2; ++round) {
        while (!taken.empty()) {
            builder.apply(std::move(taken.back()));
            taken.pop_back();
        }
        QVERIFY(builder.tree == done);
        while (!builder.journal.empty())
            taken.push_back(builder.revert());
        QVERIFY(builder.tree == undone);
    }
}

void TreeTest::copies_doNotShareWhatChanges()
{
    TreeBuilder builder = randomTree(100, 4);
    const Tree snapshot = builder.tree;
    const Tree same = snapshot;
    builder.apply(death(builder.tree, builder.index, 40));
    builder.apply(randomGrowth(builder.tree, 20, 4));
    QVERIFY(snapshot == same);
    QCOMPARE(snapshot.size(), 100U);
    QVERIFY(snapshot.isAlive(40));
}

void TreeTest::death_leavesRowsAndRevertRevives()
{
    TreeBuilder builder = randomTree(100, 5);
    InternodeId branch = 1;
    while (builder.index.subtreeSize(branch) > 20)
        ++branch;
    const std::uint32_t carried = builder.index.subtreeSize(branch);
    QVERIFY(carried > 1);
    builder.apply(death(builder.tree, builder.index, branch));
    QCOMPARE(builder.tree.size(), 100U);
    QVERIFY(!builder.tree.isAlive(branch));
    QCOMPARE(builder.tree.columns().death[branch], builder.tree.step());
    QCOMPARE(builder.index.livingCount(), 100U - carried);
    builder.revert();
    QVERIFY(builder.tree.isAlive(branch));
    QCOMPARE(builder.index.livingCount(), 100U);
}

void TreeTest::undoneRows_leaveNoTrace()
{
    TreeBuilder builder;
    const Tree before = builder.tree;
    const InternodeId tip = builder.growAxis(0, kTerminalSlot, continuing(), 5);
    TreeDelta growth = builder.revert();
    QVERIFY(builder.tree == before);
    QVERIFY(!builder.tree.isAlive(tip));
    // Meanwhile something else grows under the same ids, and is undone.
    const InternodeId other = builder.grow({.parent = 0});
    QCOMPARE(other, 1U);
    builder.revert();
    builder.apply(std::move(growth));
    QCOMPARE(builder.tree.size(), tip + 1);
    QVERIFY(builder.tree.isAlive(tip));
    QCOMPARE(builder.tree.buds(0) & kTerminalBud, 0);
}

void TreeTest::keptParameters_areKnownOnce_andGoWhenTheirDeltaIsReverted()
{
    TreeBuilder builder;
    TreeParameters parameters;
    const TreeDelta none = parameterChange(builder.tree, parameters);
    QCOMPARE(none.parametersAfter, 0U);
    QVERIFY(!none.bringsRows());
    parameters.growth.shedding = 0.3;
    builder.apply(parameterChange(builder.tree, parameters));
    QCOMPARE(builder.tree.parameterSets().size(), 2);
    QCOMPARE(builder.tree.currentParameterSet(), 1U);
    builder.apply(parameterChange(builder.tree, TreeParameters()));
    builder.apply(parameterChange(builder.tree, parameters));
    QCOMPARE(builder.tree.parameterSets().size(), 2);
    while (!builder.journal.empty())
        builder.revert();
    QVERIFY(builder.tree == Tree());
}

void TreeTest::manyParameterSets_areRefusedBeforeTheirNumberOverflows()
{
    TreeContent content = Tree().content();
    TreeParameters parameters;
    content.kept.parameters.resize(kMostParameterSets, parameters);
    const Result<Tree> full = Tree::fromContent(content);
    QVERIFY(full);
    QVERIFY(full->hasRoomFor(parameters));
    parameters.growth.shedding = 0.3;
    QVERIFY(!full->hasRoomFor(parameters));
    content.kept.parameters.append(parameters);
    const Result<Tree> tooMany = Tree::fromContent(content);
    QVERIFY(!tooMany);
    QVERIFY(tooMany.error().message.contains(QStringLiteral("parameter sets")));
}

void TreeTest::imagesOfAllTime_haveALimit()
{
    constexpr qsizetype kLimit = 250;
    const auto withImage = [](char byte) {
        TreeParameters parameters;
        parameters.leaves.image = ImageAsset(QByteArray(100, byte), {});
        return parameters;
    };
    TreeBuilder builder;
    for (const char byte : {'a', 'b'}) {
        QVERIFY(builder.tree.hasRoomFor(withImage(byte), kLimit));
        builder.apply(parameterChange(builder.tree, withImage(byte)));
    }
    QVERIFY(!builder.tree.hasRoomFor(withImage('c'), kLimit));
    QVERIFY(builder.tree.hasRoomFor(withImage('a'), kLimit));
    TreeParameters other = withImage('b');
    other.growth.shedding = 0.3;
    QVERIFY(builder.tree.hasRoomFor(other, kLimit));
    builder.revert();
    QVERIFY(builder.tree.hasRoomFor(withImage('c'), kLimit));
}

void TreeTest::placedLeaves_comeAndGoWithTheirDelta()
{
    TreeBuilder builder = randomTree(20, 3);
    const Tree before = builder.tree;
    TreeDelta delta = deltaStartingAt(builder.tree);
    delta.rows = std::make_shared<TreeRows>();
    delta.rows->leaves.append({.internode = 7,
                               .along = 0.25F,
                               .length = 0.08F,
                               .kind = LeafKind::Flower,
                               .birth = builder.tree.step()});
    delta.bornLeaves.count = 1;
    builder.apply(delta);
    QCOMPARE(builder.tree.placedLeaves().size(), 1U);
    TreeDelta wilts = deltaStartingAt(builder.tree);
    wilts.leaves.death.push_back({0, kNever, builder.tree.step()});
    builder.apply(wilts);
    QCOMPARE(builder.tree.placedLeaves().death[0], builder.tree.step());
    builder.revert();
    QCOMPARE(builder.tree.placedLeaves().death[0], kNever);
    builder.revert();
    QVERIFY(builder.tree == before);
}

void TreeTest::attachmentAlong_placesTheBaseOnTheParent()
{
    TreeBuilder builder;
    builder.growAxis(0, kTerminalSlot, Rotation::Identity(), 2, Rotation::Identity(), 1.0F);
    TreeDelta delta = births(
        builder.tree, std::array{NewInternode{.parent = 2, .slot = 0, .rotation = branching(radians(90))}});
    delta.rows->internodes.along[0] = 0.25F;
    builder.apply(delta);
    const Vec3 foot = builder.index.basePosition(builder.tree, 3);
    const Vec3 lower = builder.index.basePosition(builder.tree, 2);
    QVERIFY((foot - (lower + 0.25F * up())).norm() < 1e-6F);
    QVERIFY(((builder.index.nodePosition(3) - foot).norm() - 0.1F) < 1e-6F);
}

void TreeTest::severalRoots_standWhereTheyAre()
{
    TreeBuilder builder;
    builder.apply(rootBirth(builder.tree, builder.index, Vec3(2.0F, 0.0F, -1.0F)));
    QCOMPARE(builder.index.roots().size(), std::size_t{2});
    QCOMPARE(builder.index.livingCount(), 2U);
    QVERIFY((builder.index.basePosition(builder.tree, 1) - Vec3(2.0F, 0.0F, -1.0F)).norm() < 1e-6F);
    const InternodeId above = builder.grow({.parent = 1});
    QCOMPARE(builder.index.rootOf(builder.tree, above), 1U);
    QVERIFY(Tree::fromContent(builder.tree.content()));
    builder.revert();
    builder.revert();
    QVERIFY(builder.tree == Tree());
    QCOMPARE(builder.index.roots().size(), std::size_t{1});
}

void TreeTest::parameterChange_leavesWhatHasGrown()
{
    TreeBuilder builder = randomTree(50, 6);
    TreeParameters parameters = builder.tree.parameters();
    parameters.growth.internodeLength = 0.5;
    const InternodeColumns before = builder.tree.columns();
    builder.apply(parameterChange(builder.tree, parameters));
    QVERIFY(builder.tree.columns().length == before.length);
    QVERIFY(builder.tree.parameters() == parameters);
    QVERIFY(builder.tree.parametersOf(49) != parameters);
    const InternodeId grown = builder.grow({.parent = 49, .length = 0.5F});
    QVERIFY(builder.tree.parametersOf(grown) == parameters);
    builder.revert();
    builder.revert();
    QVERIFY(builder.tree.parameters() == builder.tree.parameterSets()[0]);
}

void TreeTest::fromContent_acceptsWhatATreeHolds()
{
    TreeBuilder builder = randomTree(200, 7);
    builder.apply(death(builder.tree, builder.index, 60));
    builder.apply(randomGrowth(builder.tree, 30, 7));
    builder.revert();
    const Result<Tree> read = reread(builder.tree, builder.tree.columns());
    QVERIFY2(static_cast<bool>(read), read ? "" : qPrintable(read.error().message));
    QVERIFY(*read == builder.tree);
}

void TreeTest::fromContent_refusesFaults_data()
{
    QTest::addColumn<QString>("fault");
    QTest::addColumn<QString>("named");
    const auto row = [](const char* fault, const char* named) {
        QTest::newRow(fault) << QString::fromLatin1(fault) << QString::fromLatin1(named);
    };
    row("short column", "different lengths");
    row("no rows", "empty");
    row("parent after child", "does not come before");
    row("parent of itself", "does not come before");
    row("seedling dead", "seedling");
    row("rotation not unit", "rotation");
    row("rotation not a number", "rotation");
    row("length zero", "length");
    row("length negative", "length");
    row("length not a number", "length");
    row("length infinite", "length");
    row("vigour above one", "vigour");
    row("vigour not a number", "vigour");
    row("slot", "bud");
    row("bud", "bud");
    row("parameters", "parameters");
    row("born in the future", "born in the future");
    row("died before birth", "died before");
    row("two continuations", "continue the same axis");
    row("alive on the dead", "dead internode");
    row("twice the same key", "key");
    row("attached beyond the node", "attachment");
    row("width of nothing", "internode is missing");
}

void TreeTest::fromContent_refusesFaults()
{
    QFETCH(QString, fault);
    QFETCH(QString, named);
    TreeBuilder builder;
    builder.growAxis(0, kTerminalSlot, continuing(), 4);
    builder.growAxis(2, 0, branching(0.8), 3);
    InternodeColumns c = builder.tree.columns();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    if (fault == u"short column")
        c.vigour.removeLast();
    else if (fault == u"no rows")
        c = {};
    else if (fault == u"parent after child")
        c.parent[3] = 6;
    else if (fault == u"parent of itself")
        c.parent[3] = 3;
    else if (fault == u"seedling dead")
        c.death[0] = 1;
    else if (fault == u"rotation not unit")
        c.rotation[3].coeffs() *= 1.1F;
    else if (fault == u"rotation not a number")
        c.rotation[3].x() = nan;
    else if (fault == u"length zero")
        c.length[3] = 0.0F;
    else if (fault == u"length negative")
        c.length[3] = -0.1F;
    else if (fault == u"length not a number")
        c.length[3] = nan;
    else if (fault == u"length infinite")
        c.length[3] = std::numeric_limits<float>::infinity();
    else if (fault == u"vigour above one")
        c.vigour[3] = 1.5F;
    else if (fault == u"vigour not a number")
        c.vigour[3] = nan;
    else if (fault == u"slot")
        c.slot[3] = kMaxLaterals;
    else if (fault == u"bud")
        c.buds[3] = BudStates::active(budBit(kMaxLaterals));
    else if (fault == u"twice the same key")
        c.key[3] = c.key[5];
    else if (fault == u"attached beyond the node")
        c.along[3] = 1.5F;
    else if (fault == u"parameters")
        c.parameterSet[3] = 1;
    else if (fault == u"born in the future")
        c.birth[3] = builder.tree.step() + 1;
    else if (fault == u"died before birth")
        c.death[6] = c.birth[6] - 1;
    else if (fault == u"two continuations")
        c.slot[5] = kTerminalSlot;
    else if (fault == u"alive on the dead")
        c.death[2] = builder.tree.step();
    TreeContent content = builder.tree.content();
    content.internodes = c;
    if (fault == u"width of nothing")
        content.sparse.width.set(c.size(), 0.1F);
    const Result<Tree> read = Tree::fromContent(content);
    QVERIFY(!read);
    QVERIFY2(read.error().message.contains(named), qPrintable(read.error().message));
}

void TreeTest::keysOfOneBucket_areCheckedQuickly()
{
    constexpr std::uint32_t count = 60'000;
    TreeBuilder builder;
    builder.growAxis(0, kTerminalSlot, continuing(), count - 1);
    std::unordered_set<InternodeKey> table;
    table.reserve(count);
    InternodeColumns columns = builder.tree.columns();
    for (InternodeId id = 0; id < count; ++id)
        columns.key[id] = id * InternodeKey{table.bucket_count()};
    QElapsedTimer clock;
    clock.start();
    QVERIFY(reread(builder.tree, columns));
    // A hash table of these keys takes a hundred times as long.
    QVERIFY2(clock.elapsed() < 15'000, qPrintable(QStringLiteral("%1 ms").arg(clock.elapsed())));
    columns.key[count - 1] = columns.key[7];
    columns.key[100] = columns.key[9];
    const Result<Tree> refused = reread(builder.tree, columns);
    QVERIFY(!refused);
    QCOMPARE(refused.error().message, QStringLiteral("internode 100: another internode has its key"));
}

void TreeTest::emptyDelta_isEmpty()
{
    const TreeBuilder builder = randomTree(20, 8);
    QVERIFY(deltaStartingAt(builder.tree).isEmpty());
    QVERIFY(!builder.journal.back().isEmpty());
}

const TestClass<TreeTest> treeTest;

} // namespace espalier::test

#include "TreeTest.moc"
