// SPDX-License-Identifier: MIT
#include "behavior/crowd/ParkedBodies.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "behavior/crowd/ForceKernel.h"

namespace crowd::behavior {

namespace {

constexpr float kLooksAhead = 6.0F;  ///< metres
constexpr float kRoom = 0.1F;        ///< metres: who passes nearer than that turns aside
constexpr float kPassingRoom = 0.2F; ///< so much he leaves then
constexpr float kGap = 0.9F;         ///< metres between two: less is no way through for a person
constexpr float kStandsBelow = 0.15F;
constexpr float kFurthestTurn = 2.6F; ///< radians: further would be back again
constexpr float kCellMetres = 8.0F;
constexpr float kLeast = 1e-3F;

float cross(const glm::vec2& a, const glm::vec2& b)
{
    return a.x * b.y - a.y * b.x;
}

float awayFrom(const glm::vec2& point, const glm::vec2& a, const glm::vec2& b)
{
    const glm::vec2 along = b - a;
    const float squared = glm::dot(along, along);
    const float share =
        squared > 0.0F ? glm::clamp(glm::dot(point - a, along) / squared, 0.0F, 1.0F) : 0.0F;
    return glm::distance(point, a + along * share);
}

/// Between two lines.
float awayFrom(const glm::vec2& a, const glm::vec2& b, const glm::vec2& c, const glm::vec2& d)
{
    const bool doCross = cross(b - a, c - a) * cross(b - a, d - a) < 0.0F &&
                         cross(d - c, a - c) * cross(d - c, b - c) < 0.0F;
    return doCross ? 0.0F
                   : std::min({awayFrom(a, c, d), awayFrom(b, c, d), awayFrom(c, a, b),
                               awayFrom(d, a, b)});
}

/// By so many radians, in the sense in which spans count.
glm::vec2 turned(const glm::vec2& way, float radians)
{
    const float c = std::cos(radians);
    const float s = std::sin(radians);
    return {way.x * c - way.y * s, way.x * s + way.y * c};
}

} // namespace

ParkedBodies::Cell ParkedBodies::cellOf(const glm::vec2& at)
{
    constexpr float kMost = 1e9F; // cells
    const glm::vec2 cell = glm::clamp(glm::floor(at / kCellMetres), -kMost, kMost);
    return {static_cast<std::int32_t>(cell.x), static_cast<std::int32_t>(cell.y)};
}

void ParkedBodies::gather(std::span<const LongBody> longBodies, std::span<const Body> bodies,
                          std::span<const float> heights)
{
    std::vector<Capsule> capsules;
    for (const LongBody& each : longBodies) {
        const Body& body = bodies[each.agent];
        const glm::vec2 velocity(body.velocityX, body.velocityZ);
        if (body.preferredSpeed != 0.0F ||
            glm::dot(velocity, velocity) > kStandsBelow * kStandsBelow) {
            continue;
        }
        const glm::vec2 at(body.x, body.z);
        const glm::vec2 heading(each.headingX, each.headingZ);
        capsules.push_back({at + heading * each.front, at - heading * each.back, body.radius,
                            heights[each.agent]});
    }
    if (capsules == m_former) {
        return;
    }
    m_former = capsules;
    m_capsules = std::move(capsules);
    cluster();
    layOut();
}

/// Those that stand so close to each other that nobody gets through lie side by side afterwards.
void ParkedBodies::cluster()
{
    const std::vector<Capsule> all = std::move(m_capsules);
    m_capsules.clear();
    m_clusters.clear();
    std::vector<bool> isTaken(all.size(), false);
    for (std::size_t first = 0; first < all.size(); ++first) {
        if (isTaken[first]) {
            continue;
        }
        Cluster made{m_capsules.size(), 0, glm::vec2(0.0F)};
        isTaken[first] = true;
        m_capsules.push_back(all[first]);
        for (std::size_t next = made.begin; next < m_capsules.size(); ++next) {
            const Capsule one = m_capsules[next];
            made.middle += 0.5F * (one.a + one.b);
            for (std::size_t other = first + 1; other < all.size(); ++other) {
                const Capsule& two = all[other];
                const bool isBeside =
                    !isTaken[other] && std::fabs(one.height - two.height) <= kLevelMetres &&
                    awayFrom(one.a, one.b, two.a, two.b) - one.radius - two.radius < kGap;
                if (isBeside) {
                    isTaken[other] = true;
                    m_capsules.push_back(two);
                }
            }
        }
        made.end = m_capsules.size();
        made.middle /= static_cast<float>(made.end - made.begin);
        m_clusters.push_back(made);
    }
}

void ParkedBodies::layOut()
{
    m_near.clear();
    for (std::uint32_t index = 0; index < m_clusters.size(); ++index) {
        for (std::size_t i = m_clusters[index].begin; i < m_clusters[index].end; ++i) {
            const Capsule& each = m_capsules[i];
            const float reach = each.radius + kLooksAhead + kCellMetres;
            const Cell low = cellOf(glm::min(each.a, each.b) - reach);
            const Cell high = cellOf(glm::max(each.a, each.b) + reach);
            for (std::int32_t x = low.first; x <= high.first; ++x) {
                for (std::int32_t z = low.second; z <= high.second; ++z) {
                    std::vector<std::uint32_t>& near = m_near[{x, z}];
                    if (near.empty() || near.back() != index) {
                        near.push_back(index);
                    }
                }
            }
        }
    }
}

bool ParkedBodies::isMet(const Cluster& cluster, const Walker& who, const glm::vec2& end,
                         float room) const
{
    return std::any_of(
        m_capsules.begin() + static_cast<std::ptrdiff_t>(cluster.begin),
        m_capsules.begin() + static_cast<std::ptrdiff_t>(cluster.end), [&](const Capsule& each) {
            return std::fabs(each.height - who.height) <= kLevelMetres &&
                   awayFrom(who.at, end, each.a, each.b) < each.radius + who.radius + room;
        });
}

ParkedBodies::Span ParkedBodies::spanOf(const Cluster& cluster, const Walker& who,
                                        const glm::vec2& ahead) const
{
    const auto angle = [](const glm::vec2& from, const glm::vec2& to) {
        return std::atan2(cross(from, to), glm::dot(from, to));
    };
    // From its middle, which angles on either side are reckoned from.
    const glm::vec2 middle = cluster.middle - who.at;
    const glm::vec2 towards = glm::dot(middle, middle) > kLeast * kLeast ? middle : ahead;
    Span span{1e3F, -1e3F, 0.0F};
    for (std::size_t i = cluster.begin; i < cluster.end; ++i) {
        const Capsule& each = m_capsules[i];
        for (const glm::vec2& end : {each.a, each.b}) {
            const glm::vec2 way = end - who.at;
            const float distance = std::max(glm::length(way), kLeast);
            const float room = each.radius + who.radius + kPassingRoom;
            const float half = std::asin(std::min(room / distance, 1.0F));
            const float at = angle(towards, way);
            span.low = std::min(span.low, at - half);
            span.high = std::max(span.high, at + half);
            span.metres = std::max(span.metres, distance);
        }
    }
    const float turn = angle(ahead, towards);
    span.low += turn;
    span.high += turn;
    return span;
}

std::optional<glm::vec2> ParkedBodies::around(const Walker& who, const IsClear& isClear) const
{
    const auto found = m_near.find(cellOf(who.at));
    const glm::vec2 way = who.aim - who.at;
    const float metres = glm::length(way);
    if (found == m_near.end() || metres < kLeast) {
        return std::nullopt;
    }
    const glm::vec2 ahead = way / metres;
    const glm::vec2 end = who.at + ahead * std::min(metres, kLooksAhead);
    std::optional<Span> blocked;
    for (const std::uint32_t index : found->second) {
        const Cluster& cluster = m_clusters[index];
        // Who wants to go right up to it may.
        if (isMet(cluster, who, end, kRoom) &&
            !isMet(cluster, {who.aim, who.aim, who.radius, who.height}, who.aim, kRoom)) {
            const Span span = spanOf(cluster, who, ahead);
            blocked = !blocked || span.metres < blocked->metres ? span : *blocked;
        }
    }
    if (!blocked) {
        return std::nullopt;
    }
    const bool isLowNearer = -blocked->low < blocked->high;
    for (const bool isLow : {isLowNearer, !isLowNearer}) {
        const float edge = isLow ? blocked->low : blocked->high;
        const glm::vec2 aside = turned(ahead, edge);
        if (std::fabs(edge) < kFurthestTurn && isClear(who.at, who.at + aside * blocked->metres)) {
            return aside;
        }
    }
    return std::nullopt;
}

} // namespace crowd::behavior
