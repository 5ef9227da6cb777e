// SPDX-License-Identifier: MIT
#include "model/gltf/ApartProcess.h"

#include <dlfcn.h>
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <utility>

#include <QtCore/QFileInfo>
#include <QtCore/QString>

namespace crowd::model::gltf {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kPieceBytes = 1U << 16U;
constexpr const char* kNoProcess =
    QT_TRANSLATE_NOOP("Messages", "there is no process to unpack it in");

/// Owns a file descriptor above the standard ones, which is closed in other programs.
class Descriptor
{
public:
    explicit Descriptor(int fd) : m_fd(fd >= 0 && fd <= 2 ? fcntl(fd, F_DUPFD_CLOEXEC, 3) : fd)
    {
        if (m_fd != fd) {
            ::close(fd);
        }
    }
    ~Descriptor() { close(); }
    Descriptor(Descriptor&& other) noexcept : m_fd(std::exchange(other.m_fd, -1)) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    Descriptor& operator=(Descriptor&&) = delete;

    [[nodiscard]] int get() const { return m_fd; }

    void close()
    {
        if (m_fd >= 0) {
            ::close(std::exchange(m_fd, -1));
        }
    }

private:
    int m_fd;
};

/// A nameless file in memory, to be read from its start.
Descriptor memoryFile(const Bytes& bytes)
{
    Descriptor file(memfd_create("crowdbrush", MFD_CLOEXEC));
    std::size_t done = 0;
    while (done < bytes.size()) {
        const ssize_t wrote = write(file.get(), bytes.data() + done, bytes.size() - done);
        if (wrote < 0 && errno != EINTR) {
            return Descriptor(-1);
        }
        done += wrote > 0 ? static_cast<std::size_t>(wrote) : 0;
    }
    (void)lseek(file.get(), 0, SEEK_SET);
    return file;
}

/// Not fork: a copy of a process with many threads may do next to nothing.
pid_t spawn(const std::string& program, int input, int output)
{
    posix_spawn_file_actions_t files;
    posix_spawnattr_t attributes;
    posix_spawn_file_actions_init(&files);
    posix_spawnattr_init(&attributes);
    posix_spawn_file_actions_adddup2(&files, input, STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&files, output, STDOUT_FILENO);
    posix_spawn_file_actions_addopen(&files, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    sigset_t signals;
    sigemptyset(&signals);
    posix_spawnattr_setsigmask(&attributes, &signals);
    sigfillset(&signals);
    posix_spawnattr_setsigdefault(&attributes, &signals);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
    std::string name = program;
    char* const arguments[] = {name.data(), nullptr};
    pid_t child = -1;
    if (posix_spawn(&child, program.c_str(), &files, &attributes, arguments, environ) != 0) {
        child = -1;
    }
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&files);
    return child;
}

/// Until the other end closes; an Error when the time is over or it is too much.
Result<Bytes> readAll(int pipe, const ApartLimits& limits)
{
    const auto end = Clock::now() + std::chrono::milliseconds(limits.milliseconds);
    Bytes bytes;
    for (;;) {
        const auto left =
            std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
        pollfd waiting{pipe, POLLIN, 0};
        const int ready = left > 0 ? poll(&waiting, 1, static_cast<int>(left)) : 0;
        if (ready == 0) {
            return Error{QT_TRANSLATE_NOOP("Messages", "it takes too long to unpack")};
        }
        if (ready < 0) {
            continue;
        }
        const std::size_t before = bytes.size();
        bytes.resize(before + kPieceBytes);
        const ssize_t got = read(pipe, bytes.data() + before, kPieceBytes);
        bytes.resize(before + (got > 0 ? static_cast<std::size_t>(got) : 0));
        if (got == 0) {
            return bytes;
        }
        if (bytes.size() > limits.outputBytes) {
            return Error{QT_TRANSLATE_NOOP("Messages", "it unpacks to more than it says")};
        }
        if (got < 0 && errno != EINTR) {
            return Error{QT_TRANSLATE_NOOP("Messages", "it is damaged")};
        }
    }
}

/// Whether the child, which has closed its output or is to be ended, ended well.
bool reap(pid_t child, bool isToEnd)
{
    if (isToEnd) {
        kill(child, SIGKILL);
    }
    int status = 0;
    pid_t ended = -1;
    do {
        ended = waitpid(child, &status, 0);
    } while (ended < 0 && errno == EINTR);
    return ended == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

} // namespace

std::string besideProgram(const std::string& name)
{
    Dl_info library{};
    (void)dladdr(reinterpret_cast<const void*>(&besideProgram), &library);
    const char* ownFile = library.dli_fname == nullptr ? "" : library.dli_fname;
    for (const QString& file : {QStringLiteral("/proc/self/exe"), QString::fromUtf8(ownFile)}) {
        const QString folder = QFileInfo(file).canonicalPath();
        for (const char* way : {"/", "/../"}) {
            const QFileInfo found(folder + QString::fromLatin1(way) + QString::fromStdString(name));
            if (!folder.isEmpty() && found.isFile() && found.isExecutable()) {
                return found.canonicalFilePath().toStdString();
            }
        }
    }
    return {};
}

Result<Bytes> runApart(const std::string& program, const Bytes& input, const ApartLimits& limits)
{
    const Descriptor request = memoryFile(input);
    int ends[2] = {-1, -1};
    if (request.get() < 0 || pipe2(ends, O_CLOEXEC) != 0) {
        return Error{kNoProcess};
    }
    const Descriptor from(ends[0]);
    Descriptor to(ends[1]);
    const pid_t child = spawn(program, request.get(), to.get());
    if (child < 0) {
        return Error{kNoProcess};
    }
    to.close();
    Result<Bytes> bytes = readAll(from.get(), limits);
    const bool isWell = reap(child, !bytes);
    if (bytes && !isWell) {
        return Error{QT_TRANSLATE_NOOP("Messages", "it is damaged")};
    }
    return bytes;
}

} // namespace crowd::model::gltf
