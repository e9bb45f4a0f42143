// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/ImageFile.h"

#include "model/io/FileReader.h"
#include "model/io/ImageStructure.h"
#include "model/io/JsonReader.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QImageReader>

#include <algorithm>
#include <initializer_list>

namespace espalier {

namespace {

struct ImageText {
    Q_DECLARE_TR_FUNCTIONS(ImageFile)
};

Error tooManyBytes(const QString& name, qsizetype most)
{
    return inputError(name, ImageText::tr("it is larger than %1 MB").arg(most >> 20));
}

/// The bytes of an image file with these pixels: PNG if any of them may be transparent, else JPEG.
QByteArray packed(const QImage& pixels)
{
    constexpr int kQuality = 92;
    QByteArray file;
    QBuffer buffer(&file);
    buffer.open(QIODevice::WriteOnly);
    if (pixels.hasAlphaChannel())
        pixels.save(&buffer, "png");
    else
        pixels.save(&buffer, "jpg", kQuality);
    return file;
}

} // namespace

Result<ImageAsset> glanceAtImage(const QByteArray& file, const QString& name)
{
    if (file.size() > imageLimits::kBytes)
        return tooManyBytes(name, imageLimits::kBytes);
    const QByteArray format = imageFormat(file);
    if (format.isEmpty())
        return inputError(name, ImageText::tr("it is neither a PNG nor a JPEG image"));
    if (const QString fault = imageStructureFault(file); !fault.isEmpty())
        return inputError(name, fault);
    QBuffer buffer;
    buffer.setData(file);
    const QSize size = QImageReader(&buffer, format).size();
    if (size.isEmpty())
        return inputError(name, ImageText::tr("the image is broken"));
    if (std::max(size.width(), size.height()) > imageLimits::kEdge) {
        return inputError(name, ImageText::tr("it has %1 × %2 pixels; %3 along an edge is the most")
                                    .arg(size.width())
                                    .arg(size.height())
                                    .arg(imageLimits::kEdge));
    }
    if (std::min(size.width(), size.height()) < imageLimits::kLeastEdge)
        return inputError(
            name, ImageText::tr("it is too small: only %1 × %2 pixels").arg(size.width()).arg(size.height()));
    return ImageAsset(file, name);
}

Result<ImageAsset> readImage(const QByteArray& file, const QString& name)
{
    Result<ImageAsset> image = glanceAtImage(file, name);
    if (image && image->pixels().isNull())
        return inputError(name, ImageText::tr("the image is broken"));
    return image;
}

Result<ImageAsset> readImageFile(const QString& fileName, const QString& name)
{
    const QString shown = name.isEmpty() ? QFileInfo(fileName).fileName() : name;
    const Result<QByteArray> file = readFile(fileName, imageLimits::kBytes);
    return file ? readImage(*file, shown) : file.error();
}

Result<ImageAsset> readPictureFile(const QString& fileName)
{
    const QString name = QFileInfo(fileName).fileName();
    Result<QByteArray> file = readFile(fileName, imageLimits::kPictureBytes);
    if (!file)
        return file.error();
    if (const Result<ImageAsset> image = readImage(*file, name))
        return image;
    allowLargeImages();
    if (!imageFormat(*file).isEmpty()) {
        if (const QString fault = imageStructureFault(*file); !fault.isEmpty())
            return inputError(name, fault);
    }
    QBuffer buffer(&*file);
    QImageReader reader(&buffer);
    reader.setDecideFormatFromContent(true);
    reader.setAutoTransform(true);
    if (const QSize size = reader.size(); std::max(size.width(), size.height()) > ImageAsset::kLargestEdge)
        reader.setScaledSize(
            size.scaled(ImageAsset::kLargestEdge, ImageAsset::kLargestEdge, Qt::KeepAspectRatio));
    const QImage pixels = reader.read();
    if (pixels.isNull())
        return inputError(name, ImageText::tr("it is not a picture that can be read"));
    return readImage(packed(pixels), name);
}

MaterialFiles findMaterialFiles(const QString& fileName)
{
    const QFileInfo file(fileName);
    QString stem = file.completeBaseName().toLower();
    for (const char* word :
         {"basecolor", "base_color", "basecolour", "albedo", "colour", "color", "diffuse", "diff", "col"}) {
        for (const char separator : {'_', '-', ' '}) {
            const QString ending = QLatin1Char(separator) + QString::fromLatin1(word);
            if (stem.endsWith(ending))
                stem.chop(ending.size());
        }
    }
    const auto hasEnding = [](const QString& rest, std::initializer_list<const char*> words) {
        return rest.size() > 1 && (rest[0] == u'_' || rest[0] == u'-' || rest[0] == u' ') &&
               std::ranges::any_of(words,
                                   [&](const char* word) { return rest.sliced(1) == QLatin1String(word); });
    };
    MaterialFiles found;
    const QStringList filters{QStringLiteral("*.png"), QStringLiteral("*.jpg"), QStringLiteral("*.jpeg")};
    for (const QFileInfo& other : file.dir().entryInfoList(filters, QDir::Files, QDir::Name)) {
        const QString name = other.completeBaseName().toLower();
        if (!name.startsWith(stem))
            continue;
        const QString rest = name.sliced(stem.size());
        if (found.normal.isEmpty() &&
            hasEnding(rest, {"normal", "normalgl", "normal_gl", "nor_gl", "nor", "nrm"}))
            found.normal = other.filePath();
        if (found.roughness.isEmpty() && hasEnding(rest, {"roughness", "rough", "rgh"}))
            found.roughness = other.filePath();
    }
    return found;
}

} // namespace espalier
