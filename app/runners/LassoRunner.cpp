// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/runners/LassoRunner.h"

namespace espalier {

void LassoRunner::fill(const LassoStroke& stroke)
{
    end();
    document().interruptEdit();
    start(LassoGesture::fill(document(), stroke, document().competitors()));
}

void LassoRunner::regrow()
{
    end();
    start(LassoGesture::regrow(document()));
}

void LassoRunner::start(LassoGesture::Begun begun)
{
    if (!begun) {
        Q_EMIT refused(begun.error().message);
        return;
    }
    const auto goOn = [this]() -> std::unique_ptr<GrowthGesture> {
        LassoGesture::Begun again = LassoGesture::goOn(document(), document().competitors());
        if (again)
            return std::move(*again);
        Q_EMIT refused(again.error().message);
        return nullptr;
    };
    GrowthRunner::start(std::move(*begun), {kEndless, 1000 / kStepsPerSecond}, goOn);
}

} // namespace espalier
