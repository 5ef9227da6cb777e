// SPDX-License-Identifier: MIT
#include <QtTest/QTest>

#include <algorithm>

#include <glm/geometric.hpp>

#include "behavior/surface/WalkSurface.h"
#include "model/pick/StageRays.h"
#include "model/scene/PlaceShape.h"
#include "tests/program/Test.h"
#include "widgets/viewport/PathDrawing.h"
#include "widgets/viewport/PathLabels.h"

using namespace crowd;
using namespace crowd::widgets;

namespace {

/// A slab under Z < 0 that is 0.15 m high, and a bridge 5 m up along X at |z - 10| < 1.
model::StageEntry slabAndBridge()
{
    auto stage = std::make_shared<model::StageAsset>();
    stage->materials.emplace_back();
    model::StageMesh mesh;
    const auto add = [&mesh](float y, glm::vec2 x, glm::vec2 z) {
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        for (const glm::vec2 corner :
             {glm::vec2(x.x, z.x), glm::vec2(x.x, z.y), glm::vec2(x.y, z.y), glm::vec2(x.y, z.x)}) {
            mesh.positions.emplace_back(corner.x, y, corner.y);
            mesh.normals.emplace_back(0.0F, 1.0F, 0.0F);
            mesh.uv.emplace_back(0.0F);
        }
        for (const std::uint32_t corner : {0U, 1U, 2U, 0U, 2U, 3U}) {
            mesh.indices.push_back(first + corner);
        }
    };
    add(0.15F, {-20.0F, 20.0F}, {-20.0F, 0.0F});
    add(5.0F, {-20.0F, 20.0F}, {9.0F, 11.0F});
    stage->meshes.push_back(mesh);
    model::StageEntry entry;
    entry.id = 1;
    entry.asset = stage;
    return entry;
}

model::Place placeAt(model::PlaceId id, const glm::vec3& position, float radius = 1.0F)
{
    model::Place place;
    place.id = id;
    place.name = "Place";
    place.position = position;
    place.radius = radius;
    return place;
}

const std::array<std::uint8_t, 3> kOrange{240, 150, 40};
const std::array<std::uint8_t, 3> kBlue{40, 100, 230};

model::Path pathOver(model::PathId id, std::vector<model::PlaceId> places,
                     const std::array<std::uint8_t, 3>& color)
{
    model::Path path;
    path.id = id;
    path.name = "Path";
    path.places = std::move(places);
    path.color = color;
    return path;
}

bool hasColor(const render::OverlayTriangle& area, const std::array<std::uint8_t, 3>& color)
{
    return glm::distance(glm::vec3(area.color), glm::vec3(color[0], color[1], color[2]) / 255.0F) <
           0.01F;
}

} // namespace

/// Where the shapes of places and paths lie, without a window.
class TestPathDrawing : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void labelsSayWhatPanelsAndRulesSay();
    void init();
    void bandGoesUpAStep();
    void bandStaysOnTheBridgeOrUnderIt();
    void bandDoesNotHangFromABridge();
    void ringLiesOnTheStep();
    void discThatFloatsALittleLiesDown();
    void nothingNearKeepsTheHeight();
    void flatGroundTakesFewTriangles();
    void onlyWhatMovedIsLaidOutAnew();
    void branchLeadsToTheOtherPath();
    void branchOfASharedPlaceShowsTheWayOn();
    void currentPathHasABorder();
    void selectedPlaceHasARing();
    void theWayAroundIsShown();
    void bothSidesAreShownWherePeopleTakeBoth();
    void areasCoverWhatTheyEnclose();
    void linesAreAsWideAsTheyAre();
    void changesGiveAnotherVersion();

private:
    [[nodiscard]] std::span<const render::OverlayTriangle> areas();
    void show(std::vector<model::Place> places, std::vector<model::Path> paths);

    std::unique_ptr<model::SceneDocument> m_document;
    std::unique_ptr<EditorState> m_state;
    model::StageRays m_rays;
    std::unique_ptr<PathDrawing> m_drawing;
};

