// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "behavior/rules/OwnNumber.h"
#include "model/population/Columns.h"
#include "model/rules/Rule.h"

namespace crowd::behavior {

/// What the artist's numbers are for each agent while rules change them. Each individual begins
/// with a value of its own: one that was given to it, or one within the number's limits that its id
/// and the seed decide.
class ArtistNumbers
{
public:
    /// Whoever begins with the same as before keeps what he has; with `areKept` everybody does.
    /// `ids` are those of the agents.
    void setNumbers(const std::vector<model::NumberName>& numbers, std::uint32_t seed, bool areKept,
                    std::span<const model::IndividualId> ids);
    /// See AgentStates::setPeople.
    void setPeople(std::span<const model::IndividualId> ids, std::span<const std::uint32_t> keep);

    /// 0 where there is none of that id.
    [[nodiscard]] float value(std::uint32_t agent, model::NumberId id) const;
    /// Becomes the value, or that much more. False: there is no such number.
    [[nodiscard]] bool change(std::uint32_t agent, model::NumberId id, float value, bool isAdded);
    /// Those that are not what they were at the beginning, ascending by number and individual; null
    /// before any was changed.
    [[nodiscard]] std::shared_ptr<const std::vector<OwnNumber>>
    changed(std::span<const model::IndividualId> ids);

private:
    [[nodiscard]] float first(const model::NumberName& number, model::IndividualId id) const;
    [[nodiscard]] std::vector<float> firstOnes(model::IndividualId id) const;

    std::vector<model::NumberName> m_numbers;
    std::vector<std::vector<float>> m_values; ///< by agent, as m_numbers
    std::uint32_t m_seed = 1;
    std::shared_ptr<const std::vector<OwnNumber>> m_changed;
    bool m_isStale = false; ///< m_changed
};

} // namespace crowd::behavior
