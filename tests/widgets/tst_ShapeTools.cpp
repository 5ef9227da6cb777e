// SPDX-License-Identifier: MIT
#include <cmath>

#include <QtCore/QLineF>
#include <QtTest/QSignalSpy>
#include <QtTest/QTest>

#include "model/scene/PlaceShape.h"
#include "tests/program/Test.h"
#include "tests/widgets/Hand.h"

using namespace crowd;
using namespace crowd::widgets;
using model::PlaceShape;
using testing::Hand;

namespace {

/// Open ground from above, with the environment brush in hand.
struct Lawn : Hand
{
    explicit Lawn(PlaceShape shape)
    {
        document.replaceScene(model::Scene(), {});
        state.setCamera(model::Camera::lookingAt({0.0F, 40.0F, 0.1F}, {0.0F, 0.0F, 0.0F}));
        state.setTool(ToolId::BrushEnvironment);
        model::BrushSettings brush = state.brush(model::BrushKind::Environment);
        brush.as<model::EnvironmentSettings>().shape = shape;
        state.setBrush(brush);
    }
    [[nodiscard]] QPointF on(float x, float z) const { return pixelOf(glm::vec3(x, 0.0F, z)); }
    void click(float x, float z)
    {
        letTimePass(1.0);
        press(on(x, z));
        release(on(x, z));
    }
    void clickAgain(float x, float z) { Hand::clickAgain(on(x, z)); }
    [[nodiscard]] const std::vector<model::Place>& places() const
    {
        return document.scene().places;
    }
    [[nodiscard]] std::size_t cornersOfLast() const { return places().back().corners.size(); }
};

} // namespace

/// Lines and areas of the environment, drawn and changed by hand.
class TestShapeTools : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void clicksMakeALine();
    void clicksMakeAnArea();
    void anAreaOfTwoCornersIsSaidToBeALine();
    void aLineIsClosedWhereItBegan();
    void eachClickIsOneStep();
    void aDragDrawsFreely();
    void whatIsDrawnIsShown();
    void theNextOneBeginsElsewhere();
    void aSingleCornerGoes();
    void cornersAreMoved();
    void cornersComeAndGo();
    void theWholeIsMoved();
    void keysChangeTheWidth();
    void whatIsTooFarAwayIsSaid();
};

void TestShapeTools::clicksMakeALine()
{
    Lawn lawn(PlaceShape::Line);
    lawn.click(-5.0F, 0.0F);
    lawn.click(5.0F, 0.0F);
    lawn.click(5.0F, 4.0F);
    lawn.key(Qt::Key_Return);
    lawn.click(-6.0F, 8.0F);
    QCOMPARE(lawn.places().size(), std::size_t{2});
    const model::Place& wall = lawn.places().front();
    QCOMPARE(wall.shape, PlaceShape::Line);
    QCOMPARE(wall.role, model::PlaceRole::Obstacle);
    QCOMPARE(wall.corners.size(), std::size_t{3});
    QCOMPARE(wall.radius, 0.15F);
    QVERIFY(model::isWithin(wall, {0.0F, 0.0F, 0.0F}));
    QVERIFY(model::isWithin(wall, {5.0F, 0.0F, 3.5F}));
    QVERIFY(!model::isWithin(wall, {0.0F, 0.0F, 2.0F}));
    QVERIFY(!wall.name.empty());
}

void TestShapeTools::clicksMakeAnArea()
{
    Lawn lawn(PlaceShape::Area);
    lawn.click(-5.0F, -3.0F);
    lawn.click(5.0F, -3.0F);
    QCOMPARE(lawn.places().back().shape, PlaceShape::Line); // it has no inside yet
    lawn.click(5.0F, 3.0F);
    lawn.click(-5.0F, 3.0F);
    lawn.click(-5.0F, -3.0F); // where it began
    lawn.click(0.0F, 8.0F);
    QCOMPARE(lawn.places().size(), std::size_t{2});
    const model::Place& area = lawn.places().front();
    QCOMPARE(area.shape, PlaceShape::Area);
    QCOMPARE(area.corners.size(), std::size_t{4});
    QVERIFY(std::abs(model::areaOf(area) - 60.0F) < 3.0F);
}

