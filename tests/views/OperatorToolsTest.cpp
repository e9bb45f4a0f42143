// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/Documents.h"
#include "tests/support/TestClasses.h"
#include "tests/support/TreeBuilder.h"
#include "tests/support/ViewportFixture.h"
#include "views/tools/AddBudsTool.h"
#include "views/tools/ProfileTool.h"
#include "views/tools/TwistTool.h"

using namespace espalier;
using namespace espalier::test;

/// Twisting and new buds by mouse, by finger and by pen.
class OperatorToolsTest : public ViewportFixture {
    Q_OBJECT

private Q_SLOTS:
    void twistAround_turnsTheBarkAfterThePointer();
    void twistAlong_turnsTheBranchFromThePressedNode();
    void twistShift_reachesTheBranchesToo();
    void twistChoice_isTurnedRoundByShift();
    void twistAgain_goesOnFromWhatIsThere();
    void twistTap_changesNothing();
    void twistDoubleClick_takesTheTwistAway();
    void twistDelete_takesAwayWhatIsUnderThePointer();
    void twistEscape_takesTheDragBack();
    void twistFingerAndPen_twist();
    void twistOverlay_windsAroundTheBranch();
    void twistBesideTheTree_doesNothing();
    void budsTap_addsBudsAroundTheBranch();
    void budsCount_isThatOfThePopOut();
    void budsHover_showsRingsWhereTheBudsWillBe();
    void budsDrag_movesTheRingsUntilTheRelease();
    void budsEscape_addsNone();
    void budsInterruption_addsNone();
    void budsFingerAndPen_addBuds();
    void budsBesideTheTree_addNone();
    void twigBeforeTheTrunk_doesNotHideIt();
    void profileTap_takesTheTrunkBehindATwig();

private:
    static constexpr InternodeId kTop = 12;    ///< Tip of the trunk
    static constexpr InternodeId kBranch = 13; ///< First of a branch of seven

    template <class T>
    T* take();
    Vec3 middle(InternodeId id) const
    {
        return 0.5F * (m_document->index().nodePosition(id) +
                       m_document->index().basePosition(m_document->tree(), id));
    }
    /// Adds a thin twig that the camera sees before the trunk, and branches that make the trunk thick;
    /// returns the first internode of the twig.
    InternodeId plantTwig();
    void dragBy(InternodeId id, const QPoint& way, Qt::KeyboardModifiers modifiers = {});
    void click(const QPoint& place) { QTest::mouseClick(m_view.get(), Qt::LeftButton, {}, place); }
    /// The twist at a node, degrees.
    double twist(InternodeId id) const
    {
        const float* turn = m_document->tree().content().sparse.twist.find(id);
        return turn ? degrees(static_cast<double>(*turn)) : 0.0;
    }
    std::size_t twistedCount() const { return m_document->tree().content().sparse.twist.cells().size(); }
};

/// Gives the tool into the hand before a trunk of thirteen internodes, with a branch of seven.
template <class T>
T* OperatorToolsTest::take()
{
    TreeParameters parameters = smallTree();
    parameters.leaves.visible = false;
    parameters.widths.baseDiameter = 0.16;
    m_document->reset(7, parameters);
    std::vector<NewInternode> internodes;
    for (InternodeId i = 0; i < kTop; ++i)
        internodes.push_back({.parent = i, .length = 0.2F});
    internodes.push_back(
        {.parent = 4, .slot = 0, .rotation = branching(radians(65), 0, 1, 0.0), .length = 0.2F});
    for (InternodeId i = kBranch; i < kBranch + 6; ++i)
        internodes.push_back({.parent = i, .length = 0.2F});
    apply(*m_document, births(m_document->tree(), internodes));
    m_document->undoStack().clear();
    m_view->setCamera(Camera());
    m_view->grabFramebuffer(); // determines the radius of the bark
    auto tool = std::make_unique<T>(m_view->toolContext());
    T* raw = tool.get();
    m_view->setTool(std::move(tool));
    return raw;
}

