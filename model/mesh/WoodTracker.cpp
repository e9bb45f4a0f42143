// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/WoodTracker.h"

#include "model/base/Headroom.h"

#include <algorithm>
#include <cmath>

namespace espalier {

namespace {

/// Number of steps in which all radii are checked, when they all change.
constexpr std::uint32_t kRoundSteps = 4;
/// Share of the tolerance that is reserved for drift between two checks.
constexpr float kDriftShare = 0.25F;

bool isOff(float value, float reference, float tolerance)
{
    return std::abs(value - reference) > tolerance * reference;
}

} // namespace

void WoodTracker::restart(const Tree& tree, const TreeIndex& index)
{
    const WoodMeshOptions options = m_options;
    *this = WoodTracker(*m_mesher);
    m_options = options;
    m_parameters = tree.parameters();
    m_placedLeaves.rebuild(tree);
    m_widths.emplace(tree, index);
    startRound();
    resize(tree.size());
    for (InternodeId id = 0; id < tree.size(); ++id) {
        if (!tree.isAlive(id))
            continue;
        m_mesher->joinedChildren(index, id, m_joined);
        for (const InternodeId child : m_joined)
            m_joins[child] = 1;
    }
    m_hasChanged = true;
    m_woodIsDirty = true;
}

void WoodTracker::setOptions(const WoodMeshOptions& options)
{
    m_woodIsDirty = m_woodIsDirty || m_options != options;
    m_options = options;
}

void WoodTracker::follow(const Tree& tree, const TreeIndex& index, const TreeDelta& delta)
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
    // Where radii depend on more than tips, an edit can change widths anywhere: take() computes and compares
    // all of them, once. With neither constraints nor a base diameter, they do not depend on the tree.
    const bool isTapered = now.widths.baseDiameter > 0.0 && index.greatestTipCount() == 1;
    if (!tree.widthConstraints().empty() || !delta.sparse.width.empty() || isTapered ||
        !m_widths->dependOnTipsAlone())
        m_widthsAreStale = true;
    else if (now.widths.baseDiameter > 0.0 || areWidthsOthers)
        m_widths.emplace(tree, index);
    forgetRemoved(tree, delta);
    resize(tree.size());
    ++m_update;
    collectTouched(tree, index, delta);
    collectChanged(tree, index, delta);
    m_placedLeaves.update(tree, delta);
    const std::span<const InternodeId> leafy = m_placedLeaves.recentlyChanged();
    m_dirtyLeaves.insert(m_dirtyLeaves.end(), leafy.begin(), leafy.end());
}

WoodTracker::Work WoodTracker::take(const Tree& tree, const TreeIndex& index, std::size_t pieces)
{
    const bool hasChanged = std::exchange(m_hasChanged, false);
    if (hasChanged)
        followWidths(tree, index);
    if (std::exchange(m_woodIsDirty, false)) {
        m_dirty = m_mesher->pieces(tree, index);
        startRound();
    }
    if (hasChanged || !m_dirty.empty())
        collectWaiting(tree);
    if (std::exchange(m_leavesAreDirty, false)) {
        m_bare = m_mesher->pieces(tree, index);
        std::ranges::reverse(m_bare);
    }
    const auto taken = [&pieces](std::vector<InternodeId>& from) {
        const auto first = from.end() - static_cast<std::ptrdiff_t>(std::min(pieces, from.size()));
        std::vector<InternodeId> ids(first, from.end());
        from.erase(first, from.end());
        pieces -= ids.size();
        return ids;
    };
    Work work;
    work.wood = taken(m_waiting);
    if (m_waiting.empty())
        work.leaves = taken(m_bare);
    work.gone = std::exchange(m_gone, {});
    // Pieces that have become part of another piece are removed when that piece is meshed.
    for (const InternodeId base : work.wood) {
        for (const InternodeId id : internodesOf(index, base)) {
            if (id != base && std::exchange(m_isPiece[id], std::uint8_t{0}) != 0)
                work.gone.push_back(id);
        }
    }
    return work;
}

std::unique_ptr<WoodPieceMesher> WoodTracker::pieceMesher(const Tree& tree, const TreeIndex& index) const
{
    return m_mesher->pieceMesher(tree, index, *m_widths, m_options);
}

void WoodTracker::noteMeshed(const WoodPieceMesher& piece)
{
    const std::span<const InternodeId> internodes = piece.internodes();
    m_isPiece[internodes.front()] = 1;
    m_supportRadius[internodes.front()] = piece.supportRadius();
    for (std::size_t i = 0; i < internodes.size(); ++i)
        m_radius[internodes[i]] = piece.radii()[i];
}

