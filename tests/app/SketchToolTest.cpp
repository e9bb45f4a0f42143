// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/tools/SketchTool.h"

#include "model/sketch/FlatTree.h"
#include "panels/LeafChoices.h"
#include "panels/Notice.h"
#include "panels/ParameterSlider.h"
#include "panels/SketchPopOut.h"
#include "tests/support/TestClasses.h"
#include "tests/support/ViewportFixture.h"
#include "tests/support/WindowFixture.h"
#include "views/Viewport.h"
#include "views/tools/ToolColours.h"

#include <QAbstractButton>
#include <QCoreApplication>
#include <QInputDevice>
#include <QPointingDevice>
#include <QTabletEvent>
#include <QTest>

using namespace espalier;

/// The user at the real window with the pencil.
class SketchToolTest : public test::WindowFixture {
    Q_OBJECT

private Q_SLOTS:
    void strokes_becomeTrunkAndBranches();
    void finger_drawsABranch();
    void hover_showsWhereAStrokeWouldJoin();
    void escape_dropsTheStroke();
    void twoSides_giveABranchItsWidth();
    void twoSides_mayRunDownward();
    void twoSides_switchedOff_areTwoBranches();
    void stroke_announcesWhatItWillBe();
    void newPage_forgetsTheForm();
    void sliders_goBackOnADoubleClick();
    void mirror_drawsBothSides();
    void strokeAcrossOnce_cuts_twice_erases();
    void eraser_erasesWhatItCrossesTwice();
    void giveDepth_spreadsTheBranches();
    void controls_tryDepthsOutAsOneStep();
    void strokesAfterwards_lieParallelToTheScreen();
    void loop_isALeaf();
    void placedLeaves_bringSuggestions();
    void largeLoop_isACrownThatTheTreeFills();
    void tap_drawsNothing();
    void ink_isInTheNextPicture();
    void secondViewThatMoves_keepsTheStrokeAsDrawn();

private:
    struct Place {
        float right;
        float up;
    };
    const Tree& tree() { return m_window->document().tree(); }
    const TreeIndex& index() { return m_window->document().index(); }
    int steps() { return m_window->document().undoStack().count(); }
    QAbstractButton* button(const char* name)
    {
        return workspace().sketchPopOut().findChild<QAbstractButton*>(QString::fromLatin1(name));
    }
    void press(const char* name)
    {
        QVERIFY(button(name)->isEnabled());
        QTest::mouseClick(button(name), Qt::LeftButton);
    }
    void take() { action(ActionId::Sketch)->trigger(); }
    /// Draws with the mouse from place to place, without lifting the pencil; returns where it is.
    QPoint drawOn(const std::vector<Place>& places, Qt::KeyboardModifiers keys = {});
    void draw(const std::vector<Place>& places, Qt::KeyboardModifiers keys = {});
    /// What the pencil says that the stroke will be.
    QString announced();
    /// A trunk with two branches.
    void drawTree();
    std::uint32_t axes();
};

void SketchToolTest::ink_isInTheNextPicture()
{
    drawTree();
    QTRY_VERIFY_WITH_TIMEOUT(viewport().isAtRest(), 10000);
    const QPoint from = at(0.0F, 0.6F);
    QTest::mousePress(handle(), Qt::LeftButton, {}, from);
    for (int i = 1; i <= 12; ++i) {
        const QPoint place = from + QPoint(12 * i, -6 * i);
        QVERIFY2(test::isInNextPicture(viewport(), viewport().mapFrom(m_window.get(), place), kBrushColour,
                                       [&] { QTest::mouseMove(handle(), place); }),
                 qPrintable(QString::number(i)));
    }
    QTest::mouseRelease(handle(), Qt::LeftButton, {}, from + QPoint(144, -72));
}

