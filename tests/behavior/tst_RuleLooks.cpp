// SPDX-License-Identifier: MIT
#include <cmath>

#include <QtTest/QTest>

#include "tests/behavior/Actors.h"
#include "tests/program/Test.h"

using namespace crowd;
using namespace crowd::testing;
using model::ComparedProperty;
using model::Condition;
using model::SettableProperty;

namespace keys = model::columns;

namespace {

actions::SetProperty setTo(SettableProperty property, float value = 0.0F)
{
    actions::SetProperty made;
    made.property = property;
    made.value = value;
    return made;
}

/// With a skin that cannot be tinted, a top and hair.
void giveSlots(model::Scene& scene)
{
    auto asset = std::make_shared<model::Template>(*scene.templates.front().asset);
    for (const char* name : {"skin", "top", "hair"}) {
        model::Slot slot;
        slot.name = name;
        slot.tintable = std::string(name) != "skin";
        asset->slots.push_back(slot);
    }
    scene.templates.front().asset = asset;
}

template<class T>
T shownOf(const Session& session, model::ColumnKey<T> key, std::size_t row)
{
    return session.frame()->population.column(key)[row];
}

/// Where in his clip somebody is shown, 0..1.
double placeIn(const Session& session, std::size_t row, float clipSeconds)
{
    const auto frame = session.frame();
    const double place =
        static_cast<double>(frame->population.column(keys::phase)[row]) +
        frame->seconds * static_cast<double>(frame->population.column(keys::playbackSpeed)[row]) /
            static_cast<double>(clipSeconds);
    return place - std::floor(place);
}

/// Nought at the same place, also across the clip's end.
double apart(double a, double b)
{
    return std::fabs(std::remainder(a - b, 1.0));
}

} // namespace

class TestRuleLooks : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aSlotIsTinted();
    void allSlotsAreThoseThatCanBe();
    void heightIsShownAndAskedFor();
    void aClipIsTheirsFromNowOn();
    void playbackSpeedGoesOnFromWhereItIs();
    void phaseBringsEverybodyTogether();
    void propertiesAreCompared_data();
    void propertiesAreCompared();
    void whatTheArtistPaintsCountsAgain();
    void tagsOfRulesSurviveTheTagBrush();
};

void TestRuleLooks::aSlotIsTinted()
{
    model::Scene scene = rowOf(2);
    giveSlots(scene);
    actions::SetProperty blush = setTo(SettableProperty::Tint);
    blush.slot = "hair";
    blush.color = {200, 10, 20};
    blush.strength = 128;
    scene.rules = {onEvent("blush", {blush})};
    Session session(scene);
    session.send("blush", 0.0F, {2});
    run(session, 2);
    QVERIFY(shownOf(session, keys::tint(2), 1) == blush.tint());
    QVERIFY(shownOf(session, keys::tint(1), 1) == model::Tint());
    QVERIFY(shownOf(session, keys::tint(2), 0) == model::Tint());
    QVERIFY(scene.population.column(keys::tint(2))[1] == model::Tint());
}

void TestRuleLooks::allSlotsAreThoseThatCanBe()
{
    model::Scene scene = rowOf(1);
    giveSlots(scene);
    const actions::SetProperty blush = setTo(SettableProperty::Tint);
    scene.rules = {onEvent("blush", {blush})};
    Session session(scene);
    session.send("blush", 0.0F, {1});
    run(session, 2);
    QVERIFY(shownOf(session, keys::tint(0), 0) == model::Tint()); // skin
    QVERIFY(shownOf(session, keys::tint(1), 0) == blush.tint());
    QVERIFY(shownOf(session, keys::tint(2), 0) == blush.tint());
    QVERIFY(shownOf(session, keys::tint(3), 0) == model::Tint()); // there is no such slot
}

