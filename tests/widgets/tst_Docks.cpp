// SPDX-License-Identifier: MIT
#include <algorithm>

#include <QtCore/QSettings>
#include <QtCore/QStandardPaths>
#include <QtTest/QSignalSpy>
#include <QtTest/QTest>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QListWidget>
#include <QtWidgets/QMainWindow>
#include <QtWidgets/QToolButton>
#include <QtWidgets/QTreeWidget>
#include <QtWidgets/QUndoView>

#include "tests/widgets/SmallTheatre.h"
#include "widgets/docks/CurveEditor.h"
#include "widgets/docks/Docks.h"
#include "widgets/docks/NumberField.h"
#include "widgets/docks/ValueSlider.h"
#include "widgets/theme/Theme.h"

using namespace crowd;
using namespace crowd::widgets;

namespace {

/// A window with one dock over the small theatre.
template<class Dock>
struct Desk
{
    Desk() : state(document), dock(nullptr)
    {
        document.replaceScene(testing::smallTheatre(), {});
        dock = new Dock(state, &window);
        window.addDockWidget(Qt::LeftDockWidgetArea, dock);
        window.resize(300, 700);
        window.show();
    }
    ~Desk() { delete dock; }
    /// Laid out; events are handed to the widgets, so the window need not be exposed.
    [[nodiscard]] bool isReady()
    {
        return QTest::qWaitFor([this] { return dock->isVisible() && dock->width() > 0; });
    }
    template<class Child>
    [[nodiscard]] QList<Child*> all() const
    {
        QList<Child*> found;
        for (Child* child : dock->template findChildren<Child*>()) {
            if (child->isVisible()) {
                found << child;
            }
        }
        return found;
    }

    model::SceneDocument document;
    EditorState state;
    QMainWindow window;
    Dock* dock;
};

void type(QLineEdit& field, const QString& text)
{
    field.setFocus();
    field.selectAll();
    QTest::keyClicks(&field, text);
    QTest::keyClick(&field, Qt::Key_Return);
}

/// The field of a form that a label stands beside.
template<class Field>
Field* fieldBeside(const QWidget& dock, const QString& label)
{
    for (const QLabel* item : dock.findChildren<QLabel*>()) {
        if (item->text() == label && item->buddy() != nullptr) {
            return qobject_cast<Field*>(item->buddy());
        }
    }
    return nullptr;
}

} // namespace

class DocksTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();

    void paletteChoosesTheTool();
    void everyBrushHasSettingsThatFit_data();
    void everyBrushHasSettingsThatFit();
    void sliderChangesTheBrush();
    void sliderStaysInItsRange();
    void drawnCurveIsKept();
    void colourEditsTheEndThatIsChosen();
    void greyKeepsTheHueOfTheSquare();
    void swatchesAreRemembered();
    void tickedTemplatesAreTheMix();
    void individualShowsNobody();
    void individualShowsMixedAndWritesAll();
    void individualComparesClipsByName();
    void individualIgnoresNonsense();
    void outlineListsTheScene();
    void renamedCameraCanBeUndone();
    void historyGoesBack();
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

void DocksTest::sliderStaysInItsRange()
{
    ValueSlider slider(QStringLiteral("Size"), {1.0, 10.0, 1.0, 0, {}, false}, nullptr);
    slider.resize(200, 24);
    slider.show();
    QVERIFY(QTest::qWaitForWindowExposed(&slider));
    slider.setValue(5.0);
    QSignalSpy edited(&slider, &ValueSlider::valueEdited);
    QTest::mousePress(&slider, Qt::LeftButton, {}, {100, 10});
    QTest::mouseMove(&slider, {900, 10});
    QTest::mouseRelease(&slider, Qt::LeftButton, {}, {900, 10});
    QCOMPARE(slider.value(), 10.0);
    QVERIFY(edited.count() > 0);
}

void DocksTest::drawnCurveIsKept()
{
    CurveEditor editor(nullptr);
    editor.resize(160, 60);
    editor.show();
    QVERIFY(QTest::qWaitForWindowExposed(&editor));
    QSignalSpy edited(&editor, &CurveEditor::edited);
    QTest::mouseClick(&editor, Qt::LeftButton, {}, {5, 58});
    QVERIFY(edited.count() > 0);
    QVERIFY(editor.curve().weights.front() < 0.3F);
    QCOMPARE(editor.curve().weights.back(), 1.0F);
    QTest::mouseDClick(&editor, Qt::LeftButton, {}, {80, 30});
    QCOMPARE(editor.curve(), model::DistributionCurve());
}

void DocksTest::colourEditsTheEndThatIsChosen()
{
    Desk<ColourDock> desk;
    QVERIFY(desk.isReady());
    desk.dock->setColor(QColor(10, 20, 30));
    const auto& colors = desk.state.brush(model::BrushKind::Colour).colour.colors;
    QCOMPARE(colors.front(), (model::PaintColor{10, 20, 30}));
    const model::PaintColor last = colors.back();
    QVERIFY(last != colors.front());
    type(*desk.all<QLineEdit>().front(), QStringLiteral("#ff8000"));
    QCOMPARE(desk.dock->color(), QColor(255, 128, 0));
    QCOMPARE(desk.state.brush(model::BrushKind::Colour).colour.colors.back(), last);
}

