// SPDX-License-Identifier: MIT
#include <cmath>

#include <QtTest/QTest>

#include "model/document/GroupEdits.h"
#include "model/document/SceneEdit.h"
#include "tests/program/WindowTest.h"
#include "tests/widgets/Hand.h"
#include "widgets/viewport/BrushCursor.h"
#include "widgets/viewport/PeopleMarks.h"

using namespace crowd;
using namespace crowd::widgets;
using crowd::testing::Hand;
using crowd::testing::kCenter;

/// What is seen of tags and of the brush itself.
class TestPeopleMarks : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void ringsTellWhoHasWhichTag();
    void severalTagsShareARing();
    void ringsFollowWhoWalks();
    void tagsOfManyAreCheap();
    void ringsTellOfGroupsAndFeatures();
    void aCursorCarriesTheBrush();
    void aLargeBrushIsNoCursor();

private:
    static void tag(Hand& hand, model::IndividualId id, std::uint64_t tags);
};

void TestPeopleMarks::tag(Hand& hand, model::IndividualId id, std::uint64_t tags)
{
    const auto edit = hand.document.beginEdit().value();
    const std::array<model::IndividualId, 1> ids{id};
    edit->setColumn(model::columns::tags, ids, std::span<const std::uint64_t>(&tags, 1));
    edit->commit(QStringLiteral("Tag"));
}

void TestPeopleMarks::ringsTellWhoHasWhichTag()
{
    Hand hand;
    hand.drag(kCenter, kCenter + QPointF(80.0, 0.0));
    const model::IndividualId first = hand.document.scene().population.ids()[0];
    tag(hand, first, 2);
    PeopleMarks marks;
    marks.make(hand.state, *hand.state.frame());
    QVERIFY2(marks.markers().empty(), "the create brush is active, and tags are off");
    hand.state.setTool(ToolId::BrushTag);
    marks.make(hand.state, *hand.state.frame());
    QCOMPARE(marks.markers().size(), std::size_t{1});
    QVERIFY(marks.markers()[0].innerShare > 0.0F);
    QCOMPARE(marks.legend().size(), std::size_t{1});
    QVERIFY(marks.legend()[0].name.contains(QLatin1Char('2')));
    hand.state.setTool(ToolId::BrushColour);
    ViewOptions options = hand.state.viewOptions();
    QVERIFY(!options.showTags);
    options.showTags = true;
    hand.state.setViewOptions(options);
    marks.make(hand.state, *hand.state.frame());
    QCOMPARE(marks.markers().size(), std::size_t{1});
}

void TestPeopleMarks::severalTagsShareARing()
{
    Hand hand;
    hand.drag(kCenter, kCenter + QPointF(80.0, 0.0));
    tag(hand, hand.document.scene().population.ids()[0], 0b1011);
    hand.state.setTool(ToolId::BrushUntag);
    PeopleMarks marks;
    marks.make(hand.state, *hand.state.frame());
    QCOMPARE(marks.markers().size(), std::size_t{3});
    QCOMPARE(marks.legend().size(), std::size_t{3});
    for (std::size_t i = 0; i < 3; ++i) {
        const render::Marker& part = marks.markers()[i];
        QVERIFY(std::abs(part.fromTurn - static_cast<float>(i) / 3.0F) < 1e-4F);
        QVERIFY(std::abs(part.toTurn - part.fromTurn - 1.0F / 3.0F) < 1e-4F);
    }
    QVERIFY(marks.markers()[0].color != marks.markers()[1].color);
}

void TestPeopleMarks::ringsFollowWhoWalks()
{
    Hand hand;
    hand.drag(kCenter, kCenter + QPointF(80.0, 0.0));
    tag(hand, hand.document.scene().population.ids()[0], 1);
    hand.state.setTool(ToolId::BrushTag);
    model::CrowdFrame frame = *hand.state.frame(); // as a session shows it
    const std::array<model::IndividualId, 1> ids{frame.population.ids()[0]};
    const std::array<glm::vec3, 1> there{glm::vec3(3.0F, 0.0F, 4.0F)};
    frame.population.setValues(model::columns::position, ids, std::span<const glm::vec3>(there));
    PeopleMarks marks;
    marks.make(hand.state, frame);
    QCOMPARE(marks.markers().size(), std::size_t{1});
    QVERIFY(marks.markers()[0].position == there[0]);
}

