// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#if defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define ESPALIER_THREAD_SANITIZER
#include <sanitizer/tsan_interface.h>
#endif
#endif

namespace espalier {

/// Tells the thread sanitizer that one thread hands data over to another one. Qt and TBB do that with locks
/// inside their libraries, which are not compiled with the sanitizer, so that it would report every hand-over
/// as a race. Without the sanitizer, this class does nothing.
///
/// As a value that a lambda captures last, it goes with the lambda: each copy gives what the thread that made
/// the copy has written. The thread that runs the lambda calls take() before it reads anything else.
class HandOver {
public:
    HandOver() { give(); }
    HandOver(const HandOver&) { give(); }
    HandOver& operator=(const HandOver&) = delete;
    /// A lambda that was never called can be destroyed by the thread that it was given to.
    ~HandOver() { take(); }

#ifdef ESPALIER_THREAD_SANITIZER
    /// All that this thread has written so far happens before what follows take() in another thread.
    void give() const
    {
        __tsan_release(address());
    }
    void take() const
    {
        __tsan_acquire(address());
    }

private:
    void* address() const
    {
        return const_cast<HandOver*>(this);
    }
#else
    void give() const {}
    void take() const {}
#endif
};

} // namespace espalier
