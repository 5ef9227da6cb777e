// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>

#include "model/brush/ColumnWriting.h"

namespace crowd::model {

namespace {

constexpr double kDegreesPerRadian = 180.0 / std::numbers::pi;

/// Heading with which the operator lets somebody face.
std::optional<float> targetHeading(const ChangeRequest& request, double u,
                                   const glm::vec3& position)
{
    HeadingSettings heading = request.settings.as<OrientationSettings>().heading;
    const OperatorInfo& op = operatorInfo(request.settings.op);
    if (op.followsLine) {
        return request.strokeHeading;
    }
    const auto base = headingFor(heading, request.view, position, request.strokeHeading, u);
    if (!base || !op.usesDistribution || heading.mode == HeadingMode::Random) {
        return base;
    }
    heading.mode = HeadingMode::Random;
    heading.headingRadians = *base;
    return headingFor(heading, request.view, position, std::nullopt, u);
}

bool followsSomething(HeadingMode mode)
{
    return mode != HeadingMode::Direction && mode != HeadingMode::Random;
}

} // namespace

ChangeResult OrientationSettings::change(const ChangeRequest& request)
{
    const Population& people = request.edit.scene().population;
    const auto headings = people.column(columns::heading);
    const auto positions = people.column(columns::position);
    const OperatorResult draws = OperatorShares(request).drawn(DrawPurpose::Heading);
    ColumnChange<float> change;
    bool hasTarget = false;
    forEachRow(request, [&](std::size_t i, std::size_t row, IndividualId id) {
        auto target = targetHeading(request, draws.shares[i], positions[row]);
        hasTarget = hasTarget || target;
        if (target && request.settings.buildUp) {
            const float way = wrappedAngle(*target - headings[row]);
            *target = wrappedAngle(headings[row] + way * request.settings.flow);
        }
        change.set(id, headings[row], target.value_or(headings[row]));
    });
    ChangeResult result;
    change.apply(request.edit, columns::heading, result.changed);
    result.reason = hasTarget ? StrokeReason::Unchanged : StrokeReason::NoDirection;
    return result;
}

MainNumber OrientationSettings::mainNumber(const BrushSettings& brush)
{
    const HeadingSettings& heading = brush.as<OrientationSettings>().heading;
    const bool isTurn = followsSomething(heading.mode);
    return {isTurn ? QT_TRANSLATE_NOOP("BrushTexts", "Turned by, °")
                   : QT_TRANSLATE_NOOP("BrushTexts", "Direction, °"),
            isTurn ? QT_TRANSLATE_NOOP("BrushTexts", "Turned by: %1°")
                   : QT_TRANSLATE_NOOP("BrushTexts", "Direction: %1°"),
            (isTurn ? heading.turnRadians : heading.headingRadians) * kDegreesPerRadian,
            -180.0,
            180.0,
            5.0,
            0,
            true};
}

void OrientationSettings::setMainNumber(BrushSettings& brush, float value)
{
    HeadingSettings& heading = brush.as<OrientationSettings>().heading;
    (followsSomething(heading.mode) ? heading.turnRadians : heading.headingRadians) =
        static_cast<float>(static_cast<double>(value) / kDegreesPerRadian);
}

} // namespace crowd::model
