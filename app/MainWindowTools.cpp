// SPDX-License-Identifier: GPL-3.0-or-later
// The part of MainWindow that puts tools into the hand, and says what is enabled meanwhile.
#include "app/MainWindow.h"
#include "panels/BackgroundPanel.h"
#include "panels/BrushPanel.h"
#include "panels/GrowPopOut.h"
#include "panels/HistoryPanel.h"
#include "panels/Notice.h"
#include "panels/ProfilePanel.h"
#include "panels/library/LibraryPanel.h"
#include "views/Viewport.h"
#include "views/tools/AddBudsTool.h"
#include "views/tools/BendTool.h"
#include "views/tools/BrushTool.h"
#include "views/tools/GrowTool.h"
#include "views/tools/InvigorateTool.h"
#include "views/tools/LassoTool.h"
#include "views/tools/MoveTool.h"
#include "views/tools/MultiplyTool.h"
#include "views/tools/ProfileTool.h"
#include "views/tools/PruneTool.h"
#include "views/tools/ReduceTool.h"
#include "views/tools/ReproduceTool.h"
#include "views/tools/SelectBudTool.h"
#include "views/tools/SketchTool.h"
#include "views/tools/TwistTool.h"
#include "views/tools/WidthTool.h"

#include <QActionGroup>

