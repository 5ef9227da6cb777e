// SPDX-License-Identifier: MIT
#include "behavior/takes/TakeFile.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include <QtCore/QDir>

#include "behavior/takes/TakeHead.h"
#include "model/base/Checksum.h"
#include "model/project/WholeFile.h"

namespace crowd::behavior {

namespace {

using model::Error;
using model::Result;

/// At the end of the file, so that one that is cut off is known by what it lacks.
struct Trailer
{
    std::uint64_t headOffset = 0;
    std::uint64_t headSize = 0;
    std::uint64_t headChecksum = 0;
    std::uint32_t version = 1;
    std::uint32_t byteOrder = 0x01020304;
    std::array<char, 16> mark{'C', 'r', 'o', 'w', 'd', 'b', 'r', 'u',
                              's', 'h', ' ', 't', 'a', 'k', 'e', '\n'};
};
static_assert(sizeof(Trailer) == 48);

constexpr std::uint64_t kMostHeadBytes = 1ULL << 30U;

std::span<const std::byte> bytesOf(const QByteArray& bytes)
{
    return {reinterpret_cast<const std::byte*>(bytes.constData()),
            static_cast<std::size_t>(bytes.size())};
}

std::string_view textOf(std::span<const std::byte> bytes)
{
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::string_view textOf(const Trailer& trailer)
{
    return {reinterpret_cast<const char*>(&trailer), sizeof(Trailer)};
}

Error notWritten(const QString& path, const model::Message& why)
{
    return Error{QT_TRANSLATE_NOOP("Messages", "%1: could not be written (%2). The take was not "
                                               "kept; free some room or save the project "
                                               "elsewhere."),
                 path.toStdString(), why};
}

Error damaged(const model::MotionFile& file)
{
    return Error{QT_TRANSLATE_NOOP("Messages", "%1: is damaged or no take. Keep the take once "
                                               "more, or fetch the file from a copy."),
                 file.path().toStdString()};
}

} // namespace

/// Writes what there was as it began.
class TakeWriting
{
public:
    explicit TakeWriting(const MotionCache& run) : m_run(run)
    {
        const std::scoped_lock lock(run.m_mutex);
        m_pieces.assign(run.m_pieces.begin(), run.m_pieces.end());
    }
    [[nodiscard]] Result<model::Take> write(const QString& folder, const TakeProgress& progress);

private:
    using Frame = MotionCache::Frame;
    using Piece = MotionCache::Piece;

    [[nodiscard]] Result<std::vector<std::byte>> bytesOfPiece(std::size_t index) const;
    [[nodiscard]] Result<TakeHead> head(const TakeProgress& progress) const;
    [[nodiscard]] std::optional<Error> writeAll(const QString& path, const TakeHead& head,
                                                const QByteArray& headBytes,
                                                const TakeProgress& progress) const;
    [[nodiscard]] int people() const;

