// SPDX-License-Identifier: GPL-3.0-or-later
// How the time for documents with many things of one kind grows with their number n: the rows end in the
// fitted order, which must not be above n log n.
#include "commands/DocumentProject.h"
#include "commands/ProfileEdits.h"
#include "commands/SetParameters.h"
#include "model/document/Edit.h"
#include "model/io/project/ProjectFile.h"
#include "tests/support/TreeBuilder.h"
#include "views/render/PreparedScene.h"

#include <benchmark/benchmark.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace espalier::test {

namespace {

enum Kind { kBranchesAtOneNode, kLassoStrokes, kParameterSets, kProfiles };

void applyAlone(TreeDocument& document, TreeDelta delta)
{
    Edit edit(document);
    edit.apply(std::move(delta));
    edit.commit(QStringLiteral("Change"));
}

NewInternode branchAt(int number)
{
    return {.parent = 0,
            .slot = kFirstAdventitiousSlot,
            .rotation = branching(1.0, number % 97, 97),
            .length = 0.05F};
}

LassoStroke strokeOf(int number)
{
    LassoStroke stroke;
    const float left = 0.01F * static_cast<float>(number);
    stroke.points = {Vec2(left, 1.0F), Vec2(left + 1.0F, 1.0F), Vec2(left + 1.0F, 2.0F)};
    return stroke;
}

void performOne(TreeDocument& document, Kind kind, int number)
{
    const Tree& tree = document.tree();
    switch (kind) {
    case kBranchesAtOneNode:
        applyAlone(document, births(tree, std::vector{branchAt(number)}));
        return;
    case kLassoStrokes: {
        TreeDelta delta = deltaStartingAt(tree);
        delta.lassos.push_back({keepLasso(delta, tree, strokeOf(number)), true});
        applyAlone(document, std::move(delta));
        return;
    }
    case kParameterSets: {
        TreeParameters parameters = tree.parameters();
        parameters.growth.branchingAngle = 0.2 + 1e-5 * number;
        setParameters(document, parameters);
        return;
    }
    case kProfiles: {
        const float size = 1.0F + 1e-4F * static_cast<float>(number);
        StrandProfile profile;
        profile.boundaries = {{Vec2(-size, -1.0F), Vec2(size, -1.0F), Vec2(0.0F, 1.0F)}};
        setProfile(document, std::vector<InternodeId>{0}, profile);
        return;
    }
    }
}

void perform(TreeDocument& document, Kind kind, int count)
{
    for (int i = 0; i < count; ++i)
        performOne(document, kind, i);
}

void performsAll(benchmark::State& state)
{
    const auto kind = static_cast<Kind>(state.range(0));
    for ([[maybe_unused]] const auto iteration : state) {
        TreeDocument document;
        perform(document, kind, static_cast<int>(state.range(1)));
    }
    state.SetComplexityN(state.range(1));
}

void undoesAndRedoesAll(benchmark::State& state)
{
    TreeDocument document;
    document.undoStack().setUndoLimit(0);
    perform(document, static_cast<Kind>(state.range(0)), static_cast<int>(state.range(1)));
    for ([[maybe_unused]] const auto iteration : state) {
        while (document.undoStack().canUndo())
            document.undoStack().undo();
        while (document.undoStack().canRedo())
            document.undoStack().redo();
    }
    state.SetComplexityN(state.range(1));
}

void opens(benchmark::State& state)
{
    TreeDocument document;
    perform(document, static_cast<Kind>(state.range(0)), static_cast<int>(state.range(1)));
    const Result<QByteArray> packed = packProject(projectOf(document, QStringLiteral("Many")));
    if (!packed) {
        state.SkipWithError(packed.error().message.toUtf8().constData());
        return;
    }
    for ([[maybe_unused]] const auto iteration : state) {
        Result<Project> project = unpackProject(*packed);
        if (!project) {
            state.SkipWithError(project.error().message.toUtf8().constData());
            return;
        }
        PreparedTree tree = prepared(std::move(*project));
        tree.preparePicking();
        const PreparedScene scene(tree.tree, tree.index, tree.growthModel->space());
        benchmark::DoNotOptimize(scene.mesh);
    }
    state.SetComplexityN(state.range(1));
}

} // namespace

/// A family for each kind, so that each gets an order of its own.
[[maybe_unused]] const bool kAreRegistered = [] {
    constexpr std::array<std::pair<const char*, Kind>, 4> kKinds{
        {{"branches at one node", kBranchesAtOneNode},
         {"lassos", kLassoStrokes},
         {"parameter sets", kParameterSets},
         {"profiles", kProfiles}}};
    const auto add = [](const std::string& name, void (*run)(benchmark::State&), Kind kind) {
        benchmark::internal::Benchmark* made = benchmark::RegisterBenchmark(name.c_str(), run);
        for (const int count : {2'000, 4'000, 8'000, 16'000})
            made->Args({kind, count});
        made->Unit(benchmark::kMillisecond)->Complexity();
    };
    for (const auto& [name, kind] : kKinds) {
        add(std::string("performs ") + name, performsAll, kind);
        add(std::string("undoes and redoes ") + name, undoesAndRedoesAll, kind);
        add(std::string("opens ") + name, opens, kind);
    }
    return true;
}();

} // namespace espalier::test
