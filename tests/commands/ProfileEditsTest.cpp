// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/ProfileEdits.h"

#include "commands/BendGesture.h"
#include "commands/DocumentProject.h"
#include "commands/GrowGesture.h"
#include "commands/Prune.h"
#include "model/io/project/ProjectFile.h"
#include "tests/support/Documents.h"
#include "tests/support/Growing.h"
#include "tests/support/Replaying.h"
#include "tests/support/Strands.h"
#include "tests/support/TestClasses.h"

#include <QTest>

#include <array>

namespace espalier::test {

class ProfileEditsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void profile_isOneUndoStep_undoneAndRedoneToTheBit();
    void profile_isCopiedToAllNodes();
    void sameProfile_isNoCommand();
    void samePofilesAreKeptOnce();
    void fullDocument_refusesMore();
    void blend_givesTheNodesBetweenProfiles_undoneAndRedoneToTheBit();
    void blend_downward_isTheSameAsUpward();
    void blend_withoutABranchBetween_doesNothing();
    void clear_takesProfilesAway_undoneAndRedoneToTheBit();
    void branchBetween_isTheBranch();
    void deadAndUnknown_getNoProfile();
    void profile_survivesBendPruneGrowthUndoAndTravel();
    void profile_survivesSavingAndLoading();
    void recipes_giveTheSameDocument();
};

namespace {

/// A random document and a path of at least eight internodes upward from the seedling.
std::vector<InternodeId> longPath(TreeDocument& document, std::uint64_t seed = 1)
{
    growAtRandom(document, seed, 120, 300);
    const auto depth = [&](InternodeId id) {
        std::size_t count = 0;
        for (; id != kNoInternode; id = document.tree().parent(id))
            ++count;
        return count;
    };
    InternodeId deepest = 0;
    for (InternodeId id = 0; id < document.tree().size(); ++id) {
        if (document.tree().isAlive(id) && depth(id) > depth(deepest))
            deepest = id;
    }
    std::vector<InternodeId> path = branchBetween(document.tree(), 0, deepest);
    return path;
}

/// Undoes and redoes the last command; what differs.
QString undoRedoFault(TreeDocument& document, const DocumentState& before)
{
    const DocumentState after(document);
    document.undoStack().undo();
    if (const QString difference = differenceFrom(before, document); !difference.isEmpty())
        return QStringLiteral("undone: ") + difference;
    document.undoStack().redo();
    return differenceFrom(after, document);
}

} // namespace

void ProfileEditsTest::profile_isOneUndoStep_undoneAndRedoneToTheBit()
{
    for (int shape = 0; shape < kProfileShapeCount; ++shape) {
        TreeDocument document;
        const std::vector<InternodeId> path = longPath(document);
        const int steps = document.undoStack().count();
        const DocumentState before(document);
        const StrandProfile profile = profileOf(static_cast<ProfileShape>(shape));
        setProfile(document, std::span(path).subspan(2, 1), profile);
        QVERIFY(document.tree().profileOf(path[2]) != nullptr);
        QVERIFY(*document.tree().profileOf(path[2]) == profile);
        QCOMPARE(document.undoStack().count(), steps + 1);
        QCOMPARE(document.undoStack().undoText(), QStringLiteral("Draw Profile"));
        QCOMPARE(undoRedoFault(document, before), QString());
    }
}

void ProfileEditsTest::profile_isCopiedToAllNodes()
{
    TreeDocument document;
    const std::vector<InternodeId> path = longPath(document);
    const int steps = document.undoStack().count();
    const DocumentState before(document);
    // In no order, and one twice.
    const std::array ids{path[4], path[1], path[4], path[3]};
    setProfile(document, ids, profileOf(ProfileShape::Fluted));
    for (const std::size_t i : {1U, 3U, 4U})
        QVERIFY(document.tree().profileOf(path[i]) != nullptr);
    QVERIFY(document.tree().profileOf(path[2]) == nullptr);
    QCOMPARE(document.undoStack().count(), steps + 1);
    QCOMPARE(undoRedoFault(document, before), QString());
}

void ProfileEditsTest::sameProfile_isNoCommand()
{
    TreeDocument document;
    const std::vector<InternodeId> path = longPath(document);
    setProfile(document, path, profileOf(ProfileShape::Ring));
    const DocumentState before(document);
    setProfile(document, path, profileOf(ProfileShape::Ring));
    setProfile(document, {}, profileOf(ProfileShape::Round));
    QCOMPARE(differenceFrom(before, document), QString());
}

