// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/WidthGesture.h"
#include "model/document/HistorySnapshot.h"
#include "model/settings/Lengths.h"
#include "model/shape/Widths.h"
#include "tests/support/Documents.h"
#include "tests/support/TestClasses.h"
#include "tests/support/TreeBuilder.h"
#include "tests/support/ViewportFixture.h"
#include "views/LabelEditor.h"
#include "views/render/LabelLayout.h"
#include "views/tools/BendTool.h"
#include "views/tools/WidthTool.h"

using namespace espalier;
using namespace espalier::test;

/// Bending and widths by mouse, by finger and by pen.
class ShapingToolsTest : public ViewportFixture {
    Q_OBJECT

private Q_SLOTS:
    void bendMouse_pullsTheBranchFromItsOwnBase();
    void bendPins_holdBaseAndMiddle();
    void bendEscape_takesTheDragBackAndThenThePins();
    void bendTapBesideTheTree_clearsThePins();
    void bendPins_stayUnderNewIds();
    void bendFinger_pullsTheBranch();
    void bendTwoFingers_lowerIsTheBase();
    void bendThreeFingers_holdTheMiddleToo();
    void bendTwoFingersAtOnce_bendToo();
    void bendFingersOffTheBranch_moveTheCamera();
    void bendPen_pullsTheBranch();
    void bendWeights_changeTheForm();
    void bendIntoTheSeedling_doesNothing();
    void widthTap_holdsTheWidthThatIs();
    void widthEnds_setTheWidth();
    void widthMiddle_movesAlongTheBranch();
    void widthDrawnToTheAxis_isRemoved();
    void widthDelete_removesTheOneUnderThePointer();
    void widthDoubleClick_removes();
    void widthHandle_staysChosenUnderNewIds();
    void widthLabel_isTypedIn();
    void widthLabel_refusesNonsenseAndEscapes();
    void widthLabel_doubleClickPutsNoHandleOnATwigBehind();
    void widthLabels_doNotCoverEachOther();
    void widthTap_takesTheTrunkAndNotTheTwigInFront();
    void widthEscape_takesTheDragBack();
    void widthFingerAndPen_setTheWidth();
    void widthAnywhereOnTheScreen_leavesASoundTree();
    void labels_saySoInCentimetres();

private:
    static constexpr InternodeId kTop = 12;    ///< Tip of the trunk
    static constexpr InternodeId kBranch = 13; ///< First of a branch of seven
    static constexpr InternodeId kTip = 19;

    static constexpr InternodeId kAnother = 6; ///< Internodes of growAnother()

    void plant();
    InternodeId growAnother();
    void dropTheBranch();
    template <class T>
    T* take();
    Vec3 node(InternodeId id) const { return m_document->index().nodePosition(id); }
    Vec3 middle(InternodeId id) const
    {
        return 0.5F * (node(id) + m_document->index().basePosition(m_document->tree(), id));
    }
    void touchMove(std::initializer_list<std::pair<int, QPoint>> fingers);
    void click(const Vec3& place) { QTest::mouseClick(m_view.get(), Qt::LeftButton, {}, at(place)); }
    double diameter(InternodeId id) const
    {
        return 2.0 * static_cast<double>(
                         Widths(m_document->tree(), m_document->index()).radius(m_document->index(), id));
    }
    /// Place of the right end of a width's handle.
    QPoint handleEnd(InternodeId id) const;
    /// The middle of the label of a width's handle.
    QPoint labelPlace(InternodeId id) const;
    void dragPixels(const QPoint& from, const QPoint& to);
    bool isPositionedLikeBefore(const DocumentState& before, InternodeId id) const
    {
        return TreeIndex(before.tree).nodePosition(id) == node(id);
    }
};

/// A trunk of thirteen internodes, and from its fifth a branch of seven toward the right, with twigs.
void ShapingToolsTest::plant()
{
    TreeParameters parameters = smallTree();
    parameters.leaves.visible = false;
    m_document->reset(7, parameters);
    std::vector<NewInternode> internodes;
    for (InternodeId i = 0; i < kTop; ++i)
        internodes.push_back({.parent = i, .length = 0.2F});
    internodes.push_back(
        {.parent = 4, .slot = 0, .rotation = branching(radians(65), 0, 1, 0.0), .length = 0.2F});
    for (InternodeId i = kBranch; i < kTip; ++i)
        internodes.push_back({.parent = i, .length = 0.2F});
    // So that the trunk carries more than the branch.
    for (InternodeId i = 6; i < kTop; ++i)
        internodes.push_back({.parent = i, .slot = 0, .rotation = branching(radians(50)), .length = 0.1F});
    internodes.push_back({.parent = kTip - 2, .slot = 0, .rotation = branching(radians(50)), .length = 0.1F});
    apply(*m_document, births(m_document->tree(), internodes));
    m_document->undoStack().clear();
    m_view->setCamera(Camera());
    QVERIFY(std::abs(node(kTip).x()) > 1.0F);
    // Drawing determines the radius of the bark.
    m_view->grabFramebuffer();
}

