// SPDX-License-Identifier: MIT
#include <QtCore/QDir>
#include <QtCore/QFileInfo>
#include <QtCore/QProcess>
#include <QtCore/QRegularExpression>
#include <QtCore/QTranslator>
#include <QtTest/QTest>
#include <QtWidgets/QApplication>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QTreeWidget>

#include "app/window/RecentFiles.h"
#include "model/project/LocateAssets.h"
#include "model/project/SceneAssets.h"
#include "tests/app/SceneWindow.h"
#include "tests/model/CrashedEditor.h"
#include "tests/program/WindowTest.h"

using namespace crowd;
using namespace crowd::testing;

namespace {

/// A template whose file is not there.
void addMissing(model::Scene& scene, model::TemplateId id, const QString& name, const QString& path)
{
    model::TemplateEntry lost;
    lost.id = id;
    lost.name = name.toStdString();
    lost.path = path.toStdString();
    lost.clipNames = {"idle"};
    scene.templates.push_back(lost);
}

void writeTo(const QString& path, const QByteArray& bytes)
{
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(bytes);
}

/// Hands the text of a message box on, and closes it.
std::function<void(QDialog&)> reading(QString& text)
{
    return [&text](QDialog& dialog) {
        if (auto* box = qobject_cast<QMessageBox*>(&dialog)) {
            text = box->text();
        }
        dialog.accept();
    };
}

/// Makes this process's autosave of a document another one's; its new path.
QString keepAs(const QString& path, qint64 process)
{
    QFile stat(QStringLiteral("/proc/%1/stat").arg(process));
    if (!stat.open(QIODevice::ReadOnly)) {
        return {};
    }
    const QByteArray text = stat.readAll();
    const QString start = QString::fromLatin1(
        text.mid(text.lastIndexOf(')') + 2).split(' ').value(19)); // since the machine's start
    const QString own = model::autosavePath(path);
    const QString kept =
        QString(own).replace(QRegularExpression(QStringLiteral("\\.[0-9]+-[0-9]+\\.autosave$")),
                             QStringLiteral(".%1-%2.autosave").arg(process).arg(start));
    return QFile::rename(own, kept) ? kept : QString();
}

} // namespace

/// Scene files in the editor's real window: new, open, save, recovery after a crash, missing
/// assets, several files at once.
class SceneFilesTest : public QObject, private SceneWindow
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { prepare("SceneFilesTest"); }
    void init() { begin(); }
    void cleanup();

    void savesAndReopensIdentically();
    void asksBeforeClosing();
    void unreadableFileLeavesTheSceneAlone();
    void whatIsWrongIsSaidInTheLanguageOfTheWindow();
    void missingAssetsAreNamed();
    void locatesMissingAssetsAndTheirNeighbours();
    void saysWhyALocatedFileWillNotDo();
    void offersRecoveryAfterACrash();
    void declinedRecoveryIsGone();
    void autosavesOnItsTimer();
    void keepsNothingOfAnUnchangedScene();
    void discardedChangesAreNotOfferedAgain();
    void recoversASceneNeverSaved();
    void throwsAwayASceneNeverSaved();
    void offersARecentSceneAtStart();
    void leavesARecentSceneToItsEditor();
    void asksBeforeReplacingWhatAnotherWrote();
    void savesUnderANameWithItsSuffix_data();
    void savesUnderANameWithItsSuffix();
    void nothingHappensInTheMiddleOfAStroke();
    void opensASceneAndModelsAtStart();
    void startsModelsOnEmptyGround();
    void newScenesAreEmpty();
    void recentFilesComeNewestFirst();
    void recentFileThatIsGoneLeavesTheList();
};

void SceneFilesTest::cleanup()
{
    m_window.reset();
    QDir(QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation))
        .removeRecursively();
}

