// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <QtCore/QObject>
#include <QtCore/QString>
#include <glm/vec2.hpp>

#include "model/bake/KeyframeStore.h"
#include "model/brush/BrushSettings.h"
#include "model/brush/LastStrokes.h"
#include "model/document/SceneDocument.h"
#include "model/states/ChangeOver.h"
#include "model/view/View.h"
#include "render/RenderInput.h"
#include "widgets/state/CameraDirector.h"
#include "widgets/state/CameraMotion.h"
#include "widgets/state/GroundFinder.h"
#include "widgets/state/PathFocus.h"
#include "widgets/state/ScriptBrush.h"
#include "widgets/state/Selection.h"
#include "widgets/state/SessionControl.h"
#include "widgets/state/TakeShelf.h"
#include "widgets/state/ToolId.h"
#include "widgets/state/Transport.h"
#include "widgets/state/UndoGroups.h"

namespace crowd::widgets {

/// What the mouse buttons paint with.
enum class ButtonMapping : std::uint8_t {
    Standard, ///< left paints with the brush's own selection, right opens the palette
    Paper     ///< left a point, middle a circle, right a rectangle (Ulicny et al. 2004)
};

class ScriptPainter;

/// How the picture is drawn and handled, apart from the scene itself. Saved with the preferences.
/// What a picture may cost.
enum class PictureQuality : std::uint8_t {
    Automatic, ///< as smooth as it can be without lagging behind, and perfect at rest
    Fast,      ///< always as quick as it can be
    Best       ///< always smooth
};

struct ViewOptions
{
    bool showSeats = true; ///< free seats as discs while the creation brush snaps to them
    bool showGroundGrid = true;
    bool showShadows = true;
    bool showPaths = true;
    bool showTags = false;
    bool showRelations = false;  ///< arcs: of the selected, of all where nobody is
    bool showWalkable = false;   ///< where people can walk, as a colour on the ground
    bool selectsByLasso = false; ///< the select tool; else by a rectangle
    render::Look look = render::Look::Lit;
    std::string property = "template"; ///< of the look "property", as model::paintBy() takes it
    model::LookId ownLook = 0; ///< of the scene, whose light, background and lines there are
    ButtonMapping buttons = ButtonMapping::Standard;
    PictureQuality quality = PictureQuality::Automatic;
    int samples = 4; ///< a pixel, while the picture keeps up; 0: edges are found in it
    friend bool operator==(const ViewOptions&, const ViewOptions&) = default;
};

/// The view's camera, and the name of the bookmark it stands at exactly (empty: a free view).
struct ViewCamera
{
    model::Camera camera;
    QString name;
};

/// What the next click in the picture chooses, instead of what the tool does.
enum class Picking : std::uint8_t {
    None,
    Colour, ///< of the person under it, for the colours of the active brush
    Point,  ///< that people are to face, for the heading of the active brush
    Place,  ///< any point on the ground or a stage, see choosePoint()
    Person  ///< see choosePerson()
};

/// How states are given back, by whatever key or button.
struct RecallSettings
{
    model::RecallTiming timing; ///< the heading is the view's at that moment
    bool isForRunAlone = false; ///< from the panel, while it plays
    bool isForSelected = false; ///< for who of the state is selected, and nobody else
    friend bool operator==(const RecallSettings&, const RecallSettings&) = default;
};

/// Work that takes its time, shown over the picture. total 0: nothing is going on.
struct LongWork
{
    QString text;
    int done = 0;
    int total = 0;
    bool isStroke = false; ///< of a script brush: offers to take it back
};

/// What the editor works with beside the document: tool, brushes, selection, clock, view. One per
/// main window, owned by it and handed to viewport and docks; the document outlives it. Main thread
/// only.
class EditorState : public QObject
{
    Q_OBJECT

public:
    explicit EditorState(model::SceneDocument& document, QObject* parent = nullptr);
    ~EditorState() override;

    [[nodiscard]] model::SceneDocument& document() const { return m_document; }
    [[nodiscard]] const model::Scene& scene() const { return m_document.scene(); }
    [[nodiscard]] model::KeyframeStore& keyframes() { return m_keyframes; }
    [[nodiscard]] Selection& selection() { return m_selection; }
    [[nodiscard]] const Selection& selection() const { return m_selection; }
    [[nodiscard]] Transport& transport() { return m_transport; }
    [[nodiscard]] const Transport& transport() const { return m_transport; }
    [[nodiscard]] PathFocus& paths() { return m_paths; }
    [[nodiscard]] const PathFocus& paths() const { return m_paths; }
    /// The strokes that can be laid anew.
    [[nodiscard]] model::LastStrokes& strokes() { return m_strokes; }
    /// Where people can walk.
    [[nodiscard]] GroundFinder& ground() { return m_ground; }
    [[nodiscard]] UndoGroups& undoGroups() { return m_undoGroups; }
    [[nodiscard]] SessionControl& session() { return m_session; }
    [[nodiscard]] const SessionControl& session() const { return m_session; }
    [[nodiscard]] CameraDirector& director() { return m_director; }
    [[nodiscard]] TakeShelf& takes() { return m_takes; }
    [[nodiscard]] const TakeShelf& takes() const { return m_takes; }
    /// What is shown now: the scene at the transport's time, people where a session has them.
    [[nodiscard]] model::CrowdFramePtr frame() const;

