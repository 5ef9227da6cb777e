// SPDX-License-Identifier: MIT
#include "model/scene/Timeline.h"

#include <limits>

#include <QtTest/QTest>

#include "model/document/MemberEntries.h"
#include "model/project/ProjectReader.h"
#include "model/states/StateKeeping.h"
#include "tests/model/ProjectText.h"
#include "tests/program/Test.h"

using namespace crowd::model;
using crowd::testing::projectText;

namespace {

Mark markAt(double seconds, MarkId id)
{
    Mark mark;
    mark.id = id;
    mark.seconds = seconds;
    return mark;
}

/// A project with this text as its timeline.
std::string withTimeline(const std::string& timeline)
{
    Scene scene;
    scene.timeline = {markAt(1.0, 1)};
    std::string text = projectText(scene);
    const std::size_t begin = text.find('[', text.find("\"timeline\""));
    std::size_t end = begin;
    for (int depth = 0; end == begin || depth > 0; ++end) {
        depth += text[end] == '[' || text[end] == '{' ? 1 : 0;
        depth -= text[end] == ']' || text[end] == '}' ? 1 : 0;
    }
    return text.replace(begin, end - begin, timeline);
}

} // namespace

class TestTimeline : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void filesKeepIt();
    void oddFilesAreRefused_data();
    void oddFilesAreRefused();
    void oddRangesAreRefused();
    void whatIsSprayedIsHeardOneAfterTheOther();
    void newMarksComeLast();
    void whatIsAtOneTimeHappensInOrder();
    void newStatesAreNotTakenForThoseThatAreGone();
};

void TestTimeline::filesKeepIt()
{
    Scene scene;
    QVERIFY(projectText(scene).find("timeline") == std::string::npos);
    Mark event = markAt(12.25, 3);
    event.name = "here ♪";
    event.kind = MarkKind::Event;
    event.event = "wave";
    event.payload = -2.5F;
    event.people = {1, 7, 2147483647};
    event.delays = {300, 0, 33};
    Mark state = markAt(1.0 / 3.0, 8);
    state.kind = MarkKind::State;
    state.state = 4;
    state.setTiming({1.5F, {6.0F, StaggerOrder::Heading, {1.0F, 0.0F, -2.0F}, 0.25F}});
    scene.timeline = {event, state};
    scene.playRange = {.begin = 1.5, .end = 8.25, .isLoop = true};
    const std::string text = projectText(scene);
    const auto read = projectFromText(text);
    QVERIFY(read.isOk() && isSame(read.value().timeline, scene.timeline));
    QVERIFY(read.value().timeline[1].timing() == state.timing());
    QVERIFY(read.value().playRange == scene.playRange);
    QVERIFY(projectText(read.value()) == text);
}

void TestTimeline::oddFilesAreRefused_data()
{
    QTest::addColumn<QString>("timeline");
    QTest::addColumn<QString>("said");
    const auto odd = [](const char* name, const char* text, const char* said) {
        QTest::newRow(name) << QString::fromUtf8(text) << QString::fromUtf8(said);
    };
    odd("before the beginning", R"([{"id": 1, "seconds": -1}])", "timeline[0].seconds");
    odd("far too late", R"([{"id": 1, "seconds": 1e30}])", "timeline[0].seconds");
    odd("no time", R"([{"id": 1, "seconds": "soon"}])", "timeline[0].seconds");
    odd("no kind", R"([{"id": 1, "kind": "dance"}])", "timeline[0].kind");
    odd("twice", R"([{"id": 2}, {"id": 2}])", "the id 2 is given twice");
    odd("no id", R"([{"id": 0}])", "timeline");
    odd("nobody", R"([{"id": 1, "people": ["Anna"]}])", "timeline[0].people");
    odd("nobody knows when", R"([{"id": 1, "delays": ["late"]}])", "timeline[0].delays");
    odd("no list", R"({"id": 1})", "timeline must be a list");
    odd("no object", R"([7])", "timeline[0]");
    odd("for ever", R"([{"id": 1, "fade": 1e9}])", "timeline[0].fade");
}

void TestTimeline::oddFilesAreRefused()
{
    QFETCH(QString, timeline);
    QFETCH(QString, said);
    const auto read = projectFromText(withTimeline(timeline.toStdString()));
    QVERIFY(!read);
    const QString message = QString::fromStdString(read.error().message);
    QVERIFY2(message.contains(said), qPrintable(message));
}

void TestTimeline::oddRangesAreRefused()
{
    Scene scene;
    scene.playRange.end = 4.5;
    const std::string text = projectText(scene);
    const std::size_t end = text.find("4.5");
    QVERIFY(end != std::string::npos);
    for (const char* odd : {"-1", "1e30", "\"soon\"", "null"}) {
        const auto read = projectFromText(std::string(text).replace(end, 3, odd));
        QVERIFY2(!read && QString::fromStdString(read.error().message)
                              .contains(QStringLiteral("playRange.end")),
                 odd);
    }
    QVERIFY(!projectFromText(std::string(text).replace(end, 3, "[7]")));
    scene.playRange = {.begin = 3.0, .end = 3.0};
    QVERIFY(!scene.playRange.isSet());
}

void TestTimeline::whatIsSprayedIsHeardOneAfterTheOther()
{
    Mark mark = markAt(2.0, 3);
    mark.kind = MarkKind::Event;
    mark.people = {1, 2, 5, 9};
    QCOMPARE(atOneMomentEach(mark).size(), std::size_t{1});
    mark.delays = {500, 0, 500}; // a list that is too short: the last at once
    const Timeline parts = atOneMomentEach(mark);
    QCOMPARE(parts.size(), std::size_t{2});
    QVERIFY(parts[0].seconds == 2.0 && (parts[0].people == std::vector<int>{2, 9}));
    QVERIFY(parts[1].seconds == 2.5 && (parts[1].people == std::vector<int>{1, 5}));
    QVERIFY(parts[1].id == 3 && parts[1].delays.empty());
    QCOMPARE(mark.length(), 0.5);
}

void TestTimeline::newMarksComeLast()
{
    QCOMPARE(freeMarkId({}), MarkId{1});
    QCOMPARE(freeMarkId({markAt(9.0, 2), markAt(1.0, 5)}), MarkId{6});
    QCOMPARE(freeMarkId({markAt(0.0, std::numeric_limits<MarkId>::max())}), MarkId{0});
    Timeline full(kMostMarks);
    for (std::size_t i = 0; i < full.size(); ++i) {
        full[i].id = static_cast<MarkId>(i + 1);
    }
    QCOMPARE(freeMarkId(full), MarkId{0});
    QVERIFY(findMark(full, 77) == &full[76] && findMark(full, 100'001) == nullptr);
}

void TestTimeline::whatIsAtOneTimeHappensInOrder()
{
    const Timeline ordered = inOrder({markAt(3.0, 1), markAt(1.0, 2), markAt(1.0, 4)});
    QCOMPARE(ordered[0].id, MarkId{2});
    QCOMPARE(ordered[1].id, MarkId{4});
    QCOMPARE(ordered[2].id, MarkId{1});
    QVERIFY(!doesAnything(ordered));
}

void TestTimeline::newStatesAreNotTakenForThoseThatAreGone()
{
    Scene scene;
    Mark mark = markAt(1.0, 1);
    mark.state = 1;
    scene.timeline = {mark};
    QCOMPARE(freeStateId({}, scene), StateId{2});
}

CROWD_TEST(TestTimeline)
#include "tst_Timeline.moc"
