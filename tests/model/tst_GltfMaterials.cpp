// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <numbers>

#include <QtCore/QBuffer>
#include <QtGui/QColor>
#include <QtGui/QImage>
#include <QtTest/QTest>

#include "tests/model/GltfFolder.h"
#include "tests/model/GltfSamples.h"
#include "tests/program/Test.h"

using namespace crowd::model;
using namespace gltf_samples;

namespace {

/// The next of the file's images, within it.
void addPicture(GltfBuilder& builder, const QImage& picture)
{
    QByteArray png;
    QBuffer buffer(&png);
    if (!picture.save(&buffer, "PNG")) {
        qFatal("cannot write a picture");
    }
    const int view = builder.view(std::vector<std::uint8_t>(png.begin(), png.end()));
    builder.add("images", {{"bufferView", view}, {"mimeType", "image/png"}});
}

} // namespace

class tst_GltfMaterials : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void makesSlotsOfMaterials();
    void offersVariantsAsChoices();
    void readsTexturesWithTheirTransform();
    void shinesByItsPictureAlone();
    void readsNormalMapsOfStages();
    void knowsWhatIsSmooth();
    void takesTheMeanOfPicturesOfSmoothness();

private:
    GltfFolder m_folder;
};

void tst_GltfMaterials::makesSlotsOfMaterials()
{
    GltfBuilder builder = GltfBuilder::triangle();
    builder.root["materials"] = {
        {{"name", "unused"}},
        {{"name", "cloth"}, {"extras", {{"slot", "top"}}}, {"doubleSided", true}},
        {{"name", "face"}, {"extras", {{"slot", "skin"}, {"tintable", false}}}},
        {{"name", "cloth far"}, {"extras", {{"slot", "top"}}}, {"doubleSided", true}},
        {{"name", "face"},
         {"alphaMode", "MASK"},
         {"alphaCutoff", 0.25},
         {"emissiveFactor", {1, 0, 0.5}},
         {"extensions", {{"KHR_materials_unlit", Json::object()}}},
         {"pbrMetallicRoughness", {{"baseColorFactor", {0.5, 0.25, 1, 0.75}}}}},
        {{"name", "face"}}};
    const Json attributes = primitive(builder)["attributes"];
    builder.root["meshes"][0]["primitives"] = Json::array();
    for (const int material : {5, 4, 3, 2, 1, -1}) {
        Json part{{"attributes", attributes}};
        if (material >= 0) {
            part["material"] = material;
        }
        builder.root["meshes"][0]["primitives"].push_back(part);
    }
    const TemplatePtr asset = m_folder.load(builder);
    std::vector<std::string> names;
    for (const Slot& slot : asset->slots) {
        names.push_back(slot.name);
    }
    QCOMPARE(names, (std::vector<std::string>{"top", "skin", "face", "face 2", "default"}));
    QVERIFY(asset->slots[0].tintable && !asset->slots[1].tintable);
    QVERIFY(asset->slots[0].takesPalette && !asset->slots[1].takesPalette);
    QVERIFY2(asset->slots[2].tintable && !asset->slots[2].takesPalette,
             "a file that says nothing of tints keeps its colours");
    QVERIFY(asset->slots[0].choices[0].doubleSided);
    const MaterialChoice& face = asset->slots[2].choices.front();
    QCOMPARE(face.baseColor, glm::vec4(0.5F, 0.25F, 1.0F, 0.75F));
    QCOMPARE(face.alphaMode, AlphaMode::Mask);
    QCOMPARE(face.alphaCutoff, 0.25F);
    QCOMPARE(face.emissive, glm::vec3(1.0F, 0.0F, 0.5F));
    QVERIFY(face.unlit);
    std::vector<int> used;
    for (const Submesh& submesh : asset->levels.front().submeshes) {
        used.push_back(submesh.slot);
    }
    QCOMPARE(used, (std::vector<int>{3, 2, 0, 1, 0, 4}));
}

