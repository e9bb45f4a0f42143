// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/MeshPool.h"

#include "model/base/Parallel.h"
#include "model/mesh/Tubes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace espalier {

namespace {

constexpr std::size_t kTubesPerTask = 64;
/// Room that is set aside for growth, in elements; memory that is not written to costs nothing.
constexpr std::size_t kLeastReserve = 1U << 20U;
constexpr std::size_t kReserveFactor = 4;
/// In how many steps all radii are looked at, where they all change.
constexpr std::uint32_t kRoundSteps = 4;
/// Share of the tolerance that is kept for what drifts between two looks.
constexpr float kDriftShare = 0.25F;
/// Ranges this near to each other (elements) are reported as one.
constexpr std::uint32_t kJoinGap = 256;

bool isOff(float value, float reference, float tolerance)
{
    return std::abs(value - reference) > tolerance * reference;
}

/// The new places are left as they are: whoever uses a run writes all of it.
template <class T>
void growTo(MeshBuffer<T>& buffer, std::uint32_t size)
{
    if (size > buffer.capacity())
        buffer.reserve(std::max(kLeastReserve, kReserveFactor * size));
    if (size > buffer.size())
        buffer.resize(size);
}

void add(std::vector<MeshPool::Range>& ranges, std::uint32_t begin, std::uint32_t end)
{
    if (begin < end)
        ranges.push_back({begin, end});
}

void coalesce(std::vector<MeshPool::Range>& ranges)
{
    std::ranges::sort(ranges, {}, &MeshPool::Range::begin);
    std::size_t kept = 0;
    for (const MeshPool::Range& range : ranges) {
        if (kept > 0 && range.begin <= ranges[kept - 1].end + kJoinGap)
            ranges[kept - 1].end = std::max(ranges[kept - 1].end, range.end);
        else
            ranges[kept++] = range;
    }
    ranges.resize(kept);
}

} // namespace

/// What the tube of a base will take.
struct MeshPool::Needs {
    MeshSize size;
    std::uint32_t leaves = 0;
};

void MeshPool::rebuild(const Tree& tree, const TreeIndex& index)
{
    MeshPool fresh(m_options);
    // Memory that has been used is faster than new.
    fresh.m_vertices.swap(m_vertices);
    fresh.m_indices.swap(m_indices);
    fresh.m_leaves.swap(m_leaves);
    *this = std::move(fresh);
    m_vertices.clear();
    m_indices.clear();
    m_leaves.clear();
    m_parameters = tree.parameters();
    m_widths.emplace(tree, index);
    startRound();
    resize(tree.size());
    for (InternodeId id = 0; id < tree.size(); ++id) {
        if (tree.isAlive(id))
            m_continuation[id] = tubeContinuation(index, id);
    }
    meshTubes(tree, index, tubesOf(tree, index), true);
}

void MeshPool::follow(const Tree& tree, const TreeIndex& index, const TreeDelta& delta)
{
    const TreeParameters& now = tree.parameters();
    if (!m_widths)
        return;
    m_hasChanged = true;
    const bool areWidthsOthers = m_parameters.widths != now.widths;
    m_woodIsDirty = m_woodIsDirty || areWidthsOthers || m_parameters.bark.scale != now.bark.scale;
    m_leavesAreDirty = m_leavesAreDirty || m_parameters.leaves != now.leaves ||
                       m_parameters.growth.irregularity != now.growth.irregularity;
    m_parameters = now;
    // With constraints, any edit may change widths anywhere: finish() computes and compares them all, once.
    // With neither these nor a base diameter, they do not depend on the tree.
    if (!tree.widthConstraints().empty() || !delta.sparse.width.empty())
        m_widthsAreStale = true;
    else if (now.widths.baseDiameter > 0.0 || areWidthsOthers)
        m_widths.emplace(tree, index);
    for (auto id = static_cast<InternodeId>(m_tubes.size()); id-- > tree.size();)
        forget(id); // its row was taken out
    resize(tree.size());
    ++m_update;
    collectTouched(tree, index, delta);
    collectChanged(tree, index);
}

void MeshPool::finish(const Tree& tree, const TreeIndex& index)
{
    finishSome(tree, index, std::numeric_limits<std::size_t>::max());
}

