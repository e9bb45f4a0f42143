// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/export/Exporter.h"

#include "model/io/JsonReader.h"
#include "model/io/export/ExportText.h"

#include <QFileInfo>

namespace espalier {

Result<ExportFiles> prepareExport(const Tree& tree, const TreeIndex& index, const QString& name,
                                  const QString& fileName, const ExportOptions& options,
                                  const Progress& progress, const QStringList& others)
{
    const ExportFormat* const format = exportFormatOf(fileName);
    if (format == nullptr) {
        const QFileInfo file(fileName);
        return Error{Error::Kind::Output,
                     inputError(file.fileName(),
                                ExportText::tr("“.%1” is not an export format; the formats are %2")
                                    .arg(file.suffix().toLower(), exportSuffixes().join(QLatin1String(", "))))
                         .message};
    }
    const auto goesOn = [&](double done) { return !progress || progress(done); };
    const Error cancelled{Error::Kind::Cancelled, ExportText::tr("The export was cancelled.")};

    if (!goesOn(0.0))
        return cancelled;
    const ExportScene scene = buildExportScene(tree, index, name, options, format->parts());
    if (!goesOn(0.3))
        return cancelled;
    ExportFiles files(fileName, others);
    if (const Result<void> written = format->write(scene, files); !written)
        return written.error();
    if (!goesOn(0.95))
        return cancelled;
    return files;
}

Result<void> exportTree(const Tree& tree, const TreeIndex& index, const QString& name,
                        const QString& fileName, const ExportOptions& options, const Progress& progress)
{
    Result<ExportFiles> files = prepareExport(tree, index, name, fileName, options, progress);
    if (!files)
        return files.error();
    if (Result<void> committed = files->commit(); !committed)
        return committed;
    if (progress)
        progress(1.0);
    return {};
}

} // namespace espalier
