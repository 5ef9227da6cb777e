// SPDX-License-Identifier: MIT
#include "widgets/viewport/PathDrawing.h"

#include <algorithm>
#include <cmath>

namespace crowd::widgets {

namespace {

constexpr int kSides = 48;
constexpr float kLift = 0.06F; ///< metres above the ground, so that it does not flicker
constexpr float kRingShare = 0.09F;
constexpr float kArrowMetres = 1.3F;
constexpr float kArrowSpacing = 7.0F;

const glm::vec3 kUp(0.0F, kLift, 0.0F);

glm::vec4 colorOf(const std::array<std::uint8_t, 3>& color, float alpha)
{
    return {static_cast<float>(color[0]) / 255.0F, static_cast<float>(color[1]) / 255.0F,
            static_cast<float>(color[2]) / 255.0F, alpha};
}

QColor screenColorOf(const std::array<std::uint8_t, 3>& color)
{
    return {color[0], color[1], color[2]};
}

} // namespace

void PathDrawing::ring(const model::Place& place, glm::vec4 color)
{
    const float inner = place.radius - std::clamp(place.radius * kRingShare, 0.04F, 0.15F);
    const auto at = [&](int side, float radius) {
        const float angle = 6.2831853F * static_cast<float>(side) / static_cast<float>(kSides);
        return place.position + kUp + radius * glm::vec3(std::sin(angle), 0.0F, std::cos(angle));
    };
    glm::vec4 faint = color;
    faint.a *= place.role == model::PlaceRole::Spot ? 0.25F : 0.5F;
    for (int side = 0; side < kSides; ++side) {
        const glm::vec3 a = at(side, place.radius);
        const glm::vec3 b = at(side + 1, place.radius);
        const glm::vec3 c = at(side + 1, inner);
        const glm::vec3 d = at(side, inner);
        m_areas.push_back({{a, b, c}, color});
        m_areas.push_back({{a, c, d}, color});
        m_areas.push_back({{d, c, place.position + kUp}, faint});
    }
}

/// A lane as wide as the flow, and arrows along its middle.
void PathDrawing::lane(const model::Place& from, const model::Place& to, glm::vec4 color,
                       bool isJump)
{
    const glm::vec3 way = to.position - from.position;
    const float length = std::sqrt(way.x * way.x + way.z * way.z);
    if (length < 0.01F) {
        return;
    }
    const glm::vec3 along = way / length;
    const glm::vec3 aside(along.z, 0.0F, -along.x);
    const glm::vec3 a = from.position + kUp;
    const glm::vec3 b = to.position + kUp;
    if (!isJump) {
        glm::vec4 faint = color;
        faint.a *= 0.36F;
        m_areas.push_back(
            {{a - aside * from.radius, a + aside * from.radius, b + aside * to.radius}, faint});
        m_areas.push_back(
            {{a - aside * from.radius, b + aside * to.radius, b - aside * to.radius}, faint});
    }
    const float size =
        std::min({kArrowMetres, length * 0.4F, std::max(0.25F, (from.radius + to.radius) * 0.6F)});
    const int arrows = std::max(1, static_cast<int>(length / kArrowSpacing));
    for (int i = 0; i < arrows; ++i) {
        const float share = (static_cast<float>(i) + 0.5F) / static_cast<float>(arrows);
        const glm::vec3 tip = a + way * share + along * size * 0.5F + kUp * 0.2F;
        const glm::vec3 back = tip - along * size;
        const glm::vec3 notch = tip - along * size * 0.65F;
        m_areas.push_back({{tip, notch, back + aside * size * 0.45F}, color});
        m_areas.push_back({{tip, back - aside * size * 0.45F, notch}, color});
    }
}

void PathDrawing::draw(const EditorState& state)
{
    const model::Scene& scene = state.scene();
    m_areas.clear();
    for (const model::Path& path : scene.paths) {
        const bool isCurrent = path.id == state.paths().path();
        const glm::vec4 color = colorOf(path.color, isCurrent ? 1.0F : 0.85F);
        const std::size_t count = path.places.size();
        const bool isOpen = path.kind == model::PathKind::Simple || count < 2 ||
                            (isCurrent && state.paths().isPainting() && count < 3);
        for (std::size_t i = 0; i < count && i + 1 < count + (isOpen ? 0 : 1); ++i) {
            const model::Place* from = scene.findPlace(path.places[i]);
            const model::Place* to = scene.findPlace(path.places[(i + 1) % count]);
            if (from != nullptr && to != nullptr) {
                const bool isJump = i + 1 == count && path.kind == model::PathKind::Teleport;
                lane(*from, *to, isJump ? glm::vec4(color.r, color.g, color.b, 0.25F) : color,
                     isJump);
            }
        }
    }
    for (const model::Place& place : scene.places) {
        ring(place, colorOf(place.color, state.paths().isSelected(place.id) ? 1.0F : 0.9F));
    }
}

std::span<const render::OverlayTriangle> PathDrawing::areas(const EditorState& state)
{
    if (m_isStale) {
        m_isStale = false;
        draw(state);
    }
    return m_areas;
}

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
