// SPDX-License-Identifier: MIT
#include <QtWidgets/QComboBox>
#include <QtWidgets/QDoubleSpinBox>
#include <QtWidgets/QListWidget>
#include <QtWidgets/QMenu>
#include <QtWidgets/QToolButton>

#include "model/document/SceneEdit.h"
#include "tests/program/WindowTest.h"
#include "tests/widgets/Desk.h"
#include "widgets/docks/RulesDock.h"
#include "widgets/rules/CueForm.h"
#include "widgets/rules/RuleEditor.h"
#include "widgets/rules/RuleProblems.h"
#include "widgets/rules/RuleTexts.h"

using namespace crowd;
using namespace crowd::widgets;
using crowd::testing::Desk;

namespace {

namespace actions = model::actions;
namespace triggers = model::triggers;

using RulesDesk = Desk<RulesDock>;

/// What is seen of that name now.
template<class Widget>
Widget* seen(const RulesDesk& desk, const char* name)
{
    for (Widget* widget : desk.all<Widget>()) {
        if (widget->objectName() == QLatin1String(name)) {
            return widget;
        }
    }
    return nullptr;
}

/// What is shown of that name: forms that were replaced are gone.
template<class Widget>
Widget* shown(RulesDesk& desk, const char* name)
{
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    QCoreApplication::processEvents(); // what is new is shown
    return seen<Widget>(desk, name);
}

void activate(QComboBox& box, int index)
{
    box.setCurrentIndex(index);
    Q_EMIT box.activated(index);
}

void press(RulesDesk& desk, const char* name, int which = 0)
{
    (void)shown<QWidget>(desk, "");
    QList<QToolButton*> buttons;
    for (QToolButton* button : desk.all<QToolButton>()) {
        if (button->objectName() == QLatin1String(name)) {
            buttons << button;
        }
    }
    QVERIFY2(buttons.size() > which, name);
    QTest::mouseClick(buttons[which], Qt::LeftButton);
}

void giveRule(RulesDesk& desk, const model::Rule& rule)
{
    auto edit = desk.document.beginEdit().value();
    edit->setRules({rule});
    edit->commit(QStringLiteral("Rule"));
    auto* list = desk.dock->findChild<QListWidget*>();
    QTRY_COMPARE(list->count(), 1);
    list->setCurrentRow(0);
}

model::Rule ruleOf(std::vector<model::Action> actions)
{
    model::Rule rule;
    rule.id = 1;
    rule.trigger = triggers::Event{"go"};
    rule.actions = std::move(actions);
    return rule;
}

} // namespace

class TestRulePanel : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aCueIsChangedInPlace();
    void keysOfOtherCuesAreNotOffered();
    void blocksAreBuiltWithButtons();
    void weightsOfClipsAreEdited();
    void clipsAreTickedOneAfterTheOther();
    void countsAreWholeNumbers();
    void sentencesTellWhatRepeatsAndWhatIsDrawn();
    void blocksSayWhatIsMissing();
    void theFieldKeepsTheKeyboard();
    void whatIsAddedIsInSight_data();
    void whatIsAddedIsInSight();
    void longNamesOfCuesStandAlone();
};

void TestRulePanel::whatIsAddedIsInSight_data()
{
    QTest::addColumn<QSize>("size");
    QTest::newRow("along the bottom") << QSize(1200, 320);
    QTest::newRow("at the side") << QSize(300, 400);
}

