// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QImage>
#include <QString>

#include <memory>

namespace espalier {

/// An image that the user has chosen for leaves or bark, or none. A value type: its data never change and are
/// shared by all copies, so an image that the undo stack refers to stays in memory. Two images are equal if
/// their files have the same bytes.
class ImageAsset {
public:
    /// The longest edge of pixels(), px; larger images are scaled down to it.
    static constexpr int kLargestEdge = 2048;

    ImageAsset() = default;
    /// @p file: the bytes of a PNG or JPEG file; readImage() (model/io) checks them. @p name: the name of
    /// that file, for recipes.
    ImageAsset(const QByteArray& file, const QString& name);

    bool isNull() const { return m_data == nullptr; }
    /// SHA-256 of the file's bytes, in 64 hexadecimal digits; empty if there is no image.
    QString hash() const { return m_data ? m_data->hash : QString(); }
    QString name() const { return m_data ? m_data->name : QString(); }
    QByteArray file() const { return m_data ? m_data->file : QByteArray(); }
    /// The suffix for a file with these bytes: "png" or "jpg".
    QString suffix() const;
    /// The decoded image, turned upright by its orientation tag: Format_RGBA8888 or Format_RGB888; null if
    /// the file cannot be decoded. A cache keeps the last few decoded images. Can be called on any thread.
    QImage pixels() const;
    /// pixels() converted to sRGB, for an image that shows colours.
    QImage colours() const;

    bool operator==(const ImageAsset& other) const
    {
        return m_data == other.m_data || (m_data && other.m_data && m_data->hash == other.m_data->hash);
    }

private:
    struct Data {
        QString hash;
        QString name;
        QByteArray file;
    };
    std::shared_ptr<const Data> m_data;
};

/// Lets Qt unpack images of up to 8192 × 8192 pixels; without this, it refuses those of more than 128 MB.
void allowLargeImages();

/// The format of an image file, from its first bytes: "png", "jpeg", or empty if it is neither.
QByteArray imageFormat(const QByteArray& file);

} // namespace espalier