void TestRuleLooks::heightIsShownAndAskedFor()
{
    model::Scene scene = rowOf(3);
    Rule grow = onEvent("grow", {setTo(SettableProperty::Height, 1.25F)});
    grow.limit = 1;
    conditions::Property tall;
    tall.property = ComparedProperty::Height;
    tall.comparison = model::Comparison::More;
    tall.value = 1.2F;
    actions::AddTag mark;
    mark.tag = 3;
    Rule look = onEvent("look", {mark});
    look.id = 2;
    look.conditions = {tall};
    scene.rules = {grow, look};
    Session session(scene);
    session.send("grow", 0.0F, {2});
    run(session, 2);
    session.send("look", 0.0F, {1, 2, 3});
    run(session, 2);
    QCOMPARE(shownOf(session, keys::height, 1), 1.25F);
    QCOMPARE(shownOf(session, keys::height, 0), 1.0F);
    QCOMPARE(session.rules().tags(1), std::uint64_t{8});
    QCOMPARE(session.rules().tags(0), std::uint64_t{0});
    QCOMPARE(shownOf(session, keys::tags, 1), std::uint64_t{8});
}

void TestRuleLooks::aClipIsTheirsFromNowOn()
{
    model::Scene scene = rowOf(2);
    actions::SetProperty sit = setTo(SettableProperty::Clip);
    sit.clips = {{"sit", 1.0F}};
    actions::PlayClip clap;
    clap.clips = {{"clap", 1.0F}};
    scene.rules = {onEvent("rest", {sit, clap})};
    Session session(scene);
    session.send("rest", 0.0F, {1});
    run(session, 3);
    QCOMPARE(int{clipOf(session, 0)}, 3); // claps first
    run(session, 60);
    QCOMPARE(int{clipOf(session, 0)}, 4);
    QCOMPARE(int{clipOf(session, 1)}, 0);
    sit.clips = {{"no such clip", 1.0F}};
    scene.rules = {onEvent("rest", {sit})};
    session.adopt(scene);
    session.send("rest", 0.0F, {2});
    run(session, 3);
    QCOMPARE(int{clipOf(session, 1)}, 0); // stays as it is
}

void TestRuleLooks::playbackSpeedGoesOnFromWhereItIs()
{
    model::Scene scene = rowOf(1);
    scene.rules = {onEvent("faster", {setTo(SettableProperty::PlaybackSpeed, 3.0F)})};
    Session session(scene);
    run(session, 25);
    const double before = placeIn(session, 0, 2.0F);
    session.send("faster", 0.0F, {1});
    session.step();
    QCOMPARE(shownOf(session, keys::playbackSpeed, 0), 3.0F);
    QVERIFY(apart(placeIn(session, 0, 2.0F), before) < 0.06); // 1/30 s of it at most
    const double later = placeIn(session, 0, 2.0F);
    run(session, 6); // 0.2 s at triple speed are 0.3 of the clip
    QVERIFY(apart(placeIn(session, 0, 2.0F), later + 0.3) < 1e-3);
}

void TestRuleLooks::phaseBringsEverybodyTogether()
{
    model::Scene scene = rowOf(5);
    const auto ids = scene.population.ids();
    const std::vector<model::IndividualId> all(ids.begin(), ids.end());
    const std::vector<float> phases{0.1F, 0.3F, 0.55F, 0.7F, 0.95F};
    scene.population.setValues<float>(keys::phase, all, phases);
    scene.rules = {onEvent("now", {setTo(SettableProperty::Phase, 0.25F)})};
    Session session(scene);
    run(session, 17);
    session.send("now", 0.0F, all);
    run(session, 2);
    for (std::size_t row = 0; row < 5; ++row) {
        QVERIFY(apart(placeIn(session, row, 2.0F), 0.25 + 1.0 / 30.0) < 0.02);
        QVERIFY(apart(placeIn(session, row, 2.0F), placeIn(session, 0, 2.0F)) < 1e-5);
    }
}

