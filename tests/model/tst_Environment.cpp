// SPDX-License-Identifier: MIT
#include <ctime>

#include <QtTest/QTest>

#include "model/document/PathEdits.h"
#include "model/document/SceneEdit.h"
#include "model/project/EnvironmentText.h"
#include "model/project/ProjectReader.h"
#include "tests/model/ProjectText.h"
#include "tests/program/Test.h"

using namespace crowd::model;
using crowd::testing::projectText;

namespace {

Place placeAt(float x, float z, const char* name = "door")
{
    Place place;
    place.name = name;
    place.position = {x, 0.0F, z};
    place.radius = 1.25F;
    place.color = {1, 2, 3};
    return place;
}

/// Three places, a path over them with a branch to another path, a rule and a tag.
void furnish(SceneDocument& document)
{
    auto edit = document.beginEdit().value();
    const PlaceId a = edit->addPlace(placeAt(0.0F, 0.0F, "gate"));
    const PlaceId b = edit->addPlace(placeAt(5.0F, 0.0F));
    const PlaceId c = edit->addPlace(placeAt(5.0F, 7.5F));
    Path side;
    side.name = "side";
    side.places = {c, a};
    const PathId sideId = edit->addPath(side);
    Path round;
    round.name = "round";
    round.kind = PathKind::Cyclic;
    round.places = {a, b, c, b};
    round.branches = {{b, sideId, 0.5F}};
    edit->addPath(round);
    Rule rule;
    rule.id = 4;
    rule.name = "applause";
    rule.trigger = triggers::Event{"clap"};
    rule.conditions = {{conditions::Chance{0.25F}, true}};
    actions::SendEvent send;
    send.reach = EventReach::Tagged;
    rule.actions = {actions::PlayClip{{{"sit_clap", 2.0F}, {"sit_cheer", 1.0F}}}, send};
    rule.limit = 3;
    rule.yields = RuleYield::Nobody;
    Rule other;
    other.id = 5;
    other.trigger = triggers::SpeedLimit{false, 1.75F};
    conditions::Property shows;
    shows.property = ComparedProperty::Clip;
    shows.clip = "wave";
    other.conditions = {conditions::Number{2, Comparison::Less, -3.5F}, shows};
    actions::GoToPlace moveUp;
    moveUp.choice = PlaceChoice::Ahead;
    actions::Follow follow;
    follow.aim = ActionAim::Tagged;
    follow.tag = 12;
    actions::SetProperty dye;
    dye.slot = "hair";
    dye.color = {1, 20, 255};
    dye.strength = 77;
    other.actions = {moveUp,
                     actions::AddToNumber{2},
                     actions::Appear{kNotChosen},
                     follow,
                     dye,
                     actions::TakeOnState{7, 2.5F, 1.0F},
                     actions::TellLight{5, LightDeed::Sweep, 0.5F},
                     actions::Repeat{0},
                     {actions::OneOf{2.5F}, 1},
                     {actions::PlayClip(), 2}};
    edit->setRules({rule, other});
    edit->setNumbers(
        {{2, "patience", -1.0F, 4.5F, {{1, 2.5F}, {900, -7.0F}}}, {7, "hunger", 0.0F, 0.0F}});
    edit->setStepsPerSecond(120);
    Cue calm{4, "Calm", {}, 0.0F, "F8"};
    calm.state = 7;
    calm.seconds = 1.5F;
    calm.spread = 4.0F;
    calm.order = StaggerOrder::Wedge;
    calm.point = {1.0F, 0.0F, -3.0F};
    edit->setCues({{3, "Go", "go", 2.5F, "F7", CueReach::Tagged, 9}, calm});
    edit->setSurface({0.5F, 2.0F, 0.3F, 35.0F});
    Place full = *edit->scene().findPlace(b);
    full.capacity = 12;
    full.role = PlaceRole::Slow;
    full.speedShare = 0.25F;
    edit->changePlace(full);
    Place lawn = *edit->scene().findPlace(c);
    lawn.shape = PlaceShape::Area;
    lawn.corners = {{0.0F, 0.5F, 0.0F}, {2.0F, 0.0F, 0.0F}, {0.0F, 0.0F, 2.25F}};
    edit->changePlace(lawn);
    edit->setTags({{0, "brave", {9, 8, 7}}, {63, "late", {1, 1, 1}}});
    edit->commit(QStringLiteral("Furnish"));
}

using Change = void (*)(Place&);

std::string fileWith(const std::string& members)
{
    return R"({"format": "crowdbrush-scene", "version": 1, )" + members +
           R"("individuals": {"columns": ["id","template","position"], "rows": []}})";
}

} // namespace

