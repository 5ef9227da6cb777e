// SPDX-License-Identifier: MIT
#include "widgets/tools/PlaceHandles.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <QtCore/QCoreApplication>
#include <QtCore/QLocale>

#include "model/base/Segment.h"
#include "model/brush/Stroke.h"
#include "model/document/PathEdits.h"
#include "model/document/SceneEdit.h"
#include "widgets/state/BrushTexts.h"
#include "widgets/tools/BrushTool.h"
#include "widgets/tools/PlaceCorners.h"

namespace crowd::widgets {

namespace {

constexpr double kHandleClickSlack = 4.0;
constexpr float kBesideMetres = 0.3F; ///< a place that stood on the ground may end so far off it

/// How far from the middle of a leg's band, 1 at its border; infinite on another floor.
float offMiddle(const glm::vec3& point, const model::Place& from, const model::Place& to)
{
    constexpr float kFloorMetres = 2.5F; // hills between two places
    const glm::vec3 level(1.0F, 0.0F, 1.0F);
    const float share =
        model::nearestShare(point * level, from.position * level, to.position * level);
    const glm::vec3 middle = glm::mix(from.position, to.position, share);
    if (std::abs(point.y - middle.y) > kFloorMetres) {
        return std::numeric_limits<float>::infinity();
    }
    return glm::length((point - middle) * level) / glm::mix(from.radius, to.radius, share);
}

struct PlaceHandlesText
{
    Q_DECLARE_TR_FUNCTIONS(PlaceHandles)
};

class PlaceDrag : public DragSession
{
public:
    PlaceDrag(const ToolContext& context, const ToolInput& press, const PlaceHit& hit)
        : m_context(context), m_press(press), m_hit(hit)
    {
    }

    void update(const ToolInput& input) override
    {
        if (!m_edit &&
            (input.position() - m_press.position()).manhattanLength() <= kHandleClickSlack) {
            return;
        }
        if (!m_edit) {
            begin();
        }
        const auto ground = groundUnder(m_context, input);
        if (m_edit && ground) {
            m_hit.isBorder ? resize(*ground) : move(*ground);
        }
    }

    void release(const ToolInput& input) override
    {
        update(input);
        if (!m_edit) {
            click(input);
            return;
        }
        m_context.state.showStatus(m_isRefused ? model::reasonText(m_reason) : QString());
        const auto edit = std::move(m_edit);
        edit->commit(m_hit.isBorder ? PlaceHandlesText::tr("Resize a place")
                                    : PlaceHandlesText::tr("Move %n place(s)", nullptr,
                                                           static_cast<int>(m_before.size())));
    }

    void cancel() override { m_edit.reset(); }

    void show(ToolPicture& picture) const override
    {
        picture.cursor = m_hit.isBorder ? Qt::SizeHorCursor
                         : m_isRefused  ? Qt::ForbiddenCursor
                                        : Qt::SizeAllCursor;
        const model::Place* place = m_context.state.scene().findPlace(m_hit.place);
        if (m_edit && m_hit.isBorder && place != nullptr) {
            picture.symbolAt = m_press.position();
            picture.label = PlaceHandlesText::tr("%1 m").arg(
                QLocale().toString(static_cast<double>(place->radius), 'f', 2));
        }
    }

private:
    void click(const ToolInput& input)
    {
        PathFocus& focus = m_context.state.paths();
        if (input.modifiers & (Qt::ShiftModifier | Qt::ControlModifier)) {
            focus.toggle(m_hit.place);
            return;
        }
        focus.select({m_hit.place});
        for (const model::Path& path : m_context.state.scene().paths) {
            if (std::ranges::find(path.places, m_hit.place) != path.places.end()) {
                focus.look(path.id);
                return;
            }
        }
    }

    void begin()
    {
        auto edit = m_context.state.document().beginEdit();
        if (!edit) {
            return;
        }
        m_edit = std::move(edit).value();
        PathFocus& focus = m_context.state.paths();
        if (!focus.isSelected(m_hit.place)) {
            focus.select({m_hit.place});
        }
        const auto start = groundUnder(m_context, m_press);
        m_start = start.value_or(glm::vec3(0.0F));
        for (const model::PlaceId id : focus.places()) {
            m_before.push_back(*m_context.state.scene().findPlace(id));
        }
        const model::Place* held = m_context.state.scene().findPlace(m_hit.place);
        const auto brush = held->role == model::PlaceRole::Spot ? model::BrushKind::Path
                                                                : model::BrushKind::Environment;
        if (!m_hit.isBorder && !m_context.state.brush(brush).place()->anywhere) {
            m_walkable = m_context.state.ground().wait();
        }
    }

