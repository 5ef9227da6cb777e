// SPDX-License-Identifier: MIT
#include "model/states/StateKeeping.h"

#include <QtTest/QTest>

#include "model/base/Random.h"
#include "model/project/ProjectReader.h"
#include "model/states/StateDifference.h"
#include "tests/model/LivelyBrush.h"
#include "tests/model/ProjectText.h"
#include "tests/program/Test.h"

using namespace crowd::test;
using crowd::testing::projectText;

namespace {

struct StatesScene : LivelyScene
{
    StatesScene() : ids(savableCrowd()) {}

    /// Some on a path, and templates that files can name.
    Ids savableCrowd()
    {
        Scene scene = document.scene();
        for (TemplateEntry& entry : scene.templates) {
            entry.path = "builtin:templates/man.glb";
        }
        document.replaceScene(std::move(scene), {});
        const Ids all = addCrowd();
        put(columns::path, {all[0], all[1]}, kLivelyPath);
        return all;
    }

    State keep(const char* name, ColumnSet columns = usualStateColumns())
    {
        return keepOf(name, columns, ids);
    }
    State keepOf(const char* name, ColumnSet columns, const Ids& of)
    {
        document.edit(QStringLiteral("Keep"), [&](SceneEdit& edit) {
            putState(edit, keepState(edit.scene(), name, columns, of));
        });
        return *findState(document.scene(), name);
    }
    StateRecall recall(const State& state, const Ids* only = nullptr)
    {
        return recall(state, state.columns, only);
    }
    StateRecall recall(const State& state, ColumnSet columns, const Ids* only = nullptr)
    {
        StateRecall result;
        document.edit(QStringLiteral("Recall"),
                      [&](SceneEdit& edit) { result = recallState(edit, state, columns, only); });
        return result;
    }
    template<class T>
    void put(ColumnKey<T> key, const Ids& of, T value)
    {
        document.edit(QStringLiteral("Put"), [&](SceneEdit& edit) {
            edit.setColumn(key, of, std::span<const T>(&value, 1));
        });
    }
    /// Everybody else than they were.
    void stir()
    {
        put(columns::clip, ids, std::uint16_t{2});
        put(columns::phase, ids, 0.875F);
        put(columns::height, ids, 1.5F);
        put(columns::tint(1), ids, Tint{1, 2, 3, 4});
        put(columns::materialChoices, ids, MaterialChoices{});
        put(columns::parts, ids, std::uint32_t{2});
        put(columns::path, ids, PathId{0});
    }
    void change(TemplateEntry entry)
    {
        document.edit(QStringLiteral("Change"),
                      [&](SceneEdit& edit) { edit.changeTemplate(entry); });
    }
    template<class T>
    T valueOf(ColumnKey<T> key, std::size_t person)
    {
        return people().column(key)[people().rowOf(ids[person])];
    }

    Ids ids;
};

bool says(const StateRecall& recall, const char* part)
{
    return std::ranges::any_of(recall.notes, [part](const Message& note) {
        return note.english().find(part) != std::string::npos;
    });
}

Scene read(const std::string& text)
{
    auto scene = projectFromText(text);
    return scene ? std::move(scene).value() : Scene();
}

} // namespace

class tst_States : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void whatRunsIsNotCompared();
    void recallEqualsWhatWasKept();
    void whoAndWhereAreLeftOut();
    void someOfItForSomeOfThem();
    void whoIsGoneIsSkipped();
    void clipsSlotsAndPartsGoByName();
    void slotsOfMissingFilesAreWhatTheyWere();
    void whatIsGoneIsSaid();
    void seatsAreNotTakenFromOthers();
    void aStateOfThatNameIsReplaced();
    void undoTakesItBack();
    void filesKeepThem();
    void fourColumnsAreSmall();
    void filesAreRefusedWithThePlace_data();
    void filesAreRefusedWithThePlace();
};

/// How far somebody is in his clip, while clips run.
void tst_States::whatRunsIsNotCompared()
{
    StatesScene scene;
    const State calm = scene.keep("calm");
    scene.put(columns::phase, scene.ids, 0.875F);
    const auto all = differenceFrom(calm, scene.document.scene());
    QCOMPARE(all.aspects.size(), std::size_t{1});
    QVERIFY(all.aspects.front().aspect == PropertyAspect::Animation);
    const auto without = differenceFrom(calm, scene.document.scene(), {ColumnId::Phase});
    QVERIFY(without.aspects.empty() && without.ids.empty());
}

