// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/ReproduceTree.h"
#include "commands/SketchStroke.h"
#include "commands/VaryTree.h"
#include "model/base/Random.h"
#include "model/sketch/BranchPropagation.h"
#include "model/sketch/FlatTree.h"
#include "tests/bench/Crowns.h"
#include "tests/support/TreeBuilder.h"

#include <benchmark/benchmark.h>

#include <cmath>

namespace espalier {

namespace {

/// A trunk, and strokes that join whatever is near.
void drawStrokes(TreeDocument& document, int count)
{
    const auto draw = [&](std::vector<Vec2> points) {
        const LassoStroke stroke{Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), std::move(points)};
        (void)sketchBranch(document, {.stroke = stroke, .base = {}});
    };
    draw({{0.0F, 0.0F}, {0.0F, 4.0F}});
    Random random(7, 0, 0, Purpose::ShootLength);
    for (int i = 1; i < count; ++i) {
        const Vec2 from(static_cast<float>(random.uniform(-1.5, 1.5)),
                        static_cast<float>(random.uniform(1.0, 4.0)));
        const Vec2 way(static_cast<float>(random.uniform(-0.8, 0.8)),
                       static_cast<float>(random.uniform(0.2, 0.8)));
        draw({from, from + 0.5F * way + Vec2(0.05F, 0.0F), from + way});
    }
}

void sketch_giveDepth(benchmark::State& state)
{
    TreeDocument document;
    drawStrokes(document, static_cast<int>(state.range(0)));
    for (auto _ : state)
        benchmark::DoNotOptimize(giveDepth(document.tree(), document.index(), {}));
}
BENCHMARK(sketch_giveDepth)->Arg(50)->Arg(200)->Unit(benchmark::kMillisecond);

void sketch_stroke(benchmark::State& state)
{
    TreeDocument document;
    drawStrokes(document, 200);
    for (auto _ : state) {
        const LassoStroke stroke{Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), {{0.1F, 2.0F}, {0.9F, 2.7F}}};
        benchmark::DoNotOptimize(sketchBranch(document, {.stroke = stroke, .base = {}}));
        document.undo();
    }
}
BENCHMARK(sketch_stroke)->Unit(benchmark::kMillisecond);

using namespace test;

/// Propagation of a branch with @p twigs twigs of 3 internodes to 1,000 branches: 30,000 nodes with 10 twigs,
/// the size of the largest tree of Okabe 2005 (figure 1).
void propagation(benchmark::State& state)
{
    constexpr InternodeId kTargets = 1000;
    TreeBuilder builder;
    builder.growAxis(0, kTerminalSlot, continuing(), kTargets, continuing(0.0, 0.0), 0.01F);
    std::vector<InternodeId> firsts;
    for (InternodeId i = 0; i <= kTargets; ++i) {
        firsts.push_back(builder.tree.size());
        builder.growAxis(i, 0, branching(1.0), 12, continuing(0.05), 0.02F);
    }
    const InternodeId reference = firsts.front();
    for (InternodeId i = 0; i < static_cast<InternodeId>(state.range(0)); ++i)
        builder.growAxis(reference + i, 0, branching(0.8), 3, continuing(), 0.01F);
    std::uint32_t born = 0;
    for (auto _ : state) {
        const Result<TreeDelta> delta =
            propagated(builder.tree, builder.index,
                       {.reference = reference, .targets = Propagation::Targets::SameOrder, .axes = {}});
        born = delta ? delta->born.count : 0;
    }
    state.counters["born"] = born;
}

BENCHMARK(propagation)->Arg(10)->ArgName("twigs")->Unit(benchmark::kMillisecond);

/// A grown crown takes the figure of a leaning trunk and of a silhouette of 500 points, as one command.
void reproduction(benchmark::State& state)
{
    TreeDocument& document = crown(static_cast<std::uint32_t>(state.range(0)));
    TreeFigure figure{.trunk = {{0.0F, 0.0F}, {0.3F, 1.0F}, {0.2F, 2.0F}}, .silhouette = {}, .azimuth = 20.0};
    for (int i = 0; i < 500; ++i) {
        const auto angle = static_cast<float>(radians(0.72 * i));
        figure.silhouette.emplace_back(0.2F + 1.5F * std::cos(angle), 1.6F + 1.4F * std::sin(angle));
    }
    for (auto _ : state) {
        benchmark::DoNotOptimize(reproduceTree(document, figure));
        state.PauseTiming();
        document.undo();
        state.ResumeTiming();
    }
}
BENCHMARK(reproduction)->Arg(30'000)->ArgName("internodes")->Unit(benchmark::kMillisecond);

/// One variation takes the place of another, as in the window.
void variation(benchmark::State& state)
{
    TreeDocument& document = crown(static_cast<std::uint32_t>(state.range(0)));
    VariationTrial trial(document);
    std::uint64_t seed = 0;
    for (auto _ : state)
        benchmark::DoNotOptimize(trial.tryOut(++seed, 0.3));
    document.undo();
}
BENCHMARK(variation)->Arg(30'000)->ArgName("internodes")->Unit(benchmark::kMillisecond);

} // namespace

} // namespace espalier
