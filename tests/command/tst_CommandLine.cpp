// SPDX-License-Identifier: MIT
#include <QtCore/QJsonDocument>
#include <QtCore/QJsonObject>
#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>

#include "tests/command/Program.h"
#include "tests/program/Test.h"

using namespace crowd::testing;

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
    void aCardIsWrittenInEachLanguage();
    void failuresAreEnglishInEveryLanguage();
    void measuresOnlyWhatMakesSense_data();
    void measuresOnlyWhatMakesSense();
    void givesScriptsAllThatFollowsThem_data();
    void givesScriptsAllThatFollowsThem();
};

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
    QTest::newRow("a script is still the program's to explain")
        << QStringList{QStringLiteral("script"), QStringLiteral("--help")} << 0
        << QByteArray("sys.argv") << QByteArray();
    QTest::newRow("no script is bad usage")
        << QStringList{QStringLiteral("script")} << 2 << QByteArray() << QByteArray("FILE");
    QTest::newRow("a failure says whose it is")
        << QStringList{QStringLiteral("render"), nowhere, QStringLiteral("--output"),
                       QStringLiteral("/nowhere/a.png")}
        << 1 << QByteArray() << QByteArray("crowdbrush render: ");
    QTest::newRow("a missing script is said as that")
        << QStringList{QStringLiteral("script"), QStringLiteral("/nowhere/a.py")} << 1
        << QByteArray() << QByteArray("crowdbrush script: /nowhere/a.py is not a file");
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
    QTest::newRow("a card without a file is bad usage")
        << QStringList{QStringLiteral("card")} << 2 << QByteArray() << QByteArray("--output");
    QTest::newRow("a card that cannot be written is a failure")
        << QStringList{QStringLiteral("card"), QStringLiteral("--output"),
                       QStringLiteral("/nowhere/card.pdf")}
        << 1 << QByteArray() << QByteArray("crowdbrush card: /nowhere/card.pdf");
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
    QTest::newRow("what levels lose") << QStringLiteral("bench render --count 60 --frames 1 --size "
                                                        "256x144 --detail levels --quality")
                                      << QStringLiteral("full_psnr full_ssim lost_psnr lost_ssim");
    QTest::newRow("painting") << QStringLiteral("bench paint --count 100")
                              << QStringLiteral("count dab_ms_p50 dab_ms_p99 undo_ms frame_ms "
                                                "candidates_per_dab candidates_ratio_100k_10k "
                                                "state_keep_ms state_recall_ms state_undo_ms "
                                                "session_frame_ms fade_frame_ms");
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
    QTest::newRow("keeping a run")
        << QStringLiteral("bench motion --count 50 --frames 70")
        << QStringLiteral("count frames frames_kept bytes_per_person_step disk_bytes step_ms "
                          "write_percent seek_ms_p50 seek_ms_p99 retake_seconds");
    QTest::newRow("scripts") << QStringLiteral("bench python --count 100 --rounds 1")
                             << QStringLiteral("count rounds columns_ratio stroke_ratio");
    QTest::newRow("files") << QStringLiteral("bench io --count 100")
                           << QStringLiteral(
                                  "count bytes save_ms load_ms parse_floor_ms "
                                  "state_bytes state_save_ms state_load_ms "
                                  "state_parse_floor_ms cast_templates cast_bytes cast_load_ms "
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

void CommandLineTest::aCardIsWrittenInEachLanguage()
{
    const QTemporaryDir folder;
    QByteArray before;
    for (const char* language : {"en", "de"}) {
        const QString path = folder.filePath(QLatin1String(language) + QStringLiteral(".pdf"));
        const Outcome outcome = run({QStringLiteral("--language"), QLatin1String(language),
                                     QStringLiteral("card"), QStringLiteral("--output"), path});
        QCOMPARE(outcome.status, 0);
        QVERIFY2(outcome.output.isEmpty() && outcome.errors.isEmpty(), outcome.errors.constData());
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray bytes = file.readAll();
        QVERIFY(bytes.startsWith("%PDF") && bytes != before);
        before = bytes;
    }
}

void CommandLineTest::failuresAreEnglishInEveryLanguage()
{
    const QTemporaryDir folder;
    const auto wrongIn = [&folder](const QString& name, const QByteArray& bytes) {
        QFile file(folder.filePath(name));
        if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size()) {
            return QByteArray();
        }
        file.close();
        return run({QStringLiteral("info"), file.fileName()}).errors;
    };
    const QByteArray before = qgetenv("LANGUAGE");
    qputenv("LANGUAGE", "de");
    const QByteArray scene = wrongIn(QStringLiteral("broken.crowd"), R"({"version": 1, )");
    const QByteArray model = wrongIn(QStringLiteral("broken.glb"), "no model");
    before.isNull() ? qunsetenv("LANGUAGE") : qputenv("LANGUAGE", before);
    QVERIFY2(scene.contains("The file is damaged or was edited wrongly: it ends too early, at "
                            "line 1, column "),
             scene.constData());
    QVERIFY2(model.contains("broken.glb: this is neither a .glb"), model.constData());
}

void CommandLineTest::measuresOnlyWhatMakesSense_data()
{
    QTest::addColumn<QString>("arguments");
    QTest::addColumn<int>("status");
    QTest::addColumn<QByteArray>("message");
    const BadUsage rows[] = {
        {"nothing", "", 2, "subcommand"},
        {"what it cannot", "potato", 2, "subcommand is required"},
        {"drawing less than nobody", "render --count -1", 2, "--count"},
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
    for (const BadUsage& row : rows) {
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

void CommandLineTest::givesScriptsAllThatFollowsThem_data()
{
    QTest::addColumn<QString>("before"); ///< FILE
    QTest::addColumn<QString>("after");
    const auto row = [](const char* name, const char* before, const char* after) {
        QTest::newRow(name) << QString::fromLatin1(before) << QString::fromLatin1(after);
    };
    row("nothing", "script", "");
    row("options in their order", "script", "--write --only one two -x");
    row("a separator", "script", "-- a b");
    row("a separator between", "script", "a -- b --");
    row("a request for help", "script", "-h");
    row("a long request for help", "script", "--help");
    row("a question for the version", "script", "--version");
    row("an option that the program has", "script", "--language de --json");
    row("a command that the program has", "script", "script info render bench");
    row("with a separator before the file", "script --", "-x --help");
    row("with an option of the program before", "--language de script", "-- --help");
    row("with the same in one word", "--language=de script", "-h");
}

void CommandLineTest::givesScriptsAllThatFollowsThem()
{
    QFETCH(const QString, before);
    QFETCH(const QString, after);
    const QTemporaryDir folder;
    const QString script = folder.filePath(QStringLiteral("arguments.py"));
    QFile file(script);
    QVERIFY(file.open(QIODevice::WriteOnly));
    QVERIFY(file.write("import sys\nprint(' '.join(sys.argv[1:]))\n") > 0);
    file.close();
    const Outcome outcome =
        run(before.split(u' ') + QStringList{script} + after.split(u' ', Qt::SkipEmptyParts));
    QVERIFY2(outcome.status == 0, outcome.errors.constData());
    QCOMPARE(outcome.output, after.toUtf8() + '\n');
}

CROWD_TEST(CommandLineTest)
#include "tst_CommandLine.moc"
