// SPDX-License-Identifier: MIT
#include "behavior/session/PoseKeeping.h"

#include <map>
#include <optional>
#include <utility>

namespace crowd::behavior {

namespace keys = model::columns;

namespace {

constexpr float kHasLeftBelow = -1e4F; ///< metres

/// Ids with a value each, for one column.
template<class T>
struct Kept
{
    std::vector<model::IndividualId> ids;
    std::vector<T> values;

    void add(model::IndividualId id, const T& value)
    {
        ids.push_back(id);
        values.push_back(value);
    }
    void write(model::SceneEdit& edit, model::ColumnKey<T> key) const
    {
        edit.setColumn(key, ids, std::span<const T>(values));
    }
};

template<class T, class ValueOf>
void keepSet(model::SceneEdit& edit, const std::vector<SetLook>& looks, model::ColumnKey<T> key,
             const ValueOf& valueOf)
{
    Kept<T> kept;
    for (const SetLook& look : looks) {
        const std::optional<T> value = valueOf(look);
        if (value && edit.scene().population.rowOf(look.id) != model::Population::npos) {
            kept.add(look.id, *value);
        }
    }
    kept.write(edit, key);
}

/// How many people are elsewhere, or look another way.
int keepPlaces(model::SceneEdit& edit, const model::Population& shown)
{
    const model::Population before = edit.scene().population;
    Kept<glm::vec3> positions;
    Kept<float> headings;
    Kept<model::SeatId> seats;
    Kept<std::uint16_t> clips;
    for (std::size_t row = 0; row < shown.size(); ++row) {
        const glm::vec3 position = shown.column(keys::position)[row];
        const float heading = shown.column(keys::heading)[row];
        const model::IndividualId id = shown.ids()[row];
        const std::size_t then = before.rowOf(id); // npos: removed since it was shown
        if (position.y < kHasLeftBelow || then == model::Population::npos) {
            continue;
        }
        if (position != before.column(keys::position)[then] ||
            heading != before.column(keys::heading)[then]) {
            positions.add(id, position);
            headings.add(id, heading);
        }
        const model::SeatId seat = shown.column(keys::seat)[row];
        if (seat != before.column(keys::seat)[then]) {
            seats.add(id, seat);
            clips.add(id, shown.column(keys::clip)[row]);
        }
    }
    positions.write(edit, keys::position);
    headings.write(edit, keys::heading);
    seats.write(edit, keys::seat);
    clips.write(edit, keys::clip);
    return static_cast<int>(positions.ids.size());
}

void keepLooks(model::SceneEdit& edit, const std::vector<SetLook>& looks)
{
    for (int slot = 0; slot < model::kMaxTintSlots; ++slot) {
        keepSet(edit, looks, keys::tint(slot), [slot](const SetLook& look) {
            return (look.tinted >> slot & 1) != 0
                       ? std::optional(look.tints[static_cast<std::size_t>(slot)])
                       : std::nullopt;
        });
    }
    keepSet(edit, looks, keys::height, [](const SetLook& look) { return look.height; });
    keepSet(edit, looks, keys::tags, [](const SetLook& look) { return look.tags; });
    keepSet(edit, looks, keys::clip, [](const SetLook& look) { return look.clip; });
    keepSet(edit, looks, keys::playbackSpeed,
            [](const SetLook& look) { return look.playbackSpeed; });
    keepSet(edit, looks, keys::phase, [](const SetLook& look) { return look.phase; });
}

void keepNumbers(model::SceneEdit& edit, const std::vector<OwnNumber>& numbers)
{
    const model::Population& people = edit.scene().population;
    std::vector<model::NumberName> kept = edit.scene().numbers;
    for (model::NumberName& named : kept) {
        std::map<model::IndividualId, float> values(named.values.begin(), named.values.end());
        for (const OwnNumber& own : numbers) {
            if (own.number == named.id) {
                values[own.id] = own.value;
            }
        }
        std::erase_if(values, [&people](const auto& value) {
            return people.rowOf(value.first) == model::Population::npos;
        });
        named.values.assign(values.begin(), values.end());
    }
    edit.setNumbers(std::move(kept));
}

} // namespace

int keepPose(model::SceneEdit& edit, const model::Population& shown, const SessionPose* pose)
{
    const int people = keepPlaces(edit, shown);
    if (pose != nullptr && pose->looks) {
        keepLooks(edit, *pose->looks);
    }
    if (pose != nullptr && pose->numbers) {
        keepNumbers(edit, *pose->numbers);
    }
    return people;
}

} // namespace crowd::behavior