void tst_GltfMaterials::offersVariantsAsChoices()
{
    GltfBuilder builder = GltfBuilder::triangle();
    builder.root["extensions"] = {
        {"KHR_materials_variants", {{"variants", {{{"name", "day"}}, {{"name", "night"}}}}}}};
    builder.root["materials"] = {{{"name", "a"}}, {{"name", "b"}, {"doubleSided", true}}};
    primitive(builder)["material"] = 0;
    primitive(builder)["extensions"] = {
        {"KHR_materials_variants", {{"mappings", {{{"material", 1}, {"variants", {1}}}}}}}};
    const TemplatePtr asset = m_folder.load(builder);
    QCOMPARE(asset->slots.size(), std::size_t{1});
    QCOMPARE(asset->slots[0].choices.size(), std::size_t{2});
    QCOMPARE(asset->slots[0].choices[1].name, std::string("night"));
    QVERIFY(asset->slots[0].choices[1].doubleSided && !asset->slots[0].choices[0].doubleSided);
}

void tst_GltfMaterials::readsTexturesWithTheirTransform()
{
    QImage picture(2, 1, QImage::Format_RGBA8888);
    picture.setPixelColor(0, 0, QColor(10, 20, 30, 40));
    picture.setPixelColor(1, 0, QColor(255, 0, 0));
    GltfBuilder builder = GltfBuilder::triangle();
    addPicture(builder, picture);
    builder.add("samplers", {{"wrapS", 33071}, {"wrapT", 33648}, {"magFilter", 9728}});
    builder.add("textures", {{"source", 0}, {"sampler", 0}});
    const double quarter = std::numbers::pi / 2.0;
    const Json transform = {
        {"KHR_texture_transform",
         {{"offset", {0.5, 0.25}}, {"scale", {2, 3}}, {"rotation", quarter}, {"texCoord", 1}}}};
    const Json texture = {{"index", 0}, {"extensions", transform}};
    builder.add("materials", {{"name", "m"},
                              {"extras", {{"tintMask", 0}}},
                              {"pbrMetallicRoughness", {{"baseColorTexture", texture}}}});
    primitive(builder)["material"] = 0;
    primitive(builder)["attributes"]["TEXCOORD_1"] =
        builder.accessor<float>({0, 0, 1, 0, 0, 1}, "VEC2");
    const TemplatePtr asset = m_folder.load(builder);
    QCOMPARE(asset->images.size(), std::size_t{1});
    QCOMPARE(asset->images[0].rgba, (std::vector<std::uint8_t>{10, 20, 30, 40, 255, 0, 0, 255}));
    const MaterialChoice& choice = asset->slots[0].choices[0];
    QCOMPARE(choice.image, 0);
    QCOMPARE(choice.tintMask, 0);
    QCOMPARE(choice.wrapU, Wrap::Clamp);
    QCOMPARE(choice.wrapV, Wrap::Mirror);
    QVERIFY(choice.nearest);
    const std::array<float, 6> expected{0, 3, 0.5F, -2, 0, 0.25F};
    for (std::size_t i = 0; i < 6; ++i) {
        QVERIFY(std::abs(choice.uvTransform[i] - expected[i]) < 1e-6F);
    }
    QCOMPARE(asset->levels.front().uv[1], glm::vec2(1, 0));
}

