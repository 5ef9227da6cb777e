// SPDX-License-Identifier: MIT
#include <QtTest/QTest>

#include "behavior/rules/RuleEngine.h"
#include "model/document/SceneEdit.h"
#include "model/project/ProjectReader.h"
#include "tests/behavior/Actors.h"
#include "tests/model/ProjectText.h"
#include "tests/program/Test.h"
#include "widgets/state/SessionControl.h"

using namespace crowd;
using namespace crowd::testing;
using widgets::SessionControl;
using widgets::Transport;

namespace keys = model::columns;

namespace {

constexpr model::NumberId kHunger = 2;

/// Three people; "change" recolours, resizes, tags and sets going whoever hears it, and makes him
/// hungrier.
model::Scene changeable()
{
    model::Scene scene = rowOf(3);
    auto asset = std::make_shared<model::Template>(*scene.templates.front().asset);
    asset->slots.emplace_back().name = "top";
    scene.templates.front().asset = asset;
    scene.templates.front().path = "builtin:templates/actor.glb"; // to be written
    scene.nextId = 4;
    scene.numbers = {{kHunger, "hunger", 1.0F, 1.0F}, {3, "thirst", 0.0F, 5.0F}};
    actions::SetProperty tint;
    tint.color = {10, 20, 30};
    tint.strength = 200;
    actions::SetProperty height;
    height.property = model::SettableProperty::Height;
    height.value = 1.5F;
    actions::SetProperty speed;
    speed.property = model::SettableProperty::PlaybackSpeed;
    speed.value = 2.0F;
    actions::SetProperty sit;
    sit.property = model::SettableProperty::Clip;
    sit.clips = {{"sit", 1.0F}};
    actions::AddTag tag;
    tag.tag = 9;
    actions::AddToNumber more;
    more.number = kHunger;
    more.value = 2.5F;
    scene.rules = {onEvent("change", {tint, height, speed, sit, tag, more})};
    return scene;
}

struct Stage
{
    explicit Stage(const model::Scene& scene) : control(document, transport)
    {
        document.replaceScene(scene, {});
    }
    /// So many steps are done and shown.
    [[nodiscard]] bool step(int steps)
    {
        for (int i = 0; i < steps; ++i) {
            control.stepOnce();
        }
        const double seconds = transport.seconds();
        return QTest::qWaitFor([this, seconds] { return control.availableSeconds() >= seconds; });
    }
    [[nodiscard]] bool change(const std::vector<model::IndividualId>& ids)
    {
        const bool hasBegun = step(1);
        control.send({"change", 0.0F}, ids);
        return hasBegun && step(5);
    }

    model::SceneDocument document;
    Transport transport;
    SessionControl control;
};

} // namespace

class TestKeepPose : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void whatRulesHaveSetIsKept();
    void numbersAreKeptAndBegunWith();
    void keepingTwiceKeepsTheLatest();
    void keptNumbersAreInTheFile();
    void undoneItIsAsBefore();
    void itIsShownWithoutBeingKept();
    void stepsAreAsLongAsTheSceneSays_data();
    void stepsAreAsLongAsTheSceneSays();
};

void TestKeepPose::whatRulesHaveSetIsKept()
{
    Stage stage(changeable());
    QVERIFY(stage.change({2}));
    QVERIFY(stage.control.keepPose());
    const model::Population& people = stage.document.scene().population;
    QVERIFY((people.column(keys::tint(0))[1] == model::Tint{10, 20, 30, 200}));
    QCOMPARE(people.column(keys::height)[1], 1.5F);
    QCOMPARE(people.column(keys::playbackSpeed)[1], 2.0F);
    QCOMPARE(people.column(keys::clip)[1], std::uint16_t{4});
    QCOMPARE(people.column(keys::tags)[1], std::uint64_t{1} << 9U);
    // Nobody else's.
    QVERIFY(people.column(keys::tint(0))[0] == model::Tint());
    QCOMPARE(people.column(keys::height)[0], 1.0F);
    QCOMPARE(people.column(keys::tags)[2], std::uint64_t{0});
    // And it is shown on as it was.
    const auto before = stage.control.frame(stage.transport.seconds());
    QVERIFY(stage.step(1));
    const auto after = stage.control.frame(stage.transport.seconds());
    QVERIFY(after->population.column(keys::tint(0))[1] ==
            before->population.column(keys::tint(0))[1]);
    QCOMPARE(after->population.column(keys::height)[1], 1.5F);
    QCOMPARE(after->population.column(keys::clip)[1], std::uint16_t{4});
}

void TestKeepPose::numbersAreKeptAndBegunWith()
{
    Stage stage(changeable());
    QVERIFY(stage.change({1, 3}));
    QVERIFY(stage.control.keepPose());
    const std::vector<std::pair<model::IndividualId, float>> kept{{1, 3.5F}, {3, 3.5F}};
    QCOMPARE(stage.document.scene().numbers[0].values, kept);
    QVERIFY(stage.document.scene().numbers[1].values.empty());
    Session again(stage.document.scene());
    QCOMPARE(again.rules().number(0, kHunger), 3.5F);
    QCOMPARE(again.rules().number(1, kHunger), 1.0F);
}

