// SPDX-License-Identifier: MIT
#include "app/python/ColumnRules.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "model/base/Random.h"
#include "model/base/ShownText.h"
#include "model/brush/ClipChoice.h"
#include "model/describe/FieldChecks.h"
#include "model/population/PropertyValues.h"

namespace crowd::app {

using namespace model;

namespace {

const ColumnValues* find(std::span<const ColumnValues> values, ColumnId column)
{
    const auto found = std::ranges::find(values, column, &ColumnValues::column);
    return found == values.end() ? nullptr : &*found;
}

template<class T>
std::span<const T> itemsOf(const ColumnValues& values)
{
    return {reinterpret_cast<const T*>(values.bytes.data()), values.bytes.size() / sizeof(T)};
}

Error refused(ColumnId column, std::size_t index, const std::string& why)
{
    return Error{std::string(columnInfo(column).name) + "[" + std::to_string(index) + "] " + why};
}

/// Written by scripts at all, and within its legal range; a project file may hold anything finite.
Result<void> checkColumn(const ColumnValues& values)
{
    const PropertyInfo& property = propertyInfo(values.column);
    if (!property.isWrittenBy(kWrittenByScript)) {
        return Error{std::string(property.column.name) + " is not for scripts to write."};
    }
    const auto illegal = firstIllegal(property, values.bytes);
    if (!illegal) {
        return {};
    }
    return refused(values.column, illegal->row,
                   "is " + shortNumber(static_cast<double>(illegal->value)) +
                       (std::isfinite(illegal->value) ? "" : ", not a finite number") + "; it is " +
                       property.traits.meaning + " and must lie from " +
                       shortNumber(property.meta.low) + " to " + shortNumber(property.meta.high) +
                       ".");
}

/// What a template suggests for those created from it.
struct Usual
{
    const TemplateEntry* entry = nullptr;
    std::uint16_t standing = 0;
    std::uint16_t seated = 0;
    std::uint32_t parts = 0;
    bool hasParts = false;
};

/// Entries of a scene by id; ids are small, and neighbours often share theirs.
class TemplateTable
{
public:
    explicit TemplateTable(const Scene& scene)
    {
        for (const TemplateEntry& entry : scene.templates) {
            if (entry.id >= m_usual.size()) {
                m_usual.resize(entry.id + std::size_t{1});
            }
            Usual& usual = m_usual[entry.id];
            usual.entry = &entry;
            usual.standing = usualClip(entry, false);
            usual.seated = usualClip(entry, true);
            usual.hasParts = entry.asset != nullptr;
            usual.parts = entry.asset ? defaultParts(*entry.asset) : 0;
        }
    }
    [[nodiscard]] const TemplateEntry* find(TemplateId id) const
    {
        return id < m_usual.size() ? m_usual[id].entry : nullptr;
    }
    [[nodiscard]] const Usual& usual(TemplateId id) const { return m_usual[id]; }

private:
    std::vector<Usual> m_usual;
};

Result<void> checkTemplates(const TemplateTable& table, std::span<const TemplateId> ids)
{
    for (std::size_t i = 0; i < ids.size(); ++i) {
        if (table.find(ids[i]) == nullptr) {
            return refused(ColumnId::Template, i,
                           "is " + std::to_string(ids[i]) +
                               ", and the scene has no such template: take the id of one of "
                               "scene.templates.");
        }
    }
    return {};
}

Result<void> checkClips(const TemplateTable& table, std::span<const TemplateId> templates,
                        std::span<const std::uint16_t> clips)
{
    for (std::size_t i = 0; i < clips.size(); ++i) {
        const TemplateEntry& entry = *table.find(templates[i]);
        if (clips[i] >= entry.clipNames.size()) {
            return refused(ColumnId::Clip, i,
                           "is " + std::to_string(clips[i]) + ", but template " + entry.name +
                               " has " + std::to_string(entry.clipNames.size()) +
                               " clips, counted from 0.");
        }
    }
    return {};
}

/// As checkClips; 0 is always right, 1 the first clip.
Result<void> checkStyles(const TemplateTable& table, std::span<const TemplateId> templates,
                         std::span<const std::uint16_t> styles)
{
    for (std::size_t i = 0; i < styles.size(); ++i) {
        const std::size_t clips = table.find(templates[i])->clipNames.size();
        if (styles[i] > clips) {
            return refused(ColumnId::WalkStyle, i,
                           "is " + std::to_string(styles[i]) + ", but the template has " +
                               std::to_string(clips) + " clips, counted from 1; 0: any.");
        }
    }
    return {};
}

Result<void> checkPaths(const Scene& scene, std::span<const PathId> ids)
{
    for (std::size_t i = 0; i < ids.size(); ++i) {
        if (ids[i] != 0 && scene.findPath(ids[i]) == nullptr) {
            return refused(ColumnId::Path, i,
                           "is " + std::to_string(ids[i]) +
                               ", and the scene has no such path: take the id of one of "
                               "scene.environment[\"paths\"], or 0.");
        }
    }
    return {};
}

Result<void> checkGroups(const Scene& scene, std::span<const GroupId> ids)
{
    for (std::size_t i = 0; i < ids.size(); ++i) {
        if (ids[i] != 0 && scene.findGroup(ids[i]) == nullptr) {
            return refused(ColumnId::Group, i,
                           "is " + std::to_string(ids[i]) + ", and the scene has no such group. " +
                               knownGroups(scene));
        }
    }
    return {};
}

/// 0 is always right.
Result<void> checkBorne(const Scene& scene, std::uint8_t kind, const ColumnValues& values)
{
    const FeatureKind* known = findKind(scene.features, kind);
    const std::span<const FeatureId> ids = itemsOf<FeatureId>(values);
    for (std::size_t i = 0; i < ids.size(); ++i) {
        const bool isThere =
            ids[i] == 0 ||
            (known != nullptr &&
             std::ranges::find(known->values, ids[i], &FeatureValue::id) != known->values.end());
        if (!isThere) {
            return refused(values.column, i,
                           "is " + std::to_string(ids[i]) +
                               ", and no feature of that number has such a value: "
                               "Scene.set_feature takes names.");
        }
    }
    return {};
}

Result<void> checkBorne(const Scene& scene, std::span<const ColumnValues> values)
{
    for (std::uint8_t kind = 1; kind <= kMostFeatureKinds; ++kind) {
        const ColumnValues* borne = find(values, columns::feature(kind).id);
        auto valid = borne != nullptr ? checkBorne(scene, kind, *borne) : Result<void>();
        if (!valid) {
            return valid;
        }
    }
    return {};
}

/// Groups to be in, features to bear and paths to follow that are there.
Result<void> checkEntries(const Scene& scene, std::span<const ColumnValues> values,
                          MissingEntries missing)
{
    if (missing == MissingEntries::Take) {
        return {};
    }
    if (const ColumnValues* groups = find(values, ColumnId::Group)) {
        if (auto valid = checkGroups(scene, itemsOf<GroupId>(*groups)); !valid) {
            return valid;
        }
    }
    if (auto valid = checkBorne(scene, values); !valid) {
        return valid;
    }
    const ColumnValues* paths = find(values, ColumnId::Path);
    return paths != nullptr ? checkPaths(scene, itemsOf<PathId>(*paths)) : Result<void>();
}

using Seats = std::unordered_map<SeatId, const WorldSeat*>;

Result<void> checkSeats(const Seats& seats, std::unordered_set<SeatId> taken,
                        std::span<const SeatId> wanted)
{
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        if (wanted[i] == kNoSeat) {
            continue;
        }
        if (!seats.contains(wanted[i])) {
            return refused(ColumnId::Seat, i,
                           "is " + std::to_string(wanted[i]) +
                               ", and no stage has such a seat: take one of scene.seats[\"id\"].");
        }
        if (!taken.insert(wanted[i]).second) {
            return refused(ColumnId::Seat, i,
                           "is " + std::to_string(wanted[i]) +
                               ", which is taken: take one where "
                               "scene.seats[\"free\"] is true.");
        }
    }
    return {};
}

Seats seatsById(const std::vector<WorldSeat>& seats)
{
    Seats table;
    for (const WorldSeat& seat : seats) {
        table[seat.id] = &seat;
    }
    return table;
}

/// Seats of everyone but these (ascending).
std::unordered_set<SeatId> takenByOthers(const Scene& scene, std::span<const IndividualId> ids)
{
    std::unordered_set<SeatId> taken;
    const auto all = scene.population.ids();
    const auto seats = scene.population.column(columns::seat);
    for (std::size_t row = 0; row < all.size(); ++row) {
        if (seats[row] != kNoSeat && !std::ranges::binary_search(ids, all[row])) {
            taken.insert(seats[row]);
        }
    }
    return taken;
}

Result<void> checkCommon(std::size_t n, std::span<const ColumnValues> values)
{
    for (const ColumnValues& each : values) {
        const ColumnInfo& info = columnInfo(each.column);
        if (each.bytes.size() != n * info.stride) {
            return Error{std::string(info.name) + " has " +
                         std::to_string(each.bytes.size() / info.stride) + " values for " +
                         std::to_string(n) + " individuals: give one each, or one for all."};
        }
        if (auto valid = checkColumn(each); !valid) {
            return valid;
        }
    }
    return {};
}

/// Where the values say nothing: what the template and the seat suggest.
void fillDefaults(const Scene& scene, const TemplateTable& table, const Seats& seats,
                  IndividualRows& rows)
{
    const auto templates = rows.column(columns::templateId);
    const auto taken = rows.column(columns::seat);
    const auto clips = rows.column(columns::clip);
    const auto seeds = rows.column(columns::seed);
    const auto parts = rows.column(columns::parts);
    for (std::size_t i = 0; i < rows.ids.size(); ++i) {
        const Usual& usual = table.usual(templates[i]);
        clips[i] = taken[i] != kNoSeat ? usual.seated : usual.standing;
        seeds[i] = static_cast<std::uint32_t>(hashKeys(scene.seed, scene.nextId + i));
        if (usual.hasParts) {
            parts[i] = usual.parts;
        }
        if (taken[i] != kNoSeat) {
            const Seat& seat = seats.at(taken[i])->seat;
            rows.column(columns::position)[i] = seat.position;
            rows.column(columns::heading)[i] = seat.headingRadians;
        }
    }
}

void put(IndividualRows& rows, const ColumnValues& values)
{
    rows.bytes[static_cast<std::size_t>(values.column)] = values.bytes;
}

} // namespace

