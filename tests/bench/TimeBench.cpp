// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/BrushGesture.h"
#include "commands/TimeGesture.h"
#include "model/document/GradualUndo.h"
#include "tests/bench/Crowns.h"
#include "views/render/TreeScene.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>

namespace espalier {

namespace {

using namespace test;

constexpr std::size_t kHistory = 1'000;
constexpr std::uint32_t kInternodes = 100'000;

/// A tree with a long history: strokes of two seconds that wind around its growing crown. Made once.
TreeDocument& brushed()
{
    static TreeDocument document;
    double time = 0.0;
    const auto sample = [&] {
        const double height = std::min(0.3 + time, 4.0 + 2.5 * std::sin(0.26 * time));
        const double reach = std::min(0.1 * time, 3.0 + 2.0 * std::sin(0.42 * time));
        const Vec3 position(static_cast<float>(reach * std::cos(time)), static_cast<float>(height),
                            static_cast<float>(reach * std::sin(time)));
        return BrushSample{time, position, 1.2F};
    };
    while (document.journal().size() < kHistory || document.index().livingCount() < kInternodes) {
        BrushGesture stroke(document, sample());
        for (const double end = time + 2.0; time < end;) {
            time += 0.016;
            stroke.add(sample());
        }
        stroke.finish();
    }
    return document;
}

/// The work of a drag of the time slider, up to the data for the graphics card: to each of @p places in turn,
/// and a picture there.
template <class Place>
void slide(benchmark::State& state, int count, Place&& place)
{
    TreeDocument& document = brushed();
    TreeScene scene(document);
    scene.mesh().takeChanges();
    const auto connection = QObject::connect(&document, &TreeDocument::changed,
                                             [&](const TreeChange& change) { scene.follow(change); });
    const std::size_t history = document.journal().size();
    std::vector<double> samples;
    double pictures = 0.0;
    double sent = 0.0;
    for (auto _ : state) {
        TimeGesture gesture(document);
        const double start = cpuTime();
        for (int i = 0; i < count; ++i) {
            const double before = cpuTime();
            gesture.moveTo(place(i, history));
            const double moved = cpuTime();
            scene.prepare();
            const MeshPool::Changes changes = scene.mesh().takeChanges();
            benchmark::DoNotOptimize(scene.light().takeChanges());
            const double after = cpuTime();
            samples.push_back(after - before);
            pictures += after - moved;
            for (const MeshPool::Range& range : changes.vertices)
                sent += sizeof(MeshVertex) * (range.end - range.begin);
        }
        state.SetIterationTime(cpuTime() - start);
        gesture.cancel();
        scene.prepare();
        scene.mesh().takeChanges();
        scene.light().takeChanges();
    }
    QObject::disconnect(connection);
    const auto steps = static_cast<double>(samples.size());
    state.counters["internodes"] = document.index().livingCount();
    state.counters["history"] = static_cast<double>(history);
    state.counters["median_ms"] = 1000.0 * median(samples);
    state.counters["worst_ms"] = 1000.0 * worst(samples);
    state.counters["picture_ms"] = 1000.0 * pictures / steps;
    state.counters["vertexBytes"] = sent / steps;
}

/// A thousand steps back, one by one, and forth again.
void timeSlider_byOne(benchmark::State& state)
{
    constexpr int kSteps = static_cast<int>(kHistory);
    slide(state, 2 * kSteps, [](int i, std::size_t history) {
        const int back = i < kSteps ? i + 1 : 2 * kSteps - 1 - i;
        return history - static_cast<std::size_t>(back);
    });
}
BENCHMARK(timeSlider_byOne)->UseManualTime()->Iterations(1)->Unit(benchmark::kMillisecond);

/// A fast drag: so many deltas between two pictures.
void timeSlider_byJumps(benchmark::State& state)
{
    const auto stride = static_cast<int>(state.range(0));
    const int steps = static_cast<int>(kHistory) / stride;
    slide(state, 2 * steps, [=](int i, std::size_t history) {
        const int back = i < steps ? i + 1 : 2 * steps - 1 - i;
        return history - static_cast<std::size_t>(back * stride);
    });
}
BENCHMARK(timeSlider_byJumps)
    ->ArgName("deltas")
    ->Arg(10)
    ->Arg(100)
    ->Arg(1000)
    ->UseManualTime()
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);

/// A "Grow" of so many internodes is undone and redone in slices: how long the window waits for one, with all
/// that follows the tree, and how long a single delta takes.
void undoOfGrow(benchmark::State& state)
{
    constexpr std::chrono::milliseconds kSlice(6);
    TreeDocument& document = crown(static_cast<std::uint32_t>(state.range(0)));
    TreeScene scene(document);
    const auto connection = QObject::connect(&document, &TreeDocument::changed,
                                             [&](const TreeChange& change) { scene.follow(change); });
    QUndoStack& stack = document.undoStack();
    std::vector<double> pictures;
    const auto walk = [&](int index, std::chrono::milliseconds slice) {
        std::vector<double> times;
        GradualUndo undo(document, index);
        for (bool isLeft = true; isLeft;) {
            const double before = cpuTime();
            isLeft = undo.advance(slice, slice.count() > 0 ? GradualUndo::kLeastRows : 1);
            const double undone = cpuTime();
            scene.prepareSome();
            times.push_back(undone - before);
            pictures.push_back(cpuTime() - undone);
        }
        for (bool isDone = false; !isDone;) {
            const double before = cpuTime();
            isDone = scene.prepareSome();
            pictures.push_back(cpuTime() - before);
        }
        return times;
    };
    for (auto _ : state) {
        const int end = stack.index();
        const double start = cpuTime();
        std::vector<double> slices = walk(0, kSlice);
        state.counters["undo_worst_ms"] = 1000.0 * worst(slices);
        state.counters["undo_slices"] = static_cast<double>(slices.size());
        state.counters["undo_picture_ms"] = 1000.0 * worst(std::exchange(pictures, {}));
        slices = walk(end, kSlice);
        state.counters["redo_picture_ms"] = 1000.0 * worst(std::exchange(pictures, {}));
        state.counters["redo_worst_ms"] = 1000.0 * worst(slices);
        state.counters["redo_slices"] = static_cast<double>(slices.size());
        state.SetIterationTime(cpuTime() - start);
        state.counters["undo_delta_ms"] = 1000.0 * worst(walk(0, std::chrono::milliseconds(0)));
        state.counters["redo_delta_ms"] = 1000.0 * worst(walk(end, std::chrono::milliseconds(0)));
    }
    QObject::disconnect(connection);
    state.counters["internodes"] = document.index().livingCount();
    state.counters["deltas"] = static_cast<double>(document.journal().size());
}
BENCHMARK(undoOfGrow)
    ->ArgName("internodes")
    ->Arg(20'000)
    ->Arg(100'000)
    ->UseManualTime()
    ->Iterations(3)
    ->Unit(benchmark::kMillisecond);

} // namespace

} // namespace espalier
