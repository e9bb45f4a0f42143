// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/LassoPopOut.h"
#include "panels/Notice.h"
#include "tests/support/TestClasses.h"
#include "tests/support/WindowFixture.h"
#include "views/Viewport.h"

#include <QCheckBox>
#include <QCoreApplication>
#include <QEvent>
#include <QInputDevice>
#include <QPoint>
#include <QPointF>
#include <QPointingDevice>
#include <QPushButton>
#include <QSignalSpy>
#include <QTabletEvent>
#include <QTest>

using namespace espalier;

/// The user at the real window with the Lasso tool.
class LassoingTest : public test::WindowFixture {
    Q_OBJECT

private Q_SLOTS:
    void mouse_drawsALassoThatTheTreeFills();
    void finger_drawsALasso();
    void pen_drawsALasso();
    void escapeDuringLassoGrowth_takesAllBack();
    void pressDuringLassoGrowth_keepsWhatGrew();
    void lassoTooSmall_isSaidInOneSentence();
    void saveDuringTheStroke_writesTheFilledEnvelope();
    void lassoPopOut_regrowsRemovesAndHides();

private:
    /// Selects the Lasso tool, on a tree of few internodes.
    void takeLasso();
    /// Points of a circle in the window, 0.9 m wide, above the seedling, closed.
    std::vector<QPoint> lassoPlaces();
    /// Draws the circle with the mouse; the button is up again.
    void drawLasso();
};

void LassoingTest::takeLasso()
{
    action(ActionId::Lasso)->trigger();
    TreeParameters parameters;
    parameters.growth.internodeLength = 0.1;
    m_window->document().reset(3, parameters);
    QCOMPARE(m_window->document().index().livingCount(), 1U);
}

std::vector<QPoint> LassoingTest::lassoPlaces()
{
    std::vector<QPoint> places;
    for (int i = 0; i <= 40; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / 41.0;
        places.push_back(
            at(static_cast<float>(0.9 * std::cos(angle)), static_cast<float>(1.7 + 0.9 * std::sin(angle))));
    }
    return places;
}

void LassoingTest::drawLasso()
{
    const std::vector<QPoint> places = lassoPlaces();
    QTest::mousePress(handle(), Qt::LeftButton, {}, places.front());
    for (const QPoint& place : places)
        QTest::mouseMove(handle(), place, 1);
    QTest::mouseRelease(handle(), Qt::LeftButton, {}, places.back());
}

void LassoingTest::mouse_drawsALassoThatTheTreeFills()
{
    takeLasso();
    drawLasso();
    const TreeDocument& document = m_window->document();
    QCOMPARE(document.tree().lassoIndicesInForce().size(), 1U);
    QCOMPARE(document.undoStack().count(), 0); // it is growing still
    QTRY_COMPARE_WITH_TIMEOUT(document.undoStack().count(), 1, 20000);
    QVERIFY(document.index().livingCount() > 100);
    Box3 crown;
    for (InternodeId id = 1; id < document.tree().size(); ++id) {
        if (document.index().tipCount(id) <= 3)
            crown.extend(document.index().nodePosition(id));
    }
    QVERIFY(crown.max().y() < 2.65F && crown.max().y() > 2.2F);
    QVERIFY(crown.max().x() < 0.95F && crown.min().x() > -0.95F && crown.sizes().x() > 1.3F);
    QVERIFY(crown.sizes().z() > 1.2F);
    action(ActionId::Undo)->trigger();
    QCOMPARE(document.index().livingCount(), 1U);
    QVERIFY(document.tree().lassoIndicesInForce().empty());
    action(ActionId::Redo)->trigger();
    QVERIFY(document.index().livingCount() > 100);
}

void LassoingTest::finger_drawsALasso()
{
    takeLasso();
    const std::vector<QPoint> places = lassoPlaces();
    QTest::touchEvent(handle(), m_screen).press(0, places.front());
    for (const QPoint& place : places)
        QTest::touchEvent(handle(), m_screen).move(0, place);
    QTest::touchEvent(handle(), m_screen).release(0, places.back());
    const TreeDocument& document = m_window->document();
    QTRY_COMPARE_WITH_TIMEOUT(document.undoStack().count(), 1, 20000);
    QVERIFY(document.index().livingCount() > 100);
    QCOMPARE(document.tree().lassoIndicesInForce().size(), 1U);
}

void LassoingTest::pen_drawsALasso()
{
    takeLasso();
    static const QPointingDevice pen(
        QStringLiteral("lasso pen"), 8, QInputDevice::DeviceType::Stylus, QPointingDevice::PointerType::Pen,
        QInputDevice::Capability::Position | QInputDevice::Capability::Pressure, 1, 1);
    const auto send = [this](QEvent::Type type, const QPoint& inWindow) {
        const QPointF place = viewport().mapFrom(m_window.get(), inWindow);
        QTabletEvent event(type, &pen, place, viewport().mapToGlobal(place),
                           type == QEvent::TabletRelease ? 0.0 : 0.6, 0, 0, 0, 0, 0, Qt::NoModifier,
                           type == QEvent::TabletMove ? Qt::NoButton : Qt::LeftButton,
                           type == QEvent::TabletRelease ? Qt::NoButton : Qt::LeftButton);
        QCoreApplication::sendEvent(&viewport(), &event);
    };
    const std::vector<QPoint> places = lassoPlaces();
    send(QEvent::TabletPress, places.front());
    for (const QPoint& place : places)
        send(QEvent::TabletMove, place);
    send(QEvent::TabletRelease, places.back());
    const TreeDocument& document = m_window->document();
    QTRY_COMPARE_WITH_TIMEOUT(document.undoStack().count(), 1, 20000);
    QVERIFY(document.index().livingCount() > 100);
}

