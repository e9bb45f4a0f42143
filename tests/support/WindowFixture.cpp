// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/WindowFixture.h"

#include "commands/SketchStroke.h"
#include "panels/BackgroundPanel.h"
#include "panels/Notice.h"
#include "panels/Theme.h"
#include "views/Viewport.h"

#include <QApplication>
#include <QCoreApplication>
#include <QMessageBox>
#include <QPoint>
#include <QPointF>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

namespace espalier::test {

void WindowFixture::initTestCase()
{
    m_screen = QTest::createTouchDevice();
    theme::apply(*qApp);
    QSettings().clear();
    // The window is made here because data tables, which run before init(), may use it.
    m_window = std::make_unique<MainWindow>();
}

void WindowFixture::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    QVERIFY(m_folder->isValid());
    QSettings().clear();
    if (!m_window)
        m_window = std::make_unique<MainWindow>();
    m_window->resize(m_size);
    viewport().setBestSamples(1);
    m_window->show();
    m_window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
    ViewValues values;
    values.personShown = false;
    m_window->viewSettings().setValues(values);
    SceneLook look;
    look.groundShown = false;
    look.shadowsShown = false;
    look.backdrop = Backdrop::Plain;
    m_window->files().file().setLookOfNewTrees(look);
    workspace().background().setLookOfNewTrees(look);
    m_window->document().setLook(look);
    m_window->files().file().setUnmodified();
    // Tests count in its pixels.
    viewport().setSeedlingView(Viewport::kDefaultSeedlingView);
    action(ActionId::Brush)->trigger();
    viewport().setFocus();
}

void WindowFixture::cleanup()
{
    // A question about unsaved changes, or about growth, would wait for an answer for ever.
    action(ActionId::Cancel)->trigger();
    m_window->files().file().setUnmodified();
    if (m_window->files().isAside()) {
        m_window->files().bringBack();
        m_window->files().file().setUnmodified();
    }
    m_window->workspace().notice().finish();
    action(ActionId::New)->trigger();
}

QPoint WindowFixture::at(float right, float up)
{
    const Camera& camera = viewport().mainCamera();
    const auto point = camera.project(right * camera.right() + up * Vec3::UnitY());
    return viewport().mapTo(m_window.get(), point.value_or(QPointF()).toPoint());
}

void WindowFixture::brush(float fromUp, float toUp, float right)
{
    constexpr int kMoves = 25;
    const QPoint from = at(right, fromUp);
    const QPoint to = at(right, toUp);
    QTest::mousePress(handle(), Qt::LeftButton, {}, from);
    for (int i = 1; i <= kMoves; ++i) {
        QTest::mouseMove(handle(), from + (to - from) * i / kMoves);
        QTest::qWait(20);
    }
    QTest::mouseRelease(handle(), Qt::LeftButton, {}, to);
    QCoreApplication::processEvents();
}

void WindowFixture::makeTree()
{
    const auto draw = [&](std::vector<Vec2> points) {
        const LassoStroke stroke{Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), std::move(points)};
        QVERIFY(sketchBranch(m_window->document(), {.stroke = stroke, .base = {}}));
    };
    draw({{0.0F, 0.0F}, {0.0F, 1.6F}});
    for (int i = 0; i < 24; ++i) {
        const float height = 0.85F + 0.03F * static_cast<float>(i);
        const float side = i % 2 == 0 ? 1.0F : -1.0F;
        draw({{0.0F, height}, {0.25F * side, height + 0.2F}, {0.45F * side, height + 0.6F}});
    }
}

void WindowFixture::answer(QMessageBox::StandardButton button)
{
    QTimer::singleShot(100, this, [this, button] {
        auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
        if (!box)
            return answer(button);
        box->button(button)->click();
    });
}

void WindowFixture::save(const QString& fileName)
{
    DocumentFile& file = m_window->files().file();
    QSignalSpy saved(&file, &DocumentFile::saved);
    file.save(fileName, {});
    QVERIFY(saved.wait());
}

QString WindowFixture::notice()
{
    return workspace().notice().text();
}

} // namespace espalier::test
