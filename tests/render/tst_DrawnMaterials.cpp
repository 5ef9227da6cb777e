// SPDX-License-Identifier: MIT
#include <cmath>

#include <QtTest/QtTest>

#include "tests/model/GltfFolder.h"
#include "tests/program/Test.h"
#include "tests/render/FileDrawing.h"
#include "tests/render/QuadFiles.h"

using namespace crowd;
using namespace crowd::testing;

namespace {

struct Colour
{
    int red = 0;
    int green = 0;
    int blue = 0;
};

constexpr Colour kRed{255, 0, 0};
constexpr Colour kBlue{0, 0, 255};
constexpr Colour kWhite{255, 255, 255};
constexpr Colour kBlack{0, 0, 0};
constexpr Colour kWall{0, 255, 0};
constexpr int kCentre = FileDrawing::kPixels / 2;
constexpr float kMetres = 2.5F; ///< height of a picture of one square

/// A square of one colour, linear.
GltfBuilder plain(const std::array<float, 4>& colour, const char* alphaMode = "OPAQUE")
{
    GltfBuilder builder = quad();
    builder.root["materials"][0] = {{"pbrMetallicRoughness", {{"baseColorFactor", colour}}},
                                    {"alphaMode", alphaMode}};
    return builder;
}

QImage halves(const QColor& left, const QColor& right)
{
    QImage picture(2, 1, QImage::Format_RGBA8888);
    picture.setPixelColor(0, 0, left);
    picture.setPixelColor(1, 0, right);
    return picture;
}

/// Half of one linear colour over half of another, encoded.
int halfOver(int front, int behind)
{
    const auto linear = [](int value) {
        return std::pow((value / 255.0 + 0.055) / 1.055, 2.4) * (value > 0 ? 1.0 : 0.0);
    };
    const double mixed = 0.5 * linear(front) + 0.5 * linear(behind);
    return mixed <= 0.0 ? 0 : static_cast<int>(255.0 * (1.055 * std::pow(mixed, 1 / 2.4) - 0.055));
}

struct Standing
{
    model::TemplateId templateId = 1;
    float z = 0.0F; ///< metres towards the eye
};

model::Population peopleAt(const std::vector<Standing>& standing)
{
    model::Population people = makeRow(standing.size());
    for (std::size_t i = 0; i < standing.size(); ++i) {
        const model::IndividualId id = people.ids()[i];
        const glm::vec3 position(0.0F, 0.0F, standing[i].z);
        people.setValues(model::columns::templateId, {&id, 1}, {&standing[i].templateId, 1});
        people.setValues(model::columns::position, {&id, 1}, {&position, 1});
    }
    return people;
}

} // namespace

/// Materials of imported characters as they are seen: what shines, what is seen through, and how
/// pictures are repeated.
class TestDrawnMaterials : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void cleanupTestCase();
    void shinesWhereThePictureDoes();
    void glassShowsWhoIsBehind();
    void glassIsDrawnFarthestFirst();
    void clearPartsOfBlendedPicturesAreNotSeen();
    void ghostsAreSeenThroughToo();
    void choicesOfOneSlotBlendOnTheirOwn();
    void everyPictureHasItsSampler();
    void manyMaterialsKeepTheirColours();
    void manyPicturesAreDrawn();

private:
    [[nodiscard]] DrawnFile draw(const GltfBuilder& builder);
    [[nodiscard]] DrawnFile drawAll(const std::vector<GltfBuilder>& files,
                                    const std::vector<Standing>& standing);

    gltf_samples::GltfFolder m_folder;
    std::unique_ptr<FileDrawing> m_drawing;
};

void TestDrawnMaterials::initTestCase()
{
    m_drawing = std::make_unique<FileDrawing>();
    QVERIFY2(m_drawing->problem().empty(), m_drawing->problem().c_str());
}

void TestDrawnMaterials::cleanupTestCase()
{
    m_drawing.reset();
}

DrawnFile TestDrawnMaterials::draw(const GltfBuilder& builder)
{
    return drawAll({builder}, {{1, 0.0F}});
}

DrawnFile TestDrawnMaterials::drawAll(const std::vector<GltfBuilder>& files,
                                      const std::vector<Standing>& standing)
{
    std::vector<model::TemplateEntry> entries;
    for (const GltfBuilder& file : files) {
        entries.push_back(
            entryFor(m_folder.load(file), static_cast<model::TemplateId>(entries.size() + 1)));
    }
    return m_drawing->drawPeople(peopleAt(standing), entries, kMetres, {0, 0, 1});
}

bool isColour(const DrawnFile& drawn, int x, int y, const Colour& expected)
{
    const std::uint8_t* pixel = drawn.at(x, y);
    const bool isSame = std::abs(pixel[0] - expected.red) < 6 &&
                        std::abs(pixel[1] - expected.green) < 6 &&
                        std::abs(pixel[2] - expected.blue) < 6;
    if (!isSame) {
        qWarning("at %d, %d: %d %d %d instead of %d %d %d", x, y, pixel[0], pixel[1], pixel[2],
                 expected.red, expected.green, expected.blue);
    }
    return isSame;
}

