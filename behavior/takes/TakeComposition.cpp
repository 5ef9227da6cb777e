// SPDX-License-Identifier: MIT
#include "behavior/takes/TakeComposition.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "behavior/agents/Turning.h"
#include "behavior/takes/PoseClip.h"

namespace crowd::behavior {

namespace {

/// Where he is in his clip at the pose's time.
ClipPlace clipThen(const SessionPose& pose, std::size_t row)
{
    ClipPlace place = clipOf(pose, row);
    if ((pose.flags[row] & kPoseClock) != 0) {
        place.place = place.placeAt(pose.seconds);
        place.place -= place.isLooped ? std::floor(place.place) : 0.0;
    }
    return place;
}

/// Puts people of poses into one, by ascending ids.
class PoseBuilder
{
public:
    PoseBuilder(SessionPose& pose, const model::Population& scene) : m_pose(pose), m_scene(scene) {}

    void add(const SessionPose& from, std::size_t row)
    {
        m_pose.ids.push_back(from.ids[row]);
        m_pose.x.push_back(from.x[row]);
        m_pose.y.push_back(from.y[row]);
        m_pose.z.push_back(from.z[row]);
        m_pose.headings.push_back(from.headings[row]);
        m_pose.clips.push_back(from.clips[row]);
        m_pose.rates.push_back(from.rates[row]);
        m_pose.clipSeconds.push_back(from.clipSeconds[row]);
        m_pose.places.push_back(from.places[row]);
        m_pose.flags.push_back(from.flags[row]);
        if (m_pose.hasSeats) {
            m_pose.seats.push_back(seatOf(from, row));
        }
        m_pose.gone += (from.flags[row] & kPoseGone) != 0 ? 1U : 0U;
    }
    /// Of somebody who was just added.
    void addFade(const PoseFade& fade)
    {
        m_pose.fades.push_back(
            {static_cast<std::uint32_t>(m_pose.ids.size() - 1), fade.from, fade.begin});
    }

private:
    [[nodiscard]] model::SeatId seatOf(const SessionPose& from, std::size_t row) const
    {
        if (from.hasSeats) {
            return from.seats[row];
        }
        const std::size_t there = m_scene.rowOf(from.ids[row]);
        return there == model::Population::npos ? model::kNoSeat
                                                : m_scene.column(model::columns::seat)[there];
    }

    SessionPose& m_pose;
    const model::Population& m_scene;
};

/// Who fades, in the order of the rows of a pose.
const PoseFade* fadeOf(const SessionPose& pose, std::size_t row)
{
    const auto found = std::ranges::lower_bound(pose.fades, static_cast<std::uint32_t>(row), {},
                                                &PoseFade::person);
    return found != pose.fades.end() && found->person == row ? &*found : nullptr;
}

/// On the way from where he is in one pose to where he is in the other.
void blendLast(SessionPose& pose, const SessionPose& to, std::size_t row, float share)
{
    const auto mixed = [share](float a, float b) { return a + (b - a) * share; };
    pose.x.back() = mixed(pose.x.back(), to.x[row]);
    pose.y.back() = mixed(pose.y.back(), to.y[row]);
    pose.z.back() = mixed(pose.z.back(), to.z[row]);
    const float turn = wrappedRadians(to.headings[row] - pose.headings.back());
    pose.headings.back() = wrappedRadians(pose.headings.back() + turn * share);
}

/// Values of one property, of people from several sources.
class Values
{
public:
    explicit Values(std::size_t stride) : m_stride(stride) {}

