// SPDX-License-Identifier: MIT
#include <algorithm>
#include <vector>

#include <QtCore/QSettings>
#include <QtCore/QStandardPaths>
#include <QtCore/QTimer>
#include <QtGui/QShortcut>
#include <QtGui/QStandardItemModel>
#include <QtTest/QSignalSpy>
#include <QtWidgets/QAbstractSpinBox>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QDoubleSpinBox>
#include <QtWidgets/QLabel>
#include <QtWidgets/QListWidget>
#include <QtWidgets/QMenu>
#include <QtWidgets/QScrollArea>
#include <QtWidgets/QScrollBar>
#include <QtWidgets/QToolButton>
#include <QtWidgets/QTreeWidget>

#include "model/document/PathEdits.h"
#include "model/document/SceneEdit.h"
#include "model/scene/PlaceShape.h"
#include "model/states/StateKeeping.h"
#include "tests/program/WindowTest.h"
#include "tests/widgets/Desk.h"
#include "widgets/docks/EnvironmentDock.h"
#include "widgets/docks/RulesDock.h"
#include "widgets/forms/NumberField.h"
#include "widgets/forms/NumberList.h"
#include "widgets/rules/CueForm.h"
#include "widgets/rules/RuleNames.h"
#include "widgets/rules/RuleProblems.h"
#include "widgets/rules/RuleTexts.h"
#include "widgets/state/Cues.h"

using namespace crowd;
using namespace crowd::widgets;
using crowd::testing::Desk;

namespace {

/// A path over two places.
void furnish(model::SceneDocument& document)
{
    auto edit = document.beginEdit().value();
    model::Place place;
    place.position = {1.0F, 0.05F, 2.0F};
    const model::PathId path = model::appendPlace(*edit, 0, place, model::PathKind::Simple);
    place.position = {6.0F, 0.05F, 2.0F};
    model::appendPlace(*edit, path, place, model::PathKind::Simple);
    edit->commit(QStringLiteral("Furnish"));
}

template<class Dock>
void addBy(Desk<Dock>& desk, const char* button, const QString& entry)
{
    auto* add = desk.dock->template findChild<QToolButton*>(QLatin1String(button));
    for (QAction* action : add->menu()->actions()) {
        if (action->text() == entry) {
            action->trigger();
            return;
        }
    }
    QFAIL("no such entry");
}

} // namespace

class TestBehaviourDocks : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void theTreeShowsAndSelectsPlaces();
    void valuesOfPlacesAndPathsAreEdited();
    void readyMadeRulesBecomeSentences();
    void everyReadyMadeSetIsSound_data();
    void everyReadyMadeSetIsSound();
    void aRuleSaysWhatIsWrong();
    void aQueueWithoutAPathAsksForOne();
    void aPathIsChosenForAllRulesThatWaitForIt();
    void whatIsNotChosenYetIsNotGone();
    void everyKindHasASentenceAndFields();
    void cuesAreButtonsAndKeys();
    void cuesRecallStates();
    void aCueSaysThatTheGroundIsStillSought();
    void tagsAndNumbersGetNames();
    void tagsAreWrittenByName();
    void branchesAreAddedWeighedAndRemoved();
    void roomSpeedAndSurfaceAreEdited();
    void linesBecomeAreas();
    void theTreeShowsWhatWasJustMade();
    void whileItRunsTheRunIsCounted();
    void namesOfBranchesCanBeRead();
    void everythingFitsASmallPanel();
};

void TestBehaviourDocks::initTestCase()
{
    QStandardPaths::setTestModeEnabled(true);
    QSettings().clear();
}

void TestBehaviourDocks::theTreeShowsAndSelectsPlaces()
{
    Desk<EnvironmentDock> desk;
    QVERIFY(desk.isReady());
    furnish(desk.document);
    auto* tree = desk.dock->findChild<QTreeWidget*>();
    QTRY_COMPARE(tree->topLevelItemCount(), 1);
    QCOMPARE(tree->topLevelItem(0)->childCount(), 2);
    tree->setCurrentItem(tree->topLevelItem(0)->child(1));
    QCOMPARE(desk.state.paths().places(), std::vector<model::PlaceId>{2});
    QCOMPARE(desk.state.paths().path(), model::PathId{1});
    desk.state.paths().select({1});
    QVERIFY(tree->topLevelItem(0)->child(0)->isSelected());
    QVERIFY(!tree->topLevelItem(0)->child(1)->isSelected());
    tree->topLevelItem(0)->setText(0, QStringLiteral("way home"));
    QCOMPARE(desk.document.scene().paths[0].name, std::string("way home"));
    desk.document.undoStack().undo();
    QCOMPARE(desk.document.scene().paths[0].name, std::string("Path 1"));
}