void TestPathDrawing::init()
{
    m_drawing = std::make_unique<PathDrawing>();
    m_state.reset();
    m_document = std::make_unique<model::SceneDocument>();
    m_state = std::make_unique<EditorState>(*m_document);
    const model::StageEntry stage = slabAndBridge();
    m_rays.setStages({&stage, 1});
}

void TestPathDrawing::show(std::vector<model::Place> places, std::vector<model::Path> paths)
{
    model::Scene scene;
    scene.places = std::move(places);
    scene.paths = std::move(paths);
    m_document->replaceScene(std::move(scene), {});
}

std::span<const render::OverlayTriangle> TestPathDrawing::areas()
{
    m_drawing->forget();
    return m_drawing->areas(*m_state, m_rays);
}

void TestPathDrawing::bandGoesUpAStep()
{
    show({placeAt(1, {0.0F, 0.0F, 6.0F}), placeAt(2, {0.0F, 0.15F, -6.0F})},
         {pathOver(1, {1, 2}, kOrange)});
    int onSlab = 0;
    int onGround = 0;
    for (const render::OverlayTriangle& area : areas()) {
        for (const glm::vec3& corner : area.corners) {
            const float floor = corner.z <= 0.0F ? 0.15F : 0.0F;
            QVERIFY2(corner.y > floor && corner.y < floor + 0.1F,
                     qPrintable(QStringLiteral("%1 at z %2").arg(corner.y).arg(corner.z)));
            ++(corner.z < 0.0F ? onSlab : onGround);
        }
    }
    QVERIFY(onSlab > 10);
    QVERIFY(onGround > 10);
}

void TestPathDrawing::bandStaysOnTheBridgeOrUnderIt()
{
    show({placeAt(1, {-8.0F, 5.0F, 10.0F}), placeAt(2, {8.0F, 5.0F, 10.0F})},
         {pathOver(1, {1, 2}, kOrange)});
    QVERIFY(std::ranges::all_of(areas(), [](const render::OverlayTriangle& area) {
        return area.corners[0].y > 5.0F && area.corners[0].y < 5.1F;
    }));
    show({placeAt(1, {0.0F, 0.0F, 4.0F}), placeAt(2, {0.0F, 0.0F, 16.0F})},
         {pathOver(1, {1, 2}, kOrange)});
    QVERIFY(!areas().empty());
    QVERIFY(std::ranges::all_of(areas(), [](const render::OverlayTriangle& area) {
        return area.corners[0].y > 0.0F && area.corners[0].y < 0.1F;
    }));
}

void TestPathDrawing::bandDoesNotHangFromABridge()
{
    show({placeAt(1, {0.0F, 5.0F, 10.0F}), placeAt(2, {0.0F, 0.0F, 30.0F})},
         {pathOver(1, {1, 2}, kOrange)});
    for (const render::OverlayTriangle& area : areas()) {
        const auto [low, high] =
            std::ranges::minmax(area.corners, {}, [](const glm::vec3& corner) { return corner.y; });
        QVERIFY(high.y - low.y < 1.2F);
    }
}

void TestPathDrawing::ringLiesOnTheStep()
{
    show({placeAt(1, {0.0F, 0.0F, 0.2F}, 2.0F)}, {});
    const auto all = areas();
    QVERIFY(!all.empty());
    for (const render::OverlayTriangle& area : all) {
        for (const glm::vec3& corner : area.corners) {
            const float floor = corner.z <= 0.0F ? 0.15F : 0.0F;
            QVERIFY(corner.y > floor && corner.y < 0.2F);
            QVERIFY(glm::distance(corner, glm::vec3(0.0F, corner.y, 0.2F)) < 2.001F);
        }
    }
}

void TestPathDrawing::discThatFloatsALittleLiesDown()
{
    show({placeAt(1, {0.0F, 2.0F, 30.0F}, 2.0F)}, {});
    QVERIFY(!areas().empty());
    for (const render::OverlayTriangle& area : areas()) {
        for (const glm::vec3& corner : area.corners) {
            QVERIFY(corner.y > 0.0F && corner.y < 0.1F);
        }
    }
}

