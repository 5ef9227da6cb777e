// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "behavior/session/SessionPose.h"

/// Poses as few bytes, quickly: most of what a step does to somebody is little, so that in the
/// words of two poses in a row only the lower bytes differ, and only those are written
/// (PackKernel.h). Exact, with a checksum.
namespace crowd::behavior {

/// Writes the columns of poses, and what else there is one each for some people. One thread.
class PoseWriter
{
public:
    struct Packed
    {
        std::span<const std::byte> bytes; ///< until the next are packed
        bool isDifference = false;        ///< to be read only after the pose before
    };
    /// Against the pose before, where there is one of the same people.
    [[nodiscard]] Packed packed(const SessionPose& pose, const SessionPose* before);

private:
    std::vector<std::byte> m_room; ///< kept from pose to pose: making it takes as long as the rest
};

/// Reads them again, one after the other. One thread.
class PoseColumns
{
public:
    /// False: damaged, or not against what was read before; it is good for nothing then.
    [[nodiscard]] bool read(std::span<const std::byte> bytes, bool isDifference);
    /// Fills the columns of a pose; what is not a column stays as it is there.
    void fill(SessionPose& pose) const;

    struct Counts
    {
        std::uint32_t people = 0;
        std::uint32_t seats = 0; ///< none, or one each
        std::uint32_t fades = 0;
    };

private:
    Counts m_counts;
    std::vector<std::uint32_t> m_words; ///< each column from a group of four on
};

} // namespace crowd::behavior