    [[nodiscard]] ToolId tool() const { return m_tool; }
    void setTool(ToolId id);
    /// The tool that was active before this one.
    [[nodiscard]] ToolId previousTool() const { return m_previousTool; }

    [[nodiscard]] const model::BrushSettings& brush(model::BrushKind kind) const;
    void setBrush(const model::BrushSettings& settings); ///< for the kind it names
    /// Settings of the active tool; null when it is no brush.
    [[nodiscard]] const model::BrushSettings* activeBrush() const;
    /// Brushes that scripts brought along, in the order of their coming.
    [[nodiscard]] const std::vector<ScriptBrush>& scriptBrushes() const { return m_scriptBrushes; }
    /// Takes the place of the one with the same name; what the artist has set there stays where it
    /// still fits.
    void putScriptBrush(ScriptBrush brush);
    /// The brush of the kind Script is this one from now on.
    void chooseScriptBrush(const std::string& name);
    /// Null: no scripts run here.
    [[nodiscard]] ScriptPainter* scriptPainter() const { return m_scriptPainter; }
    void setScriptPainter(ScriptPainter* painter) { m_scriptPainter = painter; }
    /// Whether creation and dragging snap to free seats (part of the creation brush's settings).
    [[nodiscard]] bool isSeatGridOn() const;
    void setSeatGridOn(bool isOn);

    [[nodiscard]] Picking picking() const { return m_picking; }
    void setPicking(Picking picking); ///< ends when the tool changes
    /// The next click in the picture, with any tool, calls `taken` with the point under it. What
    /// was to be chosen before is not any more.
    using PointTaken = std::function<void(const glm::vec3& metres)>;
    void choosePoint(PointTaken taken);
    /// That was the click: ends the picking.
    void offerPoint(const glm::vec3& metres);
    /// The same with somebody, and with who was under the click.
    using PersonTaken = std::function<void(model::IndividualId id)>;
    void choosePerson(PersonTaken taken);
    void offerPerson(model::IndividualId id);
    /// A colour was picked in the picture.
    void offerColor(const model::PaintColor& color) { Q_EMIT colorPicked(color); }
    /// A stroke of this brush became an undo step.
    void noteStroke(model::BrushKind kind) { Q_EMIT strokeCommitted(kind); }

    [[nodiscard]] const ViewCamera& viewCamera() const { return m_view; }
    [[nodiscard]] const model::Camera& camera() const { return m_view.camera; }
    /// At once, as drags do; stops a motion. The name is forgotten unless one is given.
    void setCamera(const model::Camera& camera, const QString& name = {});
    /// Smoothly; later calls take over from where the camera is by then.
    void moveCameraTo(const model::Camera& camera, const QString& name = {},
                      double seconds = CameraMotion::kSeconds);
    /// Where the camera is going, or where it is.
    [[nodiscard]] model::Camera cameraTarget() const;
    /// Size of the picture in logical pixels, told by the viewport.
    [[nodiscard]] glm::vec2 viewSize() const { return m_viewSize; }
    void setViewSize(glm::vec2 logicalPixels) { m_viewSize = logicalPixels; }

    [[nodiscard]] const ViewOptions& viewOptions() const { return m_options; }
    void setViewOptions(const ViewOptions& options);
    /// Whether relations are seen: as the view is set, and always while the brush works on them.
    [[nodiscard]] bool showsRelations() const
    {
        return m_options.showRelations || m_tool == ToolId::BrushRelation;
    }

    [[nodiscard]] const RecallSettings& recall() const { return m_recall; }
    void setRecall(const RecallSettings& recall);
    /// A state was recalled in the run alone, of which undo knows nothing.
    void noteRecallInRun(const QString& name);
    /// The name of that state, once, while the run goes on and nothing was done in the scene since.
    [[nodiscard]] QString takeRecallInRun();

    /// The light that is looked at and has its handles in the picture; 0: none.
    [[nodiscard]] model::LightId chosenLight() const { return m_chosenLight; }
    void chooseLight(model::LightId id);

