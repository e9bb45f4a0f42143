// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/SetParameters.h"
#include "model/strands/ProfileShapes.h"
#include "panels/ProfilePanel.h"
#include "tests/support/TestClasses.h"
#include "tests/support/WindowFixture.h"
#include "views/Viewport.h"

#include <QAbstractButton>
#include <QCoreApplication>
#include <QInputDevice>
#include <QLabel>
#include <QPointingDevice>
#include <QTabletEvent>
#include <QTest>

using namespace espalier;

/// The user at the real window with the profile tool and its panel.
class ProfilesTest : public test::WindowFixture {
    Q_OBJECT

public:
    ProfilesTest() : WindowFixture({1280, 900}) {}

private Q_SLOTS:
    void tap_choosesTheNodeAndShowsItsStrands();
    void mouse_sketchesAnOutline();
    void finger_sketchesAnOutline();
    void pen_sketchesAndErases();
    void lineThatCrossesItself_staysRedUntilTheNextStroke();
    void loopWithinAnother_isACavity();
    void attractor_isDragged();
    void point_isMoved();
    void shapesClearAndUndo_changeTheProfile();
    void sketchOnThickWood_reachesAsFarAsItIsThick();
    void copyAndInterpolate_goToTheOtherEnd();
    void escape_dropsTheStroke();
    void escape_dropsAPenStrokeWhateverHasTheFocus();
    void escape_endsTheWaitForTheOtherEndFirst();
    void shapes_tellTheirNames();
    void prunedBranch_isNotShownAnyMore();

private:
    ProfilePanel& panel() { return workspace().profilePanel(); }
    ProfileCanvas& canvas() { return panel().canvas(); }
    const Tree& tree() { return m_window->document().tree(); }
    const StrandProfile* profile() { return tree().profileOf(*m_window->profiles().chosen()); }
    QAbstractButton* button(const char* name)
    {
        return panel().findChild<QAbstractButton*>(QString::fromLatin1(name));
    }
    void press(const char* name) { QTest::mouseClick(button(name), Qt::LeftButton); }
    QString message() { return panel().faultText(); }
    /// Draws a tree, takes the tool and taps the trunk.
    void chooseTrunk();
    void tap(float up);
    /// Points of the canvas around its middle.
    std::vector<QPoint> circle(double radius, double turns = 1.0, bool isEight = false);
    void draw(const std::vector<QPoint>& places);
};

void ProfilesTest::tap(float up)
{
    QTest::mouseMove(handle(), at(0.0F, up) - QPoint(30, 0));
    QTest::mouseClick(handle(), Qt::LeftButton, {}, at(0.0F, up));
}

