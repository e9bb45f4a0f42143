// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Error.h"
#include "views/camera/Camera.h"
#include "views/render/RenderOptions.h"
#include "views/render/TreeScene.h"

#include <QImage>

#include <memory>
#include <optional>

class QOffscreenSurface;
class QOpenGLContext;

namespace espalier {

class Renderer;
class RenderTarget;

/// Draws pictures of trees without a window. It needs a display with OpenGL 3.3 (a virtual one is enough),
/// and must be used on the GUI thread.
class OffscreenRenderer {
public:
    /// Fails with a sentence for the user if there is no OpenGL.
    static Result<std::unique_ptr<OffscreenRenderer>> create();
    ~OffscreenRenderer();

    /// A picture of the size of @p camera's view, in pixels, 1...16,384 along each edge or up to the card's
    /// limit.
    Result<QImage> render(TreeScene& scene, const Camera& camera, const RenderOptions& options);
    /// Draws one of the passes of such a picture, 0...options.samples − 1 in that order.
    Result<void> renderPass(TreeScene& scene, const Camera& camera, const RenderOptions& options, int pass);
    /// The mean of the passes drawn so far.
    QImage picture() const;

private:
    OffscreenRenderer();

    std::unique_ptr<QOpenGLContext> m_context;
    std::unique_ptr<QOffscreenSurface> m_surface;
    std::unique_ptr<Renderer> m_renderer;
    std::unique_ptr<RenderTarget> m_target;
};

/// What a picture of a whole tree looks like.
struct PictureRequest {
    QSize size{1280, 960};
    NamedView view = NamedView::Front;
    /// Used instead of the named view; its view size becomes the picture's.
    std::optional<Camera> camera;
    RenderOptions options;
};

/// The camera of that picture.
Camera cameraFor(const PictureRequest& request, const TreeScene& scene);

/// Draws the document's tree. Makes a renderer for this picture only: for many pictures keep an
/// OffscreenRenderer.
Result<QImage> renderImage(const TreeDocument& document, const PictureRequest& request = {});

/// A named view of the whole tree; a seedling is shown as in a new document.
Camera pictureCamera(NamedView view, const TreeScene& scene, const QSize& size);

} // namespace espalier