InternodeId OperatorToolsTest::plantTwig()
{
    std::vector<NewInternode> internodes;
    const InternodeId first = m_document->tree().size();
    internodes.push_back({.parent = 1, .slot = 1, .rotation = branching(radians(20), 1, 4), .length = 0.2F});
    for (InternodeId i = first; i < first + 8; ++i)
        internodes.push_back({.parent = i, .rotation = continuing(0.0, 0.0, 0.0), .length = 0.2F});
    for (const InternodeId parent : {8U, 9U, 10U, 11U}) {
        for (const int slot : {0, 2})
            internodes.push_back(
                {.parent = parent, .slot = slot, .rotation = branching(1.2, slot, 4), .length = 0.2F});
    }
    apply(*m_document, births(m_document->tree(), internodes));
    m_document->undoStack().clear();
    m_view->grabFramebuffer(); // determines the radius of the bark
    return first;
}

void OperatorToolsTest::dragBy(InternodeId id, const QPoint& way, Qt::KeyboardModifiers modifiers)
{
    const QPoint from = at(middle(id));
    QTest::mousePress(m_view.get(), Qt::LeftButton, modifiers, from);
    for (int i = 1; i <= 10; ++i) {
        const QPointF place = QPointF(from) + QPointF(way) * i / 10.0;
        QMouseEvent event(QEvent::MouseMove, place, m_view->mapToGlobal(place), Qt::NoButton, Qt::LeftButton,
                          modifiers);
        QCoreApplication::sendEvent(m_view.get(), &event);
    }
    QTest::mouseRelease(m_view.get(), Qt::LeftButton, modifiers, from + way);
}

void OperatorToolsTest::twistAround_turnsTheBarkAfterThePointer()
{
    take<TwistTool>();
    const DocumentState before(*m_document);
    dragBy(3, {-50, 0});
    // To the left around an upright trunk: its strands lean to the left.
    QVERIFY2(std::abs(twist(3) - 50.0 * TwistTool::kDegreesPerPixel) < 1.0,
             qPrintable(QString::number(twist(3))));
    QCOMPARE(twist(kTop), twist(3));
    QCOMPARE(twist(2), 0.0);
    QCOMPARE(twist(kBranch), 0.0);
    QCOMPARE(m_document->undoStack().count(), 1);
    QCOMPARE(m_document->journal().size(), before.journal.size() + 1);
    m_document->undoStack().undo();
    QVERIFY(DocumentState(*m_document) == before);
    dragBy(3, {50, 0});
    QVERIFY(twist(3) < -9.0);
}

void OperatorToolsTest::twistAlong_turnsTheBranchFromThePressedNode()
{
    take<TwistTool>();
    dragBy(6, {0, -60});
    QVERIFY(std::abs(twist(6) - 60.0 * TwistTool::kDegreesPerPixel) < 1.0);
    QCOMPARE(twist(5), 0.0);
    QCOMPARE(twist(kTop), twist(6));
    dragBy(2, {0, 60});
    QVERIFY(twist(2) < -10.0);
    QCOMPARE(twist(6), twist(2));
    QCOMPARE(m_document->undoStack().count(), 2);
}

void OperatorToolsTest::twistShift_reachesTheBranchesToo()
{
    take<TwistTool>();
    dragBy(2, {-50, 0}, Qt::ShiftModifier);
    QVERIFY(twist(2) > 5.0);
    QCOMPARE(twist(kBranch + 6), twist(2));
    QCOMPARE(twistedCount(), std::size_t{m_document->index().subtreeSize(2)});
    QCOMPARE(m_document->undoStack().count(), 1);
}

void OperatorToolsTest::twistChoice_isTurnedRoundByShift()
{
    take<TwistTool>();
    m_settings->set(&ViewValues::twistsSubtree, true);
    dragBy(2, {-50, 0}, Qt::ShiftModifier);
    QCOMPARE(twist(kBranch), 0.0);
    dragBy(2, {-30, 0});
    QVERIFY(twist(kBranch) > 5.0);
}

void OperatorToolsTest::twistAgain_goesOnFromWhatIsThere()
{
    take<TwistTool>();
    dragBy(3, {-50, 0});
    const double first = twist(3);
    dragBy(3, {-50, 0});
    QVERIFY(std::abs(twist(3) - 2.0 * first) < 0.5);
}

void OperatorToolsTest::twistTap_changesNothing()
{
    take<TwistTool>();
    const DocumentState before(*m_document);
    click(at(middle(3)));
    QVERIFY(DocumentState(*m_document) == before);
}

