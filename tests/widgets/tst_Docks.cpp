// SPDX-License-Identifier: MIT
#include <algorithm>

#include <QtCore/QSettings>
#include <QtCore/QStandardPaths>
#include <QtTest/QSignalSpy>
#include <QtTest/QTest>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QLabel>
#include <QtWidgets/QListWidget>
#include <QtWidgets/QToolButton>
#include <QtWidgets/QTreeWidget>
#include <QtWidgets/QUndoView>

#include "tests/model/FullDisk.h"
#include "tests/program/WindowTest.h"
#include "tests/widgets/Desk.h"
#include "widgets/docks/Docks.h"
#include "widgets/docks/TemplateDelegate.h"
#include "widgets/forms/CheckList.h"
#include "widgets/forms/RangeSlider.h"
#include "widgets/forms/StatureNote.h"
#include "widgets/forms/ValueSlider.h"
#include "widgets/theme/Theme.h"

using namespace crowd;
using namespace crowd::widgets;
using crowd::testing::Desk;

class DocksTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();

    void paletteChoosesTheTool();
    void everyBrushHasSettingsThatFit_data();
    void everyBrushHasSettingsThatFit();
    void aToolWithoutSettingsSaysWhatItDoes();
    void sliderChangesTheBrush();
    void tickedTemplatesAreTheMix();
    void heightsAreSaidInMetres();
    void unlikeHeightsAreSaidByName();
    void theNoteIsThatOfTheShape();
    void theMaskIsNoLowerThanOtherBoxes();
    void outlineListsTheScene();
    void renamedCameraCanBeUndone();
    void stagesAndTemplatesAreRenamed();
    void paletteIsAsHighAsItsButtons();
    void templatesShowTheirShareOfTheMix();
    void sectionsStayFolded();
    void historyGoesBack();
    void historySaysWhatItTakes();
    void theTagBrushShowsNameAndColour();
};

void DocksTest::initTestCase()
{
    QCoreApplication::setOrganizationName(QStringLiteral("CrowdbrushTest"));
    QCoreApplication::setApplicationName(QStringLiteral("DocksTest"));
    QStandardPaths::setTestModeEnabled(true);
    QSettings().clear();
    applyTheme(Theme::Dark);
}

void DocksTest::paletteChoosesTheTool()
{
    Desk<BrushPaletteDock> desk;
    QVERIFY(desk.isReady());
    for (const ToolInfo& info : toolTable()) {
        auto* button = desk.dock->findChild<QToolButton*>(QLatin1String(info.stableId));
        QVERIFY2(button != nullptr, info.stableId);
        QVERIFY2(!button->icon().isNull() && !button->toolTip().isEmpty(), info.stableId);
        QTest::mouseClick(button, Qt::LeftButton);
        QCOMPARE(desk.state.tool(), info.id);
        QTest::mouseClick(button, Qt::LeftButton);
        QVERIFY2(button->isChecked(), "a second click leaves the tool chosen");
    }
}

void DocksTest::everyBrushHasSettingsThatFit_data()
{
    QTest::addColumn<int>("tool");
    for (const ToolInfo& info : toolTable()) {
        QTest::newRow(info.stableId) << static_cast<int>(info.id);
    }
}

void DocksTest::everyBrushHasSettingsThatFit()
{
    QFETCH(int, tool);
    Desk<BrushSettingsDock> desk;
    QVERIFY(desk.isReady());
    desk.state.setTool(static_cast<ToolId>(tool));
    const bool isBrush = brushKindOf(static_cast<ToolId>(tool)).has_value();
    QTRY_COMPARE(!desk.all<ValueSlider>().isEmpty(), isBrush);
    desk.dock->setFixedWidth(280);
    QTest::qWait(30);
    for (const QWidget* child : desk.all<QWidget>()) {
        const QPoint right = child->mapTo(desk.dock, QPoint(child->width(), 0));
        QVERIFY2(right.x() <= desk.dock->width(), child->metaObject()->className());
    }
}

