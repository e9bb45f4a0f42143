// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/render/FramePacer.h"

#include <algorithm>
#include <numbers>

namespace espalier {

namespace {

/// Number of slow frames in a row after which the quality is reduced.
constexpr int kPatience = 3;

} // namespace

void FramePacer::disturb(bool treeChanges)
{
    // A movement starts one step better than the last one ended: the tree may be smaller now, or the machine
    // less busy.
    if (m_isAtRest) {
        if (m_saving != Saving::Nothing)
            m_saving = static_cast<Saving>(static_cast<int>(m_saving) - 1);
        m_treeChanges = false;
        m_slowFrames = 0;
    }
    m_isAtRest = false;
    m_treeChanges = m_treeChanges || treeChanges;
    m_shadowStrength = showsShadows() ? 1.0 : 0.0;
}

void FramePacer::rest()
{
    m_isAtRest = true;
    // With slow frames, fading in would be a delay.
    if (m_saving > Saving::ShadowsOfGrowth)
        m_shadowStrength = 1.0;
}

bool FramePacer::advance(double seconds)
{
    if (!isPhasingIn())
        return false;
    m_shadowStrength = std::min(1.0, m_shadowStrength + seconds / kPhaseIn);
    return true;
}

void FramePacer::frameTook(double seconds)
{
    if (m_isAtRest)
        return;
    m_slowFrames = seconds > kFrameBudget ? m_slowFrames + 1 : 0;
    if (m_slowFrames < kPatience || m_saving == Saving::MostPixels)
        return;
    m_slowFrames = 0;
    m_saving = static_cast<Saving>(static_cast<int>(m_saving) + 1);
    m_shadowStrength = showsShadows() ? 1.0 : 0.0;
}

bool FramePacer::showsShadows() const
{
    return m_isAtRest || m_saving == Saving::Nothing ||
           (m_saving == Saving::ShadowsOfGrowth && !m_treeChanges);
}

void FramePacer::apply(RenderOptions& options) const
{
    options.samples = isAtRest() ? m_bestSamples : 1;
    options.shadowStrength = m_shadowStrength;
    options.mayLag = !m_isAtRest;
    options.isPlain = !m_isAtRest && m_saving >= Saving::Shadows;
}

double FramePacer::scale() const
{
    if (m_isAtRest || m_saving < Saving::HalfThePixels)
        return 1.0;
    return m_saving == Saving::HalfThePixels ? std::numbers::sqrt2 / 2.0 : 0.5;
}

} // namespace espalier
