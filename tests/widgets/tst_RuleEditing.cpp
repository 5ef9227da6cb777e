// SPDX-License-Identifier: MIT
#include <QtTest/QTest>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QListWidget>
#include <QtWidgets/QMenu>
#include <QtWidgets/QScrollBar>
#include <QtWidgets/QToolButton>

#include "model/document/SceneEdit.h"
#include "tests/program/WindowTest.h"
#include "tests/widgets/Desk.h"
#include "widgets/docks/RulesDock.h"
#include "widgets/rules/RuleTexts.h"

using namespace crowd;
using namespace crowd::widgets;

namespace {

struct RulesDesk : crowd::testing::Desk<RulesDock>
{
    [[nodiscard]] QListWidget* list()
    {
        return dock->findChild<QListWidget*>(QStringLiteral("ruleList"));
    }
    [[nodiscard]] const std::vector<model::Rule>& rules() { return document.scene().rules; }
    void put(std::vector<model::Rule> rules)
    {
        document.edit(QStringLiteral("Rules"), [&rules](model::SceneEdit& edit) {
            edit.set<model::members::Rules>(std::move(rules));
        });
    }
    /// As from the menu of a button.
    void choose(const char* button, const QString& entry)
    {
        const auto* tool = dock->findChild<QToolButton*>(QLatin1String(button));
        QVERIFY(tool != nullptr && tool->menu() != nullptr);
        for (QAction* action : tool->menu()->actions()) {
            if (action->text() == entry) {
                action->trigger();
                return;
            }
        }
        QFAIL("no such entry");
    }
};

std::vector<model::Rule> someRules(model::RuleId count)
{
    std::vector<model::Rule> rules;
    for (model::RuleId id = 1; id <= count; ++id) {
        model::Rule& rule = rules.emplace_back();
        rule.id = id;
        rule.name = "rule " + std::to_string(id);
        rule.trigger = model::triggers::Event{"go" + std::to_string(id)};
        rule.actions.emplace_back(model::actions::AddTag());
    }
    return rules;
}

} // namespace

/// Rules under the hands of who edits them.
class TestRuleEditing : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theListStaysWhereItIs();
    void rowsFollowTheRules();
    void whatIsAddedIsChosenFirst();
    void coloursHaveNames();
    void tagsAreOfferedByName();
};

void TestRuleEditing::theListStaysWhereItIs()
{
    RulesDesk desk;
    QVERIFY(desk.isReady());
    desk.put(someRules(40));
    QTRY_COMPARE(desk.list()->count(), 40);
    desk.list()->setCurrentRow(0);
    QScrollBar& bar = *desk.list()->verticalScrollBar();
    int last = 0; // until the panel has its height
    int steady = 0;
    QTRY_VERIFY((steady = bar.maximum() == last ? steady + 1 : 0, last = bar.maximum(),
                 last > 0 && steady > 3));
    bar.setValue(bar.maximum());
    const int place = bar.value();
    std::vector<model::Rule> rules = desk.rules();
    rules[0].actions.emplace_back(model::actions::Stop());
    const QString before = desk.list()->item(0)->text();
    desk.put(rules);
    QTRY_VERIFY(desk.list()->item(0)->text() != before);
    QCoreApplication::processEvents();
    QCOMPARE(bar.value(), place);
    QCOMPARE(desk.list()->currentRow(), 0);
}

void TestRuleEditing::rowsFollowTheRules()
{
    RulesDesk desk;
    QVERIFY(desk.isReady());
    desk.put(someRules(3));
    QTRY_COMPARE(desk.list()->count(), 3);
    desk.list()->setCurrentRow(1);
    std::vector<model::Rule> rules = desk.rules();
    std::swap(rules[1], rules[2]);
    rules[0].isEnabled = false;
    desk.put(rules);
    QTRY_COMPARE(desk.list()->currentRow(), 2); // where the chosen one has gone
    QCOMPARE(desk.list()->item(0)->checkState(), Qt::Unchecked);
    rules.erase(rules.begin() + 2);
    desk.put(rules);
    QTRY_COMPARE(desk.list()->count(), 2);
    QVERIFY(desk.list()->item(1)->text().contains(QStringLiteral("go3")));
    desk.document.undoStack().undo();
    QTRY_COMPARE(desk.list()->count(), 3);
}

