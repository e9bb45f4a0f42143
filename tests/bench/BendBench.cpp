// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/BendGesture.h"
#include "model/shape/ChainBend.h"
#include "tests/support/TreeBuilder.h"
#include "views/render/MeshPool.h"

#include <benchmark/benchmark.h>

#include <array>
#include <chrono>
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

/// The tip goes around in a wide loop once in 4 s at 60 calls a second, with or without a second handle in
/// the middle.
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

/// One move of a drag that bends a branch of a tree of 50,000 internodes: the form, the tree and its indices,
/// and the mesh. The branch carries about one of @p share of the tips.
void bendGesture_move50k(benchmark::State& state)
{
    test::TreeBuilder grown = test::randomTree(50'000, 3);
    TreeDocument document;
    document.reset(grown.tree, {});
    const Tree& tree = document.tree();
    const TreeIndex& index = document.index();
    InternodeId base = 0;
    while (index.tipCount(base) * state.range(0) > index.tipCount(0)) {
        InternodeId next = kNoInternode;
        for (InternodeId id = index.firstChild(base); id != kNoInternode; id = index.nextSibling(id)) {
            if (next == kNoInternode || index.tipCount(id) > index.tipCount(next))
                next = id;
        }
        if (next == kNoInternode)
            break;
        base = next;
    }
    InternodeId end = base;
    std::size_t longest = 0;
    for (InternodeId id = base; id < tree.size(); ++id) {
        if (!tree.isAlive(id))
            continue;
        if (const std::size_t length = pathBetween(tree, base, id).size(); length > longest) {
            longest = length;
            end = id;
        }
    }
    MeshPool pool;
    pool.rebuild(tree, index);
    pool.takeChanges();
    double meshing = 0.0;
    QObject::connect(&document, &TreeDocument::changed,
                     [&](const TreeChange& change) { pool.follow(tree, index, *change.delta); });
    BendGesture gesture(document, base, {{end}});
    const Vec3 start = gesture.gripPoints().front();
    const float reach = 0.3F * (start - index.nodePosition(base)).norm();
    int call = 0;
    for (auto _ : state) {
        const float s = 0.0262F * static_cast<float>(++call);
        const Vec3 target = start + reach * Vec3(std::sin(s), std::cos(s) - 1.0F, 0.3F * std::sin(2.0F * s));
        gesture.moveTo(std::span(&target, 1));
        const auto before = std::chrono::steady_clock::now();
        pool.finish(tree, index);
        benchmark::DoNotOptimize(pool.takeChanges());
        meshing += std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count();
    }
    state.counters["path"] = static_cast<double>(longest);
    state.counters["carried"] = index.subtreeSize(base);
    state.counters["meshing_ms"] = benchmark::Counter(1e3 * meshing, benchmark::Counter::kAvgIterations);
}
BENCHMARK(bendGesture_move50k)->ArgName("share")->Arg(1)->Arg(20)->Unit(benchmark::kMillisecond);

} // namespace
