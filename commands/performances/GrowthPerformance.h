// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/GrowthGesture.h"
#include "commands/recipe/Performance.h"

#include <limits>
#include <memory>

namespace espalier {

/// Performs a growth gesture, twelve steps a second.
class GrowthPerformance : public Performance {
public:
    explicit GrowthPerformance(std::unique_ptr<GrowthGesture> gesture,
                               int mostSteps = std::numeric_limits<int>::max());

    bool advance(double seconds) override;
    /// That growth has stopped because the machine's memory holds no more, or empty.
    QString warning() const override { return m_ceilingWarning; }

protected:
    const GrowthGesture& gesture() const { return *m_gesture; }

private:
    std::unique_ptr<GrowthGesture> m_gesture;
    std::uint32_t m_ceiling;
    QString m_ceilingWarning;
    int m_mostSteps;
    int m_steps = 0;
    double m_due = 0.0; ///< Steps that are due, with a fraction
};

} // namespace espalier
