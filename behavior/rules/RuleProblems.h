// SPDX-License-Identifier: MIT
#pragma once

#include <utility>
#include <vector>

#include "behavior/base/Problem.h"

namespace crowd::behavior {

/// What the artist should know of rules that run: each problem once, and no more than can be read.
class RuleProblems
{
public:
    void clear() { m_problems.clear(); }
    void add(Problem problem);
    void beginStep() { m_isOverloadNoted = false; }
    /// There is more to do than a step has room for. True for the first time in a step, when it is
    /// to be added: there may be very many whom it holds up.
    [[nodiscard]] bool noteOverload() { return !std::exchange(m_isOverloadNoted, true); }
    [[nodiscard]] const std::vector<Problem>& all() const { return m_problems; }

private:
    std::vector<Problem> m_problems;
    bool m_isOverloadNoted = false;
};

} // namespace crowd::behavior
