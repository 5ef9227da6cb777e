// SPDX-License-Identifier: MIT
#include <cmath>

#include <QtTest/QTest>

#include "model/gltf/GltfImport.h"
#include "tests/model/GltfFolder.h"
#include "tests/model/GltfSamples.h"
#include "tests/program/Test.h"

using namespace crowd::model;
using namespace gltf_samples;

/// What the specification of glTF 2.0 says of accessors, meshes and nodes, with the geometry that
/// is to come of it.
class tst_GltfSpecMeshes : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void interleavesAttributes();
    void readsSparseValuesOverDenseOnes();
    void readsSparseIndices();
    void readsQuantisedMeshes();
    void readsVertexColoursOfEveryKind();
    void readsTheSetOfCoordinatesThatTheTextureNames();
    void skipsPointsAndLines();
    void keepsMorphsAtTheirRestingWeights();
    void readsMorphsThatAreSparse();
    void readsScenesOfEveryShape_data();
    void readsScenesOfEveryShape();
    void readsFilesThatDrawNothing_data();
    void readsFilesThatDrawNothing();
    void ignoresCamerasAndLights();
    void drawsAMeshForEachOfItsNodes();
    void drawsAMeshForEachInstance();
    void shearsUnderScaledParents();
    void turnsOverOnlyWhatIsMirroredOddly();
    void readsNodesAsMatrices();
    void readsDeepTrees();
    void toleratesExtrasOfEveryKind();

private:
    GltfFolder m_folder;
};

namespace {

const std::vector<glm::vec3> kTriangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

Json& accessorAt(GltfBuilder& builder, int index)
{
    return builder.root["accessors"][static_cast<std::size_t>(index)];
}

Json sparse(int count, int indexView, int indexType, int valueView)
{
    return {{"count", count},
            {"indices", {{"bufferView", indexView}, {"componentType", indexType}}},
            {"values", {{"bufferView", valueView}}}};
}

} // namespace

void tst_GltfSpecMeshes::interleavesAttributes()
{
    GltfBuilder builder = GltfBuilder::triangle();
    // Position, normal, coordinates, with eight bytes before the first and four between.
    const int view = builder.view<float>({7, 7, 0, 0, 0,     0, 0, 1, 0.5F, 0.25F, 9, 1, 0, 0,
                                          0, 0, 1, 0, 0.75F, 9, 0, 1, 0,    0,     0, 1, 1, 1});
    builder.root["bufferViews"][static_cast<std::size_t>(view)]["byteStride"] = 36;
    Json& attributes = primitive(builder)["attributes"];
    std::size_t offset = 8;
    for (const char* name : {"POSITION", "NORMAL", "TEXCOORD_0"}) {
        const bool isUv = std::string(name) == "TEXCOORD_0";
        const int accessor = builder.accessorOf(view, 5126, 3, isUv ? "VEC2" : "VEC3");
        accessorAt(builder, accessor)["byteOffset"] = offset;
        attributes[name] = accessor;
        offset += 12;
    }
    const Mesh mesh = m_folder.load(builder)->levels.front();
    QCOMPARE(mesh.positions, kTriangle);
    QCOMPARE(mesh.normals, std::vector<glm::vec3>(3, glm::vec3(0, 0, 1)));
    QCOMPARE(mesh.uv, (std::vector<glm::vec2>{{0.5F, 0.25F}, {0, 0.75F}, {1, 1}}));
}

void tst_GltfSpecMeshes::readsSparseValuesOverDenseOnes()
{
    for (const int type : {5121, 5123, 5125}) {
        GltfBuilder builder = GltfBuilder::triangle();
        const int at = type == 5121   ? builder.view<std::uint8_t>({0, 2})
                       : type == 5123 ? builder.view<std::uint16_t>({0, 2})
                                      : builder.view<std::uint32_t>({0, 2});
        const int values = builder.view<float>({9, 9, 9, 8, 8, 8});
        Json& positions = accessorAt(builder, primitive(builder)["attributes"]["POSITION"]);
        positions["sparse"] = sparse(2, at, type, values);
        const Mesh mesh = m_folder.load(builder)->levels.front();
        QCOMPARE(mesh.positions, (std::vector<glm::vec3>{{9, 9, 9}, {1, 0, 0}, {8, 8, 8}}));
    }
}

