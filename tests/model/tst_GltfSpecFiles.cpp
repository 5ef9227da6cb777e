// SPDX-License-Identifier: MIT
#include <QtCore/QBuffer>
#include <QtCore/QDir>
#include <QtGui/QImage>
#include <QtGui/QImageWriter>
#include <QtTest/QTest>

#include "model/gltf/GltfImport.h"
#include "tests/model/GltfFolder.h"
#include "tests/model/GltfSamples.h"
#include "tests/program/Test.h"

using namespace crowd::model;
using namespace gltf_samples;

/// What the specification of glTF 2.0 says of containers, URIs, pictures and extensions.
class tst_GltfSpecFiles : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void readsBase64OfEveryKind_data();
    void readsBase64OfEveryKind();
    void readsFilesInOtherFolders_data();
    void readsFilesInOtherFolders();
    void readsContainersOfEveryShape_data();
    void readsContainersOfEveryShape();
    void decodesPicturesOfEveryKind_data();
    void decodesPicturesOfEveryKind();
    void showsThePictureThatItCan_data();
    void showsThePictureThatItCan();
    void usesPlainPicturesBeforeOthers();
    void acceptsExtensionsThatAreNotDemanded();
    void acceptsDemandedExtensions_data();
    void acceptsDemandedExtensions();
    void refusesUnknownDemands_data();
    void refusesUnknownDemands();
    void readsUnlitAndGlowingMaterials();
    void readsTheOtherWorkflow();
    void warnsOfVariantsWithOtherCoordinates();
    void saysWhichCompressionItCannotRead();

private:
    Result<TemplatePtr> read(const QByteArray& content, const QString& name)
    {
        return importTemplate(writeFile(m_folder.filePath(name), content));
    }

    GltfFolder m_folder;
};

namespace {

QByteArray binaryOf(const GltfBuilder& builder)
{
    return {reinterpret_cast<const char*>(builder.bytes.data()),
            static_cast<qsizetype>(builder.bytes.size())};
}

QByteArray gltfText(const Json& json)
{
    return QByteArray::fromStdString(json.dump());
}

/// Two pixels: red, and half transparent green.
QImage picture()
{
    QImage image(2, 1, QImage::Format_RGBA8888);
    image.setPixelColor(0, 0, QColor(255, 0, 0));
    image.setPixelColor(1, 0, QColor(0, 255, 0, 128));
    return image;
}

QByteArray encoded(const QImage& image, const char* format)
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    QImageWriter writer(&buffer, format);
    writer.setQuality(100);
    if (!writer.write(image)) {
        qFatal("%s cannot be written", format);
    }
    return bytes;
}

