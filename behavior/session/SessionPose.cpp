// SPDX-License-Identifier: MIT
#include "behavior/session/SessionPose.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>

#include "behavior/agents/RecalledValues.h"
#include "behavior/agents/Turning.h"

namespace crowd::behavior {

namespace {

constexpr float kJumpMetres = 1.5F; ///< further in one step is no walk

/// The largest whole number that is not above it; for numbers far below 2^51. (The library's needs
/// a call each.)
double wholeBelow(double value)
{
    constexpr double kRounds = 6755399441055744.0;
    const double nearest = (value + kRounds) - kRounds;
    return nearest - static_cast<double>(nearest > value); // a guess would be wrong half the time
}

/// Place in a clip at a share of the time from one step to the next, as far as the next is known:
/// people speed up and slow down, and their feet must keep up with them.
double placeBetween(const ClipPlace& before, const ClipPlace& after, double share, double since)
{
    if (before.clipSeconds <= 0.0F) {
        return before.place;
    }
    if (before.rate == after.rate) {
        return before.place +
               since * static_cast<double>(before.rate) / static_cast<double>(before.clipSeconds);
    }
    return before.place + share * std::remainder(after.place - before.place, 1.0);
}

/// A moment between two steps, and who of the people in them is where.
class Between
{
public:
    Between(const SessionPose& before, const SessionPose& after, double seconds)
        : m_before(before), m_after(after), m_seconds(seconds)
    {
        const double length = after.seconds - before.seconds;
        m_share = length > 0.0 ? std::clamp((seconds - before.seconds) / length, 0.0, 1.0) : 0.0;
        // Later than the last step: it stands until the next one is done.
        m_stand = length > 0.0 ? seconds : before.seconds;
    }

    /// Finds people of one list in the other, both ascending: `kNone` for who is not there.
    static std::vector<std::uint32_t> find(std::span<const model::IndividualId> whom,
                                           std::span<const model::IndividualId> where);
    static constexpr std::uint32_t kNone = 0xFFFFFFFFU;

    void apply(model::CrowdFrame& frame) const;

private:
    void addFades(std::span<const std::uint32_t> rows, std::vector<model::ClipFade>& fades) const;
    /// Somebody in the later step; who is not there any more is as he was in the one before.
    struct Then
    {
        const SessionPose& pose;
        std::size_t person;
    };
    [[nodiscard]] inline glm::vec3 position(std::size_t person, const Then& then) const;
    [[nodiscard]] inline float heading(std::size_t person, const Then& then) const;
    [[nodiscard]] inline float phase(std::size_t person, const Then& then) const;