void SketchToolTest::secondViewThatMoves_keepsTheStrokeAsDrawn()
{
    take();
    m_window->resize(1400, 900);
    draw({{0.0F, 0.0F}, {0.0F, 2.0F}});
    m_window->viewSettings().set(&ViewValues::secondViewShown, true);
    QTRY_VERIFY(viewport().isAtRest());
    const SecondView& second = viewport().secondView();
    QVERIFY(second.isShown());
    const auto place = [&](const Vec3& point) {
        const QPoint inView = second.camera().project(point)->toPoint() + second.rect().topLeft();
        return viewport().mapTo(m_window.get(), inView);
    };
    const int trunk = steps();
    QTest::mousePress(handle(), Qt::LeftButton, {}, place({0.0F, 1.0F, 0.0F}));
    for (int i = 1; i <= 10; ++i) {
        const auto share = static_cast<float>(i) / 10.0F;
        QTest::mouseMove(handle(), place({0.0F, 1.0F + 0.4F * share, -0.5F * share}));
    }
    QVERIFY(viewport().isGestureActive());
    const QRect before = second.rect();
    QTest::keyClick(handle(), Qt::Key_3, Qt::ControlModifier);
    QTRY_VERIFY(second.rect() != before);
    QTest::mouseRelease(handle(), Qt::LeftButton, {}, place({0.0F, 1.4F, -0.5F}));
    QTRY_COMPARE(steps(), trunk + 1);
    Vec3 tip = Vec3::Zero();
    for (InternodeId id = 0; id < tree().size(); ++id) {
        if (index().nodePosition(id).z() < tip.z())
            tip = index().nodePosition(id);
    }
    QVERIFY2((tip - Vec3(0.0F, 1.4F, -0.5F)).norm() < 0.1F,
             qPrintable(QStringLiteral("%1 %2 %3").arg(tip.x()).arg(tip.y()).arg(tip.z())));
    QTest::keyClick(handle(), Qt::Key_3, Qt::ControlModifier);
    m_window->viewSettings().set(&ViewValues::secondViewShown, false);
}

QPoint SketchToolTest::drawOn(const std::vector<Place>& places, Qt::KeyboardModifiers keys)
{
    const QPoint first = at(places.front().right, places.front().up);
    QTest::mouseMove(handle(), first);
    QTest::mousePress(handle(), Qt::LeftButton, keys, first);
    QPoint last = first;
    for (const Place& place : places) {
        const QPoint next = at(place.right, place.up);
        for (int i = 1; i <= 8; ++i)
            QTest::mouseMove(handle(), last + (next - last) * i / 8);
        last = next;
    }
    return last;
}

void SketchToolTest::draw(const std::vector<Place>& places, Qt::KeyboardModifiers keys)
{
    QTest::mouseRelease(handle(), Qt::LeftButton, keys, drawOn(places, keys));
    QCoreApplication::processEvents();
}

QString SketchToolTest::announced()
{
    Overlay overlay;
    viewport().tool().paint(overlay);
    return overlay.labels().empty() ? QString() : overlay.labels().front().text;
}

void SketchToolTest::drawTree()
{
    take();
    draw({{0.0F, 0.0F}, {0.0F, 2.0F}});
    draw({{0.0F, 1.0F}, {0.5F, 1.3F}, {0.9F, 1.8F}});
    draw({{0.0F, 1.4F}, {-0.6F, 1.6F}, {-0.9F, 2.0F}});
    QCOMPARE(axes(), 3U);
}

std::uint32_t SketchToolTest::axes()
{
    std::uint32_t count = 0;
    for (InternodeId id = 0; id < tree().size(); ++id)
        count += tree().isAlive(id) && index().axis(id) == id ? 1 : 0;
    return count;
}

void SketchToolTest::strokes_becomeTrunkAndBranches()
{
    drawTree();
    QCOMPARE(steps(), 3);
    QVERIFY(isFlat(tree(), index()));
    // The tip is where the stroke ended, within two pixels.
    const InternodeId tip = tree().size() - 1;
    const QPointF seen = viewport().mainCamera().project(index().nodePosition(tip)).value_or(QPointF());
    const QPoint wanted = at(-0.9F, 2.0F);
    QVERIFY((viewport().mapTo(m_window.get(), seen.toPoint()) - wanted).manhattanLength() <= 3);
    action(ActionId::Undo)->trigger();
    QCOMPARE(axes(), 2U);
    action(ActionId::Redo)->trigger();
    QCOMPARE(axes(), 3U);
}

