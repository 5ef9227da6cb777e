// SPDX-License-Identifier: MIT
#include <utility>

#include <QtCore/QTimer>
#include <QtTest/QTest>
#include <QtWidgets/QColorDialog>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QLabel>
#include <QtWidgets/QListWidget>
#include <QtWidgets/QMenu>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QToolButton>

#include "model/scene/ReadyLight.h"
#include "tests/program/WindowTest.h"
#include "tests/widgets/Desk.h"
#include "widgets/commands/LightCommands.h"
#include "widgets/docks/LightDock.h"
#include "widgets/forms/FieldForm.h"

using namespace crowd;
using namespace crowd::widgets;

namespace {

struct LightDesk : crowd::testing::Desk<LightDock>
{
    [[nodiscard]] const model::Lighting& light() { return document.scene().lighting; }
    /// Its sliders, in the order in which the light describes its numbers.
    [[nodiscard]] ValueSlider* slider(const char* key)
    {
        qsizetype index = 0;
        for (const model::FieldInfo& field : model::fieldsOf<model::Lighting>()) {
            if (field.meta.key == std::string_view(key)) {
                break;
            }
            index += field.is<float>() ? 1 : 0;
        }
        return form("lightForm")->findChildren<ValueSlider*>().at(index);
    }
    [[nodiscard]] FieldForm* form(const char* name)
    {
        return dock->findChild<FieldForm*>(QLatin1String(name));
    }
    [[nodiscard]] QListWidget* list()
    {
        return dock->findChild<QListWidget*>(QStringLiteral("lights"));
    }
    [[nodiscard]] const model::Lights& lights() { return document.scene().lights; }
    [[nodiscard]] int steps() { return document.undoStack().count(); }
};

} // namespace

class TestLightDock : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void showsAllThatIsDescribed();
    void theChosenLampIsShown();
    void aDragIsOneStepAndSeenMeanwhile();
    void typingIsOneStep();
    void softnessIsAskedForWhereShadowsAre();
    void readyMadeLightKeepsTheGround();
    void followsUndo();
    void listsLightsAndShowsTheChosenOne();
    void theListSwitchesAndRenames();
    void aDragOfALightIsOneStep();
    void coloursAreSeenBeforeTheyAreChosen();
    void takesWhoeverIsSelected();
    void followsWhoIsClicked();
    void groupsCanBeChosenWhenTheyCome();
    void saysWhenTheyAreTooMany();
};

void TestLightDock::showsAllThatIsDescribed()
{
    LightDesk desk;
    int numbers = 0;
    int colours = 0;
    for (const model::FieldInfo& field : model::fieldsOf<model::Lighting>()) {
        numbers += field.is<float>() ? 1 : 0;
        colours += field.is<glm::vec3>() ? 1 : 0;
    }
    QCOMPARE(desk.form("lightForm")->findChildren<ValueSlider*>().size(), qsizetype{numbers});
    QCOMPARE(colours, 5);
    auto* form = desk.dock->findChild<FieldForm*>(QStringLiteral("lightForm"));
    for (const char* name : {"Colour", "Light", "Above", "Horizon"}) {
        bool isThere = false;
        for (const auto* button : form->findChildren<QToolButton*>()) {
            isThere = isThere || button->accessibleName() == QLatin1String(name);
        }
        QVERIFY2(isThere, name);
    }
}

/// Wherever it is.
void TestLightDock::theChosenLampIsShown()
{
    LightDesk desk;
    QVERIFY(desk.isReady());
    auto* button = desk.dock->findChild<QToolButton*>(QStringLiteral("frameLight"));
    QVERIFY(!button->isVisible()); // the sun is nowhere
    addLight(desk.state, model::LightKind::Point, {300.0F, 0.0F, -200.0F});
    QVERIFY(desk.state.chosenLight() != 0 && button->isVisible());
    const auto away = [&desk] {
        const model::Camera camera = desk.state.cameraTarget();
        const glm::vec3 to = desk.lights()[0].position - camera.position;
        return std::pair(glm::length(to), glm::dot(glm::normalize(to), camera.forward()));
    };
    QVERIFY(away().first > 100.0F);
    QTest::mouseClick(button, Qt::LeftButton);
    const auto [metres, straight] = away();
    QVERIFY2(metres < 40.0F && straight > 0.9F, qPrintable(QString::number(metres)));
    QCOMPARE(desk.steps(), 1); // the light alone
}

