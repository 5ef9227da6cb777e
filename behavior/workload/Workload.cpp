// SPDX-License-Identifier: MIT
#include "behavior/workload/Workload.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

#include "behavior/crowd/Chunks.h"
#include "behavior/workload/PathsWorkload.h"
#include "model/base/Random.h"

namespace crowd::behavior {

namespace {

constexpr float kApart = 0.5F;

/// Asks `goalDirection(agent, position)` (unit) for everybody.
template<class Direction>
void steerAll(CrowdSimulation& crowd, const Direction& goalDirection)
{
    const std::span<Body> bodies = crowd.bodies();
    overRows(bodies.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t agent = begin; agent < end; ++agent) {
            Body& body = bodies[agent];
            const glm::vec2 wish =
                goalDirection(agent, glm::vec2(body.x, body.z)) * body.preferredSpeed;
            body.desiredX = wish.x;
            body.desiredZ = wish.y;
        }
    });
}

void place(CrowdSimulation& crowd, const std::vector<glm::vec2>& places)
{
    std::vector<AgentState> states(places.size());
    for (std::size_t i = 0; i < places.size(); ++i) {
        states[i].position = places[i];
        states[i].radius = kWorkloadRadius;
        states[i].preferredSpeed = kWorkloadSpeed;
    }
    crowd.setAgents(states);
}

glm::vec2 directionTo(const glm::vec2& goal, const glm::vec2& from)
{
    const glm::vec2 way = goal - from;
    const float squared = way.x * way.x + way.y * way.y;
    return squared > 1e-8F ? way / std::sqrt(squared) : glm::vec2(0.0F);
}

class SquareWorkload : public Workload
{
public:
    SquareWorkload(std::size_t count, std::uint64_t seed)
        : m_seed(seed), m_side(std::sqrt(static_cast<float>(count) / 0.5F)), m_goals(count),
          m_arrivals(count)
    {
        place(m_crowd, scatter(count, glm::vec2(0.0F), glm::vec2(m_side), kApart, seed));
        for (std::size_t i = 0; i < count; ++i) {
            m_goals[i] = goal(i);
        }
    }

    void steer() override
    {
        steerAll(m_crowd, [this](std::size_t agent, const glm::vec2& at) {
            const glm::vec2 way = m_goals[agent] - at;
            if (way.x * way.x + way.y * way.y < 1.0F) {
                ++m_arrivals[agent];
                m_goals[agent] = goal(agent);
            }
            return directionTo(m_goals[agent], at);
        });
    }
    [[nodiscard]] std::size_t outsideWalls() const override { return 0; }

private:
    [[nodiscard]] glm::vec2 goal(std::size_t agent) const
    {
        return m_side *
               glm::vec2(model::unitFloat(model::hashKeys(m_seed, 7, agent, m_arrivals[agent], 0)),
                         model::unitFloat(model::hashKeys(m_seed, 7, agent, m_arrivals[agent], 1)));
    }

    std::uint64_t m_seed;
    float m_side;
    std::vector<glm::vec2> m_goals;
    std::vector<std::uint32_t> m_arrivals;
};

class CorridorWorkload : public Workload
{
public:
    CorridorWorkload(std::size_t count, std::uint64_t seed)
        : m_length(static_cast<float>(count) / (2.0F * kWidth)), m_isForward(count)
    {
        const glm::vec2 margin(kWorkloadRadius);
        place(m_crowd, scatter(count, margin, glm::vec2(m_length, kWidth) - margin, kApart, seed));
        for (std::size_t i = 0; i < count; ++i) {
            m_isForward[i] = static_cast<std::uint8_t>(i % 2);
        }
        m_crowd.setWalls(rectangleWalls(glm::vec2(0.0F), glm::vec2(m_length, kWidth)));
    }

