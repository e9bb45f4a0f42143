// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/runners/GrowthRunner.h"
#include "commands/LassoGesture.h"
#include "views/tools/LassoTool.h"

namespace espalier {

/// Lets a tree fill envelopes, slowly enough to be watched.
class LassoRunner : public GrowthRunner, public EnvelopeFilling {
    Q_OBJECT

public:
    /// How fast envelopes are filled, steps a second at most.
    static constexpr int kStepsPerSecond = 24;

    using GrowthRunner::GrowthRunner;

    /// See LassoGesture::fill(); says refused() if that gives an error. Ends what is under way.
    void fill(const LassoStroke& stroke) override;
    void end() override { GrowthRunner::end(); }
    std::span<const Vec3> markers() const override
    {
        return gesture() ? gesture()->markers() : std::span<const Vec3>();
    }
    /// See LassoGesture::regrow().
    void regrow();

Q_SIGNALS:
    /// In one sentence, why nothing was begun.
    void refused(const QString& why);

private:
    void start(LassoGesture::Begun begun);
};

} // namespace espalier
