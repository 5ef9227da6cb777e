// SPDX-License-Identifier: MIT
#include "model/document/UndoMemory.h"

#include <fcntl.h>
#include <unistd.h>

#include <QtCore/QDir>
#include <QtCore/QFileInfo>
#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>

#include "model/document/SceneCommand.h"
#include "tests/model/FullDisk.h"
#include "tests/model/RandomEdits.h"
#include "tests/program/Test.h"

using namespace crowd::model;
using namespace crowd::testing;

namespace {

UndoLimits tinyLimits(const QString& folder)
{
    return {4096, folder, 0};
}

std::string stateOf(const SceneDocument& document)
{
    return sceneText(document.scene());
}

void turnEverybody(SceneDocument& document, float headingRadians)
{
    const auto present = document.scene().population.ids();
    const std::vector<IndividualId> ids(present.begin(), present.end());
    const auto edit = document.beginEdit().value();
    edit->setColumn(columns::heading, ids, std::span<const float>(&headingRadians, 1));
    edit->commit(QStringLiteral("Turn"));
}

/// The temporary file of this process whose folder it is, opened a second time; -1 if none.
int openSpilled(const QString& folder)
{
    for (const QFileInfo& link :
         QDir(QStringLiteral("/proc/self/fd")).entryInfoList(QDir::Files | QDir::System)) {
        const QString target = QFile::symLinkTarget(link.filePath());
        if (target.startsWith(folder) && target.contains(QStringLiteral("(deleted)"))) {
            return ::open(QFile::encodeName(link.filePath()).constData(), O_RDWR);
        }
    }
    return -1;
}

/// Turns all bits of the temporary file; twice restores it.
void spoil(const QString& folder, std::uint64_t size)
{
    const int file = openSpilled(folder);
    QVERIFY(file >= 0);
    std::vector<char> bytes(size);
    QCOMPARE(::pread(file, bytes.data(), size, 0), static_cast<ssize_t>(size));
    for (char& byte : bytes) {
        byte = static_cast<char>(~byte);
    }
    QCOMPARE(::pwrite(file, bytes.data(), size, 0), static_cast<ssize_t>(size));
    ::close(file);
}

} // namespace

class tst_UndoMemory : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void undoesTenThousandRandomEditsWhileSpilling();
    void keepsTheBudget();
    void anotherBudgetTakesEffectAtOnce();
    void countsSceneLevelEntries();
    void hasNoNameThatCouldStayBehind();
    void usesTheFileAgain();
    void keepsInMemoryWhatCannotBeWritten_data();
    void keepsInMemoryWhatCannotBeWritten();
    void goesOnSpillingWhenThereIsRoomAgain();
    void leavesRoomOnTheDisk();
    void refusesUndoThatCannotBeReadBack();
    void refusesRedoThatCannotBeReadBack();
    void stopsWhereALongMoveFails();

private:
    std::unique_ptr<QTemporaryDir> m_folder;
};

void tst_UndoMemory::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
}

void tst_UndoMemory::undoesTenThousandRandomEditsWhileSpilling()
{
    SceneDocument document(tinyLimits(m_folder->path()));
    const std::string first = stateOf(document);
    std::map<int, std::string> states;
    for (std::uint64_t key = 0; key < 10000; ++key) {
        if (randomEdit(document, key) && key % 500 == 0) {
            states[document.undoStack().index()] = stateOf(document);
        }
    }
    QVERIFY(document.undoMemory().bytesOnDisk() > 100000);
    const std::string last = stateOf(document);
    while (document.undoStack().canUndo()) {
        document.undoStack().undo();
        const auto state = states.find(document.undoStack().index());
        QVERIFY(state == states.end() || stateOf(document) == state->second);
    }
    QCOMPARE(stateOf(document), first);
    document.undoStack().setIndex(document.undoStack().count());
    QCOMPARE(stateOf(document), last);
}

void tst_UndoMemory::keepsTheBudget()
{
    SceneDocument document({100000, m_folder->path(), 0});
    addPeople(document, 1000); // about 110 bytes each
    for (int i = 1; i <= 50; ++i) {
        turnEverybody(document, static_cast<float>(i));
        QVERIFY(document.undoMemory().bytes() < 100000 + 10000); // each keeps a little
    }
    document.undoStack().setIndex(0);
    document.undoStack().setIndex(51);
    QVERIFY(document.undoMemory().bytes() < 100000 + 10000); // each keeps a little
}

