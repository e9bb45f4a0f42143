// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/base/Parallel.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

namespace espalier::parallel {

void forRanges(std::size_t count, std::size_t grain, RangeTask task)
{
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, grain),
                      [&task](const tbb::blocked_range<std::size_t>& range) {
                          task.call(task.closure, range.begin(), range.end());
                      });
}

void forBoth(Task first, Task second)
{
    tbb::parallel_invoke([&first] { first.call(first.closure); }, [&second] { second.call(second.closure); });
}

} // namespace espalier::parallel
