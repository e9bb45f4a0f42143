// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/project/ProjectVersion1.h"

#include "model/base/Random.h"
#include "model/io/project/ColumnEntries.h"
#include "model/io/project/KeptEntries.h"
#include "model/io/project/ProjectDescription.h"
#include "model/io/project/ProjectImages.h"
#include "model/io/project/ProjectLimits.h"
#include "model/io/project/ProjectText.h"

namespace espalier::projectVersion1 {

namespace {

/// Bit k: the living bud in slot k.
using OldBudMask = std::uint8_t;

struct OldCounts {
    std::uint32_t died = 0;
    std::uint32_t budChanges = 0;
    std::uint32_t frames = 0;
    std::uint32_t widths = 0;
    std::uint32_t lassos = 0;
};

struct OldInternodes {
    QList<InternodeId> parent;
    QList<Rotation> rotation;
    QList<float> length;
    QList<float> vigour;
    QList<std::uint8_t> slot;
    QList<OldBudMask> buds;
    QList<Step> birth;
    QList<Step> death;
    QList<std::uint8_t> present;
    QList<std::uint16_t> parameterSet;

    Result<void> read(const ZipReader& archive, std::uint32_t rows)
    {
        Result<void> result;
        const auto column = [&](const char* name, auto& values) {
            if (result)
                result = readEntry(archive, QByteArray("tree/") + name, rows, values);
        };
        column("parent", parent);
        column("rotation", rotation);
        column("length", length);
        column("vigour", vigour);
        column("slot", slot);
        column("buds", buds);
        column("birth", birth);
        column("death", death);
        column("present", present);
        column("parameterSet", parameterSet);
        return result;
    }
};

struct OldJournal {
    QList<Step> stepBefore;
    QList<Step> stepAfter;
    QList<std::uint32_t> parametersBefore;
    QList<std::uint32_t> parametersAfter;
    QList<InternodeId> bornFirst;
    QList<std::uint32_t> bornCount;
    QList<std::uint32_t> diedCount;
    QList<std::uint32_t> budCount;
    QList<std::uint32_t> frameCount;
    QList<std::uint32_t> widthCount;
    QList<std::uint32_t> lassoCount;
    QList<InternodeId> died;
    QList<InternodeId> budId;
    QList<OldBudMask> budBefore;
    QList<OldBudMask> budAfter;
    QList<InternodeId> frameId;
    QList<Rotation> rotationBefore;
    QList<Rotation> rotationAfter;
    QList<float> lengthBefore;
    QList<float> lengthAfter;
    QList<InternodeId> widthId;
    QList<float> widthBefore;
    QList<float> widthAfter;
    QList<std::uint32_t> lassoIndex;
    QList<std::uint8_t> lassoInForce;

    Result<void> read(const ZipReader& archive, std::uint32_t deltas, const OldCounts& counts)
    {
        Result<void> result;
        const auto column = [&](const char* name, auto& values, std::uint32_t rows) {
            if (result)
                result = readEntry(archive, QByteArray("journal/") + name, rows, values);
        };
        column("stepBefore", stepBefore, deltas);
        column("stepAfter", stepAfter, deltas);
        column("parametersBefore", parametersBefore, deltas);
        column("parametersAfter", parametersAfter, deltas);
        column("bornFirst", bornFirst, deltas);
        column("bornCount", bornCount, deltas);
        column("diedCount", diedCount, deltas);
        column("budCount", budCount, deltas);
        column("frameCount", frameCount, deltas);
        column("widthCount", widthCount, deltas);
        column("lassoCount", lassoCount, deltas);
        column("died", died, counts.died);
        column("budId", budId, counts.budChanges);
        column("budBefore", budBefore, counts.budChanges);
        column("budAfter", budAfter, counts.budChanges);
        column("frameId", frameId, counts.frames);
        column("rotationBefore", rotationBefore, counts.frames);
        column("rotationAfter", rotationAfter, counts.frames);
        column("lengthBefore", lengthBefore, counts.frames);
        column("lengthAfter", lengthAfter, counts.frames);
        column("widthId", widthId, counts.widths);
        column("widthBefore", widthBefore, counts.widths);
        column("widthAfter", widthAfter, counts.widths);
        column("lassoIndex", lassoIndex, counts.lassos);
        column("lassoInForce", lassoInForce, counts.lassos);
        return result;
    }