void tst_States::recallEqualsWhatWasKept()
{
    StatesScene scene;
    const Population before = scene.people();
    const State calm = scene.keep("calm");
    scene.stir();
    QVERIFY(!(scene.people() == before));
    const StateRecall recall = scene.recall(calm);
    QVERIFY(scene.people() == before);
    QCOMPARE(recall.changed.size(), scene.ids.size());
    QVERIFY(recall.notes.empty());
    const int steps = scene.document.undoStack().count();
    QVERIFY(scene.recall(calm).changed.empty());
    QCOMPARE(scene.document.undoStack().count(), steps); // nothing changed
}

void tst_States::whoAndWhereAreLeftOut()
{
    const ColumnSet usual = usualStateColumns();
    for (const ColumnId column : {ColumnId::Template, ColumnId::Position, ColumnId::Heading,
                                  ColumnId::Seat, ColumnId::Group, ColumnId::Seed}) {
        QVERIFY(!usual.contains(column));
    }
    for (const ColumnId column : {ColumnId::Clip, ColumnId::Phase, ColumnId::Tint7,
                                  ColumnId::Height, ColumnId::Tags, ColumnId::Path}) {
        QVERIFY(usual.contains(column));
    }
    StatesScene scene;
    const State calm = scene.keep("calm");
    scene.put(columns::position, scene.ids, glm::vec3(1.0F, 2.0F, 3.0F));
    scene.put(columns::group, scene.ids, std::uint32_t{7});
    QVERIFY(scene.recall(calm).changed.empty());
    const State where = scene.keep("where", {ColumnId::Position});
    QVERIFY(where.columns.contains(ColumnId::Seat)); // they go together
    scene.put(columns::position, scene.ids, glm::vec3(0.0F));
    QCOMPARE(scene.recall(where).changed.size(), scene.ids.size());
    QCOMPARE(scene.valueOf(columns::position, 5), glm::vec3(1.0F, 2.0F, 3.0F));
}

void tst_States::someOfItForSomeOfThem()
{
    StatesScene scene;
    const float height = scene.valueOf(columns::height, 4);
    const State calm = scene.keep("calm");
    scene.stir();
    const Ids some{scene.ids[4], scene.ids[5]};
    QVERIFY(scene.recall(calm, {ColumnId::Height, ColumnId::Position}, &some).changed == some);
    QCOMPARE(scene.valueOf(columns::height, 4), height);
    QCOMPARE(scene.valueOf(columns::height, 6), 1.5F);
    QCOMPARE(scene.valueOf(columns::phase, 4), 0.875F);
}

void tst_States::whoIsGoneIsSkipped()
{
    StatesScene scene;
    const Population before = scene.people();
    const Ids first(scene.ids.begin(), scene.ids.begin() + 30);
    const State calm = scene.keepOf("calm", usualStateColumns(), first);
    scene.stir();
    const Ids gone{scene.ids[0], scene.ids[7]};
    scene.document.edit(QStringLiteral("Remove"),
                        [&](SceneEdit& edit) { edit.removeIndividuals(gone); });
    QCOMPARE(scene.recall(calm).changed.size(), std::size_t{28});
    QCOMPARE(scene.valueOf(columns::phase, 1),
             before.column(columns::phase)[before.rowOf(scene.ids[1])]);
    QCOMPARE(scene.valueOf(columns::phase, 40), 0.875F); // he is in none
}

