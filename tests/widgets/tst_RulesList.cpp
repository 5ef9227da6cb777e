// SPDX-License-Identifier: MIT
#include <utility>
#include <vector>

#include <QtGui/QAction>
#include <QtGui/QContextMenuEvent>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QListWidget>
#include <QtWidgets/QMenu>
#include <QtWidgets/QPlainTextEdit>
#include <QtWidgets/QToolButton>

#include "model/document/SceneEdit.h"
#include "tests/program/WindowTest.h"
#include "tests/widgets/Desk.h"
#include "widgets/docks/RulesDock.h"
#include "widgets/rules/RuleItemDelegate.h"
#include "widgets/rules/RuleTexts.h"

using namespace crowd;
using namespace crowd::widgets;

namespace {

/// Three rules, of which the second one is chosen.
struct RulesListDesk : crowd::testing::Desk<RulesDock>
{
    [[nodiscard]] bool begin()
    {
        std::vector<model::Rule> rules(3);
        for (std::size_t i = 0; i < rules.size(); ++i) {
            rules[i].id = static_cast<model::RuleId>(i + 1);
            rules[i].trigger = model::triggers::Event{"event" + std::to_string(i + 1)};
        }
        auto edit = document.beginEdit().value();
        edit->setRules(std::move(rules));
        edit->commit(QStringLiteral("Rules"));
        list = dock->findChild<QListWidget*>(QStringLiteral("ruleList"));
        return isReady() && QTest::qWaitFor([this] { return list->count() == 3; }) && choose(1);
    }
    [[nodiscard]] bool choose(int row)
    {
        list->setCurrentRow(row);
        return list->currentRow() == row;
    }
    [[nodiscard]] QAction* action(const char* name) const
    {
        return dock->findChild<QAction*>(QLatin1String(name));
    }
    /// The rules' ids in their order.
    [[nodiscard]] std::vector<model::RuleId> order() const
    {
        std::vector<model::RuleId> ids;
        for (const model::Rule& rule : document.scene().rules) {
            ids.push_back(rule.id);
        }
        return ids;
    }

    QListWidget* list = nullptr;
};

using Ids = std::vector<model::RuleId>;

} // namespace

class TestRulesList : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void buttonsSayWhatTheyDo();
    void aRightClickOffersWhatTheButtonsDo();
    void rulesAreDuplicatedAndDeleted();
    void rulesAreMoved();
    void rulesAreSwitchedOffAndOn();
    void theListHasKeys();
    void conditionsReadAsSentences_data();
    void conditionsReadAsSentences();
    void leavingReadsAsASentence_data();
    void leavingReadsAsASentence();
    void whatLastsSaysHowLong();
    void countingMovesNothing();
    void theLogOfAnotherSceneIsForgotten();
};

void TestRulesList::buttonsSayWhatTheyDo()
{
    RulesListDesk desk;
    QVERIFY(desk.begin());
    for (const char* name : {"duplicateRule", "removeRule", "tryRule"}) {
        const auto* button = desk.dock->findChild<QToolButton*>(QLatin1String(name));
        QVERIFY2(button != nullptr && button->isEnabled(), name);
        QVERIFY2(!button->icon().isNull() && button->toolTip().contains(QStringLiteral("rule")),
                 name);
    }
    desk.list->setCurrentRow(-1);
    QVERIFY(!desk.dock->findChild<QToolButton*>(QStringLiteral("removeRule"))->isEnabled());
}

