// SPDX-License-Identifier: MIT
#include <set>

#include <QtCore/QSettings>
#include <QtCore/QTemporaryDir>
#include <QtCore/QTimer>
#include <QtGui/QImage>
#include <QtTest/QTest>
#include <QtWidgets/QAbstractButton>
#include <QtWidgets/QAbstractItemView>
#include <QtWidgets/QApplication>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QInputDialog>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QListWidget>
#include <QtWidgets/QMenu>
#include <QtWidgets/QToolButton>

#include "model/brush/FeatureBrush.h"
#include "model/document/SceneEdit.h"
#include "model/features/FeatureWriting.h"
#include "model/project/FeatureFile.h"
#include "tests/program/WindowTest.h"
#include "tests/widgets/Desk.h"
#include "widgets/commands/FeatureCommands.h"
#include "widgets/docks/FeaturePreview.h"
#include "widgets/docks/FeaturesDock.h"
#include "widgets/docks/IndividualDock.h"
#include "widgets/forms/ColourRow.h"
#include "widgets/forms/FieldForm.h"

using namespace crowd;
using namespace crowd::widgets;

namespace {

struct FeaturesDesk : crowd::testing::Desk<FeaturesDock>
{
    FeaturesDesk()
    {
        QObject::connect(&state, &EditorState::statusMessage,
                         [this](const QString& text) { said = text; });
    }
    [[nodiscard]] QListWidget* list()
    {
        return dock->findChild<QListWidget*>(QStringLiteral("features"));
    }
    [[nodiscard]] QComboBox* kinds()
    {
        return dock->findChild<QComboBox*>(QStringLiteral("featureKinds"));
    }
    [[nodiscard]] FieldForm* form()
    {
        for (FieldForm* each : dock->findChildren<FieldForm*>(QStringLiteral("featureForm"))) {
            if (!each->isHidden()) {
                return each;
            }
        }
        return nullptr;
    }
    [[nodiscard]] QAbstractButton* seen(const QString& button)
    {
        QAbstractButton* found = nullptr;
        for (auto* each : dock->findChildren<QAbstractButton*>(button)) {
            found = each->isVisible() ? each : found;
        }
        return found;
    }
    void press(const QString& button)
    {
        QAbstractButton* found = nullptr;
        QTRY_VERIFY2((found = seen(button)) != nullptr, qPrintable(button));
        QVERIFY2(found != nullptr && found->isEnabled(), qPrintable(button));
        found->click();
    }
    [[nodiscard]] QStringList names()
    {
        QStringList all;
        for (int row = 0; row < list()->count(); ++row) {
            all << list()->item(row)->text();
        }
        return all;
    }
    void choose(const char* name)
    {
        list()->setCurrentRow(static_cast<int>(names().indexOf(QLatin1String(name))));
    }
    [[nodiscard]] const model::FeatureValue& value(const char* name)
    {
        for (const model::FeatureKind& kind : document.scene().features) {
            if (const model::FeatureValue* found = kind.find(name)) {
                return *found;
            }
        }
        static const model::FeatureValue kNone;
        return kNone;
    }
    [[nodiscard]] std::set<model::FeatureId> borne(std::uint8_t kind)
    {
        const auto column = document.scene().population.column(model::columns::feature(kind));
        return {column.begin(), column.end()};
    }

    QString said;
};

} // namespace

class TestFeaturesDock : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void showsKindsAndTheirValues();
    void givesAValueToWhoIsSelected();
    void theBrushPaintsTheChosenValue();
    void aKindThatIsBackIsShown();
    void coloursOfAnOutfitAreSeenAndSet();
    void addsDuplicatesRenamesAndRemoves();
    void aKindOfOnesOwn();
    void aNewKindIsAskedForItsName();
    void showsWhatTheBrushPaints();
    void aWordTakenByMouseLeavesTheKeysToTheBrushes();
    void whatIsSetComesToTheSceneAtRest();
    void bearersChangeWhereTicked();
    void listsGrowAndShrink();
    void sixPeopleWearIt();
    void filesAreSharedBetweenScenes();
    void filesThatAreNoneAreRefused_data();
    void filesThatAreNoneAreRefused();
    void anotherSceneInBetween();
    void thePanelOfACharacterHasThem();
};