void tst_States::clipsSlotsAndPartsGoByName()
{
    StatesScene scene;
    scene.put(columns::clip, scene.ids, std::uint16_t{1});
    scene.put(columns::walkStyle, scene.ids, std::uint16_t{2});
    const Tint tint = scene.valueOf(columns::tint(0), 0);
    const State calm = scene.keep("calm");
    // The files changed: clips and slots in another order, parts too.
    TemplateEntry entry = *scene.document.scene().findTemplate(1);
    std::rotate(entry.clipNames.begin(), entry.clipNames.begin() + 1, entry.clipNames.end());
    auto asset = std::make_shared<Template>(*entry.asset);
    std::rotate(asset->slots.begin(), asset->slots.begin() + 1, asset->slots.end());
    std::ranges::reverse(asset->parts);
    entry.asset = asset;
    scene.change(entry);
    const std::uint32_t parts = scene.valueOf(columns::parts, 0);
    scene.stir();
    scene.put(columns::parts, scene.ids, std::uint32_t{0});
    QVERIFY(scene.recall(calm).notes.empty());
    QCOMPARE(scene.valueOf(columns::clip, 0), std::uint16_t{0});
    QCOMPARE(scene.valueOf(columns::walkStyle, 0), std::uint16_t{1});
    const int last = static_cast<int>(asset->slots.size()) - 1;
    QCOMPARE(scene.valueOf(columns::tint(last), 0), tint);
    const std::uint32_t swapped = (parts & 1U) << 1U | (parts >> 1U & 1U);
    QCOMPARE(scene.valueOf(columns::parts, 0) & 3U, swapped);
    QCOMPARE(scene.valueOf(columns::clip, 1), std::uint16_t{1}); // of the other template
}

/// Nothing says that they are others, whatever becomes of the clips.
void tst_States::slotsOfMissingFilesAreWhatTheyWere()
{
    StatesScene scene;
    TemplateEntry entry = *scene.document.scene().findTemplate(1);
    entry.path = "lost.glb"; // else what was loaded is kept
    entry.asset.reset();
    scene.change(entry);
    const Tint tint = scene.valueOf(columns::tint(1), 2);
    const std::uint32_t parts = scene.valueOf(columns::parts, 2);
    const State calm = scene.keep("calm");
    std::rotate(entry.clipNames.begin(), entry.clipNames.begin() + 1, entry.clipNames.end());
    scene.change(entry);
    scene.stir();
    (void)scene.recall(calm);
    QVERIFY(scene.valueOf(columns::tint(1), 2) == tint);
    QCOMPARE(scene.valueOf(columns::parts, 2), parts);
}

void tst_States::whatIsGoneIsSaid()
{
    StatesScene scene;
    ColumnSet columns = usualStateColumns();
    columns.insert(ColumnId::Template);
    const State calm = scene.keep("calm", columns);
    TemplateEntry entry = *scene.document.scene().findTemplate(1);
    const std::string lost = entry.clipNames[scene.valueOf(columns::clip, 0)];
    for (std::string& clip : entry.clipNames) {
        clip = clip == lost ? "another" : clip;
    }
    scene.change(entry);
    scene.put(columns::clip, scene.ids, std::uint16_t{2});
    const StateRecall recall = scene.recall(calm);
    QVERIFY2(says(recall, ("no clip \"" + lost + "\"").c_str()), lost.c_str());
    QCOMPARE(scene.valueOf(columns::clip, 0), std::uint16_t{2}); // he keeps his
    scene.put(columns::templateId, scene.ids, kOtherMan);
    scene.put(columns::path, scene.ids, PathId{0});
    scene.document.edit(QStringLiteral("Remove"), [](SceneEdit& edit) {
        edit.removeTemplate(1);
        edit.removePath(kLivelyPath);
    });
    const StateRecall later = scene.recall(calm);
    QVERIFY(says(later, "For 30 of them the template is gone"));
    QVERIFY(says(later, "the path is gone"));
    QCOMPARE(scene.valueOf(columns::templateId, 0), kOtherMan);
}

