// SPDX-License-Identifier: MIT
#include <cmath>

#include <QtTest/QTest>

#include "tests/model/BrushScene.h"
#include "tests/program/Test.h"

using namespace crowd::test;

class tst_BrushColour : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void coloursOneSlotOrAllTintable();
    void halfStrengthIsHalfwayToTheFormerColour();
    void sparesSkinAndHairWhereThereAreClothes();
    void replacesOrMultipliesAndUndoesBoth();
    void coloursRandomlyFromTheList();
    void gradientRunsAlongTheLine();
    void gradientFollowsThePointerUntilRelease();
    void buildsUpOnlyWhenAsked();
};

void tst_BrushColour::coloursOneSlotOrAllTintable()
{
    BrushScene scene;
    const Ids ids = scene.addPeople({{-2, 0, 0}, {2, 0, 0}});
    BrushSettings settings = colourBrush(BrushSelection::Point);
    settings.as<ColourSettings>().strength = 0.5F;
    const View view = fromAbove();
    QCOMPARE(scene.paint(view, settings, {pixelOf(view, {-2, 0, 0})}).affected, 1);
    QCOMPARE(tintOf(scene, ids[0], 0), Tint{});
    QCOMPARE(tintOf(scene, ids[0], 1), (Tint{200, 100, 0, 128}));
    QCOMPARE(tintOf(scene, ids[0], 2), (Tint{200, 100, 0, 128}));
    settings.as<ColourSettings>().slot = "bottom";
    QCOMPARE(scene.paint(view, settings, {pixelOf(view, {2, 0, 0})}).affected, 1);
    QCOMPARE(tintOf(scene, ids[1], 1), Tint{});
    QCOMPARE(tintOf(scene, ids[1], 2), (Tint{200, 100, 0, 128}));
}

void tst_BrushColour::halfStrengthIsHalfwayToTheFormerColour()
{
    BrushScene scene;
    const Ids ids = scene.addPeople({{0, 0, 0}});
    const View view = fromAbove();
    const std::vector<glm::dvec2> there{pixelOf(view, {0, 0, 0})};
    BrushSettings settings = colourBrush(BrushSelection::Point);
    settings.as<ColourSettings>().colors = {{255, 0, 0}};
    (void)scene.paint(view, settings, there);
    QCOMPARE(tintOf(scene, ids[0], 1), (Tint{255, 0, 0, 255}));
    settings.as<ColourSettings>().colors = {{0, 0, 255}};
    settings.as<ColourSettings>().strength = 0.5F;
    (void)scene.paint(view, settings, there);
    QCOMPARE(tintOf(scene, ids[0], 1), (Tint{188, 0, 188, 255})); // half of the light of each
    (void)scene.paint(view, settings, there);
    const Tint nearer = tintOf(scene, ids[0], 1);
    QVERIFY(nearer.blue > 188 && nearer.red < 188 && nearer.strength == 255);
    // What is dyed half is covered by three quarters afterwards.
    settings.as<ColourSettings>().strength = 0.0F;
    settings.as<ColourSettings>().slot = "bottom";
    BrushScene other;
    const Ids fresh = other.addPeople({{0, 0, 0}});
    settings.as<ColourSettings>().strength = 0.5F;
    (void)other.paint(view, settings, there);
    QCOMPARE(tintOf(other, fresh[0], 2), (Tint{0, 0, 255, 128}));
    (void)other.paint(view, settings, there);
    QCOMPARE(tintOf(other, fresh[0], 2), (Tint{0, 0, 255, 192}));
    // A wipe over one spot colours once, however many dabs it has.
    BrushScene wiped;
    const Ids one = wiped.addPeople({{0, 0, 0}});
    (void)wiped.paint(view, settings, {there[0], there[0] + glm::dvec2(4.0, 0.0), there[0]});
    QCOMPARE(tintOf(wiped, one[0], 2), (Tint{0, 0, 255, 128}));
}

void tst_BrushColour::sparesSkinAndHairWhereThereAreClothes()
{
    const auto tintsAfter = [](const std::vector<std::string>& slots, const std::string& chosen) {
        BrushScene scene;
        auto man = std::make_shared<Template>(*boxMan());
        for (std::size_t i = 0; i < slots.size(); ++i) {
            man->slots[i].name = slots[i];
            man->slots[i].tintable = true;
        }
        const auto edit = scene.document.beginEdit().value();
        edit->changeTemplate(boxManEntry(1, man));
        edit->commit(QStringLiteral("Change"));
        const Ids ids = scene.addPeople({{0, 0, 0}});
        BrushSettings settings = colourBrush(BrushSelection::Point);
        settings.as<ColourSettings>().sparesBody = true;
        settings.as<ColourSettings>().slot = chosen;
        const View view = fromAbove();
        (void)scene.paint(view, settings, {pixelOf(view, {0, 0, 0})});
        std::string painted;
        for (int slot = 0; slot < 3; ++slot) {
            painted += tintOf(scene, ids[0], slot).strength > 0 ? 'x' : '-';
        }
        return painted;
    };
    QCOMPARE(tintsAfter({"Hair", "top", "left_skin"}, {}), std::string("-x-"));
    QCOMPARE(tintsAfter({"Hair", "top", "left_skin"}, "Hair"), std::string("x--"));
    QCOMPARE(tintsAfter({"fur", "body", "eyes"}, {}), std::string("xxx")); // wears nothing
}

