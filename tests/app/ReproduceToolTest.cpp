// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/tools/ReproduceTool.h"

#include "panels/Notice.h"
#include "panels/ReproducePopOut.h"
#include "tests/support/Documents.h"
#include "tests/support/TestClasses.h"
#include "tests/support/WindowFixture.h"
#include "views/Viewport.h"

#include <QAbstractButton>
#include <QCoreApplication>
#include <QLabel>
#include <QTabletEvent>
#include <QTest>

using namespace espalier;
using test::differenceFrom;
using test::DocumentState;

/// The user at the real window with the tool that gives the tree a new figure.
class ReproduceToolTest : public test::WindowFixture {
    Q_OBJECT

private Q_SLOTS:
    void trunkAndSilhouette_giveTheTreeItsFigure();
    void silhouetteFirst_isALoopAndWaitsForTheTrunk();
    void finger_drawsBothStrokes();
    void pen_drawsBothStrokes();
    void turnedView_isTheDrawingsPlane();
    void undoAndRedo_restoreTheTreeToTheLastBit();
    void badStrokes_sayWhy_data();
    void badStrokes_sayWhy();
    void badSilhouette_leavesTheTrunk();
    void seedling_saysThatThereIsNoTree();
    void viewFromAbove_isRefused();
    void escape_dropsTheStrokeThenTheFirst();
    void undo_forgetsTheFirstStrokeBeforeItUndoesAStep();
    void anotherToolsKey_takesTheSecondStroke();
    void another_replacesTheVariationAsOneStep();
    void controls_tryTheVariationOut();
    void anotherAfterAnEdit_isAStepOfItsOwn();

private:
    struct Place {
        float right;
        float up;
    };
    const Tree& tree() { return m_window->document().tree(); }
    const TreeIndex& index() { return m_window->document().index(); }
    TreeDocument& document() { return m_window->document(); }
    int steps() { return document().undoStack().count(); }
    const ReproduceTool& tool() { return dynamic_cast<const ReproduceTool&>(viewport().tool()); }
    QString hint()
    {
        return workspace().reproducePopOut().findChild<QLabel*>(QStringLiteral("figureHint"))->text();
    }
    QAbstractButton* another()
    {
        return workspace().reproducePopOut().findChild<QAbstractButton*>(QStringLiteral("otherVariation"));
    }
    /// Makes a tree and takes the tool.
    void takeTool();
    void draw(const std::vector<Place>& places);
    /// The node at the end of the trunk, m.
    Vec3 tip();
    /// The highest node and the farthest to the right, m.
    Box3 bounds();

    const std::vector<Place> m_trunk{{0.0F, 0.0F}, {0.15F, 0.6F}, {0.1F, 1.2F}};
    const std::vector<Place> m_crown{{0.1F, 0.3F},  {0.9F, 0.6F},  {0.9F, 1.1F}, {0.2F, 1.5F},
                                     {-0.6F, 1.2F}, {-0.7F, 0.6F}, {0.08F, 0.3F}};
};

void ReproduceToolTest::takeTool()
{
    makeTree();
    action(ActionId::Reproduce)->trigger();
    QTRY_VERIFY(!m_window->isBusy());
}

void ReproduceToolTest::draw(const std::vector<Place>& places)
{
    const QPoint first = at(places.front().right, places.front().up);
    QTest::mouseMove(handle(), first);
    QTest::mousePress(handle(), Qt::LeftButton, {}, first);
    QPoint last = first;
    for (const Place& place : places) {
        const QPoint next = at(place.right, place.up);
        for (int i = 1; i <= 8; ++i)
            QTest::mouseMove(handle(), last + (next - last) * i / 8);
        last = next;
    }
    QTest::mouseRelease(handle(), Qt::LeftButton, {}, last);
    QCoreApplication::processEvents();
}

Vec3 ReproduceToolTest::tip()
{
    InternodeId id = 0;
    while (index().mainChild(id) != kNoInternode)
        id = index().mainChild(id);
    return index().nodePosition(id);
}

Box3 ReproduceToolTest::bounds()
{
    Box3 box;
    for (InternodeId id = 0; id < tree().size(); ++id)
        box.extend(index().nodePosition(id));
    return box;
}