std::string knownGroups(const Scene& scene)
{
    if (scene.groups.empty()) {
        return "It has none: make one in scene.groups, or take 0.";
    }
    constexpr std::size_t kMost = 20;
    std::string text = "Its groups:";
    for (std::size_t i = 0; i < std::min(kMost, scene.groups.size()); ++i) {
        const Group& group = scene.groups[i];
        text +=
            (i == 0 ? " " : ", ") + std::to_string(group.id) + " \"" + shortened(group.name) + '"';
    }
    return text + (scene.groups.size() > kMost ? " …; " : "; ") + "0: none.";
}

Result<void> checkRoom(const Scene& scene, std::size_t coming)
{
    const std::size_t now = scene.population.size();
    if (coming > kMostPeople || now > kMostPeople - coming) {
        return Error{"A scene has room for " + std::to_string(kMostPeople) +
                     " characters: it has " + std::to_string(now) + ", and " +
                     std::to_string(coming) + " more do not fit."};
    }
    if (coming >= std::numeric_limits<IndividualId>::max() - scene.nextId) {
        return Error{"The scene has no ids left for " + std::to_string(coming) +
                     " more characters: all have been given out. Go on in another scene."};
    }
    return {};
}

namespace {

/// What can be said of the values of new individuals before any rows are made of them.
Result<void> checkNew(const Scene& scene, std::size_t n, std::span<const ColumnValues> values,
                      MissingEntries missing)
{
    if (auto room = checkRoom(scene, n); !room) {
        return room;
    }
    if (auto valid = checkCommon(n, values); !valid) {
        return valid;
    }
    if (auto valid = checkEntries(scene, values, missing); !valid) {
        return valid;
    }
    if (find(values, ColumnId::Template) == nullptr) {
        return Error{"create needs a template, as in create(template=t, position=...)."};
    }
    if (find(values, ColumnId::Seat) == nullptr && find(values, ColumnId::Position) == nullptr) {
        return Error{"create needs a position or a seat for each individual."};
    }
    return {};
}

/// Clips and styles are their templates' own.
Result<void> checkMotion(const TemplateTable& table, const IndividualRows& rows)
{
    const auto templates = rows.column(columns::templateId);
    if (auto valid = checkClips(table, templates, rows.column(columns::clip)); !valid) {
        return valid;
    }
    return checkStyles(table, templates, rows.column(columns::walkStyle));
}

} // namespace