class TestEnvironment : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void savingKeepsEverything();
    void undoAndRedoRestoreIdenticalBytes();
    void everyMemberOfAPlaceIsAStep_data();
    void everyMemberOfAPlaceIsAStep();
    void stepsAreKnownWhenTheyAreAnnounced();
    void filesFromBeforeHaveNone();
    void aRemovedPlaceLeavesItsPaths();
    void aRemovedPathIsFollowedByNobody();
    void aNewPathIsNotTakenForADeletedOne();
    void placesOfAPathAreCountedByThemselves();
    void tooManyAreRefused();
    void refusesWhatIsWrong_data();
    void refusesWhatIsWrong();
    void unknownMembersAreWrittenBack();
    void scriptsMayNotMisspell_data();
    void scriptsMayNotMisspell();
    void scriptsMayPutBackWhatTheSceneHas();
    void manyPlacesAreSetAtOnce();
};

void TestEnvironment::savingKeepsEverything()
{
    SceneDocument document;
    furnish(document);
    const std::string text = projectText(document.scene());
    const auto read = projectFromText(text);
    QVERIFY2(read.isOk(), read ? "" : read.error().message.c_str());
    QCOMPARE(read.value().places, document.scene().places);
    QCOMPARE(read.value().paths, document.scene().paths);
    QCOMPARE(read.value().rules, document.scene().rules);
    QCOMPARE(read.value().tags, document.scene().tags);
    QCOMPARE(read.value().numbers, document.scene().numbers);
    QCOMPARE(read.value().cues, document.scene().cues);
    QCOMPARE(read.value().surface, document.scene().surface);
    QCOMPARE(read.value().stepsPerSecond, 120U);
    QCOMPARE(projectText(read.value()), text);
}

/// Not after the obstacles that were there before.
void TestEnvironment::placesOfAPathAreCountedByThemselves()
{
    SceneDocument document;
    document.edit(QStringLiteral("Build"), [](SceneEdit& edit) {
        Place wall;
        wall.name = "Obstacle 1";
        wall.role = PlaceRole::Obstacle;
        (void)edit.addPlace(wall);
        Place known;
        known.name = "Place 3";
        (void)edit.addPlace(known);
        PathId path = 0;
        for (int i = 0; i < 2; ++i) {
            path = appendPlace(edit, path, Place(), PathKind::Simple);
        }
    });
    const std::vector<Place>& places = document.scene().places;
    QCOMPARE(places[2].name, std::string("Place 2"));
    QCOMPARE(places[3].name, std::string("Place 4"));
}

void TestEnvironment::undoAndRedoRestoreIdenticalBytes()
{
    SceneDocument document;
    const std::string empty = projectText(document.scene());
    furnish(document);
    const std::string full = projectText(document.scene());
    {
        auto edit = document.beginEdit().value();
        edit->removePlace(2);
        edit->removePath(1);
        edit->setRules({});
        edit->setNumbers({});
        edit->setCues({});
        edit->setSurface({});
        edit->setStepsPerSecond(60);
        edit->commit(QStringLiteral("Clear"));
    }
    const std::string less = projectText(document.scene());
    QVERIFY(less != full);
    document.undoStack().undo();
    QCOMPARE(projectText(document.scene()), full);
    document.undoStack().undo();
    QCOMPARE(projectText(document.scene()), empty);
    document.undoStack().redo();
    document.undoStack().redo();
    QCOMPARE(projectText(document.scene()), less);
}

