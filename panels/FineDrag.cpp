// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/FineDrag.h"

#include <algorithm>

namespace espalier {

namespace {

/// Up to this distance from the track a drag is as fast as the pointer, px.
constexpr double kNear = 40.0;
constexpr double kWithShift = 1.0 / 8.0;

} // namespace

void FineDrag::begin(double place, double pointer, double least, double most)
{
    m_least = least;
    m_most = most;
    m_place = place;
    m_pointer = pointer;
}

void FineDrag::move(double pointer, double away, bool isShiftHeld)
{
    const double share = kNear / std::max(away, kNear);
    const double way = share * share * (isShiftHeld ? kWithShift : 1.0) * (pointer - m_pointer);
    m_place = std::clamp(m_place + way, m_least, m_most);
    m_pointer = pointer;
}

} // namespace espalier
