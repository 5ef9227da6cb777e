// SPDX-License-Identifier: MIT
#include <map>
#include <random>
#include <tuple>

#include "model/brush/IndividualEdits.h"
#include "model/features/FeatureWriting.h"
#include "model/project/EnvironmentText.h"
#include "model/project/ProjectReader.h"
#include "model/relations/RelatedPeople.h"
#include "tests/model/LivelyBrush.h"
#include "tests/model/ProjectText.h"
#include "tests/program/Test.h"

using namespace crowd::test;
using crowd::testing::projectText;

namespace {

constexpr RelationKindId kFamily = 1;
constexpr RelationKindId kFriends = 2;
constexpr RelationKindId kLeader = 4;

struct RelationScene : LivelyScene
{
    RelationScene()
    {
        Scene scene = document.scene();
        for (TemplateEntry& entry : scene.templates) {
            entry.path = "/nowhere/" + entry.name + ".glb"; // so that it can be saved
        }
        document.replaceScene(std::move(scene), {});
        ids = addCrowd();
    }

    [[nodiscard]] const RelationTable& table() const { return document.scene().relations; }
    void relate(const std::vector<Relation>& relations)
    {
        document.edit(QStringLiteral("Relate"), [&](SceneEdit& edit) { edit.relate(relations); });
    }
    [[nodiscard]] glm::dvec2 pixelOf(IndividualId id) const
    {
        const glm::vec3 at = people().column(columns::position)[people().rowOf(id)];
        return glm::dvec2(*fromAbove().project(at + glm::vec3(0.0F, 1.0F, 0.0F)));
    }
    StrokeOutcome paintAll(BrushSettings settings)
    {
        settings.selection = BrushSelection::Rectangle;
        settings.through = true;
        return paint(fromAbove(), settings, {{0, 0}, {1279, 767}});
    }

    Ids ids;
};

BrushSettings relationBrush(RelationHow how, const char* name = "friends")
{
    BrushSettings settings = brush(BrushKind::Relation, BrushSelection::AllInCircle);
    settings.radiusPixels = 12.0F;
    settings.through = true;
    settings.as<RelationSettings>().relation = name;
    settings.as<RelationSettings>().how = how;
    return settings;
}

/// What a table must be, slowly.
using Known = std::map<std::tuple<IndividualId, RelationKindId, IndividualId>, float>;

std::vector<Relation> listed(const Known& known)
{
    std::vector<Relation> all;
    for (const auto& [key, strength] : known) {
        all.push_back({std::get<0>(key), std::get<2>(key), strength, std::get<1>(key)});
    }
    return all;
}

QString problemOf(const QString& relations)
{
    const std::string text =
        R"({"format": "crowdbrush-scene", "version": 1, "templates": [{"id": 1, "name": "m",)"
        R"("path": "/nowhere.glb"}], "relations": )" +
        relations.toStdString() +
        R"(, "individuals": {"columns": ["id","template","position"], "rows": [)"
        R"([1,1,[0,0,0]],[2,1,[1,0,0]],[3,1,[2,0,0]]]}})";
    const auto read = projectFromText(text);
    if (!read) {
        return QString::fromStdString(read.error().message);
    }
    QString warnings = QStringLiteral("%1 left;").arg(read.value().relations.count());
    for (const Message& warning : read.value().readWarnings) {
        warnings += QStringLiteral(" ") + QString::fromStdString(warning.english());
    }
    return warnings;
}

} // namespace

