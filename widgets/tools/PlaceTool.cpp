// SPDX-License-Identifier: MIT
#include "widgets/tools/PlaceTool.h"

#include <algorithm>
#include <cmath>

#include <QtCore/QCoreApplication>
#include <QtCore/QLocale>

#include "model/brush/Stroke.h"
#include "model/document/PathEdits.h"
#include "model/document/SceneEdit.h"
#include "model/scene/NearestPath.h"
#include "widgets/tools/EnvironmentPlaces.h"
#include "widgets/tools/PlaceHits.h"
#include "widgets/tools/ShapeDrag.h"

namespace crowd::widgets {

using model::BrushKind;

namespace {

struct PlaceToolText
{
    Q_DECLARE_TR_FUNCTIONS(PlaceTool)
};

/// Places of one drag lie this many radii apart, and at least a step.
constexpr float kSpacingRadii = 2.5F;
constexpr float kLeastSpacing = 1.0F;
/// A way so many times as long as straight on, and so much longer, is worth a word.
constexpr float kDetour = 2.0F;
constexpr float kDetourMetres = 5.0F;

/// Whether a click on a place leads the path back to where it began.
bool closesAt(const model::Path& path, model::PlaceId place)
{
    return path.places.size() > 2 && path.places.front() == place;
}

/// Adds places while the button is held, each at once.
class PaintPlaces : public DragSession
{
public:
    PaintPlaces(const ToolContext& context, BrushKind kind, const ToolInput& press)
        : m_context(context), m_kind(kind), m_current(press)
    {
        add(press);
    }

    void update(const ToolInput& input) override
    {
        m_current = input;
        const auto ground = groundUnder(m_context, input);
        if (!ground || !m_last) {
            return;
        }
        const glm::vec3 way = *ground - *m_last;
        const float spacing = std::max(kLeastSpacing, settings().radiusMetres * kSpacingRadii);
        if (way.x * way.x + way.z * way.z > spacing * spacing) {
            add(input);
        }
    }
    void release(const ToolInput& input) override { m_current = input; }
    void cancel() override {}
    void show(ToolPicture& picture) const override
    {
        picture.cursor = Qt::CrossCursor;
        picture.symbol = toolOf(m_kind);
        picture.symbolAt = m_current.position();
    }

private:
    [[nodiscard]] const model::BrushSettings& brush() const
    {
        return m_context.state.brush(m_kind);
    }
    [[nodiscard]] const model::PlaceSettings& settings() const { return *brush().place(); }
    [[nodiscard]] model::PathKind newPathKind() const
    {
        return brush().as<model::PathSettings>().kind;
    }

    /// The first click of a double click on another path has begun one of its own: that goes, and
    /// the path under the pointer gets the place.
    [[nodiscard]] bool insert(const ToolInput& input)
    {
        EditorState& state = m_context.state;
        const model::Path* begun =
            state.paths().isPainting() ? state.scene().findPath(state.paths().path()) : nullptr;
        const bool isInto = m_kind == BrushKind::Path && input.isSecond && begun != nullptr &&
                            begun->places.size() == 1 && pathUnder(m_context, input) != 0;
        if (!isInto) {
            return false;
        }
        state.document().undoStack().undo();
        state.paths().end();
        return insertPlaceUnder(m_context, input);
    }

    void add(const ToolInput& input)
    {
        if (insert(input)) {
            return;
        }
        const auto ground = groundUnder(m_context, input);
        if (!ground) {
            m_context.state.refuse(PlaceToolText::tr(
                "Nothing to walk on there: the pointer is on the sky, or on something upright. "
                "Click on the ground beside it."));
            return;
        }
        const auto walkable = settings().anywhere ? nullptr : m_context.state.ground().wait();
        const auto refusal = walkable ? walkable->refusal(*ground) : model::WalkRefusal::None;
        if (refusal != model::WalkRefusal::None) {
            m_context.state.refuse(model::reasonText(model::reasonOf(refusal)));
            return;
        }
        m_last = ground;
        m_context.state.showStatus({}); // of the click before
        m_kind == BrushKind::Path ? extendPath(input, *ground) : addDisc(*ground);
    }

