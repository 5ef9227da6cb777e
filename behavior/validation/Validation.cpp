// SPDX-License-Identifier: MIT
#include "behavior/validation/Validation.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>

#include <glm/geometric.hpp>

#include "behavior/validation/SessionExperiments.h"
#include "behavior/validation/Track.h"
#include "behavior/workload/WorkloadRun.h"

namespace crowd::behavior {

namespace {

constexpr double kStep = static_cast<double>(kWorkloadStep);
constexpr double kTolerance = 0.15;

/// With one decimal, for names of rows.
std::string inMetres(double metres)
{
    const long tenths = std::lround(metres * 10.0);
    return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10);
}

CrowdSimulation crowdOf(const std::vector<glm::vec2>& places, const std::vector<Wall>& walls)
{
    std::vector<AgentState> states(places.size());
    for (std::size_t i = 0; i < places.size(); ++i) {
        states[i].position = places[i];
        states[i].preferredSpeed = kFreeSpeed;
    }
    CrowdSimulation crowd;
    crowd.setWalls(walls);
    crowd.setAgents(states);
    return crowd;
}

/// One step towards where `target` sends each from where it is.
void stepTowards(CrowdSimulation& crowd, const std::function<glm::vec2(const glm::vec2&)>& target)
{
    for (Body& body : crowd.bodies()) {
        const glm::vec2 at(body.x, body.z);
        const glm::vec2 way = target(at) - at;
        const float length = std::max(glm::length(way), 1e-4F);
        body.desiredX = way.x / length * body.preferredSpeed;
        body.desiredZ = way.y / length * body.preferredSpeed;
    }
    crowd.step(kWorkloadStep);
}

/// A walker alone in a corridor of 40 m, from rest after a run-up of 5 m.
ValidationRow corridorSpeed()
{
    CrowdSimulation crowd = crowdOf({{1.0F, 1.0F}}, rectangleWalls({0.0F, 0.0F}, {60.0F, 2.0F}));
    const auto ahead = [](const glm::vec2& at) { return at + glm::vec2(1.0F, 0.0F); };
    int steps = 0;
    while (crowd.bodies()[0].x < 45.0F && steps < 3000) {
        const bool isTimed = crowd.bodies()[0].x >= 5.0F;
        stepTowards(crowd, ahead);
        steps += isTimed ? 1 : 0;
    }
    const double speed = 40.0 / (steps * kStep);
    return {"walking speed kept in a corridor of 40 m", "m/s", speed, 1.34 * 0.98, 1.34 * 1.02};
}

ValidationRow speedAt(const Track& track, const std::string& name, float perSquareMetre)
{
    TrackCrowd crowd(track, perSquareMetre, false, 5);
    glm::dvec2 sum(0.0);
    constexpr int kSettle = 900;
    constexpr int kMeasure = 600;
    for (int i = 0; i < kSettle + kMeasure; ++i) {
        crowd.step();
        if (i >= kSettle) {
            sum += crowd.speedAndDensity();
        }
    }
    const double expected = weidmannSpeed(sum.y / kMeasure);
    return {"speed in a " + name + " at " + inMetres(static_cast<double>(perSquareMetre)) +
                " people per m2 (Weidmann)",
            "m/s", sum.x / kMeasure, expected * (1.0 - kTolerance), expected * (1.0 + kTolerance)};
}

struct RoomRun
{
    double flow = 0.0;    ///< people per metre and second, from the 20th to the 80th of 100
    double emptyAt = 0.0; ///< seconds; 0: not within the time
};

/// 100 people leave a room of 8 × 8 m through a door `width` wide with a passage of 1 m behind it.
RoomRun leaveRoom(float width)
{
    constexpr float kRoom = 8.0F;
    const float low = 0.5F * (kRoom - width);
    const float high = 0.5F * (kRoom + width);
    const std::vector<Wall> walls{
        {{0.0F, 0.0F}, {kRoom, 0.0F}},        {{0.0F, 0.0F}, {0.0F, kRoom}},
        {{0.0F, kRoom}, {kRoom, kRoom}},      {{kRoom, 0.0F}, {kRoom, low}},
        {{kRoom, high}, {kRoom, kRoom}},      {{kRoom, low}, {kRoom + 1.0F, low}},
        {{kRoom, high}, {kRoom + 1.0F, high}}};
    CrowdSimulation crowd =
        crowdOf(scatter(100, glm::vec2(0.4F), glm::vec2(7.0F, 7.6F), 0.5F, 11), walls);
    const auto target = [&](const glm::vec2& at) {
        if (at.x > kRoom + 1.0F) {
            return at + glm::vec2(1.0F, at.y > 0.5F * kRoom ? 0.5F : -0.5F);
        }
        const float aside = std::max(0.5F * width - 0.35F, 0.0F);
        const float z = std::clamp(at.y, 0.5F * kRoom - aside, 0.5F * kRoom + aside);
        return glm::vec2(std::max(kRoom + 0.3F, at.x + 0.5F), z);
    };
    RoomRun run;
    double from = 0.0;
    constexpr int kMostSteps = 5400;
    for (int i = 0; i < kMostSteps && run.emptyAt == 0.0; ++i) {
        stepTowards(crowd, target);
        const auto out =
            std::ranges::count_if(crowd.bodies(), [](const Body& body) { return body.x > kRoom; });
        const double seconds = (i + 1) * kStep;
        if (out >= 20 && from == 0.0) {
            from = seconds;
        }
        if (out >= 80 && run.flow == 0.0) {
            run.flow = 60.0 / ((seconds - from) * static_cast<double>(width));
        }
        run.emptyAt = out == 100 ? seconds : 0.0;
    }
    return run;
}

/// 30 people around a corner of a corridor 2 m wide: how many get around within a minute.
ValidationRow corner()
{
    const std::vector<glm::vec2> outer{{0.0F, 0.0F}, {14.0F, 0.0F}, {14.0F, 14.0F}};
    const std::vector<glm::vec2> inner{{0.0F, 2.0F}, {12.0F, 2.0F}, {12.0F, 14.0F}};
    std::vector<Wall> walls{{outer[0], inner[0]}};
    for (std::size_t i = 0; i < 2; ++i) {
        walls.push_back({outer[i], outer[i + 1]});
        walls.push_back({inner[i], inner[i + 1]});
    }
    CrowdSimulation crowd =
        crowdOf(scatter(30, glm::vec2(0.4F), glm::vec2(9.0F, 1.6F), 0.5F, 12), walls);
    std::size_t around = 0;
    for (int i = 0; i < 1800; ++i) {
        stepTowards(crowd, [](const glm::vec2& at) {
            return at.x < 12.2F && at.y < 2.0F ? glm::vec2(13.0F, 1.2F)
                                               : at + glm::vec2(0.0F, 1.0F);
        });
    }
    for (const Body& body : crowd.bodies()) {
        const bool isInside = body.x >= 12.0F && body.x <= 14.0F;
        around += isInside && body.z > 4.0F && body.z < 14.0F ? 1U : 0U;
        around += body.z >= 14.0F ? 1U : 0U; // out of the open end
    }
    return {"people out of 30 around a corner, none through its walls", "", //
            static_cast<double>(around), 30.0, 30.0};
}

ValidationRow lanes()
{
    TrackCrowd crowd({20.0F, 8.0F, 4.0F}, 0.8F, true, 13);
    double index = 0.0;
    constexpr int kSettle = 1800;
    constexpr int kMeasure = 600;
    for (int i = 0; i < kSettle + kMeasure; ++i) {
        crowd.step();
        index += i >= kSettle ? crowd.laneIndex() / kMeasure : 0.0;
    }
    return {"lanes in two-way flow (band index, mixed about 0.2)", "", index, 0.5, 1.0};
}

ValidationRow denseCorridor()
{
    auto made = makeWorkload("corridor", 1000, 14);
    Workload& workload = *made.value();
    const WorkloadFigures figures = runWorkload(workload, 3000, nullptr);
    return {"share of 1000 outside the walls of a dense corridor, 100 s", "", figures.outsideWalls,
            0.0, 0.0};
}

} // namespace

