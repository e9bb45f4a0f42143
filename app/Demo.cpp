// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/Demo.h"

#include "app/MainWindow.h"
#include "app/cli/BatchJob.h"
#include "app/files/Outputs.h"
#include "views/render/OffscreenRenderer.h"

#include <QDir>

#include <cstdio>

namespace espalier {

namespace {

const QString kDemoName = QStringLiteral("first-tree");

Result<QStringList> writeAll(MainWindow& window, const QString& view)
{
    QStringList written;
    const TreeDocument& document = window.document();
    Project project = window.files().file().snapshot();
    project.name = kDemoName;
    for (const char* suffix : {".espalier", ".fbx", ".obj", ".glb"}) {
        const QString fileName = kDemoName + QLatin1String(suffix);
        if (const Result<void> result = writeOutput(project, fileName); !result)
            return result.error();
        written.append(fileName);
    }
    PictureRequest request;
    request.view = namedView(view);
    const Result<QImage> picture = renderImage(document, request);
    if (!picture)
        return picture.error();
    if (const Result<void> result = writePicture(*picture, kDemoName + QStringLiteral(".png")); !result)
        return result.error();
    written.append(kDemoName + QStringLiteral(".png"));
    return written;
}

} // namespace

void demonstrateUnseen(MainWindow& window, const Recipe& recipe)
{
    QObject::connect(
        &window.recipeRunner(), &RecipeRunner::finished, &window, [&window, view = recipe.camera.view] {
            const Result<QStringList> written = writeAll(window, view);
            if (!written)
                complain(written.error().message);
            else
                std::printf(
                    "There is no display, so the tree was brushed on a virtual one. Written to %s: %s\n",
                    qPrintable(QDir::currentPath()), qPrintable(written->join(QStringLiteral(", "))));
            // The tree is in files now, and no user is there to answer a question about unsaved changes.
            window.files().file().setUnmodified();
            QCoreApplication::exit(written ? kDone : kOutputNotWritten);
        });
    window.playRecipe(recipe, RecipeRunner::Pace::Hurried);
}

} // namespace espalier
