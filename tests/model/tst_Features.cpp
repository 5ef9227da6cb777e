// SPDX-License-Identifier: MIT
#include <set>

#include "model/brush/TakenFrom.h"
#include "model/features/FeatureLook.h"
#include "model/features/FeatureWriting.h"
#include "model/project/EnvironmentText.h"
#include "model/project/ProjectReader.h"
#include "tests/model/LivelyBrush.h"
#include "tests/model/ProjectText.h"
#include "tests/program/Test.h"

using namespace crowd::test;
using crowd::testing::projectText;

namespace {

struct FeatureScene : LivelyScene
{
    FeatureScene() : ids(addCrowd()) {}

    [[nodiscard]] const FeatureKinds& kinds() const { return document.scene().features; }
    [[nodiscard]] const FeatureKind& kind(const char* name) const
    {
        return *findKind(kinds(), name);
    }
    [[nodiscard]] FeatureId idOf(const char* kindName, const char* value) const
    {
        return kind(kindName).find(value)->id;
    }
    void set(const char* kindName, const char* value, const Ids& of)
    {
        document.edit(QStringLiteral("Set"), [&](SceneEdit& edit) {
            const std::vector<FeatureId> wanted(of.size(), idOf(kindName, value));
            (void)setFeature(edit, kind(kindName), of, wanted, 5);
        });
    }
    void change(const FeatureKinds& all, bool isWorn)
    {
        document.edit(QStringLiteral("Change"),
                      [&](SceneEdit& edit) { changeFeatures(edit, all, isWorn); });
    }
    template<class T>
    [[nodiscard]] T valueOf(ColumnKey<T> key, IndividualId id) const
    {
        return people().column(key)[people().rowOf(id)];
    }
    /// By name, as each template counts them.
    [[nodiscard]] std::string clipOf(IndividualId id) const
    {
        const auto* entry = document.scene().findTemplate(valueOf(columns::templateId, id));
        return entry->clipNames[valueOf(columns::clip, id)];
    }
    StrokeOutcome paintAll(BrushSettings settings)
    {
        settings.selection = BrushSelection::Rectangle;
        settings.through = true;
        return paint(fromAbove(), settings, {{0, 0}, {1279, 767}});
    }

    Ids ids;
};

BrushSettings featureBrush(const char* kind, std::vector<ClipWeight> values, BrushOperator op)
{
    BrushSettings settings(BrushKind::Feature);
    settings.as<FeatureSettings>().kind = kind;
    settings.as<FeatureSettings>().values = std::move(values);
    settings.op = op;
    return settings;
}

/// The emotions of all, from the press to where the pointer was let go.
std::vector<FeatureId> inOrderOfTheLine(const FeatureScene& scene)
{
    const View view = fromAbove();
    std::vector<std::pair<float, FeatureId>> along;
    for (const IndividualId id : scene.ids) {
        const auto at = view.project(scene.valueOf(columns::position, id));
        along.emplace_back(at ? at->x * 1279.0F + at->y * 767.0F : 0.0F,
                           scene.valueOf(columns::feature(1), id));
    }
    std::ranges::sort(along);
    std::vector<FeatureId> row;
    for (const auto& [_, value] : along) {
        row.push_back(value);
    }
    return row;
}

/// A value that does everything that one can.
FeatureValue allOfIt(FeatureId id)
{
    FeatureValue value;
    value.id = id;
    value.name = "everything";
    value.color = {1, 2, 3};
    value.templates = {1, 2};
    value.clips = {{"cheer", 2.0F}, {"", 1.0F, ClipRole::Sit}};
    value.setsPhase = value.setsSpeed = value.setsWalkSpeed = true;
    value.setsHeight = value.setsGirth = true;
    value.speed = {1.5F, 1.75F};
    value.walkSpeed = {2.0F, 3.0F};
    value.height = {0.5F, 0.5F};
    value.girth = {2.0F, 2.0F};
    value.heightCurve.weights[3] = 4.0F;
    FeatureSlot slot;
    slot.slot = "top";
    slot.colors = {{250, 0, 0}};
    slot.strength = 0.5F;
    slot.replaces = false;
    slot.materials = {{"plain"}};
    value.slots = {slot};
    value.parts = {{"hat", false}, {"bag", true}};
    return value;
}

QString problemOfFeatures(const QString& features)
{
    const std::string text =
        R"({"format": "crowdbrush-scene", "version": 1, "features": )" + features.toStdString() +
        R"(, "individuals": {"columns": ["id","template","position"], "rows": []}})";
    const auto read = projectFromText(text);
    return read ? QString() : QString::fromStdString(read.error().message);
}

} // namespace