/// All of it, also where the status bar is short.
void DocksTest::aToolWithoutSettingsSaysWhatItDoes()
{
    Desk<BrushSettingsDock> desk;
    QVERIFY(desk.isReady());
    const auto note = [&desk] { return desk.dock->findChild<QLabel*>(QStringLiteral("toolNote")); };
    desk.state.setTool(ToolId::Select);
    QTRY_VERIFY(note() != nullptr);
    desk.state.setHint(QStringLiteral("Click: select · Drag: area"));
    QCOMPARE(note()->text(), QStringLiteral("Click: select\n\nDrag: area"));
    desk.state.setTool(ToolId::BrushColour);
    QTRY_VERIFY(note() == nullptr);
    desk.state.setHint(QStringLiteral("Drag: paint"));
    desk.state.setTool(ToolId::Select);
    QTRY_VERIFY(note() != nullptr);
    QCOMPARE(note()->text(), QStringLiteral("Drag: paint")); // as it is by then
}

void DocksTest::sliderChangesTheBrush()
{
    Desk<BrushSettingsDock> desk;
    QVERIFY(desk.isReady());
    desk.state.setTool(ToolId::BrushColour);
    QTRY_COMPARE(desk.dock->windowTitle(), QStringLiteral("Colour Brush"));
    const auto before = desk.state.brush(model::BrushKind::Colour);
    QSignalSpy changed(&desk.state, &EditorState::brushChanged);
    ValueSlider* slider = desk.all<ValueSlider>().front();
    QTest::mousePress(slider, Qt::LeftButton, {}, {60, 8});
    QTest::mouseMove(slider, {130, 8});
    QTest::mouseRelease(slider, Qt::LeftButton, {}, {130, 8});
    QVERIFY(changed.count() > 0);
    QVERIFY(!(desk.state.brush(model::BrushKind::Colour) == before));
}

void DocksTest::tickedTemplatesAreTheMix()
{
    Desk<TemplatesDock> desk;
    QVERIFY(desk.isReady());
    auto edit = desk.document.beginEdit().value();
    model::TemplateEntry second = desk.document.scene().templates.front();
    second.id = 0;
    second.name = "other";
    const model::TemplateId id = edit->addTemplate(second);
    edit->commit(QStringLiteral("Import"));
    auto* list = desk.dock->findChild<QListWidget*>();
    QTRY_COMPARE(list->count(), 2);
    const auto mix = [&] {
        return desk.state.brush(model::BrushKind::Create).as<crowd::model::CreateSettings>().mix;
    };
    list->item(1)->setCheckState(Qt::Unchecked);
    for (const model::TemplateWeight& entry : mix()) {
        QVERIFY(entry.id != id);
    }
    list->item(1)->setCheckState(Qt::Checked);
    list->item(0)->setCheckState(Qt::Unchecked);
    QCOMPARE(mix().size(), std::size_t{1});
    QCOMPARE(mix().front().id, id);
    list->item(1)->setCheckState(Qt::Unchecked);
    QVERIFY2(list->item(1)->checkState() == Qt::Checked, "the last template stays in the mix");
}

void DocksTest::heightsAreSaidInMetres()
{
    Desk<BrushSettingsDock> desk;
    QVERIFY(desk.isReady());
    const model::Scene& scene = desk.document.scene();
    const float tall = scene.templates.front().asset->height;
    desk.state.setTool(ToolId::BrushScale);
    model::BrushSettings scale = desk.state.brush(model::BrushKind::Scale);
    scale.as<model::ScaleSettings>().height = {0.5F, 0.75F};
    desk.state.setBrush(scale);
    const auto note = [&] { return desk.dock->findChild<QLabel*>(QStringLiteral("stature")); };
    QTRY_VERIFY(note() != nullptr && note()->isVisible());
    QTRY_COMPARE(note()->text(), QStringLiteral("%1 to %2 m tall")
                                     .arg(static_cast<double>(0.5F * tall), 0, 'f', 2)
                                     .arg(static_cast<double>(0.75F * tall), 0, 'f', 2));
    scale.as<model::ScaleSettings>().setsHeight = false;
    desk.state.setBrush(scale);
    QTRY_VERIFY(!note()->isVisible());
    // Of those that are created alone; of nobody nothing.
    model::BrushSettings create = desk.state.brush(model::BrushKind::Create);
    create.as<model::CreateSettings>().mix = {{scene.templates.front().id, 0.0F}};
    QCOMPARE(statureText({&scene, &create}, {1.0F, 1.0F}), QString());
    create.as<model::CreateSettings>().mix = {{scene.templates.front().id, 1.0F}};
    QVERIFY(statureText({&scene, &create}, {1.0F, 1.0F}).endsWith(QStringLiteral("m tall")));
}

