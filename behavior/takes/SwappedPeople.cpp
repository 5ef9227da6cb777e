// SPDX-License-Identifier: MIT
#include "behavior/takes/SwappedPeople.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>

#include "behavior/agents/PropertyOverrides.h"
#include "behavior/takes/PoseClip.h"
#include "model/brush/IndividualEdits.h"

namespace crowd::behavior {

namespace {

namespace keys = model::columns;

std::vector<model::ColumnId> lookColumns()
{
    std::vector<model::ColumnId> ids{keys::templateId.id, keys::tintReplaces.id,
                                     keys::materialChoices.id, keys::parts.id};
    for (int slot = 0; slot < model::kMaxTintSlots; ++slot) {
        ids.push_back(keys::tint(slot).id);
    }
    return ids;
}

/// What rules or states have made of these people.
void putOverrides(const OverrideColumns* overrides, model::IndividualRows& rows)
{
    for (std::size_t index = 0; overrides != nullptr && index < model::kColumnCount; ++index) {
        const auto id = static_cast<model::ColumnId>(index);
        const OverrideColumn* column = overrides->column(id);
        const std::size_t stride = model::columnInfo(id).stride;
        for (std::size_t row = 0; column != nullptr && row < rows.ids.size(); ++row) {
            const auto found = std::ranges::lower_bound(column->ids, rows.ids[row]);
            if (found != column->ids.end() && *found == rows.ids[row]) {
                const auto at = static_cast<std::size_t>(found - column->ids.begin());
                std::memcpy(rows.bytes[index].data() + row * stride,
                            column->bytes.data() + at * stride, stride);
            }
        }
    }
}

/// A column of the run with that of some people in place of theirs; both ascending.
OverrideColumn withRows(const OverrideColumn* column, const model::IndividualRows& rows,
                        model::ColumnId id)
{
    const std::size_t stride = model::columnInfo(id).stride;
    const std::vector<std::byte>& bytes = rows.bytes[static_cast<std::size_t>(id)];
    OverrideColumn made;
    const auto add = [&made, stride](model::IndividualId person, const std::byte* value) {
        made.ids.push_back(person);
        made.bytes.insert(made.bytes.end(), value, value + stride);
    };
    std::size_t old = 0;
    const std::size_t count = column != nullptr ? column->ids.size() : 0;
    for (std::size_t row = 0; row <= rows.ids.size(); ++row) {
        const bool isEnd = row == rows.ids.size();
        for (; old < count && (isEnd || column->ids[old] <= rows.ids[row]); ++old) {
            if (isEnd || column->ids[old] != rows.ids[row]) {
                add(column->ids[old], column->bytes.data() + old * stride);
            }
        }
        if (!isEnd) {
            add(rows.ids[row], bytes.data() + row * stride);
        }
    }
    return made;
}

/// The same moment of a step in another gait: by one shift, so that nothing jumps in between.
double placeIn(const GaitTable::Gait& from, const GaitTable::Gait& to, double place)
{
    if (from.feetTogether.empty() || to.feetTogether.empty()) {
        return place;
    }
    const auto passing = static_cast<double>(from.feetTogether.front());
    return place + GaitTable::nearestTogether(to, passing) - passing;
}

} // namespace

SwappedPeople::SwappedPeople(const model::Scene& scene, std::span<const model::IndividualId> people,
                             std::span<const int> templates)
    : m_population(scene.population), m_wanted(people.begin(), people.end())
{
    m_templates.templates = scene.templates;
    m_tables.read(scene.templates);
    for (const int id : templates) {
        const bool isId = id > 0 && id <= std::numeric_limits<model::TemplateId>::max();
        const std::uint32_t table = m_tables.indexOf(static_cast<model::TemplateId>(id));
        if (isId && m_tables.has(table) && m_tables.entry(table)->asset) {
            m_targets.push_back(table);
        }
    }
    gather();
}

void SwappedPeople::gather()
{
    m_people.clear();
    for (const model::IndividualId id : m_wanted) {
        const std::size_t row = m_population.rowOf(id);
        if (row != model::Population::npos && !m_targets.empty()) {
            m_people.push_back({id, m_tables.indexOf(m_population.column(keys::templateId)[row]),
                                m_targets[id % m_targets.size()],
                                m_population.column(keys::height)[row],
                                m_population.column(keys::seat)[row] != model::kNoSeat});
        }
    }
}

bool SwappedPeople::setPeople(const model::Population& people)
{
    if (people.version() == m_population.version()) {
        return false;
    }
    m_population = people;
    m_made.reset();
    gather();
    return true;
}

void SwappedPeople::apply(SessionPose& pose, std::set<model::IndividualId>& swapped)
{
    std::vector<model::IndividualId> ids;
    for (const Person& person : m_people) {
        const std::size_t row = rowOfPerson(pose, person.id);
        if (row == kNotInPose || !swapped.insert(person.id).second) {
            continue;
        }
        swapClip(pose, row, person);
        ids.push_back(person.id);
    }
    if (!ids.empty()) {
        putLooks(pose, ids);
    }
}

const SwappedPeople::Other& SwappedPeople::otherOf(const Person& person, std::uint16_t clip,
                                                   bool isSeated)
{
    const auto [found, isNew] = m_others.try_emplace({person.before, person.after, clip, isSeated});
    Other& other = found->second;
    if (!isNew) {
        return other;
    }
    const model::TemplateEntry* before = m_tables.entry(person.before);
    const model::TemplateEntry* after = m_tables.entry(person.after);
    model::IndividualRows row = model::IndividualRows::withDefaults({person.id});
    row.column(keys::templateId)[0] = before != nullptr ? before->id : model::TemplateId{0};
    row.column(keys::clip)[0] = clip;
    row.column(keys::seat)[0] = isSeated ? model::SeatId{1} : model::kNoSeat;
    model::toTemplate(m_templates, row, *after);
    other.clip.clip = row.column(keys::clip)[0];
    const GaitTable* from = m_tables.gaits(person.before);
    const GaitTable* to = m_tables.gaits(person.after);
    const std::size_t gait = from != nullptr ? from->gaitOf(clip) : 0;
    if (gait != 0 && to != nullptr) {
        other.from = &from->gait(gait);
        const std::size_t same = to->gaitOf(other.clip.clip);
        const std::size_t fitting = to->choose(0, other.from->metresPerSecond);
        other.to = &to->gait(same != 0 ? same : fitting);
        other.clip.clip = other.to->clip;
    }
    const TemplateTables::ClipFacts* facts = m_tables.clip(person.after, other.clip.clip);
    other.clip.isLooped = facts == nullptr || facts->isLooped;
    other.clip.clipSeconds = facts != nullptr ? facts->seconds : 0.0F;
    return other;
}

ClipPlace SwappedPeople::converted(const Person& person, const ClipPlace& clip, bool isSeated)
{
    if (person.before == person.after) {
        return clip;
    }
    const Other& other = otherOf(person, clip.clip, isSeated);
    ClipPlace made = other.clip;
    made.rate = clip.rate;
    made.place = clip.place;
    if (other.to != nullptr && !other.from->isFree && !other.to->isFree) {
        const float speed = other.from->metresPerSecond * person.height * clip.rate;
        made.rate = GaitTable::playback(*other.to, speed, person.height);
        made.place = placeIn(*other.from, *other.to, clip.place);
    }
    made.place = wholeTurns(made, made.place);
    return made;
}

void SwappedPeople::swapClip(SessionPose& pose, std::size_t row, const Person& person)
{
    const bool isSeated = pose.hasSeats ? pose.seats[row] != model::kNoSeat : person.isSeated;
    putClip(pose, row, converted(person, clipOf(pose, row), isSeated));
    const auto fades = std::ranges::lower_bound(pose.fades, static_cast<std::uint32_t>(row), {},
                                                &PoseFade::person);
    for (auto fade = fades; fade != pose.fades.end() && fade->person == row; ++fade) {
        fade->from = converted(person, fade->from, isSeated);
    }
}

/// As the scene, states and rules have them, in their other template.
model::IndividualRows SwappedPeople::looks(const SessionPose& pose,
                                           std::span<const model::IndividualId> ids) const
{
    model::IndividualRows rows = m_population.rows(ids);
    putOverrides(pose.recalled.get(), rows);
    putOverrides(pose.overrides.get(), rows);
    for (std::size_t row = 0; row < ids.size(); ++row) {
        const auto person = std::ranges::lower_bound(m_people, ids[row], {}, &Person::id);
        model::IndividualRows one = model::IndividualRows::withDefaults({ids[row]});
        for (std::size_t column = 0; column < model::kColumnCount; ++column) {
            const std::size_t stride = one.bytes[column].size();
            std::memcpy(one.bytes[column].data(), rows.bytes[column].data() + row * stride, stride);
        }
        model::toTemplate(m_templates, one, *m_tables.entry(person->after));
        for (std::size_t column = 0; column < model::kColumnCount; ++column) {
            const std::size_t stride = one.bytes[column].size();
            std::memcpy(rows.bytes[column].data() + row * stride, one.bytes[column].data(), stride);
        }
    }
    return rows;
}

void SwappedPeople::putLooks(SessionPose& pose, std::span<const model::IndividualId> ids)
{
    const bool isAsBefore = m_made && m_overrides == pose.overrides &&
                            m_recalled == pose.recalled && std::ranges::equal(m_ids, ids);
    if (!isAsBefore) {
        const model::IndividualRows rows = looks(pose, ids);
        auto made = pose.overrides ? std::make_shared<OverrideColumns>(*pose.overrides)
                                   : std::make_shared<OverrideColumns>();
        for (const model::ColumnId id : lookColumns()) {
            const OverrideColumn* column = pose.overrides ? pose.overrides->column(id) : nullptr;
            made->put(id, withRows(column, rows, id));
        }
        m_ids.assign(ids.begin(), ids.end());
        m_overrides = pose.overrides;
        m_recalled = pose.recalled;
        m_made = std::move(made);
    }
    pose.overrides = m_made;
}

} // namespace crowd::behavior
