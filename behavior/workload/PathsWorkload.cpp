// SPDX-License-Identifier: MIT
#include "behavior/workload/PathsWorkload.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "behavior/session/Session.h"
#include "model/rules/RuleSets.h"

namespace crowd::behavior {

namespace {

constexpr float kMesh = 25.0F; ///< metres between places
/// So wide that people walk everywhere, half a person per square metre as in "square": narrow paths
/// would be a denser crowd and another question.
constexpr float kPlaceRadius = 0.5F * kMesh;

class PathsWorkload : public Workload
{
public:
    PathsWorkload(const model::Scene& scene, const SessionPlan& plan)
        : m_scene(scene), m_session(scene, plan)
    {
        m_scene.places = plan.places;
        m_scene.paths = plan.paths;
        std::vector<model::IndividualId> ids;
        std::vector<model::PathId> paths;
        ids.reserve(plan.walkers.size());
        paths.reserve(plan.walkers.size());
        for (const SessionPlan::Walker& walker : plan.walkers) {
            ids.push_back(walker.id);
            paths.push_back(walker.path);
        }
        m_scene.population.setValues<model::PathId>(model::columns::path, ids, paths);
    }

    void steer() override {}
    void step() override
    {
        m_session.step();
        m_pose = m_session.pose(); // as for a player
    }
    [[nodiscard]] SessionPosePtr pose() const override { return m_pose; }
    [[nodiscard]] const model::Scene* scene() const override { return &m_scene; }
    [[nodiscard]] CrowdSimulation& crowd() override { return m_session.crowd(); }
    [[nodiscard]] std::size_t outsideWalls() const override { return 0; }

private:
    model::Scene m_scene; ///< its people follow the plan's paths
    Session m_session;
    SessionPosePtr m_pose;
};

/// People with clips to stand, walk and run with.
model::TemplateEntry walkerTemplate()
{
    auto asset = std::make_shared<model::Template>();
    model::TemplateEntry entry;
    const auto add = [&](const char* name, float seconds, float metresPerSecond,
                         model::ClipRole role) {
        model::Clip clip;
        clip.name = name;
        clip.seconds = seconds;
        clip.speed = metresPerSecond;
        clip.role = role;
        clip.loop = true;
        asset->clips.push_back(clip);
        entry.clipNames.emplace_back(name);
    };
    add("idle", 2.0F, 0.0F, model::ClipRole::Idle);
    add("walk", 1.0F, 1.3F, model::ClipRole::Walk);
    add("run", 0.7F, 3.0F, model::ClipRole::Run);
    entry.id = 1;
    entry.asset = asset;
    entry.clipSpeeds.assign(3, std::numeric_limits<float>::quiet_NaN());
    return entry;
}

/// A grid of places, and a path around each of its squares.
void addNetwork(SessionPlan& plan, int squares)
{
    for (int i = 0; i < (squares + 1) * (squares + 1); ++i) {
        const glm::vec2 corner(i % (squares + 1), i / (squares + 1));
        plan.places.push_back({static_cast<model::PlaceId>(i + 1), std::to_string(i + 1),
                               glm::vec3(corner.x, 0.0F, corner.y) * kMesh, kPlaceRadius});
    }
    for (int i = 0; i < squares * squares; ++i) {
        const int first = i / squares * (squares + 1) + i % squares + 1;
        model::Path path{
            static_cast<model::PathId>(i + 1), std::to_string(i + 1), model::PathKind::Cyclic, {}};
        for (const int place : {first, first + 1, first + squares + 2, first + squares + 1}) {
            path.places.push_back(static_cast<model::PlaceId>(place));
        }
        plan.paths.push_back(std::move(path));
    }
}

} // namespace

std::unique_ptr<Workload> makePathsWorkload(std::size_t count, std::uint64_t seed)
{
    const float side = std::sqrt(static_cast<float>(count) / 0.5F);
    const int squares = std::max(1, static_cast<int>(std::ceil(side / kMesh)));
    SessionPlan plan;
    addNetwork(plan, squares);
    std::vector<model::IndividualId> ids(count);
    std::iota(ids.begin(), ids.end(), 1U);
    auto rows = model::IndividualRows::withDefaults(ids);
    const float width = static_cast<float>(squares) * kMesh;
    const std::vector<glm::vec2> places =
        scatter(count, glm::vec2(0.0F), glm::vec2(width), 0.5F, seed);
    std::ranges::fill(rows.column(model::columns::templateId), model::TemplateId{1});
    for (std::size_t i = 0; i < count; ++i) {
        rows.column(model::columns::position)[i] = {places[i].x, 0.0F, places[i].y};
        const glm::ivec2 square = glm::min(glm::ivec2(places[i] / kMesh), squares - 1);
        plan.walkers.push_back({ids[i],
                                static_cast<model::PathId>(square.y * squares + square.x + 1),
                                kWorkloadSpeed});
    }
    model::Scene scene;
    scene.templates.push_back(walkerTemplate());
    scene.population.add(rows);
    scene.rules = model::rulesOf(model::RuleSet::Pedestrians, scene);
    model::giveIds(scene.rules, scene);
    return std::make_unique<PathsWorkload>(scene, plan);
}

} // namespace crowd::behavior
