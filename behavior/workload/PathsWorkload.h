// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "behavior/workload/Workload.h"

namespace crowd::behavior {

/// "paths" of makeWorkload().
[[nodiscard]] std::unique_ptr<Workload> makePathsWorkload(std::size_t count, std::uint64_t seed);

} // namespace crowd::behavior
