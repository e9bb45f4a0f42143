// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/HandOver.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace espalier {

/// What TBB is given: functions without their types, so that its templates are compiled once, in a file that
/// the thread sanitizer leaves out.
namespace parallel {

struct RangeTask {
    void* closure;
    void (*call)(void* closure, std::size_t begin, std::size_t end);
};

struct Task {
    void* closure;
    void (*call)(void* closure);
};

/// A function that other threads call.
template <class Function>
struct Handed {
    Function& function;
    HandOver begun{};
    HandOver done{};

    template <class... Arguments>
    static void call(void* closure, Arguments... arguments)
    {
        auto& handed = *static_cast<Handed*>(closure);
        handed.begun.take();
        handed.function(arguments...);
        handed.done.give();
    }
};

/// Calls the task on disjoint ranges of about @p grain that cover [0, count).
void forRanges(std::size_t count, std::size_t grain, RangeTask task);
void forBoth(Task first, Task second);

} // namespace parallel

/// Calls @p body(begin, end) on disjoint ranges that cover [0, count), on all threads that the program may
/// use. The body must write only what belongs to its own indices: then the result is the same on one thread
/// or many.
template <class Body>
void parallelFor(std::size_t count, std::size_t grain, Body&& body)
{
    if (count <= grain) {
        if (count > 0)
            body(std::size_t{0}, count);
        return;
    }
    using Handed = parallel::Handed<std::remove_reference_t<Body>>;
    Handed handed{body};
    parallel::forRanges(count, grain, {&handed, &Handed::template call<std::size_t, std::size_t>});
    handed.done.take();
}

/// Calls both functions, at the same time if a thread is free. Neither may read what the other one writes.
template <class First, class Second>
void inParallel(First&& first, Second&& second)
{
    using HandedFirst = parallel::Handed<std::remove_reference_t<First>>;
    using HandedSecond = parallel::Handed<std::remove_reference_t<Second>>;
    HandedFirst one{first};
    HandedSecond other{second};
    parallel::forBoth({&one, &HandedFirst::template call<>}, {&other, &HandedSecond::template call<>});
    one.done.take();
    other.done.take();
}

/// Calls @p work() with all the threads that the program may use but one, which stays free for the window's
/// thread; returns the result of @p work().
template <class Work>
auto leavingOneThread(Work&& work)
{
    const int threads = tbb::this_task_arena::max_concurrency();
    return tbb::task_arena(std::max(1, threads - 1)).execute(std::forward<Work>(work));
}

} // namespace espalier
