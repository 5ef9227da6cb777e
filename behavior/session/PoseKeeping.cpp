// SPDX-License-Identifier: MIT
#include "behavior/session/PoseKeeping.h"

#include <map>
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

void keepOverrides(model::SceneEdit& edit, const OverrideColumns& overrides)
{
    for (std::size_t index = 0; index < model::kColumnCount; ++index) {
        const auto id = static_cast<model::ColumnId>(index);
        if (const OverrideColumn* column = overrides.column(id)) {
            const OverrideColumn there = presentIn(edit.scene().population, id, *column);
            edit.setColumn(id, there.ids, there.bytes);
        }
    }
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
    if (pose != nullptr && pose->overrides) {
        keepOverrides(edit, *pose->overrides);
    }
    if (pose != nullptr && pose->numbers) {
        keepNumbers(edit, *pose->numbers);
    }
    return people;
}

} // namespace crowd::behavior