void SketchToolTest::finger_drawsABranch()
{
    drawTree();
    const QPoint from = at(0.0F, 1.7F);
    const QPoint to = at(0.5F, 2.3F);
    QTest::touchEvent(handle(), m_screen).press(0, from);
    for (int i = 1; i <= 10; ++i)
        QTest::touchEvent(handle(), m_screen).move(0, from + (to - from) * i / 10);
    QTest::touchEvent(handle(), m_screen).release(0, to);
    QTRY_COMPARE(axes(), 4U);
}

void SketchToolTest::hover_showsWhereAStrokeWouldJoin()
{
    drawTree();
    QTest::mouseMove(handle(), at(0.3F, 0.5F));
    const auto& tool = dynamic_cast<const SketchTool&>(viewport().tool());
    QTRY_VERIFY(tool.shownPlace().has_value());
    QCOMPARE(index().axis(tool.shownPlace()->internode), 0U);
    const Vec3 place = positionOf(tree(), index(), *tool.shownPlace());
    QVERIFY(std::abs(place.y() - 0.5F) < 0.1F);
}

void SketchToolTest::escape_dropsTheStroke()
{
    take();
    const QPoint from = at(0.0F, 0.0F);
    QTest::mousePress(handle(), Qt::LeftButton, {}, from);
    QTest::mouseMove(handle(), from - QPoint(0, 150));
    QTest::keyClick(handle(), Qt::Key_Escape);
    QTest::mouseRelease(handle(), Qt::LeftButton, {}, from - QPoint(0, 150));
    QCOMPARE(steps(), 0);
    QCOMPARE(tree().size(), 1U);
}

void SketchToolTest::twoSides_giveABranchItsWidth()
{
    take();
    draw({{-0.15F, 0.0F}, {-0.05F, 2.0F}});
    draw({{0.15F, 0.0F}, {0.05F, 2.0F}});
    QCOMPARE(axes(), 1U);
    QVERIFY(std::abs(tree().widthConstraint(0) - 0.3F) < 0.05F);
    QVERIFY(std::abs(tree().rootPosition(0).x()) < 0.02F);
    // The next branch has its form: a tenth of its length at the tip's end.
    draw({{0.0F, 1.2F}, {1.0F, 1.6F}});
    QCOMPARE(axes(), 2U);
    InternodeId first = tree().size() - 1;
    while (tree().continuesAxis(first))
        first = tree().parent(first);
    QVERIFY(tree().widthConstraint(first) > 0.06F);
    QVERIFY(tree().widthConstraint(first) < tree().widthConstraint(0));
}

void SketchToolTest::twoSides_switchedOff_areTwoBranches()
{
    take();
    draw({{0.0F, 0.0F}, {0.0F, 2.0F}});
    auto* row = workspace().sketchPopOut().findChild<QWidget*>(QStringLiteral("view.sketchSides"));
    auto* twoSides = row->findChild<QAbstractButton*>();
    QTest::mouseClick(twoSides, Qt::LeftButton, {}, QPoint(10, twoSides->height() / 2));
    QVERIFY(!m_window->viewSettings().values().sketchSides);
    draw({{0.0F, 1.2F}, {1.0F, 1.6F}});
    draw({{0.0F, 1.3F}, {1.0F, 1.7F}});
    QCOMPARE(axes(), 3U);
}