void ProfilesTest::chooseTrunk()
{
    makeTree();
    action(ActionId::Profile)->trigger();
    QVERIFY(panel().isVisible());
    // The picture of the tree comes to rest, and what is under the pointer with it.
    QTRY_VERIFY_WITH_TIMEOUT(!m_window->isBusy() && viewport().isAtRest(), 20'000);
    tap(0.4F);
    QTRY_VERIFY(m_window->profiles().chosen().has_value());
    QTRY_VERIFY(m_window->profiles().isUpToDate());
    QVERIFY(!canvas().isEmpty());
}

std::vector<QPoint> ProfilesTest::circle(double radius, double turns, bool isEight)
{
    std::vector<QPoint> places;
    const QPointF middle = canvas().toWidget(Vec2::Zero());
    for (int i = 0; i <= 60; ++i) {
        const double angle = 2.0 * std::numbers::pi * turns * i / 61.0;
        const QPointF offset(std::cos(angle), isEight ? 0.8 * std::sin(2.0 * angle) : std::sin(angle));
        places.push_back((middle + radius * offset).toPoint());
    }
    return places;
}

void ProfilesTest::draw(const std::vector<QPoint>& places)
{
    const QPoint corner = canvas().mapTo(m_window.get(), QPoint());
    QTest::mousePress(handle(), Qt::LeftButton, {}, corner + places.front());
    for (const QPoint& place : places)
        QTest::mouseMove(handle(), corner + place, 1);
    QTest::mouseRelease(handle(), Qt::LeftButton, {}, corner + places.back());
}

void ProfilesTest::tap_choosesTheNodeAndShowsItsStrands()
{
    chooseTrunk();
    const InternodeId id = *m_window->profiles().chosen();
    QVERIFY(std::abs(m_window->document().index().nodePosition(id).y() - 0.4F) < 0.3F);
    const QString title = panel().findChild<QLabel*>(QStringLiteral("profileTitle"))->text();
    QVERIFY2(title.contains(QStringLiteral("strands")), qPrintable(title));
    QVERIFY(m_window->profiles().section().has_value());
    // A tap beside the tree chooses none.
    QTest::mouseClick(handle(), Qt::LeftButton, {}, at(1.6F, 0.4F));
    QVERIFY(!m_window->profiles().chosen());
    QVERIFY(canvas().isEmpty());
}

void ProfilesTest::mouse_sketchesAnOutline()
{
    chooseTrunk();
    const int steps = m_window->document().undoStack().count();
    draw(circle(70.0, 0.9)); // Open ends are joined
    QVERIFY(profile() != nullptr);
    QCOMPARE(profile()->boundaries.size(), 1U);
    QVERIFY(profile()->boundaries.front().size() < 64);
    QCOMPARE(m_window->document().undoStack().count(), steps + 1);
    QCOMPARE(message(), QString());
    QTRY_VERIFY(m_window->profiles().isUpToDate());
    QCOMPARE(m_window->profiles().section()->outline.size(), 1U);
}

void ProfilesTest::finger_sketchesAnOutline()
{
    chooseTrunk();
    const QPoint corner = canvas().mapTo(m_window.get(), QPoint());
    const std::vector<QPoint> places = circle(60.0);
    QTest::touchEvent(handle(), m_screen).press(0, corner + places.front());
    for (const QPoint& place : places)
        QTest::touchEvent(handle(), m_screen).move(0, corner + place);
    QTest::touchEvent(handle(), m_screen).release(0, corner + places.back());
    QVERIFY(profile() != nullptr);
    QCOMPARE(profile()->boundaries.size(), 1U);
}

void ProfilesTest::pen_sketchesAndErases()
{
    chooseTrunk();
    const auto pen = [&](QEvent::Type type, const QPoint& place, QPointingDevice::PointerType kind) {
        static QPointingDevice stylus(
            QStringLiteral("pen"), 71, QInputDevice::DeviceType::Stylus, QPointingDevice::PointerType::Pen,
            QInputDevice::Capability::Position | QInputDevice::Capability::Pressure, 1, 3);
        static QPointingDevice eraser(QStringLiteral("eraser"), 72, QInputDevice::DeviceType::Stylus,
                                      QPointingDevice::PointerType::Eraser,
                                      QInputDevice::Capability::Position | QInputDevice::Capability::Pressure,
                                      1, 3);
        const bool isUp = type == QEvent::TabletRelease;
        QTabletEvent event(type, kind == QPointingDevice::PointerType::Pen ? &stylus : &eraser,
                           QPointF(place), canvas().mapToGlobal(QPointF(place)), isUp ? 0.0 : 0.6, 0, 0, 0, 0,
                           0, {}, Qt::LeftButton, isUp ? Qt::NoButton : Qt::LeftButton);
        QCoreApplication::sendEvent(&canvas(), &event);
    };
    const std::vector<QPoint> places = circle(60.0);
    pen(QEvent::TabletPress, places.front(), QPointingDevice::PointerType::Pen);
    for (const QPoint& place : places)
        pen(QEvent::TabletMove, place, QPointingDevice::PointerType::Pen);
    pen(QEvent::TabletRelease, places.back(), QPointingDevice::PointerType::Pen);
    QVERIFY(profile() != nullptr);
    const QPoint onLine = canvas().toWidget(profile()->boundaries.front().front()).toPoint();
    pen(QEvent::TabletPress, onLine, QPointingDevice::PointerType::Eraser);
    pen(QEvent::TabletRelease, onLine, QPointingDevice::PointerType::Eraser);
    QVERIFY(profile() == nullptr);
}

void ProfilesTest::lineThatCrossesItself_staysRedUntilTheNextStroke()
{
    chooseTrunk();
    const int steps = m_window->document().undoStack().count();
    draw(circle(70.0, 1.0, true));
    QVERIFY(profile() == nullptr);
    QVERIFY2(message().contains(QStringLiteral("its outline crosses itself")), qPrintable(message()));
    QVERIFY(!canvas().faultyLine().empty());
    QCOMPARE(m_window->document().undoStack().count(), steps);
    draw(circle(60.0));
    QVERIFY(canvas().faultyLine().empty());
    QCOMPARE(message(), QString());
    QVERIFY(profile() != nullptr);
}

void ProfilesTest::loopWithinAnother_isACavity()
{
    chooseTrunk();
    draw(circle(90.0));
    draw(circle(40.0));
    QVERIFY(profile() != nullptr);
    QCOMPARE(profile()->boundaries.size(), 2U);
    QVERIFY(!isInside(*profile(), Vec2::Zero()));
    press("profileErase");
    const QPoint onInner = canvas().toWidget(profile()->boundaries[1].front()).toPoint();
    draw({onInner});
    QCOMPARE(profile()->boundaries.size(), 1U);
    press("profileOutline");
}

void ProfilesTest::attractor_isDragged()
{
    chooseTrunk();
    press("profileAttractor");
    const QPoint middle = canvas().toWidget(Vec2::Zero()).toPoint();
    draw({middle, middle + QPoint(20, 5), middle + QPoint(40, 0)});
    QVERIFY(profile() == nullptr);
    QVERIFY(!message().isEmpty());
    press("shapeRound");
    draw({middle, middle + QPoint(20, 5), middle + QPoint(40, 0)});
    QCOMPARE(profile()->attractors.size(), 1U);
    press("profileOutline");
}

void ProfilesTest::point_isMoved()
{
    chooseTrunk();
    press("shapeRound");
    press("profilePoints");
    const Vec2 before = profile()->boundaries.front().front();
    const QPoint place = canvas().toWidget(before).toPoint();
    draw({place, place + QPoint(10, 3), place + QPoint(16, 5)});
    const Vec2 after = profile()->boundaries.front().front();
    QVERIFY(after.x() > before.x());
    QCOMPARE(profile()->boundaries.front().size(), profileOf(ProfileShape::Round).boundaries.front().size());
    // Over the other side: the outline would cross itself.
    const QPoint moved = canvas().toWidget(after).toPoint();
    draw({moved, canvas().toWidget(Vec2(-1.6F, 0.3F)).toPoint()});
    QVERIFY(profile()->boundaries.front().front() == after);
    QVERIFY(!message().isEmpty());
    press("profileOutline");
}

void ProfilesTest::shapesClearAndUndo_changeTheProfile()
{
    chooseTrunk();
    for (const char* name :
         {"shapeElongated", "shapeC", "shapeRing", "shapeTwo", "shapeThree", "shapeFluted"}) {
        press(name);
        QVERIFY(profile() != nullptr);
        QCOMPARE(profileFault(*profile()), QString());
    }
    QVERIFY(*profile() == profileOf(ProfileShape::Fluted));
    action(ActionId::Undo)->trigger();
    QVERIFY(*profile() == profileOf(ProfileShape::ThreeParts));
    QTRY_VERIFY(m_window->profiles().isUpToDate());
    QVERIFY(canvas().profile() == profileOf(ProfileShape::ThreeParts));
    press("profileClear");
    QVERIFY(profile() == nullptr);
    QVERIFY(!button("profileClear")->isEnabled());
}

void ProfilesTest::sketchOnThickWood_reachesAsFarAsItIsThick()
{
    chooseTrunk();
    TreeParameters parameters = tree().parameters();
    parameters.widths.baseDiameter = 0.6F;
    QVERIFY(setParameters(m_window->document(), parameters));
    const auto isAtRest = [&] { return !m_window->isBusy() && m_window->profiles().isUpToDate(); };
    while (!tree().isRoot(*m_window->profiles().chosen()))
        press("profileDown");
    QTRY_VERIFY_WITH_TIMEOUT(isAtRest(), 20'000);
    const auto count = [&] { return tree().content().sparse.profile.cells().size(); };
    const int steps = m_window->document().undoStack().count();
    press("shapeTwo");
    const std::size_t shaped = count();
    QVERIFY2(shaped > 1, qPrintable(QString::number(shaped)));
    QCOMPARE(m_window->document().undoStack().count(), steps + 1);
    QTRY_VERIFY_WITH_TIMEOUT(isAtRest(), 20'000);
    // The next sketch shapes the same nodes, and Clear clears them all.
    press("shapeRing");
    QCOMPARE(count(), shaped);
    QTRY_VERIFY_WITH_TIMEOUT(isAtRest(), 20'000);
    press("profileClear");
    QCOMPARE(count(), 0U);
}

void ProfilesTest::copyAndInterpolate_goToTheOtherEnd()
{
    chooseTrunk();
    const TreeIndex& index = m_window->document().index();
    const auto reach = [&](InternodeId id) {
        std::size_t count = 0;
        for (; count < 3 && index.mainChild(id) != kNoInternode; ++count)
            id = index.mainChild(id);
        return count;
    };
    const InternodeId first = *m_window->profiles().chosen();
    QVERIFY(!button("profileCopy")->isEnabled());
    press("shapeRing");
    const auto isAtRest = [&] { return !m_window->isBusy() && m_window->profiles().isUpToDate(); };
    QTRY_VERIFY_WITH_TIMEOUT(isAtRest(), 20'000);
    const auto count = [&] { return tree().content().sparse.profile.cells().size(); };
    const std::size_t shaped = count();
    QVERIFY(shaped >= 1);
    press("profileCopy");
    QCOMPARE(panel().span(), ProfilePanel::Span::Copy);
    InternodeId other = first;
    const std::size_t above = reach(first);
    for (std::size_t step = 0; step < above; ++step)
        other = index.mainChild(other);
    QVERIFY(above > 0);
    const Vec3& place = m_window->document().index().nodePosition(other);
    const QPointF seen = viewport().mainCamera().project(place).value_or(QPointF());
    QTest::mouseClick(handle(), Qt::LeftButton, {}, viewport().mapTo(m_window.get(), seen.toPoint()));
    QVERIFY(m_window->profiles().chosen().has_value());
    QCOMPARE(*m_window->profiles().chosen(), first);
    QVERIFY(count() > shaped || shaped > above);
    action(ActionId::Undo)->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(isAtRest(), 20'000);
    QCOMPARE(count(), shaped);
    // With the buttons alone.
    const auto pressAndWait = [&](const char* name) {
        press(name);
        QTRY_VERIFY_WITH_TIMEOUT(isAtRest(), 20'000);
    };
    for (const char* name : {"profileCopy", "profileUp", "profileUp", "profileCopy"})
        pressAndWait(name);
    QTRY_VERIFY(count() >= std::min<std::size_t>(above, 2) + 1);
    QCOMPARE(*m_window->profiles().chosen(), first);
    action(ActionId::Undo)->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(isAtRest(), 20'000);
    for (int i = 0; i < 3; ++i)
        pressAndWait("profileUp");
    pressAndWait("shapeElongated");
    pressAndWait("profileBlend");
    for (int i = 0; i < 3; ++i)
        pressAndWait("profileDown");
    pressAndWait("profileBlend");
    QTRY_VERIFY(count() >= above + 1);
    QCOMPARE(m_window->document().undoStack().undoText(), QStringLiteral("Blend Profiles"));
}

void ProfilesTest::escape_dropsTheStroke()
{
    chooseTrunk();
    const std::vector<QPoint> places = circle(60.0);
    const QPoint corner = canvas().mapTo(m_window.get(), QPoint());
    QTest::mousePress(handle(), Qt::LeftButton, {}, corner + places.front());
    for (const QPoint& place : places)
        QTest::mouseMove(handle(), corner + place, 1);
    QTest::keyClick(handle(), Qt::Key_Escape);
    QTest::mouseRelease(handle(), Qt::LeftButton, {}, corner + places.back());
    // The node stays chosen: the stroke alone was cancelled.
    QVERIFY(m_window->profiles().chosen());
    QVERIFY(profile() == nullptr);
    QTest::keyClick(handle(), Qt::Key_Escape);
    QVERIFY(!m_window->profiles().chosen());
}

void ProfilesTest::escape_dropsAPenStrokeWhateverHasTheFocus()
{
    chooseTrunk();
    for (const bool isElsewhere : {false, true}) {
        viewport().setFocus();
        const std::vector<QPoint> places = circle(60.0);
        const QPoint corner = canvas().mapTo(m_window.get(), QPoint());
        QTest::touchEvent(handle(), m_screen).press(0, corner + places.front());
        for (const QPoint& place : places)
            QTest::touchEvent(handle(), m_screen).move(0, corner + place);
        if (isElsewhere)
            viewport().setFocus();
        QTest::keyClick(handle(), Qt::Key_Escape);
        QTest::touchEvent(handle(), m_screen).release(0, corner + places.back());
        QVERIFY(m_window->profiles().chosen());
        QVERIFY(profile() == nullptr);
    }
}

void ProfilesTest::escape_endsTheWaitForTheOtherEndFirst()
{
    chooseTrunk();
    press("shapeRing");
    QTRY_VERIFY(m_window->profiles().isUpToDate());
    press("profileCopy");
    QCOMPARE(panel().span(), ProfilePanel::Span::Copy);
    QTest::keyClick(handle(), Qt::Key_Escape);
    QCOMPARE(panel().span(), ProfilePanel::Span::None);
    QVERIFY(!button("profileCopy")->isChecked());
    QVERIFY(m_window->profiles().chosen() && profile() != nullptr);
    QTest::keyClick(handle(), Qt::Key_Escape);
    QVERIFY(!m_window->profiles().chosen());
}

void ProfilesTest::shapes_tellTheirNames()
{
    chooseTrunk();
    const auto* words = panel().findChild<QLabel*>(QStringLiteral("profileMessage"));
    const QString advice = words->text();
    for (const char* name :
         {"shapeRound", "shapeElongated", "shapeC", "shapeRing", "shapeTwo", "shapeThree", "shapeFluted"}) {
        const QAbstractButton* shape = button(name);
        QVERIFY(!shape->accessibleName().isEmpty());
        QCOMPARE(shape->toolTip(), shape->accessibleName());
        QTest::mouseMove(handle(), shape->mapTo(m_window.get(), shape->rect().center()));
        QTRY_COMPARE(words->text(), shape->accessibleName());
    }
    QTest::mouseMove(handle(), at(0.0F, 1.0F));
    QTRY_COMPARE(words->text(), advice);
}

void ProfilesTest::prunedBranch_isNotShownAnyMore()
{
    chooseTrunk();
    while (m_window->document().undoStack().canUndo())
        m_window->document().undoStack().undo();
    QVERIFY(!m_window->profiles().chosen() || tree().isAlive(*m_window->profiles().chosen()));
    QVERIFY(canvas().isEmpty() || m_window->profiles().chosen());
}

namespace {
const test::TestClass<ProfilesTest> profilesTest;
}

#include "ProfilesTest.moc"
