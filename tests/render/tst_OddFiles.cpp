// SPDX-License-Identifier: MIT
#include <cmath>
#include <functional>

#include <QtTest/QtTest>

#include "model/gltf/GltfImport.h"
#include "tests/model/GltfFolder.h"
#include "tests/program/Test.h"
#include "tests/render/FileDrawing.h"
#include "tests/render/QuadFiles.h"

using namespace crowd;
using namespace crowd::testing;

namespace {

using Build = std::function<GltfBuilder()>;

/// Changes the plain file.
template<class Change>
Build changed(const Change& change)
{
    return [change] {
        GltfBuilder builder = quad();
        change(builder);
        return builder;
    };
}

std::vector<float> scaled(std::vector<float> values, float factor)
{
    for (float& value : values) {
        value *= factor;
    }
    return values;
}

std::vector<float> cornersBy(const std::function<glm::vec3(const glm::vec3&)>& move)
{
    std::vector<float> out;
    for (std::size_t i = 0; i < kCorners.size(); i += 3) {
        const glm::vec3 to = move({kCorners[i], kCorners[i + 1], kCorners[i + 2]});
        out.insert(out.end(), {to.x, to.y, to.z});
    }
    return out;
}

template<class T>
std::vector<T> wholeNumbers(const std::vector<float>& values, float factor)
{
    std::vector<T> out;
    for (const float value : values) {
        out.push_back(static_cast<T>(std::lround(value * factor)));
    }
    return out;
}

/// Four byte pairs of coordinates, each on four bytes as vertex data has to be.
int bytePairs(GltfBuilder& builder, const std::vector<float>& values)
{
    std::vector<std::uint8_t> bytes;
    for (std::size_t i = 0; i < values.size(); i += 2) {
        for (const float value : {values[i], values[i + 1], 0.0F, 0.0F}) {
            bytes.push_back(static_cast<std::uint8_t>(std::lround(value * 255.0F)));
        }
    }
    const int view = builder.view(bytes);
    builder.root["bufferViews"][static_cast<std::size_t>(view)]["byteStride"] = 4;
    const int accessor = builder.accessorOf(view, 5121, values.size() / 2, "VEC2");
    builder.root["accessors"][static_cast<std::size_t>(accessor)]["normalized"] = true;
    return accessor;
}

void makeSparse(GltfBuilder& builder, int accessor, const std::vector<std::uint8_t>& at,
                const std::vector<float>& values)
{
    const int indices = builder.view(at);
    const int replaced = builder.view(values);
    builder.root["accessors"][static_cast<std::size_t>(accessor)]["sparse"] = {
        {"count", at.size()},
        {"indices", {{"bufferView", indices}, {"componentType", 5121}}},
        {"values", {{"bufferView", replaced}}}};
}

Json& texture(GltfBuilder& builder)
{
    return builder.root["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"];
}

void row(const char* name, const Build& build)
{
    QTest::newRow(name) << build().glb();
}

} // namespace

/// The same square with four colours, written in the many ways in which glTF files are: each is
/// drawn alike.
class TestOddFiles : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void cleanupTestCase();
    void drawsTheSquare_data();
    void drawsTheSquare();

private:
    void addGeometry();
    void addCoordinates();
    void addNodes();
    void addPictures();

    gltf_samples::GltfFolder m_folder;
    std::unique_ptr<FileDrawing> m_drawing;
};

void TestOddFiles::initTestCase()
{
    m_drawing = std::make_unique<FileDrawing>();
    QVERIFY2(m_drawing->problem().empty(), m_drawing->problem().c_str());
}

void TestOddFiles::cleanupTestCase()
{
    m_drawing.reset();
}

