// SPDX-License-Identifier: MIT
#include <memory>

#include <QtCore/QFile>
#include <QtCore/QFileInfo>
#include <QtCore/QMimeData>
#include <QtGui/QDropEvent>
#include <QtTest/QSignalSpy>
#include <QtTest/QTest>
#include <QtWidgets/QApplication>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QDoubleSpinBox>
#include <QtWidgets/QListWidget>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QTableWidget>

#include "app/window/AssetController.h"
#include "app/window/FileQueue.h"
#include "app/window/MainWindow.h"
#include "model/project/ProjectFile.h"
#include "tests/app/SceneWindow.h"
#include "tests/program/WindowTest.h"

using namespace crowd;
using namespace crowd::testing;

/// Models that come into the real window: dropped, imported, out of the library; and their clips.
class ImportedFilesTest : public QObject, private SceneWindow
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { prepare("ImportedFilesTest"); }
    void init() { begin(); }
    void cleanup() { m_window.reset(); }

    void droppedModelBecomesATemplate();
    void severalDroppedFilesComeOneAfterTheOther();
    void severalImportedFilesAreOneMix();
    void severalDroppedFilesNeedOneAnswer();
    void changedClipsAreOneUndoStep();
    void libraryAddsWhomTheArtistChooses();
    void unsupportedFileIsRefusedAtOnce();

private:
    /// Templates that the create brush paints.
    [[nodiscard]] std::size_t mixSize() const
    {
        return m_window->state()
            .brush(model::BrushKind::Create)
            .as<model::CreateSettings>()
            .mix.size();
    }
};

