// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/growth/BrushGrowth.h"
#include "model/growth/SelfOrganisingModel.h"
#include "model/mesh/BranchMesher.h"
#include "model/mesh/LeafCard.h"
#include "model/texture/Textures.h"
#include "views/render/MeshPool.h"

#include <benchmark/benchmark.h>
#include <tbb/global_control.h>

#include <array>
#include <cmath>

namespace {

using namespace espalier;

/// A tree under a brush that circles through its crown.
class Brushed {
public:
    explicit Brushed(std::uint32_t internodes = 0)
    {
        m_growth.rebuild(m_tree, m_index);
        while (m_index.livingCount() < internodes)
            step();
    }

    /// Continues until a step grows something, and returns that step.
    TreeDelta& step()
    {
        for (;;) {
            const BrushSample brush = sample(m_step);
            m_delta = m_brush.step(m_tree, m_index, m_growth,
                                   std::array{sample(m_step > 0 ? m_step - 1 : 0), brush});
            ++m_step;
            if (m_delta.isEmpty())
                continue;
            m_tree.apply(m_delta);
            m_index.update(m_tree, m_delta);
            m_growth.follow(m_tree, m_index, m_delta);
            m_growth.settle(m_tree, m_index);
            return m_delta;
        }
    }

    const Tree& tree() const { return m_tree; }
    const TreeIndex& index() const { return m_index; }

private:
    static BrushSample sample(int step)
    {
        const double height = step < 25 ? 0.15 * step : 4.0 + 3.0 * std::sin(0.013 * step);
        const double reach = step < 25 ? 0.0 : 2.5 + 1.5 * std::sin(0.021 * step);
        const Vec3 position(static_cast<float>(reach * std::cos(0.05 * step)), static_cast<float>(height),
                            static_cast<float>(reach * std::sin(0.05 * step)));
        return {.time = step / kBrushStepsPerSecond, .position = position, .radius = 1.2F};
    }

    Tree m_tree{3};
    TreeIndex m_index{m_tree};
    SelfOrganisingModel m_growth;
    BrushGrowth m_brush;
    TreeDelta m_delta;
    int m_step = 0;
};

const Brushed& tree50k()
{
    static const Brushed tree(50'000);
    return tree;
}

void setRate(benchmark::State& state, const char* what, std::size_t count)
{
    state.counters[what] =
        benchmark::Counter(static_cast<double>(count), benchmark::Counter::kIsIterationInvariantRate);
}

void meshBranches_50k(benchmark::State& state)
{
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(state.range(0)));
    const Brushed& grown = tree50k();
    const Widths widths(grown.tree(), grown.index());
    std::size_t vertices = 0;
    for (auto _ : state)
        vertices = meshBranches(grown.tree(), grown.index(), widths).vertices.size();
    setRate(state, "vertices/s", vertices);
}
BENCHMARK(meshBranches_50k)->ArgName("threads")->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();

void placeLeaves_50k(benchmark::State& state)
{
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(state.range(0)));
    const Brushed& grown = tree50k();
    const Widths widths(grown.tree(), grown.index());
    std::size_t leaves = 0;
    for (auto _ : state)
        leaves = placeLeaves(grown.tree(), grown.index(), widths).size();
    setRate(state, "leaves/s", leaves);
}
BENCHMARK(placeLeaves_50k)->ArgName("threads")->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();

void expandLeaves_50k(benchmark::State& state)
{
    const MeshBuffer<LeafInstance> leaves =
        placeLeaves(tree50k().tree(), tree50k().index(), Widths(tree50k().tree(), tree50k().index()));
    for (auto _ : state)
        benchmark::DoNotOptimize(expandLeaves(leaves));
    setRate(state, "leaves/s", leaves.size());
}
BENCHMARK(expandLeaves_50k)->Unit(benchmark::kMillisecond)->UseRealTime();

void meshPool_rebuild50k(benchmark::State& state)
{
    MeshPool pool;
    for (auto _ : state)
        pool.rebuild(tree50k().tree(), tree50k().index());
}
BENCHMARK(meshPool_rebuild50k)->Unit(benchmark::kMillisecond)->UseRealTime();

/// One step of the brush on a tree of so many internodes.
void meshPool_brushStep(benchmark::State& state)
{
    Brushed grown(static_cast<std::uint32_t>(state.range(0)));
    MeshPool pool;
    pool.rebuild(grown.tree(), grown.index());
    pool.takeChanges();
    double born = 0.0;
    double sent = 0.0;
    for (auto _ : state) {
        state.PauseTiming();
        const TreeDelta& delta = grown.step();
        born += delta.born.count;
        state.ResumeTiming();
        pool.follow(grown.tree(), grown.index(), delta);
        pool.finish(grown.tree(), grown.index());
        const MeshPool::Changes changes = pool.takeChanges();
        state.PauseTiming();
        for (const MeshPool::Range& range : changes.vertices)
            sent += sizeof(MeshVertex) * (range.end - range.begin);
        state.ResumeTiming();
    }
    state.counters["born"] = benchmark::Counter(born, benchmark::Counter::kAvgIterations);
    state.counters["vertexBytes"] = benchmark::Counter(sent, benchmark::Counter::kAvgIterations);
}
BENCHMARK(meshPool_brushStep)
    ->Arg(5'000)
    ->Arg(20'000)
    ->Arg(50'000)
    ->Iterations(100)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void meshPool_settle50k(benchmark::State& state)
{
    MeshPool pool;
    pool.rebuild(tree50k().tree(), tree50k().index());
    for (auto _ : state)
        benchmark::DoNotOptimize(pool.settle(tree50k().tree(), tree50k().index()));
}
BENCHMARK(meshPool_settle50k)->Unit(benchmark::kMillisecond)->UseRealTime();

void barkAlbedo_1024(benchmark::State& state)
{
    for (auto _ : state)
        benchmark::DoNotOptimize(barkAlbedo(static_cast<BarkKind>(state.range(0)), 1024));
}
BENCHMARK(barkAlbedo_1024)
    ->ArgName("kind")
    ->DenseRange(0, kBarkKindCount - 1)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void barkTextures_1024(benchmark::State& state)
{
    for (auto _ : state)
        benchmark::DoNotOptimize(barkTextures(static_cast<BarkKind>(state.range(0)), 1024));
}
BENCHMARK(barkTextures_1024)
    ->ArgName("kind")
    ->DenseRange(0, kBarkKindCount - 1)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void leafAlbedo_512(benchmark::State& state)
{
    for (auto _ : state)
        benchmark::DoNotOptimize(leafAlbedo(static_cast<LeafShape>(state.range(0)), 512));
}
BENCHMARK(leafAlbedo_512)
    ->ArgName("shape")
    ->DenseRange(0, kLeafShapeCount - 1)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

} // namespace
