// SPDX-License-Identifier: MIT
#include <cmath>
#include <map>
#include <memory>
#include <set>

#include <QtTest/QTest>

#include "model/brush/ClipChoice.h"
#include "model/brush/MoveDrag.h"
#include "model/brush/Stroke.h"
#include "tests/model/BrushScene.h"
#include "tests/program/Test.h"

using namespace crowd::test;

namespace {

const std::vector<glm::dvec2> kEverything{{1.0, 1.0}, {1279.0, 767.0}};

/// A plate from (-2, 0) to (2, rise) over 4 m in X.
StageEntry ramp(float rise)
{
    return stageOf({plate({glm::vec3(-2, 0, -2), glm::vec3(-2, 0, 2), glm::vec3(2, rise, 2),
                           glm::vec3(2, rise, -2)})});
}

float nearestPair(const Population& people)
{
    float nearest = 1.0e9F;
    const auto positions = people.column(columns::position);
    for (std::size_t a = 0; a < positions.size(); ++a) {
        for (std::size_t b = 0; b < a; ++b) {
            nearest = std::min(nearest, glm::distance(positions[a], positions[b]));
        }
    }
    return nearest;
}

BrushSettings creator(BrushSelection selection)
{
    return brush(BrushKind::Create, selection);
}

std::set<SeatId> seatsOf(const Population& people)
{
    const auto seats = people.column(columns::seat);
    return {seats.begin(), seats.end()};
}

} // namespace

class tst_BrushCreate : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void createsOnTheGround();
    void landsOnTheStage();
    void refusesSteepSlopes();
    void keepsOutOfForbiddenGround();
    void keepsTheMinimalDistance();
    void wideBodiesTakeMoreRoom();
    void whoFitsComesWhereOthersDoNot();
    void insectsAreInNobodysWay();
    void looksThroughPeople();
    void variesWithinTheRanges();
    void dressesEachInAnOutfit();
    void facesVaryApartFromOutfits();
    void mixesTemplatesByWeight();
    void takesSeatsOnceAndSitsThemDown();
    void anAreaTakesTheSeatsThatAreMarkedInIt();
    void leavesTheColoursOfTheBodyAlone_data();
    void leavesTheColoursOfTheBodyAlone();
    void leavesTheColoursOfForeignModelsAlone();
    void keepsToRanksAndWedges();
    void fillsAShareOfTheSeats();
    void dotsAlongSeatsLeaveTheirShareFree();
    void spraysIntoTheCircle();
    void doesNotSeatBehindTheStage();
    void fillsByDensity();
    void ghostIsWhatAPressCreates();
    void saysWhyNobodyCame();
    void aClickThatMovesPlantsOne();
    void dragsOnTheGround();
    void dragsToAFreeSeat();
    void whoIsDraggedOntoAnotherChangesPlaces();
    void severalDraggedAlongARowChangePlaces();
    void audiencesSitInSeveralWays();
    void aDragCanBeCancelled();
};

void tst_BrushCreate::createsOnTheGround()
{
    BrushScene scene;
    const View view = fromAbove();
    const auto outcome =
        scene.paint(view, creator(BrushSelection::Point), {pixelOf(view, {1, 0, 2})});
    QCOMPARE(outcome.affected, 1);
    QVERIFY(glm::distance(scene.people().column(columns::position)[0], {1, 0, 2}) < 0.01F);
    QCOMPARE(scene.people().column(columns::templateId)[0], TemplateId{1});
    QCOMPARE(scene.people().column(columns::clip)[0], std::uint16_t{0});
    QCOMPARE(scene.people().column(columns::seat)[0], kNoSeat);
}

void tst_BrushCreate::landsOnTheStage()
{
    BrushScene scene({ramp(2.0F)});
    const View view = fromAbove();
    scene.paint(view, creator(BrushSelection::Point), {pixelOf(view, {1, 1.5F, 0.5F})});
    QVERIFY(glm::distance(scene.people().column(columns::position)[0], {1, 1.5F, 0.5F}) < 0.01F);
}

void tst_BrushCreate::refusesSteepSlopes()
{
    // 4 m in 4 m is 45°; 5 m is 51.3°.
    BrushScene gentle({ramp(4.0F)});
    BrushScene steep({ramp(5.0F)});
    const View view = fromAbove();
    const std::vector<glm::dvec2> middle{pixelOf(view, {0, 0, 0})};
    QVERIFY(gentle.paint(view, creator(BrushSelection::Point), middle).isCommitted);
    const auto refused = steep.paint(view, creator(BrushSelection::Point), middle);
    QVERIFY(!refused.isCommitted);
    QCOMPARE(refused.reason, StrokeReason::TooSteep);
    BrushSettings filling = creator(BrushSelection::Rectangle);
    filling.as<CreateSettings>().density = 4.0F;
    QCOMPARE(
        steep.paint(view, filling, {pixelOf(view, {-1, 0, -1}), pixelOf(view, {1, 0, 1})}).reason,
        StrokeReason::TooSteep);
}