template <class T>
T* ShapingToolsTest::take()
{
    plant();
    auto tool = std::make_unique<T>(m_view->toolContext());
    T* raw = tool.get();
    m_view->setTool(std::move(tool));
    return raw;
}

void ShapingToolsTest::touchMove(std::initializer_list<std::pair<int, QPoint>> fingers)
{
    auto event = QTest::touchEvent(m_view.get(), m_touch.get());
    for (const auto& [finger, place] : fingers)
        event.move(finger, place);
    event.commit();
    QTest::qWait(20);
}

void ShapingToolsTest::dragPixels(const QPoint& from, const QPoint& to)
{
    QTest::mousePress(m_view.get(), Qt::LeftButton, {}, from);
    for (int i = 1; i <= 10; ++i) {
        const QPointF place = QPointF(from) + QPointF(to - from) * i / 10.0;
        QMouseEvent event(QEvent::MouseMove, place, m_view->mapToGlobal(place), Qt::NoButton, Qt::LeftButton,
                          Qt::NoModifier);
        QCoreApplication::sendEvent(m_view.get(), &event);
    }
    QTest::mouseRelease(m_view.get(), Qt::LeftButton, {}, to);
}

QPoint ShapingToolsTest::handleEnd(InternodeId id) const
{
    const Camera& camera = m_view->mainCamera();
    Vec3 across = m_document->index().heading(id).cross(camera.forward()).normalized();
    if (across.dot(camera.right()) < 0.0F)
        across = -across;
    const float pixels = camera.pixelsPerMetre(camera.depth(middle(id)));
    const float reach =
        m_document->tree().widthConstraint(id) / 2.0F + static_cast<float>(WidthTool::kBeyond) / pixels;
    return at(middle(id) + reach * across);
}

void ShapingToolsTest::bendMouse_pullsTheBranchFromItsOwnBase()
{
    take<BendTool>();
    const DocumentState before(*m_document);
    const Vec3 start = node(kTip);
    const Vec3 target = start + Vec3(-0.3F, -0.5F, 0.0F);
    QTest::mouseMove(m_view.get(), at(start));
    stroke(start, target, 300);
    QVERIFY2((node(kTip) - target).norm() < 0.03F, qPrintable(QString::number((node(kTip) - target).norm())));
    QVERIFY(isPositionedLikeBefore(before, kTop));
    QVERIFY(isPositionedLikeBefore(before, 4));
    QCOMPARE(m_document->undoStack().count(), 1);
    QCOMPARE(m_document->journal().size(), before.journal.size() + 1);
    QCOMPARE(indexFault(*m_document), QString());
    m_document->undoStack().undo();
    QVERIFY(DocumentState(*m_document) == before);
    m_document->undoStack().redo();
    QVERIFY((node(kTip) - target).norm() < 0.03F);
}

void ShapingToolsTest::bendPins_holdBaseAndMiddle()
{
    take<BendTool>();
    const InternodeId base = kBranch + 1;
    const InternodeId held = kBranch + 3;
    click(middle(base));
    click(middle(held));
    QCOMPARE(m_document->undoStack().count(), 0);
    const DocumentState before(*m_document);
    const Vec3 heldAt = middle(held);
    const Vec3 start = node(kTip);
    const Vec3 target = start + Vec3(-0.2F, 0.3F, 0.0F);
    stroke(start, target, 300);
    QVERIFY((node(kTip) - target).norm() < 0.03F);
    QVERIFY((middle(held) - heldAt).norm() < 0.03F);
    QVERIFY(isPositionedLikeBefore(before, base));
    QCOMPARE(m_document->undoStack().count(), 1);
    // The pin itself is dragged.
    const Vec3 pinTarget = middle(held) + Vec3(0.05F, -0.25F, 0.0F);
    stroke(middle(held), pinTarget, 300);
    QVERIFY((middle(held) - pinTarget).norm() < 0.03F);
    QVERIFY(isPositionedLikeBefore(before, base));
    QCOMPARE(m_document->undoStack().count(), 2);
    QCOMPARE(indexFault(*m_document), QString());
}

