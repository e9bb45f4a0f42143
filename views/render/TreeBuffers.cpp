// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/render/TreeBuffers.h"

#include "model/mesh/LeafCard.h"
#include "model/texture/OwnTextures.h"
#include "views/render/TreeScene.h"

#include <cstddef>
#include <map>

namespace espalier {

namespace {

constexpr int kBarkEdge = 1024; ///< px
constexpr int kLeafEdge = 512;  ///< px
// For the user's own images
constexpr int kOwnBarkEdge = 2048;
constexpr int kOwnLeafEdge = 1024;

ShaderImages forShaders(const SurfaceTextures& textures)
{
    QImage surface = textures.normal.convertToFormat(QImage::Format_RGBA8888);
    for (int y = 0; y < surface.height(); ++y) {
        const uchar* const roughness = textures.roughness.constScanLine(y);
        uchar* const line = surface.scanLine(y);
        for (int x = 0; x < surface.width(); ++x)
            line[4 * x + 3] = roughness[x];
    }
    return {textures.colour, surface};
}

/// Textures that were made before, shared by all viewports: making them takes longer than a frame.
template <class Kind, class Make>
const ShaderImages& imagesOf(Kind kind, Make&& make)
{
    static std::map<Kind, ShaderImages> made;
    ShaderImages& images = made[kind];
    if (images.colour.isNull())
        images = forShaders(make(kind));
    return images;
}

void attribute(Gl& gl, GLuint location, GLint size, std::size_t stride, std::size_t offset,
               GLuint divisor = 0)
{
    gl.glEnableVertexAttribArray(location);
    gl.glVertexAttribPointer(location, size, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride),
                             reinterpret_cast<const void*>(offset));
    gl.glVertexAttribDivisor(location, divisor);
}

void meshAttributes(Gl& gl)
{
    attribute(gl, 0, 3, sizeof(MeshVertex), offsetof(MeshVertex, position));
    attribute(gl, 1, 3, sizeof(MeshVertex), offsetof(MeshVertex, normal));
    attribute(gl, 2, 4, sizeof(MeshVertex), offsetof(MeshVertex, tangent));
    attribute(gl, 3, 2, sizeof(MeshVertex), offsetof(MeshVertex, uv));
}

} // namespace

TreeBuffers::TreeBuffers(Gl& gl)
    : m_gl(gl),
      m_vertices(gl),
      m_indices(gl),
      m_leaves(gl),
      m_cardVertices(gl),
      m_cardIndices(gl),
      m_strandVertices(gl),
      m_strandIndices(gl),
      m_fibres(gl),
      m_barkArray(gl),
      m_strandArray(gl),
      m_fibreArray(gl),
      m_leafArray(gl),
      m_barkColour(gl),
      m_barkSurface(gl),
      m_leafColour(gl),
      m_leafSurface(gl),
      m_light(gl)
{
    gl.glBindTexture(GL_TEXTURE_3D, m_light.get());
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        gl.glTexParameteri(GL_TEXTURE_3D, filter, GL_LINEAR);
    // Outside the volume there is no shade.
    constexpr std::array<float, 4> light{1.0F, 1.0F, 1.0F, 1.0F};
    gl.glTexParameterfv(GL_TEXTURE_3D, GL_TEXTURE_BORDER_COLOR, light.data());
    for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
        gl.glTexParameteri(GL_TEXTURE_3D, wrap, GL_CLAMP_TO_BORDER);

    const auto woodArray = [&gl](const GlVertexArray& array, const GlBuffer& vertices,
                                 const GlBuffer& indices) {
        gl.glBindVertexArray(array.get());
        gl.glBindBuffer(GL_ARRAY_BUFFER, vertices.name());
        gl.glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices.name());
        meshAttributes(gl);
    };
    woodArray(m_barkArray, m_vertices, m_indices);
    woodArray(m_strandArray, m_strandVertices, m_strandIndices);

    gl.glBindVertexArray(m_fibreArray.get());
    gl.glBindBuffer(GL_ARRAY_BUFFER, m_fibres.name());
    attribute(gl, 0, 3, sizeof(FibreVertex), offsetof(FibreVertex, position));
    gl.glEnableVertexAttribArray(1);
    gl.glVertexAttribPointer(1, 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(FibreVertex),
                             reinterpret_cast<const void*>(offsetof(FibreVertex, colour)));

    gl.glBindVertexArray(m_leafArray.get());
    gl.glBindBuffer(GL_ARRAY_BUFFER, m_cardVertices.name());
    gl.glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, m_cardIndices.name());
    meshAttributes(gl);
    gl.glBindBuffer(GL_ARRAY_BUFFER, m_leaves.name());
    attribute(gl, 4, 4, sizeof(LeafInstance), offsetof(LeafInstance, position), 1);
    attribute(gl, 5, 4, sizeof(LeafInstance), offsetof(LeafInstance, rotation), 1);
    attribute(gl, 6, 3, sizeof(LeafInstance), offsetof(LeafInstance, width), 1);
    gl.glBindVertexArray(0);
}

