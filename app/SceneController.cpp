// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/SceneController.h"

#include "app/files/DocumentFile.h"
#include "app/files/Settings.h"
#include "app/runners/Background.h"
#include "model/io/ImageFile.h"
#include "panels/BackgroundPanel.h"
#include "panels/Notice.h"

#include <QFileDialog>
#include <QImageReader>

namespace espalier {

SceneController::SceneController(const Parts& parts) : m_parts(parts)
{
    parts.panel.setLookOfNewTrees(parts.file.lookOfNewTrees());
    connect(&parts.panel, &BackgroundPanel::pictureAsked, this, &SceneController::choosePicture);
    connect(&parts.panel, &BackgroundPanel::lookForNewTreesAsked, this, &SceneController::keepForNewTrees);
    connect(&parts.document, &TreeDocument::changed, this, [this](const TreeChange& change) {
        if (change.kind == TreeChange::Kind::Reset)
            ++m_asked;
    });
}

void SceneController::choosePicture()
{
    QStringList patterns;
    for (const QByteArray& format : QImageReader::supportedImageFormats())
        patterns.append(QStringLiteral("*.") + QString::fromLatin1(format));
    auto* dialog = new QFileDialog(&m_parts.window, tr("Reference Picture"), m_parts.settings.folder(),
                                   tr("Pictures (%1)").arg(patterns.join(QLatin1Char(' '))));
    dialog->setObjectName(QStringLiteral("pictureDialog"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    connect(dialog, &QFileDialog::fileSelected, this, &SceneController::takePicture);
    dialog->open();
}

void SceneController::takePicture(const QString& fileName)
{
    runInBackground(
        this, [fileName] { return readPictureFile(fileName); },
        [this, asked = ++m_asked](const Result<ImageAsset>& image) {
            if (!image) {
                m_parts.notice.showWarning(image.error().message);
            } else if (asked == m_asked) {
                TracingImage tracing = m_parts.viewSettings.values().tracing;
                tracing.image = *image;
                m_parts.viewSettings.set(&SceneLook::tracing, tracing);
            }
            Q_EMIT pictureTaken();
        });
}

void SceneController::keepForNewTrees()
{
    const SceneLook look = withoutPicture(m_parts.viewSettings.values());
    m_parts.settings.setLookOfNewTrees(look);
    m_parts.file.setLookOfNewTrees(look);
    m_parts.panel.setLookOfNewTrees(look);
    m_parts.notice.showInformation(tr("New trees will have this background, ground and light."));
}

} // namespace espalier
