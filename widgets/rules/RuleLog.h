// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <vector>

#include <QtCore/QStringList>

#include "behavior/rules/RuleEngine.h"
#include "model/scene/Scene.h"

namespace crowd::widgets {

/// What fired lately, to be read: what one rule does in a burst is one line, for however many
/// people and however often, so that rules that set each other off hide nothing. Forgets the oldest
/// bursts when there is too much. Window thread.
class RuleLog
{
public:
    void clear();
    void add(const behavior::RuleFired& fired);
    /// The oldest first, of the people that `isShown` lets through. Names rules as in the scene.
    [[nodiscard]] QStringList lines(const model::Scene& scene,
                                    const std::function<bool(model::IndividualId)>& isShown) const;

private:
    struct Tally
    {
        std::uint64_t count = 0;
        double first = 0.0; ///< seconds of the clock
        double last = 0.0;
    };
    struct Burst
    {
        model::RuleId rule = 0;
        double last = 0.0;
        std::map<model::IndividualId, Tally> people;
    };

    [[nodiscard]] Burst& burstOf(const behavior::RuleFired& fired);
    void forget();

    std::vector<Burst> m_bursts; ///< by when they began
    std::size_t m_tallies = 0;
};

} // namespace crowd::widgets