bool TreeBuffers::follow(TreeScene& scene)
{
    const bool isOther = std::exchange(m_scene, scene.number()) != scene.number();
    fillTextures(scene.parameters());
    fillLight(scene, isOther);
    MeshPool& mesh = scene.mesh();
    const MeshPool::Changes changes = mesh.takeChanges();
    const bool hasOtherStrands = followStrands(scene);
    if (!isOther && changes.isEmpty())
        return hasOtherStrands;
    send(m_vertices, mesh.vertices(), changes.vertices, isOther);
    send(m_indices, mesh.indices(), changes.indices, isOther);
    send(m_leaves, mesh.leaves(), changes.leaves, isOther);
    m_indexCount = static_cast<GLsizei>(mesh.indices().size());
    m_leafCount = static_cast<GLsizei>(mesh.leaves().size());
    return true;
}

template <class T>
void TreeBuffers::send(GlBuffer& buffer, std::span<const T> elements, std::span<const MeshPool::Range> ranges,
                       bool all)
{
    if (buffer.reserve(elements.size_bytes()) || all) {
        buffer.write(0, elements.data(), elements.size_bytes());
        return;
    }
    for (const MeshPool::Range& range : ranges) {
        const std::span<const T> changed = elements.subspan(range.begin, range.end - range.begin);
        buffer.write(range.begin * sizeof(T), changed.data(), changed.size_bytes());
    }
}

void TreeBuffers::fillTextures(const TreeParameters& parameters)
{
    const BarkParameters& bark = parameters.bark;
    const auto looksLike = [](const BarkParameters& a, const BarkParameters& b) {
        return a.kind == b.kind && a.image == b.image && a.normalImage == b.normalImage &&
               a.roughnessImage == b.roughnessImage;
    };
    if (!m_bark || !looksLike(*m_bark, bark)) {
        const ShaderImages images =
            bark.image.isNull()
                ? imagesOf(bark.kind, [](BarkKind kind) { return barkTextures(kind, kBarkEdge); })
                : forShaders(barkTextures(bark, kOwnBarkEdge));
        fillTexture(m_gl, m_barkColour, images.colour, TextureContent::Colour, true);
        fillTexture(m_gl, m_barkSurface, images.surface, TextureContent::Data, true);
    }
    m_bark = bark;

    const LeafParameters& leaves = parameters.leaves;
    const bool hasOtherImage = !m_leaf || !(m_leaf->image == leaves.image);
    const bool isOther = hasOtherImage || m_leaf->shape != leaves.shape;
    const bool isPaler = !m_leaf || m_leaf->saturation != leaves.saturation;
    m_leaf = leaves;
    if (!isOther && !isPaler)
        return;
    if (hasOtherImage && !leaves.image.isNull())
        m_ownLeaf = forShaders(leafTextures(leaves, kOwnLeafEdge));
    const ShaderImages& images =
        leaves.image.isNull()
            ? imagesOf(leaves.shape, [](LeafShape shape) { return leafTextures(shape, kLeafEdge); })
            : m_ownLeaf;
    QImage colour = images.colour;
    saturateLeaf(colour, leaves.saturation);
    fillTexture(m_gl, m_leafColour, colour, TextureContent::Colour, false);
    if (!isOther)
        return;
    fillTexture(m_gl, m_leafSurface, images.surface, TextureContent::Data, false);
    const LeafCard& card = leafCard(leaves.image.isNull() ? leaves.shape : LeafShape::Own);
    m_cardVertices.reserve(card.vertices.size() * sizeof(MeshVertex));
    m_cardVertices.write(0, card.vertices.data(), card.vertices.size() * sizeof(MeshVertex));
    m_cardIndices.reserve(card.indices.size() * sizeof(VertexIndex));
    m_cardIndices.write(0, card.indices.data(), card.indices.size() * sizeof(VertexIndex));
    m_cardIndexCount = static_cast<GLsizei>(card.indices.size());
}

