// SPDX-License-Identifier: MIT
#include <csignal>

#include <sched.h>
#include <sys/resource.h>

#include <QtCore/QDir>
#include <QtCore/QFile>
#include <QtCore/QFileInfo>
#include <QtCore/QTemporaryDir>
#include <QtGui/QImage>
#include <QtTest/QTest>

#include "model/project/ProjectFile.h"
#include "tests/app/PlainScene.h"
#include "tests/command/Program.h"
#include "tests/program/FileContent.h"
#include "tests/program/MovieContent.h"
#include "tests/program/Test.h"

using namespace crowd;
using namespace crowd::testing;

/// `crowdbrush render` from outside, in an environment without a display.
class RenderCommandTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void drawsOnlyWhatMakesSense_data();
    void drawsOnlyWhatMakesSense();
    void drawsPicturesOfTheSizeAskedFor();
    void drawsMovies();
    void movesTheCamera();
    void drawsNothingThatLacksSomething();
    void opensWhatComesWithIt();
    void aFrameIsTheSameFromAnyRangeAndThreads_data();
    void aFrameIsTheSameFromAnyRangeAndThreads();
    void aFullDiskIsAFailure();
    void aLongSimulationTellsAndEnds();
};

void RenderCommandTest::drawsOnlyWhatMakesSense_data()
{
    QTest::addColumn<QString>("options");
    QTest::addColumn<int>("status");
    QTest::addColumn<QByteArray>("message");
    const BadUsage rows[] = {
        {"unknown camera", "--output %1/a.png --camera nobody", 1, "no camera named \"nobody\""},
        {"a camera that moves by itself", "--output %1/a.png --camera Front --camera-move x.json",
         1, "leave --camera away"},
        {"a move that is not there", "--output %1/a.png --camera-move %1/no.json", 1,
         "give \"turntable\", or a file"},
        {"a take that is not there", "--output %1/a.png --take Rehearsal", 2,
         "no take named \"Rehearsal\""},
        {"size 0", "--output %1/a.png --size 0x0", 2, "--size 0x0"},
        {"size of one number", "--output %1/a.png --size 64", 2, "WIDTHxHEIGHT"},
        {"size 100000", "--output %1/a.png --size 100000x100000", 2, "at most 32768"},
        {"a JPEG beyond what it holds", "--output %1/a.jpg --size 20000x20", 2,
         "a JPEG file has at most 16384"},
        {"a movie beyond all", "--output %1/a.mp4 --frames 0-3 --size 20000x20", 2,
         "too large for a movie"},
        {"negative size", "--output %1/a.png --size -64x-36", 2, "--size"},
        {"no such folder", "--output %1/no/a.png --allow-missing", 1, "a.png cannot be written"},
        {"a folder", "--output %1/ --allow-missing", 1, "let the name end in one of .png"},
        {"a format that is none", "--output %1/a.tiger --allow-missing", 1,
         "let the name end in one of .png"},
        {"unknown look", "--output %1/a.png --look potato", 2, "there are: plain, lit"},
        {"unknown property", "--output %1/a.png --by shoesize", 2, "There are: template, group"},
        {"a property in another look", "--output %1/a.png --by tag --look clay", 2, "leave one"},
        {"focus behind the camera", "--output %1/a.png --focus -1", 2, "0.01 to 1000000 metres"},
        {"focus that is none", "--output %1/a.png --focus nan", 2, "0.01 to 1000000 metres"},
        {"no opening", "--output %1/a.png --f-stop 0", 2, "0.01 to 1000"},
        {"endless f-stop", "--output %1/a.png --focus 4 --f-stop inf", 2, "0.01 to 1000"},
        {"time that is none", "--output %1/a.png --time nan", 2, "--time"},
        {"frames without a place", "--output %1/a.png --frames 0-3", 2, "put ####"},
        {"frames in no steps", "--output %1/a#.png --frames 0-9x0", 2, "0-90x10"},
        {"frames with nothing between", "--output %1/a#.png --frames 1,,3", 2, "not a range"},
        {"several frames without a place", "--output %1/a.png --frames 1,3", 2, "put ####"},
        {"passes without room", "--output %1/a.jpg --passes depth", 2, "end in .exr or .png"},
        {"a pass without room", "--output %1/a.png --passes id,cryptomatte", 2,
         "room for the pass \"cryptomatte\""},
        {"passes of a movie", "--output %1/a.mp4 --frames 0-3 --passes id", 2, "end in .exr"},
        {"a pass that is none", "--output %1/a.exr --passes depth,smell", 2,
         "no pass \"smell\". There are: colour, depth"},
        {"passes nowhere", "--output %1/no/a.exr --passes id --allow-missing", 1,
         "a.exr cannot be written"},
        {"a transparent movie", "--output %1/a.mp4 --frames 0-3 --transparent", 2,
         "cannot be transparent"},
        {"a transparent JPEG", "--output %1/a.jpg --transparent", 2, "end in .png or .exr"},
        {"a movie gone on with", "--output %1/a.mp4 --frames 0-3 --resume", 2, "as a whole"},
        {"frames backwards", "--output %1/a#.png --frames 3-0", 2, "not a range"},
        {"a place without frames", "--output %1/a#.png", 2, "--frames A-B"},
        {"no frames a second", "--output %1/a#.png --frames 0-1 --fps 0", 2, "--fps"},
        {"no output", "--size 64x36", 2, "--output"},
        {"a movie of nothing", "--output %1/a.mp4", 2, "say of which frames"},
        {"many movies", "--output %1/a##.mp4 --frames 0-9", 2, "is one movie"},
        {"a movie nowhere", "--output %1/no/a.gif --frames 0-1 --allow-missing", 1,
         "a.gif cannot be written"},
        {"a time beyond all", "--output %1/a.png --time 1e18", 2, "604800, a week"},
        {"endless time", "--output %1/a.png --time inf", 2, "--time"},
        {"a time long before", "--output %1/a.png --time -1e18", 2, "--time"},
        {"hardly a frame a second", "--output %1/a#.png --frames 0-1 --fps 1e-300", 2, "0.01"},
        {"endless frames a second", "--output %1/a#.png --frames 0-1 --fps inf", 2, "--fps"},
        {"frames a second that are none", "--output %1/a.png --fps nan", 2, "--fps"},
        {"negative frames a second", "--output %1/a#.png --frames 0-1 --fps -30", 2, "--fps"},
        {"the last frame of all", "--output %1/a#.png --frames 0-2147483647", 2, "a week"},
        {"more frames than a number holds", "--output %1/a#.png --frames 0-99999999999", 2,
         "not a range"},
        {"negative frames", "--output %1/a#.png --frames -3-5", 2, "not a range"},
    };
    for (const BadUsage& row : rows) {
        QTest::newRow(row.name) << QString::fromLatin1(row.options) << row.status
                                << QByteArray(row.message);
    }
}

