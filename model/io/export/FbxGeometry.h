// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/io/export/FbxNodes.h"
#include "model/mesh/Mesh.h"

namespace espalier {

/// Gives the "Geometry" object that Assimp has written for some mesh the triangles of @p mesh, in the form in
/// which Assimp writes them: normals for each corner, texture coordinates each once. Assimp itself
/// would take many times the memory of the file for it. The arrays are made from @p mesh while the document
/// is written, so it must live until then. Returns false if the object lacks one of the arrays, or if there
/// are more numbers than an array can have (2^32 − 1 bytes).
bool setFbxTriangles(FbxNode& geometry, const TriangleMesh& mesh);

} // namespace espalier