void TestFeaturesDock::init()
{
    QSettings().clear();
}

void TestFeaturesDock::showsKindsAndTheirValues()
{
    FeaturesDesk desk;
    QVERIFY(desk.isReady());
    QCOMPARE(desk.kinds()->count(), 2);
    QCOMPARE(desk.names().size(), 7);
    QCOMPARE(desk.names().front(), QStringLiteral("neutral"));
    desk.kinds()->setCurrentIndex(1);
    QVERIFY(desk.names().contains(QStringLiteral("team red")));
    QTRY_VERIFY(desk.form() != nullptr);
}

void TestFeaturesDock::givesAValueToWhoIsSelected()
{
    FeaturesDesk desk;
    QVERIFY(desk.isReady());
    desk.choose("sad");
    desk.press(QStringLiteral("giveFeature"));
    QVERIFY2(desk.said.contains(QStringLiteral("Nobody is there")), qPrintable(desk.said));
    const auto ids = crowd::testing::addPeople(desk.document, 4);
    desk.state.selection().set(std::span(ids).first(2));
    desk.press(QStringLiteral("giveFeature"));
    QCOMPARE(model::bearersOf(desk.document.scene(), desk.value("sad").id).size(), std::size_t{2});
    desk.state.selection().set({});
    desk.press(QStringLiteral("selectBearers"));
    QCOMPARE(desk.state.selection().ids().size(), std::size_t{2});
    desk.state.selection().set({}); // all, where nobody is selected
    desk.choose("happy");
    desk.press(QStringLiteral("giveFeature"));
    QCOMPARE(model::bearersOf(desk.document.scene(), desk.value("happy").id).size(),
             std::size_t{4});
    QVERIFY2(desk.said.contains(QStringLiteral("nobody is selected")), qPrintable(desk.said));
    desk.list()->setFocus();
    QTest::keyClick(desk.list(), Qt::Key_Delete);
    QVERIFY2(desk.said.contains(QStringLiteral("4 characters")), qPrintable(desk.said));
}

void TestFeaturesDock::theBrushPaintsTheChosenValue()
{
    FeaturesDesk desk;
    QVERIFY(desk.isReady());
    desk.choose("sad");
    desk.press(QStringLiteral("paintFeature"));
    QCOMPARE(desk.state.tool(), ToolId::BrushFeature);
    const auto* painted = &desk.state.activeBrush()->as<model::FeatureSettings>();
    QCOMPARE(painted->kind, std::string("emotion"));
    QCOMPARE(painted->values.size(), std::size_t{1});
    QCOMPARE(painted->values.front().clip, std::string("sad"));
    desk.choose("angry"); // while the brush is in hand
    QCOMPARE(desk.state.activeBrush()->as<model::FeatureSettings>().values.front().clip,
             std::string("angry"));
    desk.kinds()->setCurrentIndex(1);
    desk.choose("team red");
    desk.press(QStringLiteral("paintFeature"));
    QCOMPARE(desk.state.tool(), ToolId::BrushOutfit);
    QCOMPARE(model::featureSettings(*desk.state.activeBrush())->values.front().clip,
             std::string("team red"));
}

void TestFeaturesDock::coloursOfAnOutfitAreSeenAndSet()
{
    FeaturesDesk desk;
    QVERIFY(desk.isReady());
    desk.kinds()->setCurrentIndex(1);
    desk.choose("team red");
    QTRY_VERIFY(desk.form() != nullptr && desk.form()->findChild<ColourRow*>() != nullptr);
    auto* row = desk.form()->findChild<ColourRow*>();
    const model::FeatureValue before = desk.value("team red");
    QCOMPARE(row->colours(), before.slots.front().colors);
    QVERIFY(!row->colours().empty());
    QTRY_COMPARE(row->findChildren<QToolButton*>(QStringLiteral("colour")).size(),
                 static_cast<qsizetype>(row->colours().size()));
    // Those that the dialog would give.
    const ColourRow::Colours wanted{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}};
    Q_EMIT row->edited(wanted);
    QTRY_COMPARE(desk.value("team red").slots.front().colors, wanted);
    desk.document.undoStack().undo();
    QTRY_COMPARE(desk.value("team red").slots.front().colors, before.slots.front().colors);
}

