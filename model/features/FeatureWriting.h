// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "model/document/SceneEdit.h"
#include "model/scene/Scene.h"

/// People come to bear values of a feature, with all that these do to them. Ids ascending, all
/// present.
namespace crowd::model {

/// Values of one column.
struct ChangedColumn
{
    ColumnId column{};
    std::vector<IndividualId> ids; ///< ascending
    std::vector<std::byte> bytes;  ///< one value each
};

/// What changes when each of them comes to bear the value of a kind that is wanted of him, one
/// each; 0, or one that the kind has not: none, and what the one he bore has done to him becomes as
/// his template has it. Draws depend on
/// seed, individual and value alone.
[[nodiscard]] std::vector<ChangedColumn> featureChanges(const Scene& scene, const FeatureKind& kind,
                                                        std::span<const IndividualId> ids,
                                                        std::span<const FeatureId> wanted,
                                                        std::uint64_t seed);

/// featureChanges(), in an edit; ids of those who changed, ascending.
std::vector<IndividualId> setFeature(SceneEdit& edit, const FeatureKind& kind,
                                     std::span<const IndividualId> ids,
                                     std::span<const FeatureId> wanted, std::uint64_t seed);

/// One of several values for each of so many, by weight: draws as in featureChanges().
struct WeightedFeature
{
    FeatureId id = 0;
    float weight = 1.0F;
};
[[nodiscard]] std::vector<FeatureId> drawnFeatures(std::span<const WeightedFeature> mix,
                                                   std::span<const IndividualId> ids,
                                                   std::uint64_t seed);

/// Who bears a value, ascending.
[[nodiscard]] std::vector<IndividualId> bearersOf(const Scene& scene, FeatureId value);
/// The smallest above all that kinds, people and rules name: a new value must not be taken for one
/// that is gone. 0: all are taken.
[[nodiscard]] FeatureId freeFeatureId(const Scene& scene);
/// The id of a further kind, whose column nobody uses; 0: there are as many as there can be.
[[nodiscard]] std::uint8_t freeKindId(const Scene& scene);

/// Puts these kinds in place of those that there are. Who bears a value that is gone bears none of
/// its kind, and looks as before. `isWorn`: whoever bears a value that does something else than
/// before changes with it.
void changeFeatures(SceneEdit& edit, FeatureKinds kinds, bool isWorn);

} // namespace crowd::model
