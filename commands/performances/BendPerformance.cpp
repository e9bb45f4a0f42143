// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/BendGesture.h"
#include "commands/recipe/BendOperation.h"
#include "commands/recipe/RecipeText.h"

#include <algorithm>

namespace espalier {

namespace {

/// A grip with the internodes that were found.
struct FoundGrip {
    InternodeId base = kNoInternode;
    std::vector<BranchBend::Handle> handles{};
    std::vector<std::size_t> indices{}; ///< Index of each handle among the operation's
    bool isThere() const { return base != kNoInternode; }
};

FoundGrip find(const TreeDocument& document, const InternodeReference& base,
               std::span<const BendOperation::Handle> handles, QStringList& faults)
{
    FoundGrip found;
    const Result<InternodeId> baseId = base.resolve(document);
    if (!baseId) {
        faults.append(baseId.error().message);
        return found;
    }
    found.base = *baseId;
    for (std::size_t i = 0; i < handles.size(); ++i) {
        const Result<InternodeId> id = handles[i].internode.resolve(document);
        if (!id) {
            faults.append(id.error().message);
            continue;
        }
        found.handles.push_back({*id, handles[i].along});
        found.indices.push_back(i);
    }
    return found;
}

void pull(BendGesture& gesture, const FoundGrip& grip, std::span<const BendOperation::Handle> handles,
          std::span<const BendOperation::Move> moves, QStringList& faults)
{
    // The path begins with the base, which no handle can move.
    const std::span<const InternodeId> path = gesture.path();
    for (const BranchBend::Handle& handle : grip.handles) {
        if (path.empty() || std::ranges::find(path.subspan(1), handle.id) == path.end())
            faults.append(RecipeText::tr("internode %1 is not on the branch above internode %2")
                              .arg(handle.id)
                              .arg(grip.base));
    }
    std::vector<Vec3> targets(grip.handles.size());
    for (const BendOperation::Move& move : moves) {
        for (std::size_t i = 0; i < targets.size(); ++i)
            targets[i] = move.targets[grip.indices[i]];
        for (int call = 0; call < move.calls.value_or(0); ++call)
            gesture.moveTo(targets);
        if (!move.calls)
            gesture.settleAt(targets);
    }
    if (!moves.empty())
        return;
    for (std::size_t i = 0; i < targets.size(); ++i)
        targets[i] = handles[grip.indices[i]].target;
    gesture.settleAt(targets);
}

} // namespace

QString BendOperation::perform(TreeDocument& document) const
{
    QStringList faults;
    const FoundGrip first = find(document, base, handles, faults);
    if (!first.isThere())
        return joinedFaults(faults);
    BendGesture gesture(document, first.base, first.handles, {.stretching = stretching, .bending = bending});
    pull(gesture, first, handles, moves, faults);
    for (const Grip& regrip : regrips) {
        const FoundGrip found = find(document, regrip.base, regrip.handles, faults);
        if (!found.isThere())
            continue;
        gesture.regrip(found.base, found.handles);
        pull(gesture, found, regrip.handles, regrip.moves, faults);
    }
    gesture.finish();
    return joinedFaults(faults);
}

} // namespace espalier
