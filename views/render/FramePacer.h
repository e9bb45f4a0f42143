// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/render/RenderOptions.h"

namespace espalier {

/// Chooses the quality of frames (TreeSketch §3.5, speed considerations): lower while something moves,
/// depending on how long such frames take on this machine, and the highest at rest, where shadows that were
/// off fade in.
class FramePacer {
public:
    /// A frame while moving should take less, s.
    static constexpr double kFrameBudget = 0.030;
    /// Shadows take this long to appear, s.
    static constexpr double kPhaseIn = 0.25;

    /// Steps of saving; each step includes those before it.
    enum class Saving {
        Nothing,
        ShadowsOfGrowth, ///< No shadows while the tree itself changes
        Shadows,         ///< No shadows while anything moves, and plain light
        HalfThePixels,
        MostPixels, ///< Only a quarter of the pixels is drawn
    };

    /// The number of passes for a picture at rest, 1...kBestSamples.
    int bestSamples() const { return m_bestSamples; }
    void setBestSamples(int samples) { m_bestSamples = samples; }

    /// Something begins to move; @p treeChanges: the tree itself changes.
    void disturb(bool treeChanges);
    /// All motion has ended.
    void rest();
    bool isAtRest() const { return m_isAtRest && m_shadowStrength >= 1.0; }
    bool isPhasingIn() const { return m_isAtRest && m_shadowStrength < 1.0; }
    /// Continues to fade shadows in; returns whether that changes the picture.
    bool advance(double seconds);

    /// Reports how long the last frame took to draw, s.
    void frameTook(double seconds);

    /// Sets the quality of the next frame in @p options.
    void apply(RenderOptions& options) const;
    /// Size of the next frame relative to the view, along an edge, 0.5...1.
    double scale() const;
    Saving saving() const { return m_saving; }

private:
    bool showsShadows() const;

    int m_bestSamples = RenderOptions::kBestSamples;
    Saving m_saving = Saving::Nothing;
    bool m_isAtRest = true;
    bool m_treeChanges = false;
    double m_shadowStrength = 1.0;
    int m_slowFrames = 0;
};

} // namespace espalier
