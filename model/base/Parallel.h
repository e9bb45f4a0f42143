// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace espalier {

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
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, count, grain),
        [&](const tbb::blocked_range<std::size_t>& range) { body(range.begin(), range.end()); });
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
