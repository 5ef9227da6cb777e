// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <QtCore/QObject>
#include <QtCore/QString>

#include "widgets/state/EditorState.h"

namespace crowd::widgets {

/// Which rules fired for the selected, of all that has been played. Main thread; the state outlives
/// it.
class SelectedFirings : public QObject
{
    Q_OBJECT

public:
    explicit SelectedFirings(EditorState& state);

    /// By time, seconds of the clock.
    [[nodiscard]] std::span<const behavior::RuleFired> shown() const { return m_shown; }
    /// What fired from one time to another, to be read; empty: nothing.
    [[nodiscard]] QString text(double from, double to) const;

Q_SIGNALS:
    void changed();

private:
    void readAnew();
    void readOn();

    EditorState& m_state;
    std::vector<behavior::RuleFired> m_shown;
    std::uint64_t m_begin = 0; ///< of the history, when it was read
    std::uint64_t m_seen = 0;  ///< the number of what fires next
};

} // namespace crowd::widgets
