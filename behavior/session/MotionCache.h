// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "behavior/session/FrameBlocks.h"
#include "behavior/session/PoseBytes.h"
#include "behavior/session/SessionPose.h"
#include "model/document/SpillFile.h"
#include "model/scene/MotionFile.h"

namespace crowd::behavior {

/// What the poses of a run may take.
struct MotionBudget
{
    std::uint64_t memoryBytes = 192ULL << 20U;
    std::uint64_t diskBytes = 2ULL << 30U;    ///< of a file that has no name
    std::uint64_t reserveBytes = 1ULL << 30U; ///< that stay free on the disk
    QString folder{};                         ///< of that file; empty: where the system has its own
};

/// The steps of a run, one after the other, to be had again exactly as they were (MotionReader):
/// compact in memory, then on disk, then no more, the earliest first. One thread adds, any may
/// read. Those of a kept take (openTake()) are in its file; nobody adds to them.
class MotionCache
{
public:
    static constexpr std::size_t kPieceSteps = 32; ///< in a row, about a second

    explicit MotionCache(const MotionBudget& budget = {});

    /// The next step; later than the one before.
    void add(const SessionPosePtr& pose);
    /// The same steps of another run in a row, as they are packed there: `piece` of it, counted
    /// from its first. The steps before fill pieces. False: they cannot be read.
    [[nodiscard]] bool addPiece(const MotionCache& other, std::size_t piece);
    /// Seconds of the first and the last step of each piece.
    [[nodiscard]] std::vector<std::pair<double, double>> pieces() const;

    struct Extent
    {
        double first = 0.0; ///< seconds of the earliest step that is there
        double last = 0.0;
        std::size_t steps = 0; ///< none: the times mean nothing
    };
    [[nodiscard]] Extent extent() const;
    /// Bytes of memory and of disk.
    [[nodiscard]] std::pair<std::uint64_t, std::uint64_t> bytes() const;

private:
    friend class MotionReader;
    friend class TakeReading;
    friend class TakeWriting;

    using Bytes = FrameBlocks::Bytes;
    /// A step: the columns as bytes, all else as it was.
    struct Frame
    {
        SessionPosePtr rest;
        Bytes bytes;           ///< null: on disk, with its piece
        std::size_t begin = 0; ///< on disk, in its piece
        std::size_t size = 0;
        bool isDifference = false;
    };
    /// Some steps in a row, which can be read without those before them.
    struct Piece
    {
        std::vector<Frame> frames;
        std::optional<model::SpillFile::Extent> onDisk;
    };
    /// A piece that a reader has from disk.
    struct Loaded
    {
        std::uint64_t piece = 0; ///< since the run began
        Bytes bytes;             ///< null: none
    };
    struct Found
    {
        std::uint64_t number = 0; ///< of a step, since the run began
        bool isLast = false;
    };

    [[nodiscard]] std::optional<Found> find(double seconds) const;
    [[nodiscard]] std::vector<Frame> framesTo(std::uint64_t number, std::uint64_t from,
                                              Loaded& loaded) const;
    [[nodiscard]] model::Result<std::vector<std::byte>>
    readPiece(const model::SpillFile::Extent& extent) const;
    void giveUp(std::uint64_t number);
    void fit();
    void spill(Piece& piece);
    void dropFirst();

    const MotionBudget m_budget;
    // The adding thread's.
    PoseWriter m_writer;
    FrameBlocks m_blocks;
    SessionPosePtr m_last;
    mutable std::mutex m_mutex;
    // Under the mutex.
    std::deque<Piece> m_pieces;
    std::uint64_t m_firstPiece = 0; ///< pieces that are gone
    std::uint64_t m_memory = 0;
    std::uint64_t m_disk = 0;
    model::SpillFile m_file;
    model::MotionFilePtr m_take; ///< since it was opened; null: of a run
};

} // namespace crowd::behavior
