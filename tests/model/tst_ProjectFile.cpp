// SPDX-License-Identifier: MIT
#include "model/project/ProjectFile.h"

#include <cmath>
#include <csignal>
#include <functional>
#include <limits>
#include <sys/resource.h>
#include <sys/stat.h>

#include <QtCore/QDir>
#include <QtCore/QFile>
#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>

#include "model/base/Random.h"
#include "model/project/AssetPaths.h"
#include "model/project/ProjectReader.h"
#include "model/project/ProjectWriter.h"
#include "model/project/SceneAssets.h"
#include "tests/model/ProjectText.h"
#include "tests/program/Test.h"

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
    void filesOfBeforeHaveTheirLight();
    void keepsWhatItDoesNotKnow();
    void keepsUnknownMembersWhereTheyStood();
    void refusesBadInputWithItsPlace_data();
    void refusesBadInputWithItsPlace();
    void readsAllThatCanBeMade();
    void saysFirstThatAVersionIsNewer();
    void refusesTextThatIsNotUtf8();
    void refusesHugeHeaders();
    void freesSeatsTakenTwice();
    void readsOddButValidFiles();
    void refusesEveryTruncation();
    void refusesToWriteWhatIsNotANumber();
    void refusesToWriteWhatItCouldNotRead_data();
    void refusesToWriteWhatItCouldNotRead();
    void refusesWhatIsNotAFile();
    void findsAssetsWhereverTheyAre_data();
    void findsAssetsWhereverTheyAre();
    void builtinPathsStayInTheirFolder();
    void builtinTemplatesAreSharedWhileKept();
    void entriesOfOneFileShareIt();
    void keepsLinkAndPermissionsOnSaving();
    void leavesTheOldFileOnAFullDisk();
    void storesAssetsRelativeToTheFile();
    void leavesTheOldFileWhenSavingFails();
    void readsTheFirstVersion();
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

/// New scenes have shadows; what was painted without them stays so.
void tst_ProjectFile::filesOfBeforeHaveTheirLight()
{
    QVERIFY(Scene().lighting.shadowStrength > 0.0F);
    auto nothing = projectFromText(kSmall);
    QVERIFY(nothing.isOk());
    QCOMPARE(nothing.value().lighting, Lighting());
    QCOMPARE(nothing.value().lighting.shadowStrength, 0.0F);
    auto some = projectFromText(
        changed("\"templates\":", "\"lighting\": {\"sunStrength\": 2}, \"templates\":"));
    QVERIFY(some.isOk());
    QCOMPARE(some.value().lighting.sunStrength, 2.0F);
    QCOMPARE(some.value().lighting.shadowStrength, 0.0F);
}

void tst_ProjectFile::keepsWhatItDoesNotKnow()
{
    std::string text = changed("\"seat\"]", "\"seat\",\"mood\"]");
    text.replace(text.find("4294967295]"), 11, "4294967295,{\"joy\":[1,2]}]");
    text.replace(text.find("16777217]"), 9, "16777217,null]");
    text.replace(text.find("\"version\": 1,"), 13, "\"version\": 1, \"weather\": [{\"a\": 1}],");
    const Scene scene = projectFromText(text).value();
    const std::string written = projectToText(scene).value();
    QVERIFY(written.find("{\"joy\":[1,2]}") != std::string::npos);
    QVERIFY(written.find("\"weather\": [\n{\"a\":1}") != std::string::npos);
    QCOMPARE(projectToText(projectFromText(written).value()).value(), written);
}

