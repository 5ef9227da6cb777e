// SPDX-License-Identifier: MIT
#include "widgets/viewport/PathDrawing.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "model/scene/PlaceShape.h"
#include "widgets/viewport/AreaSlices.h"
#include "widgets/viewport/WaysAround.h"

namespace crowd::widgets {

namespace {

constexpr float kRingShare = 0.09F; ///< of the radius
constexpr float kArrowMetres = 1.3F;
constexpr float kArrowSpacing = 7.0F;
constexpr float kLaneOpacity = 0.34F;
constexpr float kCurrentLaneOpacity = 0.5F;
constexpr float kSpotOpacity = 0.45F;
constexpr float kRoleOpacity = 0.5F;
constexpr float kJumpOpacity = 0.3F;
constexpr float kBright = 0.72F;    ///< from the colour towards white
constexpr float kSideWidth = 0.06F; ///< metres to either side, of an area's sides
constexpr float kCornerRadius = 0.18F;
constexpr float kWayNarrow = 0.04F; ///< metres to either side, of a way around something
constexpr float kWayWide = 0.1F;
constexpr float kWayShade = 0.4F; ///< of the colour
constexpr float kShortestPiece = 0.05F;

constexpr float kCell = 1.0F;           ///< metres between samples of the ground
constexpr float kManyMetres = 2'000.0F; ///< of paths: samples lie farther apart beyond
constexpr float kBranchBend = 0.12F;    ///< of its length, aside, so that it crosses bands
constexpr float kBranchNarrow = 0.16F;  ///< metres to either side
constexpr float kBranchWide = 0.4F;
constexpr float kDashWidths = 6.0F; ///< half widths from dash to dash
constexpr int kMostDashes = 200;

glm::vec3 colorOf(const std::array<std::uint8_t, 3>& color)
{
    return {static_cast<float>(color[0]) / 255.0F, static_cast<float>(color[1]) / 255.0F,
            static_cast<float>(color[2]) / 255.0F};
}

glm::vec3 bright(const glm::vec3& color)
{
    return glm::mix(color, glm::vec3(1.0F), kBright);
}

/// Wide enough to be seen from where the whole band is.
float borderOf(float radius)
{
    return std::clamp(radius * 0.17F, 0.06F, 0.6F);
}

float flatDistance(const glm::vec3& a, const glm::vec3& b)
{
    return glm::length(glm::vec2(a.x - b.x, a.z - b.z));
}

/// Metres of all paths together.
float lengthOf(const model::Scene& scene)
{
    float metres = 0.0F;
    for (const model::Path& path : scene.paths) {
        for (std::size_t i = 0; i + 1 < path.places.size(); ++i) {
            const model::Place* from = scene.findPlace(path.places[i]);
            const model::Place* to = scene.findPlace(path.places[i + 1]);
            metres += from != nullptr && to != nullptr ? flatDistance(from->position, to->position)
                                                       : 0.0F;
        }
    }
    return metres;
}

/// In steps, so that what is laid out keeps while a place is dragged.
float cellFor(const model::Scene& scene)
{
    float cell = kCell;
    for (float metres = lengthOf(scene); metres > kManyMetres; metres *= 0.5F) {
        cell *= 2.0F;
    }
    return cell;
}

/// From the rim of a place to the rim of another, bent to the right.
class BranchCurve
{
public:
    BranchCurve(const model::Place& from, const model::Place& to, float bend)
        : m_from(from.position), m_to(to.position)
    {
        const glm::vec3 way = m_to - m_from;
        m_control = (m_from + m_to) * 0.5F + glm::vec3(-way.z, 0.0F, way.x) * bend;
        const float metres = flatDistance(m_from, m_to);
        m_first = std::min(from.radius / metres, 0.3F);
        m_last = 1.0F - std::min(to.radius / metres, 0.3F);
    }
    [[nodiscard]] glm::vec3 at(float share) const
    {
        const float t = glm::mix(m_first, m_last, share);
        return glm::mix(glm::mix(m_from, m_control, t), glm::mix(m_control, m_to, t), t);
    }

private:
    glm::vec3 m_from;
    glm::vec3 m_to;
    glm::vec3 m_control{0.0F};
    float m_first = 0.0F;
    float m_last = 1.0F;
};

} // namespace

void PathDrawing::add(Layer layer, const std::vector<GroundTriangle>& triangles, glm::vec4 color)
{
    auto& list = m_layers[static_cast<std::size_t>(layer)];
    for (const GroundTriangle& corners : triangles) {
        list.push_back({corners, color});
    }
}

void PathDrawing::band(const BandShape& shape, Layer layer, glm::vec4 color)
{
    add(layer, m_sheets.band(shape), color);
}

void PathDrawing::ring(const RingShape& shape, Layer layer, glm::vec4 color)
{
    add(layer, m_sheets.ring(shape), color);
}

/// Lies on the ground with each of its corners; `tip` lies on it already.
void PathDrawing::arrow(const glm::vec3& tip, const glm::vec3& along, float size, Layer layer,
                        glm::vec4 color)
{
    const glm::vec3 aside(along.z, 0.0F, -along.x);
    const auto corner = [&](float back, float off) {
        return m_sheets.onGround(tip - along * (size * back) + aside * (size * off),
                                 size * 0.7F + 0.2F);
    };
    const glm::vec3 notch = corner(0.65F, 0.0F);
    const glm::vec3 top = corner(0.0F, 0.0F);
    add(layer, {{top, notch, corner(1.0F, 0.45F)}, {top, corner(1.0F, -0.45F), notch}}, color);
}

void PathDrawing::place(const model::Place& place, bool isSelected)
{
    const bool isSpot = place.role == model::PlaceRole::Spot;
    const glm::vec4 fill(colorOf(place.color), isSpot ? kSpotOpacity : kRoleOpacity);
    switch (place.shape) {
    case model::PlaceShape::Round:
        disc(place, fill, isSelected);
        break;
    case model::PlaceShape::Line:
        line(place, fill, isSelected);
        break;
    case model::PlaceShape::Area:
        area(place, fill, isSelected);
        break;
    }
}

void PathDrawing::disc(const model::Place& place, glm::vec4 fill, bool isSelected)
{
    const glm::vec3 color(fill);
    const float width = std::clamp(place.radius * kRingShare, 0.04F, 0.15F);
    ring({place.position, place.radius - width, place.radius}, Layer::Ring, {color, 1.0F});
    ring({place.position, 0.0F, place.radius - width}, Layer::Disc, fill);
    if (isSelected) {
        ring({place.position, place.radius, place.radius + borderOf(place.radius)},
             Layer::SelectedRing, {bright(color), 1.0F});
    }
}

/// As wide as it keeps people off, round where it bends, its middle drawn out.
void PathDrawing::line(const model::Place& place, glm::vec4 fill, bool isSelected)
{
    const glm::vec3 color(fill);
    const float half = place.radius;
    const float width = std::clamp(half * kRingShare, 0.04F, 0.15F);
    const float border = half + borderOf(half);
    const std::vector<glm::vec3> corners = model::cornersOf(place);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        ring({corners[i], 0.0F, half}, Layer::Disc, fill);
        if (i + 1 < corners.size()) {
            const glm::vec3& to = corners[i + 1];
            band({corners[i], to, {-half, half}, {-half, half}}, Layer::Disc, fill);
            band({corners[i], to, {-width, width}, {-width, width}}, Layer::Ring, {color, 1.0F});
        }
        if (isSelected && i + 1 < corners.size()) {
            const glm::vec3& to = corners[i + 1];
            const glm::vec4 shown(bright(color), 1.0F);
            band({corners[i], to, {half, border}, {half, border}}, Layer::SelectedRing, shown);
            band({corners[i], to, {-border, -half}, {-border, -half}}, Layer::SelectedRing, shown);
        }
    }
    if (isSelected) {
        this->corners(place);
    }
}

