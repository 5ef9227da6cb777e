// SPDX-License-Identifier: MIT
#include "model/gltf/GltfImport.h"

#include <cmath>
#include <numbers>

#include <meshoptimizer.h>

#include <QtCore/QBuffer>
#include <QtCore/QDir>
#include <QtCore/QTemporaryDir>
#include <QtGui/QImage>
#include <QtTest/QTest>

#include "tests/model/GltfSamples.h"
#include "tests/program/Test.h"

using namespace crowd::model;

namespace {

using namespace gltf_samples;
using Indices = std::vector<std::uint32_t>;

/// Vertices of a strip along X: 0 0, 0 1, 1 0, 1 1, 2 0.
GltfBuilder strip(int mode)
{
    GltfBuilder builder = GltfBuilder::triangle();
    const int positions =
        builder.accessor<float>({0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0, 2, 0, 0}, "VEC3");
    primitive(builder) = {{"attributes", {{"POSITION", positions}}}, {"mode", mode}};
    return builder;
}

} // namespace

class tst_GltfImport : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void tellsTemplatesFromStages();
    void expandsStripsAndFans_data();
    void expandsStripsAndFans();
    void readsIndicesOfEverySize();
    void readsStridesSparseValuesAndMissingViews();
    void readsNormalisedIntegers();
    void unpacksMeshoptCompression();
    void shadesFlatWhereNormalsAreMissing();
    void turnsMirroredTrianglesOver();
    void skinsWithWeightsOfSumOne();
    void readsEightInfluences();
    void sharesBonesBetweenSkins();
    void makesPartsOfWhatHangsOnJoints();
    void findsLevelsByExtension();
    void findsLevelsByName();
    void makesSlotsOfMaterials();
    void offersVariantsAsChoices();
    void readsTexturesWithTheirTransform();
    void readsClipsWithTheirExtras();
    void namesClipsApart();
    void animatesNodesThatHaveMatrices();
    void takesRootMotionOut();
    void keepsFallsAsTheyAre();
    void choosesAStandingClip();
    void readsNamesAndPathsInEveryScript();
    void readsSceneChoice();
    void flattensStagesAndTheirSeats();
    void appliesSettings();
    void canBeCancelled();

private:
    TemplatePtr load(const GltfBuilder& builder, const ImportSettings& settings = {})
    {
        const Result<TemplatePtr> asset = importTemplate(save(builder), settings);
        if (!asset) {
            qFatal("%s", asset.error().message.c_str());
        }
        return asset.value();
    }

    std::string save(const GltfBuilder& builder)
    {
        return writeFile(m_folder.filePath(QStringLiteral("test.glb")), builder.glb());
    }

    QTemporaryDir m_folder;
};

void tst_GltfImport::tellsTemplatesFromStages()
{
    QCOMPARE(sniffKind(save(GltfBuilder::triangle())), FileKind::Stage);
    QCOMPARE(sniffKind(save(skinned())), FileKind::Template);
    GltfBuilder moving = GltfBuilder::triangle();
    animate(moving, {{"name", "spin"}}, 0, "translation", {0, 1}, {0, 0, 0, 0, 0, 0});
    QCOMPARE(sniffKind(save(moving)), FileKind::Template);
    QCOMPARE(sniffKind("nowhere.glb"), FileKind::Unknown);
}

void tst_GltfImport::expandsStripsAndFans_data()
{
    QTest::addColumn<int>("mode");
    QTest::addColumn<std::vector<std::uint32_t>>("indices");
    QTest::newRow("list, two corners left over") << 4 << Indices{0, 1, 2};
    QTest::newRow("strip") << 5 << Indices{0, 1, 2, 1, 3, 2, 2, 3, 4};
    QTest::newRow("fan") << 6 << Indices{1, 2, 0, 2, 3, 0, 3, 4, 0};
    QTest::newRow("points") << 0 << Indices{};
    QTest::newRow("line strip") << 3 << Indices{};
}