void ShapingToolsTest::bendEscape_takesTheDragBackAndThenThePins()
{
    take<BendTool>();
    click(middle(kBranch + 1));
    const DocumentState before(*m_document);
    const Vec3 start = node(kTip);
    const Vec3 target = start + Vec3(-0.2F, 0.4F, 0.0F);
    press(start);
    drag(start, target, 200);
    QVERIFY(!(m_document->tree() == before.tree));
    QTest::keyClick(m_view.get(), Qt::Key_Escape);
    QVERIFY(DocumentState(*m_document) == before);
    release(target);
    QVERIFY(DocumentState(*m_document) == before);
    // The base is pinned still.
    stroke(start, target, 200);
    QVERIFY(isPositionedLikeBefore(before, kBranch + 1));
    m_document->undoStack().undo();
    QTest::keyClick(m_view.get(), Qt::Key_Escape);
    stroke(start, target, 200);
    QVERIFY(!isPositionedLikeBefore(before, kBranch + 1));
}

void ShapingToolsTest::bendTapBesideTheTree_clearsThePins()
{
    take<BendTool>();
    const DocumentState before(*m_document);
    click(middle(kBranch + 2));
    QTest::mouseClick(m_view.get(), Qt::LeftButton, {}, {20, 20});
    stroke(node(kTip), node(kTip) + Vec3(-0.2F, 0.4F, 0.0F), 200);
    QVERIFY(!isPositionedLikeBefore(before, kBranch + 2));
    QCOMPARE(m_document->undoStack().count(), 1);
}

/// Grows another branch below the first one, to the right as well; returns its first internode.
InternodeId ShapingToolsTest::growAnother()
{
    const InternodeId first = m_document->tree().size();
    std::vector<NewInternode> internodes{
        {.parent = 2, .slot = 0, .rotation = branching(radians(80), 0, 1, 0.0), .length = 0.2F}};
    for (InternodeId i = 0; i < kAnother - 1; ++i)
        internodes.push_back({.parent = first + i, .length = 0.2F});
    apply(*m_document, births(m_document->tree(), internodes));
    m_view->grabFramebuffer();
    return first;
}

/// Lets the first branch die, and the history forget it.
void ShapingToolsTest::dropTheBranch()
{
    const std::uint32_t rows = m_document->tree().size();
    apply(*m_document, death(m_document->tree(), m_document->index(), kBranch));
    std::optional<ShortenedHistory> shortened =
        HistorySnapshot(*m_document).without(m_document->journal().size());
    QVERIFY(shortened && m_document->shorten(*shortened));
    QVERIFY(m_document->tree().size() < rows);
    m_view->grabFramebuffer();
}

void ShapingToolsTest::bendPins_stayUnderNewIds()
{
    take<BendTool>();
    const InternodeId old = growAnother() + 2;
    const InternodeKey key = m_document->tree().key(old);
    click(middle(old));
    dropTheBranch();
    const auto pinned = static_cast<InternodeId>(m_document->tree().columns().key.indexOf(key));
    QVERIFY(pinned != old);
    const DocumentState before(*m_document);
    const InternodeId tip = pinned + kAnother - 3;
    stroke(node(tip), node(tip) + Vec3(-0.1F, -0.2F, 0.0F), 200);
    QVERIFY(!isPositionedLikeBefore(before, tip));
    QVERIFY(isPositionedLikeBefore(before, pinned));
    QCOMPARE(indexFault(*m_document), QString());
}

void ShapingToolsTest::bendFinger_pullsTheBranch()
{
    take<BendTool>();
    const QPoint from = at(node(kTip));
    const Vec3 target = node(kTip) + Vec3(-0.2F, -0.6F, 0.0F);
    const QPoint to = at(target);
    QTest::touchEvent(m_view.get(), m_touch.get()).press(0, from);
    for (int i = 1; i <= 10; ++i)
        touchMove({{0, from + (to - from) * i / 10}});
    QTest::touchEvent(m_view.get(), m_touch.get()).release(0, to);
    QVERIFY((node(kTip) - target).norm() < 0.05F);
    QCOMPARE(m_document->undoStack().count(), 1);
    QCOMPARE(indexFault(*m_document), QString());
}

