// SPDX-License-Identifier: MIT
#include <csignal>
#include <functional>

#include <sched.h>
#include <sys/resource.h>

#include <QtCore/QDir>
#include <QtCore/QJsonDocument>
#include <QtCore/QJsonObject>
#include <QtCore/QProcess>
#include <QtCore/QTemporaryDir>
#include <QtGui/QImage>
#include <QtTest/QTest>

#include "model/project/ProjectFile.h"
#include "tests/app/SceneWindow.h"
#include "tests/program/Test.h"

using namespace crowd;

/// The program from outside, in an environment without a display: statuses and messages.
class CommandLineTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void statusAndMessage_data();
    void statusAndMessage();
    void jsonIsAloneOnStandardOutput_data();
    void jsonIsAloneOnStandardOutput();
    void aFailureIsOneLine();
    void drawsOnlyWhatMakesSense_data();
    void drawsOnlyWhatMakesSense();
    void drawsPicturesOfTheSizeAskedFor();
    void measuresOnlyWhatMakesSense_data();
    void measuresOnlyWhatMakesSense();
    void givesScriptsTheirArgumentsInOrder();
    void drawsNothingThatLacksSomething();
    void opensWhatComesWithIt();
    void aFrameIsTheSameFromAnyRangeAndThreads_data();
    void aFrameIsTheSameFromAnyRangeAndThreads();
    void aFullDiskIsAFailure();
    void aLongSimulationTellsAndEnds();
};

namespace {

struct Outcome
{
    int status = -1;
    QByteArray output;
    QByteArray errors;
};

QProcessEnvironment withoutDisplay()
{
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"}) {
        environment.remove(QLatin1String(name));
    }
    return environment;
}

/// `inProgram` is run in the new process, before the program.
Outcome run(const QStringList& arguments, const std::function<void()>& inProgram = {})
{
    QProcess program;
    program.setProcessEnvironment(withoutDisplay());
    if (inProgram) {
        program.setChildProcessModifier(inProgram);
    }
    program.start(QStringLiteral(CROWD_PROGRAM), arguments);
    if (!program.waitForFinished(60'000) || program.exitStatus() != QProcess::NormalExit) {
        return {};
    }
    return {program.exitCode(), program.readAllStandardOutput(), program.readAllStandardError()};
}

QString exampleScene()
{
    return QStringLiteral(CROWD_TEST_DATA "/project/version-1.crowd");
}

} // namespace

void CommandLineTest::statusAndMessage_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<int>("status");
    QTest::addColumn<QByteArray>("output");
    QTest::addColumn<QByteArray>("errors");
    const QString nowhere = QStringLiteral("/nowhere/at-all.crowd");
    QTest::newRow("help names the commands")
        << QStringList{QStringLiteral("--help")} << 0 << QByteArray("info") << QByteArray();
    QTest::newRow("an unknown option is bad usage")
        << QStringList{QStringLiteral("--nonsense")} << 2 << QByteArray()
        << QByteArray("--nonsense");
    QTest::newRow("a command without its file is bad usage")
        << QStringList{QStringLiteral("info")} << 2 << QByteArray() << QByteArray("FILE");
    QTest::newRow("a value out of its choices is bad usage")
        << QStringList{QStringLiteral("info"), exampleScene(), QStringLiteral("--as"),
                       QStringLiteral("potato")}
        << 2 << QByteArray() << QByteArray("potato");
    QTest::newRow("a missing file is a failure that names it")
        << QStringList{QStringLiteral("info"), nowhere} << 1 << QByteArray() << nowhere.toUtf8();
    QTest::newRow("the editor without a display says so and what works")
        << QStringList{} << 1 << QByteArray() << QByteArray("display");
    QTest::newRow("the editor with a file without a display says so")
        << QStringList{exampleScene()} << 1 << QByteArray() << QByteArray("display");
    QTest::newRow("a folder is a failure that says what to check")
        << QStringList{QStringLiteral("info"), QStringLiteral("/tmp")} << 1 << QByteArray()
        << QByteArray("not a plain file. Check the name");
    QTest::newRow("a file that is no scene says what it should be")
        << QStringList{QStringLiteral("info"), QStringLiteral(CROWD_PROGRAM)} << 1 << QByteArray()
        << QByteArray("neither a .glb");
    QTest::newRow("a scene is described") << QStringList{QStringLiteral("info"), exampleScene()}
                                          << 0 << QByteArray("individuals") << QByteArray();
}