void RenderCommandTest::drawsOnlyWhatMakesSense()
{
    QFETCH(const QString, options);
    QFETCH(const int, status);
    QFETCH(const QByteArray, message);
    const QTemporaryDir folder;
    QStringList arguments{QStringLiteral("render"), exampleScene()};
    if (!options.contains(QStringLiteral("--size"))) {
        arguments << QStringLiteral("--size") << QStringLiteral("64x36");
    }
    const Outcome outcome =
        run(arguments + QString(options).replace(QStringLiteral("%1"), folder.path()).split(u' '));
    QVERIFY2(outcome.status == status, outcome.errors.constData());
    QVERIFY2(outcome.errors.contains(message), outcome.errors.constData());
    QVERIFY(outcome.output.isEmpty());
    QVERIFY(QDir(folder.path()).isEmpty());
}

void RenderCommandTest::drawsPicturesOfTheSizeAskedFor()
{
    const QTemporaryDir folder;
    const QString theatre = QStringLiteral(CROWD_RESOURCES "/scenes/theatre.crowd");
    const QString pattern = folder.filePath(QStringLiteral("f_###.png"));
    const Outcome outcome =
        run({QStringLiteral("render"), theatre, QStringLiteral("--output"), pattern,
             QStringLiteral("--size"), QStringLiteral("96x54"), QStringLiteral("--frames"),
             QStringLiteral("9-10"), QStringLiteral("--camera"), QStringLiteral("Back row")});
    QVERIFY2(outcome.status == 0, outcome.errors.constData());
    for (const char* name : {"f_009.png", "f_010.png"}) {
        const QImage picture(folder.filePath(QLatin1String(name)));
        QCOMPARE(picture.size(), QSize(96, 54));
        QVERIFY(!picture.hasAlphaChannel());
    }
    // Those that are not there yet, of a list.
    const QString kept = folder.filePath(QStringLiteral("f_009.png"));
    QVERIFY(QImage(96, 54, QImage::Format_Mono).save(kept)); // whatever it shows
    const qint64 keptBytes = QFileInfo(kept).size();
    QVERIFY(QFile::resize(folder.filePath(QStringLiteral("f_010.png")), 100)); // not whole
    const Outcome more =
        run({QStringLiteral("render"), theatre, QStringLiteral("--output"), pattern,
             QStringLiteral("--size"), QStringLiteral("96x54"), QStringLiteral("--frames"),
             QStringLiteral("12,8-11x2,9"), QStringLiteral("--resume")});
    QVERIFY2(more.status == 0, more.errors.constData());
    QCOMPARE(QDir(folder.path()).entryList(QDir::Files).join(u' '),
             QStringLiteral("f_008.png f_009.png f_010.png f_012.png"));
    QCOMPARE(QFileInfo(kept).size(), keptBytes);
    QCOMPARE(QImage(folder.filePath(QStringLiteral("f_010.png"))).size(), QSize(96, 54));
    QCOMPARE(QString::fromUtf8(more.output).count(QStringLiteral(".png")), 3);
    const QString wide = folder.filePath(QStringLiteral("wide.png"));
    const Outcome large = run({QStringLiteral("render"), exampleScene(), QStringLiteral("--output"),
                               wide, QStringLiteral("--size"), QStringLiteral("20000x20"),
                               QStringLiteral("--allow-missing")});
    QVERIFY2(large.status == 0, large.errors.constData());
    QCOMPARE(QImage(wide).size(), QSize(20000, 20));
    const QStringList missing{QStringLiteral("render"), QStringLiteral("/nowhere/at-all.crowd"),
                              QStringLiteral("--output"), pattern.left(pattern.size() - 7)};
    QCOMPARE(run(missing + QStringList{QStringLiteral("--size"), QStringLiteral("9x9")}).status, 1);
}

