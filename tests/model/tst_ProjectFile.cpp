// SPDX-License-Identifier: MIT
#include "model/project/ProjectFile.h"

#include <cmath>
#include <limits>

#include <QtCore/QDir>
#include <QtCore/QFile>
#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>

#include "model/base/Random.h"
#include "model/project/Autosave.h"
#include "model/project/ProjectReader.h"
#include "model/project/ProjectWriter.h"

using namespace crowd::model;

namespace {

constexpr const char* kSmall = R"({
"format": "crowdbrush-scene", "version": 1,
"templates": [{"id": 1, "path": "man.glb", "clips": ["idle"]}],
"individuals": {"columns": ["id","template","position","tint0","seat"], "rows": [
[4,1,[0,0.5,-1],"#ff000080",4294967295],
[7,1,[1,0,2e1],"#ffffff00",16777217]
]}})";

/// kSmall with one piece replaced.
std::string changed(const char* from, const char* to)
{
    std::string text = kSmall;
    const auto place = text.find(from);
    Q_ASSERT(place != std::string::npos);
    return text.replace(place, std::strlen(from), to);
}

Scene variedScene(std::size_t count)
{
    Scene scene;
    scene.name = "Größe \"x\"";
    TemplateEntry entry;
    entry.id = 3;
    entry.path = "builtin:templates/man.glb";
    entry.clipNames = {"idle", "sit"};
    entry.clipSpeeds = {std::numeric_limits<float>::quiet_NaN(), 1.25F};
    entry.import.scale = 0.0254F;
    scene.templates.push_back(entry);
    StageEntry stage;
    stage.id = 1;
    stage.path = "/somewhere/theatre.glb";
    stage.headingRadians = 0.1F;
    scene.stages.push_back(stage);
    scene.cameras.push_back({"Front", Camera::lookingAt({1, 2, 3}, {0, 0, 0})});
    scene.lighting.sunStrength = 0.7F;
    std::vector<IndividualId> ids(count);
    for (std::size_t i = 0; i < count; ++i) {
        ids[i] = static_cast<IndividualId>(2 * i + 1);
    }
    scene.nextId = static_cast<IndividualId>(2 * count + 5);
    IndividualRows rows = IndividualRows::withDefaults(ids);
    for (std::size_t i = 0; i < count; ++i) {
        const auto random = [i](int what) { return unitFloat(hashKeys(i, what)); };
        rows.column(columns::templateId)[i] = 3;
        rows.column(columns::position)[i] = {random(1) * 100.0F, -0.0F, -random(2) * 1e-7F};
        rows.column(columns::heading)[i] = random(3) * 6.28F;
        rows.column(columns::tint(2))[i] = {static_cast<std::uint8_t>(i), 2, 3, 255};
        rows.column(columns::materialChoices)[i][7] = static_cast<std::uint8_t>(i % 5);
        rows.column(columns::seat)[i] = i % 2 == 0 ? kNoSeat : static_cast<SeatId>(i);
        rows.column(columns::tags)[i] = ~std::uint64_t{0} - i;
    }
    scene.population.add(rows);
    return scene;
}

} // namespace

class tst_ProjectFile : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void readsWhatItWrote();
    void keepsWhatItDoesNotKnow();
    void refusesBadInputWithItsPlace_data();
    void refusesBadInputWithItsPlace();
    void refusesEveryTruncation();
    void refusesToWriteWhatIsNotANumber();
    void storesAssetsRelativeToTheFile();
    void leavesTheOldFileWhenSavingFails();
    void readsTheFirstVersion();
    void offersARecoveryOnlyWhenItIsNewer();
};

void tst_ProjectFile::readsWhatItWrote()
{
    const Scene scene = variedScene(500);
    const std::string text = projectToText(scene).value();
    const Result<Scene> read = projectFromText(text);
    QVERIFY2(read.isOk(), read ? "" : read.error().message.c_str());
    QVERIFY(read.value().population == scene.population);
    QCOMPARE(read.value().nextId, scene.nextId);
    QCOMPARE(read.value().cameras.front().camera, scene.cameras.front().camera);
    QCOMPARE(read.value().lighting, scene.lighting);
    QCOMPARE(projectToText(read.value()).value(), text);
}

