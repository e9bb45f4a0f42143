// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/envelope/EnvelopeMesh.h"

#include <benchmark/benchmark.h>

#include <cmath>

namespace {

using namespace espalier;

/// A crown with five bulges, 400 points.
LassoStroke crown()
{
    LassoStroke stroke;
    for (int i = 0; i < 400; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / 400.0;
        const double radius = 3.0 + 0.4 * std::cos(5.0 * angle);
        stroke.points.emplace_back(static_cast<float>(radius * std::cos(angle)),
                                   static_cast<float>(radius * std::sin(angle)));
    }
    return stroke;
}

void strokeToEnvelope(benchmark::State& state)
{
    const std::vector<LassoStroke> strokes{crown()};
    for (auto _ : state) {
        Result<Envelope> envelope =
            Envelope::fromStrokes(strokes, {.resolution = static_cast<int>(state.range(0))});
        benchmark::DoNotOptimize(envelope);
    }
}
BENCHMARK(strokeToEnvelope)->Arg(128)->Arg(256)->Arg(512)->Unit(benchmark::kMillisecond);

void envelopeToMesh(benchmark::State& state)
{
    const Envelope envelope = *Envelope::fromStrokes(std::vector{crown()});
    for (auto _ : state)
        benchmark::DoNotOptimize(envelopeMesh(envelope));
}
BENCHMARK(envelopeToMesh)->Unit(benchmark::kMillisecond);

void envelopeToMarkers(benchmark::State& state)
{
    const Envelope envelope = *Envelope::fromStrokes(std::vector{crown()});
    for (auto _ : state)
        benchmark::DoNotOptimize(envelope.sampleUniform(20000, 1));
}
BENCHMARK(envelopeToMarkers)->Unit(benchmark::kMillisecond);

} // namespace
