// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/strands/NodeProfiles.h"

#include "model/strands/StrandSkeleton.h"
#include "tests/support/Strands.h"
#include "tests/support/TestClasses.h"

#include <QTest>

namespace espalier::test {

class NodeProfilesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void profile_fadesOverTwiceTheRadius_data();
    void profile_fadesOverTwiceTheRadius();
    void profile_withoutFades_isThatOfItsOwnNodes();
    void nearProfiles_becomeEachOther();
    void distantProfiles_fadeToRoundWood();
    void profile_ofATrunk_leavesItsLimbsAlone();
    void strands_doNotOverlapWhereAProfileFades();
};

namespace {

constexpr InternodeId kPoleNodes = 60;
constexpr float kPoleLength = 0.05F; ///< m, of an internode
constexpr float kPoleRadius = 0.3F;  ///< m

/// An upright trunk without limbs, equally thick.
TreeBuilder pole()
{
    TreeBuilder grown(1, strandParameters(5));
    std::vector<NewInternode> internodes;
    for (InternodeId id = 1; id < kPoleNodes; ++id)
        internodes.push_back({.parent = id - 1, .rotation = continuing(), .length = kPoleLength});
    grown.apply(births(grown.tree, internodes));
    TreeDelta widths = deltaStartingAt(grown.tree);
    for (InternodeId id = 0; id < kPoleNodes; ++id)
        widths.sparse.width.push_back({id, std::nullopt, 2.0F * kPoleRadius});
    grown.apply(std::move(widths));
    return grown;
}

struct Profiles {
    explicit Profiles(const TreeBuilder& grown, bool areFaded = true)
        : skeleton(strandSkeleton(grown.tree, grown.index, Widths(grown.tree, grown.index))),
          profiles(grown.tree, skeleton, areFaded)
    {
    }
    std::uint32_t node(InternodeId id) const
    {
        const auto found = std::ranges::find_if(
            skeleton.nodes, [id](const StrandNode& n) { return n.internode == id && n.along == 1.0F; });
        return static_cast<std::uint32_t>(found - skeleton.nodes.begin());
    }
    float distance(std::uint32_t a, std::uint32_t b) const
    {
        return (skeleton.nodes[a].position - skeleton.nodes[b].position).norm();
    }

    StrandSkeleton skeleton;
    NodeProfiles profiles;
};

float areaOfCavities(const StrandProfile& profile)
{
    float whole = 0.0F;
    for (const StrandProfile::Loop& loop : profile.boundaries)
        whole = std::max(whole, std::abs(signedAreaOf(loop)));
    return whole - areaOf(profile);
}

} // namespace

void NodeProfilesTest::profile_fadesOverTwiceTheRadius_data()
{
    QTest::addColumn<StrandProfile>("profile");
    for (int i = 0; i < kProfileShapeCount; ++i)
        QTest::newRow(qPrintable(QStringLiteral("shape %1").arg(i)))
            << profileOf(static_cast<ProfileShape>(i));
    QTest::newRow("thin C") << thinC(0.1F);
}

void NodeProfilesTest::profile_fadesOverTwiceTheRadius()
{
    QFETCH(const StrandProfile, profile);
    constexpr InternodeId kMiddle = kPoleNodes / 2;
    TreeBuilder grown = pole();
    grown.apply(profileChange(grown.tree, kMiddle, profile));
    const Profiles after(grown);
    const std::uint32_t middle = after.node(kMiddle);
    QVERIFY(after.profiles.at(middle) == profile);
    const float reach = 2.0F * after.skeleton.nodes[middle].radius;
    QVERIFY(reach > 3.0F * kPoleLength);
    for (std::uint32_t node = 0; node < after.skeleton.nodes.size(); ++node) {
        const float distance = after.distance(node, middle);
        if (std::abs(distance - reach) < 1e-4F)
            continue;
        QCOMPARE(after.profiles.has(node), distance < reach);
        if (!after.profiles.has(node))
            continue;
        const StrandProfile faded = after.profiles.at(node);
        QCOMPARE(profileFault(faded), QString());
        // Wood near the end is about round.
        if (distance > 0.95F * reach) {
            QCOMPARE(faded.boundaries.size(), 1U);
            QVERIFY(areaOf(faded) > 0.9F * areaOf(profile) && areaOf(faded) < 1.1F * areaOf(profile));
        }
    }
    // Cavities become smaller and smaller.
    float last = areaOfCavities(profile);
    for (InternodeId id = kMiddle + 1; id < kPoleNodes && after.profiles.has(after.node(id)); ++id) {
        const float area = areaOfCavities(after.profiles.at(after.node(id)));
        QVERIFY(areaOfCavities(profile) <= 0.0F || area <= last + 1e-3F);
        last = area;
    }
}

