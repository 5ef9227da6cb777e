// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "behavior/base/Problem.h"
#include "behavior/surface/WalkSurface.h"
#include "model/scene/Path.h"

/// What is wrong with places and paths of a running session, as sentences for the artist.
namespace crowd::behavior {

/// Places that nobody can get to.
[[nodiscard]] std::vector<Problem> problemsOfPlaces(std::span<const model::Place> places,
                                                    const WalkSurface& surface);

/// Paths with something between their places.
[[nodiscard]] std::vector<Problem> problemsOfPaths(std::span<const model::Path> paths,
                                                   std::span<const model::Place> places,
                                                   const WalkSurface& surface);

/// People who are to walk and stand where no way leads to or from; none: no problem.
[[nodiscard]] std::vector<Problem> problemsOfPeople(std::vector<model::IndividualId> offSurface);

/// How many people are to stand in each place, or do.
using GuestCounts = std::map<model::PlaceId, std::uint32_t>;

/// More people than have room want to stand in a place; `known` are problems said before, and no
/// place is named twice.
[[nodiscard]] std::vector<Problem> problemsOfCrowding(const GuestCounts& guests,
                                                      std::span<const model::Place> places,
                                                      std::span<const Problem> known);

} // namespace crowd::behavior
