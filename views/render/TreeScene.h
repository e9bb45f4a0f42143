// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/TreeDocument.h"
#include "views/render/PreparedScene.h"

namespace espalier {

/// What there is to draw of a document's tree: its mesh, its leaves, its light, and how large it is. Told
/// of each change, it follows at a cost of what changed; one renderer takes its changes.
class TreeScene {
public:
    /// A part of a frame, ms.
    static constexpr int kSlice = 5;

    /// Shows the tree as it is. @p document outlives the scene.
    explicit TreeScene(const TreeDocument& document);

    /// Takes what a worker thread has made of the tree that the document shows at its next reset. It is
    /// dropped if that shows another one.
    void expect(PreparedScene prepared) { m_expected = std::move(prepared); }
    /// Follows a change that the document has just told.
    void follow(const TreeChange& change);
    /// Brings up to date what several changes need only once; before mesh(), light() and
    /// bounds().
    void prepare();
    /// Brings some of it up to date, for about kSlice; returns whether nothing is left. What has waited
    /// longest comes first, so that a large tree that goes on growing is followed a little late, but
    /// followed.
    bool prepareSome();
    /// When there is time: brings everything to its exact form, likewise.
    bool settleSome();
    /// How long a pixel of the picture is at the tree, m: how fine the wood must be. It follows in large
    /// steps.
    void setPixelSize(double metres);
    /// Whether there is something left to prepare.
    bool isBehind() const { return m_isBehind; }

    /// Tells scenes apart, also those that lived at the same place.
    std::uint64_t number() const { return m_number; }
    const TreeParameters& parameters() const { return m_document.parameters(); }
    MeshPool& mesh() { return m_mesh; }
    const MeshPool& mesh() const { return m_mesh; }
    LightGrid& light() { return m_light; }
    const LightGrid& light() const { return m_light; }
    /// Of the living tree with its leaves and the seedling's base, m; never empty.
    const Box3& bounds() const { return m_bounds; }
    /// Points that a picture of the whole tree must show: its nodes, its base, and the tips of its leaves, m.
    std::vector<Vec3> outline() const;

private:
    void rebuild();
    bool workSome();
    void updateLight();
    void updateBounds();

    const TreeDocument& m_document;
    std::uint64_t m_number;
    MeshPool m_mesh;
    LightGrid m_light;
    Box3 m_bounds;
    Box3 m_relit; ///< Where nodes came or went since prepare()
    bool m_lightIsOld = false;
    bool m_lightWaits = false; ///< Until settleSome()
    bool m_isBehind = false;
    bool m_isSettling = false;
    bool m_isExact = true;
    bool m_boundsAreOld = false;
    std::optional<PreparedScene> m_expected;
};

} // namespace espalier