void TestShapeTools::anAreaOfTwoCornersIsSaidToBeALine()
{
    for (const PlaceShape shape : {PlaceShape::Area, PlaceShape::Line}) {
        Lawn lawn(shape);
        QString said;
        QObject::connect(&lawn.state, &EditorState::statusMessage,
                         [&said](const QString& text) { said = text; });
        lawn.click(-5.0F, -3.0F);
        lawn.click(5.0F, -3.0F);
        lawn.key(Qt::Key_Escape);
        QCOMPARE(lawn.places().back().shape, PlaceShape::Line);
        QCOMPARE(said.contains(QStringLiteral("three")), shape == PlaceShape::Area);
    }
}

void TestShapeTools::aLineIsClosedWhereItBegan()
{
    Lawn lawn(PlaceShape::Line);
    lawn.click(-5.0F, -3.0F);
    lawn.click(5.0F, -3.0F);
    lawn.click(0.0F, 4.0F);
    lawn.click(-5.0F, -3.0F);
    QCOMPARE(lawn.places().size(), std::size_t{1});
    const model::Place& fence = lawn.places().front();
    QCOMPARE(fence.shape, PlaceShape::Line);
    QCOMPARE(fence.corners.size(), std::size_t{4});
    QVERIFY(fence.corners.front() == fence.corners.back());
    QVERIFY(!model::isWithin(fence, {0.0F, 0.0F, 0.0F})); // one can be in it
    QCOMPARE(lawn.state.paths().shaped(), model::PlaceId{0});
}

void TestShapeTools::eachClickIsOneStep()
{
    Lawn lawn(PlaceShape::Area);
    lawn.click(-5.0F, -3.0F);
    lawn.click(5.0F, -3.0F);
    lawn.click(5.0F, 3.0F);
    lawn.document.undoStack().undo();
    QCOMPARE(lawn.cornersOfLast(), std::size_t{2});
    lawn.click(0.0F, 5.0F); // goes on from there
    QCOMPARE(lawn.places().size(), std::size_t{1});
    QCOMPARE(lawn.cornersOfLast(), std::size_t{3});
    for (int i = 0; i < 3; ++i) {
        lawn.document.undoStack().undo();
    }
    QVERIFY(lawn.places().empty());
    lawn.click(0.0F, 5.0F); // another one: the first is gone
    QCOMPARE(lawn.places().size(), std::size_t{1});
}

void TestShapeTools::aDragDrawsFreely()
{
    Lawn lawn(PlaceShape::Area);
    const int before = lawn.document.undoStack().count();
    lawn.press(lawn.on(6.0F, 0.0F));
    for (int i = 1; i <= 60; ++i) {
        const float angle = 6.0F * static_cast<float>(i) / 60.0F;
        lawn.move(lawn.on(6.0F * std::cos(angle), 6.0F * std::sin(angle)));
    }
    lawn.release(lawn.on(6.0F * std::cos(6.0F), 6.0F * std::sin(6.0F)));
    QCOMPARE(lawn.places().size(), std::size_t{1});
    const model::Place& disc = lawn.places().front();
    QCOMPARE(disc.shape, PlaceShape::Area);
    QVERIFY2(disc.corners.size() > 8 && disc.corners.size() < 40,
             QByteArray::number(static_cast<int>(disc.corners.size())));
    QVERIFY(std::abs(model::areaOf(disc) - 113.0F) < 8.0F);
    QCOMPARE(lawn.document.undoStack().count(), before + 1);
    QCOMPARE(lawn.state.paths().shaped(), model::PlaceId{0}); // that was all of it
    lawn.document.undoStack().undo();
    QVERIFY(lawn.places().empty());
}

