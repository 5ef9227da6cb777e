// SPDX-License-Identifier: MIT
#include <cmath>

#include <QtTest/QTest>

#include "model/bake/ClipBaker.h"
#include "tests/model/GltfFolder.h"
#include "tests/model/GltfSamples.h"
#include "tests/program/Test.h"

using namespace crowd::model;
using namespace gltf_samples;

/// What the specification of glTF 2.0 says of skins and animations, with the poses that are to come
/// of it.
class tst_GltfSpecClips : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void interpolatesLinearly();
    void interpolatesInSteps();
    void interpolatesCubically();
    void turnsTheShorterWay();
    void readsRotationsAsFractions();
    void holdsTheEnds();
    void bakesClipsWithoutLength_data();
    void bakesClipsWithoutLength();
    void movesSeveralSkeletonsAtOnce();
    void ignoresChannelsThatMoveNothing();
    void followsPointersToNodes();
    void leavesOutClipsOfOtherPointers();
    void ignoresTheSkinnedNodesOwnPlace();
    void takesJointsFromAnywhere();
    void keepsUnskinnedUsesOfSkinnedMeshes();
    void drawsASkinForEachOfItsNodes();
    void readsInverseBindMatrices();
    void readsJointsOfEverySize();
    void ignoresInfluencesPastTheFourthSet();
    void turnsMirroredSkinsOver();
    void acceptsSkeletonRoots();

private:
    GltfFolder m_folder;
};

namespace {

/// The node of the triangle moves by one channel.
GltfBuilder moving(const char* path, const std::vector<float>& times,
                   const std::vector<float>& values, const char* interpolation = "LINEAR")
{
    GltfBuilder builder = GltfBuilder::triangle();
    animate(builder, {{"name", "move"}}, 0, path, times, values);
    builder.root["animations"][0]["samplers"][0]["interpolation"] = interpolation;
    return builder;
}

/// Where the triangle's corner at the origin is.
glm::vec3 originAt(const Template& asset, float seconds)
{
    return posed(asset, 0, seconds)[0];
}

/// Where its corner at +X is.
glm::vec3 xAt(const Template& asset, float seconds)
{
    return posed(asset, 0, seconds)[1];
}

} // namespace

void tst_GltfSpecClips::interpolatesLinearly()
{
    // It comes back, so that this is no motion of the root.
    const TemplatePtr asset =
        m_folder.load(moving("translation", {0, 1, 4}, {0, 0, 0, 2, 4, 6, 0, 0, 0}));
    QVERIFY(near(originAt(*asset, 0.5F), {1, 2, 3}));
    QVERIFY(near(originAt(*asset, 2.5F), {1, 2, 3}));
    QVERIFY(near(originAt(*asset, 1.0F), {2, 4, 6}));
}

void tst_GltfSpecClips::interpolatesInSteps()
{
    const TemplatePtr asset =
        m_folder.load(moving("scale", {0, 1, 2}, {1, 1, 1, 2, 1, 1, 3, 1, 1}, "STEP"));
    QVERIFY(near(xAt(*asset, 0.99F), {1, 0, 0}));
    QVERIFY(near(xAt(*asset, 1.0F), {2, 0, 0}));
    QVERIFY(near(xAt(*asset, 1.99F), {2, 0, 0}));
    QVERIFY(near(xAt(*asset, 2.0F), {3, 0, 0}));
}

