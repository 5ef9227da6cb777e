// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <map>
#include <span>
#include <string>
#include <vector>

#include <QtTest/QTest>

#include "model/base/Random.h"
#include "model/features/FeatureWriting.h"
#include "model/project/ProjectReader.h"
#include "model/relations/RelatedPeople.h"
#include "model/states/StateKeeping.h"
#include "tests/model/LivelyBrush.h"
#include "tests/model/ProjectText.h"
#include "tests/program/Test.h"

using namespace crowd::test;
using crowd::testing::projectText;

namespace {

constexpr std::uint64_t kEdits = 400;
constexpr std::uint64_t kJumps = 150;

/// A crowd that is kept, given back, made happy and related at random: one undo step each, the
/// same for the same key.
class MixedScene : public LivelyScene
{
public:
    MixedScene()
    {
        Scene scene = document.scene();
        for (TemplateEntry& entry : scene.templates) {
            entry.path = "builtin:templates/man.glb"; // so that it can be saved
        }
        document.replaceScene(std::move(scene), {});
        (void)addCrowd();
    }

    void change(std::uint64_t key)
    {
        using Step = void (MixedScene::*)(SceneEdit&, std::uint64_t);
        constexpr std::array<Step, 10> kSteps{
            &MixedScene::keep,         &MixedScene::recall,   &MixedScene::forget,
            &MixedScene::feel,         &MixedScene::feel,     &MixedScene::changeValues,
            &MixedScene::relateSome,   &MixedScene::partSome, &MixedScene::changeKinds,
            &MixedScene::comeAndLeave,
        };
        document.edit(QStringLiteral("Mix"), [&](SceneEdit& edit) {
            for (std::uint64_t i = 0; i <= hashKeys(key, 1) % 3; ++i) {
                const std::uint64_t step = hashKeys(key, 2, i);
                (this->*kSteps[step % kSteps.size()])(edit, step);
            }
        });
    }

private:
    static Ids someOf(const SceneEdit& edit, std::uint64_t key, std::uint64_t share = 4)
    {
        Ids chosen;
        for (const IndividualId id : edit.scene().population.ids()) {
            if (hashKeys(key, id) % share == 0) {
                chosen.push_back(id);
            }
        }
        return chosen;
    }
    /// Of entries that are there.
    static std::size_t anyOf(std::size_t count, std::uint64_t key) { return key % count; }

    void keep(SceneEdit& edit, std::uint64_t key)
    {
        ColumnSet columns;
        for (const PropertyAspectInfo& aspect : propertyAspects()) {
            if (hashKeys(key, static_cast<std::uint64_t>(aspect.aspect)) % 2 == 0) {
                columnsOf(aspect.aspect).forEach([&](ColumnId each) { columns.insert(each); });
            }
        }
        const std::string name = "state " + std::to_string(hashKeys(key, 40) % 4);
        putState(edit, keepState(edit.scene(), name, columns, someOf(edit, key, 2)));
    }
    void recall(SceneEdit& edit, std::uint64_t key)
    {
        const std::vector<State> states = edit.scene().states;
        if (!states.empty()) {
            const State& state = states[anyOf(states.size(), hashKeys(key, 41))];
            const Ids only = someOf(edit, key, 2);
            (void)recallState(edit, state, state.columns, &only);
        }
    }
    void forget(SceneEdit& edit, std::uint64_t key)
    {
        std::vector<State> states = edit.scene().states;
        if (!states.empty()) {
            states.erase(states.begin() +
                         static_cast<std::ptrdiff_t>(anyOf(states.size(), hashKeys(key, 42))));
            edit.setStates(std::move(states));
        }
    }
    void feel(SceneEdit& edit, std::uint64_t key)
    {
        const FeatureKinds kinds = edit.scene().features;
        const FeatureKind& kind = kinds[anyOf(kinds.size(), hashKeys(key, 43))];
        const Ids ids = someOf(edit, key);
        std::vector<FeatureId> wanted(ids.size(), 0);
        for (std::size_t i = 0; i < ids.size(); ++i) {
            const std::size_t value = hashKeys(key, 44, i) % (kind.values.size() + 1);
            wanted[i] = value < kind.values.size() ? kind.values[value].id : FeatureId{0};
        }
        (void)setFeature(edit, kind, ids, wanted, key);
    }
    /// One goes, comes, or does something else.
    void changeValues(SceneEdit& edit, std::uint64_t key)
    {
        FeatureKinds kinds = edit.scene().features;
        FeatureKind& kind = kinds[anyOf(kinds.size(), hashKeys(key, 45))];
        const std::uint64_t how = hashKeys(key, 46) % 3;
        if (how == 0 && kind.values.size() > 1) {
            kind.values.erase(kind.values.begin());
        } else if (how == 1) {
            FeatureValue value;
            value.id = freeFeatureId(edit.scene());
            value.name = "value " + std::to_string(value.id);
            kind.values.push_back(std::move(value));
        } else if (!kind.values.empty()) {
            FeatureValue& value = kind.values[anyOf(kind.values.size(), hashKeys(key, 47))];
            value.setsHeight = true;
            value.height = {1.0F, 1.0F + 0.5F * unitFloat(hashKeys(key, 48))};
        }
        changeFeatures(edit, std::move(kinds), hashKeys(key, 49) % 2 == 0);
    }
    void relateSome(SceneEdit& edit, std::uint64_t key)
    {
        const RelationKinds& kinds = edit.scene().relationKinds;
        const Ids ids = someOf(edit, key);
        std::vector<Relation> made;
        for (std::size_t i = 1; i < ids.size(); ++i) {
            made.push_back({ids[i - 1], ids[i], unitFloat(hashKeys(key, 50, i)),
                            kinds[anyOf(kinds.size(), hashKeys(key, 51, i))].id});
        }
        edit.relate(made);
    }
    void partSome(SceneEdit& edit, std::uint64_t key)
    {
        const Ids ids = someOf(edit, key);
        const std::vector<Relation> gone = relationsOf(edit.scene(), ids, 0);
        edit.unrelate(gone);
    }
    void changeKinds(SceneEdit& edit, std::uint64_t key)
    {
        RelationKinds kinds = edit.scene().relationKinds;
        if (kinds.size() > 2 && hashKeys(key, 52) % 2 == 0) {
            kinds.erase(kinds.begin() + 1); // its relations go with it
        } else if (freeRelationId(kinds) != 0) {
            RelationKind kind;
            kind.id = freeRelationId(kinds);
            kind.name = "kind " + std::to_string(kind.id);
            kind.isMutual = hashKeys(key, 53) % 2 == 0;
            kinds.insert(std::ranges::upper_bound(kinds, kind.id, {}, &RelationKind::id), kind);
        }
        edit.setRelationKinds(std::move(kinds));
    }
    void comeAndLeave(SceneEdit& edit, std::uint64_t key)
    {
        const Ids ids = someOf(edit, key, 12);
        if (hashKeys(key, 54) % 2 == 0 && edit.scene().population.size() > 30) {
            edit.removeIndividuals(ids);
        } else if (edit.scene().population.size() < 90) {
            (void)duplicate(edit, ids, {1.0F, 0.0F, 0.0F});
        }
    }
};

} // namespace

