// SPDX-License-Identifier: MIT
#include "widgets/tools/LightHandles.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include <QtCore/QCoreApplication>
#include <QtCore/QLineF>
#include <QtCore/QLocale>
#include <glm/geometric.hpp>

#include "model/document/SceneEdit.h"
#include "model/scene/LightAim.h"
#include "widgets/commands/LightCommands.h"

namespace crowd::widgets {

using model::FieldInfo;
using model::FieldRole;
using model::FieldValue;
using model::Light;

namespace {

constexpr double kLightHandlePixels = 10.0;
constexpr double kLightClickSlack = 4.0;
constexpr float kLeastLevel = 0.05F; ///< sine between ray and ground below which it meets far away
constexpr float kMostMoved = 500.0F; ///< metres in one drag
constexpr float kLeastOpening = 0.02F; ///< radians: its edge can be taken hold of again

struct LightHandlesText
{
    Q_DECLARE_TR_FUNCTIONS(LightHandles)
};

bool isNear(const model::View& view, const glm::vec3& point, const QPointF& pixel)
{
    const auto seen = view.project(point);
    return seen && QLineF(pixel, QPointF(seen->x, seen->y)).length() < kLightHandlePixels;
}

/// Where a ray meets a plane through a point; nothing where it runs along it or away.
std::optional<glm::vec3> onPlane(const model::Ray& ray, const glm::vec3& point,
                                 const glm::vec3& normal)
{
    const float towards = glm::dot(ray.direction, normal);
    if (std::abs(towards) < kLeastLevel) {
        return std::nullopt;
    }
    const float along = glm::dot(point - ray.origin, normal) / towards;
    return along > 0.0F ? std::optional(ray.origin + along * ray.direction) : std::nullopt;
}

/// Where a field is taken hold of; nothing where it has no place, or means nothing.
std::optional<glm::vec3> handleOf(const Light& light, const FieldInfo& field,
                                  const ToolContext& context)
{
    const FieldRole role = field.meta.role;
    if (role == FieldRole::Space) {
        return std::get<glm::vec3>(field.get(&light));
    }
    const bool isOfAim = role == FieldRole::Target || role == FieldRole::Opening;
    const auto target =
        isOfAim && isAimed(light) ? aimedAt(light, context.state.frame().get()) : std::nullopt;
    return target && role == FieldRole::Opening
               ? coneEdge(light, *target, context.state.camera().right())
               : target;
}

class LightDrag : public DragSession
{
public:
    LightDrag(const ToolContext& context, const ToolInput& press, const LightHit& hit)
        : m_context(context), m_press(press), m_hit(hit), m_at(press.position())
    {
    }

    void update(const ToolInput& input) override
    {
        m_at = input.position();
        const bool isStill =
            (input.position() - m_press.position()).manhattanLength() <= kLightClickSlack;
        if (!m_edit && (isStill || !begin())) {
            return;
        }
        if (m_hit.is(FieldRole::Target) && input.modifiers.testFlag(Qt::ControlModifier)) {
            follow(input);
            return;
        }
        const auto value = valueUnder(input);
        if (!value) {
            return;
        }
        m_edit->setLights(withLight(m_context.state.scene().lights, m_hit.light, [&](Light& light) {
            if (m_hit.is(FieldRole::Target)) {
                light.aim = model::LightAim::Place;
            }
            m_hit.field->set(&light, *value);
        }));
    }

    void release(const ToolInput& input) override
    {
        update(input);
        if (const auto edit = std::move(m_edit)) {
            edit->commit(m_hit.is(FieldRole::Opening) ? LightHandlesText::tr("Change a cone")
                                                      : LightHandlesText::tr("Move a light"));
        } else {
            m_context.state.chooseLight(m_hit.light);
        }
    }

    void cancel() override { m_edit.reset(); }

    void show(ToolPicture& picture) const override
    {
        picture.cursor = Qt::SizeAllCursor;
        const Light* light = findLight(m_context.state.scene().lights, m_hit.light);
        if (m_edit && light != nullptr && !m_hit.is(FieldRole::Target)) {
            picture.symbolAt = m_at;
            picture.label = labelOf(*light);
        }
    }

private:
    [[nodiscard]] QString labelOf(const Light& light) const
    {
        const FieldValue value = m_hit.field->get(&light);
        if (const auto* place = std::get_if<glm::vec3>(&value)) {
            return LightHandlesText::tr("%1 m high")
                .arg(QLocale().toString(static_cast<double>(place->y), 'f', 1));
        }
        const double degrees =
            static_cast<double>(std::get<float>(value)) * m_hit.field->meta.shownScale;
        return LightHandlesText::tr("%1°").arg(QLocale().toString(degrees, 'f', 0));
    }