void TestBehaviourDocks::valuesOfPlacesAndPathsAreEdited()
{
    Desk<EnvironmentDock> desk;
    QVERIFY(desk.isReady());
    furnish(desk.document);
    desk.state.paths().select({2});
    auto* radius = desk.dock->findChild<NumberField*>(QStringLiteral("placeRadius"));
    QTRY_VERIFY(radius->isVisible());
    testing::type(*radius, QStringLiteral("3"));
    QCOMPARE(desk.document.scene().places[1].radius, 3.0F);
    desk.state.paths().select({});
    desk.state.paths().look(1);
    auto* kind = desk.dock->findChild<QComboBox*>(QStringLiteral("pathKind"));
    QVERIFY(kind->isVisible() && !radius->isVisible());
    kind->setCurrentIndex(2);
    Q_EMIT kind->activated(2);
    QCOMPARE(desk.document.scene().paths[0].kind, model::PathKind::Teleport);
    desk.document.undoStack().undo();
    desk.document.undoStack().undo();
    QCOMPARE(desk.document.scene().paths[0].kind, model::PathKind::Simple);
    QVERIFY(desk.document.scene().places[1].radius < 3.0F);
}

void TestBehaviourDocks::readyMadeRulesBecomeSentences()
{
    Desk<RulesDock> desk;
    QVERIFY(desk.isReady());
    auto* list = desk.dock->findChild<QListWidget*>();
    QCOMPARE(list->count(), 0);
    addBy(desk, "addRule", ruleSetName(model::RuleSet::Pedestrians));
    QTRY_COMPARE(list->count(), static_cast<int>(desk.document.scene().rules.size()));
    QVERIFY(list->count() >= 3);
    QVERIFY2(list->item(0)->text().contains(QStringLiteral("run")),
             qPrintable(list->item(0)->text()));
    QCOMPARE(desk.state.brush(model::BrushKind::Event).as<crowd::model::EventSettings>().name,
             std::string("run"));
    QCOMPARE(desk.document.undoStack().count(), 1);
    list->item(1)->setCheckState(Qt::Unchecked);
    QVERIFY(!desk.document.scene().rules[1].isEnabled);
    QTRY_COMPARE(list->item(1)->checkState(), Qt::Unchecked);
    desk.document.undoStack().undo();
    desk.document.undoStack().undo();
    QTRY_COMPARE(list->count(), 0);
}

void TestBehaviourDocks::everyReadyMadeSetIsSound_data()
{
    QTest::addColumn<int>("set");
    for (int set = 0; set < static_cast<int>(model::RuleSet::Count); ++set) {
        QTest::newRow(qPrintable(ruleSetName(static_cast<model::RuleSet>(set)))) << set;
    }
}

void TestBehaviourDocks::everyReadyMadeSetIsSound()
{
    QFETCH(const int, set);
    model::Scene scene;
    model::TemplateEntry entry;
    entry.id = 1;
    entry.clipNames = {"idle", "clap", "sit_clap", "cheer", "sit_cheer", "wave"};
    scene.templates.push_back(entry);
    scene.places = {{1, "exit", {}, 1.0F}, {2, "front", {}, 1.0F}, {3, "behind", {}, 1.0F}};
    scene.places[0].role = model::PlaceRole::Exit;
    scene.paths = {{1, "line", model::PathKind::Simple, {2, 3}}};
    for (const model::Rule& rule : model::rulesOf(static_cast<model::RuleSet>(set), scene)) {
        QCOMPARE(ruleProblem(scene, rule), QString());
        QVERIFY(!ruleSentence(scene, rule).isEmpty());
    }
}

void TestBehaviourDocks::aRuleSaysWhatIsWrong()
{
    Desk<RulesDock> desk;
    QVERIFY(desk.isReady());
    addBy(desk, "addRule", RulesDock::tr("A New Rule"));
    addBy(desk, "addRule", RulesDock::tr("A New Rule"));
    QVERIFY(desk.document.scene().rules[0].name != desk.document.scene().rules[1].name);
    desk.document.undoStack().undo();
    auto* problem = desk.dock->findChild<QLabel*>(QStringLiteral("ruleProblem"));
    QTRY_VERIFY(problem->isVisible());
    QVERIFY2(problem->text().contains(QStringLiteral("type the event")),
             qPrintable(problem->text())); // nothing happens while it is being made
    addBy(desk, "addAction", QStringLiteral("stop"));
    QCOMPARE(desk.document.scene().rules[0].actions.size(), std::size_t{2});
    desk.document.undoStack().undo();
    QCOMPARE(desk.document.scene().rules[0].actions.size(), std::size_t{1});
}

