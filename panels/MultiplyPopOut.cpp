// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/MultiplyPopOut.h"

#include "panels/ViewField.h"
#include "panels/ViewRow.h"

#include <QVBoxLayout>

namespace espalier {

namespace {

constexpr ViewField kPassesOn = viewSwitch<&ViewValues::passesOn>(
    "view.passesOn", QT_TRANSLATE_NOOP("Parameters", "Pass on"),
    QT_TRANSLATE_NOOP("Parameters",
                      "A tap on a branch gives other branches what it carries. Otherwise it adds one "
                      "branch like those that the branch carries."));
constexpr ViewField kPassesOnInOrder = viewSwitch<&ViewValues::passesOnInOrder>(
    "view.passesOnInOrder", QT_TRANSLATE_NOOP("Parameters", "Only to similar ones"),
    QT_TRANSLATE_NOOP("Parameters", "Only branches that are equally many forks away from the trunk get it."));
constexpr ViewField kPassesOnScaled = viewSwitch<&ViewValues::passesOnScaled>(
    "view.passesOnScaled", QT_TRANSLATE_NOOP("Parameters", "Scaled"),
    QT_TRANSLATE_NOOP("Parameters", "What a branch gets is scaled to the size of that branch. Otherwise it "
                                    "keeps its size, and its distance from the tip."));
constexpr ViewField kPassesOnAnew = viewSwitch<&ViewValues::passesOnAnew>(
    "view.passesOnAnew", QT_TRANSLATE_NOOP("Parameters", "Replace"),
    QT_TRANSLATE_NOOP("Parameters", "What the branches carried until now is removed."));

} // namespace

MultiplyPopOut::MultiplyPopOut(ViewSettings& settings, QWidget* parent) : Bar(parent)
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(14, 6, 14, 6);
    for (const ViewField* field : {&kPassesOn, &kPassesOnInOrder, &kPassesOnScaled, &kPassesOnAnew})
        column->addWidget(makeViewRow(*field, settings, this));
}

} // namespace espalier