void tst_ProjectFile::keepsUnknownMembersWhereTheyStood()
{
    std::string text = changed("\"clips\":", "\"mood\": \"glad\", \"clips\":");
    text.replace(text.find("\"templates\":"), 11,
                 R"("stages": [{"id": 1, "path": "a.glb", "fog": 0.5}],
"cameras": [{"name": "a", "position": [0,0,0], "orientation": [0,0,0,1], "lens": {"f": 50}}],
"lighting": {"moon": true}, "templates")");
    text.replace(text.find("\"columns\""), 9, "\"sorted\": false, \"columns\"");
    text.replace(text.find("[\"idle\"]"), 8, "[\"idle\"], \"import\": {\"flip\": [1,2]}");
    const Result<Scene> scene = projectFromText(text);
    QVERIFY2(scene.isOk(), scene ? "" : scene.error().message.c_str());
    const std::string written = projectToText(scene.value()).value();
    for (const char* kept : {"\"mood\":\"glad\"", "\"fog\":0.5", "\"lens\":{\"f\":50}",
                             "\"moon\":true", "\"sorted\": false", "\"flip\":[1,2]"}) {
        QVERIFY2(written.find(kept) != std::string::npos, kept);
    }
    QCOMPARE(projectToText(projectFromText(written).value()).value(), written);
}

void tst_ProjectFile::saysFirstThatAVersionIsNewer()
{
    std::string text = changed("\"version\": 1", "\"version\": 2");
    text.replace(text.find("[4,1,"), 5, "[{},");
    const Result<Scene> read = projectFromText(text);
    QVERIFY(!read.isOk());
    QVERIFY2(read.error().message.find("Update Crowdbrush") != std::string::npos,
             read.error().message.c_str());
}

void tst_ProjectFile::refusesTextThatIsNotUtf8()
{
    const Result<Scene> read = projectFromText(changed("man.glb", "m\xff\xfe.glb"));
    QVERIFY(!read.isOk());
    QVERIFY2(read.error().message.find("not valid JSON at line 3") != std::string::npos,
             read.error().message.c_str());
    const std::string atOnce = projectFromText("{\"\xff").error().message;
    QVERIFY2(atOnce.find("not valid JSON at line 1") != std::string::npos, atOnce.c_str());
    for (const std::string& said :
         {read.error().message, atOnce}) { // as UTF-8, for whoever reads it
        QCOMPARE(QString::fromStdString(said).toStdString(), said);
        QVERIFY(said.find("\xEF\xBF\xBD") != std::string::npos);
    }
}

void tst_ProjectFile::refusesHugeHeaders()
{
    std::string many = "\"x\": [0";
    for (int i = 0; i < 2'100'000; ++i) {
        many += ",0";
    }
    const Result<Scene> read =
        projectFromText(changed("\"templates\":", (many + "], \"templates\":").c_str()));
    QVERIFY(!read.isOk());
    QVERIFY(read.error().message.find("more than 2000000 values") != std::string::npos);
}

void tst_ProjectFile::freesSeatsTakenTwice()
{
    const Result<Scene> read = projectFromText(changed("4294967295", "16777217"));
    QVERIFY2(read.isOk(), read ? "" : read.error().message.c_str());
    const Scene& scene = read.value();
    QCOMPARE(scene.population.column(columns::seat)[0], SeatId{16777217});
    QCOMPARE(scene.population.column(columns::seat)[1], kNoSeat);
    QCOMPARE(scene.readWarnings.size(), std::size_t{1});
    QVERIFY(scene.readWarnings.front().english().find("Individual 7") != std::string::npos);
    QVERIFY(projectFromText(projectToText(scene).value()).value().readWarnings.empty());
}

void tst_ProjectFile::readsOddButValidFiles()
{
    // Ids out of order, windows line ends, a byte-order mark, an exponent, a tiny number.
    std::string text = changed("[7,1,[1,0,2e1]", "[2,1,[1E0,1e-60,-0.0]");
    for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 2)) {
        text.replace(at, 1, "\r\n");
    }
    const Result<Scene> read = projectFromText("\xEF\xBB\xBF" + text);
    QVERIFY2(read.isOk(), read ? "" : read.error().message.c_str());
    const Population& people = read.value().population;
    QCOMPARE(people.ids()[0], IndividualId{2});
    QCOMPARE(people.column(columns::position)[0], glm::vec3(1.0F, 0.0F, 0.0F));
    QVERIFY(std::signbit(people.column(columns::position)[0].z));
    QCOMPARE(read.value().nextId, IndividualId{5});
}

