// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/sketch/SketchLine.h"

#include <optional>

namespace espalier {

/// What the user drew with one movement of the pointer.
struct SketchStroke {
    enum class Kind {
        Dot,    ///< No length: a tap. The line has one point.
        Open,   ///< A branch, or a gesture that edits. The line has two points or more.
        Closed, ///< The outline of a leaf. The line has three points or more; the first is not repeated.
    };

    Kind kind = Kind::Open;
    SketchLine line;

    bool operator==(const SketchStroke&) const = default;
};

/// Lengths are in the unit of the samples. The defaults are for pixels; see forPixels() for metres.
struct StrokeFitOptions {
    double tolerance = 2.0;  ///< The farthest that the line may be from a sample, > 0
    double spacing = 6.0;    ///< Between points of the line at most, > 0
    double shake = 4.0;      ///< Deviation of the smoothing along the stroke, >= 0: shorter waves are shake
    double closingGap = 8.0; ///< A stroke whose ends are nearer to each other than this is a loop (uncertain)
    double closingShare = 0.1; ///< The same as a share of the stroke's length (uncertain)

    /// The defaults for samples in another unit, in which a pixel has the size @p pixel, > 0.
    static StrokeFitOptions forPixels(double pixel);
};

/// The greatest coordinate of a sample, and the greatest number of a stroke's points.
inline constexpr double kFarthestSketchPoint = 1e6;
inline constexpr std::size_t kMostSketchPoints = 1000;

/// A smooth line through the samples of a pointer, with points at even distances. Repeated samples and shake
/// are removed: the line is smoothed along its length, no point by more than half the tolerance, and then
/// resampled, finely enough that no sample is farther from it than the tolerance. The ends of an open stroke
/// stay. Samples in reverse order give the same open line in reverse order. Only a scribble, too long for
/// kMostSketchPoints, may miss the tolerance.
///
/// A stroke is a loop if the gap between its ends is below closingShare of its length, or below closingGap
/// and below a third of its length, so that a short line stays a line.
///
/// Returns nothing without samples, or if a coordinate is not finite or is beyond kFarthestSketchPoint.
/// Okabe 2005, 3.2, asks for open and closed strokes and does not say how they are told apart.
std::optional<SketchStroke> fitStroke(const SketchLine& samples, const StrokeFitOptions& options = {});

} // namespace espalier
