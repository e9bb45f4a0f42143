// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/tree/Tree.h"

#include <QImage>
#include <QString>

namespace espalier {

/// What a project file holds.
struct Project {
    Tree tree{};
    Journal journal; ///< Its deltas stand applied
    QString name;
    QImage thumbnail; ///< May be null
    /// So many of the last deltas lie ahead of the moment that was shown.
    std::uint32_t ahead = 0;
    /// One sentence for a person about what of the file could not be taken over, such as an image that is
    /// missing in it; not part of a file.
    QString warning{};
};

} // namespace espalier
