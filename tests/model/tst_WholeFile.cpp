// SPDX-License-Identifier: MIT
#include "model/project/WholeFile.h"

#include <csignal>

#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include <QtCore/QDir>
#include <QtCore/QFile>
#include <QtCore/QFileInfo>
#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>

#include "model/project/ProcessName.h"
#include "tests/model/FullDisk.h"
#include "tests/program/FileContent.h"
#include "tests/program/Test.h"

using namespace crowd::model;
using crowd::testing::contentOf;
using crowd::testing::FullDisk;

namespace {

/// A process that waits to be ended by its number.
pid_t startIdle()
{
    const pid_t process = ::fork();
    if (process == 0) {
        for (;;) {
            ::pause();
        }
    }
    return process;
}

QString processNameOf(pid_t process)
{
    const QByteArray stat = contentOf(QStringLiteral("/proc/%1/stat").arg(process));
    return QStringLiteral("%1-%2").arg(process).arg(
        QString::fromLatin1(stat.mid(stat.lastIndexOf(')') + 2).split(' ').value(19)));
}

} // namespace

/// Files written whole or not at all, and the names of processes that write them.
class tst_WholeFile : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void refusesWhatIsNoFile_data();
    void refusesWhatIsNoFile();
    void followsLinksThatStayLinks();
    void refusesLinksInACircle();
    void keepsTheOldFileWhenTheLastBytesFindNoRoom();
    void leavesNothingWithoutCommit();
    void keepsPermissions();
    void writesUnderTheLongestName();
    void removesWhatKilledWritersLeft();
    void whoeverWasKilledIsDeadAtOnce();

private:
    [[nodiscard]] QString at(const QString& name) const { return m_folder->filePath(name); }
    [[nodiscard]] QStringList files() const
    {
        return QDir(m_folder->path())
            .entryList(QDir::AllEntries | QDir::System | QDir::Hidden | QDir::NoDotAndDotDot);
    }

    std::unique_ptr<QTemporaryDir> m_folder;
};

void tst_WholeFile::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
}

void tst_WholeFile::refusesWhatIsNoFile_data()
{
    QTest::addColumn<QString>("kind");
    QTest::addColumn<bool>("isThroughLink");
    for (const char* kind : {"pipe", "socket", "folder"}) {
        QTest::newRow(kind) << QString::fromLatin1(kind) << false;
        QTest::addRow("link to a %s", kind) << QString::fromLatin1(kind) << true;
    }
}

