// SPDX-License-Identifier: MIT
#include "behavior/takes/EditedTake.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <set>

#include <QtTest/QTest>

#include "behavior/session/Session.h"
#include "behavior/takes/Retake.h"
#include "tests/behavior/RuleScenes.h"
#include "tests/program/Test.h"

using namespace crowd;
using namespace crowd::testing;
using behavior::EditedTake;
using behavior::EditedTime;
using behavior::MotionCache;
using behavior::OwnMoment;
using behavior::SessionPosePtr;
using model::HandEdit;
using model::HandEditKind;

namespace {

constexpr double kEditedStep = 1.0 / 30.0;
constexpr double kEditedEnd = 6.0; ///< seconds
constexpr std::size_t kEditedWalkers = 4;

/// People in a row along X who walk ahead, along Z.
model::Scene editedScene()
{
    model::Scene scene = rowOf(kEditedWalkers);
    scene.places = {{1, "far", {2.0F, 0.0F, 80.0F}, 6.0F}};
    scene.paths = {{1, "way", model::PathKind::Simple, {1}}};
    letWalk(scene, 1);
    return scene;
}

std::shared_ptr<MotionCache> editedMotion(const model::Scene& scene)
{
    auto cache = std::make_shared<MotionCache>();
    behavior::Session session(scene);
    cache->add(session.pose());
    while (session.seconds() < kEditedEnd) {
        session.step();
        cache->add(session.pose());
    }
    return cache;
}

HandEdit editOf(HandEditKind kind, double begin = 0.0, double end = 0.0)
{
    HandEdit edit;
    edit.kind = kind;
    edit.people = {2};
    edit.begin = begin;
    edit.end = end;
    return edit;
}

struct SeenInTake
{
    float x = 0.0F;
    float z = 0.0F;
    std::uint16_t clip = 0;
    float rate = 0.0F;
    bool isGone = false;
    std::size_t gone = 0;
    std::size_t fades = 0;
};

} // namespace

/// What is done to people of a take by hand is seen, and nothing else is.
class TestEditedTake : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void timeGoesAsItIsTold_data();
    void timeGoesAsItIsTold();
    void theirPaceHasNoJumps();
    void laterIsLater();
    void whoStandsStillRests();
    void asideIsBesideTheWay();
    void hiddenIsGoneForAWhile();
    void whatBeginsBetweenTwoStepsIsSeenAtOnce();
    void nobodyElseNotices();
    void editsOfTheSamePeopleAddUp();
    void whoIsNotMovedIsEditedToo();
    void whatIsOffOrOfNobodyIsNothing();
    void somebodyElseDoesTheSame();
    void ofSeveralTemplatesAndEditsEachHasOne();
    void whatRulesHaveMadeOfThemGoesOver();
    void templatesThatAreGoneAreNoneOfTheirs();
    void whoActsAgainAvoidsThemWhereTheyAreSeen();

private:
    [[nodiscard]] SeenInTake seen(const std::vector<HandEdit>& edits, double seconds,
                                  std::size_t id = 2) const;

    model::Scene m_scene;
    std::shared_ptr<MotionCache> m_motion;
};

void TestEditedTake::initTestCase()
{
    m_scene = editedScene();
    QCOMPARE(m_scene.population.ids()[1], model::IndividualId{2});
    m_motion = editedMotion(m_scene);
}

SeenInTake TestEditedTake::seen(const std::vector<HandEdit>& edits, double seconds,
                                std::size_t id) const
{
    EditedTake take(m_motion, edits, m_scene);
    const SessionPosePtr pose = take.around(seconds + 1e-4).first;
    const auto found = std::ranges::find(pose->ids, static_cast<model::IndividualId>(id));
    if (found == pose->ids.end()) { // nobody moves him yet
        const auto place = m_scene.population.column(model::columns::position)[id - 1];
        return {place.x, place.z, 0, 1.0F, false, 0, 0};
    }
    const auto row = static_cast<std::size_t>(found - pose->ids.begin());
    return {pose->x[row],
            pose->z[row],
            pose->clips[row],
            pose->rates[row],
            (pose->flags[row] & behavior::kPoseGone) != 0,
            pose->gone,
            pose->fades.size()};
}