namespace {

/// People who stand and begin to walk away along a path.
model::Scene walkers()
{
    model::Scene scene = plainScene(24);
    scene.places = {{1, "near", {0.0F, 0.0F, 3.0F}, 0.5F}, {2, "far", {0.0F, 0.0F, -9.0F}, 0.5F}};
    scene.paths = {{1, "away", model::PathKind::Simple, {1, 2}}};
    const auto present = scene.population.ids();
    const std::vector<model::IndividualId> ids(present.begin(), present.end());
    std::vector<glm::vec3> positions;
    for (std::size_t i = 0; i < ids.size(); ++i) {
        positions.emplace_back(static_cast<float>(i % 6) * 1.2F - 3.0F, 0.0F,
                               static_cast<float>(i / 6) * 1.2F);
    }
    scene.population.setValues<glm::vec3>(model::columns::position, ids, positions);
    scene.population.setValues<model::PathId>(model::columns::path, ids,
                                              std::vector<model::PathId>(ids.size(), 1));
    return scene;
}

} // namespace

void RenderCommandTest::drawsMovies()
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("a.webm"));
    const Outcome outcome =
        run({QStringLiteral("render"), QStringLiteral(CROWD_RESOURCES "/scenes/theatre.crowd"),
             QStringLiteral("--output"), path, QStringLiteral("--size"), QStringLiteral("96x54"),
             QStringLiteral("--frames"), QStringLiteral("10-15"), QStringLiteral("--fps"),
             QStringLiteral("25")});
    QVERIFY2(outcome.status == 0, outcome.errors.constData());
    QCOMPARE(outcome.output.trimmed(), path.toUtf8());
    const auto pictures = picturesOf(path, 96, 54);
    QCOMPARE(pictures.size(), std::size_t{6});
    QVERIFY(pictures.front() != pictures.back());
    QCOMPARE(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden),
             QStringList{QStringLiteral("a.webm")});
}

