// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/growth/VigourModel.h"

#include "commands/DocumentProject.h"
#include "commands/SetParameters.h"
#include "model/growth/BudBreak.h"
#include "model/growth/Sagging.h"
#include "model/growth/ShootDirection.h"
#include "model/growth/VigourFlux.h"
#include "model/growth/VigourSpecies.h"
#include "model/io/project/ProjectFile.h"
#include "model/mesh/TreeCounts.h"
#include "tests/support/Documents.h"
#include "tests/support/Growing.h"
#include "tests/support/TestClasses.h"

#include <QTest>

#include <tbb/global_control.h>

namespace espalier::test {

/// The vigour model: the invariants of its formulas, and trees that grow by it.
class VigourModelTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void rate_isAtMostTheLight();
    void potential_isOneForTheStrongestShoot();
    void loneLitShoot_growsAtHalfTheRate();
    void apicalControl_ordersTheAxes();
    void inhibitor_isTheSumFromAbove();
    void dominance_neverRaisesTheNumberOfBreaks();
    void light_doesNotIncreaseUnderANewCaster();
    void tip_lengthensUntilItsInternodeIsFull();
    void turnedToward_turnsByTheShare();
    void sagging_neverRises();
    void bareTrunk_hasNoBranches();
    void growth_isTheSameOnOneThreadAndMany();
    void growth_isUndoneAndRedoneToTheBit();
    void files_keepTheStateOfGrowth();
    void competitors_growAlone();
    void addedVigour_isUsedUp();
    void invigoratedBranch_growsAlone();
    void brush_growsTowardTheMarkersAlone();
    void brush_shedsShadedTips();
    void species_growDifferentOutlines();

private:
    static TreeParameters vigorous(const VigourParameters& vigour = {});
    static void grownTree(TreeDocument& document, std::uint64_t seed, int steps,
                          const VigourParameters& vigour = {});
};

TreeParameters VigourModelTest::vigorous(const VigourParameters& vigour)
{
    TreeParameters parameters;
    parameters.growth.model = GrowthModelKind::Vigour;
    parameters.vigour = vigour;
    return parameters;
}

void VigourModelTest::grownTree(TreeDocument& document, std::uint64_t seed, int steps,
                                const VigourParameters& vigour)
{
    document.reset(seed, vigorous(vigour));
    QCOMPARE(grow(document, steps), steps);
}

namespace {

/// The flux of a document's tree with other parameters of vigour.
class FluxOf {
public:
    FluxOf(const TreeDocument& document, const VigourParameters& parameters)
        : m_growing(document.tree(), document.index(), m_workspace),
          m_parameters(parameters),
          m_flux(m_growing, document.growthModel().space(), parameters, {.years = 0.1})
    {
    }
    const VigourFlux& operator*() const { return m_flux; }
    const VigourFlux* operator->() const { return &m_flux; }
    std::size_t breaks() const { return breakingBuds(m_growing, m_flux, m_parameters).size(); }

private:
    GrowthWorkspace m_workspace;
    GrowingTree m_growing;
    VigourParameters m_parameters;
    VigourFlux m_flux;
};

/// Internodes outside the branch of @p root whose row in @p after differs from that in @p before.
int changesOutside(const Tree& before, const Tree& after, InternodeId root)
{
    std::vector<bool> isInside(after.size(), false);
    int changes = 0;
    for (InternodeId id = 0; id < after.size(); ++id) {
        isInside[id] = id == root || (!after.isRoot(id) && isInside[after.parent(id)]);
        if (isInside[id])
            continue;
        if (id >= before.size()) {
            ++changes;
            continue;
        }
        InternodeTable::visit([&](const auto&, const auto& a, const auto& b) { changes += a[id] != b[id]; },
                              before.columns(), after.columns());
    }
    return changes;
}

VigourParameters branchy()
{
    VigourParameters vigour;
    vigour.growthRate = 0.8;
    vigour.internodeLength = 0.1;
    return vigour;
}

} // namespace

void VigourModelTest::rate_isAtMostTheLight()
{
    TreeDocument document;
    grownTree(document, 3, 50, branchy());
    QVERIFY(document.index().livingCount() > 300);
    for (const double control : {0.7, 1.0, 1.6}) {
        VigourParameters vigour = branchy();
        vigour.apicalControl = control;
        vigour.distanceControl = 0.5;
        vigour.heightControl = 0.3;
        const FluxOf flux(document, vigour);
        QVERIFY(flux->nodes().size() > 100);
        bool isShaded = false;
        for (const InternodeId id : flux->nodes()) {
            QVERIFY(flux->light(id) >= 0.0 && flux->light(id) <= 1.0);
            QVERIFY(flux->rate(id) >= 0.0 && flux->rate(id) <= flux->light(id));
            isShaded = isShaded || flux->light(id) < 0.7;
        }
        QVERIFY(isShaded);
    }
}

