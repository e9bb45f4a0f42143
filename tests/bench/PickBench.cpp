// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/shape/Widths.h"
#include "tests/bench/Crowns.h"
#include "views/tools/BudPicker.h"

#include <benchmark/benchmark.h>

#include <array>

namespace espalier {

namespace {

using namespace test;

constexpr std::array kDevices{PointerDevice::Finger, PointerDevice::Pen, PointerDevice::Mouse};
constexpr std::array kDeviceNames{"finger", "pen", "mouse"};
constexpr double kPixelsPerMillimetre = 96.0 / 25.4;
constexpr QSizeF kView(1600.0, 1000.0);

/// Distance of the camera.
enum View { WholeTree, Twigs };
constexpr std::array kViewNames{"whole tree", "twigs"};

Camera cameraFor(const TreeDocument& document, View view)
{
    Box3 box;
    InternodeId highest = 0;
    for (InternodeId id = 0; id < document.tree().size(); ++id) {
        if (!document.tree().isAlive(id))
            continue;
        const Vec3& position = document.index().nodePosition(id);
        box.extend(position);
        if (position.y() > document.index().nodePosition(highest).y())
            highest = id;
    }
    Camera camera;
    camera.setViewSize(kView);
    camera.setTarget(view == WholeTree ? Vec3(box.center()) : document.index().nodePosition(highest));
    camera.setDistance(view == WholeTree ? 1.5F * box.sizes().maxCoeff() : 2.0F);
    return camera;
}

/// A pointer that goes over the whole view, line by line; the arguments are internodes, device and view.
template <class Pick>
void pointAll(benchmark::State& state, Pick&& pick)
{
    const TreeDocument& document = crown(static_cast<std::uint32_t>(state.range(0)));
    const Widths widths(document.tree(), document.index());
    // The viewport takes the radii from its mesh.
    std::vector<float> radii;
    for (InternodeId id = 0; id < document.tree().size(); ++id)
        radii.push_back(document.tree().isAlive(id) ? widths.radius(document.index(), id) : 0.0F);
    const std::function<float(InternodeId)> radius = [&](InternodeId id) { return radii[id]; };
    const auto view = static_cast<View>(state.range(2));
    const Camera camera = cameraFor(document, view);
    const PickScene scene{document.tree(), document.index(), document.pickIndex(), radius, radii[0], camera};
    const double reach =
        pickReach(kDevices.at(static_cast<std::size_t>(state.range(1))), kPixelsPerMillimetre);

    std::vector<double> samples;
    std::vector<double> hits;
    for (auto _ : state) {
        constexpr int kColumns = 24;
        constexpr int kRows = 15;
        const int at = static_cast<int>(samples.size()) % (kColumns * kRows);
        const QPointF pointer(kView.width() * (at % kColumns + 0.5) / kColumns,
                              kView.height() * (at / kColumns + 0.5) / kRows);
        const double before = cpuTime();
        const bool isHit = pick(scene, pointer, reach);
        samples.push_back(cpuTime() - before);
        if (isHit)
            hits.push_back(samples.back());
    }
    state.SetLabel(std::string(kDeviceNames.at(static_cast<std::size_t>(state.range(1)))) + ", " +
                   kViewNames.at(static_cast<std::size_t>(view)));
    state.counters["internodes"] = document.index().livingCount();
    state.counters["hits"] = static_cast<double>(hits.size()) / static_cast<double>(samples.size());
    state.counters["hit_median_ms"] = 1000.0 * median(hits);
    state.counters["worst_ms"] = 1000.0 * worst(samples);
}

void pickBranchOfACrown(benchmark::State& state)
{
    pointAll(state, [](const PickScene& scene, const QPointF& pointer, double reach) {
        return pickBranch(scene, pointer, reach).has_value();
    });
}

void pickBudsOfACrown(benchmark::State& state)
{
    pointAll(state, [](const PickScene& scene, const QPointF& pointer, double reach) {
        return !pickBuds(scene, pointer, reach).empty();
    });
}

BENCHMARK(pickBranchOfACrown)
    ->ArgsProduct({{500'000}, {0, 1}, {WholeTree, Twigs}})
    ->ArgNames({"internodes", "device", "view"})
    ->Iterations(360)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(pickBudsOfACrown)
    ->ArgsProduct({{500'000}, {0, 1}, {WholeTree, Twigs}})
    ->ArgNames({"internodes", "device", "view"})
    ->Iterations(360)
    ->Unit(benchmark::kMillisecond);

} // namespace

} // namespace espalier
