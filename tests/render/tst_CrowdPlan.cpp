// SPDX-License-Identifier: MIT
#include <QtTest/QtTest>

#include "model/bake/KeyframeTime.h"
#include "model/base/Random.h"
#include "render/crowd/CrowdPlan.h"
#include "render/crowd/LevelChoice.h"
#include "render/crowd/StaticRecords.h"
#include "tests/program/Test.h"
#include "tests/render/TestScene.h"

using namespace crowd;
using namespace crowd::testing;

/// Who is drawn how, and what is uploaded: all of it without GL.
class TestCrowdPlan : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void levelFollowsHeight_data();
    void levelFollowsHeight();
    void levelIsKeptNearAThreshold();
    void whoIsBesideTheViewIsCulled();
    void orderIsByLevelTemplateDistanceAndKeyframe();
    void planIsTheSameForAnyOrderOfChunks();
    void levelsFollowTheIndividualWhenRowsMove();
    void highlightedAreListed();
    void keyframesAreThoseOfTheShownPhase();
    void standInsAreReported();
    void standInsOfFadesAreReported();
    void theOrderIsTheSameWhereverClipsLie();
    void whoChangesClipsIsDrawnBetweenBoth();
    void hiddenGroupsAreNotDrawn();
    void onlyChangedRowsAreListed();
    void rowsThatComeBackAreListed();
    void olderPopulationIsNoticed();

private:
    [[nodiscard]] render::CrowdPlan plan(const model::Population& population,
                                         const model::View& view, double seconds = 0.0);
    void make(render::CrowdPlan& plan, const model::Population& population, const model::View& view,
              double seconds = 0.0, std::span<const model::IndividualId> selected = {});

    model::TemplatePtr m_man = makeBoxMan(4);
    std::vector<render::PlanTemplate> m_templates;
    std::vector<model::TemplateEntry> m_entries;
    std::vector<model::GroupId> m_hidden; ///< groups
    std::vector<float> m_lifts;
};

void TestCrowdPlan::make(render::CrowdPlan& plan, const model::Population& population,
                         const model::View& view, double seconds,
                         std::span<const model::IndividualId> selected)
{
    m_entries = {entryFor(m_man, 1), entryFor(m_man, 2)};
    m_templates.assign(2, {});
    for (render::PlanTemplate& asset : m_templates) {
        asset.isDrawable = true;
        asset.height = m_man->height;
        asset.levels = 4;
        std::uint32_t first = 0;
        for (std::size_t clip = 0; clip < m_man->clips.size(); ++clip) {
            asset.clips.push_back({&m_man->clips[clip], first, true,
                                   static_cast<std::uint16_t>(clip), m_man->bounds});
            asset.clipOfName.push_back(static_cast<std::uint16_t>(clip));
            first += static_cast<std::uint32_t>(m_man->clips[clip].keyframeCount());
        }
    }
    m_lifts.assign(population.size(), 0.0F);
    model::CrowdFrame frame = *frameOf(population, m_entries, seconds);
    frame.hiddenGroups = m_hidden;
    plan.make({frame, m_templates, m_lifts, view, 1.0F, {}, selected, 0});
}

render::CrowdPlan TestCrowdPlan::plan(const model::Population& population, const model::View& view,
                                      double seconds)
{
    render::CrowdPlan made;
    make(made, population, view, seconds);
    return made;
}

void TestCrowdPlan::hiddenGroupsAreNotDrawn()
{
    model::Population people = makeRow(3);
    const std::vector<model::GroupId> groups{0, 4, 9};
    people.setValues<model::GroupId>(model::columns::group, people.ids(), groups);
    const model::View view = frontView({640.0F, 640.0F}, 10.0F);
    const auto drawnWithout = [&](std::vector<model::GroupId> hidden) {
        m_hidden = std::move(hidden);
        return plan(people, view).instances().size();
    };
    QCOMPARE(drawnWithout({}), std::size_t{3});
    QCOMPARE(drawnWithout({4}), std::size_t{2});
    QCOMPARE(drawnWithout({4, 9}), std::size_t{1});
    QCOMPARE(drawnWithout({5}), std::size_t{3});
    m_hidden.clear();
}

