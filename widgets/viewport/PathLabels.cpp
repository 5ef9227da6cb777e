// SPDX-License-Identifier: MIT
#include "widgets/viewport/PathLabels.h"

#include <algorithm>

namespace crowd::widgets {

namespace {

QColor screenColorOf(const std::array<std::uint8_t, 3>& color)
{
    return {color[0], color[1], color[2]};
}

/// Those that rules speak of by name.
std::vector<model::PlaceId> placesOfRules(const model::Scene& scene)
{
    std::vector<model::PlaceId> named;
    for (const model::Rule& rule : scene.rules) {
        const auto ids = model::idsNamedIn(rule, model::FieldRole::Place);
        named.insert(named.end(), ids.begin(), ids.end());
    }
    std::ranges::sort(named);
    return named;
}

/// Whether the artist, who works on paths, may look for it by its name: those of other paths would
/// hide the picture.
bool isAtHand(const EditorState& state, model::PlaceId place)
{
    const auto leadsOver = [place](const model::Path& path) {
        return std::ranges::find(path.places, place) != path.places.end();
    };
    const auto& paths = state.scene().paths;
    const model::Path* current = state.scene().findPath(state.paths().path());
    return (current != nullptr && leadsOver(*current)) || std::ranges::none_of(paths, leadsOver);
}

} // namespace

std::vector<PlaceLabel> pathLabels(const EditorState& state, const model::View& view)
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
    const std::vector<model::PlaceId> ofRules = placesOfRules(scene);
    for (const model::Place& place : scene.places) {
        const bool isSelected = state.paths().isSelected(place.id);
        const bool isNamed = place.role != model::PlaceRole::Spot ||
                             std::ranges::binary_search(ofRules, place.id) ||
                             (isWorking && isAtHand(state, place.id));
        if (isWorking || isSelected || isNamed) {
            add(place, isSelected || isNamed ? place.name : std::string(), isSelected, place.color);
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
