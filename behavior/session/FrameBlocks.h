// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <future>
#include <memory>
#include <span>

namespace crowd::behavior {

/// Memory for what is kept piece after piece and let go in the same order. The system gives memory
/// page by page as it is first written to, which takes longer than to fill it: here it comes in
/// large blocks, for which large pages are asked, and the next one is got ready by another thread
/// while one is filled. A block is freed with the last piece in it. One thread keeps; what is kept
/// is never written to again and may be read and let go by any.
class FrameBlocks
{
public:
    using Bytes = std::shared_ptr<const std::byte>; ///< the first of them

    /// A copy of them.
    [[nodiscard]] Bytes keep(std::span<const std::byte> bytes);

private:
    using Block = std::shared_ptr<std::byte>;

    [[nodiscard]] Block takeBlock(std::size_t size);

    Block m_block;
    std::future<Block> m_next; ///< of the size of the present one; none before there is one
    std::size_t m_used = 0;
    std::size_t m_size = 0;
};

} // namespace crowd::behavior
