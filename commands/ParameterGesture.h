// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/TreeDocument.h"

#include <memory>

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
    /// step.
    void tryOut(const TreeParameters& parameters, const QString& text);
    /// The next trial begins another gesture.
    void finish() { m_command.reset(); }
    /// Takes back what the gesture has put in force, undo step and all.
    void cancel() { takeBack(); }

private:
    class TrialCommand;

    void takeBack();

    TreeDocument& m_document;
    /// The command of the last trial, as long as it exists.
    std::weak_ptr<TrialCommand*> m_command;
    /// Its parameters were new to the document.
    bool m_remembered = false;
};

} // namespace espalier
