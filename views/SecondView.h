// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/camera/Camera.h"
#include "views/input/PointerSample.h"
#include "views/render/FrameUniforms.h"
#include "views/render/RenderTarget.h"

#include <QRect>

#include <optional>

namespace espalier {

class Overlay;
class OverlayRenderer;
class Renderer;
class TreeScene;
struct RenderOptions;

/// A small second view in the lower right corner of a viewport: the same tree, whole, from the right; from
/// the front while the first view looks down at it. What is drawn in it has depth in the first view. It is
/// drawn with the viewport's renderer, in the same context.
class SecondView {
public:
    /// The number of passes for a picture at rest.
    static constexpr int kSamples = 4;

    /// Where it is in the part @p clear of the viewport, px; empty if there is no room.
    static QRect placeIn(const QRect& clear);
    /// Shows what the viewport's camera @p main sees in the part @p clear, at @p place (px); nothing if that
    /// is empty. Unless that camera is close to a part of it, all of @p bounds, m, is shown.
    void follow(const Camera& main, const QRect& clear, const QRect& place, const Box3& bounds);
    bool isFromTheFront() const { return m_isFromTheFront; }
    bool isShown() const { return !m_rect.isEmpty(); }
    /// In the viewport, px; empty if it is not shown.
    const QRect& rect() const { return m_rect; }
    const Camera& camera() const { return m_camera; }
    bool isAt(const QPointF& place) const { return isShown() && QRectF(m_rect).contains(place); }
    /// @p sample with its position in this view; it does not leave it.
    PointerSample seenFromHere(PointerSample sample) const;

    /// Draws a pass of the tree's picture, as Renderer::renderPass(). The scene, its shadows and its detail
    /// stay those of the picture of @p main, which was drawn just before.
    void drawPass(Renderer& renderer, TreeScene& scene, RenderOptions options, const Camera& main,
                  double pixelRatio, int pass);
    /// Whether there is a picture.
    bool hasPicture() const { return m_picture.has_value(); }
    /// Whether the picture was last drawn so long ago that it may be drawn again while things move; @p now
    /// in s.
    bool isDue(double now) const { return now - m_drawnAt >= kInterval; }
    void setDrawnAt(double now) { m_drawnAt = now; }
    /// Shows the picture, and over it the shapes in @p overlay, in the bound framebuffer of a viewport
    /// @p height px high, which must be @p target.
    void show(Gl& gl, Renderer& renderer, OverlayRenderer& overlays, const Overlay& overlay, GLuint target,
              int height, double pixelRatio) const;
    void releaseGl() { m_picture.reset(); }

private:
    /// Time between two pictures while something moves, s.
    static constexpr double kInterval = 0.12;

    QRect m_rect;
    bool m_isFromTheFront = false;
    Camera m_camera;
    std::optional<RenderTarget> m_picture;
    FrameUniforms m_frame; ///< Of the picture
    double m_drawnAt = -1e9;
};

} // namespace espalier
