// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/GrowthProcess.h"
#include "commands/recipe/RecipeOperation.h"
#include "model/document/Edit.h"

#include <memory>
#include <span>
#include <vector>

namespace espalier {

/// Growth without a brush, step by step; each step shows at once. finish() makes all steps one undo step,
/// whether growth has come to its end or not, and another edit that begins finishes the gesture. cancel()
/// takes the steps back, and so does the destructor of an unfinished gesture. Either step() computes the
/// steps, or the caller takes the process out, lets it compute them elsewhere, and adds them in their order.
class GrowthGesture {
public:
    virtual ~GrowthGesture() = default;

    /// Grows one step. Returns false, and does not change the tree, if growth has come to its end or the
    /// process was taken out.
    bool step();

    /// Takes the process out, so that its steps can be computed elsewhere.
    std::unique_ptr<GrowthProcess> takeProcess() { return std::move(m_process); }
    /// Applies the next step of the process, which starts at the present tree. Returns false, and does not
    /// change the tree, if the step is empty: growth has come to its end.
    bool add(GrownStep grown);

    void finish();
    void cancel() { m_edit->cancel(); }
    /// Sets what is called in place of finish() when another edit begins; it must finish or cancel the
    /// gesture.
    void setInterrupted(Edit::Interrupted interrupted) { m_interrupted = std::move(interrupted); }

    const TreeDocument& document() const { return m_edit->document(); }
    /// Whether growth has come to its end.
    bool isExhausted() const { return m_isExhausted; }
    /// Number of steps applied.
    std::size_t stepCount() const { return m_stepCount; }
    /// The living markers of free space, m, for display.
    std::span<const Vec3> markers() const { return m_markers; }

protected:
    /// @p prepare makes the first changes of the undo step, such as a new envelope, through the gesture's
    /// edit.
    GrowthGesture(TreeDocument& document, QString text, const std::function<void(Edit&)>& prepare = {});
    /// To be called once, before the first step. The process starts at the tree that @p prepare left.
    void setProcess(std::unique_ptr<GrowthProcess> process);
    /// The name of the undo step; the text that the gesture was made with, unless it is overridden.
    virtual QString title() const { return m_text; }
    /// The recipe's operation that makes the steps applied so far.
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