    void steer() override
    {
        steerAll(m_crowd, [this](std::size_t agent, const glm::vec2& at) {
            if (at.x < kTurn) {
                m_isForward[agent] = 1;
            } else if (at.x > m_length - kTurn) {
                m_isForward[agent] = 0;
            }
            return glm::vec2(m_isForward[agent] != 0 ? 1.0F : -1.0F, 0.0F);
        });
    }
    [[nodiscard]] std::size_t outsideWalls() const override
    {
        const auto isOutside = [this](const Body& body) {
            return !(body.x >= 0.0F && body.x <= m_length && body.z >= 0.0F && body.z <= kWidth);
        };
        return static_cast<std::size_t>(std::ranges::count_if(m_crowd.bodies(), isOutside));
    }

private:
    static constexpr float kWidth = 10.0F;
    static constexpr float kTurn = 1.0F;

    float m_length;
    std::vector<std::uint8_t> m_isForward;
};

/// Square blocks of houses, streets between them; everybody walks from crossing to crossing.
class CityWorkload : public Workload
{
public:
    CityWorkload(std::size_t count, std::uint64_t seed);

    void steer() override
    {
        steerAll(m_crowd, [this](std::size_t agent, const glm::vec2& at) {
            const glm::vec2 way = spotOf(agent) - at;
            if (way.x * way.x + way.y * way.y < 1.0F) {
                goOn(agent);
            }
            return directionTo(spotOf(agent), at);
        });
    }
    [[nodiscard]] std::size_t outsideWalls() const override;

private:
    static constexpr float kStreet = 8.0F;
    static constexpr float kPeriod = 40.0F; ///< a street and a block

    /// Middle of a crossing, or one's own spot near it.
    [[nodiscard]] static glm::vec2 middleOf(const glm::ivec2& crossing)
    {
        return glm::vec2(crossing) * kPeriod + 0.5F * kStreet;
    }
    [[nodiscard]] glm::vec2 spotOf(std::size_t agent) const
    {
        return middleOf(m_crossing[agent]) + m_beside[agent];
    }
    void goOn(std::size_t agent);

    std::uint64_t m_seed;
    int m_blocks;
    std::vector<glm::ivec2> m_crossing; ///< that each walks to
    std::vector<glm::vec2> m_beside;
    std::vector<std::uint32_t> m_turns;
};

CityWorkload::CityWorkload(std::size_t count, std::uint64_t seed)
    : m_seed(seed), m_blocks(1), m_crossing(count), m_beside(count), m_turns(count)
{
    const auto streetArea = [](int blocks) {
        const float side = static_cast<float>(blocks) * kPeriod + kStreet;
        const float block = kPeriod - kStreet;
        return side * side - static_cast<float>(blocks * blocks) * block * block;
    };
    while (streetArea(m_blocks) * 0.5F < static_cast<float>(count)) {
        ++m_blocks;
    }
    const float side = static_cast<float>(m_blocks) * kPeriod + kStreet;
    std::vector<Wall> walls = rectangleWalls(glm::vec2(0.0F), glm::vec2(side));
    for (int i = 0; i < m_blocks * m_blocks; ++i) {
        const glm::vec2 low = glm::vec2(i % m_blocks, i / m_blocks) * kPeriod + kStreet;
        for (const Wall& wall : rectangleWalls(low, low + kPeriod - kStreet)) {
            walls.push_back(wall);
        }
    }
    m_crowd.setWalls(walls);

    // Along the streets that run in x, one person after the other in rows across.
    std::vector<glm::vec2> places(count);
    const std::size_t streets = static_cast<std::size_t>(m_blocks) + 1;
    const std::vector<glm::vec2> strip =
        scatter((count + streets - 1) / streets, glm::vec2(0.5F),
                glm::vec2(side - 0.5F, kStreet - 0.5F), kApart, seed);
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t street = i % streets;
        places[i] = strip[i / streets] + glm::vec2(0.0F, static_cast<float>(street) * kPeriod);
        const int column = std::min(static_cast<int>(places[i].x / kPeriod), m_blocks);
        const int ahead = std::min(column + static_cast<int>(i / streets % 2), m_blocks);
        m_crossing[i] = {ahead, static_cast<int>(street)};
        for (int axis = 0; axis < 2; ++axis) {
            m_beside[i][axis] =
                (kStreet - 2.0F) * (model::unitFloat(model::hashKeys(seed, 9, i, axis)) - 0.5F);
        }
    }
    place(m_crowd, places);
}

