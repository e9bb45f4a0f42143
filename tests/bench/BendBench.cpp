// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/shape/ChainBend.h"

#include <benchmark/benchmark.h>

#include <array>
#include <cmath>

namespace {

using namespace espalier;
using Eigen::AngleAxisd;
using Eigen::Quaterniond;
using Eigen::Vector3d;

ChainPose branch(std::size_t count)
{
    ChainPose pose;
    pose.nodes.push_back(Vector3d::Zero());
    Quaterniond rotation = Quaterniond::Identity();
    const double step = 1.0 / static_cast<double>(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double s = static_cast<double>(i) * step;
        rotation = rotation * AngleAxisd(0.9 * step * std::cos(3.0 * s), Vector3d::UnitZ()) *
                   AngleAxisd(0.5 * step, Vector3d::UnitX());
        pose.rotations.push_back(rotation.normalized());
        pose.nodes.push_back(pose.nodes.back() + step * (rotation * Vector3d::UnitY()));
    }
    return pose;
}

/// The tip goes around in a wide loop once in 4 s at 60 calls a second, with or without a second hand that
/// holds the middle.
void chainBend_drag(benchmark::State& state)
{
    const auto count = static_cast<std::uint32_t>(state.range(0));
    const ChainPose rest = branch(count);
    const std::array<ChainHandle, 2> handles{{{count - 1, 1.0}, {count / 2, 0.5}}};
    const auto held = static_cast<std::size_t>(state.range(1));
    ChainBend bend(rest, std::span(handles).first(held));
    std::array<Vector3d, 2> targets{rest.nodes.back(),
                                    0.5 * (rest.nodes[count / 2] + rest.nodes[count / 2 + 1])};
    double steps = 0.0;
    int call = 0;
    for (auto _ : state) {
        const double s = 0.0262 * ++call;
        targets[0] = rest.nodes.back() +
                     Vector3d(0.4 * std::sin(s), -0.2 * (1.0 - std::cos(s)), 0.15 * std::sin(2.0 * s));
        benchmark::DoNotOptimize(bend.solve(std::span(targets).first(held)));
        steps += static_cast<double>(bend.descents().size());
    }
    state.counters["steps"] = benchmark::Counter(steps, benchmark::Counter::kAvgIterations);
    state.counters["solves/s"] =
        benchmark::Counter(static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}
BENCHMARK(chainBend_drag)
    ->ArgNames({"internodes", "handles"})
    ->Args({40, 1})
    ->Args({200, 1})
    ->Args({200, 2})
    ->Args({1000, 1})
    ->Unit(benchmark::kMillisecond);

/// Calls that use up all their steps: far out of reach, to another side each time.
void chainBend_worst(benchmark::State& state)
{
    ChainBend bend = [] {
        const ChainHandle tip{199, 1.0};
        return ChainBend(branch(200), std::span(&tip, 1));
    }();
    int call = 0;
    for (auto _ : state) {
        const double s = 2.4 * ++call;
        const Vector3d target(10.0 * std::sin(s), 10.0 * std::cos(s), 3.0 * std::cos(2.0 * s));
        benchmark::DoNotOptimize(bend.solve(std::span(&target, 1)));
    }
}
BENCHMARK(chainBend_worst)->Unit(benchmark::kMillisecond);

} // namespace
