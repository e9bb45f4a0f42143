// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/Edit.h"

#include <memory>
#include <optional>

namespace espalier {

/// A drag of a slider: parameters are tried out live, and all trials of one gesture are one undo step. No
/// edit is open between two trials: each leaves a complete command on the undo stack, which the next one
/// replaces if the document has not changed since.
class ParameterGesture {
public:
    explicit ParameterGesture(TreeDocument& document) : m_document(document) {}
    ParameterGesture(const ParameterGesture&) = delete;
    ParameterGesture& operator=(const ParameterGesture&) = delete;

    /// Puts @p parameters in force, in place of those that the gesture tried before, as an undo step named
    /// @p text. Returns false, and does nothing, if the document has no room for them.
    bool tryOut(const TreeParameters& parameters, const QString& text);
    /// Ends the gesture: the next trial begins another undo step.
    void finish() { m_revision.reset(); }
    /// Reverts the last trial and removes its undo step, if the document has not changed since.
    void cancel();

private:
    /// Resumes the undo step of the last trial, or begins a new edit if the document has changed since.
    std::unique_ptr<Edit> takeEdit();

    TreeDocument& m_document;
    /// The document's revision after the last trial; empty before the first.
    std::optional<std::uint64_t> m_revision;
};

} // namespace espalier
