// SPDX-License-Identifier: MIT
#include "model/brush/NewPeople.h"

#include <algorithm>
#include <cmath>

#include "model/base/Random.h"
#include "model/brush/ClipChoice.h"
#include "model/brush/Operator.h"
#include "model/brush/SlotChoice.h"

namespace crowd::model {

namespace {

const TemplateWeight* chosenTemplate(std::span<const TemplateWeight> mix, double u)
{
    double total = 0.0;
    for (const TemplateWeight& item : mix) {
        total += std::max(0.0F, item.weight);
    }
    double left = u * total;
    const TemplateWeight* last = nullptr;
    for (const TemplateWeight& item : mix) {
        if (item.weight > 0.0F) {
            last = &item;
            if (left < item.weight) {
                break;
            }
            left -= item.weight;
        }
    }
    return last;
}

/// Fills rows one by one.
class RowWriter
{
public:
    RowWriter(const View& view, const BrushSettings& settings, std::optional<float> strokeHeading,
              IndividualRows& rows)
        : m_view(view), m_settings(settings), m_strokeHeading(strokeHeading), m_rows(rows)
    {
    }

    void write(std::size_t row, const TemplateEntry& entry, const Spot& spot)
    {
        const CreateSettings& create = m_settings.as<CreateSettings>();
        const bool isSeated = spot.seat != kNoSeat;
        const double share = draw(spot, DrawPurpose::Clip);
        const auto wanted = suitingClip(entry, create.clips, isSeated, share);
        const auto usual = isSeated ? seatedClip(entry, share) : usualClip(entry, false);
        m_rows.column(columns::templateId)[row] = entry.id;
        m_rows.column(columns::position)[row] = spot.position;
        m_rows.column(columns::heading)[row] = heading(spot);
        m_rows.column(columns::height)[row] = varied(spot, DrawPurpose::Height, create.height);
        m_rows.column(columns::girth)[row] = varied(spot, DrawPurpose::Girth, create.girth);
        m_rows.column(columns::phase)[row] = varied(spot, DrawPurpose::Phase, create.phase);
        m_rows.column(columns::parts)[row] = parts(*entry.asset, spot);
        m_rows.column(columns::clip)[row] = wanted.value_or(usual);
        m_rows.column(columns::seat)[row] = spot.seat;
        m_rows.column(columns::group)[row] = create.group;
        m_rows.column(columns::seed)[row] = static_cast<std::uint32_t>(
            hashKeys(spot.key, static_cast<std::uint64_t>(DrawPurpose::Seed)));
        writeOutfit(row, *entry.asset, spot);
        writeTints(row, *entry.asset, spot);
    }

private:
    [[nodiscard]] double draw(const Spot& spot, DrawPurpose purpose, std::uint64_t extra = 0) const
    {
        const double u = randomUnit(spot.key, purpose, extra);
        return m_settings.op == BrushOperator::Random ? m_settings.distribution.sample(u) : u;
    }
    [[nodiscard]] float varied(const Spot& spot, DrawPurpose purpose, const ValueRange& range) const
    {
        return range.low + (range.high - range.low) * static_cast<float>(draw(spot, purpose));
    }
    [[nodiscard]] float heading(const Spot& spot) const
    {
        if (spot.seat != kNoSeat) {
            return wrappedAngle(spot.seatHeading);
        }
        const HeadingSettings& wanted = m_settings.as<CreateSettings>().heading;
        return headingFor(wanted, m_view, spot.position, m_strokeHeading,
                          draw(spot, DrawPurpose::Heading))
            .value_or(wrappedAngle(wanted.headingRadians));
    }
    [[nodiscard]] std::uint32_t parts(const Template& asset, const Spot& spot) const
    {
        std::uint32_t shown = defaultParts(asset);
        const std::size_t count =
            m_settings.as<CreateSettings>().variesParts ? asset.parts.size() : 0;
        for (std::size_t part = 0; part < std::min<std::size_t>(count, 32); ++part) {
            const std::uint32_t bit = std::uint32_t{1} << part;
            shown =
                randomUnit(spot.key, DrawPurpose::Parts, part) < 0.5 ? shown | bit : shown & ~bit;
        }
        return shown;
    }
    void writeOutfit(std::size_t row, const Template& asset, const Spot& spot)
    {
        MaterialChoices& choices = m_rows.column(columns::materialChoices)[row];
        const std::size_t slots = std::min(asset.slots.size(), choices.size());
        const CreateSettings& create = m_settings.as<CreateSettings>();
        for (std::size_t slot = 0; slot < slots; ++slot) {
            const bool varies = isOfTheBody(asset.slots[slot].name)
                                    ? create.variesFaces.value_or(create.variesOutfit)
                                    : create.variesOutfit;
            if (!varies) {
                continue;
            }
            const std::size_t count = std::min<std::size_t>(asset.slots[slot].choices.size(), 256);
            if (count > 1) {
                const double u = randomUnit(spot.key, DrawPurpose::Outfit, slot);
                choices[slot] = static_cast<std::uint8_t>(
                    std::min(static_cast<std::size_t>(u * static_cast<double>(count)), count - 1));
            }
        }
    }
    void writeTints(std::size_t row, const Template& asset, const Spot& spot)
    {
        const CreateSettings& create = m_settings.as<CreateSettings>();
        const std::size_t slots = std::min<std::size_t>(asset.slots.size(), kMaxTintSlots);
        for (std::size_t slot = 0; slot < slots && !create.palette.empty(); ++slot) {
            const Slot& painted = asset.slots[slot];
            if (!painted.tintable || !painted.takesPalette || isOfTheBody(painted.name)) {
                continue;
            }
            const auto picked =
                static_cast<std::size_t>(draw(spot, DrawPurpose::Palette, slot) *
                                         static_cast<double>(create.palette.size()));
            const PaintColor& color = create.palette[std::min(picked, create.palette.size() - 1)];
            const float strength = std::clamp(create.paletteStrength, 0.0F, 1.0F);
            m_rows.column(columns::tint(static_cast<int>(slot)))[row] = {
                color[0], color[1], color[2],
                static_cast<std::uint8_t>(std::floor(strength * 255.0F + 0.5F))};
        }
    }

