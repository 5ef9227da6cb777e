// SPDX-License-Identifier: MIT
#include <cmath>

#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>

#include "model/brush/ClipChoice.h"
#include "model/gltf/ClipNames.h"
#include "model/gltf/ClipRoles.h"
#include "model/gltf/GltfImport.h"
#include "model/project/ProjectFile.h"
#include "model/project/SceneAssets.h"
#include "tests/program/Test.h"

using namespace crowd::model;
using gltf::NamedUse;

/// What clips are for: proposed by name, way and speed, chosen by the artist, kept in projects.
class tst_ClipRoles : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void namesSayTheUse_data();
    void namesSayTheUse();
    void wordsOfAllNamesSayNothing();
    void nobodyWalksAnotherWay();
    void aVariantIsNoGaitBesideAPlainOne();
    void namelessGaitsAreThoseThatGetOn();
    void builtinPeopleHaveThem_data();
    void builtinPeopleHaveThem();
    void chosenOnesAreSavedAndCount();
    void aSpeedMakesAGaitInOldProjects();
};

namespace {

Template withClips(std::initializer_list<Clip> clips)
{
    Template asset;
    asset.height = 1.8F;
    asset.clips = clips;
    return asset;
}

Clip clipOf(const char* name, float speed = 0.0F, const glm::vec3& way = glm::vec3(0.0F))
{
    Clip clip;
    clip.name = name;
    clip.seconds = 1.0F;
    clip.speed = speed;
    clip.way = way;
    return clip;
}

std::vector<ClipRole> proposed(Template asset)
{
    gltf::proposeRoles(asset, gltf::usesOf(asset));
    std::vector<ClipRole> roles;
    for (const Clip& clip : asset.clips) {
        roles.push_back(clip.role);
    }
    return roles;
}

constexpr glm::vec3 kAhead(0.0F, 0.0F, 1.0F);

} // namespace

void tst_ClipRoles::namesSayTheUse_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("kind");
    QTest::addColumn<int>("role");
    const auto row = [](const char* name, NamedUse::Kind kind, ClipRole role) {
        QTest::newRow(name) << QString::fromUtf8(name) << static_cast<int>(kind)
                            << static_cast<int>(role);
    };
    using enum NamedUse::Kind;
    for (const char* name :
         {"walk", "Walking", "WALK", "walk_01", "Walk.001", "Armature|Walk", "walkcycle",
          "WalkForward", "Walk_Fwd_Loop", "Walking_A", "2_move", "walk_root.001", "Drive"}) {
        row(name, Plain, ClipRole::Walk);
    }
    for (const char* name : {"run", "Running_A", "RunFwd", "Armature|Sprint", "Gallop", "trot_2"}) {
        row(name, Plain, ClipRole::Run);
    }
    for (const char* name :
         {"jump", "WalkJump", "Gallop_Jump", "Attack", "Walking_Backwards", "run_shoot",
          "Running_Strafe_Left", "Idle_HitReact_Left", "idle_to_fight", "dash_root", "Walk_Stop",
          "TurnLeft", "Death_A", "Sit_Chair_Down", "sit_down"}) {
        row(name, Action, ClipRole::Other);
    }
    row("idle_2", Plain, ClipRole::Idle);
    row("Survey", Plain, ClipRole::Idle);
    row("Sit_Chair_Idle", Variant, ClipRole::Sit);
    row("Flying", Plain, ClipRole::Fly);
    row("Walk_Gun", Variant, ClipRole::Walk);
    row("Crawl", Weak, ClipRole::Walk);
    row("animation_0", Unknown, ClipRole::Other);
    row("Take 001", Unknown, ClipRole::Other);
    row("mixamo.com", Unknown, ClipRole::Other);
    row("", Unknown, ClipRole::Other);
}

void tst_ClipRoles::namesSayTheUse()
{
    QFETCH(const QString, name);
    const NamedUse use = gltf::namedUses({name.toStdString()}).front();
    QTEST(static_cast<int>(use.kind), "kind");
    QTEST(static_cast<int>(use.role), "role");
}

void tst_ClipRoles::wordsOfAllNamesSayNothing()
{
    const auto uses =
        gltf::namedUses({"FrogArmature|Frog_Attack", "FrogArmature|Frog_Walk", "Frog_Jump"});
    QCOMPARE(static_cast<int>(uses[1].kind), static_cast<int>(NamedUse::Kind::Plain));
    QVERIFY(uses[1].isOf(ClipRole::Walk));
}

void tst_ClipRoles::nobodyWalksAnotherWay()
{
    // The second variant walks backwards, whatever it is called.
    const std::vector<ClipRole> roles =
        proposed(withClips({clipOf("idle"), clipOf("Walking_A", 0.7F, kAhead),
                            clipOf("Walking_B", 0.7F, -kAhead), clipOf("Run", 3.0F, kAhead)}));
    QCOMPARE(roles, (std::vector<ClipRole>{ClipRole::Idle, ClipRole::Walk, ClipRole::Other,
                                           ClipRole::Run}));
}