void tst_GltfMaterials::shinesByItsPictureAlone()
{
    QImage picture(1, 1, QImage::Format_RGBA8888);
    picture.fill(QColor(255, 0, 0));
    GltfBuilder builder = GltfBuilder::triangle();
    addPicture(builder, picture);
    builder.add("images", {{"uri", "gone.png"}});
    builder.add("samplers", {{"wrapS", 33071}});
    builder.add("textures", {{"source", 0}, {"sampler", 0}});
    builder.add("textures", {{"source", 1}});
    const Json transform = {{"KHR_texture_transform", {{"offset", {0.5, 0.25}}}}};
    builder.add("materials", {{"emissiveTexture", {{"index", 0}, {"extensions", transform}}},
                              {"emissiveFactor", {1, 1, 0.5}}});
    primitive(builder)["material"] = 0;
    TemplatePtr asset = m_folder.load(builder);
    const MaterialChoice glowing = asset->slots[0].choices[0];
    QCOMPARE(glowing.emissiveImage, 0);
    QCOMPARE(glowing.emissive, glm::vec3(1, 1, 0.5F));
    QCOMPARE(glowing.emissiveUvTransform[2], 0.5F);
    QCOMPARE(glowing.wrapU, Wrap::Clamp);
    QVERIFY(asset->warnings.empty());
    // Without the picture it must not shine as a whole.
    builder.root["materials"][0]["emissiveTexture"] = {{"index", 1}};
    asset = m_folder.load(builder);
    QCOMPARE(asset->slots[0].choices[0].emissive, glm::vec3(0));
    QCOMPARE(asset->warnings.size(), std::size_t{1});
    // Nor where the picture lies by coordinates that the vertices do not keep.
    Json& material = builder.root["materials"][0];
    material["emissiveTexture"] = {{"index", 0}, {"texCoord", 1}};
    material["pbrMetallicRoughness"] = {{"baseColorTexture", {{"index", 0}}}};
    asset = m_folder.load(builder);
    QCOMPARE(asset->slots[0].choices[0].emissive, glm::vec3(0));
    QCOMPARE(asset->warnings.size(), std::size_t{1});
    // A picture that a black factor puts out is not even read.
    material["emissiveFactor"] = {0, 0, 0};
    QVERIFY(m_folder.load(builder)->warnings.empty());
}

void tst_GltfMaterials::readsNormalMapsOfStages()
{
    QImage picture(2, 2, QImage::Format_RGBA8888);
    picture.fill(QColor(128, 128, 255));
    GltfBuilder builder = GltfBuilder::triangle();
    addPicture(builder, picture);
    builder.add("images", {{"uri", "gone.png"}});
    builder.add("textures", {{"source", 0}});
    builder.add("textures", {{"source", 1}});
    const Json transform = {{"KHR_texture_transform", {{"offset", {0.5, 0.25}}}}};
    builder.add("materials",
                {{"normalTexture", {{"index", 0}, {"scale", 0.5}, {"extensions", transform}}}});
    primitive(builder)["material"] = 0;
    const auto stageOf = [&] { return importStage(m_folder.save(builder)).value(); };
    StagePtr stage = stageOf();
    const MaterialChoice rough = stage->materials[0];
    QCOMPARE(rough.normalImage, 0);
    QCOMPARE(rough.normalScale, 0.5F);
    QCOMPARE(rough.normalUvTransform[2], 0.5F);
    QCOMPARE(stage->images.size(), std::size_t{1});
    QVERIFY(stage->warnings.empty());
    // Those of people are left alone.
    const TemplatePtr person = m_folder.load(builder);
    QCOMPARE(person->slots[0].choices[0].normalImage, -1);
    QVERIFY(person->images.empty() && person->warnings.empty());
    // Without the picture, or by other coordinates, it is smooth.
    Json& material = builder.root["materials"][0];
    material["normalTexture"] = {{"index", 1}};
    stage = stageOf();
    QCOMPARE(stage->materials[0].normalImage, -1);
    QCOMPARE(stage->warnings.size(), std::size_t{1});
    material["normalTexture"] = {{"index", 0}, {"texCoord", 1}, {"scale", 1e30}};
    QCOMPARE(stageOf()->materials[0].normalImage, 0); // it alone says which
    QVERIFY(stageOf()->materials[0].normalScale < 100.0F);
    material["pbrMetallicRoughness"] = {{"baseColorTexture", {{"index", 0}}}};
    stage = stageOf();
    QCOMPARE(stage->materials[0].normalImage, -1);
    QCOMPARE(stage->warnings.size(), std::size_t{1});
    // Nothing is lit there.
    material = {{"normalTexture", {{"index", 0}}},
                {"extensions", {{"KHR_materials_unlit", Json::object()}}}};
    QCOMPARE(stageOf()->materials[0].normalImage, -1);
}

