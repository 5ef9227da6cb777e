// SPDX-License-Identifier: MIT
#include "model/brush/ColumnWriting.h"
#include "model/scene/NearestPath.h"

namespace crowd::model {

ChangeResult WalkSettings::change(const ChangeRequest& request)
{
    const Population& people = request.edit.scene().population;
    const auto& settings = request.settings.as<WalkSettings>();
    const auto paths = people.column(columns::path);
    const auto speeds = people.column(columns::walkSpeed);
    const OperatorShares shares(request);
    // Nobody walks like his neighbour: the operator decides only how evenly.
    const bool isLine = operatorInfo(request.settings.op).followsLine;
    const auto speedShares =
        (isLine ? shares.of(DrawPurpose::Speed) : shares.drawn(DrawPurpose::Speed, 1)).shares;
    ColumnChange<PathId> pathChange;
    ColumnChange<float> speedChange;
    const bool isNearest = settings.path == kNearestPath;
    const std::optional<NearestPath> nearest =
        isNearest ? std::optional<NearestPath>(request.edit.scene()) : std::nullopt;
    const bool isThere = settings.path == 0 || (isNearest && !request.edit.scene().paths.empty()) ||
                         request.edit.scene().findPath(settings.path) != nullptr;
    forEachRow(request, [&](std::size_t i, std::size_t row, IndividualId id) {
        if (settings.setsPath && isThere) {
            pathChange.set(id, paths[row],
                           nearest ? nearest->at(shares.positions()[i]) : settings.path);
        }
        if (settings.setsSpeed) {
            speedChange.set(id, speeds[row], valueAt(settings.speed, speedShares[i]));
        }
    });
    ChangeResult result;
    pathChange.apply(request.edit, columns::path, result.changed);
    speedChange.apply(request.edit, columns::walkSpeed, result.changed);
    const bool setsAnything = (settings.setsPath && isThere) || settings.setsSpeed;
    result.reason = setsAnything ? StrokeReason::Unchanged : StrokeReason::NothingChosen;
    return result;
}

MainNumber WalkSettings::mainNumber(const BrushSettings& brush)
{
    return {QT_TRANSLATE_NOOP("BrushTexts", "Walking speed, m/s"),
            QT_TRANSLATE_NOOP("BrushTexts", "Walking speed: %1 m/s"),
            brush.as<WalkSettings>().speed.low,
            0.0,
            kMaxWalkingSpeed,
            0.1,
            1};
}

void WalkSettings::setMainNumber(BrushSettings& brush, float value)
{
    auto& settings = brush.as<WalkSettings>();
    settings.speed = movedTo(value, settings.speed);
    settings.setsSpeed = true;
}

std::string WalkSettings::take(BrushSettings& brush, const TakenFrom& from)
{
    auto& settings = brush.as<WalkSettings>();
    const float speed = from.value(columns::walkSpeed);
    const Path* path = from.scene.findPath(from.value(columns::path));
    std::string taken;
    if (settings.setsPath && path != nullptr) {
        settings.path = path->id;
        taken = path->name;
    }
    if (settings.setsSpeed && speed > 0.0F) {
        settings.speed = movedTo(speed, settings.speed);
        taken += (taken.empty() ? "" : " · ") + shortNumber(static_cast<double>(speed)) + " m/s";
    }
    return taken;
}

} // namespace crowd::model