void TestPathDrawing::nothingNearKeepsTheHeight()
{
    show({placeAt(1, {0.0F, 40.0F, 4.0F})}, {});
    QVERIFY(!areas().empty());
    for (const render::OverlayTriangle& area : areas()) {
        QVERIFY(std::abs(area.corners[0].y - 40.0F) < 0.1F);
    }
}

void TestPathDrawing::flatGroundTakesFewTriangles()
{
    show({placeAt(1, {-80.0F, 0.0F, 30.0F}), placeAt(2, {80.0F, 0.0F, 30.0F})},
         {pathOver(1, {1, 2}, kOrange)});
    QVERIFY2(areas().size() < 700, qPrintable(QString::number(areas().size())));
}

void TestPathDrawing::onlyWhatMovedIsLaidOutAnew()
{
    GroundSheets sheets;
    const RingShape ring{{0.0F, 0.0F, 0.0F}, 0.0F, 1.0F};
    const BandShape band{{0.0F, 0.0F, 0.0F}, {4.0F, 0.0F, 0.0F}, {-1.0F, 1.0F}, {-1.0F, 1.0F}};
    sheets.begin(m_rays, 1.0F);
    const GroundTriangle* ringBefore = sheets.ring(ring).data();
    const GroundTriangle* bandBefore = sheets.band(band).data();
    QVERIFY(!sheets.band(band).empty());
    sheets.begin(m_rays, 1.0F); // both memories are there until the next begin()
    QVERIFY(sheets.ring({{0.0F, 0.0F, 1.0F}, 0.0F, 1.0F}).data() != ringBefore);
    QCOMPARE(sheets.band(band).data(), bandBefore);
    const std::vector<GroundTriangle> onStage = sheets.band(band);
    m_rays.setStages({});
    sheets.begin(m_rays, 1.0F);
    QVERIFY(sheets.band(band) != onStage);
}

void TestPathDrawing::branchLeadsToTheOtherPath()
{
    model::Path leaving = pathOver(1, {1, 2}, kOrange);
    const std::vector<model::Place> places{
        placeAt(1, {-10.0F, 0.0F, 30.0F}), placeAt(2, {10.0F, 0.0F, 30.0F}),
        placeAt(3, {10.0F, 0.0F, 50.0F}), placeAt(4, {10.0F, 0.0F, 60.0F})};
    const auto nearest = [](std::span<const render::OverlayTriangle> all, const glm::vec3& to) {
        float least = 1e6F;
        for (const render::OverlayTriangle& area : all) {
            for (const glm::vec3& corner : area.corners) {
                if (hasColor(area, kBlue) && area.color.a > 0.9F) {
                    least = std::min(least, glm::distance(corner, to));
                }
            }
        }
        return least;
    };
    show(places, {leaving, pathOver(2, {3, 4}, kBlue)});
    QVERIFY(nearest(areas(), places[1].position) > 15.0F);
    leaving.branches.push_back({2, 2, 1.0F});
    show(places, {leaving, pathOver(2, {3, 4}, kBlue)});
    QVERIFY(nearest(areas(), places[1].position) < 1.3F); // from the rim of the one
    QVERIFY(nearest(areas(), places[2].position) < 1.3F); // to the rim of the other
    // Above everything else.
    QVERIFY(hasColor(areas().front(), kBlue));
}

void TestPathDrawing::branchOfASharedPlaceShowsTheWayOn()
{
    model::Path leaving = pathOver(1, {1, 2}, kOrange);
    leaving.branches.push_back({2, 2, 1.0F});
    show({placeAt(1, {-10.0F, 0.0F, 30.0F}), placeAt(2, {10.0F, 0.0F, 30.0F}),
          placeAt(3, {10.0F, 0.0F, 50.0F})},
         {leaving, pathOver(2, {2, 3}, kBlue)});
    QVERIFY(hasColor(areas().front(), kBlue));
    QVERIFY(areas().front().corners[0].z > 30.9F);
}

