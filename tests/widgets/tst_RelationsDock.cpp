// SPDX-License-Identifier: MIT
#include <QtTest/QTest>
#include <QtWidgets/QAbstractButton>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QLabel>
#include <QtWidgets/QListWidget>
#include <glm/geometric.hpp>

#include "tests/program/WindowTest.h"
#include "tests/widgets/Desk.h"
#include "tests/widgets/Hand.h"
#include "tests/widgets/SmallTheatre.h"
#include "widgets/commands/RelationCommands.h"
#include "widgets/docks/RelationsDock.h"
#include "widgets/forms/FieldForm.h"
#include "widgets/viewport/RelationArcs.h"

using namespace crowd;
using namespace crowd::widgets;
using crowd::testing::Hand;
using Ids = std::vector<model::IndividualId>;

namespace {

Ids addPeople(model::SceneDocument& document, int count)
{
    Ids ids;
    document.edit(QStringLiteral("Add"), [&](model::SceneEdit& edit) {
        auto rows = model::IndividualRows::withDefaults(Ids(static_cast<std::size_t>(count)));
        for (std::size_t i = 0; i < rows.ids.size(); ++i) {
            rows.column(model::columns::templateId)[i] = document.scene().templates.front().id;
            rows.column(model::columns::position)[i] = {1.5F * static_cast<float>(i) - 3.0F, 0.05F,
                                                        6.0F};
        }
        ids = edit.addIndividuals(std::move(rows));
    });
    return ids;
}

struct RelationsDesk : crowd::testing::Desk<RelationsDock>
{
    RelationsDesk() : ids(addPeople(document, 5))
    {
        QObject::connect(&state, &EditorState::statusMessage,
                         [this](const QString& text) { said = text; });
    }
    [[nodiscard]] QListWidget* list()
    {
        return dock->findChild<QListWidget*>(QStringLiteral("relationKinds"));
    }
    void press(const char* button)
    {
        auto* found = dock->findChild<QAbstractButton*>(QLatin1String(button));
        QVERIFY2(found != nullptr && found->isEnabled(), button);
        found->click();
    }
    void choose(const char* name)
    {
        const auto items = list()->findItems(QLatin1String(name), Qt::MatchExactly);
        QVERIFY2(items.size() == 1, name);
        list()->setCurrentItem(items.front());
    }
    [[nodiscard]] QString note()
    {
        return dock->findChild<QLabel*>(QStringLiteral("relationsNote"))->text();
    }
    [[nodiscard]] const model::RelationTable& table() { return document.scene().relations; }

    Ids ids;
    QString said;
};

struct RelationHand : Hand
{
    RelationHand() : ids(addPeople(document, 5))
    {
        state.setTool(ToolId::BrushRelation);
        QObject::connect(&state, &EditorState::statusMessage,
                         [this](const QString& text) { said = text; });
    }
    void set(const std::function<void(model::BrushSettings&)>& change)
    {
        model::BrushSettings brush = *state.activeBrush();
        change(brush);
        state.setBrush(brush);
    }
    [[nodiscard]] const model::RelationTable& table() { return document.scene().relations; }

    Ids ids;
    QString said;
};

} // namespace

class TestRelationsDock : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void listsKindsAndCountsThem();
    void relatesTheSelected();
    void kindsAreMadeNamedAndRemoved();
    void theFormChangesAKind();
    void duplicatesAreRelatedAmongEachOther();
    void duplicatesStandWhereNobodyStands();
    void theBoxSaysThatTheBrushShowsThem();
    void panelAndBrushSpeakOfTheSameKind();
    void aDragRelatesAndControlTakesAway();
    void whatTheBrushPaintsIsOfTheScene();
    void aLassoAfterALasso();
    void arcsAreOfTheSelectedOrOfAll();
    void manyArcsAreSeenThrough();
};

void TestRelationsDock::listsKindsAndCountsThem()
{
    RelationsDesk desk;
    QVERIFY(desk.isReady());
    QCOMPARE(desk.list()->count(), 5);
    QTRY_VERIFY2(desk.note().startsWith(QStringLiteral("Nobody")), qPrintable(desk.note()));
    desk.choose("friends");
    desk.state.selection().set(desk.ids);
    desk.press("relateSelected");
    QTRY_VERIFY2(desk.note().startsWith(QStringLiteral("10 ")), qPrintable(desk.note()));
}