/// Nobody is sent to, or served at, any place there is.
void TestBehaviourDocks::aQueueWithoutAPathAsksForOne()
{
    const model::Scene scene;
    for (const model::Rule& rule : model::rulesOf(model::RuleSet::Queue, scene)) {
        const QString sentence = ruleSentence(scene, rule);
        QVERIFY2(!sentence.contains(QStringLiteral("any place")), qPrintable(sentence));
        QVERIFY2(!sentence.contains(QStringLiteral("gone")), qPrintable(sentence));
        QVERIFY2(ruleProblem(scene, rule).contains(QStringLiteral("choose a p")),
                 qPrintable(ruleProblem(scene, rule)));
    }
}

/// Once, by its field in one of them; and taken back by one step.
void TestBehaviourDocks::aPathIsChosenForAllRulesThatWaitForIt()
{
    Desk<RulesDock> desk;
    QVERIFY(desk.isReady());
    addBy(desk, "addRule", ruleSetName(model::RuleSet::Queue));
    furnish(desk.document);
    const auto openRules = [&desk] {
        const model::Scene& scene = desk.document.scene();
        return std::ranges::count_if(scene.rules, [&scene](const model::Rule& rule) {
            return ruleProblem(scene, rule).contains(QStringLiteral("choose a p"));
        });
    };
    QCOMPARE(openRules(), 3);
    const auto pathField = [&desk]() -> QComboBox* {
        for (QComboBox* field : desk.dock->findChildren<QComboBox*>()) {
            if (field->isVisible() && field->findText(QStringLiteral("Path 1")) >= 0) {
                return field;
            }
        }
        return nullptr;
    };
    QTRY_VERIFY(pathField() != nullptr);
    QSignalSpy said(&desk.state, &EditorState::statusMessage);
    Q_EMIT pathField()->activated(pathField()->findText(QStringLiteral("Path 1")));
    QCOMPARE(openRules(), 0);
    const auto* served = desk.document.scene().rules[2].trigger.as<model::triggers::Arrived>();
    QCOMPARE(served->place, desk.document.scene().paths[0].places.front());
    QVERIFY2(said.last()[0].toString().contains(u'2'), qPrintable(said.last()[0].toString()));
    desk.document.undoStack().undo();
    QCOMPARE(openRules(), 3);
}

/// What is chosen first is asked for, not missed.
void TestBehaviourDocks::whatIsNotChosenYetIsNotGone()
{
    const model::Scene scene;
    model::Rule rule;
    rule.trigger = model::triggers::Event{"go"};
    rule.actions.emplace_back(model::actions::GoToPlace());
    QVERIFY(ruleProblem(scene, rule).contains(QStringLiteral("choose a place")));
    QVERIFY(!ruleSentence(scene, rule).contains(QStringLiteral("any place")));
    rule.actions[0].as<model::actions::GoToPlace>()->place = 5;
    QVERIFY(ruleProblem(scene, rule).contains(QStringLiteral("not there any more")));
}

/// Whatever a rule may hold, its editor can be built and says it in words.
void TestBehaviourDocks::everyKindHasASentenceAndFields()
{
    Desk<RulesDock> desk;
    QVERIFY(desk.isReady());
    model::Rule rule;
    rule.id = 1;
    for (std::size_t kind = 0; kind < model::kindsOf<model::ConditionData>().size(); ++kind) {
        rule.conditions.emplace_back().begin(kind);
    }
    for (std::size_t kind = 0; kind < model::kindsOf<model::ActionData>().size(); ++kind) {
        rule.actions.emplace_back().begin(kind);
    }
    for (std::size_t property = 0; property < model::kSettableProperties.size(); ++property) {
        model::actions::SetProperty set;
        set.property = static_cast<model::SettableProperty>(property);
        set.clips = {{"sit", 1.0F}, {"sit_clap", 2.0F}};
        rule.actions.emplace_back(set);
    }
    for (std::size_t property = 0; property < model::kComparedProperties.size(); ++property) {
        model::conditions::Property asked;
        asked.property = static_cast<model::ComparedProperty>(property);
        rule.conditions.emplace_back(asked);
    }
    for (std::size_t aim = 0; aim < model::rulefields::kAims.size(); ++aim) {
        model::actions::LookAt look;
        look.aim = static_cast<model::ActionAim>(aim);
        rule.actions.emplace_back(look);
    }
    for (std::size_t choice = 0; choice < model::actions::GoToPlace::kChoices.size(); ++choice) {
        model::actions::GoToPlace go;
        go.choice = static_cast<model::PlaceChoice>(choice);
        rule.actions.emplace_back(go);
    }
    auto* list = desk.dock->findChild<QListWidget*>();
    for (std::size_t kind = 0; kind < model::kindsOf<model::TriggerData>().size(); ++kind) {
        rule.trigger.begin(kind);
        auto edit = desk.document.beginEdit().value();
        edit->setRules({rule});
        edit->commit(QStringLiteral("Rule"));
        QTRY_COMPARE(list->count(), 1);
        list->setCurrentRow(0);
        QTRY_VERIFY(desk.all<QComboBox>().size() > 40);
        const QString sentence = ruleSentence(desk.document.scene(), rule);
        QVERIFY2(!sentence.contains(QStringLiteral("%")) || sentence.contains(QStringLiteral("50")),
                 qPrintable(sentence));
        QVERIFY(!sentence.contains(QStringLiteral(", then , ")));
    }
}

