// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "model/document/SceneEdit.h"

/// Changes of chosen individuals that touch several columns at once, through an open edit.
/// Ids ascending, all present.
namespace crowd::model {

/// Makes them copies of another template of the scene, where they stand. Clips, tints, material
/// choices and parts go over by the names of clips, slots, choices and parts; who did what is
/// usual, or something that the new template lacks, does what is usual there.
void changeTemplate(SceneEdit& edit, std::span<const IndividualId> ids, TemplateId id);

/// The same for rows that are in no scene yet: copies of individuals of any templates.
void toTemplate(const Scene& scene, IndividualRows& rows, const TemplateEntry& after);

enum class SitResult : std::uint8_t { Done, NoSuchSeat, SeatIsTaken };
/// Puts somebody onto a seat, facing as it does. Clips that stand as usual become the seated one.
[[nodiscard]] SitResult sitDown(SceneEdit& edit, IndividualId id, SeatId seat);
/// Frees their seats; they stay at the foot point, standing as usual if they sat as usual.
void standUp(SceneEdit& edit, std::span<const IndividualId> ids);

} // namespace crowd::model