void TestEditedTake::timeGoesAsItIsTold_data()
{
    QTest::addColumn<std::vector<HandEdit>>("edits");
    QTest::addColumn<double>("shown");
    QTest::addColumn<double>("own");
    QTest::addColumn<double>("pace");
    HandEdit later = editOf(HandEditKind::Shift);
    later.later = 2.0;
    HandEdit earlier = later;
    earlier.later = -2.0;
    HandEdit half = editOf(HandEditKind::Pace, 2.0, 6.0);
    HandEdit still = half;
    still.pace = 0.0F;
    HandEdit forGood = still;
    forGood.end = 0.0;
    HandEdit twice = half;
    twice.pace = 2.0F;
    const auto row = [](const char* name, const std::vector<HandEdit>& edits, double shown,
                        double own,
                        double pace) { QTest::newRow(name) << edits << shown << own << pace; };
    row("nothing", {}, 3.0, 3.0, 1.0);
    row("later", {later}, 3.0, 1.0, 1.0);
    row("not begun", {later}, 1.0, 0.0, 0.0);
    row("earlier", {earlier}, 3.0, 5.0, 1.0);
    row("over", {earlier}, 9.0, 10.0, 0.0);
    row("before it is slow", {half}, 2.0, 2.0, 1.0);
    // Half a second in which the pace falls from 1 to a half, and one in which it rises again.
    row("slow", {half}, 4.0, 2.0 + 0.375 + 0.75, 0.5);
    row("no longer slow", {half}, 7.0, 2.0 + 0.375 + 1.5 + 0.375 + 1.0, 1.0);
    row("still", {still}, 4.0, 2.25, 0.0);
    row("on again", {still}, 7.0, 2.0 + 0.25 + 0.25 + 1.0, 1.0);
    row("still for good", {forGood}, 9.0, 2.25, 0.0);
    row("fast", {twice}, 4.0, 2.0 + 0.75 + 3.0, 2.0);
    row("slow and later", {half, later}, 4.0, 2.0 + 0.375 + 0.75 - 2.0, 0.5);
    row("in any order", {later, half}, 4.0, 2.0 + 0.375 + 0.75 - 2.0, 0.5);
    row("twice as slow", {half, half}, 4.0, 2.0 + 0.5 * (1.0 - 0.5 + 0.25 / 3.0) + 1.5 * 0.25,
        0.25);
}

void TestEditedTake::timeGoesAsItIsTold()
{
    QFETCH(std::vector<HandEdit>, edits);
    QFETCH(double, shown);
    QFETCH(double, own);
    QFETCH(double, pace);
    const OwnMoment moment = EditedTime(edits, 0.0, 10.0).at(shown);
    QVERIFY2(std::abs(moment.seconds - own) < 1e-9, qPrintable(QString::number(moment.seconds)));
    QVERIFY2(std::abs(moment.pace - pace) < 1e-9, qPrintable(QString::number(moment.pace)));
}

void TestEditedTake::theirPaceHasNoJumps()
{
    HandEdit still = editOf(HandEditKind::Pace, 2.0, 2.6); // too short for whole ramps
    still.pace = 0.0F;
    HandEdit fast = editOf(HandEditKind::Pace, 2.2, 5.0);
    fast.pace = 4.0F;
    const EditedTime time(std::vector{still, fast}, 0.0, 100.0);
    constexpr double kFine = 1e-3;
    OwnMoment before = time.at(1.0);
    for (double shown = 1.0 + kFine; shown < 8.0; shown += kFine) {
        const OwnMoment now = time.at(shown);
        const double advance = (now.seconds - before.seconds) / kFine;
        QVERIFY2(std::abs(advance - 0.5 * (now.pace + before.pace)) < 0.05,
                 qPrintable(QString::number(shown)));
        QVERIFY(std::abs(now.pace - before.pace) < 0.05);
        before = now;
    }
}