void TestShapeTools::whatIsDrawnIsShown()
{
    Lawn lawn(PlaceShape::Line);
    lawn.click(-5.0F, 0.0F);
    lawn.hover(lawn.on(5.0F, 0.0F));
    const ToolPicture side = lawn.tools.picture();
    QVERIFY(side.arrow.has_value());
    QVERIFY(QLineF(side.arrow->p1(), lawn.on(-5.0F, 0.0F)).length() < 2.0);
    QVERIFY2(side.label.startsWith(QStringLiteral("10")), qPrintable(side.label));
    lawn.click(5.0F, 0.0F);
    lawn.click(0.0F, 5.0F);
    lawn.hover(lawn.on(-5.0F, 0.0F));
    QVERIFY(lawn.tools.picture().label.contains(QStringLiteral("Close")));
    QVERIFY(lawn.state.hint().contains(QStringLiteral("corner")));
    lawn.key(Qt::Key_Return);
    lawn.hover(lawn.on(5.0F, 0.0F));
    QVERIFY(!lawn.tools.picture().arrow.has_value());
    lawn.press(lawn.on(0.0F, -5.0F));
    lawn.move(lawn.on(2.0F, -5.0F));
    lawn.move(lawn.on(4.0F, -6.0F));
    QVERIFY(!lawn.tools.picture().outlines.empty());
    lawn.release(lawn.on(4.0F, -6.0F));
}

void TestShapeTools::theNextOneBeginsElsewhere()
{
    Lawn lawn(PlaceShape::Line);
    lawn.click(-5.0F, 0.0F);
    lawn.click(5.0F, 0.0F);
    lawn.clickAgain(5.0F, 0.0F); // a double click ends it
    lawn.click(0.0F, 5.0F);
    QCOMPARE(lawn.places().size(), std::size_t{2});
    lawn.click(0.0F, 7.0F);
    model::BrushSettings brush = lawn.state.brush(model::BrushKind::Environment);
    brush.as<model::EnvironmentSettings>().role = model::PlaceRole::Slow;
    lawn.state.setBrush(brush);
    lawn.click(3.0F, 7.0F); // of another kind
    QCOMPARE(lawn.places().size(), std::size_t{3});
    QCOMPARE(lawn.places().back().role, model::PlaceRole::Slow);
}

/// As a path of one place does.
void TestShapeTools::aSingleCornerGoes()
{
    Lawn lawn(PlaceShape::Line);
    lawn.click(-5.0F, 0.0F);
    lawn.key(Qt::Key_Return);
    QVERIFY(lawn.places().empty());
    lawn.document.undoStack().undo();
    QCOMPARE(lawn.places().size(), std::size_t{1});
    lawn.document.undoStack().undo();
    lawn.click(-5.0F, 0.0F);
    lawn.clickAgain(-5.0F, 0.0F);
    QVERIFY(lawn.places().empty());
    // Closed by a double click nothing begins there.
    lawn.click(-5.0F, -3.0F);
    lawn.click(5.0F, -3.0F);
    lawn.click(0.0F, 4.0F);
    lawn.click(-5.0F, -3.0F);
    lawn.clickAgain(-5.0F, -3.0F);
    QCOMPARE(lawn.places().size(), std::size_t{1});
    QCOMPARE(lawn.cornersOfLast(), std::size_t{4});
}

void TestShapeTools::cornersAreMoved()
{
    Lawn lawn(PlaceShape::Line);
    lawn.click(-5.0F, -3.0F);
    lawn.click(5.0F, -3.0F);
    lawn.click(0.0F, 4.0F);
    lawn.click(-5.0F, -3.0F);
    lawn.key(Qt::Key_Escape);
    lawn.state.setTool(ToolId::Select);
    lawn.drag(lawn.on(0.0F, 4.0F), lawn.on(0.0F, 8.0F));
    const auto corners = [&] { return model::cornersOf(lawn.places().front()); };
    QVERIFY(glm::distance(corners()[2], glm::vec3(0.0F, 0.0F, 8.0F)) < 0.3F);
    QVERIFY(glm::distance(corners()[0], glm::vec3(-5.0F, 0.0F, -3.0F)) < 0.3F);
    lawn.drag(lawn.on(-5.0F, -3.0F), lawn.on(-8.0F, -3.0F)); // stays closed
    QVERIFY(corners().front() == corners().back());
    QVERIFY(glm::distance(corners().front(), glm::vec3(-8.0F, 0.0F, -3.0F)) < 0.3F);
    lawn.document.undoStack().undo();
    lawn.document.undoStack().undo();
    QVERIFY(glm::distance(corners()[2], glm::vec3(0.0F, 0.0F, 4.0F)) < 0.3F);
}

