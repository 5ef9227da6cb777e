// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/state/EditorState.h"

namespace crowd::widgets {

/// A drag through what has been played: time stands while it is held, and plays on after that if
/// it played. Main thread; the state outlives it.
class Scrub
{
public:
    explicit Scrub(EditorState& state) : m_state(state) {}

    void begin();
    void end(); ///< nothing where none is under way
    [[nodiscard]] bool isHeld() const { return m_isHeld; }

    // Of what can be shown, by the clock.
    [[nodiscard]] double first() const;
    [[nodiscard]] double last() const;
    /// That moment, or the nearest to it that can be shown; the timeline's camera also of one that
    /// has not been played yet.
    void show(double seconds);

private:
    EditorState& m_state;
    bool m_isHeld = false;
    bool m_playedBefore = false;
};

} // namespace crowd::widgets