bool MeshPool::finishSome(const Tree& tree, const TreeIndex& index, std::size_t tubes)
{
    if (!m_widths) {
        rebuild(tree, index);
        return true;
    }
    const bool hasChanged = std::exchange(m_hasChanged, false);
    if (hasChanged)
        followWidths(tree, index);
    if (std::exchange(m_woodIsDirty, false)) {
        m_dirty = tubesOf(tree, index);
        startRound();
    }
    if (hasChanged || !m_dirty.empty())
        collectWaiting(tree);
    if (std::exchange(m_leavesAreDirty, false)) {
        m_bare = tubesOf(tree, index);
        std::ranges::reverse(m_bare);
    }
    const auto take = [&tubes](std::vector<InternodeId>& from) {
        const auto first = from.end() - static_cast<std::ptrdiff_t>(std::min(tubes, from.size()));
        std::vector<InternodeId> taken(first, from.end());
        from.erase(first, from.end());
        tubes -= taken.size();
        return taken;
    };
    const std::vector<InternodeId> wood = take(m_waiting);
    releaseInner(wood);
    meshTubes(tree, index, wood, true);
    if (m_waiting.empty())
        meshTubes(tree, index, take(m_bare), false);
    return m_waiting.empty() && m_bare.empty();
}

bool MeshPool::settle(const Tree& tree, const TreeIndex& index)
{
    finish(tree, index);
    const bool found = noteInexact(tree, index);
    finish(tree, index);
    return found;
}

bool MeshPool::noteInexact(const Tree& tree, const TreeIndex& index)
{
    ++m_update;
    collectRange(tree, index, {0, tree.size()}, 0.0F);
    startRound();
    return !m_dirty.empty();
}

const MeshPool::Tube* MeshPool::tube(InternodeId base) const
{
    return base < m_tubes.size() && m_tubes[base].vertices.capacity > 0 ? &m_tubes[base] : nullptr;
}

MeshPool::Changes MeshPool::takeChanges()
{
    coalesce(m_changes.vertices);
    coalesce(m_changes.indices);
    coalesce(m_changes.leaves);
    return std::exchange(m_changes, {});
}

std::size_t MeshPool::bytes() const
{
    constexpr std::size_t row =
        sizeof(Tube) + sizeof(InternodeId) + sizeof(float) + 1 + 2 * sizeof(std::uint32_t);
    return m_vertices.size() * sizeof(MeshVertex) + m_indices.size() * sizeof(VertexIndex) +
           m_leaves.size() * sizeof(LeafInstance) + m_tubes.size() * row;
}

void MeshPool::resize(std::uint32_t size)
{
    m_tubes.resize(size);
    m_continuation.resize(size, kNoInternode);
    m_radius.resize(size, 0.0F);
    m_bears.resize(size, 0);
    m_inspected.resize(size, 0);
    m_visited.resize(size, 0);
}

/// Born, dead, back to life or moved: their tubes and those of their parents.
void MeshPool::collectTouched(const Tree& tree, const TreeIndex& index, const TreeDelta& delta)
{
    const auto touch = [&](InternodeId id) {
        if (id >= tree.size()) {
            const InternodeId parent = delta.rows->internodes.parent[id - delta.born.first];
            if (parent < tree.size() && tree.isAlive(parent))
                inspect(tree, index, parent, kTolerance);
            return;
        }
        if (tree.isAlive(id)) {
            m_dirty.push_back(id);
            inspect(tree, index, id, kTolerance);
        } else {
            forget(id);
        }
        if (const InternodeId parent = tree.parent(id); parent != kNoInternode && tree.isAlive(parent))
            inspect(tree, index, parent, kTolerance);
    };
    // Buds are not meshed, so of the touched only these matter.
    for (InternodeId id = delta.born.first; id != delta.born.end(); ++id)
        touch(id);
    for (const InternodeId id : delta.died)
        touch(id);
    for (const InternodeId id : index.recentlyMoved()) {
        if (tree.isAlive(id))
            m_dirty.push_back(id);
    }
    // What a bent internode stands on has another bend at its end.
    delta.forEachReframed([&](InternodeId id) {
        if (const InternodeId parent = tree.parent(id); parent != kNoInternode && tree.isAlive(parent))
            m_dirty.push_back(parent);
    });
}

/// Internodes that carry more or less than before.
void MeshPool::collectChanged(const Tree& tree, const TreeIndex& index)
{
    const LeafPlacer placer(tree, index);
    for (const InternodeId id : index.recentlyChanged()) {
        if (!tree.isAlive(id))
            continue;
        checkRadius(index, id, kTolerance);
        if (placer.bears(id) != (m_bears[id] != 0))
            m_dirty.push_back(id);
        inspect(tree, index, id, kTolerance);
        if (const InternodeId parent = tree.parent(id); parent != kNoInternode)
            inspect(tree, index, parent, kTolerance);
    }
}

