// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/GrowthGesture.h"
#include "model/envelope/EnvelopeSet.h"

#include <functional>
#include <memory>
#include <optional>

namespace espalier {

/// Growth into what lassos enclose. A new envelope and what grows into it are one undo step.
class LassoGesture : public GrowthGesture {
public:
    using Begun = Result<std::unique_ptr<LassoGesture>>;

    /// Adds the envelope that @p stroke stands for, and starts to fill all that are in force. The stroke may
    /// be raw; its ends are joined. An Error, and nothing changed, if it encloses nothing.
    static Begun fill(TreeDocument& document, const LassoStroke& stroke, Competitors competitors = {});
    /// Puts the envelopes of @p strokes, which are simplified, in force in place of those that are, and
    /// @p parameters as well, and starts to fill them. An Error, and nothing changed, if they enclose
    /// nothing, or if the document has no room for another parameter set.
    static Begun fillAll(TreeDocument& document, const std::vector<LassoStroke>& strokes,
                         const TreeParameters& parameters, Competitors competitors = {});
    /// Takes the tree back to where it stood before the first of the envelopes in force was drawn, and starts
    /// to fill them all with the parameters that are in force now. What has been done to the tree since goes
    /// too. An Error, and nothing changed, if there is no envelope.
    static Begun regrow(TreeDocument& document);

    /// Goes on filling the envelopes in force, with the parameters that are in force now. An Error, and
    /// nothing changed, if there is no envelope.
    static Begun goOn(TreeDocument& document, Competitors competitors = {});

private:
    /// The operation of so many steps, or of all that there are.
    using OperationOfSteps = std::function<RecipeOperation(std::optional<int> steps)>;

    LassoGesture(TreeDocument& document, const QString& text, EnvelopeSet envelopes, Competitors competitors,
                 OperationOfSteps operation, const std::function<void(Edit&)>& prepare = {});
    static Begun fillAll(TreeDocument& document, const QString& text, const std::vector<LassoStroke>& strokes,
                         const TreeParameters& parameters, Competitors competitors,
                         const std::function<void(Edit&)>& goBack);
    RecipeOperation operation() const override;

    OperationOfSteps m_operation;
};

/// Takes the envelopes in force away, as one undo step; the tree stays as it grew. False if there are none.
bool removeEnvelopes(TreeDocument& document);

} // namespace espalier
