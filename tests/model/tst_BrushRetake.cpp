// SPDX-License-Identifier: MIT
#include <vector>

#include <QtTest/QTest>

#include "tests/model/BrushScene.h"
#include "tests/program/Test.h"

using namespace crowd::test;

namespace {

constexpr glm::dvec2 kCorner{200, 100};
constexpr glm::dvec2 kOppositeCorner{1100, 700};

/// Who was to do a take again, each time that it was asked for.
struct Wishes
{
    BrushContext of(BrushScene& scene, bool isFree = true)
    {
        BrushContext context = scene.context(fromAbove());
        context.retake = [this, isFree](const RetakeSettings& how,
                                        std::span<const IndividualId> ids) {
            settings = how;
            asked.emplace_back(ids.begin(), ids.end());
            return isFree;
        };
        return context;
    }

    RetakeSettings settings;
    std::vector<Ids> asked;
};

std::unique_ptr<Stroke> begin(BrushScene& scene, const BrushContext& context,
                              const BrushSettings& settings, glm::dvec2 at)
{
    return Stroke::begin(scene.document, context, settings, 7, PointerInput::at(at, 0.0));
}

} // namespace

/// The brush that lets people do a part of a take again.
class tst_BrushRetake : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aRectangleIsAskedForOnceInTheEnd();
    void dabsGatherWhomTheyReach();
    void onlyThoseWhomTheMaskMeans();
    void escapeAsksForNobody();
    void withoutATakeItIsSaid();
    void oneAtATime();
};

void tst_BrushRetake::aRectangleIsAskedForOnceInTheEnd()
{
    BrushScene scene;
    const Ids ids = scene.addPeople(crowdGrid());
    const int steps = scene.document.undoStack().count();
    Wishes wishes;
    BrushSettings settings = brush(BrushKind::Retake, BrushSelection::Rectangle);
    settings.as<RetakeSettings>() = {RetakeStretch::ForSeconds, 3.0F, false};
    const auto stroke = begin(scene, wishes.of(scene), settings, kCorner);
    stroke->move(PointerInput::at(kOppositeCorner, 0.1));
    QCOMPARE(stroke->gathered().size(), ids.size());
    stroke->move(PointerInput::at({700, 700}, 0.2)); // a smaller one
    const Ids some(stroke->gathered().begin(), stroke->gathered().end());
    QVERIFY(some.size() < ids.size() && !some.empty());
    QVERIFY(wishes.asked.empty());
    const StrokeOutcome outcome = stroke->finish();
    QVERIFY(outcome.isSent && !outcome.isCommitted);
    QCOMPARE(outcome.affected, static_cast<int>(some.size()));
    QCOMPARE(wishes.asked, std::vector<Ids>{some});
    QVERIFY((wishes.settings == RetakeSettings{RetakeStretch::ForSeconds, 3.0F, false}));
    QCOMPARE(scene.document.undoStack().count(), steps); // of the document nothing is changed
}

void tst_BrushRetake::dabsGatherWhomTheyReach()
{
    BrushScene scene;
    const Ids ids = scene.addPeople({{-3.0F, 0.0F, 0.0F}, {0.0F, 0.0F, 0.0F}, {3.0F, 0.0F, 0.0F}});
    Wishes wishes;
    const BrushSettings settings = brush(BrushKind::Retake, BrushSelection::AllInCircle);
    const auto pixel = [](float x) { return pixelOf(fromAbove(), {x, 1.0F, 0.0F}); };
    const auto stroke = begin(scene, wishes.of(scene), settings, pixel(3.0F));
    QCOMPARE(stroke->affected(), 1);
    stroke->move(PointerInput::at(pixel(1.5F), 0.1));
    stroke->move(PointerInput::at(pixel(0.0F), 0.2));
    stroke->move(PointerInput::at(pixel(3.0F), 0.3)); // once more: he is meant already
    QCOMPARE(stroke->finish().affected, 2);
    QCOMPARE(wishes.asked, (std::vector<Ids>{{ids[1], ids[2]}}));
}

void tst_BrushRetake::onlyThoseWhomTheMaskMeans()
{
    BrushScene scene;
    const Ids ids = scene.addPeople({{-3.0F, 0.0F, 0.0F}, {0.0F, 0.0F, 0.0F}});
    Wishes wishes;
    BrushSettings settings = brush(BrushKind::Retake, BrushSelection::Rectangle);
    settings.mask.onlySelected = true;
    settings.mask.selected = {static_cast<int>(ids[1])};
    const auto stroke = begin(scene, wishes.of(scene), settings, kCorner);
    stroke->move(PointerInput::at(kOppositeCorner, 0.1));
    (void)stroke->finish();
    QCOMPARE(wishes.asked, (std::vector<Ids>{{ids[1]}}));
}

void tst_BrushRetake::escapeAsksForNobody()
{
    BrushScene scene;
    scene.addPeople(crowdGrid());
    Wishes wishes;
    const BrushSettings settings = brush(BrushKind::Retake, BrushSelection::Rectangle);
    const auto stroke = begin(scene, wishes.of(scene), settings, kCorner);
    stroke->move(PointerInput::at(kOppositeCorner, 0.1));
    stroke->cancel();
    (void)stroke->finish();
    QVERIFY(wishes.asked.empty());
}

void tst_BrushRetake::withoutATakeItIsSaid()
{
    BrushScene scene;
    scene.addPeople(crowdGrid());
    for (const BrushSelection selection :
         {BrushSelection::Rectangle, BrushSelection::AllInCircle}) {
        const StrokeOutcome outcome = scene.paint(fromAbove(), brush(BrushKind::Retake, selection),
                                                  {kCorner, kOppositeCorner});
        QVERIFY(!outcome.isSent && !outcome.isCommitted);
        QCOMPARE(outcome.reason, StrokeReason::NoTake);
        QVERIFY(!outcome.message.isEmpty());
    }
}

void tst_BrushRetake::oneAtATime()
{
    BrushScene scene;
    scene.addPeople(crowdGrid());
    Wishes wishes;
    const BrushSettings settings = brush(BrushKind::Retake, BrushSelection::Rectangle);
    const auto stroke = begin(scene, wishes.of(scene, false), settings, kCorner);
    stroke->move(PointerInput::at(kOppositeCorner, 0.1));
    const StrokeOutcome outcome = stroke->finish();
    QCOMPARE(outcome.reason, StrokeReason::TakeBusy);
    QCOMPARE(outcome.affected, 0);
    QVERIFY(!outcome.isSent && !outcome.message.isEmpty());
}

CROWD_TEST(tst_BrushRetake)
#include "tst_BrushRetake.moc"
