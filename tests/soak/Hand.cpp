// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/soak/Hand.h"

#include "commands/AddBuds.h"
#include "commands/BendGesture.h"
#include "commands/BrushGesture.h"
#include "commands/DrawSketch.h"
#include "commands/EraseTwigs.h"
#include "commands/GrowGesture.h"
#include "commands/ImportSkeleton.h"
#include "commands/InferDepth.h"
#include "commands/InvigorateGesture.h"
#include "commands/KeepClear.h"
#include "commands/LassoGesture.h"
#include "commands/MoveBranch.h"
#include "commands/MultiplyBranch.h"
#include "commands/ParameterGesture.h"
#include "commands/PlaceLeaves.h"
#include "commands/ProfileEdits.h"
#include "commands/PropagateBranch.h"
#include "commands/Prune.h"
#include "commands/ReduceGesture.h"
#include "commands/ReproduceTree.h"
#include "commands/SetParameters.h"
#include "commands/SketchStroke.h"
#include "commands/TimeGesture.h"
#include "commands/TwistGesture.h"
#include "commands/VaryTree.h"
#include "commands/WidthGesture.h"
#include "tests/support/AllOperations.h"

#include <algorithm>
#include <limits>

namespace espalier::test {

namespace {

void finish(LassoGesture::Begun begun, int mostSteps = std::numeric_limits<int>::max())
{
    if (!begun)
        return;
    for (int step = 0; step < mostSteps && (*begun)->step(); ++step) {
    }
    (*begun)->finish();
}

class Hand {
public:
    Hand(TreeDocument& document, RandomOperations& random) : m_document(document), m_random(random) {}

    void operator()(const SetParametersOperation& operation)
    {
        // A slider's step stays a separate step; a recipe's step joins the travel before it.
        if (!m_document.future().empty() || operation.parameters == m_document.parameters()) {
            setParameters(m_document, operation.parameters);
            return;
        }
        ParameterGesture gesture(m_document);
        for (int i = m_random.below(3); i > 0; --i)
            gesture.tryOut(m_random.parameters(), QStringLiteral("Soak"));
        gesture.tryOut(operation.parameters, QStringLiteral("Soak"));
        gesture.finish();
    }

    void operator()(const BrushStrokeOperation& operation)
    {
        const std::vector<BrushSample>& samples = operation.samples;
        BrushGesture gesture(m_document, samples.front(), operation.only.resolve(m_document).competitors,
                             operation.end, operation.placement);
        for (std::size_t i = 1; i < samples.size(); ++i) {
            if (m_random.onceIn(8))
                gesture.moveToward(samples[i], 0.5 * (samples[i - 1].time + samples[i].time));
            gesture.add(samples[i]);
        }
        gesture.finish();
    }

    void operator()(const GrowOperation& operation)
    {
        GrowGesture gesture(m_document, operation.only.resolve(m_document).competitors);
        for (int i = 0; i < operation.steps && gesture.step(); ++i) {
        }
        gesture.finish();
    }

    void operator()(const PruneOperation& operation)
    {
        std::vector<InternodeId> cuts;
        for (const InternodeReference& internode : operation.internodes)
            cuts.push_back(internode.number());
        pruneBranches(m_document, cuts);
    }

    void operator()(const InvigorateOperation& operation)
    {
        hold<InvigorateGesture>(operation.internode, operation.seconds);
    }

    void operator()(const ReduceOperation& operation)
    {
        hold<ReduceGesture>(operation.internode, operation.seconds);
    }

    void operator()(const TravelOperation& operation)
    {
        TimeGesture gesture(m_document);
        const auto here = static_cast<std::int64_t>(m_document.journal().size());
        const auto end = static_cast<std::int64_t>(gesture.historyLength());
        const auto moveTo = [&](std::int64_t position) {
            gesture.moveTo(static_cast<std::size_t>(std::clamp(position, std::int64_t{0}, end)));
        };
        for (int i = m_random.below(4); i > 0; --i)
            moveTo(here + m_random.below(21) - 10);
        moveTo(here + operation.by);
        gesture.finish();
    }

