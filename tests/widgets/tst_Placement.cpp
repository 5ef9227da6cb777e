// SPDX-License-Identifier: MIT
#include <cmath>
#include <span>
#include <vector>

#include <QtTest/QTest>
#include <QtWidgets/QLabel>
#include <QtWidgets/QTreeWidget>

#include "tests/program/WindowTest.h"
#include "tests/widgets/Desk.h"
#include "widgets/docks/SceneDock.h"
#include "widgets/forms/FieldForm.h"

using namespace crowd;
using namespace crowd::widgets;
using crowd::testing::addPeople;

namespace {

struct SceneDesk : crowd::testing::Desk<SceneDock>
{
    [[nodiscard]] FieldForm* form(const char* name)
    {
        return dock->findChild<FieldForm*>(QLatin1String(name));
    }
    [[nodiscard]] QTreeWidget* tree() { return dock->findChild<QTreeWidget*>(); }
    /// Clicks the first of a heading's rows.
    void click(int heading)
    {
        QTreeWidgetItem* item = tree()->topLevelItem(heading)->child(0);
        QTest::mouseClick(tree()->viewport(), Qt::LeftButton, {},
                          tree()->visualItemRect(item).center());
    }
    [[nodiscard]] QString title()
    {
        return dock->findChild<QLabel*>(QStringLiteral("placementTitle"))->text();
    }
    [[nodiscard]] const model::StageEntry& stage() { return document.scene().stages.front(); }
    [[nodiscard]] const model::Camera& camera() { return document.scene().cameras.front().camera; }
};

constexpr int kStages = 0;
constexpr int kCameras = 2;

} // namespace

/// Stages are placed and cameras set in the panel Scene.
class TestPlacement : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aStageIsPlacedWithWhoSitsThere();
    void theViewIsSetWhereNothingIsChosen();
    void theViewGoesWithItsCamera();
    void whatIsChosenStaysChosen();
};

void TestPlacement::aStageIsPlacedWithWhoSitsThere()
{
    SceneDesk desk;
    QVERIFY(desk.isReady());
    const auto ids = addPeople(desk.document, 2);
    const auto seat = desk.document.scene().worldSeats().front();
    const std::vector<model::IndividualId> first{ids.front()};
    QVERIFY(desk.document.edit(QStringLiteral("sit"), [&](model::SceneEdit& edit) {
        edit.setColumn<model::SeatId>(model::columns::seat, first, std::span(&seat.id, 1));
        edit.setColumn<glm::vec3>(model::columns::position, first,
                                  std::span(&seat.seat.position, 1));
    }) != model::EditOutcome::Refused);
    desk.click(kStages);
    QTRY_VERIFY(desk.form("stagePlacement")->isVisible());
    QVERIFY(!desk.form("cameraForm")->isVisible());
    QCOMPARE(desk.title(), QStringLiteral("Stage: small theatre"));
    const int steps = desk.document.undoStack().count();
    const auto places = [&] {
        return desk.document.scene().population.column(model::columns::position);
    };
    const glm::vec3 standing = places()[1];
    const auto sliders = desk.form("stagePlacement")->findChildren<ValueSlider*>();
    Q_EMIT sliders.at(sliders.size() - 2)->valueEdited(90.0); // before the size
    QVERIFY(std::abs(desk.stage().headingRadians - 1.5707963F) < 1e-4F);
    QCOMPARE(desk.document.undoStack().count(), steps + 1);
    const auto now = desk.document.scene().worldSeats().front();
    QVERIFY(glm::length(places()[0] - now.seat.position) < 1e-4F);
    QVERIFY(glm::length(places()[0] - seat.seat.position) > 0.1F);
    QCOMPARE(places()[1], standing);
    desk.document.undoStack().undo();
    QCOMPARE(desk.stage().headingRadians, 0.0F);
    QCOMPARE(places()[0], seat.seat.position);
}

void TestPlacement::theViewIsSetWhereNothingIsChosen()
{
    SceneDesk desk;
    QVERIFY(desk.isReady());
    QTRY_VERIFY(desk.form("cameraForm")->isVisible());
    QCOMPARE(desk.title(), QStringLiteral("This view"));
    const int steps = desk.document.undoStack().count();
    Q_EMIT desk.form("cameraForm")->findChildren<ValueSlider*>().front()->valueEdited(30.0);
    QVERIFY(std::abs(desk.state.camera().fovYRadians - 0.5235988F) < 1e-4F);
    QCOMPARE(desk.document.undoStack().count(), steps); // the view is nobody's
}

void TestPlacement::theViewGoesWithItsCamera()
{
    SceneDesk desk;
    QVERIFY(desk.isReady());
    desk.state.setCamera(desk.camera(), QStringLiteral("front"));
    desk.click(kCameras);
    QTRY_COMPARE(desk.title(), QStringLiteral("Camera: front"));
    Q_EMIT desk.form("cameraForm")->findChildren<ValueSlider*>().front()->valueEdited(30.0);
    QVERIFY(std::abs(desk.camera().fovYRadians - 0.5235988F) < 1e-4F);
    QCOMPARE(desk.state.camera(), desk.camera());
    QCOMPARE(desk.state.viewCamera().name, QStringLiteral("front"));
    desk.document.undoStack().undo();
    QCOMPARE(desk.state.camera(), desk.camera()); // and back
    desk.document.undoStack().redo();
    QCOMPARE(desk.state.camera(), desk.camera());
    // Elsewhere the view stays as it is.
    const model::Camera away = model::Camera::lookingAt({9.0F, 9.0F, 9.0F}, {0.0F, 0.0F, 0.0F});
    desk.state.setCamera(away);
    Q_EMIT desk.form("cameraForm")->findChildren<ValueSlider*>().front()->valueEdited(60.0);
    QCOMPARE(desk.state.camera(), away);
    QVERIFY(std::abs(desk.camera().fovYRadians - 1.0471976F) < 1e-4F);
}

void TestPlacement::whatIsChosenStaysChosen()
{
    SceneDesk desk;
    QVERIFY(desk.isReady());
    desk.click(kStages);
    QTRY_COMPARE(desk.title(), QStringLiteral("Stage: small theatre"));
    addPeople(desk.document, 3); // the list is made anew
    QTRY_COMPARE(desk.tree()->topLevelItem(1)->child(0)->text(1), QStringLiteral("3"));
    QCOMPARE(desk.title(), QStringLiteral("Stage: small theatre"));
    QVERIFY(desk.document.edit(QStringLiteral("gone"), [&](model::SceneEdit& edit) {
        edit.removeStage(desk.stage().id);
    }) != model::EditOutcome::Refused);
    QTRY_COMPARE(desk.title(), QStringLiteral("This view"));
    // A click beside the rows chooses none of them.
    const int below = desk.tree()->viewport()->height() - 3;
    QVERIFY(desk.tree()->itemAt(QPoint(40, below)) == nullptr);
    desk.tree()->setCurrentItem(desk.tree()->topLevelItem(kCameras)->child(0));
    QTRY_COMPARE(desk.title(), QStringLiteral("Camera: front"));
    QTest::mouseClick(desk.tree()->viewport(), Qt::LeftButton, {}, QPoint(40, below));
    QTRY_COMPARE(desk.title(), QStringLiteral("This view"));
}

CROWD_WINDOW_TEST(TestPlacement)
#include "tst_Placement.moc"
