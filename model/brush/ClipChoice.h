// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "model/brush/BrushSettings.h"
#include "model/scene/Scene.h"

namespace crowd::model {

/// One of the wanted clips that the template has, as a value of the clip column: the one at the
/// share u (0..1) of their weights. Nothing when it has none of them.
[[nodiscard]] std::optional<std::uint16_t> chosenClip(const TemplateEntry& entry,
                                                      std::span<const ClipWeight> wanted, double u);

/// As above; where some of them are for sitting and some are not, one that suits.
[[nodiscard]] std::optional<std::uint16_t> suitingClip(const TemplateEntry& entry,
                                                       std::span<const ClipWeight> wanted,
                                                       bool isSeated, double u);

/// Value of the clip column for a clip of the asset; nothing when the entry does not list its name.
[[nodiscard]] std::optional<std::uint16_t> clipColumnOf(const TemplateEntry& entry, int assetClip);

/// What a clip is for: the artist's word, or else the asset's. Whoever gave a clip a speed and said
/// nothing else means it for a gait. `column` counts as the clip column does, `assetClip` as the
/// asset's clips.
[[nodiscard]] ClipRole clipRole(const TemplateEntry& entry, std::size_t column,
                                std::size_t assetClip);
/// Whether a clip takes people over the ground: a loop with a speed, the artist's or else the
/// asset's, or else what is usual for its role.
[[nodiscard]] bool movesOverGround(const TemplateEntry& entry, std::size_t column,
                                   std::size_t assetClip);
/// Its ground speed at playback speed 1 and height 1, m/s.
[[nodiscard]] float groundSpeed(const TemplateEntry& entry, std::size_t column,
                                std::size_t assetClip);

/// How fast people of a template walk who were given no speed, m/s at height 1: as their walking
/// clip does.
[[nodiscard]] float usualWalkingSpeed(const TemplateEntry& entry);

/// How somebody new stands (or sits, on a seat) when no clip is wanted.
[[nodiscard]] std::uint16_t usualClip(const TemplateEntry& entry, bool isSeated);

/// How somebody new sits when no clip is wanted: at the share u (0..1), half of them as usual, the
/// others with the further clips for sitting, evenly.
[[nodiscard]] std::uint16_t seatedClip(const TemplateEntry& entry, double u);
/// Whether somebody who plays the clip just sits, or stands.
[[nodiscard]] bool isRest(const TemplateEntry& entry, std::uint16_t column, bool isSeated);

/// Which parts somebody new wears: bit i shows part i.
[[nodiscard]] std::uint32_t defaultParts(const Template& asset);

} // namespace crowd::model