void SceneFilesTest::savesAndReopensIdentically()
{
    openScene(plainScene(40), QStringLiteral("a.crowd"));
    moveEverybody(document(), 7.25F);
    QVERIFY(m_window->files().save());
    QVERIFY(!document().isModified());
    QFile file(pathOf(QStringLiteral("a.crowd")));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray saved = file.readAll();
    const model::Population before = document().scene().population;
    QSignalSpy opened(&m_window->files(), &app::FileController::sceneOpened);
    m_window->files().openPath(pathOf(QStringLiteral("a.crowd")));
    QTRY_COMPARE_WITH_TIMEOUT(opened.count(), 1, kPatienceMs);
    QVERIFY(document().scene().population == before);
    QVERIFY(m_window->files().save());
    file.close();
    QVERIFY(file.open(QIODevice::ReadOnly));
    QCOMPARE(file.readAll(), saved);
}

void SceneFilesTest::asksBeforeClosing()
{
    openScene(plainScene(2), QStringLiteral("a.crowd"));
    moveEverybody(document(), 3.0F);
    {
        const DialogAnswer cancel(pressing(QMessageBox::Cancel));
        QVERIFY(!m_window->close());
        QVERIFY(cancel.hasAnswered());
        QVERIFY(m_window->isVisible());
    }
    {
        const DialogAnswer save(pressing(QMessageBox::Save));
        QVERIFY(m_window->close());
        QVERIFY(save.hasAnswered());
    }
    const auto saved = model::readProject(pathOf(QStringLiteral("a.crowd")));
    QVERIFY(saved.isOk());
    QCOMPARE(saved.value().population.column(model::columns::position)[0].x, 3.0F);
}

void SceneFilesTest::unreadableFileLeavesTheSceneAlone()
{
    openScene(plainScene(6), QStringLiteral("a.crowd"));
    const QString broken = pathOf(QStringLiteral("broken.crowd"));
    writeTo(broken, "not a scene");
    QString message;
    const DialogAnswer answer(reading(message));
    m_window->files().openPath(broken);
    QTRY_VERIFY_WITH_TIMEOUT(answer.hasAnswered(), kPatienceMs);
    QVERIFY2(message.contains(QStringLiteral("broken.crowd")), qPrintable(message));
    QCOMPARE(document().scene().population.size(), std::size_t{6});
    QCOMPARE(QFileInfo(document().path()).fileName(), QStringLiteral("a.crowd"));
}

void SceneFilesTest::whatIsWrongIsSaidInTheLanguageOfTheWindow()
{
    openScene(plainScene(1), QStringLiteral("a.crowd"));
    QTranslator german;
    QVERIFY(german.load(QStringLiteral(":/translations/crowdbrush_de.qm")));
    QCoreApplication::installTranslator(&german); // goes when it dies
    const QString scene = pathOf(QStringLiteral("broken.crowd"));
    writeTo(scene, R"({"format": "crowdbrush-scene", "version": 1, )");
    QString ofScene;
    const DialogAnswer readScene(reading(ofScene));
    m_window->files().openPath(scene);
    QTRY_VERIFY_WITH_TIMEOUT(readScene.hasAnswered(), kPatienceMs);
    QVERIFY2(ofScene.startsWith(scene + QStringLiteral(": Die Datei ist beschädigt oder")),
             qPrintable(ofScene));
    QVERIFY2(ofScene.contains(QStringLiteral("sie endet zu früh, bei Zeile 1, Spalte ")),
             qPrintable(ofScene));
    const QString model = pathOf(QStringLiteral("broken.glb"));
    writeTo(model, "no model");
    QString ofModel;
    const DialogAnswer readModel(reading(ofModel));
    m_window->assets().locateAt({false, 1, "man", "", {}}, model);
    QTRY_VERIFY_WITH_TIMEOUT(readModel.hasAnswered(), kPatienceMs);
    QVERIFY2(ofModel.startsWith(QStringLiteral("broken.glb: das ist weder eine .glb")),
             qPrintable(ofModel));
}

