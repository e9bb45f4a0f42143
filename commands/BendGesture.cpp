// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/BendGesture.h"

#include "commands/RecordedEdit.h"
#include "commands/recipe/RecipeJson.h"

#include <QCoreApplication>

#include <algorithm>

namespace espalier {

namespace {

/// The changes of @p first and then @p second as one list; all are by ascending id.
std::vector<FrameChange> joined(const std::vector<FrameChange>& first, const std::vector<FrameChange>& second)
{
    std::vector<FrameChange> all;
    all.reserve(first.size() + second.size());
    auto later = second.begin();
    for (const FrameChange& change : first) {
        for (; later != second.end() && later->id < change.id; ++later)
            all.push_back(*later);
        FrameChange both = change;
        if (later != second.end() && later->id == change.id) {
            both.after = later->after;
            both.lengthAfter = later->lengthAfter;
            ++later;
        }
        if (both.after != both.before || both.lengthAfter != both.lengthBefore)
            all.push_back(both);
    }
    all.insert(all.end(), later, second.end());
    return all;
}

} // namespace

BendGesture::BendGesture(TreeDocument& document, InternodeId base, std::vector<BranchBend::Handle> handles,
                         const BendOptions& options)
    : m_edit(document, [this] { finish(); }),
      m_options(options),
      m_bend(bendOf(document, base, handles, options))
{
    measure(handles);
    m_grips.push_back(gripOf(base, handles));
}

BranchBend BendGesture::bendOf(const TreeDocument& document, InternodeId base,
                               std::span<const BranchBend::Handle> handles, const BendOptions& options)
{
    const Tree& tree = document.tree();
    InternodeId end = base;
    for (const BranchBend::Handle& handle : handles) {
        if (handle.id < tree.size() && tree.isAlive(handle.id) && handle.id > end &&
            !pathBetween(tree, base, handle.id).empty())
            end = handle.id;
    }
    return {tree, document.index(), base, end == base ? kNoInternode : end, handles, options};
}

void BendGesture::measure(std::span<const BranchBend::Handle> handles)
{
    m_gripPoints.clear();
    for (const BranchBend::Handle& handle : handles)
        m_gripPoints.push_back(m_bend.restPoint(handle));
}

void BendGesture::regrip(InternodeId base, std::vector<BranchBend::Handle> handles)
{
    if (!m_edit.isActive())
        return;
    m_done = joined(m_done, m_bend.changes());
    m_bend = bendOf(m_edit.document(), base, handles, m_options);
    measure(handles);
    m_grips.push_back(gripOf(base, handles));
}

BendOperation::Grip BendGesture::gripOf(InternodeId base, std::span<const BranchBend::Handle> handles)
{
    m_holding.clear();
    BendOperation::Grip grip;
    const std::span<const InternodeId> path = m_bend.path();
    if (path.empty())
        return grip;
    const TreeDocument& document = m_edit.document();
    grip.base = InternodeReference::to(document, base);
    for (std::size_t i = 0; i < handles.size(); ++i) {
        if (handles[i].id == base || !std::ranges::binary_search(path, handles[i].id))
            continue;
        m_holding.push_back(i);
        grip.handles.push_back({InternodeReference::to(document, handles[i].id), handles[i].along,
                                withoutNegativeZeros(m_gripPoints[i])});
    }
    return grip;
}

std::vector<Vec3> BendGesture::note(std::span<const Vec3> targets, bool settles)
{
    std::vector<Vec3> wanted(targets.begin(), targets.end());
    for (std::size_t i = wanted.size(); i < m_gripPoints.size(); ++i)
        wanted.push_back(m_gripPoints[i]);
    for (Vec3& target : wanted)
        target = withoutNegativeZeros(target);
    BendOperation::Grip& grip = m_grips.back();
    BendOperation::Move move;
    if (!settles)
        move.calls = 1;
    for (const std::size_t i : m_holding)
        move.targets.push_back(wanted[i]);
    for (std::size_t i = 0; i < m_holding.size(); ++i)
        grip.handles[i].target = move.targets[i];
    const bool isAgain = !settles && !grip.moves.empty() && grip.moves.back().calls &&
                         grip.moves.back().targets == move.targets;
    if (isAgain)
        ++*grip.moves.back().calls;
    else
        grip.moves.push_back(std::move(move));
    return wanted;
}

BendOperation BendGesture::operation() const
{
    // A grip without moves has changed nothing.
    std::vector<BendOperation::Grip> grips;
    for (const BendOperation::Grip& grip : m_grips) {
        if (grip.moves.empty())
            continue;
        grips.push_back(grip);
        if (grip.moves.size() == 1 && !grip.moves.front().calls)
            grips.back().moves.clear(); // the handles' targets suffice
    }
    BendOperation bend{.base = grips.front().base,
                       .handles = grips.front().handles,
                       .moves = grips.front().moves,
                       .bending = m_options.bending,
                       .stretching = m_options.stretching};
    bend.regrips.assign(grips.begin() + 1, grips.end());
    return bend;
}

bool BendGesture::moveTo(std::span<const Vec3> targets)
{
    if (!m_edit.isActive() || m_bend.path().empty())
        return true;
    const bool settled = m_bend.solve(note(targets, false));
    show();
    return settled;
}

void BendGesture::settleAt(std::span<const Vec3> targets)
{
    if (!m_edit.isActive() || m_bend.path().empty())
        return;
    const std::vector<Vec3> wanted = note(targets, true);
    for (int call = 0; call < kMostPulls && !m_bend.solve(wanted); ++call) {
    }
    show();
}

void BendGesture::show()
{
    std::vector<FrameChange> changes = joined(m_done, m_bend.changes());
    apply(changes);
    // If a bend moves nodes beyond the limit, the branch keeps the form of the call before.
    const TreeDocument& document = m_edit.document();
    const bool isInWorld = std::ranges::all_of(document.index().recentlyMoved(), [&](InternodeId id) {
        return document.index().nodePosition(id).cwiseAbs().maxCoeff<Eigen::PropagateNaN>() <= kFarthestNode;
    });
    if (isInWorld)
        m_shown = std::move(changes);
    else
        apply(m_shown);
}

void BendGesture::apply(const std::vector<FrameChange>& changes)
{
    m_edit.takeBack();
    TreeDelta delta = deltaStartingAt(m_edit.document().tree());
    for (const FrameChange& change : changes)
        delta.addFrame(change.id, change.before, change.after, change.lengthBefore, change.lengthAfter);
    m_edit.apply(std::move(delta));
}

void BendGesture::finish()
{
    commitRecorded(m_edit, QCoreApplication::translate("Commands", "Bend"), [this] { return operation(); });
}

} // namespace espalier
