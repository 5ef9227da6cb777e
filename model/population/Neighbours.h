// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "model/population/Population.h"

/// Sets of people by what they have in common with others. Ids ascending, all present; metres.
namespace crowd::model {

/// Those who look like one of them, these included: template, materials, tints and parts.
[[nodiscard]] std::vector<IndividualId> lookAlikes(const Population& people,
                                                   std::span<const IndividualId> ids);
/// These, and those whose foot point is so near to one of theirs.
[[nodiscard]] std::vector<IndividualId>
withNeighbours(const Population& people, std::span<const IndividualId> ids, float metres);
/// These without those who have somebody else so near.
[[nodiscard]] std::vector<IndividualId> withoutRim(const Population& people,
                                                   std::span<const IndividualId> ids, float metres);

} // namespace crowd::model
