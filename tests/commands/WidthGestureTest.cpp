// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/WidthGesture.h"

#include "model/shape/Widths.h"
#include "tests/support/Documents.h"
#include "tests/support/Growing.h"
#include "tests/support/TestClasses.h"

#include <QTest>

#include <cmath>

namespace espalier::test {

class WidthGestureTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void width_isOneDeltaAndOneUndoStep_undoneAndRedoneToTheBit();
    void branch_hasTheWidthThatWasSet();
    void constraint_movesAndTakesThePlaceOfAnother();
    void zero_removesTheConstraint();
    void cancelledWidth_leavesNoTrace();
    void sameWidth_isNoCommand();
    void hostileWidths_leaveSoundRadii_data();
    void hostileWidths_leaveSoundRadii();
    void deadAndUnknown_haveNoWidth();
};

namespace {

double diameterAt(const TreeDocument& document, InternodeId id)
{
    return 2.0 * static_cast<double>(Widths(document.tree(), document.index()).radius(document.index(), id));
}

/// A living internode that carries about @p share of the tips.
InternodeId bough(const TreeDocument& document, double share)
{
    InternodeId best = 0;
    const auto off = [&](InternodeId id) {
        return std::abs(document.index().tipCount(id) - share * document.index().tipCount(0));
    };
    for (InternodeId id = 1; id < document.tree().size(); ++id) {
        if (document.tree().isAlive(id) && off(id) < off(best))
            best = id;
    }
    return best;
}

} // namespace

void WidthGestureTest::width_isOneDeltaAndOneUndoStep_undoneAndRedoneToTheBit()
{
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        TreeDocument document;
        growAtRandom(document, seed, 100, 300);
        const DocumentState before(document);
        const InternodeId id = bough(document, 0.4);
        WidthGesture gesture(document, id);
        for (int i = 1; i <= 20; ++i) {
            gesture.set(0.01 * i);
            QCOMPARE(document.journal().size(), before.journal.size() + 1);
            QCOMPARE(document.tree().widthConstraint(id), static_cast<float>(0.01 * i));
        }
        gesture.finish();
        QCOMPARE(document.undoStack().count(), before.undoIndex + 1);
        QCOMPARE(document.undoStack().undoText(), QStringLiteral("Set Width"));
        QCOMPARE(indexFault(document), QString());
        const DocumentState done(document);
        document.undoStack().undo();
        QVERIFY(DocumentState(document) == before);
        QCOMPARE(differenceFrom(before, document), QString());
        document.undoStack().redo();
        QVERIFY(DocumentState(document) == done);
    }
}

void WidthGestureTest::branch_hasTheWidthThatWasSet()
{
    TreeDocument document;
    grow(document, 16);
    const InternodeId id = bough(document, 0.3);
    const double before = diameterAt(document, id);
    const double baseBefore = diameterAt(document, 0);
    setWidth(document, id, 3.0 * before);
    QVERIFY(std::abs(diameterAt(document, id) - 3.0 * before) < 1e-6);
    // The branches below it become thicker, too.
    QVERIFY(diameterAt(document, 0) > baseBefore);
    setWidth(document, 0, 5.0 * before);
    QVERIFY(std::abs(diameterAt(document, 0) - 5.0 * before) < 1e-6);
    QVERIFY(std::abs(diameterAt(document, id) - 3.0 * before) < 1e-6);
    QCOMPARE(document.undoStack().count(), 3); // the growth, too
}

void WidthGestureTest::constraint_movesAndTakesThePlaceOfAnother()
{
    TreeDocument document;
    grow(document, 16);
    const InternodeId first = bough(document, 0.3);
    const InternodeId second = bough(document, 0.6);
    QVERIFY(first != second);
    setWidth(document, first, 0.05);
    setWidth(document, second, 0.08);
    const DocumentState before(document);
    WidthGesture gesture(document, first);
    gesture.set(bough(document, 0.1), 0.05);
    QCOMPARE(document.tree().widthConstraint(first), 0.0F);
    QCOMPARE(document.tree().widthConstraints().size(), 2U);
    gesture.set(second, 0.05);
    QCOMPARE(document.tree().widthConstraints().size(), 1U);
    QCOMPARE(document.tree().widthConstraint(second), 0.05F);
    gesture.finish();
    QCOMPARE(document.journal().size(), before.journal.size() + 1);
    document.undoStack().undo();
    QVERIFY(DocumentState(document) == before);
    QCOMPARE(document.tree().widthConstraint(first), 0.05F);
    QCOMPARE(document.tree().widthConstraint(second), 0.08F);
}

