// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Error.h"
#include "model/io/export/FbxNodes.h"

namespace espalier {

/// Corrects a binary FBX file as Assimp up to 5.2 writes it; this is the only place that does so:
///
/// - The lists of nested nodes lack the record of zeros that ends them (25 bytes from version 7500 on, 13
///   before), without which Blender and other programs cannot read the file.
/// - Textures, images and geometries have no names. Textures and images get the names of their files without
///   the ending, geometries the names of the models that show them.
/// - The strength of the specular highlight is called ShininessFactor, which no reader knows; it becomes
///   SpecularFactor.
/// - The header holds the time of the export, so that two exports of one tree differ; it becomes the constant
/// that
///   Assimp writes as CreationTime.
///
/// What is right already stays the same. Fails if the content is not a valid tree of nodes. The document
/// shares the bytes of @p content.
Result<FbxDocument> repairFbx(QByteArrayView content);

} // namespace espalier