void TestLightDock::aDragIsOneStepAndSeenMeanwhile()
{
    LightDesk desk;
    const int before = desk.steps();
    ValueSlider* sun = desk.slider("sunStrength");
    QTRY_VERIFY(sun->isVisible());
    const QPoint start = sun->rect().center();
    const float began = desk.light().sunStrength;
    QTest::mousePress(sun, Qt::LeftButton, {}, start);
    for (int i = 1; i <= 5; ++i) {
        QTest::mouseMove(sun, start + QPoint(6 * i, 0));
        QMouseEvent move(QEvent::MouseMove, start + QPoint(6 * i, 0),
                         sun->mapToGlobal(start + QPoint(6 * i, 0)), Qt::NoButton, Qt::LeftButton,
                         Qt::NoModifier);
        QApplication::sendEvent(sun, &move);
    }
    const float seen = desk.light().sunStrength;
    QVERIFY(seen > began);
    QCOMPARE(desk.steps(), before);
    QTest::mouseRelease(sun, Qt::LeftButton, {}, start + QPoint(30, 0));
    QCOMPARE(desk.steps(), before + 1);
    QCOMPARE(desk.light().sunStrength, seen);
    desk.document.undoStack().undo();
    QCOMPARE(desk.light().sunStrength, began);
}

void TestLightDock::typingIsOneStep()
{
    LightDesk desk;
    const int before = desk.steps();
    Q_EMIT desk.slider("sunElevation")->valueEdited(30.0);
    QCOMPARE(desk.steps(), before + 1);
    QVERIFY(std::abs(desk.light().sunElevationRadians - 0.5235988F) < 1e-4F);
}

void TestLightDock::softnessIsAskedForWhereShadowsAre()
{
    LightDesk desk;
    QTRY_VERIFY(desk.slider("shadowSoftness")->isVisible());
    Q_EMIT desk.slider("shadowStrength")->valueEdited(0.0);
    QCOMPARE(desk.light().shadowStrength, 0.0F);
    QTRY_VERIFY(!desk.slider("shadowSoftness")->isVisible());
}

void TestLightDock::readyMadeLightKeepsTheGround()
{
    LightDesk desk;
    const glm::vec3 ground(0.1F, 0.2F, 0.3F);
    desk.document.edit(QStringLiteral("Ground"), [&](model::SceneEdit& edit) {
        model::Lighting light = desk.light();
        light.ground = ground;
        edit.setLighting(light);
    });
    auto* button = desk.dock->findChild<QToolButton*>(QStringLiteral("readyLight"));
    const auto actions = button->menu()->actions();
    QCOMPARE(actions.size(), static_cast<qsizetype>(model::readyLights().size()));
    for (qsizetype i = 0; i < actions.size(); ++i) {
        const model::ReadyLight& ready = model::readyLights()[static_cast<std::size_t>(i)];
        const int before = desk.steps();
        actions[i]->trigger();
        QCOMPARE(desk.steps(), before + 1);
        QCOMPARE(desk.light().sunElevationRadians, ready.light.sunElevationRadians);
        QCOMPARE(desk.light().ground, ground);
        QVERIFY(desk.light().shadowStrength > 0.0F);
    }
}

void TestLightDock::followsUndo()
{
    LightDesk desk;
    ValueSlider* shadows = desk.slider("shadowStrength");
    const double before = shadows->value();
    Q_EMIT shadows->valueEdited(25.0);
    QCOMPARE(shadows->value(), 25.0);
    desk.document.undoStack().undo();
    QCOMPARE(shadows->value(), before);
}

void TestLightDock::listsLightsAndShowsTheChosenOne()
{
    LightDesk desk;
    QCOMPARE(desk.list()->count(), 1);
    QTRY_VERIFY(desk.form("lightForm")->isVisible());
    auto* add = desk.dock->findChild<QToolButton*>(QStringLiteral("add-spot"));
    QTest::mouseClick(add, Qt::LeftButton);
    QVERIFY(desk.state.picking() != Picking::None);
    desk.state.offerPoint({1.0F, 0.0F, 2.0F});
    QCOMPARE(desk.list()->count(), 2);
    QCOMPARE(desk.list()->currentRow(), 1);
    QTRY_VERIFY(desk.form("lampForm")->isVisible() && !desk.form("lightForm")->isVisible());
    desk.list()->setCurrentRow(0);
    QCOMPARE(desk.state.chosenLight(), model::LightId{0});
    QTRY_VERIFY(desk.form("lightForm")->isVisible() && !desk.form("lampForm")->isVisible());
    auto* remove = desk.dock->findChild<QToolButton*>(QStringLiteral("removeLight"));
    QVERIFY(!remove->isEnabled());
    desk.list()->setCurrentRow(1);
    QTest::mouseClick(remove, Qt::LeftButton);
    QVERIFY(desk.lights().empty());
    QCOMPARE(desk.list()->count(), 1);
    desk.document.undoStack().undo();
    QCOMPARE(desk.list()->count(), 2);
    QCOMPARE(desk.list()->currentRow(), 1); // what has come back is worked on
}

