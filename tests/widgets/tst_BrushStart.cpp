// SPDX-License-Identifier: MIT
#include "widgets/state/BrushStart.h"

#include <utility>

#include <QtTest/QTest>

#include "model/states/StateKeeping.h"
#include "tests/program/Test.h"
#include "tests/widgets/Hand.h"
#include "widgets/commands/StateCommands.h"

using namespace crowd;
using model::BrushKind;
using testing::Hand;
using widgets::ToolId;

/// Brushes that are taken up for the first time, as a new artist takes them up.
class TestBrushStart : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theTemplateBrushBeginsWithThoseTicked();
    void theAnimationBrushBeginsWithClipsThatFit();
    void thePartsBrushTakesOffWhatEverybodyWears();
    void theOutfitBrushPaintsWhatTheSceneHas();
    void theGroupBrushMakesAGroup();
    void theCloneBrushAsksWhomToClone();
    void theRestoreBrushTakesStatesThatGiveSomethingBack();
    void theScriptBrushSaysWhatIsMissing();
    void whatIsChosenStays();
    void whatIsUnchosenOnPurposeStays();
    void whatWasThereBeforeTheBrushIsKept();
};

void TestBrushStart::theTemplateBrushBeginsWithThoseTicked()
{
    Hand hand;
    hand.state.setTool(ToolId::BrushTemplate);
    const auto& chosen = hand.state.brush(BrushKind::Template).as<model::TemplateSettings>();
    QCOMPARE(chosen.templates, std::vector<int>{1});
    QCOMPARE(widgets::missingOf(hand.state, BrushKind::Template), QString());
}

/// Standing people get what stands: the first stroke shows.
void TestBrushStart::theAnimationBrushBeginsWithClipsThatFit()
{
    Hand hand;
    const auto ids = testing::addPeople(hand.document, 3);
    hand.state.setTool(ToolId::BrushAnimation);
    const auto& animation = hand.state.brush(BrushKind::Animation).as<model::AnimationSettings>();
    QVERIFY(!animation.clips.empty());
    const model::TemplateEntry& entry = hand.document.scene().templates[0];
    for (const model::ClipWeight& each : animation.clips) {
        const model::Clip& clip =
            entry.asset->clips[static_cast<std::size_t>(entry.asset->clipIndex(each.clip))];
        QVERIFY2(clip.loop && clip.speed <= 0.0F, each.clip.c_str());
    }
    const QPointF at = hand.pixelOf(ids[1]);
    hand.drag(at, at + QPointF(3.0, 0.0));
    QCOMPARE(hand.document.undoStack().count(), 2);
}

void TestBrushStart::thePartsBrushTakesOffWhatEverybodyWears()
{
    Hand hand;
    testing::addPeople(hand.document, 3); // they wear all that they have
    hand.state.setTool(ToolId::BrushParts);
    QVERIFY(!hand.state.brush(BrushKind::Parts).as<model::PartsSettings>().isShown);
}

/// What was painted in another scene is not there.
void TestBrushStart::theOutfitBrushPaintsWhatTheSceneHas()
{
    Hand hand;
    model::BrushSettings brush = hand.state.brush(BrushKind::Outfit);
    brush.as<model::OutfitSettings>().kind = "team";
    brush.as<model::OutfitSettings>().values = {{"lions", 1.0F}};
    hand.state.setBrush(brush);
    hand.state.setTool(ToolId::BrushOutfit);
    const auto& outfit = hand.state.brush(BrushKind::Outfit).as<model::OutfitSettings>();
    QCOMPARE(outfit.kind, std::string("outfit"));
    QVERIFY(outfit.values.empty());
}

/// One step for the group and one for those who come into it.
void TestBrushStart::theGroupBrushMakesAGroup()
{
    Hand hand;
    const auto ids = testing::addPeople(hand.document, 3);
    hand.state.setTool(ToolId::BrushGroup);
    hand.hover(hand.pixelOf(ids[0]));
    QVERIFY2(hand.tools.picture().label.contains(QStringLiteral("new group")),
             qPrintable(hand.tools.picture().label));
    const QPointF at = hand.pixelOf(ids[1]);
    hand.drag(at, at + QPointF(3.0, 0.0));
    const auto& groups = hand.document.scene().groups;
    QCOMPARE(groups.size(), std::size_t{1});
    const model::Population& people = hand.document.scene().population;
    QCOMPARE(people.column(model::columns::group)[people.rowOf(ids[1])], groups[0].id);
    QCOMPARE(widgets::missingOf(hand.state, BrushKind::Group), QString());
    hand.drag(at, at + QPointF(3.0, 0.0));
    QCOMPARE(groups.size(), std::size_t{1});
}

