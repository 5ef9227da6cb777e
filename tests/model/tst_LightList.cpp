// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string_view>

#include <QtTest/QTest>

#include "model/document/SceneEdit.h"
#include "model/project/ProjectReader.h"
#include "model/scene/LightAim.h"
#include "tests/model/ProjectText.h"
#include "tests/program/Test.h"

using namespace crowd::model;
using crowd::testing::projectText;

namespace {

Lights twoLights()
{
    Light spot;
    spot.id = 3;
    spot.name = "Left";
    spot.color = {10, 20, 30};
    spot.aim = LightAim::Person;
    spot.person = 12;
    spot.coneRadians = 1.25F;
    Light point;
    point.id = 9;
    point.name = "Lamp";
    point.kind = LightKind::Point;
    point.isOn = false;
    point.position = {1.0F, 2.5F, -3.0F};
    return {spot, point};
}

CrowdFrame frameWith(const Population& people)
{
    CrowdFrame frame;
    frame.population = people;
    return frame;
}

} // namespace

/// Lights of a scene as data.
class TestLightList : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void filesKeepThem();
    void anotherKindKeepsWhatItHad();
    void filesFromBeforeHaveNone();
    void whatIsNotKnownIsKept();
    void refusesWhatIsWrong_data();
    void refusesWhatIsWrong();
    void aimsAtPeopleWhereTheyAre();
    void idsAreNotUsedAgain();
};

void TestLightList::filesKeepThem()
{
    SceneDocument document;
    const std::string before = projectText(document.scene());
    document.edit(QStringLiteral("Lights"), [](SceneEdit& edit) { edit.setLights(twoLights()); });
    const std::string text = projectText(document.scene());
    const auto read = projectFromText(text);
    QVERIFY2(read.isOk(), read ? "" : read.error().message.c_str());
    QVERIFY(read.value().lights == twoLights());
    QCOMPARE(projectText(read.value()), text);
    document.undoStack().undo();
    QCOMPARE(projectText(document.scene()), before);
}

void TestLightList::anotherKindKeepsWhatItHad()
{
    Light light = newLight(LightKind::Spot, {1.0F, 0.0F, 2.0F}, {0.0F, 2.0F, 9.0F});
    light.coneRadians = 1.25F;
    const glm::vec3 target = light.target;
    const FieldInfo& kind = *std::ranges::find_if(fieldsOf<Light>(), [](const FieldInfo& each) {
        return std::string_view(each.meta.key) == "kind";
    });
    kind.set(&light, std::int64_t{1});
    QVERIFY(!isAimed(light));
    kind.set(&light, std::int64_t{0});
    QVERIFY(isAimed(light) && light.coneRadians == 1.25F && light.target == target);
}

void TestLightList::filesFromBeforeHaveNone()
{
    const std::string text = projectText(Scene());
    QVERIFY(text.find("\"lights\"") == std::string::npos);
    QVERIFY(projectFromText(text).value().lights.empty());
}

void TestLightList::whatIsNotKnownIsKept()
{
    Scene scene;
    scene.lights = twoLights();
    scene.lights[1].unknownMembers = R"({"gobo":"leaves"})";
    const std::string text = projectText(scene);
    const auto read = projectFromText(text);
    QVERIFY(read.isOk());
    QCOMPARE(projectText(read.value()), text);
    QVERIFY(text.find("gobo") != std::string::npos);
}

void TestLightList::refusesWhatIsWrong_data()
{
    QTest::addColumn<QByteArray>("light");
    QTest::addColumn<QString>("said");
    const auto row = [](const char* name, const char* light, const char* said) {
        QTest::newRow(name) << QByteArray(light) << QString::fromUtf8(said);
    };
    row("no cone", R"({"id": 1, "cone": 0})", "lights[0].cone must lie between");
    row("a half turn", R"({"id": 1, "cone": 3.1415927})", "lights[0].cone must lie between");
    row("negative", R"({"id": 1, "strength": -1})", "lights[0].strength must lie between");
    row("beyond all", R"({"id": 1, "strength": 1e30})", "lights[0].strength must lie between");
    row("nowhere", R"({"id": 1, "position": [0, 1e30, 0]})", "lights[0].position");
    row("no number", R"({"id": 1, "position": [0, null, 0]})", "lights[0].position");
    row("another kind", R"({"id": 1, "kind": "laser"})", "lights[0].kind must be one of");
    row("no colour", R"({"id": 1, "color": "red"})", "lights[0].color");
    row("twice", R"({"id": 1}, {"id": 1})", "the id 1 is given twice");
    row("no id", R"({"id": 0})", "lights[0].id");
    row("no list", R"(7)", "lights[0] must be an object");
}

void TestLightList::refusesWhatIsWrong()
{
    QFETCH(const QByteArray, light);
    QFETCH(const QString, said);
    std::string text = projectText(Scene());
    text.insert(text.find('{') + 1, "\"lights\": [" + light.toStdString() + "],");
    const auto read = projectFromText(text);
    QVERIFY(!read.isOk());
    const QString message = QString::fromStdString(read.error().message);
    QVERIFY2(message.contains(said), qPrintable(message));
}

void TestLightList::aimsAtPeopleWhereTheyAre()
{
    SceneDocument document;
    document.edit(QStringLiteral("Add"), [](SceneEdit& edit) {
        auto rows = IndividualRows::withDefaults(std::vector<IndividualId>(3));
        rows.column(columns::position)[0] = {1.0F, 0.0F, 0.0F};
        rows.column(columns::position)[1] = {5.0F, 1.0F, 2.0F};
        rows.column(columns::position)[2] = {7.0F, 1.0F, 4.0F};
        rows.column(columns::group)[1] = 4;
        rows.column(columns::group)[2] = 4;
        (void)edit.addIndividuals(std::move(rows));
    });
    const CrowdFrame frame = frameWith(document.scene().population);
    Light light;
    light.target = {9.0F, 9.0F, 9.0F};
    QVERIFY(aimedAt(light, &frame) == light.target);
    light.aim = LightAim::Person;
    QVERIFY(aimedAt(light, &frame) == light.target); // nobody is chosen yet
    light.person = document.scene().population.ids()[0];
    QVERIFY(aimedAt(light, &frame).value().x == 1.0F);
    QVERIFY(aimedAt(light, &frame).value().y > 0.5F); // not at his feet
    light.person = 99;
    QVERIFY(!aimedAt(light, &frame));
    QVERIFY(!aimedAt(light, nullptr));
    light.aim = LightAim::Group;
    light.group = 4;
    QVERIFY(aimedAt(light, &frame).value().x == 6.0F);
    QVERIFY(aimedAt(light, &frame).value().z == 3.0F);
    light.group = 5;
    QVERIFY(!aimedAt(light, &frame));
}

void TestLightList::idsAreNotUsedAgain()
{
    Lights lights = twoLights();
    QCOMPARE(freeLightId({}), LightId{1});
    QCOMPARE(freeLightId(lights), LightId{10});
    QCOMPARE(freeLightId(lights, 20), LightId{21}); // a rule names one that is gone
    lights.back().id = 0xFFFFFFFFU;
    QCOMPARE(freeLightId(lights), LightId{0});
    QVERIFY(findLight(lights, 3) == &lights.front());
    QVERIFY(findLight(lights, 4) == nullptr);
}

CROWD_TEST(TestLightList)
#include "tst_LightList.moc"
