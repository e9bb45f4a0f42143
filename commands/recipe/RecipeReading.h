// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/io/JsonReader.h"
#include "model/tree/Parameters.h"

#include <QHash>

namespace espalier {

/// What the parts of a recipe share while it is read: the parameters that have come in force so far, the
/// images that they name, and how many samples there may still be.
class RecipeReading {
public:
    /// Images are files, named relative to @p folder; if it is empty, a recipe has none.
    explicit RecipeReading(QString folder) : m_folder(std::move(folder)) {}

    /// Those that were read last, complete; at first the program's defaults.
    const TreeParameters& parameters() const { return m_parameters; }
    /// What is read next counts from these.
    void setParameters(const TreeParameters& parameters) { m_parameters = parameters; }
    /// Puts those that @p json names in force, on top of the others. If it names none, not a bit changes.
    Result<void> readParameters(const QJsonObject& json, const QString& place);

    /// Counts @p samples, the size of @p reader's member @p key. False, and the reader has an error, if the
    /// recipe has too many.
    bool admitSamples(JsonReader& reader, QLatin1StringView key, qsizetype samples);

private:
    struct Image {
        Result<ImageAsset> asset;
        double aspect = 1.0; ///< As a leaf; 0 if there is none in it
    };

    const Image& image(const QString& name);
    Result<ImageAsset> readImage(const QString& name) const;

    QString m_folder;
    QHash<QString, Image> m_images; ///< Each is read once
    TreeParameters m_parameters;
    qsizetype m_samples = 0;
};

} // namespace espalier
