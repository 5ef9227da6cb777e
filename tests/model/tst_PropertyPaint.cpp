// SPDX-License-Identifier: MIT
#include "model/view/PropertyPaint.h"

#include <cmath>
#include <limits>
#include <set>

#include "tests/model/BrushScene.h"
#include "tests/program/Test.h"

using namespace crowd::test;
using crowd::model::paintBy;
using crowd::model::PropertyClass;
using crowd::model::PropertyPaint;

/// What people are coloured by.
class tst_PropertyPaint : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everybodyIsInAClass_data();
    void everybodyIsInAClass();
    void groupsHaveTheirColours();
    void severalTagsAreAClassOfTheirOwn();
    void featuresAreByKind();
    void clipsKeepTheirColours();
    void heightsAreInEvenSteps();
    void nobodysSpeedIsNone();
    void densityIsOfThePlaceWhereTheyStand();
    void aFrameTakesTheColours();
    void unknownPropertiesAreRefused();
};

namespace {

template<class T>
void set(BrushScene& scene, ColumnKey<T> key, const Ids& ids, T value)
{
    const auto edit = scene.document.beginEdit().value();
    edit->setColumn(key, ids, std::span<const T>(&value, 1));
    edit->commit(QStringLiteral("Set"));
}

PropertyPaint paint(const BrushScene& scene, std::string_view key)
{
    return paintBy(scene.document.scene(), scene.people(), key);
}

} // namespace

void tst_PropertyPaint::everybodyIsInAClass_data()
{
    QTest::addColumn<QString>("key");
    BrushScene scene;
    for (const std::string& key : propertyKeys(scene.document.scene())) {
        QTest::newRow(key.c_str()) << QString::fromStdString(key);
    }
    QTest::newRow("unknown") << QStringLiteral("shoe size");
}

void tst_PropertyPaint::everybodyIsInAClass()
{
    QFETCH(const QString, key);
    BrushScene scene;
    const Ids ids = scene.addPeople(crowdGrid());
    set(scene, columns::walkSpeed, {ids[0]}, std::numeric_limits<float>::quiet_NaN());
    set(scene, columns::height, {ids[1]}, std::numeric_limits<float>::infinity());
    set(scene, columns::position, {ids[2]}, glm::vec3(1e30F, 0.0F, -1e30F));
    set(scene, columns::clip, {ids[3]}, std::uint16_t{60000});
    set(scene, columns::templateId, {ids[4]}, crowd::model::TemplateId{60000});
    const PropertyPaint found = paint(scene, key.toStdString());
    QCOMPARE(found.classOfRow.size(), ids.size());
    std::size_t people = 0;
    for (std::size_t i = 0; i < found.classes.size(); ++i) {
        QVERIFY(found.classes[i].people > 0);
        QCOMPARE(peopleIn(found, i, scene.people()).size(), found.classes[i].people);
        people += found.classes[i].people;
    }
    QCOMPARE(people, ids.size());
    QVERIFY(paint(BrushScene(), key.toStdString()).classes.empty());
}

void tst_PropertyPaint::groupsHaveTheirColours()
{
    BrushScene scene;
    const Ids ids = scene.addPeople({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}});
    scene.document.edit(QStringLiteral("Groups"), [](crowd::model::SceneEdit& edit) {
        crowd::model::Group group;
        group.id = 7;
        group.name = "Fans";
        group.color = {10, 20, 30};
        edit.setGroups({group});
    });
    set(scene, columns::group, {ids[0]}, std::uint32_t{7});
    set(scene, columns::group, {ids[1]}, std::uint32_t{99});
    const PropertyPaint found = paint(scene, "group");
    QCOMPARE(found.classes.size(), std::size_t{3});
    QCOMPARE(found.classes[0].name, std::string("Fans"));
    QCOMPARE(found.classes[0].color, 0x0A141EU);
    QVERIFY(found.classes[1].kind == PropertyClass::Kind::Unnamed);
    QCOMPARE(found.classes[1].number, 99U);
    QVERIFY(found.classes[2].kind == PropertyClass::Kind::None); // comes last
    QCOMPARE(peopleIn(found, 1, scene.people()), Ids{ids[1]});
}

void tst_PropertyPaint::severalTagsAreAClassOfTheirOwn()
{
    BrushScene scene;
    const Ids ids = scene.addPeople({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}});
    set(scene, columns::tags, {ids[0]}, std::uint64_t{1});
    set(scene, columns::tags, {ids[1]}, std::uint64_t{1} << 63U);
    set(scene, columns::tags, {ids[2]}, std::uint64_t{5});
    const PropertyPaint found = paint(scene, "tag");
    QCOMPARE(found.classes.size(), std::size_t{4});
    QCOMPARE(found.classes[0].number, 0U);
    QCOMPARE(found.classes[1].number, 63U);
    QVERIFY(found.classes[2].kind == PropertyClass::Kind::Several);
    QVERIFY(found.classes[3].kind == PropertyClass::Kind::None);
    QVERIFY(found.classes[0].color != found.classes[1].color);
}

void tst_PropertyPaint::featuresAreByKind()
{
    BrushScene scene;
    scene.document.edit(QStringLiteral("Features"), [](crowd::model::SceneEdit& edit) {
        edit.setFeatures(crowd::model::readyFeatures());
    });
    const Ids ids = scene.addPeople({{0, 0, 0}, {1, 0, 0}});
    const auto& kind = scene.document.scene().features.front();
    set(scene, columns::feature(kind.id), {ids[1]}, kind.values[2].id);
    const PropertyPaint found = paint(scene, "feature:" + kind.name);
    QCOMPARE(found.classes.size(), std::size_t{2});
    QCOMPARE(found.classes[0].name, kind.values[2].name);
    QCOMPARE(peopleIn(found, 0, scene.people()), Ids{ids[1]});
}

