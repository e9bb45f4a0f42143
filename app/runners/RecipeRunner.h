// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/performances/RecipeReplica.h"
#include "model/document/EditFollower.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <memory>
#include <optional>

namespace espalier {

/// Plays a recipe while the window responds, so that the user sees how the tree grows: another thread plays
/// it on a copy, one part ahead, and the document repeats the edits in slices of time.
class RecipeRunner : public QObject {
    Q_OBJECT

public:
    enum class Pace {
        OfTheHand, ///< Strokes take their own time, with pauses around operations that happen at once
        Hurried,   ///< As fast as possible, but strokes still show in parts
    };

    explicit RecipeRunner(TreeDocument& document, QObject* parent = nullptr);

    /// Resets the document and plays @p recipe on it. Stops a recipe that is being played.
    void start(Recipe recipe, Pace pace);
    /// Stops the recipe; the operation under way is taken back, those before it stay.
    void stop();
    bool isRunning() const { return m_follower != nullptr; }
    /// The pace of the present recipe, or of the last one.
    Pace pace() const { return m_pace; }
    /// See RecipePlayer::warnings(); of the recipe that was last played to its end.
    const QStringList& warnings() const { return m_moment.warnings; }
    /// The number of operations of the recipe that was started last.
    std::size_t operationCount() const { return m_recipe.operations.size(); }
    /// What there is to show of the recipe that is being played; null if there is none.
    const RecipeMoment* moment() const { return isRunning() ? &m_moment : nullptr; }

Q_SIGNALS:
    void started();
    /// The recipe was played on for a moment: the brush or the tree may have changed.
    void advanced();
    /// @p whole is false if the recipe was stopped before its end.
    void finished(bool whole);

private:
    void ask(double seconds);
    void receive(RecipePart part);
    void advance();
    void takePart();
    void end(bool whole);

    TreeDocument& m_document;
    Recipe m_recipe;
    Pace m_pace = Pace::Hurried;
    std::shared_ptr<RecipeReplica> m_replica; ///< Null once it has played everything
    std::unique_ptr<EditFollower> m_follower; ///< Null while no recipe is being played
    std::optional<RecipePart> m_next;         ///< Played, but not repeated yet
    bool m_isAsked = false;                   ///< The replica is playing
    RecipeMoment m_moment;                    ///< Of the part that is being repeated
    double m_pause = 0.0;                     ///< The rest of the pause between two operations, s
    QTimer m_timer;
    QElapsedTimer m_clock;
};

} // namespace espalier