void ShapingToolsTest::bendTwoFingers_lowerIsTheBase()
{
    take<BendTool>();
    const DocumentState before(*m_document);
    const Camera camera = m_view->mainCamera();
    const InternodeId base = kBranch + 2;
    const QPoint lower = at(middle(base));
    const QPoint from = at(node(kTip));
    const Vec3 target = node(kTip) + Vec3(-0.2F, -0.4F, 0.0F);
    const QPoint to = at(target);
    QTest::touchEvent(m_view.get(), m_touch.get()).press(0, from);
    QTest::touchEvent(m_view.get(), m_touch.get()).stationary(0).press(1, lower);
    for (int i = 1; i <= 10; ++i)
        touchMove({{0, from + (to - from) * i / 10}, {1, lower}});
    QVERIFY(m_view->isGestureActive());
    QTest::touchEvent(m_view.get(), m_touch.get()).release(0, to).stationary(1);
    QVERIFY(!m_view->isGestureActive());
    // The finger that stays down changes nothing.
    const DocumentState done(*m_document);
    touchMove({{1, lower + QPoint(60, 60)}});
    QTest::touchEvent(m_view.get(), m_touch.get()).release(1, lower + QPoint(60, 60));
    QVERIFY(DocumentState(*m_document) == done);
    QVERIFY((node(kTip) - target).norm() < 0.05F);
    QVERIFY(isPositionedLikeBefore(before, base));
    QVERIFY(m_view->mainCamera() == camera);
    QCOMPARE(m_document->undoStack().count(), 1);
    m_document->undoStack().undo();
    QVERIFY(DocumentState(*m_document) == before);
}

void ShapingToolsTest::bendThreeFingers_holdTheMiddleToo()
{
    take<BendTool>();
    const DocumentState before(*m_document);
    const InternodeId base = kBranch;
    const InternodeId held = kBranch + 3;
    const QPoint lower = at(middle(base));
    const QPoint middleAt = at(middle(held));
    const QPoint from = at(node(kTip));
    const Vec3 target = node(kTip) + Vec3(-0.3F, 0.2F, 0.0F);
    const Vec3 heldTarget = middle(held) + Vec3(0.0F, -0.2F, 0.0F);
    QTest::touchEvent(m_view.get(), m_touch.get()).press(0, lower);
    QTest::touchEvent(m_view.get(), m_touch.get()).stationary(0).press(1, from);
    QTest::touchEvent(m_view.get(), m_touch.get()).stationary(0).stationary(1).press(2, middleAt);
    for (int i = 1; i <= 10; ++i) {
        touchMove({{0, lower},
                   {1, from + (at(target) - from) * i / 10},
                   {2, middleAt + (at(heldTarget) - middleAt) * i / 10}});
    }
    QTest::touchEvent(m_view.get(), m_touch.get())
        .release(0, lower)
        .release(1, at(target))
        .release(2, at(heldTarget));
    QVERIFY((node(kTip) - target).norm() < 0.06F);
    QVERIFY((middle(held) - heldTarget).norm() < 0.06F);
    QVERIFY(isPositionedLikeBefore(before, base));
    QCOMPARE(m_document->undoStack().count(), 1);
    QCOMPARE(indexFault(*m_document), QString());
    m_document->undoStack().undo();
    QVERIFY(DocumentState(*m_document) == before);
}

void ShapingToolsTest::bendTwoFingersAtOnce_bendToo()
{
    take<BendTool>();
    const DocumentState before(*m_document);
    const QPoint lower = at(middle(kBranch + 1));
    const QPoint from = at(node(kTip));
    QTest::touchEvent(m_view.get(), m_touch.get()).press(0, from).press(1, lower);
    for (int i = 1; i <= 10; ++i)
        touchMove({{0, from + QPoint(-1, 3) * i}, {1, lower}});
    QTest::touchEvent(m_view.get(), m_touch.get()).release(0, from + QPoint(-10, 30)).release(1, lower);
    QVERIFY(!isPositionedLikeBefore(before, kTip));
    QVERIFY(isPositionedLikeBefore(before, kBranch + 1));
    QCOMPARE(m_document->undoStack().count(), 1);
}

void ShapingToolsTest::bendFingersOffTheBranch_moveTheCamera()
{
    take<BendTool>();
    const DocumentState before(*m_document);
    const Camera camera = m_view->mainCamera();
    const QPoint from = at(node(kTip));
    QTest::touchEvent(m_view.get(), m_touch.get()).press(0, from);
    touchMove({{0, from + QPoint(0, 20)}});
    touchMove({{0, from + QPoint(0, 40)}});
    QVERIFY(!(m_document->tree() == before.tree));
    // The second finger is beside the tree: both move the camera.
    const QPoint beside(60, 60);
    QTest::touchEvent(m_view.get(), m_touch.get()).stationary(0).press(1, beside);
    QVERIFY(DocumentState(*m_document) == before);
    touchMove({{0, from + QPoint(30, 40)}, {1, beside + QPoint(30, 0)}});
    QTest::touchEvent(m_view.get(), m_touch.get())
        .release(0, from + QPoint(30, 40))
        .release(1, beside + QPoint(30, 0));
    QVERIFY(DocumentState(*m_document) == before);
    QVERIFY(!(m_view->mainCamera() == camera));
}