void OperatorToolsTest::twistDoubleClick_takesTheTwistAway()
{
    take<TwistTool>();
    dragBy(3, {-50, 0});
    QVERIFY(twistedCount() > 0);
    QTest::qWait(600);
    click(at(middle(3)));
    QTest::mouseDClick(m_view.get(), Qt::LeftButton, {}, at(middle(3)));
    QCOMPARE(twistedCount(), 0U);
    QCOMPARE(m_document->undoStack().undoText(), QStringLiteral("Remove Twist"));
    m_document->undoStack().undo();
    QVERIFY(twist(3) > 5.0);
}

void OperatorToolsTest::twistDelete_takesAwayWhatIsUnderThePointer()
{
    take<TwistTool>();
    for (const Qt::Key key : {Qt::Key_Delete, Qt::Key_Backspace}) {
        dragBy(3, {-50, 0});
        QTest::mouseMove(m_view.get(), at(middle(8)));
        QTest::mouseMove(m_view.get(), at(middle(7)));
        QTest::keyClick(m_view.get(), key);
        QVERIFY(twist(3) != 0.0);
        QCOMPARE(twist(kTop), 0.0); // from the pointer on
        QTest::mouseMove(m_view.get(), at(middle(3)));
        QTest::keyClick(m_view.get(), key);
        QCOMPARE(twistedCount(), 0U);
    }
}

void OperatorToolsTest::twistEscape_takesTheDragBack()
{
    take<TwistTool>();
    const DocumentState before(*m_document);
    press(middle(3));
    drag(middle(3), middle(3) + Vec3(-0.4F, 0.0F, 0.0F), 200);
    QVERIFY(twist(3) > 2.0); // follows the hand
    QTest::keyClick(m_view.get(), Qt::Key_Escape);
    QVERIFY(DocumentState(*m_document) == before);
    release(middle(3));
    QVERIFY(DocumentState(*m_document) == before);
}

void OperatorToolsTest::twistFingerAndPen_twist()
{
    take<TwistTool>();
    const QPoint from = at(middle(5));
    QTest::touchEvent(m_view.get(), m_touch.get()).press(0, from);
    for (int i = 1; i <= 10; ++i) {
        QTest::touchEvent(m_view.get(), m_touch.get()).move(0, from - QPoint(4 * i, 0));
        QTest::qWait(20);
    }
    QTest::touchEvent(m_view.get(), m_touch.get()).release(0, from - QPoint(40, 0));
    QCOMPARE(m_document->undoStack().count(), 1);
    QVERIFY(twist(kTop) > 4.0);

    const QPointF place = at(middle(kBranch + 3));
    sendPen(QEvent::TabletPress, place, 0.5);
    for (int i = 1; i <= 10; ++i)
        sendPen(QEvent::TabletMove, place - QPointF(0.0, 4.0 * i), 0.5);
    sendPen(QEvent::TabletRelease, place - QPointF(0.0, 40.0), 0.0);
    QCOMPARE(m_document->undoStack().count(), 2);
    QVERIFY(std::abs(twist(kBranch + 3)) > 4.0);
}

void OperatorToolsTest::twistOverlay_windsAroundTheBranch()
{
    const TwistTool* tool = take<TwistTool>();
    QTest::mouseMove(m_view.get(), at(middle(4)));
    QTest::mouseMove(m_view.get(), at(middle(3)));
    const auto turned = [&] {
        Overlay overlay;
        tool->paint(overlay);
        if (overlay.lines().empty())
            return 1e9F;
        const Overlay::Line& line = overlay.lines().front();
        // From the first point to the last one around the upright trunk.
        const Vec3& first = overlay.points()[line.first];
        const Vec3& last = overlay.points()[line.first + line.count - 1];
        return (Vec3(last.x(), 0.0F, last.z()).normalized() - Vec3(first.x(), 0.0F, first.z()).normalized())
            .norm();
    };
    QVERIFY(turned() < 1e-3F);
    dragBy(3, {-45, 0});
    QTest::mouseMove(m_view.get(), at(middle(4)));
    QTest::mouseMove(m_view.get(), at(middle(3)));
    QVERIFY(turned() > 0.2F && turned() < 10.0F);
    Overlay overlay;
    tool->paint(overlay);
    QCOMPARE(overlay.labels().size(), 1U);
    QVERIFY(overlay.labels().front().text.contains(QStringLiteral("9.0°")));
}

