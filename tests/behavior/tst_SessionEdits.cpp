// SPDX-License-Identifier: MIT
#include <QtTest/QTest>

#include "tests/behavior/RuleScenes.h"
#include "tests/program/Test.h"

using namespace crowd;
using namespace crowd::testing;

namespace {

/// Like an actor, but its clips stand in another order.
model::TemplateEntry mirroredActor(model::TemplateId id)
{
    model::TemplateEntry entry = actorTemplate();
    auto asset = std::make_shared<model::Template>(*entry.asset);
    std::ranges::reverse(asset->clips);
    asset->defaultClip = static_cast<int>(asset->clips.size()) - 1;
    asset->seatedClip = static_cast<int>(asset->clips.size()) - 1 - 4;
    std::ranges::reverse(entry.clipNames);
    entry.id = id;
    entry.name = "mirrored";
    entry.asset = asset;
    return entry;
}

/// Name of the clip that somebody shows.
std::string clipNameOf(const Session& session, const model::Scene& scene, std::size_t row)
{
    const model::TemplateEntry* entry =
        scene.findTemplate(session.frame()->population.column(model::columns::templateId)[row]);
    return entry->clipNames.at(clipOf(session, row));
}

bool walks(const Session& session, const model::Scene& scene, std::size_t row)
{
    const std::string clip = clipNameOf(session, scene, row);
    return clip == "walk" || clip == "stroll"; // as fast as each is
}

/// Two actors of template 1, an unused 2, and 3 and 4 with their clips in another order.
model::Scene mixedScene()
{
    model::Scene scene = rowOf(4);
    scene.templates.push_back(actorTemplate());
    scene.templates.back().id = 2;
    scene.templates.push_back(mirroredActor(3));
    const std::vector<model::IndividualId> others{3, 4};
    scene.population.setValues<model::TemplateId>(model::columns::templateId, others,
                                                  std::vector<model::TemplateId>{3, 3});
    scene.population.setValues<std::uint16_t>(model::columns::clip, others,
                                              std::vector<std::uint16_t>{7, 7}); // idle
    scene.places = {{1, "far", {0.0F, 0.0F, 60.0F}, 0.2F}};
    scene.paths = {{1, "way", model::PathKind::Simple, {1}}};
    letWalk(scene, 1);
    return scene;
}

} // namespace

/// Templates that come and go while a session runs.
class TestSessionEdits : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void whoseTemplateStaysKeepsHisClips_data();
    void whoseTemplateStaysKeepsHisClips();
    void whoseTemplateIsReadAnewGoesOn();
};

void TestSessionEdits::whoseTemplateStaysKeepsHisClips_data()
{
    QTest::addColumn<bool>("isAdded");
    QTest::newRow("an unused one is removed below") << false;
    QTest::newRow("one is added below") << true;
}

void TestSessionEdits::whoseTemplateStaysKeepsHisClips()
{
    QFETCH(const bool, isAdded);
    model::Scene scene = mixedScene();
    Session session(scene);
    run(session, 60);
    for (std::size_t row = 0; row < 4; ++row) {
        QVERIFY2(walks(session, scene, row), clipNameOf(session, scene, row).c_str());
    }
    if (isAdded) {
        model::TemplateEntry other = actorTemplate();
        other.id = 9;
        scene.templates.insert(scene.templates.begin(), other);
    } else {
        scene.templates.erase(scene.templates.begin() + 1);
    }
    const glm::vec3 before = placeOf(session, 3);
    session.adopt(scene);
    run(session, 30);
    for (std::size_t row = 0; row < 4; ++row) {
        QVERIFY2(walks(session, scene, row), clipNameOf(session, scene, row).c_str());
    }
    QVERIFY(placeOf(session, 3).z > before.z + 0.4F);
}

void TestSessionEdits::whoseTemplateIsReadAnewGoesOn()
{
    model::Scene scene = mixedScene();
    Session session(scene);
    run(session, 60);
    scene.templates[0] = mirroredActor(1);
    session.adopt(scene);
    run(session, 30);
    QVERIFY2(walks(session, scene, 0), clipNameOf(session, scene, 0).c_str());
    QVERIFY2(walks(session, scene, 3), clipNameOf(session, scene, 3).c_str());
}

CROWD_TEST(TestSessionEdits)
#include "tst_SessionEdits.moc"
