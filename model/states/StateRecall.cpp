// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstring>
#include <map>
#include <set>

#include "model/brush/ByteChange.h"
#include "model/population/Properties.h"
#include "model/states/StateKeeping.h"

namespace crowd::model {

namespace {

constexpr int kGone = -1;

/// Where each of some names was among others.
std::vector<int> placesOf(const std::vector<std::string>& now, const std::vector<std::string>& then)
{
    std::vector<int> places;
    places.reserve(now.size());
    for (const std::string& name : now) {
        const auto found = std::ranges::find(then, name);
        places.push_back(found == then.end() ? kGone : static_cast<int>(found - then.begin()));
    }
    return places;
}

/// How what counts within a template is said again within another one, or itself as it is now.
class NameMap
{
public:
    NameMap(const StateTemplate& then, const StateTemplate& now)
        : m_areClipsSame(then.clips == now.clips), m_areSlotsSame(then.slots == now.slots),
          m_arePartsSame(then.parts == now.parts), m_clips(placesOf(then.clips, now.clips)),
          m_slots(placesOf(now.slots, then.slots)), m_parts(placesOf(now.parts, then.parts))
    {
    }
    // Also where no names are known.
    [[nodiscard]] bool areClipsSame() const { return m_areClipsSame; }
    [[nodiscard]] bool areSlotsSame() const { return m_areSlotsSame; }
    [[nodiscard]] bool arePartsSame() const { return m_arePartsSame; }
    /// kGone: it has none of that name.
    [[nodiscard]] int clip(std::size_t then) const
    {
        return then < m_clips.size() ? m_clips[then] : kGone;
    }
    [[nodiscard]] int slotThen(std::size_t now) const
    {
        return now < m_slots.size() ? m_slots[now] : kGone;
    }
    [[nodiscard]] std::span<const int> partsThen() const { return m_parts; }

private:
    bool m_areClipsSame;
    bool m_areSlotsSame;
    bool m_arePartsSame;
    std::vector<int> m_clips; ///< today's by those of then
    std::vector<int> m_slots; ///< those of then by today's
    std::vector<int> m_parts;
};

/// One column of a state.
class HeldColumn
{
public:
    HeldColumn(const StoredRows& rows, ColumnId column)
        : m_info(propertyInfo(column)), m_stride(m_info.column.stride),
          m_bytes(m_info.initial.data(), m_stride)
    {
        const auto found = std::ranges::find(rows.columns, column, &StoredRows::Column::column);
        if (found != rows.columns.end()) {
            m_bytes = found->bytes;
        }
    }
    [[nodiscard]] std::span<const std::byte> of(std::size_t row) const
    {
        return m_bytes.size() == m_stride ? m_bytes : m_bytes.subspan(row * m_stride, m_stride);
    }
    template<class T>
    [[nodiscard]] T valueOf(std::size_t row) const
    {
        T value;
        std::memcpy(&value, of(row).data(), sizeof(T));
        return value;
    }

private:
    const PropertyInfo& m_info;
    std::size_t m_stride;
    std::span<const std::byte> m_bytes;
};

/// Somebody who is in the state and in the scene.
struct Pair
{
    IndividualId id = 0;
    std::size_t row = 0;  ///< in the scene
    std::size_t then = 0; ///< in the state
};

class Recall
{
public:
    /// `write` changes the scene.
    Recall(const Scene& scene, WriteColumn write, const State& state,
           const std::vector<IndividualId>* ids)
        : m_scene(scene), m_write(std::move(write)), m_state(state), m_rows(*state.people)
    {
        pairUp(ids);
    }
    StateRecall run(ColumnSet columns);

private:
    using Value = std::span<const std::byte>;
    void pairUp(const std::vector<IndividualId>* ids);
    /// valueFor(pair): what somebody gets; an empty one: he keeps his.
    template<class ValueFor>
    void write(ColumnId column, const ValueFor& valueFor);
    void writePlain(ColumnId column);
    void writeTemplates();
    void writeClips(ColumnId column, std::uint16_t first);
    void writeTint(ColumnId column);
    void writeChoices();
    void writeReplaces();
    void writeParts();
    void writeReferences(ColumnId column);
    void writeSeats();
    void writeOne(ColumnId column);
    [[nodiscard]] const NameMap& names(const Pair& pair);
    [[nodiscard]] const NameMap& namesBetween(const Pair& pair);
    [[nodiscard]] std::set<std::size_t> whoFindNoSeat() const;
    template<class T>
    [[nodiscard]] Value hold(T value)
    {
        std::memcpy(m_value.data(), &value, sizeof(T));
        return {m_value.data(), sizeof(T)};
    }
    [[nodiscard]] const Population& people() const { return m_scene.population; }