    void addDisc(const glm::vec3& ground)
    {
        model::Place place;
        place.position = ground;
        place.radius = settings().radiusMetres;
        addEnvironment(m_context.state, place);
    }

    /// A place that is there already is taken into the path.
    void extendPath(const ToolInput& input, const glm::vec3& ground)
    {
        EditorState& state = m_context.state;
        PathFocus& focus = state.paths();
        const model::PathId current = focus.isPainting() ? focus.path() : 0;
        const auto hit = placeAt(m_context, input.position());
        const model::Path* path = state.scene().findPath(current);
        if (hit && !hit->isBorder) {
            const bool isLast =
                path != nullptr && !path->places.empty() && path->places.back() == hit->place;
            if (isLast) {
                if (input.isSecond && path->places.size() > 1) { // as of lines and areas
                    endPath(state);
                }
                return;
            }
            if (path != nullptr && closesAt(*path, hit->place)) {
                close(*path);
                return;
            }
            extend(PlaceToolText::tr("Lead a path over a place"), [&](model::SceneEdit& edit) {
                return appendKnownPlace(edit, current, hit->place, newPathKind());
            });
            return;
        }
        model::Place place;
        place.position = ground;
        place.radius = settings().radiusMetres;
        const QString text = current == 0 ? PlaceToolText::tr("Begin a path")
                                          : PlaceToolText::tr("Add a place to a path");
        const model::PathId extended = extend(text, [&](model::SceneEdit& edit) {
            return appendPlace(edit, current, place, newPathKind());
        });
        const model::Path* made = state.scene().findPath(extended);
        if (made != nullptr && made->places.size() > 1) { // else it leads nowhere yet
            followFromNowOn(extended);
            sayWay(extended);
        }
    }

    /// What is between the path's last two places, where one does not get straight from the one to
    /// the other.
    void sayWay(model::PathId id) const
    {
        const model::Scene& scene = m_context.state.scene();
        const model::Path* path = scene.findPath(id);
        const model::WalkableGroundPtr ground = m_context.state.ground().soon();
        if (path == nullptr || path->places.size() < 2 || !ground) {
            return;
        }
        const model::Place* from = scene.findPlace(*(path->places.end() - 2));
        const model::Place* to = scene.findPlace(path->places.back());
        if (from == nullptr || to == nullptr) {
            return;
        }
        const auto metres = ground->wayMetres(from->position, to->position, to->radius);
        const float straight = glm::distance(from->position, to->position);
        if (metres && std::isinf(*metres)) {
            m_context.state.showStatus(PlaceToolText::tr(
                "No way leads there from the place before: characters go as near as they can."));
        } else if (metres && *metres > kDetour * straight + kDetourMetres) {
            m_context.state.showStatus(
                PlaceToolText::tr("Something is in between: characters walk %1 m around it.")
                    .arg(QLocale().toString(std::lround(*metres))));
        }
    }

    /// The path that `work` returns is what is chosen from now on; 0: it was refused.
    model::PathId extend(const QString& text,
                         const std::function<model::PathId(model::SceneEdit&)>& work)
    {
        model::PathId extended = 0;
        m_context.state.document().edit(text,
                                        [&](model::SceneEdit& edit) { extended = work(edit); });
        if (extended != 0) {
            choose(extended);
        }
        return extended;
    }

    /// The path is what is chosen from now on, no place.
    void choose(model::PathId path)
    {
        PathFocus& focus = m_context.state.paths();
        focus.select({});
        focus.paint(path);
    }

    void close(model::Path path)
    {
        EditorState& state = m_context.state;
        path.kind = model::PathKind::Cyclic;
        state.document().edit(PlaceToolText::tr("Close a path"),
                              [&](model::SceneEdit& edit) { edit.changePath(path); });
        state.paths().end();
        state.showStatus(PlaceToolText::tr("The path is closed: characters go round."));
    }

