// SPDX-License-Identifier: GPL-3.0-or-later
// The part of MainWindow that plays recipes.
#include "app/MainWindow.h"
#include "commands/recipe/Performance.h"
#include "model/mesh/TreeCounts.h"
#include "panels/Notice.h"
#include "views/Viewport.h"
#include "views/tools/RecipeTool.h"

namespace espalier {

namespace {

/// ms between two looks at whether a growing tree is still in sight.
constexpr int kFollowInterval = 400;

/// Where the brush and the lasso will be, m; empty if the recipe has no strokes.
Box3 strokeBounds(const Recipe& recipe)
{
    Box3 bounds;
    for (const RecipeOperation& operation : recipe.operations)
        bounds.extend(operation.reach());
    return bounds;
}

/// The camera, moved back until it shows all of the box and some room for it to grow.
Camera withHeadroom(const Viewport& viewport, const Box3& bounds)
{
    const Vec3 room = 0.06F * bounds.sizes();
    return viewport.framing(Box3(bounds.min() - room, bounds.max() + room));
}

} // namespace

void MainWindow::playRecipe(const Recipe& recipe, RecipeRunner::Pace pace)
{
    cancelAll();
    Viewport& viewport = m_workspace->viewport();
    viewport.setTool(
        std::make_unique<RecipeTool>(viewport.toolContext(), [this] { return m_recipeRunner.moment(); }));
    m_recipeRunner.start(recipe, pace);
    // A recipe may take back more than a person wants to.
    m_document.undoStack().setUndoLimit(0);
    m_files->file().startUnsaved(recipe.name);
    m_files->autosave().clear();
    if (const Box3 strokes = strokeBounds(recipe); !strokes.isEmpty())
        viewport.setCamera(withHeadroom(viewport, strokes));
    updateEnabled();
    updateTip();
}

void MainWindow::followRecipe()
{
    Viewport& viewport = m_workspace->viewport();
    viewport.update();
    if (m_followClock.isValid() && m_followClock.elapsed() < kFollowInterval)
        return;
    m_followClock.start();
    showRecipeProgress();
    const Box3 bounds = treeBounds(m_document.tree(), m_document.index());
    for (int corner = 0; corner < 8; ++corner) {
        const auto place =
            viewport.mainCamera().project(bounds.corner(static_cast<Box3::CornerType>(corner)));
        if (!place || !QRectF(viewport.clearRect()).contains(*place)) {
            viewport.flyTo(withHeadroom(viewport, bounds));
            return;
        }
    }
}

void MainWindow::showRecipeProgress()
{
    if (m_recipeRunner.isRunning() && m_recipeRunner.pace() == RecipeRunner::Pace::Hurried)
        m_workspace->notice().showProgress(m_recipeRunner,
                                           tr("Growing %1").arg(m_files->file().displayName()),
                                           m_recipeRunner.moment()->progress, [this] { cancelAll(); });
}

void MainWindow::showRecipeWarnings()
{
    const QStringList warnings = m_recipeRunner.warnings();
    if (warnings.isEmpty())
        return;
    m_workspace->notice().showWarning(
        tr("Not everything that the recipe names was found in the tree (%1 of %2 operations): %3")
            .arg(warnings.size())
            .arg(m_recipeRunner.operationCount())
            .arg(joinedFaults(warnings)));
}

} // namespace espalier