void TestRuleEditing::whatIsAddedIsChosenFirst()
{
    RulesDesk desk;
    QVERIFY(desk.isReady());
    desk.put(someRules(1));
    QTRY_COMPARE(desk.list()->count(), 1);
    desk.list()->setCurrentRow(0);
    desk.choose("addCondition", QStringLiteral("is seated"));
    QCOMPARE(desk.rules()[0].conditions.size(), std::size_t{1});
    QVERIFY(desk.rules()[0].conditions[0].is<model::conditions::IsSeated>());
    QTRY_VERIFY(desk.dock->findChild<QToolButton*>(QStringLiteral("addAction")) != nullptr);
    QCoreApplication::processEvents();
    desk.choose("addAction", QStringLiteral("stand up"));
    QCOMPARE(desk.rules()[0].actions.size(), std::size_t{2});
    QVERIFY(desk.rules()[0].actions[1].is<model::actions::StandUp>());
}

void TestRuleEditing::coloursHaveNames()
{
    const model::Scene scene;
    model::Rule rule = someRules(1)[0];
    rule.actions.clear();
    model::actions::SetProperty paint; // its colour
    const auto said = [&](model::PaintColor color) {
        paint.color = color;
        rule.actions = {paint};
        return ruleSentence(scene, rule);
    };
    const std::pair<model::PaintColor, const char*> named[] = {
        {{200, 60, 60}, "red"},     {{240, 150, 40}, "orange"}, {{120, 80, 40}, "brown"},
        {{250, 220, 60}, "yellow"}, {{60, 160, 70}, "green"},   {{60, 90, 200}, "blue"},
        {{250, 250, 250}, "white"}, {{10, 10, 12}, "black"},    {{128, 128, 128}, "grey"}};
    for (const auto& [color, name] : named) {
        QVERIFY2(said(color).contains(QLatin1String(name)), qPrintable(said(color)));
        QVERIFY2(!said(color).contains(u'#'), qPrintable(said(color)));
    }
}

void TestRuleEditing::tagsAreOfferedByName()
{
    RulesDesk desk;
    QVERIFY(desk.isReady());
    desk.document.edit(QStringLiteral("Tags"), [](model::SceneEdit& edit) {
        edit.set<model::members::Tags>({{7, "brave", {}}, {2, "shy", {}}});
    });
    std::vector<model::Rule> rules = someRules(1); // it gives the first tag
    desk.put(rules);
    QTRY_COMPARE(desk.list()->count(), 1);
    desk.list()->setCurrentRow(0);
    QComboBox* tags = nullptr;
    for (QComboBox* each : desk.dock->findChildren<QComboBox*>()) {
        tags = each->findText(QStringLiteral("tag brave")) >= 0 ? each : tags;
    }
    QVERIFY(tags != nullptr);
    QVERIFY2(tags->count() == 4, qPrintable(QString::number(tags->count())));
    QCOMPARE(tags->currentText(), QStringLiteral("tag no. 1"));
    QVERIFY(tags->itemText(3).startsWith(QStringLiteral("a new tag")));
    Q_EMIT tags->activated(tags->findText(QStringLiteral("tag brave")));
    QCOMPARE(int{desk.rules()[0].actions[0].as<model::actions::AddTag>()->tag}, 7);
    QTRY_VERIFY2(desk.list()->item(0)->text().contains(QStringLiteral("brave")),
                 qPrintable(desk.list()->item(0)->text()));
}

CROWD_WINDOW_TEST(TestRuleEditing)
#include "tst_RuleEditing.moc"
