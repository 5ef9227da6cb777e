// SPDX-License-Identifier: MIT
#include <cmath>
#include <memory>

#include <QtTest/QTest>

#include "model/pick/StageRays.h"
#include "tests/program/Test.h"

using namespace crowd::model;

namespace {

/// A wall across Z = 0 that faces +Z, four metres wide and high.
std::vector<StageEntry> wall(bool isTwoSided)
{
    auto stage = std::make_shared<StageAsset>();
    stage->materials.emplace_back();
    stage->materials.front().doubleSided = isTwoSided;
    StageMesh mesh;
    mesh.positions = {{-2, 0, 0}, {2, 0, 0}, {2, 4, 0}, {-2, 4, 0}};
    mesh.normals.assign(4, glm::vec3(0, 0, 1));
    mesh.uv.assign(4, glm::vec2(0));
    mesh.indices = {0, 1, 2, 0, 2, 3};
    for (const glm::vec3& corner : mesh.positions) {
        stage->bounds.add(corner);
    }
    stage->meshes.push_back(mesh);
    StageEntry entry;
    entry.asset = stage;
    return {entry};
}

} // namespace

/// What is drawn is what rays meet.
class TestStageRays : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aWallIsThereFromInFront();
    void fromBehindItIsLookedThrough();
    void whatHasTwoSidesIsThereFromBoth();
    void whatIsMetLiesInTheTriangle();
};

void TestStageRays::aWallIsThereFromInFront()
{
    StageRays rays;
    rays.setStages(wall(false));
    const auto hit = rays.hit({{0.0F, 2.0F, 5.0F}, {0.0F, 0.0F, -1.0F}});
    QVERIFY(hit && !hit->isGround && hit->distance > 4.99F && hit->normal.z > 0.99F);
    QVERIFY(rays.isBlocked({0.0F, 2.0F, 5.0F}, {0.0F, 2.0F, -5.0F}));
}

/// To the last digit, on every processor: from far away, and nearly along it.
void TestStageRays::whatIsMetLiesInTheTriangle()
{
    StageRays rays;
    auto stages = wall(false);
    stages.front().headingRadians = 0.7F;
    rays.setStages(stages);
    const glm::dvec3 normal(std::sin(0.7), 0.0, std::cos(0.7));
    for (const glm::vec3& from : {glm::vec3(40.0F, 30.0F, 35.0F), glm::vec3(900.0F, 2.0F, 1000.0F),
                                  glm::vec3(10.0F, 2.0F, -7.5F)}) {
        const glm::vec3 to(0.3F, 1.7F, -0.2F);
        const auto hit = rays.hit({from, glm::normalize(to - from)});
        QVERIFY(hit && !hit->isGround);
        QVERIFY(std::abs(glm::dot(normal, glm::dvec3(hit->point))) < 1.0e-6);
        QVERIFY(glm::distance(glm::vec3(normal), hit->normal) < 1.0e-6F);
    }
}

/// The camera has gone through it: it is not drawn from there.
void TestStageRays::fromBehindItIsLookedThrough()
{
    StageRays rays;
    rays.setStages(wall(false));
    QVERIFY(!rays.isBlocked({0.0F, 2.0F, -5.0F}, {0.0F, 2.0F, 5.0F}));
    QVERIFY(rays.hit({{0.0F, 2.0F, -5.0F}, {0.0F, 0.0F, 1.0F}})); // it is there all the same
}

void TestStageRays::whatHasTwoSidesIsThereFromBoth()
{
    StageRays rays;
    rays.setStages(wall(true));
    const auto hit = rays.hit({{0.0F, 2.0F, -5.0F}, {0.0F, 0.0F, 1.0F}});
    QVERIFY(hit && !hit->isGround && hit->normal.z < -0.99F);
    QVERIFY(rays.isBlocked({0.0F, 2.0F, -5.0F}, {0.0F, 2.0F, 5.0F}));
}

CROWD_TEST(TestStageRays)
#include "tst_StageRays.moc"
