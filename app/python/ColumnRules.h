// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "app/python/ScriptPeople.h"
#include "model/base/Result.h"
#include "model/scene/Scene.h"

/// What values a script may give to individuals. Everything is checked before anything changes;
/// a message names the column, the place in the array and what would do.
namespace crowd::app {

/// In one scene.
inline constexpr std::size_t kMostPeople = 10'000'000;

/// Whether so many more fit into the scene.
[[nodiscard]] model::Result<void> checkRoom(const model::Scene& scene, std::size_t coming);

/// Which groups there are to choose from, as a sentence for messages.
[[nodiscard]] std::string knownGroups(const model::Scene& scene);

/// n rows for addIndividuals: the given columns (n values each), elsewhere what the template and
/// the seat suggest. "template" is needed, and "position" or "seat".
[[nodiscard]] model::Result<model::IndividualRows> newRows(const model::Scene& scene, std::size_t n,
                                                           std::span<const ColumnValues> values,
                                                           MissingEntries missing);

/// Ids strictly ascending and all alive.
[[nodiscard]] model::Result<void> checkAlive(const model::Scene& scene,
                                             std::span<const model::IndividualId> ids);

/// Values for individuals that are there: ids ascending and alive.
[[nodiscard]] model::Result<void> checkChange(const model::Scene& scene,
                                              std::span<const model::IndividualId> ids,
                                              std::span<const ColumnValues> values,
                                              MissingEntries missing);

} // namespace crowd::app
