// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/render/TreeScene.h"

#include <utility>

namespace espalier {

namespace {

std::uint64_t nextNumber()
{
    static std::uint64_t last = 0;
    return ++last;
}

} // namespace

TreeScene::TreeScene(const TreeDocument& document) : m_document(document), m_number(nextNumber())
{
    rebuild();
}

void TreeScene::rebuild()
{
    m_mesh.rebuild(m_document.tree(), m_document.index());
    m_lightIsOld = true;
    m_boundsAreOld = true;
    prepare();
}

void TreeScene::follow(const TreeChange& change)
{
    if (change.kind == TreeChange::Kind::Reset) {
        rebuild();
        return;
    }
    const TreeDelta& delta = *change.delta;
    m_mesh.follow(m_document.tree(), m_document.index(), delta);
    const auto relight = [&](InternodeId id) { m_relit.extend(m_document.index().nodePosition(id)); };
    for (InternodeId id = delta.born.first; id != delta.born.end(); ++id)
        relight(id);
    for (const InternodeId id : delta.died)
        relight(id);
    m_boundsAreOld = true;
    // Other parameters may be another kind of shadow. A bent branch takes its shadow along, which is too much
    // to work out while a hand moves it.
    m_lightIsOld = m_lightIsOld || delta.parametersBefore != delta.parametersAfter;
    m_lightWaits = m_lightWaits || !delta.frames.empty();
}

bool TreeScene::settle()
{
    if (std::exchange(m_lightWaits, false))
        m_lightIsOld = true;
    return m_mesh.settle(m_document.tree(), m_document.index());
}

std::vector<Vec3> TreeScene::outline() const
{
    const Tree& tree = m_document.tree();
    std::vector<Vec3> points{Vec3::Zero()};
    points.reserve(m_document.index().livingCount() + m_mesh.leaves().size() + 1);
    for (InternodeId id = 0; id < tree.size(); ++id) {
        if (tree.isAlive(id))
            points.push_back(m_document.index().nodePosition(id));
    }
    // A palm's leaves reach far beyond its nodes.
    for (const LeafInstance& leaf : m_mesh.leaves()) {
        if (leaf.length > 0.0F) {
            const Rotation rotation(leaf.rotation[3], leaf.rotation[0], leaf.rotation[1], leaf.rotation[2]);
            points.push_back(toVec3(leaf.position) + leaf.length * (rotation * Vec3::UnitY()));
        }
    }
    return points;
}

void TreeScene::prepare()
{
    m_mesh.finish(m_document.tree(), m_document.index());
    if (!m_lightWaits) {
        const VoxelSpace& space = m_document.growthIndex().space();
        if (m_lightIsOld)
            m_light.rebuild(space);
        else
            m_light.update(space, m_relit);
        m_lightIsOld = false;
        m_relit.setEmpty();
    }

    if (!m_boundsAreOld)
        return;
    m_boundsAreOld = false;
    const Tree& tree = m_document.tree();
    m_bounds = Box3(Vec3::Zero());
    for (InternodeId id = 0; id < tree.size(); ++id) {
        if (tree.isAlive(id))
            m_bounds.extend(m_document.index().nodePosition(id));
    }
    const LeafParameters& leaves = parameters().leaves;
    const Vec3 beyond = Vec3::Constant(static_cast<float>(leaves.visible ? leaves.length : 0.02));
    m_bounds.min() -= beyond;
    m_bounds.max() += beyond;
}

} // namespace espalier
