// SPDX-License-Identifier: MIT
#include "app/python/ScriptScene.h"

#include <unistd.h>

#include <QtCore/QFileInfo>

#include "model/project/AssetPaths.h"
#include "model/project/ProjectFile.h"
#include "model/project/SceneAssets.h"

namespace crowd::app {

using namespace model;

struct ScriptScene::OwnParts
{
    SceneDocument document;
    KeyframeStore keyframes{kScriptKeyframeBytes};
    StageRays stage;
};

ScriptScene::ScriptScene()
    : m_own(std::make_unique<OwnParts>()), m_host{&m_own->document, &m_own->keyframes,
                                                  &m_own->stage,
                                                  [](const std::function<void()>& work) {
                                                      work();
                                                  }},
      m_process(getpid())
{
}

ScriptScene::ScriptScene(ScriptHost host) : m_host(std::move(host)), m_process(getpid())
{
    m_interruption = QObject::connect(m_host.document, &SceneDocument::editInterrupted,
                                      m_host.document, [this] { dropEdits(); });
}

/// The host needs its document: what is open is taken back, what the script does next is refused.
void ScriptScene::dropEdits()
{
    m_edit.reset();
    if (m_stroke) {
        m_stroke->cancel();
        m_stroke.reset();
    }
    if (m_link) {
        m_link->abandon();
    }
}

ScriptScene::~ScriptScene()
{
    try {
        m_host.run([this] {
            QObject::disconnect(m_interruption);
            m_stroke.reset(); // takes back what was not finished
            m_edit.reset();
        });
    } catch (const std::exception&) {
        QObject::disconnect(m_interruption);
        (void)m_edit.release(); // the editor is closing: the document goes with all it holds
        (void)m_stroke.release();
    }
}

std::shared_ptr<const Scene> ScriptScene::scene() const
{
    if (m_own) {
        return {&m_own->document.scene(), [](const Scene*) {}}; // stays where it is
    }
    return onDocument([this] { return std::make_shared<const Scene>(m_host.document->scene()); });
}

ScriptScene::Snapshot ScriptScene::snapshot() const
{
    return onDocument([this]() -> Snapshot {
        return {std::make_shared<const Scene>(m_host.document->scene()),
                m_host.document->revision(), m_change, m_changeRevision};
    });
}

void ScriptScene::noteChangeOver(ChangeOver change)
{
    m_change = std::make_shared<const ChangeOver>(std::move(change));
    m_changeRevision = m_host.document->revision();
}

std::uint64_t ScriptScene::revision() const
{
    return onDocument([this] { return m_host.document->revision(); });
}

Result<void> ScriptScene::send(const ScriptEvent& event)
{
    if (!m_host.send) {
        return Error{"Nothing plays here: make a session and send it the event, as in "
                     "crowdbrush.Session(scene).send(\"" +
                     event.name + "\")."};
    }
    if (!onDocument([&] { return m_host.send(event); })) {
        return Error{"The event \"" + event.name +
                     "\" is not sent, since nobody plays: press play first."};
    }
    return {};
}

std::string ScriptScene::path() const
{
    return onDocument([this] { return m_host.document->path().toStdString(); });
}

bool ScriptScene::isModified() const
{
    return onDocument([this] { return m_host.document->isModified(); });
}

Result<void> ScriptScene::open(const std::string& path)
{
    if (!m_own) {
        return Error{"The editor's scene stays in its window: open another one with "
                     "crowdbrush.open(path), or choose File > Open."};
    }
    const QString file = isBuiltin(path)
                             ? assetFile(path)
                             : QFileInfo(QString::fromStdString(path)).absoluteFilePath();
    auto scene = loadScene(file);
    if (!scene) {
        return scene.error();
    }
    // A ready-made scene is not saved over: it has no file yet.
    m_own->document.replaceScene(std::move(scene).value(), isBuiltin(path) ? QString() : file);
    return {};
}

Result<void> ScriptScene::save(const std::string& path)
{
    return onDocument([&]() -> Result<void> {
        if (auto allowed = refuseDuringEdit("Saving"); !allowed) {
            return allowed;
        }
        SceneDocument& document = *m_host.document;
        if (auto allowed = refuseDuringStroke(); !allowed) {
            return allowed;
        }
        if (path.empty() && document.path().isEmpty()) {
            return Error{
                "The scene has no file yet: say where, as in scene.save(\"crowd.crowd\")."};
        }
        const QString file = path.empty()
                                 ? document.path()
                                 : QFileInfo(QString::fromStdString(path)).absoluteFilePath();
        if (auto saved = saveProject(document.scene(), file); !saved) {
            return saved;
        }
        document.markSaved(file);
        return {};
    });
}

std::uint64_t ScriptScene::birthOf(TemplateId id) const
{
    const auto found = m_births.find(id);
    return found == m_births.end() ? 0 : found->second;
}

Result<void> ScriptScene::refuseDuringEdit(const char* what) const
{
    if (m_asking > 0) {
        return Error{"A longer call is at work on this scene: change nothing until it is done, nor "
                     "in its progress."};
    }
    if (m_link) {
        return Error{std::string(what) +
                     " is not possible in a brush: all it does belongs to one stroke."};
    }
    if (m_edit) {
        return Error{std::string(what) +
                     " is not possible inside 'with scene.edit(...)': end that block first."};
    }
    return {};
}

Result<void> ScriptScene::refuseDuringStroke() const
{
    if (m_stroke && !m_link) {
        return Error{"A stroke is being painted on this scene: try again when it has ended."};
    }
    if (!m_edit && !m_link && m_host.document->isEditOpen()) {
        return Error{"Somebody is painting in the window: try again when the stroke has ended."};
    }
    return {};
}

Result<bool> ScriptScene::step(bool isUndo)
{
    return onDocument([&]() -> Result<bool> {
        if (auto allowed = refuseDuringEdit(isUndo ? "Undo" : "Redo"); !allowed) {
            return allowed.error();
        }
        if (auto allowed = refuseDuringStroke(); !allowed) {
            return allowed.error();
        }
        QUndoStack& stack = m_host.document->undoStack();
        if (!(isUndo ? stack.canUndo() : stack.canRedo())) {
            return false;
        }
        QString refusal;
        const auto connection = QObject::connect(m_host.document, &SceneDocument::undoRefused,
                                                 [&refusal](const QString& why) { refusal = why; });
        isUndo ? stack.undo() : stack.redo();
        QObject::disconnect(connection);
        if (!refusal.isEmpty()) {
            return Error{refusal.toStdString()};
        }
        return true;
    });
}

Result<bool> ScriptScene::undo()
{
    return step(true);
}

Result<bool> ScriptScene::redo()
{
    return step(false);
}

std::vector<std::string> ScriptScene::history() const
{
    return onDocument([this] {
        std::vector<std::string> texts;
        const QUndoStack& stack = m_host.document->undoStack();
        texts.reserve(static_cast<std::size_t>(stack.count()));
        for (int i = 0; i < stack.count(); ++i) {
            texts.push_back(stack.text(i).toStdString());
        }
        return texts;
    });
}

int ScriptScene::historyIndex() const
{
    return onDocument([this] { return m_host.document->undoStack().index(); });
}

Result<void> ScriptScene::beginEdit(const std::string& text)
{
    return onDocument([&]() -> Result<void> {
        if (auto allowed = refuseDuringEdit("Another edit"); !allowed) {
            return allowed;
        }
        if (auto allowed = refuseDuringStroke(); !allowed) {
            return allowed;
        }
        auto begun = m_host.document->beginEdit();
        if (!begun) {
            return begun.error();
        }
        m_edit = std::move(begun).value();
        m_editText = QString::fromStdString(text);
        m_editor = m_caller;
        return {};
    });
}

void ScriptScene::endEdit(bool isKept)
{
    m_host.run([this, isKept] {
        if (m_edit && isKept) {
            m_edit->commit(m_editText);
        }
        m_edit.reset(); // takes back what was not committed
    });
}

void ScriptScene::joinStroke(const ScriptStrokeLinkPtr& link)
{
    m_host.run([&] { m_link = link; });
}

void ScriptScene::leaveStroke()
{
    try {
        m_host.run([this] { m_link.reset(); });
    } catch (const std::exception&) {
        return; // the editor is closing: nobody will edit any more
    }
}

Result<void> ScriptScene::edit(const QString& text, const Work& work)
{
    if (m_asking > 0) {
        return Error{"A longer call is at work on this scene: change nothing until it is done, nor "
                     "in its progress."};
    }
    if (m_link) {
        if (m_link->edit() == nullptr) {
            return Error{"The stroke was taken back."};
        }
        work(*m_link->edit());
        return {};
    }
    if (m_edit && m_caller != m_editor) {
        return Error{"Another thread is inside 'with scene.edit(\"" + m_editText.toStdString() +
                     "\")': wait until that block has ended."};
    }
    if (m_edit) {
        work(*m_edit);
        return {};
    }
    if (auto allowed = refuseDuringStroke(); !allowed) {
        return allowed;
    }
    const auto own = m_host.document->beginEdit();
    if (!own) {
        return own.error();
    }
    work(*own.value());
    own.value()->commit(text);
    return {};
}

bool ScriptScene::isInsideEdit() const
{
    return onDocument([this] { return m_edit != nullptr || m_link != nullptr; });
}

bool ScriptScene::ask(const KeepGoing& keepGoing, double share)
{
    if (!keepGoing) {
        return true;
    }
    ++m_asking;
    const bool goesOn = keepGoing(share); // throws nothing: what was raised waits with the asker
    --m_asking;
    return goesOn;
}

bool ScriptScene::isOfThisProcess() const
{
    return m_process == getpid();
}

void ScriptScene::holdStroke(std::unique_ptr<Stroke> stroke)
{
    m_stroke = std::move(stroke);
}

std::unique_ptr<Stroke> ScriptScene::takeStroke()
{
    return std::move(m_stroke);
}

void ScriptScene::dropStroke()
{
    m_host.run([this] { m_stroke.reset(); });
}

} // namespace crowd::app