namespace espalier {

void MainWindow::askAboutCeiling(GrowthRunner& runner)
{
    m_workspace->notice().ask(
        tr("Growth has stopped: the tree has %L1 internodes, and the memory of this machine "
           "may not hold a larger one.")
            .arg(m_document.tree().size()),
        tr("Allow More"), tr("Leave It"), [&runner](bool more) {
            if (more)
                runner.raiseCeiling();
        });
}

void MainWindow::connectTools()
{
    auto* tools = new QActionGroup(this);
    for (const ActionId id : Actions::tools())
        tools->addAction(m_actions[id]);
    m_actions[ActionId::Brush]->setChecked(true);
    connect(tools, &QActionGroup::triggered, this, &MainWindow::takeTool);

    // A key goes farther than a notch of the wheel: from a twig to a crown takes few presses.
    constexpr double kNotchesOfKey = 3.0;
    const auto resize = [this](double notches) {
        m_viewSettings.set(&ViewValues::brushRadius,
                           steppedBrushRadius(m_viewSettings.values().brushRadius, notches));
    };
    connect(m_actions[ActionId::SmallerBrush], &QAction::triggered, this,
            [resize] { resize(-kNotchesOfKey); });
    connect(m_actions[ActionId::LargerBrush], &QAction::triggered, this, [resize] { resize(kNotchesOfKey); });
    connect(m_actions[ActionId::Cancel], &QAction::triggered, this, &MainWindow::cancel);
    connect(m_actions[ActionId::GrowStep], &QAction::triggered, this, [this] {
        if (!isBusy() || (m_growRunner.isRunning() && !m_workspace->viewport().isGestureActive()))
            m_growRunner.run(1);
    });
    connect(&m_timeRunner, &TimeRunner::runningChanged, this, &MainWindow::updateEnabled);
    connect(&m_growRunner, &GrowRunner::exhausted, this,
            [this] { m_workspace->notice().showInformation(tr("The tree has no room left to grow.")); });
    for (GrowthRunner* runner :
         {static_cast<GrowthRunner*>(&m_growRunner), static_cast<GrowthRunner*>(&m_lassoRunner)})
        connect(runner, &GrowthRunner::ceilingReached, this, [this, runner] { askAboutCeiling(*runner); });
    connect(&m_growRunner, &GrowRunner::runningChanged, this, &MainWindow::updateEnabled);
    connect(&m_lassoRunner, &LassoRunner::runningChanged, this, &MainWindow::updateEnabled);
    connect(&m_lassoRunner, &LassoRunner::refused, this,
            [this](const QString& why) { m_workspace->notice().showInformation(why); });
    connect(&m_recipeRunner, &RecipeRunner::advanced, this, &MainWindow::followRecipe);
    connect(&m_recipeRunner, &RecipeRunner::finished, this, [this](bool whole) {
        m_workspace->notice().finishProgress(m_recipeRunner);
        if (whole) {
            // What the recipe makes, it makes again: nothing would be lost.
            m_files->file().setUnmodified();
            showRecipeWarnings();
        }
        takeTool();
        updateEnabled();
        m_workspace->viewport().frameAll();
    });
}

ActionId MainWindow::toolInHand() const
{
    return *std::ranges::find_if(Actions::tools(),
                                 [this](ActionId id) { return m_actions[id]->isChecked(); });
}

void MainWindow::takeTool()
{
    Viewport& viewport = m_workspace->viewport();
    ToolContext& context = viewport.toolContext();
    Workspace::PopOut popOut = Workspace::PopOut::None;
    switch (toolInHand()) {
    case ActionId::Grow:
        viewport.setTool(std::make_unique<GrowTool>(context, m_growRunner));
        popOut = Workspace::PopOut::Grow;
        break;
    case ActionId::Prune:
        viewport.setTool(std::make_unique<PruneTool>(context));
        popOut = Workspace::PopOut::Prune;
        break;
    case ActionId::Invigorate:
        viewport.setTool(std::make_unique<InvigorateTool>(context));
        break;
    case ActionId::Reduce:
        viewport.setTool(std::make_unique<ReduceTool>(context));
        break;
    case ActionId::SelectBud:
        viewport.setTool(std::make_unique<SelectBudTool>(
            context, [this](const QString& why) { m_workspace->notice().showInformation(why); }));
        break;
    case ActionId::Bend:
        viewport.setTool(std::make_unique<BendTool>(context));
        popOut = Workspace::PopOut::Bend;
        break;
    case ActionId::Width:
        viewport.setTool(std::make_unique<WidthTool>(context));
        break;
    case ActionId::Twist:
        viewport.setTool(std::make_unique<TwistTool>(context));
        popOut = Workspace::PopOut::Twist;
        break;
    case ActionId::AddBuds:
        viewport.setTool(std::make_unique<AddBudsTool>(context));
        popOut = Workspace::PopOut::AddBuds;
        break;
    case ActionId::Sketch:
        viewport.setTool(std::make_unique<SketchTool>(
            context, m_lassoRunner, [this](const QString& why) { m_sketching->refuse(why); }));
        popOut = Workspace::PopOut::Sketch;
        break;
    case ActionId::Move:
        viewport.setTool(
            std::make_unique<MoveTool>(context, [this](const QString& why) { m_sketching->refuse(why); }));
        break;
    case ActionId::Multiply:
        viewport.setTool(std::make_unique<MultiplyTool>(
            context, [this](const QString& why) { m_sketching->refuse(why); }));
        popOut = Workspace::PopOut::Multiply;
        break;
    case ActionId::Reproduce:
        viewport.setTool(std::make_unique<ReproduceTool>(context, *m_reproducing));
        popOut = Workspace::PopOut::Reproduce;
        break;
    case ActionId::Profile:
        viewport.setTool(std::make_unique<ProfileTool>(context, *m_profiles));
        popOut = Workspace::PopOut::Profile;
        break;
    case ActionId::Lasso:
        viewport.setTool(std::make_unique<LassoTool>(context, m_lassoRunner));
        popOut = Workspace::PopOut::Lasso;
        break;
    default:
        viewport.setTool(std::make_unique<BrushTool>(context));
        popOut = Workspace::PopOut::Brush;
        break;
    }
    updateTip();
    m_profiles->setShown(popOut == Workspace::PopOut::Profile);
    m_leaves->setShown(popOut == Workspace::PopOut::Sketch);
    m_workspace->showPopOut(popOut);
    updateEnabled();
}

void MainWindow::updateTip()
{
    // The tip is for the first stroke only.
    const bool isNew = m_document.index().livingCount() <= 1 || m_recipeRunner.isRunning();
    m_workspace->setTip(isNew ? m_workspace->viewport().tool().tip() : QString());
}

void MainWindow::updateEnabled()
{
    // Undo and redo are not shown disabled while a stroke is made: that would flicker.
    const QUndoStack& stack = m_document.undoStack();
    m_actions[ActionId::Undo]->setEnabled(stack.canUndo() || isHandBusy() ||
                                          m_workspace->viewport().tool().canTakeBack());
    m_actions[ActionId::Redo]->setEnabled(stack.canRedo());
    const bool isIdle = !m_recipeRunner.isRunning();
    m_workspace->setBlank(!isBusy() && m_document.index().livingCount() <= 1 && stack.count() == 0 &&
                          m_offersSizes && m_files->file().fileName().isEmpty());
    for (const ActionId id : {ActionId::Save, ActionId::SaveAs, ActionId::SaveRecipe, ActionId::Export,
                              ActionId::SavePicture, ActionId::CopyPicture})
        m_actions[id]->setEnabled(isIdle);
    for (const ActionId id : Actions::tools())
        m_actions[id]->setEnabled(isIdle);
    // Only one thing at a time may change the document.
    m_workspace->viewport().setGrowing(m_growRunner.isRunning() || m_lassoRunner.isRunning() ||
                                       m_recipeRunner.isRunning());
    m_workspace->growPopOut().setEnabled(!m_recipeRunner.isRunning() &&
                                         !m_workspace->viewport().isGestureActive());
    // Parameters may change while the tree grows: growth knows how to wait for them.
    const bool isGrowing = m_growRunner.isRunning() || m_lassoRunner.isRunning();
    for (int i = 0; i < Workspace::kSheetCount; ++i) {
        // What changes the view or the hand alone is never in the way.
        Bar& sheet = m_workspace->sheet(i);
        if (&sheet != &m_workspace->background() && &sheet != &m_workspace->brushSheet())
            sheet.setEnabled(isGrowing || !isBusy());
    }
    m_workspace->brushSheet().setParametersEnabled(isGrowing || !isBusy());
    m_workspace->history().setEnabled(!isBusy());
    m_workspace->profilePanel().setMayEdit(!isBusy());
    m_workspace->library().setMayKeep(!isBusy());
}

} // namespace espalier