    [[nodiscard]] bool begin()
    {
        const Light* light = findLight(m_context.state.scene().lights, m_hit.light);
        auto edit = m_context.state.document().beginEdit();
        if (light == nullptr || !edit) {
            return false;
        }
        if (m_hit.is(FieldRole::Space)) {
            m_before = std::get<glm::vec3>(m_hit.field->get(light));
        }
        m_edit = std::move(edit).value();
        m_context.state.chooseLight(m_hit.light);
        return true;
    }

    /// Whoever is under the pointer has the light with him from now on.
    void follow(const ToolInput& input)
    {
        const auto hit = m_context.queries.picker(input.pointer.shownSeconds)
                             .individualAt(input.pointer.pixels());
        if (!hit) {
            return;
        }
        m_edit->setLights(withLight(m_context.state.scene().lights, m_hit.light, [&](Light& light) {
            light.aim = model::LightAim::Person;
            light.person = hit->id;
        }));
    }

    [[nodiscard]] std::optional<FieldValue> valueUnder(const ToolInput& input)
    {
        const Light* light = findLight(m_context.state.scene().lights, m_hit.light);
        if (light == nullptr) {
            return std::nullopt;
        }
        if (m_hit.is(FieldRole::Opening)) {
            return openingUnder(input, *light);
        }
        if (m_hit.is(FieldRole::Target)) {
            const auto hit = m_context.queries.picker(input.pointer.shownSeconds)
                                 .surfaceAt(input.pointer.pixels());
            return hit ? std::optional<FieldValue>(hit->point) : std::nullopt;
        }
        return placeUnder(input, std::get<glm::vec3>(m_hit.field->get(light)));
    }

    /// The cone whose edge meets the plane across its way under the pointer.
    [[nodiscard]] std::optional<FieldValue> openingUnder(const ToolInput& input, const Light& light)
    {
        const auto target = aimedAt(light, m_context.state.frame().get());
        const float length = target ? glm::distance(*target, light.position) : 0.0F;
        if (length < kLeastLevel) {
            return std::nullopt;
        }
        const model::Ray ray =
            m_context.queries.view().rayThrough(glm::vec2(input.pointer.pixels()));
        const auto met = onPlane(ray, *target, (*target - light.position) / length);
        if (!met) {
            return std::nullopt;
        }
        const float opening = 2.0F * std::atan2(glm::distance(*met, *target), length);
        const model::FieldMeta& meta = m_hit.field->meta;
        return FieldValue(std::clamp(opening, kLeastOpening, static_cast<float>(meta.high)));
    }

    /// Of what is there `now`.
    [[nodiscard]] std::optional<FieldValue> placeUnder(const ToolInput& input, const glm::vec3& now)
    {
        const model::View view = m_context.queries.view();
        const model::Ray ray = view.rayThrough(glm::vec2(input.pointer.pixels()));
        const bool isUpright = input.modifiers.testFlag(Qt::ShiftModifier);
        glm::vec3 level = view.camera().forward();
        level.y = 0.0F;
        const bool isFromAbove = glm::length(level) < kLeastLevel;
        const glm::vec3 facing = isFromAbove ? glm::vec3(0.0F, 0.0F, 1.0F) : glm::normalize(level);
        if (!isUpright) {
            const auto met = onPlane(ray, now, {0.0F, 1.0F, 0.0F});
            if (met && glm::distance(*met, m_before) <= kMostMoved) {
                return FieldValue(*met);
            }
        }
        const auto met = onPlane(ray, now, facing);
        if (!met || glm::distance(*met, m_before) > kMostMoved) {
            return std::nullopt;
        }
        // At the horizon of its height it goes aside alone: it would be out of the world else.
        return FieldValue(isUpright ? glm::vec3(now.x, met->y, now.z)
                                    : glm::vec3(met->x, now.y, met->z));
    }

    ToolContext m_context;
    ToolInput m_press;
    LightHit m_hit;
    QPointF m_at;             ///< of the pointer
    glm::vec3 m_before{0.0F}; ///< where it was, of what has a place
    std::unique_ptr<model::SceneEdit> m_edit;
};

} // namespace

std::optional<LightHit> lightAt(const ToolContext& context, const QPointF& pixel)
{
    const model::LightId chosen = context.state.chosenLight();
    if (chosen == 0) {
        return std::nullopt;
    }
    const model::View view = context.queries.view();
    std::optional<LightHit> hit;
    for (const Light& light : context.state.scene().lights) {
        for (const FieldInfo& field : model::fieldsOf<Light>()) {
            const auto at = light.id == chosen || field.meta.role == FieldRole::Space
                                ? handleOf(light, field, context)
                                : std::nullopt;
            if (at && isNear(view, *at, pixel) && (!hit || light.id == chosen)) {
                hit = LightHit{light.id, &field};
            }
        }
    }
    return hit;
}

DragSessionPtr lightDrag(const ToolContext& context, const ToolInput& press, const LightHit& hit)
{
    return std::make_unique<LightDrag>(context, press, hit);
}

} // namespace crowd::widgets