void tst_GltfSpecClips::interpolatesCubically()
{
    // In-tangent, value, out-tangent of each of two keys, two seconds apart.
    const TemplatePtr moved = m_folder.load(
        moving("translation", {1, 3}, {9, 9, 9, 0, 0, 0, 0, 3, 0, 0, 1, 0, 0, 2, 0, 9, 9, 9},
               "CUBICSPLINE"));
    QCOMPARE(moved->clips[0].startSeconds, 1.0F);
    for (const float at : {0.0F, 0.5F, 1.0F, 1.7F, 2.0F}) {
        const float t = at / 2.0F;
        const float expected = 2.0F * 3.0F * (t * t * t - 2.0F * t * t + t) +
                               2.0F * (3.0F * t * t - 2.0F * t * t * t) +
                               2.0F * 1.0F * (t * t * t - t * t);
        QVERIFY(near(originAt(*moved, at), {0, expected, 0}));
    }
    const float half = std::sqrt(0.5F);
    const TemplatePtr turned =
        m_folder.load(moving("rotation", {0, 1}, {0, 0, 0, 0, 0, 0, 0,    1,    0, 0, 0, 0,
                                                  0, 0, 0, 0, 0, 0, half, half, 0, 0, 0, 0},
                             "CUBICSPLINE"));
    QVERIFY(near(xAt(*turned, 0.0F), {1, 0, 0}));
    QVERIFY(near(xAt(*turned, 0.5F), {half, half, 0}));
    QVERIFY(near(xAt(*turned, 1.0F), {0, 1, 0}));
    // A single key has nothing between.
    const TemplatePtr still =
        m_folder.load(moving("translation", {2}, {9, 9, 9, 4, 5, 6, 9, 9, 9}, "CUBICSPLINE"));
    QVERIFY(near(originAt(*still, 0.0F), {4, 5, 6}));
}

void tst_GltfSpecClips::turnsTheShorterWay()
{
    const float half = std::sqrt(0.5F);
    // The second is a quarter turn about Z with all signs turned over.
    const TemplatePtr asset =
        m_folder.load(moving("rotation", {0, 1}, {0, 0, 0, 1, 0, 0, -half, -half}));
    QVERIFY(near(xAt(*asset, 0.5F), {half, half, 0}));
    QVERIFY(near(xAt(*asset, 1.0F), {0, 1, 0}));
}

void tst_GltfSpecClips::readsRotationsAsFractions()
{
    for (const bool isByte : {true, false}) {
        GltfBuilder builder = GltfBuilder::triangle();
        const int times = builder.accessor<float>({0}, "SCALAR");
        const int values = isByte ? builder.accessor<std::int8_t>({0, 0, 90, 90}, "VEC4")
                                  : builder.accessor<std::int16_t>({0, 0, 23170, 23170}, "VEC4");
        builder.root["accessors"][static_cast<std::size_t>(values)]["normalized"] = true;
        builder.add(
            "animations",
            {{"samplers", {{{"input", times}, {"output", values}}}},
             {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "rotation"}}}}}}});
        QVERIFY(near(xAt(*m_folder.load(builder), 0.0F), {0, 1, 0}));
    }
}

void tst_GltfSpecClips::holdsTheEnds()
{
    GltfBuilder builder = moving("translation", {1, 2, 3}, {0, 1, 0, 0, 2, 0, 0, 1, 0});
    // A second channel of the clip is longer on both sides.
    const int times = builder.accessor<float>({0, 5}, "SCALAR");
    const int values = builder.accessor<float>({1, 1, 1, 1, 1, 1}, "VEC3");
    Json& clip = builder.root["animations"][0];
    clip["samplers"].push_back({{"input", times}, {"output", values}});
    clip["channels"].push_back({{"sampler", 1}, {"target", {{"node", 0}, {"path", "scale"}}}});
    const TemplatePtr asset = m_folder.load(builder);
    QCOMPARE(asset->clips[0].seconds, 5.0F);
    QVERIFY(near(originAt(*asset, 0.0F), {0, 1, 0}));
    QVERIFY(near(originAt(*asset, 1.5F), {0, 1.5F, 0}));
    QVERIFY(near(originAt(*asset, 4.5F), {0, 1, 0}));
}

void tst_GltfSpecClips::bakesClipsWithoutLength_data()
{
    QTest::addColumn<QString>("interpolation");
    QTest::addColumn<int>("keys");
    for (const char* name : {"LINEAR", "STEP", "CUBICSPLINE"}) {
        QTest::newRow(name) << QString::fromLatin1(name)
                            << (QString::fromLatin1(name).startsWith(u'C') ? 3 : 1);
    }
}