void tst_GltfImport::expandsStripsAndFans()
{
    QFETCH(const int, mode);
    QFETCH(const std::vector<std::uint32_t>, indices);
    const TemplatePtr asset = load(strip(mode));
    const Mesh& mesh = asset->levels.front();
    QCOMPARE(mesh.indices.size(), indices.size());
    for (std::size_t i = 0; i < indices.size(); ++i) {
        // Flat normals may have made a copy of the vertex.
        QCOMPARE(mesh.positions[mesh.indices[i]], mesh.positions[indices[i]]);
    }
    // Points and lines: that they are there, and that nothing else is.
    QCOMPARE(asset->warnings.size(), std::size_t{mode >= 5 ? 0U : mode == 4 ? 1U : 2U});
}

void tst_GltfImport::readsIndicesOfEverySize()
{
    for (int size = 1; size <= 4; size *= 2) {
        GltfBuilder builder = GltfBuilder::triangle();
        primitive(builder)["indices"] =
            size == 1   ? builder.accessor<std::uint8_t>({2, 0, 1}, "SCALAR")
            : size == 2 ? builder.accessor<std::uint16_t>({2, 0, 1}, "SCALAR")
                        : builder.accessor<std::uint32_t>({2, 0, 1}, "SCALAR");
        QCOMPARE(load(builder)->levels.front().indices, (Indices{2, 0, 1}));
    }
    GltfBuilder none = GltfBuilder::triangle();
    primitive(none).erase("indices");
    QCOMPARE(load(none)->levels.front().indices, (Indices{0, 1, 2}));
}

