// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/Edit.h"

#include <memory>
#include <optional>

namespace espalier {

/// A drag of a slider: parameters are tried out live, and all that one gesture tries is one undo step.
/// Nothing is left hanging between two trials: each leaves a whole command on the undo stack, which the next
/// one replaces, provided that nobody has done or undone anything since.
class ParameterGesture {
public:
    explicit ParameterGesture(TreeDocument& document) : m_document(document) {}
    ParameterGesture(const ParameterGesture&) = delete;
    ParameterGesture& operator=(const ParameterGesture&) = delete;

    /// Puts @p parameters in force, in place of those that the gesture tried before. @p text names the undo
    /// step. Does nothing if the document has no room for another parameter set.
    void tryOut(const TreeParameters& parameters, const QString& text);
    /// The next trial begins another gesture.
    void finish() { m_revision.reset(); }
    /// Takes back what the gesture has put in force, undo step and all.
    void cancel();

private:
    /// Goes on with the undo step of the last trial, if nothing else has changed the document since.
    std::unique_ptr<Edit> takeEdit();

    TreeDocument& m_document;
    /// Of the document, after the last trial; none before the first.
    std::optional<std::uint64_t> m_revision;
};

} // namespace espalier