void OperatorToolsTest::twistBesideTheTree_doesNothing()
{
    take<TwistTool>();
    const DocumentState before(*m_document);
    QTest::mousePress(m_view.get(), Qt::LeftButton, {}, {20, 20});
    QTest::mouseMove(m_view.get(), {90, 60});
    QTest::mouseRelease(m_view.get(), Qt::LeftButton, {}, {90, 60});
    QTest::keyClick(m_view.get(), Qt::Key_Delete);
    QVERIFY(DocumentState(*m_document) == before);
}

void OperatorToolsTest::budsTap_addsBudsAroundTheBranch()
{
    take<AddBudsTool>();
    const DocumentState before(*m_document);
    const Vec3 place = middle(3);
    click(at(place));
    const Tree& tree = m_document->tree();
    QCOMPARE(tree.size(), before.tree.size() + 5);
    QCOMPARE(m_document->undoStack().count(), 1);
    // The middle one is under the pointer, on the near side.
    const Vec3 third = m_document->index().nodePosition(before.tree.size() + 2);
    QVERIFY((m_view->mainCamera().project(third)->toPoint() - at(place)).manhattanLength() < 4);
    QVERIFY(third.z() > 0.0F);
    for (InternodeId id = before.tree.size(); id < tree.size(); ++id)
        QCOMPARE(m_document->index().axis(tree.parent(id)), InternodeId{0});
    QCOMPARE(indexFault(*m_document), QString());
    m_document->undoStack().undo();
    QVERIFY(DocumentState(*m_document) == before);
}

void OperatorToolsTest::budsCount_isThatOfThePopOut()
{
    take<AddBudsTool>();
    const std::uint32_t before = m_document->tree().size();
    m_settings->set(&ViewValues::newBuds, 8.0);
    m_settings->set(&ViewValues::budSpacing, 0.1);
    click(at(middle(6)));
    QCOMPARE(m_document->tree().size(), before + 8);
    const float rise =
        m_document->index().nodePosition(before + 1).y() - m_document->index().nodePosition(before).y();
    QVERIFY(std::abs(rise - 0.1F) < 1e-3F);
}

void OperatorToolsTest::budsHover_showsRingsWhereTheBudsWillBe()
{
    const AddBudsTool* tool = take<AddBudsTool>();
    QTest::mouseMove(m_view.get(), at(middle(4)));
    QTest::mouseMove(m_view.get(), at(middle(5)));
    const std::vector<BarkBud> shown = tool->shownBuds();
    QCOMPARE(shown.size(), 5U);
    Overlay overlay;
    tool->paint(overlay);
    QCOMPARE(overlay.lines().size(), 10U); // a ring and a shoot each
    const std::uint32_t before = m_document->tree().size();
    click(at(middle(5)));
    QCOMPARE(m_document->tree().size(), before + 5);
    for (std::size_t i = 0; i < shown.size(); ++i)
        QVERIFY(
            (m_document->index().nodePosition(before + static_cast<InternodeId>(i)) - shown[i].place).norm() <
            0.01F);
    QTest::mouseMove(m_view.get(), {20, 20});
    QVERIFY(tool->shownBuds().empty());
}

void OperatorToolsTest::budsDrag_movesTheRingsUntilTheRelease()
{
    const AddBudsTool* tool = take<AddBudsTool>();
    const std::uint32_t before = m_document->tree().size();
    press(middle(3));
    drag(middle(3), middle(8), 200);
    QCOMPARE(m_document->tree().size(), before);
    QVERIFY(std::abs(tool->shownBuds()[2].place.y() - middle(8).y()) < 0.05F);
    release(middle(8));
    QCOMPARE(m_document->tree().size(), before + 5);
    QVERIFY(std::abs(m_document->index().nodePosition(before + 2).y() - middle(8).y()) < 0.05F);
    // Where the pointer is over no branch at last, there are no buds.
    press(middle(3));
    drag(middle(3), Vec3(2.0F, 2.0F, 0.0F), 200);
    release(Vec3(2.0F, 2.0F, 0.0F));
    QCOMPARE(m_document->tree().size(), before + 5);
}