void tst_BrushCreate::keepsOutOfForbiddenGround()
{
    const View view = fromAbove();
    BrushSettings walkers = creator(BrushSelection::Point);
    walkers.as<CreateSettings>().anywhere = false;
    for (const PlaceRole role : {PlaceRole::Forbidden, PlaceRole::Obstacle, PlaceRole::Spot}) {
        BrushScene scene;
        scene.document.edit(QStringLiteral("Place"), [role](SceneEdit& edit) {
            Place place;
            place.position = {1.0F, 0.0F, 2.0F};
            place.radius = 1.5F;
            place.role = role;
            (void)edit.addPlace(place);
        });
        const auto inside = scene.paint(view, walkers, {pixelOf(view, {1, 0, 3})});
        QCOMPARE(inside.isCommitted, role == PlaceRole::Spot);
        if (!inside.isCommitted) {
            QCOMPARE(inside.reason, StrokeReason::ForbiddenGround);
        }
        QVERIFY(scene.paint(view, walkers, {pixelOf(view, {1, 0, 4})}).isCommitted);
        BrushSettings anywhere = creator(BrushSelection::Point);
        QVERIFY(scene.paint(view, anywhere, {pixelOf(view, {0.5F, 0, 1.5F})}).isCommitted);
    }
}

void tst_BrushCreate::keepsTheMinimalDistance()
{
    BrushScene scene;
    scene.addPeople({{0, 0, 0}});
    BrushSettings settings = creator(BrushSelection::Spray);
    settings.ratePerSecond = 400.0F;
    settings.radiusPixels = 120.0F;
    settings.as<CreateSettings>().minimalDistance = 0.5F;
    const glm::dvec2 at = pixelOf(fromAbove(), {0, 0, 0});
    QVERIFY(scene.paint(fromAbove(), settings, std::vector<glm::dvec2>(60, at)).affected > 15);
    QVERIFY(nearestPair(scene.people()) >= 0.4999F);
    settings.selection = BrushSelection::Rectangle;
    settings.as<CreateSettings>().density = 5.0F;
    QVERIFY(scene.paint(fromAbove(), settings, kEverything).affected > 100);
    QVERIFY(nearestPair(scene.people()) >= 0.4999F);
}

void tst_BrushCreate::wideBodiesTakeMoreRoom()
{
    // Long ones, among people and among each other, by spray and by area.
    auto horse = std::make_shared<Template>(*boxMan());
    horse->footprint = {0.4F, 0.8F, 0.8F};
    BrushScene scene;
    const auto edit = scene.document.beginEdit().value();
    edit->addTemplate(boxManEntry(2, horse));
    edit->commit(QStringLiteral("Add"));
    scene.addPeople({{0, 0, 0}, {3, 0, 0}, {-3, 0, 1}});
    BrushSettings settings = creator(BrushSelection::Spray);
    settings.as<CreateSettings>().mix = {{2, 1.0F}};
    settings.as<CreateSettings>().girth = {1.0F, 1.0F};
    settings.as<CreateSettings>().minimalDistance = 0.5F;
    settings.ratePerSecond = 400.0F;
    settings.radiusPixels = 200.0F;
    const glm::dvec2 at = pixelOf(fromAbove(), {0, 0, 0});
    QVERIFY(scene.paint(fromAbove(), settings, std::vector<glm::dvec2>(60, at)).affected > 2);
    settings.selection = BrushSelection::Rectangle;
    settings.as<CreateSettings>().density = 3.0F;
    QVERIFY(scene.paint(fromAbove(), settings, kEverything).affected > 2);
    settings.as<CreateSettings>().mix = {{1, 1.0F}};
    QVERIFY(scene.paint(fromAbove(), settings, kEverything).affected > 2);
    const auto positions = scene.people().column(columns::position);
    const auto headings = scene.people().column(columns::heading);
    const auto templates = scene.people().column(columns::templateId);
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const glm::vec3 way(std::sin(headings[i]), 0.0F, std::cos(headings[i]));
        for (std::size_t other = 0; other < positions.size(); ++other) {
            if (templates[i] != 2 || other == i) {
                continue;
            }
            const glm::vec3 from = positions[other] - positions[i];
            const float along = std::clamp(glm::dot(from, way), -0.8F, 0.8F);
            const float least = templates[other] == 2 ? 0.8F : 0.65F;
            QVERIFY(glm::length(from - along * way) > least - 0.05F);
        }
    }
}