class tst_Features : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void namesAreFoundByTheirWords_data();
    void namesAreFoundByTheirWords();
    void aValueDoesWhatItSays();
    void whatIsNotNamedStays();
    void whoSitsPlaysClipsToSitWith();
    void limitedValuesAreForTheirTemplates();
    void drawsAreOnesOwnAndTheSameAgain();
    void everyReadyValueChangesSomebody();
    void undoTakesItBack();
    void theBrushPaintsOneAnyOrARow();
    void theBrushTakesItOffAndTakesItUp();
    void clothesComeOffAsTheyCameOn();
    void ticksOfAnotherKindDoNotCount();
    void theBrushSaysWhatIsMissing();
    void masksAskForThem();
    void bearersChangeWithTheirValueWhereAsked();
    void whoBearsWhatIsGoneBearsNone();
    void idsAreNotGivenOutAgain();
    void filesKeepThem();
    void untouchedOnesAreNotWritten();
    void filesKeepWhatTheyDoNotKnow();
    void filesAreRefusedWithThePlace_data();
    void filesAreRefusedWithThePlace();
};

void tst_Features::namesAreFoundByTheirWords_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("wanted");
    QTest::addColumn<bool>("isFound");
    QTest::newRow("itself") << "cheer"
                            << "cheer" << true;
    QTest::newRow("one of its words") << "sit_cheer"
                                      << "cheer" << true;
    QTest::newRow("both words") << "sit_look_around"
                                << "look around" << true;
    QTest::newRow("foreign spelling") << "Armature|SitCheer01"
                                      << "sit cheer" << true;
    QTest::newRow("capitals") << "CHEER"
                              << "cheer" << true;
    QTest::newRow("a part of a word") << "cheerful"
                                      << "cheer" << false;
    QTest::newRow("another word") << "clap"
                                  << "cheer" << false;
    QTest::newRow("one of two is missing") << "sit"
                                           << "sit cheer" << false;
    QTest::newRow("no words") << "clap"
                              << "" << true;
    QTest::newRow("no letters") << "001"
                                << "001" << true;
    QTest::newRow("not latin") << QStringLiteral("ходьба") << QStringLiteral("ходьба") << true;
}

void tst_Features::namesAreFoundByTheirWords()
{
    QFETCH(QString, name);
    QFETCH(QString, wanted);
    QTEST(hasWords(name.toStdString(), wanted.toStdString()), "isFound");
}

