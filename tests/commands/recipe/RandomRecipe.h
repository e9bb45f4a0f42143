// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Random.h"
#include "model/io/ParametersJson.h"
#include "model/strands/ProfileShapes.h"
#include "tests/support/AllOperations.h"

namespace espalier::test {

/// A random recipe among all that parseRecipe can return.
inline Recipe randomRecipe(std::uint64_t seed)
{
    Random random(seed, 0, 0, Purpose::Direction);
    const auto randomParameters = [&] {
        TreeParameters parameters;
        visitParameters(parameters, [&](const ParameterInfo& info, auto& field) {
            using Field = std::remove_reference_t<decltype(field)>;
            const double value = random.uniform(info.minimum, info.maximum);
            if constexpr (std::is_same_v<Field, double>)
                field = info.quantity == Quantity::Angle ? radians(value) : value;
            else
                field = static_cast<Field>(static_cast<int>(std::lround(value)));
        });
        GrowthParameters& growth = parameters.growth;
        growth.ellipseOffset =
            std::clamp(growth.ellipseOffset, -0.9 * growth.ellipseVertical, growth.ellipseVertical / 2);
        normaliseDirectionWeights(growth);
        return parameters;
    };
    Recipe result;
    result.name = QStringLiteral("Ginkgo “%1” \\ \n").arg(seed);
    result.description = QStringLiteral("täglich \"gegossen\"");
    result.seed = random.bits();
    result.parameters = randomParameters();
    result.camera.view = QStringLiteral("three-quarter");
    for (int i = 0; i < 20; ++i) {
        BrushStrokeOperation stroke;
        for (double time = 0.0; time < 3.0; time += 0.01 + random.uniform()) {
            stroke.samples.push_back(
                {time, 100.0F * random.inBall(), static_cast<float>(random.uniform() * random.uniform())});
        }
        result.operations.emplace_back(stroke);
        stroke.end = i % 3 == 0 ? StrokeEnd::Arrives : StrokeEnd::AtRelease;
        stroke.until = i % 4 == 0 ? std::optional(stroke.samples.back().time - 0.001) : std::nullopt;
        if (i % 5 == 0)
            stroke.placement = {.around = random.inBall(), .copies = 2 + i % 3, .isSpread = i % 2 == 0};
        result.operations.emplace_back(stroke);
        result.operations.emplace_back(SetParametersOperation{randomParameters()});
        if (i % 3 == 0)
            stroke.only = {static_cast<InternodeId>(random.bits() % 1000), i % kMaxLaterals};
        result.operations.emplace_back(GrowOperation{i + 1, stroke.only});
        result.operations.emplace_back(PruneOperation{{7U, static_cast<InternodeId>(random.bits() % 1000)}});
        result.operations.emplace_back(TravelOperation{i - 50});
        result.operations.emplace_back(
            InvigorateOperation{static_cast<InternodeId>(i), random.uniform(0.0, kMostHeldSeconds)});
        result.operations.emplace_back(ReduceOperation{InternodeReference(InternodeKey(i), {}), 0.1 * i});
        result.operations.emplace_back(UndoOperation{i + 2});
        result.operations.emplace_back(RedoOperation{i + 3});
        BendOperation bend{.base = static_cast<InternodeId>(i),
                           .handles = {},
                           .bending = random.uniform(0.01, 100.0),
                           .stretching = random.uniform(0.01, 100.0)};
        for (int handle = 0; handle <= i; ++handle) {
            bend.handles.push_back(
                {static_cast<InternodeId>(i + 7 * handle), random.uniform(), 10.0F * random.inBall()});
        }
        result.operations.emplace_back(bend);
        for (int move = 0; move < i; ++move) {
            std::vector<Vec3> targets(bend.handles.size());
            for (Vec3& target : targets)
                target = 10.0F * random.inBall();
            bend.moves.push_back({targets, move % 3 == 0 ? std::nullopt : std::optional(move)});
        }
        bend.regrips = {{static_cast<InternodeId>(i + 1), bend.handles, bend.moves}, {7U, bend.handles}};
        result.operations.emplace_back(bend);
        result.operations.emplace_back(
            SetWidthOperation{0xffff'fffe - static_cast<InternodeId>(i), random.uniform(0.0, 100.0)});
        result.operations.emplace_back(SetWidthOperation{7U, 0.1F, InternodeReference(InternodeKey(i), {})});
        const StrandProfile profile = profileOf(static_cast<ProfileShape>(i % kProfileShapeCount));
        result.operations.emplace_back(SetProfileOperation{{7U, static_cast<InternodeId>(i)}, profile});
        result.operations.emplace_back(
            SetProfileOperation{{InternodeReference(InternodeKey(i), {})}, profile, 3U, profile});
        result.operations.emplace_back(SetProfileOperation{{5U}});
        LassoOperation lasso;
        lasso.only = stroke.only;
        lasso.stroke.origin = 100.0F * random.inBall();
        lasso.stroke.right = random.direction();
        lasso.stroke.up = anyPerpendicular(lasso.stroke.right);
        for (int j = 0; j < 3 + i; ++j)
            lasso.stroke.points.push_back(10.0F * random.inBall().head<2>());
        result.operations.emplace_back(lasso);
        result.operations.emplace_back(FillEnvelopesOperation{{}, {}, lasso.only, i});
        result.operations.emplace_back(
            FillEnvelopesOperation{std::vector(2, lasso.stroke), randomParameters(), lasso.only, {}});
        lasso.steps = i;
        result.operations.emplace_back(lasso);
        result.operations.emplace_back(RegrowOperation{});
        result.operations.emplace_back(RemoveLassoOperation{});
        result.operations.emplace_back(TwistOperation{static_cast<InternodeId>(i),
                                                      random.uniform(-180.0, 180.0),
                                                      i % 2 == 0 ? TwistScope::Branch : TwistScope::Subtree});
        result.operations.emplace_back(AddBudsOperation{.internode = static_cast<InternodeId>(i),
                                                        .count = 1 + i % 8,
                                                        .spacing = random.uniform(),
                                                        .along = random.uniform(),
                                                        .azimuth = random.uniform(-360.0, 360.0)});
        result.operations.emplace_back(
            PlaceLeafOperation{.internode = static_cast<InternodeId>(i),
                               .along = static_cast<float>(random.uniform()),
                               .rotation = Rotation(Eigen::AngleAxisf(2.0F, random.direction())),
                               .length = static_cast<float>(random.uniform(0.001, 1.0)),
                               .kind = static_cast<LeafKind>(i % 3)});
        result.operations.emplace_back(
            ArrangeOperation{.engine = kLeafEngines[static_cast<std::size_t>(i) % kLeafEngines.size()],
                             .internode = InternodeReference(InternodeKey(i), {}),
                             .along = static_cast<float>(random.uniform())});
        result.operations.emplace_back(
            MoveBranchOperation{.internode = static_cast<InternodeId>(i),
                                .onto = InternodeReference(InternodeKey(i), {}),
                                .along = static_cast<float>(random.uniform()),
                                .rotation = Rotation(Eigen::AngleAxisf(2.0F, random.direction())),
                                .scale = i % 2 == 0 ? 1.0 : random.uniform(0.1, 9.0)});
        result.operations.emplace_back(
            KeepClearOperation{static_cast<InternodeId>(i), static_cast<float>(random.uniform(0.0, 9.0))});
        SweptTwigs twigs{.sweeps = {}, .thickest = random.uniform()};
        twigs.depth = i % 2 == 0 ? SweepDepth::All : SweepDepth::NearSide;
        for (int j = 0; j <= i % 3; ++j)
            twigs.sweeps.push_back(
                {10.0F * random.inBall(),
                 std::vector(static_cast<std::size_t>(1 + j),
                             SweepPoint{random.inBall(), static_cast<float>(random.uniform())})});
        result.operations.emplace_back(EraseOperation{twigs});
        result.operations.emplace_back(ThinOperation{twigs, random.uniform()});
        ImportOperation import;
        for (int j = 0; j <= i; ++j)
            import.skeleton.push_back({j == 0 ? kNoInternode : static_cast<std::uint32_t>(j - 1),
                                       100.0F * random.inBall(), 100.0F * random.inBall(),
                                       static_cast<float>(random.uniform())});
        result.operations.emplace_back(import);
        SketchOperation sketch;
        sketch.sketch.depth = {.seed = random.bits(),
                               .secondTree = i % 2 == 0,
                               .sideways = static_cast<DepthOptions::Sideways>(i % 3)};
        for (int j = 0; j <= i; ++j)
            sketch.sketch.strokes.emplace_back(1 + j, Vec2(10.0F * random.inBall().head<2>()));
        result.operations.emplace_back(sketch);
        InferOperation infer{.options = sketch.sketch.depth};
        infer.options.hullMagnification = random.uniform(0.5, 3.0);
        infer.options.angleMagnification = random.uniform(0.5, 3.0);
        result.operations.emplace_back(infer);
        SketchStrokeOperation branch;
        branch.stroke.origin = random.inBall();
        for (int j = 0; j <= i + 1; ++j)
            branch.stroke.points.emplace_back(random.inBall().head<2>());
        branch.mirror = i % 2 == 0;
        if (i % 3 == 0) {
            branch.on = static_cast<InternodeId>(i);
            branch.along = static_cast<float>(random.uniform());
            branch.radii = {static_cast<float>(random.uniform()), 0.01F};
        } else if (i % 3 == 1) {
            branch.replaces = static_cast<InternodeId>(i);
        }
        result.operations.emplace_back(branch);
        result.operations.emplace_back(
            MultiplyOperation{static_cast<InternodeId>(i), 1 + 50 * i, random.bits()});
        PropagateOperation propagate{.internode = InternodeReference(InternodeKey(i), {}),
                                     .targets = static_cast<Propagation::Targets>(i % 3),
                                     .axes = {},
                                     .scaling = i % 2 == 0,
                                     .replaces = i % 4 < 2};
        for (int j = 0; j <= i && propagate.targets == Propagation::Targets::Listed; ++j)
            propagate.axes.emplace_back(static_cast<InternodeId>(j));
        result.operations.emplace_back(propagate);
        result.operations.emplace_back(
            ReproduceOperation{{.trunk = sketch.sketch.strokes.front(),
                                .silhouette = sketch.sketch.strokes.back(),
                                .azimuth = i % 2 == 0 ? 0.0 : random.uniform(-180.0, 180.0)}});
        result.operations.emplace_back(
            VaryOperation{random.bits(), random.uniform(VaryOperation::kLeastAmount, 1.0)});
    }
    return result;
}

} // namespace espalier::test