void PathDrawing::area(const model::Place& place, glm::vec4 fill, bool isSelected)
{
    const glm::vec3 color(fill);
    const std::vector<glm::vec3> corners = model::cornersOf(place);
    for (const BandShape& slice : slicesOf(corners)) {
        band(slice, Layer::Disc, fill);
    }
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::vec3& to = corners[(i + 1) % corners.size()];
        band({corners[i], to, {-kSideWidth, kSideWidth}, {-kSideWidth, kSideWidth}},
             isSelected ? Layer::SelectedRing : Layer::Ring,
             {isSelected ? bright(color) : color, 1.0F});
    }
    if (isSelected) {
        this->corners(place);
    }
}

/// To take hold of.
void PathDrawing::corners(const model::Place& place)
{
    const glm::vec4 shown(bright(colorOf(place.color)), 1.0F);
    for (const glm::vec3& corner : model::cornersOf(place)) {
        ring({corner, 0.0F, kCornerRadius}, Layer::SelectedRing, shown);
    }
}

/// Arrows along the middle.
void PathDrawing::arrows(const model::Place& from, const model::Place& to, glm::vec4 color)
{
    const float length = flatDistance(from.position, to.position);
    const glm::vec3 way = to.position - from.position;
    const glm::vec3 along = glm::vec3(way.x, 0.0F, way.z) / length;
    const float size =
        std::min({kArrowMetres, length * 0.4F, std::max(0.25F, (from.radius + to.radius) * 0.6F)});
    const int count = std::max(1, static_cast<int>(length / kArrowSpacing));
    for (int i = 0; i < count; ++i) {
        const float share = (static_cast<float>(i) + 0.5F) / static_cast<float>(count);
        const glm::vec3 middle = m_sheets.onGround(from.position + way * share,
                                                   GroundSheets::reachBetween(length, share));
        arrow(middle + along * (size * 0.5F), along, size, Layer::Arrow, color);
    }
}

