// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/BatchJob.h"

#include "app/cli/SketchJob.h"
#include "app/files/Outputs.h"
#include "commands/DocumentProject.h"
#include "commands/ImportSkeleton.h"
#include "commands/SetParameters.h"
#include "commands/VaryTree.h"
#include "commands/recipe/JournalRecipe.h"
#include "commands/recipe/Recipe.h"
#include "commands/recipe/RecipePlayer.h"
#include "model/base/WithinMemory.h"
#include "model/io/FileWriter.h"
#include "model/io/ParametersJson.h"
#include "model/mesh/BranchMesher.h"
#include "model/mesh/LeafCard.h"
#include "model/mesh/StrandMesher.h"
#include "model/mesh/SurfaceCheck.h"
#include "model/mesh/TreeCounts.h"
#include "views/render/OffscreenRenderer.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <unistd.h>

#include <cstdio>

namespace espalier {

namespace {

/// Prints the progress of a task, if the standard error is a terminal.
void tellProgress(const QString& text)
{
    static const bool isWatched = isatty(STDERR_FILENO) != 0;
    if (!isWatched)
        return;
    std::fprintf(stderr, "\r\033[K%s", qPrintable(text));
    std::fflush(stderr);
}

ExitCode fail(const Error& error)
{
    complain(error.message);
    return error.kind == Error::Kind::Input ? kInputUnreadable : kOutputNotWritten;
}

double secondsOf(const QElapsedTimer& timer)
{
    return static_cast<double>(timer.nsecsElapsed()) * 1e-9;
}

/// The largest memory that this process has used so far, MB; 0 if the system does not report it.
double peakMemory()
{
    QFile status(QStringLiteral("/proc/self/status"));
    if (!status.open(QIODevice::ReadOnly))
        return 0.0;
    for (const QByteArray& line : status.readAll().split('\n')) {
        if (line.startsWith("VmHWM:"))
            return line.mid(6).trimmed().split(' ').constFirst().toDouble() / 1024.0;
    }
    return 0.0;
}

/// Times that the parts of a job have taken, s.
struct Times {
    double growth = 0.0;
    double mesh = 0.0;
    double exports = 0.0;
    double total = 0.0;
};

struct MeshCounts {
    std::uint64_t vertices = 0;
    std::uint64_t triangles = 0;
    SurfaceFaults surface;           ///< Of the wood
    StrandLayouts::Counts strands{}; ///< All 0 for tubes
    double profileSeconds = 0.0;
    double woodSeconds = 0.0;
};

/// Counts of the exported mesh.
MeshCounts countMesh(const Tree& tree, const TreeIndex& index)
{
    MeshCounts counts;
    QElapsedTimer timer;
    timer.start();
    const Widths widths(tree, index);
    BranchMesh wood;
    if (tree.parameters().wood.mesher == WoodMesherKind::Strands) {
        const StrandLayouts layouts(tree, index, widths);
        counts.profileSeconds = secondsOf(timer);
        timer.start();
        wood = meshStrands(layouts, tree.parameters());
        counts.woodSeconds = secondsOf(timer);
        counts.strands = layouts.count();
    } else {
        wood = meshBranches(tree, index, widths);
        counts.woodSeconds = secondsOf(timer);
    }
    counts.surface = checkSurface(wood, true);
    const LeafCard& card = leafCard(tree.parameters().leaves.shape);
    const std::uint64_t leaves = countTree(tree, index).leaves;
    counts.vertices = wood.vertices.size() + leaves * card.vertices.size();
    counts.triangles = (wood.indices.size() + leaves * card.indices.size()) / 3;
    return counts;
}

QJsonValue number(std::uint64_t value)
{
    return QJsonValue(static_cast<qint64>(value));
}

QJsonObject countsToJson(const TreeCounts& counts)
{
    return {{QStringLiteral("internodes"), number(counts.internodes)},
            {QStringLiteral("buds"), number(counts.buds)},
            {QStringLiteral("leaves"), number(counts.leaves)},
            {QStringLiteral("leavesPlaced"), number(counts.leavesPlaced)},
            {QStringLiteral("axes"), number(counts.axes)},
            {QStringLiteral("steps"), number(counts.steps)}};
}

/// @p more: what else is to be said; its "infer" is a time.
Result<void> addStats(const TreeDocument& document, const MeshCounts& mesh, const Times& times,
                      QJsonObject more, const QString& fileName, Outputs& outputs)
{
    QJsonObject stats = countsToJson(countTree(document.tree(), document.index()));
    stats[QStringLiteral("vertices")] = number(mesh.vertices);
    stats[QStringLiteral("triangles")] = number(mesh.triangles);
    stats[QStringLiteral("strands")] = number(mesh.strands.strands);
    stats[QStringLiteral("particles")] = number(mesh.strands.particles);
    stats[QStringLiteral("contacts")] = QJsonObject{{QStringLiteral("count"), number(mesh.strands.contacts)},
                                                    {QStringLiteral("deepest"), mesh.strands.deepest}};
    const SurfaceFaults& surface = mesh.surface;
    stats[QStringLiteral("surface")] =
        QJsonObject{{QStringLiteral("openEdges"), number(surface.openEdges)},
                    {QStringLiteral("nonManifoldEdges"), number(surface.nonManifoldEdges)},
                    {QStringLiteral("nonManifoldVertices"), number(surface.nonManifoldVertices)},
                    {QStringLiteral("degenerate"), number(surface.degenerate)},
                    {QStringLiteral("components"), number(surface.components)},
                    {QStringLiteral("inverted"), number(surface.inverted)},
                    {QStringLiteral("selfIntersections"), number(surface.selfIntersections)}};
    QJsonObject seconds{
        {QStringLiteral("growth"), times.growth},          {QStringLiteral("mesh"), times.mesh},
        {QStringLiteral("profiles"), mesh.profileSeconds}, {QStringLiteral("wood"), mesh.woodSeconds},
        {QStringLiteral("export"), times.exports},         {QStringLiteral("total"), times.total}};
    if (const QJsonValue infer = more.take(QStringLiteral("infer")); infer.isDouble())
        seconds[QStringLiteral("infer")] = infer;
    stats[QStringLiteral("seconds")] = seconds;
    for (auto i = more.constBegin(); i != more.constEnd(); ++i)
        stats[i.key()] = i.value();
    stats[QStringLiteral("peakRssMb")] = peakMemory();
    return outputs.add(QJsonDocument(stats).toJson(), fileName);
}

/// Writes the strands of each cross-section: places in strand radii, along the first and third axis of the
/// section's frame.
Result<void> addProfiles(const TreeDocument& document, const QString& fileName, Outputs& outputs)
{
    const Tree& tree = document.tree();
    const StrandLayouts layouts(tree, document.index(), Widths(tree, document.index()));
    const auto digits = [](float value) { return QString::number(value, 'g', 7).toDouble(); };
    QJsonArray nodes;
    for (std::uint32_t i = 0; i < layouts.skeleton().nodes.size(); ++i) {
        const StrandNode& node = layouts.skeleton().nodes[i];
        const Vec3& centre = layouts.centre(i);
        QJsonArray places;
        for (std::uint32_t strand = 0; strand < node.strands; ++strand) {
            const Vec2 place = layouts.place(i, strand);
            places.append(QJsonArray{digits(place.x()), digits(place.y())});
        }
        QJsonObject json{
            {QStringLiteral("internode"), number(node.internode)},
            {QStringLiteral("along"), digits(node.along)},
            {QStringLiteral("parent"), layouts.skeleton().isBase(i) ? QJsonValue(-1) : number(node.parent)},
            {QStringLiteral("offset"), number(node.offset)},
            {QStringLiteral("radius"), digits(node.radius)},
            {QStringLiteral("strandRadius"), digits(layouts.scale(i))},
            {QStringLiteral("centre"),
             QJsonArray{digits(centre.x()), digits(centre.y()), digits(centre.z())}},
            {QStringLiteral("frame"), QJsonArray{digits(node.frame.x()), digits(node.frame.y()),
                                                 digits(node.frame.z()), digits(node.frame.w())}},
            {QStringLiteral("places"), places}};
        if (layouts.profileScale(i) > 0.0F)
            json[QStringLiteral("profileScale")] = digits(layouts.profileScale(i));
        nodes.append(json);
    }
    return outputs.add(
        QJsonDocument(QJsonObject{{QStringLiteral("nodes"), nodes}}).toJson(QJsonDocument::Compact),
        fileName);
}

Result<void> addPicture(const TreeDocument& document, const CommandLine& line, const QString& recipeView,
                        Outputs& outputs)
{
    PictureRequest request;
    request.size = line.size;
    request.view = namedView(line.camera.isEmpty() ? recipeView : line.camera);
    static_cast<SceneLook&>(request.options.view) = withoutPicture(document.look());
    request.options.view.fibresShown = line.fibres;
    if (line.transparent) {
        request.options.background = QColor(Qt::transparent);
        request.options.view.groundShown = line.groundShadow;
    }
    const Result<QImage> picture = renderImage(document, request);
    if (!picture)
        return Error{Error::Kind::Output,
                     QStringLiteral("%1: %2").arg(line.picture, picture.error().message)};
    return outputs.add(*picture, line.picture);
}

Result<void> addAll(const Project& project, const QStringList& fileNames, Outputs& outputs)
{
    for (const QString& fileName : fileNames) {
        tellProgress(QStringLiteral("%1…").arg(fileName));
        const Result<void> written = outputs.add(project, fileName);
        tellProgress({});
        if (!written)
            return written.error();
    }
    return {};
}

Result<void> writeOutputs(const Project& project, const QStringList& fileNames)
{
    Outputs outputs(fileNames);
    const Result<void> added = addAll(project, fileNames, outputs);
    return added ? outputs.commit() : added;
}

/// What is to be played: a recipe, or the history of a project.
struct ReplayInput {
    Recipe recipe;
    std::optional<Project> project; ///< That it is the history of
};

Result<ReplayInput> readReplayInput(const QString& fileName)
{
    if (QFileInfo(fileName).suffix().toLower() != QLatin1String("espalier")) {
        Result<Recipe> recipe = readRecipe(fileName);
        if (!recipe)
            return recipe.error();
        return ReplayInput{std::move(*recipe), {}};
    }
    Result<Project> project = loadProject(fileName);
    if (!project)
        return project.error();
    if (!project->warning.isEmpty())
        complain(project->warning);
    Result<Recipe> recipe = recipeOf(*project);
    if (!recipe)
        return inputError(QFileInfo(fileName).fileName(), recipe.error().message);
    return ReplayInput{std::move(*recipe), std::move(*project)};
}

/// Plays the recipes one after another on one document, and prints what they did not find there, which is an
/// Error if the command line is strict. Returns the view that the last of them asks for.
Result<QString> playRecipes(TreeDocument& document, QString& name, const CommandLine& line)
{
    std::vector<Recipe> recipes;
    std::optional<Tree> wanted;    // Of a project whose history alone is played
    std::optional<SceneLook> look; // Of the last project
    for (const QString& fileName : line.inputs) {
        Result<ReplayInput> input = readReplayInput(fileName);
        if (!input)
            return input.error();
        if (input->project && input->project->look)
            look = input->project->look;
        if (input->project && line.inputs.size() == 1 && !line.seed && line.overrides.isEmpty())
            wanted = shownTree(*input->project);
        line.overrides.applyTo(input->recipe);
        recipes.push_back(std::move(input->recipe));
    }
    if (line.seed)
        recipes.front().seed = *line.seed;
    name = recipes.front().name.isEmpty() ? QFileInfo(line.inputs.constFirst()).completeBaseName()
                                          : recipes.front().name;

    QString view;
    qsizetype warnings = 0;
    for (std::size_t i = 0; i < recipes.size(); ++i) {
        if (!recipes[i].camera.view.isEmpty())
            view = recipes[i].camera.view;
        const auto operations = recipes[i].operations.size();
        RecipePlayer player(document, std::move(recipes[i]),
                            i == 0 ? RecipePlayer::Start::Anew : RecipePlayer::Start::GoOn);
        for (std::size_t done = 1; !player.isDone(); ++done) {
            tellProgress(QStringLiteral("%1: %2/%3")
                             .arg(line.inputs[static_cast<qsizetype>(i)])
                             .arg(done)
                             .arg(operations));
            player.playOperation();
        }
        tellProgress({});
        const QString fileName = QFileInfo(line.inputs[static_cast<qsizetype>(i)]).fileName();
        for (const QString& warning : player.warnings())
            complain(QStringLiteral("%1: %2").arg(fileName, warning));
        warnings += player.warnings().size();
    }
    if (look)
        document.setLook(*look);
    if (wanted && !(document.tree() == *wanted)) {
        complain(
            QCoreApplication::translate(
                "CommandLine", "%1: its history, played again, gives a different tree from the one it holds")
                .arg(QFileInfo(line.inputs.constFirst()).fileName()));
        ++warnings;
    }
    if (line.strict && warnings > 0)
        return Error{Error::Kind::Input,
                     QCoreApplication::translate("CommandLine",
                                                 "--strict: nothing is written, because some "
                                                 "operations did not find everything that they name")};
    return view;
}

/// Writes all that the command line asks for. @p growth: s that making the tree has taken; @p view: that the
/// picture has unless the command line says otherwise; @p more: for the statistics.
Result<void> writeResults(const TreeDocument& document, const QString& name, const CommandLine& line,
                          double growth, const QString& view, const QJsonObject& more)
{
    Times times;
    times.growth = growth;
    QElapsedTimer total;
    total.start();
    MeshCounts mesh;
    QElapsedTimer timer;
    timer.start();
    if (!line.stats.isEmpty())
        mesh = countMesh(document.tree(), document.index());
    times.mesh = secondsOf(timer);

    timer.start();
    Outputs outputs(line.outputs + QStringList{line.picture, line.profiles, line.stats});
    Result<void> added = addAll(projectOf(document, name), line.outputs, outputs);
    times.exports = secondsOf(timer);
    if (added && !line.picture.isEmpty())
        added = addPicture(document, line, view, outputs);
    if (added && !line.profiles.isEmpty())
        added = addProfiles(document, line.profiles, outputs);
    times.total = growth + secondsOf(total);
    if (added && !line.stats.isEmpty())
        added = addStats(document, mesh, times, more, line.stats, outputs);
    return added ? outputs.commit() : added;
}

/// Varies the tree, if the command line says so.
Result<void> varyIfAsked(TreeDocument& document, const CommandLine& line)
{
    if (!line.variation)
        return {};
    const Result<void> done = varyTree(document, line.variation->seed, line.variation->amount);
    return done ? done : inputError(QFileInfo(line.inputs.constFirst()).fileName(), done.error().message);
}

Result<void> replay(const CommandLine& line)
{
    TreeDocument document;
    QElapsedTimer timer;
    timer.start();
    QString name;
    const Result<QString> view = playRecipes(document, name, line);
    if (!view)
        return view.error();
    if (const Result<void> done = varyIfAsked(document, line); !done)
        return done.error();
    return writeResults(document, name, line, secondsOf(timer), *view, {});
}

Result<void> sketch(const CommandLine& line)
{
    TreeDocument document;
    QElapsedTimer timer;
    timer.start();
    const Result<QJsonObject> stats = sketchTree(document, line);
    if (!stats)
        return stats.error();
    return writeResults(document, QFileInfo(line.inputs.constFirst()).completeBaseName(), line,
                        secondsOf(timer), {}, *stats);
}

/// Reads the input and prints a warning about parts of the file that could not be read.
Result<Project> loadInput(const CommandLine& line)
{
    Result<Project> project = loadProject(line.inputs.constFirst());
    if (project && !project->warning.isEmpty())
        complain(project->warning);
    return project;
}

Result<void> importTree(const CommandLine& line)
{
    const QString& fileName = line.inputs.constFirst();
    const Result<Skeleton> skeleton = readSkeletonFile(fileName);
    if (!skeleton)
        return skeleton.error();
    TreeDocument document;
    if (const Result<void> imported = importSkeleton(document, *skeleton); !imported)
        return inputError(QFileInfo(fileName).fileName(), imported.error().message);
    return writeOutputs(projectOf(document, QFileInfo(fileName).completeBaseName()), line.outputs);
}

/// Shows the project as the command line changes it: with other parameters in force, and varied.
Result<void> showChanged(TreeDocument& document, Project project, const CommandLine& line)
{
    showProject(document, std::move(project));
    if (!setParameters(document, line.overrides.appliedTo(document.parameters())))
        return inputError(
            QFileInfo(line.inputs.constFirst()).fileName(),
            QCoreApplication::translate("CommandLine", "there is no room for more parameter sets"));
    return varyIfAsked(document, line);
}

Result<void> exportProject(const CommandLine& line)
{
    Result<Project> project = loadInput(line);
    if (!project)
        return project.error();
    if (line.overrides.isEmpty() && !line.variation)
        return writeOutputs(*project, line.outputs);
    const QString name = project->name;
    const ForeignParts foreign = project->foreign;
    TreeDocument document;
    if (const Result<void> shown = showChanged(document, std::move(*project), line); !shown)
        return shown.error();
    Project changed = projectOf(document, name);
    changed.foreign = foreign;
    return writeOutputs(changed, line.outputs);
}

Result<void> render(const CommandLine& line)
{
    Result<Project> project = loadInput(line);
    if (!project)
        return project.error();
    TreeDocument document;
    if (const Result<void> shown = showChanged(document, std::move(*project), line); !shown)
        return shown.error();
    Outputs outputs({line.picture});
    const Result<void> added = addPicture(document, line, {}, outputs);
    return added ? outputs.commit() : added;
}

QJsonArray pointToJson(const Vec3& point)
{
    // A float has this many digits.
    const auto digits = [](float value) { return QString::number(value, 'g', 7).toDouble(); };
    return {digits(point.x()), digits(point.y()), digits(point.z())};
}

Result<void> info(const CommandLine& line)
{
    const Result<Project> project = loadInput(line);
    if (!project)
        return project.error();
    const Tree tree = shownTree(*project);
    const TreeIndex index(tree);
    const Box3 bounds = treeBounds(tree, index);
    const QJsonObject json{
        {QStringLiteral("version"), projectLimits::kVersion},
        {QStringLiteral("name"), project->name},
        {QStringLiteral("seed"), QString::number(project->tree.seed())},
        {QStringLiteral("counts"), countsToJson(countTree(tree, index))},
        {QStringLiteral("bounds"), QJsonObject{{QStringLiteral("minimum"), pointToJson(bounds.min())},
                                               {QStringLiteral("maximum"), pointToJson(bounds.max())}}},
        {QStringLiteral("journalLength"), number(project->journal.size())},
        {QStringLiteral("parameters"), toJson(tree.parameters())},
    };
    const QByteArray text = QJsonDocument(json).toJson();
    if (std::fwrite(text.constData(), 1, static_cast<std::size_t>(text.size()), stdout) !=
            static_cast<std::size_t>(text.size()) ||
        std::fflush(stdout) != 0)
        return Error{Error::Kind::Output, QStringLiteral("standard output: %1").arg(qt_error_string())};
    return {};
}

} // namespace

NamedView namedView(const QString& name)
{
    if (name == QStringLiteral("side"))
        return NamedView::Side;
    if (name == QStringLiteral("top"))
        return NamedView::Top;
    if (name == QStringLiteral("three-quarter"))
        return NamedView::ThreeQuarter;
    return NamedView::Front;
}

void complain(const QString& sentence)
{
    constexpr qsizetype kMost = 1000;
    QString shown = sentence.left(kMost).simplified();
    // A name from a file could otherwise send commands to the terminal.
    for (QChar& character : shown) {
        if (!character.isPrint() && !character.isSurrogate())
            character = QChar::ReplacementCharacter;
    }
    if (sentence.size() > kMost)
        shown += QChar(0x2026);
    std::fprintf(stderr, "espalier: %s\n", qPrintable(shown));
}

namespace {

Result<void> perform(const CommandLine& line)
{
    Result<void> result;
    switch (line.verb) {
    case CommandLine::Verb::Replay:
        result = replay(line);
        break;
    case CommandLine::Verb::Import:
        result = importTree(line);
        break;
    case CommandLine::Verb::Sketch:
        result = sketch(line);
        break;
    case CommandLine::Verb::Export:
        result = exportProject(line);
        break;
    case CommandLine::Verb::Render:
        result = render(line);
        break;
    case CommandLine::Verb::Info:
        result = info(line);
        break;
    default:
        Q_UNREACHABLE();
    }
    return result;
}

} // namespace

ExitCode runBatchJob(const CommandLine& line)
{
    const auto work = [&line] { return perform(line); };
    const Result<void> result = withinMemory(work);
    return result ? kDone : fail(result.error());
}

} // namespace espalier
