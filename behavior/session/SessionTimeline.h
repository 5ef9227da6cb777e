// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <set>

#include "model/scene/Timeline.h"

namespace crowd::behavior {

class Session;
struct SessionParts;

/// Which marks of a timeline a session has come to. Each is given once; those from before the
/// session began, or that an edit puts into its past, are not. Seconds of the clock.
class DueMarks
{
public:
    void read(const model::Timeline& timeline);
    /// It has happened already.
    void forget(model::MarkId mark) { m_forgotten.insert(mark); }
    /// In the order in which they happen, until now; the first call begins at the same moment.
    [[nodiscard]] model::Timeline take(double now);

private:
    model::Timeline m_ahead; ///< in the order in which they happen
    std::set<model::MarkId> m_forgotten;
    std::optional<double> m_until; ///< nothing: nobody has asked yet
};

/// What happens at a mark happens in the session now. What cannot is among its problems.
void performMark(Session& session, SessionParts& parts, const model::Mark& mark);

} // namespace crowd::behavior
