// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/project/JournalColumns.h"

#include <algorithm>
#include <numeric>

namespace espalier {

JournalCounts JournalCounts::of(const Journal& journal)
{
    JournalCounts counts;
    counts.deltas = static_cast<std::uint32_t>(journal.size());
    for (const auto& delta : journal) {
        counts.died += static_cast<std::uint32_t>(delta->died.size());
        counts.budChanges += static_cast<std::uint32_t>(delta->buds.size());
        counts.frames += static_cast<std::uint32_t>(delta->frames.size());
        counts.widths += static_cast<std::uint32_t>(delta->widths.size());
        counts.lassos += static_cast<std::uint32_t>(delta->lassos.size());
    }
    return counts;
}

JournalColumns JournalColumns::of(const Journal& journal)
{
    JournalColumns columns;
    for (const auto& delta : journal) {
        columns.stepBefore.append(delta->stepBefore);
        columns.stepAfter.append(delta->stepAfter);
        columns.parametersBefore.append(delta->parametersBefore);
        columns.parametersAfter.append(delta->parametersAfter);
        columns.bornFirst.append(delta->born.first);
        columns.bornCount.append(delta->born.count);
        columns.diedCount.append(static_cast<std::uint32_t>(delta->died.size()));
        columns.budCount.append(static_cast<std::uint32_t>(delta->buds.size()));
        columns.frameCount.append(static_cast<std::uint32_t>(delta->frames.size()));
        columns.widthCount.append(static_cast<std::uint32_t>(delta->widths.size()));
        columns.lassoCount.append(static_cast<std::uint32_t>(delta->lassos.size()));
        for (const InternodeId id : delta->died)
            columns.died.append(id);
        for (const TreeDelta::BudChange& change : delta->buds) {
            columns.budId.append(change.id);
            columns.budBefore.append(change.before);
            columns.budAfter.append(change.after);
        }
        for (const TreeDelta::FrameChange& change : delta->frames) {
            columns.frameId.append(change.id);
            columns.rotationBefore.append(change.before);
            columns.rotationAfter.append(change.after);
            columns.lengthBefore.append(change.lengthBefore);
            columns.lengthAfter.append(change.lengthAfter);
        }
        for (const TreeDelta::WidthChange& change : delta->widths) {
            columns.widthId.append(change.id);
            columns.widthBefore.append(change.before);
            columns.widthAfter.append(change.after);
        }
        for (const TreeDelta::LassoChange& change : delta->lassos) {
            columns.lassoIndex.append(change.index);
            columns.lassoInForce.append(change.isInForce ? 1 : 0);
        }
    }
    return columns;
}

std::optional<Journal> JournalColumns::toJournal(const JournalCounts& counts) const
{
    const auto sum = [](const QList<std::uint32_t>& column) {
        return std::accumulate(column.begin(), column.end(), std::uint64_t{0});
    };
    if (sum(diedCount) != counts.died || sum(budCount) != counts.budChanges ||
        sum(frameCount) != counts.frames || sum(widthCount) != counts.widths ||
        sum(lassoCount) != counts.lassos ||
        std::ranges::any_of(lassoInForce, [](std::uint8_t flag) { return flag > 1; }))
        return {};
    Journal journal;
    journal.reserve(counts.deltas);
    auto death = died.begin();
    qsizetype bud = 0;
    qsizetype frame = 0;
    qsizetype width = 0;
    qsizetype lasso = 0;
    for (qsizetype i = 0; i < stepBefore.size(); ++i) {
        auto delta = std::make_shared<TreeDelta>();
        delta->stepBefore = stepBefore[i];
        delta->stepAfter = stepAfter[i];
        delta->parametersBefore = parametersBefore[i];
        delta->parametersAfter = parametersAfter[i];
        delta->born = {bornFirst[i], bornCount[i]};
        delta->died.assign(death, death + diedCount[i]);
        death += diedCount[i];
        delta->buds.reserve(budCount[i]);
        for (const qsizetype end = bud + budCount[i]; bud < end; ++bud)
            delta->buds.push_back({budId[bud], budBefore[bud], budAfter[bud]});
        delta->frames.reserve(frameCount[i]);
        for (const qsizetype end = frame + frameCount[i]; frame < end; ++frame)
            delta->frames.push_back({frameId[frame], rotationBefore[frame], rotationAfter[frame],
                                     lengthBefore[frame], lengthAfter[frame]});
        delta->widths.reserve(widthCount[i]);
        for (const qsizetype end = width + widthCount[i]; width < end; ++width)
            delta->widths.push_back({widthId[width], widthBefore[width], widthAfter[width]});
        delta->lassos.reserve(lassoCount[i]);
        for (const qsizetype end = lasso + lassoCount[i]; lasso < end; ++lasso)
            delta->lassos.push_back({lassoIndex[lasso], lassoInForce[lasso] != 0});
        journal.push_back(std::move(delta));
    }
    return journal;
}

} // namespace espalier
