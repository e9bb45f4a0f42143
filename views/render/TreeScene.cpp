// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/render/TreeScene.h"

#include <QElapsedTimer>

#include <cmath>
#include <utility>

namespace espalier {

namespace {

/// Tolerances of the wood are 1 mm times a power of this; a step doubles or halves the sides of a branch.
constexpr double kStep = 4.0;
constexpr double kTolerance = WoodMeshOptions{}.tolerance; ///< m
constexpr double kFinestStep = -3.0;
constexpr double kCoarsestStep = 2.0;
/// The allowed error of an outline, px; and the factor by which the tolerance may differ from the best one
/// before it changes by a step.
constexpr double kTolerancePixels = 0.2;
constexpr double kMoreTolerance = 1.5;

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
    const auto isOfThisTree = [this](const PreparedScene& scene) {
        return scene.tree.columns().parent.isSharedWith(m_document.tree().columns().parent);
    };
    replaceStrands(nullptr);
    m_strandsRevision = ~std::uint64_t{0};
    if (std::optional<PreparedScene> expected = std::exchange(m_expected, std::nullopt);
        expected && isOfThisTree(*expected)) {
        m_mesh = std::move(expected->mesh);
        m_strands = std::move(expected->strands);
        m_light = std::move(expected->light);
        m_lightIsOld = false;
        m_relit.setEmpty();
    } else {
        m_mesh.rebuild(m_document.tree(), m_document.index());
        m_lightIsOld = true;
    }
    m_boundsAreOld = true;
    m_lightWaits = false;
    prepare();
}

void TreeScene::setStrands(std::shared_ptr<const ShownStrands> strands, std::uint64_t revision)
{
    replaceStrands(std::move(strands));
    m_strandsRevision = revision;
}

void TreeScene::replaceStrands(std::shared_ptr<const ShownStrands> strands)
{
    if (strands == m_strands)
        return;
    m_strands = std::move(strands);
    m_mesh.setLines(linesOf(m_strands));
    m_isBehind = true;
    m_isSettling = false;
    m_isExact = false;
}

void TreeScene::prepareStrands()
{
    if (!wantsStrands())
        return;
    WorkProgress progress;
    setStrands(makeShownStrands(m_document.tree(), m_fibresShown, nullptr, progress), m_document.revision());
    prepare();
}

void TreeScene::follow(const TreeChange& change)
{
    if (!change.delta) {
        rebuild();
        return;
    }
    m_isBehind = true;
    m_isSettling = false;
    m_isExact = false;
    const TreeDelta& delta = *change.delta;
    // Tubes stand in for branches that come or move; other changes leave the last strands in place.
    if (delta.born.count > 0 || delta.reframes() || parameters().wood.mesher == WoodMesherKind::Tubes)
        replaceStrands(nullptr);
    m_mesh.follow(m_document.tree(), m_document.index(), delta);
    const auto relight = [&](InternodeId id) { m_relit.extend(m_document.index().nodePosition(id)); };
    if (change.kind == TreeChange::Kind::Applied) {
        for (InternodeId id = delta.born.first; id != delta.born.end(); ++id)
            relight(id);
    }
    m_relit.extend(m_document.index().recentlyRemoved());
    for (const InternodeId id : delta.died)
        relight(id);
    m_boundsAreOld = true;
    // Other parameters can change the shadows. A bent branch takes its shadow along, which is too slow to
    // compute while the branch is dragged.
    m_lightIsOld = m_lightIsOld || delta.parametersBefore != delta.parametersAfter;
    m_lightWaits = m_lightWaits || delta.reframes();
}

void TreeScene::setPixelSize(double metres)
{
    const double wanted = kTolerancePixels * metres;
    const double now = m_mesh.options().tolerance;
    if (!(wanted > 0.0) || (wanted > now / kMoreTolerance && wanted < now * kStep * kMoreTolerance))
        return;
    const double steps = std::floor(std::log(wanted * kMoreTolerance / kTolerance) / std::log(kStep));
    const double tolerance = kTolerance * std::pow(kStep, std::clamp(steps, kFinestStep, kCoarsestStep));
    if (tolerance == now)
        return;
    m_mesh.setOptions({.tolerance = tolerance});
    m_isBehind = true;
    m_isSettling = false;
    m_isExact = false;
}

bool TreeScene::settleSome()
{
    if (m_isExact || !prepareSome())
        return m_isExact;
    if (!std::exchange(m_isSettling, true)) {
        m_mesh.noteInexact(m_document.tree(), m_document.index());
        m_lightIsOld = m_lightIsOld || std::exchange(m_lightWaits, false);
    }
    m_isSettling = !workSome();
    m_isExact = !m_isSettling;
    return m_isExact;
}

std::vector<TreeScene::Foot> TreeScene::feet() const
{
    std::vector<Foot> feet;
    for (const InternodeId root : m_document.index().roots()) {
        if (m_document.tree().isAlive(root))
            feet.push_back({m_document.index().basePosition(m_document.tree(), root),
                            m_mesh.tracker().meshedRadius(root)});
    }
    return feet;
}

std::vector<Vec3> TreeScene::outline() const
{
    const Tree& tree = m_document.tree();
    std::vector<Vec3> points;
    for (const Foot& foot : feet())
        points.push_back(foot.base);
    points.reserve(m_document.index().livingCount() + m_mesh.leaves().size() + points.size());
    for (InternodeId id = 0; id < tree.size(); ++id) {
        if (tree.isAlive(id))
            points.push_back(m_document.index().nodePosition(id));
    }
    // The leaves of a palm reach far beyond its nodes.
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
    updateLight();
    updateBounds();
    m_isBehind = false;
}

bool TreeScene::prepareSome()
{
    updateBounds();
    m_isBehind = m_isBehind && !workSome();
    return !m_isBehind;
}

/// Performs one slice of the pending work; returns whether nothing is left.
bool TreeScene::workSome()
{
    constexpr std::size_t tubes = 256;
    constexpr std::size_t nodes = 2048;
    QElapsedTimer timer;
    timer.start();
    while (timer.elapsed() < kSlice) {
        if (!m_mesh.finishSome(m_document.tree(), m_document.index(), tubes))
            continue;
        if (!m_lightWaits) {
            if (!m_document.prepareGrowthModel(nodes))
                continue;
            updateLight();
        }
        return true;
    }
    return false;
}

void TreeScene::updateLight()
{
    if (m_lightWaits)
        return;
    const VoxelSpace& space = m_document.growthModel().space();
    if (m_lightIsOld)
        m_light.rebuild(space);
    else
        m_light.update(space, m_relit);
    m_lightIsOld = false;
    m_relit.setEmpty();
}

void TreeScene::updateBounds()
{
    if (!std::exchange(m_boundsAreOld, false))
        return;
    const Tree& tree = m_document.tree();
    m_bounds = Box3(Vec3::Zero());
    for (const Foot& foot : feet())
        m_bounds.extend(foot.base);
    for (InternodeId id = 0; id < tree.size(); ++id) {
        if (tree.isAlive(id))
            m_bounds.extend(m_document.index().nodePosition(id));
    }
    extendByPlacedLeaves(m_bounds, tree, m_document.index());
    const LeafParameters& leaves = parameters().leaves;
    const Vec3 beyond = Vec3::Constant(static_cast<float>(leaves.visible ? leaves.length : 0.02));
    m_bounds.min() -= beyond;
    m_bounds.max() += beyond;
}

} // namespace espalier
