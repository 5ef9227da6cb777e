// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include <QtCore/QObject>

#include "model/brush/BrushContext.h"
#include "model/pick/ScenePicker.h"
#include "model/pick/StageRays.h"
#include "widgets/state/EditorState.h"
#include "widgets/tools/SeatMarkers.h"

namespace crowd::widgets {

/// What is where in the picture: the stage, people and seats, kept up to date with the document and
/// the view. One per viewport; the state outlives it. Main thread only.
class SceneQueries : public QObject
{
    Q_OBJECT

public:
    explicit SceneQueries(EditorState& state);

    [[nodiscard]] model::View view() const;
    [[nodiscard]] const model::StageRays& stage();
    /// People as they were shown at a moment of the transport, in the present view.
    [[nodiscard]] const model::ScenePicker& picker(double shownSeconds);
    [[nodiscard]] model::BrushContext brushContext();
    /// The same for what is only shown: it does not wait for where people can walk.
    [[nodiscard]] model::BrushContext hoverContext();

    /// What is under a pixel, nearest first: a person, the stage, the ground; else the depth of the
    /// camera's pivot. World frame, metres.
    [[nodiscard]] glm::vec3 pointUnder(glm::dvec2 pixel, double shownSeconds);

    [[nodiscard]] std::span<const model::WorldSeat> seats();
    [[nodiscard]] std::uint64_t seatsVersion() const { return m_seats.version(); }
    [[nodiscard]] std::span<const render::Marker> freeSeats();

private:
    EditorState& m_state;
    model::StageRays m_stage;
    bool m_isStageStale = true;
    model::ScenePicker m_picker;
    SeatMarkers m_seats;
};

} // namespace crowd::widgets