void TestPathDrawing::currentPathHasABorder()
{
    show({placeAt(1, {-10.0F, 0.0F, 30.0F}), placeAt(2, {10.0F, 0.0F, 30.0F})},
         {pathOver(1, {1, 2}, kBlue)});
    const auto beside = [](const render::OverlayTriangle& area) {
        return std::ranges::all_of(area.corners, [](const glm::vec3& corner) {
            return corner.z - 30.0F > 0.999F && std::abs(corner.x) < 10.001F;
        });
    };
    QCOMPARE(std::ranges::count_if(areas(), beside), 0);
    m_state->paths().look(1);
    const auto all = areas();
    QVERIFY(std::ranges::count_if(all, beside) >= 2);
    const auto border = std::ranges::find_if(all, beside);
    QVERIFY(border->color.r > 0.6F && border->color.a > 0.9F); // brighter than the blue
}

void TestPathDrawing::selectedPlaceHasARing()
{
    show({placeAt(1, {0.0F, 0.0F, 30.0F})}, {});
    const auto outside = [](const render::OverlayTriangle& area) {
        return glm::distance(glm::vec2(area.corners[1].x, area.corners[1].z),
                             glm::vec2(0.0F, 30.0F)) > 1.01F;
    };
    QCOMPARE(std::ranges::count_if(areas(), outside), 0);
    m_state->paths().select({1});
    QVERIFY(std::ranges::count_if(areas(), outside) > 40);
}

/// As soon as it is known, and only where it is not straight on.
void TestPathDrawing::theWayAroundIsShown()
{
    model::Place pond = placeAt(3, {0.0F, 0.0F, -40.0F}, 4.0F);
    pond.role = model::PlaceRole::Obstacle;
    pond.color = kBlue;
    const auto farthestAside = [this] {
        float aside = 0.0F;
        for (const render::OverlayTriangle& area : areas()) {
            for (const glm::vec3& corner : area.corners) {
                aside = std::max(aside, hasColor(area, kBlue) ? 0.0F : std::abs(corner.z + 40.0F));
            }
        }
        return aside;
    };
    const model::Place west = placeAt(1, {-9.0F, 0.0F, -40.0F});
    const model::Place east = placeAt(2, {9.0F, 0.0F, -40.0F});
    show({west, east, pond}, {pathOver(1, {1, 2}, kOrange)});
    QVERIFY(farthestAside() < 1.5F); // nobody knows yet
    QTRY_VERIFY(m_state->session().surface() != nullptr);
    QVERIFY2(farthestAside() > 4.2F && farthestAside() < 6.0F,
             QByteArray::number(static_cast<double>(farthestAside())));
    pond.position.z = -60.0F;
    show({west, east, pond}, {pathOver(1, {1, 2}, kOrange)});
    QTRY_VERIFY(m_state->session().surface() != nullptr);
    QVERIFY(farthestAside() < 1.5F);
}

/// In a wide flow those at its edges are nearer to the other end of what stands in its middle.
void TestPathDrawing::bothSidesAreShownWherePeopleTakeBoth()
{
    model::Place pond = placeAt(3, {0.0F, 0.0F, -40.3F}, 3.0F);
    pond.role = model::PlaceRole::Obstacle;
    const auto sides = [this](float radius, const model::Place& between) {
        show({placeAt(1, {-14.0F, 0.0F, -40.0F}, radius), placeAt(2, {14.0F, 0.0F, -40.0F}, radius),
              between},
             {pathOver(1, {1, 2}, kOrange)});
        [&] { QTRY_VERIFY(m_state->session().surface() != nullptr); }();
        glm::bvec2 found(false);
        const glm::vec3 shade = glm::vec3(kOrange[0], kOrange[1], kOrange[2]) / 255.0F * 0.4F;
        for (const render::OverlayTriangle& area : areas()) {
            if (glm::distance(glm::vec3(area.color), shade) < 0.01F) {
                for (const glm::vec3& corner : area.corners) {
                    found.x = found.x || corner.z < -43.0F;
                    found.y = found.y || corner.z > -37.5F;
                }
            }
        }
        return found;
    };
    QVERIFY(sides(4.0F, pond).x);
    QVERIFY(sides(4.0F, pond).y);
    QVERIFY(!sides(0.3F, pond).x); // all go by the nearer end
    QVERIFY(sides(0.3F, pond).y);
    pond.position.z = -60.0F;
    QVERIFY(!sides(4.0F, pond).x && !sides(4.0F, pond).y);
}

