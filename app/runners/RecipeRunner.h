// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/RecipePlayer.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <memory>

namespace espalier {

/// Plays a recipe in a window that stays responsive, so that the user sees how the tree grows.
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
    bool isRunning() const { return m_player != nullptr; }
    /// The pace of the present recipe, or of the last one.
    Pace pace() const { return m_pace; }
    /// See RecipePlayer::warnings(); of the recipe that was last played to its end.
    const QStringList& warnings() const { return m_warnings; }
    /// The number of operations of the recipe that was started last.
    std::size_t operationCount() const { return m_operationCount; }
    /// Null if no recipe is being played.
    const RecipePlayer* player() const { return m_player.get(); }

Q_SIGNALS:
    void started();
    /// The recipe was played on for a moment: the brush or the tree may have changed.
    void advanced();
    /// @p whole is false if the recipe was stopped before its end.
    void finished(bool whole);

private:
    void advance();

    TreeDocument& m_document;
    std::unique_ptr<RecipePlayer> m_player;
    Pace m_pace = Pace::Hurried;
    QStringList m_warnings;
    std::size_t m_operationCount = 0;
    double m_pause = 0.0; ///< The rest of the pause between two operations, s
    QTimer m_timer;
    QElapsedTimer m_clock;
};

} // namespace espalier
