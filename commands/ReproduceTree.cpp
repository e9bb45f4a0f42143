// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/ReproduceTree.h"

#include "commands/RecordedEdit.h"
#include "commands/recipe/RecipeJson.h"
#include "commands/recipe/ReproduceOperation.h"
#include "model/sketch/StrokeFit.h"
#include "model/sketch/TreeReproduction.h"

#include <QCoreApplication>

namespace espalier {

namespace {

/// A recipe does not keep the sign of zeros, so the tree must not depend on it.
SketchLine lineOf(std::vector<Vec2>& stroke)
{
    SketchLine line;
    for (Vec2& point : stroke) {
        point = withoutNegativeZeros(point);
        line.emplace_back(point.cast<double>());
    }
    return line;
}

} // namespace

Result<std::uint32_t> reproduceTree(TreeDocument& document, TreeFigure figure)
{
    const SketchLine samples = lineOf(figure.trunk);
    const SketchLine silhouette = lineOf(figure.silhouette);
    Eigen::AlignedBox2d box;
    for (const SketchLine* line : {&samples, &silhouette}) {
        for (const Eigen::Vector2d& point : *line)
            box.extend(point);
    }
    Edit edit(document);
    const double diagonal = box.isEmpty() ? 0.0 : box.diagonal().norm();
    const std::optional<SketchStroke> trunk =
        fitStroke(samples, StrokeFitOptions::forPixels(diagonal > 0.0 ? 1e-3 * diagonal : 1e-3));
    if (!trunk || trunk->kind != SketchStroke::Kind::Open)
        return Error{Error::Kind::Input,
                     QCoreApplication::translate("Commands", "the new trunk must be an open line")};
    figure.azimuth += 0.0; // −0 becomes 0
    Result<Reproduction> result =
        reproduced(document.tree(), document.index(), trunk->line, silhouette, radians(figure.azimuth));
    if (!result)
        return result.error();
    edit.apply(std::move(result->delta));
    commitRecorded(edit, QCoreApplication::translate("Commands", "Reshape Tree"),
                   [&] { return ReproduceOperation{std::move(figure)}; });
    return result->outside;
}

} // namespace espalier
