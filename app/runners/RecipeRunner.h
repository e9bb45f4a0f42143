// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/RecipePlayer.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <memory>

namespace espalier {

/// Plays a recipe in a window that stays alive, so that one sees the tree come into being.
class RecipeRunner : public QObject {
    Q_OBJECT

public:
    enum class Pace {
        OfTheHand, ///< Strokes take the time that the hand took, and what happens at once can be seen
        Hurried,   ///< As fast as it goes, a piece of a stroke at a time
    };

    explicit RecipeRunner(TreeDocument& document, QObject* parent = nullptr);

    /// Starts the document anew with the recipe.
    void start(Recipe recipe, Pace pace);
    /// Ends it where it is; a stroke that is half done is taken back.
    void stop();
    bool isRunning() const { return m_player != nullptr; }
    /// Of the recipe that runs, or of the last one.
    Pace pace() const { return m_pace; }
    /// See RecipePlayer::warnings(); of the recipe that was last played to its end.
    const QStringList& warnings() const { return m_warnings; }
    /// Of the recipe that was started last.
    std::size_t operationCount() const { return m_operationCount; }
    /// Null unless it runs.
    const RecipePlayer* player() const { return m_player.get(); }

Q_SIGNALS:
    void started();
    /// The brush has moved, or the tree has grown.
    void advanced();
    /// @p whole unless it was stopped before the recipe's end.
    void finished(bool whole);

private:
    void advance();

    TreeDocument& m_document;
    std::unique_ptr<RecipePlayer> m_player;
    Pace m_pace = Pace::Hurried;
    QStringList m_warnings;
    std::size_t m_operationCount = 0;
    double m_pause = 0.0; ///< s that the hand still rests
    QTimer m_timer;
    QElapsedTimer m_clock;
};

} // namespace espalier
