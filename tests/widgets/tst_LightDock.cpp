// SPDX-License-Identifier: MIT
#include <QtTest/QTest>
#include <QtWidgets/QMenu>
#include <QtWidgets/QToolButton>

#include "model/scene/ReadyLight.h"
#include "tests/program/WindowTest.h"
#include "tests/widgets/Desk.h"
#include "widgets/docks/FieldForm.h"
#include "widgets/docks/LightDock.h"

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
        return dock->findChildren<ValueSlider*>().at(index);
    }
    [[nodiscard]] int steps() { return document.undoStack().count(); }
};

} // namespace

class TestLightDock : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void showsAllThatIsDescribed();
    void aDragIsOneStepAndSeenMeanwhile();
    void typingIsOneStep();
    void softnessIsAskedForWhereShadowsAre();
    void readyMadeLightKeepsTheGround();
    void followsUndo();
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
    QCOMPARE(desk.dock->findChildren<ValueSlider*>().size(), qsizetype{numbers});
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

CROWD_WINDOW_TEST(TestLightDock)
#include "tst_LightDock.moc"
