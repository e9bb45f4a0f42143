// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/FineDrag.h"

#include <algorithm>

namespace espalier {

namespace {

/// Up to this distance from the track a drag is as fast as the pointer, px.
constexpr double kNear = 40.0;
constexpr double kWithShift = 1.0 / 8.0;

} // namespace

void FineDrag::begin(double place, double pointer)
{
    m_place = place;
    m_pointer = pointer;
}

void FineDrag::move(double pointer, double away, bool isShiftHeld)
{
    const double share = kNear / std::max(away, kNear);
    m_place += share * share * (isShiftHeld ? kWithShift : 1.0) * (pointer - m_pointer);
    m_pointer = pointer;
}

} // namespace espalier
