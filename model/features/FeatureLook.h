// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "model/population/Columns.h"
#include "model/scene/Scene.h"

namespace crowd::model {

/// Whether a name has all the words that are wanted: "cheer" and "sit cheer" find "sit_cheer" and
/// "Armature|SitCheer01". Words begin after what is no letter and where a small letter is followed
/// by a capital; their case says nothing. No words find everything.
[[nodiscard]] bool hasWords(std::string_view name, std::string_view wanted);

/// Something that is drawn by weight: a value of a column.
struct WeightedPick
{
    std::uint16_t pick = 0;
    float weight = 1.0F;
};

/// One of them at a share, 0 <= u < 1, of their weights. There is one at least.
[[nodiscard]] std::uint16_t pickedAt(const std::vector<WeightedPick>& picks, double u);

/// What a value of a feature does to those of one template: its names looked up.
struct FeatureLook
{
    struct SlotLook
    {
        const FeatureSlot* colors = nullptr; ///< null: as they are
        std::vector<WeightedPick> materials; ///< of the slot's choices
    };

    FeatureLook(const FeatureValue& value, const TemplateEntry& entry);

    const FeatureValue& value;
    bool isMeant = false;               ///< else they do not bear it
    std::vector<WeightedPick> standing; ///< as the clip column has them
    std::vector<WeightedPick> seated;
    std::vector<WeightedPick> walking; ///< as the column walkStyle has them
    std::array<SlotLook, kMaxTintSlots> slots;
    std::uint32_t shownParts = 0; ///< bits
    std::uint32_t hiddenParts = 0;

private:
    void findClips(const TemplateEntry& entry);
    void findSlots(const Template& asset);
    void findParts(const Template& asset);
};

} // namespace crowd::model
