// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/BrushPopOut.h"

#include "panels/BrushControls.h"
#include "panels/ViewRow.h"

#include <QVBoxLayout>

namespace espalier {

namespace {

constexpr int kBrushPopOutWidth = 140; ///< px

} // namespace

BrushPopOut::BrushPopOut(const TreeDocument& document, ViewSettings& settings, QWidget* parent) : Bar(parent)
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(14, 14, 14, 6);
    column->setSpacing(0);
    column->addWidget(new BrushRadius(document, settings, this), 1);
    column->addSpacing(8);
    for (ViewRow* row : {makeBrushPlaneRow(settings, this), makeSymmetryRow(settings, this)}) {
        row->setFixedWidth(kBrushPopOutWidth);
        column->addWidget(row);
    }
    for (const BrushSwitch which : {BrushSwitch::Pressure, BrushSwitch::Markers})
        column->addWidget(makeBrushSwitch(which, settings, this));
}

} // namespace espalier