void tst_Features::aValueDoesWhatItSays()
{
    FeatureScene scene;
    FeatureKinds kinds = scene.kinds();
    kinds[0].values.push_back(allOfIt(40));
    scene.change(kinds, false);
    scene.set("emotion", "everything", scene.ids);
    for (const IndividualId id : scene.ids) {
        QCOMPARE(scene.valueOf(columns::feature(1), id), FeatureId{40});
        QCOMPARE(scene.clipOf(id), std::string("cheer")); // nobody sits
        const float speed = scene.valueOf(columns::playbackSpeed, id);
        QVERIFY(speed >= 1.5F && speed <= 1.75F);
        const float walkSpeed = scene.valueOf(columns::walkSpeed, id);
        QVERIFY(walkSpeed >= 2.0F && walkSpeed <= 3.0F);
        QCOMPARE(scene.valueOf(columns::height, id), 0.5F);
        QCOMPARE(scene.valueOf(columns::girth, id), 2.0F);
        QCOMPARE(scene.valueOf(columns::parts, id) & 3U, 2U);
        const auto* entry =
            scene.document.scene().findTemplate(scene.valueOf(columns::templateId, id));
        const int top = entry->asset->slotIndex("top");
        QCOMPARE(scene.valueOf(columns::tint(top), id), (Tint{250, 0, 0, 128}));
        QCOMPARE(scene.valueOf(columns::materialChoices, id)[static_cast<std::size_t>(top)],
                 std::uint8_t{0});
    }
}

void tst_Features::whatIsNotNamedStays()
{
    FeatureScene scene;
    const IndividualRows before = scene.people().rows(scene.ids);
    FeatureKinds kinds = scene.kinds();
    FeatureValue nothing;
    nothing.id = 40;
    nothing.name = "nothing";
    kinds[0].values.push_back(nothing);
    scene.change(kinds, false);
    scene.set("emotion", "nothing", scene.ids);
    const IndividualRows after = scene.people().rows(scene.ids);
    for (std::size_t column = 0; column < kColumnCount; ++column) {
        const bool isBorne = static_cast<ColumnId>(column) == ColumnId::Feature1;
        QCOMPARE(after.bytes[column] == before.bytes[column], !isBorne);
    }
}

void tst_Features::whoSitsPlaysClipsToSitWith()
{
    FeatureScene scene;
    const Ids seated{scene.ids[0], scene.ids[1]};
    scene.document.edit(QStringLiteral("Sit"), [&](SceneEdit& edit) {
        const std::vector<SeatId> seats{1, 2};
        edit.setColumn(columns::seat, seated, std::span<const SeatId>(seats));
    });
    FeatureKinds kinds = scene.kinds();
    kinds[0].values.push_back(allOfIt(40));
    scene.change(kinds, false);
    scene.set("emotion", "everything", scene.ids);
    QCOMPARE(scene.clipOf(scene.ids[0]), std::string("idle")); // no clip of that role: it stays
    TemplateEntry man = *scene.document.scene().findTemplate(1);
    man.clipRoles = {std::nullopt, ClipRole::Sit, std::nullopt};
    scene.document.edit(QStringLiteral("Say"), [&](SceneEdit& edit) { edit.changeTemplate(man); });
    scene.set("emotion", "everything", scene.ids);
    QCOMPARE(scene.clipOf(scene.ids[0]), std::string("sit"));
    QCOMPARE(scene.clipOf(scene.ids[2]), std::string("cheer"));
}

void tst_Features::limitedValuesAreForTheirTemplates()
{
    FeatureScene scene;
    FeatureKinds kinds = scene.kinds();
    FeatureValue limited = allOfIt(40);
    limited.templates = {kOtherMan};
    kinds[0].values.push_back(limited);
    scene.change(kinds, false);
    scene.set("emotion", "everything", scene.ids);
    for (const IndividualId id : scene.ids) {
        const bool isMeant = scene.valueOf(columns::templateId, id) == kOtherMan;
        QCOMPARE(scene.valueOf(columns::feature(1), id), isMeant ? FeatureId{40} : FeatureId{0});
        QCOMPARE(scene.valueOf(columns::girth, id) == 2.0F, isMeant);
    }
}

void tst_Features::drawsAreOnesOwnAndTheSameAgain()
{
    FeatureScene scene;
    scene.set("emotion", "excited", scene.ids);
    const auto phases = scene.people().column(columns::phase);
    QVERIFY(std::set<float>(phases.begin(), phases.end()).size() > scene.ids.size() / 2);
    const Population first = scene.people();
    scene.set("emotion", "sad", scene.ids);
    scene.set("emotion", "excited", scene.ids);
    QVERIFY(first == scene.people());
    // Nor does it matter with whom somebody is told so.
    FeatureScene apart;
    for (const IndividualId id : apart.ids) {
        apart.set("emotion", "excited", {id});
    }
    QVERIFY(first == apart.people());
}

