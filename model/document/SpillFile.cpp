// SPDX-License-Identifier: MIT
#include "model/document/SpillFile.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <QtCore/QDir>
#include <QtCore/QFile>
#include <QtCore/QFileInfo>

#include "model/base/Checksum.h"

namespace crowd::model {

namespace {

std::string systemReason()
{
    return std::strerror(errno);
}

QString folderForTemporaryFiles()
{
    for (const QString& folder :
         {qEnvironmentVariable("TMPDIR"), QStringLiteral("/var/tmp"), QDir::tempPath()}) {
        if (!folder.isEmpty() && QFileInfo(folder).isDir() && QFileInfo(folder).isWritable()) {
            return folder;
        }
    }
    return QDir::tempPath();
}

int openUnnamed(const QByteArray& folder)
{
    const int file = ::open(folder.constData(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
    if (file >= 0 || (errno != EOPNOTSUPP && errno != EISDIR && errno != EINVAL)) {
        return file;
    }
    // A file system without nameless files: take the name away at once.
    QByteArray name = folder + "/crowdbrush-undo-XXXXXX";
    const int named = ::mkostemp(name.data(), O_CLOEXEC);
    if (named >= 0) {
        ::unlink(name.constData());
    }
    return named;
}

} // namespace

SpillFile::SpillFile(const QString& folder, std::uint64_t reserveBytes)
    : m_folder(folder), m_reserve(reserveBytes)
{
}

SpillFile::~SpillFile()
{
    if (m_file >= 0) {
        ::close(m_file);
    }
}

Result<void> SpillFile::open()
{
    if (m_file >= 0) {
        return {};
    }
    const QString folder = m_folder.isEmpty() ? folderForTemporaryFiles() : m_folder;
    m_file = openUnnamed(QFile::encodeName(folder));
    if (m_file < 0) {
        return Error{QT_TRANSLATE_NOOP("Messages", "%1: no temporary file could be made (%2)"),
                     folder.toStdString(), systemReason()};
    }
    return {};
}

Result<void> SpillFile::checkRoom(std::uint64_t size) const
{
    struct statvfs disk
    {
    };
    if (::fstatvfs(m_file, &disk) != 0) {
        return {}; // the write itself will tell
    }
    const std::uint64_t free = std::uint64_t{disk.f_bavail} * disk.f_frsize;
    if (free < size || free - size < m_reserve) {
        return Error{
            QT_TRANSLATE_NOOP("Messages", "the disk of the temporary file is nearly full")};
    }
    return {};
}

std::uint64_t SpillFile::takePlace(std::uint64_t size)
{
    const auto fits = std::find_if(m_free.begin(), m_free.end(),
                                   [size](const auto& gap) { return gap.second >= size; });
    if (fits == m_free.end()) {
        const std::uint64_t offset = m_end;
        m_end += size;
        return offset;
    }
    const auto [offset, room] = *fits;
    m_free.erase(fits);
    if (room > size) {
        m_free.emplace(offset + size, room - size);
    }
    return offset;
}

Result<SpillFile::Extent> SpillFile::write(std::span<const std::byte> bytes)
{
    if (const Result<void> opened = open(); !opened) {
        return opened.error();
    }
    if (const Result<void> room = checkRoom(bytes.size()); !room) {
        return room.error();
    }
    const Extent extent{takePlace(bytes.size()), bytes.size(), checksumOf(bytes)};
    for (std::size_t done = 0; done < bytes.size();) {
        const ssize_t written = ::pwrite(m_file, &bytes[done], bytes.size() - done,
                                         static_cast<off_t>(extent.offset + done));
        if (written < 0 && errno == EINTR) {
            continue;
        }
        if (written <= 0) {
            const Error error{
                QT_TRANSLATE_NOOP("Messages", "the temporary file could not be written (%1)"),
                systemReason()};
            release(extent);
            return error;
        }
        done += static_cast<std::size_t>(written);
    }
    return extent;
}

Result<std::vector<std::byte>> SpillFile::read(const Extent& extent) const
{
    std::vector<std::byte> bytes(extent.size);
    for (std::size_t done = 0; done < bytes.size();) {
        const ssize_t got = ::pread(m_file, &bytes[done], bytes.size() - done,
                                    static_cast<off_t>(extent.offset + done));
        if (got < 0 && errno == EINTR) {
            continue;
        }
        if (got < 0) {
            return Error{QT_TRANSLATE_NOOP("Messages", "the temporary file could not be read (%1)"),
                         systemReason()};
        }
        if (got == 0) {
            return Error{
                QT_TRANSLATE_NOOP("Messages", "the temporary file is shorter than it was")};
        }
        done += static_cast<std::size_t>(got);
    }
    if (checksumOf(bytes) != extent.checksum) {
        return Error{QT_TRANSLATE_NOOP("Messages",
                                       "the temporary file does not hold what was written to it")};
    }
    return bytes;
}

void SpillFile::release(const Extent& extent)
{
    if (extent.size == 0) {
        return;
    }
    auto gap = m_free.emplace(extent.offset, extent.size).first;
    if (const auto next = std::next(gap);
        next != m_free.end() && gap->first + gap->second == next->first) {
        gap->second += next->second;
        m_free.erase(next);
    }
    if (gap != m_free.begin()) {
        const auto previous = std::prev(gap);
        if (previous->first + previous->second == gap->first) {
            previous->second += gap->second;
            m_free.erase(gap);
            gap = previous;
        }
    }
    if (gap->first + gap->second == m_end) {
        m_end = gap->first;
        m_free.erase(gap);
        // Giving the room back early is a courtesy; a file that stays long does no harm.
        [[maybe_unused]] const int result = ::ftruncate(m_file, static_cast<off_t>(m_end));
    }
}

} // namespace crowd::model
