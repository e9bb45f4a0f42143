// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/export/ExportScene.h"

#include "model/base/Parallel.h"
#include "model/mesh/LeafCard.h"
#include "model/mesh/UvWrap.h"
#include "model/mesh/WoodMesh.h"
#include "model/texture/AllocatedImage.h"
#include "model/texture/OwnTextures.h"

#include <QBuffer>
#include <QImageWriter>

#include <bit>
#include <cmath>
#include <cstring>
#include <numeric>

namespace espalier {

namespace {

constexpr std::size_t kMostTiles = 8;
/// rad; hues that differ by less share a tile.
constexpr float kTileHue = static_cast<float>(radians(1.0));
/// 0...100: PNG is packed fast rather than small.
constexpr int kPngQuality = 80;

/// One colour of the leaves.
struct LeafTile {
    double hueShift = 0.0; ///< rad, mean of its leaves
    double value = 0.0;    ///< Factor of the brightness, mean of its leaves
    int leaves = 0;
};

/// The tile of each leaf: equal steps of hue, from the least to the greatest.
struct LeafTiles {
    std::vector<LeafTile> tiles;
    std::vector<std::uint8_t> tileOf; ///< One element for each visible leaf
};

/// The tolerance of the wood's mesh, m. The number of a branch's sides is proportional to the inverse root of
/// it.
double exportTolerance(const ExportOptions& options)
{
    return WoodMeshOptions{}.tolerance / (options.detail * options.detail);
}

LeafTiles chooseTiles(std::span<const LeafInstance> leaves)
{
    float least = std::numeric_limits<float>::infinity();
    float greatest = -least;
    for (const LeafInstance& leaf : leaves) {
        if (leaf.length > 0.0F) {
            least = std::min(least, leaf.hueShift);
            greatest = std::max(greatest, leaf.hueShift);
        }
    }
    const float spread = std::max(0.0F, greatest - least);
    // A power of two, so that the width of the row of tiles is valid in every renderer.
    const auto count =
        std::bit_ceil(std::clamp(static_cast<std::size_t>(spread / kTileHue), std::size_t{1}, kMostTiles));
    LeafTiles result{std::vector<LeafTile>(count), {}};
    result.tileOf.reserve(leaves.size());
    for (const LeafInstance& leaf : leaves) {
        if (leaf.length <= 0.0F)
            continue;
        const float place = spread > 0.0F ? (leaf.hueShift - least) / spread : 0.0F;
        const auto tile = std::min(static_cast<std::size_t>(place * static_cast<float>(count)), count - 1);
        result.tileOf.push_back(static_cast<std::uint8_t>(tile));
        result.tiles[tile].hueShift += leaf.hueShift;
        result.tiles[tile].value += leaf.value;
        ++result.tiles[tile].leaves;
    }
    for (LeafTile& tile : result.tiles) {
        tile.hueShift /= std::max(1, tile.leaves);
        tile.value /= std::max(1, tile.leaves);
    }
    return result;
}

/// Images of equal size in a row.
QImage inARow(const std::vector<QImage>& images)
{
    const QImage& first = images.front();
    QImage row =
        allocated(QImage(first.width() * static_cast<int>(images.size()), first.height(), first.format()));
    const auto bytes = static_cast<std::size_t>(first.width()) * static_cast<std::size_t>(first.depth() / 8);
    for (std::size_t i = 0; i < images.size(); ++i) {
        for (int y = 0; y < row.height(); ++y)
            std::memcpy(row.scanLine(y) + i * bytes, images[i].constScanLine(y), bytes);
    }
    return row;
}

/// Light that passes through a leaf is yellower and redder than the light that it reflects. The viewport
/// draws that. Exported materials have no such light, and leaves would look dull and cold: so it is in their
/// colours. Red, green, blue, linear.
constexpr std::array kThrough{1.35, 1.0, 0.9};

/// Multiplies colours by linear factors.
void multiply(QImage& image, const std::array<double, 3>& factors)
{
    std::array<std::array<uchar, 256>, 3> tables;
    for (std::size_t channel = 0; channel < 3; ++channel) {
        // A power approximates sRGB's transfer function well enough for scaling.
        const double factor = std::pow(factors[channel], 1.0 / 2.2);
        for (std::size_t i = 0; i < 256; ++i)
            tables[channel][i] = static_cast<uchar>(std::min(255.0, static_cast<double>(i) * factor + 0.5));
    }
    for (int y = 0; y < image.height(); ++y) {
        uchar* pixel = image.scanLine(y);
        for (int x = 0; x < image.width(); ++x, pixel += 4) {
            for (std::size_t channel = 0; channel < 3; ++channel)
                pixel[channel] = tables[channel][pixel[channel]];
        }
    }
}

QImage leafColours(LeafShape shape, double saturation, int size, const std::vector<LeafTile>& tiles)
{
    std::array<double, 3> through;
    for (std::size_t channel = 0; channel < 3; ++channel)
        through[channel] = 1.0 + std::min(saturation, 1.0) * (kThrough[channel] - 1.0);
    std::vector<QImage> images(tiles.size());
    parallelFor(tiles.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            images[i] = leafAlbedo(shape, size, kLeafTextureHue + tiles[i].hueShift);
            saturateLeaf(images[i], saturation);
            const double value = tiles[i].value;
            multiply(images[i], {value * through[0], value * through[1], value * through[2]});
        }
    });
    return inARow(images);
}

