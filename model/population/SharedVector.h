// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstdint>
#include <utility>
#include <vector>

namespace crowd::model {

/// A vector that its copies share until one of them writes. Each copy belongs to one thread at a
/// time; those that share may be read, copied, written and dropped on different threads.
///
/// Counts its owners itself: shared_ptr::use_count() orders nothing, so that whoever found itself
/// alone could write while reads of a copy that was just dropped elsewhere were still under way.
template<class T>
class SharedVector
{
public:
    SharedVector() : SharedVector(std::vector<T>()) {}
    explicit SharedVector(std::vector<T> items) : m_block(new Block(std::move(items))) {}
    SharedVector(const SharedVector& other) noexcept : m_block(other.m_block) { hold(); }
    /// What was moved from may only be assigned to or dropped.
    SharedVector(SharedVector&& other) noexcept : m_block(std::exchange(other.m_block, nullptr)) {}
    SharedVector& operator=(SharedVector other) noexcept
    {
        std::swap(m_block, other.m_block);
        return *this;
    }
    ~SharedVector() { drop(); }

    [[nodiscard]] const std::vector<T>& operator*() const { return m_block->items; }
    [[nodiscard]] const std::vector<T>* operator->() const { return &m_block->items; }

    /// To be written by this copy alone.
    [[nodiscard]] std::vector<T>& writable()
    {
        // Acquire pairs with the release in drop(): what others read here, they have read.
        if (m_block->owners.load(std::memory_order_acquire) != 1) {
            *this = SharedVector(std::vector<T>(m_block->items));
        }
        return m_block->items;
    }

private:
    struct Block
    {
        explicit Block(std::vector<T> given) : items(std::move(given)) {}

        std::atomic<std::uint32_t> owners{1};
        std::vector<T> items;
    };

    void hold() noexcept
    {
        if (m_block != nullptr) {
            m_block->owners.fetch_add(1, std::memory_order_relaxed);
        }
    }
    void drop() noexcept
    {
        if (m_block != nullptr && m_block->owners.fetch_sub(1, std::memory_order_acq_rel) == 1) {
            delete m_block;
        }
    }

    Block* m_block;
};

} // namespace crowd::model