    /// The state that is looked at, or that came last; 0: none.
    [[nodiscard]] model::StateId chosenState() const { return m_chosenState; }
    void chooseState(model::StateId id);

    /// A point that a panel speaks of, marked in the picture: metres, world frame.
    [[nodiscard]] const std::optional<glm::vec3>& markedPoint() const { return m_markedPoint; }
    /// Whoever marks one takes away none but his own.
    void markPoint(const QObject* marker, const std::optional<glm::vec3>& metres);

    /// Ascending: they are washed over in the picture instead of those who are selected; empty:
    /// nobody is.
    [[nodiscard]] const std::vector<model::IndividualId>& washed() const { return m_washed; }
    void setWashed(std::vector<model::IndividualId> ids);

    [[nodiscard]] const LongWork& longWork() const { return m_longWork; }
    void setLongWork(const LongWork& work);

    /// What the keys and buttons do right now; stays until the next one.
    [[nodiscard]] const QString& hint() const { return m_hint; }
    void setHint(const QString& hint);
    /// A passing remark for the status bar: "No free seat under the brush".
    void showStatus(const QString& text) { Q_EMIT statusMessage(text); }
    /// Why what was just tried in the picture did nothing: also said where the hand looks.
    void refuse(const QString& text);

    /// Called by the viewport's frame clock: transport and camera motion go on.
    void advance(double realSeconds);
    /// Does the picture change by itself?
    [[nodiscard]] bool isAnimating() const;

Q_SIGNALS:
    void toolChanged(crowd::widgets::ToolId tool);
    void brushChanged(crowd::model::BrushKind kind);
    void scriptBrushesChanged();
    void pickingChanged(crowd::widgets::Picking picking);
    void colorPicked(const crowd::model::PaintColor& color);
    void strokeCommitted(crowd::model::BrushKind kind);
    void viewCameraChanged(const crowd::widgets::ViewCamera& view);
    void viewOptionsChanged(const crowd::widgets::ViewOptions& options);
    void recallChanged(const crowd::widgets::RecallSettings& recall);
    void washedChanged();
    void lightChosen(crowd::model::LightId id);
    void stateChosen(crowd::model::StateId id);
    void markedPointChanged();
    void longWorkChanged(const crowd::widgets::LongWork& work);
    void hintChanged(const QString& hint);
    void statusMessage(const QString& text);
    void refused(const QString& text);
    /// A clip was baked in the background.
    void keyframesChanged(const crowd::model::KeyframeStore::Progress& progress);

private:
    void placeCamera(const model::Camera& camera, const QString& name);
    void followScene(const model::SceneChange& change);
    void beginScene();
    void start(model::BrushKind kind);
    void refreshWalk(bool isNewScene);
    void refreshMix(bool isNewScene);
    void refreshSeatGrid(bool isNewScene);

    model::SceneDocument& m_document;
    model::KeyframeStore m_keyframes;
    Selection m_selection;
    Transport m_transport;
    PathFocus m_paths;
    model::LastStrokes m_strokes;
    SessionControl m_session;
    GroundFinder m_ground;
    UndoGroups m_undoGroups;
    std::array<model::BrushSettings, model::kBrushCount> m_brushes;
    std::array<bool, model::kBrushCount> m_isStarted{}; ///< see startBrush()
    std::vector<ScriptBrush> m_scriptBrushes;
    ScriptPainter* m_scriptPainter = nullptr; ///< somebody else's
    ToolId m_tool = ToolId::BrushCreate;
    ToolId m_previousTool = ToolId::Select;
    Picking m_picking = Picking::None;
    PointTaken m_pointTaken;   ///< of Picking::Place
    PersonTaken m_personTaken; ///< of Picking::Person
    RecallSettings m_recall;
    QString m_recalledInRun;  ///< empty: none
    int m_recalledAtStep = 0; ///< of the undo stack
    std::vector<model::IndividualId> m_washed;
    model::LightId m_chosenLight = 0;
    model::StateId m_chosenState = 0;
    std::optional<glm::vec3> m_markedPoint;
    const QObject* m_pointMarker = nullptr; ///< never looked into
    bool m_hasSeats = false;
    std::optional<model::PathId> m_wantedPath; ///< of the walk brush, also while it is undone
    ViewCamera m_view;
    QString m_motionName;
    CameraMotion m_motion;
    CameraDirector m_director;
    TakeShelf m_takes;
    glm::vec2 m_viewSize{1280.0F, 720.0F};
    ViewOptions m_options;
    LongWork m_longWork;
    QString m_hint;
};

} // namespace crowd::widgets