/// A triangle whose material shows texture 0, which is still to be made.
GltfBuilder textured()
{
    GltfBuilder builder = GltfBuilder::triangle();
    builder.add("materials", {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
    primitive(builder)["material"] = 0;
    return builder;
}

int addImage(GltfBuilder& builder, const QByteArray& bytes, const char* mime)
{
    const int view = builder.view(std::vector<std::uint8_t>(bytes.begin(), bytes.end()));
    return builder.add("images", {{"bufferView", view}, {"mimeType", mime}});
}

int imageOf(const TemplatePtr& asset)
{
    return asset->slots.front().choices.front().image;
}

} // namespace

void tst_GltfSpecFiles::readsBase64OfEveryKind_data()
{
    QTest::addColumn<QString>("head");
    QTest::addColumn<int>("way");
    const QString usual = QStringLiteral("data:application/octet-stream;base64,");
    QTest::newRow("as usual") << usual << 0;
    QTest::newRow("gltf-buffer") << QStringLiteral("data:application/gltf-buffer;base64,") << 0;
    QTest::newRow("no type") << QStringLiteral("data:;base64,") << 0;
    QTest::newRow("with a parameter") << QStringLiteral("data:a/b;charset=utf-8;base64,") << 0;
    QTest::newRow("in capitals") << QStringLiteral("DATA:application/octet-stream;BASE64,") << 0;
    QTest::newRow("without padding") << usual << 1;
    QTest::newRow("in lines") << usual << 2;
    QTest::newRow("with per cent signs") << usual << 3;
    QTest::newRow("in the alphabet for URLs") << usual << 4;
    QTest::newRow("no base64 at all") << QStringLiteral("data:application/octet-stream,") << 5;
}

void tst_GltfSpecFiles::readsBase64OfEveryKind()
{
    QFETCH(const QString, head);
    QFETCH(const int, way);
    GltfBuilder builder = GltfBuilder::triangle();
    // Makes both + and / of base64, and an end that is padded.
    (void)builder.view<std::uint8_t>({0, 0xFB, 0xEF, 0xBE, 255, 255, 255, 0});
    Json json = builder.withBuffer();
    const QByteArray bytes = binaryOf(builder);
    QByteArray body = bytes.toBase64();
    if (way == 1) {
        QVERIFY(body.endsWith('='));
        body.replace("=", "");
    } else if (way == 2) {
        body.insert(40, "\r\n").append("\n");
    } else if (way == 3) {
        QVERIFY(body.contains('+') && body.contains('/'));
        body = body.toPercentEncoding();
    } else if (way == 4) {
        body = bytes.toBase64(QByteArray::Base64UrlEncoding);
        QVERIFY(body.contains('-') && body.contains('_'));
    } else if (way == 5) {
        body = bytes.toPercentEncoding();
    }
    json["buffers"][0]["uri"] = head.toStdString() + body.toStdString();
    const Result<TemplatePtr> asset = read(gltfText(json), QStringLiteral("data.gltf"));
    QVERIFY2(asset.isOk(), asset ? "" : asset.error().message.c_str());
    QCOMPARE(asset.value()->levels.front().positions[1], glm::vec3(1, 0, 0));
}

void tst_GltfSpecFiles::readsFilesInOtherFolders_data()
{
    QTest::addColumn<QString>("place");
    QTest::addColumn<QString>("uri");
    QTest::newRow("beside") << QStringLiteral("models/skin") << QStringLiteral("skin");
    QTest::newRow("with a dot") << QStringLiteral("models/skin") << QStringLiteral("./skin");
    QTest::newRow("below") << QStringLiteral("models/a/b/skin") << QStringLiteral("a/b/skin");
    QTest::newRow("above") << QStringLiteral("skin") << QStringLiteral("../skin");
    QTest::newRow("in a sister") << QStringLiteral("tex tures/skin")
                                 << QStringLiteral("../tex%20tures/skin");
    QTest::newRow("with a space as it is")
        << QStringLiteral("models/my skin") << QStringLiteral("my skin");
    QTest::newRow("in another script, encoded")
        << QStringLiteral("models/кожа") << QStringLiteral("%D0%BA%D0%BE%D0%B6%D0%B0");
    QTest::newRow("in another script") << QStringLiteral("models/кожа") << QStringLiteral("кожа");
    QTest::newRow("with a per cent sign, encoded")
        << QStringLiteral("models/50%20") << QStringLiteral("50%2520");
    QTest::newRow("with a hash and a question mark")
        << QStringLiteral("models/a#1?") << QStringLiteral("a%231%3F");
    QTest::newRow("with a plus") << QStringLiteral("models/a+b") << QStringLiteral("a+b");
}

void tst_GltfSpecFiles::readsFilesInOtherFolders()
{
    QFETCH(const QString, place);
    QFETCH(const QString, uri);
    GltfBuilder builder = textured();
    builder.add("images", {{"uri", uri.toStdString() + ".png"}});
    builder.add("textures", {{"source", 0}});
    Json json = builder.withBuffer();
    json["buffers"][0]["uri"] = uri.toStdString() + ".bin";
    const QDir folder(m_folder.path());
    QVERIFY(folder.mkpath(QFileInfo(place).path()) && folder.mkpath(QStringLiteral("models")));
    writeFile(folder.filePath(place + QStringLiteral(".bin")), binaryOf(builder));
    writeFile(folder.filePath(place + QStringLiteral(".png")), encoded(picture(), "png"));
    const Result<TemplatePtr> asset = read(gltfText(json), QStringLiteral("models/man.gltf"));
    QVERIFY2(asset.isOk(), asset ? "" : asset.error().message.c_str());
    QCOMPARE(imageOf(asset.value()), 0);
    QVERIFY(asset.value()->warnings.empty());
}

void tst_GltfSpecFiles::readsContainersOfEveryShape_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("content");
    GltfBuilder builder = GltfBuilder::triangle();
    const QByteArray glb = builder.glb();
    const auto withLength = [](QByteArray bytes) {
        const auto length = static_cast<std::uint32_t>(bytes.size());
        std::memcpy(bytes.data() + 8, &length, 4);
        return bytes;
    };
    QTest::newRow("a GLB by another name") << QStringLiteral("man.bin") << glb;
    QTest::newRow("text by another name") << QStringLiteral("man.glb") << builder.embedded();
    QTest::newRow("a byte order mark")
        << QStringLiteral("man.gltf") << QByteArray("\xEF\xBB\xBF") + builder.embedded();
    QTest::newRow("space before the text")
        << QStringLiteral("man.gltf") << QByteArray("\r\n\t ") + builder.embedded() + "\n";
    QTest::newRow("chunks that nobody knows")
        << QStringLiteral("man.glb") << withLength(glb + QByteArray("\4\0\0\0ACMEabcd", 12));
    QVERIFY(builder.bytes.size() % 4 != 0);
    QTest::newRow("a binary chunk with padding") << QStringLiteral("man.glb") << glb;
    Json outside = Json::parse(builder.embedded().toStdString());
    builder.bytes.clear();
    QTest::newRow("a GLB with data: URIs")
        << QStringLiteral("man.glb") << builder.glb(outside.dump());
}

