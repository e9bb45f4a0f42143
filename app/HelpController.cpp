// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/HelpController.h"

#include "app/Tour.h"
#include "app/Workspace.h"
#include "app/files/DocumentFile.h"
#include "app/files/Settings.h"
#include "panels/HelpPanel.h"
#include "panels/Notice.h"
#include "panels/ParameterPanel.h"
#include "views/Viewport.h"

#include <QApplication>

namespace espalier {

HelpController::HelpController(const Parts& parts, bool isSample)
    : m_parts(parts),
      m_tour(std::make_unique<Tour>(parts.workspace, parts.actions, parts.document, parts.viewSettings)),
      m_isSample(isSample)
{
    HelpPanel& help = parts.workspace.help();
    connect(parts.actions[ActionId::Help], &QAction::triggered, this, &HelpController::toggle);
    connect(&help, &HelpPanel::recipeAsked, this, &HelpController::playSample);
    connect(m_tour.get(), &Tour::recipeAsked, this, &HelpController::playForTour);
    connect(&help, &HelpPanel::tourAsked, this, &HelpController::startTour);
    connect(&help, &HelpPanel::closeAsked, this, &HelpController::close);
    connect(&parts.recipeRunner, &RecipeRunner::started, m_tour.get(), &Tour::stop);
    connect(&parts.recipeRunner, &RecipeRunner::finished, this, &HelpController::handOverSample);
}

HelpController::~HelpController() = default;

QString HelpController::pageAtHand() const
{
    const Actions& actions = m_parts.actions;
    for (int i = 0; i < Workspace::kSheetCount; ++i) {
        if (!m_parts.workspace.sheet(i).isAncestorOf(QApplication::focusWidget()))
            continue;
        const ActionId sheet = Actions::sheets()[static_cast<std::size_t>(i)];
        // The tool and its sheet are one subject.
        return actions[sheet == ActionId::BrushSheet ? ActionId::Brush : sheet]->objectName();
    }
    for (const ActionId id : Actions::tools()) {
        if (actions[id]->isChecked())
            return actions[id]->objectName();
    }
    return HelpBook::kIndex;
}

void HelpController::toggle()
{
    HelpPanel& help = m_parts.workspace.help();
    const QString page = pageAtHand();
    if (help.isVisible() && help.page() == page) {
        close();
        return;
    }
    m_parts.actions[ActionId::HideInterface]->setChecked(false);
    help.showPage(page);
    m_parts.workspace.showHelp(true);
}

void HelpController::close()
{
    m_parts.workspace.showHelp(false);
    m_parts.workspace.viewport().setFocus();
}

bool HelpController::putAway()
{
    if (m_tour->isRunning()) {
        m_tour->stop();
        return true;
    }
    if (!m_parts.workspace.help().isVisible())
        return false;
    close();
    return true;
}

void HelpController::startTour()
{
    if (m_parts.stage.isBusy())
        return;
    m_parts.settings.setTourSeen(true);
    close();
    m_parts.actions[ActionId::HideInterface]->setChecked(false);
    m_tour->start();
}

void HelpController::startFirstTour()
{
    if (!m_parts.settings.isTourSeen())
        startTour();
}

void HelpController::playSample(const QString& fileName)
{
    const Result<Recipe> recipe = readRecipe(fileName);
    if (!recipe) {
        m_parts.workspace.notice().showWarning(recipe.error().message);
        return;
    }
    if (m_isSample)
        m_parts.recipeRunner.stop();
    if (!m_parts.stage.makeRoom())
        return;
    m_parts.stage.playRecipe(*recipe, RecipeRunner::Pace::OfTheHand);
    m_isSample = true;
    m_parts.workspace.viewport().setFocus();
}

void HelpController::playForTour(const QString& fileName)
{
    const int next = m_tour->step() + 1;
    playSample(fileName);
    if (m_parts.recipeRunner.isRunning())
        m_tourGoesOn = next;
}

/// Gives the tree of a sample to the user, after the sample has been played or stopped.
void HelpController::handOverSample()
{
    if (!std::exchange(m_isSample, false))
        return;
    // A sample of the program is not an unsaved change.
    m_parts.file.setUnmodified();
    // The user who has read about a tool and seen it at work probably wants to try it: it becomes the current
    // tool.
    for (const ActionId id : Actions::tools()) {
        QAction* tool = m_parts.actions[id];
        if (m_parts.workspace.isHelpShown() && m_parts.workspace.help().page() == tool->objectName())
            tool->trigger();
    }
    if (const std::optional<int> step = std::exchange(m_tourGoesOn, std::nullopt))
        m_tour->start(*step);
}

} // namespace espalier
