// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/ParameterPanel.h"

#include "model/io/ParametersJson.h"
#include "panels/ParameterRow.h"
#include "panels/ParameterValue.h"
#include "panels/SheetScroll.h"

#include <QHBoxLayout>
#include <QScopedValueRollback>
#include <QVBoxLayout>

#include <cstring>

namespace espalier {

namespace {

/// Whether existing wood shows a change of that parameter at once.
bool showsAtOnce(const char* key)
{
    return std::strncmp(key, "growth.", 7) != 0;
}

/// Mends what the change of one parameter makes contradictory: the weights of direction share a whole, and an
/// ellipse's offset stays inside it.
void reconcile(TreeParameters& parameters, std::string_view changed)
{
    GrowthParameters& growth = parameters.growth;
    double* const weights[] = {&growth.axisWeight, &growth.tropismWeight, &growth.spaceWeight};
    const std::string_view keys[] = {"growth.axisWeight", "growth.tropismWeight", "growth.spaceWeight"};
    for (std::size_t i = 0; i < 3; ++i) {
        if (changed != keys[i])
            continue;
        double& second = *weights[(i + 1) % 3];
        double& third = *weights[(i + 2) % 3];
        const double rest = 1.0 - *weights[i];
        const double share = second + third > 0.0 ? second / (second + third) : 0.5;
        second = rest * share;
        third = rest - second;
        normaliseDirectionWeights(growth);
    }
    const double most = 0.95 * growth.ellipseVertical;
    growth.ellipseOffset = std::clamp(growth.ellipseOffset, -most, most);
}

} // namespace

ParameterPanel::ParameterPanel(TreeDocument& document, ParameterSheet sheet, QWidget* parent)
    : Bar(parent), m_document(document), m_gesture(document)
{
    build(sheet);
    showValues();
    connect(&document, &TreeDocument::changed, this, [this](const TreeChange& change) {
        const bool parametersMoved =
            !change.delta || change.delta->parametersBefore != change.delta->parametersAfter;
        if (parametersMoved && !m_isOwnChange)
            showValues();
    });
}

void ParameterPanel::build(ParameterSheet sheet)
{
    auto* content = new QWidget;
    auto* columns = new QHBoxLayout(content);
    columns->setContentsMargins(20, 14, 20, 12);
    columns->setSpacing(18);

    QVBoxLayout* column = nullptr;
    for (const ParameterSection& section : parameterSections()) {
        if (section.sheet != sheet)
            continue;
        if (!section.below) {
            if (column) {
                column->addStretch();
                columns->addWidget(barSeparator(Qt::Vertical, content));
            }
            column = new QVBoxLayout;
            column->setSpacing(8);
            columns->addLayout(column);
        }
        column->addWidget(makeSection(section, content));
    }
    column->addStretch();

    auto* whole = new QVBoxLayout(this);
    whole->setContentsMargins(1, 1, 1, 1);
    whole->addWidget(new SheetScroll(content, this));
}

QWidget* ParameterPanel::makeSection(const ParameterSection& section, QWidget* parent)
{
    auto* box = new QWidget(parent);
    box->setFixedWidth(kSheetColumn);
    auto* lines = new QVBoxLayout(box);
    lines->setContentsMargins(0, 0, 0, 0);
    lines->setSpacing(2);
    lines->addWidget(sheetTitle(parameterTr(section.title), box));
    for (const ParameterText& text : section.parameters) {
        addRow(text, box);
        lines->addWidget(m_rows.back());
    }
    return box;
}

void ParameterPanel::addRow(const ParameterText& text, QWidget* parent)
{
    visitParameter(m_document.parameters(), text.key, [&](const ParameterInfo& info, const auto&) {
        auto* row = new ParameterRow(info, text, parent);
        m_rows.push_back(row);
        connect(row, &ParameterRow::edited, this, [this, row](double value) { edit(*row, value); });
        connect(row, &ParameterRow::gestureEnded, this, [this, row] { finish(*row); });
    });
}

ParameterRow* ParameterPanel::row(const char* key) const
{
    const auto found = std::ranges::find_if(
        m_rows, [&](const ParameterRow* row) { return std::strcmp(row->key(), key) == 0; });
    return found == m_rows.end() ? nullptr : *found;
}

void ParameterPanel::showValues()
{
    m_shown = m_document.parameters();
    for (ParameterRow* row : m_rows) {
        visitParameter(m_shown, row->key(), [&](const ParameterInfo& info, const auto& field) {
            row->setValue(surfaceValue(info, field));
        });
    }
}

void ParameterPanel::edit(const ParameterRow& row, double value)
{
    visitParameter(m_shown, row.key(),
                   [&](const ParameterInfo& info, auto& field) { setSurfaceValue(info, field, value); });
    reconcile(m_shown, row.key());
    for (ParameterRow* other : m_rows) {
        if (other == &row)
            continue;
        visitParameter(m_shown, other->key(), [&](const ParameterInfo& info, const auto& field) {
            if (other->value() != surfaceValue(info, field))
                other->setValue(surfaceValue(info, field));
        });
    }
    if (showsAtOnce(row.key()))
        putInForce(row);
}

void ParameterPanel::finish(const ParameterRow& row)
{
    putInForce(row);
    m_gesture.finish();
    showValues();
}

void ParameterPanel::putInForce(const ParameterRow& row)
{
    const QScopedValueRollback quiet(m_isOwnChange, true);
    m_gesture.tryOut(m_shown, row.accessibleName());
}

} // namespace espalier
