// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstring>
#include <deque>
#include <iterator>
#include <numeric>
#include <type_traits>
#include <utility>

#include "behavior/agents/StateFades.h"
#include "behavior/agents/Turning.h"
#include "behavior/crowd/Chunks.h"
#include "model/pick/ShownPeople.h"
#include "model/population/Properties.h"
#include "model/population/Strides.h"

namespace crowd::behavior {

using namespace model;

namespace {

namespace shownKeys = model::columns;

/// Who of some people is still on the way at one moment.
struct OnTheWay
{
    const FadeTimes* times = nullptr;
    std::vector<std::uint32_t> people; ///< indices in the times
    std::vector<std::uint32_t> rows;   ///< of the frame
    std::vector<float> shares;         ///< 0..1 of what they become
};

/// Where the frame has the same people, row by row.
OnTheWay onTheWay(const FadeTimes& times, double seconds)
{
    OnTheWay way{&times, {}, {}, std::vector<float>(times.ids.size())};
    overRows(way.shares.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            way.shares[i] = times.shareAt(i, seconds);
        }
    });
    way.people.resize(way.shares.size());
    std::iota(way.people.begin(), way.people.end(), 0U);
    const auto hasArrived = [](float share) { return share >= 1.0F; };
    if (std::ranges::any_of(way.shares, hasArrived)) {
        std::erase_if(way.people, [&](std::uint32_t i) { return hasArrived(way.shares[i]); });
        std::erase_if(way.shares, hasArrived);
    }
    way.rows = way.people;
    return way;
}

OnTheWay onTheWay(const FadeTimes& times, const Population& people, double seconds)
{
    if (std::ranges::equal(times.ids, people.ids())) {
        return onTheWay(times, seconds);
    }
    OnTheWay way{&times, {}, {}, {}};
    way.people.reserve(times.ids.size());
    way.rows.reserve(times.ids.size());
    way.shares.reserve(times.ids.size());
    const std::span<const IndividualId> ids = people.ids();
    std::size_t row = 0;
    for (std::size_t i = 0; i < times.ids.size(); ++i) {
        const float share = times.shareAt(i, seconds);
        if (share >= 1.0F) {
            continue;
        }
        while (row < ids.size() && ids[row] < times.ids[i]) {
            ++row;
        }
        if (row < ids.size() && ids[row] == times.ids[i]) {
            way.people.push_back(static_cast<std::uint32_t>(i));
            way.rows.push_back(static_cast<std::uint32_t>(row));
            way.shares.push_back(share);
        }
    }
    return way;
}

Tint between(const Tint& from, const Tint& to, float share)
{
    // All four channels at once, 16 bits each: a crowd has a million of them. A channel has as many
    // steps as the weight.
    constexpr std::uint64_t kWhole = 1U << 8U;
    constexpr std::uint64_t kChannels = 0x00FF00FF00FF00FFU;
    constexpr std::uint64_t kRound = 0x0080008000800080U;
    const auto weight =
        static_cast<std::uint64_t>(static_cast<std::int32_t>(share * static_cast<float>(kWhole)));
    const auto apart = [](const Tint& tint) {
        const auto bytes = std::uint64_t{std::bit_cast<std::uint32_t>(tint)};
        return (bytes | bytes << 24U) & kChannels; // 0, 2 and, above them, 1, 3
    };
    const std::uint64_t mixed =
        (apart(from) * (kWhole - weight) + apart(to) * weight + kRound) >> 8U & kChannels;
    return std::bit_cast<Tint>(static_cast<std::uint32_t>(mixed | mixed >> 24U));
}

/// The picture at one moment.
class FadedFrame
{
public:
    FadedFrame(const std::vector<bool>& isBusy, CrowdFrame& frame)
        : m_isBusy(isBusy), m_frame(frame)
    {
    }
    void apply(const FadeColumn& column);

private:
    [[nodiscard]] const OnTheWay& wayOf(const FadeTimes& times);
    /// A column, to be written for those on the way.
    template<class T>
    [[nodiscard]] std::span<T> shown(ColumnKey<T> key)
    {
        Population& people = m_frame.population;
        return m_way->rows.size() == people.size() ? people.edit(key)
                                                   : people.edit(key, m_way->rows);
    }
    template<class T, class Blend>
    void write(const FadeColumn& column, const Blend& blend);
    void writeBetween(const FadeColumn& column);
    void writeStep(const FadeColumn& column);
    void writeClips(const FadeColumn& column);
    void replaceFades(std::vector<ClipFade> coming);
    void findClips();
    /// Null: the template is not there.
    [[nodiscard]] const Clip* clipOf(TemplateId id, std::uint16_t clip) const
    {
        if (id >= m_clips.size() || m_clips[id].empty()) {
            return nullptr;
        }
        return m_clips[id][std::min<std::size_t>(clip, m_clips[id].size() - 1)];
    }
    [[nodiscard]] bool isBusy(std::uint32_t row) const
    {
        return row < m_isBusy.size() && m_isBusy[row];
    }

    const std::vector<bool>& m_isBusy;
    CrowdFrame& m_frame;
    std::deque<OnTheWay> m_ways; ///< mostly the same people come from something in several columns
    const OnTheWay* m_way = nullptr;               ///< of the column in hand
    std::vector<std::vector<const Clip*>> m_clips; ///< by template id, as its clip column counts
};

const OnTheWay& FadedFrame::wayOf(const FadeTimes& times)
{
    const auto known = std::ranges::find(m_ways, &times, &OnTheWay::times);
    if (known != m_ways.end()) {
        return *known;
    }
    return m_ways.emplace_back(onTheWay(times, m_frame.population, m_frame.seconds));
}

