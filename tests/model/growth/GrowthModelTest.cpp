// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/growth/GrowthModel.h"

#include "commands/GrowGesture.h"
#include "commands/GrowthReplica.h"
#include "tests/support/Documents.h"
#include "tests/support/Growing.h"
#include "tests/support/TestClasses.h"

#include <QTest>

namespace espalier::test {

class GrowthModelTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void document_growsByTheModelThatItHas();
    void switchedModels_growOnFromEachOthersTree();
    void switchedModels_areUndone();
    void replica_growsByTheModelThatItIsGiven();
};

namespace {

/// Lengthens the trunk by one internode a step.
class UprightModel final : public GrowthModel {
public:
    std::unique_ptr<GrowthModel> fresh() const override { return std::make_unique<UprightModel>(); }
    void rebuild(const Tree& /*tree*/, const TreeIndex& /*index*/) override { ++m_rebuilds; }
    void follow(const Tree& /*tree*/, const TreeIndex& /*index*/, const TreeDelta& /*delta*/) override {}
    bool settleSome(const Tree& /*tree*/, const TreeIndex& /*index*/, std::size_t /*nodes*/) override
    {
        return m_rebuilds > 0;
    }
    const VoxelSpace& space() const override { return m_space; }
    std::size_t bytes() const override { return 0; }
    TreeDelta growFreely(const Tree& tree, const TreeIndex& index, const GrowthStepOptions& /*options*/,
                         GrowthWorkspace& workspace) const override
    {
        const BudRef tip{trunkTip(index, 0), kTerminalSlot};
        const Vec3 above = index.nodePosition(tip.node) + Vec3(0.0F, 100.0F, 0.0F);
        return growLeader(tree, index, tip, above, 0.0F, 1, workspace);
    }
    TreeDelta growToward(const Tree& tree, const TreeIndex& index, MarkerSet& /*markers*/,
                         const GrowthStepOptions& options, GrowthWorkspace& workspace) const override
    {
        return growFreely(tree, index, options, workspace);
    }

private:
    VoxelSpace m_space;
    int m_rebuilds = 0;
};

} // namespace

void GrowthModelTest::document_growsByTheModelThatItHas()
{
    TreeDocument document;
    document.setGrowthModel(std::make_unique<UprightModel>());
    grow(document, 7);
    QCOMPARE(document.index().livingCount(), 8U);
    QCOMPARE(document.index().axis(trunkTip(document.index(), 0)), 0U);
    QCOMPARE(document.index().tipCount(0), 1U);
}

void GrowthModelTest::switchedModels_growOnFromEachOthersTree()
{
    TreeDocument document;
    growAtRandom(document, 5, 30, 80);
    const std::uint32_t before = document.index().livingCount();

    document.setGrowthModel(std::make_unique<UprightModel>());
    grow(document, 3);
    QCOMPARE(document.index().livingCount(), before + 3);

    document.setGrowthModel(std::make_unique<SelfOrganisingModel>());
    QCOMPARE(indexFault(document), QString());
    grow(document, 2);
    QVERIFY(document.index().livingCount() > before + 5);
    QCOMPARE(indexFault(document), QString());
}

void GrowthModelTest::switchedModels_areUndone()
{
    TreeDocument document;
    growAtRandom(document, 6, 30, 80);
    const DocumentState start(document);
    grow(document, 1);
    document.setGrowthModel(std::make_unique<UprightModel>());
    grow(document, 2);
    document.setGrowthModel(std::make_unique<SelfOrganisingModel>());
    document.undo();
    document.undo();
    QCOMPARE(differenceFrom(start, document), QString());
}

void GrowthModelTest::replica_growsByTheModelThatItIsGiven()
{
    TreeDocument document;
    growAtRandom(document, 7, 20, 50);
    document.setGrowthModel(std::make_unique<UprightModel>());
    const Tree before = document.tree();
    GrowGesture gesture(document);
    GrowthReplica replica(before, document.freshGrowthModel(), gesture.takeProcess());
    const GrownStep step = replica.grow();
    QCOMPARE(step.delta.born.count, 1U);
}

const TestClass<GrowthModelTest> growthModelTest;

} // namespace espalier::test

#include "GrowthModelTest.moc"
