// SPDX-License-Identifier: MIT
#include <optional>

#include <QtTest/QTest>

#include "tests/model/GltfFolder.h"
#include "tests/model/GltfSamples.h"
#include "tests/program/Test.h"

using namespace crowd::model;
using namespace gltf_samples;

class tst_GltfClips : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void readsClipsWithTheirExtras();
    void namesClipsApart();
    void animatesNodesThatHaveMatrices();
    void takesRootMotionOut();
    void keepsFallsAsTheyAre();
    void choosesAStandingClip();

private:
    GltfFolder m_folder;
};

void tst_GltfClips::readsClipsWithTheirExtras()
{
    GltfBuilder builder = skinned();
    animate(builder, {{"name", "wave"}, {"extras", {{"loop", false}}}}, 2, "rotation", {0.5F, 2},
            {0, 0, 0, 2, 0, 0, 0, 1});
    animate(builder, {{"name", "sit"}, {"extras", {{"seatHeight", 0.45}}}}, 2, "scale", {0},
            {1, 1, 1});
    animate(builder, {{"name", "ride"}, {"extras", {{"speed", 6.5}}}}, 2, "scale", {0, 1},
            {1, 1, 1, 1, 1, 1});
    const TemplatePtr asset = m_folder.load(builder);
    QCOMPARE(asset->clips.size(), std::size_t{3});
    QCOMPARE(asset->clips[0].startSeconds, 0.5F);
    QCOMPARE(asset->clips[0].seconds, 1.5F);
    QVERIFY(!asset->clips[0].loop && asset->clips[1].loop);
    QCOMPARE(asset->clips[0].channels[0].values[3], 1.0F);
    QCOMPARE(asset->clips[1].seatHeight, std::optional(0.45F));
    QCOMPARE(asset->clips[1].seconds, 0.0F);
    QCOMPARE(asset->seatedClip, 1);
    QCOMPARE(asset->clips[2].speed, 6.5F);
}

void tst_GltfClips::namesClipsApart()
{
    GltfBuilder builder = skinned();
    for (const char* name : {"Walk", "Walk", "", "Walk"}) {
        animate(builder, {{"name", name}}, 2, "scale", {0}, {1, 1, 1});
    }
    const TemplatePtr asset = m_folder.load(builder);
    std::vector<std::string> names;
    for (const Clip& clip : asset->clips) {
        names.push_back(clip.name);
    }
    QCOMPARE(names, (std::vector<std::string>{"Walk", "Walk 2", "animation_2", "Walk 3"}));
}

void tst_GltfClips::animatesNodesThatHaveMatrices()
{
    GltfBuilder builder = GltfBuilder::triangle();
    // Twice as large, turned a quarter about Z, at x = 3.
    builder.root["nodes"][0]["matrix"] = {0, 2, 0, 0, -2, 0, 0, 0, 0, 0, 2, 0, 3, 0, 0, 1};
    animate(builder, {{"name", "up"}}, 0, "translation", {0, 1}, {3, 0, 0, 3, 1, 0});
    const TemplatePtr asset = m_folder.load(builder);
    QVERIFY(near(posed(*asset, 0, 0.0F)[1], {3, 2, 0}));
    QVERIFY(near(posed(*asset, 0, 1.0F)[2], {1, 1, 0}));
}

void tst_GltfClips::takesRootMotionOut()
{
    GltfBuilder builder = skinned();
    animate(builder, {{"name", "walk"}}, 1, "translation", {0, 2}, {0, 0, 0, 0, 0.1F, 3});
    const TemplatePtr asset = m_folder.load(builder);
    QCOMPARE(asset->clips[0].speed, 1.5F);
    QVERIFY(near(asset->clips[0].rootMotion, {0, 0, 3}));
    QVERIFY(near(posed(*asset, 0, 2.0F)[0], {0, 0.1F, 0}));
    ImportSettings settings;
    settings.removeRootMotion = false;
    settings.scale = 0.5F;
    const TemplatePtr kept = m_folder.load(builder, settings);
    QCOMPARE(kept->clips[0].speed, 0.75F);
    QVERIFY(near(posed(*kept, 0, 2.0F)[0], {0, 0.05F, 1.5F}));
}

void tst_GltfClips::keepsFallsAsTheyAre()
{
    GltfBuilder builder = skinned();
    // The head comes forward and down, the hips stay.
    animate(builder, {{"name", "fall"}}, 2, "translation", {0, 1}, {0, 1, 0, 0, 0, 1});
    const TemplatePtr asset = m_folder.load(builder);
    QCOMPARE(asset->clips[0].speed, 0.0F);
    QCOMPARE(asset->clips[0].rootMotionNode, -1);
}

void tst_GltfClips::choosesAStandingClip()
{
    GltfBuilder builder = skinned();
    for (const char* name : {"T-Pose", "RESET", "run", "Sit_Idle", "Rig|Idle", "idle_happy"}) {
        animate(builder, {{"name", name}}, 2, "scale", {0, 1}, {1, 1, 1, 1, 1, 1});
    }
    QCOMPARE(m_folder.load(builder)->defaultClip, 4);
    builder.root["animations"].erase(4);
    QCOMPARE(m_folder.load(builder)->defaultClip, 4);
    builder.root["animations"].erase(4);
    QCOMPARE(m_folder.load(builder)->defaultClip, 3);
    builder.root["animations"].erase(3);
    QCOMPARE(m_folder.load(builder)->defaultClip, 2);
}

CROWD_TEST(tst_GltfClips)
#include "tst_GltfClips.moc"
