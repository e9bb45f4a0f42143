// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/Actions.h"
#include "app/FileController.h"
#include "app/GrowRunner.h"
#include "app/LassoRunner.h"
#include "app/RecipeRunner.h"
#include "app/Settings.h"
#include "app/TimeRunner.h"
#include "app/Workspace.h"

#include <QElapsedTimer>
#include <QMainWindow>

namespace espalier {

class Tour;

/// The program's window: puts the parts together and tells them of each other.
class MainWindow : public QMainWindow {
    Q_OBJECT

public:
    explicit MainWindow(QWidget* parent = nullptr);
    ~MainWindow() override;

    TreeDocument& document() { return m_document; }
    ViewSettings& viewSettings() { return m_viewSettings; }
    Actions& actions() { return m_actions; }
    Workspace& workspace() { return *m_workspace; }
    FileController& files() { return *m_files; }
    RecipeRunner& recipeRunner() { return m_recipeRunner; }
    GrowRunner& growRunner() { return m_growRunner; }

    /// Ends what is under way, and lets a recipe grow another tree before the person's eyes.
    void playRecipe(const Recipe& recipe, RecipeRunner::Pace pace);
    /// Plays a recipe that belongs to the program. Asks about unsaved changes first; its own tree is none, as
    /// long as nobody works on it.
    void playSample(const QString& fileName);
    /// Opens the help at the page of what is at hand; closes it if that is what it shows.
    void toggleHelp();
    Tour& tour() { return *m_tour; }
    void startTour();
    /// Shows a newcomer around: the first time that it is called on a person's machine, and never again.
    void startFirstTour();

    QSize sizeHint() const override { return {1440, 900}; }

protected:
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    void connectFiles();
    void connectTools();
    void connectView();
    void connectHelp();
    void followDocument();
    /// Ends whatever is under way.
    void cancelAll();
    /// Whether a gesture or growth is changing the document now.
    bool isHandBusy() const;
    /// The same, or a recipe.
    bool isBusy() const;
    void updateEnabled();
    void updateTitle();
    void updateTip();
    /// A sample has been played, or stopped.
    void handOverSample();
    /// Keeps a tree in sight that a recipe lets grow.
    void followRecipe();
    ActionId toolInHand() const;
    /// Of the sheet that has the keys, or else of the tool in hand.
    QString helpPage() const;
    void takeTool();
    void cancel();

    Settings m_settings;
    TreeDocument m_document;
    ViewSettings m_viewSettings;
    GrowRunner m_growRunner;
    LassoRunner m_lassoRunner;
    TimeRunner m_timeRunner;
    RecipeRunner m_recipeRunner;
    Actions m_actions;
    QElapsedTimer m_followClock;
    bool m_isSample = false; ///< What the recipe runner plays
    std::unique_ptr<Workspace> m_workspace;
    std::unique_ptr<FileController> m_files;
    std::unique_ptr<Tour> m_tour;
};

} // namespace espalier