void tst_GltfSpecMeshes::readsSparseIndices()
{
    GltfBuilder builder = GltfBuilder::triangle();
    const int at = builder.view<std::uint8_t>({0, 1});
    const int values = builder.view<std::uint16_t>({1, 2});
    accessorAt(builder, primitive(builder)["indices"])["sparse"] = sparse(2, at, 5121, values);
    QCOMPARE(m_folder.load(builder)->levels.front().indices, (std::vector<std::uint32_t>{1, 2, 2}));
}

void tst_GltfSpecMeshes::readsQuantisedMeshes()
{
    GltfBuilder builder = skinned();
    builder.root["extensionsRequired"] = {"KHR_mesh_quantization"};
    Json& attributes = primitive(builder)["attributes"];
    // Whole numbers as they are; rows padded to four bytes, as the extension asks.
    const int places = builder.view<std::uint16_t>({0, 0, 0, 0, 200, 0, 0, 0, 0, 100, 0, 0});
    const int normals = builder.view<std::int8_t>({0, 0, 127, 0, 0, -127, 0, 0, -128, 0, 0, 0});
    builder.root["bufferViews"][static_cast<std::size_t>(places)]["byteStride"] = 8;
    builder.root["bufferViews"][static_cast<std::size_t>(normals)]["byteStride"] = 4;
    attributes["POSITION"] = builder.accessorOf(places, 5123, 3, "VEC3");
    attributes["NORMAL"] = builder.accessorOf(normals, 5120, 3, "VEC3");
    accessorAt(builder, attributes["NORMAL"])["normalized"] = true;
    attributes["TEXCOORD_0"] = builder.accessor<std::int16_t>({-3, 4, 5, 6, 7, 8}, "VEC2");
    attributes["WEIGHTS_0"] =
        builder.accessor<std::uint8_t>({255, 0, 0, 0, 255, 0, 0, 0, 51, 204, 0, 0}, "VEC4");
    accessorAt(builder, attributes["WEIGHTS_0"])["normalized"] = true;
    const TemplatePtr asset = m_folder.load(builder);
    const Mesh& mesh = asset->levels.front();
    QCOMPARE(mesh.positions, (std::vector<glm::vec3>{{0, 0, 0}, {200, 0, 0}, {0, 100, 0}}));
    QCOMPARE(mesh.normals, (std::vector<glm::vec3>{{0, 0, 1}, {0, -1, 0}, {-1, 0, 0}}));
    QCOMPARE(mesh.uv, (std::vector<glm::vec2>{{-3, 4}, {5, 6}, {7, 8}}));
    QVERIFY(near(posed(*asset, -1, 0.0F)[2], {0, 100.8F, 0}));
}

void tst_GltfSpecMeshes::readsVertexColoursOfEveryKind()
{
    GltfBuilder builder = GltfBuilder::triangle();
    Json& color = primitive(builder)["attributes"]["COLOR_0"];
    color = builder.accessor<float>({1, 0.5F, 0, 0.25F, 2, -1, 0, 1, 0, 0, 0, 0}, "VEC4");
    QCOMPARE(m_folder.load(builder)->levels.front().colors,
             (std::vector<glm::u8vec4>{{255, 128, 0, 64}, {255, 0, 0, 255}, {0, 0, 0, 0}}));
    color = builder.accessor<std::uint8_t>({1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}, "VEC4");
    accessorAt(builder, color)["normalized"] = true;
    QCOMPARE(m_folder.load(builder)->levels.front().colors,
             (std::vector<glm::u8vec4>{{1, 2, 3, 4}, {5, 6, 7, 8}, {9, 10, 11, 12}}));
}

void tst_GltfSpecMeshes::readsTheSetOfCoordinatesThatTheTextureNames()
{
    GltfBuilder builder = GltfBuilder::triangle();
    builder.add("textures", Json::object());
    builder.add("materials", {{"pbrMetallicRoughness",
                               {{"baseColorTexture", {{"index", 0}, {"texCoord", 2}}}}}});
    primitive(builder)["material"] = 0;
    Json& attributes = primitive(builder)["attributes"];
    attributes["TEXCOORD_0"] = builder.accessor<float>({9, 9, 9, 9, 9, 9}, "VEC2");
    attributes["TEXCOORD_1"] = attributes["TEXCOORD_0"];
    attributes["TEXCOORD_2"] = builder.accessor<float>({1, 2, 3, 4, 5, 6}, "VEC2");
    QCOMPARE(m_folder.load(builder)->levels.front().uv,
             (std::vector<glm::vec2>{{1, 2}, {3, 4}, {5, 6}}));
    attributes.erase("TEXCOORD_2");
    QCOMPARE(m_folder.load(builder)->levels.front().uv, std::vector<glm::vec2>(3, glm::vec2(0)));
}

