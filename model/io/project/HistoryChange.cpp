// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/project/HistoryChange.h"

#include "model/io/JsonReader.h"
#include "model/io/ZipArchive.h"
#include "model/io/project/JournalEntries.h"
#include "model/io/project/KeptEntries.h"
#include "model/io/project/LookEntry.h"
#include "model/io/project/ProjectFile.h"
#include "model/io/project/ProjectImages.h"
#include "model/io/project/ProjectLimits.h"
#include "model/io/project/ProjectText.h"
#include "model/io/project/TreeEntries.h"

#include <QJsonDocument>

#include <algorithm>
#include <cstring>

namespace espalier {

namespace {

constexpr char kChangeEntry[] = "change.json";
constexpr char kKnownEntry[] = "known";
constexpr qsizetype kMostDescription = 1 << 20;

Error doesNotFit()
{
    return inputError(ProjectText::tr("a change of the history"),
                      ProjectText::tr("it does not follow on from what is before it"));
}

/// The rows and values of all fresh deltas, one after the other.
TreeRows joined(const std::vector<std::shared_ptr<const TreeRows>>& pieces)
{
    TreeRows all;
    const auto append = [](const auto&, auto& column, const auto& more) { column.append(more); };
    for (const auto& piece : pieces) {
        if (!piece)
            continue;
        InternodeTable::visit(append, all.internodes, piece->internodes);
        LeafTable::visit(append, all.leaves, piece->leaves);
        KeptTable::visit(append, all.kept, piece->kept);
    }
    return all;
}

/// Takes the rows of one delta after the other out of all of them.
class RowSplitter {
public:
    explicit RowSplitter(TreeRows all) : m_all(std::move(all)) {}

