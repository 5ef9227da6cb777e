// SPDX-License-Identifier: MIT
#include "model/features/FeatureLook.h"

#include <algorithm>
#include <cctype>

#include "model/base/WeightedDraw.h"
#include "model/brush/ClipChoice.h"
#include "model/brush/SlotChoice.h"

namespace crowd::model {

namespace {

bool isLetter(char letter)
{
    return std::isalpha(static_cast<unsigned char>(letter)) != 0;
}
bool isLower(char letter)
{
    return std::islower(static_cast<unsigned char>(letter)) != 0;
}
bool isUpper(char letter)
{
    return std::isupper(static_cast<unsigned char>(letter)) != 0;
}
char lower(char letter)
{
    return static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
}

/// Calls act(word) with each word in small letters.
template<class Act>
void forEachWord(std::string_view text, const Act& act)
{
    std::string word;
    for (std::size_t i = 0; i <= text.size(); ++i) {
        const bool ends = i == text.size() || !isLetter(text[i]) ||
                          (i > 0 && isUpper(text[i]) && isLower(text[i - 1]));
        if (ends && !word.empty()) {
            act(word);
            word.clear();
        }
        if (i < text.size() && isLetter(text[i])) {
            word += lower(text[i]);
        }
    }
}

bool equalsInSmall(std::string_view a, std::string_view b)
{
    return std::ranges::equal(a, b, [](char x, char y) { return lower(x) == lower(y); });
}

bool sits(const Clip& clip)
{
    return clip.seatHeight.has_value() || clip.role == ClipRole::Sit;
}

void add(std::vector<WeightedPick>& picks, std::size_t pick, float weight)
{
    const auto known = std::ranges::find(picks, pick, &WeightedPick::pick);
    if (known == picks.end()) {
        picks.push_back({static_cast<std::uint16_t>(pick), weight});
    }
}

} // namespace

bool hasWords(std::string_view name, std::string_view wanted)
{
    if (equalsInSmall(name, wanted)) {
        return true;
    }
    std::vector<std::string> words;
    forEachWord(name, [&words](const std::string& word) { words.push_back(word); });
    bool hasAll = true;
    forEachWord(wanted, [&](const std::string& word) {
        hasAll = hasAll && std::ranges::find(words, word) != words.end();
    });
    return hasAll;
}

std::uint16_t pickedAt(const std::vector<WeightedPick>& picks, double u)
{
    return picks[weightedIndex(picks, static_cast<float>(u),
                               [](const WeightedPick& each) { return each.weight; })]
        .pick;
}

FeatureLook::FeatureLook(const FeatureValue& wanted, const TemplateEntry& entry) : value(wanted)
{
    isMeant = value.templates.empty() || std::ranges::binary_search(value.templates, int{entry.id});
    if (isMeant && entry.asset) {
        findClips(entry);
        findSlots(*entry.asset);
        findParts(*entry.asset);
    }
}

void FeatureLook::findClips(const TemplateEntry& entry)
{
    for (const FeatureClip& wanted : value.clips) {
        const bool saysNothing = wanted.clip.empty() && wanted.role == ClipRole::Other;
        for (std::size_t column = 0; column < entry.clipNames.size(); ++column) {
            const std::string& name = entry.clipNames[column];
            const int index = entry.asset->clipIndex(name);
            if (index < 0 || saysNothing || !hasWords(name, wanted.clip) || wanted.weight <= 0.0F) {
                continue;
            }
            const auto clip = static_cast<std::size_t>(index);
            const ClipRole role = clipRole(entry, column, clip);
            if (wanted.role != ClipRole::Other && wanted.role != role) {
                continue;
            }
            if (isGait(role) && movesOverGround(entry, column, clip)) {
                add(walking, column + 1, wanted.weight);
            } else {
                add(sits(entry.asset->clips[clip]) ? seated : standing, column, wanted.weight);
            }
        }
    }
}

void FeatureLook::findSlots(const Template& asset)
{
    const std::size_t count = std::min<std::size_t>(asset.slots.size(), slots.size());
    const std::string anySlot;
    const ColourSlots worn(asset, anySlot, true);
    for (std::size_t i = 0; i < count; ++i) {
        const Slot& slot = asset.slots[i];
        const FeatureSlot* found = nullptr;
        for (const FeatureSlot& each : value.slots) {
            const bool isNamed = !each.slot.empty() && hasWords(slot.name, each.slot);
            if (isNamed || (found == nullptr && each.slot.empty() && worn.contains(slot))) {
                found = &each;
            }
            if (isNamed) {
                break;
            }
        }
        if (found == nullptr) {
            continue;
        }
        slots[i].colors = found->colors.empty() ? nullptr : found;
        for (const FeatureMaterial& material : found->materials) {
            const auto choice =
                std::ranges::find(slot.choices, material.name, &MaterialChoice::name);
            if (choice != slot.choices.end() && material.weight > 0.0F) {
                add(slots[i].materials, static_cast<std::size_t>(choice - slot.choices.begin()),
                    material.weight);
            }
        }
    }
}

void FeatureLook::findParts(const Template& asset)
{
    for (std::size_t i = 0; i < std::min<std::size_t>(asset.parts.size(), 32); ++i) {
        const std::uint32_t bit = 1U << i;
        for (const FeaturePart& wanted : value.parts) {
            if (hasWords(asset.parts[i].name, wanted.part)) {
                shownParts = wanted.isShown ? shownParts | bit : shownParts & ~bit;
                hiddenParts = wanted.isShown ? hiddenParts & ~bit : hiddenParts | bit;
            }
        }
    }
}

} // namespace crowd::model