void TestEditedTake::laterIsLater()
{
    HandEdit later = editOf(HandEditKind::Shift);
    later.later = 2.0;
    const SeenInTake was = seen({}, 3.0);
    QVERIFY(was.z > 1.0F);
    QVERIFY(std::abs(seen({later}, 5.0).z - was.z) < 1e-3F);
    later.later = 2.0 + 0.4 * kEditedStep; // between two steps
    QVERIFY(std::abs(seen({later}, 5.0).z - was.z) < 0.05F);
    // Until then he waits, and does not walk on the spot.
    const SeenInTake first = seen({}, 0.0);
    const SeenInTake waiting = seen({later}, 1.0);
    QVERIFY(std::abs(waiting.z - first.z) < 1e-3F);
    QVERIFY(waiting.clip != was.clip);
    QCOMPARE(waiting.rate, 1.0F);
}

void TestEditedTake::whoStandsStillRests()
{
    HandEdit still = editOf(HandEditKind::Pace, 2.0, 4.0);
    still.pace = 0.0F;
    const SeenInTake walking = seen({}, 2.0);
    const SeenInTake resting = seen({still}, 3.0);
    QVERIFY(resting.clip != walking.clip);
    QCOMPARE(seen({still}, 3.4).z, resting.z);
    // It fades, both ways.
    QVERIFY(seen({still}, 2.6).fades > seen({}, 2.6).fades);
    QVERIFY(seen({still}, 3.6).fades > seen({}, 3.6).fades);
    QCOMPARE(seen({still}, 5.0).clip, seen({}, 5.0).clip);
    QVERIFY(seen({still}, 5.0).z < seen({}, 5.0).z - 1.0F);
    HandEdit half = editOf(HandEditKind::Pace, 2.0);
    QVERIFY(std::abs(seen({half}, 4.0).rate - 0.5F * seen({}, 3.0).rate) < 0.05F);
}

void TestEditedTake::asideIsBesideTheWay()
{
    HandEdit aside = editOf(HandEditKind::Aside, 2.0, 6.0);
    aside.aside = 1.5F;
    // He looks along Z: to his right is the other way of X.
    QCOMPARE(seen({aside}, 1.9).x, seen({}, 1.9).x);
    const SeenInTake middle = seen({aside}, 4.0);
    QVERIFY2(std::abs(middle.x - seen({}, 4.0).x + 1.5F) < 0.1F,
             qPrintable(QString::number(middle.x)));
    QVERIFY(std::abs(middle.z - seen({}, 4.0).z) < 0.3F);
    // Bit by bit.
    float before = seen({aside}, 2.0).x - seen({}, 2.0).x;
    for (int step = 1; step < 120; ++step) {
        const double seconds = 2.0 + step * kEditedStep;
        const float now = seen({aside}, seconds).x - seen({}, seconds).x;
        QVERIFY(std::abs(now - before) < 0.06F);
        before = now;
    }
    aside.begin = 0.0; // from the first moment on
    aside.aside = -1.0F;
    QVERIFY(std::abs(seen({aside}, 0.0).x - seen({}, 0.0).x - 1.0F) < 0.1F);
}

void TestEditedTake::hiddenIsGoneForAWhile()
{
    const HandEdit hide = editOf(HandEditKind::Hide, 2.0, 3.0);
    QVERIFY(!seen({hide}, 1.9).isGone);
    QVERIFY(seen({hide}, 2.0).isGone);
    QCOMPARE(seen({hide}, 2.5).gone, std::size_t{1});
    QVERIFY(!seen({hide}, 3.0).isGone);
    QVERIFY(!seen({hide}, 2.5, 3).isGone);
    model::CrowdFrame frame{
        m_scene.population,
        std::make_shared<const std::vector<model::TemplateEntry>>(m_scene.templates), 2.5};
    EditedTake take(m_motion, {hide}, m_scene);
    const auto [before, after] = take.around(2.5);
    behavior::applyPose(*before, *after, frame);
    QVERIFY(frame.population.column(model::columns::position)[1].y < -1e3F); // out of sight
    QVERIFY(frame.population.column(model::columns::position)[2].y > -1.0F);
}

