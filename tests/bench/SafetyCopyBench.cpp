// SPDX-License-Identifier: GPL-3.0-or-later
// What a safety copy costs the thread of the window after a command, and what it costs a worker thread.
#include "commands/GrowGesture.h"
#include "commands/HistoryFollower.h"
#include "commands/SetParameters.h"
#include "tests/bench/Crowns.h"

#include <benchmark/benchmark.h>

#include <algorithm>

namespace espalier::test {

namespace {

constexpr std::chrono::microseconds kSlice(2'000); // as Autosave

enum Command { kParameters, kGrowStep };

void perform(TreeDocument& document, Command command, int round)
{
    if (command == kGrowStep) {
        GrowGesture gesture(document);
        gesture.step();
        gesture.finish();
        return;
    }
    TreeParameters parameters = document.parameters();
    parameters.growth.branchingAngle = 0.5 + 0.001 * (round % 100);
    setParameters(document, parameters);
}

/// The longest time that one call takes on the thread of the window, ms; the arguments are internodes and the
/// command.
void collectsAChange(benchmark::State& state)
{
    TreeDocument& document = crown(static_cast<std::uint32_t>(state.range(0)));
    const auto command = static_cast<Command>(state.range(1));
    HistoryFollower follower(document);
    follower.start();
    std::vector<double> longest;
    QSet<QString> images;
    qsizetype bytes = 0;
    int round = 0;
    for ([[maybe_unused]] const auto iteration : state) {
        state.PauseTiming();
        perform(document, command, round++);
        state.ResumeTiming();
        double worstCall = 0.0;
        std::optional<HistoryChange> change;
        while (!change) {
            const auto begun = std::chrono::steady_clock::now();
            change = follower.collect(kSlice);
            const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - begun;
            worstCall = std::max(worstCall, took.count());
        }
        longest.push_back(worstCall);
        state.PauseTiming();
        bytes = packChange(*change, images)->size();
        document.undoStack().undo();
        state.ResumeTiming();
    }
    state.counters["longest call, ms"] = worst(longest);
    state.counters["bytes"] = static_cast<double>(bytes);
    state.SetLabel(command == kGrowStep ? "a growth step" : "parameters");
}

} // namespace

BENCHMARK(collectsAChange)
    ->ArgsProduct({{50'000, 500'000}, {kParameters, kGrowStep}})
    ->Unit(benchmark::kMillisecond)
    ->Iterations(10)
    ->UseRealTime();

} // namespace espalier::test
