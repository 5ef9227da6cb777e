// SPDX-License-Identifier: MIT
#include <memory>

#include <QtCore/QRegularExpression>
#include <QtTest/QSignalSpy>
#include <QtTest/QTest>

#include "tests/behavior/BoxStage.h"
#include "tests/program/Test.h"
#include "tests/widgets/Hand.h"
#include "widgets/commands/SelectionCommands.h"

using namespace crowd;
using namespace crowd::widgets;
using testing::Hand;
using testing::kCenter;

namespace {

/// From above on a block 4 m square and 3 m high at the origin, with a hand that holds a brush.
struct Plaza : Hand
{
    Plaza()
    {
        model::Scene scene = testing::smallTheatre();
        model::StageMesh mesh;
        testing::addBox(mesh, {-2.0F, 0.0F, -2.0F}, {2.0F, 3.0F, 2.0F});
        testing::addBox(mesh, {-20.0F, 0.0F, -20.0F}, {-19.0F, 3.0F, -19.0F});
        scene.stages = {testing::stageOf(mesh)};
        document.replaceScene(std::move(scene), {});
        state.setCamera(model::Camera::lookingAt({0.0F, 30.0F, 0.1F}, {0.0F, 0.0F, 0.0F}));
        model::BrushSettings create = state.brush(model::BrushKind::Create);
        create.selection = model::BrushSelection::Point;
        create.as<crowd::model::CreateSettings>().mix = {
            {document.scene().templates.front().id, 1.0F}};
        state.setBrush(create);
        statuses = std::make_unique<QSignalSpy>(&state, &EditorState::statusMessage);
    }
    void setAnywhere(bool isAnywhere)
    {
        for (const model::BrushKind kind :
             {model::BrushKind::Create, model::BrushKind::Path, model::BrushKind::Environment}) {
            model::BrushSettings settings = state.brush(kind);
            if (auto* place = settings.place()) {
                place->anywhere = isAnywhere;
            } else {
                settings.as<crowd::model::CreateSettings>().anywhere = isAnywhere;
            }
            state.setBrush(settings);
        }
    }
    [[nodiscard]] std::size_t people() const { return document.scene().population.size(); }
    void click(const glm::vec3& point)
    {
        press(pixelOf(point));
        release(pixelOf(point));
    }
    [[nodiscard]] QString said() const
    {
        return statuses->isEmpty() ? QString() : statuses->last().front().toString();
    }

    std::unique_ptr<QSignalSpy> statuses;
};

const glm::vec3 kRoof(0.0F, 3.0F, 0.0F);
const glm::vec3 kStreet(5.0F, 0.0F, 0.0F);

} // namespace

class TestGroundTools : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void nobodyIsCreatedWhereNobodyCanWalk();
    void noPlaceComesWhereNobodyCanWalk();
    void noPlaceIsDraggedWhereNobodyCanWalk_data();
    void noPlaceIsDraggedWhereNobodyCanWalk();
    void whoIsOnARoofComesDown();
    void anotherStageHasAnotherGround();
    void whatWasRefusedIsForgottenWithTheNextClick();
    void whatIsBetweenTwoPlacesIsSaid();
    void placesHaveRoomForOne();
    void findingIsTold();
};

void TestGroundTools::nobodyIsCreatedWhereNobodyCanWalk()
{
    Plaza plaza;
    plaza.state.setTool(ToolId::BrushCreate);
    const std::size_t before = plaza.people();
    plaza.click(kRoof);
    QCOMPARE(plaza.people(), before);
    QVERIFY2(plaza.said().contains(QStringLiteral("Anywhere")), qPrintable(plaza.said()));
    plaza.click(kStreet);
    QCOMPARE(plaza.people(), before + 1);
    plaza.setAnywhere(true);
    plaza.click(kRoof);
    QCOMPARE(plaza.people(), before + 2);
}

void TestGroundTools::noPlaceComesWhereNobodyCanWalk()
{
    Plaza plaza;
    plaza.state.setTool(ToolId::BrushPath);
    plaza.click(kRoof);
    QVERIFY(plaza.document.scene().places.empty());
    QVERIFY2(plaza.said().contains(QStringLiteral("Anywhere")), qPrintable(plaza.said()));
    plaza.click(kStreet);
    QCOMPARE(plaza.document.scene().places.size(), std::size_t{1});
    plaza.setAnywhere(true);
    plaza.click(kRoof);
    QCOMPARE(plaza.document.scene().places.size(), std::size_t{2});
    QVERIFY(plaza.document.scene().places.back().position.y > 2.9F);
}

void TestGroundTools::noPlaceIsDraggedWhereNobodyCanWalk_data()
{
    QTest::addColumn<model::PlaceRole>("role");
    QTest::newRow("a place of a path") << model::PlaceRole::Spot;
    QTest::newRow("an attractor") << model::PlaceRole::Attractor;
}

