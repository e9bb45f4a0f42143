// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/InternodeReference.h"
#include "commands/recipe/RecipeOperation.h"
#include "model/document/Edit.h"

namespace espalier {

/// A press that is held on a branch, and changes it as long as it is held: a fixed number of steps a second
/// of the gesture's own time, so that the same time gives the same tree, live or replayed. finish() makes it
/// one undo step, and another edit that begins finishes it; cancel() takes it back, and so does the
/// destructor of an unfinished gesture.
class HoldGesture {
public:
    virtual ~HoldGesture() = default;
    HoldGesture(const HoldGesture&) = delete;
    HoldGesture& operator=(const HoldGesture&) = delete;

    /// The branch is held for at least @p seconds in all.
    void holdTo(double seconds);
    /// Makes one step at least: a tap counts as the shortest hold.
    void finish();
    void cancel() { m_edit.cancel(); }

    InternodeId branch() const { return m_branch; }
    /// Time that the steps made so far stand for, s.
    double seconds() const { return m_steps / m_stepsPerSecond; }
    /// Number of the steps that have changed the tree.
    int changeCount() const { return m_changes; }

protected:
    /// Precondition: @p branch is alive.
    HoldGesture(TreeDocument& document, InternodeId branch, double stepsPerSecond, QString text);

    virtual TreeDelta step(const TreeDocument& document) = 0;
    /// The recipe's operation that does the same.
    virtual RecipeOperation operation() const = 0;
    const InternodeReference& reference() const { return m_reference; }

private:
    void makeStep();

    Edit m_edit;
    InternodeId m_branch;
    InternodeReference m_reference;
    double m_stepsPerSecond;
    QString m_text;
    int m_steps = 0;
    int m_changes = 0;
};

} // namespace espalier
