// SPDX-License-Identifier: MIT
#include <QtTest/QTest>

#include "app/pictures/LookWish.h"
#include "tests/program/Test.h"

using namespace crowd;
using app::chosenLook;

namespace {

model::Scene sceneWithLooks()
{
    model::Scene scene;
    model::LookPreset dusk;
    dusk.id = 3;
    dusk.name = "Late";
    dusk.light = model::LookLight::Dusk;
    model::LookPreset groups;
    groups.id = 5;
    groups.name = "Groups";
    groups.style = model::LookStyle::Property;
    groups.property = "group";
    scene.looks = {dusk, groups};
    scene.cameras = {{"Stalls", {}, 5}, {"Gallery", {}}};
    return scene;
}

std::string refusal(const app::LookWish& wish)
{
    const auto look = chosenLook(wish, sceneWithLooks());
    return look ? std::string() : look.error().message;
}

} // namespace

/// How a picture is drawn, as people ask for it.
class TestLookWish : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void withoutAWishItIsLit();
    void aNameIsOfTheScene();
    void aCameraHasItsLook();
    void coloursOfAPropertyImplyTheirLook();
    void whatCannotBeIsRefused();
};

void TestLookWish::withoutAWishItIsLit()
{
    const auto look = chosenLook({}, sceneWithLooks());
    QVERIFY(look.isOk());
    QVERIFY(look.value().look == render::Look::Lit && !look.value().own);
    QVERIFY(chosenLook({"clay", "", "Stalls"}, sceneWithLooks()).value().look ==
            render::Look::Clay);
}

void TestLookWish::aNameIsOfTheScene()
{
    const auto look = chosenLook({"Groups", ""}, sceneWithLooks());
    QVERIFY(look.isOk());
    QVERIFY(look.value().look == render::Look::Property);
    QCOMPARE(look.value().property, std::string("group"));
    QVERIFY(look.value().own && look.value().own->id == 5);
}

void TestLookWish::aCameraHasItsLook()
{
    const model::Scene scene = sceneWithLooks();
    QVERIFY(chosenLook({"", "", "Stalls"}, scene).value().own);
    QVERIFY(chosenLook({"", "", ""}, scene).value().own); // the first one
    QVERIFY(!chosenLook({"", "", "Gallery"}, scene).value().own);
    QVERIFY(!chosenLook({"", "", "nobody's"}, scene).value().own);
    QVERIFY(!chosenLook({"", "", ""}, model::Scene()).value().own);
    QCOMPARE(chosenLook({"Late", "", "Stalls"}, scene).value().own->id, model::LookId{3});
}

void TestLookWish::coloursOfAPropertyImplyTheirLook()
{
    const model::Scene scene = sceneWithLooks();
    const auto plain = chosenLook({"", "tag"}, scene);
    QVERIFY(plain.isOk() && plain.value().look == render::Look::Property);
    const auto late = chosenLook({"Late", "tag"}, scene);
    QVERIFY(late.isOk() && late.value().look == render::Look::Property);
    QVERIFY(late.value().own->style == model::LookStyle::Property); // in the light of the evening
    QVERIFY(late.value().own->light == model::LookLight::Dusk);
}

void TestLookWish::whatCannotBeIsRefused()
{
    const std::string unknown = refusal({"oil", ""});
    QVERIFY(unknown.find("\"oil\"") != std::string::npos);
    QVERIFY(unknown.find("plain, lit") != std::string::npos);
    QVERIFY(unknown.find("Late, Groups") != std::string::npos);
    QVERIFY(refusal({"cartoon", "tag"}).find("leave one of the two out") != std::string::npos);
    QVERIFY(refusal({"", "shoes"}).find("shoes") != std::string::npos);
}

CROWD_TEST(TestLookWish)
#include "tst_LookWish.moc"