void TestGroundTools::noPlaceIsDraggedWhereNobodyCanWalk()
{
    QFETCH(model::PlaceRole, role);
    Plaza plaza;
    {
        const auto edit = plaza.document.beginEdit().value();
        model::Place place;
        place.position = kStreet;
        place.role = role;
        edit->addPlace(place);
        edit->commit(QStringLiteral("Place"));
    }
    const auto place = [&plaza] { return plaza.document.scene().places.front().position; };
    plaza.state.setTool(ToolId::Select);
    plaza.drag(plaza.pixelOf(kStreet), plaza.pixelOf(kRoof));
    QVERIFY2(plaza.said().contains(QStringLiteral("Anywhere")), qPrintable(plaza.said()));
    QVERIFY2(place().y < 0.1F && place().x > 1.9F, "where it could still go");
    plaza.drag(plaza.pixelOf(place()), plaza.pixelOf({0.0F, 0.0F, 5.0F}));
    QVERIFY2(place().z > 4.5F, "around the corner");
    plaza.setAnywhere(true);
    plaza.drag(plaza.pixelOf(place()), plaza.pixelOf(kRoof));
    QVERIFY(place().y > 2.9F);
}

void TestGroundTools::whoIsOnARoofComesDown()
{
    Plaza plaza;
    plaza.state.setTool(ToolId::BrushCreate);
    plaza.setAnywhere(true);
    plaza.click(kRoof);
    const auto height = [&plaza] {
        return plaza.document.scene().population.column(model::columns::position).back().y;
    };
    QVERIFY(height() > 2.9F);
    putSelectionOnGround(plaza.state);
    QCOMPARE(height(), 0.0F);
    const int steps = plaza.document.undoStack().count();
    putSelectionOnGround(plaza.state); // nobody is left
    QCOMPARE(plaza.document.undoStack().count(), steps);
    plaza.document.undoStack().undo();
    QVERIFY(height() > 2.9F);
}

void TestGroundTools::anotherStageHasAnotherGround()
{
    Plaza plaza;
    plaza.state.setTool(ToolId::BrushCreate);
    plaza.click(kStreet);
    const std::size_t before = plaza.people();
    model::Scene scene = plaza.document.scene();
    scene.stages.front().position = {5.0F, 0.0F, 0.0F}; // the block goes to where the street was
    plaza.document.replaceScene(std::move(scene), {});
    plaza.click({5.0F, 3.0F, 0.0F});
    QCOMPARE(plaza.people(), before);
    plaza.click({0.0F, 0.0F, 0.0F});
    QCOMPARE(plaza.people(), before + 1);
}

void TestGroundTools::whatWasRefusedIsForgottenWithTheNextClick()
{
    Plaza plaza;
    for (const ToolId tool : {ToolId::BrushPath, ToolId::BrushEnvironment}) {
        plaza.state.setTool(tool);
        plaza.click(kRoof);
        QVERIFY(!plaza.said().isEmpty());
        plaza.click(kStreet);
        QCOMPARE(plaza.said(), QString());
    }
}

void TestGroundTools::whatIsBetweenTwoPlacesIsSaid()
{
    Plaza plaza;
    model::Scene scene = plaza.document.scene();
    model::StageMesh mesh;
    testing::addBox(mesh, {-0.5F, 0.0F, -30.0F}, {0.5F, 3.0F, 30.0F}); // a long wall
    scene.stages = {testing::stageOf(mesh)};
    plaza.document.replaceScene(std::move(scene), {});
    plaza.state.setTool(ToolId::BrushPath);
    plaza.click({4.0F, 0.0F, 0.0F});
    plaza.click({4.0F, 0.0F, 5.0F});
    QCOMPARE(plaza.said(), QString());
    plaza.click({-4.0F, 0.0F, 5.0F});
    const QRegularExpression around(QStringLiteral("in between.* (\\d+) m around"));
    const QRegularExpressionMatch match = around.match(plaza.said());
    QVERIFY2(match.hasMatch(), qPrintable(plaza.said()));
    QVERIFY2(match.captured(1).toInt() > 50 && match.captured(1).toInt() < 60,
             qPrintable(plaza.said()));
    plaza.setAnywhere(true);
    plaza.click({0.0F, 3.0F, 0.0F});
    QVERIFY2(plaza.said().contains(QStringLiteral("No way leads there")), qPrintable(plaza.said()));
    QCOMPARE(plaza.document.scene().places.size(), std::size_t{4}); // it is the artist's will
}

void TestGroundTools::placesHaveRoomForOne()
{
    Plaza plaza;
    plaza.state.setTool(ToolId::BrushPath);
    for (int i = 0; i < 40; ++i) {
        plaza.key(Qt::Key_Minus);
    }
    plaza.click(kStreet);
    QCOMPARE(plaza.document.scene().places.front().radius, 0.25F);
}

void TestGroundTools::findingIsTold()
{
    Plaza plaza;
    QSignalSpy told(&plaza.state.ground(), &GroundFinder::findingChanged);
    QVERIFY(!plaza.state.ground().isFinding());
    (void)plaza.state.ground().soon();
    QVERIFY(plaza.state.ground().isFinding());
    QCOMPARE(told.count(), 1);
    QVERIFY(told.first().front().toBool());
    QTRY_COMPARE(told.count(), 2);
    QVERIFY(!told.last().front().toBool() && !plaza.state.ground().isFinding());
    QVERIFY(plaza.state.ground().soon() != nullptr);
}

CROWD_TEST(TestGroundTools)
#include "tst_GroundTools.moc"
