// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/sketch/LeafSuggestions.h"

#include "model/sketch/LeafPlacement.h"
#include "model/tree/PlacedLeafIndex.h"
#include "tests/support/PlacedLeaves.h"
#include "tests/support/TestClasses.h"

#include <QTest>

#include <array>
#include <cmath>
#include <map>
#include <optional>

namespace espalier::test {

class LeafSuggestionsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void frames_areCarriedWithoutATwist();
    void places_areFoundAgain();
    void nothing_isSuggestedWithoutSamples();
    void engines_applyToTheirSamplesAlone_data();
    void engines_applyToTheirSamplesAlone();
    void whorl_growsLeafByLeaf();
    void whorls_fillTheBranch();
    void whorls_completeTheSecondSample();
    void alternateLeaves_goOnInASpiral();
    void drawnLeaves_showTheirFacesWhicheverSideTheyAreOn();
    void pairs_lieInOnePlaneOrAcross();
    void leavesThatAreThere_stay();
    void kinds_areApart();
    void suggestions_areUndoneToTheBit();
};

namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr int kInternodes = 20;
constexpr float kInternode = 0.05F;

/// A bent branch on a short trunk: twenty internodes of 5 cm, which turn by the phyllotaxis as they bend.
struct LeafyBranch {
    TreeBuilder builder;
    InternodeId first = 0;
    InternodeId tip = 0;

    LeafyBranch()
    {
        const InternodeId trunk = builder.growAxis(0, kTerminalSlot, continuing(), 3);
        first = builder.tree.size();
        tip = builder.growAxis(trunk - 1, 0, branching(0.8), kInternodes, continuing(0.12, 0.7), kInternode);
    }

    BranchFrames frames() const { return {builder.tree, builder.index, first}; }

    /// Places a leaf at a distance from the base of the branch and at an azimuth in the carried frame.
    LeafId place(double distance, double azimuth, float length = 0.1F, LeafKind kind = LeafKind::Leaf)
    {
        const BranchFrames branch = frames();
        const BranchPlace at = branch.placeAt(distance);
        LeafRow row = leafAround(at.internode, at.along, azimuth, length);
        row.rotation = branch.localFrom(at.internode, row.rotation.cast<double>());
        row.kind = kind;
        TreeDelta delta = deltaStartingAt(builder.tree);
        addLeaf(delta, row);
        builder.apply(std::move(delta));
        return builder.tree.placedLeaves().size() - 1;
    }

    double distanceOf(LeafId leaf) const
    {
        const LeafRow row = leafRow(builder.tree, leaf);
        return frames().distanceOf({row.internode, row.along}).value();
    }
    /// rad, in the carried frame
    double azimuthOf(LeafId leaf) const
    {
        const LeafRow row = leafRow(builder.tree, leaf);
        const Eigen::Vector3d midrib =
            frames().carriedFrom(row.internode, row.rotation) * Eigen::Vector3d::UnitY();
        return std::atan2(midrib.z(), midrib.x());
    }
    BranchPlace placeOf(LeafId leaf) const
    {
        const LeafRow row = leafRow(builder.tree, leaf);
        return {row.internode, row.along};
    }

    std::vector<LeafSuggestion> suggestions(LeafId edited) const
    {
        return suggestLeaves(builder.tree, builder.index, placeOf(edited));
    }
    std::optional<TreeDelta> suggestion(LeafId edited, LeafEngine engine) const
    {
        for (LeafSuggestion& suggestion : suggestions(edited)) {
            if (suggestion.engine == engine)
                return std::move(suggestion.delta);
        }
        return std::nullopt;
    }
    /// Applies a suggestion; false if the engine makes none.
    bool arrange(LeafId edited, LeafEngine engine)
    {
        std::optional<TreeDelta> delta = suggestion(edited, engine);
        if (delta)
            builder.apply(std::move(*delta));
        return delta.has_value();
    }

    /// The azimuths of the leaves by their distance from the base, in tenths of a millimetre.
    std::map<long, std::vector<double>> azimuths() const
    {
        std::map<long, std::vector<double>> all;
        for (LeafId leaf = 0; leaf < builder.tree.placedLeaves().size(); ++leaf)
            all[std::lround(1e4 * distanceOf(leaf))].push_back(azimuthOf(leaf));
        return all;
    }
};