void tst_GltfSpecClips::bakesClipsWithoutLength()
{
    QFETCH(const QString, interpolation);
    QFETCH(const int, keys);
    std::vector<float> values(static_cast<std::size_t>(keys) * 3, 0.0F);
    values[keys == 3 ? 4 : 1] = 2.0F;
    const TemplatePtr asset =
        m_folder.load(moving("translation", {0.75F}, values, interpolation.toLatin1().constData()));
    const Clip& clip = asset->clips[0];
    QCOMPARE(clip.seconds, 0.0F);
    QVERIFY(clip.keyframeCount() >= 1);
    QVERIFY(near(originAt(*asset, 0.0F), {0, 2, 0}));
    QCOMPARE(asset->bounds.low.y, 2.0F);
    QVERIFY(bakeClip(*asset, 0, clip.keyframeCount()) != nullptr);
}

void tst_GltfSpecClips::movesSeveralSkeletonsAtOnce()
{
    GltfBuilder builder = skinned();
    builder.add("nodes", {{"name", "horse"}, {"children", {4}}, {"translation", {10, 0, 0}}});
    builder.add("nodes", {{"name", "horse head"}, {"translation", {0, 1, 0}}});
    builder.add("nodes", {{"mesh", 0}, {"skin", 1}});
    builder.add("skins", {{"joints", {3, 4}}});
    builder.root["scenes"][0]["nodes"] = {0, 1, 3, 5};
    const int times = builder.accessor<float>({0, 1}, "SCALAR");
    const int man = builder.accessor<float>({0, 1, 0, 0, 3, 0}, "VEC3");
    const int horse = builder.accessor<float>({0, 1, 0, 0, 5, 0}, "VEC3");
    const auto channel = [](int sampler, int node) {
        return Json{{"sampler", sampler}, {"target", {{"node", node}, {"path", "translation"}}}};
    };
    builder.add(
        "animations",
        {{"samplers", {{{"input", times}, {"output", man}}, {{"input", times}, {"output", horse}}}},
         {"channels", {channel(0, 2), channel(1, 4)}}});
    const TemplatePtr asset = m_folder.load(builder);
    QCOMPARE(asset->jointCount, 4);
    const std::vector<glm::vec3> p = posed(*asset, 0, 1.0F);
    QVERIFY(near(p[1], {1, 3, 0}));
    QVERIFY(near(p[4], {11, 5, 0}));
}

void tst_GltfSpecClips::ignoresChannelsThatMoveNothing()
{
    GltfBuilder builder = moving("translation", {0, 1}, {0, 0, 0, 0, 1, 0});
    builder.add("nodes", {{"name", "outside the scene"}});
    Json& clip = builder.root["animations"][0];
    const int times = builder.accessor<float>({0, 9}, "SCALAR");
    clip["samplers"].push_back({{"input", times}, {"output", clip["samplers"][0]["output"]}});
    const Json pointer = {{"KHR_animation_pointer", {{"pointer", "/materials/0/alphaCutoff"}}}};
    for (const Json& target :
         {Json{{"path", "rotation"}}, Json{{"node", 1}, {"path", "translation"}},
          Json{{"path", "pointer"}, {"extensions", pointer}},
          Json{{"node", 0}, {"path", "soul"}}}) {
        clip["channels"].push_back({{"sampler", 0}, {"target", target}});
    }
    const TemplatePtr asset = m_folder.load(builder);
    QCOMPARE(asset->clips[0].channels.size(), std::size_t{1});
    QVERIFY(near(originAt(*asset, 1.0F), {0, 1, 0}));
    // A clip may have none at all.
    clip["channels"] = Json::array();
    QCOMPARE(m_folder.load(builder)->clips[0].seconds, 0.0F);
}

/// The channels of the builder's first clip point to properties by their paths.
void pointTo(GltfBuilder& builder, const std::vector<std::string>& pointers)
{
    Json& channels = builder.root["animations"][0]["channels"];
    channels = Json::array();
    for (const std::string& pointer : pointers) {
        channels.push_back(
            {{"sampler", 0},
             {"target",
              {{"path", "pointer"},
               {"extensions", {{"KHR_animation_pointer", {{"pointer", pointer}}}}}}}});
    }
    builder.root["extensionsUsed"] = {"KHR_animation_pointer"};
}

