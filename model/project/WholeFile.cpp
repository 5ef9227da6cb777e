// SPDX-License-Identifier: MIT
#include "model/project/WholeFile.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
#include <cstdio>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <QtCore/QCryptographicHash>
#include <QtCore/QDir>
#include <QtCore/QFile>
#include <QtCore/QSysInfo>

#include "model/project/ProcessName.h"

namespace crowd::model {

namespace {

Error systemError(int code)
{
    return Error{std::system_category().message(code)};
}

QByteArray folderOf(const QByteArray& path)
{
    const qsizetype slash = path.lastIndexOf('/');
    return slash < 0 ? QByteArray("./") : path.left(slash + 1);
}

/// Where a path leads when its last part is a link, or a link to a link; that need not be there.
Result<QByteArray> followLinks(QByteArray path)
{
    constexpr int kMostLinks = 40; // as many as the system follows
    std::array<char, PATH_MAX> buffer{};
    for (int i = 0; i < kMostLinks; ++i) {
        const ssize_t length = ::readlink(path.constData(), buffer.data(), buffer.size());
        if (length < 0) {
            return path;
        }
        const QByteArray target(buffer.data(), length);
        path = target.startsWith('/') ? target : folderOf(path) + target;
    }
    return Error{QT_TRANSLATE_NOOP("Messages", "it is a link that leads back to itself")};
}

const char* kindOf(mode_t mode)
{
    if (S_ISDIR(mode)) {
        return QT_TRANSLATE_NOOP("Messages", "it is a folder, not a file");
    }
    if (S_ISFIFO(mode)) {
        return QT_TRANSLATE_NOOP("Messages", "it is a pipe, not a file");
    }
    return S_ISSOCK(mode) ? QT_TRANSLATE_NOOP("Messages", "it is a socket, not a file")
                          : QT_TRANSLATE_NOOP("Messages", "it is a device, not a file");
}

/// How the old file is kept by the new one; nothing where there is none.
struct OldFile
{
    bool isThere = false;
    struct stat facts = {};
};

Result<OldFile> oldFileAt(const QByteArray& path)
{
    OldFile old;
    if (::stat(path.constData(), &old.facts) != 0) {
        return errno == ENOENT ? Result<OldFile>(old) : systemError(errno);
    }
    if (!S_ISREG(old.facts.st_mode)) {
        return Error{kindOf(old.facts.st_mode)};
    }
    if (::access(path.constData(), W_OK) != 0) {
        return systemError(errno);
    }
    old.isThere = true;
    return old;
}

/// How names of temporary files of a file begin. Of one length, so that they are possible however
/// long its own name is.
QString temporaryStart(const QByteArray& target)
{
    const auto hash = [](const QByteArray& text, int length) {
        const QByteArray sum = QCryptographicHash::hash(text, QCryptographicHash::Sha1);
        return QString::fromLatin1(sum.toHex().left(length));
    };
    const QByteArray name = target.mid(target.lastIndexOf('/') + 1);
    // Whether a process on another machine that shares the folder is alive cannot be known here.
    const QByteArray machine = QSysInfo::machineHostName().toUtf8();
    return QStringLiteral(".crowdbrush-%1-%2.").arg(hash(name, 16), hash(machine, 8));
}

const QString kTemporaryEnd = QStringLiteral(".part");

void removeLeftovers(const QByteArray& target)
{
    const QString start = temporaryStart(target);
    QDir folder(QFile::decodeName(folderOf(target)));
    for (const QString& name :
         folder.entryList({start + QLatin1Char('*') + kTemporaryEnd}, QDir::Files | QDir::Hidden)) {
        const QString owner = name.mid(start.size()).section(QLatin1Char('.'), 0, 0);
        if (owner.contains(QLatin1Char('-')) && !isProcessAlive(owner)) {
            folder.remove(name);
        }
    }
}

QByteArray temporaryFor(const QByteArray& target)
{
    static std::atomic<unsigned> count{0}; // several threads may write the same file
    return folderOf(target) + QFile::encodeName(temporaryStart(target) + ownProcessName() +
                                                QStringLiteral(".%1").arg(count++) + kTemporaryEnd);
}

} // namespace

WholeFile::WholeFile(QByteArray target, QByteArray temporary, int file)
    : m_target(std::move(target)), m_temporary(std::move(temporary)), m_file(file)
{
}

WholeFile::WholeFile(WholeFile&& other) noexcept
    : m_target(std::move(other.m_target)), m_temporary(std::exchange(other.m_temporary, {})),
      m_file(std::exchange(other.m_file, -1))
{
}

WholeFile::~WholeFile()
{
    if (m_file >= 0) {
        ::close(m_file);
    }
    if (!m_temporary.isEmpty()) {
        ::unlink(m_temporary.constData());
    }
}

Result<WholeFile> WholeFile::begin(const QString& path)
{
    const Result<QByteArray> target = followLinks(QFile::encodeName(path));
    if (!target) {
        return target.error();
    }
    const Result<OldFile> old = oldFileAt(target.value());
    if (!old) {
        return old.error();
    }
    removeLeftovers(target.value());
    constexpr mode_t kMode = 0666; // less what the user's mask takes away
    const QByteArray temporary = temporaryFor(target.value());
    const int file = ::open(temporary.constData(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, kMode);
    if (file < 0) {
        return systemError(errno);
    }
    WholeFile made(target.value(), temporary, file);
    if (old.value().isThere) {
        const struct stat& facts = old.value().facts;
        // Somebody else's file cannot always stay his; who may read and write it stays the same.
        [[maybe_unused]] const int owned = ::fchown(file, facts.st_uid, facts.st_gid);
        if (::fchmod(file, facts.st_mode & ALLPERMS) != 0) {
            return systemError(errno);
        }
    }
    return made;
}

Result<void> WholeFile::write(std::string_view bytes)
{
    while (!bytes.empty()) {
        const ssize_t written = ::write(m_file, bytes.data(), bytes.size());
        if (written < 0 && errno != EINTR) {
            return systemError(errno);
        }
        bytes.remove_prefix(written > 0 ? static_cast<std::size_t>(written) : 0);
    }
    return {};
}

Result<void> WholeFile::commit()
{
    // Some file systems cannot flush; others only now find that there is no room.
    const bool isFlushed = ::fsync(m_file) == 0 || errno == EINVAL || errno == ENOTSUP;
    const int flushProblem = errno;
    const bool isClosed = ::close(std::exchange(m_file, -1)) == 0;
    if (!isFlushed || !isClosed) {
        return systemError(isFlushed ? errno : flushProblem);
    }
    if (std::rename(m_temporary.constData(), m_target.constData()) != 0) {
        return systemError(errno);
    }
    m_temporary.clear();
    return {};
}

Result<void> writeWholeFile(const QString& path, std::string_view bytes)
{
    auto file = WholeFile::begin(path);
    if (!file) {
        return file.error();
    }
    if (auto written = file.value().write(bytes); !written) {
        return written;
    }
    return file.value().commit();
}

} // namespace crowd::model