/// A click makes somebody if anybody of the mix has room.
void tst_BrushCreate::whoFitsComesWhereOthersDoNot()
{
    auto bus = std::make_shared<Template>(*boxMan());
    bus->footprint = {1.5F, 6.0F, 6.0F};
    BrushScene scene;
    const auto edit = scene.document.beginEdit().value();
    edit->addTemplate(boxManEntry(2, bus));
    edit->commit(QStringLiteral("Add"));
    scene.addPeople({{0, 0, 0}});
    BrushSettings settings = creator(BrushSelection::Point);
    settings.as<CreateSettings>().mix = {{1, 1.0F}, {2, 1.0F}};
    settings.as<CreateSettings>().minimalDistance = 0.5F;
    constexpr int kClicks = 12;
    for (int i = 0; i < kClicks; ++i) {
        const float around = 0.5F * static_cast<float>(i);
        const glm::vec3 place(1.5F * std::sin(around), 0.0F, 1.5F * std::cos(around));
        const std::vector<glm::dvec2> click{pixelOf(fromAbove(), place)};
        QCOMPARE(scene.paint(fromAbove(), settings, click, static_cast<std::uint64_t>(i)).affected,
                 1);
    }
    const auto templates = scene.people().column(columns::templateId);
    QVERIFY(std::ranges::count(templates, TemplateId{2}) == 0);
    // Where nobody is, both come; the room is asked of the one who does.
    settings.as<CreateSettings>().mix = {{2, 1.0F}};
    const std::vector<glm::dvec2> click{pixelOf(fromAbove(), {2.0F, 0.0F, 0.0F})};
    const auto refused = scene.paint(fromAbove(), settings, click);
    QCOMPARE(refused.affected, 0);
    QCOMPARE(refused.reason, StrokeReason::TooNearToOthers);
}

void tst_BrushCreate::insectsAreInNobodysWay()
{
    for (const bool isInsect : {true, false}) {
        auto small = std::make_shared<Template>(*boxMan());
        small->footprint = {isInsect ? 0.02F : 0.2F, 0.0F, 0.0F};
        BrushScene scene;
        const auto edit = scene.document.beginEdit().value();
        edit->addTemplate(boxManEntry(2, small));
        edit->commit(QStringLiteral("Add"));
        BrushSettings settings = creator(BrushSelection::Point);
        settings.as<CreateSettings>().minimalDistance = 0.5F;
        settings.as<CreateSettings>().mix = {{2, 1.0F}};
        const std::vector<glm::dvec2> click{pixelOf(fromAbove(), {1.0F, 0.0F, 0.0F})};
        QCOMPARE(scene.paint(fromAbove(), settings, click).affected, 1);
        settings.as<CreateSettings>().mix = {{1, 1.0F}};
        QCOMPARE(scene.paint(fromAbove(), settings, click).affected, isInsect ? 1 : 0);
    }
}

void tst_BrushCreate::looksThroughPeople()
{
    BrushScene scene;
    scene.addPeople({{0, 0, 2}});
    // The pixel lies on the man's chest; behind it is the ground.
    const View low(Camera::lookingAt({0.0F, 3.0F, 10.0F}, {0.0F, 0.5F, 0.0F}), {1280.0F, 768.0F});
    const glm::dvec2 pixel = pixelOf(low, {0, 0.9F, 2.15F});
    QVERIFY(scene.paint(low, creator(BrushSelection::Point), {pixel}).isCommitted);
    QCOMPARE(scene.people().column(columns::position)[1].y, 0.0F);
    QVERIFY(scene.people().column(columns::position)[1].z < 1.0F);
}

void tst_BrushCreate::variesWithinTheRanges()
{
    BrushScene scene;
    BrushSettings settings = creator(BrushSelection::Rectangle);
    settings.as<CreateSettings>().height = {0.8F, 1.2F};
    settings.as<CreateSettings>().girth = {0.9F, 1.0F};
    settings.as<CreateSettings>().phase = {0.25F, 0.75F};
    settings.as<CreateSettings>().palette = {{10, 20, 30}, {40, 50, 60}};
    settings.as<CreateSettings>().paletteStrength = 1.0F;
    const int created = scene.paint(fromAbove(), settings, kEverything).affected;
    QVERIFY(created > 100);
    const Population& people = scene.people();
    std::set<float> heights;
    for (std::size_t row = 0; row < people.size(); ++row) {
        const float height = people.column(columns::height)[row];
        heights.insert(height);
        QVERIFY(height >= 0.8F && height <= 1.2F);
        QVERIFY(people.column(columns::girth)[row] >= 0.9F);
        QVERIFY(people.column(columns::girth)[row] <= 1.0F);
        QVERIFY(people.column(columns::phase)[row] >= 0.25F);
        QVERIFY(people.column(columns::phase)[row] <= 0.75F);
        QCOMPARE(people.column(columns::tint(0))[row], Tint{});
        const Tint top = people.column(columns::tint(1))[row];
        QVERIFY(top == (Tint{10, 20, 30, 255}) || top == (Tint{40, 50, 60, 255}));
    }
    QVERIFY(static_cast<int>(heights.size()) > created - 5);
}

