// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Error.h"
#include "model/io/ZipArchive.h"
#include "model/scene/SceneLook.h"

#include <optional>
#include <span>

namespace espalier {

/// The entry look.json of a project: the look of its scene. Angles are in radians, so that they come back as
/// they were.
struct ReadLook {
    SceneLook look{};
    /// The name of the picture to draw after, if the archive lacks it or it is broken; the look is without it
    /// then.
    QString lostPicture{};
};

/// Adds the entry; not the picture that the look names by its hash (ProjectImages::add()).
void addLook(ZipWriter& archive, const SceneLook& look);
/// None if the archive has no such entry, as those of older programs. @p known: images that the archive need
/// not have.
Result<std::optional<ReadLook>> readLook(const ZipReader& archive, std::span<const ImageAsset> known = {});

} // namespace espalier
