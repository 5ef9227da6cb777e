// SPDX-License-Identifier: MIT
#include "model/gltf/GltfImport.h"

#include <cmath>
#include <functional>

#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>

#include "tests/model/GltfBuilder.h"
#include "tests/program/Test.h"

using namespace crowd::model;

namespace {

using Json = GltfBuilder::Json;

struct BadFile
{
    const char* name;
    const char* message; ///< part of what the artist is told
    std::function<QByteArray()> content;
    const char* suffix = ".glb";
};

/// A triangle, bent by the test.
std::function<QByteArray()> bent(std::function<void(GltfBuilder&)> bend)
{
    return [bend = std::move(bend)] {
        GltfBuilder builder = GltfBuilder::triangle();
        bend(builder);
        return builder.glb();
    };
}

/// The same with a member of the JSON replaced.
std::function<QByteArray()> with(const char* pointer, Json value)
{
    return bent([pointer, value](GltfBuilder& builder) {
        builder.root[Json::json_pointer(pointer)] = value;
    });
}

std::function<QByteArray()> text(QByteArray content)
{
    return [content] { return content; };
}

std::string nested(int depth)
{
    return R"({"asset":{"version":"2.0"},"extras":)" +
           std::string(static_cast<std::size_t>(depth), '[') +
           std::string(static_cast<std::size_t>(depth), ']') + "}";
}

QByteArray patched(qsizetype at, char value)
{
    QByteArray glb = GltfBuilder::triangle().glb();
    glb[at] = value;
    return glb;
}

void addAnimation(GltfBuilder& builder, const Json& target)
{
    const int times = builder.accessor<float>({0, 1}, "SCALAR");
    const int values = builder.accessor<float>({0, 0, 0}, "VEC3");
    builder.add("animations", {{"samplers", {{{"input", times}, {"output", values}}}},
                               {"channels", {{{"sampler", 0}, {"target", target}}}}});
}

void addSkin(GltfBuilder& builder, std::uint8_t joint)
{
    const int joints = builder.accessor<std::uint8_t>(std::vector<std::uint8_t>(12, joint), "VEC4");
    const int weights = builder.accessor<float>(std::vector<float>(12, 0.25F), "VEC4");
    Json& attributes = builder.root["meshes"][0]["primitives"][0]["attributes"];
    attributes["JOINTS_0"] = joints;
    attributes["WEIGHTS_0"] = weights;
    builder.add("skins", {{"joints", {0}}});
    builder.root["nodes"][0]["skin"] = 0;
}

std::vector<BadFile> envelopes()
{
    return {
        {"empty", "the file is empty", text("")},
        {"wrong magic", "neither a .glb", text("glTX0000000000000000")},
        {"text", "neither a .glb", text("hello"), ".gltf"},
        {"header only", "ends within the GLB header", text("glTF\x02")},
        {"version 1", "version 1", [] { return patched(4, 1); }},
        {"length past the end", "promises", [] { return patched(10, 9); }},
        {"chunk past the end", "GLB chunk 0 at byte 12", [] { return patched(14, 9); }},
        {"no JSON chunk", "is not the JSON chunk", [] { return patched(16, 'X'); }},
        {"cut in half", "promises",
         [] {
             const QByteArray whole = GltfBuilder::triangle().glb();
             return whole.left(whole.size() / 2);
         }},
        {"broken JSON", "line 1", text("{\"asset\": }"), ".gltf"},
        {"text that does not end", "missing closing quote; last read: '\"ддд",
         text("{\"asset\": \"" + QByteArray("д").repeated(100'000)), ".gltf"},
        {"JSON list", "neither a .glb", text("[]"), ".gltf"},
        {"invalid UTF-8", "JSON cannot be read", text("{\"a\":\"\xff\xfe\"}"), ".gltf"},
        {"nested too deep", "nested more than 64 levels deep at byte",
         [] { return QByteArray::fromStdString(nested(100'000)); }, ".gltf"},
        {"FBX", "Convert it in Blender", text("Kaydara FBX Binary  "), ".fbx"},
        {"OBJ", "File > Export > glTF 2.0", text("v 0 0 0"), ".obj"},
        {"Blender file", "File > Open", text("BLENDER-v304"), ".blend"},
        {"Collada", "Convert it in Blender", text("<?xml"), ".dae"},
        {"USD", "Convert it in Blender", text("PXR-USDC"), ".usd"},
    };
}

std::vector<BadFile> structures()
{
    return {
        {"no version", "asset.version is missing", with("/asset", Json::object())},
        {"glTF 1", "asset.version asks for glTF 1.0", with("/asset/version", "1.0")},
        {"unknown extension", "extensionsRequired[0] demands the extension ACME_x",
         with("/extensionsRequired", {"ACME_x"})},
        {"array is a number", "nodes is not a list", with("/nodes", 3)},
        {"item is a number", "meshes[0] is not an object", with("/meshes/0", 3)},
        {"mesh out of range", "nodes[0].mesh is 7, but the file has only 1 meshes",
         with("/nodes/0/mesh", 7)},
        {"negative mesh", "nodes[0].mesh is not the index", with("/nodes/0/mesh", -1)},
        {"mesh is text", "nodes[0].mesh is not the index", with("/nodes/0/mesh", "0")},
        {"scene out of range", "scene is 4", with("/scene", 4)},
        {"node out of range", "scenes[0].nodes[0] is 9", with("/scenes/0/nodes/0", 9)},
        {"position out of range", "meshes[0].primitives[0].attributes.POSITION is 99",
         with("/meshes/0/primitives/0/attributes/POSITION", 99)},
        {"material out of range", "meshes[0].primitives[0].material is 0",
         with("/meshes/0/primitives/0/material", 0)},
        {"texture out of range", "materials[0].pbrMetallicRoughness.baseColorTexture.index is 5",
         with("/materials", {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 5}}}}}}})},
        {"no primitives", "meshes[0].primitives is missing or empty",
         with("/meshes/0/primitives", Json::array())},
        {"no attributes", "meshes[0].primitives[0].attributes is missing",
         with("/meshes/0/primitives/0", Json::object())},
        {"mode 9", "meshes[0].primitives[0].mode is 9", with("/meshes/0/primitives/0/mode", 9)},
        {"matrix of 3", "nodes[0].matrix is not a list of 16 numbers",
         with("/nodes/0/matrix", {1, 2, 3})},
        {"own child", "nodes[0] is its own ancestor", with("/nodes/0/children", {0})},
        {"cycle of two", "is its own ancestor",
         with("/nodes", {{{"children", {1}}, {"mesh", 0}}, {{"children", {0}}}})},
        {"two parents", "nodes[2] is a child of both nodes[0] and nodes[1]",
         with("/nodes", {{{"children", {2}}, {"mesh", 0}}, {{"children", {2}}}, Json::object()})},
        {"joint out of range", "skins[0].joints[0] is 5", with("/skins", {{{"joints", {5}}}})},
        {"no joints", "skins[0].joints is not a list",
         with("/skins", {{{"joints", Json::array()}}})},
        {"bind matrices of the wrong type", "skins[0].inverseBindMatrices is not a list",
         with("/skins", {{{"joints", {0}}, {"inverseBindMatrices", 0}}})},
        {"sampler out of range", "animations[0].channels[0].sampler is not one",
         bent([](GltfBuilder& builder) {
             addAnimation(builder, {{"node", 0}, {"path", "translation"}});
             builder.root["animations"][0]["channels"][0]["sampler"] = 3;
         })},
        {"target out of range", "animations[0].channels[0].target.node is 8",
         bent([](GltfBuilder& builder) {
             addAnimation(builder, {{"node", 8}, {"path", "translation"}});
         })},
        {"too few values", "animations[0].channels[0]: it has 1 values",
         bent([](GltfBuilder& builder) {
             addAnimation(builder, {{"node", 0}, {"path", "translation"}});
         })},
        {"vertex follows a missing joint", "vertex 0 follows joint 3, but the skin has only 1",
         bent([](GltfBuilder& builder) { addSkin(builder, 3); })},
    };
}

std::vector<BadFile> layouts()
{
    const Json hugeCount = 4'000'000'000ULL;
    return {
        {"offset past the view", "accessors[0] reaches to byte",
         with("/accessors/0/byteOffset", 12)},
        {"offset overflows", "accessors[0].byteOffset is",
         with("/accessors/0/byteOffset", 18446744073709551608ULL)},
        {"count overflows", "accessors[0].count is", with("/accessors/0/count", hugeCount)},
        {"count of zeros is huge", "accessors[0].count is", bent([hugeCount](GltfBuilder& builder) {
             builder.root["accessors"][0] = {
                 {"componentType", 5126}, {"type", "VEC3"}, {"count", hugeCount}};
         })},
        {"fractional count", "accessors[0].count is 1.5", with("/accessors/0/count", 1.5)},
        {"stride times count", "accessors[0] reaches to byte",
         with("/bufferViews/0/byteStride", 252)},
        {"stride too large", "bufferViews[0].byteStride is 4096",
         with("/bufferViews/0/byteStride", 4096)},
        {"stride of an odd size", "bufferViews[0].byteStride is no multiple of 4",
         with("/bufferViews/0/byteStride", 14)},
        {"view past the buffer", "bufferViews[0] reaches to byte",
         with("/bufferViews/0/byteLength", 4096)},
        {"view offset overflows", "bufferViews[0].byteOffset is",
         with("/bufferViews/0/byteOffset", 18446744073709551615ULL)},
        {"buffer longer than its data", "buffers[0] should have 4096 bytes",
         with("/buffers", {{{"byteLength", 4096}}})},
        {"buffer of a terabyte", "buffers[0].byteLength is",
         with("/buffers", {{{"byteLength", 1ULL << 40U}}})},
        {"component type", "accessors[0].componentType is none",
         with("/accessors/0/componentType", 5124)},
        {"element type", "accessors[0].type is none", with("/accessors/0/type", "VEC7")},
        {"index out of range", "meshes[0].primitives[0].indices: index 9 at position 1",
         bent([](GltfBuilder& builder) {
             const int indices = builder.accessor<std::uint16_t>({0, 9, 2}, "SCALAR");
             builder.root["meshes"][0]["primitives"][0]["indices"] = indices;
         })},
        {"indices are floats", "primitives[0].indices has the wrong type",
         bent([](GltfBuilder& builder) {
             const int indices = builder.accessor<float>({0, 1, 2}, "SCALAR");
             builder.root["meshes"][0]["primitives"][0]["indices"] = indices;
         })},
        {"normals too few", "attributes.NORMAL has 1 elements, but POSITION has 3",
         bent([](GltfBuilder& builder) {
             const int normals = builder.accessor<float>({0, 0, 1}, "VEC3");
             builder.root["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = normals;
         })},
        {"positions are pairs", "attributes.POSITION has the wrong type",
         with("/accessors/0/type", "VEC2")},
        {"sparse without values", "accessors[0].sparse lacks",
         with("/accessors/0/sparse", {{"count", 1}})},
        {"sparse reaches too far", "accessors[0].sparse.values reaches",
         with("/accessors/0/sparse", {{"count", 3},
                                      {"indices", {{"bufferView", 1}, {"componentType", 5121}}},
                                      {"values", {{"bufferView", 1}}}})},
        {"compressed view without data",
         "bufferViews[0].extensions.EXT_meshopt_compression does not describe",
         with("/bufferViews/0/extensions",
              {{"EXT_meshopt_compression", {{"buffer", 0}, {"count", 3}, {"byteStride", 12}}}})},
        {"compressed view of garbage", "its compressed data is damaged",
         with("/bufferViews/0/extensions", {{"EXT_meshopt_compression",
                                             {{"buffer", 0},
                                              {"byteLength", 36},
                                              {"count", 3},
                                              {"byteStride", 12},
                                              {"mode", "ATTRIBUTES"}}}})},
        {"absolute buffer", "is not a path that begins at the file",
         with("/buffers", {{{"byteLength", 4}, {"uri", "/etc/passwd"}}})},
        {"buffer on the net", "is not a path that begins at the file",
         with("/buffers", {{{"byteLength", 4}, {"uri", "http://example.org/a.bin"}}})},
        {"buffer missing", "buffers[0].uri: \"gone.bin\": there is no such file",
         with("/buffers", {{{"byteLength", 4}, {"uri", "gone.bin"}}})},
        {"buffer is a folder", "buffers[0].uri",
         with("/buffers", {{{"byteLength", 4}, {"uri", "."}}})},
        {"bad base64", "is not valid base64",
         with("/buffers", {{{"byteLength", 4}, {"uri", "data:;base64,@@@@"}}})},
        {"data URI without comma", "has no comma",
         with("/buffers", {{{"byteLength", 4}, {"uri", "data:xyz"}}})},
    };
}

} // namespace

class tst_GltfHostile : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isRefusedWithThePlace_data();
    void isRefusedWithThePlace();
    void truncationAnywhereIsRefused();
    void flippedBytesDoNoHarm();
    void sharedMeshesCannotExhaustMemory();
    void hugeImagesAreLeftOut();
    void badImagesAreWarnings_data();
    void badImagesAreWarnings();
    void deepTreesAreFine();

private:
    QTemporaryDir m_folder;
};

void tst_GltfHostile::isRefusedWithThePlace_data()
{
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<QString>("suffix");
    QTest::addColumn<QString>("message");
    for (const auto& rows : {envelopes(), structures(), layouts()}) {
        for (const BadFile& row : rows) {
            QTest::newRow(row.name)
                << row.content() << QString::fromUtf8(row.suffix) << QString::fromUtf8(row.message);
        }
    }
}

void tst_GltfHostile::isRefusedWithThePlace()
{
    QFETCH(const QByteArray, content);
    QFETCH(const QString, suffix);
    QFETCH(const QString, message);
    const std::string path = writeFile(m_folder.filePath(QStringLiteral("bad") + suffix), content);
    const Result<TemplatePtr> asset = importTemplate(path);
    QVERIFY(!asset.isOk());
    const QString told = QString::fromStdString(asset.error().message);
    QVERIFY2(told.contains(message), qPrintable(told));
    QVERIFY(told.size() < 1000 && !told.contains(QChar::ReplacementCharacter));
    QVERIFY2(told.startsWith(QStringLiteral("bad") + suffix), qPrintable(told));
    QVERIFY2(!told.contains(u'\n'), qPrintable(told));
    QVERIFY(!importStage(path).isOk());
}

void tst_GltfHostile::truncationAnywhereIsRefused()
{
    GltfBuilder builder = GltfBuilder::triangle();
    addSkin(builder, 0);
    const QByteArray whole = builder.glb();
    for (qsizetype size = 0; size < whole.size(); ++size) {
        const std::string path =
            writeFile(m_folder.filePath(QStringLiteral("cut.glb")), whole.left(size));
        QVERIFY2(!importTemplate(path).isOk(), qPrintable(QString::number(size)));
    }
    QVERIFY(importTemplate(writeFile(m_folder.filePath(QStringLiteral("cut.glb")), whole)).isOk());
}

void tst_GltfHostile::flippedBytesDoNoHarm()
{
    GltfBuilder builder = GltfBuilder::triangle();
    addSkin(builder, 0);
    addAnimation(builder, {{"node", 0}, {"path", "weights"}});
    const QByteArray whole = builder.glb();
    std::uint32_t random = 1;
    for (int round = 0; round < 1000; ++round) {
        QByteArray broken = whole;
        for (int i = 0; i < 1 + round % 4; ++i) {
            random = random * 1664525U + 1013904223U;
            broken[static_cast<qsizetype>(random >> 8U) % broken.size()] =
                static_cast<char>(random >> 3U);
        }
        const std::string path =
            writeFile(m_folder.filePath(QStringLiteral("flipped.glb")), broken);
        const Result<TemplatePtr> asset = importTemplate(path);
        if (asset) {
            QVERIFY(std::isfinite(asset.value()->height));
        } else {
            QVERIFY(asset.error().message.starts_with("flipped.glb: "));
        }
    }
}

void tst_GltfHostile::sharedMeshesCannotExhaustMemory()
{
    GltfBuilder builder;
    const int positions = builder.accessorOf(-1, 5126, 1'000'000, "VEC3");
    builder.add("meshes", {{"primitives", {{{"attributes", {{"POSITION", positions}}}}}}});
    for (int i = 0; i < 1000; ++i) {
        builder.add("nodes", {{"mesh", 0}});
    }
    const std::string path =
        writeFile(m_folder.filePath(QStringLiteral("many.glb")), builder.glb());
    const Result<StagePtr> stage = importStage(path);
    QVERIFY(!stage.isOk());
    QVERIFY2(stage.error().message.find("the scene has more than") != std::string::npos,
             stage.error().message.c_str());
}

namespace {

GltfBuilder textured(const QByteArray& picture)
{
    GltfBuilder builder = GltfBuilder::triangle();
    const int view = builder.view(std::vector<std::uint8_t>(picture.begin(), picture.end()));
    builder.add("images", {{"bufferView", view}, {"mimeType", "image/png"}, {"name", "skin"}});
    builder.add("textures", {{"source", 0}});
    builder.add("materials", {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
    builder.root["meshes"][0]["primitives"][0]["material"] = 0;
    return builder;
}

/// Only the head of a PNG, with a size of its own choice.
QByteArray pngHead(quint32 width, quint32 height)
{
    QByteArray head("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16);
    for (const quint32 value : {width, height}) {
        for (int shift = 24; shift >= 0; shift -= 8) {
            head.append(static_cast<char>(value >> static_cast<unsigned>(shift)));
        }
    }
    return head + QByteArray("\x08\x06\0\0\0\0\0\0\0", 9);
}

} // namespace

void tst_GltfHostile::hugeImagesAreLeftOut()
{
    const std::string path = writeFile(m_folder.filePath(QStringLiteral("huge.glb")),
                                       textured(pngHead(2'000'000'000, 2'000'000'000)).glb());
    const Result<TemplatePtr> asset = importTemplate(path);
    QVERIFY2(asset.isOk(), asset ? "" : asset.error().message.c_str());
    QVERIFY(asset.value()->images.empty());
    QCOMPARE(asset.value()->slots.front().choices.front().image, -1);
    QCOMPARE(asset.value()->warnings.size(), std::size_t{1});
    QVERIFY(
        asset.value()->warnings.front().english().starts_with("images[0] \"skin\" is left out"));
}

void tst_GltfHostile::badImagesAreWarnings_data()
{
    QTest::addColumn<QString>("uri");
    QTest::addColumn<QString>("message");
    QTest::newRow("missing") << QStringLiteral("gone.png") << QStringLiteral("no such file");
    QTest::newRow("absolute") << QStringLiteral("/a.png") << QStringLiteral("not a path that");
    QTest::newRow("absolute, encoded")
        << QStringLiteral("%2Fa.png") << QStringLiteral("not a path that");
    QTest::newRow("another format")
        << QStringLiteral("data:image/png,<svg xmlns='a'/>") << QStringLiteral("not a picture");
    QTest::newRow("on the net") << QStringLiteral("https://example.org/a.png")
                                << QStringLiteral("not a path that");
    QTest::newRow("no picture") << QStringLiteral("data:image/png;base64,AAAA")
                                << QStringLiteral("not a picture");
    QTest::newRow("empty") << QStringLiteral("data:image/png;base64,")
                           << QStringLiteral("not a picture");
}

void tst_GltfHostile::badImagesAreWarnings()
{
    QFETCH(const QString, uri);
    QFETCH(const QString, message);
    GltfBuilder builder = textured(QByteArray(4, ' '));
    builder.root["images"][0] = {{"uri", uri.toStdString()}};
    const Result<TemplatePtr> asset =
        importTemplate(writeFile(m_folder.filePath(QStringLiteral("a.glb")), builder.glb()));
    QVERIFY2(asset.isOk(), asset ? "" : asset.error().message.c_str());
    QCOMPARE(asset.value()->warnings.size(), std::size_t{1});
    const QString warning = QString::fromStdString(asset.value()->warnings.front().english());
    QVERIFY2(warning.contains(message) && warning.contains(QStringLiteral("images[0]")),
             qPrintable(warning));
}

void tst_GltfHostile::deepTreesAreFine()
{
    GltfBuilder builder = GltfBuilder::triangle();
    constexpr int kDepth = 100'000;
    builder.root["nodes"] = Json::array();
    for (int i = 0; i < kDepth; ++i) {
        builder.add("nodes", {{"children", {i + 1}}});
    }
    builder.add("nodes", {{"mesh", 0}});
    const Result<TemplatePtr> asset =
        importTemplate(writeFile(m_folder.filePath(QStringLiteral("deep.glb")), builder.glb()));
    QVERIFY2(asset.isOk(), asset ? "" : asset.error().message.c_str());
    QCOMPARE(asset.value()->height, 1.0F);
}

CROWD_TEST(tst_GltfHostile)
#include "tst_GltfHostile.moc"