void FadedFrame::apply(const FadeColumn& column)
{
    m_way = &wayOf(*column.times);
    if (m_way->rows.empty()) {
        return;
    }
    if (column.column == ColumnId::Clip) {
        writeClips(column);
    } else if (propertyInfo(column.column).traits.blend == PropertyBlend::Step) {
        writeStep(column);
    } else {
        writeBetween(column);
    }
}

/// blend(from, to, share).
template<class T, class Blend>
void FadedFrame::write(const FadeColumn& column, const Blend& blend)
{
    const std::span<T> values = shown(ColumnKey<T>{column.column});
    overRows(m_way->rows.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            T from;
            std::memcpy(&from, column.bytes.data() + m_way->people[i] * sizeof(T), sizeof(T));
            T& to = values[m_way->rows[i]];
            to = blend(from, to, m_way->shares[i]);
        }
    });
}

void FadedFrame::writeBetween(const FadeColumn& column)
{
    const PropertyInfo& info = propertyInfo(column.column);
    if (info.traits.blend == PropertyBlend::Colour) {
        write<Tint>(column, [](const Tint& from, const Tint& to, float share) {
            return between(from, to, share);
        });
    } else if (info.traits.blend == PropertyBlend::Turn) {
        write<float>(column, [](float from, float to, float share) {
            return wrappedRadians(from + wrappedRadians(to - from) * share);
        });
    } else if (info.column.type == ColumnType::Vec3) {
        write<glm::vec3>(column, [](const glm::vec3& from, const glm::vec3& to, float share) {
            return from + (to - from) * share;
        });
    } else if (info.column.type == ColumnType::Float) {
        write<float>(column,
                     [](float from, float to, float share) { return from + (to - from) * share; });
    } else {
        writeStep(column);
    }
}

/// Half way they become what they will be.
void FadedFrame::writeStep(const FadeColumn& column)
{
    constexpr float kHalf = 0.5F;
    if (std::ranges::none_of(m_way->shares, [](float share) { return share < kHalf; })) {
        return;
    }
    withStride(columnInfo(column.column).stride, [&](auto width) {
        if constexpr (!std::is_same_v<decltype(width), std::size_t>) {
            using Value = std::array<std::byte, decltype(width)::value>;
            write<Value>(column, [](const Value& from, const Value& to, float share) {
                return share < kHalf ? from : to;
            });
        } // it knows all widths that columns have
    });
}

void FadedFrame::findClips()
{
    for (const TemplateEntry& entry : *m_frame.templates) {
        m_clips.resize(std::max<std::size_t>(m_clips.size(), entry.id + std::size_t{1}));
        std::vector<const Clip*>& clips = m_clips[entry.id];
        const std::size_t count = std::max<std::size_t>(entry.clipNames.size(), 1);
        for (std::size_t i = 0; entry.asset && i < count; ++i) {
            const int index = assetClip(entry, static_cast<std::uint16_t>(i));
            clips.push_back(index < 0 ? nullptr
                                      : &entry.asset->clips[static_cast<std::size_t>(index)]);
        }
    }
}

void FadedFrame::writeClips(const FadeColumn& column)
{
    const auto clips = shown(shownKeys::clip);
    const auto phases = shown(shownKeys::phase);
    const auto rates = shown(shownKeys::playbackSpeed);
    const auto templates = std::as_const(m_frame.population).column(shownKeys::templateId);
    findClips();
    constexpr float kNotComing = 2.0F; // no share is
    std::vector<ClipFade> coming(m_way->rows.size(), {0, 0, 0.0F, kNotComing});
    overRows(m_way->rows.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const std::uint32_t row = m_way->rows[i];
            const std::uint32_t person = m_way->people[i];
            if (isBusy(row)) {
                continue;
            }
            std::uint16_t clip = 0;
            std::memcpy(&clip, column.bytes.data() + person * sizeof(clip), sizeof(clip));
            const float phase = column.phases[person];
            const float rate = column.rates[person];
            if (m_way->shares[i] <= 0.0F) {
                clips[row] = clip;
                phases[row] = phase;
                rates[row] = rate;
            } else if (const Clip* from = clipOf(templates[row], clip)) {
                const float place = shownPhase(*from, phase, rate, m_frame.seconds);
                coming[i] = {row, clip, place, m_way->shares[i]};
            }
        }
    });
    std::erase_if(coming, [](const ClipFade& each) { return each.share == kNotComing; });
    replaceFades(std::move(coming));
}

/// The fades of those on the way, who are not busy, from one clip to the next are these.
void FadedFrame::replaceFades(std::vector<ClipFade> coming)
{
    std::erase_if(m_frame.fades, [this](const ClipFade& fade) {
        return !isBusy(fade.row) && std::ranges::binary_search(m_way->rows, fade.row);
    });
    if (m_frame.fades.empty()) {
        m_frame.fades = std::move(coming);
        return;
    }
    std::vector<ClipFade> all;
    all.reserve(m_frame.fades.size() + coming.size());
    std::ranges::merge(m_frame.fades, coming, std::back_inserter(all), {}, &ClipFade::row,
                       &ClipFade::row);
    m_frame.fades = std::move(all);
}

} // namespace

void applyFades(const FadeColumns& fades, const std::vector<bool>& isBusy, CrowdFrame& frame)
{
    FadedFrame shown(isBusy, frame);
    for (const auto& column : fades) {
        shown.apply(*column);
    }
}

} // namespace crowd::behavior