void WoodTracker::noteLeaves(const LeafRule& rule, std::span<const InternodeId> internodes)
{
    for (const InternodeId id : internodes)
        m_bears[id] = rule.bears(id) ? 1 : 0;
}

std::vector<InternodeId> WoodTracker::internodesOf(const TreeIndex& index, InternodeId base) const
{
    std::vector<InternodeId> internodes{base};
    for (std::size_t i = 0; i < internodes.size(); ++i) {
        for (InternodeId child = index.firstChild(internodes[i]); child != kNoInternode;
             child = index.nextSibling(child)) {
            if (m_joins[child] != 0)
                internodes.push_back(child);
        }
    }
    return internodes;
}

bool WoodTracker::noteInexact(const Tree& tree, const TreeIndex& index)
{
    ++m_update;
    collectRange(tree, index, {0, tree.size()}, 0.0F);
    startRound();
    return !m_dirty.empty();
}

std::size_t WoodTracker::bytes() const
{
    constexpr std::size_t row = 2 * sizeof(float) + 3 + 2 * sizeof(std::uint32_t);
    return m_radius.capacity() * row + m_placedLeaves.bytes();
}

void WoodTracker::resize(std::uint32_t size)
{
    resizeColumn(m_joins, size, std::uint8_t{0});
    resizeColumn(m_isPiece, size, std::uint8_t{0});
    resizeColumn(m_supportRadius, size, 0.0F);
    resizeColumn(m_radius, size, 0.0F);
    resizeColumn(m_bears, size, std::uint8_t{0});
    resizeColumn(m_inspected, size, 0U);
    resizeColumn(m_visited, size, 0U);
}

/// Handles rows that were taken out: pieces that continued in them now end at their parents.
void WoodTracker::forgetRemoved(const Tree& tree, const TreeDelta& delta)
{
    for (auto id = static_cast<InternodeId>(m_joins.size()); id-- > tree.size();) {
        if (m_joins[id] != 0 && delta.born.contains(id)) {
            const InternodeId parent = delta.rows->internodes.parent[id - delta.born.first];
            if (parent < tree.size() && tree.isAlive(parent))
                m_dirty.push_back(parent);
        }
        forget(id);
    }
}

/// Notes internodes that were born, died, came back to life or moved: their pieces and those of their
/// parents.
void WoodTracker::collectTouched(const Tree& tree, const TreeIndex& index, const TreeDelta& delta)
{
    const auto touch = [&](InternodeId id) {
        if (id >= tree.size()) {
            const InternodeId below = delta.rows->internodes.parent[id - delta.born.first];
            if (below < tree.size() && tree.isAlive(below))
                inspect(index, below, kTolerance);
            return;
        }
        const InternodeId parent = tree.parent(id);
        const bool standsOnWood = parent != kNoInternode && tree.isAlive(parent);
        if (tree.isAlive(id)) {
            m_dirty.push_back(id);
            inspect(index, id, kTolerance);
        } else {
            // The piece that it continued now ends at its parent.
            if (standsOnWood && m_joins[id] != 0)
                m_dirty.push_back(parent);
            forget(id);
        }
        if (standsOnWood)
            inspect(index, parent, kTolerance);
    };
    // Buds are not meshed, so only these internodes of the delta matter.
    for (InternodeId id = delta.born.first; id != delta.born.end(); ++id)
        touch(id);
    for (const InternodeId id : delta.died)
        touch(id);
    for (const InternodeId id : index.recentlyMoved()) {
        if (tree.isAlive(id))
            m_dirty.push_back(id);
    }
    // The internode below a bent one has another bend at its end.
    delta.forEachReframed([&](InternodeId id) {
        if (const InternodeId parent = tree.parent(id); parent != kNoInternode && tree.isAlive(parent))
            m_dirty.push_back(parent);
    });
}

/// Notes internodes that carry more or fewer tips than before, or have leaves since the user set their width,
/// or have none any more.
void WoodTracker::collectChanged(const Tree& tree, const TreeIndex& index, const TreeDelta& delta)
{
    const LeafRule leaves(tree, index);
    for (const InternodeId id : index.recentlyChanged()) {
        if (!tree.isAlive(id))
            continue;
        checkRadius(index, id, kTolerance);
        if (leaves.bears(id) != (m_bears[id] != 0))
            m_dirty.push_back(id);
        inspect(index, id, kTolerance);
        if (const InternodeId parent = tree.parent(id); parent != kNoInternode)
            inspect(index, parent, kTolerance);
    }
    for (const auto& change : delta.sparse.width) {
        if (tree.isAlive(change.row) && leaves.bears(change.row) != (m_bears[change.row] != 0))
            m_dirty.push_back(change.row);
    }
}