void TestFeaturesDock::addsDuplicatesRenamesAndRemoves()
{
    FeaturesDesk desk;
    QVERIFY(desk.isReady());
    desk.press(QStringLiteral("addFeature"));
    QTRY_VERIFY(desk.list()->findChild<QLineEdit*>() != nullptr);
    auto* field = desk.list()->findChild<QLineEdit*>();
    field->selectAll();
    QTest::keyClicks(field, QStringLiteral("curious"));
    QTest::keyClick(field, Qt::Key_Return);
    QTRY_VERIFY(desk.value("curious").id != 0);
    QTRY_COMPARE(desk.names().back(), QStringLiteral("curious"));
    desk.choose("sad");
    desk.press(QStringLiteral("duplicateFeature"));
    QTRY_COMPARE(desk.names().size(), 9);
    QCOMPARE(desk.names()[2], QStringLiteral("sad 2"));
    // The copy is chosen, and its name open.
    QTRY_VERIFY(desk.list()->findChild<QLineEdit*>() != nullptr);
    QCOMPARE(desk.list()->currentItem()->text(), QStringLiteral("sad 2"));
    QTest::keyClick(desk.list()->findChild<QLineEdit*>(), Qt::Key_Escape);
    QTRY_VERIFY(desk.list()->findChild<QLineEdit*>() == nullptr);
    desk.choose("sad 2");
    desk.list()->currentItem()->setText(QStringLiteral("happy")); // there is one
    QVERIFY2(desk.said.contains(QStringLiteral("already")), qPrintable(desk.said));
    QTRY_VERIFY(desk.names().contains(QStringLiteral("sad 2")));
    desk.choose("sad 2");
    desk.press(QStringLiteral("removeFeature"));
    QTRY_COMPARE(desk.names().size(), 8);
    desk.document.undoStack().undo();
    QTRY_COMPARE(desk.names().size(), 9);
}

void TestFeaturesDock::aKindOfOnesOwn()
{
    FeaturesDesk desk;
    QVERIFY(desk.isReady());
    const std::uint8_t kind = addKind(desk.state, freeKindName(desk.state));
    QCOMPARE(kind, std::uint8_t{3});
    QVERIFY(renameKind(desk.state, kind, QStringLiteral("  team ")));
    QVERIFY(!renameKind(desk.state, kind, QStringLiteral("emotion")));
    QTRY_COMPARE(desk.kinds()->count(), 3);
    desk.kinds()->setCurrentIndex(2);
    QCOMPARE(desk.kinds()->currentText(), QStringLiteral("team"));
    QVERIFY(desk.names().isEmpty());
    const model::FeatureId home = addFeature(desk.state, kind);
    QVERIFY(renameFeature(desk.state, home, QStringLiteral("home")));
    QTRY_COMPARE(desk.names(), QStringList{QStringLiteral("home")});
    for (int i = 0; i < 5; ++i) {
        QVERIFY(addKind(desk.state, freeKindName(desk.state)) != 0);
    }
    QCOMPARE(addKind(desk.state, freeKindName(desk.state)), std::uint8_t{0});
    QVERIFY2(desk.said.contains(QStringLiteral("at most 8")), qPrintable(desk.said));
    removeKind(desk.state, kind);
    QTRY_COMPARE(desk.kinds()->count(), 7);
    QVERIFY2(desk.said.contains(QStringLiteral("“team” is gone")), qPrintable(desk.said));
}

