// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/SecondView.h"
#include "views/camera/CameraFlight.h"
#include "views/input/GestureReader.h"
#include "views/input/HeldKeys.h"
#include "views/input/PointerReader.h"
#include "views/input/StrokeStabiliser.h"
#include "views/render/FramePacer.h"
#include "views/render/RenderOptions.h"
#include "views/render/TreeScene.h"
#include "views/tools/Tool.h"

#include <QBasicTimer>
#include <QMargins>
#include <QOpenGLWidget>
#include <QPointer>

#include <memory>

namespace espalier {

class LabelEditor;
class OverlayRenderer;
class Renderer;
class RenderTarget;
class SunTool;

/// Shows a document's tree, and lets the user work on it with a tool or turn it. While something moves it
/// draws plainly and fast; at rest it draws in full quality. The picture of the tree is kept, so that a
/// tool's overlay can move without drawing the tree again.
class Viewport : public QOpenGLWidget, private ToolContext, private GestureTarget {
    Q_OBJECT

public:
    /// @p document and @p settings must outlive the viewport.
    Viewport(TreeDocument& document, ViewSettings& settings, QWidget* parent = nullptr);
    /// Cancels a gesture under way.
    ~Viewport() override;

    /// See TreeScene::expect().
    void expect(PreparedScene scene) { m_scene.expect(std::move(scene)); }

    /// See TreeScene::setStrands().
    void showStrands(const std::shared_ptr<const ShownStrands>& strands, std::uint64_t revision);
    /// The strands that are shown in place of tubes, or null.
    const std::shared_ptr<const ShownStrands>& shownStrands() const { return m_scene.strands(); }

    const Camera& mainCamera() const override { return m_camera; }
    /// Sets the camera at once and ends a flight. The camera's view size becomes the viewport's.
    void setCamera(const Camera& camera);
    /// Moves the camera smoothly.
    void flyTo(const Camera& camera);
    /// Sets the height of the world that a seedling's view shows from top to bottom, m.
    void setSeedlingView(double metres);
    double seedlingView() const { return m_seedlingView; }
    /// Flies to a view of the whole tree; a seedling is shown as in a new document. A turn under way still
    /// comes to its end.
    void frameAll();
    /// Turns smoothly to another side. Target and distance stay, or become those that the camera is flying
    /// to.
    void showFrom(NamedView view);

    /// What a default Camera shows, m.
    static constexpr double kDefaultSeedlingView = 6.0;
    /// Height of the rotation strip at the bottom edge, px.
    static constexpr int kStripHeight = 36;

    void setMouseScheme(MouseScheme scheme) { m_gestures.setScheme(scheme); }
    /// See PointerReader::setPressureExponent.
    void setPressureExponent(double exponent) { m_pointers.setPressureExponent(exponent); }
    void setStabilising(const Stabilising& stabilising) { m_stabiliser.set(stabilising); }
    /// Sets the margins that bars over the viewport cover, px: whole trees are framed in the rest of it.
    void setFrameMargins(const QMargins& margins);
    /// The part of the viewport that bars leave free, px.
    QRect clearRect() const { return rect().marginsRemoved(m_frameMargins); }
    /// Moves the picture at once into the part that bars leave free, after the window got another size.
    void takeClearRect();
    /// @p camera with its target in the middle of the part that bars leave free. If @p showsTree, it shows
    /// all of the tree there; otherwise it shows at least what the part @p before showed.
    Camera inRoom(const Camera& camera, const QRect& before, bool showsTree) const;
    /// The camera, moved without turning until the part that bars leave free shows all of @p box, m.
    Camera framing(const Box3& box) const;

    /// @p camera, moved likewise until all of the tree is shown.
    Camera framed(const Camera& camera) const;
    /// The camera, or where it is flying to.
    Camera cameraAtRest() const;
    /// Whether the part that bars leave free shows all of the tree to @p camera.
    bool isTreeClear(const Camera& camera) const;
    /// The same, once the camera rests.
    bool isTreeClear() const { return isTreeClear(cameraAtRest()); }