void tst_ProjectFile::refusesBadInputWithItsPlace_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("message");
    const auto row = [](const char* name, const std::string& text, const char* message) {
        QTest::newRow(name) << QString::fromStdString(text) << QString::fromLatin1(message);
    };
    row("empty file", "", "ends too early, at line 1");
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
    row("id zero", changed("[7,1,", "[0,1,"), "row 2 of individuals, column \"id\"");
    row("a huge number", changed("2e1", "2e99"), "row 2 of individuals, column \"position\"");
    row("a text for a number", changed("0.5", "\"x\""),
        "row 1 of individuals, column \"position\"");
    row("a vector of two", changed("[0,0.5,-1]", "[0,0.5]"), "column \"position\"");
    row("a vector of four", changed("[0,0.5,-1]", "[0,0,0,0]"), "column \"position\"");
    row("a tint without hash", changed("#ff000080", "ff000080"), "column \"tint0\"");
    row("a tint of letters", changed("#ff000080", "#zz000080"), "column \"tint0\"");
    row("a short row", changed(",4294967295]", "]"), "row 1 of individuals must have 5");
    row("a long row", changed(",4294967295]", ",1,1,1]"), "row 1 of individuals must have 5");
    row("a seat too large", changed("16777217", "99999999999"), "column \"seat\"");
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
    row("a number beyond all floats", changed("2e1", "2e999"), "too large at line 6");
    row("not a number", changed("2e1", "NaN"), "not valid JSON at line 6");
    row("a boolean for a number", changed("0.5", "true"), "column \"position\"");
    row("a negative seat", changed("16777217", "-1"), "column \"seat\"");
    row("a fraction for a seat", changed("16777217", "1.5"), "column \"seat\"");
    row("an id that leaves none for others", changed("[7,1,", "[4294967295,1,"),
        "row 2 of individuals, column \"id\"");
    row("a next id that leaves none",
        changed("\"version\": 1", "\"version\": 1, \"nextId\": 4294967295"), "nextId");
    row("a next id of zero", changed("\"version\": 1", "\"version\": 1, \"nextId\": 0"), "nextId");
    row("an empty path", changed("man.glb", ""), "templates[0].path must not be empty");
    row("a template id twice",
        changed("[{\"id\": 1,", "[{\"id\": 1, \"path\": \"b.glb\"}, {\"id\": 1,"),
        "id 1 is given twice");
    row("a template id too large", changed("\"id\": 1", "\"id\": 65536"), "templates[0].id");
    row("a negative template id", changed("\"id\": 1", "\"id\": -1"), "templates[0].id");
    row("templates as an object",
        changed("[{\"id\": 1, \"path\": \"man.glb\", \"clips\": [\"idle\"]}]", "{}"),
        "templates must be a list");
    row("a template as a number",
        changed("[{\"id\": 1, \"path\": \"man.glb\", \"clips\": [\"idle\"]}]", "[3]"),
        "templates[0] must be an object");
    row("clips that are numbers", changed("[\"idle\"]", "[1]"), "templates[0].clips");
    row("a clip speed beyond all floats",
        changed("[\"idle\"]", "[\"idle\"], \"clipSpeeds\": [1e300]"), "templates[0].clipSpeeds");
    row("an import scale of zero", changed("[\"idle\"]", "[\"idle\"], \"import\": {\"scale\": 0}"),
        "templates[0].import.scale must lie between");
    row("an import rotation that is none",
        changed("[\"idle\"]", "[\"idle\"], \"import\": {\"rotation\": [0,0,0,0]}"),
        "templates[0].import.rotation");
    row("a camera without width",
        changed("\"templates\":", "\"cameras\": [{\"name\": \"a\", \"position\": [0,0,0], "
                                  "\"orientation\": [0,0,0,1], \"fovY\": 0}], \"templates\":"),
        "cameras[0].fovY");
    row("a light that is text",
        changed("\"templates\":", "\"lighting\": {\"sunStrength\": \"much\"}, \"templates\":"),
        "lighting.sunStrength");
    const auto lightRow = [&row](const char* name, const std::string& light, const char* message) {
        row(name,
            changed("\"templates\":", ("\"lighting\": {" + light + "}, \"templates\":").c_str()),
            message);
    };
    lightRow("a light below nothing", "\"sunStrength\": -1",
             "lighting.sunStrength must lie between 0 and 1000");
    lightRow("a light beyond all eyes", "\"ambientStrength\": 1e30",
             "lighting.ambientStrength must lie between 0 and 1000");
    lightRow("a sun that turned too often", "\"sunAzimuth\": 1e30",
             "lighting.sunAzimuth must lie between");
    lightRow("a sky beyond white", "\"skyZenith\": [0, 2, 0]",
             "lighting.skyZenith must lie between 0 and 1");
    row("a member twice", changed("\"templates\":", "\"version\": 1, \"templates\":"),
        "\"version\" stands twice");
    row("two tables", changed("]}}", "]}, \"individuals\": {\"columns\": [\"id\"]}}"),
        "\"individuals\" stands twice");
    row("columns again after the rows",
        changed("16777217]\n]", "16777217]\n], \"columns\": [\"id\"]"), "\"columns\" stands twice");
    row("something behind the end", std::string(kSmall) + "x", "not valid JSON at line 7");
    row("an object as row", changed("[4,1,[0,0.5,-1],\"#ff000080\",4294967295]", "{}"), "row 1");
}