void tst_BrushCreate::dressesEachInAnOutfit()
{
    BrushScene scene;
    auto man = std::make_shared<Template>(*boxMan());
    man->slots[1].choices.resize(3);
    man->parts = {{"hat", true}, {"sword", false}};
    const auto edit = scene.document.beginEdit().value();
    edit->changeTemplate(boxManEntry(1, man));
    edit->commit(QStringLiteral("Change"));
    BrushSettings settings = creator(BrushSelection::Rectangle);
    QVERIFY(scene.paint(fromAbove(), settings, kEverything).affected > 100);
    const auto countOf = [&](std::uint8_t choice) {
        const auto all = scene.people().column(columns::materialChoices);
        return std::ranges::count_if(all, [&](const auto& worn) { return worn[1] == choice; });
    };
    const auto third = static_cast<double>(scene.people().size()) / 3.0;
    for (std::uint8_t choice = 0; choice < 3; ++choice) {
        QVERIFY(std::abs(static_cast<double>(countOf(choice)) - third) < third * 0.5);
    }
    for (const auto& worn : scene.people().column(columns::materialChoices)) {
        QVERIFY2(worn[0] == 0, "one material is no choice");
    }
    for (const std::uint32_t parts : scene.people().column(columns::parts)) {
        QVERIFY2((parts & 3U) == 1U, "parts as the template has them");
    }
    scene.document.undoStack().undo();
    settings.as<CreateSettings>().variesOutfit = false;
    settings.as<CreateSettings>().variesParts = true;
    QVERIFY(scene.paint(fromAbove(), settings, kEverything).affected > 100);
    QCOMPARE(countOf(0), std::ssize(scene.people().ids()));
    std::set<std::uint32_t> worn;
    for (const std::uint32_t parts : scene.people().column(columns::parts)) {
        worn.insert(parts & 3U);
    }
    QVERIFY2(worn.size() == 4, "each part by itself");
}

void tst_BrushCreate::facesVaryApartFromOutfits()
{
    const auto worn = [](bool outfits, std::optional<bool> faces) {
        BrushScene scene;
        auto man = std::make_shared<Template>(*boxMan());
        man->slots[0].choices.resize(3); // skin
        man->slots[1].choices.resize(3); // top
        const auto edit = scene.document.beginEdit().value();
        edit->changeTemplate(boxManEntry(1, man));
        edit->commit(QStringLiteral("Change"));
        BrushSettings settings = creator(BrushSelection::Rectangle);
        settings.as<CreateSettings>().variesOutfit = outfits;
        settings.as<CreateSettings>().variesFaces = faces;
        (void)scene.paint(fromAbove(), settings, kEverything);
        const auto all = scene.people().column(columns::materialChoices);
        return std::vector<MaterialChoices>(all.begin(), all.end());
    };
    const auto kinds = [](const std::vector<MaterialChoices>& all, std::size_t slot) {
        std::set<int> found;
        for (const MaterialChoices& each : all) {
            found.insert(each[slot]);
        }
        return found.size();
    };
    const auto facesOnly = worn(false, true);
    QVERIFY(facesOnly.size() > 100);
    QCOMPARE(kinds(facesOnly, 0), std::size_t{3});
    QCOMPARE(kinds(facesOnly, 1), std::size_t{1});
    const auto clothesOnly = worn(true, false);
    QCOMPARE(kinds(clothesOnly, 0), std::size_t{1});
    QCOMPARE(kinds(clothesOnly, 1), std::size_t{3});
    // As strokes were recorded before there was a switch for it.
    QCOMPARE(worn(true, std::nullopt), worn(true, true));
    QCOMPARE(worn(false, std::nullopt), worn(false, false));
}

void tst_BrushCreate::mixesTemplatesByWeight()
{
    BrushScene scene;
    const auto edit = scene.document.beginEdit().value();
    edit->addTemplate(boxManEntry(2, boxMan()));
    edit->commit(QStringLiteral("Add"));
    BrushSettings settings = creator(BrushSelection::Rectangle);
    settings.as<CreateSettings>().mix = {{1, 1.0F}, {2, 3.0F}};
    settings.as<CreateSettings>().density = 2.0F;
    settings.as<CreateSettings>().minimalDistance = 0.1F;
    const int created = scene.paint(fromAbove(), settings, kEverything).affected;
    const auto templates = scene.people().column(columns::templateId);
    const double share =
        static_cast<double>(std::ranges::count(templates, TemplateId{2})) / created;
    QVERIFY2(share > 0.68 && share < 0.82, qPrintable(QString::number(share)));
}

void tst_BrushCreate::takesSeatsOnceAndSitsThemDown()
{
    BrushScene scene({stageOf({}, seatRows(4, 8))});
    const auto first = scene.paint(fromAbove(), creator(BrushSelection::Rectangle), kEverything);
    QCOMPARE(first.affected, 32);
    QCOMPARE(seatsOf(scene.people()).size(), std::size_t{32});
    const std::vector<WorldSeat> seats = scene.document.scene().worldSeats();
    for (std::size_t row = 0; row < seats.size(); ++row) {
        QCOMPARE(scene.people().column(columns::seat)[row], seats[row].id);
        QCOMPARE(scene.people().column(columns::position)[row], seats[row].seat.position);
        QCOMPARE(scene.people().column(columns::heading)[row], 0.25F);
        QCOMPARE(scene.people().column(columns::clip)[row], std::uint16_t{1});
    }
    const auto again = scene.paint(fromAbove(), creator(BrushSelection::Rectangle), kEverything);
    QVERIFY(!again.isCommitted);
    QCOMPARE(again.reason, StrokeReason::NoFreeSeat);
    BrushSettings removing = brush(BrushKind::Delete, BrushSelection::Point);
    const View view = fromAbove();
    scene.paint(view, removing, {pixelOf(view, seats[5].seat.position)});
    QCOMPARE(scene.people().size(), std::size_t{31});
    scene.paint(view, creator(BrushSelection::Point), {pixelOf(view, seats[5].seat.position)});
    QCOMPARE(seatsOf(scene.people()).size(), std::size_t{32});
}