void ShapingToolsTest::bendPen_pullsTheBranch()
{
    take<BendTool>();
    const QPointF from = at(node(kTip));
    const Vec3 target = node(kTip) + Vec3(-0.2F, 0.5F, 0.0F);
    const QPointF to = at(target);
    sendPen(QEvent::TabletPress, from, 0.5);
    for (int i = 1; i <= 10; ++i) {
        sendPen(QEvent::TabletMove, from + (to - from) * i / 10.0, 0.5);
        QTest::qWait(20);
    }
    sendPen(QEvent::TabletRelease, to, 0.0);
    QVERIFY((node(kTip) - target).norm() < 0.03F);
    QCOMPARE(m_document->undoStack().count(), 1);
}

void ShapingToolsTest::bendWeights_changeTheForm()
{
    const auto lengthOfBranch = [this] {
        float sum = 0.0F;
        for (InternodeId id = kBranch; id <= kTip; ++id)
            sum += m_document->tree().length(id);
        return sum;
    };
    const auto lengthWith = [&](double stretching) {
        take<BendTool>();
        m_settings->set(&ViewValues::stretchingWeight, stretching);
        // A drag toward the branch's base bends it sideways or compresses it.
        stroke(node(kTip), node(kTip) + 0.3F * (node(kBranch) - node(kTip)), 200);
        return lengthOfBranch();
    };
    const float soft = lengthWith(kLeastBendWeight);
    const float stiff = lengthWith(kMostBendWeight);
    QVERIFY2(soft < 0.95F * stiff, qPrintable(QStringLiteral("%1 %2").arg(soft).arg(stiff)));
}

void ShapingToolsTest::bendIntoTheSeedling_doesNothing()
{
    take<BendTool>();
    const DocumentState before(*m_document);
    stroke(middle(0), middle(0) + Vec3(0.8F, 0.1F, 0.0F), 100);
    QVERIFY(DocumentState(*m_document) == before);
    // A pin whose internode is gone is removed.
    click(middle(kBranch + 3));
    plant();
    m_document->reset(1, smallTree());
    stroke(node(0), node(0) + Vec3(0.5F, 0.0F, 0.0F), 100);
    QCOMPARE(m_document->tree().size(), 1U);
    QCOMPARE(m_document->undoStack().count(), 0);
}

void ShapingToolsTest::widthTap_holdsTheWidthThatIs()
{
    take<WidthTool>();
    const InternodeId id = 5;
    const DocumentState before(*m_document);
    const double is = diameter(id);
    QTest::mouseMove(m_view.get(), at(middle(id)));
    click(middle(id));
    QVERIFY(std::abs(static_cast<double>(m_document->tree().widthConstraint(id)) - is) < 1e-6);
    QCOMPARE(m_document->tree().widthConstraints().size(), 1U);
    QCOMPARE(m_document->undoStack().count(), 1);
    QCOMPARE(indexFault(*m_document), QString());
    m_document->undoStack().undo();
    QVERIFY(DocumentState(*m_document) == before);
    QTest::mouseClick(m_view.get(), Qt::LeftButton, {}, {20, 20});
    QVERIFY(DocumentState(*m_document) == before);
}

void ShapingToolsTest::widthEnds_setTheWidth()
{
    take<WidthTool>();
    const InternodeId id = 8;
    click(middle(id));
    const DocumentState before(*m_document);
    const double was = diameter(id);
    const QPoint end = handleEnd(id);
    dragPixels(end, end + QPoint(15, 0));
    const Camera& camera = m_view->mainCamera();
    const double metres = 15.0 / static_cast<double>(camera.pixelsPerMetre(camera.depth(middle(id))));
    QVERIFY2(std::abs(diameter(id) - was - 2.0 * metres) < 1e-3,
             qPrintable(QStringLiteral("%1 for %2").arg(diameter(id)).arg(was + 2.0 * metres)));
    QCOMPARE(m_document->undoStack().count(), before.undoIndex + 1);
    QCOMPARE(m_document->journal().size(), before.journal.size() + 1);
    QVERIFY(diameter(1) > was);
    m_document->undoStack().undo();
    QVERIFY(DocumentState(*m_document) == before);
}