    const MotionCache& m_run;
    std::vector<Piece> m_pieces;
};

/// From memory, or from disk under the run's mutex: what is gone meanwhile is not read.
Result<std::vector<std::byte>> TakeWriting::bytesOfPiece(std::size_t index) const
{
    const Piece& piece = m_pieces[index];
    if (piece.onDisk) {
        const std::scoped_lock lock(m_run.m_mutex);
        return m_run.readPiece(*piece.onDisk);
    }
    std::vector<std::byte> bytes;
    for (const Frame& frame : piece.frames) {
        bytes.insert(bytes.end(), frame.bytes.get(), frame.bytes.get() + frame.size);
    }
    return bytes;
}

Result<TakeHead> TakeWriting::head(const TakeProgress& progress) const
{
    TakeHead head;
    std::uint64_t offset = 0;
    for (std::size_t i = 0; i < m_pieces.size(); ++i) {
        const auto bytes = bytesOfPiece(i);
        if (!bytes) {
            return bytes.error();
        }
        TakeHead::Piece piece{offset, bytes.value().size(), model::checksumOf(bytes.value()), {}};
        std::uint64_t begin = 0;
        for (const Frame& frame : m_pieces[i].frames) {
            piece.frames.push_back({frame.rest, begin, frame.size, frame.isDifference});
            begin += frame.size;
        }
        offset += piece.size;
        head.pieces.push_back(std::move(piece));
        if (progress &&
            !progress(0.5 * static_cast<double>(i) / static_cast<double>(m_pieces.size()))) {
            return Error{QT_TRANSLATE_NOOP("Messages", "Cancelled.")};
        }
    }
    return head;
}

std::optional<Error> TakeWriting::writeAll(const QString& path, const TakeHead& head,
                                           const QByteArray& headBytes,
                                           const TakeProgress& progress) const
{
    auto file = model::WholeFile::begin(path);
    if (!file) {
        return notWritten(path, file.error().said);
    }
    for (std::size_t i = 0; i < m_pieces.size(); ++i) {
        const auto bytes = bytesOfPiece(i);
        if (!bytes) {
            return notWritten(path, bytes.error().said);
        }
        if (const auto written = file.value().write(textOf(bytes.value())); !written) {
            return notWritten(path, written.error().said);
        }
        if (progress &&
            !progress(0.5 + 0.5 * static_cast<double>(i) / static_cast<double>(m_pieces.size()))) {
            return Error{QT_TRANSLATE_NOOP("Messages", "Cancelled.")};
        }
    }
    const TakeHead::Piece& last = head.pieces.back();
    Trailer trailer;
    trailer.headOffset = last.offset + last.size;
    trailer.headSize = static_cast<std::uint64_t>(headBytes.size());
    trailer.headChecksum = model::checksumOf(bytesOf(headBytes));
    for (const std::string_view part : {textOf(bytesOf(headBytes)), textOf(trailer)}) {
        if (const auto written = file.value().write(part); !written) {
            return notWritten(path, written.error().said);
        }
    }
    if (const auto done = file.value().commit(); !done) {
        return notWritten(path, done.error().said);
    }
    return std::nullopt;
}

/// Those of the last step: who came and left is among them.
int TakeWriting::people() const
{
    PoseColumns columns;
    SessionPose pose;
    const auto bytes = bytesOfPiece(m_pieces.size() - 1);
    std::size_t begin = 0;
    for (const Frame& frame : m_pieces.back().frames) {
        if (!bytes || !columns.read(std::span(bytes.value()).subspan(begin, frame.size),
                                    frame.isDifference)) {
            return 0;
        }
        begin += frame.size;
    }
    columns.fill(pose);
    return static_cast<int>(pose.ids.size());
}

Result<model::Take> TakeWriting::write(const QString& folder, const TakeProgress& progress)
{
    if (m_pieces.empty()) {
        return Error{QT_TRANSLATE_NOOP("Messages",
                                       "Nothing has been played yet: there is no take to keep. "
                                       "Play first.")};
    }
    auto head = this->head(progress);
    if (!head) {
        return head.error();
    }
    const QByteArray bytes = takeHeadBytes(head.value());
    model::Take take;
    take.file = QString::number(model::checksumOf(bytesOf(bytes)), 16)
                    .rightJustified(16, QLatin1Char('0'))
                    .toStdString() +
                ".take";
    take.begin = m_pieces.front().frames.front().rest->seconds;
    take.end = m_pieces.back().frames.back().rest->seconds;
    take.people = people();
    const QString path = QDir(folder).filePath(QString::fromStdString(take.file));
    if (!QDir().mkpath(folder)) {
        return notWritten(
            path, model::Message(QT_TRANSLATE_NOOP("Messages", "the folder could not be made")));
    }
    if (auto error = writeAll(path, head.value(), bytes, progress)) {
        return *error;
    }
    auto file = model::MotionFile::open(path);
    if (!file) {
        return file.error();
    }
    take.motion = file.value();
    return take;
}

/// Makes a cache of a file.
class TakeReading
{
public:
    explicit TakeReading(const model::MotionFilePtr& file) : m_file(file) {}
    [[nodiscard]] Result<std::shared_ptr<MotionCache>> read() const;

private:
    [[nodiscard]] Result<Trailer> trailer() const;
    [[nodiscard]] bool put(TakeHead head, std::uint64_t headOffset, MotionCache& cache) const;