void tst_ProjectFile::keepsWhatItDoesNotKnow()
{
    std::string text = changed("\"seat\"]", "\"seat\",\"mood\"]");
    text.replace(text.find("4294967295]"), 11, "4294967295,{\"joy\":[1,2]}]");
    text.replace(text.find("16777217]"), 9, "16777217,null]");
    text.replace(text.find("\"version\": 1,"), 13, "\"version\": 1, \"rules\": [{\"a\": 1}],");
    const Scene scene = projectFromText(text).value();
    const std::string written = projectToText(scene).value();
    QVERIFY(written.find("{\"joy\":[1,2]}") != std::string::npos);
    QVERIFY(written.find("\"rules\": [\n{\"a\":1}") != std::string::npos);
    QCOMPARE(projectToText(projectFromText(written).value()).value(), written);
}

void tst_ProjectFile::refusesBadInputWithItsPlace_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("message");
    const auto row = [](const char* name, const std::string& text, const char* message) {
        QTest::newRow(name) << QString::fromStdString(text) << QString::fromLatin1(message);
    };
    row("empty file", "", "not valid JSON");
    row("not JSON", "hello", "line 1");
    row("a list", "[]", "not a Crowdbrush scene");
    row("a number", "5", "JSON object");
    row("another format", changed("crowdbrush-scene", "gltf"), "not a Crowdbrush scene");
    row("a newer version", changed("\"version\": 1", "\"version\": 2"), "newer Crowdbrush");
    row("version zero", changed("\"version\": 1", "\"version\": 0"), "\"version\"");
    row("no individuals", changed("\"individuals\"", "\"people\""), "individuals");
    row("a missing path", changed("\"path\": \"man.glb\", ", ""), "templates[0].path is missing");
    row("a wrong name", changed("\"man.glb\"", "7"), "templates[0].path must be a text");
    row("an unknown template", changed("[7,1,", "[7,9,"), "individual 7 uses the template 9");
    row("the same id twice", changed("[7,1,", "[4,1,"), "the id 4");
    row("id zero", changed("[7,1,", "[0,1,"), "row 2 of the individuals, column \"id\"");
    row("a huge number", changed("2e1", "2e99"), "row 2 of the individuals, column \"position\"");
    row("a text for a number", changed("0.5", "\"x\""),
        "row 1 of the individuals, column \"position\"");
    row("a vector of two", changed("[0,0.5,-1]", "[0,0.5]"), "column \"position\"");
    row("a vector of four", changed("[0,0.5,-1]", "[0,0,0,0]"), "column \"position\"");
    row("a tint without hash", changed("#ff000080", "ff000080"), "column \"tint0\"");
    row("a tint of letters", changed("#ff000080", "#zz000080"), "column \"tint0\"");
    row("a short row", changed(",4294967295]", "]"), "row 1 of the individuals must have 5");
    row("a long row", changed(",4294967295]", ",1,1,1]"), "row 1 of the individuals must have 5");
    row("a seat too large", changed("16777217", "99999999999"), "column \"seat\"");
    row("a seat taken twice", changed("4294967295", "16777217"), "the same seat");
    row("a column twice", changed("\"seat\"]", "\"tint0\"]"), "\"tint0\" twice");
    row("no id column", changed("\"id\",\"template\"", "\"template\",\"id\""),
        "begins with \"id\"");
    row("no positions", changed("\"position\",", "\"place\","), "lacks \"position\"");
    row("a template id of zero", changed("\"id\": 1", "\"id\": 0"), "templates: the id 0");
    row("nested too deep",
        changed("\"templates\":",
                ("\"x\": " + std::string(100, '[') + std::string(100, ']') + ", \"templates\":")
                    .c_str()),
        "nested");
    row("rows before columns", changed("\"columns\"", "\"colums\""), "before the rows");
    row("an object as row", changed("[4,1,[0,0.5,-1],\"#ff000080\",4294967295]", "{}"), "row 1");
}

