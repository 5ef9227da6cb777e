// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <set>

#include <QtCore/QString>

#include "model/scene/Timeline.h"
#include "widgets/state/EditorState.h"

/// What panel and menu do with the timeline of a scene: one undo step each.
namespace crowd::widgets {

using MarkIds = std::set<model::MarkId>;

/// What a mark without a name is called after: its cue, its state or its event.
[[nodiscard]] QString markTitle(const model::Scene& scene, const model::Mark& mark);

/// A mark of that kind at a time, for the first cue or state that there is, or the view as it is,
/// which becomes a camera of the scene where it is none. Its id; 0: there is no room, or nothing
/// can be edited now, and the status line says why.
model::MarkId addMark(EditorState& state, model::MarkKind kind, double seconds);
/// A marker at the moment that is shown.
void addMarkerNow(EditorState& state);
/// From the moment that is shown on the camera looks as the view does.
void addCameraNow(EditorState& state);
void removeMarks(EditorState& state, const MarkIds& marks);
/// Later by so many seconds, none before 0.
void shiftMarks(EditorState& state, const MarkIds& marks, double seconds);
/// Copies of them, so many seconds later. Their ids.
MarkIds copyMarks(EditorState& state, const MarkIds& marks, double seconds);
/// The timeline with one of them changed.
[[nodiscard]] model::Timeline withMark(const model::Timeline& timeline, model::MarkId id,
                                       const std::function<void(model::Mark&)>& apply);

/// Which part of time is played, and whether over and over; what is not set plays all.
void setPlayRange(EditorState& state, model::PlayRange range);
/// From there on, until where it ended before, or as far as there is something.
void beginPlayRange(EditorState& state, double seconds);
void endPlayRange(EditorState& state, double seconds);
/// Over and over: the range, or where there is none as far as there is something.
void setPlayLoop(EditorState& state, bool isLoop);
/// Where the range begins or ends, or what has been played.
void showRangeEdge(EditorState& state, bool isEnd);

/// The moment of the next or former mark is shown, as far as it has been played; says so where it
/// has not.
void showNextMark(EditorState& state, bool isForward);
/// A moment is shown that has been played; the nearest one to it.
void showMoment(EditorState& state, double seconds);

} // namespace crowd::widgets
