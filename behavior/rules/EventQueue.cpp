// SPDX-License-Identifier: MIT
#include "behavior/rules/EventQueue.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace crowd::behavior {

namespace {

constexpr std::size_t kMaxEvents = 500'000;

} // namespace

bool EventQueue::isLater(const Entry& a, const Entry& b)
{
    return a.event.due > b.event.due || (a.event.due == b.event.due && a.order > b.order);
}

void EventQueue::post(QueuedEvent event)
{
    m_heap.push_back({std::move(event), m_posted++});
    std::ranges::push_heap(m_heap, isLater);
}

bool EventQueue::hasDue(double now) const
{
    return !m_heap.empty() && m_heap.front().event.due <= now;
}

QueuedEvent EventQueue::take()
{
    assert(!m_heap.empty());
    std::ranges::pop_heap(m_heap, isLater);
    QueuedEvent event = std::move(m_heap.back().event);
    m_heap.pop_back();
    return event;
}

bool EventQueue::isFull() const
{
    return m_heap.size() > kMaxEvents;
}

} // namespace crowd::behavior