    const View& m_view;
    const BrushSettings& m_settings;
    std::optional<float> m_strokeHeading;
    IndividualRows& m_rows;
};

} // namespace

const TemplateEntry* templateAt(const Scene& scene, const CreateSettings& create, std::uint64_t key)
{
    const TemplateWeight* chosen =
        chosenTemplate(create.mix, randomUnit(key, DrawPurpose::Template));
    return chosen != nullptr ? scene.findTemplate(chosen->id) : nullptr;
}

NewPeople peopleFor(const Scene& scene, const View& view, const BrushSettings& settings,
                    std::span<const Spot> spots, std::optional<float> strokeHeading)
{
    NewPeople people;
    std::vector<const TemplateEntry*> entries;
    std::vector<const Spot*> kept;
    for (const Spot& spot : spots) {
        const TemplateEntry* entry = templateAt(scene, settings.as<CreateSettings>(), spot.key);
        if (entry != nullptr && entry->asset) {
            entries.push_back(entry);
            kept.push_back(&spot);
        } else {
            people.reason =
                entry != nullptr ? StrokeReason::TemplateNotLoaded : StrokeReason::NoTemplateChosen;
        }
    }
    people.rows = IndividualRows::withDefaults(std::vector<IndividualId>(kept.size(), 0));
    RowWriter writer(view, settings, strokeHeading, people.rows);
    for (std::size_t row = 0; row < kept.size(); ++row) {
        writer.write(row, *entries[row], *kept[row]);
    }
    return people;
}

} // namespace crowd::model
