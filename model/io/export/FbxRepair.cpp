// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/export/FbxRepair.h"

#include "model/io/JsonReader.h"
#include "model/io/export/FbxNodes.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QHash>

#include <algorithm>
#include <array>
#include <utility>

namespace espalier {

namespace {

/// Between the name and the class of an object.
const QByteArray kSeparator("\0\1", 2);
/// Properties of an object: its id, its name and class, its kind.
constexpr std::size_t kObjectProperties = 3;

QByteArray textOf(const FbxNode& node, std::size_t property)
{
    return property < node.properties.size() ? fbxText(node.properties[property]).value_or(QByteArray())
                                             : QByteArray();
}

/// Gives an object the name if it has none.
void setName(FbxNode& object, const QByteArray& name)
{
    const QByteArray kind = textOf(object, 1);
    if (object.properties.size() == kObjectProperties && kind.startsWith(kSeparator))
        object.properties[1] = fbxString(name + kind);
}

/// Names a texture or an image after its file.
void nameAfterFile(FbxNode& object)
{
    const FbxNode* const file = object.child("RelativeFilename");
    if (file == nullptr)
        return;
    const QByteArray name = QFileInfo(QString::fromUtf8(textOf(*file, 0))).completeBaseName().toUtf8();
    setName(object, name);
    if (FbxNode* const again = object.child("TextureName"); again && again->properties.size() == 1)
        again->properties[0] = fbxString(textOf(object, 1));
}

void nameGeometries(std::vector<FbxNode>& objects, const FbxNode* connections)
{
    QHash<QByteArray, QByteArray> nameOfModel;
    for (const FbxNode& object : objects) {
        if (object.name == "Model" && object.properties.size() == kObjectProperties) {
            const QByteArray name = textOf(object, 1);
            nameOfModel[object.properties[0]] = name.first(std::max<qsizetype>(0, name.indexOf(kSeparator)));
        }
    }
    QHash<QByteArray, QByteArray> modelOfGeometry;
    if (connections != nullptr) {
        for (const FbxNode& connection : connections->children) {
            // "OO" connects an object to another; its ids follow.
            if (textOf(connection, 0) == "OO" && connection.properties.size() == 3 &&
                nameOfModel.contains(connection.properties[2]))
                modelOfGeometry[connection.properties[1]] = connection.properties[2];
        }
    }
    for (FbxNode& object : objects) {
        if (object.name == "Geometry" && object.properties.size() == kObjectProperties)
            setName(object, nameOfModel.value(modelOfGeometry.value(object.properties[0])));
    }
}

void renameSpecularFactor(FbxNode& material)
{
    FbxNode* const properties = material.child("Properties70");
    if (properties == nullptr)
        return;
    for (FbxNode& property : properties->children) {
        if (textOf(property, 0) == "ShininessFactor")
            property.properties[0] = fbxString("SpecularFactor");
    }
}

/// Replaces the moment of the export by the one that CreationTime names in every file.
void setCreationTime(FbxNode& header)
{
    FbxNode* const stamp = header.child("CreationTimeStamp");
    if (stamp == nullptr)
        return;
    constexpr std::array<std::pair<const char*, std::int32_t>, 7> kMoment{{{"Year", 1970},
                                                                           {"Month", 1},
                                                                           {"Day", 1},
                                                                           {"Hour", 10},
                                                                           {"Minute", 0},
                                                                           {"Second", 0},
                                                                           {"Millisecond", 0}}};
    for (const auto& [name, value] : kMoment) {
        if (FbxNode* const part = stamp->child(name); part && part->properties.size() == 1)
            part->properties[0] = fbxInteger(value);
    }
}

} // namespace

Result<FbxDocument> repairFbx(QByteArrayView content)
{
    std::optional<FbxDocument> document = readFbx(content);
    if (!document)
        return inputError({},
                          QCoreApplication::translate("FbxRepair", "this is not a valid binary FBX file"));
    const auto node = [&](QByteArrayView name) {
        const auto found = std::ranges::find(document->nodes, name, &FbxNode::name);
        return found == document->nodes.end() ? nullptr : &*found;
    };
    if (FbxNode* const header = node("FBXHeaderExtension"))
        setCreationTime(*header);
    if (FbxNode* const objects = node("Objects")) {
        for (FbxNode& object : objects->children) {
            if (object.name == "Texture" || object.name == "Video")
                nameAfterFile(object);
            else if (object.name == "Material")
                renameSpecularFactor(object);
        }
        nameGeometries(objects->children, node("Connections"));
    }
    return *std::move(document);
}

} // namespace espalier
