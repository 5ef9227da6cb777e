// SPDX-License-Identifier: MIT
#include "model/brush/Mask.h"

#include <algorithm>
#include <array>

#include "model/scene/Scene.h"

namespace crowd::model {

namespace {

bool isListed(const std::vector<int>& list, std::uint64_t value)
{
    return std::ranges::any_of(
        list, [value](int listed) { return static_cast<std::uint64_t>(listed) == value; });
}

std::uint64_t tagBits(const std::vector<int>& tags)
{
    std::uint64_t bits = 0;
    for (const int tag : tags) {
        bits |= std::uint64_t{1} << static_cast<unsigned>(tag);
    }
    return bits;
}

/// Whether a mask's lists hold somebody.
class MaskLists
{
public:
    MaskLists(const Population& people, const MaskSettings& mask)
        : m_mask(mask), m_tags(tagBits(mask.tags)), m_selected(mask.selected), m_ids(people.ids()),
          m_templates(people.column(columns::templateId)), m_groups(people.column(columns::group)),
          m_worn(people.column(columns::tags))
    {
        for (std::uint8_t kind = 1; kind <= kMostFeatureKinds; ++kind) {
            m_borne[kind - 1] = people.column(columns::feature(kind));
        }
        std::ranges::sort(m_selected);
    }

    [[nodiscard]] bool isMeant(std::size_t row) const
    {
        const bool isHeld =
            (!m_mask.onlySelected ||
             std::ranges::binary_search(m_selected, static_cast<int>(m_ids[row]))) &&
            (m_mask.templates.empty() || isListed(m_mask.templates, m_templates[row])) &&
            (m_mask.groups.empty() || isListed(m_mask.groups, m_groups[row])) &&
            (m_tags == 0 || (m_worn[row] & m_tags) != 0) &&
            (m_mask.features.empty() || bearsOne(row));
        return isHeld != m_mask.isInverted;
    }

private:
    [[nodiscard]] bool bearsOne(std::size_t row) const
    {
        return std::ranges::any_of(m_borne, [&](std::span<const FeatureId> borne) {
            return borne[row] != 0 && isListed(m_mask.features, borne[row]);
        });
    }

    const MaskSettings& m_mask;
    std::uint64_t m_tags;
    std::vector<int> m_selected;
    std::span<const IndividualId> m_ids;
    std::span<const TemplateId> m_templates;
    std::span<const GroupId> m_groups;
    std::span<const std::uint64_t> m_worn;
    std::array<std::span<const FeatureId>, kMostFeatureKinds> m_borne;
};

} // namespace

bool hasGroups(const FieldContext& context)
{
    return context.scene != nullptr && !context.scene->groups.empty();
}

StrokeMask::StrokeMask(const Scene& scene, const MaskSettings& mask)
{
    const bool isAsked = !mask.asksNothing();
    const bool canBeLocked = std::ranges::any_of(
        scene.groups, [](const Group& group) { return group.isHidden || group.isLocked; });
    if (!isAsked && !canBeLocked) {
        return;
    }
    const MaskLists lists(scene.population, mask);
    m_verdicts.resize(scene.population.size(), Verdict::Meant);
    for (std::size_t row = 0; row < m_verdicts.size(); ++row) {
        if (canBeLocked && !scene.isTouchable(row)) {
            m_verdicts[row] = Verdict::Locked;
        } else if (isAsked && !lists.isMeant(row)) {
            m_verdicts[row] = Verdict::Masked;
        }
    }
}

} // namespace crowd::model