void CommandLineTest::statusAndMessage()
{
    QFETCH(QStringList, arguments);
    QFETCH(int, status);
    QFETCH(QByteArray, output);
    QFETCH(QByteArray, errors);
    const Outcome outcome = run(arguments);
    QCOMPARE(outcome.status, status);
    QVERIFY2(outcome.output.contains(output), outcome.output.constData());
    QVERIFY2(outcome.errors.contains(errors), outcome.errors.constData());
}

void CommandLineTest::jsonIsAloneOnStandardOutput_data()
{
    QTest::addColumn<QString>("arguments");
    QTest::addColumn<QString>("members"); ///< that the object has at least
    const QString folder = QStringLiteral(CROWD_RESOURCES);
    QTest::newRow("a scene") << QStringLiteral("info ") + exampleScene()
                             << QStringLiteral("kind individuals templates stage places paths "
                                               "rules states seats warnings");
    QTest::newRow("a template") << QStringLiteral("info %1/templates/man.glb").arg(folder)
                                << QStringLiteral("kind name triangles vertices joints slots "
                                                  "clips height_m warnings");
    QTest::newRow("a stage") << QStringLiteral("info %1/stages/theatre.glb").arg(folder)
                             << QStringLiteral("kind name triangles seats warnings");
    QTest::newRow("drawing")
        << QStringLiteral("bench render --count 4 --frames 2 --size 64x36 --clock cpu --samples 0")
        << QStringLiteral("count triangles width height detail median_ms p95_ms draws "
                          "triangles_drawn bytes_per_keyframe reference ratio samples clock");
    QTest::newRow("painting") << QStringLiteral("bench paint --count 100")
                              << QStringLiteral("count dab_ms_p50 dab_ms_p99 undo_ms frame_ms");
    for (const char* workload : {"square", "corridor", "city", "paths"}) {
        QTest::newRow(qPrintable(QStringLiteral("simulating a %1").arg(QLatin1String(workload))))
            << QStringLiteral("bench simulate --count 100 --steps 10 --workload %1")
                   .arg(QLatin1String(workload))
            << QStringLiteral("workload count steps threads agent_steps_per_second median_step_ms "
                              "overlaps_per_1000 efficiency rms_acceleration bytes_per_agent "
                              "outside_walls");
    }
    QTest::newRow("simulating on one thread and on two")
        << QStringLiteral("bench simulate --count 100 --steps 20 --threads 2 --against-one-thread")
        << QStringLiteral("median_step_ms one_thread_median_step_ms times_one_thread");
    QTest::newRow("files") << QStringLiteral("bench io --count 100")
                           << QStringLiteral("count bytes save_ms load_ms parse_floor_ms "
                                             "cast_templates cast_bytes cast_load_ms "
                                             "cast_floor_ms");
}

void CommandLineTest::jsonIsAloneOnStandardOutput()
{
    QFETCH(const QString, arguments);
    QFETCH(const QString, members);
    const Outcome outcome = run(arguments.split(u' ') << QStringLiteral("--json"));
    QVERIFY2(outcome.status == 0, outcome.errors.constData());
    QJsonParseError problem{};
    const QJsonObject json = QJsonDocument::fromJson(outcome.output, &problem).object();
    QCOMPARE(problem.error, QJsonParseError::NoError);
    for (const QString& member : members.split(u' ')) {
        QVERIFY2(json.contains(member), qPrintable(member));
    }
}

