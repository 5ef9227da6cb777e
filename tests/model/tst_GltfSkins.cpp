// SPDX-License-Identifier: MIT
#include <QtTest/QTest>

#include "tests/model/GltfFolder.h"
#include "tests/model/GltfSamples.h"
#include "tests/program/Test.h"

using namespace crowd::model;
using namespace gltf_samples;

class tst_GltfSkins : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void skinsWithWeightsOfSumOne();
    void readsEightInfluences();
    void sharesBonesBetweenSkins();
    void makesPartsOfWhatHangsOnJoints();

private:
    GltfFolder m_folder;
};

void tst_GltfSkins::skinsWithWeightsOfSumOne()
{
    GltfBuilder builder = skinned();
    animate(builder, {{"name", "nod"}}, 2, "translation", {0, 1}, {0, 1, 0, 0, 5, 0});
    const TemplatePtr asset = m_folder.load(builder);
    QCOMPARE(asset->jointCount, 2);
    const Mesh& mesh = asset->levels.front();
    QCOMPARE(mesh.influencesPerVertex, 4);
    QCOMPARE(mesh.weights[8], 0.25F);
    QCOMPARE(mesh.weights[9], 0.75F);
    // The mesh node's own place does not count; there is no inverse bind matrix.
    const std::vector<glm::vec3> p = posed(*asset, 0, 1.0F);
    QVERIFY(near(p[0], {0, 0, 0}));
    QVERIFY(near(p[1], {1, 5, 0}));
    QVERIFY(near(p[2], {0, 1 + 3.75F, 0}));
}

void tst_GltfSkins::readsEightInfluences()
{
    GltfBuilder builder = skinned();
    Json& attributes = primitive(builder)["attributes"];
    attributes["JOINTS_1"] =
        builder.accessor<std::uint16_t>({1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, "VEC4");
    attributes["WEIGHTS_1"] = builder.accessor<float>({1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, "VEC4");
    const TemplatePtr asset = m_folder.load(builder);
    QCOMPARE(asset->levels.front().influencesPerVertex, 8);
    QVERIFY(near(posed(*asset, -1, 0.0F)[0], {0, 0.5F, 0}));
}

void tst_GltfSkins::sharesBonesBetweenSkins()
{
    GltfBuilder builder = skinned();
    builder.add("skins", {{"joints", {2, 1}}});
    builder.add("nodes", {{"mesh", 0}, {"skin", 1}});
    builder.root["scenes"][0]["nodes"] = {0, 1, 3};
    const TemplatePtr asset = m_folder.load(builder);
    QCOMPARE(asset->bones.size(), std::size_t{2});
    QCOMPARE(asset->jointCount, 2);
    const std::vector<glm::vec3> p = posed(*asset, -1, 0.0F);
    QCOMPARE(p.size(), std::size_t{6});
    QVERIFY(near(p[0], {0, 0, 0}) && near(p[3], {0, 1, 0}));
}

void tst_GltfSkins::makesPartsOfWhatHangsOnJoints()
{
    GltfBuilder builder = skinned();
    const Json attributes = {{"POSITION", primitive(builder)["attributes"]["POSITION"]}};
    builder.add("meshes", {{"name", "Hut"}, {"primitives", {{{"attributes", attributes}}}}});
    builder.add("nodes", {{"mesh", 1}, {"name", "hat"}, {"translation", {0, 0.5, 0}}});
    builder.root["nodes"][2]["children"] = {3};
    const TemplatePtr asset = m_folder.load(builder);
    QCOMPARE(asset->parts.size(), std::size_t{1});
    QCOMPARE(asset->parts[0].name, std::string("hat"));
    QVERIFY(asset->parts[0].shownByDefault);
    const Mesh& mesh = asset->levels.front();
    QCOMPARE(mesh.submeshes.size(), std::size_t{2});
    QCOMPARE(mesh.submeshes[0].part, -1);
    QCOMPARE(mesh.submeshes[1].part, 0);
    QVERIFY(near(posed(*asset, -1, 0.0F)[3], {0, 1.5F, 0}));
}

CROWD_TEST(tst_GltfSkins)
#include "tst_GltfSkins.moc"