void OperatorToolsTest::budsEscape_addsNone()
{
    take<AddBudsTool>();
    const DocumentState before(*m_document);
    press(middle(3));
    QTest::keyClick(m_view.get(), Qt::Key_Escape);
    release(middle(3));
    QVERIFY(DocumentState(*m_document) == before);
}

void OperatorToolsTest::budsInterruption_addsNone()
{
    take<AddBudsTool>();
    const DocumentState before(*m_document);
    press(middle(3));
    m_view->finishGesture();
    release(middle(3));
    QVERIFY(DocumentState(*m_document) == before);
}

void OperatorToolsTest::budsFingerAndPen_addBuds()
{
    take<AddBudsTool>();
    const std::uint32_t before = m_document->tree().size();
    const QPoint place = at(middle(4));
    QTest::touchEvent(m_view.get(), m_touch.get()).press(0, place);
    QTest::qWait(30);
    QTest::touchEvent(m_view.get(), m_touch.get()).release(0, place);
    QCOMPARE(m_document->tree().size(), before + 5);
    const QPointF pen = at(middle(kBranch + 3));
    sendPen(QEvent::TabletPress, pen, 0.5);
    sendPen(QEvent::TabletRelease, pen, 0.0);
    QCOMPARE(m_document->tree().size(), before + 10);
    QCOMPARE(m_document->undoStack().count(), 2);
}

void OperatorToolsTest::budsBesideTheTree_addNone()
{
    take<AddBudsTool>();
    const DocumentState before(*m_document);
    click({20, 20});
    QVERIFY(DocumentState(*m_document) == before);
}

void OperatorToolsTest::twigBeforeTheTrunk_doesNotHideIt()
{
    take<TwistTool>();
    const InternodeId twig = plantTwig();
    const ToolContext& context = m_view->toolContext();
    const QPoint place = at(middle(5));
    // Tools for thin branches take what is in front, those for thick wood what is behind it.
    const auto front = context.pick(place, PointerDevice::Mouse);
    QVERIFY(front && m_document->index().axis(front->id) == twig);
    const auto thick = context.pickThick(place, PointerDevice::Mouse);
    QCOMPARE(thick->id, InternodeId{5});
    // A thin branch with nothing behind it is taken as well.
    const auto alone = context.pickThick(at(middle(kBranch + 3)), PointerDevice::Mouse);
    QCOMPARE(alone->id, kBranch + 3);
    dragBy(5, {-50, 0});
    QVERIFY(std::abs(twist(5)) > 1.0 && twist(4) == 0.0);
    QCOMPARE(twist(twig), 0.0);
    QCOMPARE(twist(twig + 4), 0.0);
    m_view->setTool(std::make_unique<AddBudsTool>(m_view->toolContext()));
    const InternodeId before = m_document->tree().size();
    click(place);
    QCOMPARE(m_document->tree().size(), before + 5);
    for (InternodeId id = before; id < before + 5; ++id)
        QCOMPARE(m_document->index().axis(m_document->tree().parent(id)), InternodeId{0});
}

void OperatorToolsTest::profileTap_takesTheTrunkBehindATwig()
{
    struct Choice : ProfileChoice {
        std::optional<ShownSection> section() const override { return {}; }
        void choose(InternodeId id) override { chosen = id; }
        void chooseNone() override { chosen.reset(); }
        std::optional<InternodeId> chosen;
    } choice;
    take<TwistTool>();
    plantTwig();
    m_view->setTool(std::make_unique<ProfileTool>(m_view->toolContext(), choice));
    const Vec3& node = m_document->index().nodePosition(5);
    // A little above and below the node, and at both sides of the axis within the bark.
    for (const QPoint& beside : {QPoint(0, -4), QPoint(0, 4), QPoint(3, 0), QPoint(-3, 0)}) {
        choice.chosen.reset();
        click(at(node) + beside);
        QVERIFY(choice.chosen.has_value());
        QCOMPARE(*choice.chosen, InternodeId{5});
    }
    // The tool must not outlive what it tells.
    m_view->setTool(std::make_unique<TwistTool>(m_view->toolContext()));
}

static const TestClass<OperatorToolsTest> operatorToolsTest;

#include "OperatorToolsTest.moc"
