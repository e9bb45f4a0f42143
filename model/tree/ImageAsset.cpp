// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/tree/ImageAsset.h"

#include <QBuffer>
#include <QColorSpace>
#include <QCryptographicHash>
#include <QImageReader>

#include <algorithm>
#include <deque>
#include <mutex>

namespace espalier {

namespace {

QImage unpack(const QByteArray& file)
{
    allowLargeImages();
    QBuffer buffer;
    buffer.setData(file);
    QImageReader reader(&buffer, imageFormat(file));
    reader.setAutoTransform(true);
    QImage pixels = reader.read();
    if (pixels.isNull())
        return {};
    if (std::max(pixels.width(), pixels.height()) > ImageAsset::kLargestEdge) {
        const QColorSpace space = pixels.colorSpace();
        pixels = pixels.scaled(ImageAsset::kLargestEdge, ImageAsset::kLargestEdge, Qt::KeepAspectRatio,
                               Qt::SmoothTransformation);
        pixels.setColorSpace(space);
    }
    const auto format = pixels.hasAlphaChannel() ? QImage::Format_RGBA8888 : QImage::Format_RGB888;
    return std::move(pixels).convertToFormat(format);
}

/// A cache of the images that were decoded last, for all threads.
class UnpackedImages {
public:
    static UnpackedImages& instance()
    {
        static UnpackedImages images;
        return images;
    }

    QImage of(const QString& hash, const QByteArray& file)
    {
        {
            const std::scoped_lock lock(m_mutex);
            for (const auto& [known, image] : m_images) {
                if (known == hash)
                    return image;
            }
        }
        QImage image = unpack(file);
        const std::scoped_lock lock(m_mutex);
        m_images.emplace_back(hash, image);
        if (m_images.size() > kKept)
            m_images.pop_front();
        return image;
    }

private:
    static constexpr std::size_t kKept = 6;

    std::mutex m_mutex;
    std::deque<std::pair<QString, QImage>> m_images;
};

} // namespace

void allowLargeImages()
{
    constexpr int kMegabytes = 320; // 8192 × 8192 pixels take 256
    [[maybe_unused]] static const bool isSet = [] {
        QImageReader::setAllocationLimit(kMegabytes);
        return true;
    }();
}

QByteArray imageFormat(const QByteArray& file)
{
    if (file.startsWith(QByteArrayLiteral("\x89PNG\r\n\x1a\n")))
        return QByteArrayLiteral("png");
    return file.startsWith(QByteArrayLiteral("\xff\xd8\xff")) ? QByteArrayLiteral("jpeg") : QByteArray();
}

ImageAsset::ImageAsset(const QByteArray& file, const QString& name)
    : m_data(std::make_shared<const Data>(
          Data{QString::fromLatin1(QCryptographicHash::hash(file, QCryptographicHash::Sha256).toHex()), name,
               file}))
{
}

QString ImageAsset::suffix() const
{
    return imageFormat(file()) == "png" ? QStringLiteral("png") : QStringLiteral("jpg");
}

QImage ImageAsset::pixels() const
{
    return m_data ? UnpackedImages::instance().of(m_data->hash, m_data->file) : QImage();
}

QImage ImageAsset::colours() const
{
    QImage image = pixels();
    const QColorSpace space = image.colorSpace();
    if (space.isValid() && space != QColorSpace(QColorSpace::SRgb))
        image.convertToColorSpace(QColorSpace(QColorSpace::SRgb));
    return image;
}

} // namespace espalier