void SceneFilesTest::missingAssetsAreNamed()
{
    model::Scene scene = plainScene(3);
    scene.templates.clear(); // the people there are dragons
    addMissing(scene, 1, QStringLiteral("dragon"), pathOf(QStringLiteral("dragon.glb")));
    QStringList named;
    const DialogAnswer answer([&named](QDialog& dialog) {
        for (const auto* list : dialog.findChildren<QTreeWidget*>()) {
            for (int row = 0; row < list->topLevelItemCount(); ++row) {
                named << list->topLevelItem(row)->text(0) << list->topLevelItem(row)->text(2);
            }
        }
        dialog.reject();
    });
    openScene(scene, QStringLiteral("a.crowd"));
    QTRY_VERIFY_WITH_TIMEOUT(answer.hasAnswered(), kPatienceMs);
    QCOMPARE(named, QStringList({QStringLiteral("dragon"), pathOf(QStringLiteral("dragon.glb"))}));
    QFile before(document().path());
    QVERIFY(before.open(QIODevice::ReadOnly));
    const QByteArray text = before.readAll();
    QVERIFY(m_window->files().save());
    QFile after(document().path());
    QVERIFY(after.open(QIODevice::ReadOnly));
    QCOMPARE(after.readAll(), text);
}

void SceneFilesTest::locatesMissingAssetsAndTheirNeighbours()
{
    model::Scene scene = plainScene(3);
    addMissing(scene, 2, QStringLiteral("one"), pathOf(QStringLiteral("old/one.glb")));
    addMissing(scene, 3, QStringLiteral("two"), pathOf(QStringLiteral("old/two.glb")));
    addMissing(scene, 4, QStringLiteral("lost"), pathOf(QStringLiteral("old/lost.glb")));
    model::StageEntry hall;
    hall.id = 1;
    hall.name = "hall";
    hall.path = pathOf(QStringLiteral("old/stages/hall.glb")).toStdString();
    scene.stages.push_back(hall);
    const QString man = QStringLiteral(CROWD_RESOURCES "/templates/man.glb");
    QVERIFY(QDir(m_folder->path()).mkpath(QStringLiteral("new/stages")));
    QVERIFY(QFile::copy(man, pathOf(QStringLiteral("new/one.glb"))));
    QVERIFY(QFile::copy(man, pathOf(QStringLiteral("new/two.glb"))));
    QVERIFY(QFile::copy(QStringLiteral(CROWD_RESOURCES "/stages/theatre.glb"),
                        pathOf(QStringLiteral("new/stages/hall.glb"))));
    openScene(scene, QStringLiteral("a.crowd"));
    QTRY_VERIFY_WITH_TIMEOUT(openDialog() != nullptr, kPatienceMs);
    QPointer<QDialog> dialog = openDialog();
    QCOMPARE(dialog->objectName(), QStringLiteral("missingAssets"));
    auto* list = dialog->findChild<QTreeWidget*>();
    QCOMPARE(list->topLevelItemCount(), 4);
    list->setCurrentItem(list->findItems(QStringLiteral("one"), Qt::MatchExactly).front());
    const DialogAnswer choose(choosing(pathOf(QStringLiteral("new/one.glb"))));
    dialog->findChild<QPushButton*>(QStringLiteral("locate"))->click();
    QTRY_COMPARE_WITH_TIMEOUT(list->topLevelItemCount(), 1, kPatienceMs);
    QVERIFY(choose.hasAnswered());
    QCOMPARE(list->topLevelItem(0)->text(0), QStringLiteral("lost"));
    QVERIFY(document().scene().findTemplate(2)->asset != nullptr);
    QVERIFY(document().scene().findTemplate(3)->asset != nullptr);
    QVERIFY(document().scene().findStage(1)->asset != nullptr);
    QCOMPARE(document().undoStack().count(), 1);
    QCOMPARE(document().scene().findTemplate(3)->path,
             pathOf(QStringLiteral("new/two.glb")).toStdString());
    QVERIFY(QFile::copy(man, pathOf(QStringLiteral("new/lost.glb"))));
    m_window->assets().locateAt(model::missingAssets(document().scene()).front(),
                                pathOf(QStringLiteral("new/lost.glb")));
    QTRY_VERIFY_WITH_TIMEOUT(dialog.isNull() || !dialog->isVisible(), kPatienceMs);
    QVERIFY(m_window->files().save());
    QVERIFY(model::loadScene(document().path()).value().findTemplate(4)->asset != nullptr);
}