void tst_ProjectFile::refusesBadInputWithItsPlace()
{
    QFETCH(QString, text);
    QFETCH(QString, message);
    const Result<Scene> read = projectFromText(text.toStdString());
    QVERIFY(!read.isOk());
    const QString said = QString::fromStdString(read.error().message);
    QVERIFY2(said.contains(message), qPrintable(said));
}

void tst_ProjectFile::refusesEveryTruncation()
{
    const std::string text = kSmall;
    QVERIFY(projectFromText(text).isOk());
    for (std::size_t length = 0; length < text.size(); ++length) {
        QVERIFY(!projectFromText(std::string_view(text).substr(0, length)).isOk());
    }
}

void tst_ProjectFile::refusesToWriteWhatIsNotANumber()
{
    Scene scene = variedScene(3);
    const float nan = std::nanf("");
    scene.population.setValues(columns::heading, std::vector<IndividualId>{3},
                               std::span<const float>(&nan, 1));
    const Result<std::string> text = projectToText(scene);
    QVERIFY(!text.isOk());
    QVERIFY(text.error().message.find("Individual 3 has a heading") != std::string::npos);
}

void tst_ProjectFile::storesAssetsRelativeToTheFile()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("szenen/größe.crowd"));
    QVERIFY(QDir(folder.path()).mkpath(QStringLiteral("szenen")));
    Scene scene = variedScene(2);
    scene.stages.front().path = folder.filePath(QStringLiteral("stage.glb")).toStdString();
    QVERIFY(saveProject(scene, path).isOk());
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QVERIFY(file.readAll().contains("\"../stage.glb\""));
    const Scene read = readProject(path).value();
    QCOMPARE(read.stages.front().path, scene.stages.front().path);
    QCOMPARE(read.templates.front().path, scene.templates.front().path);
}

void tst_ProjectFile::leavesTheOldFileWhenSavingFails()
{
    const Result<void> saved =
        saveProject(variedScene(1), QStringLiteral("/nonexistent-folder/a.crowd"));
    QVERIFY(!saved.isOk());
    QVERIFY(saved.error().message.find("/nonexistent-folder/a.crowd") != std::string::npos);
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("a.crowd"));
    QVERIFY(saveProject(variedScene(1), path).isOk());
    Scene broken = variedScene(1);
    const glm::vec3 nowhere(std::nanf(""));
    broken.population.setValues(columns::position, broken.population.ids(),
                                std::span<const glm::vec3>(&nowhere, 1));
    QVERIFY(!saveProject(broken, path).isOk());
    QVERIFY(readProject(path).isOk());
}

void tst_ProjectFile::readsTheFirstVersion()
{
    const Result<Scene> read =
        readProject(QStringLiteral(CROWD_TEST_DATA "/project/version-1.crowd"));
    QVERIFY2(read.isOk(), read ? "" : read.error().message.c_str());
    QVERIFY(read.value().population == variedScene(20).population);
}

void tst_ProjectFile::offersARecoveryOnlyWhenItIsNewer()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("a.crowd"));
    QVERIFY(saveProject(variedScene(1), path).isOk());
    QVERIFY(findRecovery(path).isEmpty());
    QVERIFY(writeAutosave(variedScene(2), path).isOk());
    QVERIFY(!findRecovery(path).isEmpty());
    QVERIFY(readProject(findRecovery(path)).value().population == variedScene(2).population);
    QFile recovery(autosavePath(path));
    QVERIFY(recovery.open(QIODevice::ReadWrite));
    recovery.setFileTime(QDateTime::currentDateTime().addDays(-1),
                         QFileDevice::FileModificationTime);
    recovery.close();
    QVERIFY(findRecovery(path).isEmpty());
    removeAutosave(path);
    QVERIFY(!QFile::exists(autosavePath(path)));
}

QTEST_GUILESS_MAIN(tst_ProjectFile)
#include "tst_ProjectFile.moc"