    /// The context for tools of this viewport.
    ToolContext& toolContext() { return *this; }
    /// Sets the tool, after finishing the gesture of the previous one. The first tool is a BrushTool. A pen's
    /// eraser end prunes with any tool.
    void setTool(std::unique_ptr<Tool> tool);
    const Tool& tool() const { return *m_tool; }
    /// The second view, which shows the tree from the side; see ViewValues::secondViewShown.
    const SecondView& secondView() const { return m_second; }
    /// Place of the ball that moves the sun, px. SunTool gets the samples of a pointer that is on it.
    QPointF sunPlace() const;

    /// Growth is under way: the picture is not drawn in full quality until it ends.
    void setGrowing(bool growing);

    /// Whether the user types a width, or a tool keeps something of the last gesture for the next one.
    bool isBetweenGestures() const;
    /// While a tool's gesture is under way, no other code may change the document: finish the gesture before.
    /// A gesture ends by itself when its pointer is lost: another window is in front, a dialog or menu opens,
    /// the keyboard leaves the tree, the system takes the touch away.
    bool isGestureActive() const { return m_hand->isActive(); }
    /// Whether a pointer works with the tool or moves the camera.
    bool isPointerDown() const { return m_gestures.isBusy(); }
    /// Ends a tool's gesture as it stands, as one undo step.
    void finishGesture();
    /// Cancels a tool's gesture; ends a gesture that moves the camera, too.
    void cancelGesture();
    /// Passes a key to the tool, between gestures. Returns whether the tool uses it.
    bool keyForTool(int key);
    /// See Tool::takeBack().
    void takeBackInTool() { m_tool->takeBack(); }

    /// The picture of the tree, without the overlays of tools and the sun's ball.
    QImage grabPicture();
    /// Renderer and version of OpenGL, in the driver's words; empty before the first picture.
    const QString& glDescription() const { return m_glDescription; }

    /// The number of passes for a picture at rest, 1...RenderOptions::kBestSamples: fewer are ready sooner
    /// where there is no graphics card, with rougher edges.
    void setBestSamples(int samples) { m_pacer.setBestSamples(samples); }
    /// Whether nothing moves and the picture has its full quality.
    bool isAtRest() const { return m_pacer.isAtRest() && !m_pictureIsOld && !isRefining(); }

