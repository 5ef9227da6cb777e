// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "model/brush/ColumnWriting.h"

namespace crowd::model {

namespace {

/// The one of these who is seen nearest to a pixel.
glm::vec3 nearestTo(const ChangeRequest& request, std::span<const glm::vec3> positions,
                    glm::dvec2 pixel)
{
    glm::vec3 nearest = positions.front();
    double least = std::numeric_limits<double>::max();
    for (const glm::vec3& position : positions) {
        const auto at = request.view.project(position);
        const double distance = at ? glm::distance(glm::dvec2(at->x, at->y), pixel)
                                   : std::numeric_limits<double>::max();
        if (distance < least) {
            least = distance;
            nearest = position;
        }
    }
    return nearest;
}

/// Seconds, in the order of the request's ids; empty where the stroke has no direction yet.
std::vector<double> delaysOf(const ChangeRequest& request, const TimeSettings& settings)
{
    const OperatorShares shares(request);
    std::vector<double> delays(request.ids.size(), static_cast<double>(settings.delay.low));
    const std::span<const glm::vec3> positions = shares.positions();
    const auto speed = static_cast<double>(settings.waveSpeed);
    if (settings.mode == TimeMode::Range) {
        const auto drawn = shares.of(request.settings.op, "time.delay").shares;
        for (std::size_t i = 0; i < delays.size(); ++i) {
            delays[i] = static_cast<double>(valueAt(settings.delay, drawn[i]));
        }
    } else if (settings.mode == TimeMode::Wave) {
        if (!request.strokeHeading) {
            return {};
        }
        const glm::dvec2 along(std::sin(*request.strokeHeading), std::cos(*request.strokeHeading));
        for (std::size_t i = 0; i < delays.size(); ++i) {
            delays[i] = glm::dot(along, glm::dvec2(positions[i].x, positions[i].z)) / speed;
        }
    } else if (settings.mode == TimeMode::Ripple) {
        const glm::vec3 middle = nearestTo(request, positions, request.line.from);
        for (std::size_t i = 0; i < delays.size(); ++i) {
            delays[i] = static_cast<double>(glm::distance(positions[i], middle)) / speed;
        }
    }
    return delays;
}

/// Seconds of the clip that a row plays; 0: it is not loaded.
double clipSeconds(const Scene& scene, std::size_t row)
{
    const TemplateEntry* entry =
        scene.findTemplate(scene.population.column(columns::templateId)[row]);
    const std::uint16_t clip = scene.population.column(columns::clip)[row];
    if (entry == nullptr || !entry->asset || clip >= entry->clipNames.size()) {
        return 0.0;
    }
    const int index = entry->asset->clipIndex(entry->clipNames[clip]);
    return index < 0
               ? 0.0
               : static_cast<double>(entry->asset->clips[static_cast<std::size_t>(index)].seconds);
}

} // namespace

ChangeResult TimeSettings::change(const ChangeRequest& request)
{
    const std::vector<double> delays = delaysOf(request, request.settings.as<TimeSettings>());
    ChangeResult result;
    if (delays.empty()) {
        result.reason = StrokeReason::NoDirection;
        return result;
    }
    const Scene& scene = request.edit.scene();
    const auto phases = scene.population.column(columns::phase);
    const auto speeds = scene.population.column(columns::playbackSpeed);
    ColumnChange<float> change;
    forEachRow(request, [&](std::size_t i, std::size_t row, IndividualId id) {
        const double seconds = clipSeconds(scene, row);
        if (seconds > 0.0) {
            // At that time the clip is at its beginning: see shownPhase().
            const double place = -delays[i] * static_cast<double>(speeds[row]) / seconds;
            const auto phase = static_cast<float>(place - std::floor(place));
            change.set(id, phases[row], phase < 1.0F ? phase : 0.0F);
        }
    });
    change.apply(request.edit, columns::phase, result.changed);
    result.reason = StrokeReason::Unchanged;
    return result;
}

MainNumber TimeSettings::mainNumber(const BrushSettings& brush)
{
    const auto& settings = brush.as<TimeSettings>();
    if (settings.mode == TimeMode::Wave || settings.mode == TimeMode::Ripple) {
        return {QT_TRANSLATE_NOOP("BrushTexts", "Speed of the wave, m/s"),
                QT_TRANSLATE_NOOP("BrushTexts", "Wave: %1 m/s"),
                static_cast<double>(settings.waveSpeed),
                0.1,
                1000.0,
                1.0,
                1};
    }
    return {QT_TRANSLATE_NOOP("BrushTexts", "Delay, s"),
            QT_TRANSLATE_NOOP("BrushTexts", "Delay: %1 s"),
            static_cast<double>(settings.delay.low),
            0.0,
            3600.0,
            0.1,
            2};
}

void TimeSettings::setMainNumber(BrushSettings& brush, float value)
{
    auto& settings = brush.as<TimeSettings>();
    if (settings.mode == TimeMode::Wave || settings.mode == TimeMode::Ripple) {
        settings.waveSpeed = value;
    } else {
        settings.delay = {value, value + settings.delay.high - settings.delay.low};
    }
}

} // namespace crowd::model