    void operator()(const UndoOperation& operation)
    {
        for (int i = 0; i < operation.count; ++i)
            m_document.undoStack().undo();
    }

    void operator()(const RedoOperation& operation)
    {
        for (int i = 0; i < operation.count; ++i)
            m_document.undoStack().redo();
    }

    void operator()(const BendOperation& operation)
    {
        std::vector<BranchBend::Handle> handles;
        std::vector<Vec3> targets;
        for (const BendOperation::Handle& handle : operation.handles) {
            handles.push_back({handle.internode.number(), handle.along});
            targets.push_back(handle.target);
        }
        BendGesture gesture(m_document, operation.base.number(), std::move(handles),
                            {.stretching = operation.stretching, .bending = operation.bending});
        for (int call = 0; call < BendGesture::kMostPulls && !gesture.moveTo(targets); ++call) {
        }
        gesture.finish();
    }

    void operator()(const SetWidthOperation& operation)
    {
        WidthGesture gesture(m_document, operation.internode.number());
        for (int i = m_random.below(3); i > 0; --i)
            gesture.set(static_cast<InternodeId>(m_random.below(static_cast<int>(m_document.tree().size()))),
                        0.01 * m_random.below(50));
        gesture.set(operation.diameter);
        gesture.finish();
    }

    void operator()(const SetProfileOperation& operation)
    {
        std::vector<InternodeId> ids;
        for (const InternodeReference& internode : operation.internodes)
            ids.push_back(internode.number());
        if (operation.to && operation.toProfile) {
            blendProfiles(m_document, ids.front(), operation.to->number(), *operation.profile,
                          *operation.toProfile);
            return;
        }
        if (operation.to)
            ids = branchBetween(m_document.tree(), ids.front(), operation.to->number());
        if (operation.profile)
            setProfile(m_document, ids, *operation.profile);
        else
            clearProfiles(m_document, ids);
    }

    void operator()(const LassoOperation& operation)
    {
        finish(
            LassoGesture::fill(m_document, operation.stroke, operation.only.resolve(m_document).competitors));
    }

    void operator()(const RegrowOperation&) { finish(LassoGesture::regrow(m_document)); }

    void operator()(const FillEnvelopesOperation& operation)
    {
        const Competitors competitors = operation.only.resolve(m_document).competitors;
        finish(operation.envelopes ? LassoGesture::fillAll(m_document, *operation.envelopes,
                                                           operation.parameters, competitors)
                                   : LassoGesture::goOn(m_document, competitors),
               *operation.steps);
    }

    void operator()(const ImportOperation& operation)
    {
        // Refused unless the tree is a seedling.
        (void)importSkeleton(m_document, operation.skeleton);
    }

    void operator()(const SketchOperation& operation)
    {
        // Refused unless the tree is a seedling.
        (void)drawSketch(m_document, operation.sketch);
    }

    void operator()(const SketchStrokeOperation& operation)
    {
        BranchStroke stroke{.stroke = operation.stroke, .base = {}, .radii = operation.radii};
        stroke.isMirrored = operation.mirror;
        if (operation.on) {
            // A hand begins on a branch that is there.
            const InternodeId base = operation.on->number();
            if (base >= m_document.tree().size() || !m_document.tree().isAlive(base))
                return;
            stroke.base = BranchPlace{base, operation.along};
        }
        // Refused if a stroke has hardly any length.
        (void)sketchBranch(m_document, stroke);
    }

    void operator()(const InferOperation& operation)
    {
        // Refused unless the tree is flat.
        DepthTrial trial(m_document);
        if (m_random.onceIn(2))
            (void)trial.tryOut({});
        (void)trial.tryOut(operation.options);
    }

    void operator()(const TwistOperation& operation)
    {
        TwistGesture gesture(m_document, operation.internode.number(), operation.scope);
        for (int i = m_random.below(3); i > 0; --i)
            gesture.set(m_random.below(361) - 180);
        gesture.set(operation.angle);
        gesture.finish();
    }