void ImportedFilesTest::droppedModelBecomesATemplate()
{
    const QString man = QStringLiteral(CROWD_RESOURCES "/templates/man.glb");
    QVERIFY2(QFileInfo::exists(man), qPrintable(man));
    openScene(plainScene(0), QStringLiteral("a.crowd"));
    QSignalSpy added(&m_window->assets(), &app::AssetController::templateAdded);
    QMimeData files;
    files.setUrls({QUrl::fromLocalFile(man)});
    const DialogAnswer asTemplate(pressing(QStringLiteral("Template")));
    QDragEnterEvent enter({200, 200}, Qt::CopyAction, &files, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(m_window.get(), &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent drop({200, 200}, Qt::CopyAction, &files, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(m_window.get(), &drop);
    QTRY_VERIFY_WITH_TIMEOUT(asTemplate.hasAnswered(), kPatienceMs);
    const DialogAnswer accept([](QDialog& dialog) { dialog.accept(); });
    QTRY_COMPARE_WITH_TIMEOUT(added.count(), 1, kPatienceMs);
    QVERIFY(accept.hasAnswered());
    QCOMPARE(document().scene().templates.size(), std::size_t{2});
    QVERIFY(document().scene().templates[1].asset != nullptr);
    QVERIFY(document().isModified());
    document().undoStack().undo();
    QCOMPARE(document().scene().templates.size(), std::size_t{1});
}

void ImportedFilesTest::severalDroppedFilesComeOneAfterTheOther()
{
    const QString scene = pathOf(QStringLiteral("a.crowd"));
    QVERIFY(model::saveProject(plainScene(4), scene).isOk());
    QSignalSpy added(&m_window->assets(), &app::AssetController::templateAdded);
    QSignalSpy stages(&m_window->assets(), &app::AssetController::stageAdded);
    QTimer accepting;
    connect(&accepting, &QTimer::timeout, &accepting, [] {
        if (QDialog* dialog = openDialog()) {
            dialog->accept();
        }
    });
    accepting.start(50);
    m_window->queue().openAtStart({QStringLiteral(CROWD_RESOURCES "/templates/woman.glb"), scene,
                                   QStringLiteral(CROWD_RESOURCES "/stages/theatre.glb")});
    QTRY_COMPARE_WITH_TIMEOUT(stages.count(), 1, 3 * kPatienceMs);
    QCOMPARE(document().scene().population.size(), std::size_t{4});
    QCOMPARE(added.count(), 1);
    QCOMPARE(stages.count(), 1);
    QCOMPARE(document().scene().templates.size(), std::size_t{2});
    QCOMPARE(document().scene().stages.size(), std::size_t{1});
}

void ImportedFilesTest::severalImportedFilesAreOneMix()
{
    openScene(plainScene(4), QStringLiteral("a.crowd"));
    QSignalSpy added(&m_window->assets(), &app::AssetController::templateAdded);
    int dialogs = 0;
    QTimer answering;
    connect(&answering, &QTimer::timeout, &answering, [&dialogs] {
        if (QDialog* dialog = openDialog()) {
            ++dialogs;
            dialogs == 2 ? dialog->reject() : dialog->accept(); // one of them after all not
        }
    });
    answering.start(50);
    m_window->assets().importTemplates({QStringLiteral(CROWD_RESOURCES "/templates/woman.glb"),
                                        QStringLiteral(CROWD_RESOURCES "/templates/beetle.glb"),
                                        QStringLiteral(CROWD_RESOURCES "/templates/dog.glb")});
    QTRY_COMPARE_WITH_TIMEOUT(added.count(), 2, 3 * kPatienceMs);
    QTRY_VERIFY(!m_window->assets().isBusy());
    QCOMPARE(dialogs, 3);
    QCOMPARE(document().scene().templates.size(), std::size_t{3});
    QCOMPARE(mixSize(), std::size_t{2});
}

void ImportedFilesTest::severalDroppedFilesNeedOneAnswer()
{
    openScene(plainScene(4), QStringLiteral("a.crowd"));
    QSignalSpy added(&m_window->assets(), &app::AssetController::templateAdded);
    QStringList titles;
    QTimer answering;
    connect(&answering, &QTimer::timeout, &answering, [&titles] {
        QDialog* dialog = openDialog();
        if (dialog == nullptr) {
            return;
        }
        titles << dialog->windowTitle();
        if (auto* box = qobject_cast<QMessageBox*>(dialog)) {
            box->checkBox()->setChecked(true);
            pressing(QStringLiteral("Template"))(*box);
        } else {
            dialog->findChild<QPushButton*>(QStringLiteral("importAll"))->click();
        }
    });
    answering.start(50);
    m_window->queue().drop({QStringLiteral(CROWD_RESOURCES "/templates/woman.glb"),
                            QStringLiteral(CROWD_RESOURCES "/templates/beetle.glb"),
                            QStringLiteral(CROWD_RESOURCES "/templates/dog.glb")});
    QTRY_COMPARE_WITH_TIMEOUT(added.count(), 3, 3 * kPatienceMs);
    QCOMPARE(titles, (QStringList{QStringLiteral("Import woman.glb (1 of 3)"),
                                  QStringLiteral("Import woman.glb (1 of 3)")}));
    QCOMPARE(document().scene().templates.size(), std::size_t{4});
    answering.stop();
    // Those that come later are asked about again.
    const DialogAnswer answer([](QDialog& dialog) { dialog.reject(); });
    m_window->queue().drop({QStringLiteral(CROWD_RESOURCES "/templates/horse.glb")});
    QTRY_VERIFY(answer.hasAnswered());
    QCOMPARE(answer.title(), QStringLiteral("Import horse.glb"));
}

void ImportedFilesTest::changedClipsAreOneUndoStep()
{
    openScene(plainScene(4), QStringLiteral("a.crowd"));
    const auto entry = [this]() -> const model::TemplateEntry& {
        return document().scene().templates.front();
    };
    const auto roleOf = [&entry](std::size_t clip) {
        const auto& chosen = entry().clipRoles;
        return clip < chosen.size() && chosen[clip] ? *chosen[clip]
                                                    : entry().asset->clips[clip].role;
    };
    const auto lastClip = entry().asset->clips.size() - 1;
    const model::ClipRole before = roleOf(lastClip);
    const auto chosen =
        before == model::ClipRole::Fly ? model::ClipRole::Run : model::ClipRole::Fly;
    const DialogAnswer answer([&](QDialog& dialog) {
        auto* clips = dialog.findChild<QTableWidget*>();
        const int row = static_cast<int>(lastClip);
        auto* role = qobject_cast<QComboBox*>(clips->cellWidget(row, 3));
        role->setCurrentIndex(role->findData(static_cast<int>(chosen)));
        qobject_cast<QDoubleSpinBox*>(clips->cellWidget(row, 2))->setValue(2.5);
        dialog.accept();
    });
    QUndoStack& history = document().undoStack();
    const int steps = history.count();
    m_window->assets().editClips(entry().id);
    QTRY_VERIFY_WITH_TIMEOUT(answer.hasAnswered() && history.count() > steps, 3 * kPatienceMs);
    QCOMPARE(history.count(), steps + 1);
    QCOMPARE(roleOf(lastClip), chosen);
    QCOMPARE(entry().asset->clips[lastClip].speed, 2.5F);
    history.undo();
    QCOMPARE(roleOf(lastClip), before);
    QVERIFY(entry().clipRoles.empty());
    QVERIFY(entry().clipSpeeds.empty());
    QVERIFY(!document().isModified());
    history.redo();
    QCOMPARE(roleOf(lastClip), chosen);
    QCOMPARE(document().scene().population.size(), std::size_t{4});
    // What was chosen is there again, and going back to what the file says is a choice too.
    const DialogAnswer back([&](QDialog& dialog) {
        auto* clips = dialog.findChild<QTableWidget*>();
        auto* role = qobject_cast<QComboBox*>(clips->cellWidget(static_cast<int>(lastClip), 3));
        QCOMPARE(role->currentData().toInt(), static_cast<int>(chosen));
        role->setCurrentIndex(role->findData(static_cast<int>(before)));
        dialog.accept();
    });
    m_window->assets().editClips(entry().id);
    QTRY_VERIFY_WITH_TIMEOUT(back.hasAnswered() && history.count() > steps + 1, 3 * kPatienceMs);
    QCOMPARE(roleOf(lastClip), before);
    QCOMPARE(entry().asset->clips[lastClip].speed, 2.5F);
    history.undo();
    QCOMPARE(roleOf(lastClip), chosen);
    document().undoStack().setClean(); // nothing to ask about
}

void ImportedFilesTest::libraryAddsWhomTheArtistChooses()
{
    openScene(plainScene(4), QStringLiteral("a.crowd"));
    QSignalSpy added(&m_window->assets(), &app::AssetController::templateAdded);
    QStringList offered;
    bool isManChoosable = true;
    const DialogAnswer answer([&](QDialog& dialog) {
        auto* list = dialog.findChild<QListWidget*>();
        for (int row = 0; list != nullptr && row < list->count(); ++row) {
            QListWidgetItem* item = list->item(row);
            offered << item->text();
            if (item->text() == QLatin1String("man")) {
                isManChoosable = item->flags().testFlag(Qt::ItemIsSelectable);
            }
            item->setSelected(item->text() == QLatin1String("priest") ||
                              item->text() == QLatin1String("old woman"));
        }
        dialog.accept();
    });
    m_window->actions().action("library")->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(added.count(), 2, 3 * kPatienceMs);
    QVERIFY(answer.hasAnswered());
    QVERIFY(offered.size() > 10);
    QCOMPARE(document().scene().templates.size(), std::size_t{3});
    QCOMPARE(mixSize(), std::size_t{2});
    document().undoStack().undo();
    QCOMPARE(document().scene().templates.size(), std::size_t{1});
}

void ImportedFilesTest::unsupportedFileIsRefusedAtOnce()
{
    openScene(plainScene(0), QStringLiteral("a.crowd"));
    QFile model(pathOf(QStringLiteral("dancer.fbx")));
    QVERIFY(model.open(QIODevice::WriteOnly));
    model.write("Kaydara FBX Binary");
    model.close();
    QString message;
    const DialogAnswer answer([&message](QDialog& dialog) {
        if (auto* box = qobject_cast<QMessageBox*>(&dialog)) {
            message = box->text();
        }
        dialog.accept();
    });
    m_window->queue().drop({model.fileName()});
    QTRY_VERIFY_WITH_TIMEOUT(answer.hasAnswered(), kPatienceMs);
    QVERIFY2(message.contains(QStringLiteral("dancer.fbx")), qPrintable(message));
    QVERIFY2(message.contains(QStringLiteral("glTF")), qPrintable(message));
    QCOMPARE(document().scene().templates.size(), std::size_t{1});
}

CROWD_WINDOW_TEST(ImportedFilesTest)

#include "tst_ImportedFiles.moc"
