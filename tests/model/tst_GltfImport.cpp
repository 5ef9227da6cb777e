// SPDX-License-Identifier: MIT
#include "model/gltf/GltfImport.h"

#include <cmath>
#include <numbers>

#include <QtCore/QDir>
#include <QtTest/QTest>

#include "tests/model/GltfFolder.h"
#include "tests/model/GltfSamples.h"
#include "tests/program/Test.h"

using namespace crowd::model;
using namespace gltf_samples;

class tst_GltfImport : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void tellsTemplatesFromStages();
    void readsNamesAndPathsInEveryScript();
    void readsSceneChoice();
    void flattensStagesAndTheirSeats();
    void appliesSettings();
    void canBeCancelled();
    void refusesCharactersThatNobodySees();

private:
    GltfFolder m_folder;
};

void tst_GltfImport::tellsTemplatesFromStages()
{
    QCOMPARE(sniffKind(m_folder.save(GltfBuilder::triangle())), FileKind::Stage);
    QCOMPARE(sniffKind(m_folder.save(skinned())), FileKind::Template);
    GltfBuilder moving = GltfBuilder::triangle();
    animate(moving, {{"name", "spin"}}, 0, "translation", {0, 1}, {0, 0, 0, 0, 0, 0});
    QCOMPARE(sniffKind(m_folder.save(moving)), FileKind::Template);
    QCOMPARE(sniffKind("nowhere.glb"), FileKind::Unknown);
}

void tst_GltfImport::readsNamesAndPathsInEveryScript()
{
    GltfBuilder builder = skinned();
    builder.root["materials"] = {{{"name", "кожа"}}};
    primitive(builder)["material"] = 0;
    animate(builder, {{"name", "歩く"}}, 2, "scale", {0}, {1, 1, 1});
    const QDir folder(m_folder.path());
    QVERIFY(folder.mkpath(QStringLiteral("ordner mit ü/数据")));
    const QByteArray binary(reinterpret_cast<const char*>(builder.bytes.data()),
                            static_cast<qsizetype>(builder.bytes.size()));
    writeFile(folder.filePath(QStringLiteral("ordner mit ü/数据/größe 1.bin")), binary);
    Json json = builder.withBuffer();
    json["buffers"][0]["uri"] = "%E6%95%B0%E6%8D%AE/gr%C3%B6%C3%9Fe%201.bin";
    const std::string external =
        writeFile(folder.filePath(QStringLiteral("ordner mit ü/Mädchen.gltf")),
                  QByteArray::fromStdString(json.dump()));
    const std::string embedded = writeFile(
        folder.filePath(QStringLiteral("ordner mit ü/埋め込み.gltf")), builder.embedded());
    for (const std::string& path : {external, embedded}) {
        const Result<TemplatePtr> asset = importTemplate(path);
        QVERIFY2(asset.isOk(), asset ? "" : asset.error().message.c_str());
        QCOMPARE(asset.value()->slots[0].name, std::string("кожа"));
        QCOMPARE(asset.value()->clips[0].name, std::string("歩く"));
    }
    QCOMPARE(importTemplate(external).value()->name, std::string("Mädchen"));
}

void tst_GltfImport::readsSceneChoice()
{
    GltfBuilder builder = GltfBuilder::triangle();
    builder.root["nodes"] = {{{"mesh", 0}}, {{"mesh", 0}, {"translation", {0, 5, 0}}}};
    builder.root["scenes"] = {{{"nodes", {0}}}, {{"nodes", {1}}}};
    builder.root["scene"] = 1;
    QCOMPARE(m_folder.load(builder)->bounds.low.y, 5.0F);
    builder.root.erase("scene");
    QCOMPARE(m_folder.load(builder)->bounds.low.y, 0.0F);
    builder.root.erase("scenes");
    QCOMPARE(m_folder.load(builder)->levels.front().triangleCount(), std::size_t{2});
}

