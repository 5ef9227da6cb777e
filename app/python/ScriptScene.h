// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

#include <QtCore/QCoreApplication>

#include "app/python/ScriptPictures.h"
#include "app/python/ScriptStroke.h"
#include "behavior/surface/GroundKeeper.h"
#include "model/brush/Stroke.h"
#include "model/document/SceneDocument.h"
#include "model/document/SceneEdit.h"
#include "model/pick/StageRays.h"
#include "model/states/ChangeOver.h"

namespace crowd::app {

/// An event as a script sends it.
struct ScriptEvent
{
    std::string name;
    float number = 0.0F; ///< finite
    std::vector<model::IndividualId> ids;
};

/// A document that belongs to somebody else: the editor's. All of it outlives the ScriptScene.
struct ScriptHost
{
    model::SceneDocument* document;
    model::KeyframeStore* keyframes; ///< what is on screen; strokes pick by it
    model::StageRays* stage;         ///< of the host for scripts alone; set before each stroke
    /// Runs work on the thread that the document belongs to, and waits for it.
    std::function<void(const std::function<void()>& work)> run;
    /// To those who play in the host's window, on the document's thread; false: nothing plays.
    std::function<bool(const ScriptEvent& event)> send{};
};

/// Of an undo step. A context of its own: scripts run without any window.
[[nodiscard]] inline QString stepText(const char* text)
{
    return QCoreApplication::translate("Script", text);
}

/// What a script works on: a document with all that painting and drawing need, without a window.
/// Every change goes through the undoable edits that the editor's own tools use. What is refused
/// is refused before anything changes, with a message. Knows nothing of Python. With a host its
/// functions may be called from any one thread at a time: they reach the document, and what is
/// open on it, through ScriptHost::run.
class ScriptScene
{
public:
    ScriptScene(); ///< an empty scene of its own
    explicit ScriptScene(ScriptHost host);
    ~ScriptScene(); ///< takes back an edit that is still open
    ScriptScene(const ScriptScene&) = delete;
    ScriptScene& operator=(const ScriptScene&) = delete;

    /// The scene as it is now, for reading: a snapshot where a host could change it meanwhile. Of a
    /// scene of its own it is the scene itself: only for as long as no other code of Python's runs.
    [[nodiscard]] std::shared_ptr<const model::Scene> scene() const;
    /// A copy that stays as it is, and the revision it is of.
    struct Snapshot
    {
        std::shared_ptr<const model::Scene> scene;
        std::uint64_t revision = 0;
        /// The last recall of a state, and the revision before it; null: none yet.
        std::shared_ptr<const model::ChangeOver> change{};
        std::uint64_t changeRevision = 0;
    };
    [[nodiscard]] Snapshot snapshot() const;
    /// Before a state is recalled: sessions are told by the next snapshot. Where the document is.
    void noteChangeOver(model::ChangeOver change);
    /// Grows with every change.
    [[nodiscard]] std::uint64_t revision() const;
    [[nodiscard]] std::string path() const;
    [[nodiscard]] bool isModified() const;
    /// To the session that the host plays.
    [[nodiscard]] model::Result<void> send(const ScriptEvent& event);

    [[nodiscard]] model::Result<void> open(const std::string& path);
    [[nodiscard]] model::Result<void> save(const std::string& path); ///< empty: where it was opened

    [[nodiscard]] model::Result<bool> undo(); ///< false: there was nothing to undo
    [[nodiscard]] model::Result<bool> redo();
    [[nodiscard]] std::vector<std::string> history() const; ///< texts of all steps
    [[nodiscard]] int historyIndex() const;                 ///< how many of them are done

    /// Everything until endEdit becomes one step (isKept) or is taken back.
    [[nodiscard]] model::Result<void> beginEdit(const std::string& text);
    void endEdit(bool isKept);