void TestBrushStart::theCloneBrushAsksWhomToClone()
{
    Hand hand;
    const auto ids = testing::addPeople(hand.document, 3);
    hand.state.setTool(ToolId::BrushClone);
    hand.hover(hand.pixelOf(ids[0]));
    QVERIFY2(hand.tools.picture().label.contains(QStringLiteral("to be like")),
             qPrintable(hand.tools.picture().label));
    hand.drag(hand.pixelOf(ids[2]), hand.pixelOf(ids[2]));
    QCOMPARE(hand.state.brush(BrushKind::Clone).as<model::CloneSettings>().source, ids[2]);
    QCOMPARE(hand.document.undoStack().count(), 1); // nobody was changed
    hand.hover(hand.pixelOf(ids[0]));
    QCOMPARE(hand.tools.picture().label, QString());
}

/// Of a state that holds no colours, people who were painted get none back.
void TestBrushStart::theRestoreBrushTakesStatesThatGiveSomethingBack()
{
    using model::PropertyAspect;
    for (const auto& [aspect, source] :
         {std::pair{PropertyAspect::Animation, model::RestoreSource::Created},
          std::pair{PropertyAspect::Colours, model::RestoreSource::State}}) {
        Hand hand;
        (void)testing::addPeople(hand.document, 3);
        QVERIFY(widgets::keepStateAs(hand.state, QStringLiteral("calm"), model::columnsOf(aspect),
                                     widgets::StateReach::Everybody, 0));
        hand.state.setTool(ToolId::BrushRestore);
        const auto& restore = hand.state.brush(BrushKind::Restore).as<model::RestoreSettings>();
        QCOMPARE(restore.source, source);
    }
}

void TestBrushStart::theScriptBrushSaysWhatIsMissing()
{
    Hand hand;
    hand.state.setTool(ToolId::BrushScript);
    QVERIFY(!widgets::missingOf(hand.state, BrushKind::Script).isEmpty());
}

void TestBrushStart::whatIsChosenStays()
{
    Hand hand;
    testing::addPeople(hand.document, 3);
    model::BrushSettings brush = hand.state.brush(BrushKind::Animation);
    brush.as<model::AnimationSettings>().clips = {
        {hand.document.scene().templates[0].clipNames.back(), 1.0F}};
    hand.state.setBrush(brush);
    hand.state.setTool(ToolId::BrushAnimation);
    QVERIFY(hand.state.brush(BrushKind::Animation) == brush);
}

/// Only the first time, and anew in another scene.
void TestBrushStart::whatIsUnchosenOnPurposeStays()
{
    Hand hand;
    hand.state.setTool(ToolId::BrushAnimation);
    model::BrushSettings brush = hand.state.brush(BrushKind::Animation);
    brush.as<model::AnimationSettings>().clips.clear(); // phases alone
    hand.state.setBrush(brush);
    hand.state.setTool(ToolId::Select);
    hand.state.setTool(ToolId::BrushAnimation);
    QVERIFY(hand.state.brush(BrushKind::Animation).as<model::AnimationSettings>().clips.empty());
    hand.document.replaceScene(testing::smallTheatre(), {});
    QVERIFY(!hand.state.brush(BrushKind::Animation).as<model::AnimationSettings>().clips.empty());
}

/// The restoring brush itself is no brush whose work it takes back.
void TestBrushStart::whatWasThereBeforeTheBrushIsKept()
{
    Hand hand;
    testing::addPeople(hand.document, 3);
    hand.state.setTool(ToolId::BrushColour);
    const model::Population before = hand.document.scene().population;
    testing::addPeople(hand.document, 1, 5.0F);
    hand.state.setTool(ToolId::BrushRestore);
    QVERIFY(hand.document.earlierPeople().before == before);
    hand.state.setTool(ToolId::BrushColour);
    QVERIFY(!(hand.document.earlierPeople().before == before));
}

CROWD_TEST(TestBrushStart)
#include "tst_BrushStart.moc"