/// Asked first: nothing is made of what is cancelled.
void TestFeaturesDock::aKindThatIsBackIsShown()
{
    FeaturesDesk desk;
    QVERIFY(desk.isReady());
    removeKind(desk.state, desk.document.scene().features.front().id);
    QTRY_COMPARE(desk.kinds()->count(), 1);
    QCOMPARE(desk.kinds()->currentText(), QStringLiteral("outfit"));
    desk.document.undoStack().undo();
    QTRY_COMPARE(desk.kinds()->count(), 2);
    QCOMPARE(desk.kinds()->currentText(), QStringLiteral("emotion"));
}

void TestFeaturesDock::aNewKindIsAskedForItsName()
{
    FeaturesDesk desk;
    QVERIFY(desk.isReady());
    QMenu* menu = nullptr;
    for (QToolButton* button : desk.dock->findChildren<QToolButton*>()) {
        menu = button->menu() != nullptr ? button->menu() : menu;
    }
    QVERIFY(menu != nullptr);
    const auto answer = [&](const QString& name) {
        QMetaObject::invokeMethod(menu, "aboutToShow");
        QTimer::singleShot(0, menu, [name] {
            auto* asked = qobject_cast<QInputDialog*>(QApplication::activeModalWidget());
            if (asked != nullptr && !name.isEmpty()) {
                asked->setTextValue(name);
                asked->accept();
            } else if (asked != nullptr) {
                asked->reject();
            }
        });
        menu->actions().front()->trigger();
    };
    answer({});
    QCOMPARE(desk.document.scene().features.size(), std::size_t{2});
    answer(QStringLiteral("team"));
    QCOMPARE(desk.document.scene().features.size(), std::size_t{3});
    QCOMPARE(desk.kinds()->currentText(), QStringLiteral("team"));
    answer(QStringLiteral("emotion"));
    QCOMPARE(desk.document.scene().features.size(), std::size_t{3});
    QVERIFY2(desk.said.contains(QStringLiteral("already")), qPrintable(desk.said));
}

void TestFeaturesDock::showsWhatTheBrushPaints()
{
    FeaturesDesk desk;
    QVERIFY(desk.isReady());
    desk.state.setTool(ToolId::BrushOutfit);
    QCOMPARE(desk.kinds()->currentIndex(), 1);
    desk.state.setTool(ToolId::BrushColour);
    QCOMPARE(desk.kinds()->currentIndex(), 1);
    desk.state.setTool(ToolId::BrushFeature);
    QCOMPARE(desk.kinds()->currentIndex(), 0);
}

void TestFeaturesDock::aWordTakenByMouseLeavesTheKeysToTheBrushes()
{
    FeaturesDesk desk;
    QVERIFY(desk.isReady());
    desk.choose("sad");
    auto* clip = desk.form()->findChild<QComboBox*>(); // the first clip's
    QVERIFY(clip != nullptr && clip->isEditable());
    clip->addItem(QStringLiteral("kneel"));
    clip->lineEdit()->setFocus();
    QTRY_VERIFY(clip->lineEdit()->hasFocus());
    clip->showPopup();
    QTRY_VERIFY(clip->view()->isVisible());
    const QRect last =
        clip->view()->visualRect(clip->model()->index(clip->count() - 1, clip->modelColumn()));
    QTest::mouseMove(clip->view()->viewport(), last.center());
    QTest::mouseClick(clip->view()->viewport(), Qt::LeftButton, {}, last.center());
    QTRY_VERIFY(!clip->view()->isVisible());
    QTRY_COMPARE(desk.value("sad").clips.front().clip, std::string("kneel"));
    QVERIFY(!clip->lineEdit()->hasFocus());
}

void TestFeaturesDock::whatIsSetComesToTheSceneAtRest()
{
    FeaturesDesk desk;
    QVERIFY(desk.isReady());
    desk.choose("sad");
    const int steps = desk.document.undoStack().count();
    QCheckBox* height = nullptr;
    for (auto* each : desk.form()->findChildren<QCheckBox*>()) {
        height = each->text() == QStringLiteral("How tall they are") ? each : height;
    }
    QVERIFY(height != nullptr && !height->isChecked());
    height->click();
    auto* line = desk.form()->findChild<QComboBox*>()->lineEdit(); // the first clip's
    QVERIFY(line != nullptr);
    crowd::testing::type(*line, QStringLiteral("weep"));
    QTRY_VERIFY(desk.value("sad").setsHeight);
    QCOMPARE(desk.value("sad").clips.front().clip, std::string("weep"));
    QCOMPARE(desk.document.undoStack().count(), steps + 1);
    desk.document.undoStack().undo();
    QVERIFY(!desk.value("sad").setsHeight);
    QTRY_VERIFY(!height->isChecked());
}

