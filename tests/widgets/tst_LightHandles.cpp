// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <QtTest/QTest>

#include <glm/geometric.hpp>

#include "model/scene/LightAim.h"
#include "tests/program/Test.h"
#include "tests/widgets/Hand.h"
#include "widgets/commands/LightCommands.h"
#include "widgets/viewport/LightMarks.h"

using namespace crowd;
using namespace crowd::widgets;
using crowd::testing::Hand;

namespace {

/// Somebody who has a spotlight in the picture.
struct LightHand : Hand
{
    LightHand()
    {
        state.setTool(ToolId::Select);
        id = addLight(state, model::LightKind::Spot, {0.5F, 0.0F, 5.0F});
        changeLight(state, id, QStringLiteral("Hang it lower"), [](model::Light& light) {
            light.position = {-1.5F, 2.0F, 4.0F};
        });
        steps = document.undoStack().count();
    }
    [[nodiscard]] const model::Light& light() const { return document.scene().lights.front(); }

    model::LightId id = 0;
    int steps = 0;
};

} // namespace

/// Lights taken hold of in the picture.
class TestLightHandles : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aClickPlacesASpotlight();
    void theLampMovesAtItsHeight();
    void atTheHeightOfTheEyeItGoesAside();
    void shiftMovesItUpAndDown();
    void theTargetGoesOverTheGround();
    void controlLetsItGoWithSomebody();
    void theEdgeOfTheConeOpensIt();
    void aClickOnALampChoosesIt();
    void escapeTakesADragBack();
    void handlesAreThereWhileOneIsChosen();
    void namesAreTheirOwn();
};

void TestLightHandles::aClickPlacesASpotlight()
{
    Hand hand;
    hand.state.choosePoint(
        [&hand](const glm::vec3& point) { addLight(hand.state, model::LightKind::Spot, point); });
    hand.press(crowd::testing::kCenter);
    hand.release(crowd::testing::kCenter);
    const model::Lights& lights = hand.document.scene().lights;
    QCOMPARE(lights.size(), std::size_t{1});
    QCOMPARE(hand.state.chosenLight(), lights[0].id);
    // Turned to what was clicked, from the side of whoever looks.
    const QPointF target = hand.pixelOf(lights[0].target);
    QVERIFY((target - crowd::testing::kCenter).manhattanLength() < 60.0);
    QVERIFY(lights[0].position.y > lights[0].target.y + 0.5F);
    const glm::vec3 eye = hand.state.camera().position;
    QVERIFY(glm::distance(eye, lights[0].position) < glm::distance(eye, lights[0].target));
    hand.document.undoStack().undo();
    QVERIFY(hand.document.scene().lights.empty());
    QCOMPARE(hand.state.chosenLight(), model::LightId{0});
}

void TestLightHandles::theLampMovesAtItsHeight()
{
    LightHand hand;
    const QPointF from = hand.pixelOf(hand.light().position);
    const QPointF to = from + QPointF(60.0, 20.0);
    hand.drag(from, to);
    QCOMPARE(hand.document.undoStack().count(), hand.steps + 1);
    QVERIFY(std::abs(hand.light().position.y - 2.0F) < 1e-4F);
    QVERIFY(hand.light().position.x > -1.5F);
    QVERIFY((hand.pixelOf(hand.light().position) - to).manhattanLength() < 3.0);
}

/// No ray meets the level of the lamp anywhere near; what the drag says of its height is not known.
void TestLightHandles::atTheHeightOfTheEyeItGoesAside()
{
    LightHand hand;
    const model::Camera& camera = hand.state.camera();
    const glm::vec3 ahead = glm::normalize(glm::vec3(camera.forward().x, 0, camera.forward().z));
    const glm::vec3 before = camera.position + 6.0F * ahead;
    changeLight(hand.state, hand.id, QStringLiteral("To the eye"),
                [&](model::Light& light) { light.position = before; });
    const QPointF from = hand.pixelOf(before);
    hand.drag(from, from + QPointF(50.0, -8.0));
    const glm::vec3 way = hand.light().position - before;
    QVERIFY2(glm::dot(way, camera.right()) > 0.2F, qPrintable(QString::number(way.x)));
    QVERIFY(std::abs(way.y) < 1e-4F && std::abs(glm::dot(way, ahead)) < 1e-3F);
    QVERIFY(std::abs(hand.pixelOf(hand.light().position).x() - from.x() - 50.0) < 3.0);
}

void TestLightHandles::shiftMovesItUpAndDown()
{
    LightHand hand;
    const QPointF from = hand.pixelOf(hand.light().position);
    hand.modifiers = Qt::ShiftModifier;
    hand.drag(from, from - QPointF(0.0, 50.0));
    QVERIFY(hand.light().position.y > 2.2F);
    QCOMPARE(hand.light().position.x, -1.5F);
    QCOMPARE(hand.light().position.z, 4.0F);
}

void TestLightHandles::theTargetGoesOverTheGround()
{
    LightHand hand;
    const QPointF from = hand.pixelOf(hand.light().target);
    hand.drag(from, from + QPointF(40.0, 30.0));
    QCOMPARE(hand.document.undoStack().count(), hand.steps + 1);
    QVERIFY((hand.pixelOf(hand.light().target) - from - QPointF(40.0, 30.0)).manhattanLength() <
            3.0);
    QVERIFY((hand.light().position == glm::vec3(-1.5F, 2.0F, 4.0F)));
    QVERIFY(std::abs(hand.light().target.y) < 0.2F);
}