void tst_GltfImport::readsStridesSparseValuesAndMissingViews()
{
    GltfBuilder strided = GltfBuilder::triangle();
    const int view = strided.view<float>({9, 0, 0, 0, 9, 1, 0, 0, 9, 0, 1, 0});
    strided.root["bufferViews"][static_cast<std::size_t>(view)]["byteStride"] = 16;
    const int positions = strided.accessorOf(view, 5126, 3, "VEC3");
    strided.root["accessors"][static_cast<std::size_t>(positions)]["byteOffset"] = 4;
    primitive(strided)["attributes"]["POSITION"] = positions;
    const std::vector<glm::vec3> expected{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    QCOMPARE(load(strided)->levels.front().positions, expected);

    GltfBuilder sparse = GltfBuilder::triangle();
    const int zeros = sparse.accessorOf(-1, 5126, 3, "VEC3");
    const int at = sparse.view<std::uint16_t>({1, 2});
    const int values = sparse.view<float>({1, 0, 0, 0, 1, 0});
    sparse.root["accessors"][static_cast<std::size_t>(zeros)]["sparse"] = {
        {"count", 2},
        {"indices", {{"bufferView", at}, {"componentType", 5123}}},
        {"values", {{"bufferView", values}}}};
    primitive(sparse)["attributes"]["POSITION"] = zeros;
    QCOMPARE(load(sparse)->levels.front().positions, expected);
}

void tst_GltfImport::readsNormalisedIntegers()
{
    GltfBuilder builder = GltfBuilder::triangle();
    builder.root["extensionsUsed"] = {"KHR_mesh_quantization"};
    builder.root["extensionsRequired"] = {"KHR_mesh_quantization"};
    Json& attributes = primitive(builder)["attributes"];
    const auto add = [&](const char* name, int accessor) {
        builder.root["accessors"][static_cast<std::size_t>(accessor)]["normalized"] = true;
        attributes[name] = accessor;
    };
    add("POSITION", builder.accessor<std::int16_t>({0, 0, 0, 32767, 0, 0, 0, -32768, 0}, "VEC3"));
    add("TEXCOORD_0", builder.accessor<std::uint8_t>({0, 255, 51, 0, 0, 102}, "VEC2"));
    add("COLOR_0",
        builder.accessor<std::uint16_t>({65535, 0, 0, 0, 65535, 0, 0, 0, 65535}, "VEC3"));
    const TemplatePtr asset = load(builder);
    const Mesh& mesh = asset->levels.front();
    QCOMPARE(mesh.positions[1], glm::vec3(1, 0, 0));
    QCOMPARE(mesh.positions[2], glm::vec3(0, -1, 0));
    QVERIFY(glm::length(mesh.uv[1] - glm::vec2(0.2F, 0.0F)) < 1e-6F);
    QCOMPARE(mesh.colors[0], glm::u8vec4(255, 0, 0, 255));
}

void tst_GltfImport::unpacksMeshoptCompression()
{
    const std::vector<float> positions{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};
    const Indices indices{0, 1, 2, 2, 1, 3};
    std::vector<std::uint8_t> vertexData(meshopt_encodeVertexBufferBound(4, 12));
    vertexData.resize(
        meshopt_encodeVertexBuffer(vertexData.data(), vertexData.size(), positions.data(), 4, 12));
    std::vector<std::uint8_t> indexData(meshopt_encodeIndexBufferBound(6, 4));
    indexData.resize(
        meshopt_encodeIndexBuffer(indexData.data(), indexData.size(), indices.data(), 6));
    GltfBuilder builder = GltfBuilder::triangle();
    builder.root["extensionsRequired"] = {"EXT_meshopt_compression"};
    const auto compressed = [&](const std::vector<std::uint8_t>& data, int count, int stride,
                                const char* mode) {
        const int view = builder.view(data);
        Json& json = builder.root["bufferViews"][static_cast<std::size_t>(view)];
        Json extension = json;
        extension["count"] = count;
        extension["byteStride"] = stride;
        extension["mode"] = mode;
        json = {{"buffer", 1},
                {"byteLength", count * stride},
                {"extensions", {{"EXT_meshopt_compression", extension}}}};
        return view;
    };
    const int vertexView = compressed(vertexData, 4, 12, "ATTRIBUTES");
    primitive(builder)["attributes"]["POSITION"] = builder.accessorOf(vertexView, 5126, 4, "VEC3");
    const int indexView = compressed(indexData, 6, 4, "TRIANGLES");
    primitive(builder)["indices"] = builder.accessorOf(indexView, 5125, 6, "SCALAR");
    const Json fallback = {{"EXT_meshopt_compression", {{"fallback", true}}}};
    builder.root["buffers"] = {{{"byteLength", builder.bytes.size()}},
                               {{"byteLength", 72}, {"extensions", fallback}}};
    const TemplatePtr asset = load(builder);
    const Mesh& mesh = asset->levels.front();
    QCOMPARE(mesh.positions.size(), std::size_t{4});
    QCOMPARE(mesh.positions[3], glm::vec3(1, 1, 0));
    QCOMPARE(mesh.indices.size(), std::size_t{6});
}

void tst_GltfImport::shadesFlatWhereNormalsAreMissing()
{
    // A roof: two triangles that share an edge and look different ways.
    GltfBuilder builder = GltfBuilder::triangle();
    primitive(builder)["attributes"]["POSITION"] =
        builder.accessor<float>({0, 0, 1, 0, 1, 0, 1, 0, 1, 0, 0, -1}, "VEC3");
    primitive(builder)["indices"] = builder.accessor<std::uint16_t>({0, 2, 1, 3, 0, 1}, "SCALAR");
    const TemplatePtr asset = load(builder);
    const Mesh& mesh = asset->levels.front();
    QCOMPARE(mesh.fileVertexCount, std::size_t{4});
    QCOMPARE(mesh.positions.size(), std::size_t{6});
    for (std::size_t i = 0; i < 6; i += 3) {
        const glm::vec3 a = mesh.positions[mesh.indices[i]];
        const glm::vec3 normal = glm::normalize(glm::cross(
            mesh.positions[mesh.indices[i + 1]] - a, mesh.positions[mesh.indices[i + 2]] - a));
        for (std::size_t corner = i; corner < i + 3; ++corner) {
            QVERIFY(near(mesh.normals[mesh.indices[corner]], normal));
        }
    }
    QCOMPARE(mesh.positions[4], mesh.positions[mesh.indices[4]]);
    QCOMPARE(mesh.bones.size(), std::size_t{6});
}

void tst_GltfImport::turnsMirroredTrianglesOver()
{
    GltfBuilder builder = GltfBuilder::triangle();
    builder.root["nodes"][0]["scale"] = {-1, 1, 1};
    const TemplatePtr asset = load(builder);
    const std::vector<glm::vec3> p = posed(*asset, -1, 0.0F);
    const Indices& i = asset->levels.front().indices;
    QVERIFY(glm::cross(p[i[1]] - p[i[0]], p[i[2]] - p[i[0]]).z > 0.0F);
    QVERIFY(near(p[1], {-1, 0, 0}));
    const Result<StagePtr> stage = importStage(save(builder));
    QVERIFY(stage.isOk());
    QVERIFY(near(stage.value()->meshes.front().normals.front(), {0, 0, 1}));
}

void tst_GltfImport::skinsWithWeightsOfSumOne()
{
    GltfBuilder builder = skinned();
    animate(builder, {{"name", "nod"}}, 2, "translation", {0, 1}, {0, 1, 0, 0, 5, 0});
    const TemplatePtr asset = load(builder);
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

void tst_GltfImport::readsEightInfluences()
{
    GltfBuilder builder = skinned();
    Json& attributes = primitive(builder)["attributes"];
    attributes["JOINTS_1"] =
        builder.accessor<std::uint16_t>({1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, "VEC4");
    attributes["WEIGHTS_1"] = builder.accessor<float>({1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, "VEC4");
    const TemplatePtr asset = load(builder);
    QCOMPARE(asset->levels.front().influencesPerVertex, 8);
    QVERIFY(near(posed(*asset, -1, 0.0F)[0], {0, 0.5F, 0}));
}

void tst_GltfImport::sharesBonesBetweenSkins()
{
    GltfBuilder builder = skinned();
    builder.add("skins", {{"joints", {2, 1}}});
    builder.add("nodes", {{"mesh", 0}, {"skin", 1}});
    builder.root["scenes"][0]["nodes"] = {0, 1, 3};
    const TemplatePtr asset = load(builder);
    QCOMPARE(asset->bones.size(), std::size_t{2});
    QCOMPARE(asset->jointCount, 2);
    const std::vector<glm::vec3> p = posed(*asset, -1, 0.0F);
    QCOMPARE(p.size(), std::size_t{6});
    QVERIFY(near(p[0], {0, 0, 0}) && near(p[3], {0, 1, 0}));
}

void tst_GltfImport::makesPartsOfWhatHangsOnJoints()
{
    GltfBuilder builder = skinned();
    const Json attributes = {{"POSITION", primitive(builder)["attributes"]["POSITION"]}};
    builder.add("meshes", {{"name", "Hut"}, {"primitives", {{{"attributes", attributes}}}}});
    builder.add("nodes", {{"mesh", 1}, {"name", "hat"}, {"translation", {0, 0.5, 0}}});
    builder.root["nodes"][2]["children"] = {3};
    const TemplatePtr asset = load(builder);
    QCOMPARE(asset->parts.size(), std::size_t{1});
    QCOMPARE(asset->parts[0].name, std::string("hat"));
    QVERIFY(asset->parts[0].shownByDefault);
    const Mesh& mesh = asset->levels.front();
    QCOMPARE(mesh.submeshes.size(), std::size_t{2});
    QCOMPARE(mesh.submeshes[0].part, -1);
    QCOMPARE(mesh.submeshes[1].part, 0);
    QVERIFY(near(posed(*asset, -1, 0.0F)[3], {0, 1.5F, 0}));
}

void tst_GltfImport::findsLevelsByExtension()
{
    GltfBuilder builder = skinned();
    const int small = builder.accessor<float>({0, 0, 0, 2, 0, 0, 0, 2, 0}, "VEC3");
    Json attributes = primitive(builder)["attributes"];
    attributes["POSITION"] = small;
    builder.add("meshes", {{"primitives", {{{"attributes", attributes}}}}});
    builder.add("nodes", {{"mesh", 1}, {"skin", 0}});
    builder.root["nodes"][0]["extensions"] = {{"MSFT_lod", {{"ids", {3}}}}};
    builder.add("nodes", {{"mesh", 0}, {"name", "without levels"}});
    builder.root["scenes"][0]["nodes"] = {0, 1, 4};
    const TemplatePtr asset = load(builder);
    QCOMPARE(asset->levels.size(), std::size_t{2});
    QCOMPARE(asset->levels[0].triangleCount(), std::size_t{2});
    QCOMPARE(asset->levels[1].triangleCount(), std::size_t{2});
    QCOMPARE(asset->levels[0].positions[1], glm::vec3(1, 0, 0));
    QCOMPARE(asset->levels[1].positions[1], glm::vec3(2, 0, 0));
    QCOMPARE(asset->levels[1].positions[4], glm::vec3(1, 0, 0));
}

void tst_GltfImport::findsLevelsByName()
{
    GltfBuilder builder = GltfBuilder::triangle();
    builder.root["nodes"] = {{{"mesh", 0}, {"name", "Body_LOD1"}, {"translation", {1, 0, 0}}},
                             {{"mesh", 0}, {"name", "Body_LOD0"}},
                             {{"mesh", 0}, {"name", "Body_lod2.001"}, {"translation", {2, 0, 0}}},
                             {{"mesh", 0}, {"name", "Hat_LOD0"}, {"translation", {0, 7, 0}}}};
    builder.root["scenes"][0]["nodes"] = {0, 1, 2, 3};
    const TemplatePtr asset = load(builder);
    QCOMPARE(asset->levels.size(), std::size_t{3});
    for (std::size_t level = 0; level < 3; ++level) {
        const std::vector<glm::vec3> p = posed(*asset, -1, 0.0F, level);
        QCOMPARE(p.size(), std::size_t{6});
        QVERIFY(near(p[0], {static_cast<float>(level), 0, 0}));
        QVERIFY(near(p[3], {0, 7, 0}));
    }
}

void tst_GltfImport::makesSlotsOfMaterials()
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
    const TemplatePtr asset = load(builder);
    std::vector<std::string> names;
    for (const Slot& slot : asset->slots) {
        names.push_back(slot.name);
    }
    QCOMPARE(names, (std::vector<std::string>{"top", "skin", "face", "face 2", "default"}));
    QVERIFY(asset->slots[0].tintable && !asset->slots[1].tintable);
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

void tst_GltfImport::offersVariantsAsChoices()
{
    GltfBuilder builder = GltfBuilder::triangle();
    builder.root["extensions"] = {
        {"KHR_materials_variants", {{"variants", {{{"name", "day"}}, {{"name", "night"}}}}}}};
    builder.root["materials"] = {{{"name", "a"}}, {{"name", "b"}, {"doubleSided", true}}};
    primitive(builder)["material"] = 0;
    primitive(builder)["extensions"] = {
        {"KHR_materials_variants", {{"mappings", {{{"material", 1}, {"variants", {1}}}}}}}};
    const TemplatePtr asset = load(builder);
    QCOMPARE(asset->slots.size(), std::size_t{1});
    QCOMPARE(asset->slots[0].choices.size(), std::size_t{2});
    QCOMPARE(asset->slots[0].choices[1].name, std::string("night"));
    QVERIFY(asset->slots[0].choices[1].doubleSided && !asset->slots[0].choices[0].doubleSided);
}

void tst_GltfImport::readsTexturesWithTheirTransform()
{
    QImage picture(2, 1, QImage::Format_RGBA8888);
    picture.setPixelColor(0, 0, QColor(10, 20, 30, 40));
    picture.setPixelColor(1, 0, QColor(255, 0, 0));
    QByteArray png;
    QBuffer buffer(&png);
    QVERIFY(picture.save(&buffer, "PNG"));
    GltfBuilder builder = GltfBuilder::triangle();
    const int view = builder.view(std::vector<std::uint8_t>(png.begin(), png.end()));
    builder.add("images", {{"bufferView", view}, {"mimeType", "image/png"}});
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
    const TemplatePtr asset = load(builder);
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

void tst_GltfImport::readsClipsWithTheirExtras()
{
    GltfBuilder builder = skinned();
    animate(builder, {{"name", "wave"}, {"extras", {{"loop", false}}}}, 2, "rotation", {0.5F, 2},
            {0, 0, 0, 2, 0, 0, 0, 1});
    animate(builder, {{"name", "sit"}, {"extras", {{"seatHeight", 0.45}}}}, 2, "scale", {0},
            {1, 1, 1});
    animate(builder, {{"name", "ride"}, {"extras", {{"speed", 6.5}}}}, 2, "scale", {0, 1},
            {1, 1, 1, 1, 1, 1});
    const TemplatePtr asset = load(builder);
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

void tst_GltfImport::namesClipsApart()
{
    GltfBuilder builder = skinned();
    for (const char* name : {"Walk", "Walk", "", "Walk"}) {
        animate(builder, {{"name", name}}, 2, "scale", {0}, {1, 1, 1});
    }
    const TemplatePtr asset = load(builder);
    std::vector<std::string> names;
    for (const Clip& clip : asset->clips) {
        names.push_back(clip.name);
    }
    QCOMPARE(names, (std::vector<std::string>{"Walk", "Walk 2", "animation_2", "Walk 3"}));
}

void tst_GltfImport::animatesNodesThatHaveMatrices()
{
    GltfBuilder builder = GltfBuilder::triangle();
    // Twice as large, turned a quarter about Z, at x = 3.
    builder.root["nodes"][0]["matrix"] = {0, 2, 0, 0, -2, 0, 0, 0, 0, 0, 2, 0, 3, 0, 0, 1};
    animate(builder, {{"name", "up"}}, 0, "translation", {0, 1}, {3, 0, 0, 3, 1, 0});
    const TemplatePtr asset = load(builder);
    QVERIFY(near(posed(*asset, 0, 0.0F)[1], {3, 2, 0}));
    QVERIFY(near(posed(*asset, 0, 1.0F)[2], {1, 1, 0}));
}

void tst_GltfImport::takesRootMotionOut()
{
    GltfBuilder builder = skinned();
    animate(builder, {{"name", "walk"}}, 1, "translation", {0, 2}, {0, 0, 0, 0, 0.1F, 3});
    const TemplatePtr asset = load(builder);
    QCOMPARE(asset->clips[0].speed, 1.5F);
    QVERIFY(near(asset->clips[0].rootMotion, {0, 0, 3}));
    QVERIFY(near(posed(*asset, 0, 2.0F)[0], {0, 0.1F, 0}));
    ImportSettings settings;
    settings.removeRootMotion = false;
    settings.scale = 0.5F;
    const TemplatePtr kept = load(builder, settings);
    QCOMPARE(kept->clips[0].speed, 0.75F);
    QVERIFY(near(posed(*kept, 0, 2.0F)[0], {0, 0.05F, 1.5F}));
}

void tst_GltfImport::keepsFallsAsTheyAre()
{
    GltfBuilder builder = skinned();
    // The head comes forward and down, the hips stay.
    animate(builder, {{"name", "fall"}}, 2, "translation", {0, 1}, {0, 1, 0, 0, 0, 1});
    const TemplatePtr asset = load(builder);
    QCOMPARE(asset->clips[0].speed, 0.0F);
    QCOMPARE(asset->clips[0].rootMotionNode, -1);
}

void tst_GltfImport::choosesAStandingClip()
{
    GltfBuilder builder = skinned();
    for (const char* name : {"T-Pose", "RESET", "run", "Sit_Idle", "Rig|Idle", "idle_happy"}) {
        animate(builder, {{"name", name}}, 2, "scale", {0, 1}, {1, 1, 1, 1, 1, 1});
    }
    QCOMPARE(load(builder)->defaultClip, 4);
    builder.root["animations"].erase(4);
    QCOMPARE(load(builder)->defaultClip, 4);
    builder.root["animations"].erase(4);
    QCOMPARE(load(builder)->defaultClip, 3);
    builder.root["animations"].erase(3);
    QCOMPARE(load(builder)->defaultClip, 2);
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
    QCOMPARE(load(builder)->bounds.low.y, 5.0F);
    builder.root.erase("scene");
    QCOMPARE(load(builder)->bounds.low.y, 0.0F);
    builder.root.erase("scenes");
    QCOMPARE(load(builder)->levels.front().triangleCount(), std::size_t{2});
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
    const Result<StagePtr> imported = importStage(save(builder));
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
    const TemplatePtr asset = load(GltfBuilder::triangle(), settings);
    const std::vector<glm::vec3> p = posed(*asset, 0, 0.0F);
    QVERIFY(near(p[1], {0, 5, 0}));
    QVERIFY(near(p[2], {-2, 3, 0}));
    QVERIFY(std::abs(asset->height - 2.0F) < 1e-5F);
}

void tst_GltfImport::canBeCancelled()
{
    const std::string path = save(GltfBuilder::triangle());
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

CROWD_TEST(tst_GltfImport)
#include "tst_GltfImport.moc"