    /// The rows of @p delta, null if it brings none; an error if there are not so many.
    Result<std::shared_ptr<TreeRows>> next(const TreeDelta& delta)
    {
        if (!delta.bringsRows())
            return std::shared_ptr<TreeRows>();
        auto rows = std::make_shared<TreeRows>();
        bool isThere = true;
        const auto take = [&isThere](const auto& column, auto& piece, std::uint32_t first,
                                     std::uint32_t count) {
            isThere = isThere && column.size() >= qsizetype{first} + qsizetype{count};
            piece = column.mid(first, count);
        };
        InternodeTable::visit([&](const auto&, const auto& column,
                                  auto& piece) { take(column, piece, m_internode, delta.born.count); },
                              m_all.internodes, rows->internodes);
        LeafTable::visit([&](const auto&, const auto& column,
                             auto& piece) { take(column, piece, m_leaf, delta.bornLeaves.count); },
                         m_all.leaves, rows->leaves);
        KeptTable::visit(
            [&](const auto&, const auto& values, auto& piece, std::uint32_t& first, std::uint32_t count) {
                take(values, piece, first, count);
                first += count;
            },
            m_all.kept, rows->kept, m_value, delta.kept);
        m_internode += delta.born.count;
        m_leaf += delta.bornLeaves.count;
        if (!isThere)
            return doesNotFit();
        return rows;
    }

private:
    TreeRows m_all;
    std::uint32_t m_internode = 0;
    std::uint32_t m_leaf = 0;
    KeptCounts m_value;
};

/// Whether all rows and indices that @p delta names exist after it was applied to @p tree, with its rows.
bool fits(const TreeDelta& delta, const Tree& tree)
{
    const auto hasRows = [](std::uint32_t rows, bool& isGood) {
        return [rows, &isGood](const auto&, const auto& changes) {
            isGood = isGood &&
                     std::ranges::all_of(changes, [rows](const auto& change) { return change.row < rows; });
        };
    };
    bool isGood = delta.stepBefore == tree.step() && delta.born.first == tree.size() &&
                  delta.bornLeaves.first == tree.placedLeaves().size() &&
                  delta.bringsRows() == (delta.rows != nullptr);
    InternodeTable::visit(hasRows(delta.born.end(), isGood), delta.internodes);
    LeafTable::visit(hasRows(delta.bornLeaves.end(), isGood), delta.leaves);
    SparseTable::visit(hasRows(delta.born.end(), isGood), delta.sparse);
    isGood =
        isGood && std::ranges::all_of(delta.died, [&delta](InternodeId id) { return id < delta.born.end(); });
    const auto sets = static_cast<std::uint32_t>(tree.parameterSets().size()) + delta.kept.parameters;
    return isGood && delta.parametersAfter < sets && delta.parametersBefore == tree.currentParameterSet();
}

} // namespace

QSet<QString> imageHashes(const Project& project)
{
    QSet<QString> hashes;
    for (const ImageAsset& image : ProjectImages::of(project.tree.parameterSets()))
        hashes.insert(image.hash());
    if (project.look && !project.look->tracing.image.isNull())
        hashes.insert(project.look->tracing.image.hash());
    return hashes;
}

Result<QByteArray> packChange(const HistoryChange& change, QSet<QString>& written)
{
    const TreeRows rows = joined(change.rows);
    std::vector<ImageAsset> images = ProjectImages::of(rows.kept.parameters);
    const QJsonObject names = ProjectImages::names(images);
    if (!change.look.tracing.image.isNull())
        images.push_back(change.look.tracing.image);
    std::erase_if(images, [&written](const ImageAsset& image) { return written.contains(image.hash()); });
    for (const ImageAsset& image : images)
        written.insert(image.hash());

    ZipWriter archive;
    archive.add(
        kChangeEntry,
        QJsonDocument(QJsonObject{{QStringLiteral("kept"), qint64{change.kept}},
                                  {QStringLiteral("known"), static_cast<qint64>(change.known.size())},
                                  {QStringLiteral("deltas"), static_cast<qint64>(change.fresh.size())},
                                  {QStringLiteral("ahead"), qint64{change.ahead}},
                                  {QStringLiteral("internodes"), qint64{rows.internodes.size()}},
                                  {QStringLiteral("leaves"), qint64{rows.leaves.size()}},
                                  {QStringLiteral("images"), names}})
            .toJson(QJsonDocument::Compact));
    archive.add(kKnownEntry, QByteArray(reinterpret_cast<const char*>(change.known.data()),
                                        static_cast<qsizetype>(change.known.size() * sizeof(std::uint32_t))));
    addRows(archive, rows.internodes, rows.leaves);
    KeptTable::visit(
        [&](const auto& info, const auto& values) {
            if (!values.isEmpty())
                addKept(archive, info.name, values);
        },
        rows.kept);
    addJournal(archive, change.fresh);
    addLook(archive, change.look);
    ProjectImages::add(archive, images);
    return archive.finish();
}

HistoryReplay::HistoryReplay(Project project) : m_project(std::move(project)), m_numbered(m_project.journal)
{
    m_images = ProjectImages::of(m_project.tree.parameterSets());
    if (m_project.look && !m_project.look->tracing.image.isNull())
        m_images.push_back(m_project.look->tracing.image);
}

Result<void> HistoryReplay::append(const std::shared_ptr<TreeDelta>& delta)
{
    if (!fits(*delta, m_project.tree))
        return doesNotFit();
    m_project.tree.apply(*delta);
    delta->rows.reset();
    m_project.journal.push_back(delta);
    return {};
}

Result<void> HistoryReplay::add(const QByteArray& packed)
{
    const Result<ZipReader> archive = ZipReader::open(packed);
    if (!archive)
        return archive.error();
    const Result<QByteArray> text = archive->read(kChangeEntry, kMostDescription);
    if (!text)
        return text.error();
    const Result<QJsonObject> json = parseJsonObject(*text, kMostDescription);
    if (!json)
        return json.error();
    JsonReader reader(*json, {});
    const auto count = [&reader](const char* key, std::uint32_t most) {
        return static_cast<std::uint32_t>(reader.integer(QLatin1StringView(key), 0, most));
    };
    const std::uint32_t kept = count("kept", projectLimits::kDeltas);
    const std::uint32_t known = count("known", projectLimits::kDeltas);
    const std::uint32_t deltas = count("deltas", projectLimits::kDeltas);
    const std::uint32_t ahead = count("ahead", projectLimits::kDeltas);
    const std::uint32_t internodes = count("internodes", projectLimits::kInternodes);
    const std::uint32_t leaves = count("leaves", projectLimits::kLeaves);
    const QJsonObject names = reader.object(QLatin1StringView("images"));
    if (const Result<void> end = reader.finish(); !end)
        return end;
    Journal& journal = m_project.journal;
    if (kept > journal.size() || ahead > kept + known + deltas)
        return doesNotFit();
    const Result<QByteArray> numbers =
        archive->read(kKnownEntry, std::uint64_t{known} * sizeof(std::uint32_t));
    if (!numbers || numbers->size() != static_cast<qsizetype>(known * sizeof(std::uint32_t)))
        return doesNotFit();

    while (journal.size() > kept) {
        m_project.tree.revert(*journal.back());
        journal.pop_back();
    }
    for (std::uint32_t i = 0; i < known; ++i) {
        std::uint32_t number = 0;
        std::memcpy(&number, numbers->constData() + i * sizeof number, sizeof number);
        if (number >= m_numbered.size())
            return doesNotFit();
        if (const Result<void> done = append(m_numbered[number]); !done)
            return done;
    }

    TreeRows rows;
    Result<void> read = readRows(*archive, internodes, leaves, rows);
    ProjectImages images(*archive, names);
    images.know(m_images);
    KeptTable::visit(
        [&](const auto& info, auto& values) {
            const QByteArray entry = QByteArray("kept/") + info.name;
            const bool isThere = archive->contains((entry + ".json").constData()) ||
                                 archive->contains((entry + ".pointCount").constData());
            if (read && isThere)
                read = readKept(*archive, info.name, images, values);
        },
        rows.kept);
    if (!read)
        return read;
    const JournalBounds bounds{
        m_project.tree.size() + internodes, m_project.tree.placedLeaves().size() + leaves,
        static_cast<std::uint32_t>(m_project.tree.lassos().size() + rows.kept.lassos.size())};
    const Result<Journal> fresh = readJournal(*archive, deltas, bounds);
    if (!fresh)
        return fresh.error();
    const std::vector<ImageAsset> newImages = ProjectImages::of(rows.kept.parameters);
    m_images.insert(m_images.end(), newImages.begin(), newImages.end());
    RowSplitter splitter(std::move(rows));
    for (const auto& delta : *fresh) {
        Result<std::shared_ptr<TreeRows>> own = splitter.next(*delta);
        if (!own)
            return own.error();
        delta->rows = std::move(*own);
        if (const Result<void> done = append(delta); !done)
            return done;
        m_numbered.push_back(delta);
    }
    m_project.ahead = ahead;

    Result<std::optional<ReadLook>> look = readLook(*archive, m_images);
    if (look && *look) {
        m_project.look = (*look)->look;
        if (!m_project.look->tracing.image.isNull())
            m_images.push_back(m_project.look->tracing.image);
    }
    return {};
}

Result<Project> HistoryReplay::finish()
{
    if (const Result<void> sound = checkProject(m_project); !sound)
        return sound.error();
    return std::move(m_project);
}

} // namespace espalier