void tst_BrushCreate::anAreaTakesTheSeatsThatAreMarkedInIt()
{
    // From low in front the foot of a seat lies far below its plane, where it is marked.
    BrushScene scene({stageOf({}, seatRows(1, 8))});
    const View low(Camera::lookingAt({0.0F, 1.5F, 8.0F}, {0.0F, 0.5F, 0.0F}), {1280.0F, 768.0F});
    const glm::dvec2 foot = pixelOf(low, {0.0F, 0.0F, 0.0F});
    const glm::dvec2 mark = pixelOf(low, {0.0F, 0.4F, 0.0F});
    const double between = 0.5 * (foot.y + mark.y);
    const BrushSettings settings = creator(BrushSelection::Rectangle);
    const auto feet = scene.paint(low, settings, {{1.0, between}, {1279.0, foot.y + 40.0}});
    QVERIFY2(!feet.isCommitted, "only feet are inside");
    QCOMPARE(scene.paint(low, settings, {{1.0, mark.y - 40.0}, {1279.0, between}}).affected, 8);
}

void tst_BrushCreate::leavesTheColoursOfTheBodyAlone_data()
{
    QTest::addColumn<QString>("slot");
    QTest::addColumn<bool>("isTinted");
    QTest::newRow("cloth") << "top" << true;
    QTest::newRow("hair") << "hair" << false;
    QTest::newRow("hair among other words") << "Long_Hair.001" << false;
    QTest::newRow("fur") << "fur" << false;
    QTest::newRow("a chair is no hair") << "chair" << true;
    QTest::newRow("furniture is no fur") << "furniture" << true;
}

void tst_BrushCreate::leavesTheColoursOfTheBodyAlone()
{
    QFETCH(QString, slot);
    QFETCH(bool, isTinted);
    BrushScene scene;
    auto man = std::make_shared<Template>(*boxMan());
    man->slots[1].name = slot.toStdString();
    const auto edit = scene.document.beginEdit().value();
    edit->changeTemplate(boxManEntry(1, man));
    edit->commit(QStringLiteral("Change"));
    BrushSettings settings = creator(BrushSelection::Point);
    settings.as<CreateSettings>().palette = {{10, 20, 30}};
    QVERIFY(scene.paint(fromAbove(), settings, {{640.0, 384.0}}).isCommitted);
    QCOMPARE(scene.people().column(columns::tint(1))[0],
             isTinted ? (Tint{10, 20, 30, 255}) : Tint{});
}

/// Whatever its slots are called; asked for, they still take a tint.
void tst_BrushCreate::leavesTheColoursOfForeignModelsAlone()
{
    BrushScene scene;
    auto horse = std::make_shared<Template>(*boxMan());
    for (Slot& slot : horse->slots) {
        slot.tintable = true;
        slot.takesPalette = false;
    }
    const auto edit = scene.document.beginEdit().value();
    edit->changeTemplate(boxManEntry(1, horse));
    edit->commit(QStringLiteral("Change"));
    BrushSettings settings = creator(BrushSelection::Point);
    settings.as<CreateSettings>().palette = {{10, 20, 30}};
    QVERIFY(scene.paint(fromAbove(), settings, {{640.0, 384.0}}).isCommitted);
    for (int slot = 0; slot < 3; ++slot) {
        QCOMPARE(scene.people().column(columns::tint(slot))[0], Tint{});
    }
    BrushSettings colour;
    colour.setKind(BrushKind::Colour);
    colour.selection = BrushSelection::Rectangle;
    colour.as<ColourSettings>().colors = {{40, 50, 60}};
    QVERIFY(scene.paint(fromAbove(), colour, kEverything).isCommitted);
    QCOMPARE(scene.people().column(columns::tint(1))[0], (Tint{40, 50, 60, 255}));
}

void tst_BrushCreate::keepsToRanksAndWedges()
{
    BrushScene scene({stageOf({}, seatRows(4, 8))});
    BrushSettings settings = creator(BrushSelection::Rectangle);
    settings.as<CreateSettings>().seats.ranks = {1, 3};
    settings.as<CreateSettings>().seats.wedges = {1};
    QCOMPARE(scene.paint(fromAbove(), settings, kEverything).affected, 8);
    for (const WorldSeat& seat : scene.document.scene().worldSeats()) {
        const bool isMeant = seat.seat.rank % 2 == 1 && seat.seat.wedge == 1;
        QCOMPARE(seatsOf(scene.people()).contains(seat.id), isMeant);
    }
    const auto again = scene.paint(fromAbove(), settings, kEverything);
    QVERIFY2(again.reason == StrokeReason::NoChosenSeat, "others are still free");
}

