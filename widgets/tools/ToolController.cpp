// SPDX-License-Identifier: MIT
#include "widgets/tools/ToolController.h"

#include <algorithm>
#include <utility>

#include "widgets/state/BrushTexts.h"
#include "widgets/tools/BrushTool.h"
#include "widgets/tools/FlySession.h"
#include "widgets/tools/PlaceHandles.h"
#include "widgets/tools/PlaceTool.h"
#include "widgets/tools/SelectTool.h"
#include "widgets/tools/ToolKeys.h"

namespace crowd::widgets {

namespace {

constexpr int kRefusalMs = 3000;
constexpr double kTapSeconds = 0.35;         ///< a key held longer was held
constexpr double kRepetitionSeconds = 0.004; ///< shorter than any hand between release and press

/// Whether somebody other than the tool waits for a click.
bool isAskingForClick(const EditorState& state)
{
    return state.picking() == Picking::Place || state.picking() == Picking::Person;
}

} // namespace

ToolController::ToolController(EditorState& state) : m_state(state), m_queries(state)
{
    const ToolContext context{m_state, m_queries};
    m_state.strokes().setContext([this] { return m_queries.brushContext(); });
    for (const ToolInfo& info : toolTable()) {
        std::unique_ptr<Tool>& tool = m_tools[static_cast<std::size_t>(info.id)];
        if (info.brush && model::BrushSettings(*info.brush).addsPlaces()) {
            tool = std::make_unique<PlaceTool>(context, *info.brush);
        } else if (info.brush) {
            tool = std::make_unique<BrushTool>(context, *info.brush);
        } else if (info.id == ToolId::Navigate) {
            tool = std::make_unique<NavigateTool>(context);
        } else {
            tool = std::make_unique<SelectTool>(context);
        }
    }
    connect(&state, &EditorState::toolChanged, this, [this] {
        cancel();
        refreshHint();
        refreshPicture();
    });
    connect(&state.document(), &model::SceneDocument::editInterrupted, this,
            &ToolController::cancel);
    connect(&state, &EditorState::viewOptionsChanged, this, &ToolController::refreshHint);
    connect(&state.document(), &model::SceneDocument::changed, this, [this] {
        m_isPreviewStale |= !m_session && m_pointer.has_value(); // what is under it may be gone
    });
    connect(&state, &EditorState::pickingChanged, this, [this] {
        refreshHint();
        refreshPicture();
    });
    connect(&state, &EditorState::brushChanged, this, &ToolController::renewTexts);
    connect(&state.paths(), &PathFocus::changed, this, &ToolController::refreshPicture);
    connect(&state, &EditorState::viewCameraChanged, this, &ToolController::refreshPicture);
    followRefusals();
    refreshHint();
}

void ToolController::followRefusals()
{
    m_refusalTime.setSingleShot(true);
    m_refusalTime.setInterval(kRefusalMs);
    connect(&m_refusalTime, &QTimer::timeout, this, [this] {
        m_refusal.clear();
        refreshPicture();
    });
    connect(&m_state, &EditorState::refused, this, [this](const QString& text) {
        m_refusal = text;
        m_refusalTime.start();
        refreshPicture();
    });
}

/// Unless the tool itself has something to say there.
void ToolController::addRefusal(ToolPicture& picture) const
{
    if (m_refusal.isEmpty() || !picture.label.isEmpty()) {
        return;
    }
    picture.label = m_refusal;
    picture.symbolAt = picture.symbol ? picture.symbolAt : m_pointer->position();
}

ToolController::~ToolController()
{
    m_state.strokes().setContext({});
}

Tool& ToolController::activeTool() const
{
    return *m_tools[static_cast<std::size_t>(m_state.tool())];
}

bool ToolController::claimsKey(int key, Qt::KeyboardModifiers modifiers) const
{
    return m_session || (key == Qt::Key_Space && (m_isSpaceHeld || modifiers == Qt::NoModifier));
}

ToolInput ToolController::monotonic(ToolInput input)
{
    // Events that waited while a frame was drawn are older than the frame's tick.
    if (m_session) {
        input.pointer.timeSeconds = std::max(input.pointer.timeSeconds, m_lastSeconds);
    }
    m_lastSeconds = input.pointer.timeSeconds;
    m_pointer = input;
    return input;
}

bool ToolController::isNavigation(const ToolInput& input) const
{
    if (m_isSpaceHeld || input.modifiers.testFlag(Qt::AltModifier)) {
        return input.button == Qt::LeftButton || input.button == Qt::MiddleButton ||
               input.button == Qt::RightButton;
    }
    const bool isPaperBrush =
        m_state.viewOptions().buttons == ButtonMapping::Paper && m_state.activeBrush() != nullptr;
    return input.button == Qt::MiddleButton && !isPaperBrush && m_state.tool() != ToolId::Navigate;
}

DragSessionPtr ToolController::sessionFor(const ToolInput& input)
{
    const ToolContext context{m_state, m_queries};
    if (!isNavigation(input)) {
        return takeWhatIsAskedFor(input) ? nullptr : activeTool().press(input);
    }
    m_isSpaceUsed = true;
    Navigation kind = navigationFor(input.modifiers);
    if (m_isSpaceHeld || input.modifiers.testFlag(Qt::AltModifier)) {
        // As in modelling programs: left turns, middle pans, right goes nearer.
        if (input.button != Qt::LeftButton) {
            kind = input.button == Qt::MiddleButton ? Navigation::Pan : Navigation::Dolly;
        }
    }
    return std::make_unique<NavigateDrag>(context, kind, input);
}

/// Whether somebody waits for this click, whatever the tool is.
bool ToolController::takeWhatIsAskedFor(const ToolInput& input)
{
    if (!isAskingForClick(m_state) || input.button != Qt::LeftButton) {
        return false;
    }
    if (m_state.picking() == Picking::Place) {
        takePoint(input);
    } else {
        takePerson(input);
    }
    return true;
}

void ToolController::takePerson(const ToolInput& input)
{
    const auto& pixel = input.pointer;
    const auto hit = m_queries.picker(pixel.shownSeconds).individualAt(pixel.pixels());
    if (hit) {
        m_state.offerPerson(hit->id);
    } else {
        m_state.refuse(tr("There is nobody under the cursor"));
    }
}

void ToolController::takePoint(const ToolInput& input)
{
    const auto& pixel = input.pointer;
    const auto surface = m_queries.picker(pixel.shownSeconds).surfaceAt(pixel.pixels());
    if (surface) {
        m_state.offerPoint(surface->point);
    } else {
        m_state.refuse(tr("There is no ground under the cursor"));
    }
}

void ToolController::press(const ToolInput& event)
{
    const ToolInput input = monotonic(event);
    if (m_session && m_session->isHandsFree()) {
        finish();
        return;
    }
    if (m_session && input.button != m_sessionButton) {
        return; // the first button has the drag
    }
    if (m_session) {
        m_session->release(input); // a release that never came
        finish();
    }
    m_refusal.clear();
    m_pressSeconds = input.pointer.timeSeconds;
    m_pressIndex = m_state.document().undoStack().index();
    m_session = sessionFor(input);
    m_sessionButton = m_session ? input.button : Qt::NoButton;
    if (!m_session && input.button == Qt::RightButton) {
        Q_EMIT paletteRequested(input.position());
    }
    refreshPicture();
}

void ToolController::move(const ToolInput& event)
{
    const ToolInput input = monotonic(event);
    if (m_session) {
        m_session->update(input);
    }
    refreshPicture();
}

void ToolController::release(const ToolInput& event)
{
    const ToolInput input = monotonic(event);
    if (m_session && input.button == m_sessionButton && !m_session->isHandsFree()) {
        m_session->release(input);
        finish();
        const bool isStroke = brushKindOf(m_state.tool()).has_value() &&
                              m_state.document().undoStack().index() == m_pressIndex + 1;
        if (isStroke) {
            m_state.undoGroups().note(static_cast<int>(m_state.tool()), m_pressSeconds,
                                      input.pointer.timeSeconds);
        }
    }
}

void ToolController::finish()
{
    m_session.reset();
    m_sessionButton = Qt::NoButton;
    refreshPicture();
}

void ToolController::cancel()
{
    if (m_session) {
        m_session->cancel();
        finish();
    }
}

void ToolController::leave()
{
    if (!m_session) {
        m_pointer.reset();
        refreshPicture();
    }
}

void ToolController::loseKeys()
{
    m_isSpaceHeld = false;
    if (isHandsFree()) {
        finish(); // lands where it is
    }
    refreshPicture();
}

void ToolController::pointerPlaced(const ToolInput& input)
{
    (void)monotonic(input);
    if (m_session) {
        m_session->place(input);
    }
}

void ToolController::wheel(const WheelInput& input)
{
    if (m_session) {
        m_session->wheel(input);
        refreshPicture();
        return;
    }
    const Qt::KeyboardModifiers modifiers = input.at.modifiers;
    const model::BrushSettings* brush = m_state.activeBrush();
    if (brush != nullptr && (brush->hasCircle() || brush->addsPlaces()) &&
        (modifiers.testFlag(Qt::ControlModifier) || modifiers.testFlag(Qt::ShiftModifier))) {
        changeBrush(resizedBySteps(*brush, input.notches, modifiers.testFlag(Qt::ShiftModifier)),
                    false);
        return;
    }
    m_wheel.turn({m_state, m_queries}, input);
}

void ToolController::showModifiers(const KeyInput& input)
{
    const bool isModifier = input.key == Qt::Key_Control || input.key == Qt::Key_Shift ||
                            input.key == Qt::Key_Alt || input.key == Qt::Key_Meta;
    if (isModifier && m_pointer && !m_session) {
        m_pointer->modifiers = input.modifiers; // what a press would do now, without moving first
        refreshPicture();
    }
}

bool ToolController::keyDown(const KeyInput& input)
{
    showModifiers(input);
    if (input.key == Qt::Key_Escape) {
        return escape();
    }
    if (input.key == Qt::Key_Space && spaceDown(input)) {
        return true;
    }
    if (m_session) {
        m_session->key(input, true);
        return true; // nothing else happens in the middle of a drag
    }
    return runShortcut(input);
}

bool ToolController::spaceDown(const KeyInput& input)
{
    // The X server repeats a held key as release and press at one moment. Where the press arrives
    // late, Qt takes the two for real; the key is still held.
    const bool isSameHold =
        input.isRepeat || input.timeSeconds - m_spaceUpSeconds < kRepetitionSeconds;
    if (!isSameHold && (m_session || input.modifiers != Qt::NoModifier)) {
        return false;
    }
    if (!isSameHold) {
        m_isSpaceUsed = false;
        m_spaceSeconds = input.timeSeconds;
    }
    m_isSpaceHeld = m_isSpaceHeld || !input.isRepeat;
    refreshPicture();
    return true;
}

void ToolController::togglePlaying()
{
    m_state.transport().toggle();
}

bool ToolController::spaceUp(const KeyInput& input)
{
    if (!m_isSpaceHeld || input.isRepeat) {
        return m_isSpaceHeld;
    }
    m_isSpaceHeld = false;
    m_spaceUpSeconds = input.timeSeconds;
    if (!m_isSpaceUsed && input.timeSeconds - m_spaceSeconds <= kTapSeconds) {
        togglePlaying();
    }
    refreshPicture();
    return true;
}

bool ToolController::keyUp(const KeyInput& input)
{
    showModifiers(input);
    if (input.key == Qt::Key_Space && spaceUp(input)) {
        return true;
    }
    return m_session && !input.isRepeat && m_session->key(input, false);
}

bool ToolController::escape()
{
    if (m_session) {
        cancel();
        return true;
    }
    if (m_state.picking() != Picking::None) {
        m_state.setPicking(Picking::None);
        return true;
    }
    if (m_state.tool() == ToolId::Navigate) {
        m_state.setTool(m_state.previousTool());
        return true;
    }
    forgetSources();
    endPath(m_state);
    m_state.paths().select({});
    m_state.selection().clear();
    return true;
}

/// Those from whom a relation was to go.
void ToolController::forgetSources()
{
    const model::BrushSettings* brush = m_state.activeBrush();
    const auto* relation = brush != nullptr ? brush->find<model::RelationSettings>() : nullptr;
    if (relation != nullptr && !relation->sources.empty()) {
        model::BrushSettings without = *brush;
        without.as<model::RelationSettings>().sources.clear();
        m_state.setBrush(without);
    }
}

bool ToolController::runShortcut(const KeyInput& input)
{
    const model::BrushSettings* brush = m_state.activeBrush();
    if (isFlyKey(input)) {
        const ToolInput start = m_pointer.value_or(ToolInput{});
        m_session = std::make_unique<FlySession>(ToolContext{m_state, m_queries},
                                                 FlySession::Hold::HandsFree, start);
        refreshPicture();
        return true;
    }
    if (const int steps = m_hasShortcuts ? sizeSteps(input) : 0; steps != 0 && brush != nullptr) {
        changeBrush(resizedBySteps(*brush, steps), false);
        return true;
    }
    if (const int steps = numberSteps(input); steps != 0 && brush != nullptr) {
        changeBrush(steppedMainNumber(*brush, steps), true);
        return true;
    }
    if (const int steps = numberSteps(input);
        steps != 0 && brush == nullptr && !m_state.paths().places().empty()) {
        resizePlaces(m_state, steps);
        return true;
    }
    return m_hasShortcuts && runStateKey(m_state, input);
}

void ToolController::changeBrush(const model::BrushSettings& settings, bool saysNumber)
{
    m_state.setBrush(settings);
    m_state.showStatus(saysNumber ? mainNumberText(settings) : brushSizeText(settings));
}

void ToolController::tick(const ToolInput& resting, double elapsedSeconds)
{
    if (m_session) {
        m_session->tick(monotonic(resting), elapsedSeconds);
        refreshPicture();
        return;
    }
    const bool havePeopleMoved =
        m_pointer && !m_picture.candidates.empty() && m_state.isAnimating();
    if (!m_isPreviewStale && !havePeopleMoved) {
        return;
    }
    m_isPreviewStale = false;
    if (m_pointer && !m_isSpaceHeld) {
        m_pointer->pointer.shownSeconds = resting.pointer.shownSeconds;
        ToolPicture picture = m_picture;
        picture.candidates.clear();
        activeTool().preview(*m_pointer, picture);
        replacePicture(std::move(picture));
    }
}

void ToolController::replacePicture(ToolPicture picture)
{
    const bool isSameInScene = showsTheSameInScene(picture, m_picture);
    m_picture = std::move(picture);
    Q_EMIT pictureChanged();
    if (!isSameInScene) {
        Q_EMIT scenePreviewChanged();
    }
}

void ToolController::refreshPicture()
{
    ToolPicture picture;
    if (m_session) {
        m_session->show(picture);
    } else if (m_pointer && m_isSpaceHeld) {
        picture.cursor = Qt::OpenHandCursor;
    } else if (m_pointer && isAskingForClick(m_state)) {
        picture.cursor = Qt::CrossCursor;
        picture.crosshair = m_pointer->position();
        addRefusal(picture);
    } else if (m_pointer) {
        activeTool().hover(*m_pointer, picture);
        addRefusal(picture);
        // What takes longer stays as it was until the next frame.
        picture.ghosts = m_picture.ghosts;
        picture.hovered = m_picture.hovered;
        picture.candidates = m_picture.candidates;
    }
    m_isPreviewStale = !m_session && m_pointer.has_value();
    replacePicture(std::move(picture));
}

void ToolController::renewTexts()
{
    refreshPicture();
    refreshHint();
}

void ToolController::refreshHint()
{
    switch (m_state.picking()) {
    case Picking::Place:
        m_state.setHint(tr("Click a point in the picture"));
        break;
    case Picking::Person:
        m_state.setHint(tr("Click somebody in the picture"));
        break;
    default:
        m_state.setHint(activeTool().hint());
    }
}

} // namespace crowd::widgets
