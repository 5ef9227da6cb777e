// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "model/bake/KeyframeStore.h"
#include "model/brush/BrushContext.h"
#include "model/brush/Stroke.h"
#include "model/document/SceneDocument.h"
#include "model/document/SceneEdit.h"
#include "model/pick/StageRays.h"

/// A small world for brushes and picking: a box man 0.5 m wide, 1.8 m high and 0.3 m deep with the
/// slots skin (not tintable), top and bottom and the clips idle, sit and cheer; and stages made of
/// plates and rows of seats.
namespace crowd::test {

using namespace model;

using Ids = std::vector<IndividualId>;

inline void addBox(Mesh& mesh, const glm::vec3& low, const glm::vec3& high)
{
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (int corner = 0; corner < 8; ++corner) {
        mesh.positions.emplace_back((corner & 1) != 0 ? high.x : low.x,
                                    (corner & 2) != 0 ? high.y : low.y,
                                    (corner & 4) != 0 ? high.z : low.z);
        mesh.normals.emplace_back(0.0F, 0.0F, 1.0F);
        mesh.uv.emplace_back(0.0F);
        mesh.colors.emplace_back(255);
        mesh.bones.push_back(0);
        mesh.weights.push_back(1.0F);
    }
    constexpr std::array<std::uint32_t, 36> kFaces{0, 1, 3, 0, 3, 2, 4, 7, 5, 4, 6, 7,
                                                   0, 5, 1, 0, 4, 5, 2, 3, 7, 2, 7, 6,
                                                   0, 2, 6, 0, 6, 4, 1, 5, 7, 1, 7, 3};
    for (const std::uint32_t index : kFaces) {
        mesh.indices.push_back(first + index);
    }
}

inline TemplatePtr boxMan()
{
    auto man = std::make_shared<Template>();
    man->name = "box man";
    man->nodes.emplace_back();
    man->bones.emplace_back();
    Mesh mesh;
    addBox(mesh, {-0.25F, 0.0F, -0.15F}, {0.25F, 1.8F, 0.15F});
    mesh.fileVertexCount = mesh.positions.size();
    mesh.submeshes = {{0, -1, 0, 12}, {1, -1, 12, 12}, {2, -1, 24, 12}};
    man->levels.push_back(std::move(mesh));
    for (const char* name : {"skin", "top", "bottom"}) {
        Slot slot;
        slot.name = name;
        slot.tintable = slot.name != "skin";
        slot.choices.emplace_back();
        man->slots.push_back(std::move(slot));
    }
    for (const char* name : {"idle", "sit", "cheer"}) {
        Clip clip;
        clip.name = name;
        clip.seconds = 1.0F;
        Channel still;
        still.times = {0.0F, 1.0F};
        still.values = {0, 0, 0, 0, 0, 0};
        clip.channels.push_back(std::move(still));
        man->clips.push_back(std::move(clip));
    }
    man->clips[1].seatHeight = 0.45F;
    man->seatedClip = 1;
    man->bounds = {{-0.25F, 0.0F, -0.15F}, {0.25F, 1.8F, 0.15F}};
    man->height = 1.8F;
    return man;
}

inline TemplateEntry boxManEntry(TemplateId id, TemplatePtr asset)
{
    TemplateEntry entry;
    entry.id = id;
    entry.name = "box man";
    entry.clipNames = {"idle", "sit", "cheer"};
    entry.asset = std::move(asset);
    return entry;
}

/// A flat four-sided plate, corners in order.
inline StageMesh plate(const std::array<glm::vec3, 4>& corners)
{
    StageMesh mesh;
    mesh.positions.assign(corners.begin(), corners.end());
    mesh.normals.assign(4, glm::vec3(0.0F, 1.0F, 0.0F));
    mesh.uv.assign(4, glm::vec2(0.0F));
    mesh.indices = {0, 1, 2, 0, 2, 3};
    return mesh;
}

inline StageEntry stageOf(std::vector<StageMesh> meshes, std::vector<Seat> seats = {})
{
    auto asset = std::make_shared<StageAsset>();
    asset->name = "stage";
    asset->meshes = std::move(meshes);
    asset->materials.emplace_back();
    asset->seats = std::move(seats);
    for (const StageMesh& mesh : asset->meshes) {
        for (const glm::vec3& point : mesh.positions) {
            asset->bounds.add(point);
        }
    }
    StageEntry entry;
    entry.id = 1;
    entry.name = "stage";
    entry.asset = std::move(asset);
    return entry;
}

/// rows × columns seats a metre apart around the origin, facing +Z; rank is the row, wedge 0 left
/// and 1 right of the middle.
inline std::vector<Seat> seatRows(int rows, int columns)
{
    std::vector<Seat> seats;
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            Seat seat;
            seat.position = {static_cast<float>(column) - 0.5F * static_cast<float>(columns - 1),
                             0.0F, -static_cast<float>(row)};
            seat.headingRadians = 0.25F;
            seat.height = 0.4F;
            seat.rank = row;
            seat.wedge = column * 2 < columns ? 0 : 1;
            seats.push_back(seat);
        }
    }
    return seats;
}

