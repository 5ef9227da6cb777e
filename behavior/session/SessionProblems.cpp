// SPDX-License-Identifier: MIT
#include "behavior/session/SessionProblems.h"

#include <algorithm>
#include <utility>

namespace crowd::behavior {

void SessionProblems::add(Problem problem)
{
    if (std::ranges::find(m_all, problem) == m_all.end()) {
        m_all.push_back(std::move(problem));
    }
}

void SessionProblems::replaceOfWays(std::vector<Problem> problems)
{
    std::erase_if(m_all, [this](const Problem& problem) {
        return std::ranges::find(m_ofWays, problem) != m_ofWays.end();
    });
    m_ofWays = std::move(problems);
    for (const Problem& problem : m_ofWays) {
        add(problem);
    }
}

} // namespace crowd::behavior