    const model::MotionFilePtr& m_file;
};

Result<Trailer> TakeReading::trailer() const
{
    Trailer trailer;
    if (m_file->size() < sizeof(Trailer)) {
        return damaged(*m_file);
    }
    const auto bytes = m_file->read(m_file->size() - sizeof(Trailer), sizeof(Trailer));
    if (!bytes) {
        return bytes.error();
    }
    std::memcpy(&trailer, bytes.value().data(), sizeof(Trailer));
    const Trailer ours;
    if (trailer.mark != ours.mark) {
        return damaged(*m_file);
    }
    if (trailer.version != ours.version || trailer.byteOrder != ours.byteOrder) {
        return Error{QT_TRANSLATE_NOOP("Messages", "%1: is of a newer version of Crowdbrush, or of "
                                                   "another kind of machine. Open it there."),
                     m_file->path().toStdString()};
    }
    if (trailer.headSize > kMostHeadBytes) {
        return damaged(*m_file);
    }
    return trailer;
}

bool TakeReading::put(TakeHead head, std::uint64_t headOffset, MotionCache& cache) const
{
    for (std::size_t i = 0; i < head.pieces.size(); ++i) {
        TakeHead::Piece& from = head.pieces[i];
        const bool isLast = i + 1 == head.pieces.size();
        const bool fits = from.offset <= headOffset && from.size <= headOffset - from.offset;
        if (!fits || from.frames.size() > MotionCache::kPieceSteps ||
            (!isLast && from.frames.size() < MotionCache::kPieceSteps)) {
            return false;
        }
        MotionCache::Piece& piece = cache.m_pieces.emplace_back();
        piece.onDisk = model::SpillFile::Extent{from.offset, from.size, from.checksum};
        for (TakeHead::Frame& frame : from.frames) {
            piece.frames.push_back({std::move(frame.rest), nullptr,
                                    static_cast<std::size_t>(frame.begin),
                                    static_cast<std::size_t>(frame.size), frame.isDifference});
        }
    }
    return true;
}

Result<std::shared_ptr<MotionCache>> TakeReading::read() const
{
    const auto trailer = this->trailer();
    if (!trailer) {
        return trailer.error();
    }
    const auto& [offset, size, checksum, version, byteOrder, mark] = trailer.value();
    const auto bytes = m_file->read(offset, size);
    if (!bytes) {
        return bytes.error();
    }
    auto head = model::checksumOf(bytes.value()) == checksum
                    ? takeHeadOf(QByteArray(reinterpret_cast<const char*>(bytes.value().data()),
                                            static_cast<qsizetype>(bytes.value().size())))
                    : std::nullopt;
    auto cache = std::make_shared<MotionCache>();
    if (!head || !put(std::move(*head), offset, *cache)) {
        return damaged(*m_file);
    }
    cache->m_take = m_file;
    return cache;
}

Result<model::Take> writeTake(const MotionCache& run, const QString& folder,
                              const TakeProgress& progress)
{
    return TakeWriting(run).write(folder, progress);
}

Result<std::shared_ptr<MotionCache>> openTake(const model::MotionFilePtr& file)
{
    return TakeReading(file).read();
}

model::Message damagedTake()
{
    return model::Message(QT_TRANSLATE_NOOP("Messages", "The take cannot be read: its file is "
                                                        "damaged. Fetch it from a copy."));
}

} // namespace crowd::behavior
