// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/export/GlbFormat.h"

#include "model/io/JsonReader.h"
#include "model/texture/AllocatedImage.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QImage>
#include <QImageWriter>
#include <QJsonArray>
#include <QJsonDocument>
#include <QtEndian>

#include <cstddef>
#include <cstring>
#include <limits>

namespace espalier {

namespace {

// Numbers that the specification of glTF 2.0 gives to types and targets.
constexpr int kUnsignedInt = 5125;
constexpr int kFloat = 5126;
constexpr int kVertexBuffer = 34962;
constexpr int kIndexBuffer = 34963;
constexpr qsizetype kAlignment = 4;

/// glTF stores numbers in little-endian order; this program only runs on little-endian machines.
static_assert(Q_BYTE_ORDER == Q_LITTLE_ENDIAN);

/// Packs the roughness as glTF reads it, from green, and the metalness, which is zero, from blue.
QByteArray metallicRoughness(const QByteArray& png)
{
    QImage image = allocated(allocated(QImage::fromData(png, "png")).convertToFormat(QImage::Format_RGB888));
    for (int y = 0; y < image.height(); ++y) {
        uchar* pixel = image.scanLine(y);
        for (int x = 0; x < image.width(); ++x, pixel += 3) {
            pixel[0] = 0;
            pixel[2] = 0;
        }
    }
    QByteArray packed;
    QBuffer buffer(&packed);
    if (!QImageWriter(&buffer, "png").write(image))
        throw std::bad_alloc();
    return packed;
}

QByteArray padded(QByteArray bytes, char with)
{
    bytes.append((kAlignment - bytes.size() % kAlignment) % kAlignment, with);
    return bytes;
}

QByteArray littleEndian(qsizetype number)
{
    QByteArray bytes(4, '\0');
    qToLittleEndian(static_cast<std::uint32_t>(number), bytes.data());
    return bytes;
}

/// Collects the parts of a file; each add function returns the index of what it added.
class GlbBuilder {
public:
    explicit GlbBuilder(const ExportScene& scene);

    /// Bytes of the whole file, which can exceed the limit of the header.
    qsizetype size() const { return kHeader + m_json.size() + kChunkHeader + m_binary.size(); }
    bool write(QIODevice& device) const;

private:
    static constexpr qsizetype kChunkHeader = 8;
    static constexpr qsizetype kHeader = 12 + kChunkHeader;

    static int add(QJsonArray& array, QJsonObject object)
    {
        array.append(std::move(object));
        return static_cast<int>(array.size()) - 1;
    }
    QJsonObject addView(qsizetype size);
    int addAccessor(int view, std::size_t offset, int component, const char* type, std::size_t count);
    int addMesh(const ExportMesh& mesh);
    QJsonObject addTexture(const QString& name, const QByteArray& png);
    int addMaterial(const QString& tree, const ExportMaterial& material);

    QJsonArray m_accessors;
    QJsonArray m_views;
    QJsonArray m_meshes;
    QJsonArray m_images;
    QJsonArray m_textures;
    QJsonArray m_materials;
    QByteArray m_json;
    QByteArray m_binary;
};

/// A view of @p size bytes that are about to be appended.
QJsonObject GlbBuilder::addView(qsizetype size)
{
    m_binary = padded(std::move(m_binary), '\0');
    return {{QStringLiteral("buffer"), 0},
            {QStringLiteral("byteOffset"), m_binary.size()},
            {QStringLiteral("byteLength"), size}};
}

int GlbBuilder::addAccessor(int view, std::size_t offset, int component, const char* type, std::size_t count)
{
    return add(m_accessors, {{QStringLiteral("bufferView"), view},
                             {QStringLiteral("byteOffset"), static_cast<qint64>(offset)},
                             {QStringLiteral("componentType"), component},
                             {QStringLiteral("type"), QLatin1String(type)},
                             {QStringLiteral("count"), static_cast<qint64>(count)}});
}

int GlbBuilder::addMesh(const ExportMesh& mesh)
{
    const auto& vertices = mesh.mesh.vertices;
    const auto& indices = mesh.mesh.indices;
    const auto vertexBytes = static_cast<qsizetype>(vertices.size() * sizeof(MeshVertex));
    const auto indexBytes = static_cast<qsizetype>(indices.size() * sizeof(VertexIndex));

    // Vertices are interleaved, as in MeshVertex.
    QJsonObject view = addView(vertexBytes);
    view[QLatin1String("byteStride")] = static_cast<int>(sizeof(MeshVertex));
    view[QLatin1String("target")] = kVertexBuffer;
    const int vertexView = add(m_views, view);
    const qsizetype begin = m_binary.size();
    m_binary.append(reinterpret_cast<const char*>(vertices.data()), vertexBytes);
    Box3 box;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        box.extend(toVec3(vertices[i].position));
        // In glTF v points downward. The tangent does not change: its handedness is that of the image.
        const float v = 1.0F - vertices[i].uv[1];
        std::memcpy(m_binary.data() + begin + i * sizeof(MeshVertex) + offsetof(MeshVertex, uv) +
                        sizeof(float),
                    &v, sizeof v);
    }

    view = addView(indexBytes);
    view[QLatin1String("target")] = kIndexBuffer;
    const int indexView = add(m_views, view);
    m_binary.append(reinterpret_cast<const char*>(indices.data()), indexBytes);

