// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

namespace crowd::behavior {

/// For each set of lanes, its members in ascending order, a byte each from the lowest on.
struct PackOrders
{
    std::array<std::uint64_t, 256> lanes{};

    constexpr PackOrders()
    {
        for (unsigned bits = 0; bits < 256; ++bits) {
            unsigned place = 0;
            for (unsigned lane = 0; lane < 8; ++lane) {
                if ((bits >> lane & 1U) != 0) {
                    lanes[bits] |= std::uint64_t{lane} << (8 * place++);
                }
            }
        }
    }
};

inline constexpr PackOrders kPackOrders;

} // namespace crowd::behavior
