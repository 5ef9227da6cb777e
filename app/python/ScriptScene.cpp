// SPDX-License-Identifier: MIT
#include "app/python/ScriptScene.h"

#include <algorithm>
#include <bit>
#include <set>
#include <type_traits>

#include <QtCore/QCoreApplication>
#include <QtCore/QFileInfo>

#include "app/python/BrushRules.h"
#include "app/python/ColumnRules.h"
#include "model/project/AssetPaths.h"
#include "model/project/EnvironmentText.h"
#include "model/project/ProjectFile.h"
#include "model/project/SceneAssets.h"

namespace crowd::app {

using namespace model;

namespace {

constexpr std::size_t kKeyframeBytes = std::size_t{2} << 30U;

/// Of an undo step. A context of its own: scripts run without any window.
QString stepText(const char* text)
{
    return QCoreApplication::translate("Script", text);
}

/// As entries of a scene hold it.
std::string absolute(const std::string& path)
{
    return isBuiltin(path)
               ? path
               : QFileInfo(QString::fromStdString(path)).absoluteFilePath().toStdString();
}

Result<Camera> cameraOrFirst(const Scene& scene, const std::optional<Camera>& camera)
{
    if (camera) {
        return *camera;
    }
    if (scene.cameras.empty()) {
        return Error{"The scene has no camera: give one, as in "
                     "camera=crowdbrush.Camera((0, 5, 10), (0, 0, 0))."};
    }
    return scene.cameras.front().camera;
}

template<class Entry>
bool isAmong(const std::vector<Entry>& entries, const Entry& wanted)
{
    const auto found = std::ranges::find(entries, wanted.id, &Entry::id);
    return found != entries.end() && *found == wanted;
}

/// Ids in `now` that `wanted` lacks.
template<class Entry>
auto missingIds(const std::vector<Entry>& now, const std::vector<Entry>& wanted)
{
    std::vector<decltype(Entry::id)> ids;
    for (const Entry& each : now) {
        if (std::ranges::find(wanted, each.id, &Entry::id) == wanted.end()) {
            ids.push_back(each.id);
        }
    }
    return ids;
}

void putPaths(SceneEdit& edit, const Scene& wanted)
{
    for (const Path& each : wanted.paths) {
        if (!isAmong(edit.scene().paths, each)) {
            edit.changePath(each);
        }
    }
}

void putEnvironment(SceneEdit& edit, const Scene& wanted)
{
    for (const Place& each : wanted.places) {
        if (!isAmong(edit.scene().places, each)) {
            edit.changePlace(each);
        }
    }
    putPaths(edit, wanted);
    for (const PathId id : missingIds(edit.scene().paths, wanted.paths)) {
        edit.removePath(id);
    }
    for (const PlaceId id : missingIds(edit.scene().places, wanted.places)) {
        edit.removePlace(id);
    }
    putPaths(edit, wanted); // who lost a place or a branch with those
    edit.setRules(wanted.rules);
    edit.setTags(wanted.tags);
    edit.setNumbers(wanted.numbers);
    edit.setCues(wanted.cues);
    if (wanted.surface != edit.scene().surface) {
        edit.setSurface(wanted.surface);
    }
    edit.setStepsPerSecond(wanted.stepsPerSecond);
}

Error noTemplate(TemplateId id)
{
    return Error{"The scene has no template " + std::to_string(id) +
                 ": take one of scene.templates."};
}

Error noStage(std::uint8_t id)
{
    return Error{"The scene has no stage " + std::to_string(id) + ": take one of scene.stages."};
}

/// Bit by bit: NaN stands for the file's own speed.
bool sameNumbers(const std::vector<float>& a, const std::vector<float>& b)
{
    return std::ranges::equal(a, b, [](float left, float right) {
        return std::bit_cast<std::uint32_t>(left) == std::bit_cast<std::uint32_t>(right);
    });
}

void bakeAllShown(const Scene& scene, KeyframeStore& keyframes)
{
    const auto templates = scene.population.column(columns::templateId);
    const auto clips = scene.population.column(columns::clip);
    std::set<std::pair<TemplateId, std::uint16_t>> shown;
    for (std::size_t row = 0; row < templates.size(); ++row) {
        const bool isLikeBefore =
            row > 0 && templates[row] == templates[row - 1] && clips[row] == clips[row - 1];
        if (!isLikeBefore) {
            shown.emplace(templates[row], clips[row]);
        }
    }
    for (const auto& [id, clip] : shown) {
        const TemplateEntry* entry = scene.findTemplate(id);
        if (entry != nullptr && entry->asset && clip < entry->asset->clips.size()) {
            (void)keyframes.clip(entry->asset, clip);
        }
    }
    keyframes.waitForAll();
}

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
      m_pictureKeyframes(kKeyframeBytes)
{
}

ScriptScene::ScriptScene(ScriptHost host)
    : m_host(std::move(host)), m_pictureKeyframes(kKeyframeBytes)
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
    QObject::disconnect(m_interruption);
    if (m_edit) {
        try {
            endEdit(false);
        } catch (const std::exception&) {
            (void)m_edit.release(); // the editor is closing: the document goes with all it holds
        }
    }
    (void)m_stroke.release(); // likewise: the gate was closed while its brush painted
}

template<class Action>
auto ScriptScene::onDocument(const Action& work) const
{
    std::optional<std::invoke_result_t<Action>> result;
    m_host.run([&] { result.emplace(work()); });
    return std::move(*result);
}

std::shared_ptr<const Scene> ScriptScene::scene() const
{
    if (m_own) {
        return {&m_own->document.scene(), [](const Scene*) {}}; // stays where it is
    }
    return onDocument([this] { return std::make_shared<const Scene>(m_host.document->scene()); });
}

std::string ScriptScene::path() const
{
    return onDocument([this] { return m_host.document->path().toStdString(); });
}

bool ScriptScene::isModified() const
{
    return onDocument([this] { return m_host.document->isModified(); });
}

Result<void> ScriptScene::refuseDuringEdit(const char* what) const
{
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

/// Somebody paints by hand at this moment: threads that a script left behind may come any time.
Result<void> ScriptScene::refuseDuringStroke() const
{
    if (!m_edit && !m_link && m_host.document->isEditOpen()) {
        return Error{"Somebody is painting in the window: try again when the stroke has ended."};
    }
    return {};
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
    if (auto allowed = refuseDuringEdit("Saving"); !allowed) {
        return allowed;
    }
    return onDocument([&]() -> Result<void> {
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

Result<bool> ScriptScene::step(bool isUndo)
{
    if (auto allowed = refuseDuringEdit(isUndo ? "Undo" : "Redo"); !allowed) {
        return allowed.error();
    }
    return onDocument([&]() -> Result<bool> {
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
    if (auto allowed = refuseDuringEdit("Another edit"); !allowed) {
        return allowed;
    }
    return onDocument([&]() -> Result<void> {
        if (auto allowed = refuseDuringStroke(); !allowed) {
            return allowed;
        }
        m_edit = m_host.document->beginEdit();
        m_editText = QString::fromStdString(text);
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

Result<void> ScriptScene::edit(const QString& text, const Work& work)
{
    if (m_link) {
        if (m_link->edit() == nullptr) {
            return Error{"The stroke was taken back."};
        }
        work(*m_link->edit());
        return {};
    }
    if (m_edit) {
        work(*m_edit);
        return {};
    }
    if (auto allowed = refuseDuringStroke(); !allowed) {
        return allowed;
    }
    const auto own = m_host.document->beginEdit();
    work(*own);
    own->commit(text);
    return {};
}

Result<TemplateId> ScriptScene::addTemplate(TemplateEntry entry)
{
    entry.path = absolute(entry.path);
    auto asset = loadTemplateAsset(entry);
    if (!asset) {
        return asset.error();
    }
    if (entry.name.empty()) {
        entry.name = asset.value()->name;
    }
    attachAsset(entry, asset.value());
    return onDocument([&]() -> Result<TemplateId> {
        if (entry.id != 0 && m_host.document->scene().findTemplate(entry.id) != nullptr) {
            return Error{"The scene already has a template " + std::to_string(entry.id) + "."};
        }
        TemplateId id = 0;
        const auto work = [&](SceneEdit& open) { id = open.addTemplate(entry); };
        if (auto done = edit(stepText(QT_TRANSLATE_NOOP("Script", "Add Template")), work); !done) {
            return done.error();
        }
        return id;
    });
}

Result<void> ScriptScene::changeTemplate(TemplateEntry entry)
{
    entry.path = absolute(entry.path);
    const auto now = scene();
    const TemplateEntry* was = now->findTemplate(entry.id);
    if (was == nullptr) {
        return noTemplate(entry.id);
    }
    const bool isSameFile = was->path == entry.path && was->import == entry.import &&
                            sameNumbers(was->clipSpeeds, entry.clipSpeeds);
    if (!isSameFile) {
        auto asset = loadTemplateAsset(entry);
        if (!asset) {
            return asset.error();
        }
        attachAsset(entry, asset.value());
    }
    return onDocument([&] {
        return edit(stepText(QT_TRANSLATE_NOOP("Script", "Change Template")),
                    [&](SceneEdit& open) { open.changeTemplate(entry); });
    });
}

Result<void> ScriptScene::removeTemplate(TemplateId id)
{
    return onDocument([&]() -> Result<void> {
        const Scene& now = m_host.document->scene();
        if (now.findTemplate(id) == nullptr) {
            return noTemplate(id);
        }
        const auto users = std::ranges::count(now.population.column(columns::templateId), id);
        if (users > 0) {
            return Error{std::to_string(users) + " people are of template " + std::to_string(id) +
                         ": remove them first."};
        }
        return edit(stepText(QT_TRANSLATE_NOOP("Script", "Remove Template")),
                    [&](SceneEdit& open) { open.removeTemplate(id); });
    });
}

Result<std::uint8_t> ScriptScene::addStage(StageEntry entry)
{
    entry.path = absolute(entry.path);
    auto asset = loadStageAsset(entry);
    if (!asset) {
        return asset.error();
    }
    entry.asset = asset.value();
    if (entry.name.empty()) {
        entry.name = entry.asset->name;
    }
    return onDocument([&]() -> Result<std::uint8_t> {
        if (entry.id != 0 && m_host.document->scene().findStage(entry.id) != nullptr) {
            return Error{"The scene already has a stage " + std::to_string(entry.id) + "."};
        }
        std::uint8_t id = 0;
        const auto work = [&](SceneEdit& open) { id = open.addStage(entry); };
        if (auto done = edit(stepText(QT_TRANSLATE_NOOP("Script", "Add Stage")), work); !done) {
            return done.error();
        }
        return id;
    });
}

Result<void> ScriptScene::changeStage(StageEntry entry)
{
    entry.path = absolute(entry.path);
    const auto now = scene();
    const StageEntry* was = now->findStage(entry.id);
    if (was == nullptr) {
        return noStage(entry.id);
    }
    if (was->path != entry.path) {
        auto asset = loadStageAsset(entry);
        if (!asset) {
            return asset.error();
        }
        entry.asset = asset.value();
        entry.problem.clear();
    }
    return onDocument([&] {
        return edit(stepText(QT_TRANSLATE_NOOP("Script", "Change Stage")),
                    [&](SceneEdit& open) { open.changeStage(entry); });
    });
}

Result<void> ScriptScene::removeStage(std::uint8_t id)
{
    return onDocument([&]() -> Result<void> {
        if (m_host.document->scene().findStage(id) == nullptr) {
            return noStage(id);
        }
        return edit(stepText(QT_TRANSLATE_NOOP("Script", "Remove Stage")),
                    [&](SceneEdit& open) { open.removeStage(id); });
    });
}

Result<void> ScriptScene::setCamera(const std::string& name, const Camera& camera)
{
    return onDocument([&] {
        std::vector<NamedCamera> cameras = m_host.document->scene().cameras;
        const auto found = std::ranges::find(cameras, name, &NamedCamera::name);
        if (found == cameras.end()) {
            cameras.push_back({name, camera});
        } else {
            found->camera = camera;
        }
        return edit(stepText(QT_TRANSLATE_NOOP("Script", "Set Camera")),
                    [&](SceneEdit& open) { open.setCameras(cameras); });
    });
}

Result<void> ScriptScene::removeCamera(const std::string& name)
{
    if (const auto known = camera(name); !known) {
        return known.error();
    }
    return onDocument([&] {
        std::vector<NamedCamera> cameras = m_host.document->scene().cameras;
        std::erase_if(cameras, [&name](const NamedCamera& each) { return each.name == name; });
        return edit(stepText(QT_TRANSLATE_NOOP("Script", "Remove Camera")),
                    [&](SceneEdit& open) { open.setCameras(cameras); });
    });
}

Result<void> ScriptScene::setCameras(std::vector<NamedCamera> cameras)
{
    return onDocument([&] {
        for (NamedCamera& each : cameras) {
            const auto& known = m_host.document->scene().cameras;
            const auto same = std::ranges::find(known, each.name, &NamedCamera::name);
            if (same != known.end()) {
                each.unknownMembers = same->unknownMembers;
            }
        }
        return edit(stepText(QT_TRANSLATE_NOOP("Script", "Set Cameras")),
                    [&](SceneEdit& open) { open.setCameras(cameras); });
    });
}

Result<void> ScriptScene::setLighting(Lighting lighting)
{
    return onDocument([&] {
        lighting.unknownMembers = m_host.document->scene().lighting.unknownMembers;
        return edit(stepText(QT_TRANSLATE_NOOP("Script", "Set Lighting")),
                    [&](SceneEdit& open) { open.setLighting(lighting); });
    });
}

Result<void> ScriptScene::setEnvironment(const std::string& text)
{
    return onDocument([&]() -> Result<void> {
        Scene wanted = m_host.document->scene();
        if (auto read = readEnvironmentText(text, wanted); !read) {
            return read;
        }
        return edit(stepText(QT_TRANSLATE_NOOP("Script", "Set Environment")),
                    [&](SceneEdit& open) { putEnvironment(open, wanted); });
    });
}

Result<Camera> ScriptScene::camera(const std::string& name) const
{
    const auto now = scene();
    const auto found = std::ranges::find(now->cameras, name, &NamedCamera::name);
    if (found != now->cameras.end()) {
        return found->camera;
    }
    std::string names;
    for (const NamedCamera& each : now->cameras) {
        names += (names.empty() ? "" : ", ") + each.name;
    }
    return Error{"There is no camera named \"" + name + "\". " +
                 (names.empty() ? "The scene has none." : "The scene has: " + names + ".")};
}

Result<std::vector<IndividualId>> ScriptScene::create(std::size_t n,
                                                      std::span<const ColumnValues> values)
{
    std::vector<IndividualId> ids;
    const auto done = onDocument([&]() -> Result<void> {
        auto rows = newRows(m_host.document->scene(), n, values);
        if (!rows) {
            return rows.error();
        }
        return edit(stepText(QT_TRANSLATE_NOOP("Script", "Create People")),
                    [&](SceneEdit& open) { ids = open.addIndividuals(std::move(rows).value()); });
    });
    if (!done) {
        return done.error();
    }
    return ids;
}

Result<void> ScriptScene::remove(std::span<const IndividualId> ids)
{
    return onDocument([&]() -> Result<void> {
        if (auto alive = checkAlive(m_host.document->scene(), ids); !alive) {
            return alive;
        }
        return edit(stepText(QT_TRANSLATE_NOOP("Script", "Remove People")),
                    [&](SceneEdit& open) { open.removeIndividuals(ids); });
    });
}

Result<void> ScriptScene::change(std::span<const IndividualId> ids,
                                 std::span<const ColumnValues> values)
{
    return onDocument([&]() -> Result<void> {
        if (auto alive = checkAlive(m_host.document->scene(), ids); !alive) {
            return alive;
        }
        if (auto valid = checkChange(m_host.document->scene(), ids, values); !valid) {
            return valid;
        }
        return edit(stepText(QT_TRANSLATE_NOOP("Script", "Change People")), [&](SceneEdit& open) {
            for (const ColumnValues& each : values) {
                open.setColumn(each.column, ids, each.bytes);
            }
        });
    });
}

Result<StrokeOutcome> ScriptScene::scriptStroke(const RecordedStroke& recording,
                                                const PaintWork& paint)
{
    const auto link = std::make_shared<ScriptStrokeLink>();
    const auto begun = onDocument([&]() -> Result<void> {
        if (auto allowed = refuseDuringStroke(); !allowed) {
            return allowed;
        }
        m_host.stage->setStages(m_host.document->scene().stages);
        BrushContext context{View(recording.camera, recording.viewSize), *m_host.keyframes,
                             *m_host.stage};
        context.script = link.get();
        m_stroke = Stroke::begin(*m_host.document, context, recording.settings, recording.seed,
                                 recording.inputs.front());
        for (std::size_t i = 1; i < recording.inputs.size(); ++i) {
            m_stroke->move(recording.inputs[i]);
        }
        m_stroke->settle();
        return {};
    });
    if (!begun) {
        return begun.error();
    }
    link->close();
    joinStroke(link);
    try {
        paint(*link);
    } catch (...) {
        leaveStroke();
        m_host.run([this] { m_stroke.reset(); }); // takes back what was painted
        throw;
    }
    leaveStroke();
    return onDocument([&]() -> Result<StrokeOutcome> {
        if (!m_stroke) {
            return Error{"The stroke was taken back."};
        }
        const StrokeOutcome outcome = m_stroke->finish();
        m_stroke.reset();
        return outcome;
    });
}

Result<StrokeOutcome> ScriptScene::stroke(const ScriptStroke& stroke, const PaintWork& paint)
{
    if (auto allowed = refuseDuringEdit("A stroke"); !allowed) {
        return allowed.error();
    }
    const auto now = scene();
    const auto camera = cameraOrFirst(*now, stroke.camera);
    if (!camera) {
        return camera.error();
    }
    if (auto valid = checkBrush(*now, stroke.settings); !valid) {
        return valid.error();
    }
    // A stroke sees people as they are, not as they stand in until they are baked.
    bakeAllShown(*now, *m_host.keyframes);
    RecordedStroke recording;
    recording.settings = stroke.settings;
    recording.seed = stroke.seed;
    recording.camera = camera.value();
    recording.viewSize = stroke.viewSize;
    recording.inputs = stroke.inputs;
    if (stroke.settings.kind == BrushKind::Script) {
        return scriptStroke(recording, paint);
    }
    return onDocument([&]() -> Result<StrokeOutcome> {
        if (auto allowed = refuseDuringStroke(); !allowed) {
            return allowed.error();
        }
        m_host.stage->setStages(m_host.document->scene().stages);
        return replay(*m_host.document, *m_host.keyframes, *m_host.stage, recording);
    });
}

Result<std::vector<std::uint8_t>> ScriptScene::picture(const ScriptPicture& picture)
{
    const auto now = scene();
    const auto camera = cameraOrFirst(*now, picture.camera);
    if (!camera) {
        return camera.error();
    }
    if (!m_pictures) {
        auto maker = PictureMaker::create(m_pictureKeyframes);
        if (!maker) {
            return maker.error();
        }
        m_pictures = std::move(maker).value();
    }
    const std::vector<WorldSeat> seats = now->worldSeats();
    PictureRequest request;
    request.frame = onDocument([&] { return m_host.document->frame(picture.seconds); });
    request.stages = now->stages;
    request.seats = seats;
    request.seatsVersion = ++m_pictureCount;
    request.lighting = now->lighting;
    request.camera = camera.value();
    request.size = picture.size;
    request.look = picture.look;
    if (auto drawn = m_pictures->draw(request); !drawn) {
        return drawn.error();
    }
    return m_pictures->pixels();
}

} // namespace crowd::app