double difference(double one, double other, double period = kTurn)
{
    return std::abs(std::remainder(one - other, period));
}

/// Whether leaves stand evenly around.
bool areEven(std::vector<double> azimuths)
{
    std::ranges::sort(azimuths);
    for (std::size_t i = 0; i < azimuths.size(); ++i) {
        const double next = i + 1 < azimuths.size() ? azimuths[i + 1] : azimuths.front() + kTurn;
        if (std::abs(next - azimuths[i] - kTurn / static_cast<double>(azimuths.size())) > 1e-6)
            return false;
    }
    return true;
}

QString namesOf(const std::vector<LeafSuggestion>& suggestions)
{
    static const QStringList names{QStringLiteral("addToWhorl"), QStringLiteral("extendWhorls"),
                                   QStringLiteral("alternate"), QStringLiteral("opposite"),
                                   QStringLiteral("decussate")};
    QStringList found;
    for (const LeafSuggestion& suggestion : suggestions)
        found.append(names[static_cast<int>(suggestion.engine)]);
    return found.join(u' ');
}

} // namespace

void LeafSuggestionsTest::frames_areCarriedWithoutATwist()
{
    const LeafyBranch branch;
    const BranchFrames frames = branch.frames();
    QVERIFY(std::abs(frames.length() - double{kInternodes * kInternode}) < 1e-6);
    const auto worldOf = [&](InternodeId id) {
        const Rotation local = frames.localFrom(id, Eigen::Quaterniond::Identity());
        return Eigen::Quaterniond(
            (branch.builder.index.rotation(id).cast<double>() * local.cast<double>()).normalized());
    };
    for (InternodeId id = branch.first + 1; id <= branch.tip; ++id) {
        const Eigen::Quaterniond below = worldOf(id - 1);
        const Eigen::Quaterniond here = worldOf(id);
        const Eigen::Vector3d heading = branch.builder.index.heading(id).cast<double>();
        QVERIFY((here * Eigen::Vector3d::UnitY() - heading).norm() < 1e-5);
        const double bend = std::acos(std::clamp((below * Eigen::Vector3d::UnitY()).dot(heading), -1.0, 1.0));
        // The whole turn is the bend: nothing turns about the branch.
        QVERIFY(bend > 0.05);
        QVERIFY(std::abs(here.angularDistance(below) - bend) < 1e-5);
    }
}

void LeafSuggestionsTest::places_areFoundAgain()
{
    const LeafyBranch branch;
    const BranchFrames frames = branch.frames();
    for (double distance = 0.0; distance <= frames.length(); distance += 0.013) {
        const BranchPlace place = frames.placeAt(distance);
        QVERIFY(std::abs(*frames.distanceOf(place) - distance) < 1e-6);
    }
    QCOMPARE(frames.placeAt(frames.length()).internode, branch.tip);
    QCOMPARE(frames.placeAt(frames.length()).along, 1.0F);
    const BranchPlace node = frames.placeAt(2.0 * double{kInternode} + 1e-9);
    QCOMPARE(node.internode, branch.first + 1);
    QVERIFY(!frames.distanceOf({0, 1.0F}));
}

void LeafSuggestionsTest::nothing_isSuggestedWithoutSamples()
{
    LeafyBranch branch;
    const auto at = [&](InternodeId id) {
        return suggestLeaves(branch.builder.tree, branch.builder.index, {id, 0.5F}).size();
    };
    QCOMPARE(at(branch.first), std::size_t{0});
    branch.place(0.3, 0.0);
    QVERIFY(at(branch.first) > 0);
    QCOMPARE(at(0), std::size_t{0}); // another branch
    QCOMPARE(at(branch.builder.tree.size()), std::size_t{0});
    branch.builder.apply(leafRemoval(branch.builder.tree, 0));
    QCOMPARE(at(branch.first), std::size_t{0});
    branch.builder.revert();
    branch.builder.apply(death(branch.builder.tree, branch.builder.index, branch.first));
    QCOMPARE(at(branch.first), std::size_t{0});
}