void ReproduceToolTest::trunkAndSilhouette_giveTheTreeItsFigure()
{
    takeTool();
    const int before = steps();
    const std::uint32_t size = tree().size();
    QVERIFY(hint().contains(QStringLiteral("trunk")));
    draw(m_trunk);
    QCOMPARE(steps(), before);
    QCOMPARE(tool().due(), FigureStroke::Silhouette);
    QVERIFY(hint().contains(QStringLiteral("silhouette")));
    draw(m_crown);
    QCOMPARE(steps(), before + 1);
    QCOMPARE(document().undoStack().undoText(), QStringLiteral("Reshape Tree"));
    QCOMPARE(tree().size(), size);
    QCOMPARE(tool().due(), FigureStroke::Trunk);
    QVERIFY((tip() - Vec3(0.1F, 1.2F, 0.0F)).norm() < 0.03F);
    QVERIFY(bounds().max().y() < 1.53F);
    QVERIFY(bounds().max().y() > 1.3F);
    QVERIFY(!workspace().notice().isVisible());
    // The next two strokes begin anew, from the tree as it stands.
    draw({{0.0F, 0.0F}, {-0.2F, 1.0F}});
    draw(m_crown);
    QCOMPARE(steps(), before + 2);
    QVERIFY((tip() - Vec3(-0.2F, 1.0F, 0.0F)).norm() < 0.03F);
}

void ReproduceToolTest::silhouetteFirst_isALoopAndWaitsForTheTrunk()
{
    takeTool();
    const int before = steps();
    draw(m_crown);
    QCOMPARE(steps(), before);
    QCOMPARE(tool().due(), FigureStroke::Trunk);
    QVERIFY(hint().contains(QStringLiteral("inside the silhouette")));
    // From its tip to its foot.
    draw({{0.1F, 1.2F}, {0.15F, 0.6F}, {0.0F, 0.0F}});
    QCOMPARE(steps(), before + 1);
    QVERIFY((tip() - Vec3(0.1F, 1.2F, 0.0F)).norm() < 0.03F);
}

void ReproduceToolTest::finger_drawsBothStrokes()
{
    takeTool();
    const int before = steps();
    for (const std::vector<Place>& stroke : {m_trunk, m_crown}) {
        QTest::touchEvent(handle(), m_screen).press(0, at(stroke.front().right, stroke.front().up));
        QPoint last = at(stroke.front().right, stroke.front().up);
        for (const Place& place : stroke) {
            const QPoint next = at(place.right, place.up);
            for (int i = 1; i <= 8; ++i)
                QTest::touchEvent(handle(), m_screen).move(0, last + (next - last) * i / 8);
            last = next;
        }
        QTest::touchEvent(handle(), m_screen).release(0, last);
        QTRY_VERIFY(!viewport().isGestureActive());
    }
    QTRY_COMPARE(steps(), before + 1);
    QVERIFY((tip() - Vec3(0.1F, 1.2F, 0.0F)).norm() < 0.05F);
}

void ReproduceToolTest::pen_drawsBothStrokes()
{
    takeTool();
    const int before = steps();
    static QPointingDevice pen(QStringLiteral("pen"), 74, QInputDevice::DeviceType::Stylus,
                               QPointingDevice::PointerType::Pen,
                               QInputDevice::Capability::Position | QInputDevice::Capability::Pressure, 1, 3);
    const auto send = [&](QEvent::Type type, const QPoint& place) {
        const bool isUp = type == QEvent::TabletRelease;
        const QPointF local = viewport().mapFrom(m_window.get(), place);
        QTabletEvent event(type, &pen, local, viewport().mapToGlobal(local), isUp ? 0.0 : 0.6, 0, 0, 0, 0, 0,
                           {}, Qt::LeftButton, isUp ? Qt::NoButton : Qt::LeftButton);
        QCoreApplication::sendEvent(&viewport(), &event);
    };
    for (const std::vector<Place>& stroke : {m_trunk, m_crown}) {
        send(QEvent::TabletPress, at(stroke.front().right, stroke.front().up));
        for (const Place& place : stroke)
            send(QEvent::TabletMove, at(place.right, place.up));
        send(QEvent::TabletRelease, at(stroke.back().right, stroke.back().up));
    }
    QTRY_COMPARE(steps(), before + 1);
    QVERIFY((tip() - Vec3(0.1F, 1.2F, 0.0F)).norm() < 0.05F);
}

void ReproduceToolTest::turnedView_isTheDrawingsPlane()
{
    takeTool();
    Camera camera = viewport().mainCamera();
    camera.setAzimuth(static_cast<float>(radians(75)));
    camera.setElevation(static_cast<float>(radians(12)));
    viewport().setCamera(camera);
    draw(m_trunk);
    // The second stroke lies in the plane of the first, also if the view is turned a little meanwhile.
    camera.setAzimuth(static_cast<float>(radians(55)));
    viewport().setCamera(camera);
    draw(m_crown);
    QCOMPARE(notice(), QString());
    const auto angle = static_cast<float>(radians(75));
    const Vec3 right(std::cos(angle), 0.0F, -std::sin(angle));
    QVERIFY(std::abs(tip().dot(right) - 0.1F) < 0.03F);
    QVERIFY(std::abs(tip().y() - 1.2F) < 0.03F);
    QVERIFY(std::abs(tip().dot(Vec3::UnitY().cross(right))) < 0.01F);
}

