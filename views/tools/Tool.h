// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/input/PointerSample.h"
#include "views/render/Overlay.h"
#include "views/tools/ToolContext.h"

#include <QCursor>
#include <QString>

namespace espalier {

/// Turns what a hand does into commands. Gestures are read before: a tool gets begin, any number of move
/// and tick, and then one of end, finish and cancel; hover and leave come between gestures. The camera may
/// move at any time, during a gesture as well.
class Tool {
public:
    explicit Tool(ToolContext& context) : m_context(context) {}
    /// Cancels a gesture under way.
    virtual ~Tool() = default;
    Tool(const Tool&) = delete;
    Tool& operator=(const Tool&) = delete;

    virtual void begin(const PointerSample& sample) = 0;
    virtual void move(const PointerSample& sample) = 0;
    /// Makes what was done one undo step.
    virtual void end(const PointerSample& sample) = 0;
    /// Ends the gesture before the pointer is lifted, because something interrupts it: what was done up to
    /// the last sample is one undo step. A press that only its release would make a tap does nothing.
    virtual void finish() = 0;
    /// Leaves the document as it was before the gesture. Only the user asks for it.
    virtual void cancel() = 0;
    virtual void hover(const PointerSample& sample) { Q_UNUSED(sample) }
    /// The pointer is over the view no longer.
    virtual void leave() {}
    /// Time goes on while the hand rests; called about 60 times a second while wantsTicks(). @p now: s, of
    /// the samples' clock.
    virtual void tick(double now) { Q_UNUSED(now) }
    /// The wheel with Ctrl held, in notches; a gesture may be under way.
    virtual void wheel(double notches) { Q_UNUSED(notches) }
    /// Whether a finger that comes down beside those at work, or together with the first, is another hand at
    /// the same work; otherwise all of them turn to the camera. If so, the tool gets its begin and its moves
    /// as well, told apart by its id. The first finger that is lifted ends the gesture.
    virtual bool takesFinger(const PointerSample& sample) const
    {
        Q_UNUSED(sample)
        return false;
    }
    /// A key (Qt::Key) that nothing else wanted, between gestures; Escape puts away what the tool has laid
    /// out. Whether it meant something to the tool.
    virtual bool keyPressed(int key)
    {
        Q_UNUSED(key)
        return false;
    }

    /// Whether a gesture is under way.
    virtual bool isActive() const = 0;
    virtual bool wantsTicks() const { return false; }
    virtual void paint(Overlay& overlay) const { Q_UNUSED(overlay) }
    virtual QCursor cursor() const { return Qt::CrossCursor; }
    /// What to do with it, in one short sentence.
    virtual QString tip() const = 0;

protected:
    ToolContext& context() const { return m_context; }

private:
    ToolContext& m_context;
};

} // namespace espalier
