// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/SecondView.h"

#include "views/render/OverlayRenderer.h"
#include "views/render/RenderOptions.h"
#include "views/render/Renderer.h"
#include "views/render/Sun.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace espalier {

namespace {

constexpr int kMargin = 14;          ///< px
constexpr int kLeastWidth = 150;     ///< px
constexpr int kMostWidth = 420;      ///< px
constexpr double kShare = 0.3;       ///< Of the free part's shorter side
constexpr double kProportion = 1.15; ///< Height over width
/// The side view is not shown if it would cover more than this share of the free part, along an edge.
constexpr double kMostShare = 0.5;
/// If the first view looks down more steeply than this, rad, the second one does not.
constexpr float kSteep = 0.9F;
constexpr float kRoomAround = 1.2F; ///< Room around the tree, to draw in
/// A first view that is nearer than this share of the distance that shows all looks at a part of the tree.
constexpr float kClose = 0.5F;

} // namespace

QRect SecondView::placeIn(const QRect& clear)
{
    const int width = std::clamp(static_cast<int>(kShare * std::min(clear.width(), clear.height())),
                                 kLeastWidth, kMostWidth);
    const int height = static_cast<int>(kProportion * width);
    const bool hasRoom = width + 2 * kMargin <= kMostShare * clear.width() &&
                         height + 2 * kMargin <= kMostShare * clear.height();
    return hasRoom ? QRect(clear.right() + 1 - kMargin - width, clear.bottom() + 1 - kMargin - height, width,
                           height)
                   : QRect();
}

void SecondView::follow(const Camera& main, const QRect& clear, const QRect& place, const Box3& bounds)
{
    m_rect = place;
    if (!isShown())
        return;
    m_camera = main;
    m_isFromTheFront = std::abs(main.elevation()) > kSteep;
    if (m_isFromTheFront)
        m_camera.setElevation(0.0F);
    else
        m_camera.setAzimuth(main.azimuth() + std::numbers::pi_v<float> / 2.0F);
    m_camera.setTargetShare({0.5, 0.5});
    m_camera.setViewSize(m_rect.size());
    // As much of the world from top to bottom as the free part of the first view shows.
    m_camera.setDistance(main.distance() * static_cast<float>(clear.height()) /
                         static_cast<float>(main.viewSize().height()));
    if (bounds.isEmpty())
        return;
    Camera whole = m_camera.framing(bounds);
    whole.setDistance(kRoomAround * whole.distance());
    if (m_camera.distance() > kClose * whole.distance())
        m_camera = whole;
}

PointerSample SecondView::seenFromHere(PointerSample sample) const
{
    const QPointF place = sample.position - QPointF(m_rect.topLeft());
    sample.position = {std::clamp(place.x(), 0.0, static_cast<double>(m_rect.width())),
                       std::clamp(place.y(), 0.0, static_cast<double>(m_rect.height()))};
    return sample;
}

void SecondView::drawPass(Renderer& renderer, TreeScene& scene, RenderOptions options, const Camera& main,
                          double pixelRatio, int pass)
{
    if (!m_picture)
        m_picture.emplace(renderer.gl());
    // The sun must not turn with this camera, and the picture to draw after belongs to the first view.
    pinSun(options.view, main, true);
    options.view.tracing = {};
    options.keepsShadows = true;
    options.isSecond = true;
    Camera camera = m_camera;
    const QSizeF pixels = QSizeF(m_rect.size()) * pixelRatio;
    camera.setViewSize({std::round(pixels.width()), std::round(pixels.height())});
    renderer.renderPass(scene, camera, options, *m_picture, pass);
    m_frame = renderer.frame();
}

void SecondView::show(Gl& gl, Renderer& renderer, OverlayRenderer& overlays, const Overlay& overlay,
                      GLuint target, int height, double pixelRatio) const
{
    const QSize from = m_picture->size();
    // OpenGL counts from the lower edge.
    const QRect to((QPointF(m_rect.left(), height - m_rect.bottom() - 1) * pixelRatio).toPoint(),
                   (QSizeF(m_rect.size()) * pixelRatio).toSize());
    gl.glBindFramebuffer(GL_READ_FRAMEBUFFER, m_picture->framebuffer());
    gl.glBindFramebuffer(GL_DRAW_FRAMEBUFFER, target);
    gl.glBlitFramebuffer(0, 0, from.width(), from.height(), to.left(), to.top(), to.left() + to.width(),
                         to.top() + to.height(), GL_COLOR_BUFFER_BIT,
                         from == to.size() ? GL_NEAREST : GL_LINEAR);
    gl.glBindFramebuffer(GL_FRAMEBUFFER, target);
    renderer.bindFrame(m_frame);
    overlays.render(overlay, m_camera, m_picture->depthTexture(), to, pixelRatio);
}

} // namespace espalier