void TestPeopleMarks::tagsOfManyAreCheap()
{
    Hand hand;
    model::CrowdFrame frame = *hand.state.frame();
    std::vector<model::IndividualId> ids(10'000);
    for (std::size_t i = 0; i < ids.size(); ++i) {
        ids[i] = static_cast<model::IndividualId>(i + 1);
    }
    model::IndividualRows rows = model::IndividualRows::withDefaults(ids);
    std::ranges::fill(rows.column(model::columns::tags), std::uint64_t{1});
    frame.population = {};
    frame.population.add(rows);
    hand.state.setTool(ToolId::BrushTag);
    PeopleMarks marks;
    marks.make(hand.state, frame);
    QCOMPARE(marks.markers().size(), std::size_t{10'000});
    QCOMPARE(marks.legend().size(), std::size_t{1});
}

/// While their brushes are in hand.
void TestPeopleMarks::ringsTellOfGroupsAndFeatures()
{
    Hand hand;
    hand.drag(kCenter, kCenter + QPointF(80.0, 0.0));
    const std::array<model::IndividualId, 1> ids{hand.document.scene().population.ids()[0]};
    const model::FeatureKind& kind = hand.document.scene().features.front();
    const model::FeatureValue value = kind.values.back();
    hand.document.edit(QStringLiteral("Group and feature"), [&](model::SceneEdit& edit) {
        model::Group group;
        group.name = "choir";
        group.color = {1, 2, 3};
        model::putInGroup(edit, ids, model::addGroup(edit, group));
        edit.setColumn(model::columns::feature(kind.id), ids,
                       std::span<const model::FeatureId>(&value.id, 1));
    });
    PeopleMarks marks;
    hand.state.setTool(ToolId::BrushColour);
    marks.make(hand.state, *hand.state.frame());
    QVERIFY(marks.markers().empty());
    hand.state.setTool(ToolId::BrushGroup);
    marks.make(hand.state, *hand.state.frame());
    QCOMPARE(marks.markers().size(), std::size_t{1});
    QCOMPARE(marks.legend().front().name, QStringLiteral("choir"));
    QCOMPARE(marks.legend().front().color, QColor(1, 2, 3));
    hand.state.setTool(ToolId::BrushFeature);
    marks.make(hand.state, *hand.state.frame());
    QCOMPARE(marks.markers().size(), std::size_t{1});
    QCOMPARE(marks.legend().front().color, QColor(value.color[0], value.color[1], value.color[2]));
}

void TestPeopleMarks::aCursorCarriesTheBrush()
{
    ToolPicture picture;
    picture.circle = CircleOutline{{200.0, 100.0}, 40.0};
    picture.symbol = ToolId::BrushTag;
    picture.symbolAt = picture.circle->center;
    BrushCursor cursors;
    const auto cursor = cursors.cursorFor(picture, 1.0);
    QVERIFY(cursor.has_value());
    const QImage image = cursor->pixmap().toImage();
    const QPoint middle = cursor->hotSpot();
    QVERIFY2(qAlpha(image.pixel(middle.x() - 40, middle.y())) > 100, "the circle");
    QVERIFY2(qAlpha(image.pixel(middle.x() - 20, middle.y())) == 0, "and nothing in it");
    QVERIFY2(qAlpha(image.pixel(middle.x() + 20, middle.y() + 20)) > 200, "but the symbol");
    picture.circle->center = {300.0, 50.0};
    picture.symbolAt = picture.circle->center;
    QVERIFY2(cursors.cursorFor(picture, 1.0) == cursor, "wherever it is");
    picture.circle->radius = 60.0;
    QVERIFY(cursors.cursorFor(picture, 1.0) != cursor);
    picture.circle->radius = 280.0;
    const auto large = cursors.cursorFor(picture, 1.0);
    QVERIFY(large.has_value());
    const QPoint center = large->hotSpot();
    QVERIFY(qAlpha(large->pixmap().toImage().pixel(center.x(), center.y() - 280)) > 100);
}

void TestPeopleMarks::aLargeBrushIsNoCursor()
{
    BrushCursor cursors;
    ToolPicture picture;
    QVERIFY2(!cursors.cursorFor(picture, 1.0), "no brush");
    picture.circle = CircleOutline{{200.0, 100.0}, 500.0};
    QVERIFY(!cursors.cursorFor(picture, 1.0));
}

CROWD_WINDOW_TEST(TestPeopleMarks)
#include "tst_PeopleMarks.moc"