/// As people really walk, where that is not straight on: narrow, and an arrow on each piece.
void PathDrawing::way(const std::vector<glm::vec3>& corners, const model::Place& from,
                      const model::Place& to, glm::vec3 color)
{
    const float half = std::clamp(0.04F * std::min(from.radius, to.radius), kWayNarrow, kWayWide);
    const glm::vec4 shown(color * kWayShade, 1.0F); // told from the lane and from its bright border
    for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
        const float metres = flatDistance(corners[i], corners[i + 1]);
        if (metres < kShortestPiece) {
            continue;
        }
        band({corners[i], corners[i + 1], {-half, half}, {-half, half}}, Layer::Way, shown);
        const glm::vec3 step = (corners[i + 1] - corners[i]) / metres;
        const glm::vec3 along(step.x, 0.0F, step.z);
        const float size = std::min({kArrowMetres, 0.5F * metres, 8.0F * half});
        const glm::vec3 middle = m_sheets.onGround(glm::mix(corners[i], corners[i + 1], 0.5F),
                                                   GroundSheets::reachBetween(metres, 0.5F));
        arrow(middle + along * (0.5F * size), along, size, Layer::Way, shown);
    }
}

/// A lane as wide as the flow.
void PathDrawing::leg(const model::Place& from, const model::Place& to, glm::vec3 color,
                      bool isCurrent)
{
    const glm::vec2 fromAside(-from.radius, from.radius);
    const glm::vec2 toAside(-to.radius, to.radius);
    band({from.position, to.position, fromAside, toAside},
         isCurrent ? Layer::CurrentLane : Layer::Lane,
         {color, isCurrent ? kCurrentLaneOpacity : kLaneOpacity});
    if (!isCurrent) {
        return;
    }
    const float fromBorder = borderOf(from.radius);
    const float toBorder = borderOf(to.radius);
    const glm::vec4 border(bright(color), 1.0F);
    ring({from.position, from.radius, from.radius + fromBorder}, Layer::CurrentBorder, border);
    ring({to.position, to.radius, to.radius + toBorder}, Layer::CurrentBorder, border);
    band({from.position,
          to.position,
          {from.radius, from.radius + fromBorder},
          {to.radius, to.radius + toBorder}},
         Layer::CurrentBorder, border);
    band({from.position,
          to.position,
          {-from.radius - fromBorder, -from.radius},
          {-to.radius - toBorder, -to.radius}},
         Layer::CurrentBorder, border);
}

