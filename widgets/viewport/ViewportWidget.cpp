// SPDX-License-Identifier: MIT
#include "widgets/viewport/ViewportWidget.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QtCore/QEvent>

#include "model/base/Translated.h"
#include "render/Renderer.h"
#include "render/SceneLook.h"
#include "widgets/state/BrushTexts.h"
#include "widgets/state/SceneChanges.h"
#include "widgets/state/ShownLook.h"
#include "widgets/tools/ScriptPainter.h"
#include "widgets/viewport/BrushPopup.h"
#include "widgets/viewport/PathLabels.h"
#include "widgets/viewport/PointMark.h"
#include "widgets/viewport/ViewportOverlay.h"
#include "widgets/viewport/WorkBar.h"

namespace crowd::widgets {

namespace {

constexpr qint64 kPublishMs = 250;
// Pictures slower than this are drawn with one sample a pixel and edges smoothed afterwards, until
// even that is very quick. At rest they ripen.
constexpr double kSlowMs = 45.0;
constexpr double kQuickMs = 10.0;
constexpr glm::vec3 kWashColor{0.10F, 0.75F, 1.0F};
constexpr int kViewStillMs = 100; // without a change, the view counts as still
constexpr int kHandStillMs = 150; // the same for the brush
constexpr float kCards = 18.0F;   // physical pixels below which people are pictures on cards
constexpr float kCardsBesideSamples = 6.0F;
constexpr int kRipenMs = 120; // of rest, before one picture becomes several
constexpr int kRipe = 8;      // pictures that become one
constexpr int kRipeAtBest = 16;

} // namespace

ViewportWidget::ViewportWidget(EditorState& state, QWidget* parent)
    : PictureSurface(parent), m_state(state), m_renderer(std::make_unique<render::Renderer>()),
      m_tools(state), m_input(*this, m_tools), m_overlay(new ViewportOverlay(this)),
      m_work(new WorkBar(this)), m_properties(new PropertyLegend(state, m_colours, this))
{
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setTabletTracking(true);
    setAcceptDrops(false); // the main window takes what is dropped
    m_sincePublished.start();
    m_sinceSwap.start();
    m_sinceLegend.start();
    connectState();
}

ViewportWidget::~ViewportWidget()
{
    m_tools.cancel(); // while everything that hears of it still stands
    end();
}

void ViewportWidget::redraw()
{
    renew();
    refreshClock();
}

void ViewportWidget::renew()
{
    m_isRipening = false;
    m_ripens.stop();
    renewPicture();
}

void ViewportWidget::ripen()
{
    m_isRipening = true;
    renewPicture();
}

void ViewportWidget::redrawPaths()
{
    m_paths.forget();
    refreshPlaces();
    redraw();
}

void ViewportWidget::connectState()
{
    connectScene();
    connectSession();
    connectView();
    connectOwn();
}

void ViewportWidget::connectScene()
{
    connect(&m_state.document(), &model::SceneDocument::changed, this, [this] {
        m_colours.forget(); // names and colours too may be others
        redraw();
        refreshText();
    });
    connect(&m_state.selection(), &Selection::changed, this, &ViewportWidget::redraw);
    connect(&m_state, &EditorState::washedChanged, this, &ViewportWidget::redraw);
    connect(&m_state, &EditorState::lightChosen, this, &ViewportWidget::redraw);
    connect(&m_state, &EditorState::markedPointChanged, this, &ViewportWidget::redraw);
    connect(&m_state.director(), &CameraDirector::changed, this, &ViewportWidget::redraw);
    connect(&m_state.takes(), &TakeShelf::ghostChanged, this, &ViewportWidget::redraw);
    connect(&m_state.transport(), &Transport::stateChanged, this, &ViewportWidget::redraw);
    connect(&m_state.document(), &model::SceneDocument::changed, this,
            [this](const model::SceneChange& change) {
                visitChange(
                    change, [this](const model::PathsChanged&) { redrawPaths(); },
                    [this](const model::RelationsChanged&) { redraw(); },
                    [this](const model::RelationKindsChanged&) { redraw(); },
                    [this](const model::StagesChanged&) { redrawPaths(); },
                    [this](const model::SceneReplaced&) {
                        m_isSceneNew = true;
                        redrawPaths();
                    },
                    // Places that rules speak of have their names shown.
                    [this](const model::RulesChanged&) { refreshPlaces(); });
            });
    connect(&m_state.paths(), &PathFocus::changed, this, &ViewportWidget::redrawPaths);
    connect(&m_state.ground(), &GroundFinder::changed, this, &ViewportWidget::redraw);
}

void ViewportWidget::connectSession()
{
    connect(&m_state.session(), &SessionControl::stateChanged, this, &ViewportWidget::redraw);
    connect(&m_state.session(), &SessionControl::surfaceChanged, this, [this] {
        refreshText();
        if (m_state.session().surfaceProgress() < 0.0) {
            redrawPaths(); // people may take other ways
        }
    });
    connect(&m_state.session(), &SessionControl::stepped, this, [this] {
        if (!m_clock.isRunning()) {
            renew(); // a single step
            refreshText();
        }
    });
}

void ViewportWidget::connectView()
{
    connect(&m_state, &EditorState::viewOptionsChanged, this, &ViewportWidget::redrawPaths);
    connect(&m_state, &EditorState::toolChanged, this, &ViewportWidget::refreshPlaces);
    connect(&m_state, &EditorState::viewCameraChanged, this, &ViewportWidget::refreshPlaces);
    m_handRests.setSingleShot(true);
    m_handRests.setInterval(kHandStillMs);
    connect(&m_handRests, &QTimer::timeout, this, [this] { m_overlay->setBrushCarried(false); });
    m_ripens.setSingleShot(true);
    connect(&m_ripens, &QTimer::timeout, this, &ViewportWidget::ripen);
    m_viewMotion.setSingleShot(true);
    m_viewMotion.setInterval(kViewStillMs);
    connect(&m_viewMotion, &QTimer::timeout, this, &ViewportWidget::renew);
    connect(&m_state, &EditorState::viewCameraChanged, this, [this] {
        m_viewMotion.start();
        redraw();
    });
    connect(&m_state, &EditorState::viewOptionsChanged, this, &ViewportWidget::redraw);
    connect(&m_state, &EditorState::brushChanged, this, &ViewportWidget::redraw);
    connect(&m_state, &EditorState::toolChanged, this, &ViewportWidget::redraw);
    connect(&m_state, &EditorState::keyframesChanged, this, [this] {
        redraw();
        refreshText();
    });
}

void ViewportWidget::connectOwn()
{
    connect(&m_state, &EditorState::longWorkChanged, this, &ViewportWidget::refreshText);
    connect(m_work, &WorkBar::buttonPressed, this, &ViewportWidget::pressWorkButton);
    connect(&m_tools, &ToolController::scenePreviewChanged, this, &ViewportWidget::redraw);
    connect(&m_tools, &ToolController::pictureChanged, this, &ViewportWidget::refreshOverlay);
    connect(&m_tools, &ToolController::paletteRequested, this, &ViewportWidget::showPopup);
    connect(&m_clock, &FrameClock::beat, this, &ViewportWidget::beat);
    connect(this, &PictureSurface::pictureShown, this, &ViewportWidget::finishFrame);
}

void ViewportWidget::showPopup(const QPointF& position)
{
    if (m_popup == nullptr) {
        m_popup = new BrushPopup(m_state, this);
    }
    m_popup->popUp(mapToGlobal(position.toPoint()));
}

void ViewportWidget::contextBegins()
{
    const model::Result<void> result = m_renderer->initialize();
    setProblem(result ? model::Message() : result.error().said);
}

void ViewportWidget::contextEnds(bool isCurrent)
{
    if (isCurrent) {
        m_renderer->destroy();
    } else {
        m_renderer->abandon();
    }
}

/// Of relations, lights, and the point that a panel speaks of.
void ViewportWidget::makeLines(const model::CrowdFrame& frame)
{
    m_arcs.make(m_state, frame);
    m_lightMarks.make(m_state, frame);
    m_cameraMarks.make(m_state);
    m_lines.assign(m_arcs.lines().begin(), m_arcs.lines().end());
    m_lines.insert(m_lines.end(), m_lightMarks.lines().begin(), m_lightMarks.lines().end());
    m_lines.insert(m_lines.end(), m_cameraMarks.lines().begin(), m_cameraMarks.lines().end());
    m_lines.insert(m_lines.end(), m_takeGhosts.lines().begin(), m_takeGhosts.lines().end());
    if (m_state.markedPoint()) {
        addPointMark(m_lines, *m_state.markedPoint(), m_state.camera());
    }
}

/// Who would be created, and people as they are in another take.
void ViewportWidget::makeGhosts()
{
    m_takeGhosts.make(m_state, m_tools.queries().seats(), *m_state.frame());
    m_ghosts = m_tools.picture().ghosts;
    m_ghosts.insert(m_ghosts.end(), m_takeGhosts.ghosts().begin(), m_takeGhosts.ghosts().end());
}

render::RenderInput ViewportWidget::renderInput()
{
    const ViewOptions& options = m_state.viewOptions();
    SceneQueries& queries = m_tools.queries();
    render::RenderInput input(queries.view(), m_state.keyframes());
    input.frame = m_state.frame();
    input.stages = m_state.scene().stages;
    input.seats = queries.seats();
    input.seatsVersion = queries.seatsVersion();
    input.lighting = m_state.scene().lighting;
    input.lights = m_state.scene().lights;
    input.lighting.showGroundGrid &= options.showGroundGrid;
    input.look = options.look;
    if (render::lookInfo(options.look).isByProperty) {
        input.frame = m_colours.painted(m_state, input.frame);
    }
    setQuality(input);
    input.showShadows = options.showShadows;
    if (const model::LookPreset* look = shownLook(m_state)) {
        render::useLook(input, *look);
    }
    input.selected = m_state.selection().ids();
    if (!m_state.washed().empty()) {
        input.selected = m_state.washed();
        input.selectionColor = kWashColor;
    }
    input.hovered = m_tools.picture().hovered;
    makeGhosts();
    input.ghosts = m_ghosts;
    m_marks.make(m_state, *input.frame);
    const bool isCreating = m_state.tool() == ToolId::BrushCreate;
    if (options.showSeats && isCreating && m_state.isSeatGridOn()) {
        m_marks.add(queries.freeSeats());
    }
    input.markers = m_marks.markers();
    makeLines(*input.frame);
    input.lines = m_lines;
    if (options.showPaths) {
        input.areas = m_paths.areas(m_state, queries.stage());
        input.areasVersion = m_paths.version();
    }
    if (options.showWalkable) {
        input.groundAreas = m_walkable.areas(m_state.ground().soon());
        input.groundAreasVersion = m_walkable.version();
    }
    return input;
}

void ViewportWidget::refreshPlaces()
{
    m_overlay->setPlaces(pathLabels(m_state, m_tools.queries().view()));
}

QSize ViewportWidget::choosePictureSize()
{
    m_sinceDraw.start();
    m_ripeness = m_isRipening && !isMoving() ? m_ripeness + 1 : 0;
    m_isRipening = false;
    chooseQuality();
    m_pictureSize = (QSizeF(pixelSize()) * pictureShare()).toSize().expandedTo({1, 1});
    return m_pictureSize;
}

void ViewportWidget::drawPicture(std::uint32_t framebuffer, const QSize& size)
{
    if (!m_renderer->isInitialized()) {
        return;
    }
    render::RenderInput input = renderInput();
    input.framebufferSize = {size.width(), size.height()};
    const model::Result<void> result = m_renderer->draw(input, framebuffer);
    if (m_isSceneNew) { // what the old one was drawn from goes
        m_isSceneNew = false;
        m_renderer->releaseUnused();
        m_scale.forget(); // another one takes another time
    }
    setProblem(result ? model::Message() : result.error().said);
    m_input.setShownSeconds(m_state.transport().seconds());
    const int reductionBefore = m_statistics.render.reduction;
    m_statistics.render = m_renderer->statistics();
    if (m_statistics.render.reduction != reductionBefore) {
        refreshText();
    }
    m_isShownFinal = !isMoving();
    m_isFrameOpen = true;
}

void ViewportWidget::chooseQuality()
{
    const PictureQuality quality = m_state.viewOptions().quality;
    const double frameMs = m_frameTimes.median();
    if (quality != PictureQuality::Automatic) {
        m_isCoarse = quality == PictureQuality::Fast;
    } else if (m_ripeness == 0) { // those that become one are all alike
        const bool isSlow = frameMs > (m_isCoarse ? kQuickMs : kSlowMs);
        m_isCoarse = isSlow || (m_isCoarse && m_scale.share() < 1.0);
    }
}

/// What stands still is drawn as large as it is shown.
double ViewportWidget::pictureShare() const
{
    const bool mayBeSmaller =
        m_isCoarse && isMoving() && m_state.viewOptions().quality != PictureQuality::Best;
    return mayBeSmaller ? m_scale.share() : 1.0;
}

/// So many pictures of the same become one.
int ViewportWidget::picturesToRipen() const
{
    const PictureQuality quality = m_state.viewOptions().quality;
    return quality == PictureQuality::Fast   ? 1
           : quality == PictureQuality::Best ? kRipeAtBest
                                             : kRipe;
}

void ViewportWidget::setQuality(render::RenderInput& input) const
{
    input.pixelSize = {m_pictureSize.width(), m_pictureSize.height()};
    input.samples = m_isCoarse ? 0 : m_state.viewOptions().samples;
    input.smoothsEdges = true;
    // The hysteresis hides flicker in motion; a picture at rest is the same whatever led to it.
    input.levels.hysteresis = isMoving() ? input.levels.hysteresis : 0.0F;
    if (isMoving() && m_state.viewOptions().quality != PictureQuality::Best) {
        // Cards have hard edges, which samples do not soften.
        input.levels.impostorPixels = input.samples > 0 ? kCardsBesideSamples : kCards;
    }
    if (!isMoving() && picturesToRipen() > 1) {
        input.ripeness = m_ripeness;
    }
}

void ViewportWidget::finishFrame()
{
    if (!m_isFrameOpen) {
        return; // only the overlay was painted
    }
    m_isFrameOpen = false;
    std::vector<TagLabel> legend = m_marks.legend();
    legend.insert(legend.end(), m_arcs.legend().begin(), m_arcs.legend().end());
    m_overlay->setLegend(legend);
    refreshProperties();
    if (!isMoving() && m_ripeness + 1 < picturesToRipen()) {
        m_ripens.start(m_ripeness == 0 ? kRipenMs : 0);
    }
    if (m_ripeness > 0) {
        return; // it says nothing of how quick pictures are
    }
    const double frameMs = static_cast<double>(m_sinceDraw.nsecsElapsed()) * 1e-6;
    m_clock.noteFrameTime(frameMs);
    if (m_isCoarse && !m_isShownFinal) {
        m_scale.note(frameMs);
    }
    m_frameTimes.add(frameMs);
    m_frameIntervals.add(static_cast<double>(m_sinceSwap.nsecsElapsed()) * 1e-6);
    m_sinceSwap.start();
    if (m_statistics.render.areKeyframesMissing) {
        refreshText();
    }
    publishStatistics(!m_clock.isRunning());
}

/// Numbers that change with every picture are not to be read.
void ViewportWidget::refreshProperties()
{
    if (!m_clock.isRunning() || m_sinceLegend.elapsed() >= kPublishMs) {
        m_sinceLegend.start();
        m_properties->refresh();
    }
}

void ViewportWidget::publishStatistics(bool isAtRest)
{
    if (!isAtRest && m_sincePublished.elapsed() < kPublishMs) {
        return;
    }
    m_sincePublished.start();
    m_statistics.frameMs = m_frameTimes.median();
    const double interval = m_frameIntervals.median();
    m_statistics.framesPerSecond = isAtRest || interval <= 0.0 ? 0.0 : 1000.0 / interval;
    Q_EMIT statisticsChanged(m_statistics);
}

void ViewportWidget::beat(double elapsedSeconds)
{
    const bool isAnimating = m_state.isAnimating();
    m_state.advance(elapsedSeconds);
    m_tools.tick(m_input.resting(), elapsedSeconds);
    if (isAnimating) {
        renew();
    }
    refreshClock();
}

void ViewportWidget::refreshClock()
{
    const bool wasRunning = m_clock.isRunning();
    m_clock.setRunning(isVisible() && (m_state.isAnimating() || m_tools.needsTick()));
    if (wasRunning && !m_clock.isRunning()) {
        publishStatistics(true);
        if (!m_isShownFinal) {
            renew(); // once more, smooth and without hysteresis
        }
    }
}

void ViewportWidget::refreshOverlay()
{
    const ToolPicture& picture = m_tools.picture();
    m_overlay->setPicture(picture);
    refreshCursor();
    refreshText();
    refreshClock();
}

/// Where pictures follow each other slowly, the window system carries the brush; once the hand
/// rests it is painted into the picture again, at the same place.
void ViewportWidget::refreshCursor()
{
    const ToolPicture& picture = m_tools.picture();
    const bool isSlow = m_clock.isRunning() && m_frameTimes.median() > kSlowMs;
    const auto carried =
        isSlow ? m_brushCursor.cursorFor(picture, devicePixelRatioF()) : std::nullopt;
    if (!carried) {
        m_overlay->setBrushCarried(false);
        if (cursor().shape() != picture.cursor) {
            setCursor(picture.cursor);
        }
        return;
    }
    if (cursor() != *carried) {
        setCursor(*carried);
    }
    if (picture.symbolAt != m_brushAt) {
        m_brushAt = picture.symbolAt;
        m_overlay->setBrushCarried(true);
        m_handRests.start();
    }
}

QString ViewportWidget::helpText() const
{
    const model::Scene& scene = m_state.scene();
    if (!m_problem.isEmpty()) {
        return m_problem;
    }
    if (!scene.population.isEmpty() || !scene.stages.empty()) {
        return {};
    }
    if (scene.templates.empty()) {
        return tr("This scene is empty.\nDrop a character (.glb) or a stage here, or open a "
                  "scene from the File menu.");
    }
    if (m_tools.isDragging()) {
        return {};
    }
    return m_state.tool() == ToolId::BrushCreate
               ? tr("Nobody is here yet.\nDrag over the ground: characters come.")
               : tr("Nobody is here yet.\nPress C and paint characters on the ground.");
}

WorkStatus ViewportWidget::workStatus()
{
    const double surface = m_state.session().surfaceProgress();
    if (surface >= 0.0) {
        return {tr("Finding out where characters can walk"), surface, {}, {}};
    }
    if (const double taken = m_state.session().takenShare(); taken >= 0.0) {
        return {tr("Playing up to this moment once more"), taken, {}, {}};
    }
    const auto baking = m_state.keyframes().progress();
    if (baking.pendingClips == 0) {
        m_bakedBefore = baking.finishedClips;
    }
    if (const LongWork& work = m_state.longWork(); work.total > 0) {
        const double done = static_cast<double>(work.done) / work.total;
        return work.isStroke ? WorkStatus{work.text, done, tr("Cancel"), tr("Take it back (Esc)")}
                             : WorkStatus{work.text, done, {}, {}};
    }
    if (baking.isPaused) {
        return {tr("Animations are not prepared: some characters stand still."), -1.0,
                tr("Prepare"), tr("Go on preparing them")};
    }
    if (baking.pendingClips > 0) {
        const int done = baking.finishedClips - m_bakedBefore;
        const int total = done + baking.pendingClips;
        return {tr("Preparing animations: %1 of %2").arg(done + 1).arg(total),
                static_cast<double>(done) / total, tr("Cancel"),
                tr("Stop: whose animation is not ready stands still")};
    }
    if (m_statistics.render.reduction > 0) {
        return {tr("The memory of the graphics card is used up: characters and pictures are "
                   "coarser. Fewer templates, or other programs closed, make room."),
                -1.0,
                {},
                {}};
    }
    if (baking.isBudgetReached) {
        return {tr("The memory for prepared animations is used up: some characters stand still. "
                   "The preferences set its size."),
                -1.0,
                {},
                {}};
    }
    return {};
}

void ViewportWidget::pressWorkButton()
{
    if (m_state.longWork().isStroke && m_state.scriptPainter() != nullptr) {
        m_state.scriptPainter()->cancel();
        return;
    }
    m_state.keyframes().setPaused(!m_state.keyframes().progress().isPaused);
    renew(); // what is drawn is asked for again
    refreshText();
}

void ViewportWidget::refreshText()
{
    m_overlay->setText({helpText(), m_tools.picture().mode});
    m_work->setStatus(workStatus());
}

void ViewportWidget::setProblem(const model::Message& said)
{
    if (m_said == said) {
        return;
    }
    m_said = said;
    m_problem = said.empty() ? QString() : model::translated(said);
    refreshText();
    Q_EMIT problemChanged(m_problem);
}

/// Everything else is said anew with each picture.
void ViewportWidget::renewTexts()
{
    delete std::exchange(m_popup, nullptr); // comes again when it is asked for
    m_problem = m_said.empty() ? QString() : model::translated(m_said);
    m_tools.renewTexts();
    m_properties->renewTexts();
    refreshPlaces();
    refreshText();
    renew();
}

void ViewportWidget::resizeEvent(QResizeEvent* event)
{
    // The base paints at once: first, what it is to show, and nothing over pictures of another
    // view.
    m_state.setViewSize(glm::vec2(std::max(1, width()), std::max(1, height())));
    renew();
    PictureSurface::resizeEvent(event);
    m_overlay->setGeometry(rect());
    m_work->place();
    m_properties->place();
    refreshPlaces();
}

void ViewportWidget::changeEvent(QEvent* event)
{
    PictureSurface::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        renewTexts();
    }
}

} // namespace crowd::widgets