void SketchToolTest::stroke_announcesWhatItWillBe()
{
    drawTree();
    const auto release = [this](const QPoint& place) {
        QTest::mouseRelease(handle(), Qt::LeftButton, {}, place);
        QCoreApplication::processEvents();
    };
    QPoint last = drawOn({{0.0F, 1.2F}, {1.0F, 1.2F}});
    QVERIFY(announced().isEmpty());
    release(last);
    last = drawOn({{0.0F, 1.3F}, {1.0F, 1.3F}});
    QCOMPARE(announced(), QStringLiteral("Two sides of one branch"));
    release(last);
    QCOMPARE(axes(), 4U);
    last = drawOn({{0.5F, 1.35F}, {0.6F, 1.45F}, {0.5F, 1.5F}, {0.45F, 1.4F}, {0.5F, 1.36F}});
    QCOMPARE(announced(), QStringLiteral("A leaf"));
    release(last);
    QCOMPARE(tree().placedLeaves().size(), 1U);
    last = drawOn({{0.0F, 0.8F}, {1.0F, 1.4F}, {0.0F, 2.2F}, {-1.0F, 1.4F}, {-0.02F, 0.8F}});
    QCOMPARE(announced(), QStringLiteral("A crown"));
    QTest::keyClick(handle(), Qt::Key_Escape);
    release(last);
}

void SketchToolTest::twoSides_mayRunDownward()
{
    take();
    draw({{-0.05F, 2.0F}, {-0.15F, 0.0F}});
    draw({{0.05F, 2.0F}, {0.15F, 0.0F}});
    QCOMPARE(axes(), 1U);
    QVERIFY(std::abs(tree().widthConstraint(0) - 0.3F) < 0.05F);
    QVERIFY(tree().widthConstraint(tree().size() - 1) < 0.15F);
}

void SketchToolTest::newPage_forgetsTheForm()
{
    take();
    draw({{-0.15F, 0.0F}, {-0.05F, 2.0F}});
    draw({{0.15F, 0.0F}, {0.05F, 2.0F}});
    action(ActionId::Undo)->trigger();
    action(ActionId::Undo)->trigger();
    QCOMPARE(tree().widthConstraint(0), 0.0F);
    draw({{0.0F, 0.0F}, {0.0F, 2.0F}});
    QVERIFY(tree().widthConstraint(0) > 0.0F);
    QVERIFY(tree().widthConstraint(0) < 0.12F);
}

void SketchToolTest::sliders_goBackOnADoubleClick()
{
    take();
    const double usual = m_window->viewSettings().values().depthLength;
    auto* row = workspace().sketchPopOut().findChild<QWidget*>(QStringLiteral("view.depthLength"));
    auto* slider = row->findChild<ParameterSlider*>();
    for (const bool isKey : {false, true}) {
        QTest::mouseClick(slider, Qt::LeftButton, {}, {slider->width() - 12, slider->height() / 2});
        QVERIFY(m_window->viewSettings().values().depthLength > usual);
        if (isKey)
            QTest::keyClick(slider, Qt::Key_Delete);
        else
            QTest::mouseDClick(slider, Qt::LeftButton, {}, slider->rect().center());
        QCOMPARE(m_window->viewSettings().values().depthLength, usual);
    }
}

void SketchToolTest::mirror_drawsBothSides()
{
    take();
    draw({{0.0F, 0.0F}, {0.0F, 2.0F}});
    m_window->viewSettings().set(&ViewValues::sketchMirror, true);
    draw({{0.0F, 1.0F}, {0.8F, 1.5F}});
    QCOMPARE(axes(), 3U);
    QCOMPARE(steps(), 2);
    Box3 box;
    for (InternodeId id = 0; id < tree().size(); ++id)
        box.extend(index().nodePosition(id));
    QVERIFY(std::abs(box.min().x() + box.max().x()) < 0.02F);
}

void SketchToolTest::strokeAcrossOnce_cuts_twice_erases()
{
    drawTree();
    draw({{0.4F, 1.6F}, {0.6F, 1.0F}}, Qt::ShiftModifier);
    QCOMPARE(axes(), 3U);
    Box3 box;
    for (InternodeId id = 0; id < tree().size(); ++id) {
        if (tree().isAlive(id))
            box.extend(index().nodePosition(id));
    }
    QVERIFY(box.max().x() < 0.65F);
    QCOMPARE(m_window->document().undoStack().undoText(), QStringLiteral("Prune"));
    draw({{-0.2F, 1.7F}, {-0.3F, 1.2F}, {-0.5F, 1.2F}, {-0.6F, 1.9F}}, Qt::ShiftModifier);
    QCOMPARE(axes(), 2U);
}