void tst_GltfSpecClips::followsPointersToNodes()
{
    GltfBuilder builder = moving("translation", {1, 3}, {0, 0, 0, 0, 2, 0});
    pointTo(builder, {"/nodes/0/translation", "/materials/0/emissiveFactor"});
    const TemplatePtr asset = m_folder.load(builder);
    QCOMPARE(asset->clips.size(), std::size_t{1});
    QCOMPARE(asset->clips[0].seconds, 2.0F);
    QVERIFY(near(originAt(*asset, 1.0F), {0, 1, 0}));
    QCOMPARE(asset->warnings.size(), std::size_t{1});
    QVERIFY(asset->warnings[0].english().find("/materials/0/emissiveFactor") != std::string::npos);
}

void tst_GltfSpecClips::leavesOutClipsOfOtherPointers()
{
    for (const char* pointer : {"/materials/0/emissiveFactor", "/nodes/7/translation", "/nodes/0/",
                                "/nodes/0/extras", "/nodes//translation", "", "/"}) {
        GltfBuilder builder = moving("translation", {1, 3}, {0, 0, 0, 0, 2, 0});
        pointTo(builder, {pointer});
        const TemplatePtr asset = m_folder.load(builder);
        QVERIFY(asset->clips.front().isMadeUp); // the resting pose, as of a file without clips
        QCOMPARE(asset->warnings.size(), std::size_t{2});
        QVERIFY(asset->warnings[1].english().find("\"move\"") != std::string::npos);
    }
}

void tst_GltfSpecClips::ignoresTheSkinnedNodesOwnPlace()
{
    // It hangs on a joint, is scaled and animated; only the joints count.
    GltfBuilder builder = skinned();
    builder.root["nodes"][0]["scale"] = {3, 3, -3};
    builder.root["nodes"][2]["children"] = {0};
    builder.root["scenes"][0]["nodes"] = {1};
    animate(builder, {{"name", "float"}}, 0, "translation", {0, 1}, {0, 0, 0, 0, 9, 0});
    const TemplatePtr asset = m_folder.load(builder);
    const std::vector<glm::vec3> p = posed(*asset, 0, 1.0F);
    QVERIFY(near(p[0], {0, 0, 0}) && near(p[1], {1, 1, 0}) && near(p[2], {0, 1.75F, 0}));
    QCOMPARE(asset->levels.front().indices, (std::vector<std::uint32_t>{0, 1, 2}));
}

void tst_GltfSpecClips::takesJointsFromAnywhere()
{
    GltfBuilder builder = skinned();
    // Joints in the other order, in two trees, one below a node that is no joint, the other below
    // the skinned node, and the trees not in the scene.
    builder.root["nodes"] = {{{"mesh", 0}, {"skin", 0}, {"children", {3}}},
                             {{"translation", {0, 0, 5}}, {"children", {2}}},
                             {{"name", "hips"}, {"translation", {0, 0, 1}}},
                             {{"name", "head"}, {"translation", {7, 0, 0}}}};
    builder.root["skins"][0]["joints"] = {3, 2};
    builder.root["scenes"][0]["nodes"] = {0};
    const TemplatePtr asset = m_folder.load(builder);
    const std::vector<glm::vec3> p = posed(*asset, -1, 0.0F);
    QVERIFY(near(p[0], {7, 0, 0}) && near(p[1], {1, 0, 6}));
    QVERIFY(near(p[2], {0.25F * 7, 1, 0.75F * 6}));
    QCOMPARE(asset->jointCount, 2);
    // The skinned node as a joint of its own skin.
    builder.root["skins"][0]["joints"] = {0, 3};
    builder.root["nodes"][0]["translation"] = {0, 2, 0};
    QVERIFY(near(posed(*m_folder.load(builder), -1, 0.0F)[1], {8, 2, 0}));
}

void tst_GltfSpecClips::keepsUnskinnedUsesOfSkinnedMeshes()
{
    GltfBuilder builder = skinned();
    builder.root["nodes"][0].erase("skin");
    const TemplatePtr asset = m_folder.load(builder);
    QVERIFY(near(posed(*asset, -1, 0.0F)[1], {51, 0, 0}));
    QCOMPARE(asset->jointCount, 0);
    // And a skin on a mesh that follows no joints.
    GltfBuilder stiff = GltfBuilder::triangle();
    stiff.root["nodes"] = {{{"mesh", 0}, {"skin", 0}, {"translation", {2, 0, 0}}},
                           {{"name", "joint"}}};
    stiff.add("skins", {{"joints", {1}}});
    QVERIFY(near(posed(*m_folder.load(stiff), -1, 0.0F)[1], {3, 0, 0}));
}

