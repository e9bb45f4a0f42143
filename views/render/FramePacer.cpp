// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/render/FramePacer.h"

#include <algorithm>
#include <numbers>

namespace espalier {

namespace {

/// Number of slow frames in a row after which the quality is reduced.
constexpr int kPatience = 3;

} // namespace

void FramePacer::disturb()
{
    if (!m_isAtRest)
        return;
    // A movement starts one step better than the last one ended: the tree may be smaller now, or the machine
    // less busy.
    if (m_saving != Saving::Nothing)
        m_saving = static_cast<Saving>(static_cast<int>(m_saving) - 1);
    m_slowFrames = 0;
    m_frames = 0;
    m_isAtRest = false;
}

void FramePacer::frameTook(double seconds)
{
    if (m_isAtRest)
        return;
    ++m_frames;
    m_slowFrames = seconds > kFrameBudget ? m_slowFrames + 1 : 0;
    if (m_slowFrames < kPatience || m_saving == Saving::MostPixels)
        return;
    m_slowFrames = 0;
    m_saving = static_cast<Saving>(static_cast<int>(m_saving) + 1);
}

void FramePacer::apply(RenderOptions& options) const
{
    options.samples = m_isAtRest ? m_bestSamples : 1;
    options.mayLag = !m_isAtRest;
    options.keepsShadows = !m_isAtRest && m_saving >= Saving::EarlierShadows && m_frames % kShadowFrames != 0;
    options.isPlain = !m_isAtRest && m_saving >= Saving::PlainLight;
}

double FramePacer::scale() const
{
    if (m_isAtRest || m_saving < Saving::HalfThePixels)
        return 1.0;
    return m_saving == Saving::HalfThePixels ? std::numbers::sqrt2 / 2.0 : 0.5;
}

} // namespace espalier
