// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/DrawSketch.h"

#include "commands/RecordedEdit.h"
#include "commands/recipe/RecipeJson.h"
#include "commands/recipe/SketchOperation.h"
#include "model/io/import/SkeletonTree.h"
#include "model/io/import/SketchSkeleton.h"

#include <QCoreApplication>

namespace espalier {

namespace {

Error sketchError(const char* message)
{
    return {Error::Kind::Input, QCoreApplication::translate("Commands", message)};
}

/// The drawing's strokes, smoothed.
std::vector<SketchStroke> smoothStrokes(const TreeSketch& sketch)
{
    Eigen::AlignedBox2d box;
    for (const std::vector<Vec2>& stroke : sketch.strokes) {
        for (const Vec2& point : stroke)
            box.extend(point.cast<double>());
    }
    const double diagonal = box.isEmpty() ? 0.0 : box.diagonal().norm();
    const double pixel = diagonal > 0.0 ? 1e-3 * diagonal : 1e-3;
    const StrokeFitOptions metres = StrokeFitOptions::forPixels(pixel);
    std::vector<SketchStroke> strokes;
    for (const std::vector<Vec2>& drawn : sketch.strokes) {
        SketchLine samples;
        for (const Vec2& point : drawn)
            samples.emplace_back(point.cast<double>());
        if (std::optional<SketchStroke> stroke = fitStroke(samples, metres))
            strokes.push_back(std::move(*stroke));
    }
    return strokes;
}

} // namespace

SketchedTree sketchedTree(const TreeSketch& sketch)
{
    return SketchedTree::ofStrokes(smoothStrokes(sketch));
}

Result<void> drawSketch(TreeDocument& document, TreeSketch sketch)
{
    // A recipe does not keep the sign of zeros, so the tree must not depend on it.
    for (std::vector<Vec2>& stroke : sketch.strokes) {
        for (Vec2& point : stroke)
            point = withoutNegativeZeros(point);
    }
    Edit edit(document);
    if (document.tree().size() > 1)
        return sketchError(
            QT_TRANSLATE_NOOP("Commands", "a sketch can only become a tree where nothing has grown"));
    const PlacedTree placed = inferDepth(sketchedTree(sketch), sketch.depth);
    if (placed.branches.empty())
        return sketchError(QT_TRANSLATE_NOOP("Commands", "no stroke of the sketch is a branch"));
    const double internodeLength = document.tree().parameters().growth.internodeLength;
    Result<TreeDelta> delta = growSkeleton(document.tree(), skeletonOf(placed, internodeLength),
                                           skeletonLeavesOf(placed, internodeLength));
    if (!delta)
        return delta.error();
    edit.apply(std::move(*delta));
    commitRecorded(edit, QCoreApplication::translate("Commands", "Sketch"),
                   [&] { return SketchOperation{std::move(sketch)}; });
    return {};
}

} // namespace espalier
