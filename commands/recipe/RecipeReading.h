// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/io/JsonReader.h"
#include "model/io/import/Skeleton.h"
#include "model/tree/Parameters.h"

#include <QHash>

namespace espalier {

/// The state while a recipe is read: the parameters that are in force so far, the images that it names, and
/// the number of samples so far.
class RecipeReading {
public:
    /// Images and skeletons are files, named relative to @p folder; if that is empty, a recipe can have none.
    explicit RecipeReading(QString folder) : m_folder(std::move(folder)) {}

    /// The complete parameters in force so far; at first the program's defaults.
    const TreeParameters& parameters() const { return m_parameters; }
    /// Sets the parameters that the next ones are relative to.
    void setParameters(const TreeParameters& parameters) { m_parameters = parameters; }
    /// Changes the parameters that @p json names. If it names none, nothing changes, not even by rounding.
    Result<void> readParameters(const QJsonObject& json, const QString& place);

    /// The skeleton in a file, which is named relative to the recipe's folder.
    Result<Skeleton> readSkeleton(const QString& name) const;

    /// Counts @p samples, the size of @p reader's member @p key. If the recipe has too many, reports an error
    /// to @p reader and returns false.
    bool admitSamples(JsonReader& reader, QLatin1StringView key, qsizetype samples);

private:
    struct Image {
        Result<ImageAsset> asset;
        double aspect = 1.0; ///< Of the leaf in it; 0 if there is no leaf
    };

    const Image& image(const QString& name);
    Result<ImageAsset> readImage(const QString& name) const;
    /// The path of a file that the recipe names.
    Result<QString> pathOf(const QString& name) const;

    QString m_folder;
    QHash<QString, Image> m_images; ///< By name; each file is read once
    TreeParameters m_parameters;
    qsizetype m_samples = 0;
};

} // namespace espalier