class tst_Relations : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aTableIsWhatWasPut()
    {
        std::mt19937 random(3);
        std::uniform_int_distribution<IndividualId> anybody(1, 200);
        Known known;
        RelationTable table;
        for (int round = 0; round < 60; ++round) {
            const RelationTable before = table;
            const std::vector<Relation> was = before.all();
            std::vector<Relation> batch;
            for (int i = 0; i < 40; ++i) {
                const IndividualId far = round % 7 == 0 ? 4'000'000'000U : 0U;
                batch.push_back({anybody(random) + far, anybody(random),
                                 static_cast<float>(random() % 100) / 100.0F,
                                 static_cast<RelationKindId>(1 + random() % 3)});
            }
            const bool isRemoval = round % 3 == 2;
            for (const Relation& each : batch) {
                const std::tuple key(each.from, each.kind, each.to);
                if (isRemoval) {
                    known.erase(key);
                } else if (each.from != each.to) {
                    known[key] = each.strength;
                }
            }
            isRemoval ? table.remove(batch) : table.put(batch);
            QCOMPARE(table.count(), known.size());
            QVERIFY(table.all() == listed(known));
            QVERIFY(before.all() == was); // copies share and keep
            RelationTable redone = before;
            redone.apply(table.since(before), false);
            QVERIFY(redone == table);
            redone.apply(table.since(before), true);
            QVERIFY(redone == before);
        }
        for (const Relation& each : table.all()) {
            QCOMPARE(table.find(each.from, each.to, each.kind)->strength, each.strength);
            const auto links = table.of(each.to);
            QVERIFY(std::ranges::any_of(links, [&each](const RelationLink& link) {
                return link.other == each.from && link.kind == each.kind && !link.isOut;
            }));
        }
        table.remove(table.all());
        QVERIFY(table.isEmpty());
        QVERIFY(table == RelationTable());
    }

    void mutualOnesAreOne()
    {
        RelationScene scene;
        scene.relate({{scene.ids[4], scene.ids[1], 0.5F, kFriends}});
        scene.relate({{scene.ids[1], scene.ids[4], 0.75F, kFriends},
                      {scene.ids[4], scene.ids[1], 1.0F, kLeader}});
        QCOMPARE(scene.table().count(), std::size_t{2});
        QCOMPARE(scene.table().find(scene.ids[1], scene.ids[4], kFriends)->strength, 0.75F);
        const Scene& now = scene.document.scene();
        QCOMPARE(relatedTo(now, Ids{scene.ids[1]}, kFriends), Ids{scene.ids[4]});
        QCOMPARE(relatedTo(now, Ids{scene.ids[1]}, kLeader), Ids());
        QCOMPARE(relatedTo(now, Ids{scene.ids[4]}, kLeader), Ids{scene.ids[1]});
        QCOMPARE(withRelated(now, Ids{scene.ids[1]}, kLeader), (Ids{scene.ids[1], scene.ids[4]}));

        RelationKinds kinds = now.relationKinds;
        kinds[3].isMutual = true; // a leader of both ways
        scene.document.edit(QStringLiteral("Kinds"),
                            [&](SceneEdit& edit) { edit.setRelationKinds(kinds); });
        QVERIFY(scene.table().find(scene.ids[1], scene.ids[4], kLeader) != nullptr);
        QVERIFY(scene.table().find(scene.ids[4], scene.ids[1], kLeader) == nullptr);
        kinds.erase(kinds.begin() + 1);
        scene.document.edit(QStringLiteral("Kinds"),
                            [&](SceneEdit& edit) { edit.setRelationKinds(kinds); });
        QCOMPARE(scene.table().count(), std::size_t{1}); // of friends there are none
        scene.document.undoStack().undo();
        scene.document.undoStack().undo();
        QCOMPARE(scene.table().count(), std::size_t{2});
    }

    void whoGoesTakesHisRelationsAlong()
    {
        RelationScene scene;
        scene.relate({{scene.ids[0], scene.ids[1], 0.25F, kFriends},
                      {scene.ids[2], scene.ids[0], 1.0F, kLeader},
                      {scene.ids[1], scene.ids[2], 1.0F, kFamily}});
        const std::string before = projectText(scene.document.scene());
        scene.document.edit(QStringLiteral("Remove"),
                            [&](SceneEdit& edit) { edit.removeIndividuals(Ids{scene.ids[0]}); });
        QCOMPARE(scene.table().count(), std::size_t{1});
        scene.document.undoStack().undo();
        QVERIFY(projectText(scene.document.scene()) == before);
        scene.document.undoStack().redo();
        QCOMPARE(scene.table().count(), std::size_t{1});
    }

    void undoAndFilesKeepEverything()
    {
        RelationScene scene;
        std::mt19937 random(11);
        std::vector<std::string> texts{projectText(scene.document.scene())};
        for (int step = 0; step < 40; ++step) {
            const auto now = scene.people().ids();
            const Ids all(now.begin(), now.end());
            const auto any = [&] { return all[random() % all.size()]; };
            scene.document.edit(QStringLiteral("Step"), [&](SceneEdit& edit) {
                std::vector<Relation> some;
                for (int i = 0; i < 12; ++i) {
                    some.push_back({any(), any(), static_cast<float>(random() % 9) / 8.0F,
                                    static_cast<RelationKindId>(1 + random() % 5)});
                }
                switch (random() % 5) {
                case 0:
                    edit.unrelate(edit.scene().relations.all());
                    break;
                case 1:
                    edit.removeIndividuals(Ids{any()});
                    break;
                case 2:
                    (void)duplicate(edit, Ids{all[3], all[7]}, {1.0F, 0.0F, 0.0F});
                    break;
                default:
                    edit.relate(some);
                }
            });
            const std::string text = projectText(scene.document.scene());
            if (text != texts.back()) {
                texts.push_back(text);
            }
            const auto read = projectFromText(text);
            QVERIFY2(read.isOk(), text.substr(0, 300).c_str());
            QVERIFY(read.value().relations == scene.table());
            QVERIFY(read.value().readWarnings.empty());
            QVERIFY(projectText(read.value()) == text);
        }
        for (std::size_t i = texts.size() - 1; i > 0; --i) {
            scene.document.undoStack().undo();
            QVERIFY2(projectText(scene.document.scene()) == texts[i - 1],
                     QByteArray::number(static_cast<int>(i)).constData());
        }
        for (std::size_t i = 1; i < texts.size(); ++i) {
            scene.document.undoStack().redo();
            QVERIFY(projectText(scene.document.scene()) == texts[i]);
        }
    }

    void stepsGoToDiskAndBack()
    {
        UndoLimits limits;
        limits.bytes = 1;
        SceneDocument document(limits);
        Scene empty;
        empty.templates.push_back(boxManEntry(1, boxMan()));
        document.replaceScene(std::move(empty), {});
        Ids ids;
        document.edit(QStringLiteral("People"), [&](SceneEdit& edit) {
            IndividualRows rows = IndividualRows::withDefaults(std::vector<IndividualId>(500));
            std::ranges::fill(rows.column(columns::templateId), TemplateId{1});
            ids = edit.addIndividuals(std::move(rows));
        });
        std::vector<Relation> ring;
        for (std::size_t i = 0; i < ids.size(); ++i) {
            ring.push_back({ids[i], ids[(i + 1) % ids.size()], 0.5F, kLeader});
        }
        document.edit(QStringLiteral("Ring"), [&](SceneEdit& edit) { edit.relate(ring); });
        document.edit(QStringLiteral("None"), [&](SceneEdit& edit) { edit.unrelate(ring); });
        document.edit(QStringLiteral("Name"), [](SceneEdit& edit) {
            edit.setCues({{1, "Go", "go", 0.0F, {}}});
        });
        QVERIFY(document.undoMemory().bytesOnDisk() > ring.size() * sizeof(Relation));
        document.undoStack().undo();
        document.undoStack().undo();
        QCOMPARE(document.scene().relations.count(), ring.size());
        document.undoStack().undo();
        QVERIFY(document.scene().relations.isEmpty());
        document.undoStack().redo();
        QCOMPARE(document.scene().relations.count(), ring.size());
    }

    void copiesOfAFamilyAreOne()
    {
        RelationScene scene;
        const Ids family{scene.ids[2], scene.ids[3], scene.ids[5]};
        scene.relate({{family[0], family[1], 0.5F, kFamily},
                      {family[2], family[1], 0.25F, kLeader},
                      {family[0], scene.ids[9], 1.0F, kFriends}}); // who is not copied
        Ids copies;
        scene.document.edit(QStringLiteral("Copy"), [&](SceneEdit& edit) {
            copies = duplicate(edit, family, {0.0F, 0.0F, 2.0F});
        });
        QCOMPARE(scene.table().count(), std::size_t{5});
        QCOMPARE(scene.table().find(copies[0], copies[1], kFamily)->strength, 0.5F);
        QCOMPARE(scene.table().find(copies[2], copies[1], kLeader)->strength, 0.25F);
        const auto positions = scene.people().column(columns::position);
        QCOMPARE(positions[scene.people().rowOf(copies[1])] -
                     positions[scene.people().rowOf(family[1])],
                 glm::vec3(0.0F, 0.0F, 2.0F));
    }

    void copiesOfWhoSitsSitToo()
    {
        RelationScene scene;
        Scene theatre = scene.document.scene();
        theatre.stages = {stageOf({}, seatRows(1, 4))};
        const auto seats = theatre.worldSeats();
        QCOMPARE(seats.size(), std::size_t{4});
        scene.document.replaceScene(std::move(theatre), {});
        const Ids two{scene.ids[2], scene.ids[3]};
        scene.document.edit(QStringLiteral("Sit"), [&](SceneEdit& edit) {
            QCOMPARE(sitDown(edit, two[0], seats[0].id), SitResult::Done);
            QCOMPARE(sitDown(edit, two[1], seats[1].id), SitResult::Done);
        });
        Ids copies;
        const auto copy = [&] {
            scene.document.edit(QStringLiteral("Copy"), [&](SceneEdit& edit) {
                copies = duplicate(edit, two, {0.5F, 0.0F, 0.0F});
            });
        };
        const auto seatOf = [&](IndividualId id) {
            return scene.people().column(columns::seat)[scene.people().rowOf(id)];
        };
        copy();
        QVERIFY(seatOf(copies[0]) != seatOf(copies[1]));
        for (const IndividualId id : copies) {
            QVERIFY(seatOf(id) == seats[2].id || seatOf(id) == seats[3].id);
        }
        copy(); // all are taken
        QVERIFY(seatOf(copies[0]) == kNoSeat && seatOf(copies[1]) == kNoSeat);
        QCOMPARE(seatOf(two[0]), seats[0].id);
    }

    void aDragRelatesWhereItBeganToWhereItEnds()
    {
        RelationScene scene;
        const auto& ids = scene.ids;
        const auto outcome =
            scene.paint(fromAbove(), relationBrush(RelationHow::FromTo),
                        {scene.pixelOf(ids[0]), scene.pixelOf(ids[3]), scene.pixelOf(ids[25])});
        QVERIFY2(outcome.isCommitted, qPrintable(outcome.message));
        QCOMPARE(outcome.affected, 2);
        QVERIFY(scene.table().all() == (std::vector<Relation>{{ids[0], ids[25], 1.0F, kFriends}}));
        QCOMPARE(scene.document.undoStack().undoText(),
                 QStringLiteral("Change relations of 2 character(s)"));

        BrushSettings erasing = relationBrush(RelationHow::Near);
        erasing.as<RelationSettings>().erases = true;
        QVERIFY(scene.paint(fromAbove(), erasing, {scene.pixelOf(ids[25])}).isCommitted);
        QVERIFY(scene.table().isEmpty());
        QCOMPARE(scene.paint(fromAbove(), erasing, {scene.pixelOf(ids[25])}).reason,
                 StrokeReason::NothingToErase);
        QCOMPARE(
            scene.paint(fromAbove(), relationBrush(RelationHow::FromTo), {scene.pixelOf(ids[25])})
                .reason,
            StrokeReason::NobodyElse);
        QCOMPARE(scene
                     .paint(fromAbove(), relationBrush(RelationHow::FromTo, "enemies"),
                            {scene.pixelOf(ids[25])})
                     .reason,
                 StrokeReason::NoSuchRelation);
    }

    void aDragErasesWhatIsBetweenTheTwo()
    {
        RelationScene scene;
        const auto& ids = scene.ids;
        BrushSettings brush = relationBrush(RelationHow::FromTo);
        const auto drag = [&](std::size_t from, std::size_t to) {
            return scene.paint(
                fromAbove(), brush,
                {scene.pixelOf(ids[from]), scene.pixelOf(ids[12]), scene.pixelOf(ids[to])});
        };
        QVERIFY(drag(0, 25).isCommitted);
        QVERIFY(drag(25, 3).isCommitted);
        QVERIFY(drag(0, 7).isCommitted);
        brush.as<RelationSettings>().erases = true;
        QCOMPARE(drag(3, 0).reason, StrokeReason::NothingToErase); // nothing between these
        QVERIFY(drag(25, 0).isCommitted);                          // either way round
        QVERIFY(scene.table().find(ids[0], ids[25], kFriends) == nullptr);
        QCOMPARE(scene.table().all().size(), std::size_t{2});
        scene.document.undoStack().undo();
        QCOMPARE(scene.table().all().size(), std::size_t{3});
        // A click: all of somebody.
        QVERIFY(scene.paint(fromAbove(), brush, {scene.pixelOf(ids[25])}).isCommitted);
        QCOMPARE(scene.table().all().size(), std::size_t{1});
    }

    void aDragFromOrToNobodyRelatesNobody()
    {
        RelationScene scene;
        const auto& ids = scene.ids;
        const glm::vec2 nowhere(3.0F, 3.0F);
        const BrushSettings brush = relationBrush(RelationHow::FromTo);
        const auto away = scene.paint(fromAbove(), brush,
                                      {scene.pixelOf(ids[0]), scene.pixelOf(ids[1]), nowhere});
        QVERIFY(!away.isCommitted);
        QCOMPARE(away.reason, StrokeReason::NobodyElse);
        const auto here = scene.paint(fromAbove(), brush,
                                      {nowhere, scene.pixelOf(ids[0]), scene.pixelOf(ids[1])});
        QVERIFY(!here.isCommitted);
        QCOMPARE(here.reason, StrokeReason::NobodyUnderBrush);
        QVERIFY(scene.table().isEmpty());
    }

    void aLassoSaysFromWhomAndTheNextToWhom()
    {
        RelationScene scene;
        BrushSettings settings = relationBrush(RelationHow::FromTo, "leader");
        settings.selection = BrushSelection::Rectangle;
        const glm::dvec2 first = scene.pixelOf(scene.ids[0]);
        const auto chosen =
            scene.paint(fromAbove(), settings, {first - glm::dvec2(8.0), first + glm::dvec2(8.0)});
        QCOMPARE(chosen.reason, StrokeReason::SourcesChosen);
        QVERIFY(!chosen.isCommitted);
        QCOMPARE(chosen.chosen, Ids{scene.ids[0]});
        settings.as<RelationSettings>().sources = {static_cast<int>(scene.ids[0])};
        QVERIFY(scene.paint(fromAbove(), settings, {{0, 0}, {1279, 767}}).isCommitted);
        QCOMPARE(scene.table().count(), scene.ids.size() - 1);
        QCOMPARE(relatedTo(scene.document.scene(), Ids{scene.ids[0]}, kLeader).size(),
                 scene.ids.size() - 1);
    }

    void aChainGoesFromOneToTheNext()
    {
        RelationScene scene;
        const auto& ids = scene.ids; // ten in a row
        QVERIFY(scene
                    .paint(fromAbove(), relationBrush(RelationHow::Chain, "leader"),
                           {scene.pixelOf(ids[0]), scene.pixelOf(ids[4])})
                    .isCommitted);
        QCOMPARE(scene.table().count(), std::size_t{4});
        for (std::size_t i = 0; i < 4; ++i) {
            QVERIFY(scene.table().find(ids[i], ids[i + 1], kLeader) != nullptr);
        }
    }

    void familiesAreSmallAndApart()
    {
        RelationScene scene;
        BrushSettings settings = relationBrush(RelationHow::Family, "family");
        settings.as<RelationSettings>().least = 2;
        settings.as<RelationSettings>().most = 4;
        settings.as<RelationSettings>().metres = 2.5F;
        QVERIFY(scene.paintAll(settings).isCommitted);
        int related = 0;
        const auto positions = scene.people().column(columns::position);
        for (const IndividualId id : scene.ids) {
            const Ids others = relatedTo(scene.document.scene(), Ids{id}, kFamily);
            QVERIFY(others.size() <= 3);
            related += others.empty() ? 0 : 1;
            for (const IndividualId other : others) { // who is of mine is of his
                QCOMPARE(relatedTo(scene.document.scene(), Ids{other}, kFamily).size(),
                         others.size());
                QVERIFY(glm::distance(positions[scene.people().rowOf(id)],
                                      positions[scene.people().rowOf(other)]) <= 5.0F);
            }
        }
        QVERIFY2(related > 50, QByteArray::number(related).constData());
        QCOMPARE(scene.paintAll(settings).isCommitted, false); // each has one already
    }

    void eachToSomeAroundAndToEach()
    {
        RelationScene scene;
        BrushSettings settings = relationBrush(RelationHow::Near);
        settings.as<RelationSettings>().count = 3;
        settings.as<RelationSettings>().metres = 1.6F;
        settings.as<RelationSettings>().strength = {0.25F, 0.5F};
        QVERIFY(scene.paintAll(settings).isCommitted);
        const auto positions = scene.people().column(columns::position);
        for (const Relation& each : scene.table().all()) {
            QVERIFY(each.strength >= 0.25F && each.strength <= 0.5F);
            QVERIFY(glm::distance(positions[scene.people().rowOf(each.from)],
                                  positions[scene.people().rowOf(each.to)]) <= 1.6F);
        }
        for (const IndividualId id : scene.ids) {
            QVERIFY(scene.table().of(id).size() >= 3);
        }
        scene.document.undoStack().undo();
        QVERIFY(scene.paintAll(relationBrush(RelationHow::Together)).isCommitted);
        QCOMPARE(scene.table().count(), scene.ids.size() * (scene.ids.size() - 1) / 2);
        QCOMPARE(scene.paintAll(relationBrush(RelationHow::Together)).reason,
                 StrokeReason::Unchanged);
    }

    void howMovesAreSplitChangesNothing_data()
    {
        QTest::addColumn<int>("how");
        QTest::newRow("from to") << static_cast<int>(RelationHow::FromTo);
        QTest::newRow("chain") << static_cast<int>(RelationHow::Chain);
        QTest::newRow("family") << static_cast<int>(RelationHow::Family);
        QTest::newRow("near") << static_cast<int>(RelationHow::Near);
        QTest::newRow("together") << static_cast<int>(RelationHow::Together);
    }

    void howMovesAreSplitChangesNothing()
    {
        QFETCH(int, how);
        BrushSettings settings = relationBrush(static_cast<RelationHow>(how), "leader");
        settings.radiusPixels = 40.0F;
        settings.as<RelationSettings>().strength = {0.0F, 1.0F};
        std::vector<glm::dvec2> fine;
        for (int i = 0; i <= 96; ++i) {
            fine.emplace_back(320.0 + 6.0 * i, 300.0);
        }
        RelationScene once;
        QVERIFY(once.paint(fromAbove(), settings, {fine.front(), fine.back()}).isCommitted);
        RelationScene often;
        QVERIFY(often.paint(fromAbove(), settings, fine).isCommitted);
        QVERIFY(once.table().count() > 0);
        QVERIFY(once.table() == often.table());
        // and laid again it is the same
        const RecordedStroke recording = often.recorded;
        often.document.undoStack().undo();
        QVERIFY(often.table().isEmpty());
        QVERIFY(replay(often.document, often.keyframes, often.rays, recording).isCommitted);
        QVERIFY(once.table() == often.table());
    }

    void whatIsPaintedOnOneIsShared()
    {
        RelationScene scene;
        const auto& ids = scene.ids;
        scene.relate({{ids[0], ids[30], 1.0F, kFamily}, {ids[0], ids[40], 1.0F, kFriends}});
        BrushSettings settings = brush(BrushKind::Feature, BrushSelection::AllInCircle);
        settings.radiusPixels = 12.0F;
        settings.as<FeatureSettings>().values = {{"sad", 1.0F}};
        const auto outcome = scene.paint(fromAbove(), settings, {scene.pixelOf(ids[0])});
        QCOMPARE(outcome.affected, 2);
        const FeatureKind& emotion = *findKind(scene.document.scene().features, "emotion");
        const auto borne = scene.people().column(columns::feature(emotion.id));
        const auto valueOf = [&](IndividualId id) { return borne[scene.people().rowOf(id)]; };
        QCOMPARE(valueOf(ids[30]), emotion.find("sad")->id); // family shares, friends do not
        QCOMPARE(valueOf(ids[40]), FeatureId{0});

        RelationKinds kinds = scene.document.scene().relationKinds;
        kinds[1].sharesColors = true;
        scene.document.edit(QStringLiteral("Kinds"),
                            [&](SceneEdit& edit) { edit.setRelationKinds(kinds); });
        BrushSettings colour = colourBrush(BrushSelection::AllInCircle);
        colour.radiusPixels = 12.0F;
        colour.op = BrushOperator::Random;
        QCOMPARE(scene.paint(fromAbove(), colour, {scene.pixelOf(ids[0])}).affected, 2);
        const auto slotOf = [&](IndividualId id, const std::string& name) {
            const auto row = scene.people().rowOf(id);
            const auto& entry = *scene.document.scene().findTemplate(
                scene.people().column(columns::templateId)[row]);
            const auto slot = std::ranges::find(entry.asset->slots, name, &Slot::name);
            return tintOf(scene, id, static_cast<int>(slot - entry.asset->slots.begin()));
        };
        const std::string top = scene.document.scene().templates[0].asset->slots[0].name;
        QVERIFY(slotOf(ids[40], top) == slotOf(ids[0], top));
        kinds[1].sharesColors = false;
        scene.document.edit(QStringLiteral("Kinds"),
                            [&](SceneEdit& edit) { edit.setRelationKinds(kinds); });
        QCOMPARE(scene.paint(fromAbove(), colour, {scene.pixelOf(ids[0])}, 8).affected, 1);
    }

    void scriptsSetKinds()
    {
        Scene scene;
        const std::string text = environmentText(scene);
        QVERIFY(text.find("\"relationKinds\"") != std::string::npos);
        QVERIFY(readEnvironmentText(
                    R"({"relationKinds": [{"id": 9, "name": "team", "mutual": false}]})", scene)
                    .isOk());
        QCOMPARE(scene.relationKinds.size(), std::size_t{1});
        QCOMPARE(scene.relationKinds.front().isMutual, false);
        QVERIFY(!readEnvironmentText(R"({"relationKinds": [{"id": 65, "name": "x"}]})", scene));
        QVERIFY(!readEnvironmentText(R"({"relationKinds": [{"id": 1, "name": ""}]})", scene));
        QVERIFY(!readEnvironmentText(
            R"({"relationKinds": [{"id": 1, "name": "x"}, {"id": 2, "name": "x"}]})", scene));
    }

    void oddFilesAreSaidAndNothingCrashes_data()
    {
        QTest::addColumn<QString>("relations");
        QTest::addColumn<QString>("said");
        const auto table = [](const char* rows) {
            return QStringLiteral(R"({"columns": ["from","to","kind","strength"], "rows": [%1]})")
                .arg(QLatin1String(rows));
        };
        QTest::newRow("none") << table("") << "0 left;";
        QTest::newRow("sound") << table("[1,2,1,0.5],[2,3,4,1]") << "2 left;";
        QTest::newRow("nobody") << table("[1,9,1,1],[1,2,1,1]") << "1 left; 1 relations";
        QTest::newRow("no kind") << table("[1,2,60,1]") << "0 left; 1 relations";
        QTest::newRow("oneself") << table("[2,2,1,1]") << "0 left; 1 relations";
        QTest::newRow("twice") << table("[1,2,2,1],[2,1,2,0.5]") << "1 left; 1 relations stood";
        QTest::newRow("circle") << table("[1,2,4,1],[2,3,4,1],[3,1,4,1]") << "3 left;";
        QTest::newRow("strong") << table("[1,2,1,1e30]") << "column \"strength\"";
        QTest::newRow("negative") << table("[1,2,1,-0.1]") << "column \"strength\"";
        QTest::newRow("text") << table("[1,2,1,\"NaN\"]") << "column \"strength\"";
        QTest::newRow("kind 0") << table("[1,2,0,1]") << "column \"kind\"";
        QTest::newRow("kind 65") << table("[1,2,65,1]") << "column \"kind\"";
        QTest::newRow("large id") << table("[1,4294967296,1,1]") << "column \"to\"";
        QTest::newRow("fraction") << table("[1.5,2,1,1]") << "column \"from\"";
        QTest::newRow("short") << table("[1,2,1]") << "must have 4 values";
        QTest::newRow("long") << table("[1,2,1,1,1]") << "must have 4 values";
        QTest::newRow("nested") << table("[1,[2],1,1]") << "column \"to\"";
        QTest::newRow("object") << table("{}") << "must be a list";
        QTest::newRow("number") << table("7") << "must be a list";
        QTest::newRow("no columns") << R"({"rows": [[1,2,1,1]]})"
                                    << "relations.columns";
        QTest::newRow("others") << R"({"columns": ["a"], "rows": []})"
                                << "relations.columns";
        QTest::newRow("list") << "[]"
                              << "relations must be an object";
        QTest::newRow("cut") << R"({"columns": ["from","to","kind","strength"], "rows": [[1,2)"
                             << "damaged";
    }

    void oddFilesAreSaidAndNothingCrashes()
    {
        QFETCH(QString, relations);
        QFETCH(QString, said);
        const QString problem = problemOf(relations);
        QVERIFY2(problem.contains(said), qPrintable(problem));
    }
};

CROWD_TEST(tst_Relations)
#include "tst_Relations.moc"