void tst_UndoMemory::anotherBudgetTakesEffectAtOnce()
{
    SceneDocument document({std::size_t{1} << 30U, m_folder->path(), 0});
    int changes = 0;
    connect(&document, &SceneDocument::undoBudgetChanged, this, [&changes] { ++changes; });
    const std::string first = stateOf(document);
    addPeople(document, 1000);
    for (int i = 1; i <= 10; ++i) {
        turnEverybody(document, static_cast<float>(i));
    }
    const std::string last = stateOf(document);
    const std::size_t all = document.undoMemory().bytes();
    QCOMPARE(document.undoMemory().bytesOnDisk(), std::uint64_t{0});
    document.setUndoBudget(all / 4);
    QCOMPARE(changes, 1);
    QVERIFY(document.undoMemory().bytes() < all / 4 + 10000); // each keeps a little
    QVERIFY(document.undoMemory().bytesOnDisk() > all / 2);
    QCOMPARE(document.undoStack().count(), 11);
    document.setUndoBudget(std::size_t{1} << 30U);
    document.undoStack().setIndex(0);
    QCOMPARE(stateOf(document), first);
    document.undoStack().setIndex(11);
    QCOMPARE(stateOf(document), last);
    QCOMPARE(document.undoMemory().bytes(), all); // what was read back stays now
}

void tst_UndoMemory::countsSceneLevelEntries()
{
    SceneDocument document;
    const auto edit = document.beginEdit().value();
    TemplateEntry entry;
    entry.path = std::string(10000, 'p');
    entry.clipNames = {std::string(20000, 'c')};
    (void)edit->addTemplate(entry);
    edit->setCameras({NamedCamera{std::string(5000, 'n'), Camera{}}});
    QVERIFY(edit->commit(QStringLiteral("Much text")));
    QVERIFY(document.undoMemory().bytes() > 35000);
    document.undoStack().clear();
    QCOMPARE(document.undoMemory().bytes(), std::size_t{0});
}

void tst_UndoMemory::hasNoNameThatCouldStayBehind()
{
    SceneDocument document(tinyLimits(m_folder->path()));
    addPeople(document, 1000);
    turnEverybody(document, 1.0F);
    QVERIFY(document.undoMemory().bytesOnDisk() > 0);
    QVERIFY(QDir(m_folder->path()).isEmpty(QDir::AllEntries | QDir::NoDotAndDotDot | QDir::Hidden));
}

void tst_UndoMemory::usesTheFileAgain()
{
    SceneDocument document(tinyLimits(m_folder->path()));
    for (int round = 0; round < 20; ++round) {
        addPeople(document, 1000);
        turnEverybody(document, 1.0F);
        QVERIFY(document.undoMemory().bytesOnDisk() < 250000);
        document.undoStack().setIndex(0); // the next round forgets these
    }
    document.undoStack().clear();
    QCOMPARE(document.undoMemory().bytesOnDisk(), std::uint64_t{0});
}

void tst_UndoMemory::keepsInMemoryWhatCannotBeWritten_data()
{
    QTest::addColumn<QString>("folder");
    QTest::addColumn<int>("diskBytes");
    QTest::newRow("folder is not there") << QStringLiteral("/nowhere/at/all") << -1;
    QTest::newRow("folder is a file") << QStringLiteral("/proc/version") << -1;
    QTest::newRow("disk is full from the start") << QString() << 0;
    QTest::newRow("disk fills up half way") << QString() << 150000;
}

void tst_UndoMemory::keepsInMemoryWhatCannotBeWritten()
{
    QFETCH(QString, folder);
    QFETCH(int, diskBytes);
    std::optional<FullDisk> disk;
    if (diskBytes >= 0) {
        folder = m_folder->path();
        disk.emplace(static_cast<rlim_t>(diskBytes));
    }
    SceneDocument document(tinyLimits(folder));
    QStringList complaints;
    connect(&document, &SceneDocument::undoMemoryExceeded, this,
            [&complaints](const QString& why) { complaints << why; });
    const std::string first = stateOf(document);
    for (int i = 0; i < 10; ++i) {
        addPeople(document, 500);
        turnEverybody(document, static_cast<float>(i + 1));
    }
    const std::string last = stateOf(document);
    QCOMPARE(complaints.size(), 1);
    QVERIFY(document.undoMemory().bytes() > 100000);
    document.undoStack().setIndex(0);
    QCOMPARE(stateOf(document), first);
    document.undoStack().setIndex(20);
    QCOMPARE(stateOf(document), last);
}

