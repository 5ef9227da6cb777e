// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace crowd::behavior {

/// Where the index of an agent is expected: nobody. Agents count from 0 in the order of the
/// population's rows.
inline constexpr std::uint32_t kNoAgent = 0xFFFFFFFFU;

} // namespace crowd::behavior
