// SPDX-License-Identifier: MIT
#include "behavior/validation/Track.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "behavior/workload/Workload.h"

namespace crowd::behavior {

namespace {

constexpr int kPiecesOfHalfCircle = 40;

/// Nearest point of the line between the half circles' centres.
glm::vec2 spineAt(float straight, const glm::vec2& at)
{
    return {std::clamp(at.x, -0.5F * straight, 0.5F * straight), 0.0F};
}

void addLoop(float straight, float radius, std::vector<Wall>& walls)
{
    std::vector<glm::vec2> corners;
    for (int side = 0; side < 2; ++side) {
        for (int i = 0; i <= kPiecesOfHalfCircle; ++i) {
            const float angle =
                std::numbers::pi_v<float> *
                (static_cast<float>(side) - 0.5F + static_cast<float>(i) / kPiecesOfHalfCircle);
            const float middle = side == 0 ? 0.5F * straight : -0.5F * straight;
            corners.emplace_back(middle + radius * std::cos(angle), radius * std::sin(angle));
        }
    }
    for (std::size_t i = 0; i < corners.size(); ++i) {
        walls.push_back({corners[i], corners[(i + 1) % corners.size()]});
    }
}

} // namespace

float Track::area() const
{
    return width * (2.0F * std::numbers::pi_v<float> * radius + 2.0F * straight);
}

std::vector<Wall> Track::walls() const
{
    std::vector<Wall> walls;
    addLoop(straight, radius - 0.5F * width, walls);
    addLoop(straight, radius + 0.5F * width, walls);
    return walls;
}

glm::vec2 Track::along(const glm::vec2& at) const
{
    const glm::vec2 out = at - spineAt(straight, at);
    const float length = std::max(glm::length(out), 1e-3F);
    return glm::vec2(-out.y, out.x) / length;
}

float Track::aside(const glm::vec2& at) const
{
    return glm::distance(at, spineAt(straight, at)) - radius;
}

bool Track::isMeasured(const glm::vec2& at) const
{
    return straight == 0.0F || std::fabs(at.x) < straight / 3.0F;
}

float Track::measuredArea() const
{
    return straight == 0.0F ? area() : width * straight * 4.0F / 3.0F;
}

std::vector<glm::vec2> Track::places(std::size_t count, std::uint64_t seed) const
{
    // Spread over the unrolled middle line, then rolled up.
    const float length = area() / width;
    const float half = 0.5F * width - 0.3F;
    const float half0 = std::numbers::pi_v<float> * radius;
    std::vector<glm::vec2> places =
        scatter(count, {0.0F, -half}, {length - 0.6F, half}, 0.5F, seed);
    for (glm::vec2& place : places) {
        const float side = place.x < length * 0.5F ? 1.0F : -1.0F;
        const float way = std::fmod(place.x, length * 0.5F);
        if (way < half0) {
            const float angle = way / radius - 0.5F * std::numbers::pi_v<float>;
            place = side * (glm::vec2(0.5F * straight, 0.0F) +
                            (radius + place.y) * glm::vec2(std::cos(angle), std::sin(angle)));
        } else {
            place = side * glm::vec2(0.5F * straight - (way - half0), radius + place.y);
        }
    }
    return places;
}

TrackCrowd::TrackCrowd(const Track& track, float perSquareMetre, bool isTwoWay, std::uint64_t seed)
    : m_track(track), m_isTwoWay(isTwoWay)
{
    const auto count = static_cast<std::size_t>(std::lround(track.area() * perSquareMetre));
    std::vector<AgentState> states(count);
    const std::vector<glm::vec2> places = track.places(count, seed);
    for (std::size_t i = 0; i < count; ++i) {
        states[i].position = places[i];
        states[i].preferredSpeed = kFreeSpeed;
    }
    m_crowd.setWalls(track.walls());
    m_crowd.setAgents(states);
}

float TrackCrowd::signOf(std::size_t agent) const
{
    return m_isTwoWay && agent % 2 == 1 ? -1.0F : 1.0F;
}

void TrackCrowd::step()
{
    const std::span<Body> bodies = m_crowd.bodies();
    for (std::size_t agent = 0; agent < bodies.size(); ++agent) {
        Body& body = bodies[agent];
        const glm::vec2 wish =
            m_track.along({body.x, body.z}) * (signOf(agent) * body.preferredSpeed);
        body.desiredX = wish.x;
        body.desiredZ = wish.y;
    }
    m_crowd.step(kWorkloadStep);
}

glm::dvec2 TrackCrowd::speedAndDensity() const
{
    const std::span<const Body> bodies = m_crowd.bodies();
    double speed = 0.0;
    int people = 0;
    for (std::size_t agent = 0; agent < bodies.size(); ++agent) {
        const glm::vec2 at(bodies[agent].x, bodies[agent].z);
        if (m_track.isMeasured(at)) {
            const glm::vec2 velocity(bodies[agent].velocityX, bodies[agent].velocityZ);
            speed += static_cast<double>(glm::dot(velocity, m_track.along(at)) * signOf(agent));
            ++people;
        }
    }
    return {speed / std::max(people, 1),
            static_cast<double>(people) / static_cast<double>(m_track.measuredArea())};
}

double TrackCrowd::laneIndex() const
{
    constexpr float kStrip = 0.5F;
    const auto strips = static_cast<std::size_t>(std::ceil(m_track.width / kStrip));
    std::vector<double> with(2 * strips);
    std::vector<double> against(2 * strips);
    const std::span<const Body> bodies = m_crowd.bodies();
    for (std::size_t agent = 0; agent < bodies.size(); ++agent) {
        const glm::vec2 at(bodies[agent].x, bodies[agent].z);
        if (m_track.isMeasured(at)) {
            const float across = (m_track.aside(at) + 0.5F * m_track.width) / kStrip;
            const auto strip =
                static_cast<std::size_t>(std::clamp(across, 0.0F, static_cast<float>(strips - 1)));
            auto& column = signOf(agent) > 0.0F ? with : against;
            column[strip + (at.y > 0.0F ? strips : 0)] += 1.0;
        }
    }
    double sorted = 0.0;
    double people = 0.0;
    for (std::size_t i = 0; i < with.size(); ++i) {
        const double sum = with[i] + against[i];
        if (sum > 0.0) {
            sorted += (with[i] - against[i]) * (with[i] - against[i]) / sum;
            people += sum;
        }
    }
    return people > 0.0 ? sorted / people : 0.0;
}

} // namespace crowd::behavior