void SceneFilesTest::saysWhyALocatedFileWillNotDo()
{
    model::Scene scene = plainScene(1);
    addMissing(scene, 2, QStringLiteral("one"), pathOf(QStringLiteral("old/one.glb")));
    openScene(scene, QStringLiteral("a.crowd"));
    QTRY_VERIFY_WITH_TIMEOUT(openDialog() != nullptr, kPatienceMs);
    openDialog()->reject();
    QString message;
    const DialogAnswer answer(reading(message));
    m_window->assets().locateAt(model::missingAssets(document().scene()).front(),
                                document().path());
    QTRY_VERIFY_WITH_TIMEOUT(answer.hasAnswered(), kPatienceMs);
    QVERIFY2(message.contains(QStringLiteral("a.crowd")), qPrintable(message));
    QVERIFY(!document().isModified());
}

void SceneFilesTest::offersRecoveryAfterACrash()
{
    const QString path = pathOf(QStringLiteral("a.crowd"));
    QVERIFY(model::saveProject(plainScene(2), path).isOk());
    QVERIFY(model::writeAutosave(plainScene(9), path).isOk());
    QVERIFY(!leaveBehind(path).isEmpty());
    const DialogAnswer yes(pressing(QMessageBox::Yes));
    QSignalSpy opened(&m_window->files(), &app::FileController::sceneOpened);
    m_window->files().openPath(path);
    QTRY_COMPARE_WITH_TIMEOUT(opened.count(), 1, kPatienceMs);
    QVERIFY(yes.hasAnswered());
    QCOMPARE(document().scene().population.size(), std::size_t{9});
    QCOMPARE(document().path(), path);
    QVERIFY2(document().isModified(), "what was recovered is not what the file holds");
    QVERIFY(m_window->files().save());
    QVERIFY(model::findRecovery(path).isEmpty());
    QCOMPARE(model::readProject(path).value().population.size(), std::size_t{9});
}

void SceneFilesTest::declinedRecoveryIsGone()
{
    const QString path = pathOf(QStringLiteral("a.crowd"));
    QVERIFY(model::saveProject(plainScene(2), path).isOk());
    QVERIFY(model::writeAutosave(plainScene(9), path).isOk());
    QVERIFY(!leaveBehind(path).isEmpty());
    const DialogAnswer no(pressing(QMessageBox::No));
    QSignalSpy opened(&m_window->files(), &app::FileController::sceneOpened);
    m_window->files().openPath(path);
    QTRY_COMPARE_WITH_TIMEOUT(opened.count(), 1, kPatienceMs);
    QVERIFY(no.hasAnswered());
    QCOMPARE(document().scene().population.size(), std::size_t{2});
    QVERIFY(model::findRecovery(path).isEmpty());
}

void SceneFilesTest::autosavesOnItsTimer()
{
    openScene(plainScene(2), QStringLiteral("a.crowd"));
    const QString path = document().path();
    m_window->files().setAutosaveSeconds(1);
    moveEverybody(document(), 5.0F);
    const QString kept = model::autosavePath(path);
    QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(kept), 5000);
    QVERIFY(document().isModified());
    QCOMPARE(model::readProject(kept).value().population.column(model::columns::position)[0].x,
             5.0F);
    QVERIFY(m_window->files().save());
    QVERIFY2(!QFile::exists(kept), "a clean save leaves nothing to recover");
}

void SceneFilesTest::keepsNothingOfAnUnchangedScene()
{
    openScene(plainScene(2), QStringLiteral("a.crowd"));
    const QString kept = model::autosavePath(document().path());
    m_window->files().setAutosaveSeconds(1);
    QTest::qWait(1500);
    QVERIFY(!QFile::exists(kept));
    moveEverybody(document(), 5.0F);
    QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(kept), 5000);
    const QDateTime written = QFileInfo(kept).lastModified();
    QTest::qWait(1500);
    QCOMPARE(QFileInfo(kept).lastModified(), written); // not again and again
    document().undoStack().undo();
    QTRY_VERIFY_WITH_TIMEOUT(!QFile::exists(kept), 5000);
}