std::string ValidationRow::text() const
{
    constexpr std::size_t kColumn = 68;
    const auto number = [](double value) {
        const long thousandths = std::lround(value * 1000.0);
        const std::string digits = std::to_string(std::labs(thousandths) % 1000);
        return (thousandths < 0 ? "-" : "") + std::to_string(std::labs(thousandths) / 1000) + "." +
               std::string(3 - digits.size(), '0') + digits;
    };
    std::string line = what;
    line.resize(std::max(line.size(), kColumn), ' ');
    return line + number(measured) + "  (" + number(low) + " to " + number(high) + ") " + unit +
           (isWithin() ? "" : "  <- outside");
}

double weidmannSpeed(double perSquareMetre)
{
    const double room = 1.0 / perSquareMetre - 1.0 / 5.4;
    return 1.34 * (1.0 - std::exp(-1.913 * room));
}

std::vector<ValidationRow> validate()
{
    std::vector<ValidationRow> rows{corridorSpeed()};
    for (const float perSquareMetre : {0.5F, 1.0F, 1.5F, 2.0F, 2.5F, 3.0F}) {
        rows.push_back(speedAt({0.0F, 8.0F, 3.0F}, "ring", perSquareMetre));
        rows.push_back(speedAt({18.0F, 6.0F, 4.0F}, "corridor", perSquareMetre));
    }
    for (const float width : {0.8F, 1.2F, 1.6F, 2.0F, 2.4F}) {
        const RoomRun run = leaveRoom(width);
        const std::string door = inMetres(static_cast<double>(width)) + " m wide";
        rows.push_back({"flow through a door " + door, "1/(m s)", run.flow, 1.3, 2.0});
        // All of them at the published flows; a while until the first is at the door.
        const auto metres = static_cast<double>(width);
        rows.push_back({"time until a room of 100 is empty, door " + door, "s", run.emptyAt,
                        100.0 / (2.0 * metres), 100.0 / (1.3 * metres) + 15.0});
    }
    rows.push_back(corner());
    rows.push_back(lanes());
    rows.push_back(denseCorridor());
    const std::vector<ValidationRow> sessions = sessionExperiments();
    rows.insert(rows.end(), sessions.begin(), sessions.end());
    return rows;
}

} // namespace crowd::behavior
