// SPDX-License-Identifier: MIT
#include "model/brush/LastStrokes.h"

#include <QtTest/QSignalSpy>
#include <QtTest/QTest>

#include "tests/model/LivelyBrush.h"
#include "tests/program/Test.h"

using namespace crowd::test;

namespace {

constexpr glm::dvec2 kTopLeft{200.0, 100.0};
constexpr glm::dvec2 kBottomRight{1100.0, 700.0};
constexpr glm::dvec2 kMiddle{640.0, 384.0};

struct StrokesScene : LivelyScene
{
    StrokesScene()
    {
        addCrowd();
        strokes.setContext([this] { return context(fromFront()); }); // another view than painted in
    }
    StrokeOutcome paintAll(const BrushSettings& settings, std::uint64_t seed = 7)
    {
        return paint(fromAbove(), settings, {kTopLeft, kBottomRight}, seed);
    }
    LastStrokes strokes{document};
};

BrushSettings heights(float low, float high)
{
    BrushSettings settings = brush(BrushKind::Scale, BrushSelection::Rectangle);
    settings.as<ScaleSettings>().height = {low, high};
    return settings;
}

BrushSettings redTops()
{
    BrushSettings settings = colourBrush(BrushSelection::AllInCircle);
    settings.radiusPixels = 100.0F;
    return settings;
}

} // namespace

class tst_LastStrokes : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void laidAnewEqualsAFreshOne_data();
    void laidAnewEqualsAFreshOne();
    void drawnAnewItMeansTheSamePeople();
    void laterOnesAreLaidAgain();
    void laterOnesThatFindNobodyWait();
    void whatChangesNobodyLeavesAllAsItWas();
    void anotherEditClosesTheList();
    void undoneOnesComeBackWhenRedone();
    void whoWasElsewhereInASessionIsStillMeant();
    void openEditsAreLeftAlone();
    void soManyAreKeptAsFit();
};

void tst_LastStrokes::laidAnewEqualsAFreshOne_data()
{
    QTest::addColumn<int>("kind");
    QTest::addColumn<int>("selection");
    for (const BrushKind kind : paintingBrushes()) {
        for (std::size_t selection = 0; selection < std::size(kSelections); ++selection) {
            QTest::addRow("%s by %s", brushType(kind).info.id, kSelections[selection].key)
                << static_cast<int>(kind) << static_cast<int>(selection);
        }
    }
}

/// Other values with the same area, and another area.
void tst_LastStrokes::laidAnewEqualsAFreshOne()
{
    QFETCH(int, kind);
    QFETCH(int, selection);
    std::vector<glm::dvec2> way;
    for (int i = 0; i < 24; ++i) { // 1.2 s of a spray
        way.emplace_back(300 + 28 * i, i % 2 == 0 ? 220 : 530);
    }
    const BrushSettings first =
        livelyBrush(static_cast<BrushKind>(kind), static_cast<BrushSelection>(selection),
                    BrushOperator::Uniform);
    BrushSettings other = first;
    other.op = BrushOperator::Random;
    BrushSettings wider = other;
    wider.radiusPixels = 150.0F;
    wider.through = true;
    StrokesScene scene;
    QVERIFY(scene.paint(fromAbove(), first, way).isCommitted);
    QCOMPARE(scene.strokes.tail().size(), 1U);
    for (const BrushSettings& settings : {other, wider}) {
        StrokesScene fresh;
        QVERIFY(fresh.paint(fromAbove(), settings, way).isCommitted);
        QVERIFY(scene.strokes.layAnew(0, settings, 7).isCommitted);
        QVERIFY(scene.people() == fresh.people());
        QCOMPARE(scene.document.undoStack().count(), 3);
        QCOMPARE(scene.document.undoStack().undoText(), fresh.document.undoStack().undoText());
        QVERIFY(scene.strokes.tail().front().stroke.settings == settings);
    }
}

void tst_LastStrokes::drawnAnewItMeansTheSamePeople()
{
    StrokesScene scene;
    BrushSettings spray = heights(0.5F, 0.6F);
    spray.selection = BrushSelection::Spray;
    spray.ratePerSecond = 60.0F;
    spray.as<ScaleSettings>().setsGirth = false;
    const Population before = scene.people();
    const auto meant = [&scene, &before] {
        Ids ids;
        for (const IndividualId id : before.ids()) {
            const std::size_t row = before.rowOf(id);
            if (scene.people().column(columns::height)[row] !=
                before.column(columns::height)[row]) {
                ids.push_back(id);
            }
        }
        return ids;
    };
    std::vector<glm::dvec2> way(24, kMiddle);
    QVERIFY(scene.paint(fromAbove(), spray, way).isCommitted);
    const Ids first = meant();
    const Population painted = scene.people();
    QVERIFY(scene.strokes.layAnew(0, spray, 8).isCommitted); // whose points would be others
    QVERIFY(meant() == first);
    QVERIFY(!(scene.people() == painted));
}

