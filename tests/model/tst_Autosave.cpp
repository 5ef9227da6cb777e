// SPDX-License-Identifier: MIT
#include "model/project/Autosave.h"

#include <QtCore/QDateTime>
#include <QtCore/QDir>
#include <QtCore/QFile>
#include <QtCore/QFileInfo>
#include <QtCore/QStandardPaths>
#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>

#include "model/project/ProjectFile.h"
#include "tests/model/CrashedEditor.h"
#include "tests/program/Test.h"

using namespace crowd::model;
using namespace crowd::testing;

namespace {

Scene namedScene(const char* name)
{
    Scene scene;
    scene.name = name;
    return scene;
}

std::string nameIn(const QString& file)
{
    const Result<Scene> read = readProject(file);
    return read ? read.value().name : read.error().message;
}

void setAge(const QString& path, int seconds)
{
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadWrite));
    QVERIFY(file.setFileTime(QDateTime::currentDateTime().addSecs(-seconds),
                             QFileDevice::FileModificationTime));
}

} // namespace

class tst_Autosave : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void init();
    void cleanup();
    void livingEditorsAreLeftInPeace();
    void offersWhatACrashLeft();
    void offersTheNewestFirst();
    void offersNothingOlderThanTheFile();
    void recoversDocumentsNeverSaved();
    void keepsWorkOfFoldersThatCannotBeWritten();
    void saysWhenNothingCanBeKept();

private:
    std::unique_ptr<QTemporaryDir> m_folder;
    QString m_path;
};

void tst_Autosave::initTestCase()
{
    QStandardPaths::setTestModeEnabled(true);
    QCoreApplication::setApplicationName(QStringLiteral("tst_Autosave"));
}

void tst_Autosave::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    m_path = m_folder->filePath(QStringLiteral("Straße [1].crowd"));
    QVERIFY(saveProject(namedScene("saved"), m_path).isOk());
    setAge(m_path, 100);
}

void tst_Autosave::cleanup()
{
    QDir(QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation))
        .removeRecursively();
}

void tst_Autosave::livingEditorsAreLeftInPeace()
{
    QVERIFY(writeAutosave(namedScene("mine"), m_path).isOk());
    QVERIFY(writeAutosave(namedScene("mine too"), {}).isOk());
    QVERIFY(QFile::exists(autosavePath(m_path)));
    QVERIFY(findRecovery(m_path).isEmpty());
    QVERIFY(findUntitledRecoveries().isEmpty());
    removeOldRecoveries(m_path);
    QVERIFY(QFile::exists(autosavePath(m_path)));
    removeAutosave(m_path);
    QVERIFY(!QFile::exists(autosavePath(m_path)));
    QVERIFY(QFile::exists(autosavePath({})));
    removeAutosave({});
    QVERIFY(!QFile::exists(autosavePath({})));
}

void tst_Autosave::offersWhatACrashLeft()
{
    QVERIFY(writeAutosave(namedScene("unsaved"), m_path).isOk());
    const QString left = leaveBehind(m_path);
    QCOMPARE(findRecovery(m_path), left);
    QCOMPARE(nameIn(left), std::string("unsaved"));
    QVERIFY(findRecovery(m_folder->filePath(QStringLiteral("other.crowd"))).isEmpty());
    adoptRecovery(left, m_path);
    QVERIFY(findRecovery(m_path).isEmpty());
    QCOMPARE(nameIn(autosavePath(m_path)), std::string("unsaved"));
    QVERIFY(!leaveBehind(m_path).isEmpty()); // crashes once more
    QVERIFY(!findRecovery(m_path).isEmpty());
}

void tst_Autosave::offersTheNewestFirst()
{
    QStringList left;
    for (int crash = 0; crash < 3; ++crash) {
        QVERIFY(writeAutosave(namedScene(crash == 1 ? "newest" : "older"), m_path).isOk());
        left << leaveBehind(m_path, crash);
        setAge(left.back(), crash == 1 ? 10 : 50);
    }
    QCOMPARE(nameIn(findRecovery(m_path)), std::string("newest"));
    QVERIFY(QFile::remove(left[1]));
    QCOMPARE(nameIn(findRecovery(m_path)), std::string("older"));
    QVERIFY(saveProject(namedScene("saved again"), m_path).isOk());
    removeOldRecoveries(m_path);
    QVERIFY(!QFile::exists(left[0]) && !QFile::exists(left[2]));
}

void tst_Autosave::offersNothingOlderThanTheFile()
{
    QVERIFY(writeAutosave(namedScene("old"), m_path).isOk());
    setAge(leaveBehind(m_path), 1000);
    QVERIFY(findRecovery(m_path).isEmpty());
}

void tst_Autosave::recoversDocumentsNeverSaved()
{
    QVERIFY(writeAutosave(namedScene("never saved"), {}).isOk());
    const QString left = leaveBehind({});
    QCOMPARE(findUntitledRecoveries(), QStringList{left});
    adoptRecovery(left, {});
    QVERIFY(findUntitledRecoveries().isEmpty());
    QCOMPARE(nameIn(autosavePath({})), std::string("never saved"));
}

void tst_Autosave::keepsWorkOfFoldersThatCannotBeWritten()
{
    const QString path = QStringLiteral("/proc/a.crowd"); // even root cannot write there
    QVERIFY(writeAutosave(namedScene("kept"), path).isOk());
    QVERIFY(findRecovery(path).isEmpty());
    const QString folder = QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) +
                           QStringLiteral("/unsaved");
    const QStringList kept = QDir(folder).entryList(QDir::Files);
    QCOMPARE(kept.size(), 1);
    QString left = kept.front();
    left.replace(QRegularExpression(QStringLiteral("\\.[0-9]+-[0-9]+\\.")),
                 QStringLiteral(".9000000-1."));
    QVERIFY(QDir(folder).rename(kept.front(), left));
    QCOMPARE(nameIn(findRecovery(path)), std::string("kept"));
    QVERIFY(findUntitledRecoveries().isEmpty());
    adoptRecovery(findRecovery(path), path);
    QVERIFY(findRecovery(path).isEmpty());
    removeAutosave(path);
    QVERIFY(QDir(folder).isEmpty());
}

void tst_Autosave::saysWhenNothingCanBeKept()
{
    const QString data = QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation);
    QVERIFY(QDir().mkpath(data));
    QFile inTheWay(data + QStringLiteral("/unsaved"));
    QVERIFY(inTheWay.open(QIODevice::WriteOnly));
    const Result<void> kept = writeAutosave(namedScene("lost"), {});
    QVERIFY(!kept.isOk());
    QVERIFY2(kept.error().message.find("unsaved") != std::string::npos,
             kept.error().message.c_str());
}

CROWD_TEST(tst_Autosave)
#include "tst_Autosave.moc"