void TestOddFiles::addGeometry()
{
    row("plain", [] { return quad(); });
    row("no indices", [] {
        GltfBuilder builder = quad({-1, 1, 0, -1, -1, 0, 1, -1, 0, -1, 1, 0, 1, -1, 0, 1, 1, 0},
                                   {0, 0, 0, 1, 1, 1, 0, 0, 1, 1, 1, 0});
        primitiveOf(builder).erase("indices");
        return builder;
    });
    row("indices of one byte", changed([](GltfBuilder& builder) {
            primitiveOf(builder)["indices"] =
                builder.accessor<std::uint8_t>({0, 1, 2, 0, 2, 3}, "SCALAR");
        }));
    row("indices of four bytes", changed([](GltfBuilder& builder) {
            primitiveOf(builder)["indices"] =
                builder.accessor<std::uint32_t>({0, 1, 2, 0, 2, 3}, "SCALAR");
        }));
    row("strip", changed([](GltfBuilder& builder) {
            primitiveOf(builder)["indices"] =
                builder.accessor<std::uint16_t>({0, 1, 3, 2}, "SCALAR");
            primitiveOf(builder)["mode"] = 5;
        }));
    row("fan without indices", changed([](GltfBuilder& builder) {
            primitiveOf(builder).erase("indices");
            primitiveOf(builder)["mode"] = 6;
        }));
    row("points and lines beside it", changed([](GltfBuilder& builder) {
            Json other = primitiveOf(builder);
            for (const int mode : {0, 1, 2, 3}) {
                other["mode"] = mode;
                builder.root["meshes"][0]["primitives"].push_back(other);
            }
        }));
    row("triangles that are none", changed([](GltfBuilder& builder) {
            primitiveOf(builder)["indices"] =
                builder.accessor<std::uint16_t>({0, 1, 2, 0, 0, 0, 0, 2, 3, 1, 2, 1, 3}, "SCALAR");
        }));
    row("sparse positions over nothing", changed([](GltfBuilder& builder) {
            const int positions = builder.accessorOf(-1, 5126, 4, "VEC3");
            makeSparse(builder, positions, {0, 1, 2, 3}, kCorners);
            attributesOf(builder)["POSITION"] = positions;
        }));
    row("one sparse position", [] {
        GltfBuilder builder = quad({9, 9, 9, -1, -1, 0, 1, -1, 0, 1, 1, 0});
        makeSparse(builder, 0, {0}, {-1, 1, 0});
        return builder;
    });
    row("quantized positions", changed([](GltfBuilder& builder) {
            builder.root["extensionsRequired"] = {"KHR_mesh_quantization"};
            std::vector<std::int16_t> padded;
            for (std::size_t i = 0; i < kCorners.size(); i += 3) {
                for (const float value : {kCorners[i], kCorners[i + 1], kCorners[i + 2], 0.0F}) {
                    padded.push_back(static_cast<std::int16_t>(value * 1000.0F));
                }
            }
            const int view = builder.view(padded);
            builder.root["bufferViews"][static_cast<std::size_t>(view)]["byteStride"] = 8;
            attributesOf(builder)["POSITION"] = builder.accessorOf(view, 5122, 4, "VEC3");
            builder.root["nodes"][0]["scale"] = {0.001, 0.001, 0.001};
        }));
    row("morph target that is sparse and fully on", [] {
        GltfBuilder builder = quad({-1, 1, 0, -1, -1, 0, 1, -1, 0, 0, 0, 0});
        const int target = builder.accessorOf(-1, 5126, 4, "VEC3");
        makeSparse(builder, target, {3}, {1, 1, 0});
        primitiveOf(builder)["targets"] = {{{"POSITION", target}}};
        builder.root["meshes"][0]["weights"] = {1};
        return builder;
    });
    row("seen from behind, double-sided", changed([](GltfBuilder& builder) {
            primitiveOf(builder)["indices"] =
                builder.accessor<std::uint16_t>({2, 1, 0, 3, 2, 0}, "SCALAR");
            builder.root["materials"][0]["doubleSided"] = true;
        }));
    row("padding between the vertices", changed([](GltfBuilder& builder) {
            std::vector<float> padded;
            for (std::size_t i = 0; i < 4; ++i) {
                padded.insert(padded.end(),
                              {kCorners[i * 3], kCorners[i * 3 + 1], kCorners[i * 3 + 2], 77,
                               kCornerUv[i * 2], kCornerUv[i * 2 + 1], 77, 77});
            }
            const int view = builder.view(padded);
            builder.root["bufferViews"][static_cast<std::size_t>(view)]["byteStride"] = 32;
            attributesOf(builder)["POSITION"] = builder.accessorOf(view, 5126, 4, "VEC3");
            const int uv = builder.accessorOf(view, 5126, 4, "VEC2");
            builder.root["accessors"][static_cast<std::size_t>(uv)]["byteOffset"] = 16;
            attributesOf(builder)["TEXCOORD_0"] = uv;
        }));
}