void SketchToolTest::eraser_erasesWhatItCrossesTwice()
{
    drawTree();
    static QPointingDevice eraser(
        QStringLiteral("eraser"), 73, QInputDevice::DeviceType::Stylus, QPointingDevice::PointerType::Eraser,
        QInputDevice::Capability::Position | QInputDevice::Capability::Pressure, 1, 3);
    const auto send = [&](QEvent::Type type, const QPoint& place) {
        const bool isUp = type == QEvent::TabletRelease;
        const QPointF local = viewport().mapFrom(m_window.get(), place);
        QTabletEvent event(type, &eraser, local, viewport().mapToGlobal(local), isUp ? 0.0 : 0.6, 0, 0, 0, 0,
                           0, {}, Qt::LeftButton, isUp ? Qt::NoButton : Qt::LeftButton);
        QCoreApplication::sendEvent(&viewport(), &event);
    };
    const std::vector<Place> places{{-0.2F, 1.7F}, {-0.3F, 1.2F}, {-0.5F, 1.2F}, {-0.6F, 1.9F}};
    send(QEvent::TabletPress, at(places.front().right, places.front().up));
    for (const Place& place : places)
        send(QEvent::TabletMove, at(place.right, place.up));
    send(QEvent::TabletRelease, at(places.back().right, places.back().up));
    QTRY_COMPARE(axes(), 2U);
}

void SketchToolTest::giveDepth_spreadsTheBranches()
{
    take();
    QVERIFY(!button("giveDepth")->isEnabled());
    drawTree();
    press("giveDepth");
    QCOMPARE(axes(), 5U);
    QVERIFY(!isFlat(tree(), index()));
    QVERIFY(!button("giveDepth")->isEnabled() && button("otherDepth")->isEnabled());
    action(ActionId::Undo)->trigger();
    QVERIFY(isFlat(tree(), index()));
    QVERIFY(button("giveDepth")->isEnabled() && !button("otherDepth")->isEnabled());
}

void SketchToolTest::controls_tryDepthsOutAsOneStep()
{
    drawTree();
    press("giveDepth");
    const int given = steps();
    const auto depths = [&] {
        std::vector<float> found;
        for (InternodeId id = 0; id < tree().size(); ++id)
            found.push_back(index().nodePosition(id).z());
        return found;
    };
    const std::vector<float> first = depths();
    // Two branches have few depths to choose from.
    for (int i = 0; i < 8 && depths() == first; ++i)
        press("otherDepth");
    QVERIFY(depths() != first);
    QCOMPARE(steps(), given);
    m_window->viewSettings().set(&ViewValues::secondTree, false);
    QCOMPARE(axes(), 3U);
    QCOMPARE(steps(), given);
    // Another edit ends the trial.
    draw({{0.0F, 0.6F}, {0.5F, 0.9F}});
    QVERIFY(!button("otherDepth")->isEnabled());
    m_window->viewSettings().set(&ViewValues::secondTree, true);
    QCOMPARE(axes(), 4U);
}

void SketchToolTest::strokesAfterwards_lieParallelToTheScreen()
{
    drawTree();
    press("giveDepth");
    const std::uint32_t before = tree().size();
    draw({{0.0F, 0.5F}, {0.4F, 0.7F}, {0.7F, 1.0F}});
    QVERIFY(tree().size() > before);
    const Vec3 base = index().basePosition(tree(), before);
    for (InternodeId id = before; id < tree().size(); ++id)
        QVERIFY(std::abs((index().nodePosition(id) - base).dot(viewport().mainCamera().forward())) < 1e-3F);
}

void SketchToolTest::loop_isALeaf()
{
    drawTree();
    // From the tip of the right branch outward, and back.
    draw({{0.9F, 1.8F}, {1.0F, 1.92F}, {1.2F, 1.95F}, {1.1F, 1.8F}, {0.92F, 1.79F}});
    QCOMPARE(axes(), 3U);
    QCOMPARE(tree().placedLeaves().size(), 1U);
    QVERIFY(tree().placedLeaves().length[0] > 0.2F && tree().placedLeaves().length[0] < 0.45F);
    action(ActionId::Undo)->trigger();
    QCOMPARE(tree().placedLeaves().size(), 0U);
}