void TestRelationsDock::relatesTheSelected()
{
    RelationsDesk desk;
    QVERIFY(desk.isReady());
    desk.choose("leader");
    desk.press("relateSelected");
    QVERIFY(desk.said.contains(QStringLiteral("two")));
    desk.state.selection().set(desk.ids);
    desk.press("relateSelected");
    QCOMPARE(desk.table().count(), std::size_t{4}); // one leads the others
    desk.state.selection().set(Ids{desk.ids[2]});
    desk.press("growRelated");
    QCOMPARE(desk.state.selection().ids().size(), std::size_t{2});
    desk.press("selectRelated");
    QCOMPARE(desk.state.selection().ids().size(), desk.ids.size());
    desk.state.selection().set(Ids{desk.ids[2]});
    desk.press("unrelateSelected");
    QCOMPARE(desk.table().count(), std::size_t{3});
    desk.press("unrelateSelected");
    QVERIFY(desk.said.startsWith(QStringLiteral("None")));
    desk.document.undoStack().undo();
    QCOMPARE(desk.table().count(), std::size_t{4});
}

void TestRelationsDock::kindsAreMadeNamedAndRemoved()
{
    RelationsDesk desk;
    QVERIFY(desk.isReady());
    desk.press("addRelation");
    QCOMPARE(desk.document.scene().relationKinds.size(), std::size_t{6});
    auto* editor = desk.list()->viewport()->findChild<QLineEdit*>();
    QVERIFY(editor != nullptr);
    QTest::keyClicks(editor, QStringLiteral("neighbours"));
    QTest::keyClick(editor, Qt::Key_Return);
    QTRY_VERIFY(findRelation(desk.document.scene().relationKinds, "neighbours") != nullptr);
    QTRY_VERIFY(desk.list()->viewport()->findChild<QLineEdit*>() == nullptr);
    desk.choose("neighbours");
    QVERIFY(!renameRelationKind(desk.state, 1, QStringLiteral("neighbours")));
    QVERIFY(!renameRelationKind(desk.state, 1, QStringLiteral("  ")));
    desk.state.selection().set(desk.ids);
    desk.press("relateSelected");
    QVERIFY(!desk.table().isEmpty());
    desk.press("removeRelation");
    QVERIFY(desk.table().isEmpty());
    QTRY_COMPARE(desk.list()->count(), 5);
    desk.document.undoStack().undo();
    QTRY_COMPARE(desk.list()->count(), 6);
    QVERIFY(!desk.table().isEmpty());
}

void TestRelationsDock::whatTheBrushPaintsIsOfTheScene()
{
    RelationsDesk desk;
    QVERIFY(desk.isReady());
    const auto painted = [&desk] {
        return desk.state.brush(model::BrushKind::Relation).as<model::RelationSettings>().relation;
    };
    desk.choose("couple");
    QCOMPARE(painted(), std::string("couple"));
    desk.press("removeRelation");
    QTRY_VERIFY(findRelation(desk.document.scene().relationKinds, painted()) != nullptr);
    const model::RelationKindId made = addRelationKind(desk.state);
    QCOMPARE(desk.document.scene().relationKinds.back().id, made); // behind the others
    QTRY_COMPARE(desk.list()->count(), 5);
    desk.list()->setCurrentRow(4);
    QTRY_COMPARE(painted(), desk.document.scene().relationKinds.back().name);
    desk.document.replaceScene(crowd::testing::smallTheatre(), {});
    QTRY_COMPARE(desk.list()->count(), 5);
    QTRY_VERIFY(findRelation(desk.document.scene().relationKinds, painted()) != nullptr);
    desk.press("paintRelation");
    QCOMPARE(desk.state.tool(), ToolId::BrushRelation);
}

void TestRelationsDock::theFormChangesAKind()
{
    RelationsDesk desk;
    QVERIFY(desk.isReady());
    desk.choose("friends");
    QCheckBox* shares = nullptr;
    for (QCheckBox* each : desk.all<QCheckBox>()) {
        shares = each->text() == QStringLiteral("Share colours") ? each : shares;
    }
    QVERIFY(shares != nullptr && !shares->isChecked());
    shares->click();
    QVERIFY(findRelation(desk.document.scene().relationKinds, "friends")->sharesColors);
    desk.document.undoStack().undo();
    QTRY_VERIFY(!shares->isChecked());
    desk.choose("family");
    QVERIFY(findRelation(desk.document.scene().relationKinds, "family")->sharesFeatures);
}