void TestOddFiles::addCoordinates()
{
    row("coordinates of two bytes", changed([](GltfBuilder& builder) {
            const int uv =
                builder.accessor(wholeNumbers<std::uint16_t>(kCornerUv, 65535.0F), "VEC2");
            builder.root["accessors"][static_cast<std::size_t>(uv)]["normalized"] = true;
            attributesOf(builder)["TEXCOORD_0"] = uv;
        }));
    row("coordinates of one byte", changed([](GltfBuilder& builder) {
            attributesOf(builder)["TEXCOORD_0"] = bytePairs(builder, kCornerUv);
        }));
    row("second set of coordinates", changed([](GltfBuilder& builder) {
            attributesOf(builder)["TEXCOORD_1"] = attributesOf(builder)["TEXCOORD_0"];
            attributesOf(builder)["TEXCOORD_0"] =
                builder.accessor<float>({0, 0, 0, 0, 0, 0, 0, 0}, "VEC2");
            texture(builder)["texCoord"] = 1;
        }));
    row("texture transform: scale and offset", [] {
        GltfBuilder builder = quad(kCorners, scaled(kCornerUv, 0.25F));
        texture(builder)["extensions"]["KHR_texture_transform"] = {{"scale", {4, 4}},
                                                                   {"offset", {2, -1}}};
        return builder;
    });
    row("texture transform: turned", [] {
        // Turned counter-clockwise by a quarter, (u, v) becomes (v, -u).
        GltfBuilder builder = quad(kCorners, {0, 0, -1, 0, -1, 1, 0, 1});
        texture(builder)["extensions"]["KHR_texture_transform"] = {{"rotation", 1.5707963}};
        return builder;
    });
    row("texture transform: another set", changed([](GltfBuilder& builder) {
            attributesOf(builder)["TEXCOORD_2"] = attributesOf(builder)["TEXCOORD_0"];
            attributesOf(builder).erase("TEXCOORD_0");
            texture(builder)["extensions"]["KHR_texture_transform"] = {{"texCoord", 2}};
        }));
    row("coordinates far outside, repeated", [] {
        std::vector<float> uv = kCornerUv;
        for (float& value : uv) {
            value += 7.0F;
        }
        return quad(kCorners, uv);
    });
    row("mirrored repetition", [] {
        std::vector<float> uv = kCornerUv;
        for (std::size_t i = 0; i < uv.size(); i += 2) {
            uv[i] = 2.0F - uv[i];
        }
        GltfBuilder builder = quad(kCorners, uv);
        builder.root["samplers"][0].update({{"wrapS", 33648}, {"wrapT", 33648}});
        return builder;
    });
    row("clamped", [] {
        std::vector<float> uv = kCornerUv;
        for (float& value : uv) {
            value = value * 5.0F - 2.0F;
        }
        GltfBuilder builder = quad(kCorners, uv);
        builder.root["samplers"][0].update({{"wrapS", 33071}, {"wrapT", 33071}});
        return builder;
    });
}