/// The smallest scale of the import dialog, a lift that is proposed for what lies deep, and a wide
/// camera as far away as scripts can place it.
void tst_ProjectFile::readsAllThatCanBeMade()
{
    Scene scene;
    TemplateEntry entry;
    entry.id = 1;
    entry.name = "deep";
    entry.path = "/tmp/deep.glb";
    entry.import.scale = 0.00001F;
    entry.import.groundOffset = 25000.0F;
    scene.templates.push_back(entry);
    Camera far = Camera::lookingAt({1e9F, 1e9F, -1e9F}, {-1e9F, 0.0F, 1e9F});
    far.fovYRadians = 2.967F;
    far.orthographicHeight = 2.0F * far.pivotDistance * std::tan(far.fovYRadians * 0.5F);
    scene.cameras.push_back({"far", far});
    const auto read = projectFromText(crowd::testing::projectText(scene));
    QVERIFY2(read.isOk(), read ? "" : read.error().message.c_str());
    QVERIFY(read.value().templates.front().import == entry.import);
    QVERIFY(read.value().cameras.front().camera == far);
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

void tst_ProjectFile::refusesToWriteWhatItCouldNotRead_data()
{
    using Spoil = std::function<void(Scene&)>;
    const float nan = std::nanf("");
    QTest::addColumn<Spoil>("spoil");
    QTest::addColumn<QString>("message");
    const auto row = [](const char* name, const Spoil& spoil, const char* message) {
        QTest::newRow(name) << spoil << QString::fromLatin1(message);
    };
    row(
        "a camera nowhere", [nan](Scene& s) { s.cameras.front().camera.position.x = nan; },
        "cameras[0].position");
    row(
        "a camera without width", [](Scene& s) { s.cameras.front().camera.fovYRadians = 0.0F; },
        "cameras[0].fovY");
    row(
        "an endless light", [](Scene& s) { s.lighting.sunStrength = INFINITY; },
        "lighting.sunStrength");
    row(
        "a stage without size", [](Scene& s) { s.stages.front().scale = 0.0F; }, "stages[0].scale");
    row(
        "an endless clip speed", [](Scene& s) { s.templates.front().clipSpeeds[1] = INFINITY; },
        "templates[0].clipSpeeds");
    row(
        "a template that is gone", [](Scene& s) { s.templates.clear(); },
        "Individual 1 uses the template 3");
}

void tst_ProjectFile::refusesToWriteWhatItCouldNotRead()
{
    QFETCH(std::function<void(Scene&)>, spoil);
    QFETCH(QString, message);
    Scene scene = variedScene(2);
    spoil(scene);
    const Result<std::string> text = projectToText(scene);
    QVERIFY(!text.isOk());
    const QString said = QString::fromStdString(text.error().message);
    QVERIFY2(said.contains(message), qPrintable(said));
}

void tst_ProjectFile::refusesWhatIsNotAFile()
{
    QTemporaryDir folder;
    const QString pipe = folder.filePath(QStringLiteral("pipe.crowd"));
    QCOMPARE(::mkfifo(qPrintable(pipe), 0600), 0);
    for (const QString& path : {pipe, folder.path(), QStringLiteral("/dev/zero"),
                                folder.filePath(QStringLiteral("none.crowd"))}) {
        const Result<Scene> read = readProject(path);
        QVERIFY(!read.isOk());
        QVERIFY2(QString::fromStdString(read.error().message).startsWith(path),
                 read.error().message.c_str());
    }
}

void tst_ProjectFile::findsAssetsWhereverTheyAre_data()
{
    QTest::addColumn<QString>("written");
    QTest::addColumn<QString>("found"); // %1 is the folder of the scene
    QTest::newRow("beside it") << QStringLiteral("fox.glb") << QStringLiteral("%1/fox.glb");
    QTest::newRow("below it") << QStringLiteral("a/./b/fox.glb")
                              << QStringLiteral("%1/a/b/fox.glb");
    QTest::newRow("above it") << QStringLiteral("../fox.glb") << QString();
    QTest::newRow("absolute") << QStringLiteral("/somewhere/fox.glb")
                              << QStringLiteral("/somewhere/fox.glb");
    QTest::newRow("beyond the root")
        << QStringLiteral("../../../../../../../../../../../etc/fox.glb")
        << QStringLiteral("/etc/fox.glb");
    QTest::newRow("not ASCII") << QStringLiteral("füchse/狐.glb")
                               << QStringLiteral("%1/füchse/狐.glb");
    QTest::newRow("built in") << QStringLiteral("builtin:templates/man.glb")
                              << QStringLiteral("builtin:templates/man.glb");
}

void tst_ProjectFile::findsAssetsWhereverTheyAre()
{
    QFETCH(QString, written);
    QFETCH(QString, found);
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("a.crowd"));
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(QByteArray::fromStdString(changed("man.glb", written.toUtf8().constData())));
    file.close();
    const Result<Scene> read = readProject(path);
    QVERIFY2(read.isOk(), read ? "" : read.error().message.c_str());
    const QString expected =
        found.isEmpty() ? QFileInfo(folder.path()).absolutePath() + QStringLiteral("/fox.glb")
                        : found.replace(QStringLiteral("%1"), folder.path());
    QCOMPARE(QString::fromStdString(read.value().templates.front().path), expected);
    QVERIFY(saveProject(read.value(), path).isOk());
    QCOMPARE(readProject(path).value().templates.front().path, read.value().templates.front().path);
}