void TestLightDock::theListSwitchesAndRenames()
{
    LightDesk desk;
    addLight(desk.state, model::LightKind::Point, {});
    const int before = desk.steps();
    desk.list()->item(1)->setCheckState(Qt::Unchecked);
    QVERIFY(!desk.lights().front().isOn);
    QCOMPARE(desk.steps(), before + 1);
    QTRY_COMPARE(desk.list()->item(1)->checkState(), Qt::Unchecked);
    desk.list()->item(1)->setText(QStringLiteral("  Moon  "));
    QCOMPARE(desk.lights().front().name, std::string("Moon"));
    QTRY_COMPARE(desk.list()->item(1)->text(), QStringLiteral("Moon"));
    desk.list()->item(1)->setText(QString());
    QTRY_COMPARE(desk.list()->item(1)->text(), QStringLiteral("Moon"));
}

void TestLightDock::aDragOfALightIsOneStep()
{
    LightDesk desk;
    addLight(desk.state, model::LightKind::Spot, {});
    QTRY_VERIFY(desk.form("lampForm")->isVisible());
    const int before = desk.steps();
    ValueSlider* strength = desk.form("lampForm")->findChildren<ValueSlider*>().front();
    QTRY_VERIFY(strength->isVisible());
    Q_EMIT strength->held(true);
    for (const double percent : {110.0, 150.0, 200.0}) {
        Q_EMIT strength->valueEdited(percent);
    }
    QCOMPARE(desk.lights().front().strength, 2.0F);
    QCOMPARE(desk.steps(), before);
    Q_EMIT strength->held(false);
    QCOMPARE(desk.steps(), before + 1);
    desk.document.undoStack().undo();
    QCOMPARE(desk.lights().front().strength, 1.0F);
}

/// What is looked at in the dialog is seen in the picture; one step if it is chosen, none else.
void TestLightDock::coloursAreSeenBeforeTheyAreChosen()
{
    LightDesk desk;
    addLight(desk.state, model::LightKind::Spot, {});
    QTRY_VERIFY(desk.form("lampForm")->isVisible());
    QToolButton* button = nullptr;
    for (auto* each : desk.form("lampForm")->findChildren<QToolButton*>()) {
        button = each->accessibleName() == QLatin1String("Colour") ? each : button;
    }
    QVERIFY(button != nullptr);
    const int before = desk.steps();
    const auto color = desk.lights().front().color;
    for (const bool isChosen : {false, true}) {
        bool isSeen = false;
        QTimer::singleShot(0, &desk.window, [&] {
            auto* dialog = desk.window.findChild<QColorDialog*>();
            QVERIFY(dialog != nullptr);
            dialog->setCurrentColor(Qt::blue);
            isSeen = desk.lights().front().color != color;
            isChosen ? dialog->accept() : dialog->reject();
        });
        button->click();
        QVERIFY(isSeen);
        QCOMPARE(desk.lights().front().color != color, isChosen);
        QCOMPARE(desk.steps(), before + (isChosen ? 1 : 0));
    }
    desk.document.undoStack().undo();
    QVERIFY(desk.lights().front().color == color);
}

void TestLightDock::takesWhoeverIsSelected()
{
    LightDesk desk;
    addLight(desk.state, model::LightKind::Spot, {});
    QTRY_VERIFY(desk.form("lampForm")->isVisible());
    auto* take = desk.dock->findChild<QPushButton*>(QStringLiteral("takeSelected"));
    QVERIFY(!take->isVisible()); // it aims at a place
    changeLight(desk.state, desk.state.chosenLight(), QStringLiteral("Aim"),
                [](model::Light& light) { light.aim = model::LightAim::Person; });
    QTRY_VERIFY(take->isVisible());
    const QString nobody = take->text();
    QTest::mouseClick(take, Qt::LeftButton);
    QCOMPARE(desk.lights().front().person, model::IndividualId{0}); // nobody is selected
    model::IndividualId made = 0;
    desk.document.edit(QStringLiteral("Add"), [&](model::SceneEdit& edit) {
        auto rows = model::IndividualRows::withDefaults({0});
        rows.column(model::columns::templateId)[0] = desk.document.scene().templates.front().id;
        made = edit.addIndividuals(std::move(rows)).front();
    });
    desk.state.selection().set(std::vector{made});
    QTest::mouseClick(take, Qt::LeftButton);
    QCOMPARE(desk.lights().front().person, made);
    QTRY_VERIFY(take->text() != nobody);
}

