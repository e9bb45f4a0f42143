// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/GrowthProcess.h"
#include "commands/recipe/RecipeOperation.h"
#include "model/document/Edit.h"

#include <memory>
#include <span>
#include <vector>

namespace espalier {

/// Growth without a hand, as long as somebody lets it go on: each step shows at once; finish() makes all of
/// them one undo step, whether growth has come to its end or not, and so does another edit that begins;
/// cancel() takes them back, and so does destroying the gesture unfinished. The steps are worked out here and
/// now by step(); or elsewhere, by the process that was taken out, and added in their order.
class GrowthGesture {
public:
    virtual ~GrowthGesture() = default;

    /// Grows one step; false, and nothing changed, if growth has come to its end or its process is elsewhere.
    bool step();

    /// Lets the steps be worked out elsewhere from now on.
    std::unique_ptr<GrowthProcess> takeProcess() { return std::move(m_process); }
    /// Grows the step that the process has come to, from the tree as it is now; false, and nothing changed,
    /// if that is empty.
    bool add(GrownStep grown);

    void finish();
    void cancel() { m_edit->cancel(); }
    /// What to do when another edit begins, instead of finish(); it must finish or cancel the gesture.
    void setInterrupted(Edit::Interrupted interrupted) { m_interrupted = std::move(interrupted); }

    /// Whether growth has come to its end.
    bool isExhausted() const { return m_isExhausted; }
    /// Steps that stand applied.
    std::size_t stepCount() const { return m_stepCount; }
    /// The living markers of free space, for showing them.
    std::span<const Vec3> markers() const { return m_markers; }

protected:
    /// @p prepare makes what the undo step begins with, such as a new envelope, through the gesture's edit.
    GrowthGesture(TreeDocument& document, QString text, const std::function<void(Edit&)>& prepare = {});
    /// Precondition: called once, before the first step. The process starts from the tree as it is prepared.
    void setProcess(std::unique_ptr<GrowthProcess> process);
    /// The recipe's operation that does what was done so far.
    virtual RecipeOperation operation() const = 0;

private:
    QString m_text;
    Edit::Interrupted m_interrupted;
    std::unique_ptr<Edit> m_edit;
    std::unique_ptr<GrowthProcess> m_process;
    std::vector<Vec3> m_markers;
    std::size_t m_stepCount = 0;
    bool m_isExhausted = false;
};

} // namespace espalier
