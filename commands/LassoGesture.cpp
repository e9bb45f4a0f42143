// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/LassoGesture.h"

#include "commands/DeltaCommand.h"
#include "commands/EnvelopeGrowth.h"
#include "model/envelope/LassoLoop.h"

#include <QCoreApplication>

#include <algorithm>

namespace espalier {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Lasso)
};

std::uint32_t lassoCount(const TreeDocument& document)
{
    return static_cast<std::uint32_t>(document.tree().lassos().strokes.size());
}

/// The journal's first delta that brought an envelope in that is in force still.
std::size_t firstFilling(const TreeDocument& document)
{
    const std::vector<std::uint32_t>& inForce = document.tree().lassos().inForce;
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
    LassoStroke kept = stroke;
    kept.points = simplified(stroke.points);
    if (!isLasso(kept))
        return Error{Error::Kind::Input, Text::tr("The lasso's drawing plane is not valid.")};
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

    const std::uint32_t before = lassoCount(document);
    auto delta = std::make_shared<TreeDelta>(TreeDelta::startingAt(document.tree()));
    delta->lassos.push_back({document.rememberLasso(kept), true});
    document.apply(delta);
    return std::unique_ptr<LassoGesture>(new LassoGesture(document, Text::tr("Lasso"), std::move(*envelopes),
                                                          competitors, {}, {std::move(delta)}, before));
}

LassoGesture::Begun LassoGesture::regrow(TreeDocument& document)
{
    const std::vector<std::uint32_t> wanted = document.tree().lassos().inForce;
    if (wanted.empty())
        return Error{Error::Kind::Input, Text::tr("There is no envelope to regrow.")};
    Result<EnvelopeSet> envelopes = EnvelopeSet::fromStrokes(document.tree().lassosInForce());
    if (!envelopes)
        return envelopes.error();

    const std::uint32_t parameters = document.tree().currentParameterSet();
    const Journal& journal = document.journal();
    Journal replaced(journal.begin() + static_cast<std::ptrdiff_t>(firstFilling(document)), journal.end());
    revertAll(document, replaced);
    auto delta = std::make_shared<TreeDelta>(TreeDelta::startingAt(document.tree()));
    delta->parametersAfter = parameters;
    const std::vector<std::uint32_t>& standing = document.tree().lassos().inForce;
    for (const std::uint32_t index : standing) {
        if (!std::ranges::binary_search(wanted, index))
            delta->lassos.push_back({index, false});
    }
    for (const std::uint32_t index : wanted) {
        if (!std::ranges::binary_search(standing, index))
            delta->lassos.push_back({index, true});
    }
    document.apply(delta);
    return std::unique_ptr<LassoGesture>(new LassoGesture(document, Text::tr("Regrow"), std::move(*envelopes),
                                                          {}, std::move(replaced), {std::move(delta)},
                                                          lassoCount(document)));
}

LassoGesture::Begun LassoGesture::goOn(TreeDocument& document, Competitors competitors)
{
    if (document.tree().lassos().inForce.empty())
        return Error{Error::Kind::Input, Text::tr("There is no envelope to fill.")};
    Result<EnvelopeSet> envelopes = EnvelopeSet::fromStrokes(document.tree().lassosInForce());
    if (!envelopes)
        return envelopes.error();
    return std::unique_ptr<LassoGesture>(new LassoGesture(document, Text::tr("Lasso"), std::move(*envelopes),
                                                          competitors, {}, {}, lassoCount(document)));
}

LassoGesture::LassoGesture(TreeDocument& document, const QString& text, EnvelopeSet envelopes,
                           Competitors competitors, Journal replaced, Journal first,
                           std::uint32_t lassosBefore)
    : GrowthGesture(document, text,
                    std::make_unique<EnvelopeGrowth>(std::move(envelopes), document.tree(), competitors),
                    std::move(replaced), std::move(first), lassosBefore)
{
}

bool removeEnvelopes(TreeDocument& document)
{
    auto delta = std::make_shared<TreeDelta>(TreeDelta::startingAt(document.tree()));
    for (const std::uint32_t index : document.tree().lassos().inForce)
        delta->lassos.push_back({index, false});
    if (delta->lassos.empty())
        return false;
    document.apply(delta);
    document.undoStack().push(new DeltaCommand(document, Text::tr("Remove Envelope"), {std::move(delta)}));
    return true;
}

} // namespace espalier