/// The user's image with the colour of each tile, as the viewport shows it.
QImage ownColours(const QImage& image, double saturation, const std::vector<LeafTile>& tiles)
{
    std::vector<QImage> images(tiles.size());
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        images[i] = allocated(image.copy());
        std::array<double, 3> factors = hueFactors(tiles[i].hueShift);
        for (double& factor : factors)
            factor *= tiles[i].value;
        saturateLeaf(images[i], saturation);
        multiply(images[i], factors);
    }
    return inARow(images);
}

QByteArray toPng(const QImage& image)
{
    QByteArray png;
    QBuffer buffer(&png);
    QImageWriter writer(&buffer, "png");
    writer.setQuality(kPngQuality);
    // Nothing but the memory can be missing.
    if (!writer.write(image))
        throw std::bad_alloc();
    return png;
}

/// A material without images.
ExportMaterial namedMaterial(const QString& name, const QString& textures, bool isLeaf)
{
    return {name,
            {textures, {}},
            {textures + QLatin1String("_normal"), {}},
            {textures + QLatin1String("_roughness"), {}},
            {textures + QLatin1String("_mask"), {}},
            isLeaf};
}

/// A mesh's name, which ends in the level of detail.
QString meshName(const QString& material, int level)
{
    return QStringLiteral("%1_LOD%2").arg(material).arg(level);
}

/// The alpha of an image (Format_RGBA8888) in all four channels.
QImage maskOf(const QImage& colour)
{
    QImage mask = allocated(colour.copy());
    for (int y = 0; y < mask.height(); ++y) {
        uchar* pixel = mask.scanLine(y);
        for (int x = 0; x < mask.width(); ++x, pixel += 4)
            std::memset(pixel, pixel[3], 4);
    }
    return mask;
}

/// Mean of a grey image, 0...1.
double meanOf(const QImage& grey)
{
    double sum = 0.0;
    for (int y = 0; y < grey.height(); ++y) {
        const uchar* const line = grey.constScanLine(y);
        sum += std::accumulate(line, line + grey.width(), 0.0);
    }
    return sum / (255.0 * grey.width() * grey.height());
}

/// Packs the images of a material in parallel.
void pack(ExportMaterial& material, const SurfaceTextures& textures)
{
    const QImage mask = material.isLeaf ? maskOf(textures.colour) : QImage();
    const std::array<const QImage*, 4> images{&textures.colour, &textures.normal, &textures.roughness, &mask};
    const std::array<ExportTexture*, 4> targets{&material.colour, &material.normal, &material.roughness,
                                                &material.mask};
    parallelFor(images.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            if (!images[i]->isNull())
                targets[i]->png = toPng(*images[i]);
        }
    });
    material.meanRoughness = meanOf(textures.roughness);
}

