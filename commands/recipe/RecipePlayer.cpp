// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/RecipePlayer.h"

#include "commands/recipe/SetParametersOperation.h"

namespace espalier {

RecipePlayer::RecipePlayer(TreeDocument& document, Recipe recipe, Start start)
    : m_document(document), m_recipe(std::move(recipe))
{
    if (start == Start::Anew)
        m_document.reset(m_recipe.seed, m_recipe.parameters);
    else if (const QString warning = SetParametersOperation{m_recipe.parameters}.perform(m_document);
             !warning.isEmpty())
        m_warnings.append(QStringLiteral("parameters: %1").arg(warning));
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
    const RecipeOperation& operation = m_recipe.operations[m_next];
    if (!m_performance)
        m_performance = operation.begin(m_document);
    if (!m_performance->advance(seconds))
        return;
    if (const QString warning = m_performance->warning(); !warning.isEmpty()) {
        m_warnings.append(
            QStringLiteral("operations[%1]: %2: %3").arg(QString::number(m_next), operation.name(), warning));
    }
    m_performance.reset();
    ++m_next;
}

std::optional<BrushSample> RecipePlayer::brush() const
{
    return m_performance ? m_performance->brush() : std::nullopt;
}

} // namespace espalier
