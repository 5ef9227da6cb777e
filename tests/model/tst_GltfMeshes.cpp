// SPDX-License-Identifier: MIT
#include <cstdint>
#include <vector>

#include <meshoptimizer.h>

#include <QtTest/QTest>

#include "model/gltf/GltfImport.h"
#include "tests/model/GltfFolder.h"
#include "tests/model/GltfSamples.h"
#include "tests/program/Test.h"

using namespace crowd::model;
using namespace gltf_samples;

namespace {

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

class tst_GltfMeshes : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void expandsStripsAndFans_data();
    void expandsStripsAndFans();
    void readsIndicesOfEverySize();
    void readsStridesSparseValuesAndMissingViews();
    void readsNormalisedIntegers();
    void unpacksMeshoptCompression();
    void shadesFlatWhereNormalsAreMissing();
    void turnsMirroredTrianglesOver();
    void findsLevelsByExtension();
    void findsLevelsByName();

private:
    GltfFolder m_folder;
};

void tst_GltfMeshes::expandsStripsAndFans_data()
{
    QTest::addColumn<int>("mode");
    QTest::addColumn<std::vector<std::uint32_t>>("indices");
    QTest::newRow("list, two corners left over") << 4 << Indices{0, 1, 2};
    QTest::newRow("strip") << 5 << Indices{0, 1, 2, 1, 3, 2, 2, 3, 4};
    QTest::newRow("fan") << 6 << Indices{1, 2, 0, 2, 3, 0, 3, 4, 0};
    QTest::newRow("points") << 0 << Indices{};
    QTest::newRow("line strip") << 3 << Indices{};
}

void tst_GltfMeshes::expandsStripsAndFans()
{
    QFETCH(const int, mode);
    QFETCH(const std::vector<std::uint32_t>, indices);
    if (indices.empty()) { // nobody would see points or lines
        const auto refused = importTemplate(m_folder.save(strip(mode)));
        QVERIFY(!refused.isOk());
        QVERIFY(refused.error().message.find("no triangles") != std::string::npos);
        return;
    }
    const TemplatePtr asset = m_folder.load(strip(mode));
    const Mesh& mesh = asset->levels.front();
    QCOMPARE(mesh.indices.size(), indices.size());
    for (std::size_t i = 0; i < indices.size(); ++i) {
        // Flat normals may have made a copy of the vertex.
        QCOMPARE(mesh.positions[mesh.indices[i]], mesh.positions[indices[i]]);
    }
    QCOMPARE(asset->warnings.size(), std::size_t{mode >= 5 ? 0U : 1U});
}

void tst_GltfMeshes::readsIndicesOfEverySize()
{
    for (int size = 1; size <= 4; size *= 2) {
        GltfBuilder builder = GltfBuilder::triangle();
        primitive(builder)["indices"] =
            size == 1   ? builder.accessor<std::uint8_t>({2, 0, 1}, "SCALAR")
            : size == 2 ? builder.accessor<std::uint16_t>({2, 0, 1}, "SCALAR")
                        : builder.accessor<std::uint32_t>({2, 0, 1}, "SCALAR");
        QCOMPARE(m_folder.load(builder)->levels.front().indices, (Indices{2, 0, 1}));
    }
    GltfBuilder none = GltfBuilder::triangle();
    primitive(none).erase("indices");
    QCOMPARE(m_folder.load(none)->levels.front().indices, (Indices{0, 1, 2}));
}

void tst_GltfMeshes::readsStridesSparseValuesAndMissingViews()
{
    GltfBuilder strided = GltfBuilder::triangle();
    const int view = strided.view<float>({9, 0, 0, 0, 9, 1, 0, 0, 9, 0, 1, 0});
    strided.root["bufferViews"][static_cast<std::size_t>(view)]["byteStride"] = 16;
    const int positions = strided.accessorOf(view, 5126, 3, "VEC3");
    strided.root["accessors"][static_cast<std::size_t>(positions)]["byteOffset"] = 4;
    primitive(strided)["attributes"]["POSITION"] = positions;
    const std::vector<glm::vec3> expected{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    QCOMPARE(m_folder.load(strided)->levels.front().positions, expected);

    GltfBuilder sparse = GltfBuilder::triangle();
    const int zeros = sparse.accessorOf(-1, 5126, 3, "VEC3");
    const int at = sparse.view<std::uint16_t>({1, 2});
    const int values = sparse.view<float>({1, 0, 0, 0, 1, 0});
    sparse.root["accessors"][static_cast<std::size_t>(zeros)]["sparse"] = {
        {"count", 2},
        {"indices", {{"bufferView", at}, {"componentType", 5123}}},
        {"values", {{"bufferView", values}}}};
    primitive(sparse)["attributes"]["POSITION"] = zeros;
    QCOMPARE(m_folder.load(sparse)->levels.front().positions, expected);
}

void tst_GltfMeshes::readsNormalisedIntegers()
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
    const TemplatePtr asset = m_folder.load(builder);
    const Mesh& mesh = asset->levels.front();
    QCOMPARE(mesh.positions[1], glm::vec3(1, 0, 0));
    QCOMPARE(mesh.positions[2], glm::vec3(0, -1, 0));
    QVERIFY(glm::length(mesh.uv[1] - glm::vec2(0.2F, 0.0F)) < 1e-6F);
    QCOMPARE(mesh.colors[0], glm::u8vec4(255, 0, 0, 255));
}

