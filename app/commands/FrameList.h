// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace crowd::app {

/// Which frames are drawn, in ascending order, each once. At least one.
class FrameList
{
public:
    FrameList() = default; ///< frame 0

    /// "0-99", in steps "0-90x10", a single one "7", or several of these with commas between them.
    /// Nothing: it is something else, or has a negative frame.
    [[nodiscard]] static std::optional<FrameList> parsed(std::string_view text);

    [[nodiscard]] int first() const;
    [[nodiscard]] int last() const;
    /// The one after; nothing: there is none.
    [[nodiscard]] std::optional<int> after(int frame) const;

private:
    struct Range
    {
        int first = 0;
        int last = 0; ///< one of them
        int step = 1;
    };

    [[nodiscard]] static std::optional<Range> parsedRange(std::string_view text);

    std::vector<Range> m_ranges{Range{}};
};

} // namespace crowd::app