    bool addsUp(const OldCounts& counts) const
    {
        const auto isSumOf = [](std::uint32_t wanted, const QList<std::uint32_t>& column) {
            std::uint64_t sum = 0;
            for (const std::uint32_t count : column)
                sum += count;
            return sum == wanted;
        };
        return isSumOf(counts.died, diedCount) && isSumOf(counts.budChanges, budCount) &&
               isSumOf(counts.frames, frameCount) && isSumOf(counts.widths, widthCount) &&
               isSumOf(counts.lassos, lassoCount) &&
               std::ranges::none_of(lassoInForce, [](std::uint8_t flag) { return flag > 1; });
    }
};

/// The rows that are kept, and their new ids.
class Renumbering {
public:
    /// Rows that are present, or were born in the journal, are kept. Returns nothing if births are out of
    /// order.
    static std::optional<Renumbering> of(const OldInternodes& old, const OldJournal& journal)
    {
        Renumbering result;
        const auto size = static_cast<std::uint32_t>(old.parent.size());
        result.m_ids.assign(size, kNoInternode);
        std::vector<std::uint8_t> stays(size);
        for (InternodeId id = 0; id < size; ++id)
            stays[id] = old.present[id] == 1 ? 1 : 0;
        std::uint64_t end = 1; // the seedling has no birth
        for (qsizetype i = 0; i < journal.bornFirst.size(); ++i) {
            const std::uint64_t first = journal.bornFirst[i];
            const std::uint64_t count = journal.bornCount[i];
            if (count == 0)
                continue;
            if (first < end || first + count > size)
                return {};
            end = first + count;
            std::fill(stays.begin() + static_cast<std::ptrdiff_t>(first),
                      stays.begin() + static_cast<std::ptrdiff_t>(end), std::uint8_t{1});
        }
        for (InternodeId id = 0; id < size; ++id) {
            if (stays[id] != 0)
                result.m_ids[id] = result.m_count++;
        }
        return result;
    }