void tst_GltfMaterials::knowsWhatIsSmooth()
{
    GltfBuilder builder = GltfBuilder::triangle();
    primitive(builder)["material"] = 0;
    const auto choiceOf = [&](const Json& material) {
        builder.root["materials"] = Json::array({material});
        return m_folder.load(builder)->slots[0].choices[0];
    };
    const auto is = [](const MaterialChoice& choice, float roughness, float metallic) {
        return std::abs(choice.roughness - roughness) < 1e-4F &&
               std::abs(choice.metallic - metallic) < 1e-4F;
    };
    QVERIFY(is(choiceOf({{"name", "none said"}}), 1.0F, 1.0F)); // as the standard has it
    const Json smooth = {{"roughnessFactor", 0.25}, {"metallicFactor", 0.5}};
    QVERIFY(is(choiceOf({{"pbrMetallicRoughness", smooth}}), 0.25F, 0.5F));
    const Json unlit = {{"KHR_materials_unlit", Json::object()}};
    QVERIFY(is(choiceOf({{"pbrMetallicRoughness", smooth}, {"extensions", unlit}}), 1.0F, 0.0F));
    const Json glossy = {{"KHR_materials_pbrSpecularGlossiness", {{"glossinessFactor", 0.7}}}};
    QVERIFY(is(choiceOf({{"extensions", glossy}}), 0.3F, 0.0F));
    const Json odd = {{"roughnessFactor", -3}, {"metallicFactor", 1e30}};
    const TemplatePtr asset = [&] {
        builder.root["materials"] = Json::array({Json::object({{"pbrMetallicRoughness", odd}})});
        return m_folder.load(builder);
    }();
    QVERIFY(asset == nullptr || is(asset->slots[0].choices[0], 0.0F, 1.0F));
}

/// Green is roughness, blue metal; pictures that cannot be read leave nothing that shines.
void tst_GltfMaterials::takesTheMeanOfPicturesOfSmoothness()
{
    QImage picture(2, 1, QImage::Format_RGBA8888);
    picture.setPixelColor(0, 0, QColor(0, 255, 0, 255));
    picture.setPixelColor(1, 0, QColor(0, 51, 255, 0));
    GltfBuilder builder = GltfBuilder::triangle();
    addPicture(builder, picture);
    builder.add("images", {{"uri", "gone.png"}});
    builder.add("textures", {{"source", 0}});
    builder.add("textures", {{"source", 1}});
    builder.add("materials", Json::object());
    primitive(builder)["material"] = 0;
    Json& material = builder.root["materials"][0];
    material["pbrMetallicRoughness"] = {{"roughnessFactor", 0.5},
                                        {"metallicRoughnessTexture", {{"index", 0}}}};
    TemplatePtr asset = m_folder.load(builder);
    MaterialChoice choice = asset->slots[0].choices[0];
    QVERIFY2(std::abs(choice.roughness - 0.3F) < 1e-4F,
             qPrintable(QString::number(choice.roughness)));
    QVERIFY(std::abs(choice.metallic - 0.5F) < 1e-4F);
    QVERIFY2(asset->images.empty(), "a picture of which the mean is taken is not kept");
    QVERIFY(asset->warnings.empty());
    // One picture for colour and smoothness.
    material["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0}};
    asset = m_folder.load(builder);
    QVERIFY(std::abs(asset->slots[0].choices[0].roughness - 0.3F) < 1e-4F);
    QCOMPARE(asset->images.size(), std::size_t{1});
    material["pbrMetallicRoughness"] = {{"metallicRoughnessTexture", {{"index", 1}}}};
    asset = m_folder.load(builder);
    choice = asset->slots[0].choices[0];
    QCOMPARE(choice.roughness, 1.0F);
    QCOMPARE(choice.metallic, 0.0F);
    QCOMPARE(asset->warnings.size(), std::size_t{1});
    material = {{"extensions",
                 {{"KHR_materials_pbrSpecularGlossiness",
                   {{"specularGlossinessTexture", {{"index", 0}}}}}}}};
    asset = m_folder.load(builder);
    QVERIFY(std::abs(asset->slots[0].choices[0].roughness - 0.5F) < 1e-4F); // half of it is clear
}

CROWD_TEST(tst_GltfMaterials)
#include "tst_GltfMaterials.moc"