void TestDrawnMaterials::shinesWhereThePictureDoes()
{
    GltfBuilder builder = quad();
    const int glow = addPicture(builder, halves(Qt::black, Qt::white)); // its texture is 1
    builder.root["materials"].erase(static_cast<std::size_t>(glow));
    builder.root["materials"][0]["emissiveFactor"] = {1, 1, 1};
    builder.root["materials"][0]["emissiveTexture"] = {{"index", 1}};
    const DrawnFile half = draw(builder);
    QVERIFY(isColour(half, 40, 40, kRed));
    QVERIFY(isColour(half, 40, 88, kBlue));
    QVERIFY(isColour(half, 88, 40, kWhite));
    // By its own transform: shifted by half its width.
    builder.root["materials"][0]["emissiveTexture"]["extensions"]["KHR_texture_transform"] = {
        {"offset", {0.5, 0}}};
    const DrawnFile shifted = draw(builder);
    QVERIFY(isColour(shifted, 40, 40, kWhite));
    QVERIFY(isColour(shifted, 88, 40, {255, 255, 0}));
    QVERIFY(isColour(shifted, 88, 88, kWhite)); // white it is of itself
}

void TestDrawnMaterials::glassShowsWhoIsBehind()
{
    const std::vector<GltfBuilder> files{plain({1, 1, 1, 0.5F}, "BLEND"), plain({1, 0, 0, 1})};
    const Colour pink{255, halfOver(255, 0), halfOver(255, 0)};
    // Whoever is drawn first: the glass before the red one, as first and as second template.
    QVERIFY(isColour(drawAll(files, {{1, 1}, {2, -1}}), kCentre, kCentre, pink));
    QVERIFY(isColour(drawAll({files[1], files[0]}, {{1, -1}, {2, 1}}), kCentre, kCentre, pink));
    // Behind the red one it is not seen, and alone it shows the wall.
    QVERIFY(isColour(drawAll(files, {{1, -1}, {2, 1}}), kCentre, kCentre, kRed));
    QVERIFY(isColour(draw(files[0]), kCentre, kCentre, {halfOver(255, 0), 255, halfOver(255, 0)}));
}

void TestDrawnMaterials::glassIsDrawnFarthestFirst()
{
    const GltfBuilder red = plain({1, 0, 0, 0.5F}, "BLEND");
    const GltfBuilder blue = plain({0, 0, 1, 0.5F}, "BLEND");
    const DrawnFile redFirst = drawAll({red, blue}, {{1, 1}, {2, -1}});
    const DrawnFile blueFirst = drawAll({red, blue}, {{1, -1}, {2, 1}});
    const std::uint8_t* a = redFirst.at(kCentre, kCentre);
    const std::uint8_t* b = blueFirst.at(kCentre, kCentre);
    QVERIFY(a[0] > a[2] + 30);
    QVERIFY(b[2] > b[0] + 30);
    // The same whatever the order of templates and individuals is.
    QVERIFY(drawAll({blue, red}, {{2, 1}, {1, -1}}).pixels == redFirst.pixels);
    QVERIFY(drawAll({red, blue}, {{2, -1}, {1, 1}}).pixels == redFirst.pixels);
}

void TestDrawnMaterials::clearPartsOfBlendedPicturesAreNotSeen()
{
    GltfBuilder builder = quad();
    builder.root["images"][0]["uri"] = dataUri(halves(QColor(255, 0, 0), QColor(255, 255, 255, 0)));
    builder.root["materials"][0]["alphaMode"] = "BLEND";
    const DrawnFile drawn = drawAll({builder, plain({0, 0, 1, 1})}, {{1, 1}, {2, -1}});
    QVERIFY(isColour(drawn, 40, kCentre, kRed));
    QVERIFY(isColour(drawn, 88, kCentre, kBlue));
    // What is solid of it hides glass behind it, which is drawn later.
    const DrawnFile hidden = drawAll({builder, plain({0, 0, 1, 0.5F}, "BLEND")}, {{1, 1}, {2, -1}});
    QVERIFY(isColour(hidden, 40, kCentre, kRed));
    QVERIFY(isColour(hidden, 88, kCentre, {0, halfOver(255, 0), halfOver(255, 0)}));
}

void TestDrawnMaterials::ghostsAreSeenThroughToo()
{
    render::Ghost ghost;
    ghost.asset = m_folder.load(plain({1, 1, 1, 0.5F}, "BLEND"));
    ghost.alpha = 1.0F;
    QVERIFY(isColour(m_drawing->drawGhost(ghost, kMetres), kCentre, kCentre,
                     {halfOver(255, 0), 255, halfOver(255, 0)}));
    ghost.alpha = 0.001F;
    QVERIFY(isColour(m_drawing->drawGhost(ghost, kMetres), kCentre, kCentre, kWall));
}