void ShapingToolsTest::widthMiddle_movesAlongTheBranch()
{
    take<WidthTool>();
    const InternodeId id = 3;
    click(middle(id));
    const float set = m_document->tree().widthConstraint(id);
    const DocumentState before(*m_document);
    dragPixels(at(middle(id)), at(middle(9)));
    QCOMPARE(m_document->tree().widthConstraint(id), 0.0F);
    QCOMPARE(m_document->tree().widthConstraint(9), set);
    QCOMPARE(m_document->tree().widthConstraints().size(), 1U);
    QCOMPARE(m_document->undoStack().count(), before.undoIndex + 1);
    m_document->undoStack().undo();
    QVERIFY(DocumentState(*m_document) == before);
}

void ShapingToolsTest::widthDrawnToTheAxis_isRemoved()
{
    take<WidthTool>();
    click(middle(6));
    const DocumentState before(*m_document);
    dragPixels(handleEnd(6), at(middle(6)));
    QVERIFY(m_document->tree().widthConstraints().empty());
    QCOMPARE(m_document->undoStack().undoText(), QStringLiteral("Remove Width"));
    m_document->undoStack().undo();
    QVERIFY(DocumentState(*m_document) == before);
}

void ShapingToolsTest::widthDelete_removesTheOneUnderThePointer()
{
    take<WidthTool>();
    for (const Qt::Key key : {Qt::Key_Delete, Qt::Key_Backspace}) {
        click(middle(4));
        click(middle(9));
        QCOMPARE(m_document->tree().widthConstraints().size(), 2U);
        QTest::mouseMove(m_view.get(), at(middle(4)));
        QTest::keyClick(m_view.get(), key);
        QCOMPARE(m_document->tree().widthConstraints().size(), 1U);
        QVERIFY(m_document->tree().widthConstraint(9) > 0.0F);
        // Without a handle under the pointer, the key affects the handle that was touched last.
        QTest::mouseMove(m_view.get(), QPoint(20, 20));
        QTest::keyClick(m_view.get(), key);
        QVERIFY(m_document->tree().widthConstraints().empty());
        QTest::keyClick(m_view.get(), key);
        QCOMPARE(m_document->undoStack().undoText(), QStringLiteral("Remove Width"));
    }
}

void ShapingToolsTest::widthHandle_staysChosenUnderNewIds()
{
    take<WidthTool>();
    const InternodeId first = growAnother();
    click(middle(9));
    click(middle(first + 3)); // Chosen
    QTest::mouseMove(m_view.get(), QPoint(20, 20));
    dropTheBranch();
    QCOMPARE(m_document->tree().widthConstraints().size(), 2U);
    QTest::keyClick(m_view.get(), Qt::Key_Delete);
    QCOMPARE(m_document->tree().widthConstraints().size(), 1U);
    QVERIFY(m_document->tree().widthConstraint(9) > 0.0F);
}

void ShapingToolsTest::widthDoubleClick_removes()
{
    take<WidthTool>();
    click(middle(7));
    QTest::qWait(20);
    QTest::mouseClick(m_view.get(), Qt::LeftButton, {}, handleEnd(7));
    QCOMPARE(m_document->tree().widthConstraints().size(), 1U);
    QTest::mouseClick(m_view.get(), Qt::LeftButton, {}, handleEnd(7));
    QVERIFY(m_document->tree().widthConstraints().empty());
    QCOMPARE(m_document->undoStack().count(), 2);
}

QPoint ShapingToolsTest::labelPlace(InternodeId id) const
{
    Overlay overlay;
    m_view->tool().paint(overlay);
    const std::vector<QRectF> boxes =
        labelBoxes(overlay, m_view->mainCamera(), QFontMetricsF(m_view->font()));
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        if (overlay.labels()[i].subject == id)
            return boxes[i].center().toPoint();
    }
    return {};
}

void ShapingToolsTest::widthLabel_isTypedIn()
{
    take<WidthTool>();
    click(middle(7));
    QTRY_VERIFY(m_view->toolContext().labelAt(labelPlace(7)) == InternodeId{7});
    QTest::mouseClick(m_view.get(), Qt::LeftButton, {}, labelPlace(7));
    QTRY_VERIFY(m_view->findChild<LabelEditor*>());
    auto* editor = m_view->findChild<LabelEditor*>();
    QTRY_VERIFY(editor->hasFocus());
    // The text is selected: what is typed replaces it.
    QTest::keyClicks(editor, QStringLiteral("31 cm"));
    QTest::keyClick(editor, Qt::Key_Return);
    QVERIFY(std::abs(m_document->tree().widthConstraint(7) - 0.31F) < 1e-6F);
    QCOMPARE(m_document->undoStack().count(), 2);
    QTRY_VERIFY(!m_view->findChild<LabelEditor*>());
    QVERIFY(m_view->hasFocus());
    // Enter opens it as well; a number alone is centimetres.
    QTest::keyClick(m_view.get(), Qt::Key_Return);
    QTRY_VERIFY(m_view->findChild<LabelEditor*>());
    QTest::keyClicks(m_view->findChild<LabelEditor*>(), QStringLiteral("12"));
    QTest::keyClick(m_view->findChild<LabelEditor*>(), Qt::Key_Return);
    QVERIFY(std::abs(m_document->tree().widthConstraint(7) - 0.12F) < 1e-6F);
    m_document->undoStack().undo();
    QVERIFY(std::abs(m_document->tree().widthConstraint(7) - 0.31F) < 1e-6F);
}

