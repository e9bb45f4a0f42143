// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fault/FaultyMemory.h"

#include <atomic>
#include <cerrno>
#include <limits>

namespace {

std::atomic<std::size_t> largeSize = std::numeric_limits<std::size_t>::max();
std::atomic<int> callCount = 0;
std::atomic<int> failing = -1;

bool fails(std::size_t size)
{
    if (size <= largeSize)
        return false;
    if (callCount++ != failing)
        return false;
    errno = ENOMEM;
    return true;
}

} // namespace

extern "C" {

// The functions of the C library by their other names.
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* block, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);

void* malloc(std::size_t size)
{
    return fails(size) ? nullptr : __libc_malloc(size);
}

void* calloc(std::size_t count, std::size_t size)
{
    return fails(count * size) ? nullptr : __libc_calloc(count, size);
}

void* realloc(void* block, std::size_t size)
{
    return fails(size) ? nullptr : __libc_realloc(block, size);
}

void* aligned_alloc(std::size_t alignment, std::size_t size)
{
    return fails(size) ? nullptr : __libc_memalign(alignment, size);
}

void* memalign(std::size_t alignment, std::size_t size)
{
    return fails(size) ? nullptr : __libc_memalign(alignment, size);
}

int posix_memalign(void** block, std::size_t alignment, std::size_t size)
{
    if (fails(size))
        return ENOMEM;
    *block = __libc_memalign(alignment, size);
    return *block == nullptr ? ENOMEM : 0;
}

} // extern "C"

namespace espalier::test {

FaultyMemory::FaultyMemory(int good, std::size_t size)
{
    callCount = 0;
    failing = good;
    largeSize = size;
}

FaultyMemory::~FaultyMemory()
{
    largeSize = std::numeric_limits<std::size_t>::max();
}

int FaultyMemory::calls() const
{
    return callCount;
}

} // namespace espalier::test
