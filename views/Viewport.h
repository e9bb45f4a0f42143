// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/camera/CameraFlight.h"
#include "views/input/GestureReader.h"
#include "views/input/HeldKeys.h"
#include "views/input/PointerReader.h"
#include "views/render/FramePacer.h"
#include "views/render/RenderOptions.h"
#include "views/render/TreeScene.h"
#include "views/tools/Tool.h"

#include <QBasicTimer>
#include <QMargins>
#include <QOpenGLWidget>

#include <memory>

namespace espalier {

class OverlayRenderer;
class Renderer;
class RenderTarget;
class SunTool;

/// Shows a document's tree, and lets a hand work on it with a tool or turn it about. While something moves
/// it draws plainly and fast; when all has come to rest it draws well. The picture of the tree is kept, so
/// that what a tool shows over it costs nothing to move.
class Viewport : public QOpenGLWidget, private ToolContext, private GestureTarget {
    Q_OBJECT

public:
    /// Both outlive it.
    Viewport(TreeDocument& document, ViewSettings& settings, QWidget* parent = nullptr);
    /// Cancels a gesture under way.
    ~Viewport() override;

    /// See TreeScene::expect().
    void expect(PreparedScene scene) { m_scene.expect(std::move(scene)); }

    const Camera& camera() const override { return m_camera; }
    /// At once; ends a flight. The view size is the viewport's own.
    void setCamera(const Camera& camera);
    /// Moves there smoothly.
    void flyTo(const Camera& camera);
    /// Flies to where the whole tree is seen; a seedling is shown as a new document shows it.
    void frameAll();
    /// Flies to a view from another side of the whole tree.
    void showFrom(NamedView view);

    /// Of the rotation strip at the bottom edge, px.
    static constexpr int kStripHeight = 36;

    /// What bars over the viewport cover, px: whole trees are framed in the rest of it from now on.
    void setMouseScheme(MouseScheme scheme) { m_gestures.setScheme(scheme); }
    /// See PointerReader::setPressureExponent.
    void setPressureExponent(double exponent) { m_pointers.setPressureExponent(exponent); }
    void setFrameMargins(const QMargins& margins) { m_frameMargins = margins; }
    /// What bars leave of it, px.
    QRect clearRect() const { return rect().marginsRemoved(m_frameMargins); }
    /// The camera, moved back or near until it shows all of the box, m, in what bars leave.
    Camera framing(const Box3& box) const;

    /// What a tool for this viewport is made with.
    ToolContext& toolContext() { return *this; }
    /// Ends the gesture of the tool before as it stands. At first there is a BrushTool. A pen's eraser end
    /// prunes, whatever the tool.
    void setTool(std::unique_ptr<Tool> tool);
    const Tool& tool() const { return *m_tool; }
    /// Where the ball is that moves the sun, px; it is in hand while the pointer is on it.
    QPointF sunPlace() const;

    /// Something goes on that changes the tree again and again: it is not drawn at its best until that ends.
    void setGrowing(bool growing);

    /// While a tool's gesture is under way, the document must not be changed from elsewhere: end it before.
    /// A gesture ends by itself where its pointer is lost: another window is in front, a dialog or menu
    /// opens, the keyboard leaves the tree, the system takes the touch away.
    bool isGestureActive() const { return m_hand->isActive(); }
    /// Ends a tool's gesture as it stands, as one undo step.
    void finishGesture();
    /// Takes it back; ends a gesture that moves the camera, too.
    void cancelGesture();
    /// A key for the tool, between gestures; whether it meant something to it.
    bool keyForTool(int key);

    /// What it shows of the tree, without what tools and the sun's ball show over it.
    QImage grabPicture();

    /// Whether nothing moves and the picture is as good as it gets.
    bool isAtRest() const { return m_pacer.isAtRest() && !m_pictureIsOld && !isRefining(); }

    QSize minimumSizeHint() const override { return {320, 240}; }
    QSize sizeHint() const override { return {1280, 800}; }

Q_SIGNALS:
    void cameraChanged();
    /// The pointer goes down on the tree. The tool has not looked at the tree yet.
    void toolAboutToBegin();
    void gestureActiveChanged(bool active);
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
    // What tools see
    TreeDocument& document() override { return m_document; }
    ViewSettings& viewSettings() override { return m_settings; }
    std::optional<PickedBranch> pick(const QPointF& screen, PointerDevice device) const override;
    std::vector<PickedBud> pickBuds(const QPointF& screen, PointerDevice device,
                                    double factor) const override;
    float branchRadius(InternodeId id) const override { return m_scene.mesh().tracker().meshedRadius(id); }
    void requestRepaint() override { update(); }

    // What gestures ask for
    void toolBegins(const PointerSample& sample) override;
    void toolMoves(const PointerSample& sample) override;
    void toolEnds(const PointerSample& sample) override;
    void toolIsFinished() override;
    void toolIsCancelled() override;
    void toolHovers(const PointerSample& sample) override;
    bool toolTakesFinger(const PointerSample& sample) override { return m_hand->takesFinger(sample); }
    void budIsAsked(const PointerSample& sample) override;
    void orbitBy(const QPointF& distance) override;
    void panBy(const QPointF& distance) override;
    void magnify(double factor, const QPointF& about) override;

    template <class Pick>
    auto withPickScene(Pick&& pick) const;
    double reachOf(PointerDevice device) const;
    void takeInHand(const PointerSample& sample);
    void followDocument(const TreeChange& change);
    void followSettings();
    void moveCamera(const Camera& camera);
    template <class Frame>
    Camera inClearRect(const Camera& camera, Frame&& frame) const;
    Camera framed(const Camera& camera) const;
    void showAnew();
    void moveByKeys(double seconds);
    void redrawTree();
    void tick();
    bool needsTicks() const;
    bool areRingsExpanding() const;
    void startTicking();
    /// Whether passes of the picture at its best are still to be drawn.
    bool isRefining() const
    {
        return m_pacer.isAtRest() && !m_pictureIsOld && m_passes < RenderOptions::kBestSamples;
    }
    void drawPicture();
    void paintLabels();
    void releaseGl();

    TreeDocument& m_document;
    ViewSettings& m_settings;
    Camera m_camera;
    QMargins m_frameMargins;
    bool m_isFramed = true; ///< Nobody has moved the camera since a whole tree was shown
    ViewValues m_shown;     ///< What the picture shows
    CameraFlight m_flight;
    PointerReader m_pointers;
    GestureReader m_gestures;
    HeldKeys m_keys;
    TreeScene m_scene;
    std::unique_ptr<Tool> m_tool;
    std::unique_ptr<Tool> m_eraser; ///< In hand while a pen is turned over
    std::unique_ptr<SunTool> m_sun; ///< In hand while the pointer is on the sun
    Tool* m_hand;                   ///< The one of the three that samples go to
    Overlay m_overlay;

    FramePacer m_pacer;
    bool m_isGrowing = false;
    bool m_pictureIsOld = true;
    int m_passes = 0; ///< That the picture shown is the mean of
    bool m_passIsDue = false;
    QBasicTimer m_ticks;
    QBasicTimer m_restTimer;
    double m_lastTick = 0.0;    ///< s
    double m_selectedAt = -1e9; ///< s, when the bud that alone grows was chosen

    std::unique_ptr<Renderer> m_renderer;
    std::unique_ptr<OverlayRenderer> m_overlayRenderer;
    std::unique_ptr<RenderTarget> m_picture;
};

} // namespace espalier
