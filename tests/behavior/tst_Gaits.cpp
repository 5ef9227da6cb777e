// SPDX-License-Identifier: MIT
#include <set>

#include <QtTest/QTest>

#include "behavior/motion/GaitTable.h"
#include "behavior/session/Session.h"
#include "model/project/SceneAssets.h"
#include "tests/program/Test.h"

using namespace crowd;
using behavior::GaitTable;
using behavior::Session;
using model::ClipRole;

/// With which clips people move: those that are for it, at the speed that is usual for them.
class GaitsTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void onlyGaitsAreChosenBySpeed();
    void whoeverHasNoGaitDoesNotBorrowOne();
    void runsAreFasterThanWalks();
    void whatFliesKeepsItsPace();
    void withNothingToStandWithAWalkStandsStill();
    void peopleWalkAtTheirUsualSpeed_data();
    void peopleWalkAtTheirUsualSpeed();
};

namespace {

struct ClipOf
{
    const char* name;
    float speed;
    ClipRole role;
};

model::TemplateEntry entryOf(std::initializer_list<ClipOf> clips, int standing = 0)
{
    auto asset = std::make_shared<model::Template>();
    model::TemplateEntry entry;
    for (const ClipOf& each : clips) {
        model::Clip clip;
        clip.name = each.name;
        clip.seconds = 1.0F;
        clip.speed = each.speed;
        clip.role = each.role;
        asset->clips.push_back(clip);
        entry.clipNames.emplace_back(each.name);
    }
    asset->defaultClip = standing;
    asset->height = 1.8F;
    entry.asset = asset;
    return entry;
}

/// Clips that are played while the speed rises from 0 to 12 m/s and falls again.
std::set<int> clipsAtAnySpeed(const GaitTable& table)
{
    std::set<int> clips;
    std::size_t gait = 0;
    for (int i = 0; i <= 240; ++i) {
        const int tenths = i <= 120 ? i : 240 - i;
        gait = table.choose(gait, 0.1F * static_cast<float>(tenths));
        clips.insert(table.gait(gait).clip);
    }
    return clips;
}

} // namespace

void GaitsTest::onlyGaitsAreChosenBySpeed()
{
    const GaitTable table(entryOf({{"idle", 0.0F, ClipRole::Idle},
                                   {"back", 0.7F, ClipRole::Other},
                                   {"walk", 0.8F, ClipRole::Walk},
                                   {"attack", 1.7F, ClipRole::Other},
                                   {"run", 3.0F, ClipRole::Run},
                                   {"leap", 6.0F, ClipRole::Other}}));
    QCOMPARE(clipsAtAnySpeed(table), (std::set<int>{0, 2, 4}));
    // Whoever is asked to go backwards does.
    const std::size_t back = table.gaitOf(1);
    QVERIFY(back != 0);
    QCOMPARE(table.gait(table.choose(0, 1.0F, back)).clip, std::uint16_t{1});
    QCOMPARE(table.gait(table.choose(back, 3.0F)).clip, std::uint16_t{4});
    QVERIFY(!table.isMover(1) && table.isMover(2));
}

void GaitsTest::whoeverHasNoGaitDoesNotBorrowOne()
{
    const GaitTable table(
        entryOf({{"idle", 0.0F, ClipRole::Idle}, {"attack", 1.7F, ClipRole::Other}}));
    QCOMPARE(clipsAtAnySpeed(table), (std::set<int>{0}));
}

void GaitsTest::runsAreFasterThanWalks()
{
    const GaitTable table(entryOf({{"idle", 0.0F, ClipRole::Idle},
                                   {"run", 1.5F, ClipRole::Run},
                                   {"walk", 2.0F, ClipRole::Walk},
                                   {"walk_too", 2.05F, ClipRole::Walk}}));
    QCOMPARE(clipsAtAnySpeed(table), (std::set<int>{0, 2}));
}

void GaitsTest::whatFliesKeepsItsPace()
{
    const GaitTable table(entryOf({{"fly", 12.0F, ClipRole::Fly}}));
    QVERIFY(!table.isEmpty());
    const std::size_t gait = table.choose(0, 2.0F);
    QCOMPARE(GaitTable::playback(table.gait(gait), 2.0F, 1.0F), 1.0F);
    QCOMPARE(GaitTable::playback(table.gait(0), 0.0F, 1.0F), 1.0F); // and while it hovers
}

void GaitsTest::withNothingToStandWithAWalkStandsStill()
{
    const GaitTable table(entryOf({{"animation_0", 0.9F, ClipRole::Walk}}));
    QVERIFY(!table.isEmpty());
    QCOMPARE(GaitTable::playback(table.gait(0), 0.0F, 1.0F), 0.0F);
    QCOMPARE(GaitTable::playback(table.gait(table.choose(0, 0.9F)), 0.9F, 1.0F), 1.0F);
}

void GaitsTest::peopleWalkAtTheirUsualSpeed_data()
{
    QTest::addColumn<QString>("file");
    for (const char* file : {"man", "old_woman", "horse", "dog"}) {
        QTest::newRow(file) << QString::fromUtf8(file);
    }
}

void GaitsTest::peopleWalkAtTheirUsualSpeed()
{
    QFETCH(const QString, file);
    model::Scene scene;
    model::TemplateEntry entry;
    entry.id = 1;
    entry.path = "builtin:templates/" + file.toStdString() + ".glb";
    const auto asset = model::loadTemplateAsset(entry);
    QVERIFY2(asset.isOk(), asset ? "" : asset.error().message.c_str());
    model::attachAsset(entry, asset.value());
    scene.templates.push_back(entry);
    scene.places = {{.id = 1, .name = "end", .position = {0.0F, 0.0F, 60.0F}, .radius = 1.0F}};
    scene.paths = {{.id = 1, .name = "way", .places = {1}}};
    auto rows = model::IndividualRows::withDefaults({1});
    rows.column(model::columns::templateId)[0] = 1;
    rows.column(model::columns::path)[0] = 1;
    scene.population.add(rows);
    Session session(scene);
    const int walk = asset.value()->clipIndex("walk");
    const float speed = asset.value()->clips[static_cast<std::size_t>(walk)].speed;
    for (int step = 0; step < 150; ++step) {
        session.step();
    }
    const float before = session.pose()->z.front();
    for (int step = 0; step < 60; ++step) {
        session.step();
        // Any of its walks, but it does not run.
        const std::size_t shown = session.pose()->clips.front();
        QCOMPARE(asset.value()->clips[shown].role, ClipRole::Walk);
    }
    const float measured = (session.pose()->z.front() - before) / 2.0F;
    QVERIFY2(measured > 0.8F * speed && measured < 1.2F * speed,
             qPrintable(QString::number(measured)));
}

CROWD_TEST(GaitsTest)
#include "tst_Gaits.moc"