    /// The new id; kNoInternode for a row that is removed or does not exist.
    InternodeId operator()(InternodeId old) const { return old < m_ids.size() ? m_ids[old] : kNoInternode; }

private:
    std::vector<InternodeId> m_ids;
    std::uint32_t m_count = 0;
};

InternodeColumns renumbered(const OldInternodes& old, const Renumbering& idOf, std::uint64_t seed)
{
    InternodeColumns c;
    for (InternodeId id = 0; id < static_cast<std::uint32_t>(old.parent.size()); ++id) {
        if (idOf(id) == kNoInternode)
            continue;
        // A parent that does not exist, or was removed, gets an id that the check of the tree refuses.
        const InternodeId parent = idOf(old.parent[id]);
        c.append({.parent = parent == kNoInternode && old.parent[id] != kNoInternode ? c.size() : parent,
                  .rotation = old.rotation[id],
                  .length = old.length[id],
                  .vigour = old.vigour[id],
                  .slot = old.slot[id],
                  .buds = BudStates::active(old.buds[id]),
                  .birth = old.birth[id],
                  .death = old.death[id],
                  .parameterSet = old.parameterSet[id],
                  .key = mixedBits(seed) ^ id});
    }
    return c;
}

/// Deltas that change nothing are left out. @p ahead: the number of the last deltas that lie ahead of the
/// moment that was shown, among all; then, among those that are left.
Journal renumbered(const OldJournal& old, const Renumbering& idOf, std::uint32_t& ahead)
{
    const qsizetype shown = old.stepBefore.size() - qsizetype{ahead};
    Journal journal;
    qsizetype death = 0;
    qsizetype bud = 0;
    qsizetype frame = 0;
    qsizetype width = 0;
    qsizetype lasso = 0;
    const auto diameter = [](float value) {
        return value > 0.0F ? std::optional<float>(value) : std::nullopt;
    };
    for (qsizetype i = 0; i < old.stepBefore.size(); ++i) {
        TreeDelta delta;
        delta.stepBefore = old.stepBefore[i];
        delta.stepAfter = old.stepAfter[i];
        delta.parametersBefore = old.parametersBefore[i];
        delta.parametersAfter = old.parametersAfter[i];
        delta.born.count = old.bornCount[i];
        for (const qsizetype end = death + old.diedCount[i]; death < end; ++death)
            delta.died.push_back(idOf(old.died[death]));
        for (const qsizetype end = bud + old.budCount[i]; bud < end; ++bud)
            delta.internodes.buds.push_back({idOf(old.budId[bud]), BudStates::active(old.budBefore[bud]),
                                             BudStates::active(old.budAfter[bud])});
        for (const qsizetype end = frame + old.frameCount[i]; frame < end; ++frame)
            delta.addFrame(idOf(old.frameId[frame]), old.rotationBefore[frame], old.rotationAfter[frame],
                           old.lengthBefore[frame], old.lengthAfter[frame]);
        for (const qsizetype end = width + old.widthCount[i]; width < end; ++width)
            delta.sparse.width.push_back({idOf(old.widthId[width]), diameter(old.widthBefore[width]),
                                          diameter(old.widthAfter[width])});
        for (const qsizetype end = lasso + old.lassoCount[i]; lasso < end; ++lasso)
            delta.lassos.push_back({old.lassoIndex[lasso], old.lassoInForce[lasso] != 0});
        if (!delta.isEmpty())
            journal.push_back(std::make_shared<TreeDelta>(std::move(delta)));
        else if (i >= shown)
            --ahead;
    }
    return journal;
}

/// All births of the journal are the last rows of the tree; each delta's first id follows from that. False if
/// there are more births than rows.
bool numberOldBirths(Journal& journal, std::uint32_t size)
{
    for (auto delta = journal.rbegin(); delta != journal.rend(); ++delta) {
        IdRange& born = (*delta)->born;
        if (born.count > size)
            return false;
        born.first = size -= born.count;
    }
    return true;
}

/// Pairs of an internode and a diameter in m.
SparseColumn<float> readWidths(JsonReader& reader, const QJsonArray& array, const Renumbering& idOf)
{
    std::vector<WidthConstraint> widths;
    for (const QJsonValue& value : array) {
        const QJsonArray pair = value.toArray();
        const double id = pair.at(0).toDouble(-1.0);
        const double diameter = pair.at(1).toDouble();
        if (pair.size() != 2 || !(id >= 0.0 && id < projectLimits::kInternodes) || !(diameter < 1e6)) {
            reader.fail(QLatin1StringView("widths"),
                        ProjectText::tr("pairs of an internode and a diameter are expected"));
            break;
        }
        widths.push_back({idOf(static_cast<InternodeId>(id)), static_cast<float>(diameter)});
    }
    return SparseColumn<float>::fromCells(std::move(widths));
}

OldCounts readCounts(JsonReader& parent, ProjectDescription& description)
{
    const QLatin1StringView key("journal");
    JsonReader reader(parent.object(key), parent.placeOf(key));
    OldCounts counts;
    description.deltas = readCount(reader, "deltas", 0, projectLimits::kDeltas);
    counts.died = readCount(reader, "died", 0, description.internodes);
    counts.budChanges = readCount(reader, "budChanges", 0, projectLimits::kChanges);
    counts.frames = readCount(reader, "frames", 0, projectLimits::kChanges);
    counts.widths = readCount(reader, "widths", 0, projectLimits::kChanges);
    counts.lassos = readCount(reader, "lassos", 0, projectLimits::kChanges);
    if (const Result<void> end = reader.finish(); !end)
        parent.fail(end.error());
    return counts;
}

Result<void> readLassos(const ZipReader& archive, TreeContent& content)
{
    if (const Result<void> read = readLassoColumns(archive, "lasso/", content.kept.lassos); !read)
        return read;
    QList<std::uint8_t> inForce;
    if (const Result<void> read = readEntry(archive, "lasso/inForce",
                                            static_cast<std::uint32_t>(content.kept.lassos.size()), inForce);
        !read)
        return read;
    for (qsizetype i = 0; i < inForce.size(); ++i) {
        if (inForce[i] > 1)
            return inputError(ProjectText::tr("the lassos"), ProjectText::tr("their parts do not add up"));
        if (inForce[i] == 1)
            content.lassosInForce.push_back(static_cast<std::uint32_t>(i));
    }
    return {};
}

} // namespace

Result<Project> read(const ZipReader& archive, JsonReader& reader)
{
    ProjectDescription description;
    readCommon(reader, description);
    const OldCounts counts = readCounts(reader, description);
    description.ahead = readCount(reader, "ahead", 0, description.deltas);
    const QJsonArray widths = reader.array(QLatin1StringView("widths"));
    readCount(reader, "lassos", 0, projectLimits::kLassos);
    readCount(reader, "lassoPoints", 0, projectLimits::kLassoPoints);
    const QJsonArray sets = reader.array(QLatin1StringView("parameterSets"));
    const auto descriptionError = [](const Result<void>& result) {
        return inputError(QStringLiteral("project.json"), result.error().message);
    };
    if (const Result<void> end = reader.finish(); !end)
        return descriptionError(end);

    OldInternodes oldInternodes;
    OldJournal oldJournal;
    Result<void> result = oldInternodes.read(archive, description.internodes);
    if (result)
        result = oldJournal.read(archive, description.deltas, counts);
    if (!result)
        return result.error();
    const std::optional<Renumbering> idOf = Renumbering::of(oldInternodes, oldJournal);
    if (!oldJournal.addsUp(counts) || !idOf)
        return inputError(ProjectText::tr("the history"), ProjectText::tr("its parts do not add up"));

    ProjectImages images(archive, description.imageNames);
    TreeContent content;
    content.seed = description.seed;
    content.step = description.step;
    content.currentParameters = description.currentParameters;
    content.internodes = renumbered(oldInternodes, *idOf, description.seed);
    content.sparse.width = readWidths(reader, widths, *idOf);
    if (const Result<void> end = reader.finish(); !end)
        return descriptionError(end);
    Result<QList<TreeParameters>> parameters = readParameterSets(sets, images);
    if (!parameters)
        return inputError(QStringLiteral("project.json"), parameters.error().message);
    content.kept.parameters = std::move(*parameters);
    if (result = readLassos(archive, content); !result)
        return result.error();
    Journal journal = renumbered(oldJournal, *idOf, description.ahead);
    if (!numberOldBirths(journal, content.internodes.size()))
        return inputError(ProjectText::tr("the history"), ProjectText::tr("its parts do not add up"));
    Result<Tree> tree = Tree::fromContent(std::move(content));
    if (!tree)
        return tree.error();
    return Project{.tree = std::move(*tree),
                   .journal = std::move(journal),
                   .name = description.name,
                   .thumbnail = {},
                   .ahead = description.ahead,
                   .look = {},
                   .foreign = {},
                   .warning = images.lost()};
}

} // namespace espalier::projectVersion1