    const SessionPose& m_before;
    const SessionPose& m_after;
    double m_seconds; ///< the reader's clock
    double m_stand;   ///< the time that is shown
    double m_share;   ///< 0..1 from one step to the next
};

std::vector<std::uint32_t> Between::find(std::span<const model::IndividualId> whom,
                                         std::span<const model::IndividualId> where)
{
    std::vector<std::uint32_t> found(whom.size());
    if (std::ranges::equal(whom, where)) {
        std::iota(found.begin(), found.end(), 0U);
        return found;
    }
    std::size_t row = 0;
    for (std::size_t i = 0; i < whom.size(); ++i) {
        while (row < where.size() && where[row] < whom[i]) {
            ++row;
        }
        found[i] =
            row < where.size() && where[row] == whom[i] ? static_cast<std::uint32_t>(row) : kNone;
    }
    return found;
}

glm::vec3 Between::position(std::size_t person, const Then& then) const
{
    const auto part = static_cast<float>(m_share);
    const glm::vec3 from(m_before.x[person], m_before.y[person], m_before.z[person]);
    const glm::vec3 to(then.pose.x[then.person], then.pose.y[then.person],
                       then.pose.z[then.person]);
    const glm::vec3 way = to - from;
    const bool jumps = way.x * way.x + way.y * way.y + way.z * way.z > kJumpMetres * kJumpMetres;
    const float share = !jumps ? part : part < 0.5F ? 0.0F : 1.0F;
    return from + way * share;
}

float Between::heading(std::size_t person, const Then& then) const
{
    const float from = m_before.headings[person];
    const float turn = wrappedRadians(then.pose.headings[then.person] - from);
    return wrappedRadians(from + turn * static_cast<float>(m_share));
}

/// Phase at which a reader who adds the time that has passed comes to the place that is shown.
float Between::phase(std::size_t person, const Then& then) const
{
    const float seconds = m_before.clipSeconds[person];
    const float rate = m_before.rates[person];
    const auto place = static_cast<double>(m_before.places[person]);
    const double perSecond =
        static_cast<double>(rate) / static_cast<double>(seconds > 0.0F ? seconds : 1.0F);
    const unsigned flags = m_before.flags[person];
    const bool isLooped = (flags & kPoseLooped) != 0;
    const bool goesOn = m_before.clips[person] == then.pose.clips[then.person] && isLooped;
    const float nextRate = goesOn ? then.pose.rates[then.person] : rate;
    const double turn = goesOn ? static_cast<double>(then.pose.places[then.person]) - place : 0.0;
    const double since = rate == nextRate ? (m_stand - m_before.seconds) * perSecond
                                          : m_share * (turn - wholeBelow(turn + 0.5));
    const bool isClock = (flags & kPoseClock) != 0;
    const double phase = place + (isClock ? m_stand * perSecond : since) - m_seconds * perSecond;
    const double shown = isLooped ? phase - wholeBelow(phase) : phase;
    return seconds > 0.0F ? static_cast<float>(shown) : 0.0F;
}

/// The clips that people come from, as long as any of them is left.
void Between::addFades(std::span<const std::uint32_t> rows,
                       std::vector<model::ClipFade>& fades) const
{
    std::size_t next = 0;
    for (const PoseFade& fade : m_before.fades) {
        const double since = m_stand - fade.begin;
        const std::uint32_t row = rows[fade.person];
        if (row == kNone || since < 0.0 || since >= kFadeSeconds ||
            (m_before.flags[fade.person] & kPoseGone) != 0) {
            continue;
        }
        const model::IndividualId id = m_before.ids[fade.person];
        while (next < m_after.fades.size() && m_after.ids[m_after.fades[next].person] < id) {
            ++next;
        }
        const bool goesOn = next < m_after.fades.size() &&
                            m_after.ids[m_after.fades[next].person] == id &&
                            m_after.fades[next].begin == fade.begin;
        const ClipPlace& to = goesOn ? m_after.fades[next].from : fade.from;
        double place = placeBetween(fade.from, to, m_share, m_stand - m_before.seconds);
        place = fade.from.isLooped ? place - std::floor(place) : std::clamp(place, 0.0, 1.0);
        fades.push_back({row, fade.from.clip, static_cast<float>(place),
                         static_cast<float>(since / kFadeSeconds)});
    }
}

/// Columns one after the other, so that each loop does the same to many people.
void Between::apply(model::CrowdFrame& frame) const
{
    namespace keys = model::columns;
    model::Population& people = frame.population;
    frame.fades.clear();
    // Mostly everybody is there, and nobody else.
    const bool isSame = std::ranges::equal(m_before.ids, people.ids()) &&
                        std::ranges::equal(m_before.ids, m_after.ids);
    const std::vector<std::uint32_t> rows = find(m_before.ids, people.ids());
    const std::vector<std::uint32_t> others = find(m_before.ids, m_after.ids);
    addFades(rows, frame.fades);
    const auto write = [&](const auto& key, const auto& valueOf) {
        if (isSame) {
            const auto column = people.edit(key);
            for (std::size_t i = 0; i < column.size(); ++i) {
                column[i] = valueOf(i, Then{m_after, i});
            }
            return;
        }
        const auto column = people.edit(key, rows);
        for (std::size_t i = 0; i < rows.size(); ++i) {
            if (rows[i] != kNone) {
                const bool isThere = others[i] != kNone;
                column[rows[i]] =
                    valueOf(i, isThere ? Then{m_after, others[i]} : Then{m_before, i});
            }
        }
    };
    using Index = std::size_t;
    write(keys::position, [this](Index i, const Then& then) { return position(i, then); });
    write(keys::heading, [this](Index i, const Then& then) { return heading(i, then); });
    write(keys::phase, [this](Index i, const Then& then) { return phase(i, then); });
    write(keys::clip, [this](Index i, const Then&) { return m_before.clips[i]; });
    write(keys::playbackSpeed, [this](Index i, const Then&) { return m_before.rates[i]; });
    if (m_before.hasSeats) {
        write(keys::seat, [this](Index i, const Then&) { return m_before.seats[i]; });
    }
}

/// Columns of a frame that come from the pose itself.
constexpr std::array kPosed{model::ColumnId::Position, model::ColumnId::Heading,
                            model::ColumnId::Clip,     model::ColumnId::Phase,
                            model::ColumnId::Seat,     model::ColumnId::PlaybackSpeed};

/// What rules have set of all other properties; ids that are not there are passed over.
void applyOverrides(const OverrideColumns& overrides, model::Population& people)
{
    for (std::size_t index = 0; index < model::kColumnCount; ++index) {
        const auto id = static_cast<model::ColumnId>(index);
        const OverrideColumn* column = overrides.column(id);
        if (column != nullptr && std::ranges::find(kPosed, id) == kPosed.end()) {
            const OverrideColumn there = presentIn(people, id, *column);
            if (!there.ids.empty()) {
                people.setValues(id, there.ids, there.bytes);
            }
        }
    }
}

/// Rows of those whose clip is not the one that they play by the clock.
std::vector<bool> whoIsBusy(const SessionPose& pose, const model::Population& people)
{
    std::vector<bool> isBusy(people.size());
    const std::vector<std::uint32_t> rows = Between::find(pose.ids, people.ids());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (rows[i] != Between::kNone && (pose.flags[i] & kPoseClock) == 0) {
            isBusy[rows[i]] = true;
        }
    }
    return isBusy;
}

} // namespace

void applyPose(const SessionPose& before, const SessionPose& after, model::CrowdFrame& frame)
{
    frame.lightCues = before.lightCues;
    if (before.recalled && frame.population.version() == before.sceneVersion) {
        frame.population = before.people;
    } else if (before.recalled) {
        writeColumns(*before.recalled, frame.population); // the scene has been edited since
    }
    if (before.overrides) {
        applyOverrides(*before.overrides, frame.population);
    }
    if (!before.ids.empty()) {
        Between(before, after, frame.seconds).apply(frame);
    } else {
        frame.fades.clear();
    }
    if (before.stateFades) {
        applyFades(*before.stateFades, whoIsBusy(before, frame.population), frame);
    }
}

} // namespace crowd::behavior