void tst_Features::everyReadyValueChangesSomebody()
{
    std::set<FeatureId> ids;
    for (const FeatureKind& kind : readyFeatures()) {
        for (const FeatureValue& value : kind.values) {
            QVERIFY(ids.insert(value.id).second);
            QVERIFY2(!value.name.empty(), value.name.c_str());
            QVERIFY2(value.clips.empty() != value.slots.empty(), value.name.c_str());
        }
    }
    QCOMPARE(ids.size(), std::size_t{16});
}

void tst_Features::undoTakesItBack()
{
    FeatureScene scene;
    const Population before = scene.people();
    const int steps = scene.document.undoStack().count();
    scene.set("outfit", "team red", scene.ids);
    QCOMPARE(scene.document.undoStack().count(), steps + 1);
    const Population after = scene.people();
    QVERIFY(!(before == after));
    scene.document.undoStack().undo();
    QVERIFY(before == scene.people());
    scene.document.undoStack().redo();
    QVERIFY(after == scene.people());
}

void tst_Features::theBrushPaintsOneAnyOrARow()
{
    FeatureScene scene;
    const FeatureId sad = scene.idOf("emotion", "sad");
    const FeatureId happy = scene.idOf("emotion", "happy");
    const auto borne = [&scene] {
        const auto column = scene.people().column(columns::feature(1));
        return std::set<FeatureId>(column.begin(), column.end());
    };
    const std::vector<ClipWeight> both{{"sad", 1.0F}, {"happy", 3.0F}};
    QVERIFY(scene.paintAll(featureBrush("emotion", both, BrushOperator::Uniform)).isCommitted);
    QCOMPARE(borne(), (std::set<FeatureId>{sad}));
    QVERIFY(scene.paintAll(featureBrush("emotion", both, BrushOperator::Random)).isCommitted);
    QCOMPARE(borne(), (std::set<FeatureId>{sad, happy}));
    const auto cheerful = bearersOf(scene.document.scene(), happy).size();
    QVERIFY(cheerful > scene.ids.size() / 2 && cheerful < scene.ids.size());
    QVERIFY(scene.paintAll(featureBrush("emotion", {}, BrushOperator::Gradient)).isCommitted);
    const std::size_t inARow = borne().size(); // as far as the line goes over them
    QVERIFY(inARow > 2);
    BrushSettings outfit(BrushKind::Outfit);
    QVERIFY(scene.paintAll(outfit).isCommitted);
    QCOMPARE(borne().size(), inARow); // those stay
    // Where two meet they mix; at the ends there is one only.
    QVERIFY(scene.paintAll(featureBrush("emotion", both, BrushOperator::Gradient)).isCommitted);
    const std::vector<FeatureId> row = inOrderOfTheLine(scene);
    const auto firstHappy = std::ranges::find(row, happy) - row.begin();
    const auto lastSad = row.rend() - std::ranges::find(row.rbegin(), row.rend(), sad);
    QVERIFY(firstHappy > 0 && firstHappy < lastSad);
    QVERIFY(static_cast<std::size_t>(lastSad) < row.size());
    QVERIFY(bearersOf(scene.document.scene(), scene.idOf("outfit", "everyday")).size() > 0);
}

