// SPDX-License-Identifier: MIT
#include "widgets/state/EditorState.h"

#include <algorithm>
#include <utility>

#include <QtCore/QMetaObject>

#include "model/rules/RuleSets.h"
#include "model/scene/NearestPath.h"
#include "widgets/state/BrushStart.h"
#include "widgets/state/SceneChanges.h"
#include "widgets/state/ShownLook.h"

namespace crowd::widgets {

using model::BrushKind;
using model::BrushSettings;
using model::Camera;

namespace {

/// The event brush offers an event that some rule listens to.
void refreshEvent(EditorState& state)
{
    BrushSettings settings = state.brush(BrushKind::Event);
    const std::vector<std::string> known = model::eventsOf(state.scene());
    if (!known.empty() &&
        std::ranges::find(known, settings.as<model::EventSettings>().name) == known.end()) {
        settings.as<model::EventSettings>().name = known.front();
        state.setBrush(settings);
    }
}

/// Brushes do not name groups and states that are not there any more.
void forgetGone(EditorState& state)
{
    const auto isGoneGroup = [&state](std::int64_t id) {
        return id != 0 && state.scene().findGroup(static_cast<model::GroupId>(id)) == nullptr;
    };
    const auto isGone = [&](const model::FieldMeta& meta, std::int64_t id) {
        const auto& states = state.scene().states;
        return meta.role == model::FieldRole::Group ? isGoneGroup(id)
               : meta.role == model::FieldRole::State
                   ? std::ranges::find(states, id, &model::State::id) == states.end()
                   : false;
    };
    for (std::size_t kind = 0; kind < model::kBrushCount; ++kind) {
        BrushSettings brush = state.brush(static_cast<BrushKind>(kind));
        const model::BrushType& type = model::brushType(brush.kind());
        for (const model::FieldInfo& field : type.fields) {
            if (field.is<std::int64_t>() &&
                isGone(field.meta, std::get<std::int64_t>(field.get(type.settings(brush))))) {
                field.set(type.editable(brush), std::int64_t{0});
            }
        }
        std::erase_if(brush.mask.groups, isGoneGroup);
        std::erase_if(brush.mask.features, [&state](int id) {
            return model::findFeature(state.scene().features, static_cast<model::FeatureId>(id)) ==
                   nullptr;
        });
        state.setBrush(brush);
    }
}

/// Masks, and those from whom relations are to go, name what only their scene has.
void forgetMasks(EditorState& state)
{
    for (std::size_t kind = 0; kind < model::kBrushCount; ++kind) {
        BrushSettings brush = state.brush(static_cast<BrushKind>(kind));
        brush.mask = {};
        if (auto* relation = brush.find<model::RelationSettings>()) {
            relation->sources.clear();
        }
        state.setBrush(brush);
    }
}

const std::string& nameOf(const ScriptBrush& brush)
{
    return brush.settings.as<model::ScriptSettings>().brush;
}

/// What is set already goes on where name and kind are the same.
void keepValues(const std::vector<model::ScriptValue>& known,
                std::vector<model::ScriptValue>& fresh)
{
    for (model::ScriptValue& each : fresh) {
        const auto old = std::ranges::find(known, each.name, &model::ScriptValue::name);
        if (old != known.end() && old->value.index() == each.value.index()) {
            each.value = old->value;
        }
    }
}

} // namespace

EditorState::EditorState(model::SceneDocument& document, QObject* parent)
    : QObject(parent), m_document(document), m_selection(document), m_paths(document),
      m_strokes(document), m_session(document, m_transport), m_ground(document),
      m_undoGroups(document), m_director(*this), m_takes(document, m_session)
{
    for (std::size_t kind = 0; kind < m_brushes.size(); ++kind) {
        m_brushes[kind] = model::initialBrush(static_cast<BrushKind>(kind));
    }
    m_keyframes.setFinishedCallback([this] {
        QMetaObject::invokeMethod(
            this, [this] { Q_EMIT keyframesChanged(m_keyframes.progress()); },
            Qt::QueuedConnection);
    });
    connect(&document, &model::SceneDocument::changed, this, &EditorState::followScene);
    m_director.begin();
}

EditorState::~EditorState()
{
    m_keyframes.setFinishedCallback({});
}

model::CrowdFramePtr EditorState::frame() const
{
    return m_session.frame(m_transport.seconds());
}

void EditorState::setTool(ToolId id)
{
    if (m_tool == id) {
        return;
    }
    setPicking(Picking::None);
    m_previousTool = m_tool;
    m_tool = id;
    if (const auto kind = brushKindOf(id)) {
        start(*kind);
        if (*kind != BrushKind::Restore) {
            m_document.rememberPeople();
        }
    }
    Q_EMIT toolChanged(id);
}

/// Once in a scene: what the artist leaves unchosen then is meant.
void EditorState::start(BrushKind kind)
{
    bool& isStarted = m_isStarted[static_cast<std::size_t>(kind)];
    isStarted = isStarted || startBrush(*this, kind);
}

void EditorState::setPicking(Picking picking)
{
    if (m_picking == picking) {
        return;
    }
    m_picking = picking;
    if (picking != Picking::Place) {
        m_pointTaken = {};
    }
    if (picking != Picking::Person) {
        m_personTaken = {};
    }
    Q_EMIT pickingChanged(m_picking);
}

void EditorState::choosePoint(PointTaken taken)
{
    setPicking(Picking::None);
    m_pointTaken = std::move(taken);
    setPicking(Picking::Place);
}

void EditorState::offerPoint(const glm::vec3& metres)
{
    const PointTaken taken = std::exchange(m_pointTaken, {});
    setPicking(Picking::None);
    if (taken) {
        taken(metres);
    }
}

void EditorState::choosePerson(PersonTaken taken)
{
    setPicking(Picking::None);
    m_personTaken = std::move(taken);
    setPicking(Picking::Person);
}

void EditorState::offerPerson(model::IndividualId id)
{
    const PersonTaken taken = std::exchange(m_personTaken, {});
    setPicking(Picking::None);
    if (taken) {
        taken(id);
    }
}

void EditorState::setWashed(std::vector<model::IndividualId> ids)
{
    if (m_washed != ids) {
        m_washed = std::move(ids);
        Q_EMIT washedChanged();
    }
}

void EditorState::chooseState(model::StateId id)
{
    if (m_chosenState != id) {
        m_chosenState = id;
        Q_EMIT stateChosen(id);
    }
}

void EditorState::markPoint(const QObject* marker, const std::optional<glm::vec3>& metres)
{
    const bool isOwn = m_pointMarker == marker;
    if ((!metres && !isOwn) || (isOwn && m_markedPoint == metres)) {
        return;
    }
    m_markedPoint = metres;
    m_pointMarker = metres ? marker : nullptr;
    Q_EMIT markedPointChanged();
}

void EditorState::chooseLight(model::LightId id)
{
    if (m_chosenLight != id) {
        m_chosenLight = id;
        Q_EMIT lightChosen(id);
    }
}

void EditorState::noteRecallInRun(const QString& name)
{
    m_recalledInRun = name;
    m_recalledAtStep = m_document.undoStack().index();
}

QString EditorState::takeRecallInRun()
{
    const bool isLast = m_session.isRunning() && m_recalledAtStep == m_document.undoStack().index();
    const QString name = std::exchange(m_recalledInRun, QString());
    return isLast ? name : QString();
}

void EditorState::setRecall(const RecallSettings& recall)
{
    if (m_recall != recall) {
        m_recall = recall;
        Q_EMIT recallChanged(m_recall);
    }
}

const BrushSettings& EditorState::brush(BrushKind kind) const
{
    return m_brushes[static_cast<std::size_t>(kind)];
}

void EditorState::setBrush(const BrushSettings& settings)
{
    BrushSettings& kept = m_brushes[static_cast<std::size_t>(settings.kind())];
    if (kept == settings) {
        return;
    }
    const auto* walk = settings.find<model::WalkSettings>();
    if (walk != nullptr && walk->path != kept.as<model::WalkSettings>().path) {
        m_wantedPath = walk->path;
    }
    kept = settings;
    if (settings.kind() == BrushKind::Script) {
        const auto own =
            std::ranges::find(m_scriptBrushes, settings.as<model::ScriptSettings>().brush, &nameOf);
        if (own != m_scriptBrushes.end()) {
            own->settings = settings;
        }
    }
    Q_EMIT brushChanged(settings.kind());
}

void EditorState::putScriptBrush(ScriptBrush brush)
{
    brush.settings.setKind(BrushKind::Script);
    const std::string name = nameOf(brush);
    const auto known = std::ranges::find(m_scriptBrushes, name, &nameOf);
    if (known == m_scriptBrushes.end()) {
        m_scriptBrushes.push_back(std::move(brush));
    } else {
        keepValues(known->settings.as<model::ScriptSettings>().values,
                   brush.settings.as<model::ScriptSettings>().values);
        *known = std::move(brush);
    }
    if (m_scriptBrushes.size() == 1 ||
        this->brush(BrushKind::Script).as<model::ScriptSettings>().brush == name) {
        chooseScriptBrush(name);
    }
    Q_EMIT scriptBrushesChanged();
}

void EditorState::chooseScriptBrush(const std::string& name)
{
    const auto chosen = std::ranges::find(m_scriptBrushes, name, &nameOf);
    if (chosen == m_scriptBrushes.end()) {
        return;
    }
    const bool isOther = brush(BrushKind::Script).as<model::ScriptSettings>().brush != name;
    setBrush(BrushSettings(chosen->settings));
    if (isOther) {
        Q_EMIT scriptBrushesChanged();
    }
}

const BrushSettings* EditorState::activeBrush() const
{
    const std::optional<BrushKind> kind = brushKindOf(m_tool);
    return kind ? &brush(*kind) : nullptr;
}

bool EditorState::isSeatGridOn() const
{
    return brush(BrushKind::Create).as<model::CreateSettings>().seats.isOn;
}

void EditorState::setSeatGridOn(bool isOn)
{
    BrushSettings settings = brush(BrushKind::Create);
    settings.as<model::CreateSettings>().seats.isOn = isOn;
    setBrush(settings);
}

void EditorState::placeCamera(const Camera& camera, const QString& name)
{
    if (m_view.camera == camera && m_view.name == name) {
        return;
    }
    m_view = {camera, name};
    Q_EMIT viewCameraChanged(m_view);
}

void EditorState::setCamera(const Camera& camera, const QString& name)
{
    m_motion.stop();
    placeCamera(camera, name);
}

void EditorState::moveCameraTo(const Camera& camera, const QString& name, double seconds)
{
    m_motion.start(m_view.camera, camera, seconds);
    m_motionName = name;
    // Whoever runs a frame clock hears of it through this signal.
    m_view.name.clear();
    Q_EMIT viewCameraChanged(m_view);
}

Camera EditorState::cameraTarget() const
{
    return m_motion.target().value_or(m_view.camera);
}

void EditorState::setViewOptions(const ViewOptions& options)
{
    if (m_options == options) {
        return;
    }
    m_options = options;
    Q_EMIT viewOptionsChanged(m_options);
}

void EditorState::setLongWork(const LongWork& work)
{
    m_longWork = work;
    Q_EMIT longWorkChanged(m_longWork);
}

void EditorState::refuse(const QString& text)
{
    showStatus(text);
    Q_EMIT refused(text);
}

void EditorState::setHint(const QString& hint)
{
    if (m_hint == hint) {
        return;
    }
    m_hint = hint;
    Q_EMIT hintChanged(m_hint);
}

void EditorState::advance(double realSeconds)
{
    m_session.advance(realSeconds);
    if (m_motion.isMoving()) {
        const Camera camera = m_motion.advance(realSeconds);
        placeCamera(camera, m_motion.isMoving() ? QString() : m_motionName);
    }
}

bool EditorState::isAnimating() const
{
    const bool isAnythingMoving = !scene().population.isEmpty() || m_director.track().hasMoves();
    return m_motion.isMoving() || (m_transport.isPlaying() && isAnythingMoving);
}

void EditorState::followScene(const model::SceneChange& change)
{
    visitChange(
        change, [this](const model::TemplatesChanged&) { refreshMix(false); },
        [this](const model::StagesChanged&) { refreshSeatGrid(false); },
        [this](const model::PathsChanged&) { refreshWalk(false); },
        [this](const model::RulesChanged&) { refreshEvent(*this); },
        [this](const model::GroupsChanged&) { forgetGone(*this); },
        [this](const model::StatesChanged&) { forgetGone(*this); },
        [this](const model::FeaturesChanged&) { forgetGone(*this); },
        [this](const model::LooksChanged&) { showLook(*this, m_options.ownLook); },
        [this](const model::LightsChanged&) {
            if (findLight(scene().lights, m_chosenLight) == nullptr) {
                chooseLight(0);
            }
        },
        [this](const model::SceneReplaced&) { beginScene(); });
}

/// Another one is open now.
void EditorState::beginScene()
{
    m_director.forget();
    chooseLight(0);
    showLook(*this, 0);
    forgetMasks(*this);
    forgetGone(*this);
    refreshWalk(true);
    refreshEvent(*this);
    refreshMix(true);
    refreshSeatGrid(true);
    m_isStarted = {};
    if (const auto kind = brushKindOf(m_tool)) {
        start(*kind);
    }
    m_transport.rewind();
    m_transport.setSpeed(1.0);
    const auto& cameras = scene().cameras;
    if (cameras.empty()) {
        setCamera(Camera::lookingAt({9.0F, 6.0F, 14.0F}, {0.0F, 0.8F, 0.0F}));
    } else {
        setCamera(cameras.front().camera, QString::fromStdString(cameras.front().name));
        showLookOf(*this, cameras.front());
    }
    m_director.takeScene();
}

void EditorState::refreshSeatGrid(bool isNewScene)
{
    const bool hasSeats = std::any_of(
        scene().stages.begin(), scene().stages.end(),
        [](const model::StageEntry& stage) { return stage.asset && !stage.asset->seats.empty(); });
    // The artist's choice stays while there are seats; without any, people come on the ground.
    if (hasSeats != m_hasSeats || isNewScene) {
        m_hasSeats = hasSeats;
        setSeatGridOn(hasSeats);
    }
}

/// The walk brush offers a path that is there: the one that was chosen, as soon as it is there
/// again.
void EditorState::refreshWalk(bool isNewScene)
{
    const auto isThere = [this](model::PathId path) {
        const bool isNearest = path == model::kNearestPath && !scene().paths.empty();
        return isNearest || scene().findPath(path) != nullptr;
    };
    const std::optional<model::PathId> wanted = isNewScene ? std::nullopt : m_wantedPath;
    BrushSettings settings = brush(BrushKind::Walk);
    if (wanted && (*wanted == 0 || isThere(*wanted))) {
        settings.as<model::WalkSettings>().path = *wanted;
    } else if (!isThere(settings.as<model::WalkSettings>().path)) {
        settings.as<model::WalkSettings>().path =
            scene().paths.empty() ? 0 : scene().paths.front().id;
    }
    setBrush(settings);
    m_wantedPath = wanted;
}

void EditorState::refreshMix(bool isNewScene)
{
    BrushSettings settings = brush(BrushKind::Create);
    std::vector<model::TemplateWeight>& mix = settings.as<model::CreateSettings>().mix;
    std::erase_if(mix, [&](const model::TemplateWeight& item) {
        return isNewScene || scene().findTemplate(item.id) == nullptr;
    });
    if (mix.empty()) {
        for (const model::TemplateEntry& entry : scene().templates) {
            mix.push_back({entry.id, 1.0F});
        }
    }
    setBrush(settings);
}

} // namespace crowd::widgets