void tst_GltfSpecMeshes::skipsPointsAndLines()
{
    GltfBuilder builder = GltfBuilder::triangle();
    Json& primitives = builder.root["meshes"][0]["primitives"];
    for (const int mode : {0, 1, 2, 3, 5}) {
        Json other = primitives[0];
        other["mode"] = mode;
        primitives.push_back(other);
    }
    primitives.push_back({{"attributes", Json::object()}});
    const TemplatePtr asset = m_folder.load(builder);
    QCOMPARE(asset->levels.front().triangleCount(), std::size_t{2});
    QCOMPARE(asset->slots.size(), std::size_t{1});
    QCOMPARE(asset->warnings.size(), std::size_t{1});
    QVERIFY2(asset->warnings[0].english().starts_with("5 primitives are points or lines"),
             asset->warnings[0].english().c_str());
}

void tst_GltfSpecMeshes::keepsMorphsAtTheirRestingWeights()
{
    GltfBuilder builder = GltfBuilder::triangle();
    primitive(builder)["attributes"]["NORMAL"] =
        builder.accessor<float>({0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
    const int up = builder.accessor<float>({0, 2, 0, 0, 2, 0, 0, 2, 0}, "VEC3");
    const int over = builder.accessor<float>({0, 0, -2, 0, 0, -2, 0, 0, -2}, "VEC3");
    primitive(builder)["targets"] = {{{"POSITION", up}}, {{"NORMAL", over}, {"TANGENT", over}}};
    builder.root["meshes"][0]["weights"] = {0.5, 1.0};
    builder.root["nodes"].push_back({{"mesh", 0}, {"weights", {1.0, 0.0}}});
    builder.root["scenes"][0]["nodes"] = {0, 1};
    const int times = builder.accessor<float>({0, 2}, "SCALAR");
    const int weights = builder.accessor<float>({0, 0, 1, 1}, "SCALAR");
    builder.add("animations",
                {{"name", "smile"},
                 {"samplers", {{{"input", times}, {"output", weights}}}},
                 {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "weights"}}}}}}});
    const TemplatePtr asset = m_folder.load(builder);
    const Mesh& mesh = asset->levels.front();
    QCOMPARE(mesh.positions[1], glm::vec3(1, 1, 0));
    QCOMPARE(mesh.normals[1], glm::vec3(0, 0, -1));
    QCOMPARE(mesh.positions[4], glm::vec3(1, 2, 0));
    QCOMPARE(mesh.normals[4], glm::vec3(0, 0, 1));
    QCOMPARE(asset->clips[0].seconds, 2.0F);
    QVERIFY(asset->clips[0].channels.empty());
    QCOMPARE(asset->warnings.size(), std::size_t{1});
    QVERIFY(asset->warnings[0].english().starts_with("Morph targets are not animated"));
}

void tst_GltfSpecMeshes::readsMorphsThatAreSparse()
{
    GltfBuilder builder = GltfBuilder::triangle();
    const int zeros = builder.accessorOf(-1, 5126, 3, "VEC3");
    const int at = builder.view<std::uint8_t>({1});
    const int values = builder.view<float>({0, 0, 4});
    accessorAt(builder, zeros)["sparse"] = sparse(1, at, 5121, values);
    primitive(builder)["targets"] = {{{"POSITION", zeros}}};
    builder.root["meshes"][0]["weights"] = {0.25};
    QCOMPARE(m_folder.load(builder)->levels.front().positions,
             (std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 1}, {0, 1, 0}}));
}