void TestRuleLooks::propertiesAreCompared_data()
{
    QTest::addColumn<int>("property");
    QTest::addColumn<float>("value");
    QTest::newRow("girth") << static_cast<int>(ComparedProperty::Girth) << 1.5F;
    QTest::newRow("playback speed") << static_cast<int>(ComparedProperty::PlaybackSpeed) << 2.5F;
    QTest::newRow("walking speed") << static_cast<int>(ComparedProperty::WalkSpeed) << 1.75F;
    QTest::newRow("the clip that is seen") << static_cast<int>(ComparedProperty::Clip) << 0.0F;
}

void TestRuleLooks::propertiesAreCompared()
{
    QFETCH(const int, property);
    QFETCH(const float, value);
    model::Scene scene = rowOf(2);
    const std::vector<model::IndividualId> second{2};
    scene.population.setValues<float>(keys::girth, second, std::vector<float>{1.5F});
    scene.population.setValues<float>(keys::playbackSpeed, second, std::vector<float>{2.5F});
    scene.population.setValues<float>(keys::walkSpeed, second, std::vector<float>{1.75F});
    scene.population.setValues<std::uint16_t>(keys::clip, second, std::vector<std::uint16_t>{4});
    conditions::Property asked;
    asked.property = static_cast<ComparedProperty>(property);
    asked.comparison = model::Comparison::Equal;
    asked.value = value;
    asked.clip = "sit";
    actions::AddTag mark;
    mark.tag = 1;
    Rule rule = onEvent("ask", {mark});
    rule.conditions = {asked};
    scene.rules = {rule};
    Session session(scene);
    session.send("ask", 0.0F, {1, 2});
    run(session, 2);
    QCOMPARE(session.rules().tags(0), std::uint64_t{0});
    QCOMPARE(session.rules().tags(1), std::uint64_t{2});
}

void TestRuleLooks::whatTheArtistPaintsCountsAgain()
{
    model::Scene scene = rowOf(2);
    giveSlots(scene);
    scene.rules = {
        onEvent("change", {setTo(SettableProperty::Tint), setTo(SettableProperty::Height, 2.0F),
                           setTo(SettableProperty::PlaybackSpeed, 3.0F)})};
    Session session(scene);
    session.send("change", 0.0F, {1, 2});
    run(session, 5);
    const std::vector<model::IndividualId> first{1};
    const model::Tint painted{1, 2, 3, 255};
    scene.population.setValues<model::Tint>(keys::tint(1), first,
                                            std::vector<model::Tint>{painted});
    scene.population.setValues<float>(keys::height, first, std::vector<float>{0.8F});
    scene.population.setValues<float>(keys::playbackSpeed, first, std::vector<float>{0.5F});
    session.adopt(scene);
    run(session, 2);
    QVERIFY(shownOf(session, keys::tint(1), 0) == painted);
    QVERIFY(shownOf(session, keys::tint(2), 0) == actions::SetProperty().tint()); // was not painted
    QCOMPARE(shownOf(session, keys::height, 0), 0.8F);
    QCOMPARE(shownOf(session, keys::playbackSpeed, 0), 0.5F);
    QCOMPARE(shownOf(session, keys::height, 1), 2.0F);
    QCOMPARE(shownOf(session, keys::playbackSpeed, 1), 3.0F);
}

void TestRuleLooks::tagsOfRulesSurviveTheTagBrush()
{
    model::Scene scene = rowOf(1);
    actions::AddTag mark;
    mark.tag = 4;
    scene.rules = {onEvent("mark", {mark})};
    Session session(scene);
    session.send("mark", 0.0F, {1});
    run(session, 2);
    const std::vector<model::IndividualId> first{1};
    scene.population.setValues<std::uint64_t>(keys::tags, first, std::vector<std::uint64_t>{2});
    session.adopt(scene);
    run(session, 1);
    QCOMPARE(session.rules().tags(0), std::uint64_t{2 + 16});
    QCOMPARE(shownOf(session, keys::tags, 0), std::uint64_t{2 + 16});
}

CROWD_TEST(TestRuleLooks)
#include "tst_RuleLooks.moc"
