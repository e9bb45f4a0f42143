// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/base/Memory.h"

#include <cstdlib>
#include <new>

#ifdef __GLIBC__
#include <malloc.h>
#endif
#ifdef __linux__
#include <sys/mman.h>
#endif

namespace espalier {

void keepFreedMemory()
{
#ifdef __GLIBC__
    constexpr int kMegabyte = 1 << 20;
    mallopt(M_TRIM_THRESHOLD, 64 * kMegabyte);
    mallopt(M_MMAP_THRESHOLD, 32 * kMegabyte);
#endif
}

void* allocateLarge(std::size_t bytes)
{
#ifdef __linux__
    constexpr std::size_t kPage = std::size_t{2} << 20U;
    void* const block = std::aligned_alloc(kPage, (bytes + kPage - 1) / kPage * kPage);
    if (block != nullptr)
        madvise(block, bytes, MADV_HUGEPAGE); // A wish: without large pages it only takes longer
#else
    void* const block = std::malloc(bytes);
#endif
    if (block == nullptr)
        throw std::bad_alloc();
    return block;
}

void freeLarge(void* block) noexcept
{
    std::free(block);
}

} // namespace espalier