/// Who hears that rules have changed, as undo and redo tell it, finds the steps of now.
void TestEnvironment::everyMemberOfAPlaceIsAStep_data()
{
    QTest::addColumn<Change>("change");
    const auto row = [](const char* name, Change change) { QTest::newRow(name) << change; };
    row("name", [](Place& place) { place.name += "x"; });
    row("position", [](Place& place) { place.position.y += 1.0F; });
    row("radius", [](Place& place) { place.radius += 1.0F; });
    row("colour", [](Place& place) { place.color[1] ^= 1U; });
    row("role", [](Place& place) { place.role = PlaceRole::Exit; });
    row("capacity", [](Place& place) { place.capacity += 1; });
    row("speed", [](Place& place) { place.speedShare = 0.75F; });
    row("shape", [](Place& place) { place.shape = PlaceShape::Line; });
    row("a corner", [](Place& place) { place.corners[1].z += 0.5F; });
    row("one corner more", [](Place& place) { place.corners.emplace_back(1.0F); });
    row("what a newer version says", [](Place& place) { place.unknownMembers = R"({"x":1})"; });
}

void TestEnvironment::everyMemberOfAPlaceIsAStep()
{
    QFETCH(const Change, change);
    SceneDocument document;
    furnish(document);
    Place place = document.scene().places.back();
    QVERIFY(!place.corners.empty());
    const std::string before = projectText(document.scene());
    const std::size_t bytes = document.undoMemory().bytes();
    change(place);
    document.edit(QStringLiteral("Change"), [&](SceneEdit& edit) { edit.changePlace(place); });
    QCOMPARE(document.undoStack().count(), 2);
    QVERIFY(projectText(document.scene()) != before);
    QVERIFY(document.undoMemory().bytes() >=
            bytes + sizeof(glm::vec3) * document.scene().places.back().corners.size());
    document.undoStack().undo();
    QCOMPARE(projectText(document.scene()), before);
}

void TestEnvironment::stepsAreKnownWhenTheyAreAnnounced()
{
    SceneDocument document;
    auto edit = document.beginEdit().value();
    edit->setStepsPerSecond(120);
    edit->commit(QStringLiteral("Steps"));
    std::vector<std::uint32_t> heard;
    connect(&document, &SceneDocument::changed, this, [&](const SceneChange& change) {
        if (std::holds_alternative<RulesChanged>(change)) {
            heard.push_back(document.scene().stepsPerSecond);
        }
    });
    document.undoStack().undo();
    document.undoStack().redo();
    QCOMPARE(heard, (std::vector<std::uint32_t>{30, 120}));
}

void TestEnvironment::filesFromBeforeHaveNone()
{
    const auto read = projectFromText(fileWith(""));
    QVERIFY2(read.isOk(), read ? "" : read.error().message.c_str());
    QVERIFY(read.value().places.empty() && read.value().paths.empty());
    QVERIFY(read.value().rules.empty() && !read.value().hasBehaviour());
    QVERIFY(read.value().numbers.empty() && read.value().cues.empty());
    QVERIFY(read.value().surface == SurfaceSettings());
    for (const char* member : {"paths", "numbers", "cues", "surface"}) {
        QVERIFY(projectText(read.value()).find(member) == std::string::npos);
    }
    // A rule from before rules said whom they yield to.
    const auto old = projectFromText(fileWith(R"("rules": [{"id": 1}],)"));
    QVERIFY(old.isOk());
    QCOMPARE(old.value().rules[0].yields, RuleYield::FurtherUp);
}

void TestEnvironment::aRemovedPlaceLeavesItsPaths()
{
    SceneDocument document;
    furnish(document);
    auto edit = document.beginEdit().value();
    edit->removePlace(2);
    edit->commit(QStringLiteral("Delete"));
    const Path* round = document.scene().findPath(2);
    QCOMPARE(round->places, (std::vector<PlaceId>{1, 3}));
    QVERIFY(round->branches.empty());
}

void TestEnvironment::aRemovedPathIsFollowedByNobody()
{
    SceneDocument document;
    furnish(document);
    auto edit = document.beginEdit().value();
    IndividualRows rows = IndividualRows::withDefaults({1, 2});
    rows.column(columns::path)[0] = 2;
    rows.column(columns::path)[1] = 1;
    edit->addIndividuals(std::move(rows));
    edit->commit(QStringLiteral("Create"));
    QVERIFY(document.scene().hasBehaviour());
    edit = document.beginEdit().value();
    edit->removePath(1);
    edit->commit(QStringLiteral("Delete"));
    const auto followed = document.scene().population.column(columns::path);
    QCOMPARE(followed[0], 2U);
    QCOMPARE(followed[1], 0U);
    QVERIFY(document.scene().findPath(2)->branches.empty());
    document.undoStack().undo();
    QCOMPARE(document.scene().population.column(columns::path)[1], 1U);
}

