// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "model/population/Columns.h"

namespace crowd::behavior {

/// An event on its way to one individual. World frame, metres, seconds since the session began.
struct QueuedEvent
{
    double due = 0.0;
    std::string name;
    float payload = 0.0F;
    model::IndividualId receiver = 0;
    glm::vec3 origin{0.0F};
    model::IndividualId sender = 0; ///< 0: a brush, a cue or a script
    double calledAt = 0.0;          ///< when the first of those who passed it on was called
    std::uint32_t passes = 0;       ///< from one related to the next
};

/// Events under way, taken out by the time at which they arrive; those of the same time in the
/// order in which they were posted.
class EventQueue
{
public:
    void post(QueuedEvent event);
    [[nodiscard]] bool hasDue(double now) const;
    /// The next one; there must be one.
    [[nodiscard]] QueuedEvent take();
    [[nodiscard]] std::size_t size() const { return m_heap.size(); }
    /// Rules are to send nothing more: there is as much under way as may be.
    [[nodiscard]] bool isFull() const;

private:
    struct Entry
    {
        QueuedEvent event;
        std::uint64_t order = 0;
    };

    [[nodiscard]] static bool isLater(const Entry& a, const Entry& b);

    std::vector<Entry> m_heap; ///< the earliest first
    std::uint64_t m_posted = 0;
};

} // namespace crowd::behavior
