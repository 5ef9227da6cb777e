// SPDX-License-Identifier: MIT
#include "widgets/tools/Candidates.h"

#include <algorithm>

namespace crowd::widgets {

using namespace model;

namespace {

constexpr std::size_t kMostShown = 400;
constexpr float kMarkedHeight = 0.45F; ///< share of the template's: the chest of who sits

std::vector<IndividualId> reached(const ScenePicker& picker, const BrushSettings& settings,
                                  glm::dvec2 pixel)
{
    if (settings.hasCircle()) {
        const ScreenArea circle =
            ScreenArea::circle(pixel, static_cast<double>(settings.radiusPixels));
        return picker.individualsInArea(circle,
                                        settings.through ? AreaMode::Through : AreaMode::Visible);
    }
    if (settings.selection != BrushSelection::Point) {
        return {}; // who is in a rectangle, its drag shows
    }
    std::vector<IndividualId> ids;
    if (settings.through) {
        for (const IndividualHit& hit : picker.individualsThrough(pixel)) {
            ids.push_back(hit.id);
        }
    } else if (const auto hit = picker.individualAt(pixel)) {
        ids.push_back(hit->id);
    }
    return ids;
}

} // namespace

bool worksOnPeople(BrushKind kind)
{
    return brushType(kind).info.family == StrokeFamily::People;
}

std::vector<QPointF> candidatesAt(const ToolContext& context, const BrushSettings& settings,
                                  const ToolInput& at)
{
    const double seconds = at.pointer.shownSeconds;
    const ScenePicker& picker = context.queries.picker(seconds);
    const std::vector<IndividualId> ids = reached(picker, settings, at.pointer.pixels());
    const CrowdFramePtr frame = context.state.session().frame(seconds);
    const Population& people = frame->population;
    const std::size_t step = (ids.size() + kMostShown - 1) / kMostShown;
    std::vector<QPointF> points;
    for (std::size_t i = 0; i < ids.size(); i += step) {
        const std::size_t row = people.rowOf(ids[i]);
        const TemplateEntry* entry =
            row == Population::npos
                ? nullptr
                : context.state.scene().findTemplate(people.column(columns::templateId)[row]);
        if (entry == nullptr || !entry->asset) {
            continue;
        }
        const float up = entry->asset->height * people.column(columns::height)[row] * kMarkedHeight;
        const glm::vec3 chest = people.column(columns::position)[row] + glm::vec3(0.0F, up, 0.0F);
        if (const auto pixel = picker.view().project(chest)) {
            points.emplace_back(pixel->x, pixel->y);
        }
    }
    return points;
}

} // namespace crowd::widgets