void TestBehaviourDocks::cuesAreButtonsAndKeys()
{
    Desk<RulesDock> desk;
    QVERIFY(desk.isReady());
    const CueKeys keys(desk.state, &desk.window);
    auto* add = desk.dock->findChild<QToolButton*>(QStringLiteral("addCue"));
    QTest::mouseClick(add, Qt::LeftButton);
    const auto& cues = desk.document.scene().cues;
    QCOMPARE(cues.size(), std::size_t{1});
    crowd::testing::type(*desk.dock->findChild<QLineEdit*>(QStringLiteral("cueEvent")),
                         QStringLiteral("panic"));
    QCOMPARE(cues[0].event, std::string("panic"));
    QCOMPARE(cues[0].key, std::string("F3"));
    const auto shown = [&] { return desk.dock->findChild<QToolButton*>(QStringLiteral("cue1")); };
    QTRY_VERIFY(shown() != nullptr && shown()->isVisible());
    QVERIFY(shown()->text().contains(QStringLiteral("panic")));
    QString said;
    connect(&desk.state, &EditorState::statusMessage, &desk.window,
            [&said](const QString& text) { said = text; });
    QTest::mouseClick(shown(), Qt::LeftButton);
    QVERIFY2(said.contains(QStringLiteral("Play")), qPrintable(said)); // nobody listens yet
    QCOMPARE(desk.window.findChildren<QShortcut*>().size(), 1);
    desk.document.undoStack().undo();
    QCOMPARE(cues[0].event, std::string("cheer"));
    desk.document.undoStack().undo();
    QVERIFY(desk.document.scene().cues.empty());
    QTRY_VERIFY(desk.window.findChildren<QShortcut*>().isEmpty());
}

