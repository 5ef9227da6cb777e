// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "model/scene/HandEdit.h"

namespace crowd::behavior {

/// How a person's own time goes while he is moved by hand edits.
struct OwnMoment
{
    double seconds = 0.0; ///< of the take: as he is there he is shown
    double pace = 1.0;    ///< seconds of the take in one that is shown; 0: he is held
    /// Held: shown seconds since then; below 0: he is held from the take's beginning.
    double heldFor = 0.0;
    /// Not held: shown seconds since he was let go; infinite: he was not held.
    double letGoFor = std::numeric_limits<double>::infinity();
};

/// What the edits of one person make of his time. All are by the clock, so that none moves another
/// one: he is late by all that make him late, and his pace is the product of all that change it
/// then. It changes over half a second, so that nobody stops with a jerk.
class EditedTime
{
public:
    /// `edits`: of Shift and Pace. `first`, `last`: seconds of the take.
    EditedTime(std::span<const model::HandEdit> edits, double first, double last);
    [[nodiscard]] OwnMoment at(double shown) const;

private:
    /// Another pace for a while: it ramps in, stays, and ramps out if it has an end.
    struct Stretch
    {
        double begin;
        double end; ///< infinite: it has none
        double pace;
        double ramp;

        [[nodiscard]] double paceAt(double shown) const;
        [[nodiscard]] bool holdsAt(double shown) const;
    };

    [[nodiscard]] double paceAt(double shown) const;
    [[nodiscard]] double ownBetween(double from, double to) const;
    void findHeld(double shown, OwnMoment& moment) const;

    double m_first;
    double m_last;
    double m_later = 0.0;
    std::vector<Stretch> m_stretches;
    std::vector<double> m_bends; ///< ascending times at which the pace begins or ends to change
    std::vector<double> m_owns;  ///< own seconds at each, before m_later
};

} // namespace crowd::behavior