void SceneFilesTest::discardedChangesAreNotOfferedAgain()
{
    openScene(plainScene(2), QStringLiteral("a.crowd"));
    m_window->files().setAutosaveSeconds(1);
    moveEverybody(document(), 5.0F);
    const QString kept = model::autosavePath(document().path());
    QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(kept), 5000);
    const DialogAnswer discard(pressing(QMessageBox::Discard));
    QSignalSpy opened(&m_window->files(), &app::FileController::sceneOpened);
    m_window->files().openPath(document().path());
    QTRY_COMPARE_WITH_TIMEOUT(opened.count(), 1, kPatienceMs);
    QVERIFY(!QFile::exists(kept));
    QCOMPARE(document().scene().population.column(model::columns::position)[0].x, 0.0F);
}

void SceneFilesTest::recoversASceneNeverSaved()
{
    QVERIFY(model::writeAutosave(plainScene(4), {}).isOk());
    QVERIFY(!leaveBehind({}).isEmpty());
    QString told;
    const DialogAnswer yes([&told](QDialog& dialog) {
        const auto& box = dynamic_cast<QMessageBox&>(dialog);
        told = box.informativeText();
        box.button(QMessageBox::Yes)->click();
    });
    QSignalSpy opened(&m_window->files(), &app::FileController::sceneOpened);
    QVERIFY(m_window->files().offerUntitledRecovery());
    QVERIFY2(told.contains(QStringLiteral("4 character")), qPrintable(told));
    QTRY_COMPARE_WITH_TIMEOUT(opened.count(), 1, kPatienceMs);
    QCOMPARE(document().scene().population.size(), std::size_t{4});
    QVERIFY(document().path().isEmpty());
    QVERIFY(document().isModified());
    QVERIFY(model::findUntitledRecoveries().isEmpty());
    QVERIFY2(QFile::exists(model::autosavePath({})), "it is kept until it is saved");
    const DialogAnswer name(choosing(pathOf(QStringLiteral("named"))));
    QVERIFY(m_window->files().save());
    QVERIFY(!QFile::exists(model::autosavePath({})));
    QCOMPARE(document().path(), pathOf(QStringLiteral("named.crowd")));
}

void SceneFilesTest::throwsAwayASceneNeverSaved()
{
    QVERIFY(model::writeAutosave(plainScene(4), {}).isOk());
    const QString left = leaveBehind({});
    {
        const DialogAnswer closed([](QDialog& dialog) { dialog.close(); });
        QVERIFY(!m_window->files().offerUntitledRecovery());
        QVERIFY2(QFile::exists(left), "closing the question decides nothing");
    }
    const DialogAnswer no(pressing(QMessageBox::No));
    QVERIFY(!m_window->files().offerUntitledRecovery());
    QVERIFY(!QFile::exists(left));
}

void SceneFilesTest::offersARecentSceneAtStart()
{
    openScene(plainScene(2), QStringLiteral("a.crowd"));
    const QString path = document().path();
    QVERIFY(model::writeAutosave(plainScene(9), path).isOk());
    const QString left = leaveBehind(path);
    m_window.reset();
    openWindow();
    {
        const DialogAnswer closed([](QDialog& dialog) { dialog.close(); });
        QVERIFY(!m_window->files().offerRecovery());
        QVERIFY(closed.hasAnswered());
        QVERIFY2(QFile::exists(left), "closing the question decides nothing");
    }
    const DialogAnswer yes(pressing(QMessageBox::Yes));
    QSignalSpy opened(&m_window->files(), &app::FileController::sceneOpened);
    m_window->start({});
    QTRY_COMPARE_WITH_TIMEOUT(opened.count(), 1, kPatienceMs);
    QVERIFY(yes.hasAnswered());
    QCOMPARE(document().path(), path);
    QCOMPARE(document().scene().population.size(), std::size_t{9});
    QVERIFY(document().isModified());
}

void SceneFilesTest::leavesARecentSceneToItsEditor()
{
    openScene(plainScene(2), QStringLiteral("a.crowd"));
    const QString path = document().path();
    QVERIFY(model::writeAutosave(plainScene(9), path).isOk());
    QVERIFY(!leaveBehind(path).isEmpty());
    QVERIFY(model::writeAutosave(plainScene(7), path).isOk());
    QProcess other; // stands for another editor, with unsaved changes of the scene
    other.start(QStringLiteral("sleep"), {QStringLiteral("60")});
    QVERIFY(other.waitForStarted());
    const QString kept = keepAs(path, other.processId());
    QVERIFY(!kept.isEmpty());
    m_window.reset();
    openWindow();
    QVERIFY(!m_window->files().offerRecovery());
    other.kill();
    other.waitForFinished();
    const DialogAnswer closed([](QDialog& dialog) { dialog.close(); });
    QVERIFY(!m_window->files().offerRecovery());
    QVERIFY2(closed.hasAnswered(), "with that editor gone it is asked");
}