void tst_States::seatsAreNotTakenFromOthers()
{
    StatesScene scene;
    for (std::size_t i = 0; i < 4; ++i) {
        scene.put(columns::seat, {scene.ids[i]}, static_cast<SeatId>(100 + i));
    }
    const Ids three(scene.ids.begin(), scene.ids.begin() + 3);
    const State seated = scene.keepOf("seated", {ColumnId::Seat}, three);
    // Two change places; on the third's somebody else sits now.
    scene.put(columns::seat, {scene.ids[0]}, SeatId{101});
    scene.put(columns::seat, {scene.ids[1]}, SeatId{100});
    scene.put(columns::seat, {scene.ids[2]}, kNoSeat);
    scene.put(columns::seat, {scene.ids[3]}, SeatId{102});
    const StateRecall recall = scene.recall(seated);
    QCOMPARE(scene.valueOf(columns::seat, 0), SeatId{100});
    QCOMPARE(scene.valueOf(columns::seat, 1), SeatId{101});
    QCOMPARE(scene.valueOf(columns::seat, 2), kNoSeat);
    QVERIFY(says(recall, "For 1 of them the seat is taken"));
    // Whoever stays keeps his own from others.
    scene.put(columns::seat, {scene.ids[2]}, SeatId{100});
    scene.put(columns::seat, {scene.ids[0]}, SeatId{105});
    QVERIFY(says(scene.recall(seated), "For 2 of them the seat is taken"));
    const auto seats = scene.people().column(columns::seat);
    std::vector<SeatId> taken;
    std::ranges::copy_if(seats, std::back_inserter(taken),
                         [](SeatId seat) { return seat != kNoSeat; });
    std::ranges::sort(taken);
    QVERIFY(std::ranges::adjacent_find(taken) == taken.end());
}

void tst_States::aStateOfThatNameIsReplaced()
{
    StatesScene scene;
    const State calm = scene.keep("calm");
    const State wild = scene.keep("wild");
    QVERIFY(calm.id == 1 && wild.id == 2);
    scene.stir();
    QVERIFY(!(scene.keep("calm") == calm));
    const auto& states = scene.document.scene().states;
    QCOMPARE(states.size(), std::size_t{2});
    QCOMPARE(states[0].name, std::string("calm")); // where it was, with its id
    QCOMPARE(states[0].id, StateId{1});
    QCOMPARE(states[0].people->ids, scene.ids);
}

void tst_States::undoTakesItBack()
{
    StatesScene scene;
    std::vector<std::string> texts{projectText(scene.document.scene())};
    const State calm = scene.keep("calm");
    texts.push_back(projectText(scene.document.scene()));
    scene.put(columns::phase, scene.ids, 0.875F);
    texts.push_back(projectText(scene.document.scene()));
    (void)scene.recall(calm);
    texts.push_back(projectText(scene.document.scene()));
    const int before = scene.document.undoStack().index() - 3;
    for (std::size_t step = texts.size(); step-- > 0;) {
        scene.document.undoStack().setIndex(before + static_cast<int>(step));
        QCOMPARE(projectText(scene.document.scene()), texts[step]);
    }
    scene.document.undoStack().setIndex(before + 3);
    QCOMPARE(projectText(scene.document.scene()), texts.back());
}

void tst_States::filesKeepThem()
{
    StatesScene scene;
    const std::string without = projectText(scene.document.scene());
    QVERIFY(without.find("states") == std::string::npos); // as files were before
    scene.keep("calm");
    scene.stir();
    scene.keepOf("some \"wild\" ones", {ColumnId::Position, ColumnId::Tags},
                 {scene.ids[1], scene.ids[2], scene.ids[30]});
    scene.keepOf("nobody", {ColumnId::Clip}, {});
    const std::string text = projectText(scene.document.scene());
    Scene again = read(text);
    QVERIFY(again.states == scene.document.scene().states);
    QCOMPARE(projectText(again), text);
    // What a later version writes there stays.
    std::string later = text;
    later.replace(later.find("\"holds\":[\"clip\""), 15, "\"mood\":1,\"holds\":[\"aura\",\"clip\"");
    later.replace(later.find("\"columns\":[\"template\","), 22,
                  "\"columns\":[\"aura\",\"template\",");
    const std::size_t rows = later.find("\"rows\":[") + 8;
    const std::size_t end = later.find("\n]", rows);
    std::string table = later.substr(rows, end - rows);
    for (std::size_t at = 0; (at = table.find("\n[", at)) != std::string::npos; at += 2) {
        table.replace(at, 2, "\n[7,");
    }
    later.replace(rows, end - rows, table);
    const Scene kept = read(later);
    QCOMPARE(kept.states.size(), std::size_t{3});
    QCOMPARE(read(projectText(kept)).states, kept.states);
    QVERIFY(projectText(kept).find("\"aura\"") != std::string::npos);
    QVERIFY(projectText(kept).find("\"mood\":1") != std::string::npos);
}

