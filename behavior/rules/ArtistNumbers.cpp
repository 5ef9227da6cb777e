// SPDX-License-Identifier: MIT
#include "behavior/rules/ArtistNumbers.h"

#include <algorithm>
#include <utility>

#include "behavior/base/Agents.h"
#include "model/base/Random.h"

namespace crowd::behavior {

void ArtistNumbers::setNumbers(const std::vector<model::NumberName>& numbers, std::uint32_t seed,
                               bool areKept, std::span<const model::IndividualId> ids)
{
    m_seed = seed;
    if (m_numbers == numbers) {
        return;
    }
    const std::vector<model::NumberName> former = std::exchange(m_numbers, numbers);
    for (std::size_t agent = 0; agent < ids.size(); ++agent) {
        std::vector<float> values;
        for (const model::NumberName& number : m_numbers) {
            const auto known = std::ranges::find(former, number.id, &model::NumberName::id);
            const float begin = first(number, ids[agent]);
            const bool keeps =
                known != former.end() && (areKept || first(*known, ids[agent]) == begin);
            values.push_back(
                keeps ? m_values[agent][static_cast<std::size_t>(known - former.begin())] : begin);
        }
        m_values[agent] = std::move(values);
    }
    m_isStale = true;
}

void ArtistNumbers::setPeople(std::span<const model::IndividualId> ids,
                              std::span<const std::uint32_t> keep)
{
    rearrange(m_values, keep);
    for (std::size_t agent = 0; agent < keep.size(); ++agent) {
        if (keep[agent] == kNoAgent) {
            m_values[agent] = firstOnes(ids[agent]);
        }
    }
}

float ArtistNumbers::first(const model::NumberName& number, model::IndividualId id) const
{
    const auto own = std::ranges::lower_bound(number.values, id, {},
                                              &std::pair<model::IndividualId, float>::first);
    if (own != number.values.end() && own->first == id) {
        return own->second;
    }
    const float share = model::unitFloat(model::hashKeys(m_seed, id, number.id, 55));
    return number.low + (number.high - number.low) * share;
}

std::vector<float> ArtistNumbers::firstOnes(model::IndividualId id) const
{
    std::vector<float> values;
    for (const model::NumberName& number : m_numbers) {
        values.push_back(first(number, id));
    }
    return values;
}

float ArtistNumbers::value(std::uint32_t agent, model::NumberId id) const
{
    const auto found = std::ranges::find(m_numbers, id, &model::NumberName::id);
    return found == m_numbers.end()
               ? 0.0F
               : m_values[agent][static_cast<std::size_t>(found - m_numbers.begin())];
}

bool ArtistNumbers::change(std::uint32_t agent, model::NumberId id, float value, bool isAdded)
{
    const auto found = std::ranges::find(m_numbers, id, &model::NumberName::id);
    if (found == m_numbers.end()) {
        return false;
    }
    float& number = m_values[agent][static_cast<std::size_t>(found - m_numbers.begin())];
    number = std::clamp(isAdded ? number + value : value, -model::kMaxNumber, model::kMaxNumber);
    m_isStale = true;
    return true;
}

std::shared_ptr<const std::vector<OwnNumber>>
ArtistNumbers::changed(std::span<const model::IndividualId> ids)
{
    if (std::exchange(m_isStale, false)) {
        auto own = std::make_shared<std::vector<OwnNumber>>();
        for (std::size_t i = 0; i < m_numbers.size(); ++i) {
            for (std::size_t agent = 0; agent < ids.size(); ++agent) {
                const float value = m_values[agent][i];
                if (value != first(m_numbers[i], ids[agent])) {
                    own->push_back({m_numbers[i].id, ids[agent], value});
                }
            }
        }
        m_changed = std::move(own);
    }
    return m_changed;
}

} // namespace crowd::behavior
