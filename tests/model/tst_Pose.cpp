// SPDX-License-Identifier: MIT
#include "model/bake/Pose.h"
#include "model/bake/Skinning.h"
#include "tests/model/Near.h"
#include "tests/program/Test.h"

#include <cmath>

#include <QtTest/QTest>

using namespace crowd::model;
using crowd::testing::near;

namespace {

constexpr float kHalfSqrt = 0.70710678F;

/// A root with one child a metre above it; the clip is given by its channels.
Template twoNodes(std::vector<Channel> channels)
{
    Template asset;
    asset.nodes.resize(2);
    asset.nodes[1].parent = 0;
    asset.nodes[1].translation = {0, 1, 0};
    asset.clips.resize(1);
    asset.clips[0].startSeconds = 1.0F;
    asset.clips[0].seconds = 2.0F;
    asset.clips[0].channels = std::move(channels);
    return asset;
}

glm::vec3 tip(const Template& asset, float seconds)
{
    Pose pose;
    evaluatePose(asset, 0, seconds, pose);
    return glm::vec3(pose.nodeWorld[1][3]);
}

Channel turn(Interpolation interpolation, std::vector<float> values)
{
    return {0, ChannelPath::Rotation, interpolation, {1.0F, 3.0F}, std::move(values)};
}

} // namespace

class tst_Pose : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void turnsAtConstantSpeed();
    void goesTheShortWayRound();
    void holdsStepsAndTheEnds();
    void followsCubicSplines();
    void takesRootMotionAway();
    void appliesTheRootCorrection();
    void samplesThirtyTwoTimesASecondAndAtTheEnd();
    void blendsTwoBones();
    void turnsNormalsOfMirroredAndScaledBones();
};

void tst_Pose::turnsAtConstantSpeed()
{
    // A quarter turn about X from +Y to +Z: after a third of it, 30 degrees.
    const Template asset =
        twoNodes({turn(Interpolation::Linear, {0, 0, 0, 1, kHalfSqrt, 0, 0, kHalfSqrt})});
    const float angle = 3.14159265F / 6.0F;
    QVERIFY(near(tip(asset, 2.0F / 3.0F), {0, std::cos(angle), std::sin(angle)}));
}

void tst_Pose::goesTheShortWayRound()
{
    const Template asset =
        twoNodes({turn(Interpolation::Linear, {0, 0, 0, 1, -kHalfSqrt, 0, 0, -kHalfSqrt})});
    QVERIFY(near(tip(asset, 1.0F), {0, kHalfSqrt, kHalfSqrt}));
}

void tst_Pose::holdsStepsAndTheEnds()
{
    const Template asset =
        twoNodes({turn(Interpolation::Step, {0, 0, 0, 1, kHalfSqrt, 0, 0, kHalfSqrt})});
    QVERIFY(near(tip(asset, -5.0F), {0, 1, 0}));
    QVERIFY(near(tip(asset, 1.99F), {0, 1, 0}));
    QVERIFY(near(tip(asset, 2.0F), {0, 0, 1}));
    QVERIFY(near(tip(asset, 7.0F), {0, 0, 1}));
}

void tst_Pose::followsCubicSplines()
{
    // From x 0 to 1 within two seconds, leaving at 1 m/s and arriving at rest: at half way the
    // Hermite basis gives 0.5 * 1 + 0.125 * (2 * 1).
    const Template asset =
        twoNodes({{1,
                   ChannelPath::Translation,
                   Interpolation::CubicSpline,
                   {1.0F, 3.0F},
                   {0, 0, 0, 0, 0, 0, 1, 0, 0, /**/ 0, 0, 0, 1, 0, 0, 0, 0, 0}}});
    QVERIFY(near(tip(asset, 0.0F), {0, 0, 0}));
    QVERIFY(near(tip(asset, 1.0F), {0.75F, 0, 0}));
    QVERIFY(near(tip(asset, 2.0F), {1, 0, 0}));
}

void tst_Pose::takesRootMotionAway()
{
    Template asset = twoNodes(
        {{0, ChannelPath::Translation, Interpolation::Linear, {1.0F, 3.0F}, {0, 0, 0, 0, 0, 4}}});
    QVERIFY(near(tip(asset, 1.0F), {0, 1, 2}));
    asset.clips[0].rootMotion = {0, 0, 4};
    asset.clips[0].rootMotionNode = 0;
    QVERIFY(near(tip(asset, 1.0F), {0, 1, 0}));
    QVERIFY(near(tip(asset, 2.0F), {0, 1, 0}));
}

void tst_Pose::appliesTheRootCorrection()
{
    Template asset = twoNodes({});
    asset.rootCorrection[0][0] = asset.rootCorrection[1][1] = asset.rootCorrection[2][2] = 0.5F;
    asset.rootCorrection[3][1] = 3.0F;
    QVERIFY(near(tip(asset, 0.0F), {0, 3.5F, 0}));
}

void tst_Pose::samplesThirtyTwoTimesASecondAndAtTheEnd()
{
    Clip clip;
    clip.seconds = 1.2F; // 38.4 intervals
    QCOMPARE(clip.keyframeCount(), 39);
    QCOMPARE(clip.keyframeSeconds(32), 1.0F);
    QCOMPARE(clip.keyframeSeconds(38), 1.2F);
    QCOMPARE(clip.keyframeAt(0.5F), 16.0F);
    QCOMPARE(clip.keyframeAt(1.2F), 38.0F);
    QVERIFY(std::abs(clip.keyframeAt((37.0F / 32.0F + 1.2F) / 2.0F) - 37.5F) < 1e-4F);
    clip.seconds = 0.0F;
    QCOMPARE(clip.keyframeCount(), 1);
    QCOMPARE(clip.keyframeAt(0.0F), 0.0F);
}

void tst_Pose::blendsTwoBones()
{
    Mesh mesh;
    mesh.positions = {{1, 0, 0}};
    mesh.normals = {{0, 1, 0}};
    mesh.influencesPerVertex = 2;
    mesh.bones = {0, 1};
    mesh.weights = {0.25F, 0.75F};
    glm::mat4 lifted(1.0F);
    lifted[3] = {0, 4, 0, 1};
    std::vector<glm::vec3> positions(1);
    std::vector<glm::vec3> normals(1);
    skin(mesh, std::vector<glm::mat4>{glm::mat4(1.0F), lifted}, positions, normals);
    QVERIFY(near(positions[0], {1, 3, 0}));
    QVERIFY(near(normals[0], {0, 1, 0}));
}

void tst_Pose::turnsNormalsOfMirroredAndScaledBones()
{
    Mesh mesh;
    mesh.positions = {{0, 0, 0}};
    mesh.normals = {glm::normalize(glm::vec3(1, 1, 0))};
    mesh.bones = {0};
    mesh.weights = {1.0F};
    glm::mat4 bone(1.0F);
    bone[0][0] = -2.0F; // mirrored and stretched: the plane x + y = 0 becomes -x/2 + y = 0
    std::vector<glm::vec3> positions(1);
    std::vector<glm::vec3> normals(1);
    skin(mesh, std::vector<glm::mat4>{bone}, positions, normals);
    QVERIFY(near(normals[0], glm::normalize(glm::vec3(-0.5F, 1, 0))));
}

CROWD_TEST(tst_Pose)
#include "tst_Pose.moc"
