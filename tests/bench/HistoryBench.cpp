// SPDX-License-Identifier: GPL-3.0-or-later
// What it costs the thread of the window to shorten the history of a large tree.
#include "commands/GrowGesture.h"
#include "model/document/HistorySnapshot.h"
#include "tests/bench/Crowns.h"

#include <benchmark/benchmark.h>

#include <chrono>
#include <memory>
#include <optional>
#include <vector>

namespace espalier::test {

namespace {

double since(std::chrono::steady_clock::time_point begun)
{
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begun).count();
}

/// The argument: internodes. On the thread of the window are the snapshot and the exchange, ms; the rest is a
/// worker's.
void shortensTheHistory(benchmark::State& state)
{
    std::vector<double> snapshots;
    std::vector<double> exchanges;
    for ([[maybe_unused]] const auto iteration : state) {
        state.PauseTiming();
        TreeDocument document;
        // Each step can be undone.
        while (document.index().livingCount() < state.range(0)) {
            GrowGesture growth(document);
            growth.step();
            growth.finish();
        }
        state.ResumeTiming();
        auto begun = std::chrono::steady_clock::now();
        auto snapshot = std::make_unique<HistorySnapshot>(document);
        snapshots.push_back(since(begun));
        std::optional<ShortenedHistory> shortened = snapshot->shortenedTo(1);
        snapshot.reset();
        begun = std::chrono::steady_clock::now();
        if (!shortened || !document.shorten(*shortened))
            state.SkipWithError("nothing to shorten");
        exchanges.push_back(since(begun));
    }
    state.counters["snapshot, ms"] = worst(snapshots);
    state.counters["exchange, ms"] = worst(exchanges);
}

} // namespace

BENCHMARK(shortensTheHistory)
    ->Arg(50'000)
    ->Arg(500'000)
    ->Unit(benchmark::kMillisecond)
    ->Iterations(2)
    ->UseRealTime();

} // namespace espalier::test