void DocksTest::greyKeepsTheHueOfTheSquare()
{
    Desk<ColourDock> desk;
    QVERIFY(desk.isReady());
    desk.dock->setColor(QColor::fromHsv(200, 255, 200));
    desk.dock->setColor(QColor(90, 90, 90));
    QCOMPARE(desk.dock->color(), QColor(90, 90, 90));
    type(*desk.all<QLineEdit>().front(), QStringLiteral("no colour"));
    QCOMPARE(desk.dock->color(), QColor(90, 90, 90));
}

void DocksTest::swatchesAreRemembered()
{
    qsizetype count = 0;
    {
        Desk<ColourDock> desk;
        QVERIFY(desk.isReady());
        count = desk.all<QToolButton>().size();
        desk.dock->setColor(QColor(1, 2, 3));
        for (QToolButton* button : desk.all<QToolButton>()) {
            if (button->toolTip().startsWith(QStringLiteral("Keep"))) {
                button->click();
            }
        }
        QTRY_COMPARE(desk.all<QToolButton>().size(), count + 1);
    }
    Desk<ColourDock> again;
    QVERIFY(again.isReady());
    QCOMPARE(again.all<QToolButton>().size(), count + 1);
}

void DocksTest::tickedTemplatesAreTheMix()
{
    Desk<TemplatesDock> desk;
    QVERIFY(desk.isReady());
    auto edit = desk.document.beginEdit();
    model::TemplateEntry second = desk.document.scene().templates.front();
    second.id = 0;
    second.name = "other";
    const model::TemplateId id = edit->addTemplate(second);
    edit->commit(QStringLiteral("Import"));
    auto* list = desk.dock->findChild<QListWidget*>();
    QTRY_COMPARE(list->count(), 2);
    const auto mix = [&] { return desk.state.brush(model::BrushKind::Create).create.mix; };
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

void DocksTest::individualShowsNobody()
{
    Desk<IndividualDock> desk;
    QVERIFY(desk.isReady());
    QVERIFY(desk.all<NumberField>().isEmpty());
}

void DocksTest::individualShowsMixedAndWritesAll()
{
    Desk<IndividualDock> desk;
    QVERIFY(desk.isReady());
    const auto ids = testing::addPeople(desk.document, 3);
    {
        const float tall = 1.25F;
        const auto edit = desk.document.beginEdit();
        edit->setColumn(model::columns::height, std::span(ids).first(1),
                        std::span<const float>(&tall, 1));
        edit->commit(QStringLiteral("Grow"));
    }
    desk.state.selection().set(ids);
    QTRY_VERIFY(!desk.all<NumberField>().isEmpty());
    auto* height = fieldBeside<NumberField>(*desk.dock, QStringLiteral("Height"));
    auto* girth = fieldBeside<NumberField>(*desk.dock, QStringLiteral("Girth"));
    QVERIFY(height != nullptr && girth != nullptr);
    QTRY_VERIFY2(height->text().isEmpty(), "three heights are mixed");
    QVERIFY(!girth->text().isEmpty());
    const int steps = desk.document.undoStack().count();
    type(*height, QLocale().toString(1.5, 'f', 1));
    QCOMPARE(desk.document.undoStack().count(), steps + 1);
    for (const float value : desk.document.scene().population.column(model::columns::height)) {
        QCOMPARE(value, 1.5F);
    }
    desk.document.undoStack().undo();
    QCOMPARE(desk.document.scene().population.column(model::columns::height)[0], 1.25F);
    QTRY_VERIFY(height->text().isEmpty());
}

void DocksTest::individualComparesClipsByName()
{
    Desk<IndividualDock> desk;
    QVERIFY(desk.isReady());
    const auto ids = testing::addPeople(desk.document, 2);
    desk.state.selection().set(ids);
    auto* clip = fieldBeside<QComboBox>(*desk.dock, QStringLiteral("Clip"));
    QVERIFY(clip != nullptr);
    QTRY_COMPARE(clip->currentIndex(), 0);
    const auto edit = desk.document.beginEdit();
    model::TemplateEntry other = desk.document.scene().templates.front();
    other.id = 0;
    std::ranges::reverse(other.clipNames);
    QVERIFY(other.clipNames.front() != other.clipNames.back());
    const model::TemplateId id = edit->addTemplate(other);
    edit->setColumn(model::columns::templateId, std::span(ids).last(1),
                    std::span<const model::TemplateId>(&id, 1));
    edit->commit(QStringLiteral("Change template"));
    QTRY_VERIFY2(clip->currentIndex() < 0, "the same index is another clip in the other template");
}

void DocksTest::individualIgnoresNonsense()
{
    Desk<IndividualDock> desk;
    QVERIFY(desk.isReady());
    desk.state.selection().set(testing::addPeople(desk.document, 1));
    QTRY_VERIFY(!desk.all<NumberField>().isEmpty());
    auto* height = fieldBeside<NumberField>(*desk.dock, QStringLiteral("Height"));
    const QString shown = height->text();
    const int steps = desk.document.undoStack().count();
    type(*height, QStringLiteral("tall"));
    QCOMPARE(desk.document.undoStack().count(), steps);
    QCOMPARE(height->text(), shown);
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

QTEST_MAIN(DocksTest)
#include "tst_Docks.moc"