void tst_WholeFile::refusesWhatIsNoFile()
{
    QFETCH(const QString, kind);
    QFETCH(const bool, isThroughLink);
    const QString path = at(QStringLiteral("there"));
    const QByteArray name = QFile::encodeName(path);
    if (kind == QLatin1String("pipe")) {
        QCOMPARE(::mkfifo(name.constData(), 0600), 0);
    } else if (kind == QLatin1String("socket")) {
        const int file = ::socket(AF_UNIX, SOCK_STREAM, 0);
        sockaddr_un address{};
        address.sun_family = AF_UNIX;
        QVERIFY(static_cast<std::size_t>(name.size()) < sizeof address.sun_path);
        qstrcpy(static_cast<char*>(address.sun_path), name.constData());
        QCOMPARE(::bind(file, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
        ::close(file);
    } else {
        QVERIFY(QDir().mkpath(path));
    }
    struct stat before
    {
    };
    QCOMPARE(::lstat(name.constData(), &before), 0);
    QString target = path;
    if (isThroughLink) {
        target = at(QStringLiteral("link"));
        QVERIFY(QFile::link(path, target));
    }
    const Result<void> written = writeWholeFile(target, "text");
    QVERIFY(!written.isOk());
    const QString expected = QStringLiteral("it is a %1, not a file").arg(kind);
    QCOMPARE(QString::fromStdString(written.error().message), expected);
    struct stat after
    {
    };
    QCOMPARE(::lstat(name.constData(), &after), 0);
    QCOMPARE(after.st_ino, before.st_ino);
    QCOMPARE(after.st_mode, before.st_mode);
    QCOMPARE(files().size(), isThroughLink ? 2 : 1);
}

void tst_WholeFile::followsLinksThatStayLinks()
{
    QVERIFY(QDir(m_folder->path()).mkpath(QStringLiteral("real")));
    QVERIFY(QFile::link(QStringLiteral("real/a"), at(QStringLiteral("one"))));
    QVERIFY(QFile::link(QStringLiteral("one"), at(QStringLiteral("two"))));
    for (const char* text : {"new", "and again"}) { // the first finds a link to nothing
        QVERIFY(writeWholeFile(at(QStringLiteral("two")), text).isOk());
        QCOMPARE(contentOf(at(QStringLiteral("real/a"))), QByteArray(text));
        QVERIFY(QFileInfo(at(QStringLiteral("one"))).isSymLink());
        QVERIFY(QFileInfo(at(QStringLiteral("two"))).isSymLink());
        QCOMPARE(QDir(at(QStringLiteral("real"))).entryList(QDir::Files | QDir::Hidden).size(), 1);
    }
}

void tst_WholeFile::refusesLinksInACircle()
{
    QVERIFY(QFile::link(QStringLiteral("b"), at(QStringLiteral("a"))));
    QVERIFY(QFile::link(QStringLiteral("a"), at(QStringLiteral("b"))));
    const Result<void> written = writeWholeFile(at(QStringLiteral("a")), "text");
    QVERIFY(!written.isOk());
    QCOMPARE(written.error().message, std::string("it is a link that leads back to itself"));
    QCOMPARE(files(), (QStringList{QStringLiteral("a"), QStringLiteral("b")}));
    QVERIFY(QFileInfo(at(QStringLiteral("a"))).isSymLink());
}

void tst_WholeFile::keepsTheOldFileWhenTheLastBytesFindNoRoom()
{
    const QString path = at(QStringLiteral("a"));
    QVERIFY(writeWholeFile(path, "old").isOk());
    for (const rlim_t room : {rlim_t{0}, rlim_t{99}, rlim_t{20'000}}) {
        const std::string text(room + 1, 'x'); // one byte too many
        Result<void> written{};
        {
            const FullDisk disk(room);
            written = writeWholeFile(path, text);
        }
        QVERIFY(!written.isOk());
        QVERIFY(!written.error().message.empty());
        QCOMPARE(contentOf(path), QByteArray("old"));
        QCOMPARE(files().size(), 1);
    }
}

void tst_WholeFile::leavesNothingWithoutCommit()
{
    const QString path = at(QStringLiteral("a"));
    {
        auto file = WholeFile::begin(path);
        QVERIFY(file.isOk());
        QVERIFY(file.value().write("half").isOk());
        QVERIFY(!QFileInfo::exists(path));
        QCOMPARE(files().size(), 1);
    }
    QCOMPARE(files().size(), 0);
}

void tst_WholeFile::keepsPermissions()
{
    const QString path = at(QStringLiteral("a"));
    QVERIFY(writeWholeFile(path, "old").isOk());
    struct stat facts
    {
    };
    QCOMPARE(::stat(qPrintable(path), &facts), 0);
    const mode_t mask = ::umask(0);
    ::umask(mask);
    QCOMPARE(facts.st_mode & 0777U, 0666U & ~mask);
    QCOMPARE(::chmod(qPrintable(path), 0640), 0);
    QVERIFY(writeWholeFile(path, "new").isOk());
    QCOMPARE(::stat(qPrintable(path), &facts), 0);
    QCOMPARE(facts.st_mode & 07777U, 0640U);
}

void tst_WholeFile::writesUnderTheLongestName()
{
    const QString path = at(QString(255, QLatin1Char('n')));
    QVERIFY(writeWholeFile(path, "text").isOk());
    QCOMPARE(contentOf(path), QByteArray("text"));
}

void tst_WholeFile::removesWhatKilledWritersLeft()
{
    const QString path = at(QStringLiteral("a.crowd"));
    const QString other = at(QStringLiteral("b.crowd"));
    for (const QString& each : {path, other}) {
        const pid_t writer = ::fork();
        if (writer == 0) {
            auto file = WholeFile::begin(each);
            (void)file.value().write("half");
            ::kill(::getpid(), SIGKILL);
        }
        int status = 0;
        QCOMPARE(::waitpid(writer, &status, 0), writer);
        QVERIFY(WIFSIGNALED(status));
    }
    // What an artist has put beside it is no concern of ours.
    const QString own = at(QStringLiteral("a.crowd.backup"));
    QVERIFY(writeWholeFile(own, "backup").isOk());
    auto alive = WholeFile::begin(path); // another window, in the middle of it
    QVERIFY(alive.isOk());
    QCOMPARE(files().size(), 3); // of the other file's writer, the backup, the living one
    QVERIFY(writeWholeFile(path, "whole").isOk());
    QCOMPARE(files().size(), 4);
    QVERIFY(alive.value().write("other").isOk());
    QVERIFY(alive.value().commit().isOk());
    QCOMPARE(contentOf(path), QByteArray("other"));
    QCOMPARE(contentOf(own), QByteArray("backup"));
    QVERIFY(writeWholeFile(other, "whole").isOk());
    QCOMPARE(files().size(), 3);
}

void tst_WholeFile::whoeverWasKilledIsDeadAtOnce()
{
    QVERIFY(isProcessAlive(ownProcessName()));
    QVERIFY(!isProcessAlive(QStringLiteral("%1-1").arg(::getpid()))); // an earlier one
    const pid_t process = startIdle();
    const QString name = processNameOf(process);
    QVERIFY(isProcessAlive(name));
    QCOMPARE(::kill(process, SIGKILL), 0);
    // Nobody asks after it, so that its entry stays.
    siginfo_t info{};
    QCOMPARE(::waitid(P_PID, static_cast<id_t>(process), &info, WEXITED | WNOWAIT), 0);
    QVERIFY(QFileInfo::exists(QStringLiteral("/proc/%1").arg(process)));
    QVERIFY(!isProcessAlive(name));
    QCOMPARE(::waitpid(process, nullptr, 0), process);
    QVERIFY(!isProcessAlive(name));
}

CROWD_TEST(tst_WholeFile)
#include "tst_WholeFile.moc"
