// SPDX-License-Identifier: MIT
#include "widgets/tools/LightHandles.h"

#include <cmath>
#include <utility>

#include <QtCore/QCoreApplication>
#include <QtCore/QLineF>
#include <QtCore/QLocale>
#include <glm/geometric.hpp>

#include "model/document/SceneEdit.h"
#include "model/scene/LightAim.h"
#include "widgets/commands/LightCommands.h"

namespace crowd::widgets {

using model::Light;

namespace {

constexpr double kLightHandlePixels = 10.0;
constexpr double kLightClickSlack = 4.0;
constexpr float kLeastLevel = 0.05F; ///< sine between ray and ground below which it meets far away
constexpr float kMostMoved = 500.0F; ///< metres in one drag

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
        if (m_hit.isTarget && input.modifiers.testFlag(Qt::ControlModifier)) {
            follow(input);
            return;
        }
        const auto place = placeUnder(input);
        if (!place) {
            return;
        }
        m_edit->setLights(withLight(m_context.state.scene().lights, m_hit.light, [&](Light& light) {
            if (m_hit.isTarget) {
                light.aim = model::LightAim::Place;
                light.target = *place;
            } else {
                light.position = *place;
            }
        }));
    }

    void release(const ToolInput& input) override
    {
        update(input);
        if (const auto edit = std::move(m_edit)) {
            edit->commit(LightHandlesText::tr("Move a light"));
        } else {
            m_context.state.chooseLight(m_hit.light);
        }
    }

    void cancel() override { m_edit.reset(); }

    void show(ToolPicture& picture) const override
    {
        picture.cursor = Qt::SizeAllCursor;
        const Light* light = findLight(m_context.state.scene().lights, m_hit.light);
        if (m_edit && light != nullptr && !m_hit.isTarget) {
            picture.symbolAt = m_at;
            picture.label =
                LightHandlesText::tr("%1 m high")
                    .arg(QLocale().toString(static_cast<double>(light->position.y), 'f', 1));
        }
    }

private:
    [[nodiscard]] bool begin()
    {
        const Light* light = findLight(m_context.state.scene().lights, m_hit.light);
        auto edit = m_context.state.document().beginEdit();
        if (light == nullptr || !edit) {
            return false;
        }
        m_lamp = light->position;
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

    [[nodiscard]] std::optional<glm::vec3> placeUnder(const ToolInput& input)
    {
        if (m_hit.isTarget) {
            const auto hit = m_context.queries.picker(input.pointer.shownSeconds)
                                 .surfaceAt(input.pointer.pixels());
            return hit ? std::optional(hit->point) : std::nullopt;
        }
        const model::View view = m_context.queries.view();
        const model::Ray ray = view.rayThrough(glm::vec2(input.pointer.pixels()));
        const bool isUpright = input.modifiers.testFlag(Qt::ShiftModifier);
        const Light* light = findLight(m_context.state.scene().lights, m_hit.light);
        if (light == nullptr) {
            return std::nullopt;
        }
        glm::vec3 level = view.camera().forward();
        level.y = 0.0F;
        const bool isFromAbove = glm::length(level) < kLeastLevel;
        const glm::vec3 facing = isFromAbove ? glm::vec3(0.0F, 0.0F, 1.0F) : glm::normalize(level);
        const glm::vec3 now = light->position;
        if (!isUpright) {
            const auto met = onPlane(ray, now, {0.0F, 1.0F, 0.0F});
            if (met && glm::distance(*met, m_lamp) <= kMostMoved) {
                return met;
            }
        }
        const auto met = onPlane(ray, now, facing);
        if (!met || glm::distance(*met, m_lamp) > kMostMoved) {
            return std::nullopt;
        }
        // At the horizon of its height it goes aside alone: it would be out of the world else.
        return isUpright ? glm::vec3(now.x, met->y, now.z) : glm::vec3(met->x, now.y, met->z);
    }

    ToolContext m_context;
    ToolInput m_press;
    LightHit m_hit;
    QPointF m_at;           ///< of the pointer
    glm::vec3 m_lamp{0.0F}; ///< where it was
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
        const auto target = light.id == chosen && isAimed(light)
                                ? aimedAt(light, context.state.frame().get())
                                : std::nullopt;
        if (target && isNear(view, *target, pixel)) {
            return LightHit{light.id, true};
        }
        if (isNear(view, light.position, pixel) && (!hit || light.id == chosen)) {
            hit = LightHit{light.id, false};
        }
    }
    return hit;
}

DragSessionPtr lightDrag(const ToolContext& context, const ToolInput& press, const LightHit& hit)
{
    return std::make_unique<LightDrag>(context, press, hit);
}

} // namespace crowd::widgets