    const auto attribute = [&](std::size_t offset, const char* type) {
        return addAccessor(vertexView, offset, kFloat, type, vertices.size());
    };
    const int position = attribute(offsetof(MeshVertex, position), "VEC3");
    const auto corner = [](const Vec3& point) {
        return QJsonArray{double(point.x()), double(point.y()), double(point.z())};
    };
    QJsonObject bounded = m_accessors[position].toObject();
    bounded[QLatin1String("min")] = corner(box.min());
    bounded[QLatin1String("max")] = corner(box.max());
    m_accessors[position] = bounded;
    const QJsonObject attributes{
        {QStringLiteral("POSITION"), position},
        {QStringLiteral("NORMAL"), attribute(offsetof(MeshVertex, normal), "VEC3")},
        {QStringLiteral("TANGENT"), attribute(offsetof(MeshVertex, tangent), "VEC4")},
        {QStringLiteral("TEXCOORD_0"), attribute(offsetof(MeshVertex, uv), "VEC2")}};
    const QJsonObject primitive{
        {QStringLiteral("attributes"), attributes},
        {QStringLiteral("indices"), addAccessor(indexView, 0, kUnsignedInt, "SCALAR", indices.size())},
        {QStringLiteral("material"), static_cast<int>(mesh.material)}};
    return add(m_meshes,
               {{QStringLiteral("name"), mesh.name}, {QStringLiteral("primitives"), QJsonArray{primitive}}});
}

QJsonObject GlbBuilder::addTexture(const QString& name, const QByteArray& png)
{
    const int view = add(m_views, addView(png.size()));
    m_binary.append(png);
    const int image = add(m_images, {{QStringLiteral("name"), name},
                                     {QStringLiteral("mimeType"), QStringLiteral("image/png")},
                                     {QStringLiteral("bufferView"), view}});
    const int texture = add(m_textures, {{QStringLiteral("name"), name}, {QStringLiteral("source"), image}});
    return {{QStringLiteral("index"), texture}};
}

int GlbBuilder::addMaterial(const QString& tree, const ExportMaterial& material)
{
    const auto texture = [&](const ExportTexture& source, const QByteArray& png) {
        return addTexture(tree + QLatin1Char('_') + source.name, png);
    };
    const QJsonObject surface{
        {QStringLiteral("baseColorTexture"), texture(material.colour, material.colour.png)},
        {QStringLiteral("metallicRoughnessTexture"),
         texture(material.roughness, metallicRoughness(material.roughness.png))},
        {QStringLiteral("metallicFactor"), 0}};
    QJsonObject object{{QStringLiteral("name"), material.name},
                       {QStringLiteral("pbrMetallicRoughness"), surface},
                       {QStringLiteral("normalTexture"), texture(material.normal, material.normal.png)}};
    if (material.isLeaf) {
        object[QLatin1String("alphaMode")] = QStringLiteral("MASK");
        object[QLatin1String("alphaCutoff")] = 0.5;
        object[QLatin1String("doubleSided")] = true;
    }
    return add(m_materials, object);
}

GlbBuilder::GlbBuilder(const ExportScene& scene)
{
    QJsonArray nodes;
    QJsonArray children;
    for (const ExportMesh& mesh : scene.meshes) {
        children.append(static_cast<int>(children.size()) + 1);
        nodes.append(
            QJsonObject{{QStringLiteral("name"), mesh.name}, {QStringLiteral("mesh"), addMesh(mesh)}});
    }
    nodes.prepend(QJsonObject{{QStringLiteral("name"), scene.name}, {QStringLiteral("children"), children}});
    for (const ExportMaterial& material : scene.materials)
        addMaterial(scene.name, material);
    m_binary = padded(std::move(m_binary), '\0');

    const QJsonObject asset{{QStringLiteral("version"), QStringLiteral("2.0")},
                            {QStringLiteral("generator"), QStringLiteral("Espalier")}};
    const QJsonObject document{
        {QStringLiteral("asset"), asset},
        {QStringLiteral("scene"), 0},
        {QStringLiteral("scenes"), QJsonArray{QJsonObject{{QStringLiteral("name"), scene.name},
                                                          {QStringLiteral("nodes"), QJsonArray{0}}}}},
        {QStringLiteral("nodes"), nodes},
        {QStringLiteral("meshes"), m_meshes},
        {QStringLiteral("materials"), m_materials},
        {QStringLiteral("textures"), m_textures},
        {QStringLiteral("images"), m_images},
        {QStringLiteral("accessors"), m_accessors},
        {QStringLiteral("bufferViews"), m_views},
        {QStringLiteral("buffers"),
         QJsonArray{QJsonObject{{QStringLiteral("byteLength"), m_binary.size()}}}}};
    m_json = padded(QJsonDocument(document).toJson(QJsonDocument::Compact), ' ');
}

bool GlbBuilder::write(QIODevice& device) const
{
    const QByteArray header = "glTF" + littleEndian(2) + littleEndian(size()) + littleEndian(m_json.size()) +
                              "JSON" + m_json + littleEndian(m_binary.size()) + QByteArray("BIN\0", 4);
    return device.write(header) == header.size() && device.write(m_binary) == m_binary.size();
}

} // namespace

QString GlbFormat::name() const
{
    return QCoreApplication::translate("ExportFormat", "Binary glTF");
}

Result<void> GlbFormat::write(const ExportScene& scene, ExportFiles& files) const
{
    const GlbBuilder builder(scene);
    if (builder.size() > std::numeric_limits<std::uint32_t>::max()) {
        return Error{
            Error::Kind::Output,
            inputError(files.mainName(),
                       QCoreApplication::translate(
                           "Exporter",
                           "the tree takes more than the 4 GB that such a file can hold; export less detail"))
                .message};
    }
    return files.addMain([&](QIODevice& device) { return builder.write(device); });
}

} // namespace espalier