/// By the timeline, by a file of marks, and around.
void RenderCommandTest::movesTheCamera()
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("a.crowd"));
    model::Scene scene = plainScene(5);
    scene.cameras = {{"front", model::Camera::lookingAt({0.0F, 2.0F, 9.0F}, {0.0F, 1.0F, 0.0F})},
                     {"top", model::Camera::lookingAt({0.0F, 9.0F, 0.5F}, {0.0F, 0.0F, 0.0F})}};
    model::Mark cut;
    cut.id = 1;
    cut.kind = model::MarkKind::Camera;
    cut.seconds = 2.0;
    cut.camera = "top";
    scene.timeline = {cut};
    QVERIFY(model::saveProject(scene, path).isOk());
    const auto pictures = [&](const QString& options) {
        const QString pattern = folder.filePath(QStringLiteral("f#.png"));
        const Outcome outcome = run(
            QStringList{QStringLiteral("render"), path, QStringLiteral("--output"), pattern,
                        QStringLiteral("--size"), QStringLiteral("64x36"), QStringLiteral("--fps"),
                        QStringLiteral("1"), QStringLiteral("--frames"), QStringLiteral("0-3")} +
            options.split(u' ', Qt::SkipEmptyParts));
        std::vector<QImage> drawn;
        for (int i = 0; i < 4 && outcome.status == 0; ++i) {
            drawn.emplace_back(folder.filePath(QStringLiteral("f%1.png").arg(i)));
        }
        return drawn;
    };
    const auto directed = pictures({});
    const auto front = pictures(QStringLiteral("--camera front"));
    const auto top = pictures(QStringLiteral("--camera top"));
    QVERIFY(directed.size() == 4 && front.size() == 4 && top.size() == 4);
    QVERIFY(directed[1] == front[1] && directed[2] == top[2] && directed[3] == top[3]);
    QVERIFY(front[1] != top[1]);

    const auto around = pictures(QStringLiteral("--camera front --camera-move turntable"));
    QVERIFY(around.size() == 4);
    QVERIFY(around[0] == front[0] && around[1] != front[1] && around[2] != around[1]);
    const auto over = pictures(QStringLiteral("--camera front --transparent"));
    QVERIFY(over.size() == 4 && over[0].hasAlphaChannel() && qAlpha(over[0].pixel(0, 0)) == 0);

    const QString marks = folder.filePath(QStringLiteral("move.json"));
    const auto byFile = [&](const QByteArray& content) {
        QFile file(marks);
        const bool isWritten = file.open(QIODevice::WriteOnly) && file.write(content) >= 0;
        file.close();
        return isWritten ? pictures(QStringLiteral("--camera-move ") + marks)
                         : std::vector<QImage>();
    };
    const auto cutEarlier =
        byFile(R"({"timeline": [{"id": 1, "seconds": 1, "kind": "camera", "camera": "top"}]})");
    QVERIFY(cutEarlier.size() == 4 && cutEarlier[0] == front[0] && cutEarlier[1] == top[1]);
    const auto listAlone = byFile(R"([{"seconds": 1, "kind": "camera", "camera": "top"}])");
    QVERIFY(listAlone.size() == 4 && listAlone[0] == front[0] && listAlone[1] == top[1]);
    for (const char* odd : {"", "[1]", "{", R"({"timeline": []})", R"({"timeline": 7})",
                            R"({"timeline": [{"id": 1, "seconds": 1, "kind": "tram"}]})"}) {
        QVERIFY2(byFile(odd).empty(), odd);
    }
}