void WidthGestureTest::zero_removesTheConstraint()
{
    TreeDocument document;
    grow(document, 10);
    const InternodeId id = bough(document, 0.5);
    const double natural = diameterAt(document, id);
    const DocumentState before(document);
    setWidth(document, id, 0.2);
    const DocumentState wide(document);
    setWidth(document, id, 0.0);
    QVERIFY(document.tree().widthConstraints().empty());
    QCOMPARE(document.undoStack().undoText(), QStringLiteral("Remove Width"));
    QCOMPARE(diameterAt(document, id), natural);
    document.undoStack().undo();
    QVERIFY(DocumentState(document) == wide);
    document.undoStack().undo();
    QVERIFY(DocumentState(document) == before);
}

void WidthGestureTest::cancelledWidth_leavesNoTrace()
{
    TreeDocument document;
    grow(document, 8);
    setWidth(document, 2, 0.03);
    const DocumentState before(document);
    {
        WidthGesture dropped(document, 2);
        dropped.set(5, 0.1);
        QVERIFY(!(document.tree() == before.tree));
    }
    QVERIFY(DocumentState(document) == before);
    WidthGesture gesture(document, 2);
    gesture.set(0.0);
    gesture.cancel();
    gesture.set(0.7);
    gesture.finish();
    QVERIFY(DocumentState(document) == before);
}

void WidthGestureTest::sameWidth_isNoCommand()
{
    TreeDocument document;
    grow(document, 8);
    setWidth(document, 2, 0.03);
    const DocumentState before(document);
    setWidth(document, 2, 0.03);
    setWidth(document, 3, 0.0);
    WidthGesture untouched(document, 2);
    untouched.set(0.4);
    untouched.set(0.03);
    untouched.finish();
    QVERIFY(DocumentState(document) == before);
}

void WidthGestureTest::hostileWidths_leaveSoundRadii_data()
{
    QTest::addColumn<double>("diameter");
    for (const double diameter : {1e-30, 1e-3, 50.0, 1e30, std::numeric_limits<double>::infinity(), 0.0, -1.0,
                                  -std::numeric_limits<double>::infinity(), std::nan("")})
        QTest::addRow("%g", diameter) << diameter;
}

void WidthGestureTest::hostileWidths_leaveSoundRadii()
{
    QFETCH(double, diameter);
    TreeDocument document;
    grow(document, 14);
    const DocumentState before(document);
    // At the base, at a twig, and one hard above the other.
    const InternodeId twig = bough(document, 0.0);
    for (const InternodeId id : {InternodeId{0}, twig, bough(document, 0.5), InternodeId{1}})
        setWidth(document, id, diameter);
    for (const WidthConstraint& constraint : document.tree().widthConstraints())
        QVERIFY(constraint.value > 0.0F && constraint.value <= kGreatestDiameter);
    const Widths widths(document.tree(), document.index());
    for (InternodeId id = 0; id < document.tree().size(); ++id) {
        const float radius = widths.radius(document.index(), id);
        QVERIFY(std::isfinite(radius) && radius >= 0.0F && radius <= 2.0F * kGreatestDiameter);
        QVERIFY(!document.tree().isAlive(id) || radius > 0.0F);
    }
    QCOMPARE(indexFault(document), QString());
    while (document.undoStack().index() > before.undoIndex)
        document.undoStack().undo();
    QVERIFY(DocumentState(document) == before);
}

void WidthGestureTest::deadAndUnknown_haveNoWidth()
{
    TreeDocument document;
    grow(document, 8);
    const DocumentState before(document);
    setWidth(document, document.tree().size(), 0.1);
    setWidth(document, kNoInternode, 0.1);
    WidthGesture gesture(document, 1);
    gesture.set(kNoInternode, 0.1);
    gesture.finish();
    QVERIFY(DocumentState(document) == before);
}

const TestClass<WidthGestureTest> widthGestureTest;

} // namespace espalier::test

#include "WidthGestureTest.moc"
