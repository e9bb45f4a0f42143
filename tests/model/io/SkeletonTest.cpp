// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/DocumentProject.h"
#include "commands/ImportSkeleton.h"
#include "commands/recipe/JournalRecipe.h"
#include "commands/recipe/RecipePlayer.h"
#include "model/base/Random.h"
#include "model/io/project/ProjectFile.h"
#include "model/shape/Widths.h"
#include "tests/support/Documents.h"
#include "tests/support/Growing.h"
#include "tests/support/TestClasses.h"

#include <QTemporaryDir>
#include <QTest>

namespace espalier::test {

class SkeletonTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void table_isReadInAnyOrder();
    void wrongTables_areRefused_data();
    void wrongTables_areRefused();
    void importedTree_standsWhereItsSkeletonDoes();
    void importedTree_isUndoneSavedAndOpened();
    void importedTree_growsOn();
    void manyBranchesAtANode_areAllThere();
    void branchBesideItsParent_beginsOnIt();
    void severalTrunks_areRoots();
    void segmentsWithoutLength_areLeftOut();
    void wrongSkeletons_areRefused_data();
    void wrongSkeletons_areRefused();
    void grownTree_isNotReplaced();
    void import_isARecipe();
    void fileOfASkeleton_isReadAsARecipe();
};

namespace {

const QByteArray kHeading = "id,parent,x0,y0,z0,x1,y1,z1,radius\n";

SkeletonSegment segment(std::uint32_t parent, const Vec3& base, const Vec3& tip, float radius = 0.01F)
{
    return {.parent = parent, .base = base, .tip = tip, .radius = radius};
}

/// A tree of segments that each begin where their parent ends.
Skeleton randomSkeleton(std::uint32_t count, std::uint64_t seed = 1)
{
    Random random(seed, 0, 0, Purpose::ShootLength);
    Skeleton skeleton{segment(kNoInternode, {2.0F, 0.5F, -1.0F}, {2.0F, 1.0F, -1.0F}, 0.2F)};
    while (skeleton.size() < count) {
        const auto parent =
            static_cast<std::uint32_t>(random.uniform() * static_cast<double>(skeleton.size()));
        const SkeletonSegment& below = skeleton[parent];
        const Vec3 way = static_cast<float>(random.uniform(0.01, 0.4)) * random.direction();
        skeleton.push_back(segment(parent, below.tip, below.tip + way, 0.8F * below.radius));
    }
    return skeleton;
}

/// Imports a skeleton into a new document; fails the test if that fails.
void import(TreeDocument& document, const Skeleton& skeleton)
{
    const Result<void> imported = importSkeleton(document, skeleton);
    QVERIFY2(imported, imported ? "" : qPrintable(imported.error().message));
    QCOMPARE(treeFault(document.tree().content()), QString());
    QCOMPARE(indexFault(document), QString());
}

} // namespace

void SkeletonTest::table_isReadInAnyOrder()
{
    const Result<Skeleton> skeleton = readSkeleton("\xEF\xBB\xBF" + kHeading +
                                                   "7, 3, 0,0,1, 0.5,0.25,1.5, 0.02\r\n"
                                                   "\n"
                                                   "3,-1,0,0,0,0,0,1,0.1\n");
    QVERIFY(skeleton);
    QCOMPARE(*skeleton, (Skeleton{segment(kNoInternode, {0, 0, 0}, {0, 1, 0}, 0.1F),
                                  segment(0, {0, 1, 0}, {0.5F, 1.5F, -0.25F}, 0.02F)}));
}

void SkeletonTest::wrongTables_areRefused_data()
{
    QTest::addColumn<QByteArray>("table");
    QTest::addColumn<QString>("message");
    const auto add = [](const char* name, const QByteArray& rows, const char* message) {
        QTest::newRow(name) << kHeading + rows << QString::fromUtf8(message);
    };
    QTest::newRow("empty") << QByteArray()
                           << QStringLiteral("line 1: “id,parent,x0,y0,z0,x1,y1,z1,radius” is expected");
    QTest::newRow("other columns") << QByteArray("id,x,y,z\n1,2,3,4\n")
                                   << QStringLiteral(
                                          "line 1: “id,parent,x0,y0,z0,x1,y1,z1,radius” is expected");
    add("no rows", "", "line 1: there are no segments");
    add("short row", "1,-1,0,0,0\n", "line 2: 9 numbers are expected");
    add("long row", "1,-1,0,0,0,0,0,1,0.1,5\n", "line 2: 9 numbers are expected");
    add("long line", QByteArray(500, '1') + '\n', "line 2: it is too long");
    add("no number", "1,-1,0,0,0,0,zero,1,0.1\n", "line 2: “zero” is not a number for y1");
    add("empty field", "1,,0,0,0,0,0,1,0.1\n", "line 2: “” is not a number for parent");
    add("broken id", "1.5,-1,0,0,0,0,0,1,0.1\n", "line 2: “1.5” is not a number for id");
    add("not a number", "1,-1,0,0,0,0,0,nan,0.1\n", "line 2: it lies more than 10000 m away");
    add("far away", "1,-1,0,0,0,0,0,20000,0.1\n", "line 2: it lies more than 10000 m away");
    add("radius", "1,-1,0,0,0,0,0,1,-0.1\n", "line 2: its radius is not between 0 and 50 m");
    add("twice", "1,-1,0,0,0,0,0,1,0.1\n1,-1,0,0,0,0,0,1,0.1\n",
        "line 3: its id 1 is already used in line 2");
    add("no parent", "1,-1,0,0,0,0,0,1,0.1\n2,9,0,0,0,0,0,1,0.1\n",
        "line 3: its parent, id 9, does not exist");
    add("circle", "1,-1,0,0,0,0,0,1,0.1\n2,3,0,0,0,0,0,1,0.1\n3,2,0,0,0,0,0,1,0.1\n",
        "line 3: it is its own ancestor");
}

