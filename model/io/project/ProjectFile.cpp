// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/project/ProjectFile.h"

#include "model/io/ImageFile.h"
#include "model/io/JsonReader.h"
#include "model/io/ParametersJson.h"
#include "model/io/ZipArchive.h"
#include "model/io/project/JournalCheck.h"
#include "model/io/project/JournalColumns.h"
#include "model/io/project/LassoColumns.h"
#include "model/tree/TreeIndex.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>
#include <QImageReader>
#include <QJsonDocument>
#include <QSaveFile>

#include <bit>

namespace espalier {

namespace {

static_assert(std::endian::native == std::endian::little, "the columns of a project file are little-endian");
static_assert(sizeof(Rotation) == 4 * sizeof(float));
static_assert(sizeof(Vec3) == 3 * sizeof(float) && sizeof(Vec2) == 2 * sizeof(float));

struct Text {
    Q_DECLARE_TR_FUNCTIONS(ProjectFile)
};

constexpr QLatin1StringView kFormat("espalier-project");
constexpr char kDescriptionEntry[] = "project.json";
constexpr char kThumbnailEntry[] = "thumbnail.png";
constexpr qsizetype kMaximumDescription = 64 << 20;
constexpr qint64 kMaximumFile = qint64{2} << 30;
constexpr std::uint64_t kMaximumThumbnail = 16 << 20;
constexpr int kMaximumThumbnailEdge = 4096;

/// What project.json says.
struct Description {
    QString name;
    std::uint64_t seed = 1;
    Step step = 0;
    std::uint32_t internodes = 1;
    JournalCounts journal;
    std::uint32_t ahead = 0;
    std::vector<WidthConstraint> widths;
    std::uint32_t lassos = 0;
    std::uint32_t lassoPoints = 0;
    QList<TreeParameters> parameterSets;
    std::uint32_t currentParameters = 0;
    QString lostImage; ///< Name of one that could not be read, if any
};

/// The images that parameter sets refer to, each once.
std::vector<ImageAsset> imagesOf(const Tree& tree)
{
    std::vector<ImageAsset> images;
    QSet<QString> known;
    for (const TreeParameters& set : tree.parameterSets()) {
        visitImages(set, [&](const char*, const ImageAsset& image) {
            if (!image.isNull() && !known.contains(image.hash())) {
                known.insert(image.hash());
                images.push_back(image);
            }
        });
    }
    return images;
}

bool areWithinLimits(const std::vector<ImageAsset>& images)
{
    qsizetype bytes = 0;
    for (const ImageAsset& image : images)
        bytes += image.file().size();
    return images.size() <= projectLimits::kImages && bytes <= projectLimits::kImageBytes;
}

QByteArray assetEntry(const QString& hash, const QString& suffix)
{
    return QByteArray("assets/") + hash.toLatin1() + '.' + suffix.toLatin1();
}

/// The image of that hash, if the archive has it whole.
std::optional<ImageAsset> readAsset(const ZipReader& archive, const QString& hash, const QString& name)
{
    for (const char* suffix : {"png", "jpg"}) {
        const QByteArray entry = assetEntry(hash, QLatin1String(suffix));
        if (!archive.contains(entry.constData()))
            continue;
        const Result<QByteArray> file = archive.read(entry.constData(), imageLimits::kBytes);
        const Result<ImageAsset> image = file ? glanceAtImage(*file, name) : file.error();
        if (image && image->hash() == hash)
            return *image;
    }
    return {};
}

template <class T>
QByteArray bytesOf(const QList<T>& column)
{
    // Shares the column's memory: the archive is packed before the project can change.
    return QByteArray::fromRawData(reinterpret_cast<const char*>(column.constData()),
                                   column.size() * static_cast<qsizetype>(sizeof(T)));
}

template <class T>
Result<void> readColumn(const ZipReader& archive, const QByteArray& name, std::uint32_t rows,
                        QList<T>& column)
{
    if (const Result<void> size = archive.expectSize(name.constData(), std::uint64_t{rows} * sizeof(T));
        !size)
        return size;
    column.resize(rows);
    return archive.readExactly(name.constData(), std::as_writable_bytes(std::span(column.data(), rows)));
}

std::uint32_t lassoPointsOf(const Tree& tree)
{
    std::size_t sum = 0;
    for (const LassoStroke& stroke : tree.lassos().strokes)
        sum += stroke.points.size();
    return static_cast<std::uint32_t>(sum);
}

QByteArray describe(const Project& project, const JournalCounts& counts)
{
    const Tree& tree = project.tree;
    QJsonArray sets;
    TreeParameters before;
    for (const TreeParameters& set : tree.parameterSets()) {
        sets.append(sets.isEmpty() ? toJson(set) : toJson(set, before));
        before = set;
    }
    const QJsonObject journal{{QStringLiteral("deltas"), qint64{counts.deltas}},
                              {QStringLiteral("died"), qint64{counts.died}},
                              {QStringLiteral("budChanges"), qint64{counts.budChanges}},
                              {QStringLiteral("frames"), qint64{counts.frames}},
                              {QStringLiteral("widths"), qint64{counts.widths}},
                              {QStringLiteral("lassos"), qint64{counts.lassos}}};
    QJsonArray widths;
    for (const auto [id, diameter] : tree.widthConstraints())
        widths.append(QJsonArray{qint64{id}, static_cast<double>(diameter)});
    const QJsonObject json{{QStringLiteral("format"), QString(kFormat)},
                           {QStringLiteral("version"), projectLimits::kVersion},
                           {QStringLiteral("program"), QStringLiteral(ESPALIER_VERSION)},
                           {QStringLiteral("name"), project.name},
                           {QStringLiteral("seed"), seedToJson(tree.seed())},
                           {QStringLiteral("step"), qint64{tree.step()}},
                           {QStringLiteral("internodes"), qint64{tree.size()}},
                           {QStringLiteral("journal"), journal},
                           {QStringLiteral("ahead"), qint64{project.ahead}},
                           {QStringLiteral("widths"), widths},
                           {QStringLiteral("lassos"), tree.lassos().strokes.size()},
                           {QStringLiteral("lassoPoints"), qint64{lassoPointsOf(tree)}},
                           {QStringLiteral("currentParameters"), qint64{tree.currentParameterSet()}},
                           {QStringLiteral("parameterSets"), sets}};
    QJsonObject whole = json;
    QJsonObject images;
    for (const ImageAsset& image : imagesOf(tree))
        images[image.hash()] = image.name();
    // Without any, programs that know nothing of images can read the file.
    if (!images.isEmpty())
        whole[QStringLiteral("images")] = images;
    return QJsonDocument(whole).toJson();
}

std::uint32_t readCount(JsonReader& reader, const char* key, std::uint32_t minimum, std::uint32_t maximum)
{
    return static_cast<std::uint32_t>(reader.integer(QLatin1StringView(key), minimum, maximum));
}

JournalCounts readJournalCounts(JsonReader& parent, std::uint32_t internodes)
{
    const QLatin1StringView key("journal");
    JsonReader reader(parent.object(key), parent.placeOf(key));
    JournalCounts counts;
    counts.deltas = readCount(reader, "deltas", 0, projectLimits::kDeltas);
    counts.died = readCount(reader, "died", 0, internodes);
    counts.budChanges = readCount(reader, "budChanges", 0, projectLimits::kBudChanges);
    counts.frames = readCount(reader, "frames", 0, projectLimits::kFrames);
    counts.widths = readCount(reader, "widths", 0, projectLimits::kWidths);
    counts.lassos = readCount(reader, "lassos", 0, projectLimits::kLassoChanges);
    if (const Result<void> end = reader.finish(); !end)
        parent.fail(end.error());
    return counts;
}

/// Pairs of an internode and a diameter in m; Tree::fromColumns looks at the values.
std::vector<WidthConstraint> readWidths(JsonReader& reader)
{
    const QLatin1StringView key("widths");
    const QJsonArray array = reader.array(key);
    std::vector<WidthConstraint> widths;
    for (const QJsonValue& value : array) {
        const QJsonArray pair = value.toArray();
        const double id = pair.at(0).toDouble(-1.0);
        const double diameter = pair.at(1).toDouble();
        if (pair.size() != 2 || !(id >= 0.0 && id < projectLimits::kInternodes) || !(diameter < 1e6)) {
            reader.fail(key, Text::tr("pairs of an internode and a diameter are expected"));
            break;
        }
        widths.push_back({static_cast<InternodeId>(id), static_cast<float>(diameter)});
    }
    return widths;
}

/// Parameter sets, of images those that @p imageOfName finds.
Result<QList<TreeParameters>> readParameterSets(const QJsonArray& array, const ImageOfName& imageOfName)
{
    QList<TreeParameters> sets;
    TreeParameters before;
    for (qsizetype i = 0; i < array.size(); ++i) {
        const QString place = QStringLiteral("parameterSets[%1]").arg(i);
        if (!array.at(i).isObject())
            return inputError(place, Text::tr("an object is expected"));
        const Result<TreeParameters> set = fromJson(array.at(i).toObject(), before, place, imageOfName);
        if (!set)
            return set.error();
        before = *set;
        sets.append(before);
    }
    return sets;
}

Result<Description> readDescription(const ZipReader& archive, const QByteArray& text)
{
    const Result<QJsonObject> json = parseJsonObject(text, kMaximumDescription);
    if (!json)
        return json.error();
    JsonReader reader(*json, {});
    if (reader.text(QLatin1StringView("format"), QString()) != kFormat)
        return inputError({}, Text::tr("it does not describe an Espalier project"));
    const auto version =
        reader.integer(QLatin1StringView("version"), 1, std::numeric_limits<std::int32_t>::max());
    const QString program = reader.text(QLatin1StringView("program"));
    if (version > projectLimits::kVersion) {
        return inputError(
            {}, Text::tr("Espalier %1 wrote it in version %2 of the format; this is Espalier %3, which reads "
                         "versions up to %4")
                    .arg(program)
                    .arg(version)
                    .arg(QStringLiteral(ESPALIER_VERSION))
                    .arg(projectLimits::kVersion));
    }
    Description description;
    description.name = reader.text(QLatin1StringView("name"));
    description.seed = reader.seed(QLatin1StringView("seed"));
    description.step = static_cast<Step>(reader.integer(QLatin1StringView("step"), 0, kNever - 1));
    description.internodes = readCount(reader, "internodes", 1, projectLimits::kInternodes);
    description.journal = readJournalCounts(reader, description.internodes);
    description.ahead = readCount(reader, "ahead", 0, description.journal.deltas);
    description.widths = readWidths(reader);
    description.lassos = readCount(reader, "lassos", 0, projectLimits::kLassos);
    description.lassoPoints = readCount(reader, "lassoPoints", 0, projectLimits::kLassoPoints);
    const QJsonArray sets = reader.array(QLatin1StringView("parameterSets"));
    if (sets.isEmpty() || sets.size() > projectLimits::kParameterSets)
        reader.fail(QLatin1StringView("parameterSets"),
                    Text::tr("1 to %1 sets are expected").arg(projectLimits::kParameterSets));
    description.currentParameters = static_cast<std::uint32_t>(
        reader.integer(QLatin1StringView("currentParameters"), 0, std::max<qsizetype>(sets.size(), 1) - 1));
    const QJsonObject imageNames = reader.object(QLatin1StringView("images"));
    if (imageNames.size() > qsizetype{projectLimits::kImages})
        reader.fail(QLatin1StringView("images"),
                    Text::tr("at most %1 images are expected").arg(projectLimits::kImages));
    if (const Result<void> end = reader.finish(); !end)
        return end.error();
    QHash<QString, ImageAsset> images;
    qsizetype imageBytes = 0;
    const ImageOfName imageOfName = [&](const QString& hash) -> Result<ImageAsset> {
        if (const auto known = images.find(hash); known != images.end())
            return *known;
        const QString name = imageNames.value(hash).toString();
        std::optional<ImageAsset> image;
        if (imageBytes < projectLimits::kImageBytes)
            image = readAsset(archive, hash, name);
        if (image)
            imageBytes += image->file().size();
        else
            description.lostImage = name.isEmpty() ? hash.first(std::min<qsizetype>(hash.size(), 8)) : name;
        return *images.insert(hash, image.value_or(ImageAsset()));
    };
    Result<QList<TreeParameters>> parameterSets = readParameterSets(sets, imageOfName);
    if (!parameterSets)
        return parameterSets.error();
    description.parameterSets = std::move(*parameterSets);
    visitImages(description.parameterSets[description.currentParameters],
                [&](const char*, const ImageAsset& image) {
                    if (!image.isNull() && image.pixels().isNull())
                        description.lostImage = image.name();
                });
    return description;
}

/// Whether every node lies where coordinates still mean something.
Result<void> checkPositions(const Tree& tree)
{
    const InternodeColumns& c = tree.columns();
    std::vector<Placement> placements(tree.size());
    for (InternodeId id = 0; id < tree.size(); ++id) {
        const Placement base =
            id == 0 ? Placement{Vec3::Zero(), Rotation::Identity()} : placements[c.parent[id]];
        placements[id] = placeOn(base.node, base.rotation, c.rotation[id], c.length[id]);
        if (!(placements[id].node.cwiseAbs().maxCoeff() <= projectLimits::kWorld))
            return inputError(Text::tr("internode %1").arg(id),
                              Text::tr("it lies further than %1 m away").arg(projectLimits::kWorld));
    }
    return {};
}

Result<Lassos> readLassos(const ZipReader& archive, const Description& description)
{
    LassoColumns columns;
    Result<void> read;
    LassoColumns::visit(columns, description.lassos, description.lassoPoints,
                        [&](const char* name, auto& column, std::uint32_t rows) {
                            if (read)
                                read = readColumn(archive, QByteArray("lasso/") + name, rows, column);
                        });
    if (!read)
        return read.error();
    std::optional<Lassos> lassos = columns.toLassos();
    if (!lassos)
        return inputError(Text::tr("the lassos"), Text::tr("their parts do not add up"));
    return std::move(*lassos);
}

Result<Tree> readTree(const ZipReader& archive, Description description)
{
    InternodeColumns columns;
    Result<void> read;
    InternodeColumns::visit(columns, [&](const char* name, auto& column) {
        if (read)
            read = readColumn(archive, QByteArray("tree/") + name, description.internodes, column);
    });
    if (!read)
        return read.error();
    Result<Lassos> lassos = readLassos(archive, description);
    if (!lassos)
        return lassos.error();
    Result<Tree> tree = Tree::fromColumns(description.seed, description.step, std::move(columns),
                                          std::move(description.parameterSets), description.currentParameters,
                                          std::move(description.widths), std::move(*lassos));
    if (tree) {
        if (const Result<void> positions = checkPositions(*tree); !positions)
            return positions.error();
    }
    return tree;
}

Result<Journal> readJournal(const ZipReader& archive, const JournalCounts& counts, const Tree& tree)
{
    JournalColumns columns;
    Result<void> read;
    JournalColumns::visit(columns, counts, [&](const char* name, auto& column, std::uint32_t rows) {
        if (read)
            read = readColumn(archive, QByteArray("journal/") + name, rows, column);
    });
    if (!read)
        return read.error();
    std::optional<Journal> journal = columns.toJournal(counts);
    if (!journal)
        return inputError(Text::tr("the history"), Text::tr("its parts do not add up"));
    if (const Result<void> check = checkJournal(tree, *journal); !check)
        return check.error();
    return std::move(*journal);
}

QImage readThumbnail(const ZipReader& archive)
{
    if (!archive.contains(kThumbnailEntry))
        return {};
    Result<QByteArray> png = archive.read(kThumbnailEntry, kMaximumThumbnail);
    if (!png)
        return {};
    QBuffer buffer(&*png);
    QImageReader reader(&buffer, "png");
    const QSize size = reader.size();
    if (size.isEmpty() || size.width() > kMaximumThumbnailEdge || size.height() > kMaximumThumbnailEdge)
        return {};
    return reader.read();
}

QByteArray toPng(const QImage& image)
{
    QByteArray png;
    QBuffer buffer(&png);
    image.save(&buffer, "png");
    return png;
}

} // namespace

Tree shownTree(const Project& project)
{
    Tree tree = project.tree;
    for (std::size_t i = 0; i < project.ahead; ++i)
        tree.revert(*project.journal[project.journal.size() - 1 - i]);
    return tree;
}

Result<QByteArray> packProject(const Project& project)
{
    const JournalCounts counts = JournalCounts::of(project.journal);
    if (project.tree.size() > projectLimits::kInternodes || counts.deltas > projectLimits::kDeltas ||
        counts.budChanges > projectLimits::kBudChanges || counts.frames > projectLimits::kFrames ||
        counts.widths > projectLimits::kWidths || counts.lassos > projectLimits::kLassoChanges ||
        project.tree.lassos().strokes.size() > qsizetype{projectLimits::kLassos} ||
        lassoPointsOf(project.tree) > projectLimits::kLassoPoints || !areWithinLimits(imagesOf(project.tree)))
        return Error{Error::Kind::Output,
                     Text::tr("the tree or its history is too large for a project file")};
    ZipWriter archive;
    archive.add(kDescriptionEntry, describe(project, counts));
    InternodeColumns::visit(project.tree.columns(), [&](const char* name, const auto& column) {
        archive.add(QByteArray("tree/") + name, bytesOf(column));
    });
    const JournalColumns journal = JournalColumns::of(project.journal);
    JournalColumns::visit(journal, counts, [&](const char* name, const auto& column, std::uint32_t) {
        archive.add(QByteArray("journal/") + name, bytesOf(column));
    });
    const LassoColumns lassos = LassoColumns::of(project.tree.lassos());
    LassoColumns::visit(lassos, 0, 0, [&](const char* name, const auto& column, std::uint32_t) {
        archive.add(QByteArray("lasso/") + name, bytesOf(column));
    });
    for (const ImageAsset& image : imagesOf(project.tree))
        archive.add(assetEntry(image.hash(), image.suffix()), image.file(), ZipWriter::Packing::Store);
    if (!project.thumbnail.isNull())
        archive.add(kThumbnailEntry, toPng(project.thumbnail), ZipWriter::Packing::Store);
    return archive.finish();
}

Result<Project> unpackProject(const QByteArray& content)
{
    const Result<ZipReader> archive = ZipReader::open(content);
    if (!archive)
        return archive.error();
    const Result<QByteArray> text = archive->read(kDescriptionEntry, kMaximumDescription);
    if (!text)
        return text.error();
    Result<Description> description = readDescription(*archive, *text);
    if (!description)
        return inputError(QString::fromLatin1(kDescriptionEntry), description.error().message);
    const JournalCounts counts = description->journal;
    const QString name = description->name;
    const std::uint32_t ahead = description->ahead;
    QString warning;
    if (!description->lostImage.isEmpty()) {
        warning =
            Text::tr(
                "the image “%1” is missing in it or broken; the look that was drawn for it shows instead")
                .arg(description->lostImage);
    }
    Result<Tree> tree = readTree(*archive, std::move(*description));
    if (!tree)
        return tree.error();
    Result<Journal> journal = readJournal(*archive, counts, *tree);
    if (!journal)
        return journal.error();
    return Project{std::move(*tree), std::move(*journal), name, readThumbnail(*archive), ahead, warning};
}

Result<void> saveProject(const Project& project, const QString& fileName)
{
    const QString name = QFileInfo(fileName).fileName();
    const Result<QByteArray> content = packProject(project);
    if (!content)
        return Error{Error::Kind::Output, inputError(name, content.error().message).message};
    QSaveFile file(fileName);
    if (!file.open(QIODevice::WriteOnly) || file.write(*content) != content->size() || !file.commit())
        return Error{Error::Kind::Output, inputError(name, file.errorString()).message};
    return {};
}

Result<Project> loadProject(const QString& fileName)
{
    const QString name = QFileInfo(fileName).fileName();
    QFile file(fileName);
    if (!file.open(QIODevice::ReadOnly))
        return inputError(name, file.errorString());
    if (file.size() > kMaximumFile)
        return inputError(name, Text::tr("it is larger than %1 GB").arg(kMaximumFile >> 30));
    Result<Project> project = unpackProject(file.readAll());
    if (!project)
        return inputError(name, project.error().message);
    if (!project->warning.isEmpty())
        project->warning = inputError(name, project->warning).message;
    return project;
}

Result<QImage> readThumbnail(const QString& fileName)
{
    const Result<ZipReader> archive = ZipReader::openFile(fileName);
    if (!archive)
        return inputError(QFileInfo(fileName).fileName(), archive.error().message);
    return readThumbnail(*archive);
}

} // namespace espalier
