// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/LookChoice.h"

#include "model/texture/LeafCut.h"
#include "model/texture/Textures.h"
#include "model/tree/LeafShapes.h"
#include "panels/Icon.h"
#include "panels/Theme.h"

#include <QAbstractItemView>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QMimeData>
#include <QPainter>
#include <QSignalBlocker>
#include <QUrl>
#include <QWheelEvent>

#include <algorithm>
#include <cstring>

namespace espalier {

namespace {

constexpr int kSwatch = 28; ///< px
/// Letters of an image's name that fit into the closed list.
constexpr int kShownName = 12;

/// A texture in a square, a leaf as a whole and a piece of bark.
QIcon swatchOf(const QImage& texture, LookKind kind)
{
    const int edge = 2 * kSwatch; // for high-resolution screens
    QPixmap pixmap(edge, edge);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    const QImage scaled = texture.scaled(
        edge, edge, kind == LookKind::Leaf ? Qt::KeepAspectRatio : Qt::KeepAspectRatioByExpanding,
        Qt::SmoothTransformation);
    painter.drawImage((edge - scaled.width()) / 2, (edge - scaled.height()) / 2, scaled);
    return QIcon(pixmap);
}

/// The image in the proportions of such leaves; the texture is square.
QImage inShape(const QImage& texture, LeafShape shape)
{
    // A list has room for leaves that are about as broad as long, and shows narrow ones a little broader.
    const double aspect = std::clamp(usualAspect(shape), 0.25, 0.85);
    return texture.scaled(static_cast<int>(aspect * texture.width()), texture.height(), Qt::IgnoreAspectRatio,
                          Qt::SmoothTransformation);
}

QIcon swatchOf(const ImageAsset& image, LookKind kind)
{
    if (kind == LookKind::Leaf) {
        if (const std::optional<QImage> leaf = cutLeaf(image, 4 * kSwatch))
            return swatchOf(*leaf, kind);
    }
    return swatchOf(image.pixels(), kind);
}

} // namespace

QString droppedImage(const QMimeData& data)
{
    const QList<QUrl> urls = data.urls();
    const QString name = urls.size() == 1 ? urls.constFirst().toLocalFile() : QString();
    const QString suffix = QFileInfo(name).suffix().toLower();
    const bool isImage =
        suffix == QLatin1String("png") || suffix == QLatin1String("jpg") || suffix == QLatin1String("jpeg");
    return isImage ? name : QString();
}

LookChoice::LookChoice(LookKind kind, const QStringList& drawn, QWidget* parent)
    : QComboBox(parent), m_kind(kind), m_drawnCount(static_cast<int>(drawn.size()))
{
    addItems(drawn);
    addItem(icon(QStringLiteral("open")), tr("Choose an image…"));
    sizeItems();
    setItemData(m_drawnCount,
                kind == LookKind::Leaf
                    ? tr("A PNG or JPEG of one leaf, stalk down, on a transparent or plain background")
                    : tr("A PNG or JPEG of bark; normal and roughness maps found beside it are used, too"),
                Qt::ToolTipRole);
    setIconSize({kSwatch, kSwatch});
    // As wide as its place allows; the open list is as wide as its longest line.
    setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    setMinimumContentsLength(static_cast<int>(
        std::ranges::max(drawn, {}, [](const QString& name) { return name.size(); }).size()));
    setMaxVisibleItems(m_drawnCount + 2);
    setAcceptDrops(true);
    connect(this, &QComboBox::activated, this, &LookChoice::choose);
}

std::optional<LookKind> LookChoice::kindOf(const char* parameter)
{
    if (std::strcmp(parameter, "leaves.shape") == 0)
        return LookKind::Leaf;
    return std::strcmp(parameter, "bark.kind") == 0 ? std::optional(LookKind::Bark) : std::nullopt;
}

const ImageAsset& LookChoice::imageOf(const TreeParameters& parameters, LookKind kind)
{
    return kind == LookKind::Leaf ? parameters.leaves.image : parameters.bark.image;
}

void LookChoice::takeImagesAway(TreeParameters& parameters, LookKind kind)
{
    if (kind == LookKind::Bark) {
        parameters.bark.image = parameters.bark.normalImage = parameters.bark.roughnessImage = {};
    } else if (!parameters.leaves.image.isNull()) {
        parameters.leaves.image = {};
        parameters.leaves.aspect = usualAspect(parameters.leaves.shape); // The image had its own
    }
}

void LookChoice::present(int drawn, const ImageAsset& image)
{
    const QSignalBlocker quiet(this);
    m_drawn = drawn;
    if (!(image == m_image)) {
        if (hasOwn())
            removeItem(m_drawnCount);
        m_image = image;
        if (hasOwn()) {
            const QString name = QFileInfo(image.name()).completeBaseName();
            insertItem(m_drawnCount, swatchOf(image, m_kind),
                       name.size() > kShownName ? name.first(kShownName - 1) + QChar(0x2026) : name);
            sizeItems();
            setItemData(m_drawnCount, image.name(), Qt::ToolTipRole);
            setItemData(m_drawnCount, tr("Your image: %1").arg(image.name()), Qt::AccessibleTextRole);
        }
    }
    setCurrentIndex(hasOwn() ? m_drawnCount : drawn);
}

void LookChoice::sizeItems()
{
    // Each item is large enough for a finger.
    for (int i = 0; i < count(); ++i)
        setItemData(i, QSize(0, theme::kTarget), Qt::SizeHintRole);
}

void LookChoice::choose(int index)
{
    if (index < m_drawnCount) {
        Q_EMIT drawnChosen(index);
        return;
    }
    const bool isOwn = hasOwn() && index == m_drawnCount;
    // Nothing has changed yet.
    present(m_drawn, m_image);
    if (!isOwn)
        Q_EMIT imageAsked(m_kind);
}

void LookChoice::showEvent(QShowEvent* event)
{
    if (!std::exchange(m_hasSwatches, true)) {
        constexpr int edge = 64;
        for (int i = 0; i < m_drawnCount; ++i) {
            const auto shape = static_cast<LeafShape>(i);
            setItemIcon(i, swatchOf(m_kind == LookKind::Leaf ? inShape(leafAlbedo(shape, edge), shape)
                                                             : barkAlbedo(static_cast<BarkKind>(i), edge),
                                    m_kind));
        }
    }
    QComboBox::showEvent(event);
}

void LookChoice::showPopup()
{
    constexpr int kRoom = 40; ///< px, the room around an item's text
    int widest = 0;
    for (int i = 0; i < count(); ++i)
        widest = std::max(widest, view()->fontMetrics().horizontalAdvance(itemText(i)));
    view()->setMinimumWidth(widest + kSwatch + kRoom);
    QComboBox::showPopup();
}

void LookChoice::wheelEvent(QWheelEvent* event)
{
    // The wheel scrolls the panel; it must not select the entry that chooses an image.
    event->ignore();
}

void LookChoice::dragEnterEvent(QDragEnterEvent* event)
{
    if (!droppedImage(*event->mimeData()).isEmpty())
        event->acceptProposedAction();
}

void LookChoice::dropEvent(QDropEvent* event)
{
    const QString file = droppedImage(*event->mimeData());
    if (file.isEmpty())
        return;
    event->acceptProposedAction();
    Q_EMIT imageDropped(m_kind, file);
}

} // namespace espalier
