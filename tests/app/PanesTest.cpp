// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/RecipePlayer.h"
#include "panels/BackgroundPanel.h"
#include "panels/Bar.h"
#include "panels/Notice.h"
#include "panels/architecture/ArchitecturePanel.h"
#include "panels/architecture/Diagram.h"
#include "panels/architecture/DiagramHandle.h"
#include "tests/support/TestClasses.h"
#include "tests/support/WindowFixture.h"
#include "views/Viewport.h"

#include <QApplication>
#include <QImage>
#include <QPixmap>
#include <QPoint>
#include <QRgb>
#include <QSet>
#include <QTest>
#include <QWidget>

using namespace espalier;

/// The user opens and closes the panes around the tree.
class PanesTest : public test::WindowFixture {
    Q_OBJECT

private Q_SLOTS:
    void tab_hidesEverythingButTheTree();
    void sheets_opensOneAtATime();
    void f6_leadsTheKeysToThePanelsAndBack();
    void architecture_isDraggedOverTheLiveTree();
    void window_looksLikeThis();
};

void PanesTest::tab_hidesEverythingButTheTree()
{
    auto* bar = m_window->findChild<TopBar*>();
    auto* tools = m_window->findChild<SideBar*>();
    QVERIFY(bar->isVisible() && tools->isVisible());
    QTest::keyClick(handle(), Qt::Key_Tab);
    QTRY_VERIFY(!bar->isVisible() && !tools->isVisible());
    QVERIFY(viewport().isVisible());
    QTest::keyClick(handle(), Qt::Key_Tab);
    QTRY_VERIFY(bar->isVisible() && tools->isVisible());
}

void PanesTest::sheets_opensOneAtATime()
{
    Workspace& workspace = m_window->workspace();
    action(ActionId::Architecture)->trigger();
    QVERIFY(workspace.sheet(0).isVisible());
    action(ActionId::LeafSheet)->trigger();
    QVERIFY(!workspace.sheet(0).isVisible() && workspace.sheet(2).isVisible());
    action(ActionId::Background)->trigger();
    QVERIFY(!workspace.sheet(2).isVisible() && workspace.background().isVisible());
    action(ActionId::LeafSheet)->trigger();
    QVERIFY(!workspace.background().isVisible());
    QTest::keyClick(handle(), Qt::Key_Escape);
    QTRY_VERIFY(!workspace.sheet(2).isVisible());
}

void PanesTest::f6_leadsTheKeysToThePanelsAndBack()
{
    action(ActionId::LeafSheet)->trigger();
    QTest::keyClick(handle(), Qt::Key_F6);
    Bar& sheet = m_window->workspace().sheet(2);
    QTRY_VERIFY(sheet.isAncestorOf(QApplication::focusWidget()));
    QWidget* const first = QApplication::focusWidget();
    QTest::keyClick(handle(), Qt::Key_Tab);
    QTRY_VERIFY(QApplication::focusWidget() != first);
    QVERIFY(sheet.isVisible() && sheet.isAncestorOf(QApplication::focusWidget()));
    QTest::keyClick(handle(), Qt::Key_F6);
    QTRY_COMPARE(QApplication::focusWidget(), &viewport());
    QTest::keyClick(handle(), Qt::Key_Escape);
    QTRY_VERIFY(!sheet.isVisible());
}

void PanesTest::architecture_isDraggedOverTheLiveTree()
{
    brush();
    const std::uint32_t grown = m_window->document().index().livingCount();
    action(ActionId::Architecture)->trigger();
    ArchitecturePanel& panel = m_window->workspace().architecture();
    Diagram* tropism = panel.diagrams().front();
    const QPoint from = tropism->mapTo(m_window.get(), tropism->handlePlace(0).toPoint());
    QTest::mousePress(handle(), Qt::LeftButton, {}, from);
    for (int i = 1; i <= 8; ++i)
        QTest::mouseMove(handle(), from + QPoint(0, 8 * i));
    QTest::mouseRelease(handle(), Qt::LeftButton, {}, from + QPoint(0, 64));
    const TreeDocument& document = m_window->document();
    QCOMPARE(document.undoStack().count(), 2);
    const double theta = document.parameters().growth.setPointAngle;
    QVERIFY(theta > radians(60));
    // The tree stays; F6 leads the arrow keys to the handle, and back to the tree.
    QCOMPARE(document.index().livingCount(), grown);
    QTRY_COMPARE(QApplication::focusWidget(), &viewport());
    QTest::keyClick(handle(), Qt::Key_F6);
    QTRY_VERIFY(qobject_cast<DiagramHandle*>(QApplication::focusWidget()));
    QVERIFY(QApplication::focusWidget()->isVisible());
    QTest::keyClick(handle(), Qt::Key_Down);
    QVERIFY(document.parameters().growth.setPointAngle > theta);
    QTest::keyClick(handle(), Qt::Key_F6);
    QTRY_COMPARE(QApplication::focusWidget(), &viewport());
    // The user can still brush the tree.
    brush(0.5F, 1.2F, 0.5F);
    QVERIFY(document.index().livingCount() > grown);
    action(ActionId::Architecture)->trigger();
    QVERIFY(!panel.isVisible());
}

void PanesTest::window_looksLikeThis()
{
    m_window->resize(1440, 900);
    m_window->viewSettings().setValues({});
    const auto shoot = [this](const char* name) {
        QTest::qWait(300);
        QTRY_VERIFY_WITH_TIMEOUT(viewport().isAtRest(), 30000);
        const QPixmap picture = m_window->screen()->grabWindow(m_window->winId());
        QVERIFY(picture.save(QString::fromLatin1(name)));
        // Bars on top, a tree in the middle.
        const QImage image = picture.toImage();
        QSet<QRgb> colours;
        for (int x = 0; x < image.width(); x += 3)
            colours.insert(image.pixel(x, image.height() / 2));
        QVERIFY2(colours.size() > 50, name);
    };
    shoot("window-empty.png");
    const Result<Recipe> recipe = readRecipe(QStringLiteral(":/recipes/bonsai.json"));
    QVERIFY(recipe);
    RecipePlayer(m_window->document(), *recipe).playAll();
    action(ActionId::FrameAll)->trigger();
    shoot("window.png");
    action(ActionId::Architecture)->trigger();
    shoot("window-architecture.png");
    m_window->resize(m_window->minimumSize());
    shoot("window-small.png");
    m_window->resize(1440, 900);
    action(ActionId::LeafSheet)->trigger();
    action(ActionId::Grow)->trigger();
    m_window->workspace().notice().showWarning(
        QStringLiteral("old-oak.espalier: journal/died: the column is shorter than the deltas say"));
    shoot("window-leaves.png");
    action(ActionId::BranchSheet)->trigger();
    action(ActionId::Brush)->trigger();
    m_window->workspace().notice().showProgress(*this, QStringLiteral("Writing old-oak.fbx"), 0.4, [] {});
    const QPoint from = at(1.4F, 2.4F);
    QTest::mousePress(handle(), Qt::LeftButton, {}, from);
    for (int i = 1; i <= 12; ++i) {
        QTest::mouseMove(handle(), from + QPoint(7 * i, -5 * i));
        QTest::qWait(20);
    }
    const QPixmap picture = m_window->screen()->grabWindow(m_window->winId());
    QVERIFY(picture.save(QStringLiteral("window-stroke.png")));
    QTest::keyClick(handle(), Qt::Key_Escape);
    QTest::mouseRelease(handle(), Qt::LeftButton, {}, from);
}

static const test::TestClass<PanesTest> panesTest;

#include "PanesTest.moc"