void WoodTracker::collectRange(const Tree& tree, const TreeIndex& index, IdRange range, float tolerance)
{
    for (InternodeId id = range.first; id != range.end(); ++id) {
        if (!tree.isAlive(id))
            continue;
        checkRadius(index, id, tolerance);
        inspect(index, id, tolerance);
    }
}

void WoodTracker::startRound()
{
    m_roundPower = m_checkedPower = m_widths->power();
    m_nextCheck = 0;
}

/// With a base diameter, every tip changes the power of all widths a little. Each step checks only some
/// internodes, to spread the cost, unless the drift becomes too great for that.
void WoodTracker::followWidths(const Tree& tree, const TreeIndex& index)
{
    if (std::exchange(m_widthsAreStale, false)) {
        m_widths.emplace(tree, index);
        ++m_update;
        collectRange(tree, index, {0, tree.size()}, kTolerance);
        startRound();
        return;
    }
    const double power = m_widths->power();
    if (power == m_roundPower && power == m_checkedPower)
        return;
    constexpr float tolerance = (1.0F - kDriftShare) * kTolerance;
    ++m_update;
    const double drift = std::pow(std::max(1U, index.greatestTipCount()), power - m_checkedPower);
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
        m_checkedPower = std::exchange(m_roundPower, power);
        m_nextCheck = 0;
    }
}

void WoodTracker::checkRadius(const TreeIndex& index, InternodeId id, float tolerance)
{
    if (isOff(m_widths->radius(index, id), m_radius[id], tolerance))
        m_dirty.push_back(id);
}

/// Checks a living internode's node: which children belong to its piece, and whether the other children still
/// fit.
void WoodTracker::inspect(const TreeIndex& index, InternodeId id, float tolerance)
{
    if (std::exchange(m_inspected[id], m_update) == m_update)
        return;
    const float radius = m_widths->radius(index, id);
    m_mesher->joinedChildren(index, id, m_joined);
    auto next = m_joined.begin(); // by ascending id, like the children
    for (InternodeId child = index.firstChild(id); child != kNoInternode; child = index.nextSibling(child)) {
        const std::uint8_t joins = next != m_joined.end() && *next == child ? 1 : 0;
        if (joins != 0)
            ++next;
        if (std::exchange(m_joins[child], joins) != joins) {
            m_dirty.push_back(id);
            m_dirty.push_back(child);
        }
        if (joins == 0 && isOff(radius, m_supportRadius[child], tolerance))
            m_dirty.push_back(child);
    }
}

void WoodTracker::forget(InternodeId id)
{
    if (std::exchange(m_isPiece[id], std::uint8_t{0}) != 0)
        m_gone.push_back(id);
    m_joins[id] = 0;
    m_supportRadius[id] = 0.0F;
    m_radius[id] = 0.0F;
    m_bears[id] = 0;
}

/// The first internode of the piece that a living internode belongs to; kNoInternode if an earlier call of
/// this update has reached that piece.
InternodeId WoodTracker::newPieceOf(const Tree& tree, InternodeId id)
{
    while (std::exchange(m_visited[id], m_update) != m_update) {
        const InternodeId below = tree.parent(id);
        if (below == kNoInternode || m_joins[id] == 0)
            return id;
        id = below;
    }
    return kNoInternode;
}

/// Turns the noted internodes into pieces at the end of the queue. If the tree has changed, queued internodes
/// may not begin pieces any more, so all are looked up again.
void WoodTracker::collectWaiting(const Tree& tree)
{
    std::vector<InternodeId> noted(m_waiting.rbegin(), m_waiting.rend());
    noted.insert(noted.end(), m_dirty.begin(), m_dirty.end());
    m_dirty.clear();
    m_waiting.clear();
    ++m_update;
    for (const InternodeId id : noted) {
        if (!tree.isAlive(id))
            continue; // it has died since it was noted
        if (const InternodeId base = newPieceOf(tree, id); base != kNoInternode)
            m_waiting.push_back(base);
    }
    std::ranges::reverse(m_waiting);
    std::erase_if(m_bare, [&](InternodeId id) { return !tree.isAlive(id) || m_joins[id] != 0; });
    for (const InternodeId id : m_bare)
        m_visited[id] = m_update;
    std::vector<InternodeId> bare;
    for (const InternodeId id : m_dirtyLeaves) {
        const InternodeId base = tree.isAlive(id) ? newPieceOf(tree, id) : kNoInternode;
        if (base != kNoInternode)
            bare.push_back(base);
    }
    m_dirtyLeaves.clear();
    m_bare.insert(m_bare.begin(), bare.rbegin(), bare.rend());
}

} // namespace espalier