/// Who hides somebody at the moment that is shown sees it.
void TestEditedTake::whatBeginsBetweenTwoStepsIsSeenAtOnce()
{
    const double begin = 1.0 + kEditedStep / 2.0;
    QVERIFY(seen({editOf(HandEditKind::Hide, begin)}, begin).isGone);
    QVERIFY(!seen({editOf(HandEditKind::Hide, begin)}, begin - kEditedStep).isGone);
}

void TestEditedTake::nobodyElseNotices()
{
    HandEdit still = editOf(HandEditKind::Pace, 1.0);
    still.pace = 0.0F;
    HandEdit aside = editOf(HandEditKind::Aside, 0.0);
    aside.people = {4};
    for (const double seconds : {0.5, 1.3, 2.0, 5.5}) {
        for (const std::size_t id : {1U, 3U}) {
            const SeenInTake was = seen({}, seconds, id);
            const SeenInTake now = seen({still, aside}, seconds, id);
            QCOMPARE(now.x, was.x);
            QCOMPARE(now.z, was.z);
            QCOMPARE(now.clip, was.clip);
            QCOMPARE(now.rate, was.rate);
        }
    }
}

void TestEditedTake::editsOfTheSamePeopleAddUp()
{
    HandEdit later = editOf(HandEditKind::Shift);
    later.later = 1.0;
    HandEdit aside = editOf(HandEditKind::Aside);
    aside.people = {1, 2};
    const SeenInTake both = seen({later, aside}, 4.0);
    QVERIFY(std::abs(both.z - seen({}, 3.0).z) < 0.1F);
    QVERIFY(std::abs(both.x - seen({}, 3.0).x + 1.0F) < 0.1F);
}

/// At the first step the take leaves all as the scene has them.
void TestEditedTake::whoIsNotMovedIsEditedToo()
{
    QVERIFY(EditedTake(m_motion, {}, m_scene).around(0.0).first->ids.empty());
    QVERIFY(seen({editOf(HandEditKind::Hide)}, 0.0).isGone);
    HandEdit earlier = editOf(HandEditKind::Shift);
    earlier.later = -2.0;
    QVERIFY(std::abs(seen({earlier}, 0.0).z - seen({}, 2.0).z) < 1e-3F);
    EditedTake take(m_motion, {earlier}, m_scene);
    const auto [first, next] = take.around(0.0);
    QCOMPARE(first->ids, std::vector<model::IndividualId>{2});
    QCOMPARE(next->ids.size(), kEditedWalkers);
    QVERIFY(first->seats.empty() || first->seats.size() == 1);
}

void TestEditedTake::whatIsOffOrOfNobodyIsNothing()
{
    HandEdit off = editOf(HandEditKind::Hide);
    off.isOn = false;
    QVERIFY(!seen({off}, 2.0).isGone);
    HandEdit nobody = editOf(HandEditKind::Hide);
    nobody.people = {77};
    HandEdit elsewhere = editOf(HandEditKind::Pace, 1e5, 2e5);
    EditedTake take(m_motion, {nobody, elsewhere}, m_scene);
    QCOMPARE(take.around(2.0).first->gone, std::size_t{0});
    QVERIFY(std::abs(seen({elsewhere}, 3.0).z - seen({}, 3.0).z) < 1e-4F);
    model::Take many;
    many.motion = nullptr;
    many.problem = model::Message("gone");
    QVERIFY(!EditedTake::open(many, m_scene));
}

