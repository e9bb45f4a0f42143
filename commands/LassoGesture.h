// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/GrowthGesture.h"
#include "model/envelope/EnvelopeSet.h"

#include <functional>
#include <memory>
#include <optional>

namespace espalier {

/// Growth into envelopes drawn by lassos. A new envelope and the growth into it are one undo step.
class LassoGesture : public GrowthGesture {
public:
    using Begun = Result<std::unique_ptr<LassoGesture>>;

    /// Adds the envelope of @p stroke and starts to fill all envelopes in force. The stroke need not be
    /// simplified; its ends are joined. An Error, and no change, if it encloses nothing.
    static Begun fill(TreeDocument& document, const LassoStroke& stroke, Competitors competitors = {});
    /// Puts the envelopes of @p strokes, which are simplified, in force in place of the present ones, and
    /// @p parameters as well, and starts to fill the envelopes. An Error, and no change, if they enclose
    /// nothing, or if the document has no room for another parameter set.
    static Begun fillAll(TreeDocument& document, const std::vector<LassoStroke>& strokes,
                         const TreeParameters& parameters, Competitors competitors = {});
    /// Takes the tree back to the state before the first of the envelopes in force was drawn, and starts to
    /// fill all of them with the parameters in force. All later changes of the tree are removed, too. An
    /// Error, and no change, if there is no envelope.
    static Begun regrow(TreeDocument& document);

    /// Continues to fill the envelopes in force, with the parameters in force. An Error, and no change, if
    /// there is no envelope.
    static Begun goOn(TreeDocument& document, Competitors competitors = {});

private:
    /// Makes the operation for a number of steps, or, without one, for growth to its end.
    using OperationOfSteps = std::function<RecipeOperation(std::optional<int> steps)>;

    LassoGesture(TreeDocument& document, const QString& text, EnvelopeSet envelopes, Competitors competitors,
                 OperationOfSteps operation, const std::function<void(Edit&)>& prepare = {});
    static Begun fillAll(TreeDocument& document, const QString& text, const std::vector<LassoStroke>& strokes,
                         const TreeParameters& parameters, Competitors competitors,
                         const std::function<void(Edit&)>& goBack);
    RecipeOperation operation() const override;

    OperationOfSteps m_operation;
};

/// Puts the envelopes out of force, as one undo step; the tree stays as it is. False if there are none.
bool removeEnvelopes(TreeDocument& document);

} // namespace espalier
