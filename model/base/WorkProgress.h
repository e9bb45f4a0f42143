// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>

namespace espalier {

/// Shared by the thread that does some work and the one that waits for it: how far the work has come, and
/// whether it is to stop. All functions can be called from any thread.
class WorkProgress {
public:
    class Part;

    /// Asks the work to stop soon; its result is not used.
    void cancel() { m_isCancelled.store(true, std::memory_order_relaxed); }
    bool isCancelled() const { return m_isCancelled.load(std::memory_order_relaxed); }

    /// The finished share, 0...1, of the present Part, or of the whole work. A lower share than one that was
    /// set before changes nothing, so the order in which several threads call it does not matter.
    void setShare(float share)
    {
        const float whole = m_from + (m_to - m_from) * std::clamp(share, 0.0F, 1.0F);
        float before = m_share.load(std::memory_order_relaxed);
        while (before < whole && !m_share.compare_exchange_weak(before, whole, std::memory_order_relaxed)) {
        }
    }
    /// The finished share of the whole work, 0...1. It never falls.
    float share() const { return m_share.load(std::memory_order_relaxed); }

private:
    std::atomic<bool> m_isCancelled = false;
    std::atomic<float> m_share = 0.0F;
    // Of the present part.
    float m_from = 0.0F;
    float m_to = 1.0F;
};

/// While it lives, setShare() means a part of the work: from the finished share to @p end of the part around
/// it. No other thread may call setShare() while a part begins or ends.
class WorkProgress::Part {
public:
    Part(WorkProgress& progress, float end)
        : m_progress(progress), m_outerFrom(progress.m_from), m_outerTo(progress.m_to)
    {
        progress.m_from = progress.share();
        progress.m_to = std::max(progress.m_from, m_outerFrom + end * (m_outerTo - m_outerFrom));
    }
    ~Part()
    {
        if (!m_progress.isCancelled())
            m_progress.setShare(1.0F);
        m_progress.m_from = m_outerFrom;
        m_progress.m_to = m_outerTo;
    }
    Part(const Part&) = delete;
    Part& operator=(const Part&) = delete;

private:
    WorkProgress& m_progress;
    float m_outerFrom;
    float m_outerTo;
};

/// Tells the progress of work that consists of @p count things, which several threads can do.
class WorkCount {
public:
    /// @p count at least 1, unless nothing is added.
    WorkCount(WorkProgress& progress, std::size_t count) : m_progress(progress), m_count(count) {}

    /// Notes that so many more things are done. The counting itself takes time: not for each small thing.
    void add(std::size_t done)
    {
        const std::size_t all = m_done.fetch_add(done, std::memory_order_relaxed) + done;
        m_progress.setShare(static_cast<float>(all) / static_cast<float>(m_count));
    }

private:
    WorkProgress& m_progress;
    std::size_t m_count;
    std::atomic<std::size_t> m_done = 0;
};

} // namespace espalier