    /// Where nobody can walk they stay where they were last.
    void move(const glm::vec3& ground)
    {
        std::vector<model::Place> moved = m_before;
        m_reason =
            m_walkable ? model::reasonOf(m_walkable->refusal(ground)) : model::StrokeReason::None;
        m_isRefused = m_reason != model::StrokeReason::None;
        for (model::Place& place : moved) {
            const bool wasOnGround = m_walkable && m_walkable->isWalkable(place.position);
            place.position += ground - m_start;
            if (m_before.size() == 1) {
                place.position.y = ground.y;
            } else if (wasOnGround && place.id != m_hit.place) {
                if (!settle(place.position) && !m_isRefused) {
                    m_isRefused = true;
                    m_reason = model::StrokeReason::NotWalkable;
                }
            }
        }
        for (const model::Place& place : moved) {
            if (!m_isRefused) {
                m_edit->changePlace(place);
            }
        }
    }

    /// Onto the ground there, for those that come along with the held one. False: there is none.
    [[nodiscard]] bool settle(glm::vec3& position) const
    {
        const auto ground = m_walkable->nearest(position);
        const bool isThere = ground && glm::length((*ground - position) *
                                                   glm::vec3(1.0F, 0.0F, 1.0F)) <= kBesideMetres;
        position.y = isThere ? ground->y : position.y;
        return isThere;
    }

    void resize(const glm::vec3& ground)
    {
        for (model::Place place : m_before) {
            if (place.id == m_hit.place) {
                const glm::vec2 away(ground.x - place.position.x, ground.z - place.position.z);
                place.radius = std::clamp(std::sqrt(away.x * away.x + away.y * away.y),
                                          model::kMinPlaceRadius, model::kMaxPlaceRadius);
                m_edit->changePlace(place);
            }
        }
    }

