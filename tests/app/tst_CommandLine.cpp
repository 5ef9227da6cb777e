// SPDX-License-Identifier: MIT
#include <QtCore/QJsonDocument>
#include <QtCore/QJsonObject>
#include <QtCore/QProcess>
#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>

/// The program from outside, in an environment without a display: statuses and messages.
class CommandLineTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void statusAndMessage_data();
    void statusAndMessage();
    void jsonIsAloneOnStandardOutput();
    void aFailureIsOneLine();
};

namespace {

struct Outcome
{
    int status = -1;
    QByteArray output;
    QByteArray errors;
};

Outcome run(const QStringList& arguments)
{
    QProcess program;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"}) {
        environment.remove(QLatin1String(name));
    }
    program.setProcessEnvironment(environment);
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

void CommandLineTest::jsonIsAloneOnStandardOutput()
{
    const Outcome outcome = run({QStringLiteral("info"), exampleScene(), QStringLiteral("--json")});
    QCOMPARE(outcome.status, 0);
    QJsonParseError problem{};
    const QJsonObject info = QJsonDocument::fromJson(outcome.output, &problem).object();
    QCOMPARE(problem.error, QJsonParseError::NoError);
    QCOMPARE(info.value(QStringLiteral("kind")).toString(), QStringLiteral("scene"));
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

QTEST_GUILESS_MAIN(CommandLineTest)
#include "tst_CommandLine.moc"
