// SPDX-License-Identifier: MIT
#include "widgets/tools/EnvironmentPlaces.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include <QtCore/QCoreApplication>

#include "model/document/SceneEdit.h"
#include "widgets/state/BrushTexts.h"

namespace crowd::widgets {

namespace {

struct EnvironmentPlacesText
{
    Q_DECLARE_TR_FUNCTIONS(PlaceTool)
};

std::array<std::uint8_t, 3> roleColor(model::PlaceRole role)
{
    switch (role) {
    case model::PlaceRole::Spot:
        break;
    case model::PlaceRole::Obstacle:
        return {190, 60, 50};
    case model::PlaceRole::Attractor:
        return {70, 180, 90};
    case model::PlaceRole::Repeller:
        return {200, 90, 160};
    case model::PlaceRole::Exit:
        return {60, 140, 230};
    case model::PlaceRole::Slow:
        return {150, 120, 80};
    case model::PlaceRole::Forbidden:
        return {225, 60, 110};
    case model::PlaceRole::Preferred:
        return {120, 200, 130};
    }
    return {240, 150, 40};
}

/// The first obstacle is Obstacle 1, whatever else there is.
QString freeName(const model::Scene& scene, const QString& what)
{
    for (int number = 1;; ++number) {
        QString name = EnvironmentPlacesText::tr("%1 %2").arg(what).arg(number);
        if (std::ranges::find(scene.places, name.toStdString(), &model::Place::name) ==
            scene.places.end()) {
            return name;
        }
    }
}

QString additionText(const QString& what)
{
    return EnvironmentPlacesText::tr("Add: %1").arg(what);
}

} // namespace

model::PlaceId addEnvironment(EditorState& state, model::Place place)
{
    const auto& brush = state.brush(model::BrushKind::Environment).as<model::EnvironmentSettings>();
    place.role = brush.role;
    place.color = roleColor(place.role);
    const QString what = placeRoleName(place.role);
    place.id = 0;
    state.document().edit(additionText(what), [&](model::SceneEdit& edit) {
        place.id = edit.addPlace(place);
        place.name = freeName(state.scene(), what).toStdString();
        edit.changePlace(place);
    });
    if (place.id != 0) {
        state.paths().select({place.id});
    }
    return place.id;
}

} // namespace crowd::widgets