void LassoingTest::escapeDuringLassoGrowth_takesAllBack()
{
    takeLasso();
    drawLasso();
    const TreeDocument& document = m_window->document();
    QTRY_VERIFY(document.index().livingCount() > 20);
    QTest::keyClick(handle(), Qt::Key_Escape);
    QTRY_COMPARE(document.index().livingCount(), 1U);
    QVERIFY(document.tree().lassos().isEmpty());
    QVERIFY(document.journal().empty());
    QCOMPARE(document.undoStack().count(), 0);
}

void LassoingTest::pressDuringLassoGrowth_keepsWhatGrew()
{
    takeLasso();
    drawLasso();
    const TreeDocument& document = m_window->document();
    QTRY_VERIFY(document.index().livingCount() > 20);
    QTest::mouseClick(handle(), Qt::LeftButton, {}, at(-2.0F, 0.4F));
    QCOMPARE(document.undoStack().count(), 1);
    const std::uint32_t living = document.index().livingCount();
    QVERIFY(living > 20);
    QTest::qWait(150);
    QCOMPARE(document.index().livingCount(), living);
}

void LassoingTest::lassoTooSmall_isSaidInOneSentence()
{
    takeLasso();
    QTest::mousePress(handle(), Qt::LeftButton, {}, at(0.5F, 1.0F));
    for (int i = 0; i <= 10; ++i)
        QTest::mouseMove(handle(), at(0.5F + 0.1F * static_cast<float>(i), 1.0F), 1);
    QTest::mouseRelease(handle(), Qt::LeftButton, {}, at(1.5F, 1.0F));
    QVERIFY(!notice().isEmpty());
    QVERIFY(m_window->workspace().notice().isVisible());
    QCOMPARE(m_window->document().undoStack().count(), 0);
    QVERIFY(m_window->document().tree().lassos().isEmpty());
}

void LassoingTest::saveDuringTheStroke_writesTheFilledEnvelope()
{
    takeLasso();
    const QString file = m_folder->filePath(QStringLiteral("lasso.espalier"));
    save(file);
    const std::vector<QPoint> places = lassoPlaces();
    QTest::mousePress(handle(), Qt::LeftButton, {}, places.front());
    for (const QPoint& place : places)
        QTest::mouseMove(handle(), place, 1);
    QSignalSpy saved(&m_window->files().file(), &DocumentFile::saved);
    QTest::keyClick(handle(), Qt::Key_S, Qt::ControlModifier);
    QTRY_COMPARE_WITH_TIMEOUT(saved.count(), 1, 30000);
    QTest::mouseRelease(handle(), Qt::LeftButton, {}, places.back());
    const Result<Project> project = loadProject(file);
    QVERIFY(project);
    QVERIFY(project->tree == m_window->document().tree());
    QCOMPARE(project->tree.lassoIndicesInForce().size(), 1U);
    QVERIFY(project->tree.size() > 100);
    QVERIFY(!m_window->files().file().isModified());
}

void LassoingTest::lassoPopOut_regrowsRemovesAndHides()
{
    takeLasso();
    auto* regrow = m_window->findChild<QPushButton*>(QStringLiteral("lassoRegrow"));
    auto* remove = m_window->findChild<QPushButton*>(QStringLiteral("lassoRemove"));
    auto* stop = m_window->findChild<QPushButton*>(QStringLiteral("lassoStop"));
    QVERIFY(regrow && remove && stop && regrow->isVisible());
    QVERIFY(!regrow->isEnabled() && !remove->isEnabled() && !stop->isEnabled());
    drawLasso();
    const TreeDocument& document = m_window->document();
    QVERIFY(stop->isEnabled() && !regrow->isEnabled());
    QTRY_VERIFY(document.index().livingCount() > 20);
    QTest::mouseClick(stop, Qt::LeftButton);
    QCOMPARE(document.undoStack().count(), 1);
    QTest::mouseClick(regrow, Qt::LeftButton);
    QCOMPARE(document.index().livingCount(), 1U);
    QTRY_COMPARE_WITH_TIMEOUT(document.undoStack().count(), 2, 20000);
    QVERIFY(document.index().livingCount() > 100);
    auto* show = m_window->findChild<QCheckBox*>(QStringLiteral("lassoShow"));
    QVERIFY(show && show->isChecked());
    show->click();
    QVERIFY(!m_window->viewSettings().values().envelopeShown);
    show->click();
    QTest::mouseClick(remove, Qt::LeftButton);
    QVERIFY(document.tree().lassoIndicesInForce().empty());
    QVERIFY(document.index().livingCount() > 100);
    QCOMPARE(document.undoStack().count(), 3);
}

static const test::TestClass<LassoingTest> lassoingTest;

#include "LassoingTest.moc"
