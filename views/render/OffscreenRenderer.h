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

/// Draws pictures of trees without a window. It needs a display that offers OpenGL 3.3 (a virtual one will
/// do), and belongs to the GUI thread.
class OffscreenRenderer {
public:
    /// Fails, in words for a person, where there is no OpenGL.
    static Result<std::unique_ptr<OffscreenRenderer>> create();
    ~OffscreenRenderer();

    /// A picture as large as @p camera's view, in pixels, 1...16,384 along each edge or what the card can do.
    Result<QImage> render(TreeScene& scene, const Camera& camera, const RenderOptions& options);

private:
    OffscreenRenderer();

    std::unique_ptr<QOpenGLContext> m_context;
    std::unique_ptr<QOffscreenSurface> m_surface;
    std::unique_ptr<Renderer> m_renderer;
    std::unique_ptr<RenderTarget> m_target;
};

/// What a picture of a whole tree shall be.
struct PictureRequest {
    QSize size{1280, 960};
    NamedView view = NamedView::Front;
    /// Takes the place of the view; its view size becomes the picture's.
    std::optional<Camera> camera;
    RenderOptions options;
};

/// Draws the document's tree. Makes what it needs and throws it away: for many pictures keep an
/// OffscreenRenderer.
Result<QImage> renderImage(const TreeDocument& document, const PictureRequest& request = {});

/// The front view and so on of the whole tree; of a seedling, as a new document shows it.
Camera pictureCamera(NamedView view, const TreeScene& scene, const QSize& size);

} // namespace espalier