void TestCrowdPlan::levelFollowsHeight_data()
{
    QTest::addColumn<float>("pixels");
    QTest::addColumn<int>("last");
    QTest::addColumn<int>("level");
    QTest::newRow("tall") << 200.0F << -1 << 0;
    QTest::newRow("just above the first threshold") << 60.5F << -1 << 0;
    QTest::newRow("just below it") << 59.5F << -1 << 1;
    QTest::newRow("small") << 20.0F << -1 << 2;
    QTest::newRow("tiny") << 5.0F << -1 << 3;
    QTest::newRow("fine one stays a little below") << 56.0F << 0 << 0;
    QTest::newRow("fine one goes further below") << 53.0F << 0 << 1;
    QTest::newRow("coarse one stays a little above") << 64.0F << 1 << 1;
    QTest::newRow("coarse one goes further above") << 67.0F << 1 << 0;
    QTest::newRow("from the finest to the coarsest") << 5.0F << 0 << 3;
    QTest::newRow("from the coarsest to the finest") << 200.0F << 3 << 0;
}

void TestCrowdPlan::levelFollowsHeight()
{
    QFETCH(float, pixels);
    QFETCH(int, last);
    QFETCH(int, level);
    const render::LevelChoice choice(render::LevelThresholds{});
    const std::size_t before =
        last < 0 ? render::LevelChoice::kNone : static_cast<std::size_t>(last);
    QCOMPARE(choice.level(pixels, before, 3), level);
    QCOMPARE(choice.level(pixels, before, 1), std::min(level, 1));
    QCOMPARE(choice.level(pixels, before, 0), 0);
}

void TestCrowdPlan::levelIsKeptNearAThreshold()
{
    // 1.8 m at 852 pixels per metre and metre: 60 pixels at 25.5 m.
    const model::Population people = makeRow(1);
    render::CrowdPlan plan;
    const auto levelAt = [&](float distance) {
        make(plan, people, frontView({1280.0F, 720.0F}, distance));
        return plan.runs().front().level;
    };
    QCOMPARE(levelAt(24.0F), 0);
    QCOMPARE(levelAt(26.5F), 0);
    QCOMPARE(levelAt(29.0F), 1);
    QCOMPARE(levelAt(24.5F), 1);
    QCOMPARE(levelAt(22.0F), 0);
}

void TestCrowdPlan::whoIsBesideTheViewIsCulled()
{
    const model::Population people = makeRow(1000);
    const render::CrowdPlan made = plan(people, frontView({640.0F, 640.0F}, 10.0F));
    // The view is 8.5 m wide at the row, half of it to the right, where everybody stands.
    QVERIFY(made.instances().size() >= 5);
    QVERIFY(made.instances().size() <= 7);
    for (const render::Instance& instance : made.instances()) {
        QVERIFY((instance.rowAndFlags & render::Instance::kRowMask) < 7);
    }
    const model::View away(model::Camera::lookingAt({0, 1, 10}, {0, 1, 20}), {640, 640});
    QVERIFY(plan(people, away).instances().empty());
}

/// People at random over a field, of two templates and all clips.
model::Population makeField(std::size_t count)
{
    model::Population people = makeRow(count);
    const std::vector<model::IndividualId> ids(people.ids().begin(), people.ids().end());
    std::vector<glm::vec3> positions;
    std::vector<model::TemplateId> templates;
    std::vector<std::uint16_t> clips;
    std::vector<float> phases;
    for (const model::IndividualId id : ids) {
        positions.emplace_back(model::unitFloat(model::hashKeys(id, 0)) * 60.0F - 30.0F, 0.0F,
                               -model::unitFloat(model::hashKeys(id, 1)) * 120.0F);
        templates.push_back(static_cast<model::TemplateId>(1 + id % 2));
        clips.push_back(static_cast<std::uint16_t>(id % 3));
        phases.push_back(model::unitFloat(model::hashKeys(id, 2)));
    }
    people.setValues(model::columns::position, ids, std::span<const glm::vec3>(positions));
    people.setValues(model::columns::templateId, ids,
                     std::span<const model::TemplateId>(templates));
    people.setValues(model::columns::clip, ids, std::span<const std::uint16_t>(clips));
    people.setValues(model::columns::phase, ids, std::span<const float>(phases));
    return people;
}