void NodeProfilesTest::profile_withoutFades_isThatOfItsOwnNodes()
{
    TreeBuilder grown = pole();
    grown.apply(profileChange(grown.tree, 0, profileOf(ProfileShape::Ring)));
    grown.apply(profileChange(grown.tree, 30, profileOf(ProfileShape::Ring)));
    const Profiles after(grown, false);
    for (std::uint32_t node = 0; node < after.skeleton.nodes.size(); ++node) {
        // The foot of a trunk has the profile of its first node.
        const InternodeId id = after.skeleton.nodes[node].internode;
        QCOMPARE(after.profiles.has(node), id == 0 || id == 30);
    }
}

void NodeProfilesTest::nearProfiles_becomeEachOther()
{
    TreeBuilder grown = pole();
    const StrandProfile flat = profileOf(ProfileShape::Elongated);
    const StrandProfile two = profileOf(ProfileShape::TwoParts);
    grown.apply(profileChange(grown.tree, 20, flat));
    grown.apply(profileChange(grown.tree, 28, flat));
    grown.apply(profileChange(grown.tree, 36, two));
    const Profiles after(grown);
    for (InternodeId id = 20; id <= 28; ++id)
        QVERIFY(after.profiles.at(after.node(id)) == flat);
    std::size_t parts = 1;
    for (InternodeId id = 29; id < 36; ++id) {
        const StrandProfile between = after.profiles.at(after.node(id));
        QVERIFY(between.boundaries.size() >= parts);
        parts = between.boundaries.size();
        // Never round.
        QVERIFY(isInside(between, Vec2(0.9F, 0.0F)) && !isInside(between, Vec2(0.0F, 0.9F)));
    }
    QCOMPARE(parts, 2U);
}

void NodeProfilesTest::distantProfiles_fadeToRoundWood()
{
    TreeBuilder grown = pole();
    grown.apply(profileChange(grown.tree, 4, profileOf(ProfileShape::Ring)));
    grown.apply(profileChange(grown.tree, 55, profileOf(ProfileShape::Ring)));
    const Profiles after(grown);
    QVERIFY(after.profiles.has(after.node(5)) && after.profiles.has(after.node(54)));
    QVERIFY(!after.profiles.has(after.node(30)));
    QVERIFY(after.profiles.has(0)); // The foot is near
}

void NodeProfilesTest::profile_ofATrunk_leavesItsLimbsAlone()
{
    TreeBuilder grown = randomTree(400, 3);
    grown.apply(profileChange(grown.tree, 2, profileOf(ProfileShape::TwoParts)));
    const Profiles after(grown);
    const std::uint32_t trunk = after.node(2);
    for (std::uint32_t node = 0; node < after.skeleton.nodes.size(); ++node) {
        if (after.profiles.has(node))
            QVERIFY(2 * after.skeleton.nodes[node].strands >= after.skeleton.nodes[trunk].strands);
    }
}

void NodeProfilesTest::strands_doNotOverlapWhereAProfileFades()
{
    TreeParameters parameters = strandParameters(2);
    parameters.widths.baseDiameter = 0.6F;
    TreeBuilder grown = forkedTree(1000, parameters);
    grown.apply(profileChange(grown.tree, 1, profileOf(ProfileShape::TwoParts)));
    const StrandLayouts layouts = layoutsOf(grown);
    std::uint32_t faded = 0;
    for (std::uint32_t node = 0; node < layouts.skeleton().nodes.size(); ++node)
        faded += layouts.profileScale(node) > 0.0F ? 1 : 0;
    QVERIFY(faded > 2);
    QVERIFY(layouts.count().deepest <= 0.05);
}

static const TestClass<NodeProfilesTest> nodeProfilesTest;

} // namespace espalier::test

#include "NodeProfilesTest.moc"
