// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/project/ProjectImages.h"

#include "model/io/ImageFile.h"
#include "model/io/project/ProjectLimits.h"

#include <QSet>

namespace espalier {

namespace {

QByteArray assetEntry(const QString& hash, const QString& suffix)
{
    return QByteArray("assets/") + hash.toLatin1() + '.' + suffix.toLatin1();
}

} // namespace

ImageAsset ProjectImages::find(const QString& hash)
{
    if (const auto known = m_known.constFind(hash); known != m_known.cend())
        return *known;
    const QString name = m_names.value(hash).toString();
    std::optional<ImageAsset> image;
    if (m_bytes < projectLimits::kImageBytes)
        image = read(m_archive, hash, name);
    if (image)
        m_bytes += image->file().size();
    else
        m_lost = name.isEmpty() ? hash.first(std::min<qsizetype>(hash.size(), 8)) : name;
    return *m_known.insert(hash, image.value_or(ImageAsset()));
}

void ProjectImages::know(const std::vector<ImageAsset>& images)
{
    for (const ImageAsset& image : images)
        m_known.insert(image.hash(), image);
}

std::optional<ImageAsset> ProjectImages::read(const ZipReader& archive, const QString& hash,
                                              const QString& name)
{
    for (const char* suffix : {"png", "jpg"}) {
        const QByteArray entry = assetEntry(hash, QLatin1String(suffix));
        if (!archive.contains(entry.constData()))
            continue;
        const Result<QByteArray> file = archive.read(entry.constData(), imageLimits::kBytes);
        const Result<ImageAsset> image = file ? glanceAtImage(*file, name) : file.error();
        if (image && image->hash() == hash)
            return *image;
    }
    return {};
}

std::vector<ImageAsset> ProjectImages::of(const QList<TreeParameters>& sets)
{
    std::vector<ImageAsset> images;
    QSet<QString> known;
    for (const TreeParameters& set : sets) {
        visitImages(set, [&](const char*, const ImageAsset& image) {
            if (!image.isNull() && !known.contains(image.hash())) {
                known.insert(image.hash());
                images.push_back(image);
            }
        });
    }
    return images;
}

bool ProjectImages::areWithinLimits(const std::vector<ImageAsset>& images)
{
    qsizetype bytes = 0;
    for (const ImageAsset& image : images)
        bytes += image.file().size();
    return images.size() <= projectLimits::kImages && bytes <= projectLimits::kImageBytes;
}

void ProjectImages::add(ZipWriter& archive, const std::vector<ImageAsset>& images)
{
    for (const ImageAsset& image : images)
        archive.add(assetEntry(image.hash(), image.suffix()), image.file(), ZipWriter::Packing::Store);
}

QJsonObject ProjectImages::names(const std::vector<ImageAsset>& images)
{
    QJsonObject names;
    for (const ImageAsset& image : images)
        names[image.hash()] = image.name();
    return names;
}

} // namespace espalier
