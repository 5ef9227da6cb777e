// SPDX-License-Identifier: MIT
#include "widgets/commands/LightCommands.h"

#include <algorithm>
#include <utility>

#include <QtCore/QCoreApplication>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "model/document/SceneEdit.h"
#include "model/rules/Rule.h"
#include "model/rules/RuleValues.h"
#include "widgets/state/BrushTexts.h"

namespace crowd::widgets {

using model::Light;
using model::LightId;
using model::LightKind;
using model::Lights;

namespace {

struct LightText
{
    Q_DECLARE_TR_FUNCTIONS(LightCommands)
};

QString freeLightName(const Lights& lights, LightKind kind)
{
    const QString plain = fieldText(model::kLightKinds[static_cast<std::size_t>(kind)].label);
    for (std::size_t number = 1;; ++number) {
        QString name = plain + QLatin1Char(' ') + QString::number(number);
        if (std::ranges::find(lights, name.toStdString(), &Light::name) == lights.end()) {
            return name;
        }
    }
}

/// Nearer to what it lights until its lamp is in the picture, to be taken hold of there.
void bringIntoView(const EditorState& state, Light& light)
{
    constexpr float kLeastMetres = 1.5F;
    const model::View view(state.camera(), state.viewSize());
    const auto isSeen = [&] {
        const auto at = view.project(light.position);
        return at && at->x > 0.0F && at->y > 0.0F && at->x < view.size().x && at->y < view.size().y;
    };
    while (!isSeen() && glm::distance(light.position, light.target) > kLeastMetres) {
        light.position = glm::mix(light.target, light.position, 0.8F);
    }
}

/// A rule whose light is gone does not mean the next one.
LightId lastLightOfRules(const model::Scene& scene)
{
    LightId last = 0;
    for (const model::Rule& rule : scene.rules) {
        for (const std::uint32_t named : idsNamedIn(rule, model::FieldRole::Light)) {
            last = named != model::kNotChosen ? std::max(last, named) : last;
        }
    }
    return last;
}

/// Named and chosen.
LightId add(EditorState& state, Light light)
{
    Lights lights = state.scene().lights;
    bringIntoView(state, light);
    light.id = freeLightId(lights, lastLightOfRules(state.scene()));
    if (light.id == 0) {
        state.showStatus(LightText::tr("A scene has at most %1 lights: remove one first.")
                             .arg(model::kMostLights));
        return 0;
    }
    light.name = freeLightName(lights, light.kind).toStdString();
    lights.push_back(light);
    const auto outcome =
        state.document().edit(LightText::tr("Add a light"), [&lights](model::SceneEdit& edit) {
            edit.setLights(std::move(lights));
        });
    if (outcome == model::EditOutcome::Refused) {
        return 0;
    }
    state.chooseLight(light.id);
    return light.id;
}

} // namespace

LightId addLight(EditorState& state, LightKind kind, const glm::vec3& lit)
{
    return add(state, newLight(kind, lit, state.camera().position));
}

LightId addFollowSpot(EditorState& state, model::IndividualId person)
{
    const model::CrowdFramePtr shown = state.frame();
    const std::size_t row = shown->population.rowOf(person);
    if (row == model::Population::npos) {
        return 0; // he was removed meanwhile
    }
    const glm::vec3 stands = shown->population.column(model::columns::position)[row];
    Light light = newLight(LightKind::Spot, stands, state.camera().position);
    light.aim = model::LightAim::Person;
    light.person = person;
    return add(state, std::move(light));
}

void removeLight(EditorState& state, LightId id)
{
    Lights lights = state.scene().lights;
    std::erase_if(lights, [id](const Light& each) { return each.id == id; });
    state.document().edit(LightText::tr("Remove a light"),
                          [&lights](model::SceneEdit& edit) { edit.setLights(std::move(lights)); });
}

Lights withLight(const Lights& lights, LightId id, const std::function<void(Light&)>& apply)
{
    Lights changed = lights;
    for (Light& each : changed) {
        if (each.id == id) {
            apply(each);
        }
    }
    return changed;
}

void changeLight(EditorState& state, LightId id, const QString& undoText,
                 const std::function<void(Light&)>& apply)
{
    Lights changed = withLight(state.scene().lights, id, apply);
    state.document().edit(
        undoText, [&changed](model::SceneEdit& edit) { edit.setLights(std::move(changed)); });
}

} // namespace crowd::widgets
