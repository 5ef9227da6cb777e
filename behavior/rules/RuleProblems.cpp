// SPDX-License-Identifier: MIT
#include "behavior/rules/RuleProblems.h"

#include <algorithm>
#include <utility>

namespace crowd::behavior {

namespace {

constexpr std::size_t kMaxProblems = 50;

} // namespace

void RuleProblems::add(Problem problem)
{
    if (m_problems.size() < kMaxProblems &&
        std::ranges::find(m_problems, problem) == m_problems.end()) {
        m_problems.push_back(std::move(problem));
    }
}

} // namespace crowd::behavior
