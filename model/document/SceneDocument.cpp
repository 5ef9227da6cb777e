// SPDX-License-Identifier: MIT
#include "model/document/SceneDocument.h"

#include <cassert>

#include "model/document/SceneEdit.h"

namespace crowd::model {

SceneDocument::SceneDocument(QObject* parent) : QObject(parent)
{
    qRegisterMetaType<SceneChange>();
    connect(&m_undoStack, &QUndoStack::cleanChanged, this,
            [this](bool isClean) { Q_EMIT modifiedChanged(!isClean); });
}

SceneDocument::~SceneDocument()
{
    assert(!isEditOpen());
    // The stack clears itself while it dies; whoever listened may be gone already.
    m_undoStack.blockSignals(true);
}

void SceneDocument::replaceScene(Scene scene, const QString& path)
{
    assert(!isEditOpen());
    m_scene = std::move(scene);
    m_path = path;
    m_undoStack.clear();
    announce(SceneReplaced{});
    Q_EMIT pathChanged();
}

void SceneDocument::markSaved(const QString& path)
{
    m_undoStack.setClean();
    if (path != m_path) {
        m_path = path;
        Q_EMIT pathChanged();
    }
}

void SceneDocument::setTemplateAsset(TemplateId id, TemplatePtr asset, const std::string& problem)
{
    TemplateEntry* entry = m_scene.findTemplate(id);
    if (entry == nullptr) {
        return; // removed while it was loading
    }
    entry->asset = std::move(asset);
    entry->problem = problem;
    announce(TemplatesChanged{});
}

void SceneDocument::setStageAsset(std::uint8_t id, StagePtr asset, const std::string& problem)
{
    for (StageEntry& entry : m_scene.stages) {
        if (entry.id == id) {
            entry.asset = std::move(asset);
            entry.problem = problem;
            announce(StagesChanged{});
            return;
        }
    }
}

std::unique_ptr<SceneEdit> SceneDocument::beginEdit()
{
    assert(!isEditOpen());
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
    return frame;
}

void SceneDocument::announce(const SceneChange& change)
{
    if (std::holds_alternative<TemplatesChanged>(change) ||
        std::holds_alternative<SceneReplaced>(change)) {
        m_sharedTemplates.reset();
    }
    Q_EMIT changed(change);
}

} // namespace crowd::model
