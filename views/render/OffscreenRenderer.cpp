// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/render/OffscreenRenderer.h"

#include "views/render/RenderTarget.h"
#include "views/render/Renderer.h"

#include <QCoreApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>

#include <algorithm>

namespace espalier {

namespace {

constexpr int kLargestEdge = 16384;

Error noOpenGl()
{
    return {Error::Kind::Output,
            QCoreApplication::translate("OffscreenRenderer",
                                        "A picture cannot be drawn, because there is no display that "
                                        "offers OpenGL 3.3; a virtual one (Xvfb) will do.")};
}

} // namespace

OffscreenRenderer::OffscreenRenderer()
    : m_context(std::make_unique<QOpenGLContext>()), m_surface(std::make_unique<QOffscreenSurface>())
{
}

OffscreenRenderer::~OffscreenRenderer()
{
    if (m_context->isValid() && m_context->makeCurrent(m_surface.get())) {
        m_target.reset();
        m_renderer.reset();
        m_context->doneCurrent();
    }
}

Result<std::unique_ptr<OffscreenRenderer>> OffscreenRenderer::create()
{
    std::unique_ptr<OffscreenRenderer> made(new OffscreenRenderer);
    made->m_context->setFormat(surfaceFormat());
    if (!made->m_context->create())
        return noOpenGl();
    made->m_surface->setFormat(made->m_context->format());
    made->m_surface->create();
    if (!made->m_surface->isValid() || !made->m_context->makeCurrent(made->m_surface.get()))
        return noOpenGl();
    Gl* gl = currentGl();
    if (gl == nullptr)
        return noOpenGl();
    made->m_renderer = std::make_unique<Renderer>(*gl);
    made->m_target = std::make_unique<RenderTarget>(*gl);
    return made;
}

Result<QImage> OffscreenRenderer::render(TreeScene& scene, const Camera& camera, const RenderOptions& options)
{
    for (int pass = 0; pass < options.samples; ++pass) {
        if (const Result<void> drawn = renderPass(scene, camera, options, pass); !drawn)
            return drawn.error();
    }
    return picture();
}

QImage OffscreenRenderer::picture() const
{
    m_context->makeCurrent(m_surface.get());
    return m_target->readImage();
}

Result<void> OffscreenRenderer::renderPass(TreeScene& scene, const Camera& camera,
                                           const RenderOptions& options, int pass)
{
    if (!m_context->makeCurrent(m_surface.get()))
        return noOpenGl();
    GLint largest = 0;
    currentGl()->glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &largest);
    largest = std::min(largest, kLargestEdge);
    const QSize size = camera.viewSize().toSize();
    if (size.width() > largest || size.height() > largest) {
        return Error{Error::Kind::Output,
                     QCoreApplication::translate("OffscreenRenderer",
                                                 "A picture of %1 × %2 pixels is too large; %3 "
                                                 "along an edge is the most.")
                         .arg(size.width())
                         .arg(size.height())
                         .arg(largest)};
    }
    m_renderer->renderPass(scene, camera, options, *m_target, pass);
    return {};
}

Camera cameraFor(const PictureRequest& request, const TreeScene& scene)
{
    Camera camera = request.camera.value_or(pictureCamera(request.view, scene, request.size));
    camera.setViewSize(request.size);
    return camera;
}

Camera pictureCamera(NamedView view, const TreeScene& scene, const QSize& size)
{
    Camera camera;
    camera.setViewSize(size);
    camera = camera.turnedTo(view);
    const std::vector<Vec3> outline = scene.outline();
    constexpr std::size_t kSeedling = 2; // its node and its base
    return outline.size() > kSeedling ? camera.framing(outline) : camera;
}

Result<QImage> renderImage(const TreeDocument& document, const PictureRequest& request)
{
    auto renderer = OffscreenRenderer::create();
    if (!renderer)
        return renderer.error();
    TreeScene scene(document);
    scene.setFibresShown(request.options.view.fibresShown);
    scene.prepareStrands();
    return (*renderer)->render(scene, cameraFor(request, scene), request.options);
}

} // namespace espalier