void CommandLineTest::aFailureIsOneLine()
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("broken.crowd"));
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("{\"format\": \"crowdbrush-scene\", ");
    file.close();
    const Outcome outcome = run({QStringLiteral("info"), path});
    QCOMPARE(outcome.status, 1);
    QVERIFY(outcome.output.isEmpty());
    QCOMPARE(outcome.errors.trimmed().count('\n'), 0);
    QVERIFY2(outcome.errors.contains("broken.crowd"), outcome.errors.constData());
}

namespace {

struct BadDrawing
{
    const char* name;
    const char* options; ///< %1: an empty folder
    int status;
    const char* message;
};

} // namespace

void CommandLineTest::drawsOnlyWhatMakesSense_data()
{
    QTest::addColumn<QString>("options");
    QTest::addColumn<int>("status");
    QTest::addColumn<QByteArray>("message");
    const BadDrawing rows[] = {
        {"unknown camera", "--output %1/a.png --camera nobody", 1, "no camera named \"nobody\""},
        {"size 0", "--output %1/a.png --size 0x0", 2, "--size 0x0"},
        {"size of one number", "--output %1/a.png --size 64", 2, "WIDTHxHEIGHT"},
        {"size 100000", "--output %1/a.png --size 100000x100000", 2, "at most 16384"},
        {"negative size", "--output %1/a.png --size -64x-36", 2, "--size"},
        {"no such folder", "--output %1/no/a.png --allow-missing", 1, "a.png cannot be written"},
        {"a folder", "--output %1/ --allow-missing", 1, "pictures are written as PNG"},
        {"a format that is none", "--output %1/a.tiger --allow-missing", 1,
         "pictures are written as PNG"},
        {"unknown look", "--output %1/a.png --look potato", 2, "there are: plain, lit"},
        {"time that is none", "--output %1/a.png --time nan", 2, "--time"},
        {"frames without a place", "--output %1/a.png --frames 0-3", 2, "put ####"},
        {"frames backwards", "--output %1/a#.png --frames 3-0", 2, "not a range"},
        {"a place without frames", "--output %1/a#.png", 2, "--frames A-B"},
        {"no frames a second", "--output %1/a#.png --frames 0-1 --fps 0", 2, "--fps"},
        {"no output", "--size 64x36", 2, "--output"},
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
    for (const BadDrawing& row : rows) {
        QTest::newRow(row.name) << QString::fromLatin1(row.options) << row.status
                                << QByteArray(row.message);
    }
}

void CommandLineTest::drawsOnlyWhatMakesSense()
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

void CommandLineTest::drawsPicturesOfTheSizeAskedFor()
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
    const QStringList missing{QStringLiteral("render"), QStringLiteral("/nowhere/at-all.crowd"),
                              QStringLiteral("--output"), pattern.left(pattern.size() - 7)};
    QCOMPARE(run(missing + QStringList{QStringLiteral("--size"), QStringLiteral("9x9")}).status, 1);
}