/// A butterfly and a helicopter have no height in common.
void DocksTest::unlikeHeightsAreSaidByName()
{
    model::Scene scene;
    for (const auto& [name, height] : {std::pair("Butterfly", 0.05F), std::pair("Truck", 3.0F)}) {
        auto asset = std::make_shared<model::Template>();
        asset->height = height;
        model::TemplateEntry& entry = scene.templates.emplace_back();
        entry.id = static_cast<model::TemplateId>(scene.templates.size());
        entry.name = name;
        entry.asset = asset;
    }
    QCOMPARE(statureText({&scene, nullptr}, {0.8F, 1.2F}),
             QStringLiteral("Butterfly from 0.04 m\nTruck to 3.60 m"));
}

void DocksTest::theNoteIsThatOfTheShape()
{
    Desk<BrushSettingsDock> desk;
    QVERIFY(desk.isReady());
    desk.state.setTool(ToolId::BrushEnvironment);
    const auto says = [&desk](const QString& text) {
        return std::ranges::any_of(desk.all<QLabel>(), [&text](const QLabel* label) {
            return label->text().contains(text);
        });
    };
    QTRY_VERIFY(says(QStringLiteral("Each click puts one there")));
    QVERIFY(!says(QStringLiteral("adds a corner")));
    model::BrushSettings brush = desk.state.brush(model::BrushKind::Environment);
    brush.as<model::EnvironmentSettings>().shape = model::PlaceShape::Line;
    desk.state.setBrush(brush);
    QTRY_VERIFY(says(QStringLiteral("adds a corner")));
    QVERIFY(!says(QStringLiteral("Each click puts one there")));
}

void DocksTest::theMaskIsNoLowerThanOtherBoxes()
{
    Desk<BrushSettingsDock> desk;
    QVERIFY(desk.isReady());
    desk.state.setTool(ToolId::BrushColour);
    const auto lists = [&desk] { return desk.dock->findChildren<CheckList*>(); };
    QTRY_VERIFY(!lists().isEmpty() && lists().front()->isVisible());
    const auto* box = desk.dock->findChild<QComboBox*>();
    QVERIFY(box != nullptr);
    for (const CheckList* list : lists()) {
        QTRY_VERIFY2(list->height() + 1 >= box->height(),
                     qPrintable(QStringLiteral("%1 %2").arg(list->height()).arg(box->height())));
    }
    // Places have no mask: what is noted of them stands under no heading of it.
    desk.state.setTool(ToolId::BrushEnvironment);
    const auto mask = [&desk] {
        return desk.dock->findChild<QToolButton*>(QStringLiteral("mask"));
    };
    QTRY_VERIFY(mask() != nullptr && !mask()->isVisible());
}

void DocksTest::outlineListsTheScene()
{
    Desk<SceneDock> desk;
    QVERIFY(desk.isReady());
    testing::addPeople(desk.document, 7);
    auto* tree = desk.dock->findChild<QTreeWidget*>();
    QTRY_COMPARE(tree->topLevelItemCount(), 3);
    QCOMPARE(tree->topLevelItem(0)->child(0)->text(0), QStringLiteral("small theatre"));
    QTRY_COMPARE(tree->topLevelItem(1)->child(0)->text(1), QStringLiteral("7"));
    QCOMPARE(tree->topLevelItem(2)->child(0)->text(0), QStringLiteral("front"));
}