    ToolContext m_context;
    ToolInput m_press;
    PlaceHit m_hit;
    glm::vec3 m_start{0.0F};
    std::vector<model::Place> m_before;
    model::WalkableGroundPtr m_walkable;                      ///< null: they may come anywhere
    bool m_isRefused = false;                                 ///< where the pointer is
    model::StrokeReason m_reason = model::StrokeReason::None; ///< of a refusal
    std::unique_ptr<model::SceneEdit> m_edit;
};

} // namespace

namespace {

/// The way from one place of a path to the next, by the first one's index; path 0: none.
struct Leg
{
    model::PathId path = 0;
    std::size_t index = 0;
};

Leg legUnder(const ToolContext& context, const std::optional<glm::vec3>& ground)
{
    if (!ground || !context.state.viewOptions().showPaths) {
        return {};
    }
    const model::Scene& scene = context.state.scene();
    Leg nearest;
    float least = 1.0F;
    for (const model::Path& path : scene.paths) {
        const std::size_t count = path.places.size();
        const std::size_t legs = path.kind == model::PathKind::Cyclic ? count : count - 1;
        for (std::size_t i = 0; count > 1 && i < legs; ++i) {
            const model::Place* from = scene.findPlace(path.places[i]);
            const model::Place* to = scene.findPlace(path.places[(i + 1) % count]);
            const float off =
                from != nullptr && to != nullptr ? offMiddle(*ground, *from, *to) : least;
            if (off < least) {
                least = off;
                nearest = {path.id, i};
            }
        }
    }
    return nearest;
}

/// Whether another path leads over it.
bool isNeeded(const model::Scene& scene, model::PlaceId place, model::PathId path)
{
    return std::ranges::any_of(scene.paths, [&](const model::Path& each) {
        return each.id != path && std::ranges::find(each.places, place) != each.places.end();
    });
}

} // namespace

model::PathId pathUnder(const ToolContext& context, const ToolInput& input)
{
    return legUnder(context, groundUnder(context, input)).path;
}

bool insertPlaceUnder(const ToolContext& context, const ToolInput& input)
{
    const auto ground = groundUnder(context, input);
    const Leg leg = legUnder(context, ground);
    const model::Scene& scene = context.state.scene();
    const model::Path* path = scene.findPath(leg.path);
    if (path == nullptr) {
        return false;
    }
    const model::Place& from = *scene.findPlace(path->places[leg.index]);
    const model::Place& to = *scene.findPlace(path->places[(leg.index + 1) % path->places.size()]);
    model::Place added = from;
    added.position = *ground;
    added.radius = 0.5F * (from.radius + to.radius);
    added.name.clear();
    model::PlaceId made = 0;
    context.state.document().edit(
        PlaceHandlesText::tr("Insert a place"),
        [&](model::SceneEdit& edit) { made = insertPlace(edit, leg.path, leg.index + 1, added); });
    if (made != 0) {
        context.state.paths().look(leg.path);
        context.state.paths().select({made});
    }
    return true;
}

void endPath(EditorState& state)
{
    const model::Path* path =
        state.paths().isPainting() ? state.scene().findPath(state.paths().path()) : nullptr;
    if (path != nullptr && path->places.size() == 1) {
        const model::Path gone = *path;
        const bool isTaken = isNeeded(state.scene(), gone.places.front(), gone.id);
        state.document().edit(PlaceHandlesText::tr("Take back a path of one place"),
                              [&](model::SceneEdit& edit) {
                                  edit.removePath(gone.id);
                                  if (!isTaken) {
                                      edit.removePlace(gone.places.front());
                                  }
                              });
    }
    const model::Place* post = state.scene().findPlace(state.paths().shaped());
    if (post != nullptr && post->corners.empty()) {
        state.document().edit(PlaceHandlesText::tr("Take back a single corner"),
                              [id = post->id](model::SceneEdit& edit) { edit.removePlace(id); });
    } else if (post != nullptr && post->corners.size() == 2 &&
               state.brush(model::BrushKind::Environment).as<model::EnvironmentSettings>().shape ==
                   model::PlaceShape::Area) {
        state.showStatus(
            PlaceHandlesText::tr("Two corners make a line: an area has three or more."));
    }
    state.paths().end();
}

DragSessionPtr placeDrag(const ToolContext& context, const ToolInput& press, const PlaceHit& hit)
{
    return hit.corner ? cornerDrag(context, press, hit)
                      : std::make_unique<PlaceDrag>(context, press, hit);
}

namespace {

/// A brush as large as a place: its main number is what keys change.
model::BrushSettings brushOf(const model::Place& place)
{
    if (place.shape == model::PlaceShape::Round) {
        model::BrushSettings brush = model::initialBrush(model::BrushKind::Path);
        brush.place()->radiusMetres = place.radius;
        return brush;
    }
    model::BrushSettings brush = model::initialBrush(model::BrushKind::Environment);
    auto& settings = brush.as<model::EnvironmentSettings>();
    settings.shape = model::PlaceShape::Line; // of an area: how far it goes beyond its sides
    settings.widthMetres = 2.0F * place.radius;
    return brush;
}

} // namespace

void resizePlaces(EditorState& state, int steps)
{
    const std::vector<model::PlaceId> places = state.paths().places();
    const QString text = places.size() == 1 ? PlaceHandlesText::tr("Resize a place")
                                            : PlaceHandlesText::tr("Resize places");
    QString said;
    state.document().edit(text, [&](model::SceneEdit& edit) {
        for (const model::PlaceId id : places) {
            model::Place place = *state.scene().findPlace(id);
            const model::BrushSettings size = steppedMainNumber(brushOf(place), steps);
            place.radius = place.shape == model::PlaceShape::Round
                               ? size.place()->radiusMetres
                               : 0.5F * size.as<model::EnvironmentSettings>().widthMetres;
            edit.changePlace(place);
            said = mainNumberText(size);
        }
    });
    state.showStatus(said);
}

void makePathOfPlaces(EditorState& state, model::PathKind kind)
{
    const std::vector<model::PlaceId> places = state.paths().places();
    if (places.size() < 2) {
        state.showStatus(
            PlaceHandlesText::tr("Select two places or more first, in the order to walk them."));
        return;
    }
    model::PathId path = 0;
    const auto outcome =
        state.document().edit(PlaceHandlesText::tr("Make a path"), [&](model::SceneEdit& edit) {
            path = addPathOver(edit, places, kind);
        });
    if (outcome == model::EditOutcome::Refused) {
        return;
    }
    state.paths().select({});
    state.paths().look(path);
    const QString name = QString::fromStdString(state.scene().findPath(path)->name);
    switch (kind) {
    case model::PathKind::Simple:
        state.showStatus(PlaceHandlesText::tr("%1: characters stop at its last place.").arg(name));
        break;
    case model::PathKind::Cyclic:
        state.showStatus(PlaceHandlesText::tr("%1: characters go round and round.").arg(name));
        break;
    case model::PathKind::Teleport:
        state.showStatus(
            PlaceHandlesText::tr("%1: characters jump from its last place to its first.")
                .arg(name));
        break;
    }
}

} // namespace crowd::widgets