void TestRelationsDock::duplicatesAreRelatedAmongEachOther()
{
    RelationsDesk desk;
    QVERIFY(desk.isReady());
    desk.state.selection().set(desk.ids);
    relateSelected(desk.state, 1);
    duplicateSelection(desk.state);
    QCOMPARE(desk.table().count(), std::size_t{20});
    QCOMPARE(desk.state.selection().ids().size(), std::size_t{5});
    QVERIFY(desk.state.selection().ids().front() > desk.ids.back());
    desk.document.undoStack().undo();
    QCOMPARE(desk.table().count(), std::size_t{10});
    desk.state.selection().clear();
    duplicateSelection(desk.state);
    QVERIFY(desk.said.startsWith(QStringLiteral("Nobody")));
}

void TestRelationsDock::duplicatesStandWhereNobodyStands()
{
    RelationsDesk desk;
    QVERIFY(desk.isReady());
    desk.state.selection().set(Ids{desk.ids[0]});
    for (int i = 0; i < 12; ++i) {
        desk.state.selection().set(Ids{desk.ids[0]});
        duplicateSelection(desk.state);
    }
    const auto at = desk.document.scene().population.column(model::columns::position);
    for (std::size_t i = 0; i < at.size(); ++i) {
        for (std::size_t j = i + 1; j < at.size(); ++j) {
            QVERIFY2(glm::distance(at[i], at[j]) > 0.49F, qPrintable(QString::number(j)));
        }
    }
}

void TestRelationsDock::panelAndBrushSpeakOfTheSameKind()
{
    RelationsDesk desk;
    QVERIFY(desk.isReady());
    const auto painted = [&desk] {
        const auto& brush = desk.state.brush(model::BrushKind::Relation);
        return brush.as<model::RelationSettings>().relation;
    };
    QCOMPARE(desk.list()->currentItem()->text(), QString::fromStdString(painted()));
    desk.choose("family");
    QCOMPARE(painted(), std::string("family"));
    desk.state.setTool(ToolId::BrushRelation);
    model::BrushSettings brush = *desk.state.activeBrush();
    brush.as<model::RelationSettings>().relation = "rivals";
    desk.state.setBrush(brush);
    QCOMPARE(desk.list()->currentItem()->text(), QStringLiteral("rivals"));
    brush.as<model::RelationSettings>().relation = "of another scene";
    desk.state.setBrush(brush);
    QCOMPARE(desk.list()->currentItem()->text(), QStringLiteral("rivals"));
    QCOMPARE(painted(), std::string("of another scene"));
}

void TestRelationsDock::theBoxSaysThatTheBrushShowsThem()
{
    RelationsDesk desk;
    QVERIFY(desk.isReady());
    auto* box = desk.dock->findChild<QCheckBox*>(QStringLiteral("showRelations"));
    QVERIFY(!box->isChecked() && box->isEnabled());
    desk.state.setTool(ToolId::BrushRelation);
    QVERIFY(box->isChecked() && !box->isEnabled());
    desk.state.setTool(ToolId::Select);
    QVERIFY(!box->isChecked() && box->isEnabled());
    box->click();
    QVERIFY(desk.state.viewOptions().showRelations && box->isChecked());
}

void TestRelationsDock::aDragRelatesAndControlTakesAway()
{
    RelationHand hand;
    hand.drag(hand.pixelOf(hand.ids[0]), hand.pixelOf(hand.ids[3]));
    QVERIFY2(hand.table().count() >= 1, qPrintable(hand.said));
    QVERIFY(hand.table().find(hand.ids[0], hand.ids[3], 2) != nullptr);
    QCOMPARE(hand.document.undoStack().count(), 2);
    hand.modifiers = Qt::ControlModifier;
    hand.drag(hand.pixelOf(hand.ids[3]), hand.pixelOf(hand.ids[3]));
    QVERIFY2(hand.table().isEmpty(), qPrintable(hand.said));
    hand.modifiers = Qt::NoModifier;
    hand.press(hand.pixelOf(hand.ids[0]));
    hand.move(hand.pixelOf(hand.ids[2]));
    QVERIFY(!hand.table().isEmpty()); // seen while the button is down
    QVERIFY(hand.tools.picture().arrow);
    hand.key(Qt::Key_Escape);
    QVERIFY(hand.table().isEmpty());
}

