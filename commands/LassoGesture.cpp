// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/LassoGesture.h"

#include "commands/EnvelopeGrowth.h"
#include "commands/RecordedEdit.h"
#include "commands/recipe/FillEnvelopesOperation.h"
#include "commands/recipe/LassoJson.h"
#include "commands/recipe/LassoOperation.h"
#include "commands/recipe/RemoveLassoOperation.h"
#include "model/envelope/LassoLoop.h"

#include <QCoreApplication>

#include <algorithm>

namespace espalier {

namespace {

struct LassoGestureText {
    Q_DECLARE_TR_FUNCTIONS(Lasso)
};

/// Position of the journal's first delta that put an envelope in force that is still in force.
std::size_t firstFilling(const TreeDocument& document)
{
    const std::vector<std::uint32_t>& inForce = document.tree().lassoIndicesInForce();
    const auto brings = [&](const std::shared_ptr<TreeDelta>& delta) {
        return std::ranges::any_of(delta->lassos, [&](const TreeDelta::LassoChange& change) {
            return change.isInForce && std::ranges::binary_search(inForce, change.index);
        });
    };
    return static_cast<std::size_t>(std::ranges::find_if(document.journal(), brings) -
                                    document.journal().begin());
}

} // namespace

LassoGesture::Begun LassoGesture::fill(TreeDocument& document, const LassoStroke& stroke,
                                       Competitors competitors)
{
    document.interruptEdit();
    const LassoStroke drawn = recordableLasso(stroke);
    LassoStroke kept = drawn;
    kept.points = simplified(drawn.points);
    kept = recordableLasso(std::move(kept));
    if (!isLasso(kept))
        return Error{Error::Kind::Input, LassoGestureText::tr("The lasso's drawing plane is not valid.")};
    std::vector<LassoStroke> strokes = document.tree().lassosInForce();
    // Beside other envelopes, the new one must enclose something by itself; otherwise it would have no
    // effect.
    if (!strokes.empty()) {
        if (const Result<Envelope> alone = Envelope::fromStrokes(std::span(&kept, 1)); !alone)
            return alone.error();
    }
    if (!document.tree().hasRoomForLassos(1))
        return Error{Error::Kind::Input, LassoGestureText::tr("There is no room for more lassos.")};
    strokes.push_back(kept);
    Result<EnvelopeSet> envelopes = EnvelopeSet::fromStrokes(strokes);
    if (!envelopes)
        return envelopes.error();

    const auto bringIn = [&kept](Edit& edit) {
        const Tree& tree = edit.document().tree();
        TreeDelta delta = deltaStartingAt(tree);
        delta.lassos.push_back({keepLasso(delta, tree, kept), true});
        edit.apply(std::move(delta));
    };
    const auto operation = [drawn, only = BudReference::to(document, competitors)](std::optional<int> steps) {
        return LassoOperation{drawn, only, steps};
    };
    return std::unique_ptr<LassoGesture>(new LassoGesture(
        document, LassoGestureText::tr("Lasso"), std::move(*envelopes), competitors, operation, bringIn));
}

LassoGesture::Begun LassoGesture::fillAll(TreeDocument& document, const std::vector<LassoStroke>& strokes,
                                          const TreeParameters& parameters, Competitors competitors)
{
    document.interruptEdit();
    if (!std::ranges::all_of(strokes, isLasso))
        return Error{Error::Kind::Input, LassoGestureText::tr("The lasso's drawing plane is not valid.")};
    if (!document.tree().hasRoomForLassos(strokes.size()))
        return Error{Error::Kind::Input, LassoGestureText::tr("There is no room for more lassos.")};
    if (!document.tree().hasRoomFor(parameters))
        return Error{Error::Kind::Input, LassoGestureText::tr("There is no room for more parameter sets.")};
    return fillAll(document, LassoGestureText::tr("Lasso"), strokes, parameters, competitors, [](Edit&) {});
}

LassoGesture::Begun LassoGesture::fillAll(TreeDocument& document, const QString& text,
                                          const std::vector<LassoStroke>& strokes,
                                          const TreeParameters& parameters, Competitors competitors,
                                          const std::function<void(Edit&)>& goBack)
{
    Result<EnvelopeSet> envelopes = EnvelopeSet::fromStrokes(strokes);
    if (!envelopes)
        return envelopes.error();
    const auto bringIn = [&](Edit& edit) {
        goBack(edit);
        const Tree& tree = edit.document().tree();
        TreeDelta delta = deltaStartingAt(tree);
        delta.parametersAfter = keepParameters(delta, tree, parameters);
        std::vector<LassoStroke> wanted = strokes;
        for (const std::uint32_t index : tree.lassoIndicesInForce()) {
            const auto same = std::ranges::find(wanted, tree.lassos()[index]);
            if (same == wanted.end())
                delta.lassos.push_back({index, false});
            else
                wanted.erase(same);
        }
        for (const LassoStroke& stroke : wanted)
            delta.lassos.push_back({keepLasso(delta, tree, stroke), true});
        edit.apply(std::move(delta));
    };
    const auto operation = [strokes, parameters,
                            only = BudReference::to(document, competitors)](std::optional<int> steps) {
        return FillEnvelopesOperation{strokes, parameters, only, steps};
    };
    return std::unique_ptr<LassoGesture>(
        new LassoGesture(document, text, std::move(*envelopes), competitors, operation, bringIn));
}

LassoGesture::Begun LassoGesture::regrow(TreeDocument& document)
{
    document.interruptEdit();
    if (document.tree().lassoIndicesInForce().empty())
        return Error{Error::Kind::Input, LassoGestureText::tr("There is no envelope to regrow.")};
    // The strokes and the parameters in force, which the replaced deltas brought in, are put in force again.
    const TreeParameters parameters = document.parameters();
    return fillAll(document, LassoGestureText::tr("Regrow"), document.tree().lassosInForce(), parameters, {},
                   [from = firstFilling(document)](Edit& edit) { edit.replaceFrom(from); });
}

LassoGesture::Begun LassoGesture::goOn(TreeDocument& document, Competitors competitors)
{
    document.interruptEdit();
    if (document.tree().lassoIndicesInForce().empty())
        return Error{Error::Kind::Input, LassoGestureText::tr("There is no envelope to fill.")};
    Result<EnvelopeSet> envelopes = EnvelopeSet::fromStrokes(document.tree().lassosInForce());
    if (!envelopes)
        return envelopes.error();
    const auto operation = [only = BudReference::to(document, competitors)](std::optional<int> steps) {
        return FillEnvelopesOperation{{}, {}, only, steps};
    };
    return std::unique_ptr<LassoGesture>(new LassoGesture(document, LassoGestureText::tr("Lasso"),
                                                          std::move(*envelopes), competitors, operation));
}

LassoGesture::LassoGesture(TreeDocument& document, const QString& text, EnvelopeSet envelopes,
                           Competitors competitors, OperationOfSteps operation,
                           const std::function<void(Edit&)>& prepare)
    : GrowthGesture(document, text, prepare), m_operation(std::move(operation))
{
    setProcess(std::make_unique<EnvelopeGrowth>(std::move(envelopes), document.tree(), competitors));
}

RecipeOperation LassoGesture::operation() const
{
    return m_operation(isExhausted() ? std::nullopt : std::optional(static_cast<int>(stepCount())));
}

bool removeEnvelopes(TreeDocument& document)
{
    Edit edit(document);
    TreeDelta delta = deltaStartingAt(document.tree());
    for (const std::uint32_t index : document.tree().lassoIndicesInForce())
        delta.lassos.push_back({index, false});
    edit.apply(std::move(delta));
    const bool removes = edit.hasChanges();
    commitRecorded(edit, LassoGestureText::tr("Remove Envelope"), [] { return RemoveLassoOperation{}; });
    return removes;
}

} // namespace espalier
