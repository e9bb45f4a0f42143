// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/BrushGesture.h"
#include "tests/support/Documents.h"
#include "tests/support/Growing.h"
#include "tests/support/Replaying.h"
#include "tests/support/TestClasses.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>

namespace espalier::test {

/// Strokes that are turned or repeated about the trunk (StrokePlacement).
class BrushPlacementTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void spreadLimbs_standAllAround_data();
    void spreadLimbs_standAllAround();
    void copies_areOneUndoStep();
    void copiesOfACrown_fillAllSides();
    void sameSamples_giveTheSameBytes();
    void recipe_givesTheSameDocument();
};

namespace {

void drawMast(TreeDocument& document)
{
    TreeParameters parameters;
    parameters.growth.internodeLength = 0.1;
    document.reset(4, parameters);
    brush(document, strokeAlong(std::vector{Vec3(0.0F, 0.0F, 0.0F), Vec3(0.0F, 2.5F, 0.0F)}, 0.0F, 2.0));
    document.undoStack().clear();
}

/// A limb as it is drawn from the front: from the trunk to the right and up.
void drawLimb(TreeDocument& document, float height, float radius, StrokePlacement placement)
{
    placement.around = Vec3(0.0F, height, 0.0F);
    const std::vector<BrushSample> samples = strokeAlong(
        std::vector{placement.around, Vec3(placement.around + Vec3(1.2F, 0.4F, 0.0F))}, radius, 0.8);
    BrushGesture gesture(document, samples.front(), {}, StrokeEnd::Arrives, placement);
    for (const BrushSample& sample : samples)
        gesture.add(sample);
    gesture.finish();
}

/// The azimuths of the branches that reach at least @p reach, m, away from the trunk, degrees, ascending.
std::vector<double> limbAzimuths(const TreeDocument& document, float reach)
{
    const Tree& tree = document.tree();
    const TreeIndex& index = document.index();
    std::vector<double> azimuths;
    for (InternodeId id = 1; id < tree.size(); ++id) {
        if (!tree.isAlive(id) || index.axis(id) != id)
            continue;
        InternodeId tip = id;
        while (index.mainChild(tip) != kNoInternode)
            tip = index.mainChild(tip);
        const Vec3& way = index.nodePosition(tip);
        if (std::hypot(way.x(), way.z()) >= reach)
            azimuths.push_back(degrees(std::atan2(double{way.z()}, double{way.x()})));
    }
    std::ranges::sort(azimuths);
    return azimuths;
}

double greatestGap(const std::vector<double>& azimuths)
{
    double gap = azimuths.front() + 360.0 - azimuths.back();
    for (std::size_t i = 1; i < azimuths.size(); ++i)
        gap = std::max(gap, azimuths[i] - azimuths[i - 1]);
    return gap;
}

} // namespace

void BrushPlacementTest::spreadLimbs_standAllAround_data()
{
    QTest::addColumn<float>("radius");
    QTest::newRow("line") << 0.0F;
    QTest::newRow("thin brush") << 0.08F;
}

void BrushPlacementTest::spreadLimbs_standAllAround()
{
    QFETCH(float, radius);
    TreeDocument document;
    drawMast(document);
    for (int i = 0; i < 6; ++i)
        drawLimb(document, 0.8F + 0.25F * static_cast<float>(i), radius, {.isSpread = true});
    const std::vector<double> azimuths = limbAzimuths(document, 0.8F);
    QVERIFY(azimuths.size() == 6 || (radius > 0.0F && azimuths.size() > 6));
    QVERIFY2(greatestGap(azimuths) < 130.0, qPrintable(QString::number(greatestGap(azimuths))));
    // Drawn without it, all of them are on one side.
    TreeDocument flat;
    drawMast(flat);
    for (int i = 0; i < 6; ++i)
        drawLimb(flat, 0.8F + 0.25F * static_cast<float>(i), radius, {});
    QVERIFY(greatestGap(limbAzimuths(flat, 0.8F)) > 300.0);
}

void BrushPlacementTest::copies_areOneUndoStep()
{
    TreeDocument document;
    drawMast(document);
    const DocumentState before(document);
    drawLimb(document, 1.2F, 0.0F, {.copies = 5});
    QCOMPARE(document.undoStack().count(), 1);
    const std::vector<double> azimuths = limbAzimuths(document, 0.8F);
    QCOMPARE(azimuths.size(), std::size_t{5});
    QVERIFY(std::abs(greatestGap(azimuths) - 72.0) < 8.0);
    QCOMPARE(indexFault(document), QString());
    document.undoStack().undo();
    QCOMPARE(differenceFrom(before, document), QString());
}

void BrushPlacementTest::copiesOfACrown_fillAllSides()
{
    TreeDocument document;
    drawMast(document);
    drawLimb(document, 1.5F, 0.4F, {.copies = 3});
    std::array<int, 3> nodes{};
    for (InternodeId id = 0; id < document.tree().size(); ++id) {
        const Vec3& node = document.index().nodePosition(id);
        if (std::hypot(node.x(), node.z()) < 0.4F)
            continue;
        const double azimuth = degrees(std::atan2(double{node.z()}, double{node.x()})) + 60.0;
        ++nodes[static_cast<std::size_t>(std::floor((azimuth < 0.0 ? azimuth + 360.0 : azimuth) / 120.0)) %
                3];
    }
    for (const int count : nodes)
        QVERIFY(count > 20);
}

void BrushPlacementTest::sameSamples_giveTheSameBytes()
{
    TreeDocument first;
    TreeDocument second;
    for (TreeDocument* document : {&first, &second}) {
        drawMast(*document);
        drawLimb(*document, 0.8F, 0.0F, {.isSpread = true});
        drawLimb(*document, 1.1F, 0.3F, {.copies = 2, .isSpread = true});
    }
    QCOMPARE(differenceFrom(DocumentState(first), second), QString());
}

void BrushPlacementTest::recipe_givesTheSameDocument()
{
    TreeDocument document;
    drawMast(document);
    drawLimb(document, 0.8F, 0.0F, {.isSpread = true});
    drawLimb(document, 1.0F, 0.07F, {.isSpread = true});
    drawLimb(document, 1.4F, 0.3F, {.copies = 3, .isSpread = true});
    QCOMPARE(replayFault(document), QString());
}

static const TestClass<BrushPlacementTest> brushPlacementTest;

} // namespace espalier::test

#include "BrushPlacementTest.moc"
