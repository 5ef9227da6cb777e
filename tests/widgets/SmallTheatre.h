// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "model/document/SceneDocument.h"
#include "model/document/SceneEdit.h"
#include "tests/render/TestScene.h"

/// A stage in code: a flat floor 24 m square with rows of seats that face +Z, and the box man as
/// the only template. Small enough that its clips are baked at once.
namespace crowd::testing {

inline constexpr int kSeatRows = 10;
inline constexpr int kSeatsInRow = 24;

inline model::StagePtr makeSmallStage()
{
    auto stage = std::make_shared<model::StageAsset>();
    stage->name = "small theatre";
    stage->materials.emplace_back().baseColor = {0.35F, 0.30F, 0.28F, 1.0F};
    model::StageMesh floor;
    for (const glm::vec3& corner : {glm::vec3(-12, 0.05F, -12), glm::vec3(-12, 0.05F, 12),
                                    glm::vec3(12, 0.05F, 12), glm::vec3(12, 0.05F, -12)}) {
        floor.positions.push_back(corner);
        floor.normals.emplace_back(0.0F, 1.0F, 0.0F);
        floor.uv.emplace_back(0.0F);
        stage->bounds.add(corner);
    }
    floor.indices = {0, 1, 2, 0, 2, 3};
    stage->meshes.push_back(floor);
    for (int row = 0; row < kSeatRows; ++row) {
        for (int seat = 0; seat < kSeatsInRow; ++seat) {
            model::Seat place;
            place.position = {static_cast<float>(seat) * 0.9F - 10.35F, 0.05F,
                              4.0F - static_cast<float>(row) * 1.4F};
            place.height = 0.45F;
            place.rank = row;
            place.wedge = seat < kSeatsInRow / 2 ? 0 : 1;
            stage->seats.push_back(place);
        }
    }
    return stage;
}

inline model::Scene smallTheatre()
{
    model::Scene scene;
    scene.name = "small theatre";
    auto man = makeBoxMan();
    man->seatedClip = 2;
    scene.templates.push_back(entryFor(man));
    scene.templates.back().path = "builtin:templates/box.glb";
    model::StageEntry stage;
    stage.id = 1;
    stage.name = "small theatre";
    stage.path = "builtin:stages/small.glb";
    stage.asset = makeSmallStage();
    scene.stages.push_back(stage);
    scene.cameras.push_back(
        {"front", model::Camera::lookingAt({0.0F, 16.0F, 16.0F}, {0.0F, 0.0F, -1.5F})});
    return scene;
}

/// Puts n people of template 1 a metre apart along X, from x = 0, at z.
inline std::vector<model::IndividualId> addPeople(model::SceneDocument& document, std::size_t count,
                                                  float z = 8.0F)
{
    const model::Population row = makeRow(count);
    const std::vector<model::IndividualId> rowIds(row.ids().begin(), row.ids().end());
    model::IndividualRows rows = row.rows(rowIds);
    for (glm::vec3& position : rows.column(model::columns::position)) {
        position.z = z;
        position.y = 0.05F;
    }
    auto edit = document.beginEdit().value();
    const auto ids = edit->addIndividuals(std::move(rows));
    edit->commit(QStringLiteral("add"));
    return ids;
}

} // namespace crowd::testing
