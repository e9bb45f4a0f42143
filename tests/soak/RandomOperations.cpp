// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/soak/RandomOperations.h"

#include "commands/recipe/RecipeLimits.h"
#include "model/io/ParametersJson.h"
#include "model/strands/ProfileShapes.h"
#include "tests/support/Growing.h"

#include <algorithm>
#include <bit>
#include <numeric>

namespace espalier::test {

RandomOperations::RandomOperations(std::uint64_t seed, std::uint32_t most)
    : m_random(seed, 0, 0, Purpose::ShootLength), m_most(most)
{
    for (const QString& name : operationNames()) {
        if (std::ranges::none_of(kinds(), [&](const Kind& kind) { return name == kind.name; }))
            qFatal("the soak test never does “%s”", qPrintable(name));
    }
}

int RandomOperations::below(int count)
{
    return static_cast<int>(m_random.bits() % static_cast<std::uint64_t>(count));
}

TreeParameters RandomOperations::parameters()
{
    TreeParameters parameters = randomParameters(m_random);
    parameters.growth.phyllotaxis = radians(m_random.uniform(0.0, 360.0)); // files have degrees
    parameters.widths.exponent = m_random.uniform(1.5, 4.0);
    parameters.widths.baseDiameter = onceIn(3) ? m_random.uniform(0.01, 1.0) : 0.0;
    parameters.leaves.visible = !onceIn(3);
    parameters.leaves.shape = static_cast<LeafShape>(below(kLeafShapeCount));
    parameters.leaves.arrangement = static_cast<LeafArrangement>(below(kLeafArrangementCount));
    parameters.leaves.length = m_random.uniform(0.02, 0.3);
    parameters.bark.kind = static_cast<BarkKind>(below(kBarkKindCount));
    parameters.growth.model = onceIn(2) ? GrowthModelKind::Vigour : GrowthModelKind::TreeSketch;
    parameters.vigour.growthRate = m_random.uniform(0.2, 1.0);
    parameters.vigour.internodeLength = m_random.uniform(0.05, 0.2);
    parameters.vigour.lateralBuds = 1 + below(4);
    parameters.vigour.apicalControl = m_random.uniform(0.7, 1.6);
    parameters.vigour.apicalDominance = m_random.uniform(0.0, 3.0);
    parameters.vigour.gravitropism = m_random.uniform(-0.1, 0.1);
    parameters.vigour.horizontalTropism = onceIn(2) ? m_random.uniform(0.0, 0.5) : 0.0;
    parameters.vigour.bending = onceIn(2) ? m_random.uniform(0.0, 20.0) : 0.0;
    parameters.vigour.lightPruning = onceIn(2) ? m_random.uniform(0.0, 0.7) : 0.0;
    normaliseDirectionWeights(parameters.growth);
    return parameters;
}

float RandomOperations::internode(const TreeDocument& document) const
{
    return static_cast<float>(document.parameters().growth.internodeLength);
}

InternodeId RandomOperations::living(const TreeDocument& document)
{
    const Tree& tree = document.tree();
    for (;;) {
        const auto id = static_cast<InternodeId>(m_random.bits() % tree.size());
        if (tree.isAlive(id))
            return id;
        if (!onceIn(64)) // most rows may be dead internodes
            continue;
        const TreeIndex& index = document.index();
        InternodeId at = 0;
        while (index.mainChild(at) != kNoInternode && !onceIn(20))
            at = index.mainChild(at);
        return at;
    }
}

/// Usually a living internode, otherwise a dead, undone or nonexistent one.
InternodeId RandomOperations::any(const TreeDocument& document)
{
    if (onceIn(100))
        return static_cast<InternodeId>(InternodeReference::kGreatestNumber);
    if (onceIn(20))
        return static_cast<InternodeId>(m_random.bits() % (document.tree().size() + 3));
    return living(document);
}

/// An internode that carries about a third of the tree or less.
InternodeId RandomOperations::large(const TreeDocument& document)
{
    const TreeIndex& index = document.index();
    InternodeId id = 0;
    while (index.subtreeSize(id) > index.livingCount() / 3) {
        InternodeId largest = kNoInternode;
        for (InternodeId child = index.firstChild(id); child != kNoInternode;
             child = index.nextSibling(child)) {
            if (largest == kNoInternode || index.subtreeSize(child) > index.subtreeSize(largest))
                largest = child;
        }
        if (largest == kNoInternode)
            break;
        id = largest;
    }
    return id;
}

BudReference RandomOperations::only(const TreeDocument& document)
{
    if (!onceIn(5))
        return {};
    const InternodeId node = any(document);
    const BudMask buds = node < document.tree().size() ? document.tree().buds(node) : BudMask{0};
    const auto anySlot = [&] {
        const int slot = below(kMaxLaterals + 1);
        return slot == kMaxLaterals ? kTerminalSlot : slot;
    };
    int slot = anySlot();
    while (buds != 0 && (buds & budBit(slot)) == 0 && !onceIn(100)) // also a bud that does not exist
        slot = anySlot();
    return {node, slot};
}

template <>
SetParametersOperation RandomOperations::make(const TreeDocument& document, int)
{
    if (onceIn(12)) // nothing new
        return {document.parameters()};
    const auto& sets = document.tree().parameterSets();
    if (onceIn(6))
        return {sets[below(static_cast<int>(sets.size()))]};
    TreeParameters parameters = this->parameters();
    if (!onceIn(4)) // a slider changes one parameter only
        parameters.growth = document.parameters().growth;
    if (onceIn(2))
        parameters.growth.apicalDominance = m_random.uniform();
    return {parameters};
}

template <>
BrushStrokeOperation RandomOperations::make(const TreeDocument& document, int)
{
    const float l = internode(document);
    BrushStrokeOperation operation;
    operation.end = onceIn(2) ? StrokeEnd::Arrives : StrokeEnd::AtRelease;
    operation.samples = randomStroke(m_random, document.parameters().growth, onceIn(6) ? 1.2 : 0.5);
    // A place near the living tree.
    const Vec3 there = document.index().nodePosition(living(document)) + 3.0F * l * m_random.inBall() -
                       operation.samples.front().position;
    const int every = onceIn(3) ? 1 + below(20) : 1;
    const float turn = onceIn(3) ? static_cast<float>(m_random.uniform(0.0, 3.0)) : 1.0F;
    std::vector<BrushSample> kept;
    for (std::size_t i = 0; i < operation.samples.size(); i += static_cast<std::size_t>(every)) {
        BrushSample sample = operation.samples[i];
        sample.position += there;
        // The pressure of a pen changes on the way.
        sample.radius *= i % 2 == 0 ? 1.0F : turn;
        sample.position = sample.position.cwiseMax(-1000.0F).cwiseMin(1000.0F);
        kept.push_back(sample);
    }
    operation.samples = std::move(kept);
    operation.only = only(document);
    if (onceIn(8)) {
        const Vec3 around = document.index().nodePosition(living(document));
        operation.placement = {.around = around.cwiseMax(-1000.0F).cwiseMin(1000.0F),
                               .copies = 1 + below(3),
                               .isSpread = onceIn(2)};
    }
    return operation;
}

template <>
GrowOperation RandomOperations::make(const TreeDocument& document, int)
{
    const bool isSmall = document.index().livingCount() < m_most / 4;
    return {isSmall ? 1 + below(6) : 1 + below(2), only(document)};
}

template <>
PruneOperation RandomOperations::make(const TreeDocument& document, int)
{
    PruneOperation operation;
    if (document.index().livingCount() > m_most) {
        operation.internodes = {large(document), large(document)};
        return operation;
    }
    const int count = onceIn(4) ? 1 + below(8) : 1;
    for (int i = 0; i < count; ++i)
        operation.internodes.push_back(any(document));
    return operation;
}

template <>
InvigorateOperation RandomOperations::make(const TreeDocument& document, int)
{
    return {any(document), 0.1 * below(8)};
}

template <>
ReduceOperation RandomOperations::make(const TreeDocument& document, int)
{
    return {any(document), 0.1 * below(12)};
}

template <>
TravelOperation RandomOperations::make(const TreeDocument& document, int)
{
    if (onceIn(30))
        return {onceIn(2) ? TravelOperation::kFarthest : -TravelOperation::kFarthest};
    const int far = onceIn(10) ? 200 : 12;
    const int by = 1 + below(far);
    // If there is a future, the slider often moves toward it.
    const bool isForward = document.future().empty() ? onceIn(10) : !onceIn(3);
    return {isForward ? by : -by};
}

template <>
UndoOperation RandomOperations::make(const TreeDocument&, int undoable)
{
    const int count = onceIn(40) ? 1 + below(60) : onceIn(4) ? 1 + below(8) : 1;
    return {std::clamp(count, 1, undoable)};
}

template <>
RedoOperation RandomOperations::make(const TreeDocument&, int)
{
    return {onceIn(10) ? 1 + below(60) : 1 + below(3)};
}

template <>
BendOperation RandomOperations::make(const TreeDocument& document, int)
{
    const TreeIndex& index = document.index();
    const float l = internode(document);
    BendOperation operation;
    operation.base = any(document);
    const InternodeId base = operation.base.number() < document.tree().size() ? operation.base.number() : 0;
    InternodeId at = base;
    const bool isAbsurd = onceIn(12);
    const int handles = onceIn(3) ? 1 + below(4) : 1;
    for (int i = 0; i < handles; ++i) {
        for (int up = 1 + below(12); up > 0; --up) {
            InternodeId next = index.firstChild(at);
            while (next != kNoInternode && index.nextSibling(next) != kNoInternode && onceIn(2))
                next = index.nextSibling(next);
            if (next == kNoInternode)
                break;
            at = next;
        }
        BendOperation::Handle handle;
        handle.internode = onceIn(25) ? any(document) : at;
        handle.along = onceIn(3) ? m_random.uniform() : 1.0;
        const float reach = onceIn(3) ? 20.0F * l : 4.0F * l;
        handle.target = index.nodePosition(at) + reach * m_random.inBall();
        if (isAbsurd) {
            constexpr auto kFar = static_cast<float>(recipeLimits::kCoordinate);
            switch (below(5)) {
            case 0:
                handle.target = kFar * m_random.direction();
                break;
            case 1:
                handle.target = Vec3::Constant(-kFar);
                break;
            case 2:
                handle.target = index.basePosition(document.tree(), base);
                break;
            case 3:
                handle.target = 100.0F * l * m_random.direction();
                break;
            default:
                handle.target = Vec3::Zero();
            }
        }
        handle.target = handle.target.cwiseMax(-1000.0F).cwiseMin(1000.0F);
        operation.handles.push_back(handle);
    }
    if (onceIn(5)) {
        operation.bending = std::pow(10.0, m_random.uniform(-2.0, 2.0));
        operation.stretching = std::pow(10.0, m_random.uniform(-2.0, 2.0));
    }
    return operation;
}

template <>
SetWidthOperation RandomOperations::make(const TreeDocument& document, int)
{
    SetWidthOperation operation{any(document), m_random.uniform(0.001, 0.4)};
    const auto constraints = document.tree().widthConstraints();
    if (!constraints.empty() && onceIn(3))
        operation.internode =
            constraints[static_cast<std::size_t>(below(static_cast<int>(constraints.size())))].id;
    if (onceIn(4))
        operation.diameter = 0.0;
    else if (onceIn(8))
        operation.diameter = onceIn(2) ? kGreatestDiameter : 1e-9;
    return operation;
}

template <>
SetProfileOperation RandomOperations::make(const TreeDocument& document, int)
{
    const auto profile = [this] {
        StrandProfile made = profileOf(static_cast<ProfileShape>(below(kProfileShapeCount)));
        if (onceIn(3)) {
            const Vec2 from = 2.0F * m_random.inBall().head<2>();
            made.attractors.push_back({from, 2.0F * m_random.inBall().head<2>()});
        }
        return made;
    };
    SetProfileOperation operation{{any(document)}};
    if (!onceIn(4))
        operation.profile = profile();
    if (onceIn(3)) {
        // Another node on the way to the root, if there is one.
        InternodeId end = living(document);
        operation.internodes = {end};
        for (int i = below(30); i > 0 && !document.tree().isRoot(end); --i)
            end = document.tree().parent(end);
        operation.to = end;
        if (operation.profile && onceIn(2))
            operation.toProfile = profile();
    } else {
        for (int i = below(4); i > 0; --i)
            operation.internodes.push_back(any(document));
    }
    return operation;
}

/// A closed stroke around the plane's origin, or a degenerate one.
std::vector<Vec2> RandomOperations::loop(float radius)
{
    std::vector<Vec2> points;
    const int count = 3 + below(60);
    const int kind = onceIn(4) ? below(7) : 7;
    const double bulges = 2.0 + below(4);
    for (int i = 0; i < count; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / count;
        const double r = 1.0 + 0.3 * std::cos(bulges * angle);
        Vec2 point(static_cast<float>(r * std::cos(angle)), static_cast<float>(r * std::sin(angle)));
        switch (kind) {
        case 0: // a single place
            point = Vec2::Zero();
            break;
        case 1: // a line
            point = Vec2(point.x(), 0.0F);
            break;
        case 2: // a figure of eight
            point = Vec2(point.x(), static_cast<float>(std::sin(2.0 * angle)));
            break;
        case 3: // a scribble
            point = Vec2(static_cast<float>(m_random.uniform(-1.0, 1.0)),
                         static_cast<float>(m_random.uniform(-1.0, 1.0)));
            break;
        case 4: // a spiral
            point *= static_cast<float>(i) / static_cast<float>(count);
            break;
        case 5: // a sliver
            point.x() *= 0.001F;
            break;
        case 6: // a speck
            point *= 1e-5F;
            break;
        default:
            break;
        }
        points.emplace_back(radius * point);
    }
    return points;
}

template <>
LassoOperation RandomOperations::make(const TreeDocument& document, int)
{
    const float l = internode(document);
    LassoOperation operation;
    LassoStroke& stroke = operation.stroke;
    stroke.origin = document.index().nodePosition(living(document)) + 4.0F * l * m_random.inBall();
    stroke.origin = stroke.origin.cwiseMax(-900.0F).cwiseMin(900.0F);
    const double heading = m_random.uniform(0.0, 2.0 * std::numbers::pi);
    stroke.right = Vec3(static_cast<float>(std::cos(heading)), 0.0F, static_cast<float>(std::sin(heading)));
    stroke.points = loop(l * static_cast<float>(m_random.uniform(1.0, 5.0)));
    operation.only = only(document);
    return operation;
}

template <>
FillEnvelopesOperation RandomOperations::make(const TreeDocument& document, int)
{
    FillEnvelopesOperation operation;
    operation.only = only(document);
    if (onceIn(2)) {
        LassoStroke stroke;
        stroke.origin = Vec3(0.0F, internode(document), 0.0F);
        stroke.points = loop(internode(document) * static_cast<float>(m_random.uniform(1.0, 5.0)));
        operation.envelopes = {std::move(stroke)};
        operation.parameters = parameters();
    }
    operation.steps = below(20);
    return operation;
}

template <>
ImportOperation RandomOperations::make(const TreeDocument& document, int)
{
    ImportOperation operation;
    const float l = internode(document);
    for (int i = below(30); i >= 0; --i) {
        const auto parent =
            static_cast<std::uint32_t>(below(static_cast<int>(operation.skeleton.size()) + 1));
        const bool isFoot = parent == operation.skeleton.size();
        const Vec3 base = isFoot ? 3.0F * l * m_random.inBall() : operation.skeleton[parent].tip;
        operation.skeleton.push_back({isFoot ? kNoInternode : parent, base, base + l * m_random.inBall(),
                                      l * static_cast<float>(m_random.uniform())});
    }
    return operation;
}

DepthOptions RandomOperations::depth()
{
    return {.seed = static_cast<std::uint64_t>(below(1000)),
            .secondTree = !onceIn(3),
            .sideways = static_cast<DepthOptions::Sideways>(below(3))};
}

template <>
SketchStrokeOperation RandomOperations::make(const TreeDocument& document, int)
{
    SketchStrokeOperation operation;
    const float l = internode(document);
    operation.stroke.points = {5.0F * l * m_random.inBall().head<2>()};
    for (int j = 1 + below(8); j > 0; --j)
        operation.stroke.points.emplace_back(operation.stroke.points.back() +
                                             2.0F * l * m_random.inBall().head<2>());
    if (onceIn(2)) {
        operation.on = any(document);
        operation.along = static_cast<float>(m_random.uniform());
    }
    if (onceIn(3))
        operation.radii = {l * static_cast<float>(m_random.uniform()), 0.1F * l};
    operation.mirror = onceIn(3);
    return operation;
}

template <>
InferOperation RandomOperations::make(const TreeDocument&, int)
{
    return {.options = depth()};
}

template <>
SketchOperation RandomOperations::make(const TreeDocument& document, int)
{
    SketchOperation operation;
    TreeSketch& sketch = operation.sketch;
    sketch.depth = depth();
    const float l = internode(document);
    for (int i = below(12); i >= 0; --i) {
        std::vector<Vec2> stroke{5.0F * l * m_random.inBall().head<2>()};
        for (int j = below(8); j > 0; --j)
            stroke.emplace_back(stroke.back() + 2.0F * l * m_random.inBall().head<2>());
        sketch.strokes.push_back(std::move(stroke));
    }
    return operation;
}

template <>
TwistOperation RandomOperations::make(const TreeDocument& document, int)
{
    const double angle =
        onceIn(4) ? 0.0 : m_random.uniform(-TwistOperation::kMostAngle, TwistOperation::kMostAngle);
    return {any(document), angle, onceIn(3) ? TwistScope::Subtree : TwistScope::Branch};
}

template <>
AddBudsOperation RandomOperations::make(const TreeDocument& document, int)
{
    return {.internode = any(document),
            .count = 1 + below(BudSpiral::kMostBuds),
            .spacing = onceIn(5) ? m_random.uniform(0.0, BudSpiral::kGreatestSpacing)
                                 : internode(document) * m_random.uniform(),
            .along = onceIn(4) ? below(2) : m_random.uniform(),
            .azimuth = m_random.uniform(-360.0, 360.0)};
}

template <>
PlaceLeafOperation RandomOperations::make(const TreeDocument& document, int)
{
    // Several leaves on one branch can be arranged.
    const std::uint32_t leaves = document.tree().placedLeaves().size();
    const bool isBesideTheLast = leaves > 0 && !onceIn(3);
    return {
        .internode = isBesideTheLast ? document.tree().placedLeaves().internode[leaves - 1] : any(document),
        .along = onceIn(4) ? static_cast<float>(below(2)) : static_cast<float>(m_random.uniform()),
        .rotation =
            Rotation(Eigen::AngleAxisf(static_cast<float>(m_random.uniform(0.0, 6.0)), m_random.direction())),
        .length = internode(document) * static_cast<float>(m_random.uniform(0.1, 3.0)),
        .kind = onceIn(6) ? LeafKind::Flower : LeafKind::Leaf};
}

template <>
ArrangeOperation RandomOperations::make(const TreeDocument& document, int)
{
    const LeafColumns& leaves = document.tree().placedLeaves();
    const bool isAtALeaf = leaves.size() > 0 && !onceIn(4);
    return {.engine = kLeafEngines[static_cast<std::size_t>(below(static_cast<int>(kLeafEngines.size())))],
            .internode = isAtALeaf ? leaves.internode[below(static_cast<int>(leaves.size()))] : any(document),
            .along = static_cast<float>(m_random.uniform())};
}

template <>
MoveBranchOperation RandomOperations::make(const TreeDocument& document, int)
{
    return {.internode = any(document),
            .onto = any(document),
            .along = static_cast<float>(m_random.uniform()),
            .rotation = Rotation(
                Eigen::AngleAxisf(static_cast<float>(m_random.uniform(0.0, 3.0)), m_random.direction())),
            .scale = onceIn(2) ? 1.0 : m_random.uniform(0.5, 1.5)};
}

template <>
KeepClearOperation RandomOperations::make(const TreeDocument& document, int)
{
    const double length = internode(document) * m_random.uniform(0.0, onceIn(5) ? 60.0 : 12.0);
    return {any(document), onceIn(4) ? 0.0F : static_cast<float>(length)};
}

/// A short stroke before the tree.
SweptTwigs RandomOperations::sweptTwigs(const TreeDocument& document)
{
    SweptTwigs twigs{.sweeps = {}, .thickest = onceIn(4) ? below(2) : m_random.uniform()};
    twigs.depth = onceIn(3) ? SweepDepth::NearSide : SweepDepth::All;
    const float l = internode(document);
    for (int i = onceIn(4) ? 2 : 1; i > 0; --i) {
        Sweep sweep{30.0F * l * m_random.direction(), {}};
        SweepPoint point{document.index().nodePosition(living(document)),
                         l * static_cast<float>(m_random.uniform(0.0, 2.0))};
        for (int j = below(6); j >= 0; --j) {
            point.position = point.position.cwiseMax(-1000.0F).cwiseMin(1000.0F);
            sweep.path.push_back(point);
            point.position += l * m_random.inBall();
        }
        twigs.sweeps.push_back(std::move(sweep));
    }
    return twigs;
}

template <>
EraseOperation RandomOperations::make(const TreeDocument& document, int)
{
    return {sweptTwigs(document)};
}

template <>
ThinOperation RandomOperations::make(const TreeDocument& document, int)
{
    return {sweptTwigs(document), m_random.uniform()};
}

template <>
MultiplyOperation RandomOperations::make(const TreeDocument& document, int)
{
    return {.internode = any(document), .count = 1 + below(3), .seed = static_cast<std::uint64_t>(below(9))};
}

template <>
PropagateOperation RandomOperations::make(const TreeDocument& document, int)
{
    const InternodeId reference = any(document);
    const Tree& tree = document.tree();
    const bool isSmall =
        !tree.isAlive(reference) || document.index().subtreeSize(document.index().axis(reference)) < 12;
    PropagateOperation operation{.internode = reference,
                                 .targets = static_cast<Propagation::Targets>(isSmall ? below(3) : 2),
                                 .axes = {},
                                 .scaling = onceIn(2),
                                 .replaces = onceIn(2)};
    for (int i = below(3); i >= 0 && operation.targets == Propagation::Targets::Listed; --i)
        operation.axes.emplace_back(any(document));
    return operation;
}

template <>
ReproduceOperation RandomOperations::make(const TreeDocument& document, int)
{
    const float l = internode(document);
    ReproduceOperation operation;
    operation.figure.trunk.emplace_back(Vec2::Zero());
    for (int i = below(6); i >= 0; --i)
        operation.figure.trunk.emplace_back(operation.figure.trunk.back() +
                                            5.0F * l * (m_random.inBall() + up()).head<2>());
    for (const Vec2& point : loop(20.0F * l))
        operation.figure.silhouette.emplace_back(point + Vec2(0.0F, 15.0F * l));
    operation.figure.azimuth = m_random.uniform(-180.0, 180.0);
    return operation;
}

template <>
VaryOperation RandomOperations::make(const TreeDocument&, int)
{
    return {.seed = static_cast<std::uint64_t>(below(1000)),
            .amount = m_random.uniform(VaryOperation::kLeastAmount, 1.0)};
}

std::span<const RandomOperations::Kind> RandomOperations::kinds()
{
    static constexpr Kind kKinds[] = {
        kindOf<SetParametersOperation>(16, 4), kindOf<BrushStrokeOperation>(50, 0),
        kindOf<GrowOperation>(18, 0),          kindOf<PruneOperation>(14, 50),
        kindOf<TravelOperation>(18, 14),       kindOf<UndoOperation>(22, 25),
        kindOf<RedoOperation>(14, 0),          kindOf<BendOperation>(18, 4),
        kindOf<SetWidthOperation>(16, 4),      kindOf<LassoOperation>(2, 0),
        kindOf<RegrowOperation>(1, 0),         kindOf<RemoveLassoOperation>(1, 1),
        kindOf<FillEnvelopesOperation>(1, 0),  kindOf<ImportOperation>(1, 1),
        kindOf<InvigorateOperation>(8, 0),     kindOf<ReduceOperation>(8, 14),
        kindOf<TwistOperation>(6, 2),          kindOf<AddBudsOperation>(6, 0),
        kindOf<SetProfileOperation>(6, 2),     kindOf<SketchOperation>(1, 1),
        kindOf<SketchStrokeOperation>(8, 0),   kindOf<InferOperation>(2, 1),
        kindOf<PlaceLeafOperation>(8, 2),      kindOf<ArrangeOperation>(5, 1),
        kindOf<MultiplyOperation>(6, 0),       kindOf<PropagateOperation>(3, 0),
        kindOf<ReproduceOperation>(2, 1),      kindOf<VaryOperation>(3, 1),
        kindOf<MoveBranchOperation>(6, 2),     kindOf<KeepClearOperation>(6, 4),
        kindOf<EraseOperation>(4, 4),          kindOf<ThinOperation>(4, 6),
    };
    return kKinds;
}

RecipeOperation RandomOperations::next(const TreeDocument& document, int undoable)
{
    const bool isCrowded = document.index().livingCount() > m_most;
    std::vector<int> weights;
    for (const Kind& kind : kinds()) {
        int weight = isCrowded ? kind.cuttingBack : kind.growing;
        // Lassos cost more than all other operations.
        if (kind.name == RemoveLassoOperation::kName && document.tree().lassoIndicesInForce().size() > 1)
            weight *= 10;
        if (kind.name == UndoOperation::kName && undoable <= 0)
            weight = 0;
        weights.push_back(weight);
    }
    int draw = below(std::accumulate(weights.begin(), weights.end(), 0));
    std::size_t kind = 0;
    while (draw >= weights[kind])
        draw -= weights[kind++];
    return kinds()[kind].make(*this, document, undoable);
}

} // namespace espalier::test
