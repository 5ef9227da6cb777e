// SPDX-License-Identifier: MIT
#include "model/document/SceneDocument.h"

#include <limits>
#include <numeric>

#include <QtTest/QTest>

#include "model/base/Random.h"
#include "model/document/SceneCommand.h"
#include "model/document/SceneEdit.h"
#include "model/project/ProjectWriter.h"

using namespace crowd::model;

namespace {

std::vector<IndividualId> addPeople(SceneDocument& document, std::size_t count)
{
    const auto edit = document.beginEdit();
    auto ids = edit->addIndividuals(IndividualRows::withDefaults(std::vector<IndividualId>(count)));
    edit->commit(QStringLiteral("Add"));
    return ids;
}

void setHeading(SceneEdit& edit, std::span<const IndividualId> ids, float value)
{
    edit.setColumn(columns::heading, ids, std::span<const float>(&value, 1));
}

struct Snapshot
{
    Population population;
    IndividualId nextId;
    std::size_t templates;
    std::size_t cameras;
};

Snapshot snapshotOf(const SceneDocument& document)
{
    const Scene& scene = document.scene();
    return {scene.population, scene.nextId, scene.templates.size(), scene.cameras.size()};
}

bool isSame(const Snapshot& a, const Snapshot& b)
{
    return a.population == b.population && a.nextId == b.nextId && a.templates == b.templates &&
           a.cameras == b.cameras;
}

/// A random subset of the ids, ascending.
std::vector<IndividualId> someOf(std::span<const IndividualId> ids, std::uint64_t key)
{
    std::vector<IndividualId> chosen;
    for (const IndividualId id : ids) {
        if (hashKeys(key, id) % 7 == 0) {
            chosen.push_back(id);
        }
    }
    return chosen;
}

void randomStep(SceneEdit& edit, std::uint64_t key)
{
    const auto present = edit.scene().population.ids();
    const std::vector<IndividualId> chosen = someOf(present, key);
    switch (hashKeys(key, 1) % 8) {
    case 0:
        (void)edit.addIndividuals(
            IndividualRows::withDefaults(std::vector<IndividualId>(1 + hashKeys(key, 2) % 9)));
        break;
    case 1:
        edit.removeIndividuals(chosen);
        break;
    case 2:
        setHeading(edit, chosen, unitFloat(hashKeys(key, 3)));
        break;
    case 3: {
        std::vector<Tint> tints(chosen.size());
        for (std::size_t i = 0; i < tints.size(); ++i) {
            tints[i].red = static_cast<std::uint8_t>(hashKeys(key, i) % 256);
        }
        edit.setColumn(columns::tint(static_cast<int>(hashKeys(key, 4) % 8)), chosen,
                       std::span<const Tint>(tints));
        break;
    }
    case 4:
        if (edit.scene().templates.size() < 5) {
            edit.addTemplate(TemplateEntry{});
        } else {
            edit.removeTemplate(edit.scene().templates.front().id);
        }
        break;
    case 5: {
        auto cameras = edit.scene().cameras;
        cameras.resize(hashKeys(key, 5) % 4);
        edit.setCameras(cameras);
        break;
    }
    default: {
        std::vector<float> phases(chosen.size());
        std::iota(phases.begin(), phases.end(), unitFloat(hashKeys(key, 6)));
        edit.setColumn(columns::phase, chosen, std::span<const float>(phases));
        break;
    }
    }
}

} // namespace

class tst_SceneDocument : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void makesOneStepOfManyChanges();
    void makesNoStepWhenNothingChangesInTheEnd();
    void makesNoStepWhenTheSceneEndsAsItBegan();
    void rollsBackWhatWasNotCommitted();
    void keepsOriginalValuesOfRemovedIndividuals();
    void keepsOnlyWhatChanged();
    void keepsAssetsThatCameMeanwhile();
    void announcesChangesAfterTheyAreDone();
    void undoesAndRedoesTenThousandRandomEdits();
};

void tst_SceneDocument::makesOneStepOfManyChanges()
{
    SceneDocument document;
    const auto ids = addPeople(document, 3);
    const Snapshot before = snapshotOf(document);
    {
        const auto edit = document.beginEdit();
        setHeading(*edit, std::span(ids).first(2), 1.0F);
        setHeading(*edit, std::span(ids).last(2), 2.0F);
        edit->removeIndividuals(std::span(ids).first(1));
        (void)edit->addIndividuals(IndividualRows::withDefaults({0, 0}));
        QVERIFY(edit->commit(QStringLiteral("Many")));
    }
    const Snapshot after = snapshotOf(document);
    QCOMPARE(document.undoStack().count(), 2);
    document.undoStack().undo();
    QVERIFY(isSame(snapshotOf(document), before));
    document.undoStack().redo();
    QVERIFY(isSame(snapshotOf(document), after));
}

void tst_SceneDocument::makesNoStepWhenNothingChangesInTheEnd()
{
    SceneDocument document;
    const auto ids = addPeople(document, 2);
    const Snapshot before = snapshotOf(document);
    const auto edit = document.beginEdit();
    setHeading(*edit, ids, 1.0F);
    setHeading(*edit, ids, 0.0F);
    const auto extra = edit->addIndividuals(IndividualRows::withDefaults({0}));
    edit->removeIndividuals(extra);
    QVERIFY(!edit->commit(QStringLiteral("Nothing")));
    QCOMPARE(document.undoStack().count(), 1);
    QVERIFY(isSame(snapshotOf(document), before));
}

