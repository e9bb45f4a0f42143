// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/runners/RecipeRunner.h"
#include "panels/Actions.h"

#include <QObject>

#include <memory>

namespace espalier {

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
    /// Ends the stroke under the hand and asks about unsaved changes; false if the document is to stay.
    virtual bool mayLeave() = 0;
    /// Ends what is under way, and lets a recipe grow another tree in the open document.
    virtual void playRecipe(const Recipe& recipe, RecipeRunner::Pace pace) = 0;
};

/// What a person asks for who wants to know: the help, a recipe of it that plays, and the tour.
class HelpController : public QObject {
    Q_OBJECT

public:
    /// The parts of the program that the help needs. All of them outlive it.
    struct Parts {
        Workspace& workspace;
        const Actions& actions;
        TreeDocument& document;
        ViewSettings& viewSettings;
        RecipeRunner& recipeRunner;
        RecipeStage& stage;
        Settings& settings;
    };

    /// @p isSample is what the one before it says.
    explicit HelpController(const Parts& parts, bool isSample = false);
    ~HelpController() override;

    Tour& tour() { return *m_tour; }
    /// Whether what the recipe runner plays is a sample.
    bool isSample() const { return m_isSample; }

    /// Opens the help at the page of what is at hand; closes it if that is what it shows.
    void toggle();
    /// Puts away the tour, or else the help; whether there was one.
    bool putAway();
    void startTour();
    /// Shows a newcomer around: the first time that it is called on a person's machine, and never again.
    void startFirstTour();
    /// Plays a recipe that belongs to the program. Asks about unsaved changes first; its own tree is none, as
    /// long as nobody works on it.
    void playSample(const QString& fileName);

private:
    void close();
    void handOverSample();
    /// Of the sheet that has the keys, or else of the tool in hand.
    QString pageAtHand() const;

    Parts m_parts;
    std::unique_ptr<Tour> m_tour;
    bool m_isSample;
};

} // namespace espalier
