// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/Viewport.h"

#include <QColor>
#include <QImage>
#include <QPointingDevice>
#include <QScreen>
#include <QSignalSpy>
#include <QTabletEvent>
#include <QTest>

#include <memory>

namespace espalier::test {

/// Parameters of a tree that grows little, so that a stroke in a test is quick.
inline TreeParameters smallTree()
{
    TreeParameters parameters;
    parameters.growth.internodeLength = 0.2;
    return parameters;
}

/// Calls @p move(), which moves the pointer to @p place, and waits for the first picture of the viewport
/// after that. Returns whether the screen then shows @p colour within 4 px of the place.
template <class Move>
bool isInNextPicture(Viewport& viewport, const QPoint& place, const QColor& colour, Move&& move)
{
    constexpr int kReach = 4;
    constexpr int kTolerance = 24;
    QSignalSpy pictures(&viewport, &QOpenGLWidget::frameSwapped);
    move();
    if (pictures.empty() && !pictures.wait(2000))
        return false;
    const QPoint corner = viewport.mapTo(viewport.window(), place) - QPoint(kReach, kReach);
    const QImage shown =
        viewport.screen()
            ->grabWindow(viewport.window()->winId(), corner.x(), corner.y(), 2 * kReach + 1, 2 * kReach + 1)
            .toImage();
    for (int y = 0; y < shown.height(); ++y) {
        for (int x = 0; x < shown.width(); ++x) {
            const QColor seen = shown.pixelColor(x, y);
            if (std::abs(seen.red() - colour.red()) < kTolerance &&
                std::abs(seen.green() - colour.green()) < kTolerance &&
                std::abs(seen.blue() - colour.blue()) < kTolerance)
                return true;
        }
    }
    return false;
}

/// A viewport on a screen, and the input devices of the tests.
class ViewportFixture : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { m_touch.reset(QTest::createTouchDevice()); }
    void init();
    void cleanup();

protected:
    QPoint at(const Vec3& point) const { return m_view->mainCamera().project(point)->toPoint(); }
    void press(const Vec3& point) { QTest::mousePress(m_view.get(), Qt::LeftButton, {}, at(point)); }
    void release(const Vec3& point) { QTest::mouseRelease(m_view.get(), Qt::LeftButton, {}, at(point)); }
    /// Moves a held mouse evenly along a line while time goes by.
    void drag(const Vec3& from, const Vec3& to, int milliseconds);
    void stroke(const Vec3& from, const Vec3& to, int milliseconds);
    void sendPen(QEvent::Type type, const QPointF& position, double pressure,
                 QPointingDevice::PointerType end = QPointingDevice::PointerType::Pen);
    std::uint32_t alive() const { return m_document->index().livingCount(); }

    std::unique_ptr<QPointingDevice> m_touch;
    std::unique_ptr<TreeDocument> m_document;
    std::unique_ptr<ViewSettings> m_settings;
    std::unique_ptr<Viewport> m_view;
};

inline void ViewportFixture::init()
{
    m_document = std::make_unique<TreeDocument>();
    m_document->reset(7, smallTree());
    m_settings = std::make_unique<ViewSettings>();
    // A processor draws the pictures: shadows and smooth edges would take most of a test's time.
    m_settings->set(&ViewValues::shadowsShown, false);
    m_view = std::make_unique<Viewport>(*m_document, *m_settings);
    m_view->setBestSamples(1);
    m_view->resize(640, 480);
    m_view->show();
    m_view->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(m_view.get()));
    m_view->setFocus();
}

inline void ViewportFixture::cleanup()
{
    m_view.reset();
    m_settings.reset();
    m_document.reset();
}

inline void ViewportFixture::drag(const Vec3& from, const Vec3& to, int milliseconds)
{
    constexpr int kStep = 20;
    for (int time = kStep; time <= milliseconds; time += kStep) {
        const Vec3 point = from + static_cast<float>(time) / static_cast<float>(milliseconds) * (to - from);
        const QPointF place = *m_view->mainCamera().project(point);
        QMouseEvent event(QEvent::MouseMove, place, m_view->mapToGlobal(place), Qt::NoButton, Qt::LeftButton,
                          Qt::NoModifier);
        QCoreApplication::sendEvent(m_view.get(), &event);
        QTest::qWait(kStep);
    }
}

inline void ViewportFixture::stroke(const Vec3& from, const Vec3& to, int milliseconds)
{
    press(from);
    drag(from, to, milliseconds);
    release(to);
}

inline void ViewportFixture::sendPen(QEvent::Type type, const QPointF& position, double pressure,
                                     QPointingDevice::PointerType end)
{
    const auto capabilities = QInputDevice::Capability::Position | QInputDevice::Capability::Pressure;
    static const QPointingDevice tip("test stylus", 78, QInputDevice::DeviceType::Stylus,
                                     QPointingDevice::PointerType::Pen, capabilities, 1, 1);
    static const QPointingDevice eraser("test eraser", 79, QInputDevice::DeviceType::Stylus,
                                        QPointingDevice::PointerType::Eraser, capabilities, 1, 1);
    const QPointingDevice* stylus = end == QPointingDevice::PointerType::Eraser ? &eraser : &tip;
    QTabletEvent event(type, stylus, position, m_view->mapToGlobal(position), pressure, 0.0F, 0.0F, 0.0F, 0.0,
                       0.0F, Qt::NoModifier, type == QEvent::TabletMove ? Qt::NoButton : Qt::LeftButton,
                       type == QEvent::TabletRelease ? Qt::NoButton : Qt::LeftButton);
    QCoreApplication::sendEvent(m_view.get(), &event);
}

} // namespace espalier::test