void TestEnvironment::aNewPathIsNotTakenForADeletedOne()
{
    SceneDocument document;
    auto edit = document.beginEdit().value();
    const PathId gone = edit->addPath({});
    Rule rule;
    rule.id = 1;
    rule.actions = {actions::FollowPath{gone}};
    edit->setRules({rule});
    edit->removePath(gone);
    QVERIFY(edit->addPath({}) != gone);
    edit->rollback();
}

void TestEnvironment::tooManyAreRefused()
{
    std::string cues;
    for (int id = 1; id <= 300; ++id) {
        cues += (id == 1 ? "" : ",") + std::string("{\"id\": ") + std::to_string(id) + "}";
    }
    for (const char* member : {"cues", "numbers"}) {
        const auto read =
            projectFromText(fileWith("\"" + std::string(member) + "\": [" + cues + "],"));
        QVERIFY(!read.isOk());
        QVERIFY(read.error().message.find("more than 256") != std::string::npos);
    }
}

void TestEnvironment::refusesWhatIsWrong_data()
{
    QTest::addColumn<QString>("members");
    QTest::addColumn<QString>("said");
    const auto row = [](const char* name, const char* members, const char* said) {
        QTest::newRow(name) << QString::fromUtf8(members) << QString::fromUtf8(said);
    };
    row("places that are no list", R"("places": 5,)", "places must be a list");
    row("a place without id", R"("places": [{"position": [0,0,0]}],)", "places[0].id is missing");
    row("a place without position", R"("places": [{"id": 1}],)", "places[0].position is missing");
    row("the same place twice",
        R"("places": [{"id": 1, "position": [0,0,0]}, {"id": 1, "position": [0,0,0]}],)",
        "id 1 is given twice");
    row("a place without size", R"("places": [{"id": 1, "position": [0,0,0], "radius": 0}],)",
        "places[0].radius must lie between");
    row("an unknown role", R"("places": [{"id": 1, "position": [0,0,0], "role": "x"}],)",
        "places[0].role must be one of: spot, obstacle");
    row("a colour that is none", R"("places": [{"id": 1, "position": [0,0,0], "color": "red"}],)",
        "places[0].color must be a colour");
    row("a line of one corner",
        R"("places": [{"id": 1, "position": [0,0,0], "shape": "line", "corners": [[0,0,0]]}],)",
        "places[0].corners must be a list of [x, y, z]");
    row("an area of two corners",
        R"("places": [{"id": 1, "position": [0,0,0], "shape": "area",
                       "corners": [[0,0,0], [1,0,0]]}],)",
        "places[0].corners must be a list of [x, y, z]");
    row("a corner that is none",
        R"("places": [{"id": 1, "position": [0,0,0], "shape": "line",
                       "corners": [[0,0,0], [1,0], [2,0,0]]}],)",
        "places[0].corners must be a list of [x, y, z]");
    row("a corner beyond all bounds",
        R"("places": [{"id": 1, "position": [0,0,0], "shape": "line",
                       "corners": [[0,0,0], [1e30,0,0]]}],)",
        "none farther off than 10000");
    row("corners that are no list",
        R"("places": [{"id": 1, "position": [0,0,0], "corners": "x"}],)",
        "places[0].corners must be a list of [x, y, z]");
    row("an unknown shape", R"("places": [{"id": 1, "position": [0,0,0], "shape": "x"}],)",
        "places[0].shape must be one of: round, line, area");
    row("a path over a place that is not there", R"("paths": [{"id": 3, "places": [9]}],)",
        "names the place 9, which is not there");
    row("a path with names for places", R"("paths": [{"id": 3, "places": ["a"]}],)",
        "paths[0].places must be a list of ids");
    row("a branch to nowhere",
        R"("places": [{"id": 1, "position": [0,0,0]}],
           "paths": [{"id": 3, "places": [1], "branches": [{"place": 1, "path": 8}]}],)",
        "branches off to the path 8, which is not there");
    row("a rule of an unknown kind", R"("rules": [{"id": 1, "when": {"kind": "never"}}],)",
        "rules[0].when.kind must be one of");
    row("the same rule twice", R"("rules": [{"id": 1}, {"id": 1}],)", "rules: the id 1");
    row("a chance above one", R"("rules": [{"id": 1, "if": [{"chance": 2}]}],)",
        "rules[0].if[0].chance must lie between");
    row("a clip without a name", R"("rules": [{"id": 1, "do": [{"clips": [{}]}]}],)",
        "rules[0].do[0].clips[0].clip is missing");
    row("more room than there is",
        R"("places": [{"id": 1, "position": [0,0,0], "capacity": 1e9}],)",
        "places[0].capacity must be");
    row("room for less than nobody",
        R"("places": [{"id": 1, "position": [0,0,0], "capacity": -1}],)",
        "places[0].capacity must be a whole number");
    row("ground that nobody gets over",
        R"("places": [{"id": 1, "position": [0,0,0], "speedShare": 0}],)",
        "places[0].speedShare must lie between");
    row("a surface that is none", R"("surface": 3,)", "surface must be an object");
    row("bodies without width", R"("surface": {"radius": 0},)", "surface.radius must lie between");
    row("slopes like walls", R"("surface": {"slope": 90},)", "surface.slope must lie between");
    row("steps without end", R"("surface": {"climb": 1e30},)", "surface.climb must lie between");
    row("a rule that yields to the wind", R"("rules": [{"id": 1, "yields": "wind"}],)",
        "rules[0].yields must be one of");
    row("a speed below nothing", R"("rules": [{"id": 1, "when": {"metresPerSecond": -1}}],)",
        "rules[0].when.metresPerSecond must lie between");
    row("an unknown comparison", R"("rules": [{"id": 1, "if": [{"compare": "like"}]}],)",
        "rules[0].if[0].compare must be one of");
    row("a number without end", R"("rules": [{"id": 1, "if": [{"value": 1e300}]}],)",
        "rules[0].if[0].value must be a finite number");
    row("what repeats too often", R"("rules": [{"id": 1, "do": [{"times": 100000}]}],)",
        "rules[0].do[0].times must be at most");
    row("a weight below nothing", R"("rules": [{"id": 1, "do": [{"weight": -1}]}],)",
        "rules[0].do[0].weight must lie between");
    row("a tint stronger than can be", R"("rules": [{"id": 1, "do": [{"strength": 300}]}],)",
        "rules[0].do[0].strength must be");
    row("a property that nobody has", R"("rules": [{"id": 1, "do": [{"property": "soul"}]}],)",
        "rules[0].do[0].property must be one of");
    row("an unknown choice", R"("rules": [{"id": 1, "do": [{"choice": "any"}]}],)",
        "rules[0].do[0].choice must be one of");
    row("a name for a number", R"("rules": [{"id": 1, "do": [{"number": "x"}]}],)",
        "rules[0].do[0].number must be a whole number");
    row("numbers that are no list", R"("numbers": {},)", "numbers must be a list");
    row("a number without id", R"("numbers": [{}],)", "numbers[0].id is missing");
    row("the same number twice", R"("numbers": [{"id": 1}, {"id": 1}],)",
        "numbers: the id 1 is given twice");
    row("a number the wrong way round", R"("numbers": [{"id": 1, "low": 2, "high": 1}],)",
        "numbers[0].high must lie between");
    row("a value of nobody", R"("numbers": [{"id": 1, "values": [[-1, 2]]}],)",
        "numbers[0].values must be a list of pairs");
    row("a value without end", R"("numbers": [{"id": 1, "values": [[1, 1e99]]}],)",
        "numbers[0].values must be a list of pairs");
    row("two values of one", R"("numbers": [{"id": 1, "values": [[4, 2], [4, 3]]}],)",
        "numbers[0].values names the individual 4 twice");
    row("steps without time", R"("stepsPerSecond": 0,)", "stepsPerSecond must be 30, 60 or 120");
    row("steps of any length", R"("stepsPerSecond": 45,)", "stepsPerSecond must be 30, 60 or 120");
    row("the number of nobody", R"("numbers": [{"id": 0}],)", "numbers: the id 0 is not allowed");
    row("a cue without id", R"("cues": [{}],)", "cues[0].id is missing");
    row("a cue that recalls for longer than can be",
        R"("cues": [{"id": 1, "state": 2, "seconds": 1e9}],)",
        "cues[0].seconds must lie between 0 and 600");
    row("a cue that recalls in an order that there is not",
        R"("cues": [{"id": 1, "state": 2, "order": "up"}],)", "cues[0].order must be");
    row("a cue that recalls no state", R"("cues": [{"id": 1, "state": -2}],)",
        "cues[0].state must be");
    row("a cue with the key of a panel", R"("cues": [{"id": 1, "key": "F12"}],)",
        "cues[0].key must be one of F3 to F10");
    row("a cue with the key of a brush", R"("cues": [{"id": 1, "key": "x"}],)",
        "cues[0].key must be one of F3 to F10");
    row("a cue for a tag that is none", R"("cues": [{"id": 1, "tag": 64}],)",
        "cues[0].tag must be a tag");
    row("a cue to nowhere", R"("cues": [{"id": 1, "reach": "nowhere"}],)",
        "cues[0].reach must be one of");
    row("a tag that is too large", R"("tags": [{"tag": 64}],)", "tags[0].tag must be a tag");
}