void VigourModelTest::potential_isOneForTheStrongestShoot()
{
    TreeDocument document;
    grownTree(document, 4, 40, branchy());
    for (const double control : {0.6, 1.0, 1.25, 2.0}) {
        VigourParameters vigour = branchy();
        vigour.apicalControl = control;
        vigour.distanceControl = control - 0.5;
        const FluxOf flux(document, vigour);
        double greatest = 0.0;
        for (const InternodeId id : flux->nodes()) {
            QVERIFY(flux->potential(id) >= 0.0);
            greatest = std::max(greatest, flux->potential(id));
        }
        QCOMPARE(greatest, 1.0);
    }
}

void VigourModelTest::loneLitShoot_growsAtHalfTheRate()
{
    TreeDocument document;
    document.reset(1, vigorous());
    const FluxOf flux(document, {});
    QCOMPARE(flux->nodes().size(), std::size_t{1});
    QVERIFY(std::abs(flux->light(0) - 1.0) < 1e-5);
    QVERIFY(std::abs(flux->rate(0) - 0.5) < 1e-5);
}

void VigourModelTest::apicalControl_ordersTheAxes()
{
    TreeDocument document;
    grownTree(document, 5, 40, branchy());
    VigourParameters vigour = branchy();
    const auto potentialOf = [&](int order, double control) {
        vigour.apicalControl = control;
        const FluxOf flux(document, vigour);
        for (const InternodeId id : flux->nodes()) {
            if (flux->order(id) == order)
                return flux->potential(id);
        }
        return -1.0;
    };
    QVERIFY(std::abs(potentialOf(1, 1.25) - 1.0 / 1.25) < 1e-6);
    QVERIFY(std::abs(potentialOf(2, 1.25) - 1.0 / (1.25 * 1.25)) < 1e-6);
    QCOMPARE(potentialOf(2, 1.0), 1.0);
    QVERIFY(potentialOf(0, 0.8) < potentialOf(1, 0.8) && potentialOf(1, 0.8) < potentialOf(2, 0.8));
}

void VigourModelTest::inhibitor_isTheSumFromAbove()
{
    TreeDocument document;
    grownTree(document, 6, 30, branchy());
    VigourParameters vigour = branchy();
    vigour.apicalDominance = 0.7;
    vigour.inhibitorLoss = 0.1;
    const FluxOf flux(document, vigour);
    const Tree& tree = document.tree();
    int checked = 0;
    for (InternodeId id = 0; id < tree.size(); ++id) {
        if (!tree.isAlive(id))
            continue;
        double expected = 0.0;
        for (InternodeId child = document.index().firstChild(id); child != kNoInternode;
             child = document.index().nextSibling(child)) {
            const bool isTip = (tree.buds(child) & kTerminalBud) != 0;
            expected += 0.9 * ((isTip ? 0.7 * flux->light(child) : 0.0) + flux->inhibitor(child));
        }
        QVERIFY(std::abs(flux->inhibitor(id) - expected) < 1e-4 * (1.0 + expected));
        checked += expected > 0.0 ? 1 : 0;
    }
    QVERIFY(checked > 50);
}

void VigourModelTest::dominance_neverRaisesTheNumberOfBreaks()
{
    TreeDocument document;
    grownTree(document, 7, 60, branchy());
    std::size_t before = std::numeric_limits<std::size_t>::max();
    std::size_t first = 0;
    for (const double dominance : {0.0, 0.1, 0.3, 0.8, 2.0, 5.0}) {
        VigourParameters vigour = branchy();
        vigour.apicalDominance = dominance;
        const FluxOf flux(document, vigour);
        const std::size_t breaks = flux.breaks();
        QVERIFY(breaks <= before);
        if (dominance == 0.0)
            first = breaks;
        before = breaks;
    }
    QVERIFY(first > 10 && before < first / 2);
}

