// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/FileController.h"
#include "app/files/FileDialogs.h"
#include "app/files/Outputs.h"
#include "app/runners/Background.h"
#include "panels/Notice.h"

#include <QFileInfo>

namespace espalier {

void FileController::saveAsRecipe()
{
    if (const QString name = dialogs::askForRecipe(m_window, proposedPath()); !name.isEmpty())
        saveRecipeTo(name);
}

void FileController::saveRecipeTo(const QString& fileName)
{
    m_document.interruptEdit();
    rememberFolder(fileName);
    runInBackground(
        this, [project = m_file.snapshot(), fileName] { return writeRecipeOf(project, fileName); },
        [this, shortName = QFileInfo(fileName).fileName()](const Result<void>& written) {
            if (written)
                m_notice->showInformation(tr("Saved %1").arg(shortName));
            else
                warn(tr("Not saved. %1").arg(written.error().message));
        });
}

} // namespace espalier
