// SPDX-License-Identifier: MIT
#include "model/brush/ClipChoice.h"
#include "model/brush/ColumnWriting.h"

namespace crowd::model {

namespace {

/// Whether somebody can walk with a clip, as the clip column counts.
bool isToWalkWith(const TemplateEntry& entry, std::uint16_t clip)
{
    const int index = entry.asset ? entry.asset->clipIndex(entry.clipNames[clip]) : -1;
    return index >= 0 && movesOverGround(entry, clip, static_cast<std::size_t>(index));
}

} // namespace

ChangeResult StyleSettings::change(const ChangeRequest& request)
{
    const Scene& scene = request.edit.scene();
    const Population& people = scene.population;
    const auto& settings = request.settings.as<StyleSettings>();
    const auto templates = people.column(columns::templateId);
    const auto styles = people.column(columns::walkStyle);
    const auto speeds = people.column(columns::walkSpeed);
    const OperatorShares shares(request);
    // Nobody walks like his neighbour: the operator decides only how evenly.
    const bool isLine = operatorInfo(request.settings.op).followsLine;
    const auto sharesFor = [&](DrawPurpose purpose) {
        return (isLine ? shares.of(purpose) : shares.drawn(purpose, 2)).shares;
    };
    const auto clipShares = sharesFor(DrawPurpose::Clip);
    const auto speedShares = sharesFor(DrawPurpose::Speed);
    ColumnChange<std::uint16_t> styleChange;
    ColumnChange<float> speedChange;
    bool hasValue = settings.setsSpeed || (settings.setsStyle && settings.clips.empty());
    forEachRow(request, [&](std::size_t i, std::size_t row, IndividualId id) {
        const TemplateEntry* entry = scene.findTemplate(templates[row]);
        if (settings.setsStyle && settings.clips.empty()) {
            styleChange.set(id, styles[row], 0);
        } else if (settings.setsStyle && entry != nullptr) {
            const auto chosen = chosenClip(*entry, settings.clips, clipShares[i]);
            if (chosen && isToWalkWith(*entry, *chosen)) {
                hasValue = true;
                styleChange.set(id, styles[row], static_cast<std::uint16_t>(*chosen + 1));
            }
        }
        if (settings.setsSpeed) {
            speedChange.set(id, speeds[row], valueAt(settings.speed, speedShares[i]));
        }
    });
    ChangeResult result;
    styleChange.apply(request.edit, columns::walkStyle, result.changed);
    speedChange.apply(request.edit, columns::walkSpeed, result.changed);
    const StrokeReason missing =
        settings.setsStyle ? StrokeReason::NoSuchClip : StrokeReason::NothingChosen;
    result.reason = hasValue ? StrokeReason::Unchanged : missing;
    return result;
}

MainNumber StyleSettings::mainNumber(const BrushSettings& brush)
{
    return {QT_TRANSLATE_NOOP("BrushTexts", "Walking speed, m/s"),
            QT_TRANSLATE_NOOP("BrushTexts", "Walking speed: %1 m/s"),
            brush.as<StyleSettings>().speed.low,
            0.0,
            kMaxWalkingSpeed,
            0.1,
            1};
}

void StyleSettings::setMainNumber(BrushSettings& brush, float value)
{
    auto& settings = brush.as<StyleSettings>();
    settings.speed = movedTo(value, settings.speed);
    settings.setsSpeed = true;
}

std::string StyleSettings::take(BrushSettings& brush, const TakenFrom& from)
{
    auto& settings = brush.as<StyleSettings>();
    const float speed = from.value(columns::walkSpeed);
    const std::size_t style = from.value(columns::walkStyle);
    std::string taken;
    if (settings.setsStyle && style > 0 && style <= from.entry.clipNames.size()) {
        taken = from.entry.clipNames[style - 1];
        settings.clips = {{taken, 1.0F}};
    }
    if (settings.setsSpeed && speed > 0.0F) {
        settings.speed = movedTo(speed, settings.speed);
        taken += (taken.empty() ? "" : " · ") + shortNumber(static_cast<double>(speed)) + " m/s";
    }
    return taken;
}

} // namespace crowd::model
