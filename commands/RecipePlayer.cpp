// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/RecipePlayer.h"

#include "commands/BendGesture.h"
#include "commands/Prune.h"
#include "commands/SetParameters.h"
#include "commands/TimeGesture.h"
#include "commands/WidthGesture.h"

#include <algorithm>

namespace espalier {

namespace {

/// Pace of a demonstration.
constexpr double kGrowthStepsPerSecond = 12.0;

template <class... Handlers>
struct Overloaded : Handlers... {
    using Handlers::operator()...;
};

void bend(TreeDocument& document, const BendOperation& operation)
{
    std::vector<BranchBend::Handle> handles;
    std::vector<Vec3> targets;
    for (const BendOperation::Handle& handle : operation.handles) {
        handles.push_back({handle.internode, handle.along});
        targets.push_back(handle.target);
    }
    BendGesture gesture(document, operation.base, std::move(handles),
                        {.stretching = operation.stretching, .bending = operation.bending});
    gesture.settleAt(targets);
    gesture.finish();
}

} // namespace

RecipePlayer::RecipePlayer(TreeDocument& document, Recipe recipe, Start start)
    : m_document(document), m_recipe(std::move(recipe))
{
    if (start == Start::Anew)
        m_document.reset(m_recipe.seed, m_recipe.parameters);
    else
        setParameters(m_document, m_recipe.parameters);
}

RecipePlayer::~RecipePlayer() = default;

bool RecipePlayer::isDone() const
{
    return m_next == m_recipe.operations.size();
}

double RecipePlayer::progress() const
{
    return isDone() ? 1.0 : static_cast<double>(m_next) / static_cast<double>(m_recipe.operations.size());
}

void RecipePlayer::playAll()
{
    while (!isDone())
        playOperation();
}

void RecipePlayer::playOperation()
{
    const std::size_t operation = m_next;
    while (m_next == operation && !isDone())
        advance(std::numeric_limits<double>::infinity());
}

void RecipePlayer::advance(double seconds)
{
    if (isDone())
        return;
    const bool isDoneNow = std::visit(
        Overloaded{
            [&](const SetParametersOperation& operation) {
                setParameters(m_document, operation.parameters);
                return true;
            },
            [&](const BrushStrokeOperation& operation) { return advanceStroke(operation, seconds); },
            [&](const GrowOperation& operation) { return advanceGrowth(operation, seconds); },
            [&](const PruneOperation& operation) {
                pruneBranches(m_document, operation.internodes);
                return true;
            },
            [&](const TravelOperation& operation) {
                TimeGesture gesture(m_document);
                const auto here = static_cast<std::int64_t>(m_document.journal().size());
                const auto end = static_cast<std::int64_t>(gesture.historyLength());
                gesture.moveTo(
                    static_cast<std::size_t>(std::clamp(here + operation.by, std::int64_t{0}, end)));
                gesture.finish();
                return true;
            },
            [&](const UndoOperation& operation) {
                for (int i = 0; i < operation.count; ++i)
                    m_document.undoStack().undo();
                return true;
            },
            [&](const RedoOperation& operation) {
                for (int i = 0; i < operation.count; ++i)
                    m_document.undoStack().redo();
                return true;
            },
            [&](const BendOperation& operation) {
                bend(m_document, operation);
                return true;
            },
            [&](const SetWidthOperation& operation) {
                setWidth(m_document, operation.internode, operation.diameter);
                return true;
            },
            [&](const LassoOperation& operation) {
                return advanceLasso(
                    [&] { return LassoGesture::fill(m_document, operation.stroke, operation.competitors); },
                    seconds);
            },
            [&](const RegrowOperation&) {
                return advanceLasso([&] { return LassoGesture::regrow(m_document); }, seconds);
            },
            [&](const RemoveLassoOperation&) {
                removeEnvelopes(m_document);
                return true;
            },
        },
        m_recipe.operations[m_next]);
    if (isDoneNow)
        ++m_next;
}

bool RecipePlayer::advanceStroke(const BrushStrokeOperation& operation, double seconds)
{
    const std::vector<BrushSample>& samples = operation.samples;
    if (!m_stroke) {
        m_stroke = std::make_unique<BrushGesture>(m_document, samples.front(), operation.competitors);
        m_strokeTime = samples.front().time;
        m_nextSample = 1;
    }
    m_strokeTime += seconds;
    for (; m_nextSample < samples.size() && samples[m_nextSample].time <= m_strokeTime; ++m_nextSample)
        m_stroke->add(samples[m_nextSample]);
    if (m_nextSample < samples.size()) {
        m_stroke->moveToward(samples[m_nextSample], m_strokeTime);
        return false;
    }
    m_stroke->finish();
    m_stroke.reset();
    return true;
}

bool RecipePlayer::advanceGrowth(const GrowOperation& operation, double seconds)
{
    if (!m_growth) {
        m_growth = std::make_unique<GrowGesture>(m_document, operation.competitors);
        m_growthSteps = 0;
        m_growthDue = 0.0;
    }
    m_growthDue += seconds * kGrowthStepsPerSecond;
    for (; m_growthSteps < operation.steps; ++m_growthSteps, m_growthDue -= 1.0) {
        if (m_growthDue < 1.0)
            return false;
        if (!m_growth->step())
            break;
    }
    m_growth->finish();
    m_growth.reset();
    return true;
}

/// @p begin gives the gesture, or an Error: there is nothing to fill then.
template <class Begin>
bool RecipePlayer::advanceLasso(Begin&& begin, double seconds)
{
    if (!m_lasso) {
        LassoGesture::Begun begun = begin();
        if (!begun)
            return true;
        m_lasso = std::move(*begun);
        m_growthDue = 0.0;
    }
    for (m_growthDue += seconds * kGrowthStepsPerSecond; m_growthDue >= 1.0; m_growthDue -= 1.0) {
        if (!m_lasso->step()) {
            m_lasso->finish();
            m_lasso.reset();
            return true;
        }
    }
    return false;
}

std::optional<BrushSample> RecipePlayer::brush() const
{
    if (!m_stroke)
        return std::nullopt;
    return m_stroke->path().back();
}

} // namespace espalier
