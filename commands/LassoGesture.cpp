// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/LassoGesture.h"

#include "commands/EnvelopeGrowth.h"
#include "model/envelope/LassoLoop.h"

#include <QCoreApplication>

#include <algorithm>

namespace espalier {

namespace {

struct LassoText {
    Q_DECLARE_TR_FUNCTIONS(Lasso)
};

/// The journal's first delta that brought an envelope in that is in force still.
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
    LassoStroke kept = stroke;
    kept.points = simplified(stroke.points);
    if (!isLasso(kept))
        return Error{Error::Kind::Input, LassoText::tr("The lasso's drawing plane is not valid.")};
    std::vector<LassoStroke> strokes = document.tree().lassosInForce();
    // Among others it must enclose something by itself, or it would be kept for nothing.
    if (!strokes.empty()) {
        if (const Result<Envelope> alone = Envelope::fromStrokes(std::span(&kept, 1)); !alone)
            return alone.error();
    }
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
    return std::unique_ptr<LassoGesture>(
        new LassoGesture(document, LassoText::tr("Lasso"), std::move(*envelopes), competitors, bringIn));
}

LassoGesture::Begun LassoGesture::regrow(TreeDocument& document)
{
    document.interruptEdit();
    const std::vector<std::uint32_t> wanted = document.tree().lassoIndicesInForce();
    if (wanted.empty())
        return Error{Error::Kind::Input, LassoText::tr("There is no envelope to regrow.")};
    const std::vector<LassoStroke> strokes = document.tree().lassosInForce();
    Result<EnvelopeSet> envelopes = EnvelopeSet::fromStrokes(strokes);
    if (!envelopes)
        return envelopes.error();

    const auto goBack = [&, parameters = document.parameters()](Edit& edit) {
        edit.replaceFrom(firstFilling(document));
        const Tree& tree = document.tree();
        TreeDelta delta = deltaStartingAt(tree);
        delta.parametersAfter = keepParameters(delta, tree, parameters);
        const std::vector<std::uint32_t>& standing = tree.lassoIndicesInForce();
        for (const std::uint32_t index : standing) {
            if (!std::ranges::binary_search(wanted, index))
                delta.lassos.push_back({index, false});
        }
        for (std::size_t i = 0; i < wanted.size(); ++i) {
            // Those that went with the journal's end come again.
            if (wanted[i] >= tree.lassos().size())
                delta.lassos.push_back({keepLasso(delta, tree, strokes[i]), true});
            else if (!std::ranges::binary_search(standing, wanted[i]))
                delta.lassos.push_back({wanted[i], true});
        }
        edit.apply(std::move(delta));
    };
    return std::unique_ptr<LassoGesture>(
        new LassoGesture(document, LassoText::tr("Regrow"), std::move(*envelopes), {}, goBack));
}

LassoGesture::Begun LassoGesture::goOn(TreeDocument& document, Competitors competitors)
{
    document.interruptEdit();
    if (document.tree().lassoIndicesInForce().empty())
        return Error{Error::Kind::Input, LassoText::tr("There is no envelope to fill.")};
    Result<EnvelopeSet> envelopes = EnvelopeSet::fromStrokes(document.tree().lassosInForce());
    if (!envelopes)
        return envelopes.error();
    return std::unique_ptr<LassoGesture>(
        new LassoGesture(document, LassoText::tr("Lasso"), std::move(*envelopes), competitors, {}));
}

LassoGesture::LassoGesture(TreeDocument& document, const QString& text, EnvelopeSet envelopes,
                           Competitors competitors, const std::function<void(Edit&)>& prepare)
    : GrowthGesture(document, text, prepare)
{
    setProcess(std::make_unique<EnvelopeGrowth>(std::move(envelopes), document.tree(), competitors));
}

bool removeEnvelopes(TreeDocument& document)
{
    Edit edit(document);
    TreeDelta delta = deltaStartingAt(document.tree());
    for (const std::uint32_t index : document.tree().lassoIndicesInForce())
        delta.lassos.push_back({index, false});
    edit.apply(std::move(delta));
    const bool removes = edit.hasChanges();
    edit.commit(LassoText::tr("Remove Envelope"));
    return removes;
}

} // namespace espalier