void RenderCommandTest::drawsNothingThatLacksSomething()
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("a.crowd"));
    const QString picture = folder.filePath(QStringLiteral("a.png"));
    const QStringList render{QStringLiteral("render"),   path,
                             QStringLiteral("--output"), picture,
                             QStringLiteral("--size"),   QStringLiteral("64x36")};
    model::Scene scene = plainScene(3);
    scene.templates.front().path = "builtin:templates/nobody.glb";
    scene.templates.front().name = "Somebody";
    model::StageEntry stage;
    stage.id = 1;
    stage.name = "Opera";
    stage.path = folder.filePath(QStringLiteral("opera.glb")).toStdString();
    scene.stages.push_back(stage);
    QVERIFY(model::saveProject(scene, path).isOk());
    const Outcome refused = run(render);
    QCOMPARE(refused.status, 1);
    for (const char* part : {"character \"Somebody\", of whom there are 3", "stage \"Opera\"",
                             "opera.glb", "--allow-missing"}) {
        QVERIFY2(refused.errors.contains(part), refused.errors.constData());
    }
    QVERIFY(refused.output.isEmpty());
    QVERIFY(!QFile::exists(picture));
    const Outcome allowed = run(render + QStringList{QStringLiteral("--allow-missing")});
    QVERIFY2(allowed.status == 0, allowed.errors.constData());
    QVERIFY(allowed.errors.contains("Opera"));
    QCOMPARE(QImage(picture).size(), QSize(64, 36));
    const Outcome measured =
        run({QStringLiteral("bench"), QStringLiteral("render"), QStringLiteral("--scene"), path});
    QCOMPARE(measured.status, 1);
    QVERIFY2(measured.errors.contains("Opera"), measured.errors.constData());
    // Of whom there is nobody, no picture lacks.
    scene = plainScene(1);
    scene.templates.push_back(scene.templates.front());
    scene.templates.back().id = 2;
    scene.templates.back().path = "builtin:templates/nobody.glb";
    QVERIFY(model::saveProject(scene, path).isOk());
    QCOMPARE(run(render).status, 0);
}

void RenderCommandTest::opensWhatComesWithIt()
{
    const QTemporaryDir folder;
    const QString picture = folder.filePath(QStringLiteral("a.png"));
    const QString meadow = QStringLiteral("builtin:scenes/meadow.crowd");
    const Outcome described = run({QStringLiteral("info"), meadow});
    QVERIFY2(described.status == 0, described.errors.constData());
    QVERIFY(described.output.contains("individuals"));
    const Outcome drawn = run({QStringLiteral("render"), meadow, QStringLiteral("--output"),
                               picture, QStringLiteral("--size"), QStringLiteral("64x36")});
    QVERIFY2(drawn.status == 0, drawn.errors.constData());
    QCOMPARE(QImage(picture).size(), QSize(64, 36));
    QCOMPARE(run({QStringLiteral("info"), QStringLiteral("builtin:templates/man.glb")}).status, 0);
    for (const char* wrong : {"builtin:scenes/nowhere.crowd", "builtin:../../etc/passwd"}) {
        const Outcome outcome = run(
            {QStringLiteral("render"), QLatin1String(wrong), QStringLiteral("--output"), picture});
        QCOMPARE(outcome.status, 1);
        QVERIFY2(outcome.errors.contains(wrong), outcome.errors.constData());
    }
}

void RenderCommandTest::aFrameIsTheSameFromAnyRangeAndThreads_data()
{
    QTest::addColumn<QString>("scene"); ///< empty: walkers
    QTest::newRow("people who begin to walk") << QString();
#ifndef CROWD_SANITIZED // which finds nothing more in larger ones
    for (const char* name : {"theatre", "city", "meadow", "stadium"}) {
        QTest::newRow(name) << QStringLiteral("builtin:scenes/%1.crowd").arg(QLatin1String(name));
    }
#endif
}