void TreeBuffers::fillLight(TreeScene& scene, bool all)
{
    LightGrid::Changes changes = scene.light().takeChanges();
    changes.all = changes.all || all;
    if (changes.isEmpty())
        return;
    const std::array<int, 3>& size = scene.light().size();
    const std::uint8_t* cells = scene.light().cells().data();
    m_gl.glActiveTexture(GL_TEXTURE0);
    m_gl.glBindTexture(GL_TEXTURE_3D, m_light.get());
    m_gl.glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    if (changes.all) {
        m_gl.glTexImage3D(GL_TEXTURE_3D, 0, GL_R8, size[0], size[1], size[2], 0, GL_RED, GL_UNSIGNED_BYTE,
                          cells);
    } else {
        const auto& [first, count] = changes.region;
        m_gl.glPixelStorei(GL_UNPACK_ROW_LENGTH, size[0]);
        m_gl.glPixelStorei(GL_UNPACK_IMAGE_HEIGHT, size[1]);
        cells += (static_cast<std::ptrdiff_t>(first[2]) * size[1] + first[1]) * size[0] + first[0];
        m_gl.glTexSubImage3D(GL_TEXTURE_3D, 0, first[0], first[1], first[2], count[0], count[1], count[2],
                             GL_RED, GL_UNSIGNED_BYTE, cells);
        m_gl.glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
        m_gl.glPixelStorei(GL_UNPACK_IMAGE_HEIGHT, 0);
    }
    m_gl.glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
}

bool TreeBuffers::followStrands(const TreeScene& scene)
{
    if (m_strands == scene.strands())
        return false;
    m_strands = scene.strands();
    if (hasStrandMesh()) {
        send(m_strandVertices, std::span<const MeshVertex>(m_strands->mesh().vertices), {}, true);
        send(m_strandIndices, std::span<const VertexIndex>(m_strands->mesh().indices), {}, true);
    }
    if (hasFibres())
        send(m_fibres, std::span<const FibreVertex>(m_strands->fibres), {}, true);
    return true;
}

void TreeBuffers::drawWood(GLenum mode)
{
    m_gl.glBindVertexArray(hasStrandMesh() ? m_strandArray.get() : m_barkArray.get());
    const GLsizei count =
        hasStrandMesh() ? static_cast<GLsizei>(m_strands->mesh().indices.size()) : m_indexCount;
    m_gl.glDrawElements(mode, count, GL_UNSIGNED_INT, nullptr);
}

void TreeBuffers::drawFibres()
{
    m_gl.glBindVertexArray(m_fibreArray.get());
    m_gl.glDrawArrays(GL_LINES, 0, static_cast<GLsizei>(m_strands->fibres.size()));
}

void TreeBuffers::drawBark()
{
    drawWood(GL_TRIANGLES);
}

void TreeBuffers::drawBarkPoints()
{
    drawWood(GL_POINTS);
}

void TreeBuffers::drawLeaves()
{
    if (m_leafCount == 0)
        return;
    m_gl.glBindVertexArray(m_leafArray.get());
    m_gl.glDrawElementsInstanced(GL_TRIANGLES, m_cardIndexCount, GL_UNSIGNED_INT, nullptr, m_leafCount);
}

} // namespace espalier
