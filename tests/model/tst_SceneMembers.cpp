// SPDX-License-Identifier: MIT
#include "model/scene/SceneMembers.h"

#include <limits>

#include <QtTest/QTest>

#include "model/document/EditRecord.h"
#include "model/document/MemberEntries.h"
#include "model/document/SceneEdit.h"
#include "model/project/MemberJson.h"
#include "model/project/ProjectReader.h"
#include "model/states/StateKeeping.h"
#include "tests/model/ProjectText.h"
#include "tests/program/Test.h"

using namespace crowd::model;
using crowd::testing::projectText;

namespace {

// Another value of each member: the compiler asks for that of a new one.
void alter(members::Templates, SceneEdit& edit)
{
    TemplateEntry entry;
    entry.path = "/somewhere/man.glb";
    (void)edit.addTemplate(entry);
}
void alter(members::Stages, SceneEdit& edit)
{
    StageEntry entry;
    entry.path = "/somewhere/hill.glb";
    (void)edit.addStage(entry);
}
void alter(members::Places, SceneEdit& edit)
{
    (void)edit.addPlace({0, "well", {1.0F, 2.0F, 3.0F}});
}
void alter(members::Paths, SceneEdit& edit)
{
    (void)edit.addPath({0, "lane", PathKind::Cyclic, {}});
}
void alter(members::Groups, SceneEdit& edit)
{
    Group group;
    group.id = 2;
    group.name = "left stand";
    edit.set<members::Groups>({group});
}
void alter(members::Cameras, SceneEdit& edit)
{
    edit.set<members::Cameras>({NamedCamera{"Front", Camera{}}});
}
void alter(members::Light, SceneEdit& edit)
{
    Lighting light;
    light.sunStrength = 2.5F;
    edit.set<members::Light>(light);
}
void alter(members::Lights, SceneEdit& edit)
{
    Light light;
    light.id = 4;
    light.name = "Left";
    light.softness = 0.7F;
    edit.set<members::Lights>({light});
}
void alter(members::Looks, SceneEdit& edit)
{
    LookPreset look;
    look.id = 2;
    look.name = "Evening";
    look.light = LookLight::Dusk;
    edit.setLooks({look});
}
void alter(members::Tags, SceneEdit& edit)
{
    edit.set<members::Tags>({{3, "brave", {9, 8, 7}}});
}
void alter(members::Rules, SceneEdit& edit)
{
    Rule rule;
    rule.id = 1;
    rule.name = "clap";
    edit.set<members::Rules>({rule});
}
void alter(members::Numbers, SceneEdit& edit)
{
    edit.set<members::Numbers>({{1, "patience"}});
}
void alter(members::Cues, SceneEdit& edit)
{
    edit.set<members::Cues>({{3, "Go", "go", 2.5F, "F7"}});
}
void alter(members::Steps, SceneEdit& edit)
{
    edit.set<members::Steps>(120);
}
void alter(members::Surface, SceneEdit& edit)
{
    SurfaceSettings surface;
    surface.climb = 0.1F;
    edit.set<members::Surface>(surface);
}

void alter(members::Timeline, SceneEdit& edit)
{
    Mark mark;
    mark.id = 5;
    mark.seconds = 12.5;
    mark.kind = MarkKind::Event;
    mark.event = "wave";
    mark.people = {1, 4};
    edit.set<members::Timeline>({mark});
}

void alter(members::Range, SceneEdit& edit)
{
    edit.set<members::Range>({.begin = 2.0, .end = 7.5, .isLoop = true});
}

void alter(members::Features, SceneEdit& edit)
{
    FeatureKind kind;
    kind.id = 3;
    kind.name = "team";
    edit.set<members::Features>({kind});
}

void alter(members::RelationKinds, SceneEdit& edit)
{
    RelationKind kind;
    kind.id = 7;
    kind.name = "neighbours";
    edit.setRelationKinds({kind});
}

void alter(members::Relations, SceneEdit& edit)
{
    TemplateEntry entry;
    entry.name = "man";
    entry.path = "/nowhere/man.glb";
    const TemplateId man = edit.addTemplate(entry);
    IndividualRows rows = IndividualRows::withDefaults({1, 2});
    std::ranges::fill(rows.column(columns::templateId), man);
    const auto ids = edit.addIndividuals(std::move(rows));
    edit.relate(std::vector<Relation>{{ids[0], ids[1], 0.5F, 4}});
}

void alter(members::Takes, SceneEdit& edit)
{
    Take take;
    take.id = 3;
    take.name = "Rehearsal";
    take.file = "0123.take";
    take.isShown = true;
    take.edits = {{HandEditKind::Aside, false, {3, 5}, 1.0, 2.0}};
    take.edits.front().aside = -2.0F;
    take.areEditsOn = false;
    edit.set<members::Takes>({take});
}

void alter(members::States, SceneEdit& edit)
{
    putState(edit, keepState(edit.scene(), "calm", usualStateColumns(), {}));
}

/// What a member of a scene may be made of, described by fields alone.
struct Lamp
{
    std::uint32_t id = 0;
    float strength = 1.0F;
    std::string colourName;
    std::string unknownMembers{};
    friend bool operator==(const Lamp&, const Lamp&) = default;