void ReproduceToolTest::undoAndRedo_restoreTheTreeToTheLastBit()
{
    takeTool();
    const DocumentState original(document());
    draw(m_trunk);
    draw(m_crown);
    const DocumentState taken(document());
    QVERIFY(!(original == taken));
    action(ActionId::Undo)->trigger();
    QTRY_VERIFY(!m_window->undoRunner().isRunning());
    QCOMPARE(differenceFrom(original, document()), QString());
    action(ActionId::Redo)->trigger();
    QTRY_VERIFY(!m_window->undoRunner().isRunning());
    QCOMPARE(differenceFrom(taken, document()), QString());
}

void ReproduceToolTest::badStrokes_sayWhy_data()
{
    using Strokes = std::vector<std::vector<Place>>;
    QTest::addColumn<Strokes>("strokes");
    QTest::addColumn<QString>("sentence");
    QTest::newRow("a point for the trunk")
        << Strokes{{{0.0F, 0.5F}}} << QStringLiteral("That is a point: draw the trunk as a line.");
    QTest::newRow("a point for the silhouette")
        << Strokes{m_trunk, {{0.0F, 0.5F}}}
        << QStringLiteral("That is a point: draw the silhouette as a line around the crown.");
    QTest::newRow("a trunk below the ground")
        << Strokes{{{0.0F, -0.1F}, {0.1F, -0.4F}}}
        << QStringLiteral("The trunk must be above the ground: draw it from its foot to its tip.");
    QTest::newRow("a trunk that dips below its foot")
        << Strokes{{{0.0F, 0.2F}, {0.3F, -0.3F}, {0.5F, 1.0F}}}
        << QStringLiteral("The trunk must be above the ground: draw it from its foot to its tip.");
    QTest::newRow("a silhouette beside the trunk")
        << Strokes{m_trunk, {{0.5F, 0.5F}, {1.0F, 0.5F}, {1.0F, 1.0F}, {0.6F, 1.0F}}}
        << QStringLiteral("The silhouette must enclose the tip of the trunk.");
    QTest::newRow("a line for the silhouette")
        << Strokes{m_trunk, {{0.3F, 0.1F}, {0.3F, 1.4F}}}
        << QStringLiteral("The silhouette must enclose the tip of the trunk.");
    QTest::newRow("a trunk beside the silhouette")
        << Strokes{m_crown, {{-0.9F, 0.0F}, {-0.9F, 1.0F}}}
        << QStringLiteral("The tip of the trunk must be inside the silhouette.");
    QTest::newRow("two loops") << Strokes{m_crown, m_crown}
                               << QStringLiteral("The trunk must be an open line.");
}

void ReproduceToolTest::badStrokes_sayWhy()
{
    QFETCH(const std::vector<std::vector<Place>>, strokes);
    QFETCH(const QString, sentence);
    takeTool();
    const DocumentState before(document());
    for (const std::vector<Place>& stroke : strokes)
        draw(stroke);
    QCOMPARE(notice(), sentence);
    QCOMPARE(differenceFrom(before, document()), QString());
}

void ReproduceToolTest::badSilhouette_leavesTheTrunk()
{
    takeTool();
    const int before = steps();
    draw(m_trunk);
    draw({{0.5F, 0.5F}, {1.0F, 0.5F}, {1.0F, 1.0F}, {0.6F, 1.0F}});
    QCOMPARE(tool().due(), FigureStroke::Silhouette);
    draw(m_crown);
    QCOMPARE(steps(), before + 1);
}

void ReproduceToolTest::seedling_saysThatThereIsNoTree()
{
    action(ActionId::Reproduce)->trigger();
    QVERIFY(!another()->isEnabled());
    draw(m_trunk);
    QCOMPARE(notice(), QStringLiteral("There is no tree yet to give another shape: make one first."));
    QCOMPARE(steps(), 0);
}

void ReproduceToolTest::viewFromAbove_isRefused()
{
    takeTool();
    Camera camera = viewport().mainCamera();
    camera.setElevation(static_cast<float>(radians(80)));
    viewport().setCamera(camera);
    const int before = steps();
    const QPoint from = viewport().mapTo(m_window.get(), viewport().rect().center());
    QTest::mousePress(handle(), Qt::LeftButton, {}, from);
    QTest::mouseMove(handle(), from - QPoint(0, 100));
    QTest::mouseRelease(handle(), Qt::LeftButton, {}, from - QPoint(0, 100));
    QCOMPARE(notice(), QStringLiteral("Look at the tree from the side, not from above or below, to draw its "
                                      "shape."));
    QCOMPARE(steps(), before);
}

