// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QByteArrayView>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

class QIODevice;

namespace espalier {

/// An array property that is made while it is written.
struct FbxArray {
    char type = 'd';       ///< 'd' double, 'i' 32-bit integer
    std::size_t count = 0; ///< Of elements; its bytes must be below 2^32
    std::size_t elementBytes = 8;
    /// Writes the elements, little-endian; returns false if the device does not take them.
    std::function<bool(QIODevice&)> write;
};

/// A node of a binary FBX file: a name, properties, nested nodes.
struct FbxNode {
    QByteArray name;
    /// Each property as it is in the file: a letter for the type, and the value.
    std::vector<QByteArray> properties;
    std::vector<FbxNode> children;
    std::optional<FbxArray> array; ///< The only property; then `properties` is empty
    bool hasList = false;          ///< Whether a list of nested nodes follows, which can be empty
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
/// Writes a file with those records and the right offsets, node by node. Returns false if the file is too
/// large for its offsets, or if the device does not take it.
bool writeFbx(const FbxDocument& document, QIODevice& device);

} // namespace espalier