void TestEnvironment::refusesWhatIsWrong()
{
    QFETCH(QString, members);
    QFETCH(QString, said);
    const auto read = projectFromText(fileWith(members.toStdString()));
    QVERIFY(!read.isOk());
    const QString message = QString::fromStdString(read.error().message);
    QVERIFY2(message.contains(said), qPrintable(message));
}

namespace {

TemplateEntry manWith(std::vector<std::string> clips)
{
    TemplateEntry entry;
    entry.id = 1;
    entry.name = "man";
    entry.clipNames = std::move(clips);
    return entry;
}

/// Something unknown in each part that can have it.
const char* const kStrange = R"({
"places": [{"id": 1, "position": [0,0,0], "zeal": 1}, {"id": 2, "position": [1,0,0]}],
"paths": [{"id": 1, "places": [1,2], "branches": [{"place": 1, "path": 1, "zeal": 2}], "zeal": 3}],
"surface": {"zeal": 4},
"rules": [{"id": 1, "zeal": 5, "when": {"kind": "start", "zeal": 6}, "if": [{"zeal": 7}],
           "do": [{"kind": "play", "clips": [{"clip": "wave", "zeal": 8}], "zeal": [9]}]}],
"tags": [{"tag": 3, "name": "happy", "zeal": 10}],
"numbers": [{"id": 1, "name": "joy", "zeal": 11}],
"cues": [{"id": 1, "name": "Go", "zeal": {"a": 12}}]})";

} // namespace

