// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Error.h"
#include "model/base/Vector.h"

#include <QString>

#include <vector>

namespace espalier {

/// Strokes in the order of their file, right and up, in the unit of the file.
using DrawingStrokes = std::vector<std::vector<Vec2>>;

/// Reads a drawing: an SVG, whose paths, lines and polygons are strokes; or one of a Quick, Draw! .ndjson,
/// the one in the line @p index, counted from 0 (only there; 0 for an SVG). Transforms of an SVG are heeded,
/// texts, images and colours are not. Fails (Kind::Input) with the file's name and what is wrong: it cannot
/// be read, is greater than 32 MB, is no such file, has no such line, or no stroke.
Result<DrawingStrokes> readDrawing(const QString& fileName, int index);
/// The same with the bytes of a file.
Result<DrawingStrokes> parseDrawing(const QByteArray& bytes, bool isSvg, int index);

/// The same strokes, kDrawingHeight high from the ground up, in the middle of their width.
inline constexpr double kDrawingHeight = 3.0; ///< m
DrawingStrokes fittedDrawing(DrawingStrokes strokes);

} // namespace espalier
