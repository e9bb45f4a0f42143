// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/RecipeRunner.h"

namespace espalier {

namespace {

constexpr int kTick = 16;             ///< ms
constexpr double kLongestTick = 0.1;  ///< s; a slow machine takes longer, but never jumps
constexpr double kHurriedTick = 0.25; ///< s of the recipe's time

} // namespace

RecipeRunner::RecipeRunner(TreeDocument& document, QObject* parent) : QObject(parent), m_document(document)
{
    connect(&m_timer, &QTimer::timeout, this, &RecipeRunner::advance);
}

void RecipeRunner::start(Recipe recipe, Pace pace)
{
    stop();
    m_pace = pace;
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
    m_player->advance(m_pace == Pace::Hurried ? kHurriedTick : std::min(seconds, kLongestTick));
    Q_EMIT advanced();
    if (m_player->isDone()) {
        m_timer.stop();
        m_player.reset();
        Q_EMIT finished(true);
    }
}

} // namespace espalier