void LeafSuggestionsTest::engines_applyToTheirSamplesAlone_data()
{
    QTest::addColumn<int>("first");
    QTest::addColumn<int>("second");
    QTest::addColumn<QString>("engines");
    const auto row = [](int first, int second, const char* engines) {
        QTest::addRow("%d and %d", first, second) << first << second << QString::fromLatin1(engines);
    };
    row(1, 0, "addToWhorl");
    row(3, 0, "addToWhorl");
    row(1, 1, "addToWhorl alternate opposite decussate");
    row(2, 1, "addToWhorl extendWhorls opposite decussate");
    row(1, 2, "addToWhorl extendWhorls opposite decussate");
    row(3, 1, "addToWhorl extendWhorls");
    row(1, 4, "addToWhorl extendWhorls");
    row(3, 3, "addToWhorl extendWhorls");
}

void LeafSuggestionsTest::engines_applyToTheirSamplesAlone()
{
    QFETCH(int, first);
    QFETCH(int, second);
    QFETCH(QString, engines);
    LeafyBranch branch;
    LeafId last = 0;
    for (int i = 0; i < first; ++i)
        last = branch.place(0.3, kTurn * i / first);
    for (int i = 0; i < second; ++i)
        last = branch.place(0.45, 0.4 + kTurn * i / second);
    QCOMPARE(namesOf(branch.suggestions(last)), engines);
}

void LeafSuggestionsTest::whorl_growsLeafByLeaf()
{
    LeafyBranch branch;
    const LeafId oldest = branch.place(0.33, 0.7, 0.1F);
    // A little off, but within the tolerance.
    branch.place(0.34, 2.2, 0.2F);
    const double distance = branch.distanceOf(oldest);
    for (std::size_t count = 3; count < 9; ++count) {
        const LeafColumns before = branch.builder.tree.placedLeaves();
        QVERIFY(branch.arrange(oldest, LeafEngine::AddToWhorl));
        const LeafColumns& now = branch.builder.tree.placedLeaves();
        QCOMPARE(std::size_t{now.size()}, count);
        QVERIFY(std::ranges::equal(before.birth, now.birth.first(before.birth.size())));
        QVERIFY(std::ranges::equal(before.length, now.length.first(before.length.size())));
        std::vector<double> azimuths;
        for (LeafId leaf = 0; leaf < now.size(); ++leaf) {
            azimuths.push_back(branch.azimuthOf(leaf));
            QVERIFY(std::abs(branch.distanceOf(leaf) - distance) < 1e-9);
        }
        QVERIFY(areEven(azimuths));
        QVERIFY(difference(azimuths.front(), 0.7) < 1e-6);
    }
    QVERIFY(std::abs(branch.builder.tree.placedLeaves().length[2] - 0.15F) < 1e-6F);
}

void LeafSuggestionsTest::whorls_fillTheBranch()
{
    LeafyBranch branch;
    for (int i = 0; i < 3; ++i)
        branch.place(0.4, 0.2 + kTurn * i / 3);
    const LeafId single = branch.place(0.52, 0.2 + 0.6);
    QVERIFY(branch.arrange(single, LeafEngine::ExtendWhorls));
    const auto azimuths = branch.azimuths();
    // 0.04, 0.16, …, 1.0: within the branch, and nothing beyond.
    QCOMPARE(azimuths.size(), std::size_t{9});
    for (int k = -3; k <= 5; ++k) {
        const auto whorl = azimuths.find(std::lround(1e4 * (0.4 + 0.12 * k)));
        QVERIFY(whorl != azimuths.end());
        QCOMPARE(whorl->second.size(), std::size_t{3});
        QVERIFY(areEven(whorl->second));
        QVERIFY(difference(whorl->second.front(), 0.2 + 0.6 * k, kTurn / 3) < 1e-5);
    }
    // There is nothing left to do.
    QVERIFY(!branch.arrange(single, LeafEngine::ExtendWhorls));
}

