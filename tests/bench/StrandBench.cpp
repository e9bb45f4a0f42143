// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/RecipePlayer.h"
#include "model/mesh/StrandMesher.h"
#include "model/shape/Pruning.h"
#include "model/strands/MedialAxis.h"
#include "model/strands/ProfileSlots.h"
#include "tests/support/Strands.h"

#include <QDir>

#include <benchmark/benchmark.h>
#include <tbb/global_control.h>

#include <array>
#include <chrono>
#include <fstream>
#include <map>
#include <string>

namespace {

using namespace espalier;

/// How far strands move from a node to the one below: those of the thickest branch against the section, those
/// of the others against the middle of their own branch. In strand radii.
std::vector<float> movesOf(const StrandLayouts& layouts)
{
    std::vector<float> moves;
    const StrandSkeleton& skeleton = layouts.skeleton();
    for (std::uint32_t i = 0; i < skeleton.nodes.size(); ++i) {
        std::uint32_t most = 0;
        for (const std::uint32_t child : skeleton.childrenOf(i))
            most = std::max(most, skeleton.nodes[child].strands);
        for (const std::uint32_t c : skeleton.childrenOf(i)) {
            const StrandNode& child = skeleton.nodes[c];
            Vec2 shift = Vec2::Zero();
            for (std::uint32_t s = 0; s < child.strands && child.strands < most; ++s)
                shift += (layouts.place(i, child.offset + s) - layouts.place(c, s)) /
                         static_cast<float>(child.strands);
            for (std::uint32_t s = 0; s < child.strands; ++s)
                moves.push_back((layouts.place(i, child.offset + s) - layouts.place(c, s) - shift).norm());
        }
    }
    std::ranges::sort(moves);
    return moves;
}

void count(benchmark::State& state, const StrandLayouts& layouts)
{
    const StrandLayouts::Counts counts = layouts.count();
    const std::vector<float> moves = movesOf(layouts);
    const auto move = [&](double share) {
        return double{moves[static_cast<std::size_t>(share * static_cast<double>(moves.size() - 1))]};
    };
    state.counters["nodes"] = static_cast<double>(layouts.skeleton().nodes.size());
    state.counters["strands"] = static_cast<double>(counts.strands);
    state.counters["particles"] = static_cast<double>(counts.particles);
    state.counters["MB"] = static_cast<double>(layouts.bytes()) / 1e6;
    state.counters["move50"] = move(0.5);
    state.counters["move90"] = move(0.9);
    state.counters["move99"] = move(0.99);
    state.counters["moveMost"] = move(1.0);
}

void measure(benchmark::State& state, const Tree& tree, const TreeIndex& index, std::size_t threads)
{
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    const Widths widths(tree, index);
    for (auto _ : state)
        benchmark::DoNotOptimize(StrandLayouts(tree, index, widths));
    count(state, StrandLayouts(tree, index, widths));
}

/// 42,000 nodes, 14,600 strands, about 650,000 particles.
void strandLayouts_forkedTree(benchmark::State& state)
{
    static const test::TreeBuilder grown = test::forkedTree(14'600);
    measure(state, grown.tree, grown.index, static_cast<std::size_t>(state.range(0)));
}
BENCHMARK(strandLayouts_forkedTree)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();

/// The tree of a recipe, or null if it cannot be read.
const TreeDocument* sample(benchmark::State& state, const QString& fileName)
{
    static std::map<QString, std::unique_ptr<TreeDocument>> documents;
    std::unique_ptr<TreeDocument>& document = documents[fileName];
    if (!document) {
        const Result<Recipe> recipe = readRecipe(fileName);
        if (!recipe) {
            state.SkipWithError(qPrintable(recipe.error().message));
            return nullptr;
        }
        document = std::make_unique<TreeDocument>();
        RecipePlayer(*document, *recipe).playAll();
    }
    return document.get();
}

void strandLayouts_sample(benchmark::State& state, const QString& fileName, std::size_t threads)
{
    if (const TreeDocument* const document = sample(state, fileName))
        measure(state, document->tree(), document->index(), threads);
}

void strandMesh_sample(benchmark::State& state, const QString& fileName, std::size_t threads)
{
    const TreeDocument* const document = sample(state, fileName);
    if (document == nullptr)
        return;
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    const Tree& tree = document->tree();
    const Widths widths(tree, document->index());
    for (auto _ : state) {
        const StrandLayouts layouts(tree, document->index(), widths);
        benchmark::DoNotOptimize(meshStrands(layouts, tree.parameters()));
    }
}

/// Begins a new measurement of the largest resident size of the program.
void forgetPeak()
{
    std::ofstream("/proc/self/clear_refs") << "5";
}
/// A line of /proc/self/status, in bytes.
double statusBytes(const std::string& name)
{
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);) {
        if (line.starts_with(name + ":"))
            return 1024.0 * std::stod(line.substr(name.size() + 1));
    }
    return 0.0;
}