void ProfileEditsTest::fullDocument_refusesMore()
{
    const StrandProfile round = profileOf(ProfileShape::Round);
    const std::size_t points = round.bytes() / sizeof(Vec2);
    TreeContent content = Tree().content();
    content.kept.profiles.resize(static_cast<qsizetype>(kMostProfilePointsInAll / points), round);
    TreeDocument document;
    document.reset(*Tree::fromContent(content), Journal());
    const DocumentState before(document);
    const std::vector<InternodeId> path{0};
    QVERIFY(!setProfile(document, path, profileOf(ProfileShape::Ring)));
    QVERIFY(!blendProfiles(document, 0, 0, profileOf(ProfileShape::Ring), profileOf(ProfileShape::Ring)));
    QCOMPARE(differenceFrom(before, document), QString());
    QVERIFY(setProfile(document, path, round));
    // What is within the limit can be saved and read.
    const Result<QByteArray> packed = packProject(projectOf(document, QString()));
    QVERIFY(packed && unpackProject(*packed));
}

void ProfileEditsTest::samePofilesAreKeptOnce()
{
    TreeDocument document;
    const std::vector<InternodeId> path = longPath(document);
    setProfile(document, path, profileOf(ProfileShape::Ring));
    setProfile(document, std::span(path).first(2), profileOf(ProfileShape::Round));
    setProfile(document, std::span(path).first(1), profileOf(ProfileShape::Ring));
    QCOMPARE(document.tree().profiles().size(), 2);
}

void ProfileEditsTest::blend_givesTheNodesBetweenProfiles_undoneAndRedoneToTheBit()
{
    TreeDocument document;
    const std::vector<InternodeId> path = longPath(document);
    QVERIFY(path.size() >= 8);
    const DocumentState before(document);
    const StrandProfile from = rectangle(4.0F, 1.0F);
    const StrandProfile to = rectangle(2.0F, 2.0F);
    blendProfiles(document, path[1], path[7], from, to);
    QVERIFY(*document.tree().profileOf(path[1]) == from);
    QVERIFY(*document.tree().profileOf(path[7]) == to);
    QVERIFY(document.tree().profileOf(path[0]) == nullptr);
    float last = 2.01F;
    for (std::size_t i = 2; i < 7; ++i) {
        const StrandProfile* const profile = document.tree().profileOf(path[i]);
        QVERIFY(profile != nullptr);
        float width = 0.0F;
        for (const Vec2& point : profile->boundaries.front())
            width = std::max(width, point.x());
        QVERIFY(width < last && width > 0.99F);
        last = width;
    }
    QCOMPARE(document.undoStack().undoText(), QStringLiteral("Blend Profiles"));
    QCOMPARE(undoRedoFault(document, before), QString());
}

void ProfileEditsTest::blend_downward_isTheSameAsUpward()
{
    TreeDocument up;
    TreeDocument down;
    const std::vector<InternodeId> path = longPath(up);
    longPath(down);
    const StrandProfile from = profileOf(ProfileShape::CShape);
    const StrandProfile to = profileOf(ProfileShape::TwoParts);
    blendProfiles(up, path[1], path[6], from, to);
    blendProfiles(down, path[6], path[1], to, from);
    for (std::size_t i = 1; i <= 6; ++i) {
        const float a = areaOf(*up.tree().profileOf(path[i]));
        const float b = areaOf(*down.tree().profileOf(path[i]));
        QVERIFY(std::abs(a - b) < 0.05F);
    }
}

void ProfileEditsTest::blend_withoutABranchBetween_doesNothing()
{
    TreeDocument document;
    longPath(document);
    InternodeId fork = 0;
    while (!document.tree().isAlive(fork) ||
           document.index().nextSibling(document.index().firstChild(fork)) == kNoInternode)
        ++fork;
    const InternodeId first = document.index().firstChild(fork);
    const InternodeId second = document.index().nextSibling(first);
    const DocumentState before(document);
    blendProfiles(document, first, second, profileOf(ProfileShape::Round), profileOf(ProfileShape::Ring));
    blendProfiles(document, 0, kNoInternode, profileOf(ProfileShape::Round), profileOf(ProfileShape::Ring));
    QCOMPARE(differenceFrom(before, document), QString());
}

void ProfileEditsTest::clear_takesProfilesAway_undoneAndRedoneToTheBit()
{
    TreeDocument document;
    const std::vector<InternodeId> path = longPath(document);
    setProfile(document, std::span(path).first(3), profileOf(ProfileShape::Ring));
    const DocumentState before(document);
    clearProfiles(document, path);
    for (const InternodeId id : path)
        QVERIFY(document.tree().profileOf(id) == nullptr);
    QCOMPARE(undoRedoFault(document, before), QString());
    const DocumentState cleared(document);
    clearProfiles(document, path);
    QCOMPARE(differenceFrom(cleared, document), QString());
}

