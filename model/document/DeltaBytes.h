// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "model/base/Result.h"
#include "model/document/SceneDelta.h"

namespace crowd::model {

/// The bulk of a delta (rows of individuals and values of columns, without scene-level entries) as
/// bytes, for this run of the program on this machine only.
[[nodiscard]] std::vector<std::byte> bulkBytesOf(const SceneDelta& delta);
/// Puts it back. Fails, with the delta's bulk empty, when the bytes are not such.
[[nodiscard]] Result<void> readBulk(std::span<const std::byte> bytes, SceneDelta& delta);
/// Frees the memory of the bulk.
void dropBulk(SceneDelta& delta);

} // namespace crowd::model
