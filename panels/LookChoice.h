// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/tree/Parameters.h"

#include <QComboBox>

#include <optional>

namespace espalier {

/// The parts of a tree that can have the user's own image.
enum class LookKind { Leaf, Bark };

/// A list of looks, each with a swatch: the drawn ones, the user's own image if there is one, and an entry
/// that chooses another image. The user can also drop an image on it.
class LookChoice : public QComboBox {
    Q_OBJECT

public:
    LookChoice(LookKind kind, const QStringList& drawn, QWidget* parent = nullptr);

    /// Whether a parameter is chosen by a list of looks, and of which kind.
    static std::optional<LookKind> kindOf(const char* parameter);
    /// The image in @p parameters that a list of that kind shows.
    static const ImageAsset& imageOf(const TreeParameters& parameters, LookKind kind);
    /// Removes the images of that kind, so that the drawn look is used.
    static void takeImagesAway(TreeParameters& parameters, LookKind kind);

    /// Shows the drawn look of that number, or the image instead if it is not null.
    void present(int drawn, const ImageAsset& image);

Q_SIGNALS:
    /// The user has chosen a drawn look.
    void drawnChosen(int drawn);
    /// The user wants to choose another image.
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

/// The image file in a drop, or an empty name.
QString droppedImage(const QMimeData& data);

} // namespace espalier
