// SPDX-License-Identifier: MIT
#include "behavior/session/MotionCache.h"

#include <algorithm>

#include "model/base/Checksum.h"

namespace crowd::behavior {

namespace {

constexpr std::size_t kFrameBytes = 512; ///< of what a step is besides its columns, about

/// All of it but the columns.
SessionPosePtr restOf(const SessionPose& pose)
{
    auto rest = std::make_shared<SessionPose>();
    rest->step = pose.step;
    rest->seconds = pose.seconds;
    rest->hasSeats = pose.hasSeats;
    rest->gone = pose.gone;
    rest->lit = pose.lit;
    rest->overrides = pose.overrides;
    rest->numbers = pose.numbers;
    rest->recalled = pose.recalled;
    rest->people = pose.people;
    rest->sceneVersion = pose.sceneVersion;
    rest->stateFades = pose.stateFades;
    rest->lightCues = pose.lightCues;
    return rest;
}

FrameBlocks::Bytes sharedBytes(std::vector<std::byte> bytes)
{
    const auto shared = std::make_shared<const std::vector<std::byte>>(std::move(bytes));
    return {shared, shared->data()};
}

} // namespace

MotionCache::MotionCache(const MotionBudget& budget)
    : m_budget(budget), m_file(budget.folder, budget.reserveBytes)
{
}

void MotionCache::add(const SessionPosePtr& pose)
{
    bool isFirst = false;
    {
        const std::scoped_lock lock(m_mutex);
        isFirst = m_pieces.empty() || m_pieces.back().frames.size() >= kPieceSteps;
    }
    const PoseWriter::Packed packed = m_writer.packed(*pose, isFirst ? nullptr : m_last.get());
    m_last = pose;
    Frame frame;
    frame.rest = restOf(*pose);
    frame.size = packed.bytes.size();
    frame.isDifference = packed.isDifference;
    frame.bytes = m_blocks.keep(packed.bytes);
    const std::scoped_lock lock(m_mutex);
    if (isFirst) {
        m_pieces.emplace_back();
    }
    m_memory += frame.size + kFrameBytes;
    m_pieces.back().frames.push_back(std::move(frame));
    fit();
}

bool MotionCache::addPiece(const MotionCache& other, std::size_t piece)
{
    Piece copy;
    {
        const std::scoped_lock lock(other.m_mutex);
        if (piece >= other.m_pieces.size()) {
            return false;
        }
        copy.frames = other.m_pieces[piece].frames;
        if (const auto& onDisk = other.m_pieces[piece].onDisk) {
            auto bytes = other.readPiece(*onDisk);
            if (!bytes) {
                return false;
            }
            const Bytes shared = sharedBytes(std::move(bytes).value());
            for (Frame& frame : copy.frames) {
                frame.bytes = Bytes(shared, shared.get() + frame.begin);
            }
        }
    }
    const std::scoped_lock lock(m_mutex);
    for (const Frame& frame : copy.frames) {
        m_memory += frame.size + kFrameBytes;
    }
    m_pieces.push_back(std::move(copy));
    fit();
    return true;
}

std::vector<std::pair<double, double>> MotionCache::pieces() const
{
    const std::scoped_lock lock(m_mutex);
    std::vector<std::pair<double, double>> times;
    times.reserve(m_pieces.size());
    for (const Piece& piece : m_pieces) {
        times.emplace_back(piece.frames.front().rest->seconds, piece.frames.back().rest->seconds);
    }
    return times;
}

/// Into the budget; under the mutex.
void MotionCache::fit()
{
    for (std::size_t i = 0; i + 1 < m_pieces.size() && m_memory > m_budget.memoryBytes; ++i) {
        if (!m_pieces[i].onDisk && m_budget.diskBytes > 0) {
            spill(m_pieces[i]);
        }
    }
    // What the steps are besides their columns stays in memory: a very long run ends there.
    while (m_pieces.size() > 1 &&
           (m_disk > m_budget.diskBytes || m_memory > m_budget.memoryBytes)) {
        dropFirst();
    }
}

/// Where it cannot be written it stays where it is.
void MotionCache::spill(Piece& piece)
{
    std::vector<std::byte> bytes;
    for (Frame& frame : piece.frames) {
        frame.begin = bytes.size();
        bytes.insert(bytes.end(), frame.bytes.get(), frame.bytes.get() + frame.size);
    }
    const auto written = m_file.write(bytes);
    if (!written) {
        return;
    }
    piece.onDisk = written.value();
    for (Frame& frame : piece.frames) {
        frame.bytes.reset();
    }
    m_memory -= bytes.size();
    m_disk += bytes.size();
}

void MotionCache::dropFirst()
{
    const Piece& piece = m_pieces.front();
    std::uint64_t bytes = 0;
    for (const Frame& frame : piece.frames) {
        bytes += frame.size;
    }
    m_memory -= piece.frames.size() * kFrameBytes;
    if (piece.onDisk) {
        m_file.release(*piece.onDisk);
        m_disk -= bytes;
    } else {
        m_memory -= bytes;
    }
    m_pieces.pop_front();
    ++m_firstPiece;
}

MotionCache::Extent MotionCache::extent() const
{
    const std::scoped_lock lock(m_mutex);
    if (m_pieces.empty()) {
        return {};
    }
    return {m_pieces.front().frames.front().rest->seconds,
            m_pieces.back().frames.back().rest->seconds,
            (m_pieces.size() - 1) * kPieceSteps + m_pieces.back().frames.size()};
}

std::pair<std::uint64_t, std::uint64_t> MotionCache::bytes() const
{
    const std::scoped_lock lock(m_mutex);
    return {m_memory, m_disk};
}

/// Of one piece: those after `from` where that is before the step in it, else from its beginning.
/// None: damaged, or dropped meanwhile.
std::vector<MotionCache::Frame> MotionCache::framesTo(std::uint64_t number, std::uint64_t from,
                                                      Loaded& loaded) const
{
    const std::scoped_lock lock(m_mutex);
    if (number / kPieceSteps < m_firstPiece) {
        return {};
    }
    const Piece& piece = m_pieces[static_cast<std::size_t>(number / kPieceSteps - m_firstPiece)];
    const bool goesOn = from < number && from / kPieceSteps == number / kPieceSteps;
    const std::size_t begin = goesOn ? static_cast<std::size_t>(from % kPieceSteps) + 1 : 0;
    const auto end = static_cast<std::size_t>(number % kPieceSteps) + 1;
    std::vector<Frame> frames(piece.frames.begin() + static_cast<std::ptrdiff_t>(begin),
                              piece.frames.begin() + static_cast<std::ptrdiff_t>(end));
    if (!piece.onDisk) {
        return frames;
    }
    if (!loaded.bytes || loaded.piece != number / kPieceSteps) {
        auto bytes = readPiece(*piece.onDisk);
        if (!bytes) {
            return {};
        }
        loaded.bytes = sharedBytes(std::move(bytes).value());
        loaded.piece = number / kPieceSteps;
    }
    for (Frame& frame : frames) {
        frame.bytes = Bytes(loaded.bytes, loaded.bytes.get() + frame.begin);
    }
    return frames;
}

model::Result<std::vector<std::byte>>
MotionCache::readPiece(const model::SpillFile::Extent& extent) const
{
    if (!m_take) {
        return m_file.read(extent);
    }
    auto bytes = m_take->read(extent.offset, extent.size);
    if (bytes && model::checksumOf(bytes.value()) != extent.checksum) {
        return model::Error{QT_TRANSLATE_NOOP("Messages", "%1: is damaged."),
                            m_take->path().toStdString()};
    }
    return bytes;
}

/// A step that cannot be read, with all before it. Of a take that goes on existing nothing is.
void MotionCache::giveUp(std::uint64_t number)
{
    if (m_take) {
        return;
    }
    const std::scoped_lock lock(m_mutex);
    while (!m_pieces.empty() && m_firstPiece <= number / kPieceSteps && m_pieces.size() > 1) {
        dropFirst();
    }
}

std::optional<MotionCache::Found> MotionCache::find(double seconds) const
{
    const std::scoped_lock lock(m_mutex);
    if (m_pieces.empty()) {
        return std::nullopt;
    }
    const auto isEarlier = [](double time, double each) { return time < each; };
    const auto piece =
        std::ranges::upper_bound(m_pieces, seconds, isEarlier, [](const Piece& each) {
            return each.frames.front().rest->seconds;
        });
    if (piece == m_pieces.begin()) {
        return Found{m_firstPiece * kPieceSteps, m_pieces.size() == 1 && piece->frames.size() == 1};
    }
    const std::vector<Frame>& frames = std::prev(piece)->frames;
    const auto frame = std::ranges::upper_bound(
        frames, seconds, isEarlier, [](const Frame& each) { return each.rest->seconds; });
    const auto pieces = static_cast<std::uint64_t>(piece - m_pieces.begin()) - 1;
    const auto steps = static_cast<std::uint64_t>(frame - frames.begin()) - 1;
    return Found{(m_firstPiece + pieces) * kPieceSteps + steps,
                 piece == m_pieces.end() && frame == frames.end()};
}

} // namespace crowd::behavior
