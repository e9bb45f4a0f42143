// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/growth/BrushSample.h"

#include <QStringList>

#include <optional>

namespace espalier {

class BrushGesture;
class LassoGesture;

/// An operation of a recipe while it changes a document. Destroying it before its end restores the document.
///
/// The performances are in commands/performances: they use the gestures, and the gestures use the operations
/// to record themselves.
class Performance {
public:
    Performance() = default;
    virtual ~Performance() = default;
    Performance(const Performance&) = delete;
    Performance& operator=(const Performance&) = delete;

    /// Advances by @p seconds of a demonstration, or to the end if that is infinity. Returns whether the
    /// operation is done.
    virtual bool advance(double seconds) = 0;
    /// What the operation, when it is done, did not find or could not do ("there is no internode 712"); empty
    /// if nothing.
    virtual QString warning() const { return {}; }

    /// The brush while a stroke is made.
    virtual std::optional<BrushSample> brush() const { return {}; }
    /// The stroke that is being made, or null.
    virtual const BrushGesture* stroke() const { return nullptr; }
    /// The envelope that is being filled, or null.
    virtual const LassoGesture* lasso() const { return nullptr; }
};

/// One sentence about several faults: the first three, and how many more there are.
QString joinedFaults(const QStringList& faults);

} // namespace espalier