/// Seen from above, of those of a colour that lets the ground shine through.
float filledMetres(std::span<const render::OverlayTriangle> areas)
{
    float sum = 0.0F;
    for (const render::OverlayTriangle& area : areas) {
        const glm::vec3 normal =
            glm::cross(area.corners[1] - area.corners[0], area.corners[2] - area.corners[0]);
        sum += area.color.a < 1.0F ? 0.5F * std::abs(normal.y) : 0.0F;
    }
    return sum;
}

void TestPathDrawing::areasCoverWhatTheyEnclose()
{
    model::Place bend = placeAt(1, {}, 0.05F);
    bend.role = model::PlaceRole::Forbidden;
    bend.shape = model::PlaceShape::Area;
    model::setCorners(bend,
                      std::vector<glm::vec3>{
                          {-8, 0, 2}, {2, 0, 2}, {2, 0, 4}, {-6, 0, 4}, {-6, 0, 8}, {-8, 0, 8}});
    show({bend}, {});
    QVERIFY2(std::abs(filledMetres(areas()) - 28.0F) < 0.1F,
             QByteArray::number(static_cast<double>(filledMetres(areas()))));
    m_state->paths().select({1});
    int bright = 0;
    for (const render::OverlayTriangle& area : areas()) {
        bright += area.color.g > 0.7F ? 1 : 0;
    }
    QVERIFY(bright > 6 * 2); // its sides and corners
}

void TestPathDrawing::linesAreAsWideAsTheyAre()
{
    model::Place wall = placeAt(1, {}, 0.5F);
    wall.shape = model::PlaceShape::Line;
    model::setCorners(wall, std::vector<glm::vec3>{{-8, 0, 5}, {2, 0, 5}});
    show({wall}, {});
    QVERIFY(std::abs(filledMetres(areas()) - 10.0F - 2.0F * 0.785F) < 0.1F);
}

void TestPathDrawing::changesGiveAnotherVersion()
{
    show({placeAt(1, {0.0F, 0.0F, 30.0F})}, {});
    (void)areas();
    const std::uint64_t before = m_drawing->version();
    QVERIFY(before != 0);
    (void)m_drawing->areas(*m_state, m_rays);
    QCOMPARE(m_drawing->version(), before);
    m_drawing->forget();
    (void)m_drawing->areas(*m_state, m_rays);
    QVERIFY(m_drawing->version() != before);
}

void TestPathDrawing::labelsSayWhatPanelsAndRulesSay()
{
    model::SceneDocument document;
    EditorState state(document);
    model::Scene scene;
    for (model::PlaceId id = 1; id <= 4; ++id) {
        scene.places.push_back(placeAt(id, {static_cast<float>(id), 0.0F, 0.0F}));
        scene.places.back().name = "Place " + std::to_string(id);
    }
    scene.paths = {pathOver(1, {1, 2}, kOrange), pathOver(2, {3, 4}, kBlue)};
    model::Rule rule;
    rule.trigger = model::triggers::Arrived{4};
    scene.rules = {rule};
    document.replaceScene(std::move(scene), {});
    const model::View view(model::Camera::lookingAt({2.0F, 10.0F, 8.0F}, {2.0F, 0.0F, 0.0F}),
                           {640.0F, 480.0F});
    const auto namesOf = [&] {
        QStringList names;
        for (const PlaceLabel& label : pathLabels(state, view)) {
            if (label.text.startsWith(QStringLiteral("Place "))) {
                names << label.text;
            }
        }
        return names;
    };
    state.setTool(ToolId::BrushCreate);
    QCOMPARE(namesOf(), QStringList{QStringLiteral("Place 4")}); // a rule speaks of it
    state.setTool(ToolId::Select);
    state.paths().look(1);
    QCOMPARE(namesOf(), (QStringList{QStringLiteral("Place 1"), QStringLiteral("Place 2"),
                                     QStringLiteral("Place 4")}));
}

CROWD_TEST(TestPathDrawing)
#include "tst_PathDrawing.moc"
