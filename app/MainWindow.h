// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/AnotherController.h"
#include "app/FocusKeeper.h"
#include "app/HeldToolKey.h"
#include "app/HelpController.h"
#include "app/LatinKeyFilter.h"
#include "app/LeafController.h"
#include "app/LookController.h"
#include "app/PictureController.h"
#include "app/ProfileController.h"
#include "app/ReproduceController.h"
#include "app/SceneController.h"
#include "app/SketchController.h"
#include "app/Workspace.h"
#include "app/files/FileController.h"
#include "app/files/LibraryController.h"
#include "app/files/Settings.h"
#include "app/runners/GrowRunner.h"
#include "app/runners/LassoRunner.h"
#include "app/runners/RecipeRunner.h"
#include "app/runners/StrandRunner.h"
#include "app/runners/TimeRunner.h"
#include "app/runners/UndoRunner.h"
#include "panels/Actions.h"

#include <QElapsedTimer>
#include <QMainWindow>

namespace espalier {

class HistoryLimit;
class RingMenu;
class SettingsSheet;

/// The program's window: puts the parts together and tells them of each other.
class MainWindow : public QMainWindow, public RecipeStage {
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
    UndoRunner& undoRunner() { return m_undoRunner; }
    StrandRunner& strandRunner() { return m_strandRunner; }
    HelpController& help() { return *m_help; }
    ProfileController& profiles() { return *m_profiles; }
    SceneController& scene() { return *m_scene; }
    PictureController& pictures() { return *m_pictures; }
    AnotherController& another() { return *m_another; }
    HistoryLimit& historyLimit() { return *m_historyLimit; }

    /// Whether a gesture or growth is changing the document now.
    bool isHandBusy() const;
    /// The same, or a recipe.
    bool isBusy() const override;
    bool makeRoom() override;
    void playRecipe(const Recipe& recipe, RecipeRunner::Pace pace) override;
    /// Ends the program without a question: what is under way is finished, and what is in no file stays in
    /// the safety copy, which the next start offers.
    void leaveAtOnce();

    QSize sizeHint() const override { return {1440, 900}; }

protected:
    void changeEvent(QEvent* event) override;
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    void connectFiles();
    void connectTools();
    void askAboutCeiling(GrowthRunner& runner);
    void reportProblem();
    void connectView();
    void connectLibrary();
    /// Makes the workspace and what leads it, and tells them of the parts that outlive them.
    void makeInterface();
    void connectPopOuts();
    void connectViewport();
    void makeHelp(bool isSample);
    /// Makes them anew, in the language and the units in force now, around the same document: everything is
    /// where it was.
    void remakeInterface();
    void showCheckedSheet();
    /// The middle of what the viewport shows.
    QImage thumbnail();
    SettingsSheet& showSettings();
    /// The person prefers these from now on.
    void prefer(const Preferences& preferences);
    /// Puts the preferences in force.
    void apply(const Preferences& preferences);
    /// Those that the workspace keeps.
    void suitHand();
    void limitHistory();
    void followDocument();
    /// Whether an edit is under way that would be lost if it were cancelled.
    bool hasUnfinishedWork() const;
    /// Ends what a hand has under way, and growth, and keeps what they came to; ends undoing and redoing.
    void finishHand();
    /// Takes back what is under way.
    void cancelAll();
    /// Shows the document again that was set aside.
    void backToOwnTree();
    void undo();
    void updateEnabled();
    void updateTitle();
    void updateTip();
    void showRecipeProgress();
    /// Tells what the recipe that has just been played did not find.
    void showRecipeWarnings();
    /// Keeps a tree in sight that a recipe lets grow.
    void followRecipe();
    ActionId toolInHand() const;
    void takeTool();
    void cancel();

    Settings m_settings;
    Preferences m_preferences; ///< In force
    TreeDocument m_document;
    ViewSettings m_viewSettings;
    GrowRunner m_growRunner;
    LassoRunner m_lassoRunner;
    TimeRunner m_timeRunner;
    RecipeRunner m_recipeRunner;
    UndoRunner m_undoRunner;
    StrandRunner m_strandRunner;
    Actions m_actions;
    LatinKeyFilter m_latinKeys;
    FocusKeeper m_focusKeeper;
    HeldToolKey m_heldToolKey;
    RingMenu* m_ringMenu;
    bool m_offersSizes = true; ///< The new tree's size may be chosen before the first stroke
    QElapsedTimer m_followClock;
    /// How the document that is set aside was shown.
    struct AsideView {
        Camera camera;
        QRect clear; ///< See Viewport::clearRect()
        bool showedTree;
    };
    std::optional<AsideView> m_aside;
    std::unique_ptr<Workspace> m_workspace;
    std::unique_ptr<FileController> m_files;
    std::unique_ptr<LibraryController> m_library;
    std::unique_ptr<LookController> m_looks;
    std::unique_ptr<SceneController> m_scene;
    std::unique_ptr<PictureController> m_pictures;
    std::unique_ptr<ProfileController> m_profiles;
    std::unique_ptr<SketchController> m_sketching;
    std::unique_ptr<LeafController> m_leaves;
    std::unique_ptr<ReproduceController> m_reproducing;
    std::unique_ptr<AnotherController> m_another;
    std::unique_ptr<HistoryLimit> m_historyLimit;
    std::unique_ptr<HelpController> m_help;
};

} // namespace espalier
