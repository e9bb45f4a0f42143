// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/AddBudsPopOut.h"

#include "panels/ViewField.h"
#include "panels/ViewRow.h"

#include <QVBoxLayout>

namespace espalier {

namespace {

constexpr int kAddBudsWidth = 140; ///< px

constexpr ViewField kNewBuds{
    {"view.newBuds", Quantity::Count, kLeastNewBuds, kMostNewBuds},
    {"view.newBuds", QT_TRANSLATE_NOOP("Parameters", "Buds"), "",
     QT_TRANSLATE_NOOP("Parameters", "How many buds a tap adds, in a spiral around the branch."),
     ParameterText::Scale::Linear, 0},
    [](const ViewValues& values) { return values.newBuds; },
    [](ViewValues& values, double value) { values.newBuds = value; }};

constexpr ViewField kBudSpacing{
    {"view.budSpacing", Quantity::Metres, 0, kMostBudSpacing},
    {"view.budSpacing", QT_TRANSLATE_NOOP("Parameters", "Spacing"), "",
     QT_TRANSLATE_NOOP("Parameters", "How far one bud is from the next along the branch: 0 is a whorl."),
     ParameterText::Scale::Cubic, 1, "cm", 100.0},
    [](const ViewValues& values) { return values.budSpacing; },
    [](ViewValues& values, double value) { values.budSpacing = value; }};

} // namespace

AddBudsPopOut::AddBudsPopOut(ViewSettings& settings, QWidget* parent) : Bar(parent)
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(14, 10, 14, 8);
    column->setSpacing(4);
    for (const ViewField* field : {&kNewBuds, &kBudSpacing}) {
        ViewRow* row = makeViewRow(*field, settings, this);
        row->setFixedWidth(kAddBudsWidth);
        column->addWidget(row);
    }
}

} // namespace espalier
