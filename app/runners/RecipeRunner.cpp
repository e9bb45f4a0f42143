// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/runners/RecipeRunner.h"

namespace espalier {

namespace {

constexpr int kTick = 16;             ///< ms
constexpr double kLongestTick = 0.1;  ///< s; on a slow machine the recipe slows down, without jumps
constexpr double kHurriedTick = 0.25; ///< s of the recipe's time in each call of RecipePlayer::advance()
constexpr int kHurriedWork = 25;      ///< ms of work, at least, between two pictures
constexpr double kRest = 0.9;         ///< s before and after an operation that happens at once
constexpr double kFilmStep = 0.12;    ///< s between operations of the same kind: travels look like a film

/// The pause between two operations, s.
double restBetween(const RecipeOperation& before, const RecipeOperation& after)
{
    if (before.takesTime() && after.takesTime())
        return 0.0;
    return before.name() == after.name() ? kFilmStep : kRest;
}

} // namespace

RecipeRunner::RecipeRunner(TreeDocument& document, QObject* parent) : QObject(parent), m_document(document)
{
    connect(&m_timer, &QTimer::timeout, this, &RecipeRunner::advance);
}

void RecipeRunner::start(Recipe recipe, Pace pace)
{
    stop();
    m_pace = pace;
    m_pause = 0.0;
    m_warnings.clear();
    m_operationCount = recipe.operations.size();
    m_player = std::make_unique<RecipePlayer>(m_document, std::move(recipe));
    m_clock.start();
    m_timer.start(pace == Pace::Hurried ? 0 : kTick);
    Q_EMIT started();
}

void RecipeRunner::stop()
{
    if (!isRunning())
        return;
    m_timer.stop();
    m_player.reset();
    Q_EMIT finished(false);
}

void RecipeRunner::advance()
{
    const double seconds = static_cast<double>(m_clock.restart()) / 1000.0;
    const bool isHurried = m_pace == Pace::Hurried;
    if (!isHurried && m_pause > 0.0) {
        m_pause -= seconds;
        return;
    }
    const RecipeOperation* before = m_player->operation();
    if (isHurried) {
        QElapsedTimer work;
        work.start();
        do {
            m_player->advance(kHurriedTick);
        } while (!m_player->isDone() && work.elapsed() < kHurriedWork);
    } else {
        m_player->advance(std::min(seconds, kLongestTick));
    }
    const RecipeOperation* after = m_player->operation();
    if (before && after && after != before)
        m_pause = restBetween(*before, *after);
    Q_EMIT advanced();
    if (m_player->isDone()) {
        m_timer.stop();
        m_warnings = m_player->warnings();
        m_player.reset();
        Q_EMIT finished(true);
    }
}

} // namespace espalier
