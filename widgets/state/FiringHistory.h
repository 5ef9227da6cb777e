// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "behavior/rules/FiringLog.h"

namespace crowd::widgets {

/// Which rules fired for whom since a run began, as far back as there is room; seconds of the
/// clock, ascending. Each has a number that stays its own when the earliest are forgotten, so that
/// whoever follows it asks for what is new. Main thread.
class FiringHistory
{
public:
    void add(const std::vector<behavior::RuleFired>& fired, double startSeconds);
    void clear();
    /// Of a run that goes on from then. All that is left is as if it were new.
    void forgetAfter(double seconds);

    /// The number of the earliest that is kept, and the one after the last.
    [[nodiscard]] std::uint64_t begin() const { return m_begin; }
    [[nodiscard]] std::uint64_t end() const { return m_begin + m_fired.size(); }
    /// From that number on; valid until the next change.
    [[nodiscard]] std::span<const behavior::RuleFired> since(std::uint64_t number) const;

private:
    std::vector<behavior::RuleFired> m_fired;
    std::uint64_t m_begin = 0;
};

} // namespace crowd::widgets
