// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/LookController.h"

#include "app/files/Settings.h"
#include "app/runners/Background.h"
#include "commands/ParameterGesture.h"
#include "model/io/ImageFile.h"
#include "model/texture/OwnTextures.h"
#include "panels/Notice.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QTimer>

namespace espalier {

namespace {

constexpr int kPatience = 100; ///< ms between two checks whether the document is free

/// Another image of a bark; null if there is no file of it or the file cannot be read.
ImageAsset companion(const QString& fileName)
{
    if (fileName.isEmpty())
        return {};
    const Result<ImageAsset> image = readImageFile(fileName);
    return image ? *image : ImageAsset();
}

} // namespace

/// The content of an image file.
struct LookController::Look {
    LookKind kind = LookKind::Leaf;
    ImageAsset image{};
    double aspect = 1.0; ///< Of a leaf
    ImageAsset normal{};
    ImageAsset roughness{};
};

LookController::LookController(TreeDocument& document, Settings& settings, Notice& notice,
                               std::function<bool()> isBusy, QWidget& window)
    : m_document(document),
      m_settings(settings),
      m_notice(notice),
      m_isBusy(std::move(isBusy)),
      m_window(window)
{
}

void LookController::choose(LookKind kind)
{
    auto* dialog =
        new QFileDialog(&m_window, kind == LookKind::Leaf ? tr("Image of a Leaf") : tr("Image of Bark"),
                        m_settings.folder(), tr("Images (*.png *.jpg *.jpeg)"));
    dialog->setObjectName(QStringLiteral("imageDialog"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    connect(dialog, &QFileDialog::fileSelected, this,
            [this, kind](const QString& fileName) { take(kind, fileName); });
    dialog->open();
}

void LookController::askAndTake(const QString& fileName)
{
    m_notice.ask(tr("What is %1 for?").arg(QFileInfo(fileName).fileName()),
                 {tr("Leaves"), tr("Bark"), tr("Reference Picture")}, [this, fileName](int chosen) {
                     if (chosen == 2)
                         Q_EMIT pictureDropped(fileName);
                     else
                         take(chosen == 0 ? LookKind::Leaf : LookKind::Bark, fileName);
                 });
}

Result<LookController::Look> LookController::read(LookKind kind, const QString& fileName)
{
    const Result<ImageAsset> image = readImageFile(fileName);
    if (!image)
        return image.error();
    Look look{.kind = kind, .image = *image};
    if (kind == LookKind::Leaf) {
        const std::optional<double> aspect = ownLeafAspect(*image);
        if (!aspect)
            return Error{Error::Kind::Input, noLeafIn(*image)};
        look.aspect = *aspect;
        return look;
    }
    const MaterialFiles files = findMaterialFiles(fileName);
    look.normal = companion(files.normal);
    look.roughness = companion(files.roughness);
    return look;
}

void LookController::take(LookKind kind, const QString& fileName)
{
    runInBackground(
        this, [kind, fileName] { return read(kind, fileName); },
        [this](const Result<Look>& look) {
            if (look) {
                putInForce(*look);
                return;
            }
            m_notice.showWarning(look.error().message);
            Q_EMIT taken();
        });
}

void LookController::putInForce(const Look& look)
{
    if (m_isBusy()) {
        QTimer::singleShot(kPatience, this, [this, look] { putInForce(look); });
        return;
    }
    TreeParameters parameters = m_document.parameters();
    if (look.kind == LookKind::Leaf) {
        adoptImage(parameters.leaves, look.image, look.aspect);
    } else {
        parameters.bark.image = look.image;
        parameters.bark.normalImage = look.normal;
        parameters.bark.roughnessImage = look.roughness;
    }
    ParameterGesture gesture(m_document);
    const bool hadRoom =
        gesture.tryOut(parameters, look.kind == LookKind::Leaf ? tr("Image of a Leaf") : tr("Image of Bark"));
    gesture.finish();
    if (!hadRoom)
        m_notice.showWarning(
            tr("This tree has had so many images that its file has no room for another one."));
    else if (look.normal.isNull() && look.roughness.isNull())
        m_notice.finish();
    else
        m_notice.showInformation(tr("Maps found beside it are used, too."));
    Q_EMIT taken();
}

} // namespace espalier