namespace {

constexpr model::TemplateId kElse = 2;
/// The actor with his clips the other way round, and shorter legs.
model::Scene withSomebodyElse(model::Scene scene)
{
    model::TemplateEntry other = actorTemplate();
    auto asset = std::make_shared<model::Template>(*other.asset);
    std::ranges::reverse(asset->clips);
    std::ranges::reverse(other.clipNames);
    const auto last = static_cast<int>(asset->clips.size()) - 1;
    asset->defaultClip = last - asset->defaultClip;
    asset->seatedClip = last - asset->seatedClip;
    for (model::Clip& clip : asset->clips) {
        clip.speed *= 0.5F;
    }
    other.id = kElse;
    other.name = "somebody else";
    other.asset = std::move(asset);
    scene.templates.push_back(std::move(other));
    return scene;
}

HandEdit swapOf(std::vector<int> templates, double begin = 0.0, double end = 0.0)
{
    HandEdit edit = editOf(HandEditKind::Swap, begin, end);
    edit.templates = std::move(templates);
    return edit;
}

std::string clipNameOf(const model::Scene& scene, const model::Population& people, std::size_t row)
{
    const auto* entry = scene.findTemplate(people.column(model::columns::templateId)[row]);
    return entry->clipNames[people.column(model::columns::clip)[row]];
}

/// Everybody as a picture has them.
model::Population swappedPeople(EditedTake& take, const model::Scene& scene, double seconds)
{
    model::CrowdFrame frame;
    frame.population = scene.population;
    frame.seconds = seconds;
    const auto [before, after] = take.around(seconds);
    behavior::applyPose(*before, *after, frame);
    return frame.population;
}

} // namespace

void TestEditedTake::somebodyElseDoesTheSame()
{
    const model::Scene scene = withSomebodyElse(m_scene);
    EditedTake plain(m_motion, {}, scene);
    EditedTake take(m_motion, {swapOf({kElse}, 1.0, 3.0)}, scene);
    for (const double seconds : {0.5, 1.0 + kEditedStep, 2.0, 3.5}) {
        const model::Population before = swappedPeople(plain, scene, seconds);
        const model::Population after = swappedPeople(take, scene, seconds);
        const bool isSwapped = seconds >= 1.0 && seconds < 3.0;
        const auto templates = after.column(model::columns::templateId);
        QCOMPARE(templates[1], isSwapped ? kElse : model::TemplateId{1});
        QCOMPARE(templates[2], model::TemplateId{1});
        QCOMPARE(clipNameOf(scene, after, 1), clipNameOf(scene, before, 1));
        const auto where = [](const model::Population& people) {
            return people.column(model::columns::position)[1];
        };
        QVERIFY(where(after) == where(before));
        const float pace = after.column(model::columns::playbackSpeed)[1] /
                           before.column(model::columns::playbackSpeed)[1];
        QVERIFY2(std::abs(pace - (isSwapped ? 2.0F : 1.0F)) < 0.01F,
                 qPrintable(QString::number(pace)));
    }
    // At rest too, where no step of the take says anything of him.
    QCOMPARE(swappedPeople(take, scene, 0.0).column(model::columns::templateId)[1],
             model::TemplateId{1});
    EditedTake always(m_motion, {swapOf({kElse})}, scene);
    const model::Population first = swappedPeople(always, scene, 0.0);
    QCOMPARE(first.column(model::columns::templateId)[1], kElse);
    QCOMPARE(clipNameOf(scene, first, 1), std::string("idle"));
}

void TestEditedTake::ofSeveralTemplatesAndEditsEachHasOne()
{
    const model::Scene scene = withSomebodyElse(m_scene);
    HandEdit everybody = swapOf({1, kElse});
    everybody.people = {1, 2, 3, 4};
    EditedTake take(m_motion, {everybody}, scene);
    const model::Population people = swappedPeople(take, scene, 2.0);
    const auto templates = people.column(model::columns::templateId);
    QCOMPARE(std::ranges::count(templates, kElse), 2);
    EditedTake twice(m_motion, {everybody, swapOf({1})}, scene); // the last one counts
    EditedTake turned(m_motion, {swapOf({1}), everybody}, scene);
    const auto of = [&scene](EditedTake& each) {
        return swappedPeople(each, scene, 2.0).column(model::columns::templateId)[1];
    };
    QCOMPARE(of(twice), model::TemplateId{1});
    QCOMPARE(of(turned), templates[1]);
}