void TestLightHandles::controlLetsItGoWithSomebody()
{
    LightHand hand;
    model::IndividualId man = 0;
    hand.document.edit(QStringLiteral("Add"), [&](model::SceneEdit& edit) {
        auto rows = model::IndividualRows::withDefaults({0});
        rows.column(model::columns::templateId)[0] = hand.document.scene().templates.front().id;
        rows.column(model::columns::position)[0] = {1.2F, 0.05F, 6.0F};
        man = edit.addIndividuals(std::move(rows)).front();
    });
    const QPointF from = hand.pixelOf(hand.light().target);
    hand.modifiers = Qt::ControlModifier;
    hand.drag(from, hand.pixelOf(man));
    QVERIFY(hand.light().aim == model::LightAim::Person);
    QCOMPARE(hand.light().person, man);
    // And back to a place, from where it is seen on him.
    hand.modifiers = Qt::NoModifier;
    hand.drag(hand.pixelOf(man), hand.pixelOf(man) + QPointF(0.0, 90.0));
    QVERIFY(hand.light().aim == model::LightAim::Place);
}

void TestLightHandles::theEdgeOfTheConeOpensIt()
{
    LightHand hand;
    const auto edge = [&hand] {
        return hand.pixelOf(
            coneEdge(hand.light(), hand.light().target, hand.state.camera().right()));
    };
    const float before = hand.light().coneRadians;
    const QPointF middle = hand.pixelOf(hand.light().target);
    const QPointF from = edge();
    QVERIFY((from - middle).manhattanLength() > 20.0);
    const QPointF to = middle + 1.5 * (from - middle);
    hand.drag(from, to);
    QCOMPARE(hand.document.undoStack().count(), hand.steps + 1);
    QVERIFY2(hand.light().coneRadians > 1.3F * before,
             qPrintable(QString::number(hand.light().coneRadians)));
    QVERIFY((edge() - to).manhattanLength() < 4.0);
    hand.drag(edge(), middle); // as narrow as can be, not closed
    QVERIFY(hand.light().coneRadians > 0.01F && hand.light().coneRadians < before);
    hand.document.undoStack().undo();
    hand.document.undoStack().undo();
    QCOMPARE(hand.light().coneRadians, before);
    // One that shines to all sides has none.
    changeLight(hand.state, hand.id, QStringLiteral("To all sides"),
                [](model::Light& light) { light.kind = model::LightKind::Point; });
    const int steps = hand.document.undoStack().count();
    hand.drag(from, to);
    QCOMPARE(hand.document.undoStack().count(), steps);
}

void TestLightHandles::aClickOnALampChoosesIt()
{
    LightHand hand;
    const model::LightId other = addLight(hand.state, model::LightKind::Point, {1.5F, 0.0F, 5.0F});
    QCOMPARE(hand.state.chosenLight(), other);
    const QPointF lamp = hand.pixelOf(hand.light().position);
    hand.press(lamp);
    hand.release(lamp);
    QCOMPARE(hand.state.chosenLight(), hand.id);
}

void TestLightHandles::escapeTakesADragBack()
{
    LightHand hand;
    const glm::vec3 before = hand.light().position;
    const QPointF from = hand.pixelOf(before);
    hand.press(from);
    hand.move(from + QPointF(80.0, 0.0));
    QVERIFY(hand.light().position != before); // seen meanwhile
    hand.key(Qt::Key_Escape);
    QVERIFY(hand.light().position == before);
    QCOMPARE(hand.document.undoStack().count(), hand.steps);
}

void TestLightHandles::handlesAreThereWhileOneIsChosen()
{
    LightHand hand;
    LightMarks marks;
    marks.make(hand.state, *hand.state.frame());
    const auto isDark = [](const auto& line) { return line.color.r < 0.1F; };
    QVERIFY(std::ranges::any_of(marks.lines(), isDark)); // a rim, on a bright sky
    QVERIFY(!std::ranges::all_of(marks.lines(), isDark));
    hand.state.chooseLight(0);
    marks.make(hand.state, *hand.state.frame());
    QVERIFY(marks.lines().empty());
    const QPointF from = hand.pixelOf(hand.light().position);
    hand.drag(from, from + QPointF(60.0, 20.0)); // selects an area instead
    QVERIFY((hand.light().position == glm::vec3(-1.5F, 2.0F, 4.0F)));
}

void TestLightHandles::namesAreTheirOwn()
{
    LightHand hand;
    addLight(hand.state, model::LightKind::Spot, {});
    const model::Lights& lights = hand.document.scene().lights;
    QVERIFY(lights[0].name != lights[1].name && !lights[1].name.empty());
    removeLight(hand.state, lights[0].id);
    QCOMPARE(lights.size(), std::size_t{1});
    addLight(hand.state, model::LightKind::Spot, {});
    QVERIFY(lights[0].name != lights[1].name);
}

CROWD_TEST(TestLightHandles)
#include "tst_LightHandles.moc"
