// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/tree/Parameters.h"

#include <QComboBox>

#include <optional>

namespace espalier {

/// What can look like an image of one's own.
enum class LookKind { Leaf, Bark };

/// A list of looks, each with a swatch: those that are drawn, the image of one's own if there is one, and a
/// way to choose another. An image may also be dropped on it.
class LookChoice : public QComboBox {
    Q_OBJECT

public:
    LookChoice(LookKind kind, const QStringList& drawn, QWidget* parent = nullptr);

    /// Whether a parameter is chosen by such a list.
    static std::optional<LookKind> kindOf(const char* parameter);
    /// The image that such a list shows among @p parameters.
    static const ImageAsset& imageOf(const TreeParameters& parameters, LookKind kind);
    /// Takes the images away again, so that what is drawn shows.
    static void takeImagesAway(TreeParameters& parameters, LookKind kind);

    /// The number of the drawn look, and the image that takes its place if it is one.
    void present(int drawn, const ImageAsset& image);

Q_SIGNALS:
    /// A drawn look was chosen.
    void drawnChosen(int drawn);
    /// Another image is wanted.
    void imageAsked(espalier::LookKind kind);
    void imageDropped(espalier::LookKind kind, const QString& fileName);

protected:
    void showEvent(QShowEvent* event) override;
    void showPopup() override;
    void wheelEvent(QWheelEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    bool hasOwn() const { return !m_image.isNull(); }
    void sizeItems();
    void choose(int index);

    LookKind m_kind;
    int m_drawnCount;
    int m_drawn = 0;
    ImageAsset m_image;
    bool m_hasSwatches = false;
};

/// The image file that is being dropped, or nothing.
QString droppedImage(const QMimeData& data);

} // namespace espalier
