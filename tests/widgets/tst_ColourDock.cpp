// SPDX-License-Identifier: MIT
#include <QtCore/QSettings>
#include <QtCore/QStandardPaths>
#include <QtTest/QTest>
#include <QtWidgets/QLabel>
#include <QtWidgets/QToolButton>

#include "tests/program/WindowTest.h"
#include "tests/widgets/Desk.h"
#include "widgets/docks/ColourDock.h"
#include "widgets/docks/SwatchGrid.h"

using namespace crowd;
using namespace crowd::widgets;
using crowd::testing::type;

namespace {

using ColourDesk = crowd::testing::Desk<ColourDock>;

SwatchGrid* grid(const ColourDesk& desk, const char* name)
{
    return desk.dock->findChild<SwatchGrid*>(QLatin1String(name));
}

void clickCell(SwatchGrid* cells, int index, Qt::MouseButton button = Qt::LeftButton)
{
    QTest::mouseClick(cells, button, {}, cells->cellRect(index).center());
}

const std::vector<model::PaintColor>& brushColors(const ColourDesk& desk)
{
    return desk.state.brush(model::BrushKind::Colour).as<crowd::model::ColourSettings>().colors;
}

void setOperator(ColourDesk& desk, model::BrushOperator op)
{
    model::BrushSettings brush = desk.state.brush(model::BrushKind::Colour);
    brush.op = op;
    desk.state.setBrush(brush);
}

} // namespace

class ColourDockTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void colourEditsTheEndThatIsChosen();
    void greyKeepsTheHueOfTheSquare();
    void swatchesAreRemembered();
    void coloursAreAddedAndRemoved();
    void theMarkedColourPaints();
    void newPeopleHaveColoursOfTheirOwn();
    void strokesAreRememberedAsColours();
    void theDropperTakesColours();
};

void ColourDockTest::initTestCase()
{
    QCoreApplication::setOrganizationName(QStringLiteral("CrowdbrushTest"));
    QCoreApplication::setApplicationName(QStringLiteral("ColourDockTest"));
    QStandardPaths::setTestModeEnabled(true);
    QSettings().clear();
}

void ColourDockTest::colourEditsTheEndThatIsChosen()
{
    ColourDesk desk;
    QVERIFY(desk.isReady());
    desk.state.setTool(ToolId::BrushColour);
    desk.dock->setColor(QColor(10, 20, 30));
    const auto& colors =
        desk.state.brush(model::BrushKind::Colour).as<crowd::model::ColourSettings>().colors;
    QCOMPARE(colors.front(), (model::PaintColor{10, 20, 30}));
    const model::PaintColor last = colors.back();
    QVERIFY(last != colors.front());
    type(*desk.dock->findChild<QLineEdit*>(), QStringLiteral("#ff8000"));
    QCOMPARE(desk.dock->color(), QColor(255, 128, 0));
    QCOMPARE(
        desk.state.brush(model::BrushKind::Colour).as<crowd::model::ColourSettings>().colors.back(),
        last);
}

void ColourDockTest::greyKeepsTheHueOfTheSquare()
{
    ColourDesk desk;
    QVERIFY(desk.isReady());
    desk.dock->setColor(QColor::fromHsv(200, 255, 200));
    desk.dock->setColor(QColor(90, 90, 90));
    QCOMPARE(desk.dock->color(), QColor(90, 90, 90));
    type(*desk.dock->findChild<QLineEdit*>(), QStringLiteral("no colour"));
    QCOMPARE(desk.dock->color(), QColor(90, 90, 90));
}

void ColourDockTest::swatchesAreRemembered()
{
    std::size_t count = 0;
    {
        ColourDesk desk;
        QVERIFY(desk.isReady());
        SwatchGrid* swatches = grid(desk, "swatches");
        count = swatches->colors().size();
        desk.dock->setColor(QColor(1, 2, 3));
        clickCell(swatches, static_cast<int>(count));
        QCOMPARE(swatches->colors().size(), count + 1);
        clickCell(swatches, static_cast<int>(count) + 1);
        QVERIFY2(swatches->colors().size() == count + 1, "a colour is kept once");
    }
    {
        ColourDesk again;
        QVERIFY(again.isReady());
        SwatchGrid* swatches = grid(again, "swatches");
        QCOMPARE(swatches->colors().size(), count + 1);
        again.dock->setColor(QColor(200, 0, 0));
        clickCell(swatches, static_cast<int>(count));
        QCOMPARE(again.dock->color(), QColor(1, 2, 3));
        clickCell(swatches, static_cast<int>(count), Qt::RightButton);
        QCOMPARE(swatches->colors().size(), count);
    }
    ColourDesk last;
    QCOMPARE(grid(last, "swatches")->colors().size(), count);
}

void ColourDockTest::coloursAreAddedAndRemoved()
{
    ColourDesk desk;
    QVERIFY(desk.isReady());
    desk.state.setTool(ToolId::BrushColour);
    setOperator(desk, model::BrushOperator::Random);
    SwatchGrid* chips = grid(desk, "brushColours");
    const auto before = brushColors(desk);
    clickCell(chips, static_cast<int>(before.size()));
    QCOMPARE(brushColors(desk).size(), before.size() + 1);
    desk.dock->setColor(QColor(7, 8, 9));
    QCOMPARE(brushColors(desk).back(), (model::PaintColor{7, 8, 9}));
    QCOMPARE(brushColors(desk).front(), before.front());
    clickCell(chips, static_cast<int>(before.size()), Qt::RightButton);
    QCOMPARE(brushColors(desk), before);
    for (std::size_t i = 0; i < before.size(); ++i) {
        clickCell(chips, 0, Qt::RightButton);
    }
    QVERIFY2(brushColors(desk).size() == 1, "there is always something to paint with");
}

