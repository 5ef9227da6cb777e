// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "behavior/base/Agents.h"

namespace crowd::behavior {

/// People by where they are on the ground, so that whoever is near somebody is found without asking
/// everybody. Filled when somebody first asks in a step. Metres.
class NearCells
{
public:
    void clear();
    [[nodiscard]] bool isEmpty() const { return m_people.empty(); }
    void add(std::uint32_t agent, const glm::vec3& position);
    /// All who can be within so many metres, ascending, each once, and some who are not. False: it
    /// is shorter to ask everybody.
    [[nodiscard]] bool gather(const glm::vec3& position, float metres,
                              std::vector<std::uint32_t>& agents) const;
    /// Whoever is nearest and no further than so many metres; of several the first. kNoAgent: there
    /// is none but perhaps `except`.
    [[nodiscard]] std::uint32_t nearest(const glm::vec3& position, float metres,
                                        std::uint32_t except) const;

private:
    struct Person
    {
        std::uint32_t agent = 0;
        glm::vec2 at{0.0F};
    };
    struct Nearest
    {
        float metres = 0.0F;
        std::uint32_t agent = kNoAgent;
    };
    using Cells = std::unordered_map<std::uint64_t, std::vector<Person>>;

    static void look(const std::vector<Person>& people, const glm::vec2& from, std::uint32_t except,
                     Nearest& nearest);

    Cells m_cells;
    std::vector<Person> m_people;
};

} // namespace crowd::behavior