void TestDrawnMaterials::choicesOfOneSlotBlendOnTheirOwn()
{
    GltfBuilder builder = plain({1, 0, 0, 0.2F});
    builder.root["extensions"]["KHR_materials_variants"] = {{"variants", {{{"name", "glass"}}}}};
    builder.add("materials", {{"alphaMode", "BLEND"},
                              {"pbrMetallicRoughness", {{"baseColorFactor", {0, 0, 1, 0.5}}}}});
    primitiveOf(builder)["extensions"]["KHR_materials_variants"] = {
        {"mappings", {{{"material", 1}, {"variants", {0}}}}}};
    QVERIFY(isColour(draw(builder), kCentre, kCentre, kRed)); // opaque whatever its alpha says
    model::Population people = peopleAt({{1, 0.0F}});
    setAll(people, model::columns::materialChoices, model::MaterialChoices{1});
    const DrawnFile glass =
        m_drawing->drawPeople(people, {entryFor(m_folder.load(builder))}, kMetres, {0, 0, 1});
    QVERIFY(isColour(glass, kCentre, kCentre, {0, halfOver(255, 0), halfOver(255, 0)}));
}

/// Two squares side by side by the same coordinates, which go beyond the pictures' edges.
void TestDrawnMaterials::everyPictureHasItsSampler()
{
    for (const bool isClampedFirst : {true, false}) {
        GltfBuilder builder = quad({-1, 1, 0, -1, -1, 0, 0, -1, 0, 0, 1, 0},
                                   {0, 0, 0, 1, 2, 1, 2, 0}); // twice the width
        builder.root.erase("images");
        builder.root.erase("samplers");
        builder.root.erase("textures");
        builder.root.erase("materials");
        const QImage picture = halves(Qt::white, Qt::black);
        const Json clamped = {{"wrapS", 33071}, {"wrapT", 33071}};
        addPicture(builder, picture, isClampedFirst ? clamped : Json::object());
        addPicture(builder, picture, isClampedFirst ? Json::object() : clamped);
        Json right = primitiveOf(builder);
        right["attributes"]["POSITION"] =
            builder.accessor<float>({0, 1, 0, 0, -1, 0, 1, -1, 0, 1, 1, 0}, "VEC3");
        right["material"] = 1;
        builder.root["meshes"][0]["primitives"].push_back(right);
        const DrawnFile drawn = draw(builder);
        const int clampedSide = isClampedFirst ? kCentre - 51 : kCentre;
        const int repeatedSide = isClampedFirst ? kCentre : kCentre - 51;
        // At an eighth, three, five and seven of each side, 51 pixels wide.
        for (const auto& [x, isWhite] : {std::pair(6, true), {19, false}, {44, false}}) {
            QVERIFY(isColour(drawn, clampedSide + x, kCentre, isWhite ? kWhite : kBlack));
            QVERIFY(isColour(drawn, repeatedSide + x, kCentre, isWhite ? kWhite : kBlack));
        }
        QVERIFY(isColour(drawn, clampedSide + 32, kCentre, kBlack));
        QVERIFY(isColour(drawn, repeatedSide + 32, kCentre, kWhite));
    }
}

/// A row of narrow stripes, each of a material of its own.
void TestDrawnMaterials::manyMaterialsKeepTheirColours()
{
    GltfBuilder builder = quad();
    const Json attributes = attributesOf(builder);
    const Json indices = primitiveOf(builder)["indices"];
    builder.root["meshes"][0]["primitives"] = Json::array();
    builder.root["materials"] = Json::array();
    for (int i = 0; i < 400; ++i) {
        // All but the last are black and have no extent.
        const bool isLast = i == 399;
        builder.add("materials",
                    {{"pbrMetallicRoughness",
                      {{"baseColorFactor", isLast ? Json{1, 0, 0, 1} : Json{0, 0, 0, 1}}}}});
        Json part = {{"attributes", attributes}, {"indices", indices}, {"material", i}};
        if (!isLast) {
            part["indices"] = builder.accessor<std::uint16_t>({0, 0, 1}, "SCALAR");
        }
        builder.root["meshes"][0]["primitives"].push_back(part);
    }
    QVERIFY(isColour(draw(builder), kCentre, kCentre, kRed));
}

/// More than a card has layers for in one array.
void TestDrawnMaterials::manyPicturesAreDrawn()
{
    GltfBuilder builder = quad();
    Json part = primitiveOf(builder);
    builder.root["meshes"][0]["primitives"] = Json::array();
    const int nothing = builder.accessor<std::uint16_t>({0, 0, 1}, "SCALAR");
    for (int i = 0; i < 300; ++i) {
        part["material"] = addPicture(builder, halves(Qt::black, Qt::black));
        Json none = part;
        none["indices"] = nothing;
        builder.root["meshes"][0]["primitives"].push_back(none);
    }
    part["material"] = addPicture(builder, halves(Qt::red, Qt::blue));
    builder.root["meshes"][0]["primitives"].push_back(part);
    const DrawnFile drawn = draw(builder);
    QVERIFY(isColour(drawn, 40, kCentre, kRed));
    QVERIFY(isColour(drawn, 88, kCentre, kBlue));
}

CROWD_TEST(TestDrawnMaterials)
#include "tst_DrawnMaterials.moc"