/// Though the button that adds it stands at the other end of a long rule; list and cues stay where
/// they are while there is room beside it.
void TestRulePanel::whatIsAddedIsInSight()
{
    QFETCH(QSize, size);
    RulesDesk desk;
    desk.window.resize(size);
    QVERIFY(desk.isReady());
    desk.window.resizeDocks({desk.dock}, {size.width()}, Qt::Horizontal);
    giveRule(desk, ruleOf(std::vector<model::Action>(14, actions::Wait{1.0F})));
    auto* list = desk.dock->findChild<QListWidget*>();
    const auto isInSight = [](const QWidget* widget) {
        return widget != nullptr && widget->visibleRegion().boundingRect() == widget->rect();
    };
    QTRY_VERIFY(shown<QToolButton>(desk, "addCondition") != nullptr);
    const auto place = [&desk, list] { return list->mapTo(&desk.window, QPoint(0, 0)); };
    const QPoint before = place();
    const QList<QMenu*> menus = shown<QToolButton>(desk, "addCondition")->findChildren<QMenu*>();
    menus.front()->actions().front()->trigger();
    QTRY_COMPARE(desk.document.scene().rules[0].conditions.size(), std::size_t{1});
    const auto* editor = desk.dock->findChild<RuleEditor*>();
    QTRY_VERIFY((editor = desk.dock->findChild<RuleEditor*>()) != nullptr &&
                editor->lastCondition() != nullptr && isInSight(editor->lastCondition()));
    QTRY_VERIFY(editor->lastCondition()->hasFocus());
    if (size.width() > size.height()) {
        QCOMPARE(place(), before);
    }
}

/// Else they would run under the arrow beside them.
void TestRulePanel::longNamesOfCuesStandAlone()
{
    RulesDesk desk;
    QVERIFY(desk.isReady());
    auto edit = desk.document.beginEdit().value();
    edit->setCues(
        {{1, "Bored", "a", 0.0F, "F3"}, {2, "Disappointed by the end of it", "b", 0.0F, "F4"}});
    edit->commit(QStringLiteral("Cues"));
    // Sizes that the window manager still gives would make it untrue again between two looks.
    const auto areWhole = [&desk](bool areBeside) {
        const auto* first = seen<QToolButton>(desk, "cue1");
        const auto* second = seen<QToolButton>(desk, "cue2");
        return first != nullptr && second != nullptr && (first->y() == second->y()) == areBeside &&
               (areBeside || second->width() >= second->sizeHint().width());
    };
    QTRY_VERIFY(areWhole(false));
    QVERIFY(QTest::qWaitForWindowExposed(&desk.window));
    desk.window.resize(620, 700);
    desk.window.resizeDocks({desk.dock}, {620}, Qt::Horizontal);
    QTRY_VERIFY(areWhole(true));
}

void TestRulePanel::aCueIsChangedInPlace()
{
    RulesDesk desk;
    QVERIFY(desk.isReady());
    press(desk, "addCue");
    const auto& cues = desk.document.scene().cues;
    QCOMPARE(cues.size(), std::size_t{1});
    QVERIFY(shown<QWidget>(desk, "cueForm") != nullptr);
    crowd::testing::type(*shown<QLineEdit>(desk, "cueName"), QStringLiteral("Run!"));
    QCOMPARE(cues[0].name, std::string("Run!"));
    crowd::testing::type(*shown<QLineEdit>(desk, "cueEvent"), QStringLiteral("run"));
    QCOMPARE(cues[0].event, std::string("run"));
    crowd::testing::type(*shown<QLineEdit>(desk, "cueEvent"), QString());
    QCOMPARE(cues[0].event, std::string("run")); // a cue needs one
    shown<QDoubleSpinBox>(desk, "cuePayload")->setValue(3.5);
    QCOMPARE(cues[0].payload, 3.5F);
    activate(*shown<QComboBox>(desk, "cueReach"), static_cast<int>(model::CueReach::Tagged));
    QVERIFY(cues[0].reach == model::CueReach::Tagged);
    activate(*shown<QComboBox>(desk, "cueKey"), 0);
    QVERIFY(cues[0].key.empty());
    // Each is a step of its own, and the form follows.
    desk.document.undoStack().undo();
    QCOMPARE(cues[0].key, std::string("F3"));
    desk.document.undoStack().undo();
    QVERIFY(cues[0].reach == model::CueReach::Everybody);
    desk.document.undoStack().undo();
    QCOMPARE(shown<QDoubleSpinBox>(desk, "cuePayload")->value(), 0.0);
    press(desk, "cueDone");
    QVERIFY(shown<QWidget>(desk, "cueForm") == nullptr);
    QCOMPARE(cues.size(), std::size_t{1});
}