void TestFeaturesDock::bearersChangeWhereTicked()
{
    FeaturesDesk desk;
    QVERIFY(desk.isReady());
    const auto ids = crowd::testing::addPeople(desk.document, 3);
    desk.state.selection().set(ids);
    desk.choose("sad");
    desk.press(QStringLiteral("giveFeature"));
    auto* tick = desk.dock->findChild<QCheckBox*>(QStringLiteral("featureIsWorn"));
    QTRY_VERIFY(tick->isEnabled());
    QVERIFY2(tick->text().contains(QStringLiteral("3")), qPrintable(tick->text()));
    model::FeatureValue value = desk.value("sad");
    value.setsHeight = true;
    value.height = {2.0F, 2.0F};
    changeFeature(desk.state, value, false);
    const auto height = [&desk] {
        return desk.document.scene().population.column(model::columns::height)[0];
    };
    QVERIFY(height() != 2.0F);
    value.height = {3.0F, 3.0F};
    changeFeature(desk.state, value, true);
    QCOMPARE(height(), 3.0F);
}

void TestFeaturesDock::listsGrowAndShrink()
{
    FeaturesDesk desk;
    QVERIFY(desk.isReady());
    desk.choose("sad");
    const std::size_t before = desk.value("sad").clips.size();
    desk.press(QStringLiteral("add-clips"));
    QTRY_COMPARE(desk.value("sad").clips.size(), before + 1);
    desk.press(QStringLiteral("remove-clips-0"));
    QTRY_COMPARE(desk.value("sad").clips.size(), before);
    QVERIFY(desk.value("sad").clips.front().clip != "sad");
    desk.press(QStringLiteral("add-slots"));
    QTRY_COMPARE(desk.value("sad").slots.size(), std::size_t{1});
    desk.press(QStringLiteral("add-materials"));
    QTRY_COMPARE(desk.value("sad").slots.front().materials.size(), std::size_t{1});
    desk.press(QStringLiteral("add-parts"));
    desk.press(QStringLiteral("remove-slots-0")); // before that came to the scene
    QTRY_COMPARE(desk.value("sad").parts.size(), std::size_t{1});
    QVERIFY(desk.value("sad").slots.empty());
}

void TestFeaturesDock::sixPeopleWearIt()
{
    FeaturesDesk desk;
    QVERIFY(desk.isReady());
    auto* preview = desk.dock->findChild<FeaturePreview*>(QStringLiteral("featurePreview"));
    desk.kinds()->setCurrentIndex(1);
    desk.choose("team red");
    const model::Population& people = preview->people().population;
    QCOMPARE(people.size(), std::size_t{6});
    const auto seats = people.column(model::columns::seat);
    QCOMPARE(std::ranges::count(seats, model::kNoSeat), std::ptrdiff_t{3});
    QVERIFY(preview->isVisible());
    const auto colours = [preview] {
        const QImage shot = preview->grab().toImage();
        std::set<QRgb> found;
        for (int x = 0; x < shot.width(); ++x) {
            for (int y = 0; y < shot.height(); ++y) {
                found.insert(shot.pixel(x, y));
            }
        }
        return found.size();
    };
    QTRY_VERIFY(colours() > 20);
}

