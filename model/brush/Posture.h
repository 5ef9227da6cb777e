// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "model/population/Population.h"
#include "model/scene/Scene.h"

/// Sitting down and standing up of rows that an edit is about to write. Who rests in a clip for the
/// one rests in a clip for the other afterwards; who plays anything else goes on with it. Entries
/// may be null: then the clip stays.
namespace crowd::model {

void sitDown(const TemplateEntry* entry, IndividualRows& rows, std::size_t row,
             const WorldSeat& seat);
/// Where the row is.
void standUp(const TemplateEntry* entry, IndividualRows& rows, std::size_t row);

} // namespace crowd::model