void DocksTest::renamedCameraCanBeUndone()
{
    Desk<SceneDock> desk;
    QVERIFY(desk.isReady());
    auto* tree = desk.dock->findChild<QTreeWidget*>();
    tree->topLevelItem(2)->child(0)->setText(0, QStringLiteral("balcony"));
    QCOMPARE(desk.document.scene().cameras.front().name, std::string("balcony"));
    desk.document.undoStack().undo();
    QTRY_COMPARE(tree->topLevelItem(2)->child(0)->text(0), QStringLiteral("front"));
    const std::size_t cameras = desk.document.scene().cameras.size();
    desk.window.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&desk.window));
    tree->setCurrentItem(tree->topLevelItem(2)->child(0));
    tree->setFocus();
    QTest::keyClick(tree, Qt::Key_Delete);
    QCOMPARE(desk.document.scene().cameras.size(), cameras - 1);
    desk.document.undoStack().undo();
}

void DocksTest::stagesAndTemplatesAreRenamed()
{
    Desk<SceneDock> desk;
    QVERIFY(desk.isReady());
    auto* tree = desk.dock->findChild<QTreeWidget*>();
    tree->topLevelItem(0)->child(0)->setText(0, QStringLiteral("arena"));
    QCOMPARE(desk.document.scene().stages.front().name, std::string("arena"));
    QTRY_COMPARE(tree->topLevelItem(0)->child(0)->text(0), QStringLiteral("arena"));
    tree->topLevelItem(1)->child(0)->setText(0, QStringLiteral("citizen"));
    QCOMPARE(desk.document.scene().templates.front().name, std::string("citizen"));
    const int steps = desk.document.undoStack().count();
    tree->topLevelItem(1)->child(0)->setText(0, QStringLiteral("  "));
    QCOMPARE(desk.document.undoStack().count(), steps);
    QTRY_COMPARE(tree->topLevelItem(1)->child(0)->text(0), QStringLiteral("citizen"));
    desk.document.undoStack().undo();
    QTRY_COMPARE(tree->topLevelItem(1)->child(0)->text(0), QStringLiteral("box man"));
}

void DocksTest::paletteIsAsHighAsItsButtons()
{
    Desk<BrushPaletteDock> desk;
    QVERIFY(desk.isReady());
    const auto lowest = [&] {
        int bottom = 0;
        for (const QToolButton* button : desk.all<QToolButton>()) {
            if (!button->objectName().startsWith(QStringLiteral("qt_"))) {
                bottom = std::max(bottom, button->geometry().bottom());
            }
        }
        return bottom;
    };
    for (const int width : {420, 190}) {
        desk.window.resize(width, 700);
        desk.dock->setFixedWidth(width);
        QTRY_VERIFY(desk.dock->widget()->height() - lowest() < 12);
        QTRY_VERIFY(desk.dock->widget()->height() > lowest());
    }
}

void DocksTest::templatesShowTheirShareOfTheMix()
{
    Desk<TemplatesDock> desk;
    QVERIFY(desk.isReady());
    auto edit = desk.document.beginEdit().value();
    model::TemplateEntry second = desk.document.scene().templates.front();
    second.id = 0;
    const model::TemplateId id = edit->addTemplate(second);
    edit->commit(QStringLiteral("Import"));
    auto* list = desk.dock->findChild<QListWidget*>();
    QTRY_COMPARE(list->count(), 2);
    model::BrushSettings brush = desk.state.brush(model::BrushKind::Create);
    brush.as<crowd::model::CreateSettings>().mix = {{1, 1.0F}, {id, 0.25F}};
    desk.state.setBrush(brush);
    const auto share = [&](int row) {
        return list->item(row)->data(TemplateDelegate::kShareRole).toFloat();
    };
    QCOMPARE(share(0), 0.8F);
    QCOMPARE(share(1), 0.2F);
    const QRect item = list->visualItemRect(list->item(1));
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {},
                      TemplateDelegate::tickRect(item).center());
    QVERIFY2(share(1) < 0.0F, "a click on the tick takes it out");
    QCOMPARE(share(0), 1.0F);
    Q_EMIT list->itemDoubleClicked(list->item(1));
    QCOMPARE(desk.state.brush(model::BrushKind::Create).as<crowd::model::CreateSettings>().mix,
             (std::vector<model::TemplateWeight>{{id, 1.0F}}));
}