void tst_GltfSpecFiles::readsContainersOfEveryShape()
{
    QFETCH(const QString, name);
    QFETCH(const QByteArray, content);
    const Result<TemplatePtr> asset = read(content, name);
    QVERIFY2(asset.isOk(), asset ? "" : asset.error().message.c_str());
    QCOMPARE(asset.value()->levels.front().positions[1], glm::vec3(1, 0, 0));
    QVERIFY(asset.value()->warnings.empty());
}

void tst_GltfSpecFiles::decodesPicturesOfEveryKind_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<bool>("isExact");
    const QImage image = picture();
    QTest::newRow("PNG") << encoded(image, "png") << true;
    QTest::newRow("PNG of 16 bits")
        << encoded(image.convertToFormat(QImage::Format_RGBA64), "png") << true;
    QImage indexed(2, 1, QImage::Format_Indexed8);
    indexed.setColorTable({qRgba(0, 255, 0, 128), qRgb(255, 0, 0)});
    indexed.setPixel(0, 0, 1);
    indexed.setPixel(1, 0, 0);
    QTest::newRow("PNG with a palette") << encoded(indexed, "png") << true;
    QTest::newRow("JPEG") << encoded(image.convertToFormat(QImage::Format_RGB888), "jpeg") << false;
    QTest::newRow("JPEG in grey") << encoded(image.convertToFormat(QImage::Format_Grayscale8),
                                             "jpeg")
                                  << false;
    QTest::newRow("WebP") << encoded(image, "webp") << false;
}

void tst_GltfSpecFiles::decodesPicturesOfEveryKind()
{
    QFETCH(const QByteArray, bytes);
    QFETCH(const bool, isExact);
    GltfBuilder builder = textured();
    addImage(builder, bytes, "image/wrong"); // what it says of itself does not count
    builder.add("textures", {{"source", 0}});
    const TemplatePtr asset = m_folder.load(builder);
    QVERIFY2(asset->warnings.empty(),
             asset->warnings.empty() ? "" : asset->warnings[0].english().c_str());
    QCOMPARE(imageOf(asset), 0);
    const Image& image = asset->images[0];
    QCOMPARE(image.width, 2);
    QCOMPARE(image.height, 1);
    if (isExact) {
        QCOMPARE(image.rgba, (std::vector<std::uint8_t>{255, 0, 0, 255, 0, 255, 0, 128}));
    }
}

void tst_GltfSpecFiles::showsThePictureThatItCan_data()
{
    QTest::addColumn<QString>("extension"); ///< that holds image 0
    QTest::addColumn<bool>("hasPlain");     ///< image 1 is a PNG
    QTest::addColumn<int>("image");         ///< shown
    QTest::addColumn<int>("warnings");
    for (const char* name : {"KHR_texture_basisu", "MSFT_texture_dds", "EXT_texture_avif"}) {
        QTest::addRow("%s alone", name) << QString::fromLatin1(name) << false << -1 << 1;
        QTest::addRow("%s and a plain one", name) << QString::fromLatin1(name) << true << 0 << 0;
    }
    QTest::newRow("WebP alone") << QStringLiteral("EXT_texture_webp") << false << 0 << 0;
    QTest::newRow("WebP and a plain one") << QStringLiteral("EXT_texture_webp") << true << 0 << 0;
}