    /// How often the id was given out by a script: tells a template from a later one. Under
    /// Python's lock.
    [[nodiscard]] std::uint64_t birthOf(model::TemplateId id) const;
    void noteBirth(model::TemplateId id) { ++m_births[id]; }
    /// Between the two all edits belong to that stroke. The calling thread is Python's.
    void joinStroke(const ScriptStrokeLinkPtr& link);
    void leaveStroke(); ///< does nothing where the host is closing
    [[nodiscard]] ScriptPictures& pictures() { return m_pictures; }
    [[nodiscard]] const ScriptPictures& pictures() const { return m_pictures; }

    // For what scripts do to people, assets and the environment, and how they paint: functions of
    // files of their own.

    /// The result of the work, done on the thread that the document belongs to.
    template<class Action>
    [[nodiscard]] auto onDocument(const Action& work) const
    {
        std::optional<std::invoke_result_t<Action>> result;
        m_host.run([&, caller = std::this_thread::get_id()] {
            m_caller = caller;
            result.emplace(work());
        });
        return std::move(*result);
    }
    using Work = std::function<void(model::SceneEdit&)>;
    /// As part of the open edit, where it is of the thread that asks, or as a step of its own.
    /// Where the document is, within onDocument.
    [[nodiscard]] model::Result<void> edit(const QString& text, const Work& work);
    /// Where the document is, as all that asks what is open.
    [[nodiscard]] model::Result<void> refuseDuringEdit(const char* what) const;
    /// Somebody paints by hand at this moment: threads that a script left behind may come any time.
    [[nodiscard]] model::Result<void> refuseDuringStroke() const;
    /// Where it belongs alone.
    [[nodiscard]] model::SceneDocument& document() { return *m_host.document; }
    [[nodiscard]] model::KeyframeStore& keyframes() { return *m_host.keyframes; }
    [[nodiscard]] model::StageRays& stage() { return *m_host.stage; }
    [[nodiscard]] behavior::GroundKeeper& ground() { return m_ground; }
    /// False in a fork of the process that made it.
    [[nodiscard]] bool isOfThisProcess() const;
    /// The script's own stroke, while its brush paints. Where the document is.
    void holdStroke(std::unique_ptr<model::Stroke> stroke);
    /// Null: it was taken back.
    [[nodiscard]] std::unique_ptr<model::Stroke> takeStroke();
    [[nodiscard]] model::Stroke* heldStroke() const { return m_stroke.get(); }
    /// Takes back what was painted; on any thread.
    void dropStroke();
    /// Whether what is edited now belongs to an edit or a stroke that is open. On any thread.
    [[nodiscard]] bool isInsideEdit() const;
    /// Asks whether a call is to go on; whoever is asked cannot change the scene meanwhile. Empty:
    /// it is.
    [[nodiscard]] bool ask(const model::KeepGoing& keepGoing, double share);
    [[nodiscard]] bool isOwn() const { return m_own != nullptr; } ///< there is no host

private:
    std::shared_ptr<const model::ChangeOver> m_change;
    std::uint64_t m_changeRevision = 0;
    struct OwnParts;

    void dropEdits();
    [[nodiscard]] model::Result<bool> step(bool isUndo);

    std::unique_ptr<OwnParts> m_own; ///< null with a host
    ScriptHost m_host;
    behavior::GroundKeeper m_ground;
    ScriptPictures m_pictures;
    int m_process; ///< that made it
    std::map<model::TemplateId, std::uint64_t> m_births;
    // The document's thread alone.
    std::unique_ptr<model::SceneEdit> m_edit; ///< between beginEdit and endEdit
    QString m_editText;
    std::thread::id m_editor;                ///< who began it
    mutable std::thread::id m_caller;        ///< who asks for what is done now
    ScriptStrokeLinkPtr m_link;              ///< while a script brush paints
    std::unique_ptr<model::Stroke> m_stroke; ///< the script's own stroke, while its brush paints
    QMetaObject::Connection m_interruption;
    std::atomic<int> m_asking{0}; ///< calls that are asking
};

} // namespace crowd::app
