// SPDX-License-Identifier: GPL-3.0-or-later
// The part of Viewport that handles input events.
#include "views/Viewport.h"
#include "views/tools/SunTool.h"

#include <QApplication>
#include <QKeyEvent>
#include <QWheelEvent>

#include <cmath>

namespace espalier {

namespace {

constexpr double kOrbitPerPixel = 0.0065; ///< rad
constexpr double kZoomPerNotch = 0.88;
/// A key that is only tapped moves the camera as much as one held for this long, s.
constexpr double kCameraTap = 0.04;
/// A sample that is older than this is late, s.
constexpr double kLate = 0.03;

} // namespace

bool Viewport::event(QEvent* event)
{
    switch (event->type()) {
    case QEvent::TouchBegin:
    case QEvent::TouchUpdate:
    case QEvent::TouchEnd:
    case QEvent::TouchCancel:
    case QEvent::TabletPress:
        // A press of the mouse sets the focus by itself.
        // Unlike a mouse, a pen beside a menu presses what is below it.
        if (QWidget* menu = QApplication::activePopupWidget(); menu && event->type() == QEvent::TabletPress) {
            menu->close();
            event->accept();
            return true;
        }
        if (event->type() == QEvent::TouchBegin || event->type() == QEvent::TabletPress)
            setFocus(Qt::MouseFocusReason);
        [[fallthrough]];
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
    case QEvent::MouseMove:
    case QEvent::MouseButtonRelease:
    case QEvent::TabletMove:
    case QEvent::TabletRelease:
        m_gestures.read(m_pointers.read(*event));
        event->accept();
        return true;
    case QEvent::WindowDeactivate:
        finishGesture();
        break;
    case QEvent::ShortcutOverride: {
        // Keys that move the camera, and Escape during a gesture, are not passed to shortcuts.
        const auto* key = static_cast<QKeyEvent*>(event);
        HeldKeys probe;
        if (probe.press(key->key(), key->modifiers()) ||
            (key->key() == Qt::Key_Escape && m_gestures.isBusy())) {
            event->accept();
            return true;
        }
        break;
    }
    default:
        break;
    }
    return QOpenGLWidget::event(event);
}

bool Viewport::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::TabletEnterProximity || event->type() == QEvent::TabletLeaveProximity)
        m_gestures.setPenInReach(event->type() == QEvent::TabletEnterProximity, m_pointers.now());
    // A modal dialog gets the pointer's events from now on.
    if (event->type() == QEvent::WindowBlocked && watched == window())
        finishGesture();
    return QOpenGLWidget::eventFilter(watched, event);
}

void Viewport::wheelEvent(QWheelEvent* event)
{
    const QPoint turned = event->angleDelta();
    // With Alt, some systems turn the wheel sideways.
    const double notches = (turned.y() != 0 ? turned.y() : turned.x()) / 120.0;
    if (event->modifiers().testFlag(Qt::ControlModifier))
        m_hand->wheel(notches);
    else
        magnify(std::pow(kZoomPerNotch, -notches), event->position());
    event->accept();
}

void Viewport::keyPressEvent(QKeyEvent* event)
{
    if (event->isAutoRepeat())
        return;
    if (m_keys.press(event->key(), event->modifiers())) {
        moveByKeys(kCameraTap);
        startTicking();
        return;
    }
    switch (event->key()) {
    case Qt::Key_Space:
        m_gestures.setPanKey(true);
        break;
    case Qt::Key_Escape:
        if (m_gestures.isBusy())
            cancelGesture();
        else if (!keyForTool(event->key()))
            event->ignore();
        break;
    case Qt::Key_F:
    case Qt::Key_Home:
        frameAll();
        break;
    default:
        if (!keyForTool(event->key()))
            QOpenGLWidget::keyPressEvent(event);
        break;
    }
}

void Viewport::keyReleaseEvent(QKeyEvent* event)
{
    if (event->isAutoRepeat() || m_keys.release(event->key()))
        return;
    if (event->key() == Qt::Key_Space)
        m_gestures.setPanKey(false);
    else
        QOpenGLWidget::keyReleaseEvent(event);
}