void tst_ProjectFile::builtinPathsStayInTheirFolder()
{
    QCOMPARE(assetFile("builtin:../../../etc/passwd"), QString());
    QVERIFY(assetFile("builtin:templates/man.glb").endsWith(QStringLiteral("/templates/man.glb")));
    TemplateEntry entry;
    entry.path = "builtin:../secret.glb";
    const Result<TemplatePtr> asset = loadTemplateAsset(entry);
    QVERIFY(!asset.isOk());
    QVERIFY(asset.error().message.find("builtin:../secret.glb") != std::string::npos);
}

void tst_ProjectFile::builtinTemplatesAreSharedWhileKept()
{
    TemplateEntry entry;
    entry.path = "builtin:templates/man.glb";
    const Result<TemplatePtr> first = loadTemplateAsset(entry);
    QVERIFY(first.isOk());
    QVERIFY(loadTemplateAsset(entry).value() == first.value());
    entry.import.scale = 2.0F;
    const Result<TemplatePtr> larger = loadTemplateAsset(entry);
    QVERIFY(larger.isOk());
    QVERIFY(larger.value() != first.value());
    QVERIFY(larger.value()->height > 1.5F * first.value()->height);
}

void tst_ProjectFile::entriesOfOneFileShareIt()
{
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("man.glb"));
    QVERIFY(QFile::copy(assetFile("builtin:templates/man.glb"), file));
    Scene scene;
    for (TemplateId id = 1; id <= 4; ++id) {
        TemplateEntry entry;
        entry.id = id;
        entry.path = file.toStdString();
        scene.templates.push_back(entry);
    }
    scene.templates[1].import.scale = 2.0F;
    scene.templates[3].path = folder.filePath(QStringLiteral("gone.glb")).toStdString();
    QCOMPARE(firstAlike(scene.templates), (std::vector<std::size_t>{0, 1, 0, 3}));
    loadAssets(scene);
    QVERIFY(scene.templates[0].asset != nullptr);
    QVERIFY(scene.templates[2].asset == scene.templates[0].asset);
    QVERIFY(scene.templates[1].asset != scene.templates[0].asset);
    QVERIFY(scene.templates[1].asset->height > 1.5F * scene.templates[0].asset->height);
    QVERIFY(scene.templates[3].asset == nullptr && !scene.templates[3].problem.empty());
}