/// Where some leave a path for another one's beginning: dashes that bend to the right, in the other
/// path's colour, and an arrow. Several from one place bend differently.
void PathDrawing::branch(const model::Scene& scene, const model::PathBranch& branch, int number)
{
    const model::Path* target = scene.findPath(branch.path);
    const model::Place* from = scene.findPlace(branch.place);
    if (target == nullptr || from == nullptr || target->places.empty()) {
        return;
    }
    const model::Place* to = scene.findPlace(target->places.front());
    if (to == from && target->places.size() > 1) {
        to = scene.findPlace(target->places[1]); // they are on it already
    }
    const float metres = to != nullptr ? flatDistance(from->position, to->position) : 0.0F;
    if (metres < 0.1F) {
        return;
    }
    const glm::vec4 color(colorOf(target->color), 1.0F);
    const float half =
        std::clamp(std::min(from->radius, to->radius) * 0.2F, kBranchNarrow, kBranchWide);
    const BranchCurve curve(*from, *to, kBranchBend * static_cast<float>(1 + number));
    const auto at = [&](float share) {
        return m_sheets.onGround(curve.at(share), GroundSheets::reachBetween(metres, share));
    };
    const int dashes = std::clamp(static_cast<int>(metres / (half * kDashWidths)), 2, kMostDashes);
    for (int i = 0; i < dashes; ++i) {
        const float start = static_cast<float>(i) / static_cast<float>(dashes);
        const glm::vec3 a = at(start);
        const glm::vec3 b = at(start + 0.6F / static_cast<float>(dashes));
        band({a, b, {-half, half}, {-half, half}}, Layer::Branch, color);
    }
    const glm::vec3 tip = at(1.0F);
    const glm::vec3 way = tip - at(1.0F - 0.5F / static_cast<float>(dashes));
    const glm::vec3 along = glm::normalize(glm::vec3(way.x, 0.0F, way.z));
    arrow(tip, along, std::min(half * 6.0F, metres * 0.5F), Layer::Branch, color);
}

void PathDrawing::path(const EditorState& state, const model::Path& path)
{
    const model::Scene& scene = state.scene();
    const auto surface = state.session().surface();
    const bool isCurrent = path.id == state.paths().path();
    const glm::vec3 color = colorOf(path.color);
    const std::size_t count = path.places.size();
    const bool isOpen = path.kind == model::PathKind::Simple || count < 2 ||
                        (isCurrent && state.paths().isPainting() && count < 3);
    for (std::size_t i = 0; i < count && i + 1 < count + (isOpen ? 0 : 1); ++i) {
        const model::Place* from = scene.findPlace(path.places[i]);
        const model::Place* to = scene.findPlace(path.places[(i + 1) % count]);
        if (from == nullptr || to == nullptr ||
            flatDistance(from->position, to->position) < 0.01F) {
            continue;
        }
        const bool isJump = i + 1 == count && path.kind == model::PathKind::Teleport;
        const std::vector<WayCorners> around =
            isJump ? std::vector<WayCorners>() : waysAround(surface.get(), *from, *to);
        if (!isJump) {
            leg(*from, *to, color, isCurrent);
        }
        if (around.empty()) {
            arrows(*from, *to, {color, isJump ? kJumpOpacity : 1.0F});
        }
        for (const WayCorners& corners : around) {
            way(corners, *from, *to, color);
        }
    }
    for (std::size_t i = 0; i < path.branches.size(); ++i) {
        const auto isSame = [&](const model::PathBranch& other) {
            return other.place == path.branches[i].place;
        };
        const auto end = path.branches.begin() + static_cast<std::ptrdiff_t>(i);
        branch(scene, path.branches[i],
               static_cast<int>(std::count_if(path.branches.begin(), end, isSame)));
    }
}

void PathDrawing::draw(const EditorState& state, const model::StageRays& stage)
{
    const model::Scene& scene = state.scene();
    m_sheets.begin(stage, cellFor(scene));
    for (auto& layer : m_layers) {
        layer.clear();
    }
    for (const model::Path& each : scene.paths) {
        path(state, each);
    }
    for (const model::Place& each : scene.places) {
        place(each, state.paths().isSelected(each.id));
    }
    m_areas.clear();
    for (const auto& layer : m_layers) {
        m_areas.insert(m_areas.end(), layer.begin(), layer.end());
    }
    ++m_version;
}

std::span<const render::OverlayTriangle> PathDrawing::areas(const EditorState& state,
                                                            const model::StageRays& stage)
{
    if (m_isStale) {
        m_isStale = false;
        draw(state, stage);
    }
    return m_areas;
}

} // namespace crowd::widgets
