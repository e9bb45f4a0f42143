// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Error.h"
#include "model/base/Ids.h"
#include "model/base/Vector.h"

#include <QByteArray>
#include <QLatin1StringView>

#include <vector>

namespace espalier {

/// A piece of the wood of a measured tree, a truncated cone.
struct SkeletonSegment {
    /// Index of the segment that carries it, smaller than its own; kNoInternode for the foot of a tree.
    std::uint32_t parent = kNoInternode;
    Vec3 base = Vec3::Zero(); ///< m, Y up
    Vec3 tip = Vec3::Zero();  ///< m
    float radius = 0.0F;      ///< m; 0 if it was not measured

    bool operator==(const SkeletonSegment&) const = default;
};

/// The wood of one or more trees as scans measure it: parents come before the segments that they carry.
using Skeleton = std::vector<SkeletonSegment>;

/// The suffix of files with skeletons.
inline constexpr QLatin1StringView kSkeletonSuffix("csv");
/// The greatest number of segments of a skeleton.
inline constexpr std::size_t kMostSegments = 1'000'000;

/// Reads a table of text: a first line "id,parent,x0,y0,z0,x1,y1,z1,radius", then a line for each segment.
/// The ids are whole numbers in any order; the parent of a foot is −1; lengths are in metres, with z up.
/// SkeletonFormat writes the same. Fails (Kind::Input) with the line and what is wrong with it: a missing or
/// broken number, an id that occurs twice, a parent that does not exist, a circle, a place beyond
/// kFarthestNode, a radius below 0 or beyond kGreatestDiameter / 2, too many segments, or none.
Result<Skeleton> readSkeleton(const QByteArray& table);

/// The same for a file, whose name begins the error's message.
Result<Skeleton> readSkeletonFile(const QString& fileName);

/// What is wrong with the places and the radius of @p segment; empty if nothing.
QString segmentFault(const SkeletonSegment& segment);

} // namespace espalier