void CommandLineTest::measuresOnlyWhatMakesSense_data()
{
    QTest::addColumn<QString>("arguments");
    QTest::addColumn<int>("status");
    QTest::addColumn<QByteArray>("message");
    const BadDrawing rows[] = {
        {"nothing", "", 2, "subcommand"},
        {"what it cannot", "potato", 2, "subcommand is required"},
        {"drawing nobody", "render --count 0", 2, "--count"},
        {"drawing far too many", "render --count 2000000000", 2, "--count"},
        {"no frames", "render --frames 0", 2, "--frames"},
        {"size 0", "render --size 0x0", 2, "--size 0x0"},
        {"unknown detail", "render --detail potato", 2, "--detail"},
        {"unknown clock", "render --clock sun", 2, "--clock"},
        {"too many samples", "render --samples 99", 2, "--samples"},
        {"negative triangles", "render --triangles -5", 2, "--triangles"},
        {"missing scene", "render --scene /nowhere/at-all.crowd", 1, "at-all.crowd does not exist"},
        {"slowing that is no number", "simulate --slowing nan", 2, "no number"},
        {"slowing without end", "simulate --slowing inf", 2, "--slowing"},
        {"no steps", "simulate --steps 0", 2, "--steps"},
        {"negative threads", "simulate --threads -1", 2, "--threads"},
        {"rounds beyond all", "python --rounds 1e18", 2, "--rounds"},
        {"painting nobody", "paint --count 0", 2, "--count"},
        {"painting words", "paint --count many", 2, "--count"},
        {"files of nobody", "io --count 0", 2, "--count"},
    };
    for (const BadDrawing& row : rows) {
        QTest::newRow(row.name) << QString::fromLatin1(row.options) << row.status
                                << QByteArray(row.message);
    }
}

void CommandLineTest::measuresOnlyWhatMakesSense()
{
    QFETCH(const QString, arguments);
    QFETCH(const int, status);
    QFETCH(const QByteArray, message);
    const Outcome outcome =
        run(QStringList{QStringLiteral("bench")} + arguments.split(u' ', Qt::SkipEmptyParts));
    QVERIFY2(outcome.status == status, outcome.errors.constData());
    QVERIFY2(outcome.errors.contains(message), outcome.errors.constData());
    QVERIFY(outcome.output.isEmpty());
}

void CommandLineTest::givesScriptsTheirArgumentsInOrder()
{
    const QTemporaryDir folder;
    const QString script = folder.filePath(QStringLiteral("arguments.py"));
    QFile file(script);
    QVERIFY(file.open(QIODevice::WriteOnly));
    QVERIFY(file.write("import sys\nprint(sys.argv[1:])\n") > 0);
    file.close();
    const Outcome outcome =
        run({QStringLiteral("script"), script, QStringLiteral("--write"), QStringLiteral("--only"),
             QStringLiteral("one"), QStringLiteral("two"), QStringLiteral("-x")});
    QCOMPARE(outcome.status, 0);
    QCOMPARE(outcome.output, QByteArray("['--write', '--only', 'one', 'two', '-x']\n"));
}

namespace {

/// People who stand and begin to walk away along a path.
model::Scene walkers()
{
    model::Scene scene = testing::plainScene(24);
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

QByteArray contentOf(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace

void CommandLineTest::drawsNothingThatLacksSomething()
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("a.crowd"));
    const QString picture = folder.filePath(QStringLiteral("a.png"));
    const QStringList render{QStringLiteral("render"),   path,
                             QStringLiteral("--output"), picture,
                             QStringLiteral("--size"),   QStringLiteral("64x36")};
    model::Scene scene = testing::plainScene(3);
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
    scene = testing::plainScene(1);
    scene.templates.push_back(scene.templates.front());
    scene.templates.back().id = 2;
    scene.templates.back().path = "builtin:templates/nobody.glb";
    QVERIFY(model::saveProject(scene, path).isOk());
    QCOMPARE(run(render).status, 0);
}

void CommandLineTest::opensWhatComesWithIt()
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

void CommandLineTest::aFrameIsTheSameFromAnyRangeAndThreads_data()
{
    QTest::addColumn<QString>("scene"); ///< empty: walkers
    QTest::newRow("people who begin to walk") << QString();
    for (const char* name : {"theatre", "city", "meadow", "stadium"}) {
        QTest::newRow(name) << QStringLiteral("builtin:scenes/%1.crowd").arg(QLatin1String(name));
    }
}

void CommandLineTest::aFrameIsTheSameFromAnyRangeAndThreads()
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

void CommandLineTest::aFullDiskIsAFailure()
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

void CommandLineTest::aLongSimulationTellsAndEnds()
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

CROWD_TEST(CommandLineTest)
#include "tst_CommandLine.moc"