void SceneFilesTest::asksBeforeReplacingWhatAnotherWrote()
{
    openScene(plainScene(2), QStringLiteral("a.crowd"));
    moveEverybody(document(), 3.0F);
    QVERIFY(model::saveProject(plainScene(17), document().path()).isOk());
    {
        const DialogAnswer cancel(pressing(QMessageBox::Cancel));
        QVERIFY(!m_window->files().save());
        QVERIFY(cancel.hasAnswered());
        QVERIFY(document().isModified());
        QCOMPARE(model::readProject(document().path()).value().population.size(), std::size_t{17});
    }
    const DialogAnswer replace(pressing(QMessageBox::Save));
    QVERIFY(m_window->files().save());
    QCOMPARE(model::readProject(document().path()).value().population.size(), std::size_t{2});
    moveEverybody(document(), 4.0F);
    QVERIFY(m_window->files().save()); // no question: nobody else wrote
}

void SceneFilesTest::savesUnderANameWithItsSuffix_data()
{
    QTest::addColumn<QString>("typed");
    QTest::addColumn<QString>("written");
    QTest::newRow("without a suffix") << QStringLiteral("party") << QStringLiteral("party.crowd");
    QTest::newRow("with it") << QStringLiteral("party.crowd") << QStringLiteral("party.crowd");
    QTest::newRow("in capitals") << QStringLiteral("party.CROWD") << QStringLiteral("party.CROWD");
    QTest::newRow("with a dot") << QStringLiteral("party.v2") << QStringLiteral("party.v2.crowd");
    QTest::newRow("with quotes") << QStringLiteral("Stadt ä'q \"x\".crowd")
                                 << QStringLiteral("Stadt ä'q \"x\".crowd");
    QTest::newRow("not ASCII") << QStringLiteral("Straßenfest 狐")
                               << QStringLiteral("Straßenfest 狐.crowd");
}

void SceneFilesTest::savesUnderANameWithItsSuffix()
{
    QFETCH(QString, typed);
    QFETCH(QString, written);
    openScene(plainScene(3), QStringLiteral("a.crowd"));
    const DialogAnswer name(choosing(pathOf(typed)));
    QVERIFY(m_window->files().saveAs());
    QVERIFY(name.hasAnswered());
    QCOMPARE(document().path(), pathOf(written));
    QVERIFY(model::readProject(pathOf(written)).isOk());
}

void SceneFilesTest::nothingHappensInTheMiddleOfAStroke()
{
    openScene(plainScene(3), QStringLiteral("a.crowd"));
    moveEverybody(document(), 2.0F);
    auto edit = document().beginEdit().value();
    edit->removeIndividuals(std::vector<model::IndividualId>{1});
    for (const char* id :
         {"new-theatre", "new-ground", "open", "save", "save-as", "collect", "undo", "redo"}) {
        m_window->actions().action(id)->trigger();
        QVERIFY2(!m_window->files().isBusy() && openDialog() == nullptr, id);
    }
    QCOMPARE(document().scene().population.size(), std::size_t{2});
    edit.reset();
    QCOMPARE(document().scene().population.size(), std::size_t{3});
    document().undoStack().undo();
    QCOMPARE(document().scene().population.column(model::columns::position)[0].x, 0.0F);
}