/// States, features and relations, mixed as they come.
class tst_StatesFeaturesRelations : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everyStepIsUndoneAndDoneAgain();
    void whatIsSavedIsReadAsItWas();
    void aStateKeptIsTheCrowdOfThen();
};

void tst_StatesFeaturesRelations::everyStepIsUndoneAndDoneAgain()
{
    MixedScene scene;
    QUndoStack& stack = scene.document.undoStack();
    std::map<int, std::string> texts{{stack.index(), projectText(scene.document.scene())}};
    std::size_t states = 0;
    std::size_t relations = 0;
    std::ptrdiff_t bearers = 0;
    for (std::uint64_t key = 0; key < kEdits; ++key) {
        scene.change(key);
        const Scene& now = scene.document.scene();
        texts[stack.index()] = projectText(now);
        const auto emotions = now.population.column(columns::feature(1));
        if (now.states.size() > 2 && now.relations.count() > 20) {
            states = std::max(states, now.states.size());
            relations = std::max(relations, now.relations.count());
            bearers = std::max(bearers,
                               std::ssize(emotions) - std::ranges::count(emotions, FeatureId{0}));
        }
    }
    QVERIFY2(stack.count() > static_cast<int>(kEdits / 2), "most change something");
    QVERIFY2(states > 2 && relations > 20 && bearers > 20, "all three at once");
    const auto first = static_cast<std::uint64_t>(texts.begin()->first);
    for (std::uint64_t jump = 0; jump < kJumps; ++jump) {
        const std::uint64_t last = static_cast<std::uint64_t>(stack.count());
        const auto index = static_cast<int>(first + hashKeys(jump, 60) % (last + 1 - first));
        stack.setIndex(index);
        QVERIFY2(projectText(scene.document.scene()) == texts[index],
                 qPrintable(QStringLiteral("step %1 of %2").arg(index).arg(stack.count())));
    }
}

void tst_StatesFeaturesRelations::whatIsSavedIsReadAsItWas()
{
    MixedScene scene;
    for (std::uint64_t key = 1000; key < 1000 + kEdits; ++key) {
        scene.change(key);
        if (key % 10 == 0) {
            const std::string text = projectText(scene.document.scene());
            const auto again = crowd::model::projectFromText(text);
            QVERIFY2(bool(again), again ? "" : again.error().message.c_str());
            QVERIFY2(projectText(again.value()) == text, qPrintable(QString::number(key)));
        }
    }
}

/// Whatever is done to it in between, as long as nobody leaves and nothing that it names goes.
void tst_StatesFeaturesRelations::aStateKeptIsTheCrowdOfThen()
{
    for (std::uint64_t round = 0; round < 20; ++round) {
        MixedScene scene;
        for (std::uint64_t key = 0; key < 5; ++key) {
            scene.change(hashKeys(round, 70, key));
        }
        const Population before = scene.people();
        const Ids all(before.ids().begin(), before.ids().end());
        State kept;
        scene.document.edit(QStringLiteral("Keep"), [&](SceneEdit& edit) {
            putState(edit, keepState(edit.scene(), "then", usualStateColumns(), all));
            kept = *findState(edit.scene(), "then");
        });
        for (std::uint64_t key = 0; key < 3; ++key) {
            const float height = 1.0F + unitFloat(hashKeys(round, 71, key));
            const Tint tint{static_cast<std::uint8_t>(hashKeys(round, 72, key) % 256), 3, 4, 255};
            scene.document.edit(QStringLiteral("Stir"), [&](SceneEdit& edit) {
                edit.setColumn(columns::height, all, std::span<const float>(&height, 1));
                edit.setColumn(columns::tint(1), all, std::span<const Tint>(&tint, 1));
            });
        }
        QVERIFY(!(scene.people() == before));
        scene.document.edit(QStringLiteral("Recall"),
                            [&](SceneEdit& edit) { (void)recallState(edit, kept, kept.columns); });
        QVERIFY(scene.people() == before);
    }
}

CROWD_TEST(tst_StatesFeaturesRelations)

#include "tst_StatesFeaturesRelations.moc"
