// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/io/project/ForeignParts.h"
#include "model/scene/SceneLook.h"
#include "model/tree/Tree.h"

#include <QImage>
#include <QString>

#include <optional>

namespace espalier {

/// What a project file holds.
struct Project {
    Tree tree{};
    Journal journal; ///< Its deltas are all applied to the tree
    QString name;
    QImage thumbnail; ///< May be null
    /// Number of the last deltas that lie ahead of the moment that was shown.
    std::uint32_t ahead = 0;
    std::optional<SceneLook> look{}; ///< None in files that are older than looks, or if it cannot be read
    ForeignParts foreign{};
    /// Sentences for the user about what could not be read, such as an image that is missing in the file; not
    /// part of a file.
    QString warning{};
};

} // namespace espalier
