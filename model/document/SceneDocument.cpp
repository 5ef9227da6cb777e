// SPDX-License-Identifier: MIT
#include "model/document/SceneDocument.h"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <utility>

#include "model/base/Translated.h"
#include "model/document/SceneCommand.h"
#include "model/document/SceneDelta.h"
#include "model/document/SceneEdit.h"

namespace crowd::model {

SceneDocument::SceneDocument(UndoLimits limits, QObject* parent)
    : QObject(parent), m_undoMemory(std::move(limits))
{
    qRegisterMetaType<SceneChange>();
    connect(&m_undoStack, &QUndoStack::cleanChanged, this,
            [this](bool isClean) { Q_EMIT modifiedChanged(!isClean); });
    connect(&m_undoStack, &QUndoStack::indexChanged, this, &SceneDocument::settleRefusal);
}

SceneDocument::~SceneDocument()
{
    assert(!isEditOpen());
    // The stack clears itself while it dies; whoever listened may be gone already.
    m_undoStack.blockSignals(true);
}

void SceneDocument::countBesideUndo(std::size_t bytes)
{
    m_undoMemory.setHeldBeside(bytes);
}

void SceneDocument::setUndoBudget(std::size_t bytes)
{
    m_undoMemory.setBudget(bytes);
    watchUndoMemory();
    Q_EMIT undoBudgetChanged();
}

void SceneDocument::interruptEdit()
{
    if (isEditOpen()) {
        Q_EMIT editInterrupted();
    }
    assert(!isEditOpen());
}

void SceneDocument::replaceScene(Scene scene, const QString& path)
{
    interruptEdit();
    m_scene = std::move(scene);
    m_earlier = {m_scene.population, m_scene.population, m_scene.population};
    m_path = path;
    m_undoStack.clear();
    announce(SceneReplaced{});
    Q_EMIT pathChanged();
}

void SceneDocument::markSaved(const QString& path)
{
    m_undoStack.setClean();
    m_earlier.saved = m_scene.population;
    if (path != m_path) {
        m_path = path;
        Q_EMIT pathChanged();
    }
}

EditOutcome SceneDocument::edit(const QString& text, const std::function<void(SceneEdit&)>& work)
{
    return edit([&](SceneEdit& edit) {
        work(edit);
        return text;
    });
}

EditOutcome SceneDocument::edit(const std::function<QString(SceneEdit&)>& work)
{
    const auto begun = beginEdit();
    if (!begun) {
        return EditOutcome::Refused;
    }
    const QString text = work(*begun.value());
    return begun.value()->commit(text) ? EditOutcome::Committed : EditOutcome::Unchanged;
}

Result<std::unique_ptr<SceneEdit>> SceneDocument::beginEdit()
{
    if (isEditOpen()) {
        const Error refused(QT_TRANSLATE_NOOP(
            "Messages", "Something else is being edited: finish or cancel (Esc) it first."));
        Q_EMIT editRefused(translated(refused));
        return refused;
    }
    return std::unique_ptr<SceneEdit>(new SceneEdit(*this));
}

CrowdFramePtr SceneDocument::frame(double seconds) const
{
    if (!m_sharedTemplates) {
        m_sharedTemplates = std::make_shared<const std::vector<TemplateEntry>>(m_scene.templates);
    }
    auto frame = std::make_shared<CrowdFrame>();
    frame->population = m_scene.population;
    frame->templates = m_sharedTemplates;
    frame->seconds = seconds;
    frame->hiddenGroups = groupsThat(m_scene.groups, &Group::isHidden);
    return frame;
}

/// A stroke that is laid anew creates the same people once more.
void SceneDocument::noteCreated(const SceneDelta& delta)
{
    const std::vector<IndividualId>& added = delta.added.ids;
    if (added.empty()) {
        return;
    }
    std::vector<IndividualId> known;
    std::ranges::copy_if(added, std::back_inserter(known), [this](IndividualId id) {
        return m_earlier.created.rowOf(id) != Population::npos;
    });
    (void)m_earlier.created.remove(known);
    m_earlier.created.add(m_scene.population.rows(added));
}

void SceneDocument::push(SceneDelta delta, const QString& text, const RecordedStroke* stroke)
{
    noteCreated(delta);
    Q_EMIT stepCommitted({&delta, text, stroke});
    m_undoStack.push(new SceneCommand(*this, std::move(delta), text));
    watchUndoMemory();
}

bool SceneDocument::applyStep(StoredDelta& stored, DeltaDirection direction)
{
    if (m_refusal) {
        return false;
    }
    if (isEditOpen()) {
        m_refusal = tr("Finish or cancel (Esc) what you are doing first.");
        return false;
    }
    const Result<const SceneDelta*> delta = stored.use();
    if (!delta) {
        m_refusal = tr("This step cannot be taken: %1. The scene is unharmed; save it. What was "
                       "done since can still be undone and redone.")
                        .arg(translated(delta.error()));
        return false;
    }
    applyDelta(m_scene, *delta.value(), direction,
               [this](const SceneChange& change) { announce(change); });
    Q_EMIT stepTaken(direction == DeltaDirection::Undo);
    watchUndoMemory();
    return true;
}

void SceneDocument::settleRefusal()
{
    if (!m_refusal) {
        return;
    }
    const QString why = *std::exchange(m_refusal, std::nullopt);
    // The stack has moved its index although the step was not taken: back to what is applied.
    int applied = 0;
    while (applied < m_undoStack.count() &&
           dynamic_cast<const SceneCommand&>(*m_undoStack.command(applied)).isApplied()) {
        ++applied;
    }
    m_undoStack.setIndex(applied);
    Q_EMIT undoRefused(why);
}

void SceneDocument::watchUndoMemory()
{
    const Message& problem = m_undoMemory.problem();
    if (!problem.empty() && !m_isMemoryExceeded) {
        Q_EMIT undoMemoryExceeded(
            tr("Undo takes %1 MB of memory and cannot use the disk: %2. Nothing is lost; make room "
               "there, or save and reopen the scene to forget its undo steps.")
                .arg(m_undoMemory.bytes() >> 20U)
                .arg(translated(problem)));
    }
    m_isMemoryExceeded = !problem.empty();
}

void SceneDocument::announce(const SceneChange& change)
{
    ++m_revision;
    if (std::holds_alternative<TemplatesChanged>(change) ||
        std::holds_alternative<SceneReplaced>(change)) {
        m_sharedTemplates.reset();
    }
    Q_EMIT changed(change);
}

} // namespace crowd::model
