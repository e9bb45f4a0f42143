// SPDX-License-Identifier: GPL-3.0-or-later
// The part of Viewport that draws.
#include "views/LabelEditor.h"
#include "views/Viewport.h"
#include "views/render/LabelLayout.h"
#include "views/render/OverlayRenderer.h"
#include "views/render/RenderTarget.h"
#include "views/render/Renderer.h"
#include "views/render/ScaleFigure.h"
#include "views/tools/SelectionRings.h"
#include "views/tools/SunTool.h"

#include <QElapsedTimer>
#include <QOpenGLContext>
#include <QPainter>
#include <QTimer>

#include <algorithm>
#include <cmath>

namespace espalier {

namespace {

/// A young tree's wood is drawn this much thicker on each side, px, so that the hand finds it; an old tree's
/// has a width of its own.
float boldnessOf(std::uint32_t internodes)
{
    constexpr float kMost = 1.0F;
    constexpr float kNone = 1500.0F; // internodes
    return kMost * std::max(0.0F, 1.0F - static_cast<float>(internodes) / kNone);
}

} // namespace

void Viewport::initializeGL()
{
    Gl* gl = currentGl();
    if (gl == nullptr)
        qFatal("This program needs OpenGL 3.3");
    const auto words = [gl](GLenum name) {
        return QString::fromLatin1(reinterpret_cast<const char*>(gl->glGetString(name)));
    };
    m_glDescription = QStringLiteral("%1, OpenGL %2").arg(words(GL_RENDERER), words(GL_VERSION));
    m_renderer = std::make_unique<Renderer>(*gl);
    m_overlayRenderer = std::make_unique<OverlayRenderer>(*gl);
    m_picture = std::make_unique<RenderTarget>(*gl);
    m_pictureIsOld = true;
    // A move to another window creates another context.
    connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &Viewport::releaseGl, Qt::UniqueConnection);
}

QImage Viewport::grabPicture()
{
    if (!m_isGrowing) {
        m_scene.prepare();
        m_scene.prepareStrands();
        redrawTree();
    }
    grabFramebuffer(); // draws pending changes
    makeCurrent();
    QImage picture = m_picture->readImage();
    doneCurrent();
    return picture;
}

void Viewport::releaseGl()
{
    if (!m_renderer)
        return;
    makeCurrent();
    m_picture.reset();
    m_second.releaseGl();
    m_overlayRenderer.reset();
    m_renderer.reset();
    doneCurrent();
}

void Viewport::drawPicture()
{
    RenderOptions options;
    options.view = m_settings.values();
    options.boldness = boldnessOf(m_document.index().livingCount());
    m_pacer.apply(options);
    Camera camera = m_camera;
    const QSizeF pixels = QSizeF(size()) * devicePixelRatioF() * m_pacer.scale();
    camera.setViewSize({std::round(pixels.width()), std::round(pixels.height())});
    Gl& gl = *currentGl();
    QElapsedTimer timer;
    timer.start();
    if (m_pictureIsOld)
        m_passes = 0;
    m_renderer->renderPass(m_scene, camera, options, *m_picture, m_passes);
    // Only after a frame is finished is its time known. Waiting also keeps input from running ahead of the
    // picture.
    gl.glFinish();
    m_frame = m_renderer->frame();
    const double now = m_pointers.now();
    if (m_second.isShown() && (m_pacer.isAtRest() ? m_passes < SecondView::kSamples
                                                  : m_second.isDue(now) || !m_second.hasPicture())) {
        // The scene has its bounds only now. A gesture in it goes on with the camera that it began with.
        if (!isGestureActive() || !m_isInSecondView)
            m_second.follow(m_camera, clearRect(), m_second.rect(), secondBounds());
        m_second.drawPass(*m_renderer, m_scene, options, m_camera, devicePixelRatioF() * m_pacer.scale(),
                          m_passes);
        m_second.setDrawnAt(now);
        gl.glFinish();
    }
    m_pacer.frameTook(static_cast<double>(timer.nsecsElapsed()) * 1e-9);
    m_pictureIsOld = false;
    m_passIsDue = false;
    ++m_passes;
    startTicking();
}

