// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/BrushGesture.h"
#include "commands/LassoGesture.h"

#include <QStringList>

#include <limits>
#include <memory>

namespace espalier {

/// An operation of a recipe while it is done to a document. One that is destroyed before its end leaves the
/// document as it was.
class Performance {
public:
    Performance() = default;
    virtual ~Performance() = default;
    Performance(const Performance&) = delete;
    Performance& operator=(const Performance&) = delete;

    /// Goes on by @p seconds of a demonstration, infinity for all that is left; true when the operation is
    /// done.
    virtual bool advance(double seconds) = 0;
    /// What the operation, now done, did not find or could not do ("there is no internode 712"); empty if
    /// there is no such thing.
    virtual QString warning() const { return {}; }

    /// The stroke that is being made, or null.
    virtual const BrushGesture* stroke() const { return nullptr; }
    /// The envelope that is being filled, or null.
    virtual const LassoGesture* lasso() const { return nullptr; }
};

/// Growth that goes twelve steps a second.
class GrowthPerformance : public Performance {
public:
    explicit GrowthPerformance(std::unique_ptr<GrowthGesture> gesture,
                               int mostSteps = std::numeric_limits<int>::max());

    bool advance(double seconds) override;

protected:
    const GrowthGesture& gesture() const { return *m_gesture; }

private:
    std::unique_ptr<GrowthGesture> m_gesture;
    int m_mostSteps;
    int m_steps = 0;
    double m_due = 0.0; ///< Steps, with what is left of one
};

/// Growth into envelopes. @p begun is the gesture, or an Error, which becomes the warning. @p warning is what
/// is known to be wrong beforehand.
std::unique_ptr<Performance> performanceOf(LassoGesture::Begun begun, const QString& warning = {});

/// One sentence of several faults: the first three, and how many more there are.
QString joinedFaults(const QStringList& faults);

} // namespace espalier
