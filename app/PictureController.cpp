// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/PictureController.h"

#include "app/files/FileController.h"
#include "app/files/FileDialogs.h"
#include "app/files/Outputs.h"
#include "app/files/Settings.h"
#include "app/runners/Background.h"
#include "panels/Notice.h"
#include "panels/PictureSheet.h"
#include "views/Viewport.h"

#include <QClipboard>
#include <QFileInfo>
#include <QGuiApplication>

namespace espalier {

namespace {

/// ms; a picture that is done sooner shows no progress
constexpr int kPicturePatience = 300;

/// The camera for a picture of that size: it shows at least all that @p shown shows.
Camera fitted(const Camera& shown, const QSizeF& size)
{
    const QSizeF before = shown.viewSize();
    const double narrower = (before.width() / before.height()) / (size.width() / size.height());
    Camera camera = shown;
    camera.setViewSize(size);
    camera.setDistance(camera.distance() * static_cast<float>(std::max(narrower, 1.0)));
    return camera;
}

NamedView namedViewOf(PictureSettings::View view)
{
    switch (view) {
    case PictureSettings::View::Side:
        return NamedView::Side;
    case PictureSettings::View::Top:
        return NamedView::Top;
    case PictureSettings::View::ThreeQuarter:
        return NamedView::ThreeQuarter;
    default:
        return NamedView::Front;
    }
}

} // namespace

PictureController::PictureController(const Parts& parts) : m_parts(parts)
{
    connect(&m_runner, &PictureRunner::progressed, this, [this](double share) {
        if (m_since.elapsed() >= kPicturePatience)
            m_parts.notice.showProgress(m_runner, tr("Drawing the picture"), share,
                                        [this] { m_runner.cancel(); });
    });
    connect(&m_runner, &PictureRunner::ended, this, [this] { m_parts.notice.finishProgress(m_runner); });
}

QSize PictureController::windowSize() const
{
    return (QSizeF(m_parts.viewport.size()) * m_parts.viewport.devicePixelRatioF()).toSize();
}

void PictureController::ask()
{
    auto* sheet = new PictureSheet(m_parts.settings.pictureSettings(), windowSize(), &m_parts.window);
    sheet->setAttribute(Qt::WA_DeleteOnClose);
    connect(sheet, &PictureSheet::saveAsked, this, [this](const PictureSettings& settings) {
        m_parts.settings.setPictureSettings(settings);
        save(settings);
    });
    connect(sheet, &PictureSheet::copyAsked, this, [this](const PictureSettings& settings) {
        m_parts.settings.setPictureSettings(settings);
        copy(settings);
    });
    sheet->open();
}

PictureRequest PictureController::requestFor(const PictureSettings& settings) const
{
    PictureRequest request;
    request.size = settings.size.isEmpty() ? windowSize() : settings.size;
    request.options.view = m_parts.viewSettings.values();
    request.options.view.tracing = {};
    if (settings.transparent) {
        request.options.background = QColor(Qt::transparent);
        request.options.view.groundShown = settings.shadow;
    }
    if (settings.view == PictureSettings::View::Shown)
        request.camera = fitted(m_parts.viewport.mainCamera(), request.size);
    else
        request.view = namedViewOf(settings.view);
    return request;
}

void PictureController::start(const PictureSettings& settings, std::function<void(const QImage&)> done)
{
    m_since.start();
    m_runner.start(m_parts.files.file().snapshot(), requestFor(settings),
                   [this, done = std::move(done)](const Result<QImage>& picture) {
                       if (picture)
                           done(*picture);
                       else
                           m_parts.notice.showWarning(picture.error().message);
                   });
}

void PictureController::copy(const PictureSettings& settings)
{
    start(settings, [this](const QImage& picture) {
        QGuiApplication::clipboard()->setImage(picture);
        m_parts.notice.showInformation(tr("The picture is on the clipboard."));
        Q_EMIT finished();
    });
}

void PictureController::save(const PictureSettings& settings)
{
    const QString name = dialogs::askForPicture(m_parts.window, m_parts.files.proposedPath());
    if (!name.isEmpty())
        saveTo(settings, name);
}

void PictureController::saveTo(const PictureSettings& settings, const QString& fileName)
{
    start(settings, [this, fileName](const QImage& picture) {
        runInBackground(
            this, [picture, fileName] { return writePicture(picture, fileName); },
            [this, fileName](const Result<void>& written) {
                if (written)
                    m_parts.notice.showInformation(tr("Saved %1").arg(QFileInfo(fileName).fileName()));
                else
                    m_parts.notice.showWarning(tr("Not saved. %1").arg(written.error().message));
                Q_EMIT finished();
            });
    });
}

} // namespace espalier
