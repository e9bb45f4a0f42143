// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/render/RenderOptions.h"

namespace espalier {

/// Chooses the quality of frames (TreeSketch §3.5, speed considerations): lower while something moves,
/// depending on how long such frames take on this machine, and the highest at rest. What is saved changes
/// neither brightness nor colour, so that the tree can be judged while it moves.
class FramePacer {
public:
    /// A frame while moving should take less, s.
    static constexpr double kFrameBudget = 0.030;
    /// Of so many frames with earlier shadows, one makes them anew.
    static constexpr int kShadowFrames = 4;

    /// Steps of saving; each step includes those before it.
    enum class Saving {
        Nothing,
        EarlierShadows, ///< Shadows follow now and then
        PlainLight,     ///< Light is computed per vertex
        HalfThePixels,
        MostPixels, ///< Only a quarter of the pixels is drawn
    };

    /// The number of passes for a picture at rest, 1...kBestSamples.
    int bestSamples() const { return m_bestSamples; }
    void setBestSamples(int samples) { m_bestSamples = samples; }

    /// Something moves.
    void disturb();
    /// All motion has ended.
    void rest() { m_isAtRest = true; }
    bool isAtRest() const { return m_isAtRest; }

    /// Reports how long the last frame took to draw, s.
    void frameTook(double seconds);

    /// Sets the quality of the next frame in @p options.
    void apply(RenderOptions& options) const;
    /// Size of the next frame relative to the view, along an edge, 0.5...1.
    double scale() const;
    Saving saving() const { return m_saving; }

private:
    int m_bestSamples = RenderOptions::kBestSamples;
    Saving m_saving = Saving::Nothing;
    bool m_isAtRest = true;
    int m_slowFrames = 0;
    int m_frames = 0; ///< Since the movement began
};

} // namespace espalier
