// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/render/MeshPool.h"

#include "model/base/Headroom.h"
#include "model/base/Parallel.h"

#include <algorithm>
#include <limits>

namespace espalier {

namespace {

constexpr std::size_t kPiecesPerTask = 64;
/// Room that is reserved for growth, in elements; memory that is not written to costs nothing.
constexpr std::size_t kLeastReserve = 1U << 20U;
constexpr std::size_t kReserveFactor = 4;
/// Ranges this near to each other (elements) are reported as one.
constexpr std::uint32_t kJoinGap = 256;

/// The new elements are not initialised: the code that uses a run writes all of it.
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

/// The sizes that the piece of a base needs.
struct MeshPool::Needs {
    MeshSize size;
    std::uint32_t leaves = 0;
};

void MeshPool::rebuild(const Tree& tree, const TreeIndex& index)
{
    // clear() keeps the memory, since memory that has been used is faster than new memory.
    m_vertices.clear();
    m_indices.clear();
    m_leaves.clear();
    m_vertexRuns = {};
    m_indexRuns = {};
    m_leafRuns = {};
    m_changes = {};
    m_pieces.clear();
    m_tracker.restart(tree, index);
    finish(tree, index);
}

void MeshPool::follow(const Tree& tree, const TreeIndex& index, const TreeDelta& delta)
{
    if (m_tracker.isStarted())
        m_tracker.follow(tree, index, delta);
}

void MeshPool::finish(const Tree& tree, const TreeIndex& index)
{
    finishSome(tree, index, std::numeric_limits<std::size_t>::max());
}

bool MeshPool::finishSome(const Tree& tree, const TreeIndex& index, std::size_t pieces)
{
    if (!m_tracker.isStarted())
        m_tracker.restart(tree, index);
    const WoodTracker::Work work = m_tracker.take(tree, index, pieces);
    // Some of these may be rows that were removed.
    for (const InternodeId base : work.gone)
        release(m_pieces[base]);
    resizeColumn(m_pieces, tree.size());
    mesh(tree, index, work.wood, true);
    mesh(tree, index, work.leaves, false);
    return m_tracker.isDone();
}

void MeshPool::setLines(std::shared_ptr<const StrandLines> lines)
{
    if (lines == m_lines)
        return;
    m_lines = std::move(lines);
    m_tracker.noteLeavesMoved();
}

bool MeshPool::settle(const Tree& tree, const TreeIndex& index)
{
    finish(tree, index);
    const bool found = noteInexact(tree, index);
    finish(tree, index);
    return found;
}

const MeshPool::Piece* MeshPool::piece(InternodeId base) const
{
    return base < m_pieces.size() && m_pieces[base].vertices.capacity > 0 ? &m_pieces[base] : nullptr;
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
    return m_vertices.size() * sizeof(MeshVertex) + m_indices.size() * sizeof(VertexIndex) +
           m_leaves.size() * sizeof(LeafInstance) + m_pieces.capacity() * sizeof(Piece) + m_tracker.bytes();
}

void MeshPool::mesh(const Tree& tree, const TreeIndex& index, std::span<const InternodeId> bases,
                    bool withWood)
{
    const LeafPlacer placer(tree, index, m_tracker.widths(),
                            m_lines ? std::span<const WoodLine>(*m_lines) : std::span<const WoodLine>(),
                            &m_tracker.placedLeaves());
    std::vector<Needs> needs(bases.size());
    parallelFor(bases.size(), kPiecesPerTask, [&](std::size_t begin, std::size_t end) {
        const auto mesher = m_tracker.pieceMesher(tree, index);
        for (std::size_t i = begin; i < end; ++i) {
            if (withWood)
                needs[i].size = mesher->prepare(bases[i]);
            needs[i].leaves = placer.count(m_tracker.internodesOf(index, bases[i]));
        }
    });

    for (std::size_t i = 0; i < bases.size(); ++i)
        reserve(m_pieces[bases[i]], needs[i], withWood);
    growTo(m_vertices, m_vertexRuns.end());
    growTo(m_indices, 3 * m_indexRuns.end());
    growTo(m_leaves, m_leafRuns.end());

    parallelFor(bases.size(), kPiecesPerTask, [&](std::size_t begin, std::size_t end) {
        const auto mesher = m_tracker.pieceMesher(tree, index);
        for (std::size_t i = begin; i < end; ++i) {
            const Piece& piece = m_pieces[bases[i]];
            if (withWood) {
                mesher->prepare(bases[i]);
                std::fill(m_indices.begin() + piece.indices.first + piece.size.indices,
                          m_indices.begin() + piece.indices.first + piece.indices.capacity, VertexIndex{0});
                mesher->write(std::span(m_vertices).subspan(piece.vertices.first, piece.size.vertices),
                              std::span(m_indices).subspan(piece.indices.first, piece.size.indices),
                              piece.vertices.first);
                m_tracker.noteMeshed(*mesher);
            }
            std::fill(m_leaves.begin() + piece.leaves.first + piece.leafCount,
                      m_leaves.begin() + piece.leaves.first + piece.leaves.capacity, LeafInstance{});
            const std::vector<InternodeId> internodes = m_tracker.internodesOf(index, bases[i]);
            placer.place(internodes, std::span(m_leaves).subspan(piece.leaves.first, piece.leafCount));
            m_tracker.noteLeaves(placer.rule(), internodes);
        }
    });
}

/// Allocates the runs that a piece needs.
void MeshPool::reserve(Piece& piece, const Needs& needs, bool withWood)
{
    if (withWood) {
        if (RunAllocator::capacityFor(needs.size.vertices) != piece.vertices.capacity) {
            m_vertexRuns.release(piece.vertices);
            piece.vertices = m_vertexRuns.allocate(needs.size.vertices);
        }
        // Runs consist of whole triangles, otherwise the slack of one run would shift the triangles behind
        // it.
        if (3 * RunAllocator::capacityFor(needs.size.indices / 3) != piece.indices.capacity) {
            releaseIndices(piece.indices);
            const Run triangles = m_indexRuns.allocate(needs.size.indices / 3);
            piece.indices = {3 * triangles.first, 3 * triangles.capacity};
        }
        piece.size = needs.size;
        add(m_changes.vertices, piece.vertices.first, piece.vertices.first + needs.size.vertices);
        add(m_changes.indices, piece.indices.first, piece.indices.first + piece.indices.capacity);
    }
    if (RunAllocator::capacityFor(needs.leaves) != piece.leaves.capacity) {
        releaseLeaves(piece.leaves);
        piece.leaves = m_leafRuns.allocate(needs.leaves);
    }
    piece.leafCount = needs.leaves;
    add(m_changes.leaves, piece.leaves.first, piece.leaves.first + piece.leaves.capacity);
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

void MeshPool::release(Piece& piece)
{
    m_vertexRuns.release(piece.vertices);
    releaseIndices(piece.indices);
    releaseLeaves(piece.leaves);
    piece = {};
}

} // namespace espalier
