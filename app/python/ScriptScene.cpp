// SPDX-License-Identifier: MIT
#include "app/python/ScriptScene.h"

#include <unistd.h>

#include <QtCore/QFileInfo>

#include "app/python/ScriptSceneParts.h"
#include "model/project/AssetPaths.h"
#include "model/project/ProjectFile.h"
#include "model/project/SceneAssets.h"

namespace crowd::app {

using namespace model;

namespace {

constexpr std::size_t kKeyframeBytes = std::size_t{2} << 30U;

} // namespace

struct ScriptScene::OwnParts
{
    SceneDocument document;
    KeyframeStore keyframes{kKeyframeBytes};
    StageRays stage;
};

ScriptScene::ScriptScene()
    : m_own(std::make_unique<OwnParts>()), m_host{&m_own->document, &m_own->keyframes,
                                                  &m_own->stage,
                                                  [](const std::function<void()>& work) {
                                                      work();
                                                  }},
      m_pictureKeyframes(kKeyframeBytes), m_process(getpid())
{
}

ScriptScene::ScriptScene(ScriptHost host)
    : m_host(std::move(host)), m_pictureKeyframes(kKeyframeBytes), m_process(getpid())
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
                m_host.document->revision()};
    });
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

} // namespace crowd::app
