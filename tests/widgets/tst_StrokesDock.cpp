// SPDX-License-Identifier: MIT
#include <QtTest/QTest>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QListWidget>
#include <QtWidgets/QToolButton>

#include "tests/program/WindowTest.h"
#include "tests/widgets/Desk.h"
#include "widgets/docks/StrokesDock.h"
#include "widgets/tools/ToolController.h"

using namespace crowd;
using namespace crowd::widgets;
using crowd::testing::Desk;

/// The last strokes: listed, changed by their form, laid anew.
class StrokesDockTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theFormChangesTheStroke();
    void valuesAreDrawnAnew();
    void settingsGoToTheBrushAndBack();
    void olderOnesAreChosenInTheList();
    void anotherEditEmptiesTheList();
};

namespace {

struct StrokesDesk : Desk<StrokesDock>
{
    StrokesDesk() : tools(state)
    {
        state.setViewSize({640.0F, 480.0F});
        ids = testing::addPeople(document, 5);
        scale.setKind(model::BrushKind::Scale);
        scale.selection = model::BrushSelection::Rectangle;
        scale.through = true;
        scale.as<model::ScaleSettings>().height = {1.5F, 2.0F};
    }
    model::StrokeOutcome paint(const model::BrushSettings& settings)
    {
        const auto stroke = model::Stroke::begin(document, tools.queries().brushContext(), settings,
                                                 7, model::PointerInput::at({0.0, 0.0}, 0.0));
        stroke->move(model::PointerInput::at({640.0, 480.0}, 0.1));
        return stroke->finish();
    }
    [[nodiscard]] std::vector<float> heights() const
    {
        const auto column = document.scene().population.column(model::columns::height);
        return {column.begin(), column.end()};
    }
    [[nodiscard]] QListWidget& list() const { return *dock->findChild<QListWidget*>(); }
    void press(const char* name) const
    {
        QTest::mouseClick(dock->findChild<QToolButton*>(QLatin1String(name)), Qt::LeftButton);
    }
    void clickBox(const QString& text) const
    {
        for (QCheckBox* box : all<QCheckBox>()) {
            if (box->text() == text) {
                box->click();
            }
        }
    }

    ToolController tools;
    std::vector<model::IndividualId> ids;
    model::BrushSettings scale;
};

} // namespace

void StrokesDockTest::theFormChangesTheStroke()
{
    StrokesDesk desk;
    QVERIFY(desk.isReady());
    QCOMPARE(desk.list().count(), 0);
    QVERIFY(desk.paint(desk.scale).isCommitted);
    QTRY_COMPARE(desk.list().count(), 1);
    const int steps = desk.document.undoStack().count();
    QCOMPARE(desk.list().item(0)->text(), desk.document.undoStack().undoText());
    QVERIFY(desk.heights() != std::vector<float>(5, 1.0F));
    desk.clickBox(QStringLiteral("Change the height"));
    QTRY_COMPARE(desk.heights(), std::vector<float>(5, 1.0F));
    QCOMPARE(desk.document.undoStack().count(), steps);
    QCOMPARE(desk.list().count(), 1);
    desk.clickBox(QStringLiteral("Change the height"));
    QTRY_VERIFY(desk.heights() != std::vector<float>(5, 1.0F));
    desk.document.undoStack().undo();
    QTRY_COMPARE(desk.list().count(), 0);
    QCOMPARE(desk.heights(), std::vector<float>(5, 1.0F));
}

void StrokesDockTest::valuesAreDrawnAnew()
{
    StrokesDesk desk;
    QVERIFY(desk.isReady());
    QVERIFY(desk.paint(desk.scale).isCommitted);
    QTRY_COMPARE(desk.list().count(), 1);
    const std::vector<float> before = desk.heights();
    desk.press("reroll");
    QTRY_VERIFY(desk.heights() != before);
    for (const float height : desk.heights()) {
        QVERIFY(height >= 1.5F && height <= 2.0F);
    }
}

void StrokesDockTest::settingsGoToTheBrushAndBack()
{
    StrokesDesk desk;
    QVERIFY(desk.isReady());
    QVERIFY(desk.paint(desk.scale).isCommitted);
    QTRY_COMPARE(desk.list().count(), 1);
    desk.press("to-brush");
    QCOMPARE(desk.state.tool(), toolOf(model::BrushKind::Scale));
    QVERIFY(desk.state.brush(model::BrushKind::Scale) == desk.scale);
    model::BrushSettings other = desk.scale;
    other.as<model::ScaleSettings>().height = {0.5F, 0.6F};
    desk.state.setBrush(other);
    desk.press("from-brush");
    QTRY_VERIFY(desk.heights().front() < 0.7F);
}

void StrokesDockTest::olderOnesAreChosenInTheList()
{
    StrokesDesk desk;
    QVERIFY(desk.isReady());
    model::BrushSettings girth = desk.scale;
    girth.as<model::ScaleSettings>().setsHeight = false;
    girth.as<model::ScaleSettings>().girth = {1.3F, 1.4F};
    QVERIFY(desk.paint(desk.scale).isCommitted);
    QVERIFY(desk.paint(girth).isCommitted);
    QTRY_COMPARE(desk.list().count(), 2);
    QCOMPARE(desk.list().currentRow(), 0);
    const QRect row = desk.list().visualItemRect(desk.list().item(1));
    QTest::mouseClick(desk.list().viewport(), Qt::LeftButton, {}, row.center());
    const auto girths = [&desk] {
        const auto column = desk.document.scene().population.column(model::columns::girth);
        return std::vector<float>(column.begin(), column.end());
    };
    const std::vector<float> before = girths();
    desk.clickBox(QStringLiteral("Change the height"));
    QTRY_COMPARE(desk.heights(), std::vector<float>(5, 1.0F));
    QCOMPARE(desk.list().count(), 2);
    QCOMPARE(desk.list().currentRow(), 1);
    QCOMPARE(girths(), before); // the later stroke is as it was
}

void StrokesDockTest::anotherEditEmptiesTheList()
{
    StrokesDesk desk;
    QVERIFY(desk.isReady());
    QVERIFY(desk.paint(desk.scale).isCommitted);
    QTRY_COMPARE(desk.list().count(), 1);
    (void)testing::addPeople(desk.document, 2);
    QTRY_COMPARE(desk.list().count(), 0);
    QVERIFY(desk.dock->findChild<QLabel*>(QStringLiteral("strokesNote"))->isVisible());
    QVERIFY(!desk.dock->findChild<QToolButton*>(QStringLiteral("reroll"))->isEnabled());
}

CROWD_WINDOW_TEST(StrokesDockTest)
#include "tst_StrokesDock.moc"
