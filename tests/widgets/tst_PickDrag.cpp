// SPDX-License-Identifier: MIT
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include <QtTest/QSignalSpy>
#include <QtTest/QTest>

#include "tests/program/WindowTest.h"
#include "tests/widgets/Hand.h"

using namespace crowd;
using namespace crowd::widgets;
using crowd::testing::Hand;

namespace {

void wear(Hand& hand, std::span<const model::IndividualId> ids, const model::Tint& tint)
{
    const auto edit = hand.document.beginEdit().value();
    edit->setColumn(model::columns::tint(1), ids, std::span<const model::Tint>(&tint, 1));
    edit->commit(QStringLiteral("Tint"));
}

void click(Hand& hand, QPointF place)
{
    hand.press(place);
    hand.release(place);
}

/// The colour that the colour brush takes of somebody with Ctrl; nothing: it takes none.
std::optional<model::PaintColor> takenFrom(Hand& hand, model::IndividualId id)
{
    hand.state.setTool(ToolId::BrushColour);
    const QSignalSpy picked(&hand.state, &EditorState::colorPicked);
    hand.modifiers = Qt::ControlModifier;
    click(hand, hand.pixelOf(id));
    return picked.isEmpty() ? std::nullopt
                            : std::optional(picked.back().front().value<model::PaintColor>());
}

} // namespace

class PickDragTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void controlTakesTheColourThatSomebodyWears();
    void theSlotOfTheBrushIsMeant();
    void anUntintedSlotHasTheColourOfItsMaterial();
    void whatCannotBeTintedHasItsOwnColour();
    void theDropperWorksOnceAndNobodyIsSaid();
    void aKindIsTakenForTheMix();
    void sizesAreTakenAndPainted();
    void aClipIsTaken();
    void aPointToFaceIsTakenFromTheGround();
    void anyToolTakesAPointForAForm();
    void anyToolTakesSomebodyForAPanel();
    void escapePutsTheBrushBack();
    void noGhostStandsWherePeopleArePicked();
    void theKeyAloneShowsWhatAPressWouldDo();
};

void PickDragTest::theKeyAloneShowsWhatAPressWouldDo()
{
    Hand hand;
    const auto ids = testing::addPeople(hand.document, 1);
    hand.state.setTool(ToolId::BrushColour);
    hand.hover(hand.pixelOf(ids[0]));
    QVERIFY(hand.tools.picture().circle);
    hand.tools.keyDown({Qt::Key_Control, Qt::ControlModifier, false, hand.now()});
    QVERIFY(!hand.tools.picture().circle);
    hand.tools.keyUp({Qt::Key_Control, Qt::NoModifier, false, hand.now()});
    QVERIFY(hand.tools.picture().circle);
}

void PickDragTest::controlTakesTheColourThatSomebodyWears()
{
    Hand hand;
    const auto ids = testing::addPeople(hand.document, 2);
    wear(hand, std::span(ids).first(1), {10, 20, 30, 255});
    const int steps = hand.document.undoStack().count();
    const auto taken = takenFrom(hand, ids[0]); // the chest: the top
    QVERIFY(taken.has_value());
    QCOMPARE(*taken, (model::PaintColor{10, 20, 30}));
    QVERIFY2(hand.document.undoStack().count() == steps, "nobody is painted");
}

void PickDragTest::theSlotOfTheBrushIsMeant()
{
    Hand hand;
    const auto ids = testing::addPeople(hand.document, 1);
    wear(hand, ids, {10, 20, 30, 255});
    model::BrushSettings brush = hand.state.brush(model::BrushKind::Colour);
    brush.as<crowd::model::ColourSettings>().slot = "bottom";
    hand.state.setBrush(brush);
    const auto taken = takenFrom(hand, ids[0]);
    QVERIFY(taken.has_value());
    QVERIFY(*taken != (model::PaintColor{10, 20, 30}));
}

void PickDragTest::anUntintedSlotHasTheColourOfItsMaterial()
{
    Hand hand;
    const auto ids = testing::addPeople(hand.document, 1);
    {
        model::MaterialChoices blue{};
        blue[1] = 1;
        const auto edit = hand.document.beginEdit().value();
        edit->setColumn(model::columns::materialChoices, ids,
                        std::span<const model::MaterialChoices>(&blue, 1));
        edit->commit(QStringLiteral("Blue"));
    }
    const auto taken = takenFrom(hand, ids[0]);
    QVERIFY(taken.has_value());
    QCOMPARE(*taken, (model::PaintColor{0, 0, 255}));
}

