// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "model/document/SceneEdit.h"

/// Who is related to whom, and what becomes of it where people are copied. Ids ascending, all
/// present.
namespace crowd::model {

/// The relations that these have, whichever way, by a kind or by any (0); one between two of them
/// comes twice.
[[nodiscard]] std::vector<Relation>
relationsOf(const Scene& scene, std::span<const IndividualId> ids, RelationKindId kind);
/// Those to whom one of these is related, by a kind or by any (0); of one that is not mutual, in
/// its direction. Ascending; these themselves only where another one of them is related to them.
[[nodiscard]] std::vector<IndividualId>
relatedTo(const Scene& scene, std::span<const IndividualId> ids, RelationKindId kind);
/// These, and those who are related to one of them or to whom one of them is related, by a kind or
/// by any (0). Ascending.
[[nodiscard]] std::vector<IndividualId>
withRelated(const Scene& scene, std::span<const IndividualId> ids, RelationKindId kind);

/// Copies of people, `offset` metres away; of those who sit on the free seats nearest to there, as
/// far as any is near, else they stand. Related among each other as the originals are. Their ids,
/// in the same order.
std::vector<IndividualId> duplicate(SceneEdit& edit, std::span<const IndividualId> ids,
                                    const glm::vec3& offset);

} // namespace crowd::model
