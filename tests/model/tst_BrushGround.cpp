// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <QtTest/QTest>

#include "model/document/GroundEdits.h"
#include "tests/model/BrushScene.h"
#include "tests/program/Test.h"

using namespace crowd;
using namespace crowd::model;
using namespace crowd::test;

namespace {

/// The half plane x >= 0 on the ground.
class HalfGround : public WalkableGround
{
public:
    [[nodiscard]] bool isWalkable(const glm::vec3& point) const override
    {
        return point.x >= 0.0F && std::fabs(point.y) < 0.1F;
    }
    [[nodiscard]] std::optional<glm::vec3> nearest(const glm::vec3& point) const override
    {
        return glm::vec3(std::max(point.x, 0.0F), 0.0F, point.z);
    }
};

BrushSettings walkableBrush(BrushSelection selection)
{
    BrushSettings settings = brush(BrushKind::Create, selection);
    settings.as<CreateSettings>().anywhere = false;
    settings.as<CreateSettings>().minimalDistance = 0.3F;
    settings.as<CreateSettings>().density = 2.0F;
    return settings;
}

struct GroundScene : BrushScene
{
    using BrushScene::BrushScene;

    [[nodiscard]] BrushContext onGround(const View& view)
    {
        BrushContext made = context(view);
        made.ground = [this]() -> WalkableGroundPtr {
            ++asked;
            return std::make_shared<const HalfGround>();
        };
        return made;
    }
    StrokeOutcome paintOnGround(const BrushSettings& settings, const glm::dvec2& from,
                                const glm::dvec2& to)
    {
        const auto stroke = Stroke::begin(document, onGround(fromAbove()), settings, 7,
                                          PointerInput::at(from, 0.0));
        stroke->move(PointerInput::at(to, 0.5));
        return stroke->finish();
    }
    [[nodiscard]] float leastX() const
    {
        float least = 1e9F;
        for (const glm::vec3& at : people().column(columns::position)) {
            least = std::min(least, at.x);
        }
        return least;
    }

    int asked = 0;
};

const glm::dvec2 kLeft(200.0, 200.0);
const glm::dvec2 kRight(1080.0, 560.0);

} // namespace

class TestBrushGround : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void peopleComeOnlyWhereTheyCanWalk_data();
    void peopleComeOnlyWhereTheyCanWalk();
    void whyNobodyComesIsSaid();
    void anywhereIsAsBefore();
    void onSeatsNobodyAsks();
    void aReplayIsTheSame();
    void whoStandsWrongIsPutOnTheGround();
};

void TestBrushGround::peopleComeOnlyWhereTheyCanWalk_data()
{
    QTest::addColumn<int>("selection");
    QTest::newRow("points") << static_cast<int>(BrushSelection::Point);
    QTest::newRow("spray") << static_cast<int>(BrushSelection::Spray);
    QTest::newRow("circle") << static_cast<int>(BrushSelection::AllInCircle);
    QTest::newRow("rectangle") << static_cast<int>(BrushSelection::Rectangle);
}

void TestBrushGround::peopleComeOnlyWhereTheyCanWalk()
{
    QFETCH(const int, selection);
    GroundScene scene;
    const auto outcome =
        scene.paintOnGround(walkableBrush(static_cast<BrushSelection>(selection)), kLeft, kRight);
    QVERIFY(outcome.isCommitted);
    QVERIFY(outcome.affected > 0);
    QVERIFY(scene.leastX() >= 0.0F);
    QCOMPARE(scene.asked, 1);
}

void TestBrushGround::whyNobodyComesIsSaid()
{
    GroundScene scene;
    const auto outcome =
        scene.paintOnGround(walkableBrush(BrushSelection::Rectangle), kLeft, {500.0, 500.0});
    QVERIFY(!outcome.isCommitted);
    QCOMPARE(outcome.reason, StrokeReason::NotWalkable);
    QVERIFY(outcome.message.contains(QStringLiteral("Anywhere")));
    const auto point =
        scene.paintOnGround(walkableBrush(BrushSelection::Point), kLeft, {210.0, 200.0});
    QCOMPARE(point.reason, StrokeReason::NotWalkable);
}

void TestBrushGround::anywhereIsAsBefore()
{
    GroundScene scene;
    BrushSettings settings = walkableBrush(BrushSelection::Rectangle);
    settings.as<CreateSettings>().anywhere =
        CreateSettings().anywhere; // what strokes say that say nothing
    QVERIFY(scene.paintOnGround(settings, kLeft, kRight).isCommitted);
    QVERIFY(scene.leastX() < -1.0F);
    QCOMPARE(scene.asked, 0);
}

void TestBrushGround::onSeatsNobodyAsks()
{
    GroundScene scene({stageOf({}, seatRows(2, 6))});
    QVERIFY(
        scene.paintOnGround(walkableBrush(BrushSelection::Rectangle), kLeft, kRight).isCommitted);
    QVERIFY(scene.leastX() < 0.0F);
    QCOMPARE(scene.asked, 0);
}

void TestBrushGround::aReplayIsTheSame()
{
    GroundScene painted;
    (void)painted.paintOnGround(walkableBrush(BrushSelection::Spray), kLeft, kRight);
    QVERIFY(!painted.recorded.settings.as<CreateSettings>().anywhere);
    GroundScene replayed;
    const auto outcome =
        replay(replayed.document, replayed.keyframes, replayed.rays, painted.recorded,
               [] { return std::make_shared<const HalfGround>(); });
    QVERIFY(outcome.isCommitted);
    const auto before = painted.people().column(columns::position);
    const auto after = replayed.people().column(columns::position);
    QVERIFY(std::ranges::equal(before, after));
}

void TestBrushGround::whoStandsWrongIsPutOnTheGround()
{
    BrushScene scene;
    const auto ids = scene.addPeople({{-3.0F, 2.0F, 1.0F},
                                      {4.0F, 0.0F, 1.0F},
                                      {-2.0F, 0.0F, 1.0F},
                                      {5.0F, 5.5F, 2.0F},
                                      {0.0F, 0.0F, 1.2F}});
    const HalfGround ground;
    const std::vector<IndividualId> off = offGround(scene.document.scene(), ground, ids);
    QCOMPARE(off.size(), std::size_t{3});
    QCOMPARE(off[0], ids[0]);
    QCOMPARE(off[1], ids[2]);
    QCOMPARE(off[2], ids[3]);
    const std::vector<glm::vec3> before(scene.people().column(columns::position).begin(),
                                        scene.people().column(columns::position).end());
    const auto edit = scene.document.beginEdit().value();
    QCOMPARE(putOnGround(*edit, ground, ids), 3);
    QVERIFY(edit->commit(QStringLiteral("Put")));
    const auto after = scene.people().column(columns::position);
    for (std::size_t i = 0; i < after.size(); ++i) {
        QVERIFY(ground.isWalkable(after[i]));
        for (std::size_t other = 0; other < i; ++other) {
            QVERIFY(glm::distance(after[i], after[other]) > 0.45F);
        }
    }
    QCOMPARE(after[1], before[1]);
    QCOMPARE(after[3], glm::vec3(5.0F, 0.0F, 2.0F));
    scene.document.undoStack().undo();
    QVERIFY(std::ranges::equal(scene.people().column(columns::position), before));
}

CROWD_TEST(TestBrushGround)
#include "tst_BrushGround.moc"