void ReproduceToolTest::escape_dropsTheStrokeThenTheFirst()
{
    takeTool();
    const int before = steps();
    draw(m_trunk);
    const QPoint from = at(0.5F, 0.5F);
    QTest::mousePress(handle(), Qt::LeftButton, {}, from);
    QTest::mouseMove(handle(), from + QPoint(50, 50));
    QTest::keyClick(handle(), Qt::Key_Escape);
    QTest::mouseRelease(handle(), Qt::LeftButton, {}, from + QPoint(50, 50));
    QCOMPARE(tool().due(), FigureStroke::Silhouette);
    QTest::keyClick(handle(), Qt::Key_Escape);
    QCOMPARE(tool().due(), FigureStroke::Trunk);
    QVERIFY(hint().startsWith(QStringLiteral("Draw the new trunk")));
    QCOMPARE(steps(), before);
    draw(m_trunk);
    draw(m_crown);
    QCOMPARE(steps(), before + 1);
}

void ReproduceToolTest::undo_forgetsTheFirstStrokeBeforeItUndoesAStep()
{
    takeTool();
    const int before = document().undoStack().index();
    draw(m_trunk);
    action(ActionId::Undo)->trigger();
    QCOMPARE(document().undoStack().index(), before);
    QCOMPARE(tool().due(), FigureStroke::Trunk);
    action(ActionId::Undo)->trigger();
    QTRY_COMPARE(document().undoStack().index(), before - 1);
    // Also where there is no step that could be undone.
    QTRY_VERIFY(!m_window->undoRunner().isRunning());
    document().undoStack().clear();
    draw(m_trunk);
    QVERIFY(action(ActionId::Undo)->isEnabled());
    action(ActionId::Undo)->trigger();
    QCOMPARE(tool().due(), FigureStroke::Trunk);
    QVERIFY(!action(ActionId::Undo)->isEnabled());
}

void ReproduceToolTest::anotherToolsKey_takesTheSecondStroke()
{
    takeTool();
    const int before = steps();
    draw(m_trunk);
    QPoint last = at(m_crown.front().right, m_crown.front().up);
    QTest::mousePress(handle(), Qt::LeftButton, {}, last);
    for (const Place& place : m_crown)
        QTest::mouseMove(handle(), at(place.right, place.up));
    QTest::keyClick(handle(), Qt::Key_P);
    QCOMPARE(steps(), before + 1);
    QTest::mouseRelease(handle(), Qt::LeftButton, {}, last);
    QCOMPARE(steps(), before + 1);
}

void ReproduceToolTest::another_replacesTheVariationAsOneStep()
{
    takeTool();
    const DocumentState original(document());
    const int before = steps();
    QTest::mouseClick(another(), Qt::LeftButton);
    QCOMPARE(steps(), before + 1);
    QCOMPARE(document().undoStack().undoText(), QStringLiteral("Vary Tree"));
    const Vec3 first = tip();
    QTest::mouseClick(another(), Qt::LeftButton);
    QCOMPARE(steps(), before + 1);
    QVERIFY((tip() - first).norm() > 1e-3F);
    // The first number gives the first variation.
    m_window->viewSettings().set(&ViewValues::variationNumber, 1.0);
    QCOMPARE(steps(), before + 1);
    QVERIFY((tip() - first).norm() == 0.0F);
    action(ActionId::Undo)->trigger();
    QTRY_VERIFY(!m_window->undoRunner().isRunning());
    QCOMPARE(differenceFrom(original, document()), QString());
}

void ReproduceToolTest::controls_tryTheVariationOut()
{
    takeTool();
    const int before = steps();
    m_window->viewSettings().set(&ViewValues::variation, 0.5);
    QCOMPARE(steps(), before);
    const Vec3 original = tip();
    QTest::mouseClick(another(), Qt::LeftButton);
    const float strong = (tip() - original).norm();
    m_window->viewSettings().set(&ViewValues::variation, 0.05);
    QCOMPARE(steps(), before + 1);
    QVERIFY((tip() - original).norm() < 0.5F * strong);
}

void ReproduceToolTest::anotherAfterAnEdit_isAStepOfItsOwn()
{
    takeTool();
    QTest::mouseClick(another(), Qt::LeftButton);
    draw(m_trunk);
    draw(m_crown);
    const int before = steps();
    const double number = m_window->viewSettings().values().variationNumber;
    QTest::mouseClick(another(), Qt::LeftButton);
    QCOMPARE(steps(), before + 1);
    // The same deviations would not make another tree, only more of them.
    QCOMPARE(m_window->viewSettings().values().variationNumber, number + 1.0);
}

static const test::TestClass<ReproduceToolTest> reproduceToolTest;

#include "ReproduceToolTest.moc"
