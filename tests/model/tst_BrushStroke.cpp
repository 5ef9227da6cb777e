// SPDX-License-Identifier: MIT
#include "model/brush/Stroke.h"

#include <cmath>
#include <numbers>
#include <numeric>

#include <QtTest/QTest>

#include "model/base/Random.h"
#include "tests/model/BrushScene.h"
#include "tests/program/Test.h"

using namespace crowd::test;

namespace {

using Ids = std::vector<IndividualId>;

/// 10 × 6 people a metre apart around the origin.
std::vector<glm::vec3> crowdGrid()
{
    std::vector<glm::vec3> positions;
    for (int z = 0; z < 6; ++z) {
        for (int x = 0; x < 10; ++x) {
            positions.emplace_back(static_cast<float>(x) - 4.5F, 0.0F,
                                   static_cast<float>(z) - 2.5F);
        }
    }
    return positions;
}

BrushSettings colourBrush(BrushSelection selection)
{
    BrushSettings settings = brush(BrushKind::Colour, selection);
    settings.colour.colors = {{200, 100, 0}, {0, 100, 200}};
    return settings;
}

Tint tintOf(const BrushScene& scene, IndividualId id, int slot)
{
    return scene.people().column(columns::tint(slot))[scene.people().rowOf(id)];
}

float headingOf(const BrushScene& scene, IndividualId id)
{
    return scene.people().column(columns::heading)[scene.people().rowOf(id)];
}

/// A way in whole-number directions with grid points to split at, 0.4 s a piece.
std::vector<PointerInput> wavyWay()
{
    std::vector<PointerInput> way;
    for (int i = 0; i < 8; ++i) {
        way.push_back(PointerInput::at({300.0 + 90.0 * i, i % 2 == 0 ? 240.0 : 510.0}, 0.4 * i));
    }
    return way;
}

std::vector<PointerInput> split(const std::vector<PointerInput>& way)
{
    std::vector<PointerInput> inputs{way.front()};
    for (std::size_t i = 1; i < way.size(); ++i) {
        const glm::ivec2 move = way[i].grid - way[i - 1].grid;
        const int steps = std::gcd(move.x, move.y);
        for (int k = 7; k < steps; k += 1 + static_cast<int>(hashKeys(i, k) % 1500)) {
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

/// A brush of each kind that changes much, with all that is random about it.
BrushSettings livelyBrush(BrushKind kind, BrushSelection selection, BrushOperator op)
{
    BrushSettings settings = brush(kind, selection);
    settings.op = op;
    settings.ratePerSecond = 60.0F;
    settings.create.minimalDistance = 0.3F;
    settings.create.palette = {{255, 0, 0}, {0, 255, 0}, {0, 0, 255}};
    settings.colour.blends = true;
    settings.orientation.heading.mode =
        op == BrushOperator::Random ? HeadingMode::Random : HeadingMode::AlongStroke;
    settings.animation.clips = {{"sit", 1.0F}, {"cheer", 2.0F}};
    settings.animation.setsSpeed = true;
    settings.animation.speed = {0.5F, 2.0F};
    return settings;
}

void addStrokeRows()
{
    QTest::addColumn<int>("kind");
    QTest::addColumn<int>("selection");
    QTest::addColumn<int>("op");
    constexpr std::array<const char*, 5> kKinds{"create", "delete", "colour", "orientation",
                                                "animation"};
    constexpr std::array<const char*, 4> kSelections{"point", "spray", "circle", "rectangle"};
    constexpr std::array<const char*, 3> kOperators{"uniform", "random", "gradient"};
    for (int kind = 0; kind < 5; ++kind) {
        for (int selection = 0; selection < 4; ++selection) {
            for (int op = 0; op < 3; ++op) {
                QTest::addRow("%s by %s, %s", kKinds[static_cast<std::size_t>(kind)],
                              kSelections[static_cast<std::size_t>(selection)],
                              kOperators[static_cast<std::size_t>(op)])
                    << kind << selection << op;
            }
        }
    }
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
    void coloursOneSlotOrAllTintable();
    void coloursRandomlyFromTheList();
    void gradientRunsAlongTheLine();
    void gradientFollowsThePointerUntilRelease();
    void rectangleShrinksBack();
    void buildsUpOnlyWhenAsked();
    void turnsAlongTheStroke();
    void turnsAsTheModeSays();
    void gradientTurnsAllAlongTheLine();
    void animatesWithClipsOfTheTemplate();
    void stylesAreClipsToWalkWith();
    void deletesTheFrontmostOrAllThrough();
    void digsThroughWhileItDeletes();
    void selectsInTheShownKeyframe();
    void saysWhyNothingHappened();
    void pressureScalesTheSize();
    void touchesNobodyOutsideTheCircle();
    void mainNumbersStayInTheirLimits();
    void mainNumberIsOneThatTheStrokeUses_data();
    void mainNumberIsOneThatTheStrokeUses();
    void thinsOutByAShare();
    void turnsAwayFromAPoint();
};

void tst_BrushStroke::doesNotDependOnHowEventsAreSplit()
{
    const BrushSettings settings = fetchedBrush();
    const std::vector<PointerInput> way = wavyWay();
    const std::vector<PointerInput> more = split(way);
    QVERIFY(more.size() > 5 * way.size());
    BrushScene whole;
    BrushScene pieces;
    whole.addPeople(crowdGrid());
    pieces.addPeople(crowdGrid());
    const StrokeOutcome outcome = paintInputs(whole, settings, way, 11);
    QVERIFY2(outcome.isCommitted, qPrintable(outcome.message));
    QVERIFY(paintInputs(pieces, settings, more, 11).isCommitted);
    QVERIFY(whole.people() == pieces.people());
    QCOMPARE(whole.document.scene().nextId, pieces.document.scene().nextId);
}

void tst_BrushStroke::isUndoneRedoneAndReplayedToTheSameBytes()
{
    const BrushSettings settings = fetchedBrush();
    BrushScene scene;
    scene.addPeople(crowdGrid());
    const Population before = scene.people();
    const std::vector<PointerInput> way = wavyWay();
    const auto stroke =
        Stroke::begin(scene.document, scene.context(fromAbove()), settings, 5, way.front());
    for (std::size_t i = 1; i < way.size(); ++i) {
        stroke->move(way[i]);
    }
    const RecordedStroke recording = stroke->recording();
    const StrokeOutcome outcome = stroke->finish();
    QVERIFY(outcome.isCommitted);
    QVERIFY(outcome.affected > 0);
    const Population after = scene.people();
    QVERIFY(!(after == before));
    QCOMPARE(scene.document.undoStack().count(), 2);
    scene.document.undoStack().undo();
    QVERIFY(scene.people() == before);
    scene.document.undoStack().redo();
    QVERIFY(scene.people() == after);
    scene.document.undoStack().undo();
    QVERIFY(replay(scene.document, scene.keyframes, scene.rays, recording).isCommitted);
    QVERIFY(scene.people() == after);
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
    BrushScene scene;
    scene.addPeople(crowdGrid());
    const Population before = scene.people();
    const IndividualId nextId = scene.document.scene().nextId;
    for (const bool isDestroyed : {false, true}) {
        auto stroke = Stroke::begin(scene.document, scene.context(fromAbove()), settings, 5,
                                    PointerInput::at({300.0, 240.0}, 0.0));
        stroke->move(PointerInput::at({700.0, 500.0}, 1.0));
        QVERIFY(!(scene.people() == before));
        if (isDestroyed) {
            stroke.reset();
        } else {
            stroke->cancel();
            QVERIFY(!stroke->finish().isCommitted);
        }
        QVERIFY(scene.people() == before);
        QCOMPARE(scene.document.scene().nextId, nextId);
        QCOMPARE(scene.document.undoStack().count(), 1);
        QVERIFY(!scene.document.isEditOpen());
    }
}

void tst_BrushStroke::coloursOneSlotOrAllTintable()
{
    BrushScene scene;
    const Ids ids = scene.addPeople({{-2, 0, 0}, {2, 0, 0}});
    BrushSettings settings = colourBrush(BrushSelection::Point);
    settings.colour.strength = 0.5F;
    const View view = fromAbove();
    QCOMPARE(scene.paint(view, settings, {pixelOf(view, {-2, 0, 0})}).affected, 1);
    QCOMPARE(tintOf(scene, ids[0], 0), Tint{});
    QCOMPARE(tintOf(scene, ids[0], 1), (Tint{200, 100, 0, 128}));
    QCOMPARE(tintOf(scene, ids[0], 2), (Tint{200, 100, 0, 128}));
    settings.colour.slot = "bottom";
    QCOMPARE(scene.paint(view, settings, {pixelOf(view, {2, 0, 0})}).affected, 1);
    QCOMPARE(tintOf(scene, ids[1], 1), Tint{});
    QCOMPARE(tintOf(scene, ids[1], 2), (Tint{200, 100, 0, 128}));
}

void tst_BrushStroke::coloursRandomlyFromTheList()
{
    BrushScene scene;
    const Ids ids = scene.addPeople(crowdGrid());
    BrushSettings settings = colourBrush(BrushSelection::Rectangle);
    settings.op = BrushOperator::Random;
    settings.distribution.weights.fill(0.0F);
    settings.distribution.weights[2] = 1.0F;
    settings.distribution.weights[14] = 3.0F;
    QCOMPARE(scene.paint(fromAbove(), settings, {{1.0, 1.0}, {1279.0, 767.0}}).affected, 60);
    int first = 0;
    for (const IndividualId id : ids) {
        const Tint tint = tintOf(scene, id, 1);
        QVERIFY(tint == (Tint{200, 100, 0, 255}) || tint == (Tint{0, 100, 200, 255}));
        QCOMPARE(tint, tintOf(scene, id, 2));
        first += tint.red == 200 ? 1 : 0;
    }
    QVERIFY2(first >= 6 && first <= 25, qPrintable(QString::number(first)));
}

void tst_BrushStroke::gradientRunsAlongTheLine()
{
    BrushScene scene;
    const Ids ids = scene.addPeople(crowdGrid());
    BrushSettings settings = colourBrush(BrushSelection::Rectangle);
    settings.op = BrushOperator::Gradient;
    const View view = fromAbove();
    const glm::dvec2 from = pixelOf(view, {-6.0F, 0.0F, -4.0F});
    const glm::dvec2 to = pixelOf(view, {6.0F, 0.0F, 4.0F});
    QCOMPARE(scene.paint(view, settings, {from, to}).affected, 60);
    for (std::size_t i = 0; i < ids.size(); ++i) {
        const glm::vec3 foot = crowdGrid()[i];
        const double share = ((foot.x + 6.0) * 12.0 + (foot.z + 4.0) * 8.0) / (144.0 + 64.0);
        const Tint tint = tintOf(scene, ids[i], 1);
        QVERIFY(std::abs(tint.red - 200.0 * (1.0 - share)) <= 1.0);
        QVERIFY(std::abs(tint.blue - 200.0 * share) <= 1.0);
        QCOMPARE(tint.green, std::uint8_t{100});
    }
}

void tst_BrushStroke::gradientFollowsThePointerUntilRelease()
{
    BrushScene scene;
    const Ids ids = scene.addPeople({{-2, 0, 0}, {0, 0, 0}, {2, 0, 0}});
    BrushSettings settings = colourBrush(BrushSelection::AllInCircle);
    settings.op = BrushOperator::Gradient;
    const View view = fromAbove();
    const auto at = [&](float x) { return PointerInput::at(pixelOf(view, {x, 0, 0}), 0.0); };
    const auto stroke = Stroke::begin(scene.document, scene.context(view), settings, 1, at(-2));
    stroke->move(at(0));
    QCOMPARE(tintOf(scene, ids[1], 1).blue, std::uint8_t{200});
    stroke->move(at(2));
    QCOMPARE(tintOf(scene, ids[0], 1).blue, std::uint8_t{0});
    QCOMPARE(tintOf(scene, ids[1], 1).blue, std::uint8_t{100});
    QCOMPARE(tintOf(scene, ids[2], 1).blue, std::uint8_t{200});
    QCOMPARE(stroke->finish().affected, 3);
}

void tst_BrushStroke::rectangleShrinksBack()
{
    BrushScene scene;
    const Ids ids = scene.addPeople({{-2, 0, 0}, {2, 0, 0}});
    const View view = fromAbove();
    const auto at = [&](float x, float z) {
        return PointerInput::at(pixelOf(view, {x, 0, z}), 0.0);
    };
    const auto stroke = Stroke::begin(scene.document, scene.context(view),
                                      colourBrush(BrushSelection::Rectangle), 1, at(-3, -1));
    stroke->move(at(3, 1));
    QCOMPARE(stroke->affected(), 2);
    stroke->move(at(0, 1));
    QCOMPARE(stroke->affected(), 1);
    QCOMPARE(tintOf(scene, ids[1], 1), Tint{});
    QCOMPARE(stroke->finish().affected, 1);
}

void tst_BrushStroke::buildsUpOnlyWhenAsked()
{
    const auto greenAfter = [](bool buildUp) {
        BrushScene scene;
        const Ids ids = scene.addPeople({{0, 0, 0}});
        BrushSettings settings = brush(BrushKind::Colour, BrushSelection::AllInCircle);
        settings.colour.colors = {{0, 55, 0}};
        settings.buildUp = buildUp;
        settings.flow = 0.5F;
        const glm::dvec2 at = pixelOf(fromAbove(), {0, 0, 0});
        // Four dabs: 0, 10, 20 and 30 pixels from the press.
        scene.paint(fromAbove(), settings, {at, at + glm::dvec2(30.0, 0.0)});
        return static_cast<int>(tintOf(scene, ids[0], 1).green);
    };
    QCOMPARE(greenAfter(false), 55);
    // 255, 155, 105, 80, then 67.5 away from the old value.
    QCOMPARE(greenAfter(true), 67);
}

void tst_BrushStroke::turnsAlongTheStroke()
{
    BrushScene scene;
    const Ids ids = scene.addPeople({{-2, 0, 0}, {2, 0, 0}});
    BrushSettings settings = brush(BrushKind::Orientation, BrushSelection::AllInCircle);
    settings.orientation.heading.mode = HeadingMode::AlongStroke;
    const View view = fromAbove();
    const auto outcome =
        scene.paint(view, settings, {pixelOf(view, {-2, 0, 0}), pixelOf(view, {2, 0, 0})});
    QCOMPARE(outcome.affected, 2);
    // To the right on screen is +X, a quarter turn from +Z.
    const float quarter = std::numbers::pi_v<float> / 2.0F;
    QVERIFY(std::abs(headingOf(scene, ids[0]) - quarter) < 1.0e-4F);
    QVERIFY(std::abs(headingOf(scene, ids[1]) - quarter) < 1.0e-4F);
}

void tst_BrushStroke::turnsAsTheModeSays()
{
    BrushScene scene;
    const Ids ids = scene.addPeople({{-2, 0, 0}, {2, 0, 1}});
    BrushSettings settings = brush(BrushKind::Orientation, BrushSelection::Rectangle);
    HeadingSettings& heading = settings.orientation.heading;
    const std::vector<glm::dvec2> all{{1.0, 1.0}, {1279.0, 767.0}};
    heading.mode = HeadingMode::Direction;
    heading.headingRadians = 1.0F;
    QCOMPARE(scene.paint(fromAbove(), settings, all).affected, 2);
    QCOMPARE(headingOf(scene, ids[0]), 1.0F);
    heading.mode = HeadingMode::TowardsPoint;
    heading.towardsPoint = {2.0F, 0.0F, 4.0F};
    QCOMPARE(scene.paint(fromAbove(), settings, all).affected, 2);
    QVERIFY(std::abs(headingOf(scene, ids[0]) - std::atan2(4.0F, 4.0F)) < 1.0e-5F);
    QVERIFY(std::abs(headingOf(scene, ids[1])) < 1.0e-5F);
    heading.mode = HeadingMode::Random;
    heading.spreadRadians = 0.2F;
    QCOMPARE(scene.paint(fromAbove(), settings, all).affected, 2);
    QVERIFY(std::abs(headingOf(scene, ids[0]) - 1.0F) <= 0.2F);
    QVERIFY(headingOf(scene, ids[0]) != headingOf(scene, ids[1]));
}

void tst_BrushStroke::gradientTurnsAllAlongTheLine()
{
    BrushScene scene;
    const Ids ids = scene.addPeople(crowdGrid());
    BrushSettings settings = brush(BrushKind::Orientation, BrushSelection::Rectangle);
    settings.op = BrushOperator::Gradient;
    const View view = fromAbove();
    scene.paint(view, settings, {pixelOf(view, {-5, 0, -4}), pixelOf(view, {5, 0, 4})});
    for (const IndividualId id : ids) {
        QVERIFY(std::abs(headingOf(scene, id) - std::atan2(10.0F, 8.0F)) < 1.0e-3F);
    }
}

void tst_BrushStroke::animatesWithClipsOfTheTemplate()
{
    BrushScene scene;
    const Ids ids = scene.addPeople(crowdGrid());
    BrushSettings settings = brush(BrushKind::Animation, BrushSelection::Rectangle);
    settings.op = BrushOperator::Random;
    settings.animation.clips = {{"sit", 1.0F}, {"cheer", 3.0F}, {"no such clip", 9.0F}};
    settings.animation.setsSpeed = true;
    settings.animation.speed = {0.5F, 1.5F};
    QCOMPARE(scene.paint(fromAbove(), settings, {{1.0, 1.0}, {1279.0, 767.0}}).affected, 60);
    std::array<int, 3> clips{};
    for (std::size_t row = 0; row < ids.size(); ++row) {
        ++clips[scene.people().column(columns::clip)[row]];
        const float phase = scene.people().column(columns::phase)[row];
        const float speed = scene.people().column(columns::playbackSpeed)[row];
        QVERIFY(phase >= 0.0F && phase < 1.0F && speed >= 0.5F && speed < 1.5F);
    }
    QCOMPARE(clips[0], 0);
    QVERIFY(clips[1] >= 5 && clips[1] <= 26);
    settings.op = BrushOperator::Uniform;
    settings.animation.phase = {0.25F, 1.0F};
    scene.paint(fromAbove(), settings, {{1.0, 1.0}, {1279.0, 767.0}});
    QCOMPARE(scene.people().column(columns::clip)[9], std::uint16_t{1});
    QCOMPARE(scene.people().column(columns::phase)[9], 0.25F);
}

void tst_BrushStroke::stylesAreClipsToWalkWith()
{
    BrushScene scene;
    const Ids ids = scene.addPeople(crowdGrid());
    const View view = fromAbove();
    const std::vector<glm::dvec2> all{{1.0, 1.0}, {1279.0, 767.0}};
    BrushSettings settings = brush(BrushKind::Style, BrushSelection::Rectangle);
    settings.style.clips = {{"idle", 1.0F}, {"cheer", 1.0F}};
    settings.style.setsSpeed = false;
    // Nobody gets anywhere with a clip that stays in place.
    QCOMPARE(scene.paint(view, settings, {all[0], all[1]}).affected, 0);
    TemplateEntry entry = scene.document.scene().templates[0];
    entry.clipSpeeds = {0.0F, 0.0F, 1.5F};
    auto edit = scene.document.beginEdit();
    edit->changeTemplate(entry);
    edit->commit(QStringLiteral("Speed"));
    settings.style.clips = {{"cheer", 1.0F}};
    settings.style.setsSpeed = true;
    settings.style.speed = {2.0F, 3.0F};
    QCOMPARE(settings.mainNumber().quantity, MainQuantity::WalkSpeed);
    QCOMPARE(settings.withMainNumber(4.0).style.speed, (ValueRange{4.0F, 5.0F}));
    QCOMPARE(scene.paint(view, settings, {all[0], all[1]}).affected, 60);
    float slowest = 9.0F;
    float fastest = 0.0F;
    for (std::size_t row = 0; row < ids.size(); ++row) {
        QCOMPARE(scene.people().column(columns::walkStyle)[row], std::uint16_t{3});
        slowest = std::min(slowest, scene.people().column(columns::walkSpeed)[row]);
        fastest = std::max(fastest, scene.people().column(columns::walkSpeed)[row]);
    }
    QVERIFY(slowest >= 2.0F && fastest <= 3.0F && fastest - slowest > 0.7F);
    // None ticked: what fits the speed again, and the speed stays.
    settings.style.clips.clear();
    settings.style.setsSpeed = false;
    QCOMPARE(scene.paint(view, settings, {all[0], all[1]}).affected, 60);
    QCOMPARE(scene.people().column(columns::walkStyle)[7], std::uint16_t{0});
    scene.document.undoStack().undo();
    QCOMPARE(scene.people().column(columns::walkStyle)[7], std::uint16_t{3});
}

void tst_BrushStroke::deletesTheFrontmostOrAllThrough()
{
    const auto leftAfter = [](bool through) {
        BrushScene scene;
        scene.addPeople({{0, 0, 2}, {0, 0, 0}, {0, 0, -2}, {3, 0, 0}});
        BrushSettings settings = brush(BrushKind::Delete, BrushSelection::Point);
        settings.through = through;
        const View view = fromFront();
        scene.paint(view, settings, {pixelOf(view, {0, 1, 0})});
        return Ids(scene.people().ids().begin(), scene.people().ids().end());
    };
    QCOMPARE(leftAfter(false), (Ids{2, 3, 4}));
    QCOMPARE(leftAfter(true), (Ids{4}));
}

void tst_BrushStroke::digsThroughWhileItDeletes()
{
    BrushScene scene;
    scene.addPeople({{0, 0, 2}, {0, 0, 0}, {0, 0, -2}});
    BrushSettings settings = brush(BrushKind::Delete, BrushSelection::Spray);
    settings.radiusPixels = 2.0F;
    settings.ratePerSecond = 10.0F;
    const View view = fromFront();
    const glm::dvec2 at = pixelOf(view, {0, 1, 0});
    const auto outcome = scene.paint(view, settings, std::vector<glm::dvec2>(5, at));
    // The press takes one, the two points of the next 0.2 s one each.
    QCOMPARE(outcome.affected, 3);
    QVERIFY(scene.people().isEmpty());
}

void tst_BrushStroke::selectsInTheShownKeyframe()
{
    // Lies down over its second: the body is where it is shown, not where it was at the start.
    auto man = std::make_shared<Template>(*boxMan());
    Channel turn;
    turn.path = ChannelPath::Rotation;
    turn.times = {0.0F, 1.0F};
    turn.values = {0, 0, 0, 1, std::sqrt(0.5F), 0, 0, std::sqrt(0.5F)};
    man->clips[0].channels.push_back(turn);
    BrushScene scene;
    scene.document.setTemplateAsset(1, man, {});
    scene.addPeople({{0, 0, 0}});
    (void)scene.keyframes.clip(man, 0);
    scene.keyframes.waitForAll();
    BrushSettings settings = colourBrush(BrushSelection::Point);
    const View view = fromAbove();
    const auto affectedAt = [&](double seconds) {
        const auto stroke =
            Stroke::begin(scene.document, scene.context(view), settings, 1,
                          PointerInput::at(pixelOf(view, {0.0F, 0.0F, 1.5F}), 0.0, seconds));
        const int affected = stroke->affected();
        stroke->cancel();
        return affected;
    };
    QCOMPARE(affectedAt(0.0), 0);
    QCOMPARE(affectedAt(0.95), 1);
    QCOMPARE(affectedAt(4.95), 1);
    QCOMPARE(affectedAt(5.05), 0);
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
    QCOMPARE(scene.paint(view, settings, {on}).reason, StrokeReason::AlreadyThisColour);
    settings.colour.slot = "hat";
    QCOMPARE(scene.paint(view, settings, {on}).reason, StrokeReason::NoSuchSlot);
    settings.kind = BrushKind::Animation;
    settings.animation.setsPhase = false;
    QCOMPARE(scene.paint(view, settings, {on}).reason, StrokeReason::NothingChosen);
    settings.animation.clips = {{"fly", 1.0F}};
    QCOMPARE(scene.paint(view, settings, {on}).reason, StrokeReason::NoSuchClip);
    settings.animation.clips = {{"idle", 1.0F}};
    QCOMPARE(scene.paint(view, settings, {on}).reason, StrokeReason::AlreadyThisAnimation);
    settings.kind = BrushKind::Orientation;
    QCOMPARE(scene.paint(view, settings, {on}).reason, StrokeReason::NoDirection);
    settings.orientation.heading.mode = HeadingMode::Direction;
    QCOMPARE(scene.paint(view, settings, {on}).reason, StrokeReason::AlreadyThisHeading);
    QCOMPARE(scene.document.undoStack().count(), steps + 1);
}

void tst_BrushStroke::pressureScalesTheSize()
{
    const auto affectedAt = [](float pressure) {
        BrushScene scene;
        scene.addPeople(crowdGrid());
        BrushSettings settings = colourBrush(BrushSelection::AllInCircle);
        settings.radiusPixels = 300.0F;
        settings.pressureSize = true;
        PointerInput press = PointerInput::at(pixelOf(fromAbove(), {0.5F, 0, 0.5F}), 0.0);
        press.pressure = pressure;
        return Stroke::begin(scene.document, scene.context(fromAbove()), settings, 1, press)
            ->affected();
    };
    QCOMPARE(affectedAt(0.05F), 1);
    QVERIFY(affectedAt(1.0F) > 40);
}

void tst_BrushStroke::touchesNobodyOutsideTheCircle()
{
    BrushScene scene;
    const Ids ids = scene.addPeople(crowdGrid());
    BrushSettings settings = brush(BrushKind::Delete, BrushSelection::Spray);
    settings.radiusPixels = 128.0F;
    settings.ratePerSecond = 500.0F;
    const View view = fromAbove();
    const glm::dvec2 at = pixelOf(view, {0, 0, 0});
    std::vector<glm::dvec2> still(60, at);
    QVERIFY(scene.paint(view, settings, still).affected > 8);
    for (std::size_t i = 0; i < ids.size(); ++i) {
        // 128 pixels are 2 m; half the width of a man comes on top.
        if (glm::length(crowdGrid()[i]) > 2.0F + 0.3F) {
            QVERIFY(scene.people().rowOf(ids[i]) != Population::npos);
        }
    }
}

void tst_BrushStroke::mainNumbersStayInTheirLimits()
{
    for (int kind = 0; kind < 5; ++kind) {
        const BrushSettings settings = brush(static_cast<BrushKind>(kind), BrushSelection::Point);
        const MainNumber number = settings.mainNumber();
        const BrushSettings changed = settings.withMainNumber(number.value - number.step);
        QVERIFY(std::abs(changed.mainNumber().value - (number.value - number.step)) < 1.0e-4);
        const double most = settings.withMainNumber(1.0e9).mainNumber().value;
        QVERIFY(most <= number.high + 1.0e-4);
    }
    BrushSettings settings;
    QCOMPARE(settings.resized(5.0F).radiusPixels, settings.radiusPixels + 5.0F);
    QCOMPARE(settings.resized(-1.0e6F).radiusPixels, kMinRadiusPixels);
}

void tst_BrushStroke::mainNumberIsOneThatTheStrokeUses_data()
{
    QTest::addColumn<int>("kind");
    QTest::addColumn<int>("selection");
    QTest::addColumn<bool>("seats");
    QTest::addColumn<int>("quantity");
    const auto row = [](const char* name, BrushKind kind, BrushSelection selection, bool seats,
                        MainQuantity quantity) {
        QTest::newRow(name) << static_cast<int>(kind) << static_cast<int>(selection) << seats
                            << static_cast<int>(quantity);
    };
    using enum BrushSelection;
    row("spraying people", BrushKind::Create, Spray, true, MainQuantity::Rate);
    row("filling seats", BrushKind::Create, Rectangle, true, MainQuantity::SeatPercent);
    row("dots along seats", BrushKind::Create, Point, true, MainQuantity::SeatPercent);
    row("filling the ground", BrushKind::Create, AllInCircle, false, MainQuantity::Density);
    row("dots on the ground", BrushKind::Create, Point, false, MainQuantity::Distance);
    row("spraying them away", BrushKind::Delete, Spray, true, MainQuantity::Rate);
    row("deleting an area", BrushKind::Delete, AllInCircle, true, MainQuantity::DeletePercent);
    row("turning along the stroke", BrushKind::Orientation, Spray, true, MainQuantity::Turn);
}

void tst_BrushStroke::mainNumberIsOneThatTheStrokeUses()
{
    QFETCH(int, kind);
    QFETCH(int, selection);
    QFETCH(bool, seats);
    QFETCH(int, quantity);
    BrushSettings settings =
        brush(static_cast<BrushKind>(kind), static_cast<BrushSelection>(selection));
    settings.create.seats.isOn = seats;
    QCOMPARE(static_cast<int>(settings.mainNumber().quantity), quantity);
}

void tst_BrushStroke::thinsOutByAShare()
{
    BrushScene scene;
    scene.addPeople(crowdGrid());
    BrushSettings settings = brush(BrushKind::Delete, BrushSelection::Rectangle);
    settings.removal.percent = 50.0F;
    const StrokeOutcome half = scene.paint(fromAbove(), settings, {{100, 50}, {1200, 700}});
    QVERIFY2(half.affected > 18 && half.affected < 42, qPrintable(QString::number(half.affected)));
    settings.selection = BrushSelection::AllInCircle;
    settings.radiusPixels = 1000.0F;
    settings.removal.percent = 100.0F;
    QCOMPARE(scene.paint(fromAbove(), settings, {{640, 384}}).affected, 60 - half.affected);
    settings.removal.percent = 0.0F;
    scene.addPeople({{0, 0, 0}});
    const StrokeOutcome nobody = scene.paint(fromAbove(), settings, {{640, 384}});
    QVERIFY(nobody.reason == StrokeReason::ShareTooSmall && !nobody.message.isEmpty());
}

void tst_BrushStroke::turnsAwayFromAPoint()
{
    BrushScene scene;
    const Ids ids = scene.addPeople({{0, 0, 0}});
    BrushSettings settings = brush(BrushKind::Orientation, BrushSelection::AllInCircle);
    settings.orientation.heading.mode = HeadingMode::TowardsPoint;
    settings.orientation.heading.towardsPoint = {5, 0, 0};
    constexpr float kQuarter = std::numbers::pi_v<float> / 2.0F;
    (void)scene.paint(fromAbove(), settings, {{640, 384}});
    QVERIFY(std::abs(headingOf(scene, ids[0]) - kQuarter) < 1.0e-5F);
    settings = settings.withMainNumber(180.0);
    (void)scene.paint(fromAbove(), settings, {{640, 384}});
    QVERIFY(std::abs(headingOf(scene, ids[0]) + kQuarter) < 1.0e-5F);
}

CROWD_TEST(tst_BrushStroke)
#include "tst_BrushStroke.moc"
