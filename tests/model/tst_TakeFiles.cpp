// SPDX-License-Identifier: MIT
#include <QtCore/QDir>
#include <QtCore/QFile>
#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>

#include "model/project/Autosave.h"
#include "model/project/ProjectFile.h"
#include "model/project/TakeFiles.h"
#include "tests/program/Test.h"

using namespace crowd::model;

namespace {

bool write(const QString& path, const QByteArray& bytes)
{
    QFile file(path);
    return QDir().mkpath(QFileInfo(path).path()) && file.open(QIODevice::WriteOnly) &&
           file.write(bytes) == bytes.size();
}

QByteArray contents(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

Scene sceneWith(const QString& motion)
{
    Scene scene;
    Take take;
    take.id = 1;
    take.name = "Rehearsal";
    take.file = QFileInfo(motion).fileName().toStdString();
    take.begin = -1.5;
    take.end = 12.25;
    take.people = 40;
    take.isShown = true;
    take.motion = MotionFile::open(motion).value();
    scene.takes = {take};
    return scene;
}

} // namespace

class tst_TakeFiles : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        QVERIFY(write(in("elsewhere/0123.take"), QByteArray("how they moved")));
    }

    void theFolderIsCalledAfterTheProject()
    {
        QCOMPARE(takesFolder(QStringLiteral("/a/Show.crowd")), QStringLiteral("/a/Show.takes"));
        QCOMPARE(takesFolder(QStringLiteral("/a/Show.crowd.host-17.autosave")),
                 QStringLiteral("/a/Show.takes"));
        QCOMPARE(takesFolder(QStringLiteral("/a/Show")), QStringLiteral("/a/Show.takes"));
        QVERIFY(takesFolder(autosavePath(QString())).endsWith(QStringLiteral("untitled.takes")));
    }

    void savingBringsThemAlong()
    {
        QVERIFY(saveProject(sceneWith(in("elsewhere/0123.take")), in("Show.crowd")));
        QCOMPARE(contents(in("Show.takes/0123.take")), QByteArray("how they moved"));
        QVERIFY(QFile::remove(in("elsewhere/0123.take")));
        const auto read = readProject(in("Show.crowd"));
        QVERIFY(read.isOk());
        const Take& take = read.value().takes.front();
        QVERIFY(take.motion && take.problem.empty() && take.isShown);
        QCOMPARE(take.motion->read(4, 4).value().size(), std::size_t{4});
        QCOMPARE(take.begin, -1.5);
        QCOMPARE(take.end, 12.25);
        QCOMPARE(take.people, 40);
        // Once more, and under another name of the project.
        QVERIFY(saveProject(read.value(), in("Show.crowd")));
        QVERIFY(QDir().mkpath(in("further")));
        QVERIFY(saveProject(read.value(), in("further/Other.crowd")));
        QCOMPARE(contents(in("further/Other.takes/0123.take")), QByteArray("how they moved"));
    }

    void aProjectThatWasRenamedFindsThem()
    {
        QVERIFY(saveProject(sceneWith(in("elsewhere/0123.take")), in("Show.crowd")));
        QVERIFY(QFile::rename(in("Show.crowd"), in("Premiere.crowd")));
        QVERIFY(readProject(in("Premiere.crowd")).value().takes.front().motion);
    }

    void oneThatIsMissingIsKept()
    {
        QVERIFY(saveProject(sceneWith(in("elsewhere/0123.take")), in("Show.crowd")));
        QVERIFY(QDir(in("Show.takes")).removeRecursively());
        auto read = readProject(in("Show.crowd"));
        QVERIFY(read.isOk());
        const Take& take = read.value().takes.front();
        QVERIFY(!take.motion);
        const std::string said = take.problem.english();
        QVERIFY2(said.find("Rehearsal") != std::string::npos &&
                     said.find("0123.take") != std::string::npos,
                 said.c_str());
        QVERIFY(saveProject(read.value(), in("Again.crowd")));
        QCOMPARE(readProject(in("Again.crowd")).value().takes.front().name, take.name);
    }

    void namesDoNotLeadElsewhere_data()
    {
        QTest::addColumn<QString>("name");
        for (const char* name :
             {"../elsewhere/0123.take", "/etc/hostname", "", ".", "..", ".hidden", "a/b.take"}) {
            QTest::newRow(name) << QString::fromUtf8(name);
        }
    }

    void namesDoNotLeadElsewhere()
    {
        QFETCH(const QString, name);
        Scene scene = sceneWith(in("elsewhere/0123.take"));
        scene.takes.front().motion.reset();
        scene.takes.front().file = name.toStdString();
        QVERIFY(QDir().mkpath(in("Show.takes")));
        openTakes(scene, in("Show.crowd"));
        QVERIFY(!scene.takes.front().motion);
        QVERIFY(!scene.takes.front().problem.empty());
    }

    void aFolderInTheWayIsSaid()
    {
        QVERIFY(write(in("Show.takes"), QByteArray("no folder")));
        const auto saved = saveProject(sceneWith(in("elsewhere/0123.take")), in("Show.crowd"));
        QVERIFY(!saved);
        QVERIFY2(saved.error().message.find("Rehearsal") != std::string::npos,
                 saved.error().message.c_str());
        QVERIFY(!QFileInfo::exists(in("Show.crowd"))); // nothing by halves
    }

    void whatIsNoFileIsRefused()
    {
        QVERIFY(!MotionFile::open(m_folder->path()));
        QVERIFY(!MotionFile::open(in("nowhere.take")));
        const auto file = MotionFile::open(in("elsewhere/0123.take")).value();
        QVERIFY(!file->read(10, 100));
        QVERIFY(!file->read(~std::uint64_t{0}, 2));
        QVERIFY(QFile::resize(in("elsewhere/0123.take"), 3));
        QVERIFY(!file->read(0, 10)); // it has become shorter since
    }

private:
    [[nodiscard]] QString in(const char* name) const
    {
        return m_folder->filePath(QString::fromUtf8(name));
    }

    std::unique_ptr<QTemporaryDir> m_folder;
};

CROWD_TEST(tst_TakeFiles)
#include "tst_TakeFiles.moc"