void TestEnvironment::unknownMembersAreWrittenBack()
{
    Scene scene;
    const auto read = readEnvironmentText(kStrange, scene, false);
    QVERIFY2(read.isOk(), read ? "" : read.error().message.c_str());
    const std::string text = projectText(scene);
    QCOMPARE(QString::fromStdString(text).count(QLatin1String("\"zeal\"")), 12);
    const auto again = projectFromText(text);
    QVERIFY2(again.isOk(), again ? "" : again.error().message.c_str());
    QCOMPARE(projectText(again.value()), text);
    QVERIFY(again.value().rules == scene.rules);
    QVERIFY(again.value().cues == scene.cues);
}

void TestEnvironment::scriptsMayNotMisspell_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("said");
    const auto row = [](const char* name, const char* text, const char* said) {
        QTest::newRow(name) << QString::fromUtf8(text) << QString::fromUtf8(said);
    };
    row("a trigger", R"({"rules": [{"id": 1, "when": {"kind": "event", "evnt": "x"}}]})",
        "rules[0].when has no \"evnt\": there are kind, event, place");
    row("a condition", R"({"rules": [{"id": 1, "if": [{"kind": "tag", "tagg": 1}]}]})",
        "rules[0].if[0] has no \"tagg\"");
    row("an action", R"({"rules": [{"id": 1, "do": [{"kind": "wait", "second": 1}]}]})",
        "rules[0].do[0] has no \"second\"");
    row("a clip", R"({"rules": [{"id": 1, "do": [{"clips": [{"clip": "a", "wight": 1}]}]}]})",
        "rules[0].do[0].clips[0] has no \"wight\"");
    row("a rule", R"({"rules": [{"id": 1, "whn": {}}]})", "rules[0] has no \"whn\"");
    row("a place", R"({"places": [{"id": 1, "position": [0,0,0], "radios": 1}]})",
        "places[0] has no \"radios\"");
    row("a path", R"({"paths": [{"id": 1, "places": [], "knd": "cyclic"}]})",
        "paths[0] has no \"knd\"");
    row("a cue", R"({"cues": [{"id": 1, "evnt": "x"}]})", "cues[0] has no \"evnt\"");
    row("a number", R"({"numbers": [{"id": 1, "lo": 1}]})", "numbers[0] has no \"lo\"");
    row("a tag", R"({"tags": [{"tag": 1, "colour": "#000000"}]})", "tags[0] has no \"colour\"");
    row("the surface", R"({"surface": {"slop": 3}})", "surface has no \"slop\"");
    row("too far away", R"({"places": [{"id": 1, "position": [1e30,0,0]}]})", "too far away");
    row("a clip of nobody", R"({"rules": [{"id": 1, "do": [{"clips": [{"clip": "wawe"}]}]}]})",
        "rules[0].do[0].clips[0].clip names the clip \"wawe\"");
    QTest::newRow("nested without end")
        << QStringLiteral("{\"rules\": ") + QString(200000, QLatin1Char('[')) +
               QString(200000, QLatin1Char(']')) + QLatin1Char('}')
        << QStringLiteral("nested more than 64 deep");
}