void TestShapeTools::cornersComeAndGo()
{
    Lawn lawn(PlaceShape::Area);
    lawn.click(-6.0F, -4.0F);
    lawn.click(6.0F, -4.0F);
    lawn.click(0.0F, 6.0F);
    lawn.key(Qt::Key_Escape);
    lawn.state.setTool(ToolId::Select);
    lawn.click(2.0F, -4.0F);
    lawn.clickAgain(2.0F, -4.0F);
    QCOMPARE(lawn.cornersOfLast(), std::size_t{4});
    QVERIFY(glm::distance(model::cornersOf(lawn.places().back())[1], glm::vec3(2.0F, 0.0F, -4.0F)) <
            0.3F);
    lawn.click(2.0F, -4.0F);
    lawn.clickAgain(2.0F, -4.0F);
    QCOMPARE(lawn.cornersOfLast(), std::size_t{3});
    const QSignalSpy said(&lawn.state, &EditorState::statusMessage);
    lawn.click(0.0F, 6.0F);
    lawn.clickAgain(0.0F, 6.0F);
    QCOMPARE(lawn.cornersOfLast(), std::size_t{3});
    QVERIFY(said.last().front().toString().contains(QStringLiteral("three")));
}

void TestShapeTools::theWholeIsMoved()
{
    Lawn lawn(PlaceShape::Line);
    lawn.click(-6.0F, 0.0F);
    lawn.click(6.0F, 0.0F);
    lawn.key(Qt::Key_Escape);
    lawn.state.setTool(ToolId::Select);
    lawn.drag(lawn.on(3.0F, 0.0F), lawn.on(3.0F, 5.0F)); // by its side
    const std::vector<glm::vec3> corners = model::cornersOf(lawn.places().front());
    QVERIFY(glm::distance(corners[0], glm::vec3(-6.0F, 0.0F, 5.0F)) < 0.4F);
    QVERIFY(glm::distance(corners[1], glm::vec3(6.0F, 0.0F, 5.0F)) < 0.4F);
    lawn.click(3.0F, 5.0F);
    QCOMPARE(lawn.state.paths().places(), std::vector{lawn.places().front().id});
    lawn.key(Qt::Key_Delete);
    QVERIFY(lawn.places().empty());
}

void TestShapeTools::keysChangeTheWidth()
{
    Lawn lawn(PlaceShape::Line);
    const auto width = [&] {
        return lawn.state.brush(model::BrushKind::Environment)
            .as<model::EnvironmentSettings>()
            .widthMetres;
    };
    const float before = width();
    lawn.key(Qt::Key_Plus);
    QVERIFY(width() > before);
    lawn.click(0.0F, 0.0F);
    QCOMPARE(lawn.places().back().radius, 0.5F * width());
    // As far and in the same word when it is chosen.
    lawn.click(4.0F, 0.0F);
    lawn.key(Qt::Key_Return);
    const float painted = width();
    lawn.key(Qt::Key_Plus);
    const float more = width() - painted;
    lawn.state.setTool(ToolId::Select);
    lawn.click(2.0F, 0.0F);
    const QSignalSpy said(&lawn.state, &EditorState::statusMessage);
    lawn.key(Qt::Key_Plus);
    QVERIFY(std::abs(2.0F * lawn.places().back().radius - painted - more) < 1e-4F);
    QVERIFY(said.last().front().toString().startsWith(QStringLiteral("Width")));
}

void TestShapeTools::whatIsTooFarAwayIsSaid()
{
    Lawn lawn(PlaceShape::Line);
    lawn.click(0.0F, 0.0F);
    lawn.click(1.0F, 0.0F);
    lawn.state.setCamera(
        model::Camera::lookingAt({60'000.0F, 40.0F, 0.1F}, {60'000.0F, 0.0F, 0.0F}));
    const QSignalSpy said(&lawn.state, &EditorState::statusMessage);
    lawn.click(60'000.0F, 0.0F);
    QCOMPARE(lawn.cornersOfLast(), std::size_t{2});
    QVERIFY(said.last().front().toString().contains(QStringLiteral("too far")));
}

CROWD_TEST(TestShapeTools)
#include "tst_ShapeTools.moc"
