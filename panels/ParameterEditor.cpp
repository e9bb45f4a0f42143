// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/ParameterEditor.h"

#include "model/io/ParametersJson.h"
#include "model/tree/LeafShapes.h"
#include "panels/ParameterValue.h"

#include <QScopedValueRollback>

#include <algorithm>
#include <cmath>

namespace espalier {

namespace {

/// ms; key presses with a shorter time between them are one undo step.
constexpr int kRest = 600;

/// Corrects the parameters that contradict the changed one.
void reconcile(GrowthParameters& growth, std::string_view changed)
{
    double* const weights[] = {&growth.axisWeight, &growth.tropismWeight, &growth.spaceWeight};
    const std::string_view keys[] = {"growth.axisWeight", "growth.tropismWeight", "growth.spaceWeight"};
    const bool areWhole =
        std::abs(growth.axisWeight + growth.tropismWeight + growth.spaceWeight - 1.0) < 1e-12;
    for (std::size_t i = 0; i < 3; ++i) {
        if (changed != keys[i] || areWhole)
            continue;
        double& second = *weights[(i + 1) % 3];
        double& third = *weights[(i + 2) % 3];
        const double rest = 1.0 - *weights[i];
        const double share = second + third > 0.0 ? second / (second + third) : 0.5;
        second = rest * share;
        third = rest - second;
        normaliseDirectionWeights(growth);
    }
    const double most = kMostEllipseOffset * growth.ellipseVertical;
    growth.ellipseOffset = std::clamp(growth.ellipseOffset, -most, most);
}

} // namespace

void setParameter(TreeParameters& parameters, const char* key, double value)
{
    const LeafShape shapeBefore = parameters.leaves.shape;
    visitParameter(parameters, key,
                   [&](const ParameterInfo& info, auto& field) { setSurfaceValue(info, field, value); });
    reconcile(parameters.growth, key);
    // Another shape comes in its own proportions; the user may change them then.
    if (parameters.leaves.shape != shapeBefore)
        parameters.leaves.aspect = usualAspect(parameters.leaves.shape);
}

ParameterEditor::ParameterEditor(TreeDocument& document, QObject* parent)
    : QObject(parent), m_document(document), m_gesture(document), m_shown(document.parameters())
{
    m_rest.setSingleShot(true);
    m_rest.setInterval(kRest);
    connect(&m_rest, &QTimer::timeout, this, [this] { hold(false); });
    connect(&document, &TreeDocument::changed, this, [this](const TreeChange& change) {
        const bool parametersMoved =
            !change.delta || change.delta->parametersBefore != change.delta->parametersAfter;
        if (!parametersMoved || m_isOwnChange)
            return;
        hold(false);
        Q_EMIT overtaken();
        show(m_document.parameters());
    });
}

double ParameterEditor::value(const char* key) const
{
    double result = 0.0;
    visitParameter(m_shown, key,
                   [&](const ParameterInfo& info, const auto& field) { result = surfaceValue(info, field); });
    return result;
}

void ParameterEditor::begin()
{
    m_gesture.finish();
    m_nudgedBy = nullptr;
    hold(false);
}

void ParameterEditor::show(const TreeParameters& parameters)
{
    m_shown = parameters;
    Q_EMIT shownChanged();
}

void ParameterEditor::show(const char* key, double value)
{
    TreeParameters parameters = m_shown;
    setParameter(parameters, key, value);
    show(parameters);
}

void ParameterEditor::hold(bool held)
{
    if (std::exchange(m_holds, held) != held)
        m_document.holdParameters(held);
}

void ParameterEditor::putInForce(const QString& text)
{
    if (m_shown != m_document.parameters())
        hold(true);
    const QScopedValueRollback quiet(m_isOwnChange, true);
    // Without room, finish() shows what is in force.
    m_gesture.tryOut(m_shown, text);
}

void ParameterEditor::finish(const QString& text)
{
    putInForce(text);
    hold(false);
    show(m_document.parameters());
}

void ParameterEditor::cancel()
{
    {
        const QScopedValueRollback quiet(m_isOwnChange, true);
        m_gesture.cancel();
    }
    hold(false);
    show(m_document.parameters());
}

void ParameterEditor::nudge(const QObject* by, const TreeParameters& parameters, const QString& text)
{
    if (m_nudgedBy != by || !m_rest.isActive())
        begin();
    m_nudgedBy = by;
    m_rest.start();
    show(parameters);
    putInForce(text);
}

void ParameterEditor::nudge(const QObject* by, const char* key, double value, const QString& text)
{
    TreeParameters parameters = m_shown;
    setParameter(parameters, key, value);
    nudge(by, parameters, text);
}

void ParameterEditor::reset(std::span<const char* const> keys, const QString& text)
{
    cancel();
    const TreeParameters defaults;
    TreeParameters parameters = m_shown;
    const LeafShape shapeBefore = parameters.leaves.shape;
    for (const char* key : keys) {
        visitParameter(parameters, key, [&](const ParameterInfo&, auto& mine) {
            visitParameter(defaults, key, [&](const ParameterInfo&, const auto& original) {
                if constexpr (std::is_same_v<std::remove_cvref_t<decltype(original)>,
                                             std::remove_cvref_t<decltype(mine)>>)
                    mine = original;
            });
        });
    }
    if (!keys.empty())
        reconcile(parameters.growth, keys.back());
    if (parameters.leaves.shape != shapeBefore)
        parameters.leaves.aspect = usualAspect(parameters.leaves.shape);
    show(parameters);
    finish(text);
}

} // namespace espalier