void TestFeaturesDock::filesAreSharedBetweenScenes()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("emotion.features"));
    FeaturesDesk desk;
    QVERIFY(desk.isReady());
    model::FeatureValue value = desk.value("sad");
    value.name = "weary";
    value.templates = {1};
    changeFeature(desk.state, value, false);
    QVERIFY(exportKind(desk.state, 1, path));
    FeaturesDesk other;
    QVERIFY(other.isReady());
    model::FeatureValue happy = other.value("happy");
    happy.setsGirth = true;
    changeFeature(other.state, happy, false);
    QVERIFY(importKinds(other.state, path));
    QVERIFY(other.value("weary").id != 0 && other.value("weary").id != value.id);
    QVERIFY(other.value("weary").templates.empty());
    QVERIFY(!other.value("happy").setsGirth);
    QCOMPARE(other.value("happy").id, happy.id);
    QVERIFY(other.value("sad").id != 0);
    other.document.undoStack().undo();
    QVERIFY(other.value("happy").setsGirth);
}

void TestFeaturesDock::filesThatAreNoneAreRefused_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::newRow("empty") << QByteArray();
    QTest::newRow("no JSON") << QByteArray("features");
    QTest::newRow("another format") << QByteArray(R"({"format": "crowdbrush brush"})");
    QTest::newRow("newer") << QByteArray(
        R"({"format": "crowdbrush features", "version": 2, "features": []})");
    QTest::newRow("wrong inside") << QByteArray(
        R"({"format": "crowdbrush features", "version": 1, "features": [{"id": 70, "name": "a"}]})");
    QTest::newRow("cut off") << QByteArray(
        R"({"format": "crowdbrush features", "version": 1, "features": [{"id": 1,)");
    QTest::newRow("deep") << QByteArray(R"({"format": "crowdbrush features", "x": )") +
                                 QByteArray(100000, '[');
}

void TestFeaturesDock::filesThatAreNoneAreRefused()
{
    QFETCH(QByteArray, bytes);
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("a.features"));
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(bytes);
    file.close();
    FeaturesDesk desk;
    QVERIFY(desk.isReady());
    const model::FeatureKinds before = desk.document.scene().features;
    const auto taken = importKinds(desk.state, path);
    QVERIFY(!taken);
    QVERIFY2(taken.error().message.find("a.features") != std::string::npos,
             taken.error().message.c_str());
    QCOMPARE(desk.document.scene().features, before);
    QVERIFY(!importKinds(desk.state, folder.filePath(QStringLiteral("none.features"))));
}

void TestFeaturesDock::anotherSceneInBetween()
{
    FeaturesDesk desk;
    QVERIFY(desk.isReady());
    desk.choose("sad");
    desk.press(QStringLiteral("add-clips"));
    model::Scene empty;
    empty.features.clear();
    desk.document.replaceScene(std::move(empty), {});
    QTRY_COMPARE(desk.kinds()->count(), 0);
    QTRY_VERIFY(desk.form() == nullptr);
    QTest::qWait(1);
    QVERIFY(desk.document.scene().features.empty());
    QVERIFY(!desk.document.undoStack().canUndo());
}

void TestFeaturesDock::thePanelOfACharacterHasThem()
{
    crowd::testing::Desk<IndividualDock> desk;
    QVERIFY(desk.isReady());
    const auto ids = crowd::testing::addPeople(desk.document, 3);
    desk.state.selection().set(ids);
    const auto box = [&desk] {
        return desk.dock->findChild<QComboBox*>(QStringLiteral("feature1"));
    };
    QTRY_VERIFY(box() != nullptr && box()->isVisible());
    QCOMPARE(box()->currentText(), QStringLiteral("none"));
    box()->setCurrentIndex(2);
    Q_EMIT box()->activated(2);
    const model::FeatureId sad =
        findKind(desk.document.scene().features, "emotion")->find("sad")->id;
    QCOMPARE(model::bearersOf(desk.document.scene(), sad).size(), std::size_t{3});
    desk.state.selection().set(std::span(ids).first(1));
    QTRY_COMPARE(box()->currentText(), QStringLiteral("sad"));
    box()->setCurrentIndex(0);
    Q_EMIT box()->activated(0);
    QCOMPARE(model::bearersOf(desk.document.scene(), sad).size(), std::size_t{2});
    desk.state.selection().set(ids);
    QTRY_COMPARE(box()->currentIndex(), -1); // mixed
}

CROWD_WINDOW_TEST(TestFeaturesDock)
#include "tst_FeaturesDock.moc"