/// Of others it says what it said.
void TestEditedTake::whatRulesHaveMadeOfThemGoesOver()
{
    const model::Scene scene = withSomebodyElse(m_scene);
    behavior::PropertyOverrides rules;
    rules.set(model::columns::parts, 1, std::uint32_t{5});
    rules.set(model::columns::height, 2, 1.5F);
    behavior::SessionPose pose = *EditedTake(m_motion, {}, scene).around(2.0).first;
    pose.overrides = rules.publish();
    const std::vector<model::IndividualId> whom{2};
    behavior::SwappedPeople swap(scene, whom, std::array{int{kElse}});
    std::set<model::IndividualId> swapped;
    swap.apply(pose, swapped);
    QCOMPARE(swapped, std::set<model::IndividualId>{2});
    const auto* parts = pose.overrides->column(model::ColumnId::Parts);
    QCOMPARE(parts->ids, (std::vector<model::IndividualId>{1, 2}));
    std::uint32_t first = 0;
    std::memcpy(&first, parts->bytes.data(), sizeof(first));
    QCOMPARE(first, 5U);
    QCOMPARE(pose.overrides->column(model::ColumnId::Template)->ids, whom);
    QCOMPARE(pose.overrides->column(model::ColumnId::Height)->ids, whom);
    // Whoever the scene makes of another template meanwhile is of that one already.
    model::Population edited = scene.population;
    edited.setValues<model::TemplateId>(model::columns::templateId, whom, std::array{kElse});
    QVERIFY(swap.setPeople(edited) && !swap.setPeople(edited));
    behavior::SessionPose again = *EditedTake(m_motion, {}, scene).around(2.0).first;
    const std::uint16_t clip = again.clips[1];
    std::set<model::IndividualId> anew;
    swap.apply(again, anew);
    QCOMPARE(again.clips[1], clip);
}

void TestEditedTake::templatesThatAreGoneAreNoneOfTheirs()
{
    for (const std::vector<int>& templates : {std::vector<int>{}, {77}, {-1, 70'000}}) {
        EditedTake take(m_motion, {swapOf(templates)}, m_scene);
        QCOMPARE(swappedPeople(take, m_scene, 2.0).column(model::columns::templateId)[1],
                 model::TemplateId{1});
    }
    HandEdit nobody = swapOf({kElse});
    nobody.people = {77};
    EditedTake take(m_motion, {nobody}, withSomebodyElse(m_scene));
    QVERIFY(take.around(2.0).first);
}

/// Somebody who is brought into the way of who acts again.
void TestEditedTake::whoActsAgainAvoidsThemWhereTheyAreSeen()
{
    HandEdit still = editOf(HandEditKind::Pace, 1.0);
    still.pace = 0.0F;
    HandEdit earlier = editOf(HandEditKind::Shift);
    earlier.later = -2.0;
    HandEdit aside = editOf(HandEditKind::Aside);
    const auto places = m_scene.population.column(model::columns::position);
    aside.aside = places[1].x - places[2].x; // onto the way of the third, ahead of him
    behavior::RetakeWish wish{{3}, 0.5, kEditedEnd, 0};
    const auto nearest = [&](const std::vector<HandEdit>& edits) {
        wish.edits = edits;
        const auto made = behavior::retake(m_scene, m_motion, wish, nullptr);
        EditedTake take(made.value().motion, {earlier, still, aside}, m_scene);
        float least = 1e9F;
        for (double seconds = 1.6; seconds < kEditedEnd; seconds += kEditedStep) {
            const SessionPosePtr pose = take.around(seconds).first;
            const float x = pose->x[1] - pose->x[2];
            const float z = pose->z[1] - pose->z[2];
            least = std::min(least, std::sqrt(x * x + z * z));
        }
        return least;
    };
    const float blind = nearest({});
    const float avoiding = nearest({earlier, still, aside});
    QVERIFY2(avoiding > blind + 0.1F, qPrintable(QStringLiteral("%1 %2").arg(avoiding).arg(blind)));
}

CROWD_TEST(TestEditedTake)
#include "tst_EditedTake.moc"