void tst_GltfMeshes::unpacksMeshoptCompression()
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
    const TemplatePtr asset = m_folder.load(builder);
    const Mesh& mesh = asset->levels.front();
    QCOMPARE(mesh.positions.size(), std::size_t{4});
    QCOMPARE(mesh.positions[3], glm::vec3(1, 1, 0));
    QCOMPARE(mesh.indices.size(), std::size_t{6});
}

void tst_GltfMeshes::shadesFlatWhereNormalsAreMissing()
{
    // A roof: two triangles that share an edge and look different ways.
    GltfBuilder builder = GltfBuilder::triangle();
    primitive(builder)["attributes"]["POSITION"] =
        builder.accessor<float>({0, 0, 1, 0, 1, 0, 1, 0, 1, 0, 0, -1}, "VEC3");
    primitive(builder)["indices"] = builder.accessor<std::uint16_t>({0, 2, 1, 3, 0, 1}, "SCALAR");
    const TemplatePtr asset = m_folder.load(builder);
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

void tst_GltfMeshes::turnsMirroredTrianglesOver()
{
    GltfBuilder builder = GltfBuilder::triangle();
    builder.root["nodes"][0]["scale"] = {-1, 1, 1};
    const TemplatePtr asset = m_folder.load(builder);
    const std::vector<glm::vec3> p = posed(*asset, -1, 0.0F);
    const Indices& i = asset->levels.front().indices;
    QVERIFY(glm::cross(p[i[1]] - p[i[0]], p[i[2]] - p[i[0]]).z > 0.0F);
    QVERIFY(near(p[1], {-1, 0, 0}));
    const Result<StagePtr> stage = importStage(m_folder.save(builder));
    QVERIFY(stage.isOk());
    QVERIFY(near(stage.value()->meshes.front().normals.front(), {0, 0, 1}));
}

void tst_GltfMeshes::findsLevelsByExtension()
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
    const TemplatePtr asset = m_folder.load(builder);
    QCOMPARE(asset->levels.size(), std::size_t{2});
    QCOMPARE(asset->levels[0].triangleCount(), std::size_t{2});
    QCOMPARE(asset->levels[1].triangleCount(), std::size_t{2});
    QCOMPARE(asset->levels[0].positions[1], glm::vec3(1, 0, 0));
    QCOMPARE(asset->levels[1].positions[1], glm::vec3(2, 0, 0));
    QCOMPARE(asset->levels[1].positions[4], glm::vec3(1, 0, 0));
}

void tst_GltfMeshes::findsLevelsByName()
{
    GltfBuilder builder = GltfBuilder::triangle();
    builder.root["nodes"] = {{{"mesh", 0}, {"name", "Body_LOD1"}, {"translation", {1, 0, 0}}},
                             {{"mesh", 0}, {"name", "Body_LOD0"}},
                             {{"mesh", 0}, {"name", "Body_lod2.001"}, {"translation", {2, 0, 0}}},
                             {{"mesh", 0}, {"name", "Hat_LOD0"}, {"translation", {0, 7, 0}}}};
    builder.root["scenes"][0]["nodes"] = {0, 1, 2, 3};
    const TemplatePtr asset = m_folder.load(builder);
    QCOMPARE(asset->levels.size(), std::size_t{3});
    for (std::size_t level = 0; level < 3; ++level) {
        const std::vector<glm::vec3> p = posed(*asset, -1, 0.0F, level);
        QCOMPARE(p.size(), std::size_t{6});
        QVERIFY(near(p[0], {static_cast<float>(level), 0, 0}));
        QVERIFY(near(p[3], {0, 7, 0}));
    }
}

CROWD_TEST(tst_GltfMeshes)
#include "tst_GltfMeshes.moc"