void tst_GltfSpecClips::drawsASkinForEachOfItsNodes()
{
    GltfBuilder builder = skinned();
    builder.add("nodes", {{"mesh", 0}, {"skin", 0}, {"translation", {3, 3, 3}}});
    builder.root["scenes"][0]["nodes"] = {0, 1, 3};
    const TemplatePtr asset = m_folder.load(builder);
    const std::vector<glm::vec3> p = posed(*asset, -1, 0.0F);
    QCOMPARE(p.size(), std::size_t{6});
    QVERIFY(near(p[1], p[4]) && near(p[1], {1, 1, 0}));
    QCOMPARE(asset->bones.size(), std::size_t{2});
}

void tst_GltfSpecClips::readsInverseBindMatrices()
{
    GltfBuilder builder = skinned();
    // The second joint was bound a metre up and half as large; a third matrix is too many.
    builder.root["skins"][0]["inverseBindMatrices"] = builder.accessor<float>(
        {1, 0, 0, 0, 0, 1,  0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 2, 0, 0, 0, 0, 2, 0, 0,
         0, 0, 2, 0, 0, -2, 0, 1, 5, 0, 0, 0, 0, 5, 0, 0, 0, 0, 5, 0, 0, 0, 0, 1},
        "MAT4");
    const std::vector<glm::vec3> p = posed(*m_folder.load(builder), -1, 0.0F);
    QVERIFY(near(p[0], {0, 0, 0}) && near(p[1], {2, -1, 0}));
}

void tst_GltfSpecClips::readsJointsOfEverySize()
{
    GltfBuilder builder = skinned();
    Json& attributes = primitive(builder)["attributes"];
    attributes["JOINTS_0"] =
        builder.accessor<std::uint16_t>({0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0}, "VEC4");
    attributes["WEIGHTS_0"] = builder.accessor<std::uint16_t>(
        {65535, 0, 0, 0, 65535, 0, 0, 0, 16384, 49151, 0, 0}, "VEC4");
    builder.root["accessors"][attributes["WEIGHTS_0"].get<std::size_t>()]["normalized"] = true;
    const std::vector<glm::vec3> p = posed(*m_folder.load(builder), -1, 0.0F);
    QVERIFY(near(p[1], {1, 1, 0}));
    QVERIFY(glm::length(p[2] - glm::vec3(0, 1.75F, 0)) < 1e-4F);
}

void tst_GltfSpecClips::ignoresInfluencesPastTheFourthSet()
{
    GltfBuilder builder = skinned();
    Json& attributes = primitive(builder)["attributes"];
    for (int set = 1; set < 6; ++set) {
        attributes["JOINTS_" + std::to_string(set)] = attributes["JOINTS_0"];
        attributes["WEIGHTS_" + std::to_string(set)] = attributes["WEIGHTS_0"];
    }
    const TemplatePtr asset = m_folder.load(builder);
    QCOMPARE(asset->levels.front().influencesPerVertex, 16);
    QVERIFY(near(posed(*asset, -1, 0.0F)[2], {0, 1.75F, 0}));
}

void tst_GltfSpecClips::turnsMirroredSkinsOver()
{
    GltfBuilder builder = skinned();
    builder.root["nodes"][1]["scale"] = {-1, 1, 1};
    const TemplatePtr asset = m_folder.load(builder);
    const std::vector<glm::vec3> p = posed(*asset, -1, 0.0F);
    const std::vector<std::uint32_t>& i = asset->levels.front().indices;
    QVERIFY(near(p[1], {-1, 1, 0}));
    QVERIFY(glm::cross(p[i[1]] - p[i[0]], p[i[2]] - p[i[0]]).z > 0.0F);
}

void tst_GltfSpecClips::acceptsSkeletonRoots()
{
    GltfBuilder builder = skinned();
    for (const int root : {0, 1, 2}) {
        builder.root["skins"][0]["skeleton"] = root;
        QVERIFY(near(posed(*m_folder.load(builder), -1, 0.0F)[1], {1, 1, 0}));
    }
}

CROWD_TEST(tst_GltfSpecClips)
#include "tst_GltfSpecClips.moc"
