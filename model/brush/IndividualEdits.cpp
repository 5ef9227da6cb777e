// SPDX-License-Identifier: MIT
#include "model/brush/IndividualEdits.h"

#include <algorithm>
#include <array>
#include <vector>

#include "model/brush/ClipChoice.h"
#include "model/brush/Operator.h"
#include "model/brush/Posture.h"
#include "model/population/Properties.h"

namespace crowd::model {

namespace {

/// Those of the columns in which something is another than in the scene.
void writeChanges(SceneEdit& edit, std::span<const IndividualId> ids, const IndividualRows& rows)
{
    for (const PropertyInfo& property : properties()) {
        const auto& bytes = rows.bytes[static_cast<std::size_t>(property.id)];
        if (bytes != edit.scene().population.values(property.id, ids)) {
            edit.setColumn(property.id, ids, bytes);
        }
    }
}

std::uint16_t clipInOther(const TemplateEntry* before, const TemplateEntry& after,
                          std::uint16_t clip, bool isSeated)
{
    const bool isKnown = before != nullptr && clip < before->clipNames.size();
    if (isKnown && clip != usualClip(*before, isSeated)) {
        const ClipWeight wanted{before->clipNames[clip], 1.0F};
        if (const auto same = chosenClip(after, std::span(&wanted, 1), 0.0)) {
            return *same;
        }
    }
    return usualClip(after, isSeated);
}

/// The clip to walk with, by name; one that the new template lacks becomes the one that fits.
std::uint16_t styleInOther(const TemplateEntry* before, const TemplateEntry& after,
                           std::uint16_t style)
{
    if (style == 0 || before == nullptr || style > before->clipNames.size()) {
        return 0;
    }
    const auto found = std::ranges::find(after.clipNames, before->clipNames[style - 1U]);
    return found == after.clipNames.end()
               ? std::uint16_t{0}
               : static_cast<std::uint16_t>(found - after.clipNames.begin() + 1);
}

/// Index of what has that name; -1 where nothing has.
template<class Named>
int indexOf(const std::vector<Named>& all, const std::string& name)
{
    const auto found = std::ranges::find(all, name, &Named::name);
    return found == all.end() ? -1 : static_cast<int>(found - all.begin());
}

/// The choice of that name; of a slot without such a one, the first.
std::uint8_t choiceInOther(const Slot& before, const Slot& after, std::uint8_t choice)
{
    const int found = choice == 0 || choice >= before.choices.size()
                          ? 0
                          : indexOf(after.choices, before.choices[choice].name);
    return static_cast<std::uint8_t>(std::max(found, 0));
}

/// Parts that both have stay shown or hidden, the others are as usual.
std::uint32_t partsInOther(const Template* before, const Template& after, std::uint32_t parts)
{
    std::uint32_t shown = defaultParts(after);
    for (std::size_t i = 0; before != nullptr && i < after.parts.size(); ++i) {
        const int old = indexOf(before->parts, after.parts[i].name);
        if (old >= 0) {
            const std::uint32_t bit = std::uint32_t{1} << i;
            shown = (parts >> old & 1U) != 0 ? shown | bit : shown & ~bit;
        }
    }
    return shown;
}

/// Tints, choices and parts of one row, from the slots of one template to those of another.
void carryLooks(IndividualRows& rows, std::size_t row, const Template* before,
                const Template& after)
{
    std::array<Tint, kMaxTintSlots> tints{};
    const std::uint16_t oldModes = rows.column(columns::tintReplaces)[row];
    std::uint16_t modes = 0;
    MaterialChoices choices{};
    const auto count = std::min<std::size_t>(after.slots.size(), kMaxTintSlots);
    for (std::size_t slot = 0; slot < count; ++slot) {
        const int old = before != nullptr ? before->slotIndex(after.slots[slot].name) : -1;
        if (old < 0 || old >= kMaxTintSlots) {
            continue;
        }
        tints[slot] = rows.column(columns::tint(old))[row];
        modes = static_cast<std::uint16_t>(modes | ((oldModes >> old & 1U) << slot));
        const std::uint8_t choice =
            rows.column(columns::materialChoices)[row][static_cast<std::size_t>(old)];
        choices[slot] =
            choiceInOther(before->slots[static_cast<std::size_t>(old)], after.slots[slot], choice);
    }
    for (int slot = 0; slot < kMaxTintSlots; ++slot) {
        rows.column(columns::tint(slot))[row] = tints[static_cast<std::size_t>(slot)];
    }
    rows.column(columns::tintReplaces)[row] = modes;
    rows.column(columns::materialChoices)[row] = choices;
    std::uint32_t& parts = rows.column(columns::parts)[row];
    parts = partsInOther(before, after, parts);
}

} // namespace

void toTemplate(const Scene& scene, IndividualRows& rows, const TemplateEntry& after)
{
    for (std::size_t row = 0; row < rows.ids.size(); ++row) {
        const TemplateId old = rows.column(columns::templateId)[row];
        if (old == after.id) {
            continue;
        }
        const TemplateEntry* before = scene.findTemplate(old);
        std::uint16_t& clip = rows.column(columns::clip)[row];
        clip = clipInOther(before, after, clip, rows.column(columns::seat)[row] != kNoSeat);
        std::uint16_t& style = rows.column(columns::walkStyle)[row];
        style = styleInOther(before, after, style);
        carryLooks(rows, row, before != nullptr ? before->asset.get() : nullptr, *after.asset);
        rows.column(columns::templateId)[row] = after.id;
    }
}

void changeTemplate(SceneEdit& edit, std::span<const IndividualId> ids, TemplateId id)
{
    const TemplateEntry* after = edit.scene().findTemplate(id);
    if (after == nullptr || !after->asset) {
        return;
    }
    IndividualRows rows = edit.scene().population.rows(ids);
    toTemplate(edit.scene(), rows, *after);
    writeChanges(edit, ids, rows);
}

SitResult sitDown(SceneEdit& edit, IndividualId id, SeatId seat)
{
    const Scene& scene = edit.scene();
    const std::vector<WorldSeat> seats = scene.worldSeats();
    const auto target = std::ranges::lower_bound(seats, seat, {}, &WorldSeat::id);
    if (target == seats.end() || target->id != seat) {
        return SitResult::NoSuchSeat;
    }
    const auto taken = scene.population.column(columns::seat);
    const auto found = std::ranges::find(taken, seat);
    if (found != taken.end() &&
        scene.population.ids()[static_cast<std::size_t>(found - taken.begin())] != id) {
        return SitResult::SeatIsTaken;
    }
    const std::array ids{id};
    IndividualRows rows = scene.population.rows(ids);
    const TemplateEntry* entry = scene.findTemplate(rows.column(columns::templateId)[0]);
    sitDown(entry, rows, 0, *target);
    writeChanges(edit, ids, rows);
    return SitResult::Done;
}

void standUp(SceneEdit& edit, std::span<const IndividualId> ids)
{
    const Scene& scene = edit.scene();
    IndividualRows rows = scene.population.rows(ids);
    for (std::size_t row = 0; row < ids.size(); ++row) {
        const TemplateEntry* entry = scene.findTemplate(rows.column(columns::templateId)[row]);
        standUp(entry, rows, row);
    }
    writeChanges(edit, ids, rows);
}

} // namespace crowd::model