void ShapingToolsTest::widthLabel_refusesNonsenseAndEscapes()
{
    take<WidthTool>();
    click(middle(7));
    QTRY_VERIFY(m_view->toolContext().labelAt(labelPlace(7)) == InternodeId{7});
    const DocumentState before(*m_document);
    QTest::keyClick(m_view.get(), Qt::Key_Return);
    QTRY_VERIFY(m_view->findChild<LabelEditor*>());
    auto* editor = m_view->findChild<LabelEditor*>();
    for (const char* nonsense : {"thick", "-3 cm", "9999 m"}) {
        QTest::keyClicks(editor, QString::fromLatin1(nonsense));
        QTest::keyClick(editor, Qt::Key_Return);
        QVERIFY(editor->isVisible());
    }
    QTest::keyClick(editor, Qt::Key_Escape);
    QTRY_VERIFY(!m_view->findChild<LabelEditor*>());
    QVERIFY(m_view->hasFocus());
    QVERIFY(DocumentState(*m_document) == before);
}

void ShapingToolsTest::widthLabel_doubleClickPutsNoHandleOnATwigBehind()
{
    take<WidthTool>();
    click(middle(7));
    QTRY_VERIFY(m_view->toolContext().labelAt(labelPlace(7)) == InternodeId{7});
    // A branch behind the label.
    const Vec3 behind = m_view->mainCamera().onPlane(labelPlace(7), middle(7) - Vec3(0.0F, 0.0F, 0.3F));
    const std::vector<NewInternode> twig{
        {.parent = 2,
         .slot = 1,
         .rotation = Rotation(
             Eigen::Quaternionf::FromTwoVectors(Vec3::UnitY(), behind - m_document->index().nodePosition(2))),
         .length = 1.2F * (behind - m_document->index().nodePosition(2)).norm()}};
    apply(*m_document, births(m_document->tree(), twig));
    QVERIFY(m_view->toolContext().pick(labelPlace(7), PointerDevice::Mouse));
    QTest::mouseDClick(m_view.get(), Qt::LeftButton, {}, labelPlace(7));
    QCOMPARE(m_document->tree().widthConstraints().size(), 1U);
}

void ShapingToolsTest::widthLabels_doNotCoverEachOther()
{
    take<WidthTool>();
    for (const InternodeId id : {5U, 6U, 7U})
        setWidth(*m_document, id, 0.1 + 0.01 * id);
    Camera camera = m_view->mainCamera();
    camera.setDistance(6.0F * camera.distance());
    m_view->setCamera(camera);
    Overlay overlay;
    m_view->tool().paint(overlay);
    const std::vector<QRectF> boxes = labelBoxes(overlay, camera, QFontMetricsF(m_view->font()));
    QCOMPARE(boxes.size(), std::size_t{3});
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j)
            QVERIFY(!boxes[i].intersects(boxes[j]));
    }
}

void ShapingToolsTest::widthTap_takesTheTrunkAndNotTheTwigInFront()
{
    take<WidthTool>();
    setWidth(*m_document, 7, 0.2);
    // A twig that comes toward the viewer, in front of the trunk.
    const std::vector<NewInternode> twig{{.parent = 9,
                                          .slot = 1,
                                          .rotation = Rotation(Eigen::AngleAxisf(0.7F, Vec3::UnitX())),
                                          .length = 0.6F}};
    apply(*m_document, births(m_document->tree(), twig));
    const InternodeId id = m_document->tree().size() - 1;
    m_view->grabFramebuffer();
    const QPoint place = at(middle(id));
    QTest::mouseMove(m_view.get(), place);
    // Another tool would take the twig.
    const auto nearest = m_view->toolContext().pick(place, PointerDevice::Mouse);
    QVERIFY(nearest);
    QCOMPARE(nearest->id, id);
    QTest::mouseClick(m_view.get(), Qt::LeftButton, {}, place);
    QCOMPARE(m_document->tree().widthConstraint(id), 0.0F);
    QCOMPARE(m_document->tree().widthConstraints().size(), 2U);
}

