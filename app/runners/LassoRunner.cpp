// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/runners/LassoRunner.h"

#include "commands/recipe/LassoJson.h"
#include "model/envelope/LassoLoop.h"

namespace espalier {

void LassoRunner::fill(const LassoStroke& stroke)
{
    end();
    document().interruptEdit();
    start(LassoGesture::fill(document(), stroke, document().competitors()));
}

void LassoRunner::fillAll(std::span<const LassoStroke> strokes)
{
    end();
    document().interruptEdit();
    std::vector<LassoStroke> all = document().tree().lassosInForce();
    for (LassoStroke stroke : strokes) {
        stroke.points = simplified(stroke.points);
        all.push_back(recordableLasso(std::move(stroke)));
    }
    start(LassoGesture::fillAll(document(), all, document().parameters(), document().competitors()));
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
