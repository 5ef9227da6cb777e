// SPDX-License-Identifier: MIT
#include <algorithm>

#include <QtTest/QTest>

#include "model/base/Random.h"
#include "model/project/ProjectReader.h"
#include "model/project/ProjectWriter.h"
#include "model/states/StateKeeping.h"
#include "tests/program/Test.h"

using namespace crowd::model;

namespace {

constexpr int kRounds = 20'000;
constexpr const char* kPieces[] = {"null",        "true",
                                   "-1",          "0",
                                   "1e39",        "-1e-46",
                                   "4294967296",  "18446744073709551616",
                                   "1e400",       "[]",
                                   "{}",          "[[[[",
                                   "]]]]",        "\"\"",
                                   "\"id\"",      "\"rows\"",
                                   "\"columns\"", "\"\\u0000\"",
                                   "\"\\ud800\"", ",",
                                   ":",           "\"",
                                   "\\",          "\xff",
                                   "[1,2,3]",     "\"#00000000\"",
                                   "NaN"};

Scene seedScene()
{
    Scene scene;
    scene.name = "seed";
    for (const TemplateId id : {TemplateId{1}, TemplateId{2}, TemplateId{9}}) {
        TemplateEntry entry;
        entry.id = id;
        entry.path = "builtin:templates/man.glb";
        entry.clipNames = {"idle", "sit"};
        entry.clipSpeeds = {1.5F};
        entry.import.scale = 0.5F;
        entry.unknownMembers = "{\"mood\":[1,{\"a\":null}]}";
        scene.templates.push_back(entry);
    }
    StageEntry stage;
    stage.id = 4;
    stage.path = "stage.glb";
    scene.stages.push_back(stage);
    scene.cameras.push_back({"Front", Camera{}});
    scene.unknownMembers = "{\"weather\":[{\"rain\":\"now\"}]}";
    scene.unknownTableMembers = "{\"sorted\":true}";
    IndividualRows rows = IndividualRows::withDefaults({1, 2, 3, 5, 8, 13, 21});
    for (std::size_t i = 0; i < rows.ids.size(); ++i) {
        rows.column(columns::templateId)[i] = i % 2 == 0 ? 1 : 9;
        rows.column(columns::position)[i] = {static_cast<float>(i), 0.25F, -1e-3F};
        rows.column(columns::tint(3))[i].red = static_cast<std::uint8_t>(i);
        rows.column(columns::seat)[i] = static_cast<SeatId>(i);
        rows.column(columns::tags)[i] = ~std::uint64_t{0} - i;
        rows.column(columns::materialChoices)[i][2] = 3;
    }
    scene.population.add(rows);
    scene.nextId = 22;
    scene.places = {{.id = 1, .name = "door", .position = {1.0F, 0.0F, 2.0F}, .radius = 1.5F},
                    {.id = 4, .name = "tree", .role = crowd::model::PlaceRole::Obstacle}};
    scene.paths = {{.id = 1, .name = "way", .places = {1, 4}, .branches = {{4, 1, 0.5F}}}};
    State state =
        keepState(scene, "calm", usualStateColumns(), std::vector<IndividualId>{1, 2, 3, 8});
    state.id = 3;
    state.unknownMembers = "{\"mood\":7}";
    state.unknownColumns.push_back({"fear", {{2, "[1]"}}});
    scene.states.push_back(state);
    scene.unknownColumns.push_back({"fear", {{1, "{\"of\":\"dogs\"}"}, {8, "2"}}});
    return scene;
}

/// One to four small damages.
std::string mutated(std::string text, std::uint64_t key)
{
    const std::uint64_t count = 1 + hashKeys(key, 1) % 4;
    for (std::uint64_t m = 0; m < count && !text.empty(); ++m) {
        const std::size_t at = hashKeys(key, m, 2) % text.size();
        const std::size_t length = 1 + hashKeys(key, m, 3) % 40;
        switch (hashKeys(key, m, 4) % 6) {
        case 0:
            text[at] = static_cast<char>(hashKeys(key, m, 5) % 256);
            break;
        case 1:
            text.erase(at, length);
            break;
        case 2:
            text.insert(hashKeys(key, m, 6) % text.size(), text.substr(at, length));
            break;
        case 3:
            text.resize(at);
            break;
        case 4:
            text.insert(at, kPieces[hashKeys(key, m, 7) % std::size(kPieces)]);
            break;
        default: { // a whole value gives way to another
            const std::size_t end = text.find_first_of(",]}\n", at);
            const std::size_t last = text.find_last_of(",[:", at);
            if (end != std::string::npos && last != std::string::npos && last < end) {
                text.replace(last + 1, end - last - 1,
                             kPieces[hashKeys(key, m, 8) % std::size(kPieces)]);
            }
            break;
        }
        }
    }
    return text;
}

/// What every scene that was read must be.
void checkScene(const Scene& scene)
{
    const auto ids = scene.population.ids();
    QVERIFY(std::ranges::adjacent_find(ids, std::ranges::greater_equal{}) == ids.end());
    QVERIFY(ids.empty() || (ids.front() > 0 && ids.back() < scene.nextId));
    for (const TemplateId id : scene.population.column(columns::templateId)) {
        QVERIFY(scene.findTemplate(id) != nullptr);
    }
    const Result<std::string> text = projectToText(scene);
    QVERIFY2(text.isOk(), text ? "" : text.error().message.c_str());
    const Result<Scene> again = projectFromText(text.value());
    QVERIFY2(again.isOk(), again ? "" : again.error().message.c_str());
    QVERIFY(again.value().population == scene.population);
    QCOMPARE(projectToText(again.value()).value(), text.value());
}

} // namespace

/// The reader fed with damaged files: each is refused with a message or read as a sound scene.
class tst_ProjectMutations : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void refusesOrReadsWhole();
};

void tst_ProjectMutations::refusesOrReadsWhole()
{
    const std::string seed = projectToText(seedScene()).value();
    checkScene(projectFromText(seed).value());
    int refused = 0;
    for (int round = 0; round < kRounds; ++round) {
        const std::string text = mutated(seed, static_cast<std::uint64_t>(round));
        const Result<Scene> read = projectFromText(text);
        if (!read) {
            QVERIFY(read.error().message.size() > 30);
            ++refused;
            continue;
        }
        checkScene(read.value());
        QVERIFY2(!QTest::currentTestFailed(), text.c_str());
    }
    QVERIFY2(refused > kRounds / 2 && refused < kRounds, qPrintable(QString::number(refused)));
}

CROWD_TEST(tst_ProjectMutations)
#include "tst_ProjectMutations.moc"
