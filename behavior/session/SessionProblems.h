// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "behavior/base/Problem.h"

namespace crowd::behavior {

/// What the artist is told about a session, each thing once, in the order in which it was found.
class SessionProblems
{
public:
    [[nodiscard]] const std::vector<Problem>& all() const { return m_all; }
    void add(Problem problem);
    /// In place of everything said before.
    void replace(std::vector<Problem> problems) { m_all = std::move(problems); }
    /// Of where people can walk: in place of what was said of it before.
    void replaceOfWays(std::vector<Problem> problems);

private:
    std::vector<Problem> m_all;
    std::vector<Problem> m_ofWays; ///< those of them that another surface may change
};

} // namespace crowd::behavior
