// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>

namespace espalier {

/// Shared by the thread that does some work and the one that waits for it: how far the work has come, and
/// whether it is to stop. All functions can be called from any thread.
class WorkProgress {
public:
    /// Asks the work to stop soon; its result is not used.
    void cancel() { m_isCancelled.store(true, std::memory_order_relaxed); }
    bool isCancelled() const { return m_isCancelled.load(std::memory_order_relaxed); }

    /// The finished share, 0...1.
    void setShare(float share) { m_share.store(share, std::memory_order_relaxed); }
    float share() const { return m_share.load(std::memory_order_relaxed); }

private:
    std::atomic<bool> m_isCancelled = false;
    std::atomic<float> m_share = 0.0F;
};

} // namespace espalier