/// Whatever tint is kept for it: that is not drawn.
void PickDragTest::whatCannotBeTintedHasItsOwnColour()
{
    Hand hand;
    const auto ids = testing::addPeople(hand.document, 1);
    model::Scene scene = hand.document.scene();
    auto asset = std::make_shared<model::Template>(*scene.templates[0].asset);
    asset->slots[1].tintable = false;
    scene.templates[0].asset = asset;
    hand.document.replaceScene(std::move(scene), {});
    wear(hand, ids, {10, 20, 30, 255});
    const auto taken = takenFrom(hand, ids[0]);
    QVERIFY(taken.has_value());
    QVERIFY(*taken != (model::PaintColor{10, 20, 30}));
}

void PickDragTest::theDropperWorksOnceAndNobodyIsSaid()
{
    Hand hand;
    const auto ids = testing::addPeople(hand.document, 1);
    hand.state.setTool(ToolId::BrushColour);
    QSignalSpy picked(&hand.state, &EditorState::colorPicked);
    QSignalSpy said(&hand.state, &EditorState::statusMessage);
    QSignalSpy hinted(&hand.state, &EditorState::hintChanged);
    hand.hover({320.0, 240.0});
    hand.state.setPicking(Picking::Colour);
    QVERIFY2(!hand.tools.picture().mode.isEmpty(), "the picture says what a click does");
    QCOMPARE(hinted.back().front().toString(), hand.tools.picture().mode);
    click(hand, {5.0, 470.0});
    QCOMPARE(picked.count(), 0);
    QVERIFY(said.count() > 0);
    QVERIFY(hand.state.picking() == Picking::None);
    hand.state.setPicking(Picking::Colour);
    click(hand, hand.pixelOf(ids[0]));
    QVERIFY(picked.count() > 0);
    QVERIFY(hand.state.picking() == Picking::None);
    hand.state.setPicking(Picking::Colour);
    hand.state.setTool(ToolId::BrushDelete);
    QVERIFY2(hand.state.picking() == Picking::None, "it ends with the tool");
}

void PickDragTest::aKindIsTakenForTheMix()
{
    Hand hand;
    const auto ids = testing::addPeople(hand.document, 1);
    model::TemplateEntry other = hand.document.scene().templates.front();
    other.id = 0;
    {
        const auto edit = hand.document.beginEdit().value();
        const model::TemplateId id = edit->addTemplate(other);
        edit->setColumn(model::columns::templateId, ids,
                        std::span<const model::TemplateId>(&id, 1));
        edit->commit(QStringLiteral("Import"));
        other.id = id;
    }
    hand.state.setTool(ToolId::BrushCreate);
    hand.modifiers = Qt::ControlModifier;
    click(hand, hand.pixelOf(ids[0]));
    const auto& mix =
        hand.state.brush(model::BrushKind::Create).as<crowd::model::CreateSettings>().mix;
    QCOMPARE(mix, (std::vector<model::TemplateWeight>{{other.id, 1.0F}}));
    QCOMPARE(hand.document.scene().population.size(), std::size_t{1});
}

void PickDragTest::sizesAreTakenAndPainted()
{
    Hand hand;
    const auto ids = testing::addPeople(hand.document, 1);
    {
        const float tall = 1.3F;
        const auto edit = hand.document.beginEdit().value();
        edit->setColumn(model::columns::height, ids, std::span<const float>(&tall, 1));
        edit->commit(QStringLiteral("Tall"));
    }
    QSignalSpy said(&hand.state, &EditorState::statusMessage);
    hand.state.setTool(ToolId::BrushScale);
    QVERIFY(hand.state.hint().contains(QStringLiteral("Ctrl+click")));
    hand.modifiers = Qt::ControlModifier;
    click(hand, hand.pixelOf(ids[0]));
    const auto& scale = hand.state.brush(model::BrushKind::Scale).as<crowd::model::ScaleSettings>();
    QCOMPARE(scale.height.low, 1.3F);
    QCOMPARE(scale.girth.low, 1.0F);
    QCOMPARE(said.count(), 1);
    QVERIFY(said.back().front().toString().contains(QStringLiteral("Taken")));
    hand.state.setTool(ToolId::BrushTag);
    click(hand, hand.pixelOf(ids[0])); // has none
    QVERIFY(said.count() > 1);
    QVERIFY(said.back().front().toString().contains(QStringLiteral("Nothing to take")));
}

void PickDragTest::aClipIsTaken()
{
    Hand hand;
    const auto ids = testing::addPeople(hand.document, 1);
    {
        const std::uint16_t rise = 1;
        const auto edit = hand.document.beginEdit().value();
        edit->setColumn(model::columns::clip, ids, std::span<const std::uint16_t>(&rise, 1));
        edit->commit(QStringLiteral("Rise"));
    }
    hand.state.setTool(ToolId::BrushAnimation);
    hand.modifiers = Qt::ControlModifier;
    click(hand, hand.pixelOf(ids[0]));
    QCOMPARE(
        hand.state.brush(model::BrushKind::Animation).as<crowd::model::AnimationSettings>().clips,
        (std::vector<model::ClipWeight>{{"rise", 1.0F}}));
}