void Viewport::focusOutEvent(QFocusEvent* event)
{
    // Another widget will get the release of keys that are held.
    m_keys.clear();
    m_gestures.setPanKey(false);
    // The user may use a control with the other hand while drawing: that does not end a stroke.
    if (event->reason() != Qt::MouseFocusReason)
        finishGesture();
    QOpenGLWidget::focusOutEvent(event);
}

void Viewport::hideEvent(QHideEvent* event)
{
    finishGesture();
    QOpenGLWidget::hideEvent(event);
}

void Viewport::leaveEvent(QEvent* event)
{
    leaveViews();
    QOpenGLWidget::leaveEvent(event);
}

void Viewport::resizeEvent(QResizeEvent* event)
{
    takeClearRect();
    placeSecondView();
    m_gestures.setStrip(QRectF(0.0, height() - kStripHeight, width(), kStripHeight));
    QOpenGLWidget::resizeEvent(event);
}

/// Calls @p pick(scene) with the data for picking.
template <class Pick>
auto Viewport::withPickScene(Pick&& pick) const
{
    float greatest = 0.0F;
    for (const InternodeId root : m_document.index().roots())
        greatest = std::max(greatest, branchRadius(root));
    for (const WidthConstraint& constraint : m_document.tree().widthConstraints())
        greatest = std::max(greatest, constraint.value / 2.0F);
    const std::function<float(InternodeId)> radius = [&](InternodeId id) {
        return std::min(branchRadius(id), greatest);
    };
    return pick(
        PickScene{m_document.tree(), m_document.index(), m_document.pickIndex(), radius, greatest, camera()});
}

double Viewport::reachOf(PointerDevice device) const
{
    return pickReach(device, logicalDpiX() / 25.4);
}

std::optional<PickedBranch> Viewport::pick(const QPointF& screen, PointerDevice device) const
{
    return withPickScene([&](const PickScene& scene) { return pickBranch(scene, screen, reachOf(device)); });
}

std::optional<PickedBranch> Viewport::pickThick(const QPointF& screen, PointerDevice device) const
{
    return withPickScene(
        [&](const PickScene& scene) { return pickThickBranch(scene, screen, reachOf(device)); });
}

std::vector<PickedBud> Viewport::pickBuds(const QPointF& screen, PointerDevice device, double factor) const
{
    return withPickScene(
        [&](const PickScene& scene) { return espalier::pickBuds(scene, screen, factor * reachOf(device)); });
}

/// Between gestures, chooses the tool and the view that get the samples; returns the sample in that view.
PointerSample Viewport::takeInHand(const PointerSample& sample)
{
    if (m_hand->isActive())
        return inView(sample);
    Tool* hand = sample.isEraser && !m_tool->takesEraser() ? m_eraser.get() : m_tool.get();
    const bool isInSecondView = m_second.isAt(sample.position);
    if (isInSecondView != m_isInSecondView)
        leaveViews();
    m_isInSecondView = isInSecondView;
    if (!m_isInSecondView && m_sun->isAt(sample.position, reachOf(sample.device)))
        hand = m_sun.get();
    if (hand != m_hand) {
        m_hand->leave();
        m_hand = hand;
        setCursor(m_hand->cursor());
    }
    return inView(sample);
}

/// The pointer is in no view any more, unless a gesture is under way.
void Viewport::leaveViews()
{
    if (m_hand->isActive())
        return;
    m_late.clear();
    m_hand->leave();
    m_isInSecondView = false;
}

bool Viewport::toolTakesFinger(const PointerSample& sample)
{
    return m_hand->takesFinger(takeInHand(sample));
}

void Viewport::toolBegins(const PointerSample& sample)
{
    Q_EMIT toolAboutToBegin();
    m_late.clear();
    const PointerSample first = takeInHand(sample);
    if (m_hand->isFreehand())
        m_stabiliser.begin(first);
    m_hand->begin(first);
    startTicking();
    Q_EMIT gestureActiveChanged(true);
}

