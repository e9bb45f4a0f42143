// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/io/export/ExportFiles.h"
#include "model/io/export/ExportScene.h"

namespace espalier {

/// A file format that a tree can be exported to. Implementations have no state: one object serves all
/// threads.
class ExportFormat {
public:
    virtual ~ExportFormat() = default;

    /// Ending of the file name, lower case, without a dot: "glb". It is also the format's id in settings.
    virtual QString suffix() const = 0;
    /// Name of the format for a list that a user chooses from, translated: "Binary glTF".
    virtual QString name() const = 0;
    /// Parts of the scene that write() reads; the other parts may be empty.
    virtual ExportParts parts() const = 0;
    /// Writes the scene into @p files: the main file, and files beside it where the format needs them. The
    /// caller commits the files.
    virtual Result<void> write(const ExportScene& scene, ExportFiles& files) const = 0;

protected:
    ExportFormat() = default;
    ExportFormat(const ExportFormat&) = default;
    ExportFormat& operator=(const ExportFormat&) = default;
};

} // namespace espalier
