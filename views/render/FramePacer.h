// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/render/RenderOptions.h"

namespace espalier {

/// Decides how well a frame may be drawn (TreeSketch §3.5, speed considerations): plainly while something
/// moves, by how long such frames take on this machine, and at its best at rest, where the shadows that
/// were off are phased in.
class FramePacer {
public:
    /// A frame while moving should take less, s.
    static constexpr double kFrameBudget = 0.030;
    /// Shadows take this long to appear, s.
    static constexpr double kPhaseIn = 0.25;

    /// Steps of saving, each with those before it.
    enum class Saving {
        Nothing,
        ShadowsOfGrowth, ///< No shadows while the tree itself changes
        Shadows,         ///< None while anything moves, and plain light
        HalfThePixels,
        MostPixels, ///< A quarter is drawn
    };

    /// Something moves from now on; @p treeChanges: the tree itself.
    void disturb(bool treeChanges);
    /// All has come to rest.
    void rest();
    bool isAtRest() const { return m_isAtRest && m_shadowStrength >= 1.0; }
    bool isPhasingIn() const { return m_isAtRest && m_shadowStrength < 1.0; }
    /// Phases in; returns whether that changes the picture.
    bool advance(double seconds);

    /// How long the last frame took to draw, s.
    void frameTook(double seconds);

    /// The quality of the next frame, put into @p options.
    void apply(RenderOptions& options) const;
    /// Of the next frame's edges to the view's, 0.5...1.
    double scale() const;
    Saving saving() const { return m_saving; }

private:
    bool showsShadows() const;

    Saving m_saving = Saving::Nothing;
    bool m_isAtRest = true;
    bool m_treeChanges = false;
    double m_shadowStrength = 1.0;
    int m_slowFrames = 0;
};

} // namespace espalier