void DocksTest::sectionsStayFolded()
{
    const auto rows = [](const Desk<BrushSettingsDock>& desk) {
        return desk.all<RangeSlider>().size();
    };
    {
        Desk<BrushSettingsDock> desk;
        QVERIFY(desk.isReady());
        desk.state.setTool(ToolId::BrushCreate);
        QTRY_COMPARE(rows(desk), qsizetype{3});
        desk.dock->findChild<QToolButton*>(QStringLiteral("variation"))->click();
        QCOMPARE(rows(desk), qsizetype{0});
    }
    Desk<BrushSettingsDock> again;
    QVERIFY(again.isReady());
    QTRY_COMPARE(rows(again), qsizetype{0});
    again.dock->findChild<QToolButton*>(QStringLiteral("variation"))->click();
    QCOMPARE(rows(again), qsizetype{3});
}

void DocksTest::historyGoesBack()
{
    Desk<HistoryDock> desk;
    QVERIFY(desk.isReady());
    testing::addPeople(desk.document, 2);
    testing::addPeople(desk.document, 2, 6.0F);
    auto* view = desk.dock->findChild<QUndoView*>();
    QVERIFY(view != nullptr);
    QCOMPARE(view->model()->rowCount(), 3);
    view->setCurrentIndex(view->model()->index(0, 0));
    QTRY_COMPARE(desk.document.scene().population.size(), std::size_t{0});
}

void DocksTest::historySaysWhatItTakes()
{
    Desk<HistoryDock> desk;
    QVERIFY(desk.isReady());
    const auto* said = desk.dock->findChild<QLabel*>(QStringLiteral("undoMemory"));
    QVERIFY(!said->isVisible());
    testing::addPeople(desk.document, 2000);
    QVERIFY(said->isVisible());
    QVERIFY2(said->text().endsWith(QStringLiteral("kB in memory")), qPrintable(said->text()));
    testing::addPeople(desk.document, 2000, 6.0F);
    desk.document.setUndoBudget(1000);
    QVERIFY2(said->text().endsWith(QStringLiteral("kB on disk")), qPrintable(said->text()));
    {
        const testing::FullDisk disk(0);
        testing::addPeople(desk.document, 2000, 12.0F);
    }
    QVERIFY2(said->text().contains(QStringLiteral("temporary file")), qPrintable(said->text()));
    testing::addPeople(desk.document, 2);
    QVERIFY2(said->text().endsWith(QStringLiteral("kB on disk")), qPrintable(said->text()));
    desk.document.undoStack().clear();
    QVERIFY(!said->isVisible());
}

void DocksTest::theTagBrushShowsNameAndColour()
{
    Desk<BrushSettingsDock> desk;
    QVERIFY(desk.isReady());
    auto edit = desk.document.beginEdit().value();
    edit->setTags({{2, "guests", {10, 200, 30}}});
    edit->commit(QStringLiteral("Name a tag"));
    desk.state.setTool(ToolId::BrushTag);
    model::BrushSettings brush = desk.state.brush(model::BrushKind::Tag);
    brush.as<crowd::model::TagSettings>().tag = 2;
    desk.state.setBrush(brush);
    const auto shown = [&](const char* name) {
        return desk.dock->findChild<QLabel*>(QLatin1String(name));
    };
    QTRY_VERIFY(shown("swatchText") != nullptr);
    QCOMPARE(shown("swatchText")->text(), QStringLiteral("guests"));
    QCOMPARE(shown("swatch")->pixmap().toImage().pixelColor(5, 5), QColor(10, 200, 30));
    brush.as<crowd::model::TagSettings>().tag = 3;
    desk.state.setBrush(brush);
    QVERIFY(shown("swatchText")->text() != QStringLiteral("guests"));
    QVERIFY(shown("swatch")->pixmap().toImage().pixelColor(5, 5) != QColor(10, 200, 30));
}

CROWD_WINDOW_TEST(DocksTest)
#include "tst_Docks.moc"