void tst_GltfSpecMeshes::readsScenesOfEveryShape_data()
{
    QTest::addColumn<QString>("scenes"); ///< members of the file
    QTest::addColumn<int>("triangles");
    QTest::newRow("none: all roots") << QStringLiteral("{}") << 3;
    QTest::newRow("the first") << QStringLiteral(R"({"scenes": [{"nodes": [0]}, {"nodes": [1]}]})")
                               << 1;
    QTest::newRow("the one named")
        << QStringLiteral(R"({"scene": 1, "scenes": [{"nodes": [0]}, {"nodes": [1]}]})") << 2;
    QTest::newRow("without nodes") << QStringLiteral(R"({"scene": 0, "scenes": [{}]})") << 0;
    QTest::newRow("with a name alone") << QStringLiteral(R"({"scenes": [{"name": "empty"}]})") << 0;
    QTest::newRow("an inner node") << QStringLiteral(R"({"scenes": [{"nodes": [2]}]})") << 1;
    QTest::newRow("twice the same") << QStringLiteral(R"({"scenes": [{"nodes": [0, 0]}]})") << 1;
}

void tst_GltfSpecMeshes::readsScenesOfEveryShape()
{
    QFETCH(const QString, scenes);
    QFETCH(const int, triangles);
    GltfBuilder builder = GltfBuilder::triangle();
    builder.root["nodes"] = {{{"mesh", 0}}, {{"mesh", 0}, {"children", {2}}}, {{"mesh", 0}}};
    builder.root.erase("scene");
    builder.root.erase("scenes");
    builder.root.update(Json::parse(scenes.toStdString()));
    if (triangles == 0) {
        QVERIFY(!importTemplate(m_folder.save(builder)).isOk()); // nobody would see it
    } else {
        QCOMPARE(m_folder.load(builder)->levels.front().triangleCount(),
                 static_cast<std::size_t>(triangles));
    }
    const Result<StagePtr> stage = importStage(m_folder.save(builder));
    QVERIFY2(stage.isOk(), stage ? "" : stage.error().message.c_str());
    QCOMPARE(stage.value()->triangleCount(), static_cast<std::size_t>(triangles));
}

void tst_GltfSpecMeshes::readsFilesThatDrawNothing_data()
{
    QTest::addColumn<QString>("file");
    const QString asset = QStringLiteral(R"({"asset": {"version": "2.0"})");
    QTest::newRow("nothing at all") << asset + u'}';
    QTest::newRow("a later minor version") << QStringLiteral(R"({"asset": {"version": "2.7"}})");
    QTest::newRow("only nodes") << asset + QStringLiteral(R"(, "nodes": [{"name": "a"}]})");
    QTest::newRow("only a camera")
        << asset + QStringLiteral(R"(, "nodes": [{"camera": 0}], "cameras":
            [{"type": "perspective", "perspective": {"yfov": 1, "znear": 0.1}}]})");
    QTest::newRow("only a material") << asset + QStringLiteral(R"(, "materials": [{}]})");
    QTest::newRow("only lists without items")
        << asset + QStringLiteral(R"(, "nodes": [], "meshes": [], "scenes": []})");
}

void tst_GltfSpecMeshes::readsFilesThatDrawNothing()
{
    QFETCH(const QString, file);
    const std::string path =
        writeFile(m_folder.filePath(QStringLiteral("empty.gltf")), file.toUtf8());
    const Result<TemplatePtr> asset = importTemplate(path);
    QVERIFY(!asset.isOk());
    QVERIFY(asset.error().message.find("export the file again") != std::string::npos);
    const Result<StagePtr> stage = importStage(path);
    QVERIFY2(stage.isOk(), stage ? "" : stage.error().message.c_str());
    QVERIFY(!stage.value()->warnings.empty());
}

void tst_GltfSpecMeshes::ignoresCamerasAndLights()
{
    GltfBuilder builder = GltfBuilder::triangle();
    builder.root["extensionsRequired"] = {"KHR_lights_punctual"};
    builder.root["extensions"] = {
        {"KHR_lights_punctual",
         {{"lights", {{{"type", "spot"}, {"spot", Json::object()}}, {{"type", "point"}}}}}}};
    builder.root["cameras"] = {
        {{"type", "orthographic"},
         {"orthographic", {{"xmag", 1}, {"ymag", 1}, {"zfar", 9}, {"znear", 0}}}}};
    builder.root["nodes"][0]["camera"] = 0;
    builder.add("nodes", {{"extensions", {{"KHR_lights_punctual", {{"light", 1}}}}}});
    builder.root["scenes"][0]["nodes"] = {0, 1};
    builder.root["scenes"][0]["extensions"] = {{"KHR_xmp_json_ld", {{"packet", 0}}}};
    const TemplatePtr asset = m_folder.load(builder);
    QCOMPARE(asset->levels.front().triangleCount(), std::size_t{1});
    QVERIFY(asset->warnings.empty());
}

