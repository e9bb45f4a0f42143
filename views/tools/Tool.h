// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/input/PointerSample.h"
#include "views/render/Overlay.h"
#include "views/tools/ToolContext.h"

#include <QCursor>
#include <QString>

namespace espalier {

/// Turns the samples of a gesture into commands. GestureReader sorts the samples: a tool gets begin, any
/// number of move and tick, and then one of end, finish and cancel; hover and leave come between gestures.
/// The camera can move at any time, during a gesture as well.
class Tool {
public:
    explicit Tool(ToolContext& context) : m_context(context) {}
    /// Cancels a gesture under way.
    virtual ~Tool() = default;
    Tool(const Tool&) = delete;
    Tool& operator=(const Tool&) = delete;

    virtual void begin(const PointerSample& sample) = 0;
    virtual void move(const PointerSample& sample) = 0;
    /// Ends the gesture: what was done is one undo step.
    virtual void end(const PointerSample& sample) = 0;
    /// Ends the gesture before the pointer is lifted, because something interrupts it: what was done up to
    /// the last sample is one undo step. A press that only its release would make a tap does nothing.
    virtual void finish() = 0;
    /// Leaves the document as it was before the gesture. Called only when the user cancels.
    virtual void cancel() = 0;
    virtual void hover(const PointerSample& sample) { Q_UNUSED(sample) }
    /// The pointer is not over the view any more.
    virtual void leave() {}
    /// Called about 60 times a second while wantsTicks(), also when no sample arrives. @p now: time up to
    /// which the pointer is known to be at rest, s, of the samples' clock.
    virtual void tick(double now) { Q_UNUSED(now) }
    /// The wheel was turned with Ctrl held, by @p notches; a gesture can be under way.
    virtual void wheel(double notches) { Q_UNUSED(notches) }
    /// Whether a finger that touches the screen during the gesture, or together with its first finger, takes
    /// part in it; otherwise all fingers move the camera. If so, the tool gets begin and moves for the finger
    /// as well, with its own id. The first finger that is lifted ends the gesture.
    virtual bool takesFinger(const PointerSample& sample) const
    {
        Q_UNUSED(sample)
        return false;
    }
    /// Whether a gesture of the tool draws a line freehand, which StrokeStabiliser may calm.
    virtual bool isFreehand() const { return false; }
    /// Whether the tool has a use of its own for a pen's eraser end, which prunes otherwise.
    virtual bool takesEraser() const { return false; }
    /// Handles a key (Qt::Key) that no shortcut uses, between gestures; Escape removes the tool's pins or
    /// handles. Returns whether the tool uses the key.
    virtual bool keyPressed(int key)
    {
        Q_UNUSED(key)
        return false;
    }
    /// The document shows another tree, between gestures: the tool drops what is chosen.
    virtual void forget() { leave(); }
    /// The tree's internodes have got other ids, between gestures; what is chosen stays chosen.
    virtual void renumber(const NewNumbers& internodes)
    {
        Q_UNUSED(internodes)
        leave();
    }
    /// Whether the tool keeps something of the last gesture for the next one, between gestures.
    virtual bool canTakeBack() const { return false; }
    /// Takes that back. Undo does so before it undoes anything else.
    virtual void takeBack() {}

    /// Whether a gesture is under way.
    virtual bool isActive() const = 0;
    virtual bool wantsTicks() const { return false; }
    virtual void paint(Overlay& overlay) const { Q_UNUSED(overlay) }
    virtual QCursor cursor() const { return Qt::CrossCursor; }
    /// One short sentence for the user about what the tool does now.
    virtual QString tip() const = 0;

protected:
    ToolContext& context() const { return m_context; }

private:
    ToolContext& m_context;
};

} // namespace espalier