void TestBehaviourDocks::cuesRecallStates()
{
    Desk<RulesDock> desk;
    QVERIFY(desk.isReady());
    testing::addPeople(desk.document, 3);
    const auto setHeight = [&desk](float height) {
        desk.document.edit(QStringLiteral("Height"), [&](model::SceneEdit& edit) {
            edit.setColumn(model::columns::height, edit.scene().population.ids(),
                           std::span<const float>(&height, 1));
        });
    };
    setHeight(1.5F);
    desk.document.edit(QStringLiteral("Keep"), [](model::SceneEdit& edit) {
        putState(edit, keepState(edit.scene(), "tall", model::usualStateColumns(),
                                 edit.scene().population.ids()));
    });
    setHeight(1.0F);
    QTest::mouseClick(desk.dock->findChild<QToolButton*>(QStringLiteral("addCue")), Qt::LeftButton);
    const auto field = [&desk](const char* name) {
        return desk.dock->findChild<CueForm*>(QStringLiteral("cueForm"))
            ->findChild<QWidget*>(QLatin1String(name));
    };
    const auto& cues = desk.document.scene().cues;
    QVERIFY2(field("cueSeconds") == nullptr, "it recalls nothing yet");
    auto* states = qobject_cast<QComboBox*>(field("cueState"));
    QCOMPARE(states->count(), 2);
    states->setCurrentIndex(1);
    Q_EMIT states->activated(1);
    QCOMPARE(cues[0].state, model::StateId{1});
    QTRY_VERIFY(field("cueSpread") != nullptr);
    crowd::testing::type(
        *qobject_cast<QAbstractSpinBox*>(field("cueSpread"))->findChild<QLineEdit*>(),
        QStringLiteral("2"));
    QTRY_COMPARE(cues[0].spread, 2.0F);
    QTRY_VERIFY(field("cuePoint") != nullptr);
    QTest::mouseClick(qobject_cast<QToolButton*>(field("cuePoint")), Qt::LeftButton);
    desk.state.offerPoint({0.0F, 0.0F, 7.0F});
    QCOMPARE(cues[0].point, glm::vec3(0.0F, 0.0F, 7.0F));
    // Without an event it is called after the state.
    auto* event = qobject_cast<QLineEdit*>(field("cueEvent"));
    event->setFocus();
    event->selectAll();
    QTest::keyClick(event, Qt::Key_Delete);
    QTest::keyClick(event, Qt::Key_Return);
    QTRY_VERIFY(cues[0].event.empty());
    QTRY_VERIFY(desk.dock->findChild<QToolButton*>(QStringLiteral("cue1"))
                    ->text()
                    .contains(QStringLiteral("tall")));
    QString said;
    connect(&desk.state, &EditorState::statusMessage, &desk.window,
            [&said](const QString& text) { said = text; });
    desk.state.transport().setPlaying(false);
    sendCue(desk.state, cues[0]);
    QVERIFY2(said.contains(QStringLiteral("Press Play")), qPrintable(said));
    desk.state.transport().setPlaying(true);
    sendCue(desk.state, cues[0]);
    QVERIFY2(said.contains(QStringLiteral("tall")), qPrintable(said));
    const auto areTall = [&desk] {
        desk.state.advance(0.02);
        QTest::qWait(1);
        const auto shown = desk.state.frame()->population.column(model::columns::height);
        return std::ranges::all_of(shown, [](float each) { return each == 1.5F; });
    };
    QTRY_VERIFY_WITH_TIMEOUT(areTall(), 20'000);
    QCOMPARE(desk.document.scene().population.column(model::columns::height)[0], 1.0F);
    // The state is gone.
    desk.document.edit(QStringLiteral("Gone"), [](model::SceneEdit& edit) { edit.setStates({}); });
    sendCue(desk.state, cues[0]);
    QVERIFY2(said.contains(QStringLiteral("not there any more")), qPrintable(said));
}

void TestBehaviourDocks::aCueSaysThatTheGroundIsStillSought()
{
    Desk<RulesDock> desk;
    model::Cue cue;
    cue.id = 1;
    cue.event = "run";
    {
        const auto edit = desk.document.beginEdit().value();
        model::Rule rule;
        rule.trigger = model::triggers::Event{"run"};
        rule.actions.emplace_back(model::actions::Flee());
        edit->setRules({rule});
        edit->setCues({cue});
        edit->commit(QStringLiteral("Rules"));
    }
    testing::addPeople(desk.document, 1);
    QString said;
    connect(&desk.state, &EditorState::statusMessage, &desk.window,
            [&said](const QString& text) { said = text; });
    desk.state.transport().setPlaying(true);
    desk.state.advance(0.01); // the stage is looked at from now on
    QVERIFY(!desk.state.session().isRunning());
    desk.state.advance(0.5);
    QCOMPARE(desk.state.transport().seconds(), 0.0); // the run will have all of time
    sendCue(desk.state, cue);
    QVERIFY2(said.contains(QStringLiteral("still being found")), qPrintable(said));
    QTRY_VERIFY_WITH_TIMEOUT(desk.state.session().surfaceProgress() < 0.0, 10'000);
    desk.state.advance(0.01);
    QVERIFY(desk.state.session().isRunning());
    QCOMPARE(desk.state.session().firstSeconds(), 0.0);
    sendCue(desk.state, cue);
    QVERIFY2(said.contains(QStringLiteral("run")), qPrintable(said));
}

void TestBehaviourDocks::tagsAndNumbersGetNames()
{
    Desk<RulesDock> desk;
    QVERIFY(desk.isReady());
    auto* fold = desk.dock->findChild<QToolButton*>(QStringLiteral("foldNames"));
    fold->setChecked(true);
    const auto press = [&](const char* name) {
        auto* button = desk.dock->findChild<QToolButton*>(QLatin1String(name));
        QVERIFY(button != nullptr);
        QTest::mouseClick(button, Qt::LeftButton);
    };
    press("addTagName");
    QCOMPARE(desk.document.scene().tags.size(), std::size_t{1});
    const auto fieldNamed = [&](const QString& text) -> QLineEdit* {
        for (QLineEdit* field : desk.all<QLineEdit>()) {
            if (field->text() == text) {
                return field;
            }
        }
        return nullptr;
    };
    const QString given = QString::fromStdString(desk.document.scene().tags[0].name);
    QTRY_VERIFY(fieldNamed(given) != nullptr);
    testing::type(*fieldNamed(given), QStringLiteral("brave"));
    QCOMPARE(desk.document.scene().tags[0].name, std::string("brave"));
    QCOMPARE(tagText(desk.document.scene(), 0), QStringLiteral("brave"));
    QTRY_VERIFY(fieldNamed(QStringLiteral("brave")) != nullptr);
    press("addNumberName");
    QCOMPARE(desk.document.scene().numbers.size(), std::size_t{1});
    QTRY_VERIFY(desk.all<NumberField>().size() == 2);
    testing::type(*desk.all<NumberField>()[1], QStringLiteral("5"));
    QCOMPARE(desk.document.scene().numbers[0].high, 5.0F);
    QTRY_VERIFY(desk.all<NumberField>().size() == 2);
    testing::type(*desk.all<NumberField>()[0], QStringLiteral("7"));
    QCOMPARE(desk.document.scene().numbers[0].low, 7.0F);
    QCOMPARE(desk.document.scene().numbers[0].high, 7.0F); // never the wrong way round
    for (int i = 0; i < 5; ++i) {
        desk.document.undoStack().undo();
    }
    QVERIFY(desk.document.scene().tags.empty() && desk.document.scene().numbers.empty());
}

void TestBehaviourDocks::tagsAreWrittenByName()
{
    const std::vector<model::TagName> names{{0, "brave", {}}, {4, "late", {}}, {9, "", {}}};
    QCOMPARE(tagListText(names, 0), QString());
    const std::uint64_t some = 1U | 1U << 2U | 1U << 3U | 1U << 4U | 1U << 9U;
    QCOMPARE(tagListText(names, some), QStringLiteral("brave, late, 3, 4, 10"));
    QCOMPARE(tagListOf(names, tagListText(names, some)), some);
    QCOMPARE(tagListOf(names, QStringLiteral("LATE , 2-3, nobody")),
             std::uint64_t{1U << 4U | 1U << 1U | 1U << 2U});
    QCOMPARE(tagListOf(names, QStringLiteral("65, 0, 64")), std::uint64_t{1} << 63U);
}

void TestBehaviourDocks::branchesAreAddedWeighedAndRemoved()
{
    Desk<EnvironmentDock> desk;
    QVERIFY(desk.isReady());
    furnish(desk.document);
    desk.state.paths().select({});
    desk.state.paths().look(1);
    const auto add = [&] {
        return desk.dock->findChild<QToolButton*>(QStringLiteral("addBranch"));
    };
    QTRY_VERIFY(add() != nullptr);
    QVERIFY(!add()->isEnabled()); // there is nowhere to branch off to
    auto edit = desk.document.beginEdit().value();
    model::Place place;
    place.position = {6.0F, 0.05F, 9.0F};
    model::appendPlace(*edit, 0, place, model::PathKind::Simple);
    edit->commit(QStringLiteral("Another"));
    QTRY_VERIFY(add() != nullptr && add()->isEnabled());
    QTest::mouseClick(add(), Qt::LeftButton);
    const auto& scene = desk.document.scene();
    // From the place that is nearest to where the other path begins.
    QCOMPARE(scene.findPath(1)->branches, (std::vector<model::PathBranch>{{2, 2, 1.0F}}));
    QTRY_COMPARE(desk.all<QDoubleSpinBox>().size(), 1);
    desk.all<QDoubleSpinBox>()[0]->setValue(3.0);
    QCOMPARE(scene.findPath(1)->branches[0].weight, 3.0F);
    desk.document.undoStack().undo();
    desk.document.undoStack().undo();
    QVERIFY(scene.findPath(1)->branches.empty());
    QTRY_COMPARE(desk.all<QDoubleSpinBox>().size(), 0);
}

void TestBehaviourDocks::linesBecomeAreas()
{
    Desk<EnvironmentDock> desk;
    QVERIFY(desk.isReady());
    furnish(desk.document);
    auto edit = desk.document.beginEdit().value();
    model::Place fence;
    fence.shape = model::PlaceShape::Line;
    model::setCorners(fence, std::vector<glm::vec3>{{0, 0, 0}, {4, 0, 0}, {4, 0, 3}});
    const model::PlaceId id = edit->addPlace(fence);
    edit->commit(QStringLiteral("Fence"));
    auto* shape = desk.dock->findChild<QComboBox*>(QStringLiteral("placeShape"));
    desk.state.paths().select({2});
    QTRY_VERIFY(desk.dock->findChild<NumberField*>(QStringLiteral("placeRadius"))->isVisible());
    QVERIFY(!shape->isVisible()); // a round one has no corners
    desk.state.paths().select({id});
    QTRY_VERIFY(shape->isVisible());
    QCOMPARE(shape->currentIndex(), static_cast<int>(model::PlaceShape::Line));
    Q_EMIT shape->activated(static_cast<int>(model::PlaceShape::Area));
    QCOMPARE(desk.document.scene().findPlace(id)->shape, model::PlaceShape::Area);
    auto* facts = desk.dock->findChild<QLabel*>(QStringLiteral("placeShapeFacts"));
    QTRY_VERIFY2(facts->text().contains(QStringLiteral("3 corner")), qPrintable(facts->text()));
    desk.document.undoStack().undo();
    QCOMPARE(desk.document.scene().findPlace(id)->shape, model::PlaceShape::Line);
    model::Place wall = *desk.document.scene().findPlace(id);
    wall.corners.pop_back();
    desk.document.edit(QStringLiteral("Shorter"),
                       [&](model::SceneEdit& each) { each.changePlace(wall); });
    const auto* offered = qobject_cast<QStandardItemModel*>(shape->model());
    QTRY_VERIFY(!offered->item(static_cast<int>(model::PlaceShape::Area))->isEnabled());
    QVERIFY(offered->item(static_cast<int>(model::PlaceShape::Round))->isEnabled());
}

void TestBehaviourDocks::roomSpeedAndSurfaceAreEdited()
{
    Desk<EnvironmentDock> desk;
    QVERIFY(desk.isReady());
    furnish(desk.document);
    desk.state.paths().select({2});
    const auto number = [&](const char* name) {
        return desk.dock->findChild<NumberField*>(QLatin1String(name));
    };
    QTRY_VERIFY(number("placeCapacity")->isVisible());
    testing::type(*number("placeCapacity"), QStringLiteral("12"));
    QCOMPARE(desk.document.scene().places[1].capacity, 12U);
    QVERIFY(!number("placeSpeed")->isVisible());
    auto* role = desk.dock->findChild<QComboBox*>(QStringLiteral("placeRole"));
    QCOMPARE(role->count(), static_cast<int>(model::PlaceRole::Preferred) + 1);
    Q_EMIT role->activated(static_cast<int>(model::PlaceRole::Slow));
    QTRY_VERIFY(number("placeSpeed")->isVisible());
    testing::type(*number("placeSpeed"), QStringLiteral("30"));
    QCOMPARE(desk.document.scene().places[1].speedShare, 0.3F);
    desk.dock->findChild<QToolButton*>(QStringLiteral("foldSurface"))->setChecked(true);
    QTRY_VERIFY(number("surfaceClimb")->isVisible());
    testing::type(*number("surfaceClimb"), QStringLiteral("0.25"));
    QCOMPARE(desk.document.scene().surface.climb, 0.25F);
    while (desk.document.undoStack().index() > 1) {
        desk.document.undoStack().undo(); // all but the furniture
    }
    QVERIFY(desk.document.scene().surface == model::SurfaceSettings());
    QCOMPARE(desk.document.scene().places[1].capacity, 0U);
}

void TestBehaviourDocks::theTreeShowsWhatWasJustMade()
{
    Desk<EnvironmentDock> desk;
    QVERIFY(desk.isReady());
    for (int i = 0; i < 20; ++i) {
        furnish(desk.document);
    }
    auto* tree = desk.dock->findChild<QTreeWidget*>();
    QTRY_COMPARE(tree->topLevelItemCount(), 20);
    const auto isSeen = [tree](const QTreeWidgetItem* item) {
        return item != nullptr &&
               tree->viewport()->rect().contains(tree->visualItemRect(item).center());
    };
    QVERIFY(!isSeen(tree->topLevelItem(19)));
    tree->topLevelItem(3)->setExpanded(false);
    furnish(desk.document);
    desk.state.paths().paint(21); // before the tree knows of it
    QTRY_COMPARE(tree->topLevelItemCount(), 21);
    QVERIFY(tree->topLevelItem(20)->isSelected());
    QTRY_VERIFY(isSeen(tree->topLevelItem(20)));
    QVERIFY(!tree->topLevelItem(3)->isExpanded()); // as it was left
    // Who has scrolled on since is left alone, until something else is chosen.
    tree->scrollToTop();
    auto edit = desk.document.beginEdit().value();
    const model::PlaceId made = edit->addPlace({0, "by itself"});
    edit->commit(QStringLiteral("A place"));
    QTRY_COMPARE(tree->topLevelItemCount(), 22);
    QVERIFY(isSeen(tree->topLevelItem(0)));
    desk.state.paths().select({made});
    QTRY_VERIFY(isSeen(tree->topLevelItem(21)->child(0)));
    QVERIFY(tree->topLevelItem(21)->child(0)->isSelected());
}

/// Somebody leaves by an exit, somebody stays in a place.
void TestBehaviourDocks::whileItRunsTheRunIsCounted()
{
    Desk<EnvironmentDock> desk;
    QVERIFY(desk.isReady());
    desk.state.transport().setPlaying(false);
    furnish(desk.document);
    const auto ids = testing::addPeople(desk.document, 2, 2.0F);
    auto edit = desk.document.beginEdit().value();
    model::Place exit = desk.document.scene().places[1];
    exit.role = model::PlaceRole::Exit;
    exit.position = {2.5F, 0.05F, 2.0F};
    edit->changePlace(exit);
    model::Place begin = desk.document.scene().places[0];
    begin.position = {-1.5F, 0.05F, 2.0F};
    begin.radius = 2.0F;
    edit->changePlace(begin);
    const std::vector<model::IndividualId> walker{ids[1]};
    edit->setColumn<model::PathId>(model::columns::path, walker, std::vector<model::PathId>{1});
    edit->commit(QStringLiteral("Let one walk"));
    auto* tree = desk.dock->findChild<QTreeWidget*>();
    const auto text = [tree](int place) {
        const QTreeWidgetItem* path = tree->topLevelItem(0);
        return path == nullptr ? QString() : (place < 0 ? path : path->child(place))->text(1);
    };
    QTRY_COMPARE(text(-1), QStringLiteral("1 characters"));
    QCOMPARE(text(0), QStringLiteral("2.00 m"));
    desk.state.transport().setPlaying(true);
    const auto plays = [&](const auto& isSo) {
        desk.state.advance(1.0 / 30.0);
        return isSo();
    };
    QTRY_VERIFY_WITH_TIMEOUT(plays([&] { return text(0).startsWith(QStringLiteral("1 in it")); }),
                             30000);
    QTRY_VERIFY_WITH_TIMEOUT(plays([&] { return text(-1) == QStringLiteral("0 characters"); }),
                             30000);
    desk.state.session().stop();
    QCOMPARE(text(-1), QStringLiteral("1 characters"));
    QCOMPARE(text(0), QStringLiteral("2.00 m"));
}

void TestBehaviourDocks::namesOfBranchesCanBeRead()
{
    Desk<EnvironmentDock> desk;
    desk.window.resize(240, 700);
    QVERIFY(desk.isReady());
    furnish(desk.document);
    furnish(desk.document);
    auto edit = desk.document.beginEdit().value();
    model::Path path = desk.document.scene().paths[0];
    path.branches.push_back({1, 2, 1.0F});
    edit->changePath(path);
    edit->commit(QStringLiteral("Branch"));
    desk.state.paths().look(1);
    const auto shows = [&](const QString& name) {
        for (const QComboBox* box : desk.all<QComboBox>()) {
            const int arrow = 28;
            if (box->currentText() == name) {
                return box->width() >= box->fontMetrics().horizontalAdvance(name) + arrow;
            }
        }
        return false;
    };
    QTRY_VERIFY(shows(QStringLiteral("at Place 1")));
    QVERIFY(shows(QStringLiteral("to Path 2")));
}

/// On a small screen the panel is some 380 pixels high.
void TestBehaviourDocks::everythingFitsASmallPanel()
{
    Desk<EnvironmentDock> desk;
    desk.window.resize(250, 400);
    QVERIFY(desk.isReady());
    furnish(desk.document);
    desk.state.paths().select({1});
    auto* area = qobject_cast<QScrollArea*>(desk.dock->widget());
    auto* tree = desk.dock->findChild<QTreeWidget*>();
    QTRY_VERIFY(tree->height() >= 120);
    QTRY_COMPARE(area->verticalScrollBar()->maximum(), 0);
    // What is left over is the tree's.
    const int before = tree->height();
    desk.window.resize(250, 600);
    QTRY_VERIFY(tree->height() >= before + 190);
}

CROWD_WINDOW_TEST(TestBehaviourDocks)
#include "tst_BehaviourDocks.moc"
