// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/NewTree.h"

#include "app/files/FileDialogs.h"
#include "commands/recipe/BrushStrokeOperation.h"
#include "commands/recipe/Recipe.h"
#include "model/io/project/ProjectFile.h"
#include "model/mesh/TreeCounts.h"
#include "model/settings/ViewSettings.h"

#include <QFileInfo>

#include <algorithm>

namespace espalier {

namespace {

/// Limits of the height of a view, m.
constexpr double kLeastView = 0.3;
constexpr double kMostView = 80.0;
/// A tree that no stroke tells the size of, in internodes.
constexpr double kUnknownHeight = 60.0;
/// Radius of a brush for a crown, of the height of the view.
constexpr double kBrushShare = 0.085;

/// Sets the view so that a tree within @p bounds, m, fits into it, and a brush in proportion to it.
void suitTo(NewTree& tree, const Box3& bounds)
{
    double height = kUnknownHeight * tree.parameters.growth.internodeLength;
    if (!bounds.isEmpty()) {
        const Vec3 sizes = bounds.sizes();
        height = std::max(static_cast<double>(bounds.max().y()),
                          0.6 * static_cast<double>(std::max(sizes.x(), sizes.z())));
    }
    // A quarter of the view is below ground, and there is room above the tree.
    tree.viewHeight = std::clamp(1.45 * height, kLeastView, kMostView);
    tree.brushRadius = std::min(kBrushShare * tree.viewHeight, kMaxBrushRadius);
}

/// The largest brush of a recipe's strokes, m; 0 if there is none that grows a crown.
double crownBrush(const Recipe& recipe)
{
    double radius = 0.0;
    for (const RecipeOperation& operation : recipe.operations) {
        if (const auto* stroke = operation.as<BrushStrokeOperation>()) {
            for (const BrushSample& sample : stroke->samples)
                radius = std::max(radius, static_cast<double>(sample.radius));
        }
    }
    return radius > recipe.parameters.growth.internodeLength ? std::min(radius, kMaxBrushRadius) : 0.0;
}

Result<NewTree> likeRecipe(const QString& fileName)
{
    const Result<Recipe> recipe = readRecipe(fileName);
    if (!recipe)
        return recipe.error();
    NewTree tree{.parameters = recipe->parameters, .name = recipe->name};
    Box3 bounds;
    for (const RecipeOperation& operation : recipe->operations)
        bounds.extend(operation.reach());
    suitTo(tree, bounds);
    if (const double radius = crownBrush(*recipe); radius > 0.0)
        tree.brushRadius = radius;
    return tree;
}

Result<NewTree> likeProject(const QString& fileName)
{
    const Result<Project> project = loadProject(fileName);
    if (!project)
        return project.error();
    const Tree shown = shownTree(*project);
    NewTree tree{.parameters = shown.parameters()};
    const TreeIndex index(shown);
    if (index.livingCount() > 1)
        suitTo(tree, treeBounds(shown, index));
    return tree;
}

} // namespace

NewTree NewTree::ofSize(TreeSize size, bool takesBrush)
{
    const TreeSizePreset& preset = sizePreset(size);
    return {.parameters = parametersOfSize(size),
            .viewHeight = preset.viewHeight,
            .brushRadius = takesBrush ? preset.brushRadius : 0.0};
}

Result<NewTree> NewTree::like(const QString& fileName)
{
    const bool isRecipe = dialogs::suffixOf(fileName) == dialogs::kRecipeSuffix;
    Result<NewTree> tree = isRecipe ? likeRecipe(fileName) : likeProject(fileName);
    if (tree && tree->name.isEmpty())
        tree->name = QFileInfo(fileName).completeBaseName();
    return tree;
}

} // namespace espalier
