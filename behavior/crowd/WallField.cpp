// SPDX-License-Identifier: MIT
#include "behavior/crowd/WallField.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace crowd::behavior {

namespace {

constexpr float kBinMetres = 2.0F;
constexpr double kMostBins = 4e6;
constexpr float kSamePlace = 1000.0F; ///< ends of walls that share a millimetre meet

bool isUsable(const Wall& wall)
{
    const float length = glm::distance(wall.a, wall.b);
    return std::isfinite(length) && length > 1e-4F;
}

std::pair<long, long> nameOf(const glm::vec2& place)
{
    return {std::lround(place.x * kSamePlace), std::lround(place.y * kSamePlace)};
}

/// The two ends of a piece.
std::pair<glm::vec2, glm::vec2> endsOf(const WallPiece& piece)
{
    return {piece.at, piece.at + piece.along * piece.length};
}

} // namespace

void WallField::setWalls(std::span<const Wall> walls, float reach)
{
    m_pieces.clear();
    std::vector<Wall> usable;
    std::ranges::copy_if(walls, std::back_inserter(usable), isUsable);
    for (const Wall& wall : usable) {
        const float length = glm::distance(wall.a, wall.b);
        m_pieces.push_back({wall.a, (wall.b - wall.a) / length, glm::vec2(0.0F), length, wall.low,
                            wall.high, wall.isOneSided});
    }
    addCorners(usable);
    layOut(reach);
}

void WallField::addCorners(std::span<const Wall> walls)
{
    std::map<std::pair<long, long>, std::size_t> corners;
    const auto leave = [&](const glm::vec2& at, const glm::vec2& to, const Wall& wall) {
        const glm::vec2 along = glm::normalize(to - at);
        const auto [entry, isNew] = corners.try_emplace(nameOf(at), m_pieces.size());
        if (isNew) {
            m_pieces.push_back({at, along, glm::vec2(0.0F), 0.0F, wall.low, wall.high});
            return;
        }
        WallPiece& corner = m_pieces[entry->second];
        corner.second = along;
        corner.low = std::min(corner.low, wall.low);
        corner.high = std::max(corner.high, wall.high);
    };
    for (const Wall& wall : walls) {
        leave(wall.a, wall.b, wall);
        leave(wall.b, wall.a, wall);
    }
}

/// Places bins around all pieces, widened by the reach. Returns their size, metres.
float WallField::placeBins(float reach)
{
    glm::vec2 low(std::numeric_limits<float>::max());
    glm::vec2 high(std::numeric_limits<float>::lowest());
    for (const WallPiece& piece : m_pieces) {
        const auto [a, b] = endsOf(piece);
        low = glm::min(low, glm::min(a, b));
        high = glm::max(high, glm::max(a, b));
    }
    m_low = low - reach;
    const glm::vec2 size = high + reach - m_low;
    float bin = kBinMetres;
    while ((static_cast<double>(size.x / bin) + 1.0) * (static_cast<double>(size.y / bin) + 1.0) >
           kMostBins) {
        bin *= 2.0F;
    }
    m_perMetre = 1.0F / bin;
    m_width = static_cast<int>(size.x * m_perMetre) + 1;
    m_depth = static_cast<int>(size.y * m_perMetre) + 1;
    return bin;
}

/// Lists a piece in the bins that it comes near. A slanting wall passes by most bins of its box.
void WallField::listPiece(std::uint32_t index, float bin, float reach,
                          std::vector<std::vector<std::uint32_t>>& lists) const
{
    const WallPiece& piece = m_pieces[index];
    const auto [a, b] = endsOf(piece);
    const glm::vec2 from = (glm::min(a, b) - reach - m_low) * m_perMetre;
    const glm::vec2 to = (glm::max(a, b) + reach - m_low) * m_perMetre;
    const int lastColumn = std::min(static_cast<int>(to.x), m_width - 1);
    const int lastLine = std::min(static_cast<int>(to.y), m_depth - 1);
    for (int line = std::max(0, static_cast<int>(from.y)); line <= lastLine; ++line) {
        for (int column = std::max(0, static_cast<int>(from.x)); column <= lastColumn; ++column) {
            const glm::vec2 middle = m_low + (glm::vec2(column, line) + 0.5F) * bin - piece.at;
            const float along = std::clamp(glm::dot(middle, piece.along), 0.0F, piece.length);
            if (glm::distance(middle, along * piece.along) <= reach + bin * 0.7072F) {
                lists[static_cast<std::size_t>(line) * static_cast<std::size_t>(m_width) +
                      static_cast<std::size_t>(column)]
                    .push_back(index);
            }
        }
    }
}

/// Lists the pieces of each bin, widened by the reach.
void WallField::layOut(float reach)
{
    m_start.clear();
    m_items.clear();
    m_width = 0;
    m_depth = 0;
    if (m_pieces.empty()) {
        return;
    }
    const float bin = placeBins(reach);
    std::vector<std::vector<std::uint32_t>> lists(static_cast<std::size_t>(m_width) *
                                                  static_cast<std::size_t>(m_depth));
    for (std::uint32_t i = 0; i < m_pieces.size(); ++i) {
        listPiece(i, bin, reach, lists);
    }
    for (const auto& list : lists) {
        m_start.push_back(static_cast<std::uint32_t>(m_items.size()));
        m_items.insert(m_items.end(), list.begin(), list.end());
    }
    m_start.push_back(static_cast<std::uint32_t>(m_items.size()));
}

} // namespace crowd::behavior