void tst_BrushCreate::fillsAShareOfTheSeats()
{
    BrushScene scene({stageOf({}, seatRows(5, 8))});
    BrushSettings settings = creator(BrushSelection::Rectangle);
    settings.as<CreateSettings>().seatPercent = 35.0F;
    QCOMPARE(scene.paint(fromAbove(), settings, kEverything).affected, 14);
}

void tst_BrushCreate::dotsAlongSeatsLeaveTheirShareFree()
{
    BrushScene scene({stageOf({}, seatRows(1, 18))});
    BrushSettings settings = brush(BrushKind::Create, BrushSelection::Point);
    settings.as<CreateSettings>().seatPercent = 50.0F;
    const StrokeOutcome outcome = scene.paint(fromAbove(), settings, {{70, 384}, {1210, 384}});
    QVERIFY2(outcome.affected > 4 && outcome.affected < 15,
             qPrintable(QString::number(outcome.affected)));
    settings.as<CreateSettings>().seatPercent = 1.0F;
    scene.document.undoStack().undo();
    QCOMPARE(scene.paint(fromAbove(), settings, {{670, 384}}).affected, 1); // a click seats
    settings.as<CreateSettings>().seatPercent = 100.0F;
    QCOMPARE(scene.paint(fromAbove(), settings, {{70, 384}, {1210, 384}}).affected, 17);
}

void tst_BrushCreate::spraysIntoTheCircle()
{
    BrushScene scene({stageOf({}, seatRows(5, 9))});
    BrushSettings settings = creator(BrushSelection::Spray);
    settings.radiusPixels = 100.0F;
    settings.ratePerSecond = 60.0F;
    const View view = fromAbove();
    const glm::dvec2 at = pixelOf(view, {0, 0, -2});
    scene.paint(view, settings, std::vector<glm::dvec2>(40, at));
    // 100 pixels are 1.56 m: the nine seats around the middle.
    std::size_t inside = 0;
    for (const WorldSeat& seat : scene.document.scene().worldSeats()) {
        const bool isInside = glm::distance(pixelOf(view, seat.seat.position), at) <= 100.0;
        inside += isInside ? 1 : 0;
        QCOMPARE(seatsOf(scene.people()).contains(seat.id), isInside);
    }
    QCOMPARE(scene.people().size(), inside);
    QCOMPARE(inside, std::size_t{9});
}

void tst_BrushCreate::doesNotSeatBehindTheStage()
{
    // A roof over the left half of the seats.
    const StageEntry roofed = stageOf({plate({glm::vec3(-9, 5, -9), glm::vec3(-9, 5, 9),
                                              glm::vec3(0, 5, 9), glm::vec3(0, 5, -9)})},
                                      seatRows(4, 8));
    BrushScene scene({roofed});
    BrushSettings settings = creator(BrushSelection::Rectangle);
    QCOMPARE(scene.paint(fromAbove(), settings, kEverything).affected, 16);
    settings.through = true;
    QCOMPARE(scene.paint(fromAbove(), settings, kEverything).affected, 16);
}

void tst_BrushCreate::fillsByDensity()
{
    BrushScene scene;
    BrushSettings settings = creator(BrushSelection::Rectangle);
    settings.as<CreateSettings>().density = 2.0F;
    settings.as<CreateSettings>().minimalDistance = 0.3F;
    const View view = fromAbove();
    const int created =
        scene.paint(view, settings, {pixelOf(view, {-6, 0, -4}), pixelOf(view, {6, 0, 4})})
            .affected;
    QVERIFY2(std::abs(created - 2 * 12 * 8) <= 12, qPrintable(QString::number(created)));
    for (const glm::vec3& position : scene.people().column(columns::position)) {
        QVERIFY(std::abs(position.x) <= 6.01F && std::abs(position.z) <= 4.01F);
    }
}

void tst_BrushCreate::ghostIsWhatAPressCreates()
{
    for (const bool hasSeats : {false, true}) {
        std::vector<StageEntry> stages;
        if (hasSeats) {
            stages.push_back(stageOf({}, seatRows(4, 8)));
        }
        BrushScene scene(stages);
        const View view = fromAbove();
        for (const BrushSelection selection :
             {BrushSelection::Point, BrushSelection::Spray, BrushSelection::AllInCircle}) {
            BrushSettings settings = creator(selection);
            settings.radiusPixels = 100.0F;
            settings.as<CreateSettings>().palette = {{1, 2, 3}, {4, 5, 6}};
            const PointerInput press = PointerInput::at(pixelOf(view, {0.4F, 0.0F, -1.2F}), 3.0);
            IndividualRows ghosts =
                previewGhosts(scene.document, scene.context(view), settings, 99, press);
            QVERIFY(!ghosts.ids.empty());
            const auto stroke =
                Stroke::begin(scene.document, scene.context(view), settings, 99, press);
            IndividualRows created = scene.people().rows(scene.people().ids());
            created.ids = ghosts.ids;
            QVERIFY(created.bytes == ghosts.bytes);
            stroke->cancel();
        }
    }
}

