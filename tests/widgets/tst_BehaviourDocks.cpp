// SPDX-License-Identifier: MIT
#include <QtCore/QSettings>
#include <QtCore/QStandardPaths>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QListWidget>
#include <QtWidgets/QMenu>
#include <QtWidgets/QToolButton>
#include <QtWidgets/QTreeWidget>

#include "model/document/PathEdits.h"
#include "model/document/SceneEdit.h"
#include "tests/program/WindowTest.h"
#include "tests/widgets/Desk.h"
#include "widgets/docks/EnvironmentDock.h"
#include "widgets/docks/NumberField.h"
#include "widgets/docks/RuleTexts.h"
#include "widgets/docks/RulesDock.h"

using namespace crowd;
using namespace crowd::widgets;
using crowd::testing::Desk;

namespace {

/// A path over two places.
void furnish(model::SceneDocument& document)
{
    auto edit = document.beginEdit();
    model::Place place;
    place.position = {1.0F, 0.05F, 2.0F};
    const model::PathId path = model::appendPlace(*edit, 0, place, model::PathKind::Simple);
    place.position = {6.0F, 0.05F, 2.0F};
    model::appendPlace(*edit, path, place, model::PathKind::Simple);
    edit->commit(QStringLiteral("Furnish"));
}

template<class Dock>
void choose(Desk<Dock>& desk, const char* button, const QString& entry)
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
    choose(desk, "addRule", ruleSetName(model::RuleSet::Pedestrians));
    QTRY_COMPARE(list->count(), static_cast<int>(desk.document.scene().rules.size()));
    QVERIFY(list->count() >= 3);
    QVERIFY2(list->item(0)->text().contains(QStringLiteral("run")),
             qPrintable(list->item(0)->text()));
    QCOMPARE(desk.state.brush(model::BrushKind::Event).event.name, std::string("run"));
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
    for (const model::Rule& rule : model::rulesOf(static_cast<model::RuleSet>(set), scene)) {
        QCOMPARE(ruleProblem(scene, rule), QString());
        QVERIFY(!ruleSentence(scene, rule).isEmpty());
    }
}

void TestBehaviourDocks::aRuleSaysWhatIsWrong()
{
    Desk<RulesDock> desk;
    QVERIFY(desk.isReady());
    choose(desk, "addRule", RulesDock::tr("A New Rule"));
    auto* problem = desk.dock->findChild<QLabel*>(QStringLiteral("ruleProblem"));
    QTRY_VERIFY(problem->isVisible());
    QVERIFY2(problem->text().contains(QStringLiteral("clip")), qPrintable(problem->text()));
    auto* more = desk.dock->findChild<QToolButton*>(QStringLiteral("addAction"));
    QTest::mouseClick(more, Qt::LeftButton);
    QCOMPARE(desk.document.scene().rules[0].actions.size(), std::size_t{2});
    desk.document.undoStack().undo();
    QCOMPARE(desk.document.scene().rules[0].actions.size(), std::size_t{1});
}

CROWD_WINDOW_TEST(TestBehaviourDocks)
#include "tst_BehaviourDocks.moc"
