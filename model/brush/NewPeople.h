// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "model/brush/CreationSite.h"

/// Who comes to the spots of a creation brush.
namespace crowd::model {

/// The template of whoever comes to a spot of that key, by the weights of the mix; null for an
/// empty mix or one that is not in the scene any more.
[[nodiscard]] const TemplateEntry* templateAt(const Scene& scene, const CreateSettings& create,
                                              std::uint64_t key);

/// Rows for the spots, in their order: template by the mix, looks and animation by the settings.
/// Ids are left 0. Spots whose template is not loaded are left out, with the reason.
struct NewPeople
{
    IndividualRows rows;
    StrokeReason reason = StrokeReason::None;
};
[[nodiscard]] NewPeople peopleFor(const Scene& scene, const View& view,
                                  const BrushSettings& settings, std::span<const Spot> spots,
                                  std::optional<float> strokeHeading);

} // namespace crowd::model
