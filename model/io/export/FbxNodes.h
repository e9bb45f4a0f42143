// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QByteArrayView>

#include <cstdint>
#include <optional>
#include <vector>

namespace espalier {

/// A node of a binary FBX file: a name, properties, nested nodes.
struct FbxNode {
    QByteArray name;
    /// Each property as it is in the file: a letter for the type, and the value.
    std::vector<QByteArray> properties;
    std::vector<FbxNode> children;
    bool hasList = false; ///< Whether a list of nested nodes follows, which can be empty
    /// Bytes of properties that could not be parsed, as they are in the file; then `properties` is empty.
    QByteArray opaque;
    qsizetype opaqueCount = 0;

    /// The first child of that name; null if there is none.
    FbxNode* child(QByteArrayView childName);
};

/// A binary FBX file. Properties share the bytes that the document was read from, so those must outlive it.
struct FbxDocument {
    bool wide = true;  ///< 64-bit offsets, from version 7500 on
    QByteArray header; ///< With the version
    std::vector<FbxNode> nodes;
    QByteArray footer;
};

/// The text of a string property; nothing if it is of another type.
std::optional<QByteArray> fbxText(const QByteArray& property);
QByteArray fbxString(const QByteArray& text);
QByteArray fbxInteger(std::int32_t value);

/// Reads a file whether or not its lists of nodes end in the record of zeros that the format demands. Returns
/// nothing if the content is not a valid tree of nodes.
std::optional<FbxDocument> readFbx(QByteArrayView content);
/// Writes a file with those records and the right offsets. Returns nothing if the file is too large for its
/// offsets.
std::optional<QByteArray> writeFbx(const FbxDocument& document);

} // namespace espalier
