// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/shape/Widths.h"
#include "tests/support/TreeBuilder.h"
#include "views/render/MeshPool.h"

#include <benchmark/benchmark.h>

namespace {

using namespace espalier;

test::TreeBuilder& tree100k()
{
    static test::TreeBuilder tree = test::randomTree(100'000, 3);
    return tree;
}

/// @p count constraints spread over the tree's older branches.
std::vector<WidthConstraint> constraints(std::uint32_t count)
{
    const test::TreeBuilder& grown = tree100k();
    const Widths widths(grown.tree, grown.index);
    std::vector<WidthConstraint> found;
    for (InternodeId id = 1; id < grown.tree.size() && found.size() < count; ++id) {
        if (id % 7 == 0 && grown.index.tipCount(id) > 20)
            found.push_back({id, 2.5F * widths.radius(grown.index, id)});
    }
    return found;
}

void widths_100k(benchmark::State& state)
{
    const test::TreeBuilder& grown = tree100k();
    const auto given = constraints(static_cast<std::uint32_t>(state.range(0)));
    for (auto _ : state) {
        const Widths widths(grown.tree, grown.index, given);
        benchmark::DoNotOptimize(widths.radius(grown.index, 0));
    }
    state.counters["constraints"] = static_cast<double>(given.size());
}
BENCHMARK(widths_100k)->Arg(0)->Arg(1)->Arg(5)->Arg(100)->Unit(benchmark::kMillisecond);

/// A drag of the last of five constraints: widths, comparison and what must be meshed.
void meshPool_widthDrag100k(benchmark::State& state)
{
    test::TreeBuilder& grown = tree100k();
    const auto given = constraints(5);
    const auto set = [&](const WidthConstraint& constraint) {
        TreeDelta delta = deltaStartingAt(grown.tree);
        delta.sparse.width.push_back(
            {constraint.id, grown.tree.content().sparse.width.at(constraint.id), constraint.value});
        return &grown.apply(std::move(delta));
    };
    for (const WidthConstraint& constraint : given)
        set(constraint);
    MeshPool pool;
    pool.rebuild(grown.tree, grown.index);
    pool.takeChanges();
    int call = 0;
    for (auto _ : state) {
        const float factor = 1.0F + 0.05F * static_cast<float>(++call % 10);
        pool.follow(grown.tree, grown.index, *set({given.back().id, given.back().value * factor}));
        pool.finish(grown.tree, grown.index);
        benchmark::DoNotOptimize(pool.takeChanges());
    }
}
BENCHMARK(meshPool_widthDrag100k)->Unit(benchmark::kMillisecond)->UseRealTime();

} // namespace