void SkeletonTest::wrongTables_areRefused()
{
    QFETCH(QByteArray, table);
    QFETCH(QString, message);
    const Result<Skeleton> skeleton = readSkeleton(table);
    QVERIFY(!skeleton);
    QCOMPARE(skeleton.error().kind, Error::Kind::Input);
    QCOMPARE(skeleton.error().message, message);
}

void SkeletonTest::importedTree_standsWhereItsSkeletonDoes()
{
    const Skeleton skeleton = randomSkeleton(2000);
    TreeDocument document;
    import(document, skeleton);
    const TreeIndex& index = document.index();
    QCOMPARE(index.livingCount(), static_cast<std::uint32_t>(skeleton.size()));
    const Widths widths(document.tree(), index);
    for (InternodeId id = 0; id < skeleton.size(); ++id) {
        QVERIFY((index.nodePosition(id) - (skeleton[id].tip - skeleton[0].base)).norm() < 1e-4F);
        QVERIFY(std::abs(widths.radius(index, id) - skeleton[id].radius) <= 1e-5F * skeleton[id].radius);
    }
}

void SkeletonTest::importedTree_isUndoneSavedAndOpened()
{
    TreeDocument document;
    const DocumentState before(document);
    import(document, randomSkeleton(300));
    const DocumentState after(document);
    document.undo();
    QCOMPARE(differenceFrom(before, document), QString());
    document.redo();
    QCOMPARE(differenceFrom(after, document), QString());

    const Result<QByteArray> packed = packProject(projectOf(document, QStringLiteral("scan")));
    QVERIFY(packed);
    const Result<Project> project = unpackProject(*packed);
    QVERIFY(project);
    QCOMPARE(project->tree, document.tree());
}

void SkeletonTest::importedTree_growsOn()
{
    TreeDocument document;
    import(document, randomSkeleton(60));
    const std::uint32_t before = document.index().livingCount();
    grow(document, 3);
    QVERIFY(document.index().livingCount() > before + 10);
    QCOMPARE(indexFault(document), QString());
}

void SkeletonTest::manyBranchesAtANode_areAllThere()
{
    Skeleton skeleton{segment(kNoInternode, {0, 0, 0}, {0, 1, 0}, 0.3F)};
    for (int i = 0; i < 40; ++i)
        skeleton.push_back(segment(0, {0, 1, 0}, {0.02F * static_cast<float>(i), 2, 0}, 0.01F));
    TreeDocument document;
    import(document, skeleton);
    int continuing = 0;
    for (InternodeId id = 1; id <= 40; ++id) {
        QCOMPARE(document.tree().parent(id), 0U);
        continuing += document.tree().continuesAxis(id) ? 1 : 0;
    }
    QCOMPARE(continuing, 1);
}

void SkeletonTest::branchBesideItsParent_beginsOnIt()
{
    // A scan's branch begins at the bark of the trunk, half way up.
    TreeDocument document;
    import(document, {segment(kNoInternode, {0, 0, 0}, {0, 2, 0}, 0.2F),
                      segment(0, {0.2F, 1, 0}, {1, 1.5F, 0}, 0.05F)});
    QCOMPARE(document.tree().columns().along[1], 0.5F);
    QVERIFY((document.index().basePosition(document.tree(), 1) - Vec3(0, 1, 0)).norm() < 1e-5F);
    QVERIFY((document.index().nodePosition(1) - Vec3(1, 1.5F, 0)).norm() < 1e-5F);
    // The trunk's tip can grow on.
    QVERIFY((document.tree().buds(0) & kTerminalBud) != 0);
}