void TestRulesList::aRightClickOffersWhatTheButtonsDo()
{
    RulesListDesk desk;
    QVERIFY(desk.begin());
    QStringList offered;
    QTimer look;
    connect(&look, &QTimer::timeout, &desk.window, [&] {
        if (auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget())) {
            for (const QAction* action : menu->actions()) {
                if (!action->isSeparator()) {
                    offered << action->text();
                }
            }
            menu->close();
        }
    });
    look.start(10);
    const QPoint third = desk.list->visualItemRect(desk.list->item(2)).center();
    QContextMenuEvent event(QContextMenuEvent::Mouse, third,
                            desk.list->viewport()->mapToGlobal(third));
    QApplication::sendEvent(desk.list->viewport(), &event);
    QCOMPARE(offered,
             (QStringList{QStringLiteral("Duplicate"), QStringLiteral("Delete"),
                          QStringLiteral("Disable"), QStringLiteral("Move Up"),
                          QStringLiteral("Move Down"), QStringLiteral("Test on Selected")}));
    QCOMPARE(desk.list->currentRow(), 2); // what was clicked is what is meant
    QVERIFY(!desk.action("ruleDown")->isEnabled() && desk.action("ruleUp")->isEnabled());
}

void TestRulesList::rulesAreDuplicatedAndDeleted()
{
    RulesListDesk desk;
    QVERIFY(desk.begin());
    desk.action("ruleDuplicate")->trigger();
    QCOMPARE(desk.order(), (Ids{1, 2, 4, 3}));
    QTRY_COMPARE(desk.list->currentRow(), 2);
    desk.action("ruleDelete")->trigger();
    QCOMPARE(desk.order(), (Ids{1, 2, 3}));
    QTRY_COMPARE(desk.list->currentRow(), 2); // the next one, so that Delete goes on
    desk.action("ruleDelete")->trigger();
    QTRY_COMPARE(desk.list->currentRow(), 1);
    desk.action("ruleDelete")->trigger();
    desk.action("ruleDelete")->trigger();
    QVERIFY(desk.order().empty());
    QTRY_VERIFY(!desk.action("ruleDelete")->isEnabled());
    while (desk.document.undoStack().index() > 1) {
        desk.document.undoStack().undo();
    }
    QCOMPARE(desk.order(), (Ids{1, 2, 3}));
}

void TestRulesList::rulesAreMoved()
{
    RulesListDesk desk;
    QVERIFY(desk.begin());
    desk.action("ruleUp")->trigger();
    QCOMPARE(desk.order(), (Ids{2, 1, 3}));
    QTRY_COMPARE(desk.list->currentRow(), 0);
    QVERIFY(!desk.action("ruleUp")->isEnabled());
    desk.action("ruleDown")->trigger();
    desk.action("ruleDown")->trigger();
    QCOMPARE(desk.order(), (Ids{1, 3, 2}));
    QTRY_COMPARE(desk.list->currentRow(), 2);
    desk.document.undoStack().undo();
    QCOMPARE(desk.order(), (Ids{1, 2, 3}));
}

void TestRulesList::rulesAreSwitchedOffAndOn()
{
    RulesListDesk desk;
    QVERIFY(desk.begin());
    QAction& action = *desk.action("ruleSwitch");
    QCOMPARE(action.text(), QStringLiteral("Disable"));
    action.trigger();
    QVERIFY(!desk.document.scene().rules[1].isEnabled);
    QTRY_COMPARE(action.text(), QStringLiteral("Enable"));
    QTRY_COMPARE(desk.list->item(1)->checkState(), Qt::Unchecked);
    action.trigger();
    QVERIFY(desk.document.scene().rules[1].isEnabled);
}

void TestRulesList::theListHasKeys()
{
    RulesListDesk desk;
    QVERIFY(desk.begin());
    desk.window.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&desk.window));
    desk.list->setFocus();
    QTRY_VERIFY(desk.list->hasFocus());
    QTest::keyClick(desk.list, Qt::Key_Down, Qt::AltModifier);
    QTRY_COMPARE(desk.order(), (Ids{1, 3, 2}));
    QTRY_COMPARE(desk.list->currentRow(), 2);
    QTest::keyClick(desk.list, Qt::Key_D, Qt::ControlModifier);
    QTRY_COMPARE(desk.order().size(), std::size_t{4});
    QTest::keyClick(desk.list, Qt::Key_Delete);
    QTRY_COMPARE(desk.order(), (Ids{1, 3, 2}));
}