void tst_GltfSpecFiles::showsThePictureThatItCan()
{
    QFETCH(const QString, extension);
    QFETCH(const bool, hasPlain);
    QFETCH(const int, image);
    QFETCH(const int, warnings);
    GltfBuilder builder = textured();
    const bool isWebp = extension.endsWith(QStringLiteral("webp"));
    addImage(builder, isWebp ? encoded(picture(), "webp") : QByteArray("\xABKTX 20\xBB\r\n"),
             "x/y");
    const std::string name = extension.toStdString();
    Json texture = {{"extensions", {{name, {{"source", 0}}}}}};
    if (hasPlain) {
        addImage(builder, encoded(picture(), "png"), "image/png");
        texture["source"] = 1;
    } else {
        builder.root["extensionsRequired"] = {name};
    }
    builder.root["extensionsUsed"] = {name};
    builder.add("textures", texture);
    const TemplatePtr asset = m_folder.load(builder);
    QCOMPARE(imageOf(asset), image);
    QCOMPARE(asset->images.size(), static_cast<std::size_t>(image + 1));
    QCOMPARE(asset->warnings.size(), static_cast<std::size_t>(warnings));
}

void tst_GltfSpecFiles::usesPlainPicturesBeforeOthers()
{
    // The plain one cannot be read, the other can.
    GltfBuilder builder = textured();
    builder.add("images", {{"uri", "gone.png"}});
    addImage(builder, encoded(picture(), "webp"), "image/webp");
    builder.add("textures",
                {{"source", 0}, {"extensions", {{"EXT_texture_webp", {{"source", 1}}}}}});
    const TemplatePtr asset = m_folder.load(builder);
    QCOMPARE(imageOf(asset), 0);
    QCOMPARE(asset->warnings.size(), std::size_t{1});
}

void tst_GltfSpecFiles::acceptsExtensionsThatAreNotDemanded()
{
    GltfBuilder builder = GltfBuilder::triangle();
    builder.root["extensionsUsed"] = {"ACME_unheard_of", "KHR_animation_pointer"};
    const Json extension = {{"ACME_unheard_of", {{"index", 99}, {"list", {1, {{"a", nullptr}}}}}}};
    builder.add("materials", {{"extensions", extension}});
    builder.add("samplers", {{"extensions", extension}});
    for (const char* place : {"", "/asset", "/nodes/0", "/meshes/0", "/scenes/0", "/accessors/0",
                              "/meshes/0/primitives/0", "/bufferViews/0"}) {
        builder.root[Json::json_pointer(std::string(place) + "/extensions")] = extension;
    }
    const TemplatePtr asset = m_folder.load(builder);
    QCOMPARE(asset->levels.front().triangleCount(), std::size_t{1});
    QVERIFY(asset->warnings.empty());
}

void tst_GltfSpecFiles::acceptsDemandedExtensions_data()
{
    QTest::addColumn<QString>("name");
    for (const char* name : {"KHR_animation_pointer",
                             "KHR_draco_mesh_compression",
                             "KHR_lights_punctual",
                             "KHR_materials_anisotropy",
                             "KHR_materials_clearcoat",
                             "KHR_materials_diffuse_transmission",
                             "KHR_materials_dispersion",
                             "KHR_materials_emissive_strength",
                             "KHR_materials_ior",
                             "KHR_materials_iridescence",
                             "KHR_materials_pbrSpecularGlossiness",
                             "KHR_materials_sheen",
                             "KHR_materials_specular",
                             "KHR_materials_transmission",
                             "KHR_materials_unlit",
                             "KHR_materials_variants",
                             "KHR_materials_volume",
                             "KHR_mesh_quantization",
                             "KHR_texture_basisu",
                             "KHR_texture_transform",
                             "KHR_xmp_json_ld",
                             "EXT_meshopt_compression",
                             "EXT_texture_webp",
                             "MSFT_lod"}) {
        QTest::newRow(name) << QString::fromLatin1(name);
    }
}

void tst_GltfSpecFiles::acceptsDemandedExtensions()
{
    QFETCH(const QString, name);
    GltfBuilder builder = GltfBuilder::triangle();
    builder.root["extensionsUsed"] = {name.toStdString()};
    builder.root["extensionsRequired"] = {name.toStdString()};
    QVERIFY(m_folder.load(builder)->warnings.empty());
}