void tst_LastStrokes::laterOnesAreLaidAgain()
{
    StrokesScene scene;
    StrokesScene fresh;
    const BrushSettings sizes = heights(0.5F, 0.6F);
    const BrushSettings others = heights(1.5F, 1.6F);
    QVERIFY(scene.paintAll(sizes).isCommitted);
    QVERIFY(scene.paint(fromAbove(), redTops(), {kMiddle}).isCommitted);
    QCOMPARE(scene.strokes.tail().size(), 2U);
    QVERIFY(scene.strokes.layAnew(0, others, 3).isCommitted);
    QVERIFY(fresh.paintAll(others, 3).isCommitted);
    QVERIFY(fresh.paint(fromAbove(), redTops(), {kMiddle}).isCommitted);
    QVERIFY(scene.people() == fresh.people());
    QCOMPARE(scene.document.undoStack().count(), 4);
    scene.document.undoStack().setIndex(2);
    fresh.document.undoStack().setIndex(2);
    QVERIFY(scene.people() == fresh.people());
}

void tst_LastStrokes::laterOnesThatFindNobodyWait()
{
    StrokesScene scene;
    BrushSettings away = brush(BrushKind::Delete, BrushSelection::Rectangle);
    away.as<DeleteSettings>().percent = 30.0F;
    QVERIFY(scene.paintAll(away).isCommitted);
    QVERIFY(scene.paint(fromAbove(), redTops(), {kMiddle}).isCommitted);
    const Population before = scene.people();
    BrushSettings all = away;
    all.as<DeleteSettings>().percent = 100.0F;
    QVERIFY(scene.strokes.layAnew(0, all, 7).isCommitted);
    QCOMPARE(scene.people().size(), 0U);
    QCOMPARE(scene.strokes.tail().size(), 2U);
    QVERIFY(!scene.strokes.tail()[1].step);
    QCOMPARE(scene.document.undoStack().count(), 3);
    QVERIFY(scene.strokes.layAnew(0, away, 7).isCommitted); // and is there again
    QVERIFY(scene.people() == before);
    QVERIFY(scene.strokes.tail()[1].step);
}

void tst_LastStrokes::whatChangesNobodyLeavesAllAsItWas()
{
    StrokesScene scene;
    QVERIFY(scene.paintAll(heights(0.5F, 0.6F)).isCommitted);
    QVERIFY(scene.paint(fromAbove(), redTops(), {kMiddle}).isCommitted);
    const Population before = scene.people();
    BrushSettings nothing = heights(1.0F, 1.0F);
    nothing.as<ScaleSettings>().setsHeight = false;
    nothing.as<ScaleSettings>().setsGirth = false;
    QCOMPARE(scene.strokes.layAnew(0, nothing, 7).reason, StrokeReason::NothingChosen);
    QVERIFY(scene.people() == before);
    QCOMPARE(scene.strokes.tail().size(), 2U);
    QVERIFY(scene.strokes.tail()[0].stroke.settings == heights(0.5F, 0.6F));
    QCOMPARE(scene.document.undoStack().index(), 4);
}

void tst_LastStrokes::anotherEditClosesTheList()
{
    StrokesScene scene;
    QVERIFY(scene.strokes.tail().empty()); // the crowd came by an edit
    QVERIFY(scene.paintAll(heights(0.5F, 0.6F)).isCommitted);
    scene.addPeople({{0, 0, 8}});
    QVERIFY(scene.strokes.tail().empty());
    QCOMPARE(scene.strokes.layAnew(0, heights(1, 2), 7).reason, StrokeReason::Cancelled);
    QVERIFY(scene.paintAll(heights(0.7F, 0.8F)).isCommitted);
    QCOMPARE(scene.strokes.tail().size(), 1U);
    scene.document.undoStack().undo();
    scene.document.undoStack().undo();
    QCOMPARE(scene.strokes.tail().size(), 1U); // the one before the edit is the last again
    QVERIFY(scene.strokes.tail()[0].stroke.settings == heights(0.5F, 0.6F));
    Scene other = scene.document.scene();
    scene.document.replaceScene(std::move(other), {});
    QVERIFY(scene.strokes.tail().empty());
}

