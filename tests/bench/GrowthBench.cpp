// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/BrushGesture.h"
#include "commands/GrowGesture.h"
#include "commands/InvigorateGesture.h"
#include "model/growth/VigourSpecies.h"
#include "tests/bench/Crowns.h"

#include <benchmark/benchmark.h>
#include <sys/resource.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <chrono>
#include <numeric>

namespace espalier {

namespace {

using namespace test;

/// The edge of the crown as seen from its middle in the direction in which the stroke adds to it.
Vec3 edgeOf(const TreeDocument& document, const Vec3& direction)
{
    Box3 box;
    for (InternodeId id = 0; id < document.tree().size(); ++id) {
        if (document.tree().isAlive(id))
            box.extend(document.index().nodePosition(id));
    }
    // The farthest node within a narrow cone: outliers elsewhere do not matter.
    const Vec3 centre = box.center();
    float farthest = 0.0F;
    for (InternodeId id = 0; id < document.tree().size(); ++id) {
        const Vec3 way = document.index().nodePosition(id) - centre;
        const float along = way.dot(direction);
        if (document.tree().isAlive(id) && along > 0.97F * way.norm())
            farthest = std::max(farthest, along);
    }
    return centre + farthest * direction;
}

/// A stroke of two seconds and as many metres that adds a limb to the crown, a growth step a sample; each
/// step's CPU time goes to
/// @p samples.
void strokeAtEdge(TreeDocument& document, float radius, std::vector<double>& samples)
{
    const Vec3 direction = Vec3(0.8F, 0.6F, 0.0F);
    const Vec3 start = edgeOf(document, direction) - 0.3F * direction;
    BrushGesture gesture(document, {0.0, start, radius});
    for (int step = 1; step <= 40; ++step) {
        const BrushSample sample{step / kBrushStepsPerSecond,
                                 start + static_cast<float>(step) * 0.05F * direction, radius};
        const double before = cpuTime();
        gesture.add(sample);
        samples.push_back(cpuTime() - before);
    }
    gesture.finish();
}

void brushStep(benchmark::State& state)
{
    TreeDocument& document = crown(static_cast<std::uint32_t>(state.range(0)));
    std::vector<double> samples;
    const std::uint32_t before = document.index().livingCount();
    std::uint32_t grown = 0;
    for (auto _ : state) {
        const std::size_t first = samples.size();
        strokeAtEdge(document, static_cast<float>(state.range(1)) / 100.0F, samples);
        double sum = 0.0;
        for (std::size_t i = first; i < samples.size(); ++i)
            sum += samples[i];
        state.SetIterationTime(sum);
        grown = document.index().livingCount() - before;
        document.undoStack().undo();
    }
    state.counters["internodes"] = document.index().livingCount();
    state.counters["grown"] = grown;
    state.counters["stroke_mean_ms"] =
        1000.0 * std::accumulate(samples.begin(), samples.end(), 0.0) / static_cast<double>(samples.size());
    state.counters["step_median_ms"] = 1000.0 * median(samples);
    state.counters["step_worst_ms"] = 1000.0 * worst(samples);
}

void autonomousStep(benchmark::State& state)
{
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(state.range(1)));
    TreeDocument& document = crown(static_cast<std::uint32_t>(state.range(0)));
    std::vector<double> clock;
    std::vector<double> processor;
    std::size_t grown = 0;
    for (auto _ : state) {
        GrowGesture gesture(document);
        const std::uint32_t size = document.tree().size();
        const auto start = std::chrono::steady_clock::now();
        const double before = cpuTime();
        gesture.step();
        processor.push_back(cpuTime() - before);
        clock.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
        state.SetIterationTime(clock.back());
        grown = document.tree().size() - size;
        gesture.cancel();
    }
    state.counters["internodes"] = document.index().livingCount();
    state.counters["grown"] = static_cast<double>(grown);
    state.counters["clock_median_ms"] = 1000.0 * median(clock);
    state.counters["processor_median_ms"] = 1000.0 * median(processor);
}

/// The most memory that the process has had so far, bytes; of use in the first benchmark of a run.
double peakMemory()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

void timeToSize(benchmark::State& state)
{
    std::uint32_t internodes = 0;
    double steps = 0;
    for (auto _ : state) {
        TreeDocument document;
        growTo(document, static_cast<std::uint32_t>(state.range(0)));
        internodes = document.index().livingCount();
        steps = document.tree().step();
        state.counters["bytes_per_row"] = static_cast<double>(document.bytes()) / document.tree().size();
        state.counters["rows"] = document.tree().size();
        document.growthModel();
        document.pickIndex();
        state.counters["bytes_per_living"] = static_cast<double>(document.bytes()) / internodes;
        state.counters["process_bytes_per_living"] = peakMemory() / internodes;
    }
    state.counters["internodes"] = internodes;
    state.counters["steps"] = steps;
}

void undoAndRedoOfAStroke(benchmark::State& state)
{
    TreeDocument& document = crown(static_cast<std::uint32_t>(state.range(0)));
    std::vector<double> steps;
    strokeAtEdge(document, 0.5F, steps);
    std::vector<double> undos;
    std::vector<double> redos;
    for (auto _ : state) {
        const double start = cpuTime();
        document.undoStack().undo();
        const double middle = cpuTime();
        document.undoStack().redo();
        const double end = cpuTime();
        undos.push_back(middle - start);
        redos.push_back(end - middle);
        state.SetIterationTime(end - start);
    }
    document.undoStack().undo();
    state.counters["undo_median_ms"] = 1000.0 * median(undos);
    state.counters["redo_median_ms"] = 1000.0 * median(redos);
}

/// A hundred months of a species by the vigour model, and a second of invigoration.
void vigourYears(benchmark::State& state)
{
    const VigourSpecies& species = vigourSpecies()[static_cast<std::size_t>(state.range(0))];
    TreeParameters parameters;
    parameters.growth.model = GrowthModelKind::Vigour;
    parameters.vigour = species.parameters;
    std::vector<double> steps;
    double hold = 0.0;
    std::uint32_t internodes = 0;
    for (auto _ : state) {
        TreeDocument document;
        document.reset(3, parameters);
        GrowGesture gesture(document);
        const double start = cpuTime();
        for (int step = 0; step < 100; ++step) {
            const double before = cpuTime();
            gesture.step();
            steps.push_back(cpuTime() - before);
        }
        state.SetIterationTime(cpuTime() - start);
        gesture.finish();
        internodes = document.index().livingCount();
        InvigorateGesture invigoration(document, document.index().firstChild(0));
        const double before = cpuTime();
        invigoration.holdTo(1.0);
        hold = cpuTime() - before;
        invigoration.cancel();
    }
    state.SetLabel(species.name);
    state.counters["internodes"] = internodes;
    state.counters["step_worst_ms"] = 1000.0 * worst(steps);
    state.counters["hold_ms"] = 1000.0 * hold;
}

BENCHMARK(vigourYears)
    ->DenseRange(0, static_cast<int>(vigourSpecies().size()) - 1)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond)
    ->Iterations(2);
BENCHMARK(brushStep)
    ->ArgsProduct({{50'000, 500'000}, {50, 200}})
    ->ArgNames({"internodes", "radius_cm"})
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond)
    ->Iterations(5);
BENCHMARK(autonomousStep)
    ->ArgsProduct({{50'000}, {1, 2}})
    ->ArgNames({"internodes", "threads"})
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond)
    ->Iterations(10);
BENCHMARK(timeToSize)
    ->Arg(20'000)
    ->Arg(200'000)
    ->Arg(3'000'000)
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1);
BENCHMARK(undoAndRedoOfAStroke)->Arg(50'000)->UseManualTime()->Unit(benchmark::kMillisecond)->Iterations(10);

} // namespace

} // namespace espalier