void TestEnvironment::scriptsMayNotMisspell()
{
    QFETCH(QString, text);
    QFETCH(QString, said);
    Scene scene;
    scene.templates.push_back(manWith({"wave", "a"}));
    const std::string before = projectText(scene);
    const auto read = readEnvironmentText(text.toStdString(), scene);
    QVERIFY(!read.isOk());
    QVERIFY2(QString::fromStdString(read.error().message).contains(said),
             read.error().message.c_str());
    QCOMPARE(projectText(scene), before);
}

void TestEnvironment::scriptsMayPutBackWhatTheSceneHas()
{
    Scene scene;
    scene.templates.push_back(manWith({"stand"}));
    QVERIFY(readEnvironmentText(kStrange, scene, false).isOk());
    const std::string text = projectText(scene);
    const auto put = readEnvironmentText(environmentText(scene), scene);
    QVERIFY2(put.isOk(), put ? "" : put.error().message.c_str());
    QCOMPARE(projectText(scene), text);
}

namespace {

/// Sets, writes, reads, takes back and does again; the processor's seconds that it took.
double secondsToSet(PlaceId count)
{
    SceneDocument document;
    furnish(document);
    const std::string before = projectText(document.scene());
    std::vector<Place> places;
    Path path;
    path.id = 7;
    for (PlaceId id = 1; id <= count; ++id) {
        places.push_back(placeAt(static_cast<float>(id), 0.0F));
        places.back().id = id;
        path.places.push_back(id);
    }
    const std::clock_t begin = std::clock();
    {
        auto edit = document.beginEdit().value();
        edit->setPlacesAndPaths(places, {path});
        edit->commit(QStringLiteral("many"));
    }
    Scene read = document.scene();
    const bool isRead = readEnvironmentText(environmentText(document.scene()), read).isOk();
    document.undoStack().undo();
    const bool isBack = projectText(document.scene()) == before;
    document.undoStack().redo();
    const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    const bool isSet = isRead && isBack && read.places == places &&
                       document.scene().places == places &&
                       document.scene().paths == std::vector<Path>{path};
    return isSet ? seconds : -1.0;
}

} // namespace

/// A script may bring hundreds of thousands; each must not be looked for among all, or eight times
/// as many take 64 times as long.
void TestEnvironment::manyPlacesAreSetAtOnce()
{
    const double few = secondsToSet(20'000);
    const double many = secondsToSet(160'000);
    QVERIFY(few > 0.0);
    QVERIFY(many > 0.0);
    QVERIFY2(many < 24.0 * few, qPrintable(QStringLiteral("%1 s, %2 s").arg(few).arg(many)));
}

CROWD_TEST(TestEnvironment)
#include "tst_Environment.moc"