void ProfileEditsTest::branchBetween_isTheBranch()
{
    TreeDocument document;
    const std::vector<InternodeId> path = longPath(document);
    QCOMPARE(branchBetween(document.tree(), path[3], path[3]), std::vector{path[3]});
    const std::vector<InternodeId> part = branchBetween(document.tree(), path[5], path[2]);
    QCOMPARE(part, (std::vector{path[5], path[4], path[3], path[2]}));
    QVERIFY(branchBetween(document.tree(), 0, kNoInternode).empty());
    QVERIFY(branchBetween(document.tree(), document.tree().size(), 0).empty());
}

void ProfileEditsTest::deadAndUnknown_getNoProfile()
{
    TreeDocument document;
    const std::vector<InternodeId> path = longPath(document);
    pruneBranches(document, std::array{path[4]});
    const DocumentState before(document);
    const std::array ids{path[5], document.tree().size(), kNoInternode};
    setProfile(document, ids, profileOf(ProfileShape::Ring));
    QCOMPARE(differenceFrom(before, document), QString());
}

void ProfileEditsTest::profile_survivesBendPruneGrowthUndoAndTravel()
{
    TreeDocument document;
    const std::vector<InternodeId> path = longPath(document);
    const StrandProfile profile = profileOf(ProfileShape::CShape);
    setProfile(document, std::span(path).subspan(1, 2), profile);
    const auto isThere = [&] {
        const StrandProfile* const found = document.tree().profileOf(path[1]);
        return found != nullptr && *found == profile && document.tree().profileOf(path[2]) != nullptr;
    };
    {
        BendGesture bend(document, path[0], {{path[5], 1.0}}, {});
        const std::array target{Vec3(document.index().nodePosition(path[5]) + Vec3(0.2F, 0.0F, 0.1F))};
        bend.moveTo(target);
        bend.finish();
    }
    QVERIFY(isThere());
    pruneBranches(document, std::array{path[6]});
    QVERIFY(isThere());
    const DocumentState beforeGrowth(document);
    GrowGesture(document).step();
    QVERIFY(isThere());
    while (differenceFrom(beforeGrowth, document) != QString() && document.undoStack().canUndo())
        document.undoStack().undo();
    QVERIFY(isThere());
    const std::size_t length = document.journal().size();
    travel(document, 0);
    QVERIFY(document.tree().profileOf(0) == nullptr && document.tree().profiles().isEmpty());
    travel(document, length);
    QVERIFY(isThere());
    // A branch takes its profiles along, and brings them back.
    pruneBranches(document, std::array{path[1]});
    document.undoStack().undo();
    QVERIFY(isThere());
}

void ProfileEditsTest::profile_survivesSavingAndLoading()
{
    TreeDocument document;
    const std::vector<InternodeId> path = longPath(document);
    blendProfiles(document, path[1], path[7], profileOf(ProfileShape::Ring),
                  profileOf(ProfileShape::ThreeParts));
    const Result<QByteArray> file = packProject({document.tree(), document.journal(), {}, {}});
    QVERIFY(file);
    const Result<Project> read = unpackProject(*file);
    QVERIFY2(read, qPrintable(read ? QString() : read.error().message));
    QVERIFY(read->tree == document.tree());
}

void ProfileEditsTest::recipes_giveTheSameDocument()
{
    TreeDocument document;
    const std::vector<InternodeId> path = [&] {
        GrowGesture gesture(document);
        for (int i = 0; i < 14; ++i)
            gesture.step();
        gesture.finish();
        std::vector<InternodeId> axis{0};
        while (document.index().mainChild(axis.back()) != kNoInternode)
            axis.push_back(document.index().mainChild(axis.back()));
        return axis;
    }();
    QVERIFY(path.size() >= 6);
    StrandProfile profile = profileOf(ProfileShape::ThreeParts);
    profile.attractors = {{Vec2(-0.0F, 0.1F), Vec2(1.0F / 3.0F, -0.0F)}};
    setProfile(document, std::span(path).first(3), profile);
    blendProfiles(document, path[1], path[4], profile, profileOf(ProfileShape::Fluted));
    document.undoStack().undo();
    blendProfiles(document, path[5], path[1], profileOf(ProfileShape::Round), profile);
    clearProfiles(document, std::span(path).subspan(2, 2));
    QCOMPARE(replayFault(document), QString());
}

static const TestClass<ProfileEditsTest> profileEditsTest;

} // namespace espalier::test

#include "ProfileEditsTest.moc"
