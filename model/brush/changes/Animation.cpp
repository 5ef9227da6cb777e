// SPDX-License-Identifier: MIT
#include "model/brush/ClipChoice.h"
#include "model/brush/ColumnWriting.h"

namespace crowd::model {

ChangeResult AnimationSettings::change(const ChangeRequest& request)
{
    const Scene& scene = request.edit.scene();
    const Population& people = scene.population;
    const auto& settings = request.settings.as<AnimationSettings>();
    const auto templates = people.column(columns::templateId);
    const auto clips = people.column(columns::clip);
    const auto phases = people.column(columns::phase);
    const auto seats = people.column(columns::seat);
    const auto speeds = people.column(columns::playbackSpeed);
    const OperatorShares shares(request);
    const auto clipShares = shares.of(DrawPurpose::Clip).shares;
    const auto phaseShares = shares.of(DrawPurpose::Phase).shares;
    const auto speedShares = shares.of(DrawPurpose::Speed).shares;
    ColumnChange<std::uint16_t> clipChange;
    ColumnChange<float> phaseChange;
    ColumnChange<float> speedChange;
    bool hasValue = settings.setsPhase || settings.setsSpeed;
    forEachRow(request, [&](std::size_t i, std::size_t row, IndividualId id) {
        const TemplateEntry* entry = scene.findTemplate(templates[row]);
        if (entry != nullptr) {
            const auto chosen =
                suitingClip(*entry, settings.clips, seats[row] != kNoSeat, clipShares[i]);
            hasValue = hasValue || chosen;
            clipChange.set(id, clips[row], chosen.value_or(clips[row]));
        }
        if (settings.setsPhase) {
            phaseChange.set(id, phases[row], valueAt(settings.phase, phaseShares[i]));
        }
        if (settings.setsSpeed) {
            speedChange.set(id, speeds[row], valueAt(settings.speed, speedShares[i]));
        }
    });
    ChangeResult result;
    clipChange.apply(request.edit, columns::clip, result.changed);
    phaseChange.apply(request.edit, columns::phase, result.changed);
    speedChange.apply(request.edit, columns::playbackSpeed, result.changed);
    const StrokeReason missing =
        settings.clips.empty() ? StrokeReason::NothingChosen : StrokeReason::NoSuchClip;
    result.reason = hasValue ? StrokeReason::Unchanged : missing;
    return result;
}

void AnimationSettings::prepare(BrushSettings& brush)
{
    brush.selection = BrushSelection::AllInCircle;
    brush.op = BrushOperator::Random;
}

MainNumber AnimationSettings::mainNumber(const BrushSettings& brush)
{
    return {QT_TRANSLATE_NOOP("BrushTexts", "Speed"),
            QT_TRANSLATE_NOOP("BrushTexts", "Speed: × %1"),
            brush.as<AnimationSettings>().speed.low,
            0.0,
            4.0,
            0.1,
            1};
}

void AnimationSettings::setMainNumber(BrushSettings& brush, float value)
{
    auto& settings = brush.as<AnimationSettings>();
    const ValueRange before = settings.speed;
    settings.speed = {value, std::max(value, value + before.high - before.low)};
    settings.setsSpeed = true;
}

std::string AnimationSettings::take(BrushSettings& brush, const TakenFrom& from)
{
    const std::uint16_t clip = from.value(columns::clip);
    if (clip >= from.entry.clipNames.size()) {
        return {};
    }
    brush.as<AnimationSettings>().clips = {{from.entry.clipNames[clip], 1.0F}};
    return from.entry.clipNames[clip];
}

} // namespace crowd::model