std::uint64_t particlesOf(const StrandLayouts& layouts)
{
    std::uint64_t particles = 0;
    for (std::uint32_t i = 0; i < layouts.skeleton().nodes.size(); ++i)
        particles += layouts.skeleton().isBase(i) ? 0 : layouts.strandCount(i);
    return particles;
}

/// The mesh of a tree of so many tips, on so many threads: 2,600 tips have about 100,000 particles, 14,600
/// have 650,000, and 60,000 have 3 million. The peak is that of the layouts and the mesh together.
void strandMesh_forkedTree(benchmark::State& state)
{
    static std::map<std::int64_t, test::TreeBuilder> trees;
    const std::int64_t tips = state.range(0);
    if (!trees.contains(tips))
        trees.emplace(tips, test::forkedTree(static_cast<std::uint32_t>(tips)));
    const test::TreeBuilder& grown = trees.at(tips);
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism,
                                      static_cast<std::size_t>(state.range(1)));
    const Widths widths(grown.tree, grown.index);
    const double before = statusBytes("VmRSS");
    forgetPeak();
    const StrandLayouts layouts(grown.tree, grown.index, widths);
    std::size_t vertices = 0;
    for (auto _ : state)
        vertices = meshStrands(layouts, grown.tree.parameters()).vertices.size();
    const auto particles = static_cast<double>(particlesOf(layouts));
    state.counters["nodes"] = static_cast<double>(layouts.skeleton().nodes.size());
    state.counters["particles"] = particles;
    state.counters["vertices"] = static_cast<double>(vertices);
    state.counters["nsPerParticle"] = benchmark::Counter(
        particles * 1e-9, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
    state.counters["peakBytesPerParticle"] = (statusBytes("VmHWM") - before) / particles;
}
BENCHMARK(strandMesh_forkedTree)
    ->ArgsProduct({{2'600, 14'600, 30'000, 60'000}, {1, 2}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

/// An edit of a grown tree: a profile on its trunk, or a pruned limb.
struct StrandEdit {
    const char* name;
    TreeDelta (*make)(const Tree&, const TreeIndex&);
};

/// The first internode from the base up whose wood carries less than @p share of all tips; kNoInternode above
/// the trunk.
InternodeId placeOnTrunk(const Tree& tree, const TreeIndex& index, double share)
{
    InternodeId id = 0;
    while (index.tipCount(id) > share * index.tipCount(0)) {
        InternodeId thickest = kNoInternode;
        for (InternodeId child = index.firstChild(id); child != kNoInternode;
             child = index.nextSibling(child)) {
            if (thickest == kNoInternode || index.tipCount(child) > index.tipCount(thickest))
                thickest = child;
        }
        if (thickest == kNoInternode)
            return id;
        id = thickest;
    }
    return tree.isAlive(id) ? id : kNoInternode;
}

constexpr std::array kStrandEdits{
    StrandEdit{"profile",
               [](const Tree& tree, const TreeIndex& index) {
                   return test::profileChange(tree, placeOnTrunk(tree, index, 0.9),
                                              profileOf(ProfileShape::CShape));
               }},
    StrandEdit{"prune", [](const Tree& tree, const TreeIndex& index) {
                   // A limb of about a twentieth of the tree.
                   return prune(tree, index, std::array{placeOnTrunk(tree, index, 0.05)});
               }}};

/// All that StrandRunner does between an edit and the picture: snapshot indexed, widths, layouts, mesh.
void measureEdit(benchmark::State& state, const Tree& before, const TreeIndex& index, const StrandEdit& edit,
                 std::size_t threads)
{
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    WorkProgress progress;
    const WoodMeshOptions options;
    const auto layoutsBefore = std::make_shared<const StrandLayouts>(before, index, Widths(before, index));
    const auto last = meshStrands(layoutsBefore, before.parameters(), options, nullptr, progress);
    Tree tree = before;
    tree.apply(edit.make(before, index));
    std::array<double, 3> seconds{};
    std::size_t taken = 0;
    std::size_t nodes = 0;
    for (auto _ : state) {
        const auto start = std::chrono::steady_clock::now();
        const TreeIndex now(tree);
        const Widths widths(tree, now);
        const auto indexed = std::chrono::steady_clock::now();
        auto layouts =
            std::make_shared<const StrandLayouts>(tree, now, widths, last->layouts.get(), &progress);
        nodes = layouts->skeleton().nodes.size();
        const auto laid = std::chrono::steady_clock::now();
        const auto wood = meshStrands(std::move(layouts), tree.parameters(), options, last.get(), progress);
        const auto end = std::chrono::steady_clock::now();
        taken = wood->taken;
        seconds[0] += std::chrono::duration<double>(indexed - start).count();
        seconds[1] += std::chrono::duration<double>(laid - indexed).count();
        seconds[2] += std::chrono::duration<double>(end - laid).count();
    }
    const auto iterations = static_cast<double>(state.iterations());
    state.counters["msIndex"] = 1e3 * seconds[0] / iterations;
    state.counters["msLayouts"] = 1e3 * seconds[1] / iterations;
    state.counters["msMesh"] = 1e3 * seconds[2] / iterations;
    state.counters["taken"] = static_cast<double>(taken) / static_cast<double>(nodes);
}

void strandEdit_forkedTree(benchmark::State& state)
{
    static const test::TreeBuilder grown = test::forkedTree(14'600);
    const StrandEdit& edit = kStrandEdits[static_cast<std::size_t>(state.range(0))];
    state.SetLabel(edit.name);
    measureEdit(state, grown.tree, grown.index, edit, static_cast<std::size_t>(state.range(1)));
}
BENCHMARK(strandEdit_forkedTree)->ArgsProduct({{0, 1}, {1, 2}})->Unit(benchmark::kMillisecond)->UseRealTime();

[[maybe_unused]] const bool areSamplesRegistered = [] {
    const QDir folder(QStringLiteral(SOURCE_DIR "/resources/recipes"));
    for (const QString& name : folder.entryList({QStringLiteral("*.json")})) {
        for (const std::size_t threads : {std::size_t{1}, std::size_t{2}}) {
            benchmark::RegisterBenchmark(
                qPrintable(QStringLiteral("strandLayouts_sample/%1/%2").arg(name).arg(threads)),
                [file = folder.filePath(name), threads](benchmark::State& state) {
                    strandLayouts_sample(state, file, threads);
                })
                ->Unit(benchmark::kMillisecond)
                ->UseRealTime();
            benchmark::RegisterBenchmark(
                qPrintable(QStringLiteral("strandMesh_sample/%1/%2").arg(name).arg(threads)),
                [file = folder.filePath(name), threads](benchmark::State& state) {
                    strandMesh_sample(state, file, threads);
                })
                ->Unit(benchmark::kMillisecond)
                ->UseRealTime();
            for (const StrandEdit& edit : kStrandEdits) {
                benchmark::RegisterBenchmark(
                    qPrintable(
                        QStringLiteral("strandEdit_sample/%1/%2/%3").arg(name, edit.name).arg(threads)),
                    [file = folder.filePath(name), &edit, threads](benchmark::State& state) {
                        if (const TreeDocument* const document = sample(state, file))
                            measureEdit(state, document->tree(), document->index(), edit, threads);
                    })
                    ->Unit(benchmark::kMillisecond)
                    ->UseRealTime();
            }
        }
    }
    return true;
}();

void profileSlots_10k(benchmark::State& state)
{
    const StrandProfile profile = profileOf(static_cast<ProfileShape>(state.range(0)));
    for (auto _ : state)
        benchmark::DoNotOptimize(profileSlots(profile, 10'000));
}
BENCHMARK(profileSlots_10k)->DenseRange(0, kProfileShapeCount - 1)->Unit(benchmark::kMillisecond);

void medialAxis_shape(benchmark::State& state)
{
    const StrandProfile profile = profileOf(static_cast<ProfileShape>(state.range(0)));
    for (auto _ : state)
        benchmark::DoNotOptimize(medialAxis(profile));
}
BENCHMARK(medialAxis_shape)->DenseRange(0, kProfileShapeCount - 1)->Unit(benchmark::kMillisecond);

} // namespace
