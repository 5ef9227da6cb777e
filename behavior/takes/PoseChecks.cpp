// SPDX-License-Identifier: MIT
#include "behavior/takes/PoseChecks.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <span>

namespace crowd::behavior {

namespace {

constexpr float kFurthest = 1e7F; ///< metres and the like

template<class T>
bool areNumbers(const std::vector<T>& values)
{
    return std::ranges::all_of(values, [](T value) { return std::isfinite(value); });
}

bool areWithin(const std::vector<float>& values, float most)
{
    return std::ranges::all_of(values, [most](float value) { return std::abs(value) <= most; });
}

bool ascend(const std::vector<model::IndividualId>& ids)
{
    return std::ranges::adjacent_find(ids, std::greater_equal<>()) == ids.end();
}

/// Of a column of floats or of places.
bool areNumbers(std::span<const std::byte> bytes)
{
    std::vector<float> values(bytes.size() / sizeof(float));
    if (!values.empty()) {
        std::memcpy(values.data(), bytes.data(), values.size() * sizeof(float));
    }
    return areNumbers(values);
}

bool fits(model::ColumnId column, std::size_t count, std::span<const std::byte> bytes)
{
    const model::ColumnInfo& info = model::columnInfo(column);
    const bool isOfFloats =
        info.type == model::ColumnType::Float || info.type == model::ColumnType::Vec3;
    return bytes.size() == count * info.stride && (!isOfFloats || areNumbers(bytes));
}

bool areSound(const std::vector<PoseFade>& fades, std::size_t people)
{
    const bool inOrder =
        std::ranges::adjacent_find(fades, std::greater_equal<>(), &PoseFade::person) == fades.end();
    return inOrder && (fades.empty() || fades.back().person < people) &&
           std::ranges::all_of(fades, [](const PoseFade& fade) {
               const ClipPlace& from = fade.from;
               return std::isfinite(from.rate) && std::isfinite(from.clipSeconds) &&
                      std::isfinite(from.place) && std::isfinite(fade.begin);
           });
}

} // namespace

bool isSound(const SessionPose& pose)
{
    const std::size_t people = pose.ids.size();
    const bool hasSeats = pose.seats.size() == people;
    return ascend(pose.ids) && (pose.hasSeats ? hasSeats : pose.seats.empty() || hasSeats) &&
           areWithin(pose.x, kFurthest) && areWithin(pose.y, kFurthest) &&
           areWithin(pose.z, kFurthest) && areWithin(pose.headings, kFurthest) &&
           areWithin(pose.rates, kFurthest) && areWithin(pose.clipSeconds, kFurthest) &&
           areWithin(pose.places, kFurthest) && areSound(pose.fades, people);
}

bool isSound(model::ColumnId column, const OverrideColumn& values)
{
    return ascend(values.ids) && fits(column, values.ids.size(), values.bytes);
}

bool isSound(const FadeTimes& times)
{
    const std::size_t people = times.ids.size();
    return ascend(times.ids) && times.begins.size() == people && times.areWhole.size() == people &&
           areNumbers(times.begins) && std::isfinite(times.seconds) && std::isfinite(times.end);
}

bool isSound(const FadeColumn& column)
{
    const std::size_t people = column.times->ids.size();
    const std::size_t ofClips = column.column == model::ColumnId::Clip ? people : 0;
    return fits(column.column, people, column.bytes) && column.phases.size() == ofClips &&
           column.rates.size() == ofClips && areNumbers(column.phases) && areNumbers(column.rates);
}

bool isSound(const model::LightCues& cues)
{
    return std::ranges::all_of(cues, [](const model::LightCue& cue) {
        return std::isfinite(cue.from) && std::isfinite(cue.to) && std::isfinite(cue.fadeBegin) &&
               std::isfinite(cue.fadeSeconds) && std::isfinite(cue.flashBegin) &&
               std::isfinite(cue.flashSeconds) && std::isfinite(cue.sweepBegin) &&
               std::isfinite(cue.sweepSeconds);
    });
}

} // namespace crowd::behavior