Result<IndividualRows> newRows(const Scene& scene, std::size_t n,
                               std::span<const ColumnValues> values, MissingEntries missing)
{
    if (auto valid = checkNew(scene, n, values, missing); !valid) {
        return valid.error();
    }
    const ColumnValues& templates = *find(values, ColumnId::Template);
    const ColumnValues* seats = find(values, ColumnId::Seat);
    const TemplateTable table(scene);
    if (auto known = checkTemplates(table, itemsOf<TemplateId>(templates)); !known) {
        return known.error();
    }
    const std::vector<WorldSeat> places =
        seats != nullptr ? scene.worldSeats() : std::vector<WorldSeat>();
    const Seats seatTable = seatsById(places);
    IndividualRows rows = IndividualRows::withDefaults(std::vector<IndividualId>(n));
    put(rows, templates);
    if (seats != nullptr) {
        const auto wanted = itemsOf<SeatId>(*seats);
        if (auto free = checkSeats(seatTable, takenByOthers(scene, {}), wanted); !free) {
            return free.error();
        }
        put(rows, *seats);
    }
    fillDefaults(scene, table, seatTable, rows);
    for (const ColumnValues& each : values) {
        put(rows, each);
    }
    if (auto valid = checkMotion(table, rows); !valid) {
        return valid.error();
    }
    return rows;
}