void tst_ClipRoles::aVariantIsNoGaitBesideAPlainOne()
{
    QCOMPARE(proposed(withClips({clipOf("idle"), clipOf("walk_gun", 1.0F), clipOf("walk", 1.0F)})),
             (std::vector<ClipRole>{ClipRole::Idle, ClipRole::Other, ClipRole::Walk}));
    QCOMPARE(proposed(withClips({clipOf("idle"), clipOf("walk_gun", 1.0F)})),
             (std::vector<ClipRole>{ClipRole::Idle, ClipRole::Walk}));
}

void tst_ClipRoles::namelessGaitsAreThoseThatGetOn()
{
    // Where a name says what a gait is, no other clip becomes one by getting on.
    QCOMPARE(proposed(withClips({clipOf("idle"), clipOf("Walk", 1.0F), clipOf("Whirl", 2.0F)})),
             (std::vector<ClipRole>{ClipRole::Idle, ClipRole::Walk, ClipRole::Other}));
    QCOMPARE(proposed(withClips({clipOf("idle"), clipOf("Take 002", 1.0F), clipOf("Hit", 2.0F)})),
             (std::vector<ClipRole>{ClipRole::Idle, ClipRole::Walk, ClipRole::Other}));
}

void tst_ClipRoles::builtinPeopleHaveThem_data()
{
    QTest::addColumn<QString>("file");
    for (const char* file : {"man", "old_woman", "horse", "dog", "beetle"}) {
        QTest::newRow(file) << QString::fromUtf8(file);
    }
}

void tst_ClipRoles::builtinPeopleHaveThem()
{
    QFETCH(const QString, file);
    const Result<TemplatePtr> asset =
        importTemplate(QStringLiteral(CROWD_RESOURCES "/templates/%1.glb").arg(file).toStdString());
    QVERIFY2(asset.isOk(), asset ? "" : asset.error().message.c_str());
    for (const auto& [name, role] : {std::pair("idle", ClipRole::Idle),
                                     {"walk", ClipRole::Walk},
                                     {"run", ClipRole::Run},
                                     {"sit", ClipRole::Sit},
                                     {"clap", ClipRole::Other},
                                     {"sit_down", ClipRole::Other}}) {
        const int index = asset.value()->clipIndex(name);
        if (index >= 0) {
            const ClipRole found = asset.value()->clips[static_cast<std::size_t>(index)].role;
            QVERIFY2(found == role, name);
        }
    }
    TemplateEntry entry;
    attachAsset(entry, asset.value());
    const int walk = asset.value()->clipIndex("walk");
    QCOMPARE(usualWalkingSpeed(entry), asset.value()->clips[static_cast<std::size_t>(walk)].speed);
}

void tst_ClipRoles::chosenOnesAreSavedAndCount()
{
    Scene scene;
    TemplateEntry entry;
    entry.id = 1;
    entry.name = "man";
    entry.path = "builtin:templates/man.glb";
    const Result<TemplatePtr> asset = loadTemplateAsset(entry);
    QVERIFY(asset.isOk());
    const auto talk = static_cast<std::size_t>(asset.value()->clipIndex("talk"));
    const auto idle = static_cast<std::size_t>(asset.value()->clipIndex("idle"));
    const auto dance = static_cast<std::size_t>(asset.value()->clipIndex("dance"));
    entry.clipRoles.resize(dance + 1);
    entry.clipRoles[idle] = ClipRole::Other;
    entry.clipRoles[static_cast<std::size_t>(asset.value()->clipIndex("idle_2"))] = ClipRole::Other;
    entry.clipRoles[talk] = ClipRole::Idle;
    entry.clipRoles[dance] = ClipRole::Walk;
    attachAsset(entry, asset.value());
    scene.templates.push_back(entry);
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("roles.crowd"));
    QVERIFY(saveProject(scene, path).isOk());
    const Result<Scene> read = loadScene(path);
    QVERIFY2(read.isOk(), read ? "" : read.error().message.c_str());
    const TemplateEntry& again = read.value().templates.front();
    QCOMPARE(again.clipRoles, entry.clipRoles);
    QCOMPARE(clipRole(again, talk, talk), ClipRole::Idle);
    QCOMPARE(again.asset->defaultClip, static_cast<int>(talk));
    // A gait that shows no speed has the usual one.
    QVERIFY(movesOverGround(again, dance, dance));
    QCOMPARE(groundSpeed(again, dance, dance), usualSpeedOf(ClipRole::Walk, again.asset->height));
}

void tst_ClipRoles::aSpeedMakesAGaitInOldProjects()
{
    TemplateEntry entry;
    auto asset = std::make_shared<Template>(withClips({clipOf("idle"), clipOf("Whirl")}));
    entry.clipNames = {"idle", "Whirl"};
    entry.asset = asset;
    QCOMPARE(clipRole(entry, 1, 1), ClipRole::Other);
    entry.clipSpeeds = {NAN, 1.0F};
    QCOMPARE(clipRole(entry, 1, 1), ClipRole::Walk);
    entry.clipRoles = {std::nullopt, ClipRole::Other};
    QCOMPARE(clipRole(entry, 1, 1), ClipRole::Other);
}

CROWD_TEST(tst_ClipRoles)
#include "tst_ClipRoles.moc"