void tst_BrushColour::replacesOrMultipliesAndUndoesBoth()
{
    BrushScene scene;
    const Ids ids = scene.addPeople({{0, 0, 0}});
    BrushSettings settings = colourBrush(BrushSelection::Point);
    const View view = fromAbove();
    const std::vector<glm::dvec2> there{pixelOf(view, {0, 0, 0})};
    const auto modes = [&] {
        return static_cast<int>(scene.people().column(columns::tintReplaces)[0]);
    };
    settings.as<ColourSettings>().slot = "top";
    settings.as<ColourSettings>().replaces = true;
    QCOMPARE(scene.paint(view, settings, there).affected, 1);
    QCOMPARE(modes(), 2);
    settings.as<ColourSettings>().slot = "bottom";
    settings.as<ColourSettings>().replaces = false;
    QCOMPARE(scene.paint(view, settings, there).affected, 1);
    QCOMPARE(modes(), 2);
    settings.as<ColourSettings>().slot = "top"; // the same colour in the other way is a change
    QCOMPARE(scene.paint(view, settings, there).affected, 1);
    QCOMPARE(modes(), 0);
    QCOMPARE(scene.paint(view, settings, there).reason, StrokeReason::Unchanged);
    scene.document.undoStack().undo();
    QCOMPARE(modes(), 2);
    QCOMPARE(tintOf(scene, ids[0], 1), (Tint{200, 100, 0, 255}));
}

void tst_BrushColour::coloursRandomlyFromTheList()
{
    BrushScene scene;
    const Ids ids = scene.addPeople(crowdGrid());
    BrushSettings settings = colourBrush(BrushSelection::Rectangle);
    settings.op = BrushOperator::Random;
    settings.distribution.weights.fill(0.0F);
    settings.distribution.weights[2] = 1.0F;
    settings.distribution.weights[14] = 3.0F;
    QCOMPARE(scene.paint(fromAbove(), settings, {{1.0, 1.0}, {1279.0, 767.0}}).affected, 60);
    int first = 0;
    for (const IndividualId id : ids) {
        const Tint tint = tintOf(scene, id, 1);
        QVERIFY(tint == (Tint{200, 100, 0, 255}) || tint == (Tint{0, 100, 200, 255}));
        QCOMPARE(tint, tintOf(scene, id, 2));
        first += tint.red == 200 ? 1 : 0;
    }
    QVERIFY2(first >= 6 && first <= 25, qPrintable(QString::number(first)));
}

void tst_BrushColour::gradientRunsAlongTheLine()
{
    BrushScene scene;
    const Ids ids = scene.addPeople(crowdGrid());
    BrushSettings settings = colourBrush(BrushSelection::Rectangle);
    settings.op = BrushOperator::Gradient;
    const View view = fromAbove();
    const glm::dvec2 from = pixelOf(view, {-6.0F, 0.0F, -4.0F});
    const glm::dvec2 to = pixelOf(view, {6.0F, 0.0F, 4.0F});
    QCOMPARE(scene.paint(view, settings, {from, to}).affected, 60);
    for (std::size_t i = 0; i < ids.size(); ++i) {
        const glm::vec3 foot = crowdGrid()[i];
        const double share = ((foot.x + 6.0) * 12.0 + (foot.z + 4.0) * 8.0) / (144.0 + 64.0);
        const Tint tint = tintOf(scene, ids[i], 1);
        QVERIFY(std::abs(tint.red - 200.0 * (1.0 - share)) <= 1.0);
        QVERIFY(std::abs(tint.blue - 200.0 * share) <= 1.0);
        QCOMPARE(tint.green, std::uint8_t{100});
    }
}

void tst_BrushColour::gradientFollowsThePointerUntilRelease()
{
    BrushScene scene;
    const Ids ids = scene.addPeople({{-2, 0, 0}, {0, 0, 0}, {2, 0, 0}});
    BrushSettings settings = colourBrush(BrushSelection::AllInCircle);
    settings.op = BrushOperator::Gradient;
    const View view = fromAbove();
    const auto at = [&](float x) { return PointerInput::at(pixelOf(view, {x, 0, 0}), 0.0); };
    const auto stroke = Stroke::begin(scene.document, scene.context(view), settings, 1, at(-2));
    stroke->move(at(0));
    QCOMPARE(tintOf(scene, ids[1], 1).blue, std::uint8_t{200});
    stroke->move(at(2));
    QCOMPARE(tintOf(scene, ids[0], 1).blue, std::uint8_t{0});
    QCOMPARE(tintOf(scene, ids[1], 1).blue, std::uint8_t{100});
    QCOMPARE(tintOf(scene, ids[2], 1).blue, std::uint8_t{200});
    QCOMPARE(stroke->finish().affected, 3);
}

void tst_BrushColour::buildsUpOnlyWhenAsked()
{
    const auto greenAfter = [](bool buildUp) {
        BrushScene scene;
        const Ids ids = scene.addPeople({{0, 0, 0}});
        BrushSettings settings = brush(BrushKind::Colour, BrushSelection::AllInCircle);
        settings.as<ColourSettings>().colors = {{0, 55, 0}};
        settings.buildUp = buildUp;
        settings.flow = 0.5F;
        const glm::dvec2 at = pixelOf(fromAbove(), {0, 0, 0});
        // Four dabs: 0, 10, 20 and 30 pixels from the press.
        scene.paint(fromAbove(), settings, {at, at + glm::dvec2(30.0, 0.0)});
        return static_cast<int>(tintOf(scene, ids[0], 1).green);
    };
    QCOMPARE(greenAfter(false), 55);
    // 255, 155, 105, 80, then 67.5 away from the old value.
    QCOMPARE(greenAfter(true), 67);
}

CROWD_TEST(tst_BrushColour)
#include "tst_BrushColour.moc"