void tst_GltfSpecMeshes::drawsAMeshForEachOfItsNodes()
{
    GltfBuilder builder = GltfBuilder::triangle();
    builder.root["nodes"] = {{{"mesh", 0}, {"children", {1}}, {"translation", {1, 0, 0}}},
                             {{"mesh", 0}, {"translation", {1, 0, 0}}},
                             {{"mesh", 0}, {"scale", {2, 2, 2}}}};
    builder.root["scenes"][0]["nodes"] = {0, 2};
    const TemplatePtr asset = m_folder.load(builder);
    const std::vector<glm::vec3> p = posed(*asset, -1, 0.0F);
    QCOMPARE(p.size(), std::size_t{9});
    QVERIFY(near(p[0], {1, 0, 0}) && near(p[3], {2, 0, 0}) && near(p[7], {2, 0, 0}));
    QCOMPARE(asset->slots.size(), std::size_t{1});
    QCOMPARE(asset->jointCount, 0);
}

void tst_GltfSpecMeshes::drawsAMeshForEachInstance()
{
    GltfBuilder builder = GltfBuilder::triangle();
    builder.root["extensionsRequired"] = {"EXT_mesh_gpu_instancing"};
    builder.root["nodes"][0]["translation"] = {0, 10, 0};
    const int places = builder.accessor<float>({0, 0, 0, 5, 0, 0}, "VEC3");
    const int sizes = builder.accessor<float>({1, 1, 1, 2, 1, 1}, "VEC3");
    const int turns = builder.accessor<std::int8_t>({0, 0, 0, 127, 0, 0, 127, 0}, "VEC4");
    accessorAt(builder, turns)["normalized"] = true;
    Json& extension = builder.root["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"];
    extension["attributes"] = {{"TRANSLATION", places}, {"SCALE", sizes}, {"ROTATION", turns}};
    const TemplatePtr asset = m_folder.load(builder);
    const std::vector<glm::vec3> p = posed(*asset, -1, 0.0F);
    QCOMPARE(p.size(), std::size_t{6});
    QVERIFY(near(p[1], {1, 10, 0}));
    QVERIFY(near(p[4], {3, 10, 0})); // half a turn about Z, twice as long
    QVERIFY(near(p[5], {5, 9, 0}));
    for (const Json& wrong : {Json(99), Json("x"), Json(places + 100), Json(0.5)}) {
        extension["attributes"]["TRANSLATION"] = wrong;
        const Result<TemplatePtr> refused = importTemplate(m_folder.save(builder));
        QVERIFY(!refused.isOk());
        QVERIFY2(refused.error().message.find("nodes[0].extensions.EXT_mesh_gpu_instancing") !=
                     std::string::npos,
                 refused.error().message.c_str());
    }
}

void tst_GltfSpecMeshes::shearsUnderScaledParents()
{
    GltfBuilder builder = GltfBuilder::triangle();
    const float half = std::sqrt(0.5F);
    primitive(builder)["attributes"]["NORMAL"] =
        builder.accessor<float>({half, half, 0, half, half, 0, 0, 0, 1}, "VEC3");
    // An eighth turn about Z below a parent that is four times as wide as it is high.
    const double angle = std::atan(1.0) / 2.0;
    builder.root["nodes"] = {{{"scale", {4, 1, 1}}, {"children", {1}}},
                             {{"mesh", 0}, {"rotation", {0, 0, std::sin(angle), std::cos(angle)}}}};
    const TemplatePtr asset = m_folder.load(builder);
    Pose pose;
    evaluatePose(*asset, -1, 0.0F, pose);
    std::vector<glm::vec3> p(3);
    std::vector<glm::vec3> n(3);
    skin(asset->levels.front(), pose.bones, p, n);
    QVERIFY(near(p[1], {4 * half, half, 0}));
    QVERIFY(near(p[2], {-4 * half, half, 0}));
    // The normal turned to +Y stays there: the plane is stretched along itself.
    QVERIFY(near(n[0], {0, 1, 0}));
    QVERIFY(near(n[2], {0, 0, 1}));
}