void SketchToolTest::placedLeaves_bringSuggestions()
{
    drawTree();
    LeafChoices& choices = workspace().leafChoices();
    const auto choice = [&choices](LeafEngine engine) {
        return choices.findChild<QAbstractButton*>(
            QStringLiteral("leafChoice%1").arg(static_cast<int>(engine)));
    };
    QTRY_VERIFY(!choices.isVisible());
    draw({{0.5F, 1.4F}, {0.46F, 1.5F}, {0.5F, 1.6F}, {0.54F, 1.5F}, {0.505F, 1.41F}});
    QCOMPARE(tree().placedLeaves().size(), 1U);
    QTRY_VERIFY(choices.isVisible());
    QVERIFY(choice(LeafEngine::AddToWhorl)->isVisible());
    QVERIFY(!choice(LeafEngine::Alternate)->isVisible());
    const QImage alone = choice(LeafEngine::AddToWhorl)->icon().pixmap(112).toImage();

    draw({{0.7F, 1.6F}, {0.73F, 1.5F}, {0.7F, 1.4F}, {0.67F, 1.5F}, {0.695F, 1.59F}});
    QCOMPARE(tree().placedLeaves().size(), 2U);
    QTRY_VERIFY(choice(LeafEngine::Alternate)->isVisible());
    QVERIFY(choice(LeafEngine::Opposite)->isVisible() && choice(LeafEngine::Decussate)->isVisible());
    QVERIFY(alone != choice(LeafEngine::AddToWhorl)->icon().pixmap(112).toImage());
    QVERIFY(!choices.geometry().intersects(workspace().sketchPopOut().geometry()));

    const int before = steps();
    QTest::mouseClick(choice(LeafEngine::Alternate), Qt::LeftButton);
    QCOMPARE(steps(), before + 1);
    QVERIFY(tree().placedLeaves().size() > 3U);
    action(ActionId::Undo)->trigger();
    QCOMPARE(tree().placedLeaves().size(), 2U);
    QTRY_VERIFY(choice(LeafEngine::Alternate)->isVisible());

    // They cost nothing to one who goes on with something else.
    draw({{0.0F, 0.6F}, {0.5F, 0.9F}});
    QTRY_VERIFY(!choices.isVisible());
    action(ActionId::Undo)->trigger();
    action(ActionId::Undo)->trigger();
    QTRY_VERIFY(choices.isVisible());
    action(ActionId::Brush)->trigger();
    QTRY_VERIFY(!choices.isVisible());
}

void SketchToolTest::largeLoop_isACrownThatTheTreeFills()
{
    drawTree();
    const std::uint32_t drawn = index().livingCount();
    draw({{0.0F, 1.2F}, {0.9F, 1.3F}, {0.8F, 2.3F}, {-0.8F, 2.3F}, {-0.9F, 1.4F}, {-0.05F, 1.2F}});
    QTRY_VERIFY_WITH_TIMEOUT(index().livingCount() > 4 * drawn && !m_window->isBusy(), 60'000);
    QCOMPARE(tree().placedLeaves().size(), 0U);
    QCOMPARE(tree().lassosInForce().size(), std::size_t{2}); // From the front, and from the side
    for (InternodeId id = 0; id < tree().size(); ++id)
        QVERIFY(!tree().isAlive(id) || std::abs(index().nodePosition(id).x()) < 1.2F);
    action(ActionId::Undo)->trigger();
    QTRY_COMPARE(index().livingCount(), drawn);
}

void SketchToolTest::tap_drawsNothing()
{
    drawTree();
    QTest::mouseClick(handle(), Qt::LeftButton, {}, at(0.4F, 1.2F));
    QCOMPARE(steps(), 3);
    QVERIFY(!workspace().notice().isVisible());
}

static const test::TestClass<SketchToolTest> sketchToolTest;

#include "SketchToolTest.moc"