void ColourDockTest::theMarkedColourPaints()
{
    ColourDesk desk;
    QVERIFY(desk.isReady());
    desk.state.setTool(ToolId::BrushColour);
    setOperator(desk, model::BrushOperator::Uniform);
    SwatchGrid* chips = grid(desk, "brushColours");
    const auto before = brushColors(desk);
    QVERIFY(before.size() > 1);
    clickCell(chips, 1);
    QCOMPARE(brushColors(desk).front(), before[1]);
    QCOMPARE(brushColors(desk)[1], before[0]);
    QCOMPARE(desk.dock->color(), QColor(before[1][0], before[1][1], before[1][2]));
    // Where all of them paint, their order is theirs, until only one does again.
    setOperator(desk, model::BrushOperator::Gradient);
    clickCell(chips, 1);
    QCOMPARE(brushColors(desk).front(), before[1]);
    setOperator(desk, model::BrushOperator::Uniform);
    QCOMPARE(desk.dock->color(), QColor(before[1][0], before[1][1], before[1][2]));
}

void ColourDockTest::newPeopleHaveColoursOfTheirOwn()
{
    ColourDesk desk;
    QVERIFY(desk.isReady());
    const auto painted = brushColors(desk);
    const auto* ofWhom = desk.dock->findChild<QLabel*>(QStringLiteral("coloursOfWhom"));
    const QString title = desk.dock->windowTitle();
    desk.state.setTool(ToolId::BrushColour);
    QVERIFY(!ofWhom->isVisible());
    desk.state.setTool(ToolId::BrushCreate);
    QVERIFY(ofWhom->isVisible());
    QCOMPARE(desk.dock->windowTitle(), title); // tabs stay where they are
    SwatchGrid* chips = grid(desk, "brushColours");
    const auto palette = [&] {
        return desk.state.brush(model::BrushKind::Create)
            .as<crowd::model::CreateSettings>()
            .palette;
    };
    QCOMPARE(chips->colors().size(), palette().size());
    for (std::size_t i = palette().size(); i > 0; --i) {
        clickCell(chips, 0, Qt::RightButton);
    }
    QVERIFY2(palette().empty(), "new people may go untinted");
    desk.dock->setColor(QColor(5, 6, 7));
    QCOMPARE(palette(), (std::vector<model::PaintColor>{{5, 6, 7}}));
    QCOMPARE(brushColors(desk), painted);
}

void ColourDockTest::strokesAreRememberedAsColours()
{
    {
        ColourDesk desk;
        QVERIFY(desk.isReady());
        desk.state.setTool(ToolId::BrushColour);
        SwatchGrid* recent = grid(desk, "recentColours");
        QVERIFY(recent->colors().empty());
        desk.dock->setColor(QColor(11, 12, 13));
        QVERIFY2(recent->colors().empty(), "only what was painted with");
        desk.state.noteStroke(model::BrushKind::Colour);
        desk.state.noteStroke(model::BrushKind::Orientation);
        QCOMPARE(recent->colors(), (std::vector<QColor>{QColor(11, 12, 13)}));
        desk.dock->setColor(QColor(21, 22, 23));
        desk.state.noteStroke(model::BrushKind::Colour);
        desk.state.noteStroke(model::BrushKind::Colour);
        QCOMPARE(recent->colors(), (std::vector<QColor>{QColor(21, 22, 23), QColor(11, 12, 13)}));
        clickCell(recent, 1);
        QCOMPARE(desk.dock->color(), QColor(11, 12, 13));
        for (int i = 0; i < 20; ++i) {
            desk.dock->setColor(QColor(100 + i, 0, 0));
            desk.state.noteStroke(model::BrushKind::Colour);
        }
        QCOMPARE(recent->colors().front(), QColor(119, 0, 0));
        QVERIFY2(recent->colors().size() < 10, "one row of them");
    }
    ColourDesk again;
    QCOMPARE(grid(again, "recentColours")->colors().front(), QColor(119, 0, 0));
}

void ColourDockTest::theDropperTakesColours()
{
    ColourDesk desk;
    QVERIFY(desk.isReady());
    desk.state.setTool(ToolId::Select);
    auto* dropper = desk.dock->findChild<QToolButton*>();
    QVERIFY(dropper->isCheckable() && !dropper->isChecked());
    QTest::mouseClick(dropper, Qt::LeftButton);
    QVERIFY2(desk.state.tool() == ToolId::BrushColour, "a brush that has colours");
    QVERIFY(desk.state.picking() == Picking::Colour);
    desk.state.offerColor({31, 32, 33});
    QCOMPARE(desk.dock->color(), QColor(31, 32, 33));
    QTest::mouseClick(dropper, Qt::LeftButton);
    QVERIFY(desk.state.picking() == Picking::None);
    QVERIFY(!dropper->isChecked());
}

CROWD_WINDOW_TEST(ColourDockTest)
#include "tst_ColourDock.moc"