void Viewport::paintGL()
{
    if (m_pictureIsOld || (m_passIsDue && isRefining()))
        drawPicture();
    Gl& gl = *currentGl();
    const GLuint widgetBuffer = defaultFramebufferObject();
    const QSize from = m_picture->size();
    const QSize to = (QSizeF(size()) * devicePixelRatioF()).toSize();
    gl.glBindFramebuffer(GL_READ_FRAMEBUFFER, m_picture->framebuffer());
    gl.glBindFramebuffer(GL_DRAW_FRAMEBUFFER, widgetBuffer);
    gl.glBlitFramebuffer(0, 0, from.width(), from.height(), 0, 0, to.width(), to.height(),
                         GL_COLOR_BUFFER_BIT, from == to ? GL_NEAREST : GL_LINEAR);
    gl.glBindFramebuffer(GL_FRAMEBUFFER, widgetBuffer);
    m_overlay.clear();
    m_hand->paint(m_overlay);
    if (m_document.index().livingCount() <= 1) {
        // A seedling may be smaller than a pixel.
        const Vec3 root = m_document.tree().rootPosition(0);
        const float radius = 12.0F / m_camera.pixelsPerMetre(std::max(m_camera.depth(root), 0.1F));
        m_overlay.addCircle(root, Vec3::UnitX(), Vec3::UnitZ(), radius, QColor(150, 160, 150, 150), 1.4F);
    }
    if (const Competitors& only = m_document.competitors(); !only.areAll()) {
        const BudRef bud{only.node, only.slot};
        const Vec3 place = budPosition(m_document.tree(), m_document.index(), bud, branchRadius(only.node));
        paintSelectionRings(m_overlay, m_camera, place, m_pointers.now() - m_selectedAt);
    }
    if (!m_second.isShown())
        m_second.releaseGl();
    const bool showsSecond = m_second.hasPicture();
    if (showsSecond)
        m_secondOverlay = m_overlay;
    if (m_hand != m_sun.get())
        m_sun->paint(m_overlay);
    m_renderer->bindFrame(m_frame);
    m_overlayRenderer->render(m_overlay, m_camera, m_picture->depthTexture(), QRect(QPoint(), to),
                              devicePixelRatioF());
    paintScale();
    if (showsSecond) {
        gl.glBindFramebuffer(GL_FRAMEBUFFER, widgetBuffer);
        m_second.show(gl, *m_renderer, *m_overlayRenderer, m_secondOverlay, widgetBuffer, height(),
                      devicePixelRatioF());
        paintSecondFrame();
    }
    paintLabels();
}

void Viewport::paintScale()
{
    if (!m_settings.values().personShown)
        return;
    if (!isGestureActive())
        m_personPlace = personPlace(m_scene.bounds());
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const bool isOverLight = isBackdropLight(m_settings.values());
    paintPerson(painter, m_camera, m_personPlace, isOverLight);
    QRect beside = clearRect();
    if (m_second.isShown())
        beside.setRight(m_second.rect().left());
    paintScaleBar(painter, m_camera, beside, isOverLight);
}

/// The second view's edge and its name.
void Viewport::paintSecondFrame()
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const bool isOverLight = isBackdropLight(m_settings.values());
    const QColor edge = isOverLight ? QColor(0, 0, 0, 110) : QColor(255, 255, 255, 110);
    const QRectF frame = QRectF(m_second.rect()).adjusted(-0.5, -0.5, 0.5, 0.5);
    painter.setPen(QPen(edge, m_isInSecondView ? 2.0 : 1.0));
    painter.drawRoundedRect(frame, 3.0, 3.0);
    painter.setPen(isOverLight ? QColor(0, 0, 0, 190) : QColor(255, 255, 255, 190));
    painter.drawText(frame.adjusted(8.0, 6.0, -8.0, -6.0), Qt::AlignTop | Qt::AlignLeft,
                     m_second.isFromTheFront() ? tr("From the front") : tr("From the right"));
}

void Viewport::paintLabels()
{
    if (m_overlay.labels().empty())
        return;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setClipRegion(QRegion(rect()) - m_second.rect());
    const std::vector<QRectF> boxes = labelBoxes(m_overlay, m_camera, QFontMetricsF(font()));
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        if (boxes[i].isNull())
            continue;
        const Overlay::Label& label = m_overlay.labels()[i];
        painter.setPen(Qt::NoPen);
        painter.setBrush(QColor(24, 27, 32, 200));
        painter.drawRoundedRect(boxes[i], 5.0, 5.0);
        painter.setPen(label.colour);
        painter.drawText(boxes[i], Qt::AlignCenter, label.text);
    }
}

std::optional<InternodeId> Viewport::labelAt(const QPointF& screen) const
{
    if (m_isInSecondView)
        return std::nullopt;
    const std::vector<QRectF> boxes = labelBoxes(m_overlay, m_camera, QFontMetricsF(font()));
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        if (boxes[i].contains(screen) && m_overlay.labels()[i].subject)
            return m_overlay.labels()[i].subject;
    }
    return std::nullopt;
}

void Viewport::editLabel(InternodeId subject, const QString& text, std::function<bool(const QString&)> take)
{
    const std::vector<QRectF> boxes = labelBoxes(m_overlay, m_camera, QFontMetricsF(font()));
    const auto label = std::ranges::find(m_overlay.labels(), subject, &Overlay::Label::subject);
    if (label == m_overlay.labels().end())
        return;
    const QRectF box = boxes[static_cast<std::size_t>(label - m_overlay.labels().begin())];
    // The field takes the focus, which would end the gesture that asks for it.
    QTimer::singleShot(0, this, [this, box, text, take = std::move(take)] {
        delete m_labelEditor;
        m_labelEditor = new LabelEditor(box, text, take, this);
    });
}

} // namespace espalier