/// The textures of all leaves: a tile for each hue.
SurfaceTextures leafTiles(const LeafParameters& leaves, int size, const std::vector<LeafTile>& tiles)
{
    const SurfaceTextures one = leafTextures(leaves, size);
    return {leaves.image.isNull() ? leafColours(leaves.shape, leaves.saturation, size, tiles)
                                  : ownColours(one.colour, leaves.saturation, tiles),
            inARow(std::vector(tiles.size(), one.normal)), inARow(std::vector(tiles.size(), one.roughness))};
}

/// Moves each leaf's texture coordinates into its tile.
void moveIntoTiles(TriangleMesh& mesh, const LeafTiles& tiles, std::size_t verticesPerLeaf)
{
    const float width = 1.0F / static_cast<float>(tiles.tiles.size());
    for (std::size_t leaf = 0; leaf < tiles.tileOf.size(); ++leaf) {
        for (std::size_t i = 0; i < verticesPerLeaf; ++i) {
            float& u = mesh.vertices[leaf * verticesPerLeaf + i].uv[0];
            u = (static_cast<float>(tiles.tileOf[leaf]) + u) * width;
        }
    }
}

void addBark(ExportScene& scene, const Tree& tree, const ShownWood& wood, const ExportOptions& options)
{
    ExportMaterial material =
        namedMaterial(scene.name + QLatin1String("_Bark"), QStringLiteral("bark"), false);
    pack(material, barkTextures(tree.parameters().bark, options.textureSize));
    scene.meshes.push_back({meshName(material.name, 0),
                            withSmallV(wood.mesh({.tolerance = exportTolerance(options)})),
                            scene.materials.size()});
    scene.materials.push_back(std::move(material));
}

/// Adds the leaves; nothing if the tree shows none.
void addLeaves(ExportScene& scene, const Tree& tree, const ShownWood& wood, const ExportOptions& options)
{
    const MeshBuffer<LeafInstance> leaves = wood.leaves();
    const LeafTiles tiles = chooseTiles(leaves);
    if (tiles.tileOf.empty())
        return;
    TriangleMesh mesh = expandLeaves(leaves);
    moveIntoTiles(mesh, tiles, leafCard(static_cast<LeafShape>(leaves.front().shape)).vertices.size());
    ExportMaterial material =
        namedMaterial(scene.name + QLatin1String("_Leaves"), QStringLiteral("leaf"), true);
    pack(material, leafTiles(tree.parameters().leaves, options.textureSize / 2, tiles.tiles));
    scene.meshes.push_back({meshName(material.name, 0), std::move(mesh), scene.materials.size()});
    scene.materials.push_back(std::move(material));
}

void addSkeleton(ExportScene& scene, const Tree& tree, const TreeIndex& index, const Widths& widths)
{
    scene.skeleton.reserve(index.livingCount());
    for (InternodeId id = 0; id < tree.size(); ++id) {
        if (tree.isAlive(id)) {
            scene.skeleton.push_back({id, tree.parent(id), index.basePosition(tree, id),
                                      index.nodePosition(id), widths.radius(index, id)});
        }
    }
}

} // namespace

QString safeExportName(const QString& name)
{
    QString safe;
    for (const QChar c : name.simplified())
        safe += c.isLetterOrNumber() || c == u'-' || c == u'_' ? c : QChar(u'_');
    return safe.isEmpty() ? QStringLiteral("Tree") : safe;
}

ExportScene buildExportScene(const Tree& tree, const TreeIndex& index, const QString& name,
                             const ExportOptions& options, const ExportParts& parts)
{
    ExportScene scene;
    scene.name = safeExportName(name);
    const Widths widths(tree, index);
    if (parts.surface) {
        const ShownWood wood(tree, index, widths);
        addBark(scene, tree, wood, options);
        if (options.leaves)
            addLeaves(scene, tree, wood, options);
    }
    if (parts.skeleton)
        addSkeleton(scene, tree, index, widths);
    return scene;
}

} // namespace espalier
