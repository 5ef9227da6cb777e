// SPDX-License-Identifier: MIT
#include "model/pick/ShownPeople.h"

#include <algorithm>
#include <cmath>

namespace crowd::model {

namespace {

ShownClip shownClip(const TemplateEntry& source, int clip, BakedClipPtr baked)
{
    ShownClip shown;
    shown.asset = source.asset.get();
    shown.clip = clip;
    const Bounds& box = baked->bounds;
    if (!box.isEmpty()) {
        const float x = std::max(std::abs(box.low.x), std::abs(box.high.x));
        const float z = std::max(std::abs(box.low.z), std::abs(box.high.z));
        shown.radius = std::sqrt(x * x + z * z);
        shown.low = box.low.y;
        shown.high = box.high.y;
    }
    shown.baked = std::move(baked);
    return shown;
}

} // namespace

int assetClip(const TemplateEntry& entry, std::uint16_t clipColumn)
{
    if (!entry.asset || entry.clipNames.empty()) {
        return entry.asset ? entry.asset->defaultClip : -1;
    }
    const std::size_t name = std::min<std::size_t>(clipColumn, entry.clipNames.size() - 1);
    const int found = entry.asset->clipIndex(entry.clipNames[name]);
    return found >= 0 ? found : entry.asset->defaultClip;
}

void ShownPeople::update(CrowdFramePtr frame, std::span<const WorldSeat> seats,
                         KeyframeStore& keyframes)
{
    m_frame = std::move(frame);
    m_seatHeights.clear();
    for (const WorldSeat& seat : seats) {
        m_seatHeights.emplace_back(seat.id, seat.seat.height);
    }
    resolveClips(keyframes);
}

void ShownPeople::resolveClips(KeyframeStore& keyframes)
{
    const std::vector<TemplateEntry>& templates = *m_frame->templates;
    m_entries.assign(templates.size(), {});
    m_entryOfId.assign(std::size_t{1} << 16U, -1);
    for (std::size_t i = 0; i < templates.size(); ++i) {
        m_entryOfId[templates[i].id] = static_cast<std::int32_t>(i);
        if (templates[i].asset) {
            m_entries[i].byColumn.resize(templates[i].clipNames.size() + 1);
            m_entries[i].isKnown.resize(templates[i].clipNames.size() + 1);
        }
    }
    const auto ids = m_frame->population.column(columns::templateId);
    const auto clips = m_frame->population.column(columns::clip);
    for (std::size_t row = 0; row < ids.size(); ++row) {
        const std::int32_t index = m_entryOfId[ids[row]];
        if (index < 0) {
            continue;
        }
        Entry& entry = m_entries[static_cast<std::size_t>(index)];
        if (entry.byColumn.empty()) {
            continue;
        }
        const std::size_t column = std::min<std::size_t>(clips[row], entry.byColumn.size() - 1);
        if (!entry.isKnown[column]) {
            resolve(entry, templates[static_cast<std::size_t>(index)], column, keyframes);
        }
    }
}

void ShownPeople::resolve(Entry& entry, const TemplateEntry& source, std::size_t column,
                          KeyframeStore& keyframes) const
{
    const int clip = assetClip(source, static_cast<std::uint16_t>(column));
    entry.byColumn[column] = shownClip(source, clip, keyframes.clip(source.asset, clip).clip);
    entry.isKnown[column] = true;
}

const ShownClip* ShownPeople::clipAt(std::size_t row) const
{
    if (!m_frame->hiddenGroups.empty() &&
        isAmong(m_frame->hiddenGroups, m_frame->population.column(columns::group)[row])) {
        return nullptr;
    }
    const std::int32_t index = m_entryOfId[m_frame->population.column(columns::templateId)[row]];
    if (index < 0) {
        return nullptr;
    }
    const Entry& entry = m_entries[static_cast<std::size_t>(index)];
    if (entry.byColumn.empty()) {
        return nullptr;
    }
    const std::size_t column = std::min<std::size_t>(m_frame->population.column(columns::clip)[row],
                                                     entry.byColumn.size() - 1);
    return &entry.byColumn[column];
}

float ShownPeople::liftAt(std::size_t row, const ShownClip& clip) const
{
    const SeatId seat = m_frame->population.column(columns::seat)[row];
    if (seat == kNoSeat) {
        return 0.0F;
    }
    const auto found =
        std::ranges::lower_bound(m_seatHeights, seat, {}, &std::pair<SeatId, float>::first);
    const bool isThere = found != m_seatHeights.end() && found->first == seat;
    return seatLift(clip.asset->clips[static_cast<std::size_t>(clip.clip)],
                    isThere ? found->second : 0.0F,
                    m_frame->population.column(columns::height)[row]);
}

ShownIndividual ShownPeople::at(std::size_t row) const
{
    const Population& people = m_frame->population;
    ShownIndividual shown;
    shown.clip = clipAt(row);
    if (shown.clip == nullptr) {
        return shown;
    }
    shown.position = people.column(columns::position)[row];
    shown.position.y += liftAt(row, *shown.clip);
    shown.headingRadians = people.column(columns::heading)[row];
    shown.height = people.column(columns::height)[row];
    shown.girth = people.column(columns::girth)[row];
    shown.parts = people.column(columns::parts)[row];
    const Clip& clip = shown.clip->asset->clips[static_cast<std::size_t>(shown.clip->clip)];
    const float phase = shownPhase(clip, people.column(columns::phase)[row],
                                   people.column(columns::playbackSpeed)[row], m_frame->seconds);
    const long nearest = std::lround(clip.keyframeAt(phase * clip.seconds));
    shown.keyframe = std::clamp(static_cast<int>(nearest), 0, shown.clip->baked->keyframes - 1);
    return shown;
}

} // namespace crowd::model