void tst_SceneDocument::makesNoStepWhenTheSceneEndsAsItBegan()
{
    SceneDocument document;
    TemplateEntry entry;
    entry.clipSpeeds = {std::numeric_limits<float>::quiet_NaN()}; // the asset's own speed
    {
        const auto edit = document.beginEdit();
        entry.id = edit->addTemplate(entry);
        edit->setCameras({NamedCamera{"Front", Camera{}}});
        QVERIFY(edit->commit(QStringLiteral("Set up")));
    }
    const auto edit = document.beginEdit();
    TemplateEntry renamed = entry;
    renamed.name = "Fox";
    edit->changeTemplate(renamed);
    edit->changeTemplate(entry);
    edit->setCameras({});
    edit->setCameras({NamedCamera{"Front", Camera{}}});
    edit->removeStage(edit->addStage(StageEntry{}));
    QVERIFY(!edit->commit(QStringLiteral("Nothing")));
    QCOMPARE(document.undoStack().count(), 1);
}

void tst_SceneDocument::rollsBackWhatWasNotCommitted()
{
    SceneDocument document;
    const auto ids = addPeople(document, 4);
    const Snapshot before = snapshotOf(document);
    {
        const auto edit = document.beginEdit();
        setHeading(*edit, ids, 3.0F);
        edit->removeIndividuals(std::span(ids).subspan(1, 2));
        (void)edit->addIndividuals(IndividualRows::withDefaults({0}));
        edit->rollback();
        QVERIFY(isSame(snapshotOf(document), before));
        edit->removeIndividuals(ids);
    }
    QVERIFY(isSame(snapshotOf(document), before));
    QCOMPARE(document.undoStack().count(), 1);
}

void tst_SceneDocument::keepsOriginalValuesOfRemovedIndividuals()
{
    SceneDocument document;
    const auto ids = addPeople(document, 2);
    const Snapshot before = snapshotOf(document);
    const auto edit = document.beginEdit();
    setHeading(*edit, ids, 5.0F);
    edit->removeIndividuals(ids);
    QVERIFY(edit->commit(QStringLiteral("Turn and remove")));
    document.undoStack().undo();
    QVERIFY(isSame(snapshotOf(document), before));
}

void tst_SceneDocument::keepsOnlyWhatChanged()
{
    SceneDocument document;
    const auto ids = addPeople(document, 100000);
    const auto edit = document.beginEdit();
    std::vector<Tint> tints(ids.size());
    for (std::size_t i = 0; i < tints.size(); ++i) {
        tints[i].green = static_cast<std::uint8_t>(i % 255);
    }
    edit->setColumn(columns::tint(0), ids, std::span<const Tint>(tints));
    QVERIFY(edit->commit(QStringLiteral("Tint")));
    // Ids and new values; the old value, the same for all, is kept once.
    const auto& stack = document.undoStack();
    const auto* command = dynamic_cast<const SceneCommand*>(stack.command(stack.count() - 1));
    QVERIFY(command != nullptr);
    QVERIFY2(command->bytes() < 1700000, qPrintable(QString::number(command->bytes())));
}

void tst_SceneDocument::keepsAssetsThatCameMeanwhile()
{
    SceneDocument document;
    TemplateId id = 0;
    {
        const auto edit = document.beginEdit();
        TemplateEntry entry;
        entry.path = "fox.glb";
        id = edit->addTemplate(entry);
        QVERIFY(edit->commit(QStringLiteral("Import")));
    }
    {
        const auto edit = document.beginEdit();
        TemplateEntry renamed = *document.scene().findTemplate(id);
        renamed.name = "Fox";
        edit->changeTemplate(renamed);
        QVERIFY(edit->commit(QStringLiteral("Rename")));
    }
    document.setTemplateAsset(id, std::make_shared<Template>(), {});
    document.undoStack().undo();
    QVERIFY(document.scene().findTemplate(id)->asset != nullptr);
    QCOMPARE(document.scene().findTemplate(id)->name, std::string());
}

void tst_SceneDocument::announcesChangesAfterTheyAreDone()
{
    SceneDocument document;
    std::size_t seen = 0;
    connect(&document, &SceneDocument::changed, this, [&](const SceneChange& change) {
        if (const auto* added = std::get_if<IndividualsAdded>(&change)) {
            for (const IndividualId id : added->ids) {
                seen += document.scene().population.rowOf(id) != Population::npos ? 1 : 0;
            }
        }
    });
    addPeople(document, 3);
    QCOMPARE(seen, std::size_t{3});
    QVERIFY(document.isModified());
    document.markSaved(QStringLiteral("/tmp/a.crowd"));
    QVERIFY(!document.isModified());
}

void tst_SceneDocument::undoesAndRedoesTenThousandRandomEdits()
{
    SceneDocument document;
    std::vector<Snapshot> states{snapshotOf(document)};
    for (std::uint64_t key = 0; key < 10000; ++key) {
        const auto edit = document.beginEdit();
        for (std::uint64_t step = 0; step <= hashKeys(key, 7) % 3; ++step) {
            randomStep(*edit, hashKeys(key, step));
        }
        if (edit->commit(QStringLiteral("Random")) && key % 100 == 0) {
            states.push_back(snapshotOf(document));
        }
    }
    const Snapshot last = snapshotOf(document);
    const std::string lastBytes = projectToText(document.scene()).value();
    while (document.undoStack().canUndo()) {
        document.undoStack().undo();
    }
    QVERIFY(isSame(snapshotOf(document), states.front()));
    QCOMPARE(projectToText(document.scene()).value(), projectToText(Scene{}).value());
    while (document.undoStack().canRedo()) {
        document.undoStack().redo();
    }
    QVERIFY(isSame(snapshotOf(document), last));
    QCOMPARE(projectToText(document.scene()).value(), lastBytes);
}

QTEST_GUILESS_MAIN(tst_SceneDocument)
#include "tst_SceneDocument.moc"