void ShapingToolsTest::widthEscape_takesTheDragBack()
{
    take<WidthTool>();
    click(middle(7));
    const DocumentState before(*m_document);
    const QPoint end = handleEnd(7);
    QTest::mousePress(m_view.get(), Qt::LeftButton, {}, end);
    for (int i = 1; i <= 5; ++i)
        QTest::mouseMove(m_view.get(), end + QPoint(8 * i, 0));
    QVERIFY(m_view->isGestureActive());
    QVERIFY(diameter(7) > static_cast<double>(before.tree.widthConstraint(7)) + 0.05);
    QTest::keyClick(m_view.get(), Qt::Key_Escape);
    QTest::mouseRelease(m_view.get(), Qt::LeftButton, {}, end + QPoint(40, 0));
    QVERIFY(DocumentState(*m_document) == before);
}

void ShapingToolsTest::widthFingerAndPen_setTheWidth()
{
    take<WidthTool>();
    // One drag from the bark sets a width where there was none.
    const InternodeId first = 10;
    const double was = diameter(first);
    const QPoint from = at(middle(first));
    QTest::touchEvent(m_view.get(), m_touch.get()).press(0, from);
    for (int i = 1; i <= 10; ++i)
        touchMove({{0, from + QPoint(3 * i, 0)}});
    QTest::touchEvent(m_view.get(), m_touch.get()).release(0, from + QPoint(30, 0));
    QCOMPARE(m_document->undoStack().count(), 1);
    QCOMPARE(m_document->tree().widthConstraints().size(), 1U);
    const InternodeId thick = m_document->tree().widthConstraints().front().id;
    QVERIFY(diameter(thick) > was + 0.2);

    const QPointF end = handleEnd(thick);
    const double wide = diameter(thick);
    sendPen(QEvent::TabletPress, end, 0.5);
    for (int i = 1; i <= 10; ++i)
        sendPen(QEvent::TabletMove, end - QPointF(i, 0.0), 0.5);
    sendPen(QEvent::TabletRelease, end - QPointF(10.0, 0.0), 0.0);
    QCOMPARE(m_document->undoStack().count(), 2);
    QVERIFY(diameter(thick) < wide - 0.05);
    QCOMPARE(indexFault(*m_document), QString());
}

void ShapingToolsTest::widthAnywhereOnTheScreen_leavesASoundTree()
{
    take<WidthTool>();
    click(middle(2));
    click(middle(kBranch + 4));
    for (const QPoint& place : {QPoint(0, 0), QPoint(5000, -4000), QPoint(-100000, 3), QPoint(320, 240)}) {
        for (const InternodeId id : {InternodeId{2}, kBranch + 4}) {
            const DocumentState before(*m_document);
            dragPixels(handleEnd(id), place);
            const Widths widths(m_document->tree(), m_document->index());
            for (InternodeId each = 0; each < m_document->tree().size(); ++each) {
                const float radius = widths.radius(m_document->index(), each);
                QVERIFY(std::isfinite(radius) && radius > 0.0F && radius <= kGreatestDiameter);
            }
            m_view->grabFramebuffer();
            while (m_document->undoStack().index() > before.undoIndex)
                m_document->undoStack().undo();
            QVERIFY(DocumentState(*m_document) == before);
        }
    }
}

void ShapingToolsTest::labels_saySoInCentimetres()
{
    const WidthTool* tool = take<WidthTool>();
    const auto labels = [&] {
        Overlay overlay;
        tool->paint(overlay);
        QStringList texts;
        for (const Overlay::Label& label : overlay.labels())
            texts << label.text;
        return texts;
    };
    QVERIFY(labels().isEmpty());
    QTest::mouseMove(m_view.get(), at(middle(3)));
    QTRY_COMPARE(labels(), QStringList{lengthText(diameter(3))});
    setWidth(*m_document, 3, 0.123);
    QTest::mouseMove(m_view.get(), QPoint(20, 20));
    QTRY_COMPARE(labels(), QStringList{QStringLiteral("12 cm")});
    setWidth(*m_document, 3, 0.0412);
    QCOMPARE(labels(), QStringList{QStringLiteral("4.1 cm")});
    setWidth(*m_document, 3, 0.0034);
    QCOMPARE(labels(), QStringList{QStringLiteral("0.34 cm")});
    // The text must be visible.
    const QImage with = m_view->grabFramebuffer();
    m_view->setTool(std::make_unique<BendTool>(m_view->toolContext()));
    QVERIFY(with != m_view->grabFramebuffer());
}

static const TestClass<ShapingToolsTest> shapingToolsTest;

#include "ShapingToolsTest.moc"
