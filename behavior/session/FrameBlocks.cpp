// SPDX-License-Identifier: MIT
#include "behavior/session/FrameBlocks.h"

#include <algorithm>
#include <cstdlib>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace crowd::behavior {

namespace {

constexpr std::size_t kLargePage = std::size_t{2} << 20U; ///< bytes
constexpr std::size_t kAtLeast =
    8; ///< pieces in a block: no more than an eighth is left at its end

std::shared_ptr<std::byte> newBlock(std::size_t size)
{
    auto* block = static_cast<std::byte*>(std::aligned_alloc(kLargePage, size));
    if (block == nullptr) {
        throw std::bad_alloc();
    }
#ifdef __linux__
    (void)::madvise(block, size, MADV_HUGEPAGE); // where there are none, small ones will do
#endif
    return {block, [](std::byte* memory) { std::free(memory); }};
}

} // namespace

FrameBlocks::Bytes FrameBlocks::keep(std::span<const std::byte> bytes)
{
    if (m_size - m_used < bytes.size()) {
        const std::size_t pages = bytes.size() * kAtLeast / kLargePage + 1;
        m_size = pages * kLargePage;
        m_block = newBlock(m_size);
        m_used = 0;
    }
    std::byte* first = m_block.get() + m_used;
    std::ranges::copy(bytes, first);
    m_used += bytes.size();
    return {m_block, first};
}

} // namespace crowd::behavior