void tst_GltfSpecFiles::refusesUnknownDemands_data()
{
    QTest::addColumn<QString>("name");
    QTest::newRow("unheard of") << QStringLiteral("ACME_unheard_of");
    QTest::newRow("not ASCII") << QStringLiteral("расширение");
    QTest::newRow("known, but not read") << QStringLiteral("KHR_node_visibility");
}

void tst_GltfSpecFiles::refusesUnknownDemands()
{
    QFETCH(const QString, name);
    GltfBuilder builder = GltfBuilder::triangle();
    builder.root["extensionsRequired"] = {"KHR_mesh_quantization", name.toStdString()};
    const Result<TemplatePtr> asset = read(builder.glb(), QStringLiteral("demanding.glb"));
    QVERIFY(!asset.isOk());
    QCOMPARE(QString::fromStdString(asset.error().message),
             QStringLiteral("demanding.glb: extensionsRequired[1] demands the extension %1, which "
                            "Crowdbrush cannot read; export the file without it.")
                 .arg(name));
}

void tst_GltfSpecFiles::readsUnlitAndGlowingMaterials()
{
    GltfBuilder builder = GltfBuilder::triangle();
    builder.add("materials", {{"emissiveFactor", {1, 0.5, 0}},
                              {"extensions",
                               {{"KHR_materials_unlit", Json::object()},
                                {"KHR_materials_emissive_strength", {{"emissiveStrength", 4}}}}}});
    primitive(builder)["material"] = 0;
    const MaterialChoice choice = m_folder.load(builder)->slots.front().choices.front();
    QVERIFY(choice.unlit);
    QCOMPARE(choice.emissive, glm::vec3(4, 2, 0));
}

void tst_GltfSpecFiles::readsTheOtherWorkflow()
{
    GltfBuilder builder = textured();
    addImage(builder, encoded(picture(), "png"), "image/png");
    builder.add("textures", {{"source", 0}});
    const Json diffuse = {{"diffuseFactor", {0.5, 0.25, 1, 1}}, {"diffuseTexture", {{"index", 0}}}};
    builder.root["materials"][0] = {
        {"extensions", {{"KHR_materials_pbrSpecularGlossiness", diffuse}}}};
    const TemplatePtr asset = m_folder.load(builder);
    QCOMPARE(asset->slots.front().choices.front().baseColor, glm::vec4(0.5F, 0.25F, 1, 1));
    QCOMPARE(imageOf(asset), 0);
}

void tst_GltfSpecFiles::warnsOfVariantsWithOtherCoordinates()
{
    GltfBuilder builder = textured();
    addImage(builder, encoded(picture(), "png"), "image/png");
    builder.add("textures", {{"source", 0}});
    builder.root["materials"].push_back(builder.root["materials"][0]);
    builder.root["extensions"]["KHR_materials_variants"] = {{"variants", {{{"name", "night"}}}}};
    primitive(builder)["extensions"]["KHR_materials_variants"] = {
        {"mappings", {{{"material", 1}, {"variants", {0}}}}}};
    QVERIFY(m_folder.load(builder)->warnings.empty());
    builder.root["materials"][1]["pbrMetallicRoughness"]["baseColorTexture"]["texCoord"] = 1;
    const TemplatePtr asset = m_folder.load(builder);
    QCOMPARE(asset->slots.front().choices[1].image, 0);
    QCOMPARE(asset->warnings.size(), std::size_t{1});
    QVERIFY(asset->warnings[0].english().find("variant \"night\"") != std::string::npos);
}

void tst_GltfSpecFiles::saysWhichCompressionItCannotRead()
{
    GltfBuilder builder = GltfBuilder::triangle();
    Json& view = builder.root["bufferViews"][0];
    Json extension = {{"buffer", 0}, {"byteLength", 36},     {"byteStride", 12},
                      {"count", 3},  {"mode", "ATTRIBUTES"}, {"filter", "COLOR"}};
    view["extensions"] = {{"KHR_meshopt_compression", extension}};
    const Result<TemplatePtr> filtered = read(builder.glb(), QStringLiteral("new.glb"));
    QVERIFY(!filtered.isOk());
    QVERIFY2(filtered.error().message.find("asks for the filter \"COLOR\"") != std::string::npos,
             filtered.error().message.c_str());
}

CROWD_TEST(tst_GltfSpecFiles)
#include "tst_GltfSpecFiles.moc"
