// SPDX-License-Identifier: MIT
#include "behavior/session/PoseKeeping.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

#include "model/population/PropertyValues.h"

namespace crowd::behavior {

namespace keys = model::columns;

namespace {

constexpr float kHasLeftBelow = -1e4F; ///< metres

/// Values of one property, one for each id.
class Kept
{
public:
    explicit Kept(const model::PropertyInfo& property) : m_property(property) {}

    void add(model::IndividualId id, std::span<const std::byte> value)
    {
        m_ids.push_back(id);
        m_values.insert(m_values.end(), value.begin(), value.end());
    }
    void write(model::SceneEdit& edit) const { edit.setColumn(m_property.id, m_ids, m_values); }
    [[nodiscard]] const std::vector<model::IndividualId>& ids() const { return m_ids; }

private:
    const model::PropertyInfo& m_property;
    std::vector<model::IndividualId> m_ids; ///< ascending
    std::vector<std::byte> m_values;
};

std::span<const std::byte> valueIn(const model::Population& people,
                                   const model::PropertyInfo& property, std::size_t row)
{
    const std::size_t stride = property.column.stride;
    return people.columnBytes(property.id).subspan(row * stride, stride);
}

/// Somebody who is still there: his rows in what is shown and in the scene.
struct Present
{
    model::IndividualId id = 0;
    std::size_t shown = 0;
    std::size_t before = 0;
};

std::vector<Present> stillPresent(const model::Population& before, const model::Population& shown)
{
    std::vector<Present> present;
    for (std::size_t row = 0; row < shown.size(); ++row) {
        const std::size_t then = before.rowOf(shown.ids()[row]); // npos: removed since it was shown
        if (shown.column(keys::position)[row].y >= kHasLeftBelow &&
            then != model::Population::npos) {
            present.push_back({shown.ids()[row], row, then});
        }
    }
    return present;
}

/// What sessions write as people go about. How many people are elsewhere, or look another way.
int keepShown(model::SceneEdit& edit, const model::Population& shown)
{
    const model::Population before = edit.scene().population;
    const std::vector<Present> present = stillPresent(before, shown);
    std::vector<model::IndividualId> moved;
    for (const model::PropertyInfo& property : model::properties()) {
        if (!property.isWrittenBy(model::kWrittenBySession)) {
            continue;
        }
        Kept kept(property);
        Kept clips(model::propertyInfo(keys::clip.id)); // to sit or to stand with
        for (const Present& each : present) {
            const auto value = valueIn(shown, property, each.shown);
            if (model::isSameValue(property.column.type, value,
                                   valueIn(before, property, each.before))) {
                continue;
            }
            kept.add(each.id, value);
            if (property.id == keys::seat.id) {
                clips.add(each.id, std::as_bytes(shown.column(keys::clip).subspan(each.shown, 1)));
            }
        }
        kept.write(edit);
        clips.write(edit);
        if (property.id == keys::position.id || property.id == keys::heading.id) {
            std::vector<model::IndividualId> both;
            std::ranges::set_union(moved, kept.ids(), std::back_inserter(both));
            moved = std::move(both);
        }
    }
    return static_cast<int>(moved.size());
}

/// What a session has made of people who are there.
template<class IsMeant>
void keepColumns(model::SceneEdit& edit, const OverrideColumns& columns, const IsMeant& isMeant)
{
    for (const model::PropertyInfo& property : model::properties()) {
        const OverrideColumn* column = isMeant(property) ? columns.column(property.id) : nullptr;
        if (column != nullptr) {
            const OverrideColumn there = presentIn(edit.scene().population, property.id, *column);
            edit.setColumn(property.id, there.ids, there.bytes);
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
    if (pose != nullptr && pose->recalled) {
        keepColumns(edit, *pose->recalled, [](const model::PropertyInfo&) { return true; });
    }
    const int people = keepShown(edit, shown);
    if (pose != nullptr && pose->overrides) {
        keepColumns(edit, *pose->overrides, [](const model::PropertyInfo& property) {
            return property.isWrittenBy(model::kWrittenByRule);
        });
    }
    if (pose != nullptr && pose->numbers) {
        keepNumbers(edit, *pose->numbers);
    }
    return people;
}

void keepClips(model::SceneEdit& edit, const model::Population& shown)
{
    const model::Population before = edit.scene().population;
    std::vector<model::IndividualId> ids;
    std::vector<std::uint16_t> clips;
    std::vector<float> phases;
    std::vector<float> speeds;
    for (const Present& each : stillPresent(before, shown)) {
        if (before.column(keys::path)[each.before] != 0) {
            continue;
        }
        const float phase = shown.column(keys::phase)[each.shown];
        ids.push_back(each.id);
        clips.push_back(shown.column(keys::clip)[each.shown]);
        phases.push_back(std::clamp(phase - std::floor(phase), 0.0F, 1.0F));
        speeds.push_back(shown.column(keys::playbackSpeed)[each.shown]);
    }
    edit.setColumn(keys::clip, ids, std::span<const std::uint16_t>(clips));
    edit.setColumn(keys::phase, ids, std::span<const float>(phases));
    edit.setColumn(keys::playbackSpeed, ids, std::span<const float>(speeds));
}

} // namespace crowd::behavior
