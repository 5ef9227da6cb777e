// SPDX-License-Identifier: MIT
#include "widgets/viewport/PathDrawing.h"

namespace crowd::widgets {

namespace {

QColor screenColorOf(const std::array<std::uint8_t, 3>& color)
{
    return {color[0], color[1], color[2]};
}

} // namespace

std::vector<PlaceLabel> PathDrawing::labels(const EditorState& state, const model::View& view)
{
    std::vector<PlaceLabel> labels;
    if (!state.viewOptions().showPaths) {
        return labels;
    }
    const model::Scene& scene = state.scene();
    const std::optional<model::BrushKind> kind = brushKindOf(state.tool());
    const bool isWorking = state.tool() == ToolId::Select || kind == model::BrushKind::Path ||
                           kind == model::BrushKind::Environment;
    const auto add = [&](const model::Place& place, const std::string& text, bool isSelected,
                         const std::array<std::uint8_t, 3>& color) {
        if (const auto pixel = view.project(place.position)) {
            labels.push_back({QPointF(pixel->x, pixel->y), QString::fromStdString(text),
                              screenColorOf(color), isSelected});
        }
    };
    for (const model::Place& place : scene.places) {
        const bool isSelected = state.paths().isSelected(place.id);
        const bool isActing = place.role != model::PlaceRole::Spot;
        if (isWorking || isSelected || isActing) {
            add(place, isSelected || isActing ? place.name : std::string(), isSelected,
                place.color);
        }
    }
    for (const model::Path& path : scene.paths) {
        const model::Place* first =
            path.places.empty() ? nullptr : scene.findPlace(path.places.front());
        if (first != nullptr && !state.paths().isSelected(first->id)) {
            add(*first, path.name, path.id == state.paths().path(), path.color);
        }
    }
    return labels;
}

} // namespace crowd::widgets
