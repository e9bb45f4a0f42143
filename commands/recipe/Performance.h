// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/growth/BrushSample.h"

#include <QStringList>

#include <optional>

namespace espalier {

class BrushGesture;
class LassoGesture;

/// An operation of a recipe while it is done to a document. One that is destroyed before its end leaves the
/// document as it was.
///
/// The performances are in commands/performances: they use the gestures, which know the operations, since
/// they record themselves as such.
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

    /// Where the brush is, while a stroke is made.
    virtual std::optional<BrushSample> brush() const { return {}; }
    /// The stroke that is being made, or null.
    virtual const BrushGesture* stroke() const { return nullptr; }
    /// The envelope that is being filled, or null.
    virtual const LassoGesture* lasso() const { return nullptr; }
};

/// One sentence of several faults: the first three, and how many more there are.
QString joinedFaults(const QStringList& faults);

} // namespace espalier