void MeshPool::collectRange(const Tree& tree, const TreeIndex& index, IdRange range, float tolerance)
{
    for (InternodeId id = range.first; id != range.end(); ++id) {
        if (!tree.isAlive(id))
            continue;
        checkRadius(index, id, tolerance);
        inspect(tree, index, id, tolerance);
    }
}

void MeshPool::startRound()
{
    m_roundExponent = m_checkedExponent = m_widths->exponent();
    m_nextCheck = 0;
}

/// With a base diameter set, every tip changes the exponent of all widths a little. So that no step pays for
/// all, each looks at some internodes, unless the drift becomes too great for that.
void MeshPool::followWidths(const Tree& tree, const TreeIndex& index)
{
    if (std::exchange(m_widthsAreStale, false)) {
        m_widths.emplace(tree, index);
        ++m_update;
        collectRange(tree, index, {0, tree.size()}, kTolerance);
        startRound();
        return;
    }
    const double exponent = m_widths->exponent();
    if (exponent == m_roundExponent && exponent == m_checkedExponent)
        return;
    constexpr float tolerance = (1.0F - kDriftShare) * kTolerance;
    ++m_update;
    const double drift = std::pow(std::max(1U, index.tipCount(0)), 1.0 / exponent - 1.0 / m_checkedExponent);
    if (std::abs(drift - 1.0) > kDriftShare * kTolerance) {
        collectRange(tree, index, {0, tree.size()}, tolerance);
        startRound();
        return;
    }
    const std::uint32_t rest = tree.size() - m_nextCheck;
    const IdRange range{m_nextCheck, std::min(rest, tree.size() / kRoundSteps + 1)};
    collectRange(tree, index, range, tolerance);
    m_nextCheck = range.end();
    if (m_nextCheck == tree.size()) {
        m_checkedExponent = std::exchange(m_roundExponent, exponent);
        m_nextCheck = 0;
    }
}

void MeshPool::checkRadius(const TreeIndex& index, InternodeId id, float tolerance)
{
    if (isOff(m_widths->radius(index, id), m_radius[id], tolerance))
        m_dirty.push_back(id);
}

/// Looks at a living internode's node: through which child its tube goes on, and whether the others still
/// fit.
void MeshPool::inspect(const Tree& tree, const TreeIndex& index, InternodeId id, float tolerance)
{
    if (std::exchange(m_inspected[id], m_update) == m_update)
        return;
    const InternodeId continuation = tubeContinuation(index, id);
    if (const InternodeId before = std::exchange(m_continuation[id], continuation); before != continuation) {
        m_dirty.push_back(id);
        if (before != kNoInternode && tree.isAlive(before))
            m_dirty.push_back(before);
        if (continuation != kNoInternode)
            m_dirty.push_back(continuation);
    }
    const float radius = m_widths->radius(index, id);
    for (InternodeId child = index.firstChild(id); child != kNoInternode; child = index.nextSibling(child)) {
        if (child != continuation && isOff(radius, m_tubes[child].parentRadius, tolerance))
            m_dirty.push_back(child);
    }
}

void MeshPool::forget(InternodeId id)
{
    release(m_tubes[id]);
    m_continuation[id] = kNoInternode;
    m_radius[id] = 0.0F;
    m_bears[id] = 0;
}

/// Turns what has been noted since into tubes that wait behind the others. Where the tree has changed, those
/// may be no tubes any more, so all are looked for anew.
void MeshPool::collectWaiting(const Tree& tree)
{
    std::vector<InternodeId> noted(m_waiting.rbegin(), m_waiting.rend());
    noted.insert(noted.end(), m_dirty.begin(), m_dirty.end());
    m_dirty.clear();
    m_waiting.clear();
    ++m_update;
    for (const InternodeId id : noted) {
        if (!tree.isAlive(id))
            continue; // died since it was noted
        // Down to the base of its tube, or to where another went down before.
        InternodeId place = id;
        while (std::exchange(m_visited[place], m_update) != m_update) {
            const InternodeId below = tree.parent(place);
            if (below == kNoInternode || m_continuation[below] != place) {
                m_waiting.push_back(place);
                break;
            }
            place = below;
        }
    }
    std::ranges::reverse(m_waiting);
    std::erase_if(m_bare, [&](InternodeId id) {
        if (!tree.isAlive(id))
            return true;
        const InternodeId below = tree.parent(id);
        return (below != kNoInternode && m_continuation[below] == id);
    });
}

/// Tubes that have become a part of another's go when that is meshed.
void MeshPool::releaseInner(std::span<const InternodeId> bases)
{
    for (const InternodeId base : bases) {
        for (InternodeId id = m_continuation[base]; id != kNoInternode; id = m_continuation[id]) {
            if (m_tubes[id].vertices.capacity > 0)
                release(m_tubes[id]);
        }
    }
}