void tst_GltfImport::flattensStagesAndTheirSeats()
{
    GltfBuilder builder = GltfBuilder::triangle();
    builder.root["materials"] = {{{"name", "stone"}}};
    const int positions = primitive(builder)["attributes"]["POSITION"];
    builder.root["meshes"][0]["primitives"].push_back(
        {{"attributes", {{"POSITION", positions}}}, {"material", 0}});
    const Json seat = {{"position", {1, 2, 3}},
                       {"headingRadians", 0.0},
                       {"height", 0.4},
                       {"rank", 2},
                       {"wedge", 5}};
    builder.root["nodes"][0]["translation"] = {10, 0, 0};
    // A quarter turn about Y: +Z becomes +X.
    builder.root["nodes"][0]["rotation"] = {0, std::sqrt(0.5), 0, std::sqrt(0.5)};
    builder.root["nodes"][0]["extras"] = {{"seats", {seat, 3}}};
    builder.root["scenes"][0]["extras"] = {{"seats", Json(Json::array({seat})).dump()}};
    const Result<StagePtr> imported = importStage(m_folder.save(builder));
    QVERIFY2(imported.isOk(), imported ? "" : imported.error().message.c_str());
    const StageAsset& stage = *imported.value();
    QCOMPARE(stage.triangleCount(), std::size_t{2});
    QCOMPARE(stage.meshes.size(), std::size_t{2});
    QCOMPARE(stage.materials.size(), std::size_t{2});
    QCOMPARE(stage.materials[static_cast<std::size_t>(stage.meshes[0].material)].name,
             std::string("stone"));
    QVERIFY(near(stage.meshes[0].positions[1], {10, 0, -1}));
    QCOMPARE(stage.seats.size(), std::size_t{2});
    QVERIFY(near(stage.seats[0].position, {1, 2, 3}));
    QVERIFY(near(stage.seats[1].position, {13, 2, -1}));
    QVERIFY(std::abs(stage.seats[1].headingRadians - std::numbers::pi_v<float> / 2) < 1e-5F);
    QCOMPARE(stage.seats[1].height, 0.4F);
    QCOMPARE(stage.seats[1].rank, 2);
    QCOMPARE(stage.seats[1].wedge, 5);
    QCOMPARE(stage.warnings.size(), std::size_t{1});
}

void tst_GltfImport::appliesSettings()
{
    ImportSettings settings;
    settings.scale = 2.0F;
    settings.rotation = glm::angleAxis(std::numbers::pi_v<float> / 2, glm::vec3(0, 0, 1));
    settings.groundOffset = 3.0F;
    const TemplatePtr asset = m_folder.load(GltfBuilder::triangle(), settings);
    const std::vector<glm::vec3> p = posed(*asset, 0, 0.0F);
    QVERIFY(near(p[1], {0, 5, 0}));
    QVERIFY(near(p[2], {-2, 3, 0}));
    QVERIFY(std::abs(asset->height - 2.0F) < 1e-5F);
}

void tst_GltfImport::canBeCancelled()
{
    const std::string path = m_folder.save(GltfBuilder::triangle());
    float last = -1.0F;
    const auto watch = [&last](float fraction) {
        const bool isForwards = fraction >= last;
        last = fraction;
        return isForwards;
    };
    QVERIFY(importTemplate(path, {}, watch).isOk());
    QCOMPARE(last, 1.0F);
    for (int calls = 0; calls < 3; ++calls) {
        int left = calls;
        const auto stop = [&left](float) { return left-- > 0; };
        const Result<TemplatePtr> asset = importTemplate(path, {}, stop);
        QVERIFY(!asset.isOk());
        QVERIFY(asset.error().message.find("cancelled") != std::string::npos);
    }
}

void tst_GltfImport::refusesCharactersThatNobodySees()
{
    const auto messageOf = [this](const GltfBuilder& builder) {
        const Result<TemplatePtr> asset = importTemplate(m_folder.save(builder));
        return asset ? QString() : QString::fromStdString(asset.error().message);
    };
    GltfBuilder clips = skinned();
    animate(clips, {{"name", "walk"}}, 2, "translation", {0, 1}, {0, 0, 0, 0, 1, 0});
    for (const char* array : {"meshes", "skins"}) {
        clips.root.erase(array);
    }
    clips.root["nodes"][0] = {{"name", "empty"}};
    QCOMPARE(messageOf(clips),
             QStringLiteral("test.glb: it has no mesh, so that nobody made of it could be seen; "
                            "export the file again together with the character's mesh, as "
                            "triangles."));
    for (const int mode : {0, 1, 3}) {
        GltfBuilder points = GltfBuilder::triangle();
        primitive(points)["mode"] = mode;
        QVERIFY(messageOf(points).contains(QStringLiteral("its scene has no triangles")));
        QVERIFY(importStage(m_folder.save(points)).isOk()); // a stage may be empty
    }
    GltfBuilder elsewhere = GltfBuilder::triangle();
    elsewhere.root["scenes"][0]["nodes"] = Json::array();
    QVERIFY(messageOf(elsewhere).contains(QStringLiteral("its scene has no triangles")));
}

CROWD_TEST(tst_GltfImport)
#include "tst_GltfImport.moc"