void TestCrowdPlan::orderIsByLevelTemplateDistanceAndKeyframe()
{
    const model::Population people = makeField(5000);
    const model::View view = frontView({1280.0F, 720.0F}, 8.0F);
    const render::CrowdPlan made = plan(people, view);
    QVERIFY(made.runs().size() == 8);
    std::size_t expected = 0;
    std::pair<int, int> last{-1, -1};
    const auto positions = people.column(model::columns::position);
    int nearerAfterFarther = 0;
    for (const render::InstanceRun& run : made.runs()) {
        QCOMPARE(run.first, expected);
        expected += run.count;
        QVERIFY(std::pair(run.level, run.entry) > last);
        last = {run.level, run.entry};
        float farthest = 0.0F;
        for (std::size_t i = run.first; i < run.first + run.count; ++i) {
            const std::size_t row = made.instances()[i].rowAndFlags & render::Instance::kRowMask;
            QCOMPARE(static_cast<int>(people.column(model::columns::templateId)[row]),
                     run.entry + 1);
            const float depth = 8.0F - positions[row].z;
            // A step is a quarter of an octave.
            nearerAfterFarther += depth < farthest * 0.78F ? 1 : 0;
            farthest = std::max(farthest, depth);
        }
    }
    QCOMPARE(expected, made.instances().size());
    QCOMPARE(nearerAfterFarther, 0);
}

void TestCrowdPlan::planIsTheSameForAnyOrderOfChunks()
{
    const model::Population people = makeField(20000);
    const model::View view = frontView({1280.0F, 720.0F}, 8.0F);
    const render::CrowdPlan first = plan(people, view, 1.25);
    for (int again = 0; again < 5; ++again) {
        const render::CrowdPlan second = plan(people, view, 1.25);
        QCOMPARE(first.instances().size(), second.instances().size());
        QVERIFY(std::memcmp(first.instances().data(), second.instances().data(),
                            first.instances().size_bytes()) == 0);
    }
}

void TestCrowdPlan::levelsFollowTheIndividualWhenRowsMove()
{
    model::Population people = makeRow(3);
    render::CrowdPlan made;
    make(made, people, frontView({1280.0F, 720.0F}, 24.0F));
    QCOMPARE(made.byLevel()[0], 3);
    const std::array<model::IndividualId, 1> first{1};
    (void)people.remove(first);
    make(made, people, frontView({1280.0F, 720.0F}, 26.5F));
    QCOMPARE(made.byLevel()[0], 2); // a new individual here would be at level 1
}

void TestCrowdPlan::highlightedAreListed()
{
    const std::array<model::IndividualId, 2> selected{2, 3};
    render::CrowdPlan made;
    make(made, makeRow(4), frontView({640.0F, 640.0F}, 12.0F), 0.0, selected);
    QCOMPARE(made.highlighted().size(), std::size_t{2});
    QCOMPARE(made.highlighted()[0].rowAndFlags, render::Instance::kSelected | 1U);
    QCOMPARE(made.highlightedRuns().size(), std::size_t{1});
    make(made, makeRow(4), frontView({640.0F, 640.0F}, 12.0F));
    QVERIFY(made.highlighted().empty());
}

void TestCrowdPlan::keyframesAreThoseOfTheShownPhase()
{
    model::Population people = makeField(3000);
    const std::vector<model::IndividualId> ids(people.ids().begin(), people.ids().end());
    std::vector<float> speeds;
    for (const model::IndividualId id : ids) {
        speeds.push_back(static_cast<float>(id % 7) * 0.4F - 0.8F); // backwards, too
    }
    people.setValues(model::columns::playbackSpeed, ids, std::span<const float>(speeds));
    const double seconds = 12345.678;
    const render::CrowdPlan made = plan(people, frontView({1280.0F, 720.0F}, 60.0F), seconds);
    QVERIFY(made.instances().size() > 1000);
    for (const render::Instance& shown : made.instances()) {
        const std::size_t row = shown.rowAndFlags & render::Instance::kRowMask;
        const std::size_t index = people.column(model::columns::clip)[row];
        const render::PlanClip& clip =
            m_templates[0].clips[std::min(index, m_man->clips.size() - 1)];
        const float phase = model::shownPhase(*clip.clip, people.column(model::columns::phase)[row],
                                              speeds[row], seconds);
        const model::KeyframePlace place = model::keyframePlace(*clip.clip, phase);
        const float expected = static_cast<float>(place.first) + place.blend;
        const float got = static_cast<float>(shown.keyframeA - clip.firstKeyframe) + shown.blend;
        QVERIFY2(std::abs(got - expected) < 1e-3F, qPrintable(QString::number(row)));
    }
}