void VigourModelTest::light_doesNotIncreaseUnderANewCaster()
{
    TreeDocument document;
    grownTree(document, 8, 45, branchy());
    std::vector<float> before;
    const auto lightOf = [&](InternodeId id) {
        const VoxelSpace& space = document.growthModel().space();
        return space.light(space.cellAt(document.index().nodePosition(id)));
    };
    const std::uint32_t size = document.tree().size();
    for (InternodeId id = 0; id < size; ++id)
        before.push_back(lightOf(id));
    // Tips that lengthen move; what stays where it is gets no more light.
    const Tree old = document.tree();
    QCOMPARE(grow(document, 3), 3);
    int darker = 0;
    for (InternodeId id = 0; id < size; ++id) {
        if (!document.tree().isAlive(id) || document.tree().length(id) != old.length(id))
            continue;
        QVERIFY(lightOf(id) <= before[id]);
        darker += lightOf(id) < before[id] ? 1 : 0;
    }
    QVERIFY(darker > 20);
}

void VigourModelTest::tip_lengthensUntilItsInternodeIsFull()
{
    VigourParameters vigour;
    vigour.growthRate = 0.2;
    vigour.internodeLength = 0.1;
    TreeDocument document;
    document.reset(9, vigorous(vigour));
    float length = 0.0F;
    InternodeId tip = 0;
    int lengthened = 0;
    for (int step = 0; step < 60; ++step) {
        QCOMPARE(grow(document, 1), 1);
        const InternodeId now = trunkTip(document.index(), 0);
        const float next = document.tree().length(now);
        if (now == tip) {
            QVERIFY(next > length);
            ++lengthened;
        } else if (tip != 0) {
            QVERIFY(length > 0.059F && length < 0.16F); // it was full
        }
        tip = now;
        length = next;
        QCOMPARE(indexFault(document), QString());
    }
    QVERIFY(lengthened > 20);
}

void VigourModelTest::turnedToward_turnsByTheShare()
{
    const Vec3 heading = Vec3(1.0F, 0.0F, 0.0F);
    const Vec3 up = Vec3::UnitY();
    QVERIFY((turnedToward(heading, up, 0.5) - Vec3(1, 1, 0).normalized()).norm() < 1e-6F);
    QVERIFY((turnedToward(heading, up, 1.0) - up).norm() < 1e-6F);
    QVERIFY((turnedToward(heading, up, -0.5) - Vec3(1, -1, 0).normalized()).norm() < 1e-6F);
    QCOMPARE(turnedToward(up, up, 0.5), up);
}

void VigourModelTest::sagging_neverRises()
{
    VigourParameters vigour = branchy();
    vigour.bending = 20.0;
    vigour.bendingMaximum = 0.3;
    BranchLoad load{.mass = 10.0, .moment = {10.0, 5.0, 0.0}, .tips = 4.0, .lowest = 1.0F, .reach = 2.0};
    const double light = sagging(vigour, load, Vec3::Zero());
    load.moment *= 2.0;
    const double heavy = sagging(vigour, load, Vec3::Zero());
    QVERIFY(light > 0.0 && heavy > light && heavy <= vigour.bendingMaximum);
    load.tips = 40.0;
    QVERIFY(sagging(vigour, load, Vec3::Zero()) < heavy);

    TreeDocument document;
    document.reset(10, vigorous(vigour));
    int turned = 0;
    for (int step = 0; step < 60; ++step) {
        const TreeIndex before = document.index();
        QCOMPARE(grow(document, 1), 1);
        for (const auto& change : document.journal().back()->internodes.rotation) {
            // Not counting what its bearers turn.
            const Rotation carrier = before.rotation(document.tree().parent(change.row));
            const Vec3 up = Vec3::UnitY();
            QVERIFY((carrier * change.after * up).y() < (carrier * change.before * up).y());
            ++turned;
        }
    }
    QVERIFY(turned > 30);
    QCOMPARE(indexFault(document), QString());
    for (InternodeId id = 0; id < document.tree().size(); ++id)
        QVERIFY(document.index().nodePosition(id).y() > -0.02F);
}

void VigourModelTest::bareTrunk_hasNoBranches()
{
    VigourParameters vigour = branchy();
    vigour.lightPruning = 0.5;
    TreeDocument document;
    grownTree(document, 11, 90, vigour);
    float height = 0.0F;
    for (InternodeId id = 0; id < document.tree().size(); ++id)
        height = std::max(height, document.index().nodePosition(id).y());
    int branches = 0;
    for (InternodeId id = 1; id < document.tree().size(); ++id) {
        const Tree& tree = document.tree();
        if (!tree.isAlive(id) || tree.continuesAxis(id) || document.index().axis(tree.parent(id)) != 0)
            continue;
        ++branches;
        const bool isYoung = tree.birth(id) + 14 > tree.step();
        QVERIFY(isYoung || document.index().nodePosition(tree.parent(id)).y() > 0.15F * height);
    }
    QVERIFY(branches > 10);
}