/// Straight down on the ground, 64 pixels a metre in a view of 1280 × 768: the origin is in the
/// middle, +X to the right, +Z down.
inline View fromAbove()
{
    Camera camera = Camera::lookingAt({0.0F, 20.0F, 0.0F}, {0.0F, 0.0F, 0.0F});
    camera.projection = Projection::Orthographic;
    camera.orthographicHeight = 12.0F;
    return {camera, {1280.0F, 768.0F}};
}

/// Level, from +Z: the origin is below the middle.
inline View fromFront()
{
    return {Camera::lookingAt({0.0F, 1.0F, 10.0F}, {0.0F, 1.0F, 0.0F}), {1280.0F, 768.0F}};
}

inline glm::dvec2 pixelOf(const View& view, const glm::vec3& world)
{
    const glm::vec3 pixel = view.project(world).value();
    return {pixel.x, pixel.y};
}

struct BrushScene
{
    explicit BrushScene(std::vector<StageEntry> stages = {})
    {
        Scene scene;
        scene.templates.push_back(boxManEntry(1, man));
        scene.stages = std::move(stages);
        document.replaceScene(std::move(scene), {});
        QObject::connect(&document, &SceneDocument::stepCommitted,
                         [this](const StepCommitted& step) {
                             recorded = step.stroke == nullptr ? RecordedStroke{} : *step.stroke;
                         });
        rays.setStages(document.scene().stages);
        for (int clip = 0; clip < 3; ++clip) {
            (void)keyframes.clip(man, clip);
        }
        keyframes.waitForAll();
    }

    /// People of the box man at these foot points, as one undo step.
    std::vector<IndividualId> addPeople(const std::vector<glm::vec3>& positions)
    {
        IndividualRows rows =
            IndividualRows::withDefaults(std::vector<IndividualId>(positions.size()));
        for (std::size_t i = 0; i < positions.size(); ++i) {
            rows.column(columns::templateId)[i] = 1;
            rows.column(columns::position)[i] = positions[i];
        }
        const auto edit = document.beginEdit().value();
        std::vector<IndividualId> ids = edit->addIndividuals(std::move(rows));
        edit->commit(QStringLiteral("Add"));
        return ids;
    }

    /// Another asset in place of the box man, or none; forgets the undo steps.
    void replaceMan(TemplatePtr asset)
    {
        Scene scene = document.scene();
        scene.templates.front().asset = std::move(asset);
        document.replaceScene(std::move(scene), {});
    }

    [[nodiscard]] BrushContext context(const View& view) { return {view, keyframes, rays}; }
    [[nodiscard]] const Population& people() const { return document.scene().population; }

    /// Press, moves 0.05 s apart, release.
    StrokeOutcome paint(const View& view, const BrushSettings& settings,
                        const std::vector<glm::dvec2>& pixels, std::uint64_t seed = 7)
    {
        double time = 0.0;
        const auto stroke = Stroke::begin(document, context(view), settings, seed,
                                          PointerInput::at(pixels.front(), time));
        for (std::size_t i = 1; i < pixels.size(); ++i) {
            time += 0.05;
            stroke->move(PointerInput::at(pixels[i], time));
        }
        return stroke->finish();
    }

    TemplatePtr man = boxMan();
    SceneDocument document;
    KeyframeStore keyframes;
    StageRays rays;
    RecordedStroke recorded; ///< that made the last step
};

inline BrushSettings brush(BrushKind kind, BrushSelection selection)
{
    BrushSettings settings;
    settings.setKind(kind);
    settings.selection = selection;
    if (auto* create = settings.find<CreateSettings>()) {
        create->mix = {{1, 1.0F}};
    }
    return settings;
}

inline BrushSettings colourBrush(BrushSelection selection)
{
    BrushSettings settings = brush(BrushKind::Colour, selection);
    settings.as<ColourSettings>().colors = {{200, 100, 0}, {0, 100, 200}};
    return settings;
}

/// 10 × 6 people a metre apart around the origin.
inline std::vector<glm::vec3> crowdGrid()
{
    std::vector<glm::vec3> positions;
    for (int z = 0; z < 6; ++z) {
        for (int x = 0; x < 10; ++x) {
            positions.emplace_back(static_cast<float>(x) - 4.5F, 0.0F,
                                   static_cast<float>(z) - 2.5F);
        }
    }
    return positions;
}

/// A person's colour in a slot.
inline Tint tintOf(const BrushScene& scene, IndividualId id, int slot)
{
    return scene.people().column(columns::tint(slot))[scene.people().rowOf(id)];
}

} // namespace crowd::test