    /// The walk brush offers what was painted last, unless it is to find the nearest.
    void followFromNowOn(model::PathId path)
    {
        model::BrushSettings walk = m_context.state.brush(BrushKind::Walk);
        if (walk.as<model::WalkSettings>().path != model::kNearestPath) {
            walk.as<model::WalkSettings>().path = path;
            m_context.state.setBrush(walk);
        }
    }

    ToolContext m_context;
    BrushKind m_kind;
    ToolInput m_current;
    std::optional<glm::vec3> m_last;
};

/// Whether the brush makes lines or areas.
bool makesShapes(const ToolContext& context, BrushKind kind)
{
    return kind == BrushKind::Environment &&
           context.state.brush(kind).as<model::EnvironmentSettings>().shape !=
               model::PlaceShape::Round;
}

} // namespace

PlaceTool::PlaceTool(const ToolContext& context, BrushKind kind) : m_context(context), m_kind(kind)
{
}

QString PlaceTool::hint() const
{
    if (makesShapes(m_context, m_kind) &&
        m_context.state.brush(m_kind).as<model::EnvironmentSettings>().shape ==
            model::PlaceShape::Area) {
        return PlaceToolText::tr("Click: add a corner · Drag: draw freely · Enter, Esc or double "
                                 "click: end it · on the first "
                                 "corner: close it · V: move corners");
    }
    if (makesShapes(m_context, m_kind)) {
        return PlaceToolText::tr("Click: add a corner · Drag: draw freely · Enter, Esc or double "
                                 "click: end it · on the first "
                                 "corner: close it · + −: the width of a line · V: move corners");
    }
    return m_kind == BrushKind::Path
               ? PlaceToolText::tr(
                     "Click: add a place to the path · + −: its size · on the first place: "
                     "close the path · Enter or Esc: end it · Double click on a path: another "
                     "place in it · "
                     "V: move and resize places")
               : PlaceToolText::tr(
                     "Click: put it on the ground · + −: its size · V: move and resize");
}

DragSessionPtr PlaceTool::press(const ToolInput& input)
{
    if (input.button != Qt::LeftButton || m_context.state.document().isEditOpen()) {
        return nullptr;
    }
    if (makesShapes(m_context, m_kind)) {
        return shapeDrag(m_context, input);
    }
    return std::make_unique<PaintPlaces>(m_context, m_kind, input);
}

void PlaceTool::hover(const ToolInput& input, ToolPicture& picture) const
{
    picture.cursor = Qt::CrossCursor;
    picture.symbol = toolOf(m_kind);
    picture.symbolAt = input.position();
    if (makesShapes(m_context, m_kind)) {
        showShapeToCome(m_context, input, picture);
        return;
    }
    const auto ground = groundUnder(m_context, input);
    const model::PlaceSettings& settings = *m_context.state.brush(m_kind).place();
    const auto walkable = settings.anywhere ? nullptr : m_context.state.ground().soon();
    if (!ground || (walkable && !walkable->isWalkable(*ground))) {
        return;
    }
    const model::View view = m_context.queries.view();
    picture.outlines = {placeOutline(view, *ground, settings.radiusMetres)};
    picture.label = PlaceToolText::tr("%1 m").arg(
        QLocale().toString(static_cast<double>(settings.radiusMetres), 'f', 2));
    const PathFocus& focus = m_context.state.paths();
    const model::Path* path = m_kind == BrushKind::Path && focus.isPainting()
                                  ? m_context.state.scene().findPath(focus.path())
                                  : nullptr;
    if (path != nullptr && !path->places.empty()) {
        const model::Place* last = m_context.state.scene().findPlace(path->places.back());
        const auto from = last == nullptr ? std::nullopt : view.project(last->position);
        if (from) {
            picture.arrow = QLineF(QPointF(from->x, from->y), input.position());
        }
        const auto hit = placeAt(m_context, input.position());
        if (hit && !hit->isBorder && closesAt(*path, hit->place)) {
            picture.label = PlaceToolText::tr("Close the path");
        }
    }
}

} // namespace crowd::widgets