void VigourModelTest::growth_isTheSameOnOneThreadAndMany()
{
    const auto grown = [](int threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                        static_cast<std::size_t>(threads));
        VigourParameters vigour = branchy();
        vigour.bending = 5.0;
        vigour.lightPruning = 0.2;
        auto document = std::make_unique<TreeDocument>();
        grownTree(*document, 12, 80, vigour);
        brush(*document, strokeAlong(std::array{Vec3(0, 2, 0), Vec3(1, 3, 0)}, 0.6F, 0.5));
        return document;
    };
    const auto one = grown(1);
    const auto many = grown(8);
    QVERIFY(one->index().livingCount() > 2500);
    QVERIFY(one->tree() == many->tree());
    QVERIFY(DocumentState(*one) == DocumentState(*many));
}

void VigourModelTest::growth_isUndoneAndRedoneToTheBit()
{
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        VigourParameters vigour = branchy();
        vigour.bending = 8.0;
        vigour.lightPruning = 0.3;
        TreeDocument document;
        grownTree(document, seed, 30, vigour);
        const DocumentState before(document);
        QCOMPARE(grow(document, 12), 12);
        const DocumentState done(document);
        QCOMPARE(indexFault(document), QString());
        document.undo();
        QCOMPARE(differenceFrom(before, document), QString());
        document.redo();
        QVERIFY(DocumentState(document) == done);
        // Growing anew after an undo gives the same.
        document.undo();
        QCOMPARE(grow(document, 12), 12);
        QVERIFY(document.tree() == done.tree);
    }
}

void VigourModelTest::files_keepTheStateOfGrowth()
{
    VigourParameters vigour = branchy();
    vigour.bending = 8.0;
    TreeDocument document;
    grownTree(document, 17, 40, vigour);
    const Result<QByteArray> file = packProject(projectOf(document, QStringLiteral("vigour")));
    QVERIFY(file);
    Result<Project> project = unpackProject(*file);
    QVERIFY2(project, project ? "" : qPrintable(project.error().message));
    QVERIFY(project->tree == document.tree());
    TreeDocument read;
    read.reset(std::move(project->tree), std::move(project->journal));
    grow(document, 10);
    grow(read, 10);
    QVERIFY(read.tree() == document.tree());
}

void VigourModelTest::competitors_growAlone()
{
    TreeDocument document;
    grownTree(document, 13, 40, branchy());
    const Tree before = document.tree();
    // A growing tip of a branch.
    InternodeId tip = before.size() - 1;
    while ((before.buds(tip) & kTerminalBud) == 0)
        --tip;
    QVERIFY(grow(document, 15, {.node = tip, .slot = kTerminalSlot}) > 10);
    QCOMPARE(changesOutside(before, document.tree(), tip), 0);
    QVERIFY(document.tree().size() > before.size());
}

void VigourModelTest::addedVigour_isUsedUp()
{
    TreeDocument document;
    grownTree(document, 14, 30, branchy());
    TreeDocument plain;
    grownTree(plain, 14, 30, branchy());
    TreeDelta delta = deltaStartingAt(document.tree());
    const InternodeId branch = document.index().firstChild(10);
    delta.sparse.addedVigour.push_back({branch, std::nullopt, 1.0F});
    apply(document, std::move(delta));
    QCOMPARE(grow(document, 10), 10);
    QCOMPARE(grow(plain, 10), 10);
    QVERIFY(document.tree().content().sparse.addedVigour.cells().empty());
    QVERIFY(document.index().subtreeSize(branch) > plain.index().subtreeSize(branch) * 5 / 4);
}

void VigourModelTest::invigoratedBranch_growsAlone()
{
    TreeDocument document;
    grownTree(document, 15, 45, branchy());
    const InternodeId branch = document.index().firstChild(14);
    const Tree before = document.tree();
    GrowthWorkspace workspace;
    for (int i = 0; i < 12; ++i)
        apply(document, invigorate(document.tree(), document.index(), document.growthModel().space(), branch,
                                   0.2, 0.1, workspace));
    QCOMPARE(changesOutside(before, document.tree(), branch), 0);
    QVERIFY(document.tree().size() > before.size() + 20);
    QVERIFY(std::abs(*document.tree().content().sparse.addedVigour.at(branch) - 1.2F) < 1e-4F);
    // Its internodes are longer than the others'.
    double old = 0.0;
    double added = 0.0;
    int count = 0;
    for (InternodeId id = before.size(); id < document.tree().size(); ++id) {
        if (document.index().mainChild(id) == kNoInternode)
            continue;
        added += document.tree().length(id);
        ++count;
    }
    added /= count;
    count = 0;
    for (InternodeId id = 1; id < before.size(); ++id) {
        if (!before.isAlive(id) || document.index().mainChild(id) == kNoInternode)
            continue;
        old += before.length(id);
        ++count;
    }
    QVERIFY(added > 1.2 * old / count);
}

