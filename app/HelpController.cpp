// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/HelpController.h"

#include "app/MainWindow.h"
#include "app/Tour.h"
#include "panels/HelpPanel.h"
#include "panels/Notice.h"
#include "panels/ParameterPanel.h"
#include "views/Viewport.h"

#include <QApplication>

namespace espalier {

HelpController::HelpController(MainWindow& window, Settings& settings, bool isSample)
    : m_window(window),
      m_settings(settings),
      m_tour(std::make_unique<Tour>(window.workspace(), window.actions(), window.document(),
                                    window.viewSettings())),
      m_isSample(isSample)
{
    HelpPanel& help = window.workspace().help();
    connect(window.actions()[ActionId::Help], &QAction::triggered, this, &HelpController::toggle);
    connect(&help, &HelpPanel::recipeAsked, this, &HelpController::playSample);
    connect(&help, &HelpPanel::tourAsked, this, &HelpController::startTour);
    connect(&help, &HelpPanel::closeAsked, this, &HelpController::close);
    connect(&window.recipeRunner(), &RecipeRunner::started, m_tour.get(), &Tour::stop);
    connect(&window.recipeRunner(), &RecipeRunner::finished, this, &HelpController::handOverSample);
}

HelpController::~HelpController() = default;

QString HelpController::pageAtHand() const
{
    const Actions& actions = m_window.actions();
    for (int i = 0; i < Workspace::kSheetCount; ++i) {
        if (!m_window.workspace().sheet(i).isAncestorOf(QApplication::focusWidget()))
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
    HelpPanel& help = m_window.workspace().help();
    const QString page = pageAtHand();
    if (help.isVisible() && help.page() == page) {
        close();
        return;
    }
    m_window.actions()[ActionId::HideInterface]->setChecked(false);
    help.showPage(page);
    m_window.workspace().showHelp(true);
}

void HelpController::close()
{
    m_window.workspace().showHelp(false);
    m_window.workspace().viewport().setFocus();
}

bool HelpController::putAway()
{
    if (m_tour->isRunning()) {
        m_tour->stop();
        return true;
    }
    if (!m_window.workspace().help().isVisible())
        return false;
    close();
    return true;
}

void HelpController::startTour()
{
    if (m_window.isBusy())
        return;
    m_settings.setTourSeen(true);
    close();
    m_window.actions()[ActionId::HideInterface]->setChecked(false);
    m_tour->start();
}

void HelpController::startFirstTour()
{
    if (!m_settings.isTourSeen())
        startTour();
}

void HelpController::playSample(const QString& fileName)
{
    const Result<Recipe> recipe = readRecipe(fileName);
    if (!recipe) {
        m_window.workspace().notice().showWarning(recipe.error().message);
        return;
    }
    if (m_isSample)
        m_window.recipeRunner().stop();
    if (m_window.isHandBusy() || !m_window.files().mayLeave())
        return;
    m_window.playRecipe(*recipe, RecipeRunner::Pace::OfTheHand);
    m_isSample = true;
    m_window.workspace().viewport().setFocus();
}

/// A sample has been played, or stopped.
void HelpController::handOverSample()
{
    if (!std::exchange(m_isSample, false))
        return;
    // The program's own samples are no work of anybody's.
    m_window.document().undoStack().setClean();
    // Whoever reads of a tool and has seen it at work wants to try it.
    for (const ActionId id : Actions::tools()) {
        QAction* tool = m_window.actions()[id];
        if (m_window.workspace().isHelpShown() && m_window.workspace().help().page() == tool->objectName())
            tool->trigger();
    }
}

} // namespace espalier
