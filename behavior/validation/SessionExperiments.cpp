// SPDX-License-Identifier: MIT
#include "behavior/validation/SessionExperiments.h"

#include <cmath>
#include <memory>
#include <string>

#include "behavior/session/SceneMotion.h"

namespace crowd::behavior {

namespace {

constexpr float kPace = 1.3F;
constexpr int kMinute = 60 * 30; ///< steps

/// Somebody at the origin who walks a path.
model::Scene walkerOn(const std::vector<glm::vec3>& places, model::PathKind kind)
{
    model::Scene scene;
    auto rows = model::IndividualRows::withDefaults({1});
    rows.column(model::columns::path)[0] = 1;
    rows.column(model::columns::walkSpeed)[0] = kPace;
    scene.population.add(rows);
    model::Path path{1, "way", kind, {}};
    for (const glm::vec3& place : places) {
        const auto id = static_cast<model::PlaceId>(scene.places.size() + 1);
        scene.places.push_back({id, "place", place, 0.2F});
        path.places.push_back(id);
    }
    scene.paths = {path};
    return scene;
}

glm::vec3 placeNow(const Session& session)
{
    return session.frame()->population.column(model::columns::position)[0];
}

/// Rises by 3 m over 12 m of X, in so many steps; 1: a ramp.
model::StageEntry rise(int steps)
{
    constexpr float kFrom = 6.0F;
    constexpr float kLength = 12.0F;
    constexpr float kHeight = 3.0F;
    constexpr float kHalfWidth = 4.0F;
    auto asset = std::make_shared<model::StageAsset>();
    model::StageMesh mesh;
    const auto strip = [&](glm::vec2 a, glm::vec2 b) { // (x, y) of both ends
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        for (const glm::vec2& end : {a, b}) {
            mesh.positions.emplace_back(end.x, end.y, -kHalfWidth);
            mesh.positions.emplace_back(end.x, end.y, kHalfWidth);
        }
        for (const std::uint32_t index : {0U, 1U, 2U, 2U, 1U, 3U}) {
            mesh.indices.push_back(first + index);
        }
    };
    strip({-5.0F, 0.0F}, {kFrom, 0.0F});
    const float end = kFrom + kLength;
    if (steps == 1) {
        strip({kFrom, 0.0F}, {end, kHeight});
    }
    for (int step = 0; step < steps && steps > 1; ++step) {
        const float share = 1.0F / static_cast<float>(steps);
        const float x = kFrom + kLength * share * static_cast<float>(step);
        const float y = kHeight * share * static_cast<float>(step + 1);
        strip({x, y - kHeight * share}, {x + 0.01F, y}); // its face
        strip({x + 0.01F, y}, {x + kLength * share, y});
    }
    strip({end, kHeight}, {end + 10.0F, kHeight});
    asset->meshes = {mesh};
    asset->materials.emplace_back();
    for (const glm::vec3& position : mesh.positions) {
        asset->bounds.add(position);
    }
    model::StageEntry entry;
    entry.id = 1;
    entry.asset = asset;
    return entry;
}

/// Speed in the middle of a rise that was painted as slow ground, as a share of that before it.
ValidationRow slowRise(const std::string& name, int steps, float share)
{
    model::Scene scene = walkerOn({{24.0F, 3.0F, 0.0F}}, model::PathKind::Simple);
    scene.stages = {rise(steps)};
    model::Place slow{9, "slow", {12.0F, 1.5F, 0.0F}, 6.0F, {}, model::PlaceRole::Slow};
    slow.speedShare = share;
    scene.places.push_back(slow);
    SceneMotion motion(scene);
    const auto secondsBetween = [&](float from, float to) {
        double entered = 0.0;
        for (int step = 1; step < kMinute; ++step) {
            const double seconds = static_cast<double>(step) / 30.0;
            const float x = motion.at(seconds)->population.column(model::columns::position)[0].x;
            entered = entered == 0.0 && x > from ? seconds : entered;
            if (x > to) {
                return seconds - entered;
            }
        }
        return 1e9;
    };
    const double level = 3.0 / secondsBetween(2.0F, 5.0F);
    const double risen = 6.0 / secondsBetween(9.0F, 15.0F);
    const auto wanted = static_cast<double>(share);
    return {"speed on " + name + ", as a share of that before", "", risen / level, wanted * 0.95,
            wanted * 1.05};
}

ValidationRow endOfPath()
{
    Session session(walkerOn({{20.0F, 0.0F, 0.0F}}, model::PathKind::Simple));
    for (int step = 0; step < kMinute; ++step) {
        session.step();
    }
    const glm::vec3 at = placeNow(session);
    return {"a path that ends: rests so far from its end", "m",
            static_cast<double>(std::hypot(at.x - 20.0F, at.z)), 0.0, 0.6};
}

/// Rounds in a minute of a square with sides of 10 m, which is cut a little at its corners.
ValidationRow roundPath()
{
    Session session(walkerOn(
        {{0.0F, 0.0F, 0.0F}, {10.0F, 0.0F, 0.0F}, {10.0F, 0.0F, 10.0F}, {0.0F, 0.0F, 10.0F}},
        model::PathKind::Cyclic));
    double turned = 0.0;
    double before = std::atan2(-5.0, -5.0);
    for (int step = 0; step < kMinute; ++step) {
        session.step();
        const glm::vec3 at = placeNow(session);
        const double now =
            std::atan2(static_cast<double>(at.z) - 5.0, static_cast<double>(at.x) - 5.0);
        turned += std::remainder(now - before, 6.283185307179586);
        before = now;
    }
    const double expected = 60.0 * static_cast<double>(kPace) / 40.0;
    return {"a path that goes round: rounds of 40 m in a minute", "", turned / 6.283185307179586,
            expected * 0.95, expected * 1.1};
}

ValidationRow jumpingPath()
{
    Session session(walkerOn({{0.0F, 0.0F, 0.0F}, {10.0F, 0.0F, 0.0F}}, model::PathKind::Teleport));
    int jumps = 0;
    float before = 0.0F;
    for (int step = 0; step < kMinute; ++step) {
        session.step();
        const float x = placeNow(session).x;
        jumps += x < before - 5.0F ? 1 : 0;
        before = x;
    }
    // 10 m less what counts as there, and the first setting off.
    return {"a path that begins anew: jumps back over 10 m in a minute", "", //
            static_cast<double>(jumps), 7.0, 8.0};
}

/// Wait for an event that does not come, at most 1 s; tag; 0.5 s; tag: steps from the event to the
/// first tag, and on to the second.
std::vector<ValidationRow> sequence()
{
    model::Scene scene = walkerOn({{0.0F, 0.0F, 0.0F}}, model::PathKind::Simple);
    model::Rule rule;
    rule.id = 1;
    rule.trigger = model::triggers::Event{"go"};
    rule.actions = {model::actions::WaitForEvent{"never", 1.0F}, model::actions::AddTag{1},
                    model::actions::WaitForEvent{"never", 0.5F}, model::actions::AddTag{2}};
    scene.rules = {rule};
    Session session(scene);
    session.send("go", 0.0F, {1});
    int steps[3] = {};
    for (int step = 1; step <= kMinute; ++step) {
        session.step();
        for (const int tag : {1, 2}) {
            const bool hasIt = (session.rules().tags(0) >> tag & 1U) != 0;
            steps[tag] = hasIt && steps[tag] == 0 ? step : steps[tag];
        }
    }
    return {{"a rule that waits at most 1 s: steps from its event to what follows", "",
             static_cast<double>(steps[1]), 31.0, 31.0},
            {"and then at most 0.5 s: steps to what follows", "",
             static_cast<double>(steps[2] - steps[1]), 15.0, 15.0}};
}

} // namespace

std::vector<ValidationRow> sessionExperiments()
{
    std::vector<ValidationRow> rows{slowRise("a ramp set to 0.7", 1, 0.7F),
                                    slowRise("stairs set to 0.5", 20, 0.5F), endOfPath(),
                                    roundPath(), jumpingPath()};
    const std::vector<ValidationRow> steps = sequence();
    rows.insert(rows.end(), steps.begin(), steps.end());
    return rows;
}

} // namespace crowd::behavior
