// SPDX-License-Identifier: MIT
#include "behavior/session/FrameBlocks.h"

#include <cstdlib>
#include <cstring>
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

/// The system gives it all its memory now.
std::shared_ptr<std::byte> readyBlock(std::size_t size)
{
    constexpr std::size_t kSmallPage = 4096; // bytes
    std::shared_ptr<std::byte> block = newBlock(size);
    for (std::size_t at = 0; at < size; at += kSmallPage) {
        block.get()[at] = std::byte{};
    }
    return block;
}

} // namespace

FrameBlocks::Block FrameBlocks::takeBlock(std::size_t size)
{
    Block block = m_next.valid() ? m_next.get() : nullptr;
    if (block == nullptr || size != m_size) {
        block = newBlock(size);
    }
    m_next = std::async(&readyBlock, size); // without a thread, when it is taken
    return block;
}

FrameBlocks::Bytes FrameBlocks::keep(std::span<const std::byte> bytes)
{
    if (m_size - m_used < bytes.size()) {
        const std::size_t pages = bytes.size() * kAtLeast / kLargePage + 1;
        m_block = takeBlock(pages * kLargePage);
        m_size = pages * kLargePage;
        m_used = 0;
    }
    std::byte* first = m_block.get() + m_used;
    if (!bytes.empty()) {
        std::memcpy(first, bytes.data(), bytes.size()); // std::copy goes byte by byte
    }
    m_used += bytes.size();
    return {m_block, first};
}

} // namespace crowd::behavior
