// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/tree/TreeTables.h"

#include <QtGlobal>

#include <cstdint>

namespace espalier {

/// Limits of the content of a project file.
namespace projectLimits {
inline constexpr int kVersion = 2;
inline constexpr std::uint32_t kInternodes = 20'000'000;
inline constexpr std::uint32_t kLeaves = 20'000'000; ///< Placed leaves
inline constexpr std::uint32_t kDeltas = 4'000'000;
inline constexpr std::uint32_t kChanges = 100'000'000; ///< Changes of one column, in all deltas together
/// Rows that the deltas move, in all deltas together; only for trees that reach further than kFarthestNode
inline constexpr std::uint64_t kMovedRows = 100'000'000;
inline constexpr std::uint32_t kLassos = kMostLassos;
inline constexpr std::uint32_t kLassoPoints = 10'000'000; ///< In all
inline constexpr std::uint32_t kProfiles = kMostProfiles;
inline constexpr std::uint32_t kProfilePoints = kMostProfilePointsInAll;
inline constexpr qsizetype kRecordBytes = qsizetype{512} << 20; ///< Of what made the edits, in all
inline constexpr std::uint32_t kImages = 4096;
inline constexpr qsizetype kImageBytes = qsizetype{512} << 20; ///< Size of all images together
} // namespace projectLimits

} // namespace espalier