void tst_Features::theBrushTakesItOffAndTakesItUp()
{
    FeatureScene scene;
    const std::string usual = scene.clipOf(scene.ids[0]);
    scene.set("emotion", "excited", scene.ids);
    BrushSettings settings = featureBrush("emotion", {}, BrushOperator::Random);
    const TakenFrom from{scene.document.scene(), *scene.document.scene().findTemplate(1),
                         scene.ids[0], 0};
    QCOMPARE(FeatureSettings::take(settings, from), std::string("excited"));
    QCOMPARE(settings.as<FeatureSettings>().values.size(), std::size_t{1});
    settings.as<FeatureSettings>().takesOff = true;
    QVERIFY(scene.clipOf(scene.ids[0]) != usual);
    QVERIFY(scene.paintAll(settings).isCommitted);
    QVERIFY(bearersOf(scene.document.scene(), scene.idOf("emotion", "excited")).empty());
    QCOMPARE(scene.clipOf(scene.ids[0]), usual);
    QCOMPARE(FeatureSettings::take(settings, from), std::string());
    QCOMPARE(scene.paintAll(settings).reason, StrokeReason::Unchanged);
}

void tst_Features::clothesComeOffAsTheyCameOn()
{
    FeatureScene scene;
    const IndividualId id = scene.ids[2];
    const Population before = scene.document.scene().population;
    FeatureKinds kinds = scene.kinds();
    for (FeatureValue& value : kinds[1].values) {
        value.setsHeight = true;
        value.height = {1.4F, 1.4F};
    }
    scene.change(kinds, false);
    scene.set("outfit", "team red", scene.ids);
    const auto tinted = [&scene, id] {
        for (int slot = 0; slot < kMaxTintSlots; ++slot) {
            if (scene.valueOf(columns::tint(slot), id).strength != 0) {
                return true;
            }
        }
        return false;
    };
    QVERIFY(tinted());
    QCOMPARE(scene.valueOf(columns::height, id), 1.4F);
    BrushSettings settings(BrushKind::Outfit);
    settings.as<OutfitSettings>().takesOff = true;
    QVERIFY(scene.paintAll(settings).isCommitted);
    QVERIFY(!tinted());
    QCOMPARE(scene.valueOf(columns::height, id), 1.0F);
    QVERIFY(scene.valueOf(columns::tintReplaces, id) ==
            before.column(columns::tintReplaces)[before.rowOf(id)]);
    QVERIFY(scene.valueOf(columns::parts, id) == before.column(columns::parts)[before.rowOf(id)]);
}

void tst_Features::ticksOfAnotherKindDoNotCount()
{
    FeatureScene scene;
    const BrushSettings settings =
        featureBrush("emotion", {{"team red"}, {"team blue"}}, BrushOperator::Random);
    QVERIFY(scene.paintAll(settings).isCommitted);
    QVERIFY(scene.valueOf(columns::feature(1), scene.ids[0]) != 0);
    QCOMPARE(scene.valueOf(columns::feature(2), scene.ids[0]), FeatureId{0});
}

void tst_Features::theBrushSaysWhatIsMissing()
{
    FeatureScene scene;
    QCOMPARE(scene.paintAll(featureBrush("courage", {}, BrushOperator::Uniform)).reason,
             StrokeReason::NoSuchFeature);
    QCOMPARE(scene.paintAll(featureBrush("emotion", {{"brave"}}, BrushOperator::Uniform)).reason,
             StrokeReason::NoSuchFeature);
}

void tst_Features::masksAskForThem()
{
    FeatureScene scene;
    const Ids some{scene.ids[3], scene.ids[7]};
    scene.set("emotion", "sad", some);
    BrushSettings outfit(BrushKind::Outfit);
    outfit.mask.features = {scene.idOf("emotion", "sad")};
    QCOMPARE(scene.paintAll(outfit).affected, 2);
    outfit.mask.isInverted = true;
    QCOMPARE(scene.paintAll(outfit).affected, static_cast<int>(scene.ids.size()) - 2);
}

