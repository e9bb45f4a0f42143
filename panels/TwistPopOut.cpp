// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/TwistPopOut.h"

#include "panels/ViewField.h"
#include "panels/ViewRow.h"

#include <QVBoxLayout>

namespace espalier {

namespace {

constexpr ViewField kTwistsSubtree = viewSwitch<&ViewValues::twistsSubtree>(
    "view.twistsSubtree", QT_TRANSLATE_NOOP("Parameters", "Branches too"),
    QT_TRANSLATE_NOOP("Parameters", "A drag twists all that the branch carries, not only the branch itself. "
                                    "Hold Shift for the opposite."));

} // namespace

TwistPopOut::TwistPopOut(ViewSettings& settings, QWidget* parent) : Bar(parent)
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(14, 6, 14, 6);
    column->addWidget(makeViewRow(kTwistsSubtree, settings, this));
}

} // namespace espalier
