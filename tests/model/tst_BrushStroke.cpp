// SPDX-License-Identifier: MIT
#include "model/brush/Stroke.h"

#include <array>
#include <numeric>

#include <QtTest/QTest>

#include "model/base/Random.h"
#include "tests/model/LivelyBrush.h"
#include "tests/program/Test.h"

using namespace crowd::test;

namespace {

/// A way in whole-number directions with grid points to split at, 0.4 s a piece.
std::vector<PointerInput> wavyWay()
{
    std::vector<PointerInput> way;
    for (int i = 0; i < 8; ++i) {
        way.push_back(PointerInput::at({300.0 + 90.0 * i, i % 2 == 0 ? 240.0 : 510.0}, 0.4 * i));
    }
    return way;
}

/// The sanitizers take fifteen times as long, and look for other things than equal crowds: to them
/// each selection is shown with one operator, and each operator with one selection, and ways are
/// split into fewer pieces.
#ifdef CROWD_SANITIZED
constexpr bool kShowsAll = false;
constexpr std::uint64_t kLongestPiece = 5000; ///< of the pointer's grid
#else
constexpr bool kShowsAll = true;
constexpr std::uint64_t kLongestPiece = 1500;
#endif

std::vector<PointerInput> split(const std::vector<PointerInput>& way)
{
    std::vector<PointerInput> inputs{way.front()};
    for (std::size_t i = 1; i < way.size(); ++i) {
        const glm::ivec2 move = way[i].grid - way[i - 1].grid;
        const int steps = std::gcd(move.x, move.y);
        for (int k = 7; k < steps; k += 1 + static_cast<int>(hashKeys(i, k) % kLongestPiece)) {
            PointerInput between = way[i - 1];
            between.grid += move / steps * k;
            between.timeSeconds += (way[i].timeSeconds - between.timeSeconds) * k / steps;
            inputs.push_back(between);
        }
        inputs.push_back(way[i]);
    }
    return inputs;
}

StrokeOutcome paintInputs(BrushScene& scene, const BrushSettings& settings,
                          const std::vector<PointerInput>& inputs, std::uint64_t seed)
{
    const auto stroke =
        Stroke::begin(scene.document, scene.context(fromAbove()), settings, seed, inputs.front());
    for (std::size_t i = 1; i < inputs.size(); ++i) {
        stroke->move(inputs[i]);
    }
    return stroke->finish();
}

/// Every brush by every selection and operator.
void addStrokeRows()
{
    QTest::addColumn<int>("kind");
    QTest::addColumn<int>("selection");
    QTest::addColumn<int>("op");
    for (const BrushKind kind : paintingBrushes()) {
        for (std::size_t selection = 0; selection < std::size(kSelections); ++selection) {
            const std::size_t operators =
                kShowsAll || selection == 0 ? std::size(kOperatorChoices) : 1;
            for (std::size_t op = 0; op < operators; ++op) {
                QTest::addRow("%s by %s, %s", brushType(kind).info.id, kSelections[selection].key,
                              kOperatorChoices[op].key)
                    << static_cast<int>(kind) << static_cast<int>(selection)
                    << static_cast<int>(op);
            }
        }
    }
}

/// What strokes change of a scene.
struct Painted
{
    Population people;
    RelationTable relations;
    friend bool operator==(const Painted&, const Painted&) = default;
};

Painted paintedIn(const BrushScene& scene)
{
    return {scene.people(), scene.document.scene().relations};
}

BrushSettings fetchedBrush()
{
    QFETCH(int, kind);
    QFETCH(int, selection);
    QFETCH(int, op);
    return livelyBrush(static_cast<BrushKind>(kind), static_cast<BrushSelection>(selection),
                       static_cast<BrushOperator>(op));
}

} // namespace

class tst_BrushStroke : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void doesNotDependOnHowEventsAreSplit_data() { addStrokeRows(); }
    void doesNotDependOnHowEventsAreSplit();
    void isUndoneRedoneAndReplayedToTheSameBytes_data() { addStrokeRows(); }
    void isUndoneRedoneAndReplayedToTheSameBytes();
    void anotherSeedGivesAnotherResult();
    void escapePutsEverythingBack_data() { addStrokeRows(); }
    void escapePutsEverythingBack();
    void saysWhyNothingHappened();
};

void tst_BrushStroke::doesNotDependOnHowEventsAreSplit()
{
    const BrushSettings settings = fetchedBrush();
    const std::vector<PointerInput> way = wavyWay();
    const std::vector<PointerInput> more = split(way);
    QVERIFY(more.size() > 5 * way.size());
    LivelyScene whole;
    LivelyScene pieces;
    whole.addCrowd();
    pieces.addCrowd();
    const StrokeOutcome outcome = paintInputs(whole, settings, way, 11);
    QVERIFY2(outcome.isCommitted, qPrintable(outcome.message));
    QVERIFY(paintInputs(pieces, settings, more, 11).isCommitted);
    QVERIFY(paintedIn(whole) == paintedIn(pieces));
    QCOMPARE(whole.document.scene().nextId, pieces.document.scene().nextId);
}

