// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/sketch/BranchPropagation.h"
#include "tests/support/TreeBuilder.h"

#include <benchmark/benchmark.h>

namespace espalier {

namespace {

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

} // namespace

} // namespace espalier