    QSize minimumSizeHint() const override { return {320, 240}; }
    QSize sizeHint() const override { return {1280, 800}; }

Q_SIGNALS:
    void cameraChanged();
    /// The pointer goes down on the tree. The tool has not looked at the tree yet.
    void toolAboutToBegin();
    void gestureActiveChanged(bool active);
    /// A click asks for a menu at @p place, px of the screen.
    void menuAsked(const QPoint& place);
    /// 2...4 fingers have tapped the tree together.
    void fingersTapped(int fingers);
    void toolChanged();

protected:
    void initializeGL() override;
    void paintGL() override;
    bool event(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void timerEvent(QTimerEvent* event) override;

private:
    // ToolContext
    const Camera& camera() const override { return m_isInSecondView ? m_second.camera() : m_camera; }
    TreeDocument& document() override { return m_document; }
    ViewSettings& viewSettings() override { return m_settings; }
    std::optional<PickedBranch> pick(const QPointF& screen, PointerDevice device) const override;
    std::optional<PickedBranch> pickThick(const QPointF& screen, PointerDevice device) const override;
    std::vector<PickedBud> pickBuds(const QPointF& screen, PointerDevice device,
                                    double factor) const override;
    float branchRadius(InternodeId id) const override { return m_scene.mesh().tracker().meshedRadius(id); }
    std::optional<InternodeId> labelAt(const QPointF& screen) const override;
    void editLabel(InternodeId subject, const QString& text,
                   std::function<bool(const QString&)> take) override;
    void requestRepaint() override { update(); }

    // GestureTarget
    void toolBegins(const PointerSample& sample) override;
    void toolMoves(const PointerSample& sample) override;
    bool isLate(const PointerSample& sample);
    void takeLate();
    void toolEnds(const PointerSample& sample) override;
    void toolIsFinished() override;
    void toolIsCancelled() override;
    void toolHovers(const PointerSample& sample) override;
    bool toolTakesFinger(const PointerSample& sample) override;
    void budIsAsked(const PointerSample& sample) override;
    void menuIsAsked(const PointerSample& sample) override
    {
        Q_EMIT menuAsked(mapToGlobal(sample.position).toPoint());
    }
    void fingersTap(int fingers) override { Q_EMIT fingersTapped(fingers); }
    void orbitBy(const QPointF& distance) override;
    void panBy(const QPointF& distance) override;
    void magnify(double factor, const QPointF& about) override;

    template <class Pick>
    auto withPickScene(Pick&& pick) const;
    double reachOf(PointerDevice device) const;
    PointerSample takeInHand(const PointerSample& sample);
    void leaveViews();
    /// @p sample as the tool in hand gets it: in the view where its gesture began.
    PointerSample inView(const PointerSample& sample) const
    {
        return m_isInSecondView ? m_second.seenFromHere(sample) : sample;
    }
    void placeSecondView();
    Box3 secondBounds() const;
    void followDocument(const TreeChange& change);
    void followSettings();
    void moveCamera(const Camera& camera);
    QPointF clearShare() const;
    template <class Frame>
    Camera inClearRect(const Camera& camera, Frame&& frame) const;
    void showAnew();
    void turn(float byAzimuth, float byElevation);
    void moveByKeys(double seconds);
    void redrawTree();
    void tick();
    bool needsTicks() const;
    bool areRingsExpanding() const;
    void startTicking();
    /// Whether passes of the picture in full quality are still to be drawn.
    bool isRefining() const
    {
        return m_pacer.isAtRest() && !m_pictureIsOld && m_passes < m_pacer.bestSamples();
    }
    void drawPicture();
    void paintSecondFrame();
    void paintLabels();
    void paintScale();
    void releaseGl();

    TreeDocument& m_document;
    ViewSettings& m_settings;
    Camera m_camera;
    QMargins m_frameMargins;
    double m_seedlingView = kDefaultSeedlingView; ///< m
    bool m_isFramed = true;     ///< The camera has not been moved since a whole tree was shown
    ViewValues m_shown;         ///< The values that the picture was drawn with
    float m_personPlace = 0.0F; ///< m to the right of the seedling; see ScaleFigure
    CameraFlight m_flight;
    PointerReader m_pointers;
    GestureReader m_gestures;
    StrokeStabiliser m_stabiliser;
    HeldKeys m_keys;
    TreeScene m_scene;
    std::unique_ptr<Tool> m_tool;
    std::unique_ptr<Tool> m_eraser; ///< Gets the samples while a pen is turned over
    std::unique_ptr<SunTool> m_sun; ///< Gets the samples while the pointer is on the sun
    Tool* m_hand;                   ///< The one of the three that gets the samples now
    SecondView m_second;
    bool m_isInSecondView = false; ///< The hand is in the second view
    Overlay m_overlay;
    Overlay m_secondOverlay; ///< The same for the second view, which does not show the sun
    QPointer<LabelEditor> m_labelEditor;

    FramePacer m_pacer;
    bool m_isGrowing = false;
    QString m_glDescription;
    bool m_pictureIsOld = true;
    int m_passes = 0; ///< Number of passes that the shown picture is the mean of
    bool m_passIsDue = false;
    QBasicTimer m_ticks;
    QBasicTimer m_restTimer;
    /// The newest sample of each pointer that the tool has not got yet, because samples come faster than it
    /// can work.
    std::vector<PointerSample> m_late;
    QBasicTimer m_lateTimer;
    double m_lastTick = 0.0;    ///< s
    double m_selectedAt = -1e9; ///< Time when the bud that alone grows was chosen, s

    std::unique_ptr<Renderer> m_renderer;
    std::unique_ptr<OverlayRenderer> m_overlayRenderer;
    std::unique_ptr<RenderTarget> m_picture;
    FrameUniforms m_frame; ///< Of the picture
};

} // namespace espalier
