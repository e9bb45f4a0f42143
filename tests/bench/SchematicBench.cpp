// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/architecture/TropismDiagram.h"

#include <QImage>
#include <QPainter>

#include <benchmark/benchmark.h>
#include <tbb/global_control.h>

namespace espalier {

namespace {

/// One frame while a handle of the panel of architecture moves: the schematic tree is grown and drawn, on one
/// core, at twice the usual number of pixels. By the degrees of θ.
void schematicFrame(benchmark::State& state)
{
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
    QImage image(360, 300, QImage::Format_ARGB32_Premultiplied);
    image.setDevicePixelRatio(2.0);
    GrowthParameters growth;
    std::uint32_t internodes = 0;
    int theta = static_cast<int>(state.range(0));
    for (auto _ : state) {
        growth.setPointAngle = radians(theta);
        theta ^= 1;
        const Schematic schematic = growSchematic(growth);
        image.fill(Qt::transparent);
        QPainter painter(&image);
        painter.setRenderHint(QPainter::Antialiasing);
        drawSchematic(painter, schematic, QRectF(0.0, 0.0, 180.0, 150.0));
        internodes = schematic.index.livingCount();
    }
    state.counters["internodes"] = internodes;
}

/// The slowest parameters: buds that see far and wide, many markers, deep shadows.
void schematicFrame_laborious(benchmark::State& state)
{
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
    GrowthParameters growth;
    growth.occupancyRadius = 0.5;
    growth.perceptionDepth = 10.0;
    growth.perceptionAngle = radians(360);
    growth.markersPerBud = 32;
    growth.shadowDepth = 16;
    for (auto _ : state)
        benchmark::DoNotOptimize(growSchematic(growth).tree.size());
}

BENCHMARK(schematicFrame)
    ->Arg(0)
    ->Arg(38)
    ->Arg(90)
    ->Arg(178)
    ->ArgName("theta")
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(schematicFrame_laborious)->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);

} // namespace

} // namespace espalier