void TestOddFiles::addNodes()
{
    row("in centimetres", [] { return quad(scaled(kCorners, 18000.0F)); });
    row("a thousandth of a millimetre", [] { return quad(scaled(kCorners, 1e-6F)); });
    row("Z is up", [] {
        GltfBuilder builder =
            quad(cornersBy([](const glm::vec3& p) { return glm::vec3(p.x, -p.z, p.y); }));
        builder.root["nodes"][0]["rotation"] = {-0.70710678, 0, 0, 0.70710678};
        return builder;
    });
    row("mirrored by its node", [] {
        GltfBuilder builder =
            quad(cornersBy([](const glm::vec3& p) { return glm::vec3(-p.x, p.y, p.z); }));
        builder.root["nodes"][0]["scale"] = {-1, 1, 1};
        primitiveOf(builder)["indices"] =
            builder.accessor<std::uint16_t>({2, 1, 0, 3, 2, 0}, "SCALAR");
        return builder;
    });
    row("a matrix on the node", [] {
        GltfBuilder builder = quad(scaled(kCorners, 0.5F));
        builder.root["nodes"][0]["matrix"] = {2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 5, 6, 7, 1};
        return builder;
    });
    row("no scene", changed([](GltfBuilder& builder) {
            builder.root.erase("scene");
            builder.root.erase("scenes");
        }));
    row("the second of several scenes", changed([](GltfBuilder& builder) {
            builder.add("nodes", {{"mesh", 0}, {"translation", {40, 0, 0}}});
            builder.root["scenes"] = {{{"nodes", {1}}}, {{"nodes", {0}}}};
            builder.root["scene"] = 1;
        }));
    row("names in many scripts, twice the same", changed([](GltfBuilder& builder) {
            const char* name = "K\u00f6rper \u8eab\u4f53 \"\u202ex\"";
            builder.root["nodes"][0]["name"] = name;
            builder.add("nodes", {{"name", name}});
            builder.root["scenes"][0]["nodes"] = {0, 1};
            builder.root["meshes"][0]["name"] = name;
            builder.root["materials"][0]["name"] = name;
            builder.add("materials", builder.root["materials"][0]);
            Json half = primitiveOf(builder);
            primitiveOf(builder)["indices"] = builder.accessor<std::uint16_t>({0, 1, 2}, "SCALAR");
            half["indices"] = builder.accessor<std::uint16_t>({0, 2, 3}, "SCALAR");
            half["material"] = 1;
            builder.root["meshes"][0]["primitives"].push_back(half);
        }));
    row("skin without inverse bind matrices, weights that are not one", [] {
        GltfBuilder builder = quad(scaled(kCorners, 0.5F));
        attributesOf(builder)["JOINTS_0"] = builder.accessor<std::uint8_t>(
            {0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, "VEC4");
        attributesOf(builder)["WEIGHTS_0"] =
            builder.accessor<float>({3, 0, 0, 0, 0.1F, 0, 0, 0, 1, 0, 0, 0, 0.5F, 0, 0, 0}, "VEC4");
        builder.root["nodes"] = {{{"mesh", 0}, {"skin", 0}, {"translation", {90, 0, 0}}},
                                 {{"scale", {2, 2, 2}}, {"children", {2}}},
                                 {{"name", "b"}}};
        builder.add("skins", {{"joints", {1, 2}}});
        builder.root["scenes"][0]["nodes"] = {0, 1};
        return builder;
    });
    row("two skins", [] {
        GltfBuilder builder = quad();
        attributesOf(builder)["JOINTS_0"] =
            builder.accessor<std::uint8_t>(std::vector<std::uint8_t>(16, 0), "VEC4");
        attributesOf(builder)["WEIGHTS_0"] =
            builder.accessor<float>({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, "VEC4");
        Json half = primitiveOf(builder);
        primitiveOf(builder)["indices"] = builder.accessor<std::uint16_t>({0, 1, 2}, "SCALAR");
        half["indices"] = builder.accessor<std::uint16_t>({0, 2, 3}, "SCALAR");
        const int other = builder.add("meshes", {{"primitives", {half}}});
        builder.root["nodes"] = {{{"mesh", 0}, {"skin", 0}},
                                 {{"mesh", other}, {"skin", 1}},
                                 {{"translation", {3, 0, 0}}},
                                 {{"translation", {3, 0, 0}}}};
        builder.root["skins"] = {{{"joints", {2}}}, {{"joints", {3}}}};
        builder.root["scenes"][0]["nodes"] = {0, 1, 2, 3};
        return builder;
    });
    for (const char* interpolation : {"STEP", "LINEAR", "CUBICSPLINE"}) {
        const auto build = [interpolation] {
            GltfBuilder builder = quad(scaled(kCorners, 0.001F));
            const bool isCubic = std::string(interpolation) == "CUBICSPLINE";
            std::vector<float> values;
            for (const float scale : {1000.0F, 2000.0F}) {
                for (const float value : {0.0F, scale, 0.0F}) {
                    if (isCubic || value != 0.0F) {
                        values.insert(values.end(), 3, value);
                    }
                }
            }
            const int times = builder.accessor<float>({0.5F, 1.5F}, "SCALAR");
            const int scales = builder.accessor(values, "VEC3");
            builder.add(
                "animations",
                {{"samplers",
                  {{{"input", times}, {"output", scales}, {"interpolation", interpolation}}}},
                 {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "scale"}}}}}}});
            return builder;
        };
        row(qPrintable(QStringLiteral("scaled by a clip, %1").arg(QLatin1String(interpolation))),
            build);
    }
    row("instances", [] {
        GltfBuilder builder = quad({-1, 1, 0, -1, -1, 0, 0, -1, 0, 0, 1, 0}, kCornerUv);
        // The left half shows the left colours, and its instance the right ones: two meshes.
        Json right = primitiveOf(builder);
        primitiveOf(builder)["attributes"]["TEXCOORD_0"] =
            builder.accessor<float>({0, 0, 0, 1, 0.5F, 1, 0.5F, 0}, "VEC2");
        right["attributes"]["TEXCOORD_0"] =
            builder.accessor<float>({0.5F, 0, 0.5F, 1, 1, 1, 1, 0}, "VEC2");
        const int other = builder.add("meshes", {{"primitives", {right}}});
        const int moved = builder.accessor<float>({1, 0, 0}, "VEC3");
        builder.add("nodes",
                    {{"mesh", other},
                     {"extensions",
                      {{"EXT_mesh_gpu_instancing", {{"attributes", {{"TRANSLATION", moved}}}}}}}});
        builder.root["scenes"][0]["nodes"] = {0, 1};
        return builder;
    });
}

