// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/Viewport.h"

#include "views/LabelEditor.h"
#include "views/render/LabelLayout.h"
#include "views/render/OverlayRenderer.h"
#include "views/render/RenderTarget.h"
#include "views/render/Renderer.h"
#include "views/render/ScaleFigure.h"
#include "views/render/Sun.h"
#include "views/tools/BrushTool.h"
#include "views/tools/PruneTool.h"
#include "views/tools/SelectionRings.h"
#include "views/tools/SunTool.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QOpenGLContext>
#include <QPainter>
#include <QTimer>
#include <QTimerEvent>

#include <algorithm>
#include <cmath>

namespace espalier {

namespace {

constexpr int kTick = 16;            ///< ms
constexpr int kRestAfter = 180;      ///< ms without any movement
constexpr double kLongestTick = 0.1; ///< s; after a longer pause, animations continue where they were

} // namespace

Viewport::Viewport(TreeDocument& document, ViewSettings& settings, QWidget* parent)
    : QOpenGLWidget(parent),
      m_document(document),
      m_settings(settings),
      m_gestures(*this),
      m_scene(document),
      m_tool(std::make_unique<BrushTool>(toolContext())),
      m_eraser(std::make_unique<PruneTool>(toolContext())),
      m_sun(std::make_unique<SunTool>(toolContext())),
      m_hand(m_tool.get())
{
    setFormat(surfaceFormat());
    // Tab moves through the panels and does not reach the viewport, but F6 does. In the viewport, Tab hides
    // the panels.
    setFocusPolicy(Qt::ClickFocus);
    setMouseTracking(true);
    setTabletTracking(true);
    setAttribute(Qt::WA_AcceptTouchEvents);
    setAccessibleName(tr("Tree"));
    setCursor(m_tool->cursor());
    // Only the application gets events about a pen that enters or leaves the tablet's reach.
    qApp->installEventFilter(this);
    connect(&m_document, &TreeDocument::changed, this, &Viewport::followDocument);
    connect(&m_settings, &ViewSettings::changed, this, &Viewport::followSettings);
    connect(&m_settings, &ViewSettings::lookReplaced, this,
            [this] { m_shown.sunPinned = m_settings.values().sunPinned; });
    connect(&m_document, &TreeDocument::competitorsChanged, this, [this] {
        m_selectedAt = m_pointers.now();
        startTicking();
        update();
    });
    m_shown = m_settings.values();
    m_scene.setFibresShown(m_shown.fibresShown);
    showAnew();
}

Viewport::~Viewport()
{
    m_tool.reset();
    m_eraser.reset();
    m_sun.reset();
    releaseGl();
    // The base class destroys the context after the members of this class.
    if (context() != nullptr)
        context()->disconnect(this);
}

void Viewport::setCamera(const Camera& camera)
{
    m_flight.stop();
    moveCamera(camera);
}

void Viewport::moveCamera(const Camera& camera)
{
    m_isFramed = false;
    Camera sized = camera;
    sized.setViewSize(size());
    if (sized == m_camera)
        return;
    m_camera = sized;
    placeSecondView();
    m_pacer.disturb();
    redrawTree();
    Q_EMIT cameraChanged();
}

void Viewport::setFrameMargins(const QMargins& margins)
{
    m_frameMargins = margins;
    placeSecondView();
}

/// What the second view shows all of, m: a seedling alone is too small for that.
Box3 Viewport::secondBounds() const
{
    return m_document.index().livingCount() > 1 ? m_scene.bounds() : Box3();
}

/// Puts the second view where it belongs now. A gesture in it ends first, as it stands, since it is read with
/// the camera that it began with.
void Viewport::placeSecondView()
{
    const QRect place = SecondView::placeIn(m_settings.values().secondViewShown ? clearRect() : QRect());
    const bool moves = place != m_second.rect();
    if (moves && m_isInSecondView) {
        finishGesture();
        leaveViews();
    }
    if (!isGestureActive() || !m_isInSecondView)
        m_second.follow(m_camera, clearRect(), place, secondBounds());
    if (moves)
        redrawTree();
}

void Viewport::setSeedlingView(double metres)
{
    m_seedlingView = metres;
    if (m_isFramed && m_document.index().livingCount() <= 1)
        showAnew();
}

void Viewport::frameAll()
{
    flyTo(framed(cameraAtRest()));
}

void Viewport::showFrom(NamedView view)
{
    flyTo(cameraAtRest().turnedTo(view));
}

/// The middle of the part that bars leave free, in shares of the viewport's size.
QPointF Viewport::clearShare() const
{
    const QPointF middle = QRectF(clearRect()).center();
    return {middle.x() / std::max(width(), 1), middle.y() / std::max(height(), 1)};
}

void Viewport::takeClearRect()
{
    const bool wasFramed = m_isFramed;
    Camera camera = m_camera;
    camera.setTargetShare(clearShare());
    moveCamera(wasFramed ? framed(m_camera) : camera);
    m_isFramed = wasFramed;
}

Camera Viewport::inRoom(const Camera& camera, const QRect& before, bool showsTree) const
{
    const QRect clear = clearRect();
    if (clear == before)
        return camera;
    Camera moved = camera;
    moved.setViewSize(size());
    moved.setTargetShare(clearShare());
    if (showsTree)
        return isTreeClear(moved) ? moved : framed(moved);
    const double smaller = std::max({1.0, static_cast<double>(before.width()) / std::max(clear.width(), 1),
                                     static_cast<double>(before.height()) / std::max(clear.height(), 1)});
    moved.setDistance(moved.distance() * static_cast<float>(smaller));
    return moved;
}

/// Calls @p frame(camera) with a view of the size that bars leave free, and returns that camera for the whole
/// view.
template <class Frame>
Camera Viewport::inClearRect(const Camera& camera, Frame&& frame) const
{
    const QRect clear = clearRect();
    Camera sized = camera;
    sized.setViewSize(clear.size());
    sized = frame(sized);
    sized.setDistance(sized.distance() * static_cast<float>(height()) /
                      static_cast<float>(std::max(clear.height(), 1)));
    sized.setViewSize(size());
    sized.setTargetShare(clearShare());
    return sized;
}

Camera Viewport::framing(const Box3& box) const
{
    return inClearRect(m_camera, [&](const Camera& camera) { return camera.framing(box); });
}

Camera Viewport::framed(const Camera& camera) const
{
    if (m_document.index().livingCount() > 1)
        return inClearRect(camera, [&](const Camera& sized) { return sized.framing(m_scene.outline()); });
    Camera first;
    const auto scale = static_cast<float>(m_seedlingView / kDefaultSeedlingView);
    first.setTarget(scale * first.target());
    first.setDistance(scale * first.distance());
    first.setViewSize(size());
    first.setAzimuth(camera.azimuth());
    first.setElevation(camera.elevation());
    first.setTargetShare({clearShare().x(), first.targetShare().y()});
    return first;
}

Camera Viewport::cameraAtRest() const
{
    Camera camera = m_flight.isFlying() ? m_flight.end() : m_camera;
    camera.setViewSize(size());
    return camera;
}

bool Viewport::isTreeClear(const Camera& camera) const
{
    const QRectF clear(clearRect());
    return std::ranges::all_of(m_scene.outline(), [&](const Vec3& point) {
        const auto place = camera.project(point);
        return place && clear.contains(*place);
    });
}

void Viewport::flyTo(const Camera& camera)
{
    m_flight.start(m_camera, camera);
    startTicking();
}

void Viewport::followDocument(const TreeChange& change)
{
    m_scene.follow(change);
    if (!change.delta && !isGestureActive()) {
        for (Tool* const tool : {m_tool.get(), m_eraser.get()}) {
            if (change.internodes)
                tool->renumber(*change.internodes);
            else
                tool->forget();
        }
    }
    if (change.kind == TreeChange::Kind::Reset)
        showAnew();
    m_pacer.disturb();
    redrawTree();
}

void Viewport::showStrands(const std::shared_ptr<const ShownStrands>& strands, std::uint64_t revision)
{
    m_scene.setStrands(strands, revision);
    redrawTree();
}

/// Shows another tree from the front.
void Viewport::showAnew()
{
    setCamera(framed(Camera()));
    m_isFramed = true;
}

void Viewport::followSettings()
{
    // The sun does not move when it is pinned or unpinned.
    if (const bool isPinned = m_settings.values().sunPinned; isPinned != m_shown.sunPinned) {
        ViewValues moved = m_settings.values();
        moved.sunPinned = std::exchange(m_shown.sunPinned, isPinned);
        pinSun(moved, m_camera, isPinned);
        m_settings.setValues(moved);
    }
    // Values that affect only tools do not affect the picture of the tree.
    ViewValues values = m_settings.values();
    values.brushRadius = m_shown.brushRadius;
    values.pressureScales = m_shown.pressureScales;
    values.markersShown = m_shown.markersShown;
    values.brushPlane = m_shown.brushPlane;
    values.brushSymmetry = m_shown.brushSymmetry;
    values.pruneMode = m_shown.pruneMode;
    values.prunesThrough = m_shown.prunesThrough;
    values.eraserThickest = m_shown.eraserThickest;
    values.thinShare = m_shown.thinShare;
    values.bendingWeight = m_shown.bendingWeight;
    values.stretchingWeight = m_shown.stretchingWeight;
    values.twistsSubtree = m_shown.twistsSubtree;
    values.newBuds = m_shown.newBuds;
    values.budSpacing = m_shown.budSpacing;
    values.envelopeShown = m_shown.envelopeShown;
    values.planeShown = m_shown.planeShown;
    values.sunShown = m_shown.sunShown;
    values.personShown = m_shown.personShown;
    update();
    if (values == m_shown)
        return;
    m_shown = values;
    placeSecondView();
    m_scene.setFibresShown(values.fibresShown);
    m_pacer.disturb();
    redrawTree();
}

bool Viewport::isBetweenGestures() const
{
    return m_labelEditor || m_tool->canTakeBack();
}

void Viewport::setTool(std::unique_ptr<Tool> tool)
{
    finishGesture();
    delete m_labelEditor;
    leaveViews();
    m_tool->leave();
    m_tool = std::move(tool);
    m_hand = m_tool.get();
    setCursor(m_tool->cursor());
    update();
    Q_EMIT toolChanged();
}

QPointF Viewport::sunPlace() const
{
    return m_sun->place();
}

bool Viewport::keyForTool(int key)
{
    Tool& tool = m_hand == m_sun.get() ? *m_tool : *m_hand;
    return !isGestureActive() && tool.keyPressed(key);
}

void Viewport::setGrowing(bool growing)
{
    m_isGrowing = growing;
}

void Viewport::finishGesture()
{
    m_gestures.finish();
}

void Viewport::cancelGesture()
{
    m_gestures.cancel();
}

bool Viewport::needsTicks() const
{
    return m_hand->wantsTicks() || areRingsExpanding() || m_flight.isFlying() || m_keys.isAnyHeld() ||
           isRefining() || (m_scene.isBehind() && !m_pictureIsOld);
}

bool Viewport::areRingsExpanding() const
{
    return !m_document.competitors().areAll() && m_pointers.now() - m_selectedAt < kRingsExpand;
}

void Viewport::startTicking()
{
    if (m_ticks.isActive() || !needsTicks())
        return;
    m_lastTick = m_pointers.now();
    m_ticks.start(kTick, Qt::PreciseTimer, this);
}

void Viewport::timerEvent(QTimerEvent* event)
{
    if (event->timerId() == m_ticks.timerId()) {
        tick();
    } else if (event->timerId() == m_lateTimer.timerId()) {
        takeLate();
    } else if (event->timerId() == m_restTimer.timerId()) {
        m_restTimer.stop();
        if (m_gestures.isBusy() || m_isGrowing || needsTicks()) {
            m_restTimer.start(kRestAfter, this);
            return;
        }
        if (!m_scene.settleSome()) {
            m_restTimer.start(kTick, this);
            return;
        }
        m_pacer.rest();
        m_pictureIsOld = true;
        update();
        startTicking();
    } else {
        QOpenGLWidget::timerEvent(event);
    }
}

void Viewport::tick()
{
    const double now = m_pointers.now();
    const double seconds = std::min(now - m_lastTick, kLongestTick);
    m_lastTick = now;
    if (m_flight.isFlying()) {
        Camera camera = m_camera;
        m_flight.advance(camera, seconds);
        moveCamera(camera);
    }
    if (m_keys.isAnyHeld())
        moveByKeys(seconds);
    if (m_hand->wantsTicks()) {
        const double rested = m_pointers.rest();
        if (m_hand->isActive() && m_hand->isFreehand()) {
            if (const std::optional<PointerSample> sample = m_stabiliser.rest(rested))
                m_hand->move(*sample);
        }
        m_hand->tick(rested);
    }
    if (areRingsExpanding())
        update();
    if (isRefining()) {
        m_passIsDue = true;
        update();
    }
    if (m_scene.isBehind()) {
        m_pictureIsOld = true;
        update();
    }
    if (!needsTicks())
        m_ticks.stop();
}

/// Draws the tree again, in full quality once all motion has ended.
void Viewport::redrawTree()
{
    m_pictureIsOld = true;
    m_restTimer.start(kRestAfter, this);
    update();
}

} // namespace espalier
