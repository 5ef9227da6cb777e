// SPDX-License-Identifier: MIT
#include "model/document/SceneDocument.h"

#include <cmath>
#include <limits>

#include <QtTest/QSignalSpy>
#include <QtTest/QTest>

#include "model/document/SceneCommand.h"
#include "model/document/SceneEdit.h"
#include "tests/model/RandomEdits.h"
#include "tests/program/Test.h"

using namespace crowd::model;
using namespace crowd::testing;

namespace {

void setHeading(SceneEdit& edit, std::span<const IndividualId> ids, float value)
{
    edit.setColumn(columns::heading, ids, std::span<const float>(&value, 1));
}

} // namespace

class tst_SceneDocument : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void makesOneStepOfManyChanges();
    void makesNoStepWhenNothingChangesInTheEnd();
    void makesNoStepWhenTheSceneEndsAsItBegan();
    void tellsZeroFromMinusZero();
    void givesOutIdsOfEntriesUntilNoneIsLeft();
    void rollsBackWhatWasNotCommitted();
    void refusesUndoWhileAnEditIsOpen();
    void refusesASecondEdit();
    void saysWhatBecameOfAnEdit();
    void interruptsAnOpenEditForAnotherScene();
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
        const auto edit = document.beginEdit().value();
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
    const auto edit = document.beginEdit().value();
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
        const auto edit = document.beginEdit().value();
        entry.id = edit->addTemplate(entry);
        edit->setCameras({NamedCamera{"Front", Camera{}}});
        QVERIFY(edit->commit(QStringLiteral("Set up")));
    }
    const auto edit = document.beginEdit().value();
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

void tst_SceneDocument::tellsZeroFromMinusZero()
{
    SceneDocument document;
    Lighting light;
    light.sunAzimuthRadians = -0.0F;
    {
        const auto edit = document.beginEdit().value();
        light.sunAzimuthRadians = 0.0F;
        edit->setLighting(light);
        StageEntry stage;
        (void)edit->addStage(stage);
        QVERIFY(edit->commit(QStringLiteral("Set up")));
    }
    const auto edit = document.beginEdit().value();
    light.sunAzimuthRadians = -0.0F;
    edit->setLighting(light);
    QVERIFY(edit->commit(QStringLiteral("Turn the sun by nothing")));
    StageEntry stage = document.scene().stages.front();
    stage.headingRadians = -0.0F;
    const auto second = document.beginEdit().value();
    second->changeStage(stage);
    QVERIFY(second->commit(QStringLiteral("Turn the stage by nothing")));
    document.undoStack().setIndex(1);
    QVERIFY(!std::signbit(document.scene().lighting.sunAzimuthRadians));
    QVERIFY(!std::signbit(document.scene().stages.front().headingRadians));
    document.undoStack().setIndex(3);
    QVERIFY(std::signbit(document.scene().lighting.sunAzimuthRadians));
    QVERIFY(std::signbit(document.scene().stages.front().headingRadians));
}

void tst_SceneDocument::givesOutIdsOfEntriesUntilNoneIsLeft()
{
    SceneDocument document;
    const auto edit = document.beginEdit().value();
    StageEntry last;
    last.id = 255;
    QCOMPARE(int{edit->addStage(last)}, 255);
    for (int id = 1; id < 255; ++id) {
        QCOMPARE(int{edit->addStage(StageEntry{})}, id);
    }
    QCOMPARE(int{edit->addStage(StageEntry{})}, 0);
    QCOMPARE(document.scene().stages.size(), std::size_t{255});
    edit->removeStage(7);
    QCOMPARE(int{edit->addStage(StageEntry{})}, 7);
}

void tst_SceneDocument::refusesUndoWhileAnEditIsOpen()
{
    SceneDocument document;
    const auto ids = addPeople(document, 2);
    QString refusal;
    connect(&document, &SceneDocument::undoRefused, this,
            [&refusal](const QString& why) { refusal = why; });
    auto edit = document.beginEdit().value();
    setHeading(*edit, ids, 1.0F);
    document.undoStack().undo();
    QVERIFY(!refusal.isEmpty());
    QCOMPARE(document.undoStack().index(), 1);
    QCOMPARE(document.scene().population.size(), std::size_t{2});
    edit.reset();
    document.undoStack().undo();
    QCOMPARE(document.scene().population.size(), std::size_t{0});
}