void TestOddFiles::addPictures()
{
    const auto withPicture = [](const QImage& picture, const char* format) {
        return changed([picture, format](GltfBuilder& builder) {
            builder.root["images"][0]["uri"] = dataUri(picture, format);
        });
    };
    row("WebP", withPicture(fourColours(), "webp"));
    row("JPEG", withPicture(fourColours().scaled(64, 64), "jpeg"));
    row("PNG with a palette",
        withPicture(fourColours().convertToFormat(QImage::Format_Indexed8), "png"));
    row("PNG of 16 bits", withPicture(fourColours().convertToFormat(QImage::Format_RGBA64), "png"));
    row("larger than a layer", withPicture(fourColours().scaled(3000, 2000), "png"));
    row("Basis Universal beside a plain picture", changed([](GltfBuilder& builder) {
            builder.add("images", {{"uri", "none.ktx2"}});
            builder.root["textures"][0]["extensions"]["KHR_texture_basisu"] = {{"source", 1}};
            builder.root["extensionsUsed"] = {"KHR_texture_basisu"};
        }));
    row("unlit", changed([](GltfBuilder& builder) {
            builder.root["materials"][0]["extensions"]["KHR_materials_unlit"] = Json::object();
        }));
    row("specular and glossiness", changed([](GltfBuilder& builder) {
            const Json diffuse =
                builder.root["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"];
            builder.root["materials"][0] = {
                {"extensions",
                 {{"KHR_materials_pbrSpecularGlossiness", {{"diffuseTexture", diffuse}}}}}};
        }));
    row("blended, but solid",
        changed([](GltfBuilder& builder) { builder.root["materials"][0]["alphaMode"] = "BLEND"; }));
    row("cut out, but solid",
        changed([](GltfBuilder& builder) { builder.root["materials"][0]["alphaMode"] = "MASK"; }));
    row("opaque, its alpha counts for nothing", changed([](GltfBuilder& builder) {
            QImage picture = fourColours();
            for (int i = 0; i < 4; ++i) {
                QColor color = picture.pixelColor(i % 2, i / 2);
                color.setAlpha(i * 60);
                picture.setPixelColor(i % 2, i / 2, color);
            }
            builder.root["images"][0]["uri"] = dataUri(picture);
        }));
    row("by emission alone", changed([](GltfBuilder& builder) {
            const Json picture = texture(builder);
            builder.root["materials"][0] = {
                {"pbrMetallicRoughness", {{"baseColorFactor", {0, 0, 0, 1}}}},
                {"emissiveTexture", picture},
                {"emissiveFactor", {1, 1, 1}}};
        }));
    for (const bool isNormalized : {true, false}) {
        row(isNormalized ? "vertex colours of two bytes" : "vertex colours as numbers",
            changed([isNormalized](GltfBuilder& builder) {
                // Nine vertices would share colours: four squares with four vertices each.
                std::vector<float> positions;
                std::vector<float> colours;
                std::vector<std::uint16_t> indices;
                const std::array<glm::vec3, 4> kColours{
                    {{1, 0, 0}, {1, 1, 0}, {0, 0, 1}, {1, 1, 1}}};
                for (std::size_t square = 0; square < 4; ++square) {
                    const glm::vec3 centre(square % 2 == 0 ? -0.5F : 0.5F,
                                           square < 2 ? 0.5F : -0.5F, 0);
                    const auto first = static_cast<std::uint16_t>(square * 4);
                    for (std::size_t c = 0; c < 12; c += 3) {
                        positions.insert(positions.end(), {centre.x + kCorners[c] / 2,
                                                           centre.y + kCorners[c + 1] / 2, 0});
                        const glm::vec3& colour = kColours[square];
                        colours.insert(colours.end(), {colour.x, colour.y, colour.z, 1});
                    }
                    for (const int corner : {0, 1, 2, 0, 2, 3}) {
                        indices.push_back(static_cast<std::uint16_t>(first + corner));
                    }
                }
                int colour = builder.accessor(colours, "VEC4");
                if (isNormalized) {
                    colour =
                        builder.accessor(wholeNumbers<std::uint16_t>(colours, 65535.0F), "VEC4");
                    builder.root["accessors"][static_cast<std::size_t>(colour)]["normalized"] =
                        true;
                }
                primitiveOf(builder) = {
                    {"attributes",
                     {{"POSITION", builder.accessor(positions, "VEC3")}, {"COLOR_0", colour}}},
                    {"indices", builder.accessor(indices, "SCALAR")}};
            }));
    }
}