void tst_BrushCreate::saysWhyNobodyCame()
{
    BrushScene scene;
    scene.addPeople({{0, 0, 0}});
    const View view = fromAbove();
    const std::vector<glm::dvec2> middle{pixelOf(view, {0, 0, 0})};
    BrushSettings settings = creator(BrushSelection::Point);
    QCOMPARE(scene.paint(view, settings, middle).reason, StrokeReason::TooNearToOthers);
    settings.as<CreateSettings>().mix = {};
    QCOMPARE(scene.paint(view, settings, {{900.0, 500.0}}).reason, StrokeReason::NoTemplateChosen);
    settings.as<CreateSettings>().mix = {{1, 1.0F}};
    const View sky(Camera::lookingAt({0, 2, 0}, {0, 5, 5}), {1280.0F, 768.0F});
    QCOMPARE(scene.paint(sky, settings, {{640.0, 100.0}}).reason, StrokeReason::NothingUnderBrush);
    QCOMPARE(scene.document.undoStack().count(), 1);
    scene.replaceMan(nullptr);
    QCOMPARE(scene.paint(view, settings, {{900.0, 500.0}}).reason, StrokeReason::TemplateNotLoaded);
    QCOMPARE(scene.document.undoStack().count(), 0);
}

/// Far away a body is a few pixels wide, and a click moves by as many.
void tst_BrushCreate::aClickThatMovesPlantsOne()
{
    const View far(Camera::lookingAt({0, 160, 0.1F}, {0, 0, 0}), {1280.0F, 768.0F});
    const glm::dvec2 press = pixelOf(far, {0, 0, 0});
    const auto planted = [&](double pixels) {
        BrushScene scene;
        scene.paint(far, creator(BrushSelection::Point), {press, press + glm::dvec2(pixels, 0.0)});
        return scene.people().size();
    };
    QCOMPARE(planted(0.0), std::size_t{1});
    QCOMPARE(planted(7.0), std::size_t{1});
    QVERIFY(planted(40.0) >= 3); // a drag goes on planting
}

void tst_BrushCreate::dragsOnTheGround()
{
    BrushScene scene;
    const Ids ids = scene.addPeople({{0, 0, 0}, {1, 0, 0}, {4, 0, 0}});
    const Population before = scene.people();
    const View view = fromAbove();
    const auto drag =
        MoveDrag::begin(scene.document, scene.context(view), std::array{ids[0], ids[1]}, false,
                        PointerInput::at(pixelOf(view, {0, 0, 0}), 0.0));
    drag->move(PointerInput::at(pixelOf(view, {9, 0, 9}), 0.1));
    drag->move(PointerInput::at(pixelOf(view, {0, 0, 3}), 0.2));
    QVERIFY(drag->finish().isCommitted);
    const auto positions = scene.people().column(columns::position);
    QVERIFY(glm::distance(positions[0], {0, 0, 3}) < 0.01F);
    QVERIFY(glm::distance(positions[1], {1, 0, 3}) < 0.01F);
    QCOMPARE(positions[2], (glm::vec3{4, 0, 0}));
    scene.document.undoStack().undo();
    QVERIFY(scene.people() == before);
}

void tst_BrushCreate::dragsToAFreeSeat()
{
    BrushScene scene({stageOf({}, seatRows(2, 8))});
    const View view = fromAbove();
    const std::vector<WorldSeat> seats = scene.document.scene().worldSeats();
    scene.paint(view, creator(BrushSelection::Point), {pixelOf(view, seats[2].seat.position)});
    const Ids ids(scene.people().ids().begin(), scene.people().ids().end());
    QCOMPARE(scene.people().column(columns::seat)[0], seats[2].id);
    const auto dragTo = [&](const glm::vec3& to, bool ontoSeats) {
        const glm::vec3 from = scene.people().column(columns::position)[0];
        const auto drag = MoveDrag::begin(scene.document, scene.context(view), ids, ontoSeats,
                                          PointerInput::at(pixelOf(view, from), 0.0));
        drag->move(PointerInput::at(pixelOf(view, to), 0.1));
        return drag->finish().isCommitted;
    };
    QVERIFY(dragTo(seats[5].seat.position + glm::vec3(0.2F, 0.0F, 0.1F), true));
    QCOMPARE(scene.people().column(columns::seat)[0], seats[5].id);
    QCOMPARE(scene.people().column(columns::position)[0], seats[5].seat.position);
    QVERIFY(dragTo({0.0F, 0.0F, 4.0F}, true));
    QCOMPARE(scene.people().column(columns::seat)[0], kNoSeat);
    QCOMPARE(scene.people().column(columns::clip)[0], std::uint16_t{0});
    QVERIFY(dragTo(seats[0].seat.position, true));
    QCOMPARE(scene.people().column(columns::clip)[0], std::uint16_t{1});
}