void TestCrowdPlan::whoChangesClipsIsDrawnBetweenBoth()
{
    const model::Population people = makeField(3000);
    const auto frame = std::make_shared<model::CrowdFrame>(*frameOf(people, m_entries));
    for (std::uint32_t row = 0; row < 3000; row += 3) {
        frame->fades.push_back({row, static_cast<std::uint16_t>((row / 3) % 2), 0.5F, 0.25F});
    }
    render::CrowdPlan plain;
    render::CrowdPlan faded;
    const model::View view = frontView({1280.0F, 720.0F}, 60.0F);
    const std::vector<float> lifts(3000, 0.0F);
    plain.make({*frameOf(people, m_entries), m_templates, lifts, view, 1.0F, {}, {}, 0});
    faded.make({*frame, m_templates, lifts, view, 1.0F, {}, {}, 0});
    QCOMPARE(faded.instances().size(), plain.instances().size());
    int changed = 0;
    for (std::size_t i = 0; i < faded.instances().size(); ++i) {
        const render::Instance& was = plain.instances()[i];
        const render::Instance& now = faded.instances()[i];
        QCOMPARE(now.rowAndFlags, was.rowAndFlags); // the order is the same
        const std::uint32_t row = now.rowAndFlags & render::Instance::kRowMask;
        if (row % 3 != 0) {
            QVERIFY(std::memcmp(&now, &was, sizeof now) == 0);
            continue;
        }
        ++changed;
        const render::PlanClip& from = m_templates[0].clips[(row / 3) % 2];
        QCOMPARE(now.blend, 0.25F);
        QVERIFY(now.keyframeA >= from.firstKeyframe &&
                now.keyframeA <
                    from.firstKeyframe + static_cast<std::uint32_t>(from.clip->keyframeCount()));
        QCOMPARE(now.boxes & 0xFFFFU, std::uint32_t{from.box});
        QCOMPARE(now.boxes >> 16U, was.boxes >> 16U);
        QCOMPARE(now.keyframeB, was.blend < 0.5F ? was.keyframeA : was.keyframeB);
    }
    QVERIFY(changed > 300);
}

void TestCrowdPlan::standInsAreReported()
{
    render::CrowdPlan made;
    const model::Population people = makeRow(2);
    make(made, people, frontView());
    QVERIFY(!made.areKeyframesMissing());
    m_templates[0].clips[0].isComplete = false;
    const model::CrowdFramePtr frame = frameOf(people, m_entries);
    made.make({*frame, m_templates, m_lifts, frontView(), 1.0F, {}, {}, 0});
    QVERIFY(made.areKeyframesMissing());
}

/// Nobody may be in that clip any more.
void TestCrowdPlan::standInsOfFadesAreReported()
{
    render::CrowdPlan made;
    make(made, makeRow(2), frontView());
    const auto frame = std::make_shared<model::CrowdFrame>(*frameOf(makeRow(2), m_entries));
    QCOMPARE(frame->population.column(model::columns::clip)[0], std::uint16_t{0});
    m_templates[0].clips[1].isComplete = false;
    made.make({*frame, m_templates, m_lifts, frontView(), 1.0F, {}, {}, 0});
    QVERIFY(!made.areKeyframesMissing());
    frame->fades.push_back({0, 1, 0.5F, 0.25F});
    made.make({*frame, m_templates, m_lifts, frontView(), 1.0F, {}, {}, 0});
    QVERIFY(made.areKeyframesMissing());
}

void TestCrowdPlan::theOrderIsTheSameWhereverClipsLie()
{
    const model::Population people = makeField(3000);
    const model::View view = frontView({1280.0F, 720.0F}, 60.0F);
    const render::CrowdPlan asAsked = plan(people, view);
    for (render::PlanTemplate& asset : m_templates) {
        std::uint32_t next = 0; // the last clip was asked for first
        for (auto clip = asset.clips.rbegin(); clip != asset.clips.rend(); ++clip) {
            clip->firstKeyframe = next;
            next += static_cast<std::uint32_t>(clip->clip->keyframeCount());
        }
    }
    const std::vector<float> lifts(people.size(), 0.0F);
    render::CrowdPlan otherwise;
    otherwise.make({*frameOf(people, m_entries), m_templates, lifts, view, 1.0F, {}, {}, 0});
    QVERIFY(asAsked.instances().size() > 1000);
    QCOMPARE(otherwise.instances().size(), asAsked.instances().size());
    bool isElsewhere = false;
    for (std::size_t i = 0; i < asAsked.instances().size(); ++i) {
        QCOMPARE(otherwise.instances()[i].rowAndFlags, asAsked.instances()[i].rowAndFlags);
        isElsewhere |= otherwise.instances()[i].keyframeA != asAsked.instances()[i].keyframeA;
    }
    QVERIFY(isElsewhere);
}