void VigourModelTest::brush_growsTowardTheMarkersAlone()
{
    TreeDocument document;
    grownTree(document, 16, 45, branchy());
    const Tree before = document.tree();
    const Vec3 aside(1.5F, 2.0F, 0.0F);
    brush(document, strokeAlong(std::array{Vec3(0.3F, 1.5F, 0.0F), aside}, 0.5F, 0.6));
    QVERIFY(document.tree().size() > before.size() + 10);
    int near = 0;
    for (InternodeId id = before.size(); id < document.tree().size(); ++id) {
        const Vec3& node = document.index().nodePosition(id);
        QVERIFY(node.x() > -0.6F); // nothing grows on the other side
        near += (node - aside).norm() < 0.7F ? 1 : 0;
    }
    QVERIFY(near > 3);
    QCOMPARE(indexFault(document), QString());
    // Far from the tree there is nothing to grow toward.
    const Tree grown = document.tree();
    brush(document, strokeAlong(std::array{Vec3(30, 2, 0), Vec3(31, 2, 0)}, 0.3F, 0.3));
    QVERIFY(document.tree() == grown);
}

void VigourModelTest::brush_shedsShadedTips()
{
    // A crown that never shed, in which new parameters find shade.
    for (const double pruning : {0.0, 0.6}) {
        TreeDocument document;
        grownTree(document, 14, 70, branchy());
        const std::uint32_t size = document.tree().size();
        TreeParameters parameters = document.parameters();
        parameters.vigour.lightPruning = pruning;
        setParameters(document, parameters);
        const float top = treeBounds(document.tree(), document.index()).max().y();
        brush(document, strokeAlong(std::array{Vec3(0, top, 0), Vec3(0.6F, top + 0.8F, 0)}, 0.5F, 1.5));
        QVERIFY(document.tree().size() > size);
        int dead = 0;
        for (InternodeId id = 0; id < document.tree().size(); ++id) {
            if (document.tree().isAlive(id))
                continue;
            ++dead;
            // Young shoots and the trunk stay.
            const auto& columns = document.tree().columns();
            QVERIFY(columns.death[id] >= columns.birth[id] + 12);
            QVERIFY(document.index().axis(id) != 0);
        }
        QVERIFY(pruning > 0.0 ? dead > 20 : dead == 0);
        QCOMPARE(indexFault(document), QString());
        const DocumentState done(document);
        document.undo();
        QCOMPARE(document.tree().size(), size);
        document.redo();
        QVERIFY(DocumentState(document) == done);
    }
}

void VigourModelTest::species_growDifferentOutlines()
{
    QVERIFY(vigourSpecies().size() >= 8);
    std::map<std::string, double> slenderness; // height by width
    for (const VigourSpecies& species : vigourSpecies()) {
        TreeParameters parameters = vigorous(species.parameters);
        visitParameters(parameters, [](const ParameterInfo& info, const auto& field) {
            using Field = std::remove_cvref_t<decltype(field)>;
            if constexpr (std::is_same_v<Field, double>) {
                const double value = info.quantity == Quantity::Angle ? degrees(field) : field;
                QVERIFY2(value >= info.minimum && value <= info.maximum + 1e-9, info.key);
            }
        });
        TreeDocument document;
        document.reset(3, parameters);
        QVERIFY2(grow(document, 100) == 100, species.name);
        const Box3 box = [&] {
            Box3 all;
            for (InternodeId id = 0; id < document.tree().size(); ++id) {
                if (document.tree().isAlive(id))
                    all.extend(document.index().nodePosition(id));
            }
            return all;
        }();
        QVERIFY2(document.index().livingCount() < 60'000, species.name);
        const Vec3 size = box.sizes();
        slenderness[species.name] = size.y() / (0.5F * (size.x() + size.z()));
    }
    QVERIFY(slenderness["Poplar"] > 2.5);
    QVERIFY(slenderness["Spruce"] > 1.2);
    QVERIFY(slenderness["Oak"] < 1.3);
    QVERIFY(slenderness["Acacia"] < 1.2);
}

const TestClass<VigourModelTest> vigourModelTest;

} // namespace espalier::test

#include "VigourModelTest.moc"