void PickDragTest::aPointToFaceIsTakenFromTheGround()
{
    Hand hand;
    hand.state.setTool(ToolId::BrushOrientation);
    hand.state.setPicking(Picking::Point);
    const glm::vec3 place(2.0F, 0.05F, 3.0F);
    click(hand, hand.pixelOf(place));
    const auto& heading = hand.state.brush(model::BrushKind::Orientation)
                              .as<crowd::model::OrientationSettings>()
                              .heading;
    QVERIFY(heading.mode == model::HeadingMode::TowardsPoint);
    QVERIFY(glm::length(heading.towardsPoint - place) < 0.05F);
    hand.hover({320.0, 240.0});
    QVERIFY(hand.tools.picture().target.has_value());
    const QPointF off = *hand.tools.picture().target - hand.pixelOf(place);
    QVERIFY2(std::hypot(off.x(), off.y()) < 2.0, "the point is marked in the picture");
}

void PickDragTest::anyToolTakesAPointForAForm()
{
    Hand hand;
    const glm::vec3 place(2.0F, 0.05F, 3.0F);
    for (const ToolId tool : {ToolId::Select, ToolId::BrushColour, ToolId::BrushPath}) {
        hand.state.setTool(tool);
        std::optional<glm::vec3> taken;
        hand.state.choosePoint([&taken](const glm::vec3& point) { taken = point; });
        hand.hover(hand.pixelOf(place));
        QVERIFY(hand.tools.picture().crosshair.has_value());
        QVERIFY(hand.state.hint().contains(QStringLiteral("Click a point")));
        const int steps = hand.document.undoStack().count();
        click(hand, hand.pixelOf(place));
        QVERIFY(taken.has_value() && glm::length(*taken - place) < 0.1F);
        QVERIFY(hand.state.picking() == Picking::None);
        QCOMPARE(hand.document.undoStack().count(), steps);
    }
    bool isTaken = false;
    hand.state.choosePoint([&isTaken](const glm::vec3&) { isTaken = true; });
    QVERIFY(hand.key(Qt::Key_Escape));
    hand.state.offerPoint({});
    QVERIFY(!isTaken);
}

void PickDragTest::anyToolTakesSomebodyForAPanel()
{
    Hand hand;
    const model::IndividualId somebody = testing::addPeople(hand.document, 1)[0];
    for (const ToolId tool : {ToolId::Select, ToolId::BrushColour, ToolId::BrushCreate}) {
        hand.state.setTool(tool);
        model::IndividualId taken = 0;
        hand.state.choosePerson([&taken](model::IndividualId id) { taken = id; });
        hand.hover(hand.pixelOf(somebody));
        QVERIFY(hand.tools.picture().crosshair.has_value());
        QVERIFY(hand.state.hint().contains(QStringLiteral("Click somebody")));
        const int steps = hand.document.undoStack().count();
        click(hand, {3.0, 3.0}); // nobody is there: it goes on asking
        QVERIFY(hand.state.picking() == Picking::Person && taken == 0);
        click(hand, hand.pixelOf(somebody));
        QCOMPARE(taken, somebody);
        QVERIFY(hand.state.picking() == Picking::None);
        QCOMPARE(hand.document.undoStack().count(), steps);
    }
    bool isTaken = false;
    hand.state.choosePerson([&isTaken](model::IndividualId) { isTaken = true; });
    QVERIFY(hand.key(Qt::Key_Escape));
    hand.state.offerPerson(somebody);
    QVERIFY(!isTaken);
}

void PickDragTest::escapePutsTheBrushBack()
{
    Hand hand;
    hand.state.setTool(ToolId::BrushOrientation);
    const model::BrushSettings before = hand.state.brush(model::BrushKind::Orientation);
    hand.modifiers = Qt::ControlModifier;
    hand.press({320.0, 240.0});
    QVERIFY(!(hand.state.brush(model::BrushKind::Orientation) == before));
    QVERIFY(hand.key(Qt::Key_Escape));
    QVERIFY(hand.state.brush(model::BrushKind::Orientation) == before);
    hand.state.setPicking(Picking::Point);
    QVERIFY(hand.key(Qt::Key_Escape));
    QVERIFY(hand.state.picking() == Picking::None);
}

void PickDragTest::noGhostStandsWherePeopleArePicked()
{
    Hand hand;
    model::BrushSettings brush = hand.state.brush(model::BrushKind::Create);
    brush.as<crowd::model::CreateSettings>().seats.isOn = false;
    hand.state.setBrush(brush);
    hand.state.setTool(ToolId::BrushCreate);
    hand.hover({320.0, 240.0});
    QVERIFY(!hand.tools.picture().ghosts.empty());
    hand.modifiers = Qt::ControlModifier;
    hand.hover({322.0, 240.0});
    QVERIFY(hand.tools.picture().ghosts.empty());
}

CROWD_WINDOW_TEST(PickDragTest)
#include "tst_PickDrag.moc"