void tst_States::fourColumnsAreSmall()
{
    Scene scene = StatesScene().document.scene();
    Ids ids(700);
    std::iota(ids.begin(), ids.end(), IndividualId{1001});
    IndividualRows rows = IndividualRows::withDefaults(ids);
    for (std::size_t i = 0; i < ids.size(); ++i) {
        rows.column(columns::templateId)[i] = 1 + static_cast<TemplateId>(i % 2);
        rows.column(columns::clip)[i] = static_cast<std::uint16_t>(hashKeys(i) % 27);
        rows.column(columns::phase)[i] = unitFloat(hashKeys(i, 1));
        rows.column(columns::playbackSpeed)[i] = 0.75F + 0.5F * unitFloat(hashKeys(i, 2));
        rows.column(columns::tint(1))[i] = {static_cast<std::uint8_t>(hashKeys(i, 3)), 9, 8, 255};
    }
    scene.population.add(rows);
    scene.nextId = 2000;
    const std::size_t before = projectText(scene).size();
    scene.states.push_back(keepState(
        scene, "calm", {ColumnId::Clip, ColumnId::Phase, ColumnId::PlaybackSpeed, ColumnId::Tint1},
        ids));
    scene.states.back().id = 1;
    const std::size_t bytes = projectText(scene).size() - before;
    QVERIFY2(bytes < 30'000, qPrintable(QString::number(bytes)));
}

void tst_States::filesAreRefusedWithThePlace_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("message");
    StatesScene scene;
    scene.keepOf("calm", {ColumnId::Phase, ColumnId::Position}, {1, 2, 3});
    const std::string text = projectText(scene.document.scene());
    const auto row = [&text](const char* name, const std::string& from, const std::string& to,
                             const char* message) {
        std::string changed = text;
        const std::size_t at = changed.find(from);
        QVERIFY2(at != std::string::npos, name);
        changed.replace(at, from.size(), to);
        QTest::newRow(name) << QString::fromStdString(changed) << QString::fromLatin1(message);
    };
    row("ids that descend", "\"1-3\"", "\"3,1\"", "states[0].ids must be ascending");
    row("ids without end", "\"1-3\"", "\"1-4000000000\"", "states[0].ids");
    row("a fraction", "\"1-3\"", "\"1.5\"", "states[0].ids");
    row("a comma too much", "\"1-3\"", "\"1-3,\"", "states[0].ids");
    row("ids of zero", "\"1-3\"", "\"0-2\"", "states[0].ids");
    row("a number for ids", "\"ids\":\"1-3\"", "\"ids\":3", "states[0].ids");
    row("more ids than rows", "\"1-3\"", "\"1-4\"", "states[0] must have as many rows as ids: 4");
    row("more rows than ids", "\"1-3\"", "\"1-2\"", "states[0] must have as many rows as ids: 2");
    row("a column twice", "\"columns\":[\"template\",", "\"columns\":[\"template\",\"template\",",
        "states[0].columns names \"template\" twice");
    row("columns that are none", "\"columns\":[\"template\",\"position\"",
        "\"columns\":[1,\"position\"", "states[0].columns must be a list of names");
    row("a short row", "\"rows\":[\n[1,", "\"rows\":[\n[", "row 1 of states[0]");
    row("no name", "\"name\":\"calm\"", "\"name\":7", "states[0].name must be a text");
    row("an id of zero", "\"holds\":", "\"id\":0,\"holds\":", "");
    row("holding what is none", "\"holds\":[", "\"holds\":[5,", "states[0].holds must be a list");
    row("a list of states that is none", "\"states\": [", "\"states\": [[],", "states[0] must be");
}

void tst_States::filesAreRefusedWithThePlace()
{
    QFETCH(QString, text);
    QFETCH(QString, message);
    const auto scene = projectFromText(text.toStdString());
    QVERIFY(!scene);
    QVERIFY2(QString::fromStdString(scene.error().message).contains(message),
             scene.error().message.c_str());
}

CROWD_TEST(tst_States)
#include "tst_States.moc"
