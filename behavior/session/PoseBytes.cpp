// SPDX-License-Identifier: MIT
#include "behavior/session/PoseBytes.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "behavior/session/PackKernel.h"
#include "model/base/Checksum.h"

namespace crowd::behavior {

namespace {

using Word = std::uint32_t;
using Counts = PoseColumns::Counts;

constexpr std::size_t kWordBytes = sizeof(Word);
constexpr std::size_t kGroup = kPackedWords;
constexpr std::size_t kGroupBytes = kPackedGroupBytes;
constexpr std::size_t kFadeWords = 8;
constexpr std::size_t kSumBytes = sizeof(std::uint64_t); ///< of the checksum, in front

/// Groups that so many values take.
template<class T>
std::size_t groupsOf(std::size_t count)
{
    return (count * sizeof(T) + kGroupBytes - 1) / kGroupBytes;
}

/// All that is there once for each person, in the order of the words.
template<class Take>
void eachColumn(const Take& take)
{
    take(&SessionPose::ids);
    take(&SessionPose::x);
    take(&SessionPose::y);
    take(&SessionPose::z);
    take(&SessionPose::headings);
    take(&SessionPose::clips);
    take(&SessionPose::rates);
    take(&SessionPose::clipSeconds);
    take(&SessionPose::places);
    take(&SessionPose::flags);
}

/// Of what is compared with the pose before: who fades changes from step to step.
std::size_t comparedGroups(const Counts& counts)
{
    std::size_t groups = groupsOf<model::SeatId>(counts.seats);
    eachColumn(
        [&]<class T>(std::vector<T> SessionPose::*) { groups += groupsOf<T>(counts.people); });
    return groups;
}

std::size_t allGroups(const Counts& counts)
{
    return comparedGroups(counts) + counts.fades * (kFadeWords / kGroup);
}

using FadeWords = std::array<Word, kFadeWords>;

FadeWords wordsOf(const PoseFade& fade)
{
    FadeWords words{fade.person, fade.from.clip | (fade.from.isLooped ? 1U << 16U : 0U),
                    std::bit_cast<Word>(fade.from.rate),
                    std::bit_cast<Word>(fade.from.clipSeconds)};
    std::memcpy(&words[4], &fade.from.place, sizeof(double));
    std::memcpy(&words[6], &fade.begin, sizeof(double));
    return words;
}

PoseFade fadeOf(const Word* words)
{
    PoseFade fade;
    fade.person = words[0];
    fade.from.clip = static_cast<std::uint16_t>(words[1] & 0xFFFFU);
    fade.from.isLooped = (words[1] >> 16U) != 0;
    fade.from.rate = std::bit_cast<float>(words[2]);
    fade.from.clipSeconds = std::bit_cast<float>(words[3]);
    std::memcpy(&fade.from.place, words + 4, sizeof(double));
    std::memcpy(&fade.begin, words + 6, sizeof(double));
    return fade;
}

template<class T>
PackPlaces writeColumn(PackPlaces to, const std::vector<T>& now, const std::vector<T>* before)
{
    const auto* values = reinterpret_cast<const std::byte*>(now.data());
    const auto* then =
        before != nullptr ? reinterpret_cast<const std::byte*>(before->data()) : nullptr;
    const std::size_t bytes = now.size() * sizeof(T);
    const std::size_t whole = bytes / kGroupBytes * kGroupBytes;
    to = packGroups(to, values, then, whole / kGroupBytes);
    if (whole < bytes) {
        std::array<std::byte, kGroupBytes> last{};
        std::array<std::byte, kGroupBytes> lastThen{};
        std::memcpy(last.data(), values + whole, bytes - whole);
        if (then != nullptr) {
            std::memcpy(lastThen.data(), then + whole, bytes - whole);
        }
        to = packGroups(to, last.data(), lastThen.data(), 1);
    }
    return to;
}

/// A word of so many bytes; `left`: those that there are, no less.
Word readWord(const std::byte* data, std::size_t length, std::size_t left)
{
    constexpr std::array<Word, 5> kMasks{0, 0xFFU, 0xFFFFU, 0xFFFFFFU, 0xFFFFFFFFU};
    Word word = 0;
    if (left >= kWordBytes) {
        std::memcpy(&word, data, kWordBytes);
        return word & kMasks[length];
    }
    std::memcpy(&word, data, length);
    return word;
}

/// Into words that are there, or as what differs from them. False: there are fewer or more bytes
/// than the codes want.
bool readGroups(std::span<const std::byte> bytes, std::span<Word> words, std::size_t compared)
{
    const std::size_t groups = words.size() / kGroup;
    const std::byte* data = bytes.data() + groups;
    const std::byte* const end = bytes.data() + bytes.size();
    for (std::size_t i = 0; i < groups; ++i) {
        const auto codes = std::to_integer<unsigned>(bytes[i]);
        Word* const group = &words[i * kGroup];
        const bool isCompared = i * kGroup < compared;
        if (codes == 0 && isCompared) {
            continue;
        }
        for (unsigned k = 0; k < kGroup; ++k) {
            const std::size_t length = packedLength((codes >> (2 * k)) & 3U);
            const auto left = static_cast<std::size_t>(end - data);
            if (left < length) {
                return false;
            }
            const Word word = readWord(data, length, left);
            group[k] = isCompared ? group[k] ^ word : word;
            data += length;
        }
    }
    return data == end;
}

template<class T>
const Word* readColumn(const Word* words, std::vector<T>& values, std::size_t count)
{
    values.resize(count);
    if (count > 0) {
        std::memcpy(values.data(), words, count * sizeof(T));
    }
    return words + groupsOf<T>(count) * kGroup;
}

} // namespace

PoseWriter::Packed PoseWriter::packed(const SessionPose& pose, const SessionPose* before)
{
    const Counts counts{static_cast<Word>(pose.ids.size()), static_cast<Word>(pose.seats.size()),
                        static_cast<Word>(pose.fades.size())};
    Packed packed;
    packed.isDifference = before != nullptr && pose.ids.size() == before->ids.size() &&
                          pose.seats.size() == before->seats.size();
    const SessionPose* then = packed.isDifference ? before : nullptr;
    const std::size_t groups = allGroups(counts);
    const std::size_t head = kSumBytes + sizeof(Counts);
    const std::size_t most = head + groups * (1 + kGroupBytes) + kGroupBytes;
    if (m_room.size() < most) {
        m_room.resize(most);
    }
    std::memcpy(m_room.data() + kSumBytes, &counts, sizeof(Counts));
    PackPlaces to{m_room.data() + head, m_room.data() + head + groups};
    eachColumn([&](auto column) {
        to = writeColumn(to, pose.*column, then != nullptr ? &(then->*column) : nullptr);
    });
    to = writeColumn(to, pose.seats, then != nullptr ? &then->seats : nullptr);
    for (const PoseFade& fade : pose.fades) {
        const FadeWords words = wordsOf(fade);
        const auto* bytes = reinterpret_cast<const std::byte*>(words.data());
        to = packGroups(to, bytes, nullptr, kFadeWords / kGroup);
    }
    const auto size = static_cast<std::size_t>(to.data - m_room.data());
    packed.bytes = std::span(m_room).first(size);
    const std::uint64_t checksum = model::checksumOf(packed.bytes.subspan(kSumBytes));
    std::memcpy(m_room.data(), &checksum, kSumBytes);
    return packed;
}

bool PoseColumns::read(std::span<const std::byte> bytes, bool isDifference)
{
    if (bytes.size() < kSumBytes + sizeof(Counts)) {
        return false;
    }
    Counts counts;
    std::uint64_t checksum = 0;
    std::memcpy(&checksum, bytes.data(), kSumBytes);
    std::memcpy(&counts, bytes.data() + kSumBytes, sizeof(Counts));
    const auto summed = bytes.subspan(kSumBytes);
    const auto rest = summed.subspan(sizeof(Counts));
    const std::size_t compared = comparedGroups(counts);
    const std::size_t groups = allGroups(counts);
    const bool fits =
        !isDifference || (counts.people == m_counts.people && counts.seats == m_counts.seats);
    // No memory is taken for more people than the bytes can tell of.
    if (!fits || groups > rest.size() || model::checksumOf(summed) != checksum) {
        return false;
    }
    m_counts = counts;
    m_words.resize(groups * kGroup);
    return readGroups(rest, m_words, isDifference ? compared * kGroup : 0);
}

void PoseColumns::fill(SessionPose& pose) const
{
    const Word* words = m_words.data();
    eachColumn([&](auto column) { words = readColumn(words, pose.*column, m_counts.people); });
    words = readColumn(words, pose.seats, m_counts.seats);
    pose.fades.resize(m_counts.fades);
    for (PoseFade& fade : pose.fades) {
        fade = fadeOf(words);
        words += kFadeWords;
    }
}

} // namespace crowd::behavior