    static constexpr auto fields()
    {
        return std::tuple(field(&Lamp::id, {.key = "id", .high = 1000.0}),
                          field(&Lamp::strength, {.key = "strength", .high = 10.0}),
                          field(&Lamp::colourName, {.key = "colour"}));
    }
};

struct Lamps
{
    using Type = std::vector<Lamp>;
    static constexpr const char* key = "lamps";
    static inline Type all;
    static Type& of(const Scene&) { return all; }
};

} // namespace

class tst_SceneMembers : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void eachIsUndoneAndSaved()
    {
        forEachMember([]<class M>(const M& member) {
            SceneDocument document;
            const std::string before = projectText(document.scene());
            const auto edit = document.beginEdit().value();
            alter(member, *edit);
            QVERIFY(edit->commit(QStringLiteral("Alter")));
            const std::string after = projectText(document.scene());
            QVERIFY2(after != before, M::key);

            const auto read = projectFromText(after);
            QVERIFY2(read.isOk(), M::key);
            QVERIFY2(isSame(M::of(read.value()), M::of(document.scene())), M::key);

            document.undoStack().undo();
            QVERIFY2(projectText(document.scene()) == before, M::key);
            document.undoStack().redo();
            QVERIFY2(projectText(document.scene()) == after, M::key);
        });
    }

    void aDeltaNamesWhatChanged()
    {
        Scene scene;
        EditRecord record(scene.nextId);
        record.touch<members::Cues>(scene);
        record.touch<members::Light>(scene);
        scene.cues = {{1, "Go", "go", 0.0F, {}}};
        const SceneDelta delta = record.delta(scene);
        QVERIFY(delta.changedMembers().contains<members::Cues>());
        QVERIFY(!delta.changedMembers().contains<members::Light>()); // touched and left as it was
        QVERIFY(!delta.isEmpty());
    }

    void numbersAreComparedByTheirBits()
    {
        const float none = std::numeric_limits<float>::quiet_NaN();
        QVERIFY(isSame(Lamp{1, none, {}}, Lamp{1, none, {}}));
        QVERIFY(!isSame(Lamp{1, 0.0F, {}}, Lamp{1, -0.0F, {}}));
        QVERIFY(!isSame(Lamp{1, 1.0F, "red"}, Lamp{1, 1.0F, "blue"}));
        QVERIFY(bytesOf(Lamp{1, 1.0F, std::string(500, 'x')}) >= sizeof(Lamp) + 500);
    }

    void describedEntriesNeedNoFileOfTheirOwn()
    {
        const Scene scene;
        Lamps::all = {{1, 2.5F, "red"}, {7, 0.5F, "blue", "{\"beam\":3}"}};
        const Lamps::Type written = Lamps::all;
        nlohmann::json top;
        top[Lamps::key] = memberJson(Lamps(), scene);
        Lamps::all.clear();

        Message problem;
        JsonFields fields(top, "", problem);
        Scene read;
        readMember(Lamps(), fields, read, problem);
        QVERIFY2(problem.empty(), problem.english().c_str());
        QVERIFY(Lamps::all == written);

        top[Lamps::key][1]["strength"] = 11.0;
        readMember(Lamps(), fields, read, problem);
        QVERIFY2(problem.english().starts_with("lamps[1].strength"), problem.english().c_str());
    }
};

CROWD_TEST(tst_SceneMembers)
#include "tst_SceneMembers.moc"