void tst_LastStrokes::soManyAreKeptAsFit()
{
    StrokesScene scene;
    RecordedStroke large;
    large.settings = redTops();
    large.selected.emplace_back(LastStrokes::kMostBytes / sizeof(IndividualId) / 5 * 2);
    std::uint64_t seed = 0;
    for (const std::size_t kept : {1U, 2U, 2U}) {
        QVERIFY(scene.paintAll(heights(0.5F, 0.6F), ++seed).isCommitted);
        scene.document.undoStack().undo();
        Q_EMIT scene.document.stepCommitted({nullptr, {}, &large}); // the next step is this one
        scene.document.undoStack().redo();
        QCOMPARE(scene.strokes.tail().size(), kept);
    }
    QCOMPARE(scene.document.undoStack().index(), 5); // as undo steps all stay
    const std::size_t each = LastStrokes::kMostBytes / 5 * 2;
    QVERIFY(scene.document.undoMemory().bytes() > 2 * each); // and the strokes are counted
    scene.document.setUndoBudget(4 * each + 4 * each / 2);
    QCOMPARE(scene.strokes.tail().size(), 1U);
    QVERIFY(scene.document.undoMemory().bytes() < 2 * each);
    scene.document.replaceScene({}, {});
    QCOMPARE(scene.document.undoMemory().bytes(), std::size_t{0});
}

void tst_LastStrokes::undoneOnesComeBackWhenRedone()
{
    StrokesScene scene;
    QSignalSpy changes(&scene.strokes, &LastStrokes::changed);
    QVERIFY(scene.paintAll(heights(0.5F, 0.6F)).isCommitted);
    QVERIFY(scene.paintAll(heights(0.7F, 0.8F)).isCommitted);
    QCOMPARE(changes.count(), 2);
    scene.document.undoStack().undo();
    QCOMPARE(scene.strokes.tail().size(), 1U);
    scene.document.undoStack().redo();
    QCOMPARE(scene.strokes.tail().size(), 2U);
    scene.document.undoStack().undo();
    QVERIFY(scene.strokes.layAnew(0, heights(0.9F, 1.0F), 7).isCommitted);
    QCOMPARE(scene.strokes.tail().size(), 1U); // the undone one is gone, as by any new step
    QVERIFY(!scene.document.undoStack().canRedo());
}

void tst_LastStrokes::whoWasElsewhereInASessionIsStillMeant()
{
    StrokesScene scene;
    BrushContext context = scene.context(fromAbove());
    context.pose = [](CrowdFrame& frame) { // all of them two metres further than the scene says
        const auto was = frame.population.column(columns::position);
        std::vector<glm::vec3> positions(was.begin(), was.end());
        for (glm::vec3& position : positions) {
            position.x += 2.0F;
        }
        const Ids ids(frame.population.ids().begin(), frame.population.ids().end());
        frame.population.setValues(columns::position, ids, std::span<const glm::vec3>(positions));
    };
    BrushSettings settings = redTops();
    settings.op = BrushOperator::Random;
    const auto stroke =
        Stroke::begin(scene.document, context, settings, 7, PointerInput::at(kMiddle, 0.0));
    QVERIFY(stroke->finish().isCommitted);
    const auto coloured = [&scene] {
        Ids ids;
        for (const IndividualId id : scene.people().ids()) {
            if (tintOf(scene, id, 2).strength > 0) {
                ids.push_back(id);
            }
        }
        return ids;
    };
    const Ids meant = coloured();
    QVERIFY(!scene.strokes.tail()[0].stroke.isExact);
    QVERIFY(scene.strokes.layAnew(0, settings, 8).isCommitted);
    QVERIFY(coloured() == meant);
    QVERIFY(!scene.strokes.tail()[0].stroke.isExact); // a script could still not repeat it
}

void tst_LastStrokes::openEditsAreLeftAlone()
{
    StrokesScene scene;
    QVERIFY(scene.paintAll(heights(0.5F, 0.6F)).isCommitted);
    const auto edit = scene.document.beginEdit().value();
    QCOMPARE(scene.strokes.layAnew(0, heights(1, 2), 7).reason, StrokeReason::Cancelled);
}

CROWD_TEST(tst_LastStrokes)
#include "tst_LastStrokes.moc"
