// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/io/ZipArchive.h"
#include "model/tree/Parameters.h"

#include <QHash>
#include <QJsonObject>

#include <optional>

namespace espalier {

/// The images that the parameter sets of a project, and the look of its scene, refer to by their hashes:
/// entries assets/<SHA-256>.png or .jpg, each once.
class ProjectImages {
public:
    /// @p names: the images' file names, by hash. @p archive must outlive this.
    ProjectImages(const ZipReader& archive, QJsonObject names) : m_archive(archive), m_names(std::move(names))
    {
    }

    /// The image of that hash; an image without pixels if the archive has none, or none that can be read.
    ImageAsset find(const QString& hash);
    /// Images that the archive need not have.
    void know(const std::vector<ImageAsset>& images);
    /// The name of an image that could not be read; empty if there was none.
    const QString& lost() const { return m_lost; }

    /// All images of @p sets, each once.
    static std::vector<ImageAsset> of(const QList<TreeParameters>& sets);
    /// The image of that hash; none if @p archive has none, or none that can be read.
    static std::optional<ImageAsset> read(const ZipReader& archive, const QString& hash, const QString& name);
    static bool areWithinLimits(const std::vector<ImageAsset>& images);
    static void add(ZipWriter& archive, const std::vector<ImageAsset>& images);
    static QJsonObject names(const std::vector<ImageAsset>& images);

private:
    const ZipReader& m_archive;
    QJsonObject m_names;
    QHash<QString, ImageAsset> m_known;
    qsizetype m_bytes = 0;
    QString m_lost;
};

} // namespace espalier