void TestRulePanel::keysOfOtherCuesAreNotOffered()
{
    RulesDesk desk;
    QVERIFY(desk.isReady());
    press(desk, "addCue");
    press(desk, "addCue");
    QCOMPARE(desk.document.scene().cues[1].key, std::string("F4"));
    auto* keys = shown<QComboBox>(desk, "cueKey");
    QCOMPARE(keys->findText(QStringLiteral("F3")), -1);
    QVERIFY(keys->findText(QStringLiteral("F10")) >= 0);
}

void TestRulePanel::blocksAreBuiltWithButtons()
{
    RulesDesk desk;
    QVERIFY(desk.isReady());
    giveRule(desk, ruleOf({actions::Repeat(), actions::Stop()}));
    const auto lines = [&] { return desk.document.scene().rules[0].actions; };
    QTRY_VERIFY(shown<QToolButton>(desk, "addInside") != nullptr);
    press(desk, "addInside");
    QCOMPARE(lines().size(), std::size_t{3});
    QVERIFY(lines()[1].is<actions::Wait>() && lines()[1].depth == 1);
    // The last line up: into the repeat.
    const auto arrows = [&] {
        QList<QToolButton*> up;
        for (QToolButton* button : desk.all<QToolButton>()) {
            if (button->arrowType() == Qt::UpArrow) {
                up << button;
            }
        }
        return up;
    };
    QTRY_COMPARE(arrows().size(), 3);
    QVERIFY(!arrows()[0]->isEnabled());
    QTest::mouseClick(arrows()[2], Qt::LeftButton);
    QVERIFY(lines()[2].is<actions::Stop>() && lines()[2].depth == 1);
    desk.document.undoStack().undo();
    QCOMPARE(int{lines()[2].depth}, 0);
    giveRule(desk, ruleOf({actions::OneOf()}));
    QTRY_VERIFY(shown<QToolButton>(desk, "addAlternative") != nullptr);
    press(desk, "addAlternative");
    QCOMPARE(lines().size(), std::size_t{2});
    QVERIFY(lines()[1].is<actions::OneOf>() && lines()[1].depth == 0);
}

void TestRulePanel::weightsOfClipsAreEdited()
{
    RulesDesk desk;
    QVERIFY(desk.isReady());
    actions::PlayClip play;
    play.clips = {{"clap", 1.0F}, {"cheer", 2.0F}};
    giveRule(desk, ruleOf({play}));
    const auto weights = [&] {
        QList<QDoubleSpinBox*> found;
        for (QDoubleSpinBox* box : desk.all<QDoubleSpinBox>()) {
            if (box->toolTip().contains(QStringLiteral("against the others"))) {
                found << box;
            }
        }
        return found;
    };
    QTRY_COMPARE(weights().size(), 2);
    QCOMPARE(weights()[1]->value(), 2.0);
    weights()[1]->setValue(5.0);
    QCOMPARE(desk.document.scene().rules[0].actions[0].as<actions::PlayClip>()->clips[1].weight,
             5.0F);
    desk.document.undoStack().undo();
    QCOMPARE(desk.document.scene().rules[0].actions[0].as<actions::PlayClip>()->clips[1].weight,
             2.0F);
}