void TestRulesList::conditionsReadAsSentences_data()
{
    using namespace model::conditions;
    QTest::addColumn<model::Condition>("condition");
    QTest::addColumn<QString>("text");
    const auto add = [](const model::Condition& condition, const char* yes, const char* no) {
        model::Condition negated = condition;
        negated.isNot = true;
        QTest::newRow(yes) << condition << QString::fromUtf8(yes);
        QTest::newRow(no) << negated << QString::fromUtf8(no);
    };
    const auto above = [](auto kind) {
        kind.value = 3.0F;
        return kind;
    };
    add(HasTag(), "tagged no. 1", "not tagged no. 1");
    add(FollowsPath(), "walking any path", "not walking any path");
    add(IsSeated(), "seated", "not seated");
    add(Chance(), "by chance in 50 % of cases", "except by chance in 50 % of cases");
    add(above(Number()), "a number above 3", "a number not above 3");
    add(above(Speed()), "speed above 3", "speed not above 3");
    add(above(Payload()), "the event’s number above 3", "the event’s number not above 3");
    // Of a place that is still to be chosen.
    add(IsFull(), "… full", "… not full");
    add(above(PeopleIn()), "characters in … above 3", "characters in … not above 3");
    add(above(Property()), "height above 3", "height not above 3");
}

void TestRulesList::conditionsReadAsSentences()
{
    QFETCH(const model::Condition, condition);
    QFETCH(const QString, text);
    model::Rule rule;
    rule.trigger = model::triggers::Event{"go"};
    rule.conditions = {condition};
    rule.actions = {model::actions::Stop()};
    QCOMPARE(ruleSentence({}, rule),
             QStringLiteral("When “go” reaches someone (%1): stop").arg(text));
}

void TestRulesList::leavingReadsAsASentence_data()
{
    using model::PlaceChoice;
    QTest::addColumn<int>("choice");
    QTest::addColumn<model::PlaceId>("place");
    QTest::addColumn<model::PathId>("path");
    QTest::addColumn<QString>("text");
    const auto row = [](const char* text, PlaceChoice choice, model::PlaceId place,
                        model::PathId path) {
        QTest::newRow(text) << static_cast<int>(choice) << place << path << QString::fromUtf8(text);
    };
    row("leave the scene", PlaceChoice::Given, 0, 0);
    row("leave the scene at gate", PlaceChoice::Given, 1, 0);
    row("leave the scene at …", PlaceChoice::Given, model::kNotChosen, 0);
    row("leave the scene at the nearest exit", PlaceChoice::Nearest, 0, 0);
    row("leave the scene at the nearest place of way", PlaceChoice::Nearest, 0, 1);
    row("leave the scene at the nearest free exit", PlaceChoice::NearestFree, 0, 0);
    row("leave the scene at the nearest free place named gate", PlaceChoice::NearestFree, 1, 0);
    row("leave the scene at the first free place of way", PlaceChoice::FirstFree, 0, 1);
}

void TestRulesList::leavingReadsAsASentence()
{
    QFETCH(const int, choice);
    QFETCH(const model::PlaceId, place);
    QFETCH(const model::PathId, path);
    QFETCH(const QString, text);
    model::Scene scene;
    scene.places = {{1, "gate", {}, 1.0F}};
    scene.paths = {{1, "way", model::PathKind::Simple, {1}}};
    model::Rule rule;
    rule.trigger = model::triggers::Event{"go"};
    model::actions::LeaveScene leave;
    leave.choice = static_cast<model::PlaceChoice>(choice);
    leave.place = place;
    leave.path = path;
    rule.actions = {leave};
    QCOMPARE(ruleSentence(scene, rule), QStringLiteral("When “go” reaches someone: %1").arg(text));
}