void LeafSuggestionsTest::whorls_completeTheSecondSample()
{
    LeafyBranch branch;
    branch.place(0.5, 1.0);
    branch.place(0.5, 1.0 + kTurn / 2);
    const LeafId single = branch.place(0.4, 1.0 + kTurn / 4); // toward the base, across
    const LeafRow before = leafRow(branch.builder.tree, single);
    QVERIFY(branch.arrange(single, LeafEngine::ExtendWhorls));
    QVERIFY(leafRow(branch.builder.tree, single).rotation == before.rotation);
    const auto azimuths = branch.azimuths();
    QCOMPARE(azimuths.size(), std::size_t{11}); // 0, 0.1, …, 1
    for (int place = 0; place <= 10; ++place) {
        const std::vector<double>& whorl = azimuths.at(1000L * place);
        QCOMPARE(whorl.size(), std::size_t{2});
        QVERIFY(areEven(whorl));
        QVERIFY(difference(whorl.front(), 1.0 + kTurn / 4 * (place - 5), kTurn / 2) < 1e-5);
    }
}

void LeafSuggestionsTest::alternateLeaves_goOnInASpiral()
{
    LeafyBranch branch;
    branch.place(0.3, 0.5, 0.1F);
    const double turn = radians(137.5);
    const LeafId second = branch.place(0.37, 0.5 + turn, 0.12F);
    QVERIFY(branch.arrange(second, LeafEngine::Alternate));
    const auto azimuths = branch.azimuths();
    QCOMPARE(azimuths.size(), std::size_t{15}); // 0.02, 0.09, …, 1.0
    for (int k = -4; k <= 10; ++k) {
        const std::vector<double>& leaf = azimuths.at(std::lround(1e4 * (0.3 + 0.07 * k)));
        QCOMPARE(leaf.size(), std::size_t{1});
        QVERIFY(difference(leaf.front(), 0.5 + k * turn) < 1e-5);
    }
    for (LeafId leaf = 2; leaf < branch.builder.tree.placedLeaves().size(); ++leaf)
        QVERIFY(std::abs(branch.builder.tree.placedLeaves().length[leaf] - 0.11F) < 1e-6F);
}

void LeafSuggestionsTest::drawnLeaves_showTheirFacesWhicheverSideTheyAreOn()
{
    // Two leaves in the plane of the picture, one on each side of the trunk, both of whose faces look
    // forward.
    TreeBuilder builder;
    const InternodeId tip = builder.growAxis(0, kTerminalSlot, continuing(), 10);
    const Eigen::Vector3d toViewer = Eigen::Vector3d::UnitZ();
    for (const double side : {1.0, -1.0}) {
        const InternodeId id = tip - 5 + (side > 0.0 ? 0U : 2U);
        const Eigen::Vector3d base = builder.index.nodePosition(id).cast<double>();
        const std::array<Eigen::Vector3d, 2> outline{base, base + Eigen::Vector3d(0.1 * side, 0.06, 0.0)};
        TreeDelta delta = deltaStartingAt(builder.tree);
        addLeaf(delta, leafOn(builder.tree, builder.index, id, 1.0F, *bladeOf(outline, toViewer)));
        builder.apply(std::move(delta));
    }
    for (LeafSuggestion& suggestion : suggestLeaves(builder.tree, builder.index, {tip - 3, 1.0F})) {
        if (suggestion.engine == LeafEngine::Alternate)
            builder.apply(std::move(suggestion.delta));
    }
    const LeafColumns& leaves = builder.tree.placedLeaves();
    QVERIFY(leaves.size() > 3);
    for (LeafId leaf = 2; leaf < leaves.size(); ++leaf) {
        const Rotation frame = placedLeafFrame(builder.tree, builder.index, leaf);
        QVERIFY(std::abs((frame * Vec3(Vec3::UnitZ())).z()) > 0.99F);
    }
}