void TestOddFiles::drawsTheSquare_data()
{
    QTest::addColumn<QByteArray>("glb");
    addGeometry();
    addCoordinates();
    addNodes();
    addPictures();
}

void TestOddFiles::drawsTheSquare()
{
    QFETCH(const QByteArray, glb);
    const model::Result<model::TemplatePtr> asset =
        model::importTemplate(writeFile(m_folder.filePath(QStringLiteral("square.glb")), glb));
    QVERIFY2(asset.isOk(), asset ? "" : asset.error().message.c_str());
    const DrawnFile drawn = m_drawing->drawFrom(asset.value(), 0.8F, {0, 0, 1});
    QVERIFY2(drawn.problem.empty(), drawn.problem.c_str());
    struct Place
    {
        int x, y, red, green, blue;
    };
    for (const Place& place : {Place{40, 40, 255, 0, 0}, Place{88, 40, 255, 255, 0},
                               Place{40, 88, 0, 0, 255}, Place{88, 88, 255, 255, 255}}) {
        const std::uint8_t* pixel = drawn.at(place.x, place.y);
        const bool isRight = std::abs(pixel[0] - place.red) < 8 &&
                             std::abs(pixel[1] - place.green) < 8 &&
                             std::abs(pixel[2] - place.blue) < 8;
        QVERIFY2(isRight, qPrintable(QStringLiteral("at %1, %2: %3 %4 %5")
                                         .arg(place.x)
                                         .arg(place.y)
                                         .arg(pixel[0])
                                         .arg(pixel[1])
                                         .arg(pixel[2])));
    }
}

CROWD_TEST(TestOddFiles)
#include "tst_OddFiles.moc"