void CityWorkload::goOn(std::size_t agent)
{
    constexpr std::array<glm::ivec2, 4> kWays{glm::ivec2(1, 0), {0, 1}, {-1, 0}, {0, -1}};
    glm::ivec2 next(-1);
    while (next.x < 0 || next.y < 0 || next.x > m_blocks || next.y > m_blocks) {
        ++m_turns[agent];
        next = m_crossing[agent] + kWays[model::hashKeys(m_seed, 8, agent, m_turns[agent]) % 4];
    }
    m_crossing[agent] = next;
}

std::size_t CityWorkload::outsideWalls() const
{
    const float side = static_cast<float>(m_blocks) * kPeriod + kStreet;
    std::size_t outside = 0;
    for (const Body& body : m_crowd.bodies()) {
        const float x = body.x;
        const float z = body.z;
        const bool isInside = x >= 0.0F && z >= 0.0F && x <= side && z <= side;
        const bool isInHouse = std::fmod(x, kPeriod) > kStreet && std::fmod(z, kPeriod) > kStreet;
        outside += isInside && !isInHouse ? 0U : 1U;
    }
    return outside;
}

} // namespace

std::vector<Wall> rectangleWalls(glm::vec2 low, glm::vec2 high)
{
    const glm::vec2 right(high.x, low.y);
    const glm::vec2 left(low.x, high.y);
    return {{low, right}, {right, high}, {high, left}, {left, low}};
}

std::vector<glm::vec2> scatter(std::size_t count, glm::vec2 low, glm::vec2 high, float apart,
                               std::uint64_t seed)
{
    constexpr int kTries = 200;
    const glm::vec2 size = high - low;
    const glm::ivec2 cells = glm::ivec2(size / apart) + 1;
    std::vector<std::vector<glm::vec2>> taken(static_cast<std::size_t>(cells.x) *
                                              static_cast<std::size_t>(cells.y));
    const auto at = [&taken, &cells](int x, int z) -> std::vector<glm::vec2>& {
        return taken[static_cast<std::size_t>(z) * static_cast<std::size_t>(cells.x) +
                     static_cast<std::size_t>(x)];
    };
    const auto isFree = [&](const glm::vec2& place, float distance) {
        const glm::ivec2 cell((place - low) / apart);
        for (int z = std::max(cell.y - 1, 0); z <= std::min(cell.y + 1, cells.y - 1); ++z) {
            for (int x = std::max(cell.x - 1, 0); x <= std::min(cell.x + 1, cells.x - 1); ++x) {
                for (const glm::vec2& other : at(x, z)) {
                    if (glm::distance(place, other) < distance) {
                        return false;
                    }
                }
            }
        }
        return true;
    };
    std::vector<glm::vec2> places;
    for (std::size_t i = 0; i < count; ++i) {
        glm::vec2 place = low;
        for (int attempt = 0; attempt < 10 * kTries; ++attempt) {
            place = low + size * glm::vec2(model::unitFloat(model::hashKeys(seed, 1, i, attempt)),
                                           model::unitFloat(model::hashKeys(seed, 2, i, attempt)));
            const int rounds = attempt / kTries;
            const float closer = std::pow(0.9F, static_cast<float>(rounds));
            if (isFree(place, apart * closer)) {
                break;
            }
        }
        const glm::ivec2 cell((place - low) / apart);
        at(cell.x, cell.y).push_back(place);
        places.push_back(place);
    }
    return places;
}

model::Result<std::unique_ptr<Workload>> makeWorkload(std::string_view name, std::size_t count,
                                                      std::uint64_t seed)
{
    std::unique_ptr<Workload> workload;
    if (name == "square") {
        workload = std::make_unique<SquareWorkload>(count, seed);
    } else if (name == "corridor") {
        workload = std::make_unique<CorridorWorkload>(count, seed);
    } else if (name == "city") {
        workload = std::make_unique<CityWorkload>(count, seed);
    } else if (name == "paths") {
        workload = makePathsWorkload(count, seed);
    } else {
        return model::Error{
            QT_TRANSLATE_NOOP(
                "Messages", "There is no workload \"%1\": choose square, corridor, city or paths."),
            name};
    }
    return workload;
}

} // namespace crowd::behavior