void SceneFilesTest::opensASceneAndModelsAtStart()
{
    QVERIFY(model::saveProject(plainScene(2), pathOf(QStringLiteral("a.crowd"))).isOk());
    for (const char* name : {"first", "second"}) {
        QVERIFY(QFile::copy(QStringLiteral(CROWD_RESOURCES "/templates/man.glb"),
                            pathOf(QString::fromLatin1(name) + QStringLiteral(".glb"))));
    }
    QSignalSpy added(&m_window->assets(), &app::AssetController::templateAdded);
    m_window->queue().openAtStart({pathOf(QStringLiteral("first.glb")),
                                   pathOf(QStringLiteral("a.crowd")),
                                   pathOf(QStringLiteral("second.glb"))});
    for (int i = 0; i < 2; ++i) {
        const DialogAnswer accept([](QDialog& dialog) { dialog.accept(); });
        QTRY_COMPARE_WITH_TIMEOUT(added.count(), i + 1, kPatienceMs);
    }
    QCOMPARE(QFileInfo(document().path()).fileName(), QStringLiteral("a.crowd"));
    QCOMPARE(document().scene().population.size(), std::size_t{2});
    QCOMPARE(document().scene().templates.size(), std::size_t{3});
    QCOMPARE(document().scene().templates[1].name, std::string("first"));
    QCOMPARE(document().scene().templates[2].name, std::string("second"));
}

void SceneFilesTest::startsModelsOnEmptyGround()
{
    const QString model = QStringLiteral(CROWD_RESOURCES "/templates/woman.glb");
    QSignalSpy added(&m_window->assets(), &app::AssetController::templateAdded);
    const DialogAnswer accept([](QDialog& dialog) { dialog.accept(); });
    m_window->queue().openAtStart({model});
    QTRY_COMPARE_WITH_TIMEOUT(added.count(), 1, kPatienceMs);
    QVERIFY(document().path().isEmpty());
    QVERIFY(document().scene().stages.empty());
    QCOMPARE(document().scene().templates.size(), std::size_t{9}); // beside the eight of the cast
}

void SceneFilesTest::newScenesAreEmpty()
{
    QSignalSpy opened(&m_window->files(), &app::FileController::sceneOpened);
    m_window->actions().action("new-theatre")->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(opened.count(), 1, kPatienceMs);
    QVERIFY(document().scene().population.isEmpty());
    QVERIFY(document().scene().worldSeats().size() > 500);
    QCOMPARE(document().scene().templates.size(), std::size_t{5}); // who goes to that theatre
    QCOMPARE(document().scene().templates.front().name, std::string("patrician"));
    QVERIFY(!document().isModified() && document().path().isEmpty());
    m_window->actions().action("new-ground")->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(opened.count(), 2, kPatienceMs);
    QVERIFY(document().scene().stages.empty());
    QVERIFY(document().scene().templates.front().asset != nullptr);
    QVERIFY(!document().isModified());
}

void SceneFilesTest::recentFilesComeNewestFirst()
{
    openScene(plainScene(1), QStringLiteral("a.crowd"));
    openScene(plainScene(1), QStringLiteral("b.crowd"));
    openScene(plainScene(1), QStringLiteral("a.crowd"));
    const QStringList recent = app::recentFiles();
    QCOMPARE(recent.size(), 2);
    QCOMPARE(QFileInfo(recent[0]).fileName(), QStringLiteral("a.crowd"));
    for (int i = 0; i < 20; ++i) {
        app::addRecentFile(pathOf(QString::number(i)));
    }
    QCOMPARE(app::recentFiles().size(), qsizetype{app::kMaxRecentFiles});
    app::clearRecentFiles();
    QVERIFY(app::recentFiles().isEmpty());
}

void SceneFilesTest::recentFileThatIsGoneLeavesTheList()
{
    openScene(plainScene(1), QStringLiteral("a.crowd"));
    app::addRecentFile(pathOf(QStringLiteral("gone.crowd")));
    QString message;
    const DialogAnswer answer([&message](QDialog& dialog) {
        if (auto* box = qobject_cast<QMessageBox*>(&dialog)) {
            message = box->text();
        }
        dialog.accept();
    });
    m_window->files().openPath(pathOf(QStringLiteral("gone.crowd")));
    QVERIFY(answer.hasAnswered());
    QVERIFY2(message.contains(QStringLiteral("gone.crowd")), qPrintable(message));
    QCOMPARE(app::recentFiles(), QStringList{pathOf(QStringLiteral("a.crowd"))});
    QCOMPARE(document().scene().population.size(), std::size_t{1});
}

CROWD_WINDOW_TEST(SceneFilesTest)

#include "tst_SceneFiles.moc"
