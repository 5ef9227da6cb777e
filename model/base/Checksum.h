// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace crowd::model {

/// Of bytes that are to be read again as they were written: against accidents, not against malice.
/// The same on machines of one byte order.
[[nodiscard]] std::uint64_t checksumOf(std::span<const std::byte> bytes);

} // namespace crowd::model
