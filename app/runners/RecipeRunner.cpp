// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/runners/RecipeRunner.h"

#include "app/runners/Background.h"
#include "model/base/Parallel.h"

#include <algorithm>

namespace espalier {

namespace {

using std::chrono::milliseconds;

constexpr int kTick = 16;                ///< ms
constexpr milliseconds kSlice{6};        ///< Of repeated edits between two events
constexpr double kLongestTick = 0.1;     ///< s; on a slow machine the recipe slows down, without jumps
constexpr double kHurriedTick = 0.25;    ///< s of the recipe's time in each call of RecipePlayer::advance()
constexpr milliseconds kHurriedWork{40}; ///< Of the other thread, for one part
constexpr double kRest = 0.9;            ///< s before and after an operation that happens at once
constexpr double kFilmStep = 0.12;       ///< s between operations of the same kind: travels look like a film

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
    m_recipe = std::move(recipe);
    m_pace = pace;
    m_pause = 0.0;
    m_moment = {};
    m_moment.isDone = m_recipe.operations.empty();
    m_document.reset(m_recipe.seed, m_recipe.parameters);
    m_follower = std::make_unique<EditFollower>(m_document, [this] { stop(); });
    m_clock.start();
    m_timer.start(pace == Pace::Hurried ? 0 : kTick);
    if (!m_moment.isDone)
        m_replica = std::make_shared<RecipeReplica>(m_recipe);
    Q_EMIT started();
}

void RecipeRunner::stop()
{
    if (isRunning())
        end(false);
}

void RecipeRunner::end(bool whole)
{
    m_timer.stop();
    m_replica.reset();
    m_next.reset();
    m_isAsked = false;
    m_follower.reset();
    Q_EMIT finished(whole);
}

/// Lets the replica play the next part, of @p seconds or, in a hurry, of kHurriedWork.
void RecipeRunner::ask(double seconds)
{
    m_isAsked = true;
    const milliseconds work = m_pace == Pace::Hurried ? kHurriedWork : milliseconds(0);
    runInBackground(
        this,
        [replica = m_replica, seconds, work] {
            return leavingOneThread([&] { return replica->advance(seconds, work); });
        },
        [this, asked = std::weak_ptr(m_replica)](RecipePart part) {
            // The part of a recipe that was stopped is not used.
            if (m_replica && asked.lock() == m_replica)
                receive(std::move(part));
        });
}

void RecipeRunner::receive(RecipePart part)
{
    m_isAsked = false;
    if (part.moment.isDone)
        m_replica.reset();
    m_next = std::move(part);
    if (m_pace == Pace::Hurried)
        m_timer.start(); // It stops when there is nothing to repeat.
    else
        advance();
}

/// Begins to repeat the part that was played last.
void RecipeRunner::takePart()
{
    const std::size_t before = m_moment.operation;
    m_follower->add(std::move(m_next->events));
    m_moment = std::move(m_next->moment);
    m_next.reset();
    const std::size_t after = m_moment.operation;
    if (m_pace == Pace::OfTheHand && after != before && !m_moment.isDone)
        m_pause = restBetween(m_recipe.operations[before], m_recipe.operations[after]);
}

void RecipeRunner::advance()
{
    const double seconds = std::min(static_cast<double>(m_clock.restart()) / 1000.0, kLongestTick);
    if (!m_follower->isInStep()) {
        stop();
        return;
    }
    if (!m_follower->isWaiting() && m_next)
        takePart();
    const bool isRepeating = m_follower->isWaiting() && m_follower->advance(kSlice);
    const bool isHurried = m_pace == Pace::Hurried;
    if (m_replica && !m_isAsked && !m_next) {
        if (isHurried)
            ask(kHurriedTick);
        else if (m_pause > 0.0)
            m_pause -= seconds;
        else if (!isRepeating)
            ask(seconds);
    }
    Q_EMIT advanced();
    if (!isRunning() || isRepeating || m_next)
        return;
    if (m_moment.isDone)
        end(true);
    else if (isHurried)
        m_timer.stop();
}

} // namespace espalier