std::vector<render::RowRange> listed(std::span<const render::RowRange> ranges)
{
    return {ranges.begin(), ranges.end()};
}

void TestCrowdPlan::onlyChangedRowsAreListed()
{
    using Ranges = std::vector<render::RowRange>;
    model::Population people = makeRow(1000);
    const std::vector<model::TemplateEntry> entries{entryFor(m_man)};
    std::vector<render::RecordTemplate> templates(1);
    for (const model::Clip& clip : m_man->clips) {
        templates[0].clipOfName.push_back(&clip);
    }
    render::StaticRecords records;
    const auto update = [&] { records.update({*frameOf(people, entries), templates, {}, 1, 1}); };
    const auto placements = [&] { return listed(records.changedPlacements()); };
    const auto appearances = [&] { return listed(records.changedAppearances()); };
    update();
    QCOMPARE(placements(), (Ranges{{0, 1000}}));
    QCOMPARE(appearances(), (Ranges{{0, 1000}}));
    update();
    QVERIFY(placements().empty() && appearances().empty());

    const std::array<model::IndividualId, 4> changed{300, 301, 303, 1000};
    const model::Tint red{255, 0, 0, 255};
    people.setValues(model::columns::tint(3), changed, std::span(&red, 1));
    update();
    QVERIFY(placements().empty());
    QCOMPARE(appearances(), (Ranges{{299, 4}, {999, 1}}));
    QVERIFY(records.appearances()[299].tints[3] == red);
    QVERIFY(records.appearances()[999].tints[3] == red);
    QVERIFY(records.appearances()[998].tints[3] != red);

    people.setValues(model::columns::tint(3), changed, std::span(&red, 1));
    const float phase = 0.5F;
    people.setValues(model::columns::phase, changed, std::span(&phase, 1));
    update();
    QVERIFY(placements().empty() && appearances().empty());
}

void TestCrowdPlan::rowsThatComeBackAreListed()
{
    using Ranges = std::vector<render::RowRange>;
    model::Population people = makeRow(700);
    const std::vector<model::TemplateEntry> entries{entryFor(m_man)};
    std::vector<render::RecordTemplate> templates(1);
    templates[0].clipOfName.push_back(&m_man->clips[0]);
    render::StaticRecords records;
    const auto update = [&] { records.update({*frameOf(people, entries), templates, {}, 1, 1}); };
    update();
    const std::array<model::IndividualId, 2> last{699, 700};
    const model::IndividualRows removed = people.remove(last);
    update();
    QVERIFY(listed(records.changedPlacements()).empty());
    people.add(removed);
    update();
    QCOMPARE(listed(records.changedPlacements()), (Ranges{{698, 2}}));
    QCOMPARE(listed(records.changedAppearances()), (Ranges{{698, 2}}));
}

void TestCrowdPlan::olderPopulationIsNoticed()
{
    const model::Population before = makeRow(600);
    model::Population after = before;
    const std::array<model::IndividualId, 1> moved{1};
    const glm::vec3 place(5.0F, 0.0F, 5.0F);
    after.setValues(model::columns::position, moved, std::span(&place, 1));
    const std::vector<model::TemplateEntry> entries{entryFor(m_man)};
    std::vector<render::RecordTemplate> templates(1);
    templates[0].clipOfName.push_back(&m_man->clips[0]);
    render::StaticRecords records;
    records.update({*frameOf(after, entries), templates, {}, 1, 1});
    QVERIFY(records.placements()[0].position == place);
    records.update({*frameOf(before, entries), templates, {}, 1, 1});
    QCOMPARE(listed(records.changedPlacements()), (std::vector<render::RowRange>{{0, 1}}));
    QVERIFY(records.placements()[0].position == glm::vec3(0.0F));
}

CROWD_TEST(TestCrowdPlan)
#include "tst_CrowdPlan.moc"
