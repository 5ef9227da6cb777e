// SPDX-License-Identifier: MIT
#include "behavior/session/SessionPose.h"

#include <algorithm>
#include <cmath>

namespace crowd::behavior {

namespace {

constexpr float kFarBelow = -1e5F;
constexpr float kJumpMetres = 1.5F; ///< further in one step is no walk

struct Columns
{
    std::vector<model::IndividualId> ids;
    std::vector<glm::vec3> positions;
    std::vector<float> headings;
    std::vector<std::uint16_t> clips;
    std::vector<float> phases;
    std::vector<float> rates;
    std::vector<model::SeatId> seats;

    explicit Columns(std::size_t people)
    {
        ids.reserve(people);
        positions.reserve(people);
        headings.reserve(people);
        clips.reserve(people);
        phases.reserve(people);
        rates.reserve(people);
        seats.reserve(people);
    }
};

/// Phase at which a reader who adds the time that has passed comes to the place at `seconds`.
float phaseFor(const PersonPose& pose, double place, double seconds)
{
    if (pose.clipSeconds <= 0.0F) {
        return 0.0F;
    }
    const double phase =
        place - seconds * static_cast<double>(pose.rate) / static_cast<double>(pose.clipSeconds);
    return static_cast<float>(pose.isLooped ? phase - std::floor(phase) : phase);
}

/// Place in a clip at a share of the time from one step to the next, as far as the next is known:
/// people speed up and slow down, and their feet must keep up with them.
double placeBetween(double before, double after, float rateBefore, float rateAfter,
                    float clipSeconds, double share, double since)
{
    if (clipSeconds <= 0.0F) {
        return before;
    }
    if (rateBefore == rateAfter) {
        return before + since * static_cast<double>(rateBefore) / static_cast<double>(clipSeconds);
    }
    return before + share * std::remainder(after - before, 1.0);
}

/// The clip that somebody comes from, as long as any of it is left.
void addFade(const PersonPose& pose, const PersonPose& next, std::size_t row, double share,
             double poseSeconds, double seconds, std::vector<model::ClipFade>& fades)
{
    const double since = seconds - pose.fadeBegin;
    if (pose.fadeBegin < 0.0 || since < 0.0 || since >= kFadeSeconds || pose.isGone) {
        return;
    }
    const ClipPlace& from = pose.from;
    const ClipPlace& to = next.fadeBegin == pose.fadeBegin ? next.from : from;
    double place = placeBetween(from.place, to.place, from.rate, to.rate, from.clipSeconds, share,
                                seconds - poseSeconds);
    place = from.isLooped ? place - std::floor(place) : std::clamp(place, 0.0, 1.0);
    fades.push_back({static_cast<std::uint32_t>(row), from.clip, static_cast<float>(place),
                     static_cast<float>(since / kFadeSeconds)});
}

void put(const PersonPose& from, const PersonPose& to, double share, double poseSeconds,
         double seconds, Columns& columns)
{
    const auto part = static_cast<float>(share);
    glm::vec3 position = from.position + (to.position - from.position) * part;
    const glm::vec3 way = to.position - from.position;
    if (way.x * way.x + way.y * way.y + way.z * way.z > kJumpMetres * kJumpMetres) {
        position = part < 0.5F ? from.position : to.position;
    }
    if (from.isGone) {
        position = {0.0F, kFarBelow, 0.0F};
    }
    const float turn = wrappedRadians(to.heading - from.heading);
    const PersonPose& next = from.clip == to.clip && from.isLooped ? to : from;
    const double place = placeBetween(from.place, next.place, from.rate, next.rate,
                                      from.clipSeconds, share, seconds - poseSeconds);
    columns.ids.push_back(from.id);
    columns.positions.push_back(position);
    columns.headings.push_back(wrappedRadians(from.heading + turn * part));
    columns.clips.push_back(from.clip);
    columns.phases.push_back(phaseFor(from, place, seconds));
    columns.rates.push_back(from.rate);
    columns.seats.push_back(from.seat);
}

/// Tints, heights and tags that rules have set; ids that are not there are passed over.
void applyLooks(const std::vector<SetLook>& looks, model::Population& people)
{
    namespace keys = model::columns;
    const auto write = [&](const auto& key, const auto& valueOf) {
        using Value = std::remove_cvref_t<decltype(*valueOf(looks.front()))>;
        std::vector<model::IndividualId> ids;
        std::vector<Value> values;
        for (const SetLook& look : looks) {
            const auto value = valueOf(look);
            if (value && people.rowOf(look.id) != model::Population::npos) {
                ids.push_back(look.id);
                values.push_back(*value);
            }
        }
        if (!ids.empty()) {
            people.setValues<Value>(key, ids, values);
        }
    };
    if (looks.empty()) {
        return;
    }
    for (int slot = 0; slot < 8; ++slot) {
        write(keys::tint(slot), [slot](const SetLook& look) {
            return (look.tinted >> slot & 1) != 0
                       ? std::optional(look.tints[static_cast<std::size_t>(slot)])
                       : std::nullopt;
        });
    }
    write(keys::height, [](const SetLook& look) { return look.height; });
    write(keys::tags, [](const SetLook& look) { return look.tags; });
}

} // namespace

void applyPose(const SessionPose& before, const SessionPose& after, model::CrowdFrame& frame)
{
    if (before.looks) {
        applyLooks(*before.looks, frame.population);
    }
    const double length = after.seconds - before.seconds;
    const double share =
        length > 0.0 ? std::clamp((frame.seconds - before.seconds) / length, 0.0, 1.0) : 0.0;
    // Later than the last step: it stands until the next one is done.
    const double seconds = length > 0.0 ? frame.seconds : before.seconds;
    Columns columns(before.people.size());
    frame.fades.clear();
    const auto present = frame.population.ids();
    std::size_t row = 0;
    std::size_t next = 0;
    for (const PersonPose& pose : before.people) {
        while (row < present.size() && present[row] < pose.id) {
            ++row;
        }
        while (next < after.people.size() && after.people[next].id < pose.id) {
            ++next;
        }
        if (row >= present.size() || present[row] != pose.id) {
            continue;
        }
        const bool goesOn = next < after.people.size() && after.people[next].id == pose.id;
        const PersonPose& then = goesOn ? after.people[next] : pose;
        addFade(pose, then, row, share, before.seconds, seconds, frame.fades);
        put(pose, then, share, before.seconds, seconds, columns);
        // The reader's clock is the frame's, wherever the pose's stands.
        if (seconds != frame.seconds) {
            const double place = pose.place;
            columns.phases.back() = phaseFor(pose, place, frame.seconds);
        }
    }
    if (columns.ids.empty()) {
        return;
    }
    model::Population& people = frame.population;
    namespace keys = model::columns;
    people.setValues<glm::vec3>(keys::position, columns.ids, columns.positions);
    people.setValues<float>(keys::heading, columns.ids, columns.headings);
    people.setValues<std::uint16_t>(keys::clip, columns.ids, columns.clips);
    people.setValues<float>(keys::phase, columns.ids, columns.phases);
    people.setValues<float>(keys::playbackSpeed, columns.ids, columns.rates);
    if (before.hasSeats) {
        people.setValues<model::SeatId>(keys::seat, columns.ids, columns.seats);
    }
}

} // namespace crowd::behavior
