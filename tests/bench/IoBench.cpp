// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/export/Exporter.h"
#include "model/io/project/ProjectFile.h"
#include "tests/support/SampleProject.h"

#include <QTemporaryDir>

#include <benchmark/benchmark.h>

namespace espalier::test {

namespace {

void savesAProject(benchmark::State& state)
{
    const Project project = sampleProject(static_cast<std::uint32_t>(state.range(0)));
    const QTemporaryDir folder;
    const QString fileName = folder.filePath(QStringLiteral("tree.espalier"));
    for ([[maybe_unused]] const auto round : state) {
        if (!saveProject(project, fileName))
            state.SkipWithError("the project could not be saved");
    }
}

void loadsAProject(benchmark::State& state)
{
    const Result<QByteArray> content = packProject(sampleProject(static_cast<std::uint32_t>(state.range(0))));
    for ([[maybe_unused]] const auto round : state) {
        if (!unpackProject(*content))
            state.SkipWithError("the project could not be read");
    }
}

/// Meshes, textures, format and disk; the arguments are internodes and the format.
void exportsATree(benchmark::State& state)
{
    const TreeBuilder builder = randomTree(static_cast<std::uint32_t>(state.range(0)));
    const QString suffix = exportSuffixes().at(state.range(1));
    const QTemporaryDir folder;
    for ([[maybe_unused]] const auto round : state) {
        if (!exportTree(builder.tree, builder.index, {}, folder.filePath(QStringLiteral("tree.") + suffix)))
            state.SkipWithError("the tree could not be exported");
    }
    std::size_t vertices = 0;
    for (const ExportMesh& mesh : buildExportScene(builder.tree, builder.index, {}).meshes)
        vertices += mesh.mesh.vertices.size();
    state.counters["vertices"] = static_cast<double>(vertices);
    state.SetLabel(suffix.toStdString());
}

} // namespace

BENCHMARK(savesAProject)->Arg(50'000)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(loadsAProject)->Arg(50'000)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(exportsATree)
    ->ArgsProduct({{45'000}, {0, 1, 2, 3}})
    ->Unit(benchmark::kMillisecond)
    ->Iterations(2)
    ->UseRealTime();

} // namespace espalier::test
