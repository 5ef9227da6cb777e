// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <optional>

#include <QtWidgets/QMenu>

#include "widgets/state/EditorState.h"

namespace crowd::widgets {

/// What can be done to one path or place: each entry is one undo step, or a choice of what is
/// worked on. For one showing; the state outlives it. Main thread.
class EnvironmentMenu : public QMenu
{
    Q_OBJECT

public:
    /// Where a place stands in a path.
    struct Stop
    {
        model::PathId path = 0;
        std::size_t index = 0;
    };

    /// Closes when paths or places change meanwhile: its entries speak of those that were there.
    EnvironmentMenu(EditorState& state, QWidget* parent);

    void fillForPath(model::PathId id);
    /// `stop`: as which it was chosen; nothing where no path leads over it.
    void fillForPlace(model::PlaceId id, const std::optional<Stop>& stop);

private:
    using Change = std::function<void(model::SceneEdit&)>;

    void addChange(const QString& text, const QString& undoText, const Change& change);
    void addJoining(model::PathId id);
    void addPeople(model::PathId id);
    void insertAfter(const Stop& stop);
    void takeOut(const Stop& stop);
    void assignSelected(model::PathId id);
    void selectPeopleOf(model::PathId id);

    EditorState& m_state;
};

} // namespace crowd::widgets
