// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>

#include <QtCore/QElapsedTimer>
#include <QtCore/QTimer>

#include "widgets/state/EditorState.h"
#include "widgets/tools/ToolController.h"
#include "widgets/viewport/BrushCursor.h"
#include "widgets/viewport/CameraMarks.h"
#include "widgets/viewport/FrameClock.h"
#include "widgets/viewport/FrameStatistics.h"
#include "widgets/viewport/LightMarks.h"
#include "widgets/viewport/PathDrawing.h"
#include "widgets/viewport/PeopleMarks.h"
#include "widgets/viewport/PictureScale.h"
#include "widgets/viewport/PictureSurface.h"
#include "widgets/viewport/PropertyLegend.h"
#include "widgets/viewport/RelationArcs.h"
#include "widgets/viewport/TakeGhosts.h"
#include "widgets/viewport/ViewportInput.h"
#include "widgets/viewport/WalkableDrawing.h"

namespace crowd::model {
class View;
}
namespace crowd::render {
class Renderer;
}

namespace crowd::widgets {

class BrushPopup;
class ViewportOverlay;
class WorkBar;
struct WorkStatus;

/// The picture. Draws the scene when something changed or plays; the hand over it is the tools'
/// affair. Owns the renderer, which survives the loss
/// of its context (docking). The state outlives it. Main thread only.
class ViewportWidget : public PictureSurface
{
    Q_OBJECT

public:
    explicit ViewportWidget(EditorState& state, QWidget* parent = nullptr);
    ~ViewportWidget() override;

    [[nodiscard]] ToolController& tools() { return m_tools; }
    [[nodiscard]] const FrameStatistics& statistics() const { return m_statistics; }
    /// Share of the window's width and height that the next picture is drawn with.
    [[nodiscard]] double pictureShare() const;
    /// Nothing moves, and no detail levels are left over from the way here. The picture may still
    /// ripen.
    [[nodiscard]] bool isAtRest() const { return m_isShownFinal && !isMoving(); }
    /// So many pictures of the same the one that is shown is the mean of.
    [[nodiscard]] int ripeness() const { return m_ripeness + 1; }
    /// Why there is no picture; empty when all is well.
    [[nodiscard]] const QString& problem() const { return m_problem; }

    [[nodiscard]] QSize minimumSizeHint() const override { return {240, 180}; }
    [[nodiscard]] QSize sizeHint() const override { return {960, 640}; }

Q_SIGNALS:
    /// At most four times a second, and once when the picture comes to rest.
    void statisticsChanged(const crowd::widgets::FrameStatistics& statistics);
    void problemChanged(const QString& problem);

protected:
    void contextBegins() override;
    [[nodiscard]] QSize choosePictureSize() override;
    void drawPicture(std::uint32_t framebuffer, const QSize& size) override;
    void contextEnds(bool isCurrent) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void connectState();
    void connectScene();
    void connectSession();
    void connectView();
    void connectOwn();
    void redraw();
    void renew(); ///< what is shown has changed: the picture begins anew
    void ripen();
    void redrawPaths();
    void beat(double elapsedSeconds);
    void finishFrame();
    void showPopup(const QPointF& position);
    void refreshClock();
    void refreshOverlay();
    void refreshCursor();
    void refreshText();
    void refreshProperties();
    void pressWorkButton();
    [[nodiscard]] QString helpText() const;
    [[nodiscard]] WorkStatus workStatus();
    void publishStatistics(bool isAtRest);
    void chooseQuality();
    void setQuality(render::RenderInput& input) const;
    [[nodiscard]] int picturesToRipen() const;
    void refreshPlaces();
    [[nodiscard]] bool isMoving() const { return m_clock.isRunning() || m_viewMotion.isActive(); }
    void setProblem(const model::Message& said);
    void renewTexts();
    [[nodiscard]] render::RenderInput renderInput();
    void makeLines(const model::CrowdFrame& frame);
    void makeGhosts();

    EditorState& m_state;
    std::unique_ptr<render::Renderer> m_renderer;
    ToolController m_tools;
    ViewportInput m_input;
    ViewportOverlay* m_overlay; ///< child widget
    WorkBar* m_work;            ///< child widget
    PropertyColours m_colours;
    PropertyLegend* m_properties;  ///< child widget
    BrushPopup* m_popup = nullptr; ///< child widget, made when first asked for
    FrameClock m_clock;
    FrameTimes m_frameTimes;
    FrameTimes m_frameIntervals;
    FrameStatistics m_statistics;
    QElapsedTimer m_sinceDraw;
    QElapsedTimer m_sinceSwap;
    QElapsedTimer m_sincePublished;
    QElapsedTimer m_sinceLegend;
    bool m_isFrameOpen = false;  ///< drawn, not swapped yet
    QTimer m_viewMotion;         ///< runs from a change of the view until it counts as still
    bool m_isShownFinal = false; ///< the last picture was drawn while nothing moved
    bool m_isCoarse = false;     ///< with one sample a pixel, to keep up with the hand
    PictureScale m_scale;        ///< where even that does not
    QSize m_pictureSize;         ///< of the last picture, pixels
    QTimer m_ripens;             ///< runs until the next picture of those that become one
    int m_ripeness = 0;          ///< of the last picture: how many of the same were before it
    bool m_isRipening = false;   ///< the next picture is one more of the same
    bool m_isSceneNew = false;   ///< replaced since the last picture
    int m_bakedBefore = 0;       ///< clips finished when the present baking began
    model::Message m_said;       ///< what m_problem says, in any language
    QString m_problem;
    PathDrawing m_paths;
    WalkableDrawing m_walkable;
    PeopleMarks m_marks;
    RelationArcs m_arcs;
    LightMarks m_lightMarks;
    CameraMarks m_cameraMarks;
    TakeGhosts m_takeGhosts;
    std::vector<render::Ghost> m_ghosts;      ///< of the tool and of a take
    std::vector<render::OverlayLine> m_lines; ///< of both
    BrushCursor m_brushCursor;
    QTimer m_handRests;            ///< runs from a movement of the brush until it counts as still
    QPointF m_brushAt{-1.0, -1.0}; ///< at that movement
};

} // namespace crowd::widgets
