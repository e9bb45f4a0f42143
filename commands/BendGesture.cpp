// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/BendGesture.h"

#include <QCoreApplication>

#include <algorithm>

namespace espalier {

namespace {

/// What @p first and then @p second do, both ascending.
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
}

bool BendGesture::moveTo(std::span<const Vec3> targets)
{
    if (!m_edit.isActive() || m_bend.path().empty())
        return true;
    const bool settled = m_bend.solve(targets);
    show();
    return settled;
}

void BendGesture::settleAt(std::span<const Vec3> targets)
{
    if (!m_edit.isActive() || m_bend.path().empty())
        return;
    for (int call = 0; call < kMostCalls && !m_bend.solve(targets); ++call) {
    }
    show();
}

void BendGesture::show()
{
    std::vector<FrameChange> changes = joined(m_done, m_bend.changes());
    apply(changes);
    // A branch that is stretched out of the world stays as it was before.
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
    m_edit.commit(QCoreApplication::translate("Commands", "Bend"));
}

} // namespace espalier