void TestLightDock::followsWhoIsClicked()
{
    LightDesk desk;
    model::IndividualId made = 0;
    desk.document.edit(QStringLiteral("Add"), [&](model::SceneEdit& edit) {
        auto rows = model::IndividualRows::withDefaults({0});
        rows.column(model::columns::templateId)[0] = desk.document.scene().templates.front().id;
        rows.column(model::columns::position)[0] = {4.0F, 0.0F, -3.0F};
        made = edit.addIndividuals(std::move(rows)).front();
    });
    const int before = desk.steps();
    auto* add = desk.dock->findChild<QToolButton*>(QStringLiteral("add-follow"));
    QTest::mouseClick(add, Qt::LeftButton);
    QVERIFY(desk.state.picking() == Picking::Person && add->isChecked());
    // Another button that asks is the only one that is pressed.
    auto* spot = desk.dock->findChild<QToolButton*>(QStringLiteral("add-spot"));
    QTest::mouseClick(spot, Qt::LeftButton);
    QVERIFY(desk.state.picking() == Picking::Place && !add->isChecked() && spot->isChecked());
    QTest::mouseClick(add, Qt::LeftButton);
    QVERIFY(!spot->isChecked());
    desk.state.offerPerson(made);
    QVERIFY(desk.state.picking() == Picking::None && !add->isChecked());
    QCOMPARE(desk.lights().size(), std::size_t{1});
    const model::Light& light = desk.lights().front();
    QVERIFY(light.kind == model::LightKind::Spot && light.aim == model::LightAim::Person);
    QCOMPARE(light.person, made);
    QVERIFY(glm::distance(light.position, glm::vec3(4.0F, 0.0F, -3.0F)) < 15.0F);
    QCOMPARE(desk.state.chosenLight(), light.id);
    QCOMPARE(desk.steps(), before + 1);
    // Somebody who has gone meanwhile is not followed.
    desk.document.edit(QStringLiteral("Remove"),
                       [&](model::SceneEdit& edit) { edit.removeIndividuals(std::vector{made}); });
    QTest::mouseClick(add, Qt::LeftButton);
    desk.state.offerPerson(made);
    QCOMPARE(desk.lights().size(), std::size_t{1});
}

void TestLightDock::groupsCanBeChosenWhenTheyCome()
{
    LightDesk desk;
    addLight(desk.state, model::LightKind::Spot, {});
    changeLight(desk.state, desk.state.chosenLight(), QStringLiteral("Aim"),
                [](model::Light& light) { light.aim = model::LightAim::Group; });
    desk.document.edit(QStringLiteral("Group"), [](model::SceneEdit& edit) {
        model::Group group;
        group.id = 5;
        group.name = "Chorus";
        edit.setGroups({group});
    });
    QComboBox* box = nullptr;
    for (auto* each : desk.form("lampForm")->findChildren<QComboBox*>()) {
        box = each->findText(QStringLiteral("Chorus")) >= 0 ? each : box;
    }
    QVERIFY(box != nullptr);
    QTRY_VERIFY(box->isVisible());
    Q_EMIT box->activated(box->findText(QStringLiteral("Chorus")));
    QCOMPARE(desk.lights().front().group, model::GroupId{5});
}

void TestLightDock::saysWhenTheyAreTooMany()
{
    LightDesk desk;
    auto* note = desk.dock->findChild<QLabel*>(QStringLiteral("lightNote"));
    model::Lights many(20);
    for (std::size_t i = 0; i < many.size(); ++i) {
        many[i].id = static_cast<model::LightId>(i + 1);
    }
    desk.document.edit(QStringLiteral("Many"),
                       [&](model::SceneEdit& edit) { edit.setLights(many); });
    QTRY_VERIFY(note->isVisible());
    QVERIFY2(note->text().contains(QStringLiteral("20")), qPrintable(note->text()));
    many.resize(3);
    desk.document.edit(QStringLiteral("Few"),
                       [&](model::SceneEdit& edit) { edit.setLights(many); });
    QTRY_VERIFY(!note->isVisible());
}

CROWD_WINDOW_TEST(TestLightDock)
#include "tst_LightDock.moc"