    template<class Meant>
    void take(const OverrideColumn* from, const Meant& isMeant)
    {
        for (std::size_t i = 0; from != nullptr && i < from->ids.size(); ++i) {
            if (isMeant(from->ids[i])) {
                m_values.emplace_back(from->ids[i], &from->bytes[i * m_stride]);
            }
        }
    }
    [[nodiscard]] OverrideColumn column()
    {
        std::ranges::sort(m_values, {}, [](const auto& value) { return value.first; });
        OverrideColumn column;
        column.ids.reserve(m_values.size());
        column.bytes.reserve(m_values.size() * m_stride);
        for (const auto& [who, bytes] : m_values) {
            column.ids.push_back(who);
            column.bytes.insert(column.bytes.end(), bytes, bytes + m_stride);
        }
        return column;
    }

private:
    std::size_t m_stride;
    std::vector<std::pair<model::IndividualId, const std::byte*>> m_values;
};

const OverrideColumn* columnOf(const OverrideColumns* all, model::ColumnId id)
{
    return all != nullptr ? all->column(id) : nullptr;
}

} // namespace

TakeComposition::TakeComposition(std::vector<model::IndividualId> people, SessionPosePtr begin,
                                 const model::Population& scene)
    : m_people(std::move(people)), m_begin(std::move(begin)), m_scene(scene)
{
}

bool TakeComposition::isMeant(model::IndividualId id) const
{
    return std::ranges::binary_search(m_people, id);
}

/// Of others as in the take, of these as they were at the beginning and as the other run has
/// changed them since.
TakeComposition::Overrides TakeComposition::merged(const Overrides& take, const Overrides& other,
                                                   const Overrides& begin) const
{
    auto all = std::make_shared<OverrideColumns>();
    for (std::size_t i = 0; i < model::kColumnCount; ++i) {
        const auto id = static_cast<model::ColumnId>(i);
        const OverrideColumn* anew = columnOf(other.get(), id);
        const auto isAnew = [anew](model::IndividualId each) {
            return anew != nullptr && std::ranges::binary_search(anew->ids, each);
        };
        Values values(model::columnInfo(id).stride);
        values.take(columnOf(take.get(), id), [this](auto each) { return !isMeant(each); });
        values.take(anew, [this](auto each) { return isMeant(each); });
        values.take(columnOf(begin.get(), id),
                    [&](auto each) { return isMeant(each) && !isAnew(each); });
        all->put(id, values.column());
    }
    return all->isEmpty() ? nullptr : all;
}

TakeComposition::Overrides TakeComposition::remembered(Merged& last, const Overrides& take,
                                                       const Overrides& other,
                                                       const Overrides& begin) const
{
    if (!take && !other && !begin) {
        return nullptr;
    }
    if (!last.isThere || take != last.take || other != last.other) {
        last = {take, other, merged(take, other, begin), true};
    }
    return last.merged;
}

SessionPosePtr TakeComposition::composed(const SessionPosePtr& take, const SessionPose& other,
                                         float share)
{
    auto pose = std::make_shared<SessionPose>();
    pose->step = take->step;
    pose->seconds = take->seconds;
    pose->hasSeats = take->hasSeats || other.hasSeats;
    pose->overrides = remembered(m_overrides, take->overrides, other.overrides, m_begin->overrides);
    pose->recalled = remembered(m_recalled, take->recalled, other.recalled, m_begin->recalled);
    pose->numbers = take->numbers;
    pose->stateFades = take->stateFades;
    pose->lightCues = take->lightCues;
    std::ranges::set_difference(take->lit, m_people, std::back_inserter(pose->lit));
    pose->lit.insert(pose->lit.end(), other.lit.begin(), other.lit.end());
    std::ranges::sort(pose->lit);
    PoseBuilder builder(*pose, m_scene);
    std::size_t kept = 0;
    std::size_t anew = 0;
    while (kept < take->ids.size() || anew < other.ids.size()) {
        const bool isKept = anew == other.ids.size() ||
                            (kept < take->ids.size() && take->ids[kept] < other.ids[anew]);
        if (isKept && !isMeant(take->ids[kept])) {
            builder.add(*take, kept);
            if (const PoseFade* fade = fadeOf(*take, kept)) {
                builder.addFade(*fade);
            }
        }
        if (isKept) {
            ++kept;
            continue;
        }
        const bool isInBoth = kept < take->ids.size() && take->ids[kept] == other.ids[anew];
        builder.add(other, anew);
        if (isInBoth && share > 0.0F && (other.flags[anew] & kPoseGone) == 0 &&
            (take->flags[kept] & kPoseGone) == 0) {
            blendLast(*pose, *take, kept, share);
        }
        if (const PoseFade* fade = fadeOf(other, anew)) {
            builder.addFade(*fade);
        }
        kept += isInBoth ? 1U : 0U;
        ++anew;
    }
    return pose;
}

SessionPosePtr TakeComposition::fadedIn(const SessionPosePtr& take, const SessionPose& last) const
{
    if (take->seconds - last.seconds >= kFadeSeconds) {
        return take;
    }
    auto pose = std::make_shared<SessionPose>(*take);
    std::erase_if(pose->fades,
                  [&](const PoseFade& fade) { return isMeant(take->ids[fade.person]); });
    for (std::size_t row = 0; row < take->ids.size(); ++row) {
        const std::size_t then =
            isMeant(take->ids[row]) ? rowOfPerson(last, take->ids[row]) : kNotInPose;
        if (then == kNotInPose || (last.flags[then] & kPoseGone) != 0) {
            continue;
        }
        ClipPlace from = clipThen(last, then);
        from.place = from.clipSeconds > 0.0F
                         ? from.place + (take->seconds - last.seconds) *
                                            static_cast<double>(from.rate) /
                                            static_cast<double>(from.clipSeconds)
                         : from.place;
        pose->fades.push_back({static_cast<std::uint32_t>(row), from, last.seconds});
    }
    std::ranges::sort(pose->fades, {}, &PoseFade::person);
    return pose;
}

} // namespace crowd::behavior
