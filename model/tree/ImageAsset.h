// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QImage>
#include <QString>

#include <memory>

namespace espalier {

/// An image of the person's own, for leaves or bark; or none. A value: what it holds never changes and is
/// shared by all who hold it, the undo stack among them, so an image lives as long as somebody may come back
/// to it. Two are the same if their files have the same bytes.
class ImageAsset {
public:
    /// px; pixels() of larger images are made that large.
    static constexpr int kLargestEdge = 2048;

    ImageAsset() = default;
    /// @p file are the bytes of a PNG or JPEG file; see readImage(), which makes sound ones only. @p name is
    /// the file's, as a recipe may say it.
    ImageAsset(const QByteArray& file, const QString& name);

    bool isNull() const { return m_data == nullptr; }
    /// SHA-256 of the file, in 64 hexadecimal digits; empty for none.
    QString hash() const { return m_data ? m_data->hash : QString(); }
    QString name() const { return m_data ? m_data->name : QString(); }
    QByteArray file() const { return m_data ? m_data->file : QByteArray(); }
    /// "png" or "jpg", as the file is.
    QString suffix() const;
    /// What is in the file, upright as its camera says: Format_RGBA8888 or Format_RGB888; null if it is
    /// broken. The last few are kept, others are unpacked again. On any thread.
    QImage pixels() const;

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

/// "png" or "jpeg", as the bytes of a file begin; or nothing.
QByteArray imageFormat(const QByteArray& file);

} // namespace espalier
