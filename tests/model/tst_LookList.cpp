// SPDX-License-Identifier: MIT
#include <QtCore/QFile>
#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>

#include "model/document/SceneEdit.h"
#include "model/project/FeatureFile.h"
#include "model/project/LookFile.h"
#include "model/project/ProjectReader.h"
#include "tests/model/ProjectText.h"
#include "tests/program/Test.h"

using namespace crowd::model;
using crowd::testing::projectText;

namespace {

/// Not by their ids: the order is the one in which they are shown.
Looks twoLooks()
{
    LookPreset evening;
    evening.id = 7;
    evening.name = "Evening";
    evening.light = LookLight::Dusk;
    evening.hasBackground = true;
    evening.background = {1, 2, 3};
    evening.light = LookLight::Own;
    evening.ownLight.sunStrength = 0.25F;
    evening.ownLight.skyZenith = {0.1F, 0.0F, 0.2F};
    LookPreset plan;
    plan.id = 2;
    plan.name = "Plan";
    plan.style = LookStyle::Property;
    plan.property = "tag";
    plan.isTwoTone = true;
    plan.hasLamps = false;
    plan.hasShadows = false;
    plan.hasGround = false;
    plan.hasOutline = true;
    plan.outlinePixels = 4.5F;
    plan.outline = {9, 8, 7};
    return {evening, plan};
}

std::string fileWith(const std::string& looks)
{
    std::string text = projectText(Scene());
    text.insert(text.find('{') + 1, "\"looks\": [" + looks + "],");
    return text;
}

} // namespace

/// Looks of a scene as data, in projects and in files of their own.
class TestLookList : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void filesKeepThemInTheirOrder();
    void filesLeaveOutALightThatIsNotItsOwn();
    void filesFromBeforeHaveNone();
    void camerasNameOne();
    void whatIsNotKnownIsKept();
    void refusesWhatIsWrong_data();
    void refusesWhatIsWrong();
    void idsAreNotUsedAgain();
    void aFileOfLooksIsSharedByProjects();
    void hostileFilesAreRefused_data();
    void hostileFilesAreRefused();
    void thereIsAnEndToRoom();
};

void TestLookList::filesKeepThemInTheirOrder()
{
    SceneDocument document;
    const std::string before = projectText(document.scene());
    document.edit(QStringLiteral("Looks"), [](SceneEdit& edit) { edit.setLooks(twoLooks()); });
    const std::string text = projectText(document.scene());
    const auto read = projectFromText(text);
    QVERIFY2(read.isOk(), read ? "" : read.error().message.c_str());
    QVERIFY(read.value().looks == twoLooks());
    QCOMPARE(projectText(read.value()), text);
    document.undoStack().undo();
    QCOMPARE(projectText(document.scene()), before);
}

void TestLookList::filesLeaveOutALightThatIsNotItsOwn()
{
    Scene scene;
    scene.looks = twoLooks();
    scene.looks.erase(scene.looks.begin());
    QVERIFY(projectText(scene).find("ownLight") == std::string::npos);
}

void TestLookList::filesFromBeforeHaveNone()
{
    const std::string text = projectText(Scene());
    QVERIFY(text.find("\"looks\"") == std::string::npos);
    QVERIFY(projectFromText(text).value().looks.empty());
}

void TestLookList::camerasNameOne()
{
    Scene scene;
    scene.looks = twoLooks();
    scene.cameras = {{"Stalls", {}, 7}, {"Gallery", {}}, {"Gone", {}, 40}};
    const std::string text = projectText(scene);
    const auto read = projectFromText(text);
    QVERIFY2(read.isOk(), read ? "" : read.error().message.c_str());
    QCOMPARE(read.value().cameras[0].look, LookId{7});
    QCOMPARE(read.value().cameras[1].look, LookId{0});
    QCOMPARE(read.value().cameras[2].look, LookId{40}); // undo may bring it back
    QCOMPARE(projectText(read.value()), text);
}

void TestLookList::whatIsNotKnownIsKept()
{
    Scene scene;
    scene.looks = twoLooks();
    scene.looks[1].unknownMembers = R"({"grain":0.5})";
    scene.looks[0].ownLight.unknownMembers = R"({"moons":2})";
    const std::string text = projectText(scene);
    const auto read = projectFromText(text);
    QVERIFY(read.isOk());
    QCOMPARE(projectText(read.value()), text);
    QVERIFY(text.find("grain") != std::string::npos);
    QVERIFY(text.find("moons") != std::string::npos);
}

