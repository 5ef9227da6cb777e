// SPDX-License-Identifier: MIT
#include "behavior/takes/EditedTake.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <glm/geometric.hpp>

#include "behavior/agents/AgentColumns.h"
#include "behavior/agents/TemplateTables.h"
#include "behavior/agents/Turning.h"
#include "behavior/takes/PoseClip.h"
#include "behavior/takes/TakeFile.h"
#include "model/brush/ClipChoice.h"

namespace crowd::behavior {

namespace {

using model::HandEdit;
using model::HandEditKind;

constexpr double kWithinStep = 1e-6; ///< seconds by which times of steps are not exact
constexpr float kLongestStep = 1.5F; ///< metres: further in one step is no walk
constexpr double kAsideMetresPerSecond = 0.8;
constexpr double kAsideSeconds = 0.8; ///< at least, in which somebody is brought beside his way
constexpr double kAsideShare = 0.4;   ///< of the stretch, at most
constexpr double kPhaseOfPerson = 0.618033988749895; ///< so that those who rest do not do it alike

double advanced(const ClipPlace& clip, double seconds)
{
    return clip.clipSeconds > 0.0F ? clip.place + seconds * static_cast<double>(clip.rate) /
                                                      static_cast<double>(clip.clipSeconds)
                                   : clip.place;
}

/// As it is at the time of the pose.
ClipPlace clipIn(const SessionPose& pose, std::size_t row)
{
    ClipPlace clip = clipOf(pose, row);
    if ((pose.flags[row] & kPoseClock) != 0) {
        clip.place = wholeTurns(clip, clip.placeAt(pose.seconds));
    }
    return clip;
}

/// Somebody at a moment between two steps of the take.
class Source
{
public:
    Source(const SessionPose& before, const SessionPose& after, double seconds)
        : m_before(before), m_after(after), m_since(seconds - before.seconds)
    {
        const double length = after.seconds - before.seconds;
        m_share = length > 0.0 ? std::clamp(m_since / length, 0.0, 1.0) : 0.0;
    }
    /// False: he is not there.
    bool find(model::IndividualId id)
    {
        m_row = rowOfPerson(m_before, id);
        m_next = rowOfPerson(m_after, id);
        return m_row != kNotInPose;
    }
    [[nodiscard]] std::size_t row() const { return m_row; }
    [[nodiscard]] double since() const { return m_since; }
    void put(SessionPose& pose, std::size_t row) const;
    [[nodiscard]] ClipPlace clip() const;

private:
    const SessionPose& m_before;
    const SessionPose& m_after;
    double m_since; ///< the earlier step
    double m_share = 0.0;
    std::size_t m_row = kNotInPose;
    std::size_t m_next = kNotInPose;
};

/// Where he is.
void Source::put(SessionPose& pose, std::size_t row) const
{
    const SessionPose& a = m_before;
    const glm::vec3 from(a.x[m_row], a.y[m_row], a.z[m_row]);
    glm::vec3 place = from;
    float heading = a.headings[m_row];
    if (m_next != kNotInPose) {
        const SessionPose& b = m_after;
        const glm::vec3 to(b.x[m_next], b.y[m_next], b.z[m_next]);
        const auto share = static_cast<float>(m_share);
        if (glm::distance(from, to) <= kLongestStep) {
            place = from + (to - from) * share;
        }
        heading = wrappedRadians(heading + wrappedRadians(b.headings[m_next] - heading) * share);
    }
    pose.x[row] = place.x;
    pose.y[row] = place.y;
    pose.z[row] = place.z;
    pose.headings[row] = heading;
    pose.gone -= (pose.flags[row] & kPoseGone) != 0 ? 1U : 0U;
    pose.flags[row] = static_cast<std::uint8_t>(a.flags[m_row] & ~unsigned{kPoseClock});
    pose.gone += (pose.flags[row] & kPoseGone) != 0 ? 1U : 0U;
    if (pose.hasSeats && a.hasSeats) {
        pose.seats[row] = a.seats[m_row];
    }
}

ClipPlace Source::clip() const
{
    ClipPlace clip = clipIn(m_before, m_row);
    const bool goesOn = m_next != kNotInPose && clip.isLooped &&
                        m_after.clips[m_next] == m_before.clips[m_row] &&
                        m_after.rates[m_next] != m_before.rates[m_row];
    if (goesOn) { // feet keep up with who speeds up
        const double turn = std::remainder(clipIn(m_after, m_next).place - clip.place, 1.0);
        clip.place += m_share * turn;
    } else {
        clip.place = advanced(clip, m_since);
    }
    clip.place = wholeTurns(clip, clip.place);
    return clip;
}

void addFade(SessionPose& pose, std::size_t row, const ClipPlace& from, double begin)
{
    pose.fades.push_back({static_cast<std::uint32_t>(row), from, begin});
}

/// His clip and what it fades from, at his own moment.
void putClips(SessionPose& pose, std::size_t row, const ClipPlace& own, ClipPlace rest,
              const OwnMoment& moment)
{
    rest.place = wholeTurns(rest, advanced(rest, pose.seconds));
    ClipPlace shown = own;
    shown.rate *= static_cast<float>(moment.pace);
    if (moment.pace <= 0.0) {
        if (moment.heldFor >= 0.0 && moment.heldFor < kFadeSeconds) {
            addFade(pose, row, shown, pose.seconds - moment.heldFor);
        }
        shown = rest;
    } else if (moment.letGoFor < kFadeSeconds) {
        addFade(pose, row, rest, pose.seconds - moment.letGoFor);
    }
    putClip(pose, row, shown);
}

/// Each once, whatever a file says.
std::vector<model::IndividualId> peopleOf(const HandEdit& edit)
{
    const std::set<model::IndividualId> people(edit.people.begin(), edit.people.end());
    return {people.begin(), people.end()};
}

bool isOfTime(HandEditKind kind)
{
    return kind == HandEditKind::Shift || kind == HandEditKind::Pace;
}

/// People of the scene, as they are where a take does not move them, and what they rest with.
class ScenePeople
{
public:
    explicit ScenePeople(const model::Scene& scene) : m_people(scene.population)
    {
        m_tables.read(scene.templates);
    }
    /// Adds somebody who is in the scene.
    void add(SessionPose& pose, model::IndividualId id) const;
    /// Nothing: the scene does not have him, or his template is not there.
    [[nodiscard]] std::optional<ClipPlace> of(model::IndividualId id) const
    {
        const std::size_t row = m_people.rowOf(id);
        if (row == model::Population::npos) {
            return std::nullopt;
        }
        const auto table = m_tables.indexOf(m_people.column(model::columns::templateId)[row]);
        const model::TemplateEntry* entry = m_tables.entry(table);
        if (entry == nullptr || !entry->asset) {
            return std::nullopt;
        }
        const auto clip = model::clipColumnOf(*entry, entry->asset->defaultClip);
        const TemplateTables::ClipFacts* facts = clip ? m_tables.clip(table, *clip) : nullptr;
        if (facts == nullptr) {
            return std::nullopt;
        }
        return ClipPlace{*clip, facts->isLooped, 1.0F, facts->seconds, 0.0};
    }
    [[nodiscard]] bool isSeated(model::IndividualId id) const
    {
        const std::size_t row = m_people.rowOf(id);
        return row != model::Population::npos &&
               m_people.column(model::columns::seat)[row] != model::kNoSeat;
    }

private:
    const model::Population& m_people;
    TemplateTables m_tables;
};

void ScenePeople::add(SessionPose& pose, model::IndividualId id) const
{
    namespace keys = model::columns;
    const std::size_t row = m_people.rowOf(id);
    if (row == model::Population::npos) {
        return;
    }
    const glm::vec3 place = m_people.column(keys::position)[row];
    const std::uint16_t clip = m_people.column(keys::clip)[row];
    const auto table = m_tables.indexOf(m_people.column(keys::templateId)[row]);
    const TemplateTables::ClipFacts* facts = m_tables.clip(table, clip);
    const bool isLooped = facts == nullptr || facts->isLooped;
    pose.ids.push_back(id);
    pose.x.push_back(place.x);
    pose.y.push_back(place.y);
    pose.z.push_back(place.z);
    pose.headings.push_back(m_people.column(keys::heading)[row]);
    pose.clips.push_back(clip);
    pose.rates.push_back(m_people.column(keys::playbackSpeed)[row]);
    pose.clipSeconds.push_back(facts != nullptr ? facts->seconds : 0.0F);
    pose.places.push_back(m_people.column(keys::phase)[row]);
    pose.flags.push_back(static_cast<std::uint8_t>(unsigned{kPoseLive} | unsigned{kPoseClock} |
                                                   (isLooped ? unsigned{kPoseLooped} : 0U)));
    pose.seats.push_back(m_people.column(keys::seat)[row]);
}

/// Rows of poses, one after the other.
using RowOrder = std::vector<std::pair<const SessionPose*, std::size_t>>;

void fillRows(SessionPose& pose, const RowOrder& order)
{
    const auto fill = [&](auto member) {
        auto& column = pose.*member;
        column.clear();
        column.reserve(order.size());
        for (const auto& [from, row] : order) {
            column.push_back((from->*member)[row]);
        }
    };
    fill(&SessionPose::ids);
    fill(&SessionPose::x);
    fill(&SessionPose::y);
    fill(&SessionPose::z);
    fill(&SessionPose::headings);
    fill(&SessionPose::clips);
    fill(&SessionPose::rates);
    fill(&SessionPose::clipSeconds);
    fill(&SessionPose::places);
    fill(&SessionPose::flags);
    if (pose.hasSeats) {
        fill(&SessionPose::seats);
    }
}

float easedShare(double share)
{
    const auto s = static_cast<float>(std::clamp(share, 0.0, 1.0));
    return s * s * (3.0F - 2.0F * s);
}

} // namespace

model::Result<std::unique_ptr<EditedTake>> EditedTake::open(const model::Take& take,
                                                            const model::Scene& scene)
{
    if (!take.motion) {
        return model::Error{take.problem};
    }
    if (take.edits.size() > model::kMostHandEdits) {
        return model::Error{
            QT_TRANSLATE_NOOP("Messages", "The take \"%1\" has %2 edits by hand; there can be %3. "
                                          "Delete some."),
            take.name, take.edits.size(), model::kMostHandEdits};
    }
    auto motion = openTake(take.motion);
    if (!motion) {
        return motion.error();
    }
    return std::make_unique<EditedTake>(
        std::move(motion).value(), take.areEditsOn ? take.edits : std::vector<HandEdit>(), scene);
}

EditedTake::EditedTake(std::shared_ptr<MotionCache> motion, std::vector<HandEdit> edits,
                       const model::Scene& scene)
    : m_motion(std::move(motion)), m_reader(m_motion)
{
    const MotionCache::Extent extent = m_motion->extent();
    m_first = extent.first;
    m_last = extent.last;
    std::erase_if(edits, [](const HandEdit& edit) { return !edit.isOn || edit.people.empty(); });
    gather(edits, scene);
}

/// What begins between two steps is seen at once: from the one before on.
HandEdit EditedTake::fromItsStep(HandEdit edit)
{
    const SessionPosePtr step = edit.begin > m_first && edit.begin <= m_last
                                    ? m_reader.around(edit.begin + kWithinStep).first
                                    : nullptr;
    edit.begin = step ? step->seconds : edit.begin;
    return edit;
}

/// Who is moved by the same edits of time has the same own time.
void EditedTake::gather(const std::vector<HandEdit>& edits, const model::Scene& scene)
{
    std::map<model::IndividualId, std::vector<std::size_t>> ofPeople;
    for (std::size_t i = 0; i < edits.size(); ++i) {
        std::vector<model::IndividualId> edited = peopleOf(edits[i]);
        if (edits[i].kind == HandEditKind::Swap) {
            m_swaps.push_back(
                {fromItsStep(edits[i]), SwappedPeople(scene, edited, edits[i].templates)});
            continue;
        }
        if (!isOfTime(edits[i].kind)) {
            m_layers.push_back({fromItsStep(edits[i]), std::move(edited), {}});
            continue;
        }
        for (const model::IndividualId id : edited) {
            ofPeople[id].push_back(i);
        }
    }
    std::map<std::vector<std::size_t>, std::vector<model::IndividualId>> together;
    for (const auto& [id, list] : ofPeople) {
        together[list].push_back(id);
    }
    const ScenePeople people(scene);
    std::set<model::IndividualId> everybody;
    for (const HandEdit& edit : edits) {
        everybody.insert(edit.people.begin(), edit.people.end());
    }
    for (const model::IndividualId id : everybody) {
        people.add(m_scene, id);
    }
    for (const auto& [list, ids] : together) {
        std::vector<HandEdit> times;
        times.reserve(list.size());
        for (const std::size_t i : list) {
            times.push_back(edits[i]);
        }
        std::vector<Person> members;
        members.reserve(ids.size());
        for (const model::IndividualId id : ids) {
            const double phase = static_cast<double>(id) * kPhaseOfPerson;
            members.push_back({id, people.of(id), phase - std::floor(phase), people.isSeated(id)});
        }
        m_groups.push_back(
            {std::move(members), EditedTime(times, m_first, m_last), MotionReader(m_motion)});
    }
}

void EditedTake::setPeople(const model::Population& people)
{
    for (Swap& swap : m_swaps) {
        if (swap.people.setPeople(people)) {
            m_from = {};
            m_made = {};
        }
    }
}

std::pair<SessionPosePtr, SessionPosePtr> EditedTake::around(double seconds)
{
    const auto [before, after] = m_reader.around(seconds);
    if (!before || !isEdited()) {
        return {before, after};
    }
    const SessionPosePtr first = edited(before);
    return {first, after == before ? first : edited(after)};
}

SessionPosePtr EditedTake::edited(const SessionPosePtr& pose)
{
    if (!pose || !isEdited()) {
        return pose;
    }
    if (pose == m_from.first) {
        return m_made.first;
    }
    if (pose == m_from.second) {
        return m_made.second;
    }
    auto made = std::make_shared<SessionPose>(*inOwnTime(withEverybody(pose)));
    for (Layer& layer : m_layers) {
        apply(*made, layer);
    }
    std::set<model::IndividualId> swapped; // by the last edit that says so
    for (std::size_t i = m_swaps.size(); i-- > 0;) {
        if (shareOf(m_swaps[i].edit, pose->seconds) > 0.0F) {
            m_swaps[i].people.apply(*made, swapped);
        }
    }
    m_from = {m_from.second, pose};
    m_made = {m_made.second, made};
    return made;
}

/// Who is edited has a row also where the take leaves him as the scene has him.
SessionPosePtr EditedTake::withEverybody(const SessionPosePtr& pose) const
{
    const auto isThere = [&pose](model::IndividualId id) {
        return std::ranges::binary_search(pose->ids, id);
    };
    if (std::ranges::all_of(m_scene.ids, isThere)) {
        return pose;
    }
    RowOrder order;
    std::vector<std::uint32_t> rows; // of the pose's people now
    std::size_t next = 0;
    for (std::size_t row = 0; row <= pose->ids.size(); ++row) {
        const bool isEnd = row == pose->ids.size();
        for (; next < m_scene.ids.size() && (isEnd || m_scene.ids[next] <= pose->ids[row]);
             ++next) {
            if (isEnd || m_scene.ids[next] != pose->ids[row]) {
                order.emplace_back(&m_scene, next);
            }
        }
        if (!isEnd) {
            rows.push_back(static_cast<std::uint32_t>(order.size()));
            order.emplace_back(pose.get(), row);
        }
    }
    auto made = std::make_shared<SessionPose>(*pose);
    fillRows(*made, order);
    for (PoseFade& fade : made->fades) {
        fade.person = rows[fade.person];
    }
    return made;
}

SessionPosePtr EditedTake::inOwnTime(const SessionPosePtr& pose)
{
    if (m_groups.empty()) {
        return pose;
    }
    auto made = std::make_shared<SessionPose>(*pose);
    std::set<std::uint32_t> moved;
    std::vector<PoseFade> fades;
    made->fades.clear();
    for (Group& group : m_groups) {
        const OwnMoment moment = group.time.at(pose->seconds);
        const auto [first, next] = group.reader.around(moment.seconds + kWithinStep);
        if (!first) {
            continue; // what it is shown by says that it is damaged
        }
        const SessionPosePtr before = withEverybody(first);
        const SessionPosePtr after = next == first ? before : withEverybody(next);
        Source source(*before, *after, moment.seconds);
        for (const Person& person : group.people) {
            const std::size_t row = rowOfPerson(*made, person.id);
            if (row == kNotInPose || !source.find(person.id)) {
                continue;
            }
            source.put(*made, row);
            const ClipPlace own = source.clip();
            const bool isSeated =
                before->hasSeats ? before->seats[source.row()] != model::kNoSeat : person.isSeated;
            ClipPlace rest = isSeated || !person.rest ? own : *person.rest;
            rest.place = person.phase;
            putClips(*made, row, own, rest, moment);
            moved.insert(static_cast<std::uint32_t>(row));
        }
    }
    for (const PoseFade& fade : pose->fades) {
        if (!moved.contains(fade.person)) {
            made->fades.push_back(fade);
        }
    }
    std::ranges::sort(made->fades, {}, &PoseFade::person);
    return made;
}

/// From where each looks when the edit begins.
void EditedTake::findOffsets(Layer& layer)
{
    MotionReader reader(m_motion);
    const double begin = std::clamp(layer.edit.begin, m_first, m_last);
    const SessionPosePtr read = reader.around(begin + kWithinStep).first;
    const SessionPosePtr pose = read ? inOwnTime(withEverybody(read)) : nullptr;
    layer.offsets.assign(layer.people.size(), glm::vec2(0.0F));
    for (std::size_t i = 0; pose && i < layer.people.size(); ++i) {
        const std::size_t row = rowOfPerson(*pose, layer.people[i]);
        if (row != kNotInPose) {
            const float heading = pose->headings[row];
            layer.offsets[i] = layer.edit.aside * glm::vec2(-std::cos(heading), std::sin(heading));
        }
    }
}

/// 0..1 of an edit that counts at a time.
float EditedTake::shareOf(const HandEdit& edit, double seconds) const
{
    const bool hasEnd = edit.end > edit.begin;
    if (seconds < edit.begin - kWithinStep || (hasEnd && seconds >= edit.end - kWithinStep)) {
        return 0.0F;
    }
    if (edit.kind == HandEditKind::Hide || edit.kind == HandEditKind::Swap) {
        return 1.0F;
    }
    const double metres = std::abs(static_cast<double>(edit.aside));
    const double wanted = std::max(kAsideSeconds, metres / kAsideMetresPerSecond);
    const double ramp = hasEnd ? std::min(wanted, kAsideShare * (edit.end - edit.begin)) : wanted;
    const double in = edit.begin > m_first ? (seconds - edit.begin) / ramp : 1.0;
    const double out = hasEnd && edit.end < m_last ? (edit.end - seconds) / ramp : 1.0;
    return easedShare(std::min(in, out));
}

void EditedTake::apply(SessionPose& pose, Layer& layer)
{
    const float share = shareOf(layer.edit, pose.seconds);
    if (share <= 0.0F) {
        return;
    }
    const bool hides = layer.edit.kind == HandEditKind::Hide;
    if (!hides && layer.offsets.empty()) {
        findOffsets(layer);
    }
    for (std::size_t i = 0; i < layer.people.size(); ++i) {
        const std::size_t row = rowOfPerson(pose, layer.people[i]);
        if (row == kNotInPose) {
            continue;
        }
        if (hides) {
            pose.gone += (pose.flags[row] & kPoseGone) != 0 ? 0U : 1U;
            pose.flags[row] |= kPoseGone;
            pose.y[row] = kGoneHeight;
        } else {
            pose.x[row] += layer.offsets[i].x * share;
            pose.z[row] += layer.offsets[i].y * share;
        }
    }
}

} // namespace crowd::behavior