void tst_ProjectFile::keepsLinkAndPermissionsOnSaving()
{
    QTemporaryDir folder;
    QVERIFY(QDir(folder.path()).mkpath(QStringLiteral("real")));
    const QString real = folder.filePath(QStringLiteral("real/a.crowd"));
    const QString link = folder.filePath(QStringLiteral("link.crowd"));
    QVERIFY(saveProject(variedScene(1), real).isOk());
    const auto shared = QFile::ReadOwner | QFile::WriteOwner | QFile::ReadGroup | QFile::WriteGroup;
    QVERIFY(QFile::setPermissions(real, shared));
    QVERIFY(QFile::link(QStringLiteral("real/a.crowd"), link));
    QVERIFY(saveProject(variedScene(7), link).isOk());
    QVERIFY(QFileInfo(link).isSymLink());
    QCOMPARE(readProject(real).value().population.size(), std::size_t{7});
    QCOMPARE(QFile::permissions(real) & ~(QFile::ReadUser | QFile::WriteUser), shared);
    QCOMPARE(QDir(folder.path()).entryList(QDir::AllEntries | QDir::NoDotAndDotDot).size(), 2);
    QCOMPARE(QDir(folder.filePath(QStringLiteral("real"))).entryList(QDir::Files).size(), 1);
}

void tst_ProjectFile::leavesTheOldFileOnAFullDisk()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("a.crowd"));
    QVERIFY(saveProject(variedScene(3), path).isOk());
    std::signal(SIGXFSZ, SIG_IGN);
    rlimit before{};
    ::getrlimit(RLIMIT_FSIZE, &before);
    const rlimit full{10000, before.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &full);
    const Result<void> saved = saveProject(variedScene(5000), path);
    ::setrlimit(RLIMIT_FSIZE, &before);
    QVERIFY(!saved.isOk());
    QVERIFY2(saved.error().message.find("was not saved") != std::string::npos,
             saved.error().message.c_str());
    QCOMPARE(readProject(path).value().population.size(), std::size_t{3});
    QCOMPARE(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden).size(), 1);
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

CROWD_TEST(tst_ProjectFile)
#include "tst_ProjectFile.moc"
