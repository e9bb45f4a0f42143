// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/RemoveLassoOperation.h"

#include "commands/LassoGesture.h"

#include <QCoreApplication>

namespace espalier {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Recipe)
};

} // namespace

QString RemoveLassoOperation::perform(TreeDocument& document) const
{
    return removeEnvelopes(document) ? QString() : Text::tr("there is no envelope");
}

} // namespace espalier