void RenderCommandTest::aFrameIsTheSameFromAnyRangeAndThreads()
{
    QFETCH(QString, scene);
    const QTemporaryDir folder;
    if (scene.isEmpty()) {
        scene = folder.filePath(QStringLiteral("walkers.crowd"));
        QVERIFY(model::saveProject(walkers(), scene).isOk());
    }
    const auto draw = [&](const char* name, const char* frames, bool isOneThread) {
        const QString pattern = folder.filePath(QLatin1String(name) + QStringLiteral("_##.png"));
        const auto onOneProcessor = [] {
            cpu_set_t processors;
            CPU_ZERO(&processors);
            ::sched_getaffinity(0, sizeof processors, &processors);
            int first = 0;
            while (first < CPU_SETSIZE && !CPU_ISSET(first, &processors)) {
                ++first;
            }
            CPU_ZERO(&processors);
            CPU_SET(first, &processors);
            ::sched_setaffinity(0, sizeof processors, &processors);
        };
        return run({QStringLiteral("render"), scene, QStringLiteral("--output"), pattern,
                    QStringLiteral("--size"), QStringLiteral("192x108"), QStringLiteral("--frames"),
                    QLatin1String(frames)},
                   isOneThread ? std::function<void()>(onOneProcessor) : std::function<void()>());
    };
    const Outcome whole = draw("whole", "0-11", false);
    QVERIFY2(whole.status == 0, whole.errors.constData());
    const Outcome one = draw("one", "5-5", true);
    QVERIFY2(one.status == 0, one.errors.constData());
    const Outcome late = draw("late", "9-11", false);
    QVERIFY2(late.status == 0, late.errors.constData());
    for (const auto& [name, frame] : {std::pair{"one", "05"}, {"late", "09"}, {"late", "11"}}) {
        const auto at = [&, frame = frame](const char* range) {
            return contentOf(folder.filePath(
                QStringLiteral("%1_%2.png").arg(QLatin1String(range), QLatin1String(frame))));
        };
        QVERIFY(!at("whole").isEmpty());
        QVERIFY2(at(name) == at("whole"), frame);
    }
}

void RenderCommandTest::aFullDiskIsAFailure()
{
    const QTemporaryDir folder;
    const QStringList render{
        QStringLiteral("render"),   QStringLiteral(CROWD_RESOURCES "/templates/man.glb"),
        QStringLiteral("--output"), folder.filePath(QStringLiteral("a.png")),
        QStringLiteral("--size"),   QStringLiteral("160x90")};
    QCOMPARE(run(render).status, 0);
    const qint64 size = QFileInfo(folder.filePath(QStringLiteral("a.png"))).size();
    QVERIFY(size > 1000);
    QVERIFY(QFile::remove(folder.filePath(QStringLiteral("a.png"))));
    for (const qint64 room : {qint64{0}, size / 2, size - 1}) {
        const Outcome outcome = run(render, [room] {
            const rlimit full{static_cast<rlim_t>(room), static_cast<rlim_t>(room)};
            ::setrlimit(RLIMIT_FSIZE, &full);
        });
        QCOMPARE(outcome.status, 1);
        QVERIFY2(outcome.errors.contains("a.png cannot be written"), outcome.errors.constData());
        QVERIFY(outcome.output.isEmpty());
        QVERIFY(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden).isEmpty());
    }
}

void RenderCommandTest::aLongSimulationTellsAndEnds()
{
    const QTemporaryDir folder;
    const QString scene = folder.filePath(QStringLiteral("walkers.crowd"));
    QVERIFY(model::saveProject(walkers(), scene).isOk());
    QProcess program;
    program.setProcessEnvironment(withoutDisplay());
    program.start(QStringLiteral(CROWD_PROGRAM),
                  {QStringLiteral("render"), scene, QStringLiteral("--output"),
                   folder.filePath(QStringLiteral("a.png")), QStringLiteral("--size"),
                   QStringLiteral("64x36"), QStringLiteral("--time"), QStringLiteral("604800")});
    QByteArray errors;
    const auto hears = [&] {
        program.waitForReadyRead(100);
        errors += program.readAllStandardError();
        return errors.contains("of 604800.0 s");
    };
    QTRY_VERIFY_WITH_TIMEOUT(hears(), 60'000);
    QCOMPARE(::kill(static_cast<pid_t>(program.processId()), SIGINT), 0);
    QVERIFY(program.waitForFinished(5000));
    QCOMPARE(program.exitStatus(), QProcess::NormalExit);
    QCOMPARE(program.exitCode(), 130);
    QCOMPARE(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden).size(), 1);
}

CROWD_TEST(RenderCommandTest)
#include "tst_RenderCommand.moc"