void LeafSuggestionsTest::pairs_lieInOnePlaneOrAcross()
{
    for (const LeafEngine engine : {LeafEngine::Opposite, LeafEngine::Decussate}) {
        LeafyBranch branch;
        const LeafId first = branch.place(0.3, 0.5);
        const LeafId second = branch.place(0.4, 0.5 + 2.0);
        const LeafRow before = leafRow(branch.builder.tree, first);
        QVERIFY(branch.arrange(second, engine));
        QVERIFY(leafRow(branch.builder.tree, first).rotation == before.rotation);
        const auto azimuths = branch.azimuths();
        QCOMPARE(azimuths.size(), std::size_t{11});
        const double turn = engine == LeafEngine::Opposite ? 0.0 : kTurn / 4;
        for (int place = 0; place <= 10; ++place) {
            const std::vector<double>& pair = azimuths.at(1000L * place);
            QCOMPARE(pair.size(), std::size_t{2});
            QVERIFY(areEven(pair));
            QVERIFY(difference(pair.front(), 0.5 + turn * (place - 3), kTurn / 2) < 1e-5);
        }
    }
}

void LeafSuggestionsTest::leavesThatAreThere_stay()
{
    for (const LeafEngine engine : {LeafEngine::Alternate, LeafEngine::Opposite, LeafEngine::Decussate}) {
        LeafyBranch branch;
        const LeafId other = branch.place(0.805, 0.1, 0.3F); // where the arrangement would put one
        branch.place(0.2, 0.5);
        const LeafId second = branch.place(0.3, 1.5);
        const LeafRow before = leafRow(branch.builder.tree, other);
        QVERIFY(branch.arrange(second, engine));
        const LeafRow after = leafRow(branch.builder.tree, other);
        QVERIFY(after.rotation == before.rotation && after.along == before.along &&
                after.internode == before.internode && after.length == before.length);
        for (const auto& [place, leaves] : branch.azimuths())
            QVERIFY(std::abs(place - 8050) > 200 || leaves.size() == 1);
    }
}

void LeafSuggestionsTest::kinds_areApart()
{
    LeafyBranch branch;
    branch.place(0.3, 0.0);
    const LeafId flower = branch.place(0.5, 0.0, 0.1F, LeafKind::Flower);
    QCOMPARE(namesOf(branch.suggestions(flower)), QStringLiteral("addToWhorl"));
    const LeafId another = branch.place(0.6, 0.0, 0.1F, LeafKind::Flower);
    QVERIFY(branch.arrange(another, LeafEngine::Alternate));
    const LeafColumns& rows = branch.builder.tree.placedLeaves();
    for (LeafId leaf = 3; leaf < rows.size(); ++leaf)
        QVERIFY(rows.kind[leaf] == LeafKind::Flower);
    QVERIFY(rows.size() > 6);
}

void LeafSuggestionsTest::suggestions_areUndoneToTheBit()
{
    Random random(12, 0, 0, Purpose::Direction);
    int suggested = 0;
    for (int round = 0; round < 60; ++round) {
        LeafyBranch branch;
        const std::uint64_t count = 1 + random.bits() % 6;
        const std::array<double, 3> places{random.uniform(), random.uniform(), random.uniform()};
        LeafId last = 0;
        for (std::uint64_t i = 0; i < count; ++i)
            last = branch.place(places[random.bits() % 3], random.uniform(0.0, kTurn));
        const Tree before = branch.builder.tree;
        const double length = branch.frames().length();
        for (LeafSuggestion& suggestion : branch.suggestions(last)) {
            ++suggested;
            QVERIFY(!suggestion.delta.isEmpty());
            branch.builder.apply(std::move(suggestion.delta));
            QCOMPARE(treeFault(branch.builder.tree.content()), QString());
            const LeafColumns& rows = branch.builder.tree.placedLeaves();
            QVERIFY(rows.size() >= before.placedLeaves().size() && rows.size() < 2000);
            for (LeafId leaf = 0; leaf < rows.size(); ++leaf) {
                QVERIFY(rows.death[leaf] == kNever);
                QVERIFY(branch.distanceOf(leaf) >= 0.0 && branch.distanceOf(leaf) <= length + 1e-9);
            }
            branch.builder.revert();
            QVERIFY(branch.builder.tree == before);
        }
    }
    QVERIFY(suggested > 100);
}

const TestClass<LeafSuggestionsTest> leafSuggestionsTest;

} // namespace espalier::test

#include "LeafSuggestionsTest.moc"
