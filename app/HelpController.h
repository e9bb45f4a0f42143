// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/runners/RecipeRunner.h"
#include "panels/Actions.h"

#include <QObject>

#include <memory>
#include <optional>

namespace espalier {

class DocumentFile;
class Settings;
class Tour;
class ViewSettings;
class Workspace;

/// Where a recipe can be played; the program's window implements it.
class RecipeStage {
public:
    virtual ~RecipeStage() = default;
    /// Whether a gesture, growth or a recipe is changing the document now.
    virtual bool isBusy() const = 0;
    /// Ends what is under way and sets the user's own document aside, so that it comes back whole. Asks about
    /// unsaved changes only if one is set aside already; returns false if the one that is shown must stay.
    virtual bool makeRoom() = 0;
    /// Ends what is under way, and starts a recipe that grows another tree in the open document.
    virtual void playRecipe(const Recipe& recipe, RecipeRunner::Pace pace) = 0;
};

/// Shows the help and the tour, and plays the recipes that the help pages name.
class HelpController : public QObject {
    Q_OBJECT

public:
    /// The parts of the program that the help needs. All of them outlive it.
    struct Parts {
        Workspace& workspace;
        const Actions& actions;
        TreeDocument& document;
        DocumentFile& file;
        ViewSettings& viewSettings;
        RecipeRunner& recipeRunner;
        RecipeStage& stage;
        Settings& settings;
    };

    /// @p isSample is the value that isSample() of the controller before this one returned.
    explicit HelpController(const Parts& parts, bool isSample = false);
    ~HelpController() override;

    Tour& tour() { return *m_tour; }
    /// Whether the recipe that the recipe runner plays is a sample.
    bool isSample() const { return m_isSample; }

    /// Opens the help at the page of the current tool or sheet; closes the help if it already shows that
    /// page.
    void toggle();
    /// Closes the tour, or else the help. Returns whether one of them was open.
    bool putAway();
    void startTour();
    /// Starts the tour the first time that it is called for a user of this machine, and never again.
    void startFirstTour();
    /// Plays a recipe that belongs to the program, after the stage has made room for it. A sample that the
    /// user has not edited does not count as a change.
    void playSample(const QString& fileName);

private:
    void close();
    void handOverSample();
    void playForTour(const QString& fileName);
    /// The page of the sheet that has the keyboard focus, or else that of the current tool.
    QString pageAtHand() const;

    Parts m_parts;
    std::unique_ptr<Tour> m_tour;
    bool m_isSample;
    std::optional<int> m_tourGoesOn; ///< With this step, after the recipe that it shows
};

} // namespace espalier