Result<void> checkAlive(const Scene& scene, std::span<const IndividualId> ids)
{
    for (std::size_t i = 0; i < ids.size(); ++i) {
        if (i > 0 && ids[i] <= ids[i - 1]) {
            return Error{"Individual " + std::to_string(ids[i]) +
                         " is named twice: name each once."};
        }
        if (scene.population.rowOf(ids[i]) == Population::npos) {
            return Error{"There is no individual " + std::to_string(ids[i]) +
                         ": it was removed or never created."};
        }
    }
    return {};
}

Result<void> checkChange(const Scene& scene, std::span<const IndividualId> ids,
                         std::span<const ColumnValues> values, MissingEntries missing)
{
    if (auto valid = checkCommon(ids.size(), values); !valid) {
        return valid;
    }
    if (auto valid = checkEntries(scene, values, missing); !valid) {
        return valid;
    }
    const TemplateTable table(scene);
    IndividualRows rows = scene.population.rows(ids);
    const ColumnValues* templates = find(values, ColumnId::Template);
    if (templates != nullptr) {
        if (auto known = checkTemplates(table, itemsOf<TemplateId>(*templates)); !known) {
            return known;
        }
        put(rows, *templates);
    }
    if (const ColumnValues* clips = find(values, ColumnId::Clip)) {
        put(rows, *clips);
    }
    if (templates != nullptr || find(values, ColumnId::Clip) != nullptr) {
        if (auto valid =
                checkClips(table, rows.column(columns::templateId), rows.column(columns::clip));
            !valid) {
            return valid;
        }
    }
    if (const ColumnValues* styles = find(values, ColumnId::WalkStyle)) {
        if (auto valid = checkStyles(table, rows.column(columns::templateId),
                                     itemsOf<std::uint16_t>(*styles));
            !valid) {
            return valid;
        }
    }
    if (const ColumnValues* seats = find(values, ColumnId::Seat)) {
        const std::vector<WorldSeat> places = scene.worldSeats();
        return checkSeats(seatsById(places), takenByOthers(scene, ids), itemsOf<SeatId>(*seats));
    }
    return {};
}

} // namespace crowd::app
