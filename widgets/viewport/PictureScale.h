// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

namespace crowd::widgets {

/// How large pictures are drawn while something moves, as a share of the window's width and height,
/// so that a slow machine follows the hand: from picture to picture a step smaller while they take
/// longer than a thirtieth of a second, and a larger one again where that would do.
class PictureScale
{
public:
    /// A picture at share() took so long.
    void note(double milliseconds);
    [[nodiscard]] double share() const { return kShares[m_step]; }
    /// Whatever came before says nothing of what comes.
    void forget();

private:
    /// Each has seven tenths of the pixels of the one before.
    static constexpr std::array kShares{1.0, 0.84, 0.71, 0.59, 0.5};

    std::size_t m_step = 0;
    std::array<double, 3> m_times{}; ///< of pictures at this share
    std::size_t m_count = 0;
};

} // namespace crowd::widgets