/// From a seat they swap seats; from the ground the other one stands up there.
void tst_BrushCreate::whoIsDraggedOntoAnotherChangesPlaces()
{
    BrushScene scene({stageOf({}, seatRows(2, 8))});
    const View view = fromAbove();
    const std::vector<WorldSeat> seats = scene.document.scene().worldSeats();
    for (const std::size_t seat : {std::size_t{2}, std::size_t{5}}) {
        scene.paint(view, creator(BrushSelection::Point),
                    {pixelOf(view, seats[seat].seat.position)});
    }
    const Ids ids(scene.people().ids().begin(), scene.people().ids().end());
    const auto dragFirst = [&](const glm::vec3& to) {
        const glm::vec3 from = scene.people().column(columns::position)[0];
        const auto drag = MoveDrag::begin(scene.document, scene.context(view), std::array{ids[0]},
                                          true, PointerInput::at(pixelOf(view, from), 0.0));
        drag->move(PointerInput::at(pixelOf(view, {0.0F, 0.0F, 3.0F}), 0.1));
        drag->move(PointerInput::at(pixelOf(view, to), 0.2));
        return drag->finish().isCommitted;
    };
    const auto seatOf = [&](std::size_t row) { return scene.people().column(columns::seat)[row]; };
    const Population before = scene.people();
    QVERIFY(dragFirst(seats[5].seat.position));
    QCOMPARE(seatOf(0), seats[5].id);
    QCOMPARE(seatOf(1), seats[2].id);
    QCOMPARE(scene.people().column(columns::position)[1], seats[2].seat.position);
    scene.document.undoStack().undo();
    QVERIFY(scene.people() == before);
    const glm::vec3 ground{0.0F, 0.0F, 4.0F};
    QVERIFY(dragFirst(ground));
    QVERIFY(dragFirst(seats[5].seat.position));
    QCOMPARE(seatOf(0), seats[5].id);
    QCOMPARE(seatOf(1), kNoSeat);
    QVERIFY(glm::distance(scene.people().column(columns::position)[1], ground) < 0.05F);
    QCOMPARE(scene.people().column(columns::clip)[1], std::uint16_t{0}); // he stands
}

/// Three beside each other by one seat, onto the fourth, who comes to where the first was.
void tst_BrushCreate::severalDraggedAlongARowChangePlaces()
{
    BrushScene scene({stageOf({}, seatRows(1, 4))});
    const View view = fromAbove();
    const std::vector<WorldSeat> seats = scene.document.scene().worldSeats();
    for (const WorldSeat& seat : seats) {
        scene.paint(view, creator(BrushSelection::Point), {pixelOf(view, seat.seat.position)});
    }
    const Ids ids(scene.people().ids().begin(), scene.people().ids().end());
    const std::vector<glm::vec3> at = {seats[0].seat.position, seats[1].seat.position};
    const auto drag =
        MoveDrag::begin(scene.document, scene.context(view), std::array{ids[0], ids[1], ids[2]},
                        true, PointerInput::at(pixelOf(view, at[0]), 0.0));
    drag->move(PointerInput::at(pixelOf(view, at[1]), 0.1));
    QVERIFY(drag->finish().isCommitted);
    const auto now = scene.people().column(columns::seat);
    QCOMPARE((std::vector<SeatId>{now.begin(), now.end()}),
             (std::vector<SeatId>{seats[1].id, seats[2].id, seats[3].id, seats[0].id}));
}

void tst_BrushCreate::audiencesSitInSeveralWays()
{
    TemplateEntry entry;
    auto asset = std::make_shared<Template>();
    for (const char* name : {"idle", "sit", "sit_clap", "sit_talk", "sit_2"}) {
        Clip clip;
        clip.name = name;
        clip.role = clip.name == "idle"       ? ClipRole::Idle
                    : clip.name == "sit_clap" ? ClipRole::Other
                                              : ClipRole::Sit;
        asset->clips.push_back(clip);
        entry.clipNames.push_back(clip.name);
    }
    asset->seatedClip = 1;
    entry.asset = asset;
    std::map<std::uint16_t, int> counts;
    for (int i = 0; i < 1000; ++i) {
        ++counts[seatedClip(entry, i / 1000.0)];
    }
    QCOMPARE(counts, (std::map<std::uint16_t, int>{{1, 500}, {3, 250}, {4, 250}}));
    QCOMPARE(seatedClip(entry, 1.0), std::uint16_t{4});
    QVERIFY(isRest(entry, 3, true) && !isRest(entry, 2, true) && !isRest(entry, 3, false));
    entry.clipNames = {"idle", "sit"};
    QCOMPARE(seatedClip(entry, 0.9), std::uint16_t{1});
}

void tst_BrushCreate::aDragCanBeCancelled()
{
    BrushScene scene;
    const Ids ids = scene.addPeople({{0, 0, 0}});
    const Population before = scene.people();
    const View view = fromAbove();
    const auto drag = MoveDrag::begin(scene.document, scene.context(view), ids, false,
                                      PointerInput::at(pixelOf(view, {0, 0, 0}), 0.0));
    drag->move(PointerInput::at(pixelOf(view, {2, 0, 2}), 0.1));
    QVERIFY(!(scene.people() == before));
    drag->cancel();
    QVERIFY(scene.people() == before);
    QVERIFY(!drag->finish().isCommitted);
    QCOMPARE(scene.document.undoStack().count(), 1);
}

CROWD_TEST(tst_BrushCreate)
#include "tst_BrushCreate.moc"
