// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/ShownStrands.h"
#include "model/tree/Parameters.h"
#include "views/render/GlResources.h"
#include "views/render/MeshPool.h"

#include <QImage>

#include <optional>
#include <span>

namespace espalier {

class TreeScene;

/// A texture in the form that shaders use: colour, and the normal with the roughness as alpha, so that one
/// lookup reads both.
struct ShaderImages {
    QImage colour;
    QImage surface;
};

/// A scene on the graphics card: buffers and textures. Only what changed in the scene is sent there.
class TreeBuffers {
public:
    explicit TreeBuffers(Gl& gl);

    /// Sends the scene's changes to the card; returns true if something that casts shadows has changed.
    bool follow(TreeScene& scene);

    /// Draws with the bound program.
    void drawBark();
    /// Draws a point for each corner of the triangles.
    void drawBarkPoints();
    void drawLeaves();
    /// Whether the strands are there as lines.
    bool hasFibres() const { return m_strands && !m_strands->fibres.empty(); }
    void drawFibres();

    GLuint barkColour() const { return m_barkColour.get(); }
    /// Texture of the normal, with roughness as alpha.
    GLuint barkSurface() const { return m_barkSurface.get(); }
    GLuint leafColour() const { return m_leafColour.get(); }
    GLuint leafSurface() const { return m_leafSurface.get(); }
    /// Whether the leaves have the user's own image.
    bool hasOwnLeaves() const { return m_leaf && !m_leaf->image.isNull(); }
    GLuint lightVolume() const { return m_light.get(); }

private:
    /// Sends the elements of @p ranges, or all elements.
    template <class T>
    void send(GlBuffer& buffer, std::span<const T> elements, std::span<const MeshPool::Range> ranges,
              bool all);
    /// Sends the strands, if others are to be shown; returns whether they are.
    bool followStrands(const TreeScene& scene);
    bool hasStrandMesh() const { return m_strands && m_strands->hasMesh(); }
    void drawWood(GLenum mode);
    void fillTextures(const TreeParameters& parameters);
    void fillLight(TreeScene& scene, bool all);

    Gl& m_gl;
    GlBuffer m_vertices;
    GlBuffer m_indices;
    GlBuffer m_leaves;
    GlBuffer m_cardVertices;
    GlBuffer m_cardIndices;
    // The mesh of strands, if it is shown in place of the vertices above.
    GlBuffer m_strandVertices;
    GlBuffer m_strandIndices;
    GlBuffer m_fibres;
    GlVertexArray m_barkArray;
    GlVertexArray m_strandArray;
    GlVertexArray m_fibreArray;
    GlVertexArray m_leafArray;
    GlTexture m_barkColour;
    GlTexture m_barkSurface;
    GlTexture m_leafColour;
    GlTexture m_leafSurface;
    GlTexture m_light;
    std::uint64_t m_scene = 0; ///< Number of the scene on the card, 0 for none
    // The parameters that the textures were made for.
    std::optional<BarkParameters> m_bark;
    std::optional<LeafParameters> m_leaf;
    ShaderImages m_ownLeaf; ///< From the image in m_leaf, if it has one
    std::shared_ptr<const ShownStrands> m_strands;
    GLsizei m_indexCount = 0;
    GLsizei m_leafCount = 0;
    GLsizei m_cardIndexCount = 0;
};

} // namespace espalier