void MeshPool::meshTubes(const Tree& tree, const TreeIndex& index, std::span<const InternodeId> bases,
                         bool withWood)
{
    const LeafPlacer placer(tree, index);
    std::vector<Needs> needs(bases.size());
    parallelFor(bases.size(), kTubesPerTask, [&](std::size_t begin, std::size_t end) {
        TubeMesher mesher(tree, index, *m_widths, m_options);
        for (std::size_t i = begin; i < end; ++i) {
            if (withWood)
                needs[i].size = mesher.prepare(bases[i]);
            needs[i].leaves = placer.count(bases[i]);
        }
    });

    for (std::size_t i = 0; i < bases.size(); ++i)
        reserve(m_tubes[bases[i]], needs[i], withWood);
    growTo(m_vertices, m_vertexRuns.end());
    growTo(m_indices, 3 * m_indexRuns.end());
    growTo(m_leaves, m_leafRuns.end());

    parallelFor(bases.size(), kTubesPerTask, [&](std::size_t begin, std::size_t end) {
        TubeMesher mesher(tree, index, *m_widths, m_options);
        for (std::size_t i = begin; i < end; ++i) {
            Tube& tube = m_tubes[bases[i]];
            if (withWood) {
                mesher.prepare(bases[i]);
                std::fill(m_indices.begin() + tube.indices.first + tube.size.indices,
                          m_indices.begin() + tube.indices.first + tube.indices.capacity, VertexIndex{0});
                mesher.write(std::span(m_vertices).subspan(tube.vertices.first, tube.size.vertices),
                             std::span(m_indices).subspan(tube.indices.first, tube.size.indices),
                             tube.vertices.first);
                tube.parentRadius = mesher.parentRadius();
                for (std::size_t j = 0; j < mesher.radii().size(); ++j)
                    m_radius[mesher.internodes()[j]] = mesher.radii()[j];
            }
            std::fill(m_leaves.begin() + tube.leaves.first + tube.leafCount,
                      m_leaves.begin() + tube.leaves.first + tube.leaves.capacity, LeafInstance{});
            placer.placeTube(bases[i], std::span(m_leaves).subspan(tube.leaves.first, tube.leafCount));
            for (InternodeId id = bases[i]; id != kNoInternode; id = m_continuation[id])
                m_bears[id] = placer.bears(id) ? 1 : 0;
        }
    });
}

/// Gives a tube the room that it needs.
void MeshPool::reserve(Tube& tube, const Needs& needs, bool withWood)
{
    if (withWood) {
        if (RunAllocator::capacityFor(needs.size.vertices) != tube.vertices.capacity) {
            m_vertexRuns.release(tube.vertices);
            tube.vertices = m_vertexRuns.allocate(needs.size.vertices);
        }
        // Runs of whole triangles, or the slack of one would tear those behind it apart.
        if (3 * RunAllocator::capacityFor(needs.size.indices / 3) != tube.indices.capacity) {
            releaseIndices(tube.indices);
            const Run triangles = m_indexRuns.allocate(needs.size.indices / 3);
            tube.indices = {3 * triangles.first, 3 * triangles.capacity};
        }
        tube.size = needs.size;
        add(m_changes.vertices, tube.vertices.first, tube.vertices.first + needs.size.vertices);
        add(m_changes.indices, tube.indices.first, tube.indices.first + tube.indices.capacity);
    }
    if (RunAllocator::capacityFor(needs.leaves) != tube.leaves.capacity) {
        releaseLeaves(tube.leaves);
        tube.leaves = m_leafRuns.allocate(needs.leaves);
    }
    tube.leafCount = needs.leaves;
    add(m_changes.leaves, tube.leaves.first, tube.leaves.first + tube.leaves.capacity);
}

void MeshPool::releaseIndices(const Run& run)
{
    std::fill_n(m_indices.begin() + run.first, run.capacity, VertexIndex{0});
    add(m_changes.indices, run.first, run.first + run.capacity);
    m_indexRuns.release({run.first / 3, run.capacity / 3});
}

void MeshPool::releaseLeaves(const Run& run)
{
    std::fill_n(m_leaves.begin() + run.first, run.capacity, LeafInstance{});
    add(m_changes.leaves, run.first, run.first + run.capacity);
    m_leafRuns.release(run);
}

void MeshPool::release(Tube& tube)
{
    m_vertexRuns.release(tube.vertices);
    releaseIndices(tube.indices);
    releaseLeaves(tube.leaves);
    tube = {};
}

} // namespace espalier