void tst_Features::bearersChangeWithTheirValueWhereAsked()
{
    FeatureScene scene;
    const Ids some{scene.ids[3], scene.ids[7]};
    scene.set("outfit", "team red", some);
    FeatureKinds kinds = scene.kinds();
    FeatureValue& red = kinds[1].values[5];
    QCOMPARE(red.name, std::string("team red"));
    red.setsGirth = true;
    red.girth = {3.0F, 3.0F};
    scene.change(kinds, false);
    QVERIFY(scene.valueOf(columns::girth, some[0]) != 3.0F);
    kinds[1].values[5].girth = {4.0F, 4.0F};
    scene.change(kinds, true);
    QCOMPARE(scene.valueOf(columns::girth, some[0]), 4.0F);
    QVERIFY(scene.valueOf(columns::girth, scene.ids[0]) != 4.0F);
    scene.document.undoStack().undo();
    QVERIFY(scene.valueOf(columns::girth, some[0]) != 4.0F);
    QCOMPARE(scene.kinds()[1].values[5].girth.low, 3.0F);
}

void tst_Features::whoBearsWhatIsGoneBearsNone()
{
    FeatureScene scene;
    scene.set("emotion", "sad", {scene.ids[0]});
    scene.set("outfit", "rain", {scene.ids[0]});
    FeatureKinds kinds = scene.kinds();
    std::erase_if(kinds[0].values, [](const FeatureValue& each) { return each.name == "sad"; });
    kinds.pop_back();
    scene.change(kinds, false);
    QCOMPARE(scene.valueOf(columns::feature(1), scene.ids[0]), FeatureId{0});
    QCOMPARE(scene.valueOf(columns::feature(2), scene.ids[0]), FeatureId{0});
    scene.document.undoStack().undo();
    QVERIFY(scene.valueOf(columns::feature(1), scene.ids[0]) != 0);
    QVERIFY(scene.valueOf(columns::feature(2), scene.ids[0]) != 0);
}

void tst_Features::idsAreNotGivenOutAgain()
{
    FeatureScene scene;
    QCOMPARE(freeFeatureId(scene.document.scene()), FeatureId{17});
    Scene named = scene.document.scene();
    Rule rule;
    rule.actions = {actions::SetFeature{90}};
    named.rules = {rule};
    QCOMPARE(freeFeatureId(named), FeatureId{91});
    QCOMPARE(freeKindId(named), std::uint8_t{3});
    const std::vector<FeatureId> borne{5};
    named.population.setValues(columns::feature(3), Ids{scene.ids[0]},
                               std::span<const FeatureId>(borne));
    QCOMPARE(freeKindId(named), std::uint8_t{4});
}

void tst_Features::filesKeepThem()
{
    FeatureScene scene;
    Scene named = scene.document.scene();
    for (TemplateEntry& entry : named.templates) {
        entry.path = "builtin:templates/man.glb";
    }
    FeatureKind team;
    team.id = 5;
    team.name = "team";
    team.values = {allOfIt(60)};
    named.features.push_back(team);
    const std::vector<FeatureId> borne{60};
    named.population.setValues(columns::feature(5), Ids{scene.ids[0]},
                               std::span<const FeatureId>(borne));
    const std::string text = projectText(named);
    const auto read = projectFromText(text);
    QVERIFY2(bool(read), read ? "" : read.error().message.c_str());
    QCOMPARE(read.value().features, named.features);
    QVERIFY(read.value().population == named.population);
    QCOMPARE(projectText(read.value()), text);
}

void tst_Features::untouchedOnesAreNotWritten()
{
    FeatureScene scene;
    Scene named = scene.document.scene();
    for (TemplateEntry& entry : named.templates) {
        entry.path = "builtin:templates/man.glb";
    }
    const std::string text = projectText(named);
    QVERIFY(text.find("features") == std::string::npos);
    QVERIFY(text.find("feature1") == std::string::npos);
    QCOMPARE(projectFromText(text).value().features, readyFeatures());
    named.features.clear();
    QCOMPARE(projectFromText(projectText(named)).value().features, FeatureKinds());
}

