// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/RecipePlayer.h"

#include "commands/SetParameters.h"

namespace espalier {

namespace {

/// Pace of a demonstration.
constexpr double kGrowthStepsPerSecond = 12.0;

/// s; samples further apart are filled up, so that a demonstration moves evenly. It is done for every replay, so that all are the same.
constexpr double kLongestGap = 1.0 / 30.0;

std::vector<BrushSample> withoutGaps(const std::vector<BrushSample>& samples)
{
    std::vector<BrushSample> dense{samples.front()};
    for (std::size_t i = 1; i < samples.size(); ++i) {
        const double gap = samples[i].time - samples[i - 1].time;
        const int parts = std::max(1, static_cast<int>(std::ceil(gap / kLongestGap)));
        for (int part = 1; part < parts; ++part)
            dense.push_back(between(samples[i - 1], samples[i], samples[i - 1].time + gap * part / parts));
        dense.push_back(samples[i]);
    }
    return dense;
}

template <class... Handlers>
struct Overloaded : Handlers... {
    using Handlers::operator()...;
};

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
        },
        m_recipe.operations[m_next]);
    if (isDoneNow)
        ++m_next;
}

bool RecipePlayer::advanceStroke(const BrushStrokeOperation& operation, double seconds)
{
    if (!m_stroke) {
        m_samples = withoutGaps(operation.samples);
        m_stroke = std::make_unique<BrushGesture>(m_document, m_samples.front());
        m_strokeTime = m_samples.front().time;
        m_nextSample = 1;
    }
    m_strokeTime += seconds;
    for (; m_nextSample < m_samples.size() && m_samples[m_nextSample].time <= m_strokeTime; ++m_nextSample)
        m_stroke->add(m_samples[m_nextSample]);
    if (m_nextSample < m_samples.size())
        return false;
    m_stroke->finish();
    m_stroke.reset();
    return true;
}

bool RecipePlayer::advanceGrowth(const GrowOperation& operation, double seconds)
{
    if (!m_growth) {
        m_growth = std::make_unique<GrowGesture>(m_document);
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

std::optional<BrushSample> RecipePlayer::brush() const
{
    if (!m_stroke)
        return std::nullopt;
    return m_stroke->samples().back();
}

} // namespace espalier
