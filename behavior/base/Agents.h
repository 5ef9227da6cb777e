// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace crowd::behavior {

/// Where the index of an agent is expected: nobody. Agents count from 0 in the order of the
/// population's rows.
inline constexpr std::uint32_t kNoAgent = 0xFFFFFFFFU;

/// A column of values by agent after agents have come or gone: the new agent i is the former agent
/// keep[i], or a new one where that is kNoAgent.
template<class T>
void rearrange(std::vector<T>& column, std::span<const std::uint32_t> keep, const T& fresh = {})
{
    std::vector<T> next;
    next.reserve(keep.size());
    for (const std::uint32_t former : keep) {
        if (former == kNoAgent) {
            next.push_back(fresh);
        } else {
            next.push_back(std::move(column[former]));
        }
    }
    column = std::move(next);
}

} // namespace crowd::behavior