/// What is drawn needs all samples. Other tools need only where the pointer is now; if it was there long ago,
/// more samples wait, and the newest of them will do.
void Viewport::toolMoves(const PointerSample& sample)
{
    if (m_hand->isFreehand()) {
        m_hand->move(m_stabiliser.move(inView(sample)));
    } else if (!isLate(sample)) {
        m_hand->move(inView(sample));
    }
}

/// Whether @p sample waits until no newer one comes; if not, it takes the place of one that waits.
bool Viewport::isLate(const PointerSample& sample)
{
    std::erase_if(m_late, [&](const PointerSample& waiting) { return waiting.id == sample.id; });
    if (m_pointers.now() - sample.time <= kLate)
        return false;
    m_late.push_back(sample);
    m_lateTimer.start(0, this);
    return true;
}

void Viewport::takeLate()
{
    m_lateTimer.stop();
    for (const PointerSample& sample : std::exchange(m_late, {})) {
        if (m_hand->isActive())
            m_hand->move(inView(sample));
        else
            m_hand->hover(takeInHand(sample));
    }
}

/// A calmed stroke ends where the pointer is.
void Viewport::toolEnds(const PointerSample& sample)
{
    takeLate();
    m_hand->end(inView(sample));
    Q_EMIT gestureActiveChanged(false);
}

void Viewport::toolIsFinished()
{
    takeLate();
    m_hand->finish();
    Q_EMIT gestureActiveChanged(false);
}

void Viewport::toolIsCancelled()
{
    m_late.clear();
    m_hand->cancel();
    Q_EMIT gestureActiveChanged(false);
}

void Viewport::toolHovers(const PointerSample& sample)
{
    if (!isLate(sample))
        m_hand->hover(takeInHand(sample));
}

void Viewport::budIsAsked(const PointerSample& sample)
{
    Q_EMIT toolAboutToBegin();
    const std::vector<PickedBud> buds = pickBuds(takeInHand(sample).position, sample.device, 1.0);
    m_document.setCompetitors(buds.empty() ? Competitors{}
                                           : Competitors{buds.front().bud.node, buds.front().bud.slot});
}

void Viewport::orbitBy(const QPointF& distance)
{
    turn(static_cast<float>(-kOrbitPerPixel * distance.x()),
         static_cast<float>(kOrbitPerPixel * distance.y()));
}

/// Turns the camera, rad; a flight goes on, turned likewise.
void Viewport::turn(float byAzimuth, float byElevation)
{
    m_flight.orbit(byAzimuth, byElevation);
    Camera camera = m_camera;
    camera.orbit(byAzimuth, byElevation);
    moveCamera(camera);
}

void Viewport::panBy(const QPointF& distance)
{
    m_flight.stop();
    Camera camera = m_camera;
    if (m_isInSecondView) {
        Camera side = m_second.camera();
        side.pan(distance);
        camera.setTarget(side.target());
    } else {
        camera.pan(distance);
    }
    moveCamera(camera);
}

void Viewport::magnify(double factor, const QPointF& about)
{
    m_flight.stop();
    Camera camera = m_camera;
    camera.zoom(static_cast<float>(1.0 / factor), m_second.isAt(about) ? camera.targetPlace() : about);
    moveCamera(camera);
}

void Viewport::moveByKeys(double seconds)
{
    const HeldKeys::Motion motion = m_keys.motion();
    turn(static_cast<float>(seconds * motion.orbit.x()), static_cast<float>(seconds * motion.orbit.y()));
    if (motion.pan.isNull() && motion.zoom == 0.0)
        return;
    m_flight.stop();
    Camera camera = m_camera;
    camera.pan(seconds * motion.pan);
    camera.zoom(static_cast<float>(std::exp(-seconds * motion.zoom)), camera.targetPlace());
    moveCamera(camera);
}

} // namespace espalier
