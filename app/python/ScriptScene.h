// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>

#include "app/pictures/PictureMaker.h"
#include "app/python/ScriptStroke.h"
#include "behavior/session/SessionPose.h"
#include "behavior/surface/GroundKeeper.h"
#include "model/brush/Stroke.h"
#include "model/document/SceneDocument.h"
#include "model/document/SceneEdit.h"
#include "model/pick/StageRays.h"

namespace crowd::app {

/// Values for some columns of some individuals, as a script gives them: each n × stride bytes, in
/// the order of the ids it goes with.
struct ColumnValues
{
    model::ColumnId column = model::ColumnId::Position;
    std::vector<std::byte> bytes;
};

/// A stroke as a script asks for it. Points in logical pixels of a view of this size.
struct ScriptStroke
{
    model::BrushSettings settings;
    std::vector<model::PointerInput> inputs; ///< never empty
    std::optional<model::Camera> camera;     ///< the scene's first one without
    glm::vec2 viewSize{1280.0F, 720.0F};
    std::uint64_t seed = 1;
};

/// Does work that takes long, on whatever thread, and returns when it is done. May cancel it, and
/// then throws.
using Patience =
    std::function<void(std::atomic<bool>& isCancelled, const std::function<void()>& work)>;

/// A picture as a script asks for it.
struct ScriptPicture
{
    glm::ivec2 size{1280, 720};
    std::optional<model::Camera> camera; ///< the scene's first one without
    double seconds = 0.0;                ///< of the transport
    model::CrowdFramePtr frame;          ///< people; null: as the scene shows them at that time
    render::Look look = render::Look::Lit;
    Patience patience = [](std::atomic<bool>&, const std::function<void()>& work) { work(); };
};

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
    };
    [[nodiscard]] Snapshot snapshot() const;
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

    /// Loads the entry's file. An id of 0 stands for the next free one, an empty name for the
    /// file's own.
    [[nodiscard]] model::Result<model::TemplateId> addTemplate(model::TemplateEntry entry);
    /// How often the id was given out by a script: tells a template from a later one. Under
    /// Python's lock.
    [[nodiscard]] std::uint64_t birthOf(model::TemplateId id) const;
    void noteBirth(model::TemplateId id) { ++m_births[id]; }
    /// By id; loads the file again where path, import or speeds are others.
    [[nodiscard]] model::Result<void> changeTemplate(model::TemplateEntry entry);
    [[nodiscard]] model::Result<void> removeTemplate(model::TemplateId id); ///< that nobody uses
    [[nodiscard]] model::Result<std::uint8_t> addStage(model::StageEntry entry);
    [[nodiscard]] model::Result<void> changeStage(model::StageEntry entry);
    [[nodiscard]] model::Result<void> removeStage(std::uint8_t id);
    [[nodiscard]] model::Result<void> setCamera(const std::string& name,
                                                const model::Camera& camera);
    [[nodiscard]] model::Result<void> removeCamera(const std::string& name);
    /// All of them, in this order.
    [[nodiscard]] model::Result<void> setCameras(std::vector<model::NamedCamera> cameras);
    [[nodiscard]] model::Result<void> setLighting(model::Lighting lighting);
    /// Places, paths, tags and rules as JSON: see readEnvironmentText.
    [[nodiscard]] model::Result<void> setEnvironment(const std::string& text, bool isStrict);
    [[nodiscard]] model::Result<model::Camera> camera(const std::string& name) const;

    /// n individuals with these values; the rest gets the defaults of their templates. Their ids.
    [[nodiscard]] model::Result<std::vector<model::IndividualId>>
    create(std::size_t n, std::span<const ColumnValues> values);
    /// Ids ascending, all alive.
    [[nodiscard]] model::Result<void> remove(std::span<const model::IndividualId> ids);
    [[nodiscard]] model::Result<void> change(std::span<const model::IndividualId> ids,
                                             std::span<const ColumnValues> values);

    /// People become as a session shows them: as part of the open edit, or as a step of its own.
    /// How many are another way than before.
    /// `after`: as the scene is then.
    [[nodiscard]] model::Result<int> keepPose(const model::Population& shown,
                                              const behavior::SessionPose& pose, Snapshot& after);

    /// Those of them who stand where nobody can walk come to the nearest ground: one step. How
    /// many. Ids ascending, all alive.
    [[nodiscard]] model::Result<int> putOnGround(std::span<const model::IndividualId> ids);

    /// Of brush kind Script: `paint` gets the dabs, on the calling thread; what it throws takes the
    /// stroke back and goes on.
    using PaintWork = std::function<void(ScriptStrokeLink& dabs)>;
    [[nodiscard]] model::Result<model::StrokeOutcome> stroke(const ScriptStroke& stroke,
                                                             const PaintWork& paint = {});
    /// Between the two all edits belong to that stroke. The calling thread is Python's.
    void joinStroke(const ScriptStrokeLinkPtr& link);
    void leaveStroke(); ///< does nothing where the host is closing
    /// RGBA8, sRGB, rows from the top.
    [[nodiscard]] model::Result<std::vector<std::uint8_t>> picture(const ScriptPicture& picture);
    /// The thread that a picture is being drawn on; none else. Another one waits until it is done.
    [[nodiscard]] std::thread::id drawingThread() const { return m_drawing; }

private:
    using Work = std::function<void(model::SceneEdit&)>;
    struct OwnParts;
    struct Motion;

    template<class Action>
    [[nodiscard]] auto onDocument(const Action& work) const;
    /// As part of the open edit, or as a step of its own. Where the document is.
    [[nodiscard]] model::Result<void> edit(const QString& text, const Work& work);
    [[nodiscard]] model::Result<void> refuseDuringEdit(const char* what) const;
    [[nodiscard]] model::Result<void> refuseDuringStroke() const;
    [[nodiscard]] model::Result<model::StrokeOutcome>
    scriptStroke(const model::RecordedStroke& recording, const PaintWork& paint);
    void dropEdits();
    [[nodiscard]] model::Result<bool> step(bool isUndo);
    [[nodiscard]] model::CrowdFramePtr frameAt(double seconds, const Patience& patience);
    [[nodiscard]] model::Result<std::vector<std::uint8_t>> draw(const ScriptPicture& picture);

    std::unique_ptr<OwnParts> m_own; ///< null with a host
    ScriptHost m_host;
    behavior::GroundKeeper m_ground;
    model::KeyframeStore m_pictureKeyframes; ///< pictures wait for all of it, whatever else goes on
    std::unique_ptr<PictureMaker> m_pictures; ///< made when first asked for
    std::unique_ptr<Motion> m_motion;         ///< of the pictures, where the scene has behaviour
    std::thread::id m_drawing;
    int m_process; ///< that made it
    std::map<model::TemplateId, std::uint64_t> m_births;
    // The document's thread alone.
    std::unique_ptr<model::SceneEdit> m_edit; ///< between beginEdit and endEdit
    QString m_editText;
    ScriptStrokeLinkPtr m_link;              ///< while a script brush paints
    std::unique_ptr<model::Stroke> m_stroke; ///< the script's own stroke, while its brush paints
    QMetaObject::Connection m_interruption;
    std::uint64_t m_pictureCount = 0;
};

} // namespace crowd::app