/// Who plays what changes, what a colour means does not.
void tst_PropertyPaint::clipsKeepTheirColours()
{
    BrushScene scene;
    const Ids ids = scene.addPeople({{0, 0, 0}, {1, 0, 0}});
    const auto& names = scene.document.scene().templates.front().clipNames;
    QVERIFY(names.size() >= 2);
    set(scene, columns::clip, {ids[1]}, std::uint16_t{1});
    const PropertyPaint both = paint(scene, "clip");
    QCOMPARE(both.classes.size(), std::size_t{2});
    QCOMPARE(both.classes[1].name, names[1]);
    set(scene, columns::clip, {ids[0]}, std::uint16_t{1});
    const PropertyPaint one = paint(scene, "clip");
    QCOMPARE(one.classes.size(), std::size_t{1});
    QCOMPARE(one.classes[0].color, both.classes[1].color);
}

void tst_PropertyPaint::heightsAreInEvenSteps()
{
    BrushScene scene;
    const Ids ids = scene.addPeople({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}});
    QCOMPARE(paint(scene, "height").classes.size(), std::size_t{1}); // all are as tall
    set(scene, columns::height, {ids[0]}, 0.5F);
    set(scene, columns::height, {ids[2]}, 1.5F);
    const PropertyPaint found = paint(scene, "height");
    QCOMPARE(found.classes.size(), std::size_t{3});
    const double metres =
        static_cast<double>(scene.document.scene().templates.front().asset->height);
    QVERIFY(std::abs(found.classes.front().low - 0.5 * metres) < 1e-3);
    QVERIFY(std::abs(found.classes.back().high - 1.5 * metres) < 1e-3);
    QVERIFY(found.classes[0].high <= found.classes[1].low);
    QCOMPARE(QByteArray(found.unit.data(), static_cast<qsizetype>(found.unit.size())),
             QByteArray("m"));
}

void tst_PropertyPaint::nobodysSpeedIsNone()
{
    BrushScene scene;
    const Ids ids = scene.addPeople({{0, 0, 0}, {1, 0, 0}});
    set(scene, columns::walkSpeed, {ids[0]}, 1.4F);
    set(scene, columns::walkSpeed, {ids[1]}, 0.0F);
    const PropertyPaint found = paint(scene, "walkSpeed");
    QCOMPARE(found.classes.size(), std::size_t{2});
    QVERIFY(std::abs(found.classes[0].low - 1.4) < 1e-6);
    QVERIFY(found.classes[1].kind == PropertyClass::Kind::None);
}

/// One alone has all the room there is; forty within a metre of each other are a crush.
void tst_PropertyPaint::densityIsOfThePlaceWhereTheyStand()
{
    BrushScene scene;
    std::vector<glm::vec3> places{{100.0F, 0.0F, 0.0F}};
    for (int i = 0; i < 40; ++i) {
        places.emplace_back(static_cast<float>(i % 8) * 0.1F, 0.0F,
                            static_cast<float>(i / 8) * 0.1F);
    }
    (void)scene.addPeople(places);
    const PropertyPaint found = paint(scene, "density");
    QCOMPARE(found.classes.size(), std::size_t{2});
    QCOMPARE(found.classes[0].low, 0.0);
    QCOMPARE(found.classes[0].people, std::size_t{1});
    QCOMPARE(found.classes[1].people, std::size_t{40});
    QVERIFY(std::isinf(found.classes[1].high));
}

void tst_PropertyPaint::aFrameTakesTheColours()
{
    BrushScene scene;
    const Ids ids = scene.addPeople({{0, 0, 0}, {1, 0, 0}});
    set(scene, columns::tags, {ids[1]}, std::uint64_t{1});
    const Scene& now = scene.document.scene();
    crowd::model::CrowdFrame frame;
    frame.population = now.population;
    frame.seconds = 3.0;
    const auto painted = framePaintedBy(now, frame, "tag");
    const auto tints = painted->population.column(columns::tint(0));
    QVERIFY(tints[0] != tints[1]);
    QCOMPARE(static_cast<std::uint32_t>(tints[1].red) << 16U |
                 static_cast<std::uint32_t>(tints[1].green) << 8U | tints[1].blue,
             tagColor(now, 0));
    QCOMPARE(painted->seconds, 3.0);
    QVERIFY(painted->population.version() != frame.population.version());
    QVERIFY(frame.population == now.population); // the scene's own stay
}

void tst_PropertyPaint::unknownPropertiesAreRefused()
{
    BrushScene scene;
    const Scene& now = scene.document.scene();
    QVERIFY(checkProperty(now, "density"));
    const auto refused = checkProperty(now, "shoe size");
    QVERIFY(!refused);
    QVERIFY(QString::fromStdString(refused.error().message).contains(QLatin1String("shoe size")));
    QVERIFY(QString::fromStdString(refused.error().message).contains(QLatin1String("walkSpeed")));
    QVERIFY(!checkProperty(now, "feature:"));
}

CROWD_TEST(tst_PropertyPaint)
#include "tst_PropertyPaint.moc"
