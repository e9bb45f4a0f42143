// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/base/Memory.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <string>

#ifdef __GLIBC__
#include <malloc.h>
#endif
#ifdef __unix__
#include <sys/resource.h>
#endif

namespace espalier {

namespace {

constexpr std::uint64_t kUnknown = std::numeric_limits<std::uint64_t>::max();

/// The number after @p name in a file of lines "name number", or the number in a file of one line.
std::uint64_t numberIn(const char* fileName, const std::string& name)
{
    std::ifstream file(fileName);
    std::string word;
    std::uint64_t number = 0;
    while (!name.empty() && file >> word && word != name) {
    }
    return file >> number ? number : kUnknown;
}

std::uint64_t difference(std::uint64_t limit, std::uint64_t used)
{
    return limit == kUnknown || used == kUnknown ? kUnknown : limit - std::min(limit, used);
}

} // namespace

std::uint64_t availableMemory()
{
    constexpr std::uint64_t kKilobyte = 1024;
    std::uint64_t available = numberIn("/proc/meminfo", "MemAvailable:");
    if (available != kUnknown)
        available *= kKilobyte;
    // A container's use counts files that it has read, which give way.
    const std::uint64_t files = numberIn("/sys/fs/cgroup/memory.stat", "inactive_file");
    const std::uint64_t used =
        difference(numberIn("/sys/fs/cgroup/memory.current", {}), files == kUnknown ? 0 : files);
    available = std::min(available, difference(numberIn("/sys/fs/cgroup/memory.max", {}), used));
#ifdef __unix__
    rlimit limit = {};
    if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY) {
        std::uint64_t mapped = numberIn("/proc/self/status", "VmSize:");
        if (mapped != kUnknown)
            mapped *= kKilobyte;
        available = std::min(available, difference(limit.rlim_cur, mapped));
    }
#endif
    return available;
}

void keepFreedMemory()
{
#ifdef __GLIBC__
    constexpr int kMegabyte = 1 << 20;
    mallopt(M_TRIM_THRESHOLD, 64 * kMegabyte);
    mallopt(M_MMAP_THRESHOLD, 32 * kMegabyte);
#endif
}

} // namespace espalier