void TestLookList::refusesWhatIsWrong_data()
{
    QTest::addColumn<QByteArray>("look");
    QTest::addColumn<QString>("said");
    const auto row = [](const char* name, const char* look, const char* said) {
        QTest::newRow(name) << QByteArray(look) << QString::fromUtf8(said);
    };
    row("of a newer version", R"({"id": 1, "name": "A", "style": "oil"})",
        "looks[0].style must be one of");
    row("an own light beyond all",
        R"({"id": 1, "name": "A", "light": "own", "ownLight": {"sunStrength": 1e30}})",
        "looks[0].ownLight.sunStrength must lie between");
    row("an own light that is none", R"({"id": 1, "name": "A", "ownLight": 7})",
        "looks[0].ownLight must be an object");
    row("no such light", R"({"id": 1, "name": "A", "light": "moon"})",
        "looks[0].light must be one of");
    row("no colour", R"({"id": 1, "name": "A", "background": [1, 2]})", "looks[0].background");
    row("beyond all", R"({"id": 1, "name": "A", "outlineWidth": 1e30})",
        "looks[0].outlineWidth must lie between");
    row("negative", R"({"id": 1, "name": "A", "outlineWidth": -1})",
        "looks[0].outlineWidth must lie between");
    row("no number", R"({"id": 1, "name": "A", "outlineWidth": null})", "looks[0].outlineWidth");
    row("no name", R"({"id": 1})", "looks[0].name must not be empty");
    row("one name", R"({"id": 1, "name": "A"}, {"id": 2, "name": "A"})",
        "looks[1].name is that of another look");
    row("twice", R"({"id": 1, "name": "A"}, {"id": 1, "name": "B"})", "the id 1 is given twice");
    row("no id", R"({"id": 0, "name": "A"})", "looks[0].id");
    row("no list", R"(7)", "looks[0] must be an object");
}

void TestLookList::refusesWhatIsWrong()
{
    QFETCH(const QByteArray, look);
    QFETCH(const QString, said);
    const auto read = projectFromText(fileWith(look.toStdString()));
    QVERIFY(!read.isOk());
    const QString message = QString::fromStdString(read.error().message);
    QVERIFY2(message.contains(said), qPrintable(message));
}

void TestLookList::idsAreNotUsedAgain()
{
    Scene scene;
    QCOMPARE(scene.freeLookId(), LookId{1});
    scene.looks = twoLooks();
    QCOMPARE(scene.freeLookId(), LookId{8});
    scene.cameras = {{"Stalls", {}, 11}}; // of a look that undo may bring back
    QCOMPARE(scene.freeLookId(), LookId{12});
    scene.looks[0].id = 0xFFFFFFFFU;
    QCOMPARE(scene.freeLookId(), LookId{0});
}

void TestLookList::aFileOfLooksIsSharedByProjects()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("a.looks"));
    QVERIFY(writeLookFile(twoLooks(), path).isOk());
    const auto read = readLookFile(path);
    QVERIFY2(read.isOk(), read ? "" : read.error().message.c_str());
    QVERIFY(read.value() == twoLooks());
    Scene scene;
    scene.looks = twoLooks();
    scene.looks[1].style = LookStyle::Clay;
    scene.looks[1].id = 3;
    scene.looks[0].name = "Late";
    const auto both = withLooks(scene, read.value());
    QVERIFY(both.isOk());
    QCOMPARE(both.value().size(), std::size_t{3});
    QVERIFY(both.value()[1].style == LookStyle::Property); // that of the same name is replaced
    QCOMPARE(both.value()[1].id, LookId{3});
    QCOMPARE(both.value()[2].name, std::string("Evening"));
    QCOMPARE(both.value()[2].id, LookId{8});
}

void TestLookList::hostileFilesAreRefused_data()
{
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<QString>("said");
    const QString notOne = QStringLiteral("holds no looks");
    QTest::newRow("nothing") << QByteArray() << notOne;
    QTest::newRow("cut off") << QByteArray(R"({"format": "crowdbrush looks", "version": 1, "loo)")
                             << notOne;
    QTest::newRow("another kind") << QByteArray(R"({"format": "crowdbrush features"})") << notOne;
    QTest::newRow("a number") << QByteArray("7") << notOne;
    QTest::newRow("bytes") << QByteArray("\xFF\x00\xFE\x01", 4) << notOne;
    QTest::newRow("a well") << QByteArray(200'000, '[') << notOne;
    QTest::newRow("newer") << QByteArray(R"({"format": "crowdbrush looks", "version": 2})")
                           << QStringLiteral("newer version");
    QTest::newRow("no list") << QByteArray(
                                    R"({"format": "crowdbrush looks", "version": 1, "looks": 7})")
                             << QStringLiteral("looks must be a list");
    QTest::newRow("wrong") << QByteArray(R"({"format": "crowdbrush looks", "version": 1,
        "looks": [{"id": 1, "name": "A", "style": 3}]})")
                           << QStringLiteral("looks[0].style");
}

void TestLookList::hostileFilesAreRefused()
{
    QFETCH(const QByteArray, content);
    QFETCH(const QString, said);
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("a.looks"));
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(content);
    file.close();
    const auto read = readLookFile(path);
    QVERIFY(!read.isOk());
    const QString message = QString::fromStdString(read.error().message);
    QVERIFY2(message.contains(said) && message.contains(path), qPrintable(message));
    QVERIFY(!readFeatureFile(path).isOk() || content.contains("features"));
}

void TestLookList::thereIsAnEndToRoom()
{
    Scene scene;
    for (LookId id = 1; id <= kMostLooks; ++id) {
        LookPreset look;
        look.id = id;
        look.name = std::to_string(id);
        scene.looks.push_back(look);
    }
    QCOMPARE(scene.freeLookId(), LookId{0});
    const auto more = withLooks(scene, twoLooks());
    QVERIFY(!more.isOk());
    QVERIFY(more.error().message.find("1000") != std::string::npos);
    scene.looks.push_back(twoLooks()[0]);
    scene.looks.back().id = 5000;
    QVERIFY(!projectFromText(projectText(scene)).isOk());
}

CROWD_TEST(TestLookList)
#include "tst_LookList.moc"