void tst_SceneDocument::refusesASecondEdit()
{
    SceneDocument document;
    const auto ids = addPeople(document, 2);
    QSignalSpy refused(&document, &SceneDocument::editRefused);
    auto open = document.beginEdit().value();
    const Snapshot before = snapshotOf(document);
    bool isDone = false;
    QCOMPARE(document.edit(QStringLiteral("Second"), [&](SceneEdit&) { isDone = true; }),
             EditOutcome::Refused);
    QVERIFY(!isDone);
    const auto second = document.beginEdit();
    QVERIFY(!second);
    QVERIFY(!second.error().message.empty());
    QCOMPARE(refused.count(), 2);
    QVERIFY(isSame(snapshotOf(document), before));
    QCOMPARE(document.undoStack().count(), 1);
    open.reset();
    QCOMPARE(document.edit(QStringLiteral("Turn"),
                           [&](SceneEdit& edit) { setHeading(edit, ids, 1.0F); }),
             EditOutcome::Committed);
    QCOMPARE(refused.count(), 2);
}

void tst_SceneDocument::saysWhatBecameOfAnEdit()
{
    SceneDocument document;
    const auto ids = addPeople(document, 2);
    QCOMPARE(document.edit(QStringLiteral("Nothing"), [](SceneEdit&) {}), EditOutcome::Unchanged);
    QCOMPARE(document.undoStack().count(), 1);
    QCOMPARE(document.edit([&](SceneEdit& edit) {
        setHeading(edit, ids, 2.0F);
        return QStringLiteral("Turned 2");
    }),
             EditOutcome::Committed);
    QCOMPARE(document.undoStack().undoText(), QStringLiteral("Turned 2"));
}

void tst_SceneDocument::interruptsAnOpenEditForAnotherScene()
{
    SceneDocument document;
    const auto ids = addPeople(document, 2);
    auto edit = document.beginEdit().value();
    setHeading(*edit, ids, 1.0F);
    float headingAtEnd = -1.0F;
    connect(&document, &SceneDocument::editInterrupted, this, [&] {
        edit.reset();
        headingAtEnd = document.scene().population.column(columns::heading)[0];
    });
    document.replaceScene(Scene{}, QString());
    QCOMPARE(headingAtEnd, 0.0F);
    QVERIFY(document.scene().population.isEmpty());
    QVERIFY(!document.isEditOpen());
}

void tst_SceneDocument::rollsBackWhatWasNotCommitted()
{
    SceneDocument document;
    const auto ids = addPeople(document, 4);
    const Snapshot before = snapshotOf(document);
    {
        const auto edit = document.beginEdit().value();
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
    const auto edit = document.beginEdit().value();
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
    const auto edit = document.beginEdit().value();
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
    QVERIFY2(command->delta().bytes() < 1700000,
             qPrintable(QString::number(command->delta().bytes())));
}

void tst_SceneDocument::keepsAssetsThatCameMeanwhile()
{
    SceneDocument document;
    TemplateId id = 0;
    {
        const auto edit = document.beginEdit().value();
        TemplateEntry entry;
        entry.path = "fox.glb";
        id = edit->addTemplate(entry);
        QVERIFY(edit->commit(QStringLiteral("Import")));
    }
    {
        const auto edit = document.beginEdit().value();
        TemplateEntry renamed = *document.scene().findTemplate(id);
        renamed.name = "Fox";
        edit->changeTemplate(renamed);
        QVERIFY(edit->commit(QStringLiteral("Rename")));
    }
    {
        const auto edit = document.beginEdit().value();
        TemplateEntry located = *document.scene().findTemplate(id);
        located.asset = std::make_shared<Template>();
        edit->changeTemplate(located);
        QVERIFY(edit->commit(QStringLiteral("Locate assets")));
    }
    document.undoStack().setIndex(1);
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
    const Snapshot first = snapshotOf(document);
    for (std::uint64_t key = 0; key < 10000; ++key) {
        (void)randomEdit(document, key);
    }
    const Snapshot last = snapshotOf(document);
    const std::string lastBytes = sceneText(document.scene());
    while (document.undoStack().canUndo()) {
        document.undoStack().undo();
    }
    QVERIFY(isSame(snapshotOf(document), first));
    QCOMPARE(sceneText(document.scene()), sceneText(Scene{}));
    while (document.undoStack().canRedo()) {
        document.undoStack().redo();
    }
    QVERIFY(isSame(snapshotOf(document), last));
    QCOMPARE(sceneText(document.scene()), lastBytes);
}

CROWD_TEST(tst_SceneDocument)
#include "tst_SceneDocument.moc"
