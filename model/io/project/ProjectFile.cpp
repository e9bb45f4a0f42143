// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/project/ProjectFile.h"

#include "model/io/FileReader.h"
#include "model/io/FileWriter.h"
#include "model/io/ImageStructure.h"
#include "model/io/JsonReader.h"
#include "model/io/ZipArchive.h"
#include "model/io/project/JournalCheck.h"
#include "model/io/project/JournalEntries.h"
#include "model/io/project/KeptEntries.h"
#include "model/io/project/LookEntry.h"
#include "model/io/project/PositionCheck.h"
#include "model/io/project/ProjectDescription.h"
#include "model/io/project/ProjectImages.h"
#include "model/io/project/ProjectVersion1.h"
#include "model/io/project/TreeEntries.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QFileInfo>
#include <QImageReader>

#include <algorithm>

namespace espalier {

namespace {

constexpr char kDescriptionEntry[] = "project.json";
constexpr char kThumbnailEntry[] = "thumbnail.png";
constexpr qsizetype kMaximumDescription = 64 << 20;
constexpr qint64 kMaximumFile = qint64{2} << 30;
constexpr std::uint64_t kMaximumThumbnail = 16 << 20;
constexpr int kMaximumThumbnailEdge = 4096;

struct ProjectFileText {
    Q_DECLARE_TR_FUNCTIONS(ProjectFile)
};

/// The check of histories that both reader and writer apply.
Result<void> checkHistory(const Tree& tree, const Journal& journal)
{
    if (const Result<void> sound = checkJournal(tree, journal); !sound)
        return sound;
    return checkPositions(tree, journal);
}

/// All images that the file holds, each once.
std::vector<ImageAsset> imagesOf(const Project& project)
{
    std::vector<ImageAsset> images = ProjectImages::of(project.tree.parameterSets());
    if (project.look && !project.look->tracing.image.isNull() &&
        std::ranges::find(images, project.look->tracing.image) == images.end())
        images.push_back(project.look->tracing.image);
    return images;
}

bool isWithinLimits(const Project& project)
{
    const Tree& tree = project.tree;
    std::size_t lassoPoints = 0;
    for (const LassoStroke& stroke : tree.lassos())
        lassoPoints += stroke.points.size();
    std::size_t profilePoints = 0;
    for (const StrandProfile& profile : tree.profiles())
        profilePoints += profile.bytes() / sizeof(Vec2);
    return tree.size() <= projectLimits::kInternodes &&
           tree.placedLeaves().size() <= projectLimits::kLeaves &&
           project.journal.size() <= projectLimits::kDeltas &&
           tree.lassos().size() <= qsizetype{projectLimits::kLassos} &&
           lassoPoints <= projectLimits::kLassoPoints &&
           tree.profiles().size() <= qsizetype{projectLimits::kProfiles} &&
           profilePoints <= projectLimits::kProfilePoints &&
           ProjectImages::areWithinLimits(imagesOf(project));
}

Result<Project> readProject(const ZipReader& archive, JsonReader& reader)
{
    const Result<ProjectDescription> description = readDescription(reader);
    if (!description)
        return inputError(QString::fromLatin1(kDescriptionEntry), description.error().message);
    TreeContent content;
    content.seed = description->seed;
    content.step = description->step;
    content.currentParameters = description->currentParameters;
    content.lassosInForce = description->lassosInForce;
    Result<void> read = readTree(archive, description->internodes, description->leaves, content);
    ProjectImages images(archive, description->imageNames);
    KeptTable::visit(
        [&](const auto& info, auto& values) {
            if (read)
                read = readKept(archive, info.name, images, values);
        },
        content.kept);
    if (!read)
        return read.error();
    Result<Journal> journal = readJournal(archive, description->deltas, JournalBounds::of(content));
    if (!journal)
        return journal.error();
    Result<Tree> tree = Tree::fromContent(std::move(content));
    if (!tree)
        return tree.error();
    return Project{.tree = std::move(*tree),
                   .journal = std::move(*journal),
                   .name = description->name,
                   .thumbnail = {},
                   .ahead = description->ahead,
                   .look = {},
                   .foreign = {.members = description->foreign, .entries = {}},
                   .warning = images.lost()};
}

/// The look of a project that was read, and what other programs have put into the file, or sentences about
/// what is wrong with them: the tree is of use without them.
void takeMore(const ZipReader& archive, Project& project)
{
    QStringList warnings;
    if (!project.warning.isEmpty())
        warnings.append(ProjectFileText::tr(
                            "the image “%1” is missing from it or broken; the built-in look is shown instead")
                            .arg(project.warning));
    Result<std::optional<ReadLook>> look = readLook(archive);
    if (!look) {
        warnings.append(
            ProjectFileText::tr(
                "its background and light cannot be read (%1); those of a new tree are shown instead")
                .arg(look.error().message));
    } else if (*look) {
        if (!(*look)->lostPicture.isEmpty())
            warnings.append(ProjectFileText::tr("the reference picture “%1” is missing from it or broken")
                                .arg((*look)->lostPicture));
        project.look = std::move((*look)->look);
    }
    bool isWhole = true;
    project.foreign.entries = readForeignEntries(archive, isWhole);
    const bool canKeep = canKeepMembers(project.foreign.members);
    if (!canKeep)
        project.foreign.members = {};
    if (!isWhole || !canKeep)
        warnings.append(ProjectFileText::tr("some of what other programs have put into it cannot be kept"));
    project.warning = warnings.join(QStringLiteral("; "));
}

QImage readThumbnail(const ZipReader& archive)
{
    if (!archive.contains(kThumbnailEntry))
        return {};
    Result<QByteArray> png = archive.read(kThumbnailEntry, kMaximumThumbnail);
    if (!png || imageFormat(*png) != "png" || !imageStructureFault(*png).isEmpty())
        return {};
    QBuffer buffer(&*png);
    QImageReader reader(&buffer, "png");
    const QSize size = reader.size();
    if (size.isEmpty() || size.width() > kMaximumThumbnailEdge || size.height() > kMaximumThumbnailEdge)
        return {};
    return reader.read();
}

QByteArray thumbnailPng(const QImage& image)
{
    QByteArray png;
    QBuffer buffer(&png);
    image.save(&buffer, "png");
    return png;
}

} // namespace

Result<void> checkProject(const Project& project)
{
    if (QString fault = treeFault(project.tree.content()); !fault.isEmpty())
        return Error{Error::Kind::Input, std::move(fault)};
    return checkHistory(project.tree, project.journal);
}

Tree shownTree(const Project& project)
{
    Tree tree = project.tree;
    for (std::size_t i = 0; i < project.ahead; ++i)
        tree.revertDropping(*project.journal[project.journal.size() - 1 - i]);
    return tree;
}

Result<QByteArray> packProject(const Project& project)
{
    if (!isWithinLimits(project))
        return Error{Error::Kind::Output,
                     ProjectFileText::tr("the tree or its history is too large for a project file")};
    if (const Result<void> sound = checkProject(project); !sound)
        return Error{Error::Kind::Output, sound.error().message};
    const TreeContent& content = project.tree.content();
    ZipWriter archive;
    archive.add(kDescriptionEntry, describe(project.name, project.tree, project.journal.size(), project.ahead,
                                            project.foreign.members));
    addTree(archive, content);
    KeptTable::visit([&](const auto& info, const auto& values) { addKept(archive, info.name, values); },
                     content.kept);
    addJournal(archive, project.journal);
    if (project.look)
        addLook(archive, *project.look);
    ProjectImages::add(archive, imagesOf(project));
    if (!project.thumbnail.isNull())
        archive.add(kThumbnailEntry, thumbnailPng(project.thumbnail), ZipWriter::Packing::Store);
    addForeignEntries(archive, project.foreign.entries);
    return archive.finish();
}

Result<Project> unpackProject(const QByteArray& bytes)
{
    const Result<ZipReader> archive = ZipReader::open(bytes);
    if (!archive)
        return archive.error();
    const Result<QByteArray> text = archive->read(kDescriptionEntry, kMaximumDescription);
    if (!text)
        return text.error();
    const QString place = QString::fromLatin1(kDescriptionEntry);
    const Result<QJsonObject> json = parseJsonObject(*text, kMaximumDescription);
    if (!json)
        return inputError(place, json.error().message);
    JsonReader reader(*json, {});
    const Result<int> version = readVersion(reader);
    if (!version)
        return inputError(place, version.error().message);
    Result<Project> project =
        *version == 1 ? projectVersion1::read(*archive, reader) : readProject(*archive, reader);
    if (!project)
        return project;
    if (const Result<void> sound = checkHistory(project->tree, project->journal); !sound)
        return sound.error();
    takeMore(*archive, *project);
    project->thumbnail = readThumbnail(*archive);
    return project;
}

Result<void> saveProject(const Project& project, const QString& fileName)
{
    const QString name = QFileInfo(fileName).fileName();
    const Result<QByteArray> content = packProject(project);
    if (!content)
        return Error{Error::Kind::Output, inputError(name, content.error().message).message};
    return writeFile(fileName, *content);
}

Result<Project> loadProject(const QString& fileName)
{
    const QString name = QFileInfo(fileName).fileName();
    const Result<QByteArray> bytes = readFile(fileName, kMaximumFile);
    if (!bytes)
        return bytes.error();
    Result<Project> project = unpackProject(*bytes);
    if (!project)
        return inputError(name, project.error().message);
    if (!project->warning.isEmpty())
        project->warning = inputError(name, project->warning).message;
    return project;
}

Result<QImage> readThumbnail(const QString& fileName)
{
    // Opening a pipe could wait for ever.
    if (!QFileInfo(fileName).isFile())
        return inputError(QFileInfo(fileName).fileName(), ProjectFileText::tr("there is no such file"));
    const Result<ZipReader> archive = ZipReader::openFile(fileName);
    if (!archive)
        return inputError(QFileInfo(fileName).fileName(), archive.error().message);
    return readThumbnail(*archive);
}

} // namespace espalier