void TestRulesList::whatLastsSaysHowLong()
{
    model::Rule rule;
    rule.trigger = model::triggers::Event{"go"};
    model::actions::Follow follow;
    follow.seconds = 0.0F;
    rule.actions = {follow};
    QVERIFY(ruleSentence({}, rule).endsWith(QStringLiteral("until something else comes")));
    follow.seconds = 5.0F;
    rule.actions = {follow};
    QVERIFY(ruleSentence({}, rule).endsWith(QStringLiteral("for 5 s")));
}

/// While it plays, each count has a column of its own.
void TestRulesList::countingMovesNothing()
{
    RulesListDesk desk;
    QVERIFY(desk.begin());
    std::vector<model::Rule> rules = desk.document.scene().rules;
    for (model::Rule& rule : rules) {
        rule.actions.emplace_back(model::actions::Stop());
    }
    auto edit = desk.document.beginEdit().value();
    edit->setRules(std::move(rules));
    edit->commit(QStringLiteral("Rules"));
    crowd::testing::addPeople(desk.document, 3, 2.0F);
    desk.state.transport().setPlaying(true);
    const auto plays = [&](const auto& isSo) {
        desk.state.advance(1.0 / 30.0);
        return isSo();
    };
    QTRY_VERIFY_WITH_TIMEOUT(plays([&] { return desk.state.session().isRunning(); }), 30000);
    const auto count = [&] { return desk.list->item(0)->data(kRuleCountRole).toString(); };
    QTRY_VERIFY(desk.list->item(0)->data(kRuleCountRole).isValid());
    QVERIFY(count().isEmpty());
    std::vector<QRect> before;
    int unchanged = 0;
    const auto isAtRest = [&] { // the list has its height, and the column its room
        std::vector<QRect> now{desk.list->geometry()};
        for (int row = 0; row < 3; ++row) {
            now.push_back(desk.list->visualItemRect(desk.list->item(row)));
        }
        unchanged = now == before ? unchanged + 1 : 0;
        before = std::move(now);
        return unchanged >= 5;
    };
    QTRY_VERIFY(isAtRest());
    model::EventSettings event;
    event.name = "event1";
    desk.state.session().send(event, desk.document.scene().population.ids());
    QTRY_VERIFY_WITH_TIMEOUT(plays([&] { return !count().isEmpty(); }), 30000);
    QCoreApplication::processEvents();
    for (int row = 0; row < 3; ++row) {
        QCOMPARE(desk.list->visualItemRect(desk.list->item(row)),
                 before[static_cast<std::size_t>(row) + 1]);
    }
    QCOMPARE(desk.list->geometry(), before.front());
}

void TestRulesList::theLogOfAnotherSceneIsForgotten()
{
    RulesListDesk desk;
    QVERIFY(desk.begin());
    auto* log = desk.dock->findChild<QPlainTextEdit*>(QStringLiteral("ruleLog"));
    std::vector<model::Rule> rules = desk.document.scene().rules;
    rules[0].trigger = model::triggers::Start();
    rules[0].actions.emplace_back(model::actions::Stop());
    auto edit = desk.document.beginEdit().value();
    edit->setRules(std::move(rules));
    edit->commit(QStringLiteral("Rules"));
    crowd::testing::addPeople(desk.document, 3, 2.0F);
    desk.state.transport().setPlaying(true);
    const auto plays = [&](const auto& isSo) {
        desk.state.advance(1.0 / 30.0);
        return isSo();
    };
    QTRY_VERIFY_WITH_TIMEOUT(plays([&] { return !log->toPlainText().isEmpty(); }), 30000);
    desk.state.session().stop();
    QVERIFY(!log->toPlainText().isEmpty()); // to be read after it has played
    desk.document.replaceScene(crowd::testing::smallTheatre(), {});
    QTRY_VERIFY(log->toPlainText().isEmpty());
}

CROWD_WINDOW_TEST(TestRulesList)
#include "tst_RulesList.moc"
