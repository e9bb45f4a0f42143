// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/SketchJob.h"

#include "commands/DrawSketch.h"
#include "commands/recipe/FillEnvelopesOperation.h"
#include "commands/recipe/RecipePlayer.h"
#include "commands/recipe/SketchOperation.h"
#include "model/envelope/LassoLoop.h"
#include "model/io/import/DrawingFile.h"
#include "model/mesh/LeafPlacer.h"
#include "model/shape/Widths.h"
#include "model/tree/StrandProfile.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QFileInfo>

#include <algorithm>
#include <cmath>

namespace espalier {

namespace {

constexpr int kSilhouetteCells = 500; ///< Along the longer side
constexpr double kSketchPixels = 1000.0;
/// A crown's outline has a gap of less than this share of its length, and encloses more than this share of
/// the drawing's box.
constexpr float kCrownGap = 0.15F;
constexpr float kCrownShare = 0.08F;

/// The area that discs cover, in cells.
class Silhouette {
public:
    Silhouette(const Eigen::AlignedBox2d& box)
        : m_corner(box.min()),
          m_cell(box.sizes().maxCoeff() / kSilhouetteCells),
          m_cells(static_cast<std::size_t>(kSilhouetteCells) * kSilhouetteCells, 0)
    {
    }

    void add(const Eigen::Vector2d& centre, double radius)
    {
        const Eigen::Vector2d place = (centre - m_corner) / m_cell;
        const double reach = std::max(radius / m_cell, 0.5);
        const auto from = [&](double at) { return std::max(0, static_cast<int>(std::floor(at - reach))); };
        const auto to = [&](double at) {
            return std::min(kSilhouetteCells - 1, static_cast<int>(std::ceil(at + reach)));
        };
        for (int y = from(place.y()); y <= to(place.y()); ++y) {
            for (int x = from(place.x()); x <= to(place.x()); ++x) {
                if ((Eigen::Vector2d(x + 0.5, y + 0.5) - place).norm() <= reach)
                    m_cells[static_cast<std::size_t>(y) * kSilhouetteCells + static_cast<std::size_t>(x)] = 1;
            }
        }
    }
    double area() const
    {
        return m_cell * m_cell * static_cast<double>(std::ranges::count(m_cells, std::uint8_t{1}));
    }

private:
    Eigen::Vector2d m_corner;
    double m_cell;
    std::vector<std::uint8_t> m_cells;
};

/// The silhouette's area with the horizontal axis @p right: wood, and a ball as large as a leaf around each
/// node with leaves.
double silhouetteArea(const TreeDocument& document, const Vec3& right)
{
    const Tree& tree = document.tree();
    const TreeIndex& index = document.index();
    const Widths widths(tree, index);
    const LeafRule leaves(tree, index);
    const double leaf = tree.parameters().leaves.visible ? tree.parameters().leaves.length : 0.0;
    const auto seen = [&](const Vec3& point) {
        return Eigen::Vector2d(double{point.dot(right)}, double{point.y()});
    };
    Eigen::AlignedBox2d box;
    for (InternodeId id = 0; id < tree.size(); ++id) {
        if (tree.isAlive(id))
            box.extend(seen(index.nodePosition(id)));
    }
    box.extend(seen(tree.rootPosition(0)));
    box = Eigen::AlignedBox2d(box.min() - Eigen::Vector2d::Constant(leaf + 0.1),
                              box.max() + Eigen::Vector2d::Constant(leaf + 0.1));
    Silhouette silhouette(box);
    for (InternodeId id = 0; id < tree.size(); ++id) {
        if (!tree.isAlive(id))
            continue;
        const Vec3 base = index.basePosition(tree, id);
        const Vec3& node = index.nodePosition(id);
        constexpr int kSteps = 8;
        for (int i = 0; i <= kSteps; ++i) {
            const float share = static_cast<float>(i) / kSteps;
            silhouette.add(seen(base + share * (node - base)), double{widths.radius(index, id)});
        }
        if (leaf > 0.0 && leaves.bears(id))
            silhouette.add(seen(node), leaf);
    }
    return silhouette.area();
}

/// The greatest distance of the drawn lines from the wood, both from the front, m.
double frontDistance(const TreeDocument& document, const SketchedTree& drawing)
{
    const Tree& tree = document.tree();
    const TreeIndex& index = document.index();
    std::vector<SketchLine> wood;
    for (InternodeId id = 0; id < tree.size(); ++id) {
        if (!tree.isAlive(id))
            continue;
        const Vec3 base = index.basePosition(tree, id);
        const Vec3& node = index.nodePosition(id);
        wood.push_back({{double{base.x()}, double{base.y()}}, {double{node.x()}, double{node.y()}}});
    }
    // The trunk's foot moved to the origin.
    const Eigen::Vector2d foot = drawing.branches().front().line.front();
    const Eigen::Vector2d origin(double{tree.rootPosition(0).x()}, double{tree.rootPosition(0).y()});
    double farthest = 0.0;
    for (const SketchedBranch& branch : drawing.branches()) {
        for (const Eigen::Vector2d& point : branch.line) {
            double nearest = std::numeric_limits<double>::infinity();
            for (const SketchLine& piece : wood)
                nearest = std::min(nearest, nearestPlace(piece, point - foot + origin).distance);
            farthest = std::max(farthest, nearest);
        }
    }
    return farthest;
}

Eigen::AlignedBox2f boxOf(const DrawingStrokes& strokes)
{
    Eigen::AlignedBox2f box;
    for (const std::vector<Vec2>& stroke : strokes) {
        for (const Vec2& point : stroke)
            box.extend(point);
    }
    return box;
}

/// Whether a stroke is the outline of a crown: its ends meet, about, and it encloses much of the drawing.
bool isCrown(const std::vector<Vec2>& stroke, const Eigen::AlignedBox2f& box)
{
    float length = 0.0F;
    for (std::size_t i = 1; i < stroke.size(); ++i)
        length += (stroke[i] - stroke[i - 1]).norm();
    return stroke.size() > 2 && (stroke.back() - stroke.front()).norm() < kCrownGap * length &&
           std::abs(signedAreaOf(stroke)) > kCrownShare * box.sizes().prod();
}

} // namespace

Result<QJsonObject> sketchTree(TreeDocument& document, const CommandLine& line)
{
    const QString name = QFileInfo(line.inputs.constFirst()).fileName();
    DrawingStrokes strokes;
    for (const QString& fileName : line.inputs) {
        const Result<DrawingStrokes> read = readDrawing(fileName, line.drawing);
        if (!read)
            return read.error();
        strokes.insert(strokes.end(), read->begin(), read->end());
    }
    if (strokes.size() > kMostSketchStrokes)
        return inputError(name, QCoreApplication::translate("CommandLine", "it has more than %1 strokes")
                                    .arg(kMostSketchStrokes));
    strokes = fittedDrawing(std::move(strokes));
    const Eigen::AlignedBox2f box = boxOf(strokes);
    TreeSketch sketch;
    std::vector<std::vector<Vec2>> crowns;
    for (const std::vector<Vec2>& stroke : strokes)
        (isCrown(stroke, box) ? crowns : sketch.strokes).push_back(stroke);
    sketch.depth.seed = line.seed.value_or(sketch.depth.seed);
    sketch.depth.secondTree = !line.frontOnly;
    const SketchedTree drawing = sketchedTree(sketch);
    if (drawing.isEmpty() && crowns.empty())
        return inputError(name, QCoreApplication::translate(
                                    "CommandLine", "it has no line that can be a trunk, and no crown"));

    Recipe recipe;
    recipe.seed = line.seed.value_or(recipe.seed);
    line.overrides.applyTo(recipe);
    if (!drawing.isEmpty())
        recipe.operations.emplace_back(SketchOperation{sketch});
    // The trunk's foot moves to the origin, and the crowns with it.
    const Vec2 foot =
        drawing.isEmpty() ? Vec2(Vec2::Zero()) : Vec2(drawing.branches().front().line.front().cast<float>());
    std::vector<LassoStroke> envelopes;
    for (const std::vector<Vec2>& crown : crowns) {
        LassoStroke outline;
        for (const Vec2& point : simplified(crown))
            outline.points.emplace_back(point - foot);
        envelopes.push_back(outline);
        if (!line.frontOnly)
            envelopes.push_back(turnedToTheSide(outline));
    }
    if (!envelopes.empty()) {
        recipe.operations.emplace_back(
            FillEnvelopesOperation{.envelopes = envelopes, .parameters = recipe.parameters});
    }
    RecipePlayer player(document, std::move(recipe));
    QElapsedTimer timer;
    timer.start();
    double seconds = 0.0;
    while (!player.isDone()) {
        player.playOperation();
        if (seconds == 0.0 && !drawing.isEmpty())
            seconds = static_cast<double>(timer.nsecsElapsed()) * 1e-9;
    }
    if (const QStringList warnings = player.warnings(); !warnings.isEmpty())
        return inputError(name, warnings.constFirst());

    if (line.stats.isEmpty())
        return QJsonObject();
    const double front = silhouetteArea(document, Vec3::UnitX());
    const double side = silhouetteArea(document, Vec3::UnitZ());
    const auto count = [](std::size_t value) { return static_cast<qint64>(value); };
    const double error =
        drawing.isEmpty() ? 0.0
                          : kSketchPixels * frontDistance(document, drawing) / double{box.sizes().maxCoeff()};
    return QJsonObject{
        {QStringLiteral("strokes"), count(strokes.size())},
        {QStringLiteral("attached"), count(drawing.branches().size() + drawing.leaves().size())},
        {QStringLiteral("crowns"), count(crowns.size())},
        {QStringLiteral("leavesPlaced"), qint64{document.tree().placedLeaves().size()}},
        {QStringLiteral("frontError"), error},
        {QStringLiteral("sideOverFront"), front > 0.0 ? side / front : 0.0},
        {QStringLiteral("infer"), seconds}};
}

} // namespace espalier