void tst_Features::filesKeepWhatTheyDoNotKnow()
{
    Scene scene;
    const std::string text =
        R"({"features": [{"id": 1, "name": "team", "later": 1, "values": [)"
        R"({"id": 3, "name": "red", "sound": "la", "slots": [{"slot": "top", "gloss": 2}]}]}]})";
    QVERIFY(readEnvironmentText(text, scene, false));
    const std::string kept = environmentText(scene);
    for (const char* each : {"later", "sound", "gloss"}) {
        QVERIFY2(kept.find(each) != std::string::npos, each);
    }
    QVERIFY(readEnvironmentText(kept, scene, true)); // as the scene has them
    Scene other;
    QVERIFY(!readEnvironmentText(kept, other, true));
}

void tst_Features::filesAreRefusedWithThePlace_data()
{
    QTest::addColumn<QString>("features");
    QTest::addColumn<QString>("problem");
    const auto value = [](const char* members) {
        return QStringLiteral(R"([{"id": 1, "name": "a", "values": [{"id": 1, "name": "b", %1}]}])")
            .arg(QLatin1String(members));
    };
    QTest::newRow("no list") << "7"
                             << "features must be a list";
    QTest::newRow("no object") << "[7]"
                               << "features[0] must be an object";
    QTest::newRow("too many kinds") << R"([{"id": 9, "name": "a"}])"
                                    << "features[0].id";
    QTest::newRow("no id") << R"([{"name": "a"}])"
                           << "the id 0";
    QTest::newRow("kind twice") << R"([{"id": 1, "name": "a"}, {"id": 1, "name": "b"}])"
                                << "the id 1 is given twice";
    QTest::newRow("name twice") << R"([{"id": 1, "name": "a"}, {"id": 2, "name": "a"}])"
                                << "the name \"a\" is given twice";
    QTest::newRow("no name") << R"([{"id": 1}])"
                             << "has no name";
    QTest::newRow("value twice") << R"([{"id": 1, "name": "a", "values": [{"id": 4, "name": "b"}]},
               {"id": 2, "name": "c", "values": [{"id": 4, "name": "d"}]}])"
                                 << "the id 4 is given twice";
    QTest::newRow("no text") << value(R"("clips": [{"clip": 3}])")
                             << "features[0].values[0].clips[0].clip";
    QTest::newRow("no role") << value(R"("clips": [{"role": "fall"}])")
                             << "features[0].values[0].clips[0].role must be one of";
    QTest::newRow("weight") << value(R"("clips": [{"weight": -1}])")
                            << "features[0].values[0].clips[0].weight";
    QTest::newRow("not finite") << value(R"("clips": [{"weight": 1e300}])")
                                << "features[0].values[0].clips[0].weight";
    QTest::newRow("backwards") << value(R"("speed": [2, 1])") << "features[0].values[0].speed";
    QTest::newRow("no height") << value(R"("height": [0, 1])") << "features[0].values[0].height";
    QTest::newRow("curve") << value(R"("speed_curve": [1])") << "features[0].values[0].speed_curve";
    QTest::newRow("colour") << value(R"("slots": [{"colors": ["red"]}])")
                            << "features[0].values[0].slots[0].colors";
    QTest::newRow("strength") << value(R"("slots": [{"strength": 1e30}])")
                              << "features[0].values[0].slots[0].strength";
    QTest::newRow("material") << value(R"("slots": [{"materials": [[]]}])")
                              << "features[0].values[0].slots[0].materials[0] must be an object";
    QTest::newRow("part") << value(R"("parts": [{"shown": 1}])")
                          << "features[0].values[0].parts[0].shown";
}

void tst_Features::filesAreRefusedWithThePlace()
{
    QFETCH(QString, features);
    QFETCH(QString, problem);
    const QString said = problemOfFeatures(features);
    QVERIFY2(said.contains(problem), qPrintable(said));
}

CROWD_TEST(tst_Features)
#include "tst_Features.moc"
