// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/TreeDocument.h"
#include "model/mesh/ShownStrands.h"
#include "views/render/PreparedScene.h"

namespace espalier {

/// Everything that is drawn of a document's tree: its mesh, its leaves, its light, and its bounds. It is
/// updated for each change, at a cost that depends on the change; one renderer takes its changes.
class TreeScene {
public:
    /// Time of one slice of work within a frame, ms.
    static constexpr int kSlice = 5;

    /// Shows the document's tree. @p document must outlive the scene.
    explicit TreeScene(const TreeDocument& document);

    /// Takes what a worker thread has made of the tree that the document shows at its next reset. It is
    /// dropped if that shows another one.
    void expect(PreparedScene prepared) { m_expected = std::move(prepared); }
    /// Follows a change that the document has just told.
    void follow(const TreeChange& change);
    /// Updates what several changes need only once; call it before mesh(), light() and bounds().
    void prepare();
    /// Makes strands and fibres at once, if they are wanted. For pictures; it can take seconds.
    void prepareStrands();
    /// Updates a part, for about kSlice; returns whether nothing is left. Pieces that have waited longest
    /// come first, so that the picture of a large growing tree is only a little late.
    bool prepareSome();
    /// Brings everything to its exact form, for about kSlice; returns whether nothing is left. For times
    /// without motion.
    bool settleSome();
    /// Sets the length of a picture's pixel at the tree, m, which decides how fine the wood must be. The
    /// fineness changes in large steps.
    void setPixelSize(double metres);
    /// Whether strands are to be shown as fibres, also those of a tree whose wood is tubes.
    void setFibresShown(bool shown) { m_fibresShown = shown; }
    /// Whether strands or fibres are to be shown, but are missing or older than the tree: they take too long
    /// for a frame, so a worker makes them (StrandRunner).
    bool wantsStrands() const
    {
        return (parameters().wood.mesher == WoodMesherKind::Strands || m_fibresShown) &&
               (m_strandsRevision != m_document.revision() || !m_strands ||
                (m_fibresShown && !m_strands->hasFibres));
    }
    /// Shows @p strands in place of the tubes; leaves move to them. @p revision: of the document when they
    /// were begun; those of an earlier tree stay until the tree changes its shape.
    void setStrands(std::shared_ptr<const ShownStrands> strands, std::uint64_t revision);
    /// What is shown in place of the pieces in mesh(), or null.
    const std::shared_ptr<const ShownStrands>& strands() const { return m_strands; }

    /// Whether there is something left to prepare.
    bool isBehind() const { return m_isBehind; }

    /// A number that no other scene has.
    std::uint64_t number() const { return m_number; }
    const TreeParameters& parameters() const { return m_document.parameters(); }
    MeshPool& mesh() { return m_mesh; }
    const MeshPool& mesh() const { return m_mesh; }
    LightGrid& light() { return m_light; }
    const LightGrid& light() const { return m_light; }
    /// Bounds of the living tree with its leaves, the bases of its trunks and the origin, m; never empty.
    const Box3& bounds() const { return m_bounds; }
    /// Points that a picture of the whole tree must show: its nodes, the bases of its trunks, and the tips of
    /// its leaves, m.
    std::vector<Vec3> outline() const;
    /// The lower end of a trunk, m, and the radius there as meshed, m.
    struct Foot {
        Vec3 base;
        float radius;
    };
    /// Those of the living roots, by ascending id; at least one.
    std::vector<Foot> feet() const;

private:
    void rebuild();
    void replaceStrands(std::shared_ptr<const ShownStrands> strands);
    bool workSome();
    void updateLight();
    void updateBounds();

    const TreeDocument& m_document;
    std::uint64_t m_number;
    MeshPool m_mesh;
    LightGrid m_light;
    Box3 m_bounds;
    Box3 m_relit; ///< Region in which nodes came or went since prepare()
    bool m_lightIsOld = false;
    bool m_lightWaits = false; ///< The light is updated by settleSome()
    bool m_isBehind = false;
    bool m_isSettling = false;
    bool m_isExact = true;
    bool m_boundsAreOld = false;
    std::optional<PreparedScene> m_expected;
    std::shared_ptr<const ShownStrands> m_strands;
    bool m_fibresShown = false;
    std::uint64_t m_strandsRevision = ~std::uint64_t{0};
};

} // namespace espalier