void tst_BrushStroke::isUndoneRedoneAndReplayedToTheSameBytes()
{
    const BrushSettings settings = fetchedBrush();
    LivelyScene scene;
    scene.addCrowd();
    const Painted before = paintedIn(scene);
    const std::vector<PointerInput> way = wavyWay();
    const auto stroke =
        Stroke::begin(scene.document, scene.context(fromAbove()), settings, 5, way.front());
    for (std::size_t i = 1; i < way.size(); ++i) {
        stroke->move(way[i]);
    }
    const StrokeOutcome outcome = stroke->finish();
    QVERIFY(outcome.isCommitted);
    QVERIFY(outcome.affected > 0);
    RecordedStroke recording = scene.recorded;
    QCOMPARE(recording.affected, outcome.affected);
    const Painted after = paintedIn(scene);
    QVERIFY(!(after == before));
    QCOMPARE(scene.document.undoStack().count(), 3);
    scene.document.undoStack().undo();
    QVERIFY(paintedIn(scene) == before);
    scene.document.undoStack().redo();
    QVERIFY(paintedIn(scene) == after);
    scene.document.undoStack().undo();
    // By the same people as then, and by those whom it selects once more.
    QVERIFY(replay(scene.document, scene.keyframes, scene.rays, recording).isCommitted);
    QVERIFY(paintedIn(scene) == after);
    scene.document.undoStack().undo();
    recording.selected.clear();
    QVERIFY(replay(scene.document, scene.keyframes, scene.rays, recording).isCommitted);
    QVERIFY(paintedIn(scene) == after);
}

void tst_BrushStroke::anotherSeedGivesAnotherResult()
{
    const BrushSettings settings =
        livelyBrush(BrushKind::Colour, BrushSelection::Rectangle, BrushOperator::Random);
    BrushScene a;
    BrushScene b;
    a.addPeople(crowdGrid());
    b.addPeople(crowdGrid());
    QVERIFY(paintInputs(a, settings, wavyWay(), 1).isCommitted);
    QVERIFY(paintInputs(b, settings, wavyWay(), 2).isCommitted);
    QVERIFY(!(a.people() == b.people()));
}

void tst_BrushStroke::escapePutsEverythingBack()
{
    const BrushSettings settings = fetchedBrush();
    LivelyScene scene;
    scene.addCrowd();
    const Painted before = paintedIn(scene);
    const IndividualId nextId = scene.document.scene().nextId;
    for (const bool isDestroyed : {false, true}) {
        auto stroke = Stroke::begin(scene.document, scene.context(fromAbove()), settings, 5,
                                    PointerInput::at({300.0, 240.0}, 0.0));
        stroke->move(PointerInput::at({700.0, 500.0}, 1.0));
        stroke->move(PointerInput::at({720.0, 300.0}, 1.5));
        QVERIFY(!(paintedIn(scene) == before));
        if (isDestroyed) {
            stroke.reset();
        } else {
            stroke->cancel();
            QVERIFY(!stroke->finish().isCommitted);
        }
        QVERIFY(paintedIn(scene) == before);
        QCOMPARE(scene.document.scene().nextId, nextId);
        QCOMPARE(scene.document.undoStack().count(), 2);
        QVERIFY(!scene.document.isEditOpen());
    }
}

void tst_BrushStroke::saysWhyNothingHappened()
{
    BrushScene scene;
    scene.addPeople({{0, 0, 0}});
    const View view = fromAbove();
    const glm::dvec2 on = pixelOf(view, {0, 0, 0});
    const glm::dvec2 off = pixelOf(view, {4, 0, 0});
    BrushSettings settings = colourBrush(BrushSelection::Point);
    const int steps = scene.document.undoStack().count();
    QCOMPARE(scene.paint(view, settings, {off}).reason, StrokeReason::NobodyUnderBrush);
    QCOMPARE(scene.paint(view, settings, {off}).message, QStringLiteral("Nobody under the brush"));
    QCOMPARE(scene.document.undoStack().count(), steps);
    QVERIFY(scene.paint(view, settings, {on}).isCommitted);
    QCOMPARE(scene.paint(view, settings, {on}).reason, StrokeReason::Unchanged);
    settings.as<ColourSettings>().slot = "hat";
    QCOMPARE(scene.paint(view, settings, {on}).reason, StrokeReason::NoSuchSlot);
    settings.setKind(BrushKind::Animation);
    settings.as<AnimationSettings>().setsPhase = false;
    QCOMPARE(scene.paint(view, settings, {on}).reason, StrokeReason::NothingChosen);
    settings.as<AnimationSettings>().clips = {{"fly", 1.0F}};
    QCOMPARE(scene.paint(view, settings, {on}).reason, StrokeReason::NoSuchClip);
    settings.as<AnimationSettings>().clips = {{"idle", 1.0F}};
    QCOMPARE(scene.paint(view, settings, {on}).reason, StrokeReason::Unchanged);
    settings.setKind(BrushKind::Orientation);
    QCOMPARE(scene.paint(view, settings, {on}).reason, StrokeReason::NoDirection);
    settings.as<OrientationSettings>().heading.mode = HeadingMode::Direction;
    QCOMPARE(scene.paint(view, settings, {on}).reason, StrokeReason::Unchanged);
    QCOMPARE(scene.document.undoStack().count(), steps + 1);
}

CROWD_TEST(tst_BrushStroke)
#include "tst_BrushStroke.moc"