    const Scene& m_scene;
    WriteColumn m_write;
    const State& m_state;
    const StoredRows& m_rows;
    std::vector<Pair> m_pairs; ///< ascending ids
    std::map<std::pair<TemplateId, TemplateId>, NameMap> m_names;
    std::vector<const NameMap*> m_namesOf;  ///< of m_pairs; null: not asked yet
    std::map<std::string, int> m_lostClips; ///< how many by name
    std::array<std::byte, PropertyInfo::kMostBytes> m_value{};
    StateRecall m_result;
};

void Recall::pairUp(const std::vector<IndividualId>* ids)
{
    const std::span<const IndividualId> now = people().ids();
    std::size_t row = 0;
    for (std::size_t then = 0; then < m_rows.ids.size(); ++then) {
        const IndividualId id = m_rows.ids[then];
        while (row < now.size() && now[row] < id) {
            ++row;
        }
        const bool isMeant = ids == nullptr || std::ranges::binary_search(*ids, id);
        if (row < now.size() && now[row] == id && isMeant) {
            m_pairs.push_back({id, row, then});
        }
    }
}

template<class ValueFor>
void Recall::write(ColumnId column, const ValueFor& valueFor)
{
    ByteChange change(people(), column);
    for (const Pair& pair : m_pairs) {
        if (const Value value = valueFor(pair); !value.empty()) {
            change.set(pair.id, pair.row, value);
        }
    }
    change.apply(m_write, m_result.changed);
}

void Recall::writePlain(ColumnId column)
{
    const HeldColumn held(m_rows, column);
    write(column, [&held](const Pair& pair) { return held.of(pair.then); });
}

void Recall::writeTemplates()
{
    const HeldColumn held(m_rows, ColumnId::Template);
    int lost = 0;
    write(ColumnId::Template, [&](const Pair& pair) {
        const bool isThere = m_scene.findTemplate(held.valueOf<TemplateId>(pair.then));
        lost += isThere ? 0 : 1;
        return isThere ? held.of(pair.then) : Value();
    });
    if (lost > 0) {
        m_result.notes.emplace_back(
            QT_TRANSLATE_NOOP("Messages", "For %1 of them the template is gone."), lost);
    }
}

const NameMap& Recall::namesBetween(const Pair& pair)
{
    TemplateId then = 0;
    std::memcpy(&then, HeldColumn(m_rows, ColumnId::Template).of(pair.then).data(), sizeof(then));
    const TemplateId now = people().column(columns::templateId)[pair.row];
    const auto known = m_names.find({then, now});
    if (known != m_names.end()) {
        return known->second;
    }
    const auto remembered = std::ranges::find(m_state.templates, then, &StateTemplate::id);
    const StateTemplate former =
        remembered == m_state.templates.end() ? StateTemplate{} : *remembered;
    const TemplateEntry* entry = m_scene.findTemplate(now);
    StateTemplate current =
        entry == nullptr ? StateTemplate{} : rememberedTemplate(*entry, m_state.columns);
    if (then == now && (current.slots.empty() || former.slots.empty())) {
        current.slots = former.slots; // the file is missing: nothing says that they are others
        current.parts = former.parts;
    }
    return m_names.emplace(std::pair(then, now), NameMap(former, current)).first->second;
}

/// Once for each: what they have of templates comes before all that goes by names.
const NameMap& Recall::names(const Pair& pair)
{
    m_namesOf.resize(m_pairs.size());
    const NameMap*& known = m_namesOf[static_cast<std::size_t>(&pair - m_pairs.data())];
    if (known == nullptr) {
        known = &namesBetween(pair);
    }
    return *known;
}

/// `first`: what stands for the first clip.
void Recall::writeClips(ColumnId column, std::uint16_t first)
{
    const HeldColumn held(m_rows, column);
    write(column, [&](const Pair& pair) {
        const auto then = held.valueOf<std::uint16_t>(pair.then);
        const NameMap& map = names(pair);
        if (map.areClipsSame() || then < first) {
            return held.of(pair.then);
        }
        const std::size_t place = static_cast<std::size_t>(then) - first;
        const int now = map.clip(place);
        if (now == kGone) {
            const auto entry = std::ranges::find(
                m_state.templates,
                HeldColumn(m_rows, ColumnId::Template).valueOf<TemplateId>(pair.then),
                &StateTemplate::id);
            const bool isNamed = entry != m_state.templates.end() && place < entry->clips.size();
            ++m_lostClips[isNamed ? entry->clips[place] : std::to_string(place)];
            return Value();
        }
        return hold(static_cast<std::uint16_t>(now + first));
    });
}

void Recall::writeTint(ColumnId column)
{
    const auto slot = static_cast<std::size_t>(column) - static_cast<std::size_t>(ColumnId::Tint0);
    std::vector<HeldColumn> held;
    held.reserve(kTintColumns.size());
    for (const ColumnId each : kTintColumns) {
        held.emplace_back(m_rows, each);
    }
    write(column, [&](const Pair& pair) {
        const NameMap& map = names(pair);
        const int then = map.areSlotsSame() ? static_cast<int>(slot) : map.slotThen(slot);
        return then == kGone ? Value() : held[static_cast<std::size_t>(then)].of(pair.then);
    });
}

void Recall::writeChoices()
{
    const HeldColumn held(m_rows, ColumnId::MaterialChoices);
    const auto now = people().column(columns::materialChoices);
    write(ColumnId::MaterialChoices, [&](const Pair& pair) {
        const auto then = held.valueOf<MaterialChoices>(pair.then);
        const NameMap& map = names(pair);
        MaterialChoices choices = map.areSlotsSame() ? then : now[pair.row];
        for (std::size_t slot = 0; slot < choices.size() && !map.areSlotsSame(); ++slot) {
            const int from = map.slotThen(slot);
            choices[slot] = from == kGone ? choices[slot] : then[static_cast<std::size_t>(from)];
        }
        return hold(choices);
    });
}

void Recall::writeReplaces()
{
    const HeldColumn held(m_rows, ColumnId::TintReplaces);
    const auto now = people().column(columns::tintReplaces);
    write(ColumnId::TintReplaces, [&](const Pair& pair) {
        const unsigned then = held.valueOf<std::uint16_t>(pair.then);
        const NameMap& map = names(pair);
        unsigned bits = map.areSlotsSame() ? then : now[pair.row];
        for (unsigned slot = 0; slot < kTintColumns.size() && !map.areSlotsSame(); ++slot) {
            if (const int from = map.slotThen(slot); from != kGone) {
                bits = (bits & ~(1U << slot)) | ((then >> static_cast<unsigned>(from)) & 1U)
                                                    << slot;
            }
        }
        return hold(static_cast<std::uint16_t>(bits));
    });
}

void Recall::writeParts()
{
    const HeldColumn held(m_rows, ColumnId::Parts);
    const auto now = people().column(columns::parts);
    write(ColumnId::Parts, [&](const Pair& pair) {
        const auto then = held.valueOf<std::uint32_t>(pair.then);
        const NameMap& map = names(pair);
        std::uint32_t bits = map.arePartsSame() ? then : now[pair.row];
        const std::span<const int> parts = map.partsThen();
        for (std::size_t part = 0; part < parts.size() && !map.arePartsSame(); ++part) {
            if (parts[part] != kGone) {
                const std::uint32_t isShown = (then >> static_cast<unsigned>(parts[part])) & 1U;
                bits = (bits & ~(1U << part)) | isShown << part;
            }
        }
        return hold(bits);
    });
}

/// Paths and groups.
void Recall::writeReferences(ColumnId column)
{
    const HeldColumn held(m_rows, column);
    const Scene& scene = m_scene;
    int lost = 0;
    write(column, [&](const Pair& pair) {
        const auto then = held.valueOf<std::uint32_t>(pair.then);
        // A group may be a mere number; a path that is not there leads nowhere.
        const bool isThere =
            column == ColumnId::Group || then == 0 || scene.findPath(then) != nullptr;
        lost += isThere ? 0 : 1;
        return isThere ? held.of(pair.then) : Value();
    });
    if (lost > 0) {
        m_result.notes.emplace_back(
            QT_TRANSLATE_NOOP("Messages", "For %1 of them the path is gone."), lost);
    }
}

/// Those who would sit down where somebody sits who does not move; who stays for that reason may be
/// in the way of others.
std::set<std::size_t> Recall::whoFindNoSeat() const
{
    const HeldColumn held(m_rows, ColumnId::Seat);
    const auto now = people().column(columns::seat);
    std::set<std::size_t> moving;
    for (std::size_t i = 0; i < m_pairs.size(); ++i) {
        moving.insert(m_pairs[i].row);
    }
    std::set<SeatId> taken;
    for (std::size_t row = 0; row < now.size(); ++row) {
        if (now[row] != kNoSeat && !moving.contains(row)) {
            taken.insert(now[row]);
        }
    }
    std::set<std::size_t> staying;
    std::set<SeatId> wantedByAll;
    for (const Pair& pair : m_pairs) {
        const auto wanted = held.valueOf<SeatId>(pair.then);
        if (wanted != kNoSeat && !wantedByAll.insert(wanted).second) {
            staying.insert(pair.row); // a file was merged: the first one has it
            taken.insert(now[pair.row]);
        }
    }
    for (bool hasChanged = true; hasChanged;) {
        hasChanged = false;
        for (const Pair& pair : m_pairs) {
            const auto wanted = held.valueOf<SeatId>(pair.then);
            if (wanted != kNoSeat && taken.contains(wanted) && wanted != now[pair.row] &&
                staying.insert(pair.row).second) {
                hasChanged = true;
                if (now[pair.row] != kNoSeat) {
                    taken.insert(now[pair.row]);
                }
            }
        }
    }
    return staying;
}

/// Where they stand, and the seats they have.
void Recall::writeSeats()
{
    const std::set<std::size_t> staying = whoFindNoSeat();
    for (const ColumnId column : {ColumnId::Seat, ColumnId::Position}) {
        const HeldColumn held(m_rows, column);
        write(column, [&](const Pair& pair) {
            return staying.contains(pair.row) ? Value() : held.of(pair.then);
        });
    }
    if (!staying.empty()) {
        m_result.notes.emplace_back(
            QT_TRANSLATE_NOOP("Messages",
                              "For %1 of them the seat is taken: they stay where they are."),
            staying.size());
    }
}

void Recall::writeOne(ColumnId column)
{
    switch (column) {
    case ColumnId::Template:
        return writeTemplates();
    case ColumnId::Clip:
        return writeClips(column, 0);
    case ColumnId::WalkStyle:
        return writeClips(column, 1);
    case ColumnId::MaterialChoices:
        return writeChoices();
    case ColumnId::TintReplaces:
        return writeReplaces();
    case ColumnId::Parts:
        return writeParts();
    case ColumnId::Path:
    case ColumnId::Group:
        return writeReferences(column);
    case ColumnId::Seat:
        return writeSeats();
    case ColumnId::Position:
        return; // with the seats
    default:
        const bool isTint = column >= ColumnId::Tint0 && column <= ColumnId::Tint7;
        isTint ? writeTint(column) : writePlain(column);
    }
}

StateRecall Recall::run(ColumnSet columns)
{
    columns.forEach([this](ColumnId column) { // templates first: clips count within them
        if (m_state.columns.contains(column)) {
            writeOne(column);
        }
    });
    for (const auto& [clip, count] : m_lostClips) {
        m_result.notes.emplace_back(
            QT_TRANSLATE_NOOP("Messages",
                              "For %1 of them there is no clip \"%2\": they keep theirs."),
            count, clip);
    }
    return std::move(m_result);
}

} // namespace

ColumnSet recalledColumns(const State& state, ColumnSet columns)
{
    ColumnSet recalled;
    withBothOfPlace(columns).forEach([&](ColumnId column) {
        if (state.columns.contains(column)) {
            recalled.insert(column);
        }
    });
    return recalled;
}

StateRecall recallState(SceneEdit& edit, const State& state, ColumnSet columns,
                        const std::vector<IndividualId>* ids, const RecallTiming& timing)
{
    edit.announce(
        {state.id, peopleOf(edit.scene(), state, ids), recalledColumns(state, columns), timing});
    return giveBack(edit, state, columns, ids);
}

StateRecall giveBack(SceneEdit& edit, const State& state, ColumnSet columns,
                     const std::vector<IndividualId>* ids)
{
    const auto write = [&edit](ColumnId column, std::span<const IndividualId> whom,
                               std::span<const std::byte> values) {
        edit.setColumn(column, whom, values);
    };
    return Recall(edit.scene(), write, state, ids).run(recalledColumns(state, columns));
}

StateRecall recallState(Scene& scene, const State& state, ColumnSet columns,
                        const std::vector<IndividualId>* ids)
{
    const auto write = [&scene](ColumnId column, std::span<const IndividualId> whom,
                                std::span<const std::byte> values) {
        scene.population.setValues(column, whom, values);
    };
    return Recall(scene, write, state, ids).run(recalledColumns(state, columns));
}

} // namespace crowd::model