void tst_UndoMemory::goesOnSpillingWhenThereIsRoomAgain()
{
    SceneDocument document(tinyLimits(m_folder->path()));
    {
        const FullDisk disk(0);
        addPeople(document, 4000);
        turnEverybody(document, 1.0F);
        QVERIFY(document.undoMemory().bytes() > 30000);
        QVERIFY(!document.undoMemory().problem().empty());
    }
    turnEverybody(document, 2.0F);
    QVERIFY(document.undoMemory().bytes() < 25000); // one step, and what every step takes
    QVERIFY(document.undoMemory().problem().empty());
}

void tst_UndoMemory::leavesRoomOnTheDisk()
{
    SceneDocument document({0, m_folder->path(), std::uint64_t{1} << 62U});
    addPeople(document, 1000);
    turnEverybody(document, 1.0F);
    QCOMPARE(document.undoMemory().bytesOnDisk(), std::uint64_t{0});
    document.undoStack().setIndex(0);
    QVERIFY(document.scene().population.isEmpty());
}

void tst_UndoMemory::refusesUndoThatCannotBeReadBack()
{
    SceneDocument document(tinyLimits(m_folder->path()));
    QString refusal;
    connect(&document, &SceneDocument::undoRefused, this,
            [&refusal](const QString& why) { refusal = why; });
    addPeople(document, 1000);
    turnEverybody(document, 1.0F);
    document.markSaved(QStringLiteral("/tmp/a.crowd"));
    document.undoStack().undo(); // still in memory
    const std::string before = stateOf(document);
    const std::uint64_t size = document.undoMemory().bytesOnDisk();
    spoil(m_folder->path(), size);
    document.undoStack().undo();
    QVERIFY2(refusal.contains(QStringLiteral("temporary file")), qPrintable(refusal));
    QCOMPARE(stateOf(document), before);
    QCOMPARE(document.undoStack().index(), 1);
    QVERIFY(document.isModified());
    QVERIFY(document.undoStack().canUndo() && document.undoStack().canRedo());
    document.undoStack().redo();
    QCOMPARE(document.undoStack().index(), 2);
    QVERIFY(!document.isModified());
    document.undoStack().undo();
    spoil(m_folder->path(), size);
    document.undoStack().undo();
    QVERIFY(document.scene().population.isEmpty());
}

void tst_UndoMemory::refusesRedoThatCannotBeReadBack()
{
    SceneDocument document(tinyLimits(m_folder->path()));
    addPeople(document, 1000);
    turnEverybody(document, 1.0F);
    const std::string last = stateOf(document);
    document.undoStack().setIndex(0);
    const std::uint64_t size = document.undoMemory().bytesOnDisk();
    spoil(m_folder->path(), size);
    int refusals = 0;
    connect(&document, &SceneDocument::undoRefused, this, [&refusals] { ++refusals; });
    document.undoStack().setIndex(2);
    QCOMPARE(refusals, 1);
    QCOMPARE(document.undoStack().index(), 1); // the first step was still in memory
    QCOMPARE(document.scene().population.column(columns::heading)[0], 0.0F);
    spoil(m_folder->path(), size);
    document.undoStack().setIndex(2);
    QCOMPARE(stateOf(document), last);
}

void tst_UndoMemory::stopsWhereALongMoveFails()
{
    SceneDocument document({120000, m_folder->path(), 0});
    std::vector<std::string> states{stateOf(document)};
    for (int i = 0; i < 40; ++i) {
        i == 0 ? (void)addPeople(document, 1000) : turnEverybody(document, static_cast<float>(i));
        states.push_back(stateOf(document));
    }
    QVERIFY(document.undoMemory().bytesOnDisk() > 0);
    const std::uint64_t size = document.undoMemory().bytesOnDisk();
    spoil(m_folder->path(), size);
    document.undoStack().setIndex(0);
    const int reached = document.undoStack().index();
    QVERIFY(reached > 0 && reached < 40);
    QCOMPARE(stateOf(document), states[static_cast<std::size_t>(reached)]);
    document.undoStack().setIndex(40);
    QCOMPARE(stateOf(document), states.back());
    spoil(m_folder->path(), size);
    document.undoStack().setIndex(0);
    QCOMPARE(stateOf(document), states.front());
}

CROWD_TEST(tst_UndoMemory)
#include "tst_UndoMemory.moc"