void tst_GltfSpecMeshes::turnsOverOnlyWhatIsMirroredOddly()
{
    struct Row
    {
        glm::vec3 parent;
        glm::vec3 own;
    };
    for (const Row& row : {Row{{-1, 1, 1}, {1, 1, 1}}, Row{{-1, 1, 1}, {1, -2, 1}},
                           Row{{-1, -1, -1}, {1, 1, 1}}, Row{{1, 1, 1}, {3, 1, 0.5F}}}) {
        GltfBuilder builder = GltfBuilder::triangle();
        builder.root["nodes"] = {
            {{"scale", {row.parent.x, row.parent.y, row.parent.z}}, {"children", {1}}},
            {{"mesh", 0}, {"scale", {row.own.x, row.own.y, row.own.z}}}};
        const TemplatePtr asset = m_folder.load(builder);
        const Mesh& mesh = asset->levels.front();
        Pose pose;
        evaluatePose(*asset, -1, 0.0F, pose);
        std::vector<glm::vec3> p(3);
        std::vector<glm::vec3> n(3);
        skin(mesh, pose.bones, p, n);
        const std::vector<std::uint32_t>& i = mesh.indices;
        const glm::vec3 across = glm::cross(p[i[1]] - p[i[0]], p[i[2]] - p[i[0]]);
        // The face looks where it did in the file, carried along by the matrix.
        const float z = row.parent.z * row.own.z;
        QVERIFY(across.z * z > 0.0F);
        QVERIFY(glm::dot(across, n[0]) > 0.0F);
    }
}

void tst_GltfSpecMeshes::readsNodesAsMatrices()
{
    GltfBuilder builder = GltfBuilder::triangle();
    builder.root["nodes"] = {
        {{"matrix", {0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 5, 0, 0, 1}}, {"children", {1}}},
        {{"mesh", 0}, {"matrix", {1, 0, 0, 0, 0.5, 1, 0, 0, 0, 0, 1, 0, 0, 2, 0, 1}}}};
    const std::vector<glm::vec3> p = posed(*m_folder.load(builder), -1, 0.0F);
    QVERIFY(near(p[0], {3, 0, 0}));
    QVERIFY(near(p[1], {3, 1, 0}));
    QVERIFY(near(p[2], {2, 0.5F, 0}));
}

void tst_GltfSpecMeshes::readsDeepTrees()
{
    GltfBuilder builder = skinned();
    constexpr int kDepth = 3000;
    // hips, then a chain of a thousandth of a metre each, then the head.
    for (int i = 0; i < kDepth; ++i) {
        builder.add("nodes", {{"translation", {0, 0.001, 0}}, {"children", {i + 4}}});
    }
    builder.root["nodes"].back()["children"] = {2};
    builder.root["nodes"][1]["children"] = {3};
    const std::vector<glm::vec3> p = posed(*m_folder.load(builder), -1, 0.0F);
    QVERIFY(glm::length(p[1] - glm::vec3(1, 4, 0)) < 1e-3F);
}

void tst_GltfSpecMeshes::toleratesExtrasOfEveryKind()
{
    const Json kinds[] = {
        nullptr, true, -3, 0.5, "seats", {1, {2, "x"}}, {{"slot", 7}, {"seats", 1}}};
    for (const Json& extras : kinds) {
        GltfBuilder builder = skinned();
        animate(builder, {{"name", "nod"}}, 2, "scale", {0, 1}, {1, 1, 1, 1, 1, 1});
        builder.add("materials", {{"name", "cloth"}});
        primitive(builder)["material"] = 0;
        for (const char* place :
             {"/extras", "/asset/extras", "/nodes/0/extras", "/meshes/0/extras", "/skins/0/extras",
              "/materials/0/extras", "/animations/0/extras", "/scenes/0/extras",
              "/accessors/0/extras", "/meshes/0/primitives/0/extras", "/bufferViews/0/extras",
              "/animations/0/channels/0/extras", "/animations/0/samplers/0/extras"}) {
            builder.root[Json::json_pointer(place)] = extras;
        }
        const TemplatePtr asset = m_folder.load(builder);
        QCOMPARE(asset->slots[0].name, std::string("cloth"));
        QCOMPARE(asset->clips[0].seconds, 1.0F);
        QVERIFY(importStage(m_folder.save(builder)).isOk());
    }
}

CROWD_TEST(tst_GltfSpecMeshes)
#include "tst_GltfSpecMeshes.moc"