void TestRelationsDock::aLassoAfterALasso()
{
    RelationHand hand;
    hand.set([](model::BrushSettings& brush) {
        brush.selection = model::BrushSelection::Rectangle;
        brush.as<model::RelationSettings>().relation = "leader";
    });
    const auto around = [&hand](model::IndividualId id) {
        const QPointF at = hand.pixelOf(id);
        hand.drag(at - QPointF(9.0, 9.0), at + QPointF(9.0, 9.0));
    };
    around(hand.ids[0]);
    QVERIFY(hand.table().isEmpty());
    QVERIFY2(hand.said.startsWith(QStringLiteral("Now draw")), qPrintable(hand.said));
    const auto selected = hand.state.selection().ids();
    QCOMPARE(Ids(selected.begin(), selected.end()), Ids{hand.ids[0]}); // seen meanwhile
    around(hand.ids[4]);
    QVERIFY(hand.table().find(hand.ids[0], hand.ids[4], 4) != nullptr);
    around(hand.ids[1]);
    hand.key(Qt::Key_Escape); // not from him
    around(hand.ids[2]);
    QVERIFY2(hand.said.startsWith(QStringLiteral("Now draw")), qPrintable(hand.said));
    QCOMPARE(hand.table().count(), std::size_t{1});
    hand.document.replaceScene(crowd::testing::smallTheatre(), {}); // who was chosen is gone
    QVERIFY(hand.state.activeBrush()->as<model::RelationSettings>().sources.empty());
}

void TestRelationsDock::arcsAreOfTheSelectedOrOfAll()
{
    RelationHand hand;
    hand.document.edit(QStringLiteral("Relate"), [&hand](model::SceneEdit& edit) {
        edit.relate(std::vector<model::Relation>{{hand.ids[0], hand.ids[1], 1.0F, 1},
                                                 {hand.ids[2], hand.ids[3], 0.5F, 4}});
    });
    RelationArcs arcs;
    const auto count = [&] {
        arcs.make(hand.state, *hand.state.frame());
        return arcs.lines().size();
    };
    const std::size_t all = count(); // the brush shows them
    QCOMPARE(arcs.legend().size(), std::size_t{2});
    hand.state.setTool(ToolId::Select);
    QCOMPARE(count(), std::size_t{0});
    ViewOptions options = hand.state.viewOptions();
    options.showRelations = true;
    hand.state.setViewOptions(options);
    QCOMPARE(count(), all);
    hand.state.selection().set(Ids{hand.ids[3]});
    const std::size_t his = count();
    QVERIFY(his > 0 && his < all);
    QCOMPARE(arcs.legend().front().name, QStringLiteral("leader"));
    QVERIFY(arcs.lines().back().toPixels == 0.0F); // an arrow's head
    hand.state.selection().set(Ids{hand.ids[4]});
    QCOMPARE(count(), std::size_t{0});
}

/// They do not hide the people below.
void TestRelationsDock::manyArcsAreSeenThrough()
{
    RelationHand hand;
    const Ids people = addPeople(hand.document, 16);
    RelationArcs arcs;
    const auto alphaAfter = [&](const std::vector<model::Relation>& links) {
        hand.document.edit(QStringLiteral("Relate"),
                           [&links](model::SceneEdit& edit) { edit.relate(links); });
        arcs.make(hand.state, *hand.state.frame());
        return arcs.lines().front().color.a;
    };
    const float alone = alphaAfter({{people[0], people[1], 1.0F, 4}});
    std::vector<model::Relation> everybody;
    for (const model::IndividualId from : people) {
        for (const model::IndividualId to : people) {
            if (from != to) {
                everybody.push_back({from, to, 1.0F, 4});
            }
        }
    }
    QVERIFY(alphaAfter(everybody) < 0.8F * alone);
}

CROWD_WINDOW_TEST(TestRelationsDock)
#include "tst_RelationsDock.moc"