    void operator()(const AddBudsOperation& operation)
    {
        addBuds(m_document, operation.spiralAt(operation.internode.number()));
    }

    void operator()(const PlaceLeafOperation& operation)
    {
        placeLeaf(m_document, operation.leafAt(operation.internode.number()));
    }

    void operator()(const ArrangeOperation& operation)
    {
        arrangeLeaves(m_document, operation.engine, {operation.internode.number(), operation.along});
    }

    void operator()(const MoveBranchOperation& operation)
    {
        MoveGesture gesture(m_document);
        const BranchMove move{.branch = operation.internode.number(),
                              .place = {operation.onto.number(), operation.along},
                              .rotation = operation.rotation,
                              .scale = operation.scale};
        if (m_random.onceIn(3)) {
            BranchMove onTheWay = move;
            onTheWay.place.along *= 0.5F;
            (void)gesture.set(onTheWay);
        }
        (void)gesture.set(move);
        gesture.finish();
    }

    void operator()(const KeepClearOperation& operation)
    {
        keepClear(m_document, operation.internode.number(), operation.length);
    }

    void operator()(const EraseOperation& operation) { eraseTwigs(m_document, operation); }

    void operator()(const ThinOperation& operation) { thinTwigs(m_document, operation); }

    void operator()(const MultiplyOperation& operation)
    {
        (void)multiplyBranch(m_document, operation.internode.number(), operation.seed, operation.count);
    }

    void operator()(const PropagateOperation& operation)
    {
        Propagation propagation{.reference = operation.internode.number(),
                                .targets = operation.targets,
                                .axes = {},
                                .scaling = operation.scaling,
                                .replaces = operation.replaces};
        for (const InternodeReference& axis : operation.axes)
            propagation.axes.push_back(axis.number());
        (void)propagateBranch(m_document, propagation);
    }

    void operator()(const ReproduceOperation& operation)
    {
        (void)reproduceTree(m_document, operation.figure);
    }

    void operator()(const VaryOperation& operation)
    {
        (void)varyTree(m_document, operation.seed, operation.amount);
    }

    void operator()(const RemoveLassoOperation&) { removeEnvelopes(m_document); }

    /// Performs the operation if it is of this kind.
    template <class Data>
    bool does(const RecipeOperation& operation)
    {
        const Data* data = operation.as<Data>();
        if (data)
            (*this)(*data);
        return data != nullptr;
    }

private:
    template <class Gesture>
    void hold(const InternodeReference& internode, double seconds)
    {
        const Result<InternodeId> branch = internode.resolve(m_document);
        if (!branch)
            return;
        Gesture gesture(m_document, *branch);
        if (m_random.onceIn(3))
            gesture.holdTo(0.5 * seconds);
        gesture.holdTo(seconds);
        gesture.finish();
    }

    TreeDocument& m_document;
    RandomOperations& m_random;
};

template <class... Kinds>
bool doesAny(Hand hand, const RecipeOperation& operation)
{
    return (hand.does<Kinds>(operation) || ...);
}

} // namespace

void doByHand(TreeDocument& document, const RecipeOperation& operation, RandomOperations& random)
{
    const bool isDone =
        doesAny<SetParametersOperation, BrushStrokeOperation, GrowOperation, PruneOperation, TravelOperation,
                UndoOperation, RedoOperation, BendOperation, SetWidthOperation, LassoOperation,
                SetProfileOperation, RegrowOperation, RemoveLassoOperation, FillEnvelopesOperation,
                ImportOperation, InvigorateOperation, ReduceOperation, TwistOperation, AddBudsOperation,
                SketchOperation, SketchStrokeOperation, InferOperation, PlaceLeafOperation, ArrangeOperation,
                MultiplyOperation, PropagateOperation, ReproduceOperation, VaryOperation, MoveBranchOperation,
                KeepClearOperation, EraseOperation, ThinOperation>(Hand(document, random), operation);
    if (!isDone)
        qFatal("the soak test does not know how to do “%s” by hand", operation.name().data());
}

} // namespace espalier::test