void SkeletonTest::severalTrunks_areRoots()
{
    TreeDocument document;
    import(document,
           {segment(kNoInternode, {5, 1, 0}, {5, 2, 0}, 0.1F),
            segment(kNoInternode, {6, 1.5F, 0}, {6, 3, 0}, 0.3F), segment(0, {5, 2, 0}, {5, 3, 0}, 0.1F)});
    const Tree& tree = document.tree();
    QVERIFY(tree.isRoot(0) && tree.isRoot(1));
    QCOMPARE(tree.parent(2), 1U);
    // The thicker one comes first and stands at the origin, above the ground by as much as it was above the
    // other.
    QCOMPARE(tree.rootPosition(0), Vec3(0, 0.5F, 0));
    QCOMPARE(tree.rootPosition(1), Vec3(-1, 0, 0));
}

void SkeletonTest::segmentsWithoutLength_areLeftOut()
{
    TreeDocument document;
    import(document, {segment(kNoInternode, {0, 0, 0}, {0, 0, 0}), segment(0, {0, 0, 0}, {0, 1, 0}),
                      segment(1, {0, 1, 0}, {0, 1, 0}), segment(2, {0, 1, 0}, {0, 2, 0})});
    QCOMPARE(document.tree().size(), 2U);
    QCOMPARE(document.tree().parent(1), 0U);
    QVERIFY((document.index().nodePosition(1) - Vec3(0, 2, 0)).norm() < 1e-5F);
}

void SkeletonTest::wrongSkeletons_areRefused_data()
{
    QTest::addColumn<Skeleton>("skeleton");
    QTest::addColumn<QString>("message");
    QTest::newRow("no length") << Skeleton{segment(kNoInternode, {1, 0, 0}, {1, 0, 0})}
                               << QStringLiteral("no segment has a length");
    QTest::newRow("too long") << Skeleton{segment(kNoInternode, {0, 0, 0}, {0, 2000, 0})}
                              << QStringLiteral(
                                     "segment 1: it is longer than 1000 m, or more than 10000 m away");
    QTest::newRow("far root") << Skeleton{segment(kNoInternode, {0, 0, 0}, {0, 1, 0}, 0.2F),
                                          segment(kNoInternode, {1500, 0, 0}, {1500, 1, 0}, 0.1F)}
                              << QStringLiteral(
                                     "segment 2: it stands more than 1000 m from the thickest trunk");
}

void SkeletonTest::wrongSkeletons_areRefused()
{
    QFETCH(Skeleton, skeleton);
    QFETCH(QString, message);
    TreeDocument document;
    const DocumentState before(document);
    const Result<void> imported = importSkeleton(document, skeleton);
    QVERIFY(!imported);
    QCOMPARE(imported.error().message, message);
    QCOMPARE(differenceFrom(before, document), QString());
    QCOMPARE(document.undoStack().count(), 0);
}

void SkeletonTest::grownTree_isNotReplaced()
{
    TreeDocument document;
    grow(document, 3);
    const DocumentState before(document);
    QVERIFY(!importSkeleton(document, randomSkeleton(10)));
    QCOMPARE(differenceFrom(before, document), QString());
}

void SkeletonTest::import_isARecipe()
{
    TreeDocument document;
    import(document, randomSkeleton(100));
    const Result<Recipe> recipe = recipeOf(projectOf(document, QStringLiteral("scan")));
    QVERIFY(recipe);
    const Result<Recipe> read = parseRecipe(writeRecipe(*recipe));
    QVERIFY2(read, read ? "" : qPrintable(read.error().message));
    QCOMPARE(*read, *recipe);
    TreeDocument again;
    RecipePlayer player(again, *read);
    while (!player.isDone())
        player.playOperation();
    QVERIFY(player.warnings().isEmpty());
    QCOMPARE(again.tree(), document.tree());
}

void SkeletonTest::fileOfASkeleton_isReadAsARecipe()
{
    QTemporaryDir folder;
    const QString name = folder.filePath(QStringLiteral("Old Cherry.csv"));
    QFile file(name);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(kHeading + "0,-1,0,0,0,0,0,1,0.1\n");
    file.close();
    const Result<Recipe> recipe = readRecipe(name);
    QVERIFY(recipe);
    QCOMPARE(recipe->name, QStringLiteral("Old Cherry"));
    QCOMPARE(recipe->operations.size(), std::size_t{1});

    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(kHeading + "0,5,0,0,0,0,0,1,0.1\n");
    file.close();
    const Result<Recipe> wrong = readRecipe(name);
    QVERIFY(!wrong);
    QCOMPARE(wrong.error().message,
             QStringLiteral("Old Cherry.csv: line 2: its parent, id 5, does not exist"));
}

static const TestClass<SkeletonTest> skeletonTest;

} // namespace espalier::test

#include "SkeletonTest.moc"
