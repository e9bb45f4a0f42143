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
    /// The greatest speed of filling, steps per second.
    static constexpr int kStepsPerSecond = 24;

    using GrowthRunner::GrowthRunner;

    /// See LassoGesture::fill(); an error is reported by refused(). Ends growth that is under way.
    void fill(const LassoStroke& stroke) override;
    /// See LassoGesture::fillAll(): beside the envelopes in force. The strokes need not be simplified.
    void fillAll(std::span<const LassoStroke> strokes) override;
    void end() override { GrowthRunner::end(); }
    std::span<const Vec3> markers() const override
    {
        return gesture() ? gesture()->markers() : std::span<const Vec3>();
    }
    /// See LassoGesture::regrow(); an error is reported by refused(). Ends growth that is under way.
    void regrow();

Q_SIGNALS:
    /// Nothing was begun; @p why is one sentence for the user.
    void refused(const QString& why);

private:
    void start(LassoGesture::Begun begun);
};

} // namespace espalier
