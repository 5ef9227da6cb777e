// SPDX-License-Identifier: MIT
#include "widgets/viewport/TakeGhosts.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "widgets/tools/GhostPreview.h"

namespace crowd::widgets {

namespace {

constexpr std::size_t kMostGhosts = 120; ///< each is drawn by itself
constexpr std::size_t kMostWays = 4000;
constexpr float kAnkleMetres = 0.1F; ///< over the ground, so that it does not hide the line
constexpr glm::vec4 kWayColor{0.35F, 0.72F, 0.95F, 0.8F};

} // namespace

void TakeGhosts::make(EditorState& state, std::span<const model::WorldSeat> seats,
                      const model::CrowdFrame& shown)
{
    m_ghosts.clear();
    m_lines.clear();
    const model::CrowdFramePtr other = state.takes().ghostFrame(shown.seconds);
    if (!other) {
        return;
    }
    const TakeDifference found = differenceOf(shown, *other);
    std::vector<std::size_t> rows = found.rows;
    rows.insert(rows.end(), found.absent.begin(), found.absent.end());
    const auto here = shown.population.column(model::columns::position);
    const auto there = other->population.column(model::columns::position);
    const auto distance = [&](std::size_t row) {
        const glm::vec3 way = there[row] - state.camera().position;
        return glm::dot(way, way);
    };
    std::ranges::sort(rows, [&](std::size_t a, std::size_t b) {
        return std::pair(distance(a), a) < std::pair(distance(b), b);
    });
    for (const std::size_t row : rows) {
        if (m_ghosts.size() < kMostGhosts) {
            m_ghosts.push_back(
                ghostOf(state.scene(), seats, other->population, row, shown.seconds));
        }
        if (m_lines.size() >= kMostWays) {
            break;
        }
        if (std::ranges::binary_search(found.absent, row)) {
            continue; // no way leads to him
        }
        const glm::vec3 above(0.0F, kAnkleMetres, 0.0F);
        m_lines.push_back({there[row] + above, here[row] + above, kWayColor, 3.0F, 1.0F});
    }
}

} // namespace crowd::widgets