void TestRulePanel::clipsAreTickedOneAfterTheOther()
{
    RulesDesk desk;
    QVERIFY(desk.isReady());
    actions::PlayClip play;
    play.clips = {{"clap", 1.0F}, {"cheer", 2.0F}};
    giveRule(desk, ruleOf({play}));
    QMenu* menu = nullptr;
    QTRY_VERIFY(([&] {
        for (const QToolButton* button : desk.all<QToolButton>()) {
            menu = button->text().startsWith(QStringLiteral("clap")) ? button->menu() : menu;
        }
        return menu != nullptr;
    })());
    menu->popup(desk.window.mapToGlobal(QPoint(20, 20)));
    const auto tick = [menu](const char* name) {
        for (QAction* action : menu->actions()) {
            if (action->text() == QLatin1String(name)) {
                QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(action).center());
            }
        }
    };
    tick("clap");
    QVERIFY2(menu->isVisible(), "the next one can be ticked");
    tick("cheer");
    tick("clap");
    QVERIFY(menu->isVisible());
    const auto& rules = desk.document.scene().rules;
    QCOMPARE(rules[0].actions[0].as<actions::PlayClip>()->clips.size(),
             std::size_t{2}); // until it closes
    menu->close();
    QTRY_COMPARE(rules[0].actions[0].as<actions::PlayClip>()->clips.size(), std::size_t{1});
    QCOMPARE(rules[0].actions[0].as<actions::PlayClip>()->clips[0].clip, std::string("clap"));
    desk.document.undoStack().undo();
    QVERIFY(rules[0].actions[0].as<actions::PlayClip>()->clips == play.clips);
}

void TestRulePanel::countsAreWholeNumbers()
{
    RulesDesk desk;
    QVERIFY(desk.isReady());
    giveRule(desk, ruleOf({actions::Repeat(), actions::Stop()}));
    const auto shows = [&desk](const QString& text) {
        return std::ranges::any_of(desk.all<QDoubleSpinBox>(),
                                   [&](const QDoubleSpinBox* box) { return box->text() == text; });
    };
    QTRY_VERIFY(shows(QStringLiteral("2 ×")));
}

void TestRulePanel::sentencesTellWhatRepeatsAndWhatIsDrawn()
{
    model::Scene scene;
    const model::Rule rule = ruleOf({actions::Repeat{3},
                                     {actions::OneOf{3.0F}, 1},
                                     {actions::Wait{2.0F}, 2},
                                     {actions::OneOf{1.0F}, 1},
                                     {actions::Stop(), 2},
                                     actions::GoOn()});
    QCOMPARE(
        ruleSentence(scene, rule),
        QStringLiteral("When “go” reaches someone: repeat 3 × (either (wait about 2 s) 75 % or "
                       "(stop) 25 %), then walk on"));
}

void TestRulePanel::blocksSayWhatIsMissing()
{
    const model::Scene scene;
    QVERIFY(ruleProblem(scene, ruleOf({actions::Repeat()}))
                .contains(QStringLiteral("nothing to repeat")));
    QVERIFY(ruleProblem(scene, ruleOf({actions::OneOf()}))
                .contains(QStringLiteral("only one to choose")));
    actions::OneOf never;
    never.weight = 0.0F;
    QVERIFY(ruleProblem(scene, ruleOf({never, never})).contains(QStringLiteral("ever comes")));
    actions::Follow after;
    after.aim = model::ActionAim::Place;
    QVERIFY(ruleProblem(scene, ruleOf({after})).contains(QStringLiteral("nobody to go after")));
    actions::LookAt look;
    look.aim = model::ActionAim::Place;
    look.place = 9;
    QVERIFY(ruleProblem(scene, ruleOf({look})).contains(QStringLiteral("not there any more")));
    QVERIFY(ruleProblem(scene, ruleOf({actions::LookAt()})).isEmpty());
}

/// Whoever tabs from one field to the next types into that, also though both were made anew.
void TestRulePanel::theFieldKeepsTheKeyboard()
{
    RulesDesk desk;
    QVERIFY(desk.isReady());
    desk.window.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&desk.window));
    press(desk, "addCue");
    auto* name = shown<QLineEdit>(desk, "cueName");
    name->setFocus();
    QTRY_VERIFY(name->hasFocus());
    QTest::keyClicks(name, QStringLiteral("Go"));
    shown<QLineEdit>(desk, "cueEvent")->setFocus(Qt::TabFocusReason);
    QTRY_COMPARE(desk.document.scene().cues[0].name, std::string("Go"));
    QTRY_VERIFY(shown<QLineEdit>(desk, "cueEvent")->hasFocus());
}

CROWD_WINDOW_TEST(TestRulePanel)
#include "tst_RulePanel.moc"