void TestKeepPose::keepingTwiceKeepsTheLatest()
{
    Stage stage(changeable());
    QVERIFY(stage.change({1}));
    QVERIFY(stage.control.keepPose());
    QVERIFY(stage.change({1, 2}));
    QVERIFY(stage.control.keepPose());
    const std::vector<std::pair<model::IndividualId, float>> kept{{1, 6.0F}, {2, 3.5F}};
    QCOMPARE(stage.document.scene().numbers[0].values, kept);
    // Undone while it runs, the second change is undone in the session too.
    stage.document.undoStack().undo();
    QTest::qWait(1);
    QVERIFY(stage.step(2));
    (void)stage.control.keepPose();
    const std::vector<std::pair<model::IndividualId, float>> first{{1, 3.5F}};
    QCOMPARE(stage.document.scene().numbers[0].values, first);
}

void TestKeepPose::keptNumbersAreInTheFile()
{
    Stage stage(changeable());
    QVERIFY(stage.change({2}));
    QVERIFY(stage.control.keepPose());
    const auto read = model::projectFromText(projectText(stage.document.scene()));
    QVERIFY2(read.isOk(), read ? "" : read.error().message.c_str());
    QCOMPARE(read.value().numbers, stage.document.scene().numbers);
}

/// What a state keeps while it plays: also clips that rules play, which nobody has of his own.
void TestKeepPose::itIsShownWithoutBeingKept()
{
    model::Scene scene = changeable();
    actions::PlayClip play;
    play.clips = {{"sit", 1.0F}};
    play.isLooped = true;
    play.seconds = 0.0F;
    scene.rules.push_back(onEvent("play", {play}));
    scene.rules.back().id = 77;
    Stage stage(scene);
    QCOMPARE(projectText(stage.control.shownScene()), projectText(stage.document.scene()));
    QVERIFY(stage.change({2}));
    stage.control.send({"play", 0.0F}, std::vector<model::IndividualId>{3});
    QVERIFY(stage.step(5));
    const std::string before = projectText(stage.document.scene());
    const model::Scene shown = stage.control.shownScene();
    QCOMPARE(projectText(stage.document.scene()), before);
    QCOMPARE(shown.population.column(keys::height)[1], 1.5F);
    QCOMPARE(shown.population.column(keys::clip)[1], std::uint16_t{4});
    QCOMPARE(shown.population.column(keys::clip)[2], std::uint16_t{4});
    QVERIFY(stage.document.scene().population.column(keys::clip)[2] != 4);
    const float phase = shown.population.column(keys::phase)[2];
    QVERIFY2(phase >= 0.0F && phase <= 1.0F, qPrintable(QString::number(phase)));
}

void TestKeepPose::undoneItIsAsBefore()
{
    Stage stage(changeable());
    const std::string before = projectText(stage.document.scene());
    QVERIFY(stage.change({1, 2, 3}));
    QCOMPARE(projectText(stage.document.scene()), before); // a session never writes to the scene
    QVERIFY(stage.control.keepPose());
    const std::string kept = projectText(stage.document.scene());
    QVERIFY(kept != before);
    QCOMPARE(stage.document.undoStack().count(), 1);
    stage.document.undoStack().undo();
    QCOMPARE(projectText(stage.document.scene()), before);
    stage.document.undoStack().redo();
    QCOMPARE(projectText(stage.document.scene()), kept);
}

void TestKeepPose::stepsAreAsLongAsTheSceneSays_data()
{
    QTest::addColumn<int>("rate");
    for (const std::uint32_t rate : model::kStepRates) {
        QTest::addRow("1/%u s", rate) << static_cast<int>(rate);
    }
}

void TestKeepPose::stepsAreAsLongAsTheSceneSays()
{
    QFETCH(const int, rate);
    model::Scene scene = changeable();
    scene.stepsPerSecond = static_cast<std::uint32_t>(rate);
    Stage stage(scene);
    QVERIFY(stage.step(12));
    QVERIFY(std::abs(stage.transport.seconds() - 12.0 / rate) < 1e-9);
    QVERIFY(std::abs(stage.control.availableSeconds() - 12.0 / rate) < 1e-9);
    // Another length holds from the next play on.
    auto edit = stage.document.beginEdit().value();
    edit->setStepsPerSecond(rate == 30 ? 60 : 30);
    QVERIFY(edit->commit(QStringLiteral("Steps")));
    QVERIFY(stage.step(12));
    QVERIFY(std::abs(stage.transport.seconds() - 24.0 / rate) < 1e-9);
}

CROWD_TEST(TestKeepPose)
#include "tst_KeepPose.moc"
